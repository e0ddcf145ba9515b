//! Runs the workgroups of a kernel with barriers region by region. A region is what lies between two barriers, and it is a loop over the
//! invocations, which the compiler sees as any loop. A kernel for which that is not sure to be the same keeps its coroutines: each module says
//! what it takes.

mod crossing;
mod cut;
mod scan;
#[cfg(test)]
mod tests;
mod uniform;
mod write;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use syn::{FnArg, Ident, Pat};

use crate::checks;
use crate::function::{hygienic, max_iterations, text, view};
use crate::parse::{Kernel, Lanes, Parameter, Role};
use crossing::Crossing;
use uniform::Names;
use write::Writer;

/// Why a kernel keeps its coroutines.
pub type Kept = &'static str;

/// The function's name.
pub fn name(kernel: &Kernel) -> Ident {
    format_ident!("{}_by_regions", kernel.function.sig.ident)
}

/// A function that runs one workgroup.
pub fn function(kernel: &Kernel) -> Result<TokenStream, Kept> {
    if !kernel.waits() || kernel.has_shared_tiles() || kernel.subgroups {
        return Err("it has no barriers, or shared tiles or operations of subgroups");
    }
    if kernel.samples {
        return Err("it takes samples");
    }
    if kernel.coroutines {
        return Err("it says `coroutines`");
    }
    let is_mutable = |argument: &FnArg| match argument {
        FnArg::Typed(argument) => {
            matches!(&*argument.pat, Pat::Ident(name) if name.mutability.is_some())
        }
        FnArg::Receiver(_) => true,
    };
    if kernel.function.sig.inputs.iter().any(is_mutable) {
        return Err("a parameter that changes");
    }
    let block = &kernel.function.block;
    let scan::Body { bound, .. } = scan::Body::of(block, &kernel.id)?;
    let body = cut::cut(block, &kernel.id)?;
    let mut names = Names {
        id: &kernel.id,
        uniform: kernel.uniform().map(|parameter| &parameter.name),
        parameters: kernel.parameters.iter().map(|parameter| &parameter.name).collect(),
        bound,
        once: Default::default(),
        places: Vec::new(),
        typed: Default::default(),
    };
    names.find(&body);
    let crossing = Crossing::find(&body, &names)?;
    crossing.check_assignments(block)?;
    let has_usize = checks::has_usize(quote!(#block));
    let mut writer = Writer { kernel, names: &names, crossing: &crossing, has_usize, next: 0 };
    let body = writer.list(&body);
    Ok(whole(kernel, &writer, &body))
}

/// The function around its body.
fn whole(kernel: &Kernel, writer: &Writer, body: &TokenStream) -> TokenStream {
    let name = name(kernel);
    let id = &kernel.id;
    let views = views(kernel);
    let arrays = writer.arrays();
    let count = writer.count();
    let [x, y, z] = &kernel.threads;
    let max = max_iterations(kernel);
    let generics = kernel.function.sig.generics.params.iter();
    // with the instructions of the function that it is inlined into
    let inline = kernel.lanes.is_some().then(|| quote!(#[inline(always)]));
    let one_by_one = match (&kernel.lanes, kernel.lanes_type(), kernel.uniform()) {
        (Some(Lanes::Invocations(end)), Some(lanes), Some(Parameter { name: params, .. })) => {
            let one = quote!(<#lanes as ::muslin::lane::Lane>::One);
            Some(hygienic! {
                if const { #lanes::WIDTH > 1 } && !regions.fill_lanes(&first, #params.#end) {
                    return unsafe { self::#name::<#one, MUSLIN_PLAIN>(regions, bindings) };
                }
            })
        }
        _ => None,
    };
    hygienic! {
        // SAFETY: called as `CpuRun` says
        #[cfg(not(target_arch = "spirv"))]
        #[allow(warnings, clippy::all)]
        #inline
        unsafe fn #name<#(#generics,)* const MUSLIN_PLAIN: bool>(
            regions: &::muslin::regions::Regions,
            bindings: &[::muslin::kernel::CpuBinding],
        ) -> ::core::result::Result<(), ::muslin::regions::Failure> {
            let first = regions.first([#x, #y, #z]);
            let #id = &first;
            let mut place = first;
            let count: u32 = #count;
            ::muslin::checked!(regions.allow_iterations(#max););
            #(#views)*
            #one_by_one
            #arrays
            #body
            ::core::result::Result::Ok(())
        }
    }
}

/// At the beginning of the kernel's function: all invocations of a unit test's workgroup run together.
pub fn call(kernel: &Kernel) -> syn::Stmt {
    let id = &kernel.id;
    let text = text(&kernel.function.sig.ident);
    let regions = name(kernel);
    let (shared, bindings): (Vec<_>, Vec<_>) =
        kernel.parameters.iter().partition(|parameter| matches!(parameter.role, Role::Shared(_)));
    let arguments = bindings.into_iter().chain(shared).map(|Parameter { name, .. }| name);
    let lanes = kernel.lanes_type().into_iter();
    syn::parse2(hygienic! {
        ::muslin::checked! {
            if ::muslin::workgroup::run_together(
                #text,
                self::#regions::<#(#lanes,)* false>,
                #id,
                &[#(::muslin::kernel::CpuBinding::from(#arguments)),*],
            ) {
                return;
            }
        }
    })
    .expect("a statement")
}

/// Views of the bindings, and workgroup memory.
fn views(kernel: &Kernel) -> Vec<TokenStream> {
    let mut bindings = 0_usize;
    let mut arrays = 0_usize;
    let binding_count = kernel.parameters.iter().filter(|p| p.role.is_binding()).count();
    let views = kernel.parameters.iter().map(|Parameter { name, role, element, .. }| {
        let text = text(name);
        if let Role::Shared(len) = role {
            let at = arrays;
            arrays += 1;
            let after = binding_count + at;
            let view = view(role, element);
            // SAFETY: as below, of an array
            return hygienic! {
                let memory = ::muslin::regions::Memory::<#element, { #len }>::unwritten();
                let #name = match bindings.get(#after) {
                    ::core::option::Option::Some(own) if !MUSLIN_PLAIN => unsafe { own.#view },
                    _ => memory.view(regions.watch::<MUSLIN_PLAIN>(#at)),
                }
                .named(#text);
            };
        }
        let at = bindings;
        bindings += 1;
        let view = view(role, element);
        let named = role.is_named().then(|| hygienic!(.named(#text)));
        // SAFETY: of the generated code, see `CpuRun`: the caller passes bindings of the declared types
        hygienic!(let #name = unsafe { regions.binding::<MUSLIN_PLAIN>(&bindings[#at]).#view } #named;)
    });
    views.collect()
}
