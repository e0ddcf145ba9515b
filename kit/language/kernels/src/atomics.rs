//! Atomics of storage buffers and of workgroup memory, where the order of invocations does not decide; and a hash table, whose order it does.

use muslin::prelude::*;

use crate::CountParams;

/// Invocations of a workgroup.
pub const WORKGROUP: u32 = 64;

/// Elements of each array of [`atomics`].
pub const ELEMENTS: usize = 24;

/// Elements that take the operations of [`FOLDED`], and then one more that takes products.
pub const FOLDED: [&str; 6] = ["add", "min", "max", "and", "or", "xor"];

/// The element that counts who came first to one of the [`FLAGS`], and the first flag.
pub const FIRSTS: u32 = 7;
/// See [`FIRSTS`]. The last element is stored.
pub const FLAGS: u32 = 8;
/// How many flags there are.
pub const FLAG_COUNT: u32 = 15;

/// What an element contains at first.
pub const fn first_unsigned(index: u32) -> u32 {
    match index {
        1 | 3 => u32::MAX,
        6 => 1,
        _ => 0,
    }
}

/// What an element contains at first.
pub const fn first_signed(index: u32) -> i32 {
    match index {
        1 => i32::MAX,
        2 => i32::MIN,
        3 | 8..23 => -1,
        _ => 0,
    }
}

/// Most tries of [`multiply`]: each that fails is one that another invocation has won.
const TRIES: u32 = 2 * MAX_VALUES;
/// Most values of [`atomics`].
pub const MAX_VALUES: u32 = 1000;

/// One value for all elements of an array, by methods of the same names in storage and in workgroup memory.
macro_rules! change {
    ($array:ident, $value:expr, $first:expr) => {
        $array.atomic_add(0, $value);
        $array.atomic_min(1, $value);
        $array.atomic_max(2, $value);
        $array.atomic_and(3, $value | 0x55);
        $array.atomic_or(4, $value & 0x1234_5678);
        $array.atomic_xor(5, $value);
        $array.atomic_add(FIRSTS, $first);
        $array.atomic_store(FLAGS + FLAG_COUNT, 77);
    };
}

/// Multiplies an element, modulo 2^32.
#[loops]
fn multiply(array: Write<u32>, factor: u32) {
    let mut found = array.atomic_load(6);
    let mut is_done = false;
    while !is_done {
        let before = array.atomic_compare_exchange(6, found, found.wrapping_mul(factor));
        is_done = before == found;
        found = before;
    }
}

/// As [`multiply`], in workgroup memory.
#[loops]
#[inline(always)]
fn multiply_shared(array: Shared<u32, ELEMENTS>, factor: u32) {
    let mut found = array.atomic_load(6);
    let mut is_done = false;
    while !is_done {
        let before = array.atomic_compare_exchange(6, found, found.wrapping_mul(factor));
        is_done = before == found;
        found = before;
    }
}

/// Each atomic of `values [count]`: of all to `unsigned` and `signed [ELEMENTS]`, and of each workgroup to `of_workgroups [workgroups, 2, ELEMENTS]`.
#[kernel(threads(WORKGROUP), over(params.count), iterations = 2 * TRIES)]
pub fn atomics(
    id: Invocation,
    params: &CountParams,
    values: Read<u32>,
    unsigned: Write<u32>,
    signed: Write<i32>,
    of_workgroups: Write<u32>,
    unsigned_here: Shared<u32, ELEMENTS>,
    signed_here: Shared<i32, ELEMENTS>,
) {
    let own = id.local.x;
    if own < ELEMENTS as u32 {
        unsigned_here.write(own, first_unsigned(own));
        signed_here.write(own, first_signed(own));
    }
    id.barrier();
    if id.index() < params.count {
        let value = values.read(id.index());
        let flag = FLAGS + value % FLAG_COUNT;
        let is_first = (unsigned.atomic_exchange(flag, 1) == 0) as u32;
        change!(unsigned, value, is_first);
        multiply(unsigned, value | 1);
        let is_first = (unsigned_here.atomic_exchange(flag, 1) == 0) as u32;
        change!(unsigned_here, value, is_first);
        multiply_shared(unsigned_here, value | 1);
        let is_first = (signed.atomic_compare_exchange(flag, -1, flag as i32) == -1) as i32;
        change!(signed, value as i32, is_first);
        let is_first = (signed_here.atomic_compare_exchange(flag, -1, flag as i32) == -1) as i32;
        change!(signed_here, value as i32, is_first);
    }
    id.barrier();
    if own < ELEMENTS as u32 && id.workgroup.x * WORKGROUP < params.count {
        let at = id.workgroup.x * (2 * ELEMENTS as u32) + own;
        of_workgroups.write(at, unsigned_here.read(own));
        of_workgroups.write(at + ELEMENTS as u32, signed_here.read(own) as u32);
    }
}

/// An empty slot of [`distinct`].
pub const EMPTY: u32 = u32::MAX;

/// Parameters of [`distinct`].
#[params]
pub struct TableParams {
    /// Keys.
    pub count: u32,
    /// Slots of the table, more than there are keys.
    pub slots: u32,
}

/// Puts the distinct `keys [count]`, none of which is [`EMPTY`], into the hash table `table [slots]`, and counts them in `found [1]`.
#[kernel(threads(WORKGROUP), over(params.count), iterations = 4 * MAX_VALUES, unordered(table))]
pub fn distinct(
    id: Invocation,
    params: &TableParams,
    keys: Read<u32>,
    table: Write<u32>,
    found: Write<u32>,
) {
    if id.index() < params.count {
        let key = keys.read(id.index());
        let mut slot = key.wrapping_mul(0x9e37_79b1) % params.slots;
        let mut is_searching = true;
        while is_searching {
            let before = table.atomic_compare_exchange(slot, EMPTY, key);
            if before == EMPTY {
                found.atomic_add(0, 1);
            }
            is_searching = before != EMPTY && before != key;
            slot = (slot + 1) % params.slots;
        }
    }
}
