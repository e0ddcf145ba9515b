//! How many workgroups a dispatch has.

use muslin_kernel::KernelInfo;

/// The workgroups of a dispatch, along each axis.
#[derive(Clone, Copy, Debug)]
pub struct Workgroups {
    /// Those that run.
    pub all: [u32; 3],
    /// Those that the caller has asked for.
    pub needed: [u32; 3],
}

/// Most workgroups along an axis: every GPU starts as many.
pub const MOST: u32 = 65_535;

/// Number of workgroups along x and y with at least `items` invocations in all.
pub fn workgroups_for(info: &KernelInfo, items: u32) -> [u32; 2] {
    let groups = items.div_ceil(info.workgroup_size[0]);
    if groups <= MOST { [groups, u32::from(groups > 0)] } else { [MOST, groups.div_ceil(MOST)] }
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
}
