//! Parameters that only the device knows. `count_fill` writes them into the uniform buffer, after the dispatches that count and
//! before dispatches that read.

use std::sync::{Arc, LazyLock};

use super::pipeline::Pipeline;
use muslin_kernel::KernelInfo;

/// The kernel `count_fill`.
pub static COUNT_FILL: LazyLock<&'static KernelInfo> = LazyLock::new(|| {
    let mut kernels = muslin_kernel::kernels_of("muslin-kernel");
    kernels.find(|kernel| kernel.name == "count_fill").expect("it is declared")
});

/// Parameters of a dispatch that the device fills in.
#[derive(Clone, Copy, Debug)]
pub struct Counted<'a> {
    /// Counts by their offset in the uniform buffer.
    pub counts: &'a [(usize, PendingCount<'a>)],
    /// Pipeline of `count_fill`.
    pub fill: &'a Arc<Pipeline>,
}

/// A number that only the device knows: at index `place` of `counts`, without the items before `first`, at most `upper_bound`.
#[derive(Clone, Copy, Debug)]
pub struct PendingCount<'a> {
    pub counts: &'a wgpu::Buffer,
    pub place: u32,
    pub first: u32,
    pub upper_bound: u32,
}

/// Numbers of one buffer that a dispatch of `count_fill` fills in.
#[derive(Debug)]
pub struct Fill {
    pub counts: wgpu::Buffer,
    pub pipeline: Arc<Pipeline>,
    /// The placement that [`muslin_kernel::count::count_fill`] reads, without the first row.
    pub placement: Vec<u32>,
}

impl Counted<'_> {
    /// Adds each number to the fill of its buffer. `first` is the dispatch's offset in the uniform buffer, in bytes.
    pub fn add_to(&self, fills: &mut Vec<Fill>, first: usize) {
        for (offset, PendingCount { counts, place, first: before, upper_bound }) in self.counts {
            let word = (first + offset) / size_of::<u32>();
            let row = [word as u32, *place, *before, *upper_bound];
            match fills.iter_mut().find(|fill| fill.counts == **counts) {
                Some(fill) => fill.placement.extend(row),
                None => fills.push(Fill {
                    counts: (*counts).clone(),
                    pipeline: self.fill.clone(),
                    placement: row.to_vec(),
                }),
            }
        }
    }
}
