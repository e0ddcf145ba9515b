//! What a device is measured with: multiply-adds and sums.

use organza::parity::peak::{PeakMultiplyAdd, PeakRead};

use super::hold::hold;

#[test]
fn sums_are_multiplied_and_added_to() {
    hold::<PeakMultiplyAdd>(|set, _, index| {
        let next = |x: f64| x * f64::from(set.factor) + f64::from(set.addend);
        let after = |first: f64| (0..set.rounds()).fold(first, |x, _| next(x));
        let is_output = index < set.count as usize;
        is_output.then(|| set.beginnings(index as u32).map(after).sum())
    });
}

#[test]
fn every_value_is_read_once() {
    hold::<PeakRead>(|set, _, index| {
        let is_output = index < set.count as usize;
        is_output.then(|| set.read_by(index as u32).sum())
    });
    for (_, set) in <PeakRead as organza_check::Parity>::sets() {
        let read = (0..set.count.next_multiple_of(64)).map(|index| set.read_by(index).count());
        assert_eq!(read.sum::<usize>(), set.values.len());
    }
}
