//! The kernel's function, and what all its callers write.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::ext::IdentExt;
use syn::parse_quote;

use crate::checks;
use crate::parse::{Kernel, Parameter, Role};

/// `quote!`, whose local names differ from the kernel's bindings.
macro_rules! hygienic {
    ($($tokens:tt)*) => { ::quote::quote_spanned! { ::proc_macro2::Span::mixed_site() => $($tokens)* } };
}
pub(crate) use hygienic;

/// The kernel itself. On the CPU it knows who it is and what its buffers are called: for messages.
pub fn function(kernel: &Kernel) -> syn::ItemFn {
    let mut function = kernel.function.clone();
    let name = text(&function.sig.ident);
    let id = &kernel.id;
    let buffers = kernel.parameters.iter().filter(|parameter| parameter.role.is_named());
    let named = buffers.map(|parameter| {
        let name = &parameter.name;
        let text = text(&parameter.name);
        parse_quote! { #[cfg(not(target_arch = "spirv"))] let #name = #name.named(#text); }
    });
    let [x, y, z] = &kernel.threads;
    let witness = parse_quote! {
        ::muslin::checked!(let _witness = ::muslin::kernel::PanicContext::new(#name, #id, [#x, #y, #z]););
    };
    let max = max_iterations(kernel);
    let max = parse_quote! {
        ::muslin::checked!(::muslin::kernel::allow_iterations(#max););
    };
    checks::add(&mut function.block, has_barriers(kernel));
    let statements: Vec<syn::Stmt> = [witness, max].into_iter().chain(named).collect();
    function.block.stmts.splice(0..0, statements);
    function
}

/// Whether the invocations of a workgroup wait for each other: in all entry points, or only where shared tiles are workgroup memory.
fn has_barriers(kernel: &Kernel) -> Option<syn::Expr> {
    if kernel.waits() {
        return Some(parse_quote!(true));
    }
    let tiles = kernel.parameters.iter().filter_map(|Parameter { name, role, element, .. }| {
        let Role::SharedTile(len) = role else { return None };
        Some(quote! {
            ::muslin::shared_tile::SharedTile::<#element, {#len}>::is_shared(&*#name)
        })
    });
    kernel.has_shared_tiles().then(|| parse_quote!(false #(|| #tiles)*))
}

/// Iterations of one invocation. A kernel that declares none has none, in its helpers either.
pub fn max_iterations(kernel: &Kernel) -> TokenStream {
    kernel.iterations.as_ref().map_or(quote!(0), |max| match kernel.lanes_type() {
        // an invocation that takes several lanes may loop over them
        Some(lanes) => quote!((#max) * #lanes::WIDTH),
        None => quote!(#max),
    })
}

/// A name as text: for `r#move` it is `move`.
pub fn text(name: &Ident) -> String {
    name.unraw().to_string()
}

/// The argument that the plain entry point and the CPU pass for a parameter.
pub fn plain_argument(parameter: &Parameter) -> TokenStream {
    let name = &parameter.name;
    match parameter.role {
        Role::SharedTile(_) => quote!(&mut ::muslin::shared_tile::Unshared),
        _ => quote!(#name),
    }
}

/// The method that makes a binding's view.
pub fn view(role: &Role, element: &syn::Type) -> TokenStream {
    match role {
        Role::Uniform => hygienic!(uniform::<#element>()),
        Role::Read => hygienic!(read::<#element>()),
        Role::Packed => hygienic!(packed::<#element>()),
        Role::Write => hygienic!(write::<#element>()),
        Role::Shared(len) | Role::SharedTile(len) => hygienic!(shared::<#element, {#len}>()),
    }
}
