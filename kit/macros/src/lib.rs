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
//! | `id: Invocation`   | the built-ins of the invocation; always the first parameter |
//! | `name: &P`         | a uniform buffer holding one `P`; at most one               |
//! | `name: Read<T>`    | a storage buffer of `T` that is only read                   |
//! | `name: Write<T>`   | a storage buffer of `T` that is read and written            |
//! | `name: Shared<T, N>` | `N` values of `T` in workgroup memory                     |
//! | `name: &mut impl SharedTile<T, N>` | nothing, and in the variant `_shared` `N` values of `T` in workgroup memory |
//!
//! Drivers compute what is written: they neither fuse nor regroup arithmetic, so that results agree between devices.
//! `#[kernel(threads(64), fused)]` lets them, where speed counts for more.
//!
//! A kernel that loops states how often at most, all its loops together, in constants that the host holds its inputs
//! to: `#[kernel(threads(64), iterations = MAX_SAMPLES)]`.
//!
//! A kernel that is worth it is generic over `Lane`: `#[kernel(threads(64), lanes(samples))] fn dense<L: Lane>(..)`.
//! A GPU runs it with `f32`, the CPU with SIMD: a call stands for `L::WIDTH` consecutive invocations along x, all of
//! them below the field `samples` of the parameters.  With `lanes` alone each invocation is one call and uses the
//! lanes as it likes.
//!
//! A parameter that a kernel may have written on the device, and the host does not wait for, is declared with `counts`:
//! `#[kernel(threads(64), counts(samples))]`.  The typed dispatch then has `counted(&samples)`.
//!
//! A kernel that `organza bench` counts names its formula, a function that stands beside the parameters:
//! `work(square_work)` for `fn square_work(params: &SquareParams, shape: Shape<'_>) -> Work`.
//!
//! With `z_serial`, the CPU runs the workgroups of one z one after another on one thread: the kernel may change what only
//! invocations of one z touch with `atomic::add_wide`, which is atomic on a GPU alone.  With `z_innermost`, it runs those of
//! one x and y one after another: what they all read is in a cache but for the first.
//!
//! A kernel with `lanes(field)` that is generic over `Samples` rather than over `Lane` takes four samples in an invocation of
//! a GPU.
//!
//! A kernel with a stage has a second SPIR-V entry point of the same body and bindings, its variant; the CPU
//! always runs the plain one.
//!
//! Binding numbers are positions in the parameter list, in descriptor set 0.  From this one
//! declaration follow the SPIR-V entry points, the typed dispatch of the host (`SquareKernel`), the CPU
//! execution and the entry in the manifest.

mod cpu;
mod expand;
mod parse;

use proc_macro::TokenStream;

/// Declares a kernel; see the page of this crate.
#[proc_macro_attribute]
pub fn kernel(attribute: TokenStream, item: TokenStream) -> TokenStream {
    parse::Kernel::parse(attribute.into(), item.into())
        .map(|kernel| expand::expand(&kernel))
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
