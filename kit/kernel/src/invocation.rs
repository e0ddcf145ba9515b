//! One invocation of a kernel: its position in the dispatch, and barriers.

#[cfg(not(target_arch = "spirv"))]
use core::panic::Location;

use glam::UVec3;
#[cfg(target_arch = "spirv")]
use spirv_std::memory::{Scope, Semantics};

/// One invocation of a kernel.
#[derive(Clone, Copy)]
pub struct Invocation {
    /// Position in the workgroup.
    pub local: UVec3,
    /// Position of the workgroup in the dispatch.
    pub workgroup: UVec3,
    /// Number of workgroups in the dispatch, per axis.
    pub workgroups: UVec3,
    /// Number of invocations in a workgroup, per axis.
    pub size: UVec3,
    /// Number of items along x that an invocation handles.
    pub each: u32,
    /// Size of a subgroup, and the invocation's lane in its own, in a kernel that declares `subgroups`.
    #[cfg(target_arch = "spirv")]
    pub subgroup: glam::UVec2,
    /// Called by [`Invocation::barrier`]. The executor sets it.
    #[cfg(not(target_arch = "spirv"))]
    pub wait: fn(&'static Location<'static>),
}

impl Invocation {
    /// An invocation without barriers.
    #[inline(always)]
    pub fn new(local: UVec3, workgroup: UVec3, workgroups: UVec3, size: UVec3) -> Self {
        Self {
            local,
            workgroup,
            workgroups,
            size,
            each: 1,
            #[cfg(target_arch = "spirv")]
            subgroup: glam::UVec2::ZERO,
            #[cfg(not(target_arch = "spirv"))]
            wait: no_barrier,
        }
    }

    /// The same invocation, in a dispatch of a kernel that declares no barriers.
    #[doc(hidden)]
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    #[must_use]
    pub fn dispatched(self) -> Self {
        Self { wait: undeclared_barrier, ..self }
    }

    /// The same invocation, handling `each` items.
    #[inline(always)]
    #[must_use]
    pub fn with_items(self, each: u32) -> Self {
        Self { each, ..self }
    }

    /// The same invocation, in a lane of a subgroup of `size`.
    #[cfg(target_arch = "spirv")]
    #[inline(always)]
    #[must_use]
    pub fn with_subgroup(self, size: u32, lane: u32) -> Self {
        Self { subgroup: glam::UVec2::new(size, lane), ..self }
    }

    /// Position in the dispatch, per axis.
    #[inline(always)]
    pub fn global(&self) -> UVec3 {
        self.workgroup * self.size + self.local
    }

    /// Index of the workgroup, along x and then y, because a single axis has at most 65,535.
    #[inline(always)]
    pub fn workgroup_index(&self) -> u32 {
        self.workgroup.x + self.workgroup.y * self.workgroups.x
    }

    /// Index of the invocation's first item, in a dispatch of one-dimensional workgroups.
    #[inline(always)]
    pub fn index(&self) -> u32 {
        (self.workgroup_index() * self.size.x + self.local.x) * self.each
    }

    /// Index of the invocation in its workgroup.
    #[inline(always)]
    pub fn local_index(&self) -> u32 {
        self.local.x + self.size.x * (self.local.y + self.size.y * self.local.z)
    }

    /// Whether it and its neighbors along x, `count` of them, are all among the `items` of a kernel with `lanes(items)`.
    #[doc(hidden)]
    #[cfg(not(target_arch = "spirv"))]
    #[inline(always)]
    pub fn are_among(&self, count: u32, items: u32) -> bool {
        let is_line = self.size.y == 1 && self.size.z == 1;
        let at = if is_line { self.index() } else { self.global().x };
        crate::lane::are_below(at, count, items)
    }

    /// Waits for the whole workgroup. Afterwards, everything that it wrote to workgroup memory is visible. What it wrote to storage
    /// buffers is not: see [`storage_barrier`](Self::storage_barrier).
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn barrier(&self) {
        #[cfg(target_arch = "spirv")]
        spirv_std::arch::workgroup_memory_barrier_with_group_sync();
        #[cfg(not(target_arch = "spirv"))]
        (self.wait)(Location::caller());
    }

    /// Waits for the whole workgroup. Afterwards, everything that it wrote to workgroup memory and to storage buffers is visible to
    /// it. It does not wait for other workgroups, and sees nothing that they write: only the next dispatch does.
    ///
    /// In WGSL, it is `storageBarrier` with `workgroupBarrier`. It costs more than [`barrier`](Self::barrier), so prefer workgroup
    /// memory for what fits there. A kernel without workgroup memory declares `storage_barriers`.
    ///
    /// ```
    /// # extern crate muslin_kernel as muslin;
    /// use muslin::prelude::*;
    ///
    /// /// Reverses the values of each workgroup, in place.
    /// #[kernel(threads(64), storage_barriers)]
    /// pub fn reverse(id: Invocation, data: Write<u32>) {
    ///     let other = data.read(id.workgroup.x * 64 + 63 - id.local.x);
    ///     id.storage_barrier();
    ///     data.write(id.index(), other);
    /// }
    /// # fn main() {}
    /// ```
    #[inline(always)]
    #[cfg_attr(not(target_arch = "spirv"), track_caller)]
    pub fn storage_barrier(&self) {
        #[cfg(target_arch = "spirv")]
        spirv_std::arch::control_barrier::<
            { Scope::Workgroup as u32 },
            { Scope::Workgroup as u32 },
            {
                Semantics::UNIFORM_MEMORY.bits()
                    | Semantics::WORKGROUP_MEMORY.bits()
                    | Semantics::ACQUIRE_RELEASE.bits()
            },
        >();
        #[cfg(not(target_arch = "spirv"))]
        {
            (self.wait)(Location::caller());
            crate::phase::begin_storage();
        }
    }
}

#[cfg(not(target_arch = "spirv"))]
#[track_caller]
fn no_barrier(_: &'static Location<'static>) {
    panic!(
        "a barrier, and no other invocation runs: a test calls a kernel with barriers through \
         `muslin::workgroup::Workgroup`"
    )
}

#[cfg(not(target_arch = "spirv"))]
#[track_caller]
fn undeclared_barrier(_: &'static Location<'static>) {
    panic!(
        "a barrier in a kernel without workgroup memory: if it is a storage barrier, the kernel says so, \
         `#[kernel(.., storage_barriers)]`"
    )
}
