//! The registry's entry of a kernel.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use crate::cpu::{cpu_run, run_arithmetic, run_variant};
use crate::function::text;
use crate::parse::{Attribute, Kernel, Parameter, Role};
use crate::regions;

/// The registry's entry: what the manifest says, and how the CPU runs it. `kept` says why as coroutines.
pub fn info(kernel: &Kernel, kept: Option<regions::Kept>) -> TokenStream {
    let name_text = text(&kernel.function.sig.ident);
    let info_name = info_name(kernel);
    let [x, y, z] = &kernel.threads;
    let bindings = bindings(kernel);
    let shared = shared(kernel, false);
    let variant = variant(kernel);
    let iterations = option(kernel.iterations.as_ref());
    let run = cpu_run(kernel, kept.is_none());
    let coroutines = option(kept);
    let run_variant = run_variant(kernel);
    let run_arithmetic = run_arithmetic(kernel);
    let Attribute { fused, subgroups, z_serial, z_innermost, .. } = &kernel.attribute;
    let each = each(kernel);
    let over = over(kernel);
    let unordered = kernel.unordered.iter().map(ToString::to_string);
    let limits = limits(kernel);
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        #[::muslin::dependencies::linkme::distributed_slice(::muslin::kernel::KERNELS)]
        #[linkme(crate = ::muslin::dependencies::linkme)]
        static #info_name: ::muslin::kernel::KernelInfo = {
            #run
            #run_arithmetic
            ::muslin::kernel::KernelInfo {
                name: #name_text,
                package: ::core::env!("CARGO_PKG_NAME"),
                file: ::core::file!(),
                workgroup_size: [#x, #y, #z],
                iterations: #iterations,
                fused: #fused,
                subgroups: #subgroups,
                z_serial: #z_serial,
                z_innermost: #z_innermost,
                each: #each,
                bindings: &[#(#bindings),*],
                shared: &#shared,
                variant: #variant,
                over: #over,
                unordered: &[#(#unordered),*],
                run: run(),
                coroutines: #coroutines,
                run_variant: #run_variant,
                run_arithmetic: RUN_ARITHMETIC,
            }
        };
        #limits
    }
}

/// `Some(value)` or `None`.
fn option(value: Option<impl ToTokens>) -> TokenStream {
    match value {
        Some(value) => quote!(::core::option::Option::Some(#value)),
        None => quote!(::core::option::Option::None),
    }
}

/// The registry's records of the bindings.
fn bindings(kernel: &Kernel) -> impl Iterator<Item = TokenStream> {
    kernel.parameters.iter().filter_map(|parameter| {
        let name = text(&parameter.name);
        let Parameter { element, device_element, .. } = parameter;
        let access = match parameter.role {
            Role::Uniform => quote!(Uniform),
            Role::Read | Role::Packed => quote!(Read),
            Role::Write => quote!(Write),
            Role::Shared(_) | Role::SharedTile(_) => return None,
        };
        Some(quote! {
            ::muslin::kernel::BindingInfo {
                name: #name,
                access: ::muslin::kernel::Access::#access,
                element: ::core::stringify!(#element),
                element_bytes: ::core::mem::size_of::<#element>() as u32,
                device_bytes: ::core::mem::size_of::<#device_element>() as u32,
            }
        })
    })
}

/// Refuses what some devices do not take.
fn limits(kernel: &Kernel) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let [x, y, z] = &kernel.threads;
    let invocations = format!("the kernel `{name}`: a workgroup has 1 to 256 invocations");
    let memory = format!("the kernel `{name}`: a workgroup has at most 16 KiB of memory");
    let is_storage = |parameter: &&Parameter| {
        parameter.role.is_binding() && !matches!(parameter.role, Role::Uniform)
    };
    let storage_buffers = kernel.parameters.iter().filter(is_storage).count() as u32;
    let all_shared = shared(kernel, true);
    let iterations = iterations_limit(kernel);
    let Attribute { subgroups, z_serial, .. } = &kernel.attribute;
    let has_tiles = kernel.tiles.is_some();
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        const _: () = {
            use ::muslin::kernel::{MAX_STORAGE_BUFFERS, MAX_WORKGROUP_BYTES, workgroup_bytes};
            ::core::assert!(#storage_buffers <= MAX_STORAGE_BUFFERS, "a kernel binds at most 8 storage buffers");
            #iterations
            // what every implementation of WebGPU offers; constants here would hide those that `threads` names
            let size: [u32; 3] = [#x, #y, #z];
            let invocations: u32 = size[0].saturating_mul(size[1]).saturating_mul(size[2]);
            ::core::assert!(invocations > 0 && invocations <= 256 && size[2] <= 64, #invocations);
            ::core::assert!(!#z_serial || size[2] == 1, "`z_serial` takes workgroups that are one invocation thick: `threads(x, y)`");
            ::core::assert!(!#subgroups || size[1] == 1 && size[2] == 1, "`subgroups` takes workgroups along x: `threads(x)`");
            ::core::assert!(!#has_tiles || size[1] == 1 && size[2] == 1, "`tiles` takes workgroups along x: `threads(x)`");
            ::core::assert!(workgroup_bytes(&#all_shared) <= MAX_WORKGROUP_BYTES, #memory);
        };
    }
}

/// Refuses more iterations than every device takes.
fn iterations_limit(kernel: &Kernel) -> Option<TokenStream> {
    let iterations = kernel.iterations.as_ref()?;
    let name = &kernel.function.sig.ident;
    let message = format!(
        "the kernel `{name}` declares more than 60,000 iterations: llvmpipe ends an invocation silently after 65,536, so split the \
         work over dispatches"
    );
    Some(quote!(::core::assert!((#iterations) <= ::muslin::MAX_ITERATIONS, #message);))
}

/// The function that says what a dispatch runs over: in the declared sizes, the parameters and the lengths of buffers have their names.
fn over(kernel: &Kernel) -> TokenStream {
    let items = match &kernel.over[..] {
        [] => return quote!(::core::option::Option::None),
        [items] => quote!(Line(#items, 1)),
        [items, workgroups_z] => quote!(Line(#items, #workgroups_z)),
        all => quote!(Grid([#(#all),*])),
    };
    // bindings can have these names, too
    let [uniform, elements] =
        ["uniform", "elements"].map(|name| Ident::new(name, Span::mixed_site()));
    let mut storage = 0_usize;
    let named = kernel.parameters.iter().filter(|parameter| parameter.role.is_binding());
    let named = named.map(|Parameter { name, role, element, .. }| {
        if matches!(role, Role::Uniform) {
            return quote!(let #name = ::muslin::dependencies::bytemuck::pod_read_unaligned::<#element>(#uniform););
        }
        storage += 1;
        let at = storage - 1;
        quote!(let #name = ::muslin::kernel::Elements(#elements[#at]);)
    });
    quote! {{
        #[allow(unused_variables)]
        fn over(#uniform: &[u8], #elements: &[u64]) -> ::muslin::kernel::Items {
            #(#named)*
            ::muslin::kernel::Items::#items
        }
        ::core::option::Option::Some(over)
    }}
}

/// The arrays in workgroup memory, with or without shared tiles' arrays.
fn shared(kernel: &Kernel, stages: bool) -> TokenStream {
    let arrays = kernel.parameters.iter().filter_map(|parameter| {
        let name = text(&parameter.name);
        let element = &parameter.element;
        let len = match &parameter.role {
            Role::Shared(len) => len,
            Role::SharedTile(len) if stages => len,
            _ => return None,
        };
        Some(quote! {
            ::muslin::kernel::SharedInfo {
                name: #name,
                element: ::core::stringify!(#element),
                len: ::core::mem::size_of::<[u8; #len]>() as u32,
                bytes: ::core::mem::size_of::<[#element; #len]>() as u32,
            }
        })
    });
    quote!([#(#arrays),*])
}

/// The registry's record of the second entry point.
fn variant(kernel: &Kernel) -> TokenStream {
    if !kernel.has_variant() && kernel.tiles.is_none() {
        return quote!(::core::option::Option::None);
    }
    let tiles = option(kernel.tiles.as_ref().map(|shape| quote!([#(#shape),*])));
    let name = entry_name(kernel, true);
    let shared = shared(kernel, true);
    let sums = kernel.sums().map(|parameter| text(&parameter.name));
    quote! {
        ::core::option::Option::Some(::muslin::kernel::EntryPoint { name: #name, shared: &#shared, sums: &[#(#sums),*], tiles: #tiles })
    }
}

pub fn info_name(kernel: &Kernel) -> syn::Ident {
    format_ident!("{}_KERNEL", text(&kernel.function.sig.ident).to_uppercase())
}

/// An entry point's name: of the plain one, or of the variant.
pub fn entry_name(kernel: &Kernel, is_variant: bool) -> String {
    let name = text(&kernel.function.sig.ident);
    match is_variant {
        true if kernel.sums().next().is_some() => format!("{name}_wide"),
        true if kernel.tiles.is_some() => format!("{name}_tiles"),
        true => format!("{name}_shared"),
        false => name,
    }
}

/// Items along x that an invocation of a GPU takes.
pub fn each(kernel: &Kernel) -> TokenStream {
    match kernel.samples {
        true => {
            quote!(<::muslin::samples::Four as ::muslin::samples::Samples>::WIDTH)
        }
        false => quote!(1),
    }
}
