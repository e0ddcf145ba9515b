//! Writes the struct that owns what a test gives a kernel.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::parse::{Kernel, Role};

/// `SquareInputs`, for a dispatch of the name `SquareKernel`.
pub fn inputs(kernel: &Kernel, dispatch: &Ident) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let doc = format!(
        "What a test gives [`{name}`]({name}()): its parameters, and a `Vec` for each buffer."
    );
    let inputs = format_ident!("{}Inputs", dispatch.to_string().trim_end_matches("Kernel"));
    let mut fields = Vec::new();
    let mut lent = Vec::new();
    for parameter in kernel.parameters.iter().filter(|parameter| parameter.role.is_binding()) {
        let name = &parameter.name;
        let element = &parameter.element;
        let (field, value) = match parameter.role {
            Role::Uniform => (quote!(#element), quote!(self.#name)),
            _ => (
                quote!(<::muslin::given::Given as ::muslin::kernel::Storage>::Buffer<#element>),
                quote!(&self.#name),
            ),
        };
        fields.push(quote!(#[allow(missing_docs)] pub #name: #field));
        lent.push(quote!(#name: #value));
    }
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        #[doc = #doc]
        #[allow(dead_code)]
        #[derive(Clone)]
        pub struct #inputs { #(#fields),* }

        #[cfg(not(target_arch = "spirv"))]
        #[allow(dead_code)]
        impl #inputs {
            /// The kernel with these buffers.
            pub fn kernel(&self) -> #dispatch<'_, ::muslin::given::Given> { #dispatch { #(#lent),* } }
        }
    }
}
