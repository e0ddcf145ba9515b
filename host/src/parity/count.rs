//! Cases of `count_admit`, `count_withhold` and `count_fill`.

use organza_kernel::count::{CountFillKernel, MISFIT, PLACEMENT_VALUES};
use organza_shaders::count::{
    COUNTS, CountAdmitKernel, CountAdmitParams, CountWithholdKernel, CountWithholdParams, MEMBERS,
    PAIRS, SAMPLES,
};

use super::bench::Bench;
use super::case::Parity;
use super::exact::listed;
use super::inputs::{Random, SIZES};
use super::measure::Output;
use organza_device::Result;

/// Inputs of `count_admit`.
#[derive(Clone, Debug)]
pub struct CountAdmit {
    /// Exclusive sums; the total is the last.
    pub first: Vec<u32>,
    /// How many there is room for.
    pub room: u32,
    /// What `counts` has before.
    pub counts: [u32; COUNTS as usize],
}

impl Parity for CountAdmit {
    const KERNEL: &'static str = "count_admit";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "integers";

    fn sets() -> Vec<(String, Self)> {
        let mut sets = Vec::new();
        for (total, room) in [(0, 0), (0, 5), (5, 5), (6, 5), (u32::MAX, u32::MAX - 1)] {
            for misfit in [0, 1] {
                let counts = [misfit, 7, 8, 9];
                let set = Self { first: vec![0, 0, total], room, counts };
                sets.push((format!("{total} of {room}, misfit {misfit}"), set));
            }
        }
        sets
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let counts = bench.output_of(&self.counts)?;
        let (last, room) = (self.first.len() as u32 - 1, self.room);
        let kernel = CountAdmitKernel {
            params: CountAdmitParams { place: MEMBERS, last, room },
            first: &bench.upload(&self.first)?,
            counts: &counts,
        };
        bench.items(&kernel, 2, 1)?;
        Ok(vec![Output::exact("counts", bench.read(&counts)?)])
    }

    /// misfit, pairs, members, samples: the total of the members, and whether it fits.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let [misfit, pairs, _, samples] = self.counts;
        let total = self.first[self.first.len() - 1];
        let misfit = if total > self.room { 1 } else { misfit };
        listed([misfit, pairs, total, samples])
    }
}

/// Inputs of `count_withhold`.
#[derive(Clone, Debug)]
pub struct CountWithhold {
    /// The table.
    pub table: Vec<u32>,
    /// Whether something did not fit.
    pub misfit: u32,
}

impl Parity for CountWithhold {
    const KERNEL: &'static str = "count_withhold";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "integers";

    fn sets() -> Vec<(String, Self)> {
        let of = |size: u32, misfit: u32| {
            let mut random = Random::new(u64::from(size));
            let table = (0..size).map(|_| random.below(1000)).collect();
            (format!("{size} values, misfit {misfit}"), Self { table, misfit })
        };
        SIZES.into_iter().flat_map(|size| [0, 1].map(|misfit| of(size, misfit))).collect()
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let len = self.table.len() as u32;
        let table = bench.output_of(&self.table)?;
        let mut counts = [3; COUNTS as usize];
        counts[MISFIT as usize] = self.misfit;
        let kernel = CountWithholdKernel {
            params: CountWithholdParams { len },
            counts: &bench.upload(&counts)?,
            table: &table,
        };
        bench.items(&kernel, len, 1)?;
        Ok(vec![Output::exact("table", bench.read(&table)?)])
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let keeps = u32::from(self.misfit == 0);
        listed(self.table.iter().map(|value| keeps * value))
    }
}

/// Inputs of `count_fill`.
#[derive(Clone, Debug)]
pub struct CountFill {
    /// What `counts` has.
    pub counts: [u32; COUNTS as usize],
    /// A place in `counts`, `first` and `most`, for every other word.
    pub numbers: Vec<[u32; 3]>,
}

impl Parity for CountFill {
    const KERNEL: &'static str = "count_fill";
    const TOLERANCE: f64 = 0.0;
    const WHY: &'static str = "integers";

    fn sets() -> Vec<(String, Self)> {
        let of = |size: u32, misfit: u32| {
            let mut random = Random::new(u64::from(size));
            let numbers = (0..size).map(|_| {
                let place = [PAIRS, MEMBERS, SAMPLES][random.below(3) as usize];
                [place, random.below(3000), random.below(1000)]
            });
            let set = Self { counts: [misfit, 0, 1000, 2000], numbers: numbers.collect() };
            (format!("{size} numbers, misfit {misfit}"), set)
        };
        SIZES.into_iter().flat_map(|size| [0, 1].map(|misfit| of(size, misfit))).collect()
    }

    fn run(&self, bench: &Bench<'_>) -> Result<Vec<Output>> {
        let numbers = self.numbers.len() as u32;
        let mut placement = vec![numbers, 0, 0, 0];
        for (&[place, first, most], word) in self.numbers.iter().zip((0..).step_by(2)) {
            placement.extend([word, place, first, most]);
        }
        assert_eq!(placement.len() as u32, (1 + numbers) * PLACEMENT_VALUES);
        let parameters = bench.output::<u32>(2 * self.numbers.len())?;
        let kernel = CountFillKernel {
            placement: &bench.upload(&placement)?,
            counts: &bench.upload(&self.counts)?,
            parameters: &parameters,
        };
        bench.items(&kernel, numbers, 1)?;
        Ok(vec![Output::exact("parameters", bench.read(&parameters)?)])
    }

    /// What is left of each total behind `first`, at most `most`; nothing where something did not fit.
    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let number = |&[place, first, most]: &[u32; 3]| match self.counts {
            [0, counts @ ..] => {
                let rest = i64::from(counts[place as usize - 1]) - i64::from(first);
                rest.clamp(0, i64::from(most)) as f64
            }
            _ => 0.0,
        };
        // every other word
        self.numbers.iter().flat_map(|numbers| [Some(number(numbers)), None]).collect()
    }
}
