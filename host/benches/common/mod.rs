//! What the benchmarks share: a device of one thread, its buffers, and tiles with members.

use bytemuck::Pod;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::Vec4;
use organza::backend::{Buffer, Host};
use organza::parity::composite::extent;
use organza::parity::inputs::Random;
use organza::{Device, DeviceOptions, InstructionSet};
use organza_kernels::kernel::Dispatch;
use organza_kernels::lane::{Lane, Wide};
use organza_kernels::tile::Tile;

/// A chunk of samples, and the distance of two rows of its activations.
#[derive(Clone, Copy)]
pub struct Chunk {
    pub samples: u32,
    pub stride: u32,
}

/// A chunk of rendering on a CPU.
pub const FORWARD: Chunk = Chunk { samples: 4_096, stride: 4_096 + 16 };
/// A chunk of the way back.
pub const BACKWARD: Chunk = Chunk { samples: 2_048, stride: 2_048 + 16 };

/// S, in pixels.
pub const SIDE: u32 = 64;
const TILES: u32 = 4;
const MEMBERS: u32 = 400;

/// The instruction sets that this CPU has.
pub fn sets() -> Vec<InstructionSet> {
    InstructionSet::ALL.into_iter().filter(|set| set.is_available()).collect()
}

/// A device, and random inputs that are the same each time.
pub struct Bench {
    device: Device,
    pub random: Random,
}

impl Bench {
    pub fn new(set: InstructionSet) -> Self {
        let options = DeviceOptions { instruction_set: Some(set), ..DeviceOptions::cpu(Some(1)) };
        let device = Device::open(&options).expect("a CPU is always there");
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

    /// Weights of -0.1 to 0.1.
    pub fn vectors(&mut self, len: u32) -> Buffer<Vec4> {
        self.numbers(4 * len, [-0.1, 0.1]).view()
    }

    /// Times a kernel with invocations along x, and layers along z.
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

    /// Times a kernel over pixels.
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

/// Tiles side by side, each with members all over it of 2 to 8 pixels' standard deviation.
pub struct Tiles {
    pub tile: Vec<i32>,
    pub tile_first: Vec<u32>,
    pub member: Vec<u32>,
    /// `[members, 3]`
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
                let (dx, dy) = (random.between(0.0, side), random.between(0.0, side));
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

    /// Pairs of a member and a pixel.
    pub fn items(&self) -> u64 {
        u64::from(TILES * MEMBERS) * u64::from(SIDE * SIDE)
    }
}

/// Steps of a peak's loop.
const STEPS: u64 = 4_096;
/// Sums next to each other: a multiply-add takes several cycles, and others begin meanwhile.
const SUMS: u64 = 10;

/// Times multiply-adds on registers, each of two operations; the sets without a fused one multiply, then add.
pub fn peak(bencher: Bencher, set: InstructionSet) {
    let lanes = match set {
        InstructionSet::Scalar => 1,
        InstructionSet::Plain | InstructionSet::Avx2 => 8,
        InstructionSet::Avx512 => 16,
    };
    let counter = ItemsCount::new(2 * STEPS * SUMS * lanes);
    bencher.counter(counter).bench_local(|| match set {
        InstructionSet::Scalar => multiply_add::<Wide<1, false>>(black_box(0.5)),
        InstructionSet::Plain => multiply_add::<Wide<8, false>>(black_box(0.5)),
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `sets` has what this CPU has
        InstructionSet::Avx2 => unsafe { multiply_add_avx2(black_box(0.5)) },
        #[cfg(target_arch = "x86_64")]
        // SAFETY: as above
        InstructionSet::Avx512 => unsafe { multiply_add_avx512(black_box(0.5)) },
        #[cfg(not(target_arch = "x86_64"))]
        _ => unreachable!("`sets` has what this CPU has"),
    });
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn multiply_add_avx2(factor: f32) -> f32 {
    multiply_add::<Wide<8, true>>(factor)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq,avx512bw")]
fn multiply_add_avx512(factor: f32) -> f32 {
    multiply_add::<Wide<16, true>>(factor)
}

/// `x = x factor + 1`, again and again.
#[inline(always)]
fn multiply_add<L: Lane>(factor: f32) -> f32 {
    let (factor, one) = (L::splat(factor), L::splat(1.0));
    // variables, for an array of them would stay in memory
    let start = |value: f32| L::splat(black_box(value));
    let (mut a, mut b, mut c, mut d, mut e) =
        (start(1.0), start(1.1), start(1.2), start(1.3), start(1.4));
    let (mut f, mut g, mut h, mut i, mut j) =
        (start(1.5), start(1.6), start(1.7), start(1.8), start(1.9));
    for _ in 0..STEPS {
        a = a.mul_add(factor, one);
        b = b.mul_add(factor, one);
        c = c.mul_add(factor, one);
        d = d.mul_add(factor, one);
        e = e.mul_add(factor, one);
        f = f.mul_add(factor, one);
        g = g.mul_add(factor, one);
        h = h.mul_add(factor, one);
        i = i.mul_add(factor, one);
        j = j.mul_add(factor, one);
    }
    (a + b + c + d + e + f + g + h + i + j).sum()
}
