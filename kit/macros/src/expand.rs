//! Writes everything that follows from a kernel's declaration.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::ext::IdentExt;
use syn::parse_quote;
use syn::spanned::Spanned;

use crate::cpu::{cpu_run, plain_argument, run_arithmetic, run_variant, with_other_arithmetic};
use crate::parse::{Attribute, Kernel, Parameter, Role};
use crate::{checks, regions};

pub fn expand(kernel: &Kernel) -> TokenStream {
    let function = function(kernel);
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
        #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
        let _witness = ::muslin::kernel::PanicContext::new(#name, #id, [#x, #y, #z]);
    };
    let max = max_iterations(kernel);
    let max = parse_quote! {
        #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
        ::muslin::kernel::allow_iterations(#max);
    };
    checks::add(&mut function.block, has_barriers(kernel));
    let statements: Vec<syn::Stmt> = [witness, max].into_iter().chain(named).collect();
    function.block.stmts.splice(0..0, statements);
    function
}

/// Iterations of one invocation. A kernel that declares none has none, in its helpers either.
pub fn max_iterations(kernel: &Kernel) -> TokenStream {
    kernel.iterations.as_ref().map_or(quote!(0), |max| match kernel.lanes_type() {
        // an invocation that takes several lanes may loop over them
        Some(lanes) => quote!((#max) * #lanes::WIDTH),
        None => quote!(#max),
    })
}

/// The kernel as drivers may compile it that change its arithmetic. Only debug builds on the CPU have it.
fn arithmetic_functions(kernel: &Kernel) -> TokenStream {
    let functions = with_other_arithmetic(kernel).into_iter().flatten().map(|mut function| {
        function.vis = syn::Visibility::Inherited;
        function.attrs.clear();
        function
    });
    quote! {#(
        #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
        #[allow(warnings, clippy::all)]
        #[inline(always)]
        #functions
    )*}
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

/// A name as text: for `r#move` it is `move`.
pub fn text(name: &Ident) -> String {
    name.unraw().to_string()
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

fn info_name(kernel: &Kernel) -> syn::Ident {
    format_ident!("{}_KERNEL", text(&kernel.function.sig.ident).to_uppercase())
}

/// An entry point's name: of the plain one, or of the variant.
fn entry_name(kernel: &Kernel, is_variant: bool) -> String {
    let name = text(&kernel.function.sig.ident);
    match is_variant {
        true if kernel.sums().next().is_some() => format!("{name}_wide"),
        true if kernel.tiles.is_some() => format!("{name}_tiles"),
        true => format!("{name}_shared"),
        false => name,
    }
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

/// Items along x that an invocation of a GPU takes.
fn each(kernel: &Kernel) -> TokenStream {
    match kernel.samples {
        true => {
            quote!(<::muslin::samples::Four as ::muslin::samples::Samples>::WIDTH)
        }
        false => quote!(1),
    }
}

/// The registry's entry: what the manifest says, and how the CPU runs it. `kept` says why as coroutines.
fn info(kernel: &Kernel, kept: Option<regions::Kept>) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let name_text = text(name);
    let info_name = info_name(kernel);
    let [x, y, z] = &kernel.threads;
    let bindings = kernel.parameters.iter().filter_map(|parameter| {
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
    });
    let invocations = format!("the kernel `{name}`: a workgroup has 1 to 256 invocations");
    let memory = format!("the kernel `{name}`: a workgroup has at most 16 KiB of memory");
    let all_shared = shared(kernel, true);
    let shared = shared(kernel, false);
    let variant = variant(kernel);
    let iterations = match &kernel.iterations {
        Some(iterations) => quote!(::core::option::Option::Some(#iterations)),
        None => quote!(::core::option::Option::None),
    };
    let is_storage = |parameter: &&Parameter| {
        parameter.role.is_binding() && !matches!(parameter.role, Role::Uniform)
    };
    let storage_buffers = kernel.parameters.iter().filter(is_storage).count() as u32;
    let run = cpu_run(kernel, kept.is_none());
    let coroutines = match kept {
        Some(why) => quote!(::core::option::Option::Some(#why)),
        None => quote!(::core::option::Option::None),
    };
    let run_variant = run_variant(kernel);
    let run_arithmetic = run_arithmetic(kernel);
    let Attribute { fused, subgroups, z_serial, z_innermost, .. } = &kernel.attribute;
    let has_tiles = kernel.tiles.is_some();
    let each = each(kernel);
    let limit = limit(kernel);
    let over = over(kernel);
    let unordered = kernel.unordered.iter().map(ToString::to_string);
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
        #[cfg(not(target_arch = "spirv"))]
        const _: () = {
            use ::muslin::kernel::{MAX_STORAGE_BUFFERS, MAX_WORKGROUP_BYTES, workgroup_bytes};
            ::core::assert!(#storage_buffers <= MAX_STORAGE_BUFFERS, "a kernel binds at most 8 storage buffers");
            #limit
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
fn limit(kernel: &Kernel) -> Option<TokenStream> {
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
    let tiles = match &kernel.tiles {
        Some(shape) => quote!(::core::option::Option::Some([#(#shape),*])),
        None => quote!(::core::option::Option::None),
    };
    let name = entry_name(kernel, true);
    let shared = shared(kernel, true);
    let sums = kernel.sums().map(|parameter| text(&parameter.name));
    quote! {
        ::core::option::Option::Some(::muslin::kernel::EntryPoint { name: #name, shared: &#shared, sums: &[#(#sums),*], tiles: #tiles })
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
