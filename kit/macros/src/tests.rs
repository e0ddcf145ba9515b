//! Declarations that the macro refuses, each with the kernel's name or the binding's.

use quote::quote;

use crate::expand::expand;
use crate::parse::{Kernel, check_params};

/// The error of a kernel with these options, parameters and body.
fn refusal(
    options: proc_macro2::TokenStream,
    parameters: proc_macro2::TokenStream,
    body: proc_macro2::TokenStream,
) -> String {
    let options = quote!(threads(64), #options);
    let function = quote!(pub fn blur(id: Invocation, #parameters) { #body });
    Kernel::parse(options, function).err().map_or_else(String::new, |error| error.to_string())
}

#[test]
fn a_loop_needs_its_iterations() {
    let body = quote!(if id.index() < 9 {
        let mut i = 0;
        while i < 9 {
            i += 1;
        }
    });
    let message = refusal(quote!(), quote!(output: Write<f32>), body.clone());
    assert!(message.starts_with("the kernel `blur` has a loop: state how many"), "{message}");
    assert_eq!(refusal(quote!(iterations = 9), quote!(output: Write<f32>), body), "");
    // the loops of a function in a function are its own
    assert_eq!(
        refusal(
            quote!(),
            quote!(),
            quote!(
                fn other() {
                    loop {}
                }
            )
        ),
        ""
    );
}

#[test]
fn a_slice_is_no_binding() {
    let message = refusal(quote!(), quote!(params: &Blur, input: &[f32]), quote!());
    assert_eq!(message, "`input` is a buffer: its type is `Read<T>` or `Write<T>`");
}

#[test]
fn elements_have_one_layout() {
    let types = [
        (quote!(Vec3), "three `f32`, or `Vec4`"),
        (quote!(u8), "`Packed<u8>`, or `u32`"),
        (quote!(f64), "`f32`"),
    ];
    for (ty, advice) in types {
        let message = refusal(quote!(), quote!(input: Read<glam::#ty>), quote!());
        let start =
            format!("the elements of `input` are `{ty}`, which a GPU lays out in another way");
        assert!(message.starts_with(&start) && message.ends_with(advice), "{message}");
        // workgroup memory is not shared with the host
        assert_eq!(refusal(quote!(), quote!(values: Shared<#ty, 64>), quote!()), "");
    }
    for ty in [quote!(Read<bool>), quote!(Shared<bool, 64>)] {
        let message = refusal(quote!(), quote!(flags: #ty), quote!());
        assert!(message.starts_with("the elements of `flags` are `bool`"), "{message}");
    }
}

#[test]
fn parameters_are_plain_numbers() {
    let error = |fields| {
        let item = syn::parse2(quote!(pub struct Size { #fields })).unwrap();
        check_params(&item).err().map_or_else(String::new, |error| error.to_string())
    };
    assert_eq!(error(quote!(pub width: u32, pub scale: f32)), "");
    let message = error(quote!(pub width: u32, pub offset: u64));
    assert_eq!(
        message,
        "`offset` of `Size` is `u64`, which a GPU lays out in another way than Rust, or lacks: use two `u32`"
    );
    let message = error(quote!(pub sizes: [u32; 4]));
    assert!(message.starts_with("`sizes` of `Size` is an array"), "{message}");
    let message = error(quote!(pub width: u32, pub shift: glam::Vec2));
    assert!(message.starts_with("`shift` of `Size` is `Vec2`"), "{message}");
    assert!(message.ends_with("two `f32`, and make a vector of them in the kernel"), "{message}");
}

#[test]
fn parameters_are_neither_none_nor_too_many() {
    let error = |count: usize| {
        let fields = (0..count).map(|i| quote::format_ident!("field_{i}"));
        let item = syn::parse2(quote!(pub struct Size { #(#fields: u32),* })).unwrap();
        check_params(&item).err().map_or_else(String::new, |error| error.to_string())
    };
    assert_eq!((error(1), error(64)), (String::new(), String::new()));
    assert_eq!(error(0), "`Size` has no fields: leave out the parameter of the type `&Size`");
    assert!(error(65).starts_with("`Size` has 65 fields, and a kernel has at most 64"));
}

#[test]
fn small_integers_are_packed_and_others_are_not() {
    assert_eq!(refusal(quote!(), quote!(input: Packed<u16>), quote!()), "");
    let message = refusal(quote!(), quote!(input: Packed<f32>), quote!());
    assert_eq!(message, "the elements of `input` are `u8` or `u16`: use `Read` for others");
}

#[test]
fn only_outputs_are_unordered() {
    let message = refusal(quote!(unordered(input)), quote!(input: Read<u32>), quote!());
    assert_eq!(message, "`unordered` names bindings of the type `Write`");
    assert_eq!(refusal(quote!(unordered(list)), quote!(list: Write<u32>), quote!()), "");
}

#[test]
fn tiles_have_one_shape_and_no_other_variant() {
    assert_eq!(refusal(quote!(tiles(8, 8, 8)), quote!(), quote!()), "");
    let message = refusal(quote!(tiles(8, 8)), quote!(), quote!());
    assert_eq!(message, "expected the sides of a product, `tiles(M, N, K)`");
    let message = refusal(quote!(tiles(8, 8, 8)), quote!(sums: Write<impl SumWord>), quote!());
    assert!(message.ends_with("subgroups, sums or shared tiles"), "{message}");
}

#[test]
fn a_generic_kernel_is_told_what_to_do() {
    let function = quote!(
        pub fn blur<const SIDE: u32>(id: Invocation) {}
    );
    let message = Kernel::parse(quote!(threads(SIDE)), function).err().unwrap().to_string();
    assert!(
        message.contains("a kernel for each instance call it, as `blur::<16>(id, ..)`"),
        "{message}"
    );
}

#[test]
fn kernels_that_wait_have_lanes_if_they_are_cut() {
    let error = |options, bound, body| {
        let function = quote!(
            pub fn blur<L: #bound>(id: Invocation, params: &Size, values: Shared<f32, 64>) { #body }
        );
        let options = quote!(threads(64), lanes(count), #options);
        Kernel::parse(options, function).err().map_or_else(String::new, |error| error.to_string())
    };
    let [none, lane, waits] = [quote!(), quote!(Lane), quote!(id.barrier();)];
    assert_eq!(error(none.clone(), lane.clone(), waits.clone()), "");
    assert_eq!(error(quote!(storage_barriers), lane.clone(), quote!(id.storage_barrier();)), "");
    for (options, bound, body, reason) in [
        (quote!(subgroups), lane.clone(), none.clone(), "shared tiles or operations of subgroups"),
        (quote!(coroutines), lane.clone(), none.clone(), "it says `coroutines`"),
        (none.clone(), quote!(Samples), none.clone(), "it takes samples"),
        (none.clone(), lane.clone(), quote!(wait(id);), "the invocation is passed on"),
        (none, lane, quote!(if params.count > 0 { return; } #waits), "a `return` before a barrier"),
    ] {
        let message = error(options, bound, body);
        let start = "the kernel `blur` has `lanes`, and the CPU cannot cut it at its barriers: ";
        assert!(message.starts_with(start) && message.ends_with(reason), "{message}");
    }
}

#[test]
fn a_limit_of_iterations_names_its_kernel() {
    let options = quote!(threads(64), iterations = 70_000);
    let kernel = Kernel::parse(
        options,
        quote!(
            fn blur(id: Invocation) {
                loop {}
            }
        ),
    )
    .unwrap();
    let text = expand(&kernel).to_string();
    assert!(text.contains("the kernel `blur` declares more than 60,000 iterations"), "{text}");
}

#[test]
fn names_are_any_that_rust_has() {
    for (name, dispatch) in [
        (quote!(move_), "MoveKernel"),
        (quote!(blur__x), "BlurXKernel"),
        (quote!(r#move), "MoveKernel"),
        (quote!(_größe), "GrößeKernel"),
    ] {
        // of bindings, too: the entry point has names of its own
        let function = quote!(
            fn #name(id: Invocation, local: Write<u32>, r#in: Read<u32>, workgroup: Shared<u32, 4>) {}
        );
        let kernel = Kernel::parse(quote!(threads(64)), function).unwrap();
        let file: syn::File = syn::parse2(expand(&kernel)).unwrap();
        let has = |item: &syn::Item| matches!(item, syn::Item::Struct(of) if of.ident == dispatch);
        assert!(file.items.iter().any(has), "{dispatch}");
    }
}
