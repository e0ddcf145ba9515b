//! Parts that the benchmarks share: a device with one thread, its buffers, and tiles with members.

use bytemuck::Pod;
use divan::Bencher;
use divan::counter::ItemsCount;
use glam::Vec4;
use muslin::kernel::Dispatch;
use muslin_check::inputs::Random;
use muslin_device::{Buffer, Host};
use organza::{Device, DeviceOptions, InstructionSet};
use organza_parity::composite::extent;
use organza_shaders::tile::Tile;

/// A chunk of samples, and the stride between rows of its activations.
#[derive(Clone, Copy)]
pub struct Chunk {
    pub samples: u32,
    pub stride: u32,
}

/// A chunk of rendering on a CPU.
pub const FORWARD: Chunk = Chunk { samples: 4_096, stride: 4_096 + 16 };
/// A chunk of the backward pass on a CPU.
pub const BACKWARD: Chunk = Chunk { samples: 2_048, stride: 2_048 + 16 };

/// S, in pixels.
pub const SIDE: u32 = 64;
const TILES: u32 = 4;
const MEMBERS: u32 = 400;

/// The instruction sets that this CPU has.
pub fn sets() -> Vec<InstructionSet> {
    InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect()
}

/// A device, with random inputs that are the same each time.
pub struct Bench {
    device: Device,
    pub random: Random,
}

impl Bench {
    pub fn new(set: InstructionSet) -> Self {
        let options = DeviceOptions::cpu(Some(1)).instruction_set(set);
        let device = organza::open_device(&options).expect("a CPU is always there");
        Self { device, random: Random::new(1) }
    }

    pub fn upload<T: Pod>(&self, values: &[T]) -> Buffer<T> {
        self.device.upload("benchmark", values).expect("memory for a benchmark")
    }

    pub fn zeros<T: Pod>(&self, len: u32) -> Buffer<T> {
        self.device.zeros("benchmark", len as usize).expect("memory for a benchmark")
    }

    pub fn numbers(&mut self, len: u32, [low, high]: [f32; 2]) -> Buffer<f32> {
        let values = self.random.values(len as usize, low, high);
        self.upload(&values)
    }

    /// Random weights from -0.1 to 0.1.
    pub fn vectors(&mut self, len: u32) -> Buffer<Vec4> {
        self.numbers(4 * len, [-0.1, 0.1]).view()
    }

    /// Measures a kernel with invocations along x, and layers along z.
    pub fn run<'a>(
        &self,
        bencher: Bencher,
        items: u64,
        kernel: &impl Dispatch<'a, Host>,
        [invocations, layers]: [u32; 2],
    ) {
        bencher.counter(ItemsCount::new(items)).bench_local(|| {
            self.device.run(kernel, invocations, layers).expect("the kernel runs");
        });
    }

    /// Measures a kernel over pixels.
    pub fn run_over<'a>(
        &self,
        bencher: Bencher,
        items: u64,
        kernel: &impl Dispatch<'a, Host>,
        size: [u32; 3],
    ) {
        bencher.counter(ItemsCount::new(items)).bench_local(|| {
            self.device.run_over(kernel, size).expect("the kernel runs");
        });
    }
}

/// Tiles side by side. Each has members all over it, with standard deviations of 2 to 8 pixels.
pub struct Tiles {
    pub tile: Vec<i32>,
    pub tile_first: Vec<u32>,
    pub member: Vec<u32>,
    /// Splats of the members, `[members, 3]`.
    pub splat: Vec<Vec4>,
}

impl Tiles {
    pub fn new(random: &mut Random) -> Self {
        let corner = |index: u32| [(index * SIDE) as i32, 0];
        let tile = |index| Tile { camera: 0, origin: corner(index), output: index }.pack();
        let mut splat = Vec::new();
        for index in 0..TILES {
            let [x, y] = corner(index).map(|value| value as f32);
            for _ in 0..MEMBERS {
                let side = SIDE as f32;
                let dx = random.between(0.0, side);
                let dy = random.between(0.0, side);
                let [xx, yy] = [0, 1].map(|_| random.between(2.0, 8.0).powi(-2));
                let xy = random.between(-0.5, 0.5) * (xx * yy).sqrt();
                let [width, height] = extent([xx, xy, yy]);
                splat.extend([
                    Vec4::new(x + dx, y + dy, random.between(0.0, 1.0), width),
                    Vec4::new(xx, xy, yy, height),
                    Vec4::from_slice(&random.values(4, 0.0, 1.0)),
                ]);
            }
        }
        Self {
            tile: (0..TILES).flat_map(tile).collect(),
            tile_first: (0..=TILES).map(|index| index * MEMBERS).collect(),
            member: (0..TILES * MEMBERS).collect(),
            splat,
        }
    }

    pub fn count(&self) -> u32 {
        TILES
    }

    /// Number of pairs of a member and a pixel.
    pub fn items(&self) -> u64 {
        u64::from(TILES * MEMBERS) * u64::from(SIDE * SIDE)
    }
}
