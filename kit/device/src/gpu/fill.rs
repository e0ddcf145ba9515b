//! Parameters that only the device knows. `count_fill` writes them into the uniform buffer, after the dispatches that
//! count and before those that read.

use std::sync::{Arc, LazyLock};

use muslin_kernel::KernelInfo;
use muslin_kernel::count::PLACEMENT_VALUES;
use wgpu::util::DeviceExt;

use super::pipeline::Pipeline;
use crate::buffer::Memory;
use crate::count::{Count, Total};

/// The kernel `count_fill`.
pub static KERNEL: LazyLock<&'static KernelInfo> = LazyLock::new(|| {
    let mut kernels = muslin_kernel::kernels_of("muslin-kernel");
    kernels.find(|kernel| kernel.name == "count_fill").expect("it is declared")
});

/// Numbers to fill in, grouped by the buffer that holds them.
#[derive(Debug, Default)]
pub struct Fills {
    fills: Vec<Fill>,
}

#[derive(Debug)]
struct Fill {
    counts: wgpu::Buffer,
    pipeline: Arc<Pipeline>,
    /// The placement that [`muslin_kernel::count::count_fill`] reads, without the first row.
    placement: Vec<u32>,
}

impl Fills {
    /// Registers a number to be written to a word of the uniform buffer.
    pub fn add(&mut self, pipeline: &Arc<Pipeline>, word: u32, count: &Count) {
        let Some(Total { counts, place, first }) = count.total() else { return };
        let Memory::Gpu(buffer) = &counts.raw().memory else {
            panic!("the counts belong to the CPU")
        };
        assert_eq!(counts.raw().begin, 0, "counts have a buffer of their own");
        let row = [word, *place, *first, count.upper_bound()];
        match self.fills.iter_mut().find(|fill| fill.counts == **buffer) {
            Some(fill) => fill.placement.extend(row),
            None => self.fills.push(Fill {
                counts: wgpu::Buffer::clone(buffer),
                pipeline: pipeline.clone(),
                placement: row.to_vec(),
            }),
        }
    }

    /// A command buffer that fills in all numbers; `None` if there are none.
    pub fn take(
        &mut self,
        device: &wgpu::Device,
        parameters: &wgpu::Buffer,
    ) -> Option<wgpu::CommandBuffer> {
        if self.fills.is_empty() {
            return None;
        }
        let label = Some(KERNEL.name);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label });
        for fill in self.fills.drain(..) {
            let numbers = fill.placement.len() as u32 / PLACEMENT_VALUES;
            let rows = [&[numbers, 0, 0, 0], &fill.placement[..]].concat();
            let placement = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
                label,
                contents: bytemuck::cast_slice(&rows),
                usage: wgpu::BufferUsages::STORAGE,
            });
            // in the order of its bindings
            let buffers = [&placement, &fill.counts, parameters];
            let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label,
                layout: &fill.pipeline.layout,
                entries: &buffers
                    .map(wgpu::Buffer::as_entire_binding)
                    .into_iter()
                    .zip(0..)
                    .map(|(resource, binding)| wgpu::BindGroupEntry { binding, resource })
                    .collect::<Vec<_>>(),
            });
            let mut pass = encoder
                .begin_compute_pass(&wgpu::ComputePassDescriptor { label, timestamp_writes: None });
            pass.set_pipeline(&fill.pipeline.pipeline);
            pass.set_bind_group(0, &bind_group, &[]);
            pass.dispatch_workgroups(numbers.div_ceil(KERNEL.workgroup_size[0]), 1, 1);
        }
        Some(encoder.finish())
    }
}
