//! How the CPU runs a kernel.

use proc_macro2::TokenStream;
use quote::format_ident;

use crate::function::{function, hygienic, plain_argument, text, view};
use crate::parse::{Kernel, Lanes, Role};
use crate::{regions, regrouped};

/// `const fn run()`: a workgroup at a time where no invocation waits for another, or where the kernel is cut into regions, else one
/// invocation.
pub fn cpu_run(kernel: &Kernel, has_regions: bool) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let names: Vec<_> = kernel.parameters.iter().map(plain_argument).collect();
    if kernel.waits() {
        let lane = one_lane(kernel);
        let run = invocation_run(kernel, false, &hygienic!(self::#name #lane (id, #(#names),*)));
        let regions = regions::name(kernel);
        let runs = |is_plain: bool| match &kernel.lanes {
            None => hygienic!(self::#regions::<#is_plain>),
            Some(_) => hygienic! {
                ::muslin::kernel::lane_runs!(#regions(
                    regions: &::muslin::regions::Regions,
                    bindings: &[::muslin::kernel::CpuBinding]
                ) -> ::core::result::Result<(), ::muslin::regions::Failure>; { #is_plain })
            },
        };
        let [plain, watched] = [true, false].map(runs);
        // debug builds watch always
        let plain = hygienic!(::muslin::checked!((watched) else (#plain)));
        let run = match (has_regions, &kernel.lanes) {
            (false, _) => hygienic!(Invocation(#run)),
            (true, None) => {
                hygienic!(Regions(::muslin::kernel::RegionRuns { plain: #plain, watched }, #run))
            }
            (true, Some(_)) => hygienic!(LaneRegions([#plain, watched], #run)),
        };
        let watched = has_regions.then(|| hygienic!(let watched = #watched;));
        let whole = whole(kernel);
        return hygienic! {
            #whole
            const fn run() -> ::muslin::kernel::CpuRun {
                #watched
                ::muslin::kernel::CpuRun::#run
            }
        };
    }
    let views = views(kernel, false);
    if let Some(lanes) = &kernel.lanes {
        return lane_run(kernel, lanes, &views);
    }
    let step = hygienic! {
        self::#name(id, #(#names),*);
        local_x += 1;
    };
    let body = workgroup(kernel, &views, &step);
    hygienic! {
        // SAFETY: called as `CpuRun` says
        unsafe fn run_workgroup #body
        const fn run() -> ::muslin::kernel::CpuRun { ::muslin::kernel::CpuRun::Workgroup(run_workgroup) }
    }
}

/// The argument for a kernel that is generic over lanes, where it runs with one.
fn one_lane(kernel: &Kernel) -> Option<TokenStream> {
    kernel.lanes.is_some().then(|| hygienic!(::<::muslin::lane::Wide<1, false>>))
}

/// A function that runs one invocation, of the kernel or of its variant, by a call.
fn invocation_run(kernel: &Kernel, is_variant: bool, call: &TokenStream) -> TokenStream {
    let views = views(kernel, is_variant);
    hygienic! {{
        // SAFETY: called as `CpuRun` says
        unsafe fn run(bindings: &[::muslin::kernel::CpuBinding], id: ::muslin::invocation::Invocation) {
            #(
                // SAFETY: the caller passes bindings of the declared types
                #views
            )*
            #call;
        }
        run as unsafe fn(&[::muslin::kernel::CpuBinding], ::muslin::invocation::Invocation)
    }}
}

/// Views of the bindings, and of workgroup memory, which follows them. In the variant, shared tiles are workgroup memory.
fn views(kernel: &Kernel, is_variant: bool) -> Vec<TokenStream> {
    let mut binding = 0usize;
    let mut shared = kernel.parameters.iter().filter(|p| p.role.is_binding()).count();
    let views = kernel.parameters.iter().filter_map(|parameter| {
        let name = &parameter.name;
        let slot = if parameter.role.is_binding() { &mut binding } else { &mut shared };
        let index = *slot;
        let text = text(name);
        if matches!(parameter.role, Role::SharedTile(_)) && !is_variant {
            return None;
        }
        let view = view(&parameter.role, &parameter.element);
        *slot += 1;
        // SAFETY: of the generated code, see `CpuRun`: the caller passes bindings of the declared types.
        let view = hygienic!(unsafe { bindings[#index].#view });
        Some(match parameter.role {
            Role::SharedTile(_) => hygienic!(let #name = &mut #view.named(#text);),
            _ => hygienic!(let #name = #view;),
        })
    });
    views.collect()
}

/// Changes a block's arithmetic. Returns whether there was something to change.
type Change = fn(&mut syn::Block) -> bool;

/// The changes that drivers may make to arithmetic, with their names.
const ARITHMETIC: [(&str, Change); 2] =
    [("fused", regrouped::fuse), ("regrouped", regrouped::regroup)];

/// The kernel with each change of its arithmetic that there is, unless it allows them.
pub fn with_other_arithmetic(kernel: &Kernel) -> [Option<syn::ItemFn>; 2] {
    ARITHMETIC.map(|(name, change)| {
        let mut function = function(kernel);
        function.sig.ident = format_ident!("{}_with_{name}_arithmetic", kernel.function.sig.ident);
        (!kernel.fused && change(&mut function.block)).then_some(function)
    })
}

/// `const RUN_ARITHMETIC`: one invocation with each change of its arithmetic, in debug builds.
pub fn run_arithmetic(kernel: &Kernel) -> TokenStream {
    let none = hygienic!(::core::option::Option::None);
    let names: Vec<_> = kernel.parameters.iter().map(plain_argument).collect();
    let lane = one_lane(kernel);
    let runs = with_other_arithmetic(kernel).map(|function| {
        let Some(name) = function.map(|function| function.sig.ident) else { return none.clone() };
        let run = invocation_run(kernel, false, &hygienic!(self::#name #lane (id, #(#names),*)));
        hygienic!(::core::option::Option::Some(#run))
    });
    let ty = hygienic! {
        [::core::option::Option<unsafe fn(&[::muslin::kernel::CpuBinding], ::muslin::invocation::Invocation)>; 2]
    };
    hygienic! {
        const RUN_ARITHMETIC: #ty = ::muslin::checked!(([#(#runs),*]) else ([#none; 2]));
    }
}

/// `Option<fn>`: one invocation of the variant, whose shared tiles are workgroup memory.
pub fn run_variant(kernel: &Kernel) -> TokenStream {
    // four samples per invocation are for GPUs
    if !kernel.has_shared_tiles() || kernel.samples {
        return hygienic!(::core::option::Option::None);
    }
    let name = &kernel.function.sig.ident;
    let names = kernel.parameters.iter().map(|parameter| &parameter.name);
    let lane = kernel.lanes.is_some().then(|| hygienic!(::<f32>));
    let run = invocation_run(kernel, true, &hygienic!(self::#name #lane (id, #(#names),*)));
    hygienic!(::core::option::Option::Some(#run))
}

/// Parameters and body of a function that runs a workgroup, or the part of it from `part_begin` to `part_end`: `step` runs the invocation `id`, or several from it on, and
/// adds their number to `local_x`.
fn workgroup(kernel: &Kernel, views: &[TokenStream], step: &TokenStream) -> TokenStream {
    let [x, y, z] = &kernel.threads;
    hygienic! {
        (
            bindings: &[::muslin::kernel::CpuBinding],
            workgroup: ::muslin::dependencies::glam::UVec3,
            workgroups: ::muslin::dependencies::glam::UVec3,
            [part_begin, part_end]: [::muslin::dependencies::glam::UVec3; 2],
        ) {
            #(
                // SAFETY: the caller passes bindings of the declared types
                #views
            )*
            let size = ::muslin::dependencies::glam::UVec3::new(#x, #y, #z);
            for local_z in part_begin.z..part_end.z {
                for local_y in part_begin.y..part_end.y {
                    let mut local_x = part_begin.x;
                    while local_x < part_end.x {
                        let local = ::muslin::dependencies::glam::UVec3::new(local_x, local_y, local_z);
                        let id = ::muslin::invocation::Invocation::new(local, workgroup, workgroups, size).dispatched();
                        ::muslin::kernel::enter(local_x + size.x * (local_y + size.y * local_z));
                        #step
                    }
                }
            }
        }
    }
}

/// `const fn run()` of a kernel that is generic over lanes: one function for each instruction set.
fn lane_run(kernel: &Kernel, lanes: &Lanes, views: &[TokenStream]) -> TokenStream {
    let name = &kernel.function.sig.ident;
    let names: Vec<_> = kernel.parameters.iter().map(plain_argument).collect();
    let uniform = kernel.uniform().map(|parameter| &parameter.name);
    // several vectors of lanes, while there are as many samples
    let more = kernel.samples.then(|| {
        hygienic! {
            if id.are_among(S::WIDTH, part_items) {
                self::#name::<S>(id, #(#names),*);
                local_x += S::WIDTH;
            } else
        }
    });
    let step = match lanes {
        Lanes::Inside => hygienic! {
            self::#name::<L>(id, #(#names),*);
            local_x += 1;
        },
        Lanes::Invocations(end) => hygienic! {
            let part_items: u32 = #uniform.#end;
            #more if id.are_among(L::WIDTH, part_items) {
                self::#name::<L>(id, #(#names),*);
                local_x += L::WIDTH;
            } else {
                // what is left over, lane by lane
                self::#name::<L::One>(id, #(#names),*);
                local_x += 1;
            }
        },
    };
    let whole = whole(kernel);
    let body = workgroup(kernel, views, &step);
    let generic = kernel.samples.then(|| hygienic!(, S: ::muslin::samples::Samples));
    let vectors = kernel.samples.then(|| hygienic!(, Vectors));
    let vector = hygienic!(::muslin::dependencies::glam::UVec3);
    hygienic! {
        #whole
        // SAFETY: called as `CpuRun` says
        #[inline(always)]
        unsafe fn run_lanes<L: ::muslin::lane::Lane #generic> #body
        const fn run() -> ::muslin::kernel::CpuRun {
            ::muslin::kernel::CpuRun::Lanes(::muslin::kernel::lane_runs!(run_lanes(
                bindings: &[::muslin::kernel::CpuBinding],
                workgroup: #vector,
                workgroups: #vector,
                part: [#vector; 2]
            ) -> () #vectors))
        }
    }
}

/// Refuses lanes of invocations that do not fill a workgroup.
fn whole(kernel: &Kernel) -> Option<TokenStream> {
    let Some(Lanes::Invocations(_)) = &kernel.lanes else { return None };
    let [x, ..] = &kernel.threads;
    let max = if kernel.samples { hygienic!(samples) } else { hygienic!(lane) };
    Some(hygienic! {
        const _: () = ::core::assert!((#x) % ::muslin::#max::MAX_WIDTH == 0, "lanes fill a workgroup");
    })
}
