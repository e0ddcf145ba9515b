//! The `#[kernel]` attribute.
//!
//! A kernel is an ordinary function whose parameters are its bindings:
//!
//! ```ignore
//! #[kernel(threads(64))]
//! pub fn square(id: Invocation, params: &SquareParams, input: Read<f32>, output: Write<f32>) {
//!     let index = id.index();
//!     if index < params.count {
//!         output.write(index, input.read(index) * input.read(index));
//!     }
//! }
//! ```
//!
//! | parameter          | becomes                                                     |
//! |--------------------|-------------------------------------------------------------|
//! | `id: Invocation`   | the invocation's position; always the first parameter         |
//! | `name: &P`         | a uniform buffer with one `P`; at most one                  |
//! | `name: Read<T>`    | a storage buffer of `T` that is only read                   |
//! | `name: Packed<u8>`, `Packed<u16>` | a storage buffer of small integers that is only read, as `u32` |
//! | `name: Write<T>`   | a storage buffer of `T` that is read and written            |
//! | `name: ReadFours<f32>`, `WriteFours<f32>` | the same two, of which a GPU reads and writes four numbers at once: rows of `Samples` |
//! | `name: Shared<T, N>` | `N` values of `T` in workgroup memory                     |
//! | `name: Write<impl SumWord>` | a storage buffer of `u32`, two for each 64-bit sum; in the variant `_wide`, of `u64` |
//! | `name: &mut impl SharedTile<T, N>` | in the variant `_shared`, `N` values of `T` in workgroup memory; nothing otherwise |
//!
//! From this declaration the attribute writes the SPIR-V entry points, the host's typed dispatch (`SquareKernel`), the inputs
//! of a test (`SquareInputs`), the CPU execution, and an entry in the registry of kernels, which the manifest is made from. A binding's number is its position in
//! the parameter list, in descriptor set 0.
//!
//! | in `#[kernel(..)]`  | meaning |
//! |---------------------|---------|
//! | `threads(x, y, z)`  | the size of a workgroup |
//! | `iterations = N`    | how often all loops of one invocation run together at most; required with a loop |
//! | `lanes(field)`      | generic over `Lane` or `Samples`: a GPU runs it with `f32` (or four samples per invocation), the CPU with SIMD. A call is `L::WIDTH` invocations along x, all of them below the parameters' `field`; with barriers, those of the whole workgroup are |
//! | `lanes`             | generic over `Lane`: each invocation is one call, and has all lanes |
//! | `fused`             | drivers may fuse and regroup arithmetic. Otherwise they compute what is written, so devices agree |
//! | `storage_barriers`  | invocations wait at `Invocation::storage_barrier`, and have no workgroup memory; a kernel that has some needs not say so |
//! | `subgroups`         | invocations exchange values in their subgroup: `Invocation::subgroup_sum` and others |
//! | `coroutines`        | the CPU does not cut it at its barriers into regions: slow, and right where a region does not compile |
//! | `tiles(M, N, K)`    | it multiplies tiles, of this shape: cooperative matrices on a device that has them |
//! | `over(items)`, `over(items, workgroups_z)`, `over(width, height, depth)` | what a dispatch runs over, of the parameters and the lengths of buffers: `over(params.side, params.side, tile.len() / 4)`. `Device::run_all` and parity cases take it |
//! | `counts(field, ..)` | fields of the parameters that another kernel can have written on the device: the dispatch gets `counted(&field, ..)` |
//! | `unordered(binding, ..)` | the elements of these bindings come in any order: they are where tickets of atomics say |
//! | `z_serial`          | the CPU runs the workgroups of one z one after another, on one thread: `atomic::add_wide` can then change what only they touch |
//! | `z_innermost`       | the CPU runs the workgroups of one x and y one after another: they find in a cache what the first has read |
//!
//! A kernel with a shared tile or sums has a second SPIR-V entry point, its variant, with the same body and bindings. The CPU always
//! runs the plain one.

/// Methods of a `VisitMut` that looks at what runs: the compiler computes constants, and a function in a function is another one.
macro_rules! only_what_runs {
    () => {
        fn visit_expr_repeat_mut(&mut self, repeat: &mut syn::ExprRepeat) {
            self.visit_expr_mut(&mut repeat.expr);
        }

        fn visit_expr_const_mut(&mut self, _: &mut syn::ExprConst) {}
        fn visit_generic_argument_mut(&mut self, _: &mut syn::GenericArgument) {}
        fn visit_type_mut(&mut self, _: &mut syn::Type) {}
        fn visit_item_mut(&mut self, _: &mut syn::Item) {}
    };
}

mod checks;
mod cpu;
mod expand;
mod function;
mod info;
mod parse;
mod regions;
mod regrouped;
#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Declares a kernel; the crate's documentation has the syntax.
#[proc_macro_attribute]
pub fn kernel(attribute: TokenStream, item: TokenStream) -> TokenStream {
    parse::Kernel::parse(attribute.into(), item.into())
        .map(|kernel| expand::expand(&kernel))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}

/// Of a function that kernels call: the iterations of its loops count as the kernel's, against its `iterations`. If it takes the
/// `Invocation`, the CPU run also knows on which path through it an invocation came to a barrier.
#[proc_macro_attribute]
pub fn loops(_: TokenStream, item: TokenStream) -> TokenStream {
    let mut function = syn::parse_macro_input!(item as syn::ItemFn);
    let has_barriers = checks::takes_invocation(&function).then(|| syn::parse_quote!(true));
    checks::add(&mut function.block, has_barriers);
    quote::quote!(#function).into()
}

/// Parameters of a kernel, or an element of a buffer: a struct of plain numbers that the host fills and a GPU reads, field after field.
///
/// It stands for `#[repr(C)]` and the derives of `Clone`, `Copy`, `Debug`, `Pod` and `Zeroable`. Use `u32`, `i32` and `f32`: others
/// have another layout on a GPU than in Rust.
#[proc_macro_attribute]
pub fn params(_: TokenStream, item: TokenStream) -> TokenStream {
    let item = syn::parse_macro_input!(item as syn::ItemStruct);
    if let Err(error) = parse::check_params(&item) {
        return error.into_compile_error().into();
    }
    let name = &item.ident;
    let numbers = item.fields.iter().map(|field| {
        let ty = &field.ty;
        quote::quote_spanned!(syn::spanned::Spanned::span(ty) => is_number::<#ty>();)
    });
    quote::quote! {
        #[repr(C)]
        #[derive(Clone, Copy, Debug)]
        #item

        // SAFETY: its fields are numbers of four bytes, as is checked below: it has no padding
        unsafe impl ::muslin::dependencies::bytemuck::Pod for #name {}
        // SAFETY: zero is a number
        unsafe impl ::muslin::dependencies::bytemuck::Zeroable for #name {}

        #[cfg(not(target_arch = "spirv"))]
        impl ::muslin::kernel::Params for #name {}

        #[cfg(not(target_arch = "spirv"))]
        const _: () = {
            const fn is_number<T: ::muslin::kernel::Number>() {}
            #(#numbers)*
        };
    }
    .into()
}
