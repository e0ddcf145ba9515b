//! What is cut, what keeps its coroutines and why, and which variables get an array.

use proc_macro2::{Delimiter, Group, TokenStream};
use quote::quote;

use super::function;
use crate::parse::Kernel;

/// The function of a kernel with this body.
fn cut(body: TokenStream) -> Result<String, &'static str> {
    let function = quote!(
        fn blur(id: Invocation, params: &Blur, input: Read<u32>, output: Write<u32>, values: Shared<u32, 64>) {
            #body
        }
    );
    // as a macro passes it on
    let one = Group::new(Delimiter::None, quote!(1));
    let kernel = Kernel::parse(quote!(threads(64, #one), iterations = 9), function).unwrap();
    function_of(&kernel)
}

fn function_of(kernel: &Kernel) -> Result<String, &'static str> {
    let text = function(kernel)?.to_string();
    syn::parse_str::<syn::ItemFn>(&text).expect("a function");
    Ok(text)
}

/// The variables that have an array, in their order.
fn crossing(body: TokenStream) -> Vec<String> {
    let text = cut(body).unwrap();
    let arrays = text.split(" = :: muslin :: regions :: PerInvocation ::");
    let mut names: Vec<_> =
        arrays.map(|before| before.rsplit(' ').next().unwrap().to_owned()).collect();
    names.pop();
    names.iter().map(|name| name.rsplit_once('_').unwrap().0.to_owned()).collect()
}

#[test]
fn what_is_not_sure_keeps_its_coroutines() {
    let kept = [
        (quote!(helper(id); id.barrier();), "the invocation is passed on"),
        (quote!(let copy = id; id.barrier();), "the invocation is passed on"),
        (quote!(id.wait_for_it();), "the invocation is passed on"),
        (quote!(assert!(check(id)); id.barrier();), "the invocation is passed on"),
        (quote!(let id = 1; use_it(id);), "the invocation's name means something else"),
        (quote!(let f = || id.barrier(); f();), "a barrier within a `let`"),
        (quote!(wait!(); id.barrier();), "a macro that is not known"),
        (quote!(#[cfg(test)] id.barrier();), "a barrier with an attribute"),
        (
            quote!(let mut x = None; x.insert(&params.y); id.barrier(); f(x);),
            "a variable that may borrow crosses a barrier",
        ),
        (quote!(if params.x > 0 { return; } id.barrier();), "a `return` before a barrier"),
        (
            quote!(while params.x > 0 {
                id.barrier();
                return;
            }),
            "a `return` before a barrier",
        ),
        (
            quote!(if f()? > 0 {
                id.barrier();
            }),
            "a `return` before a barrier",
        ),
        (
            quote!(while params.x > 0 {
                if params.y > 0 {
                    break;
                }
                id.barrier();
            }),
            "a `break` or `continue` of a loop with a barrier",
        ),
        (
            quote!('a: for i in 0..3 {
                id.barrier();
                loop {
                    continue 'a;
                }
            }),
            "a `break` or `continue` of a loop with a barrier",
        ),
        (
            quote!(loop {
                id.barrier();
            }),
            "a barrier in an expression that is neither a loop over a range nor a branch",
        ),
        (
            quote!(match params.x {
                0 => id.barrier(),
                _ => {}
            }),
            "a barrier in an expression that is neither a loop over a range nor a branch",
        ),
        (
            quote!(if let Some(x) = f() {
                id.barrier();
            }),
            "a barrier in a condition, or in a branch that binds",
        ),
        (
            quote!(let x = input.read(0); if x > 0 { if params.x > 0 { id.barrier(); } }),
            "a barrier in two branches, of which the outer one is not the same in all invocations",
        ),
        (
            quote!(for i in 0..input.read(0) {
                if i > 0 {
                    id.barrier();
                }
            }),
            "a barrier in a branch of a loop that is not the same in all invocations",
        ),
        (
            quote!(let x; id.barrier(); x = input.read(0); id.barrier(); f(x);),
            "a variable without a value crosses a barrier",
        ),
        (
            quote!(let x = &input.read(0); id.barrier(); f(x);),
            "a variable that may borrow crosses a barrier",
        ),
        (
            quote!(let mut x = f(); x = g(|y| y); id.barrier(); x(1);),
            "a variable that may borrow crosses a barrier",
        ),
        (quote!(let ref x = input.read(0); id.barrier(); f(x);), "a pattern borrows"),
        (
            quote!(#[cfg(test)] let x = input.read(0); id.barrier(); f(x);),
            "a variable with an attribute crosses a barrier",
        ),
        (
            quote!(
                let mut x = input.read(0);
                id.barrier();
                { x += 1; let x = x + 1; id.barrier(); f(x); }
                f(x);
            ),
            "a variable that crosses a barrier is hidden by another",
        ),
    ];
    for (body, reason) in kept {
        assert_eq!(cut(body.clone()).err(), Some(reason), "{body}");
    }
}

#[test]
fn a_kernel_without_plain_workgroup_memory_is_not_cut() {
    for function in [
        quote!(
            fn blur(id: Invocation, output: Write<u32>) {}
        ),
        quote!(
            fn blur(id: Invocation, values: Shared<u32, 4>, near: &mut impl SharedTile<u32, 4>) {}
        ),
        quote!(
            fn blur(mut id: Invocation, values: Shared<u32, 4>) {}
        ),
    ] {
        assert!(function_of(&Kernel::parse(quote!(threads(64)), function).unwrap()).is_err());
    }
}

#[test]
fn only_what_lives_across_a_barrier_has_an_array() {
    let none: [&str; 0] = [];
    // used before and after, and within one region
    let body = quote!(let x = input.read(0); let y = x + 1; f(y); id.barrier(); let z = x; g(z););
    assert_eq!(crossing(body), ["x"]);
    // parameters, constants and places need none
    let body = quote!(
        let at = id.local.x;
        let row = at * SIDE + params.x;
        let mut half = params.count / 2;
        values.write(at, row);
        id.barrier();
        while half > 0 {
            if at < half { values.write(at, values.read(at + half)); }
            id.barrier();
            half /= 2;
        }
        for i in (0..half).rev() { values.write(i + row, 1); id.barrier(); }
    );
    assert_eq!(crossing(body), none);
    // but a division takes time, where it is none by a constant
    let body = quote!(
        let a = id.local.x / params.side;
        let b = id.local.x / SIDE;
        id.barrier();
        f(a + b);
    );
    assert_eq!(crossing(body), ["a"]);
    // what changes in one invocation alone, or in the midst of a region, does
    let body = quote!(
        let mut a = 1;
        let mut b = 2;
        let mut c = 3;
        let mut d = 4;
        if id.local.x > 0 { a += 1; }
        f(b);
        b += 1;
        f(b);
        change(&mut c);
        id.barrier();
        f(a + b + c + d);
        d += 1;
    );
    assert_eq!(crossing(body), ["a", "b", "c"]);
    // two of one name are two
    let body = quote!(let x = f(); id.barrier(); let x = x + 1; id.barrier(); g(x););
    assert_eq!(crossing(body), ["x", "x"]);
    // patterns, format strings and votes
    let body = quote!(
        let (a, Pair { b, c: [d, _] }) = f();
        id.barrier();
        println!("{a} {}", b);
        while d > 0 { id.barrier(); }
    );
    assert_eq!(crossing(body), ["a", "b", "d"]);
}

#[test]
fn a_region_of_a_part_of_the_workgroup_visits_that_part() {
    let bounds = |condition: TokenStream| {
        let body = quote!(let at = id.local.x; id.barrier(); if #condition { f(at); });
        let text = cut(body).unwrap();
        let steps = text.rsplit_once("steps :: < MUSLIN_PLAIN >").unwrap().1;
        steps.split_once(" , count)").unwrap().0.to_owned()
    };
    let all = "[0 , count]";
    for (condition, expected) in [
        (quote!(at < params.half), "[0 , bound]"),
        (quote!(at <= 9 && f()), "[0 , bound . saturating_add (1)]"),
        (quote!(9 > id.local.x), "[0 , bound]"),
        (quote!(id.local_index() >= 9), "[bound , count]"),
        (quote!(at > 9), "[bound . saturating_add (1) , count]"),
        (quote!(at == 0), "[bound , bound . saturating_add (1)]"),
        (quote!(at != 0), all),
        (quote!(at < 9 || f()), all),
        (quote!(at < input.read(0)), all),
        (quote!(id.local.y < 9), all),
    ] {
        let found = bounds(condition.clone());
        assert!(found.contains(expected), "{condition}: {found}");
    }
}
