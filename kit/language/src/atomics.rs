//! The cases of `atomics` and `distinct`: folds over the values, one after another.

use std::collections::BTreeSet;

use muslin_check::prelude::*;
use muslin_language_kernels::CountParams;
use muslin_language_kernels::atomics::{
    AtomicsInputs, DistinctInputs, ELEMENTS, EMPTY, FIRSTS, FLAG_COUNT, FLAGS, MAX_VALUES,
    TableParams, WORKGROUP, first_signed, first_unsigned,
};

case!(pub Atomics(AtomicsInputs));

/// What becomes of an array's elements.
fn folded(values: &[u32], is_signed: bool) -> Vec<u32> {
    let first =
        |index| if is_signed { first_signed(index).cast_unsigned() } else { first_unsigned(index) };
    let mut all: Vec<u32> = (0..ELEMENTS as u32).map(first).collect();
    if values.is_empty() {
        return all;
    }
    let number =
        |word: &u32| if is_signed { i64::from(word.cast_signed()) } else { (*word).into() };
    let numbers = || values.iter().map(number);
    let [low, high] = [numbers().min(), numbers().max()].map(|of| of.expect("a value") as u32);
    let flags: BTreeSet<_> = values.iter().map(|value| FLAGS + value % FLAG_COUNT).collect();
    all[0] = numbers().sum::<i64>() as u32;
    all[1] = low;
    all[2] = high;
    all[3] = values.iter().fold(!0, |all, value| all & (value | 0x55));
    all[4] = values.iter().fold(0, |all, value| all | value) & 0x1234_5678;
    all[5] = values.iter().fold(0, |all, value| all ^ value);
    if !is_signed {
        all[6] = values.iter().fold(1, |all, value| all.wrapping_mul(value | 1));
    }
    all[FIRSTS as usize] = flags.len() as u32;
    for flag in flags {
        all[flag as usize] = if is_signed { flag } else { 1 };
    }
    all[ELEMENTS - 1] = 77;
    all
}

impl Parity for Atomics {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, fill, random| {
            assert!(count <= MAX_VALUES);
            // some with few bits, some that are negative
            let few = |random: &mut Random| random.bits() % 5;
            let value = |at: u32, random: &mut Random| match fill {
                inputs::Fill::Random if at.is_multiple_of(3) => random.bits(),
                inputs::Fill::Random => few(random) << (random.bits() % 32),
                _ => few(random).wrapping_sub(2),
            };
            let values = (0..count).map(|at| value(at, random)).collect();
            let elements = 0..ELEMENTS as u32;
            Self(AtomicsInputs {
                params: CountParams { count },
                values,
                unsigned: elements.clone().map(first_unsigned).collect(),
                signed: elements.map(first_signed).collect(),
                of_workgroups: unwritten(2 * ELEMENTS * count.div_ceil(WORKGROUP) as usize),
            })
        })
    }

    fn exact(&self, output: &str, _: usize) -> Vec<Option<Rounded>> {
        match output {
            "unsigned" => listed(folded(&self.values, false)),
            "signed" => {
                let signed = folded(&self.values, true).into_iter().map(u32::cast_signed);
                listed(signed.map(f64::from).map(Rounded::exact))
            }
            _ => {
                let workgroups = self.values.chunks(WORKGROUP as usize);
                listed(
                    workgroups
                        .flat_map(|of| [false, true].map(|signed| folded(of, signed)))
                        .flatten(),
                )
            }
        }
    }
}

case!(pub Distinct(DistinctInputs));

impl Parity for Distinct {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| {
            let keys = (0..count).map(|_| random.below(count)).collect();
            // nearly full
            let slots = count + 1 + count / 8;
            let table = vec![EMPTY; slots as usize];
            Self(DistinctInputs {
                params: TableParams { count, slots },
                keys,
                table,
                found: vec![0],
            })
        })
    }

    /// The slots come in any order, so they are sorted.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs[0].values.sort_unstable_by(f64::total_cmp);
        outputs
    }

    fn exact(&self, output: &str, len: usize) -> Vec<Option<Rounded>> {
        let mut keys: Vec<_> =
            self.keys.iter().copied().collect::<BTreeSet<_>>().into_iter().collect();
        if output == "found" {
            return listed([keys.len() as u32]);
        }
        keys.resize(len, EMPTY);
        listed(keys)
    }
}
