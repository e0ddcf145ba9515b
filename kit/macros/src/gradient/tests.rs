//! Functions that the attribute refuses: each message says what to do.

use proc_macro2::TokenStream;
use quote::quote;

use super::gradient;

/// The error of a function of `x` and `y` with this body.
fn refusal(body: TokenStream) -> String {
    let function = quote!(fn f(x: f32, #[constant] y: f32) -> f32 { #body });
    gradient(quote!(), function).err().map_or_else(String::new, |error| error.to_string())
}

#[test]
fn what_is_not_straight_is_refused() {
    for (body, advice) in [
        (quote!(while y < 1.0 {} x), "a gradient has no loops: write the body as a function"),
        (quote!(let a = loop { break x; }; a), "a gradient has no loops"),
        (quote!(if y < 0.0 { return x; } x), "a gradient has no `return`: choose"),
        (quote!(let mut a = x; a), "a gradient needs all values of a variable: replace `mut`"),
        (
            quote!(let a = x; a *= 2.0; a),
            "a gradient needs all values of a variable: replace the assignment",
        ),
        (quote!(let x = x * 2.0; x), "`x` is taken, and a gradient needs both values"),
        (
            quote!(match y {
                _ => x,
            }),
            "a gradient has no `match`: use `if .. else ..`",
        ),
        (quote!(if let Some(y) = f(x) { y } else { x }), "a gradient has no `if let`"),
        (quote!((|a| a * x)(y)), "a gradient calls functions by their names"),
        (quote!(f(&x)), "a reference has no gradient: pass the value itself"),
        (quote!(g[0](x)), "a gradient calls functions by their names"),
        (quote!(square!(x)), "a gradient has arithmetic, fields"),
        (quote!(x % y), "a gradient has arithmetic, fields"),
        (quote!(y * 2.0), "the value does not depend on a parameter"),
        (quote!(x * y;), "a gradient has no use for a statement without a value"),
        (quote!(Split { fine: x, ..y }), "a gradient needs every field"),
    ] {
        let message = refusal(body.clone());
        assert!(
            message.starts_with(advice) && message.is_empty() == advice.is_empty(),
            "{body}: {message}"
        );
    }
}

#[test]
fn what_takes_no_gradient_is_refused() {
    for (item, advice) in [
        (
            quote!(
                fn f(x: &f32, n: u32) -> f32 {
                    *x
                }
            ),
            "no parameter of `f` takes a gradient",
        ),
        (
            quote!(
                fn f(x: f32) {}
            ),
            "`f` returns nothing",
        ),
        (
            quote!(
                struct F(f32);
            ),
            "`#[gradient]` takes structs with named fields",
        ),
        (
            quote!(
                enum F {}
            ),
            "`#[gradient]` takes a function or a struct with fields",
        ),
    ] {
        let message = gradient(quote!(), item).unwrap_err().to_string();
        assert!(message.starts_with(advice), "{message}");
    }
    let message = gradient(
        quote!(with = f),
        quote!(
            fn f(x: f32) -> f32 {
                x
            }
        ),
    )
    .unwrap_err();
    assert_eq!(message.to_string(), "`#[gradient]` takes nothing but `by = f`");
}
