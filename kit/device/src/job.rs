//! A dispatch: its workgroups, and on the CPU its bindings and the ways to run it.

use muslin_kernel::kernel::{Access, CpuBinding, KernelInfo};

use crate::buffer::{Memory, RawBuffer};

/// A kernel and its bindings.
pub struct KernelJob<'a> {
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

/// The workgroups of a dispatch, along each axis.
#[derive(Clone, Copy, Debug)]
pub struct Workgroups {
    /// The workgroups that run.
    pub all: [u32; 3],
    /// The workgroups that the caller has asked for.
    pub needed: [u32; 3],
}

/// Most workgroups along an axis: every GPU starts as many.
pub const MAX_WORKGROUPS: u32 = 65_535;

/// Number of workgroups along x and y with at least `items` invocations in all.
pub fn workgroups_for(info: &KernelInfo, items: u32) -> [u32; 2] {
    let groups = items.div_ceil(info.workgroup_size[0]);
    if groups <= MAX_WORKGROUPS {
        [groups, u32::from(groups > 0)]
    } else {
        [MAX_WORKGROUPS, groups.div_ceil(MAX_WORKGROUPS)]
    }
}

/// A random order of a seed, or its reverse. Of any two items, each comes first in one of the two.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    pub seed: u64,
    pub is_reversed: bool,
}

impl Order {
    /// The numbers below `count`. Another `salt` gives another order.
    pub fn permutation(self, count: u64, salt: u64) -> Vec<u64> {
        let mut numbers: Vec<_> = (0..count).collect();
        let mut state = self.seed ^ salt.wrapping_mul(0xd134_2543_de82_ef95);
        for end in (1..numbers.len()).rev() {
            let other = random(&mut state) % (end as u64 + 1);
            numbers.swap(end, other as usize);
        }
        if self.is_reversed {
            numbers.reverse();
        }
        numbers
    }
}

/// splitmix64
fn random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mixed = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

/// The memory of every binding, in order.
pub fn bind(info: &KernelInfo, uniform: &[u8], buffers: &[&RawBuffer]) -> Vec<CpuBinding<'static>> {
    let mut buffers = buffers.iter();
    let mut bindings = Vec::with_capacity(info.bindings.len());
    for binding in info.bindings {
        let (data, bytes) = match binding.access {
            Access::Uniform => (uniform.as_ptr().cast_mut(), uniform.len()),
            Access::Read | Access::Write => {
                let buffer = buffers.next().expect("the typed dispatch binds every buffer");
                let Memory::Cpu(memory) = &buffer.memory else {
                    panic!("the buffer `{}` belongs to a GPU", buffer.label)
                };
                (memory.data().wrapping_add(buffer.begin as usize), buffer.bytes as usize)
            }
        };
        bindings.push(CpuBinding { data, bytes, monitor: None });
    }
    bindings
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn workgroups_hold_all_items() {
        let info = muslin_kernel::kernels().find(|k| k.name == "count_fill").expect("a kernel");
        for items in [0, 1, 63, 64, 65, 65_535 * 64, 65_535 * 64 + 1, 1 << 31, u32::MAX] {
            let [x, y] = workgroups_for(info, items);
            assert!(x <= 65_535 && y <= 65_535);
            assert!(u64::from(x) * u64::from(y) * 64 >= u64::from(items), "{items}: {x} x {y}");
        }
    }

    #[test]
    fn an_order_has_every_number_once() {
        for count in [0, 1, 2, 64, 1000] {
            let order = Order { seed: 7, is_reversed: false };
            let mut numbers = order.permutation(count, 3);
            let mut reversed = Order { is_reversed: true, ..order }.permutation(count, 3);
            reversed.reverse();
            assert_eq!(numbers, reversed);
            assert!(count < 64 || numbers != order.permutation(count, 4));
            numbers.sort_unstable();
            assert!(numbers.into_iter().eq(0..count));
        }
    }
}
