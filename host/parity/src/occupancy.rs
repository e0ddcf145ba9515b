//! Cases of `occupancy_add` and `occupancy`.

use muslin_check::prelude::*;
use organza_shaders::occupancy::{
    FULL, OccupancyAddInputs, OccupancyInputs, OccupancyParams, OccupancyTableParams,
};
use organza_shaders::unit_cube::SceneBox;

use super::color::BOXES;
use super::exact::occupancy::{OccupancyGrid, half};
use super::exact::project::Gaussian;

/// How far from a decision of the kernel the inputs stay, in cells.
const AWAY: f64 = 1e-3;

case!(pub OccupancyAdd(OccupancyAddInputs) { grid: OccupancyGrid });

impl OccupancyAdd {
    /// Gaussians in and around the box, of scales up to `largest` cells.
    fn new(gaussians: u32, side: u32, is_contracted: bool, largest: f32) -> Self {
        let random = &mut Random::new(u64::from(gaussians + side));
        let grid = OccupancyGrid { side, aabb: BOXES[0], is_contracted };
        let cell = grid.cell() as f32;
        let len = gaussians as usize;
        let mut set = Self {
            grid,
            inputs: OccupancyAddInputs {
                params: OccupancyParams {
                    gaussians,
                    side,
                    cell,
                    contracted: u32::from(is_contracted),
                },
                scene_box: SceneBox::new(grid.aabb, is_contracted).pack().to_vec(),
                position: vec![0.0; 3 * len],
                rotation: vec![0.0; 4 * len],
                log_scale: vec![0.0; 3 * len],
                opacity: random.values(len, -6.0, 3.0),
                counts: vec![0; grid.entries().pow(3)],
            },
        };
        let [low, high] = grid.aabb;
        for index in 0..len {
            loop {
                for axis in 0..3 {
                    let [low, high] = [low[axis] as f32, high[axis] as f32];
                    let beyond = 0.3 * (high - low);
                    set.position[3 * index + axis] = random.between(low - beyond, high + beyond);
                    let scale = random.between(0.01, 1.0) * largest;
                    set.log_scale[3 * index + axis] = (scale * cell).ln();
                }
                set.rotation[4 * index..][..4].copy_from_slice(&random.values(4, 0.1, 1.0));
                if !set.is_undecided(index) {
                    break;
                }
            }
        }
        set
    }

    fn gaussian(&self, index: usize) -> Gaussian<f64> {
        let OccupancyAddInputs { position, rotation, log_scale, .. } = &**self;
        Gaussian::read(position, rotation, log_scale, index)
    }

    /// Whether rounding decides which cells a Gaussian's nodes lie in.
    fn is_undecided(&self, index: usize) -> bool {
        let gaussian = self.gaussian(index);
        let near = |x: f64| (x - x.round()).abs() < AWAY;
        let is_between = |scale: f64| {
            let scale = scale / self.grid.cell();
            half(scale - AWAY) != half(scale + AWAY)
        };
        let nodes = self.grid.nodes(&gaussian, f64::from(self.opacity[index]));
        gaussian.axes().into_iter().any(is_between)
            || nodes.iter().any(|node| node.place.into_iter().any(near))
    }
}

impl Parity for OccupancyAdd {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = Vec::new();
        for (side, is_contracted, largest) in
            [(8, false, 0.2), (8, false, 1.6), (5, true, 1.0), (3, false, 4.0), (33, false, 0.7)]
        {
            let kind = if is_contracted { ", contracted" } else { "" };
            for gaussians in [300, 3] {
                let set = Self::new(gaussians, side, is_contracted, largest);
                let name = format!("{gaussians} in {side}^3 cells, up to {largest} of one{kind}");
                sets.push((name, set));
            }
        }
        sets
    }

    /// Counts of nodes between two integers may be rounded to either.
    fn convert(&self, mut outputs: Vec<Output>) -> Vec<Output> {
        outputs[0].is_exact = false;
        outputs
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let full = f64::from(FULL);
        let mut counts = vec![Rounded::exact(0.0); self.counts.len()];
        for index in 0..self.params.gaussians as usize {
            let opacity = f64::from(self.opacity[index]);
            for node in self.grid.nodes(&self.gaussian(index), opacity) {
                if let Some(entry) = self.grid.entry(&node) {
                    let count = node.fill.min(1.0) * full;
                    let is_between = (count.fract() - 0.5).abs() < 1e-5 * count;
                    counts[entry].value += count.round();
                    counts[entry].error += 1e-6 * count + f64::from(u8::from(is_between));
                }
            }
        }
        listed(counts.into_iter().map(|count| Rounded { value: count.value.min(full), ..count }))
    }
}

case!(pub Occupancy(OccupancyInputs));

impl Parity for Occupancy {
    fn sets() -> Vec<(String, Self)> {
        let of = |entries: u32| {
            let mut random = Random::new(u64::from(entries));
            let set = Self(OccupancyInputs {
                params: OccupancyTableParams { entries },
                counts: (0..entries).map(|_| random.below(FULL + 1)).collect(),
                table: unwritten(entries as usize),
            });
            (format!("{entries} entries"), set)
        };
        [1, 63, 64, 1000].map(of).into()
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        Some(match output {
            "counts" => Rounded::exact(0.0),
            _ => Rounded::from(f64::from(self.counts[index]) / f64::from(FULL)),
        })
    }
}
