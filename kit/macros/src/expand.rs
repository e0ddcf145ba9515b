//! Writes everything that follows from a kernel's declaration.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::parse_quote;
use syn::spanned::Spanned;

use crate::cpu::with_other_arithmetic;
use crate::function::{function, plain_argument, text};
use crate::info::{each, entry_name, info, info_name};
use crate::parse::{Kernel, Role};
use crate::regions;

pub fn expand(kernel: &Kernel) -> TokenStream {
    let mut function = function(kernel);
    let arithmetic = arithmetic_functions(kernel);
    let variants = if kernel.has_variant() { &[false, true][..] } else { &[false] };
    let mut entries: Vec<_> =
        variants.iter().map(|&is_variant| entry_point(kernel, is_variant)).collect();
    if kernel.tiles.is_some() {
        let cooperative = entry_point(kernel, true);
        // each compilation has one of the two
        entries = vec![quote! {
            #[cfg(target_arch = "spirv")]
            ::muslin::tile_entry! { { #(#entries)* } { #cooperative } }
        }];
    }
    let regions = regions::function(kernel);
    let info = info(kernel, regions.as_ref().err().filter(|_| kernel.waits()).copied());
    let regions = regions.ok();
    // after the test of the workgroup's size
    regions.iter().for_each(|_| function.block.stmts.insert(1, regions::call(kernel)));
    let dispatch = dispatch(kernel);
    let inputs = inputs(kernel, &dispatch_name(kernel));
    let iterations = kernel.iterations.iter();
    quote! {
        #[inline(always)]
        #[allow(clippy::too_many_arguments)]
        #function
        #arithmetic
        #regions
        // names what the declaration names, on the GPU too
        #(const _: u32 = #iterations;)*
        #(#entries)*
        #info
        #dispatch
        #inputs
    }
}

/// The kernel as drivers may compile it that change its arithmetic. Only debug builds on the CPU have it.
fn arithmetic_functions(kernel: &Kernel) -> TokenStream {
    let functions = with_other_arithmetic(kernel).into_iter().flatten().map(|mut function| {
        function.vis = syn::Visibility::Inherited;
        function.attrs.clear();
        function
    });
    quote! {#(
        ::muslin::checked! {
            #[allow(warnings, clippy::all)]
            #[inline(always)]
            #functions
        }
    )*}
}

/// `tile_mask` -> `TileMaskKernel`
fn dispatch_name(kernel: &Kernel) -> syn::Ident {
    let name = text(&kernel.function.sig.ident);
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    let camel: String = name.split('_').map(capital).collect();
    format_ident!("{camel}Kernel")
}

/// A SPIR-V entry point: the built-ins and bindings as Rust-GPU wants them, then the function. The attribute takes literals alone, so the
/// kernel builder writes the size of the workgroup.
fn entry_point(kernel: &Kernel, is_variant: bool) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let entry_point_name = entry_name(kernel, is_variant);
    let entry = format_ident!("{entry_point_name}_entry_point");
    let [x, y, z] = &kernel.threads;
    let mut binding = 0;
    let parameters = kernel.parameters.iter().filter_map(|parameter| {
        let name = &parameter.name;
        let element = &parameter.device_element;
        let number = Literal::u32_unsuffixed(binding);
        binding += u32::from(parameter.role.is_binding());
        Some(match &parameter.role {
            Role::Uniform => quote! { #[spirv(uniform, descriptor_set = 0, binding = #number)] #name: &#element },
            Role::Read => quote! { #[spirv(storage_buffer, descriptor_set = 0, binding = #number)] #name: &[#element] },
            Role::Packed => {
                quote! { #[spirv(storage_buffer, descriptor_set = 0, binding = #number)] #name: ::muslin::memory::Packed<#element> }
            }
            Role::Write => {
                let element = if parameter.is_sum && is_variant { &parse_quote!(u64) } else { element };
                quote! { #[spirv(storage_buffer, descriptor_set = 0, binding = #number)] #name: &mut [#element] }
            }
            Role::Shared(len) => quote! { #[spirv(workgroup)] #name: &mut [#element; #len] },
            Role::SharedTile(_) if !is_variant => return None,
            Role::SharedTile(len) => quote! { #[spirv(workgroup)] #name: &mut [#element; #len] },
        })
    });
    let arguments = kernel.parameters.iter().map(|parameter| {
        let name = &parameter.name;
        if is_variant { quote!(#name) } else { plain_argument(parameter) }
    });
    // an invocation of a GPU is a lane, or takes four samples
    let lane = kernel.lanes.is_some().then(|| match kernel.samples {
        true => quote!(::<::muslin::samples::Four>),
        false => quote!(::<f32>),
    });
    let each = each(kernel);
    // bindings can have these names, too
    let [id, local, workgroup, workgroups, size, lane_index] =
        ["id", "local", "workgroup", "workgroups", "size", "lane"]
            .map(|name| Ident::new(name, Span::mixed_site()));
    let lanes = kernel.subgroups.then(|| {
        quote! {
            #[spirv(subgroup_size)] #size: u32,
            #[spirv(subgroup_local_invocation_id)] #lane_index: u32,
        }
    });
    let subgroup = kernel.subgroups.then(|| quote!(.with_subgroup(#size, #lane_index)));
    // with cooperative matrices, a subgroup is an invocation
    let is_cooperative = is_variant && kernel.tiles.is_some();
    let teams = is_cooperative.then(|| {
        quote! {
            #[spirv(num_subgroups)] #size: u32,
            #[spirv(subgroup_id)] #lane_index: u32,
        }
    });
    let vector = quote!(::muslin::dependencies::glam::UVec3);
    let place = match is_cooperative {
        true => {
            quote!(#vector::new(#lane_index, 0, 0), #workgroup, #workgroups, #vector::new(#size, 1, 1))
        }
        false => quote!(#local, #workgroup, #workgroups, #vector::new(#x, #y, #z)),
    };
    quote! {
        #[cfg(target_arch = "spirv")]
        #[allow(missing_docs, unused_variables, clippy::too_many_arguments)]
        #[::muslin::dependencies::spirv_std::spirv(compute(threads(1), entry_point_name = #entry_point_name))]
        pub fn #entry(
            #[spirv(local_invocation_id)] #local: ::muslin::dependencies::glam::UVec3,
            #[spirv(workgroup_id)] #workgroup: ::muslin::dependencies::glam::UVec3,
            #[spirv(num_workgroups)] #workgroups: ::muslin::dependencies::glam::UVec3,
            #lanes
            #teams
            #(#parameters),*
        ) {
            let #id = ::muslin::invocation::Invocation::new(#place).with_items(#each) #subgroup;
            self::#name #lane (#id, #(#arguments),*);
        }
    }
}

/// The typed dispatch of the host: a struct with a field for each binding.
fn dispatch(kernel: &Kernel) -> TokenStream {
    let struct_name = dispatch_name(kernel);
    let info_name = info_name(kernel);
    let doc = format!("The bindings of [`{0}`]({0}()), by name.", kernel.function.sig.ident);
    let mut fields = Vec::new();
    let mut binds = Vec::new();
    let mut uniform = quote!(&[]);
    for parameter in &kernel.parameters {
        let name = &parameter.name;
        let element = &parameter.element;
        match parameter.role {
            Role::Uniform => {
                fields.push(quote! { /// Uniform buffer.
                #[allow(missing_docs)] pub #name: #element });
                uniform =
                    quote_spanned!(element.span() => ::muslin::kernel::params_bytes(&self.#name));
            }
            Role::Read | Role::Packed | Role::Write => {
                let access = if matches!(parameter.role, Role::Write) {
                    "Read and written."
                } else {
                    "Read."
                };
                fields.push(quote! { #[doc = #access] pub #name: &'a HostSide::Buffer<#element> });
                binds.push(quote! { visit(HostSide::bind(self.#name)); });
            }
            Role::Shared(_) | Role::SharedTile(_) => {}
        }
    }
    let counted = counted(kernel, &struct_name);
    quote! {
        #counted

        #[cfg(not(target_arch = "spirv"))]
        #[doc = #doc]
        pub struct #struct_name<'a, HostSide: ::muslin::kernel::Storage> { #(#fields),* }

        #[cfg(not(target_arch = "spirv"))]
        impl<'a, HostSide: ::muslin::kernel::Storage> ::muslin::kernel::Dispatch<'a, HostSide> for #struct_name<'a, HostSide> {
            fn info(&self) -> &'static ::muslin::kernel::KernelInfo { &#info_name }
            fn uniform(&self) -> &[u8] { #uniform }
            fn bind(&self, visit: &mut dyn FnMut(HostSide::Binding<'a>)) { #(#binds)* }
        }
    }
}

/// `counted(self, ..)` of the typed dispatch, where the kernel declares counts.
fn counted(kernel: &Kernel, struct_name: &syn::Ident) -> TokenStream {
    let (fields, Some(uniform)) = (&kernel.counts, kernel.uniform()) else { return quote!() };
    if fields.is_empty() {
        return quote!();
    }
    let params = &uniform.name;
    let element = &uniform.element;
    let n = fields.len();
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        impl<'a, HostSide: ::muslin::kernel::Storage> #struct_name<'a, HostSide> {
            /// The same dispatch, with numbers that only the device may know.  They replace the parameters' numbers.
            #[must_use]
            pub fn counted(mut self, #(#fields: &'a HostSide::Count),*) -> ::muslin::kernel::Counted<'a, HostSide, Self, #n> {
                #(self.#params.#fields = HostSide::upper_bound(#fields);)*
                ::muslin::kernel::Counted::new(self, [#((::core::mem::offset_of!(#element, #fields), #fields)),*])
            }
        }
    }
}

/// `SquareInputs`, for a dispatch of the name `SquareKernel`.
fn inputs(kernel: &Kernel, dispatch: &Ident) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let doc = format!(
        "What a test gives [`{name}`]({name}()): its parameters, and a `Vec` for each buffer."
    );
    let kernel_name = text(name);
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
        impl ::muslin::given::Inputs for #inputs {
            const KERNEL: &'static str = #kernel_name;
            type Kernel<'a> = #dispatch<'a, ::muslin::given::Given>;
            fn kernel(&self) -> #dispatch<'_, ::muslin::given::Given> { #dispatch { #(#lent),* } }
        }
    }
}
