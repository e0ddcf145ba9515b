//! Writes what follows from a kernel's declaration.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use syn::parse_quote;

use crate::parse::{Kernel, Lanes, Role};

pub fn expand(kernel: &Kernel) -> TokenStream {
    let function = function(kernel);
    let entry = entry_point(kernel);
    let info = info(kernel);
    let dispatch = dispatch(kernel);
    let iterations = kernel.iterations.iter();
    quote! {
        #[inline(always)]
        #[allow(clippy::too_many_arguments)]
        #function
        // names what the declaration names, on the GPU too
        #(const _: u32 = #iterations;)*
        #entry
        #info
        #dispatch
    }
}

/// The kernel itself. On the CPU it knows who it is and what its buffers are called: for messages.
fn function(kernel: &Kernel) -> syn::ItemFn {
    let mut function = kernel.function.clone();
    let (name, id) = (function.sig.ident.to_string(), &kernel.id);
    let buffers = kernel.parameters.iter().filter(|p| !matches!(p.role, Role::Uniform));
    let named = buffers.map(|parameter| {
        let (name, text) = (&parameter.name, parameter.name.to_string());
        parse_quote! { #[cfg(not(target_arch = "spirv"))] let #name = #name.named(#text); }
    });
    let witness = parse_quote! {
        #[cfg(all(not(target_arch = "spirv"), debug_assertions))]
        let _witness = crate::kernel::Witness::new(#name, #id);
    };
    let statements: Vec<syn::Stmt> = std::iter::once(witness).chain(named).collect();
    function.block.stmts.splice(0..0, statements);
    function
}

/// `tile_mask` -> `TileMaskKernel`
fn dispatch_name(kernel: &Kernel) -> syn::Ident {
    let camel: String = kernel
        .function
        .sig
        .ident
        .to_string()
        .split('_')
        .map(|word| word[..1].to_uppercase() + &word[1..])
        .collect();
    format_ident!("{camel}Kernel")
}

fn info_name(kernel: &Kernel) -> syn::Ident {
    format_ident!("{}_KERNEL", kernel.function.sig.ident.to_string().to_uppercase())
}

/// The SPIR-V entry point: the built-ins and bindings as Rust-GPU wants them, then the function.
fn entry_point(kernel: &Kernel) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let entry = format_ident!("{name}_entry_point");
    let entry_point_name = name.to_string();
    let [x, y, z] = kernel.threads.map(Literal::u32_unsuffixed);
    let mut binding = 0;
    let parameters = kernel.parameters.iter().map(|parameter| {
        let (name, element) = (&parameter.name, &parameter.element);
        let number = Literal::u32_unsuffixed(binding);
        binding += u32::from(!matches!(parameter.role, Role::Shared(_)));
        match &parameter.role {
            Role::Uniform => quote! { #[spirv(uniform, descriptor_set = 0, binding = #number)] #name: &#element },
            Role::Read => quote! { #[spirv(storage_buffer, descriptor_set = 0, binding = #number)] #name: &[#element] },
            Role::Write => {
                quote! { #[spirv(storage_buffer, descriptor_set = 0, binding = #number)] #name: &mut [#element] }
            }
            Role::Shared(len) => quote! { #[spirv(workgroup)] #name: &mut [#element; #len] },
        }
    });
    let names = kernel.parameters.iter().map(|parameter| &parameter.name);
    // an invocation of a GPU is a lane
    let lane = kernel.lanes.is_some().then(|| quote!(::<f32>));
    quote! {
        #[cfg(target_arch = "spirv")]
        #[allow(missing_docs, clippy::too_many_arguments)]
        #[::spirv_std::spirv(compute(threads(#x, #y, #z), entry_point_name = #entry_point_name))]
        pub fn #entry(
            #[spirv(local_invocation_id)] local: ::glam::UVec3,
            #[spirv(workgroup_id)] workgroup: ::glam::UVec3,
            #[spirv(num_workgroups)] workgroups: ::glam::UVec3,
            #(#parameters),*
        ) {
            let id = crate::invocation::Invocation::new(local, workgroup, workgroups, ::glam::UVec3::new(#x, #y, #z));
            self::#name #lane (id, #(#names),*);
        }
    }
}

/// The registry's entry: what the manifest says, and how the CPU runs it.
fn info(kernel: &Kernel) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let name_text = name.to_string();
    let info_name = info_name(kernel);
    let [x, y, z] = kernel.threads;
    let bindings = kernel.parameters.iter().filter_map(|parameter| {
        let (name, element) = (parameter.name.to_string(), &parameter.element);
        let access = match parameter.role {
            Role::Uniform => quote!(Uniform),
            Role::Read => quote!(Read),
            Role::Write => quote!(Write),
            Role::Shared(_) => return None,
        };
        Some(quote! {
            crate::kernel::BindingInfo {
                name: #name,
                access: crate::kernel::Access::#access,
                element: ::core::stringify!(#element),
                element_bytes: ::core::mem::size_of::<#element>() as u32,
            }
        })
    });
    let shared = kernel.parameters.iter().filter_map(|parameter| {
        let (name, element) = (parameter.name.to_string(), &parameter.element);
        let Role::Shared(len) = &parameter.role else { return None };
        Some(quote! {
            crate::kernel::SharedInfo {
                name: #name,
                element: ::core::stringify!(#element),
                len: #len as u32,
                bytes: ::core::mem::size_of::<[#element; #len]>() as u32,
            }
        })
    });
    let iterations = match &kernel.iterations {
        Some(iterations) => quote!(::core::option::Option::Some(#iterations)),
        None => quote!(::core::option::Option::None),
    };
    let (count, run) = (kernel.parameters.len(), cpu_run(kernel));
    let (fused, layers, stacks) = (kernel.fused, kernel.layers, kernel.stacks);
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        #[::linkme::distributed_slice(crate::kernel::KERNELS)]
        static #info_name: crate::kernel::KernelInfo = {
            #run
            crate::kernel::KernelInfo {
                name: #name_text,
                file: ::core::file!(),
                workgroup_size: [#x, #y, #z],
                iterations: #iterations,
                fused: #fused,
                layers: #layers,
                stacks: #stacks,
                bindings: &[#(#bindings),*],
                shared: &[#(#shared),*],
                run: run(),
            }
        };
        #[cfg(not(target_arch = "spirv"))]
        const _: () = ::core::assert!(#count <= 12, "a kernel has at most 12 bindings");
    }
}

/// `const fn run()`: a workgroup at a time where no invocation waits for another, else one invocation.
fn cpu_run(kernel: &Kernel) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let [x, y, z] = kernel.threads;
    // workgroup memory follows the bindings
    let mut binding = 0usize;
    let mut shared =
        kernel.parameters.iter().filter(|p| !matches!(p.role, Role::Shared(_))).count();
    let views = kernel.parameters.iter().map(|parameter| {
        let (name, element) = (&parameter.name, &parameter.element);
        let slot =
            if matches!(parameter.role, Role::Shared(_)) { &mut shared } else { &mut binding };
        let index = *slot;
        *slot += 1;
        let view = match &parameter.role {
            Role::Uniform => quote!(uniform::<#element>()),
            Role::Read => quote!(read::<#element>()),
            Role::Write => quote!(write::<#element>()),
            Role::Shared(len) => quote!(shared::<#element, {#len}>()),
        };
        // SAFETY: of the generated code, see `CpuRun`: the caller passes bindings of the declared types.
        quote! { let #name = unsafe { bindings[#index].#view }; }
    });
    let names: Vec<_> = kernel.parameters.iter().map(|parameter| &parameter.name).collect();
    if kernel.has_shared() {
        return quote! {
            unsafe fn run_invocation(bindings: &[crate::kernel::CpuBinding], id: crate::invocation::Invocation) {
                #(
                    // SAFETY: the caller passes bindings of the declared types
                    #views
                )*
                self::#name(id, #(#names),*);
            }
            const fn run() -> crate::kernel::CpuRun { crate::kernel::CpuRun::Invocation(run_invocation) }
        };
    }
    if let Some(lanes) = &kernel.lanes {
        return lane_run(kernel, lanes, &views.collect::<Vec<_>>());
    }
    quote! {
        unsafe fn run_workgroup(
            bindings: &[crate::kernel::CpuBinding],
            workgroup: ::glam::UVec3,
            workgroups: ::glam::UVec3,
        ) {
            #(
                // SAFETY: the caller passes bindings of the declared types
                #views
            )*
            let size = ::glam::UVec3::new(#x, #y, #z);
            for local_z in 0..#z {
                for local_y in 0..#y {
                    for local_x in 0..#x {
                        let local = ::glam::UVec3::new(local_x, local_y, local_z);
                        let id = crate::invocation::Invocation::new(local, workgroup, workgroups, size);
                        crate::kernel::enter(local_x + #x * (local_y + #y * local_z));
                        self::#name(id, #(#names),*);
                    }
                }
            }
        }
        const fn run() -> crate::kernel::CpuRun { crate::kernel::CpuRun::Workgroup(run_workgroup) }
    }
}

/// `const fn run()` of a kernel that is generic over lanes: one function for each instruction set.
fn lane_run(kernel: &Kernel, lanes: &Lanes, views: &[TokenStream]) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let names: Vec<_> = kernel.parameters.iter().map(|parameter| &parameter.name).collect();
    let [x, y, z] = kernel.threads;
    let flat = y == 1 && z == 1;
    let uniform = kernel.parameters.iter().find(|p| matches!(p.role, Role::Uniform));
    let uniform = uniform.map(|parameter| &parameter.name);
    let step = match lanes {
        Lanes::Inside => quote! {
            self::#name::<L>(id, #(#names),*);
            local_x += 1;
        },
        Lanes::Invocations(end) => {
            let at = if flat { quote!(id.index()) } else { quote!(id.global().x) };
            quote! {
                let end: u32 = #uniform.#end;
                if end >= L::WIDTH && #at <= end - L::WIDTH {
                    self::#name::<L>(id, #(#names),*);
                    local_x += L::WIDTH;
                } else {
                    // what is left over, lane by lane
                    self::#name::<L::One>(id, #(#names),*);
                    local_x += 1;
                }
            }
        }
    };
    let whole = match lanes {
        Lanes::Inside => quote!(),
        Lanes::Invocations(_) => quote! {
            const _: () = ::core::assert!(#x % crate::lane::MAX_WIDTH == 0, "lanes fill a workgroup");
        },
    };
    quote! {
        #whole
        #[inline(always)]
        unsafe fn run_lanes<L: crate::lane::Lane>(
            bindings: &[crate::kernel::CpuBinding],
            workgroup: ::glam::UVec3,
            workgroups: ::glam::UVec3,
        ) {
            #(
                // SAFETY: the caller passes bindings of the declared types
                #views
            )*
            let size = ::glam::UVec3::new(#x, #y, #z);
            for local_z in 0..#z {
                for local_y in 0..#y {
                    let mut local_x = 0;
                    while local_x < #x {
                        let local = ::glam::UVec3::new(local_x, local_y, local_z);
                        let id = crate::invocation::Invocation::new(local, workgroup, workgroups, size);
                        crate::kernel::enter(local_x + #x * (local_y + #y * local_z));
                        #step
                    }
                }
            }
        }
        const fn run() -> crate::kernel::CpuRun {
            crate::kernel::lane_runs!(run_lanes)
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
        let (name, element) = (&parameter.name, &parameter.element);
        match parameter.role {
            Role::Uniform => {
                fields.push(quote! { /// Uniform buffer.
                #[allow(missing_docs)] pub #name: #element });
                uniform = quote!(::bytemuck::bytes_of(&self.#name));
            }
            Role::Read | Role::Write => {
                let access = if matches!(parameter.role, Role::Read) {
                    "Read."
                } else {
                    "Read and written."
                };
                fields.push(quote! { #[doc = #access] pub #name: &'a S::Buffer<#element> });
                binds.push(quote! { visit(S::bind(self.#name)); });
            }
            Role::Shared(_) => {}
        }
    }
    quote! {
        #[cfg(not(target_arch = "spirv"))]
        #[doc = #doc]
        pub struct #struct_name<'a, S: crate::kernel::Storage> { #(#fields),* }

        #[cfg(not(target_arch = "spirv"))]
        impl<'a, S: crate::kernel::Storage> crate::kernel::Dispatch<'a, S> for #struct_name<'a, S> {
            fn info(&self) -> &'static crate::kernel::KernelInfo { &#info_name }
            fn uniform(&self) -> &[u8] { #uniform }
            fn bind(&self, visit: &mut dyn FnMut(S::Binding<'a>)) { #(#binds)* }
        }
    }
}
