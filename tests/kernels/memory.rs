//! Memory of a device that is used again.

use organza_tests::devices;

/// Numbers of a buffer: a megabyte, a size that no pool rounds.
const LEN: usize = 1 << 18;

/// A GPU runs a copy later than the host writes.
#[test]
fn memory_waits_for_the_commands_that_use_it() {
    for (name, device) in devices::all() {
        let copy = device.unwritten::<u32>("copy", LEN).unwrap();
        let first = device.upload("first", &vec![1_u32; LEN]).unwrap();
        device.copy(&first, &copy);
        drop(first);
        let second = device.upload("second", &vec![2_u32; LEN]).unwrap();
        assert!(device.read(&copy).unwrap().iter().all(|&value| value == 1), "{name}");
        assert!(device.read(&second).unwrap().iter().all(|&value| value == 2), "{name}");
    }
}

#[test]
fn zeros_are_zeros_where_other_values_lay() {
    for (name, device) in devices::all() {
        for len in [LEN, LEN - 3, LEN] {
            let ones = device.upload("ones", &vec![1_u32; len]).unwrap();
            assert_eq!(device.read_range(&ones, len - 1, 1).unwrap(), [1], "{name}");
            drop(ones);
            let zeros = device.zeros::<u32>("zeros", len).unwrap();
            assert!(device.read(&zeros).unwrap().iter().all(|&value| value == 0), "{name}");
        }
    }
}
