//! A dispatch on the CPU, and the ways to run it.

use muslin_kernel::kernel::{CpuBinding, KernelInfo};

use crate::buffer::RawBuffer;
use crate::order::Order;
use crate::workgroups::Workgroups;

/// A kernel and its bindings.
pub struct Job<'a> {
    pub info: &'static KernelInfo,
    pub bindings: Vec<CpuBinding<'static>>,
    pub buffers: &'a [&'a RawBuffer],
    pub workgroups: Workgroups,
}

/// What a driver may do to arithmetic, in the order of [`KernelInfo::run_arithmetic`].
#[derive(Clone, Copy, PartialEq)]
pub enum Arithmetic {
    /// A multiplication and an addition round once.
    Fused,
    /// Sums and products are regrouped.
    Regrouped,
}

/// How a dispatch runs.
#[derive(Clone, Copy, Default)]
pub struct RunMode {
    /// The order of its invocations, if it is not the usual one.
    pub order: Option<Order>,
    /// Whether denormals are flushed to zero.
    pub is_flushing: bool,
    /// How its arithmetic is changed, in a kernel that has such a run.
    pub arithmetic: Option<Arithmetic>,
    /// Number of lanes of a subgroup, if it is not the device's.
    pub subgroup_size: Option<u32>,
}
