//! Orders of workgroups, and of the invocations in them: a GPU promises none.

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

#[cfg(test)]
mod tests {
    use super::*;

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
