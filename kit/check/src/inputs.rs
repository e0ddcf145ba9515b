//! Inputs for kernels, the same on every machine: random numbers, and numbers that break careless code.

use glam::Vec4;
use muslin_kernel::math::TINY;

/// Numbers of items around the size of a workgroup.
pub const SIZES: [u32; 9] = [0, 1, 63, 64, 65, 127, 128, 129, 1000];

/// Number of items in an adversarial set: two workgroups and one more item.
pub const ITEMS: u32 = 129;

/// Random numbers (splitmix64). The same seed gives the same numbers.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Starts the sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 32) as u32
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// An integer below `end`; 0 if `end` is 0.
    pub fn below(&mut self, end: u32) -> u32 {
        self.bits() % end.max(1)
    }

    /// `len` numbers in `low..high`.
    pub fn values(&mut self, len: usize, low: f32, high: f32) -> Vec<f32> {
        (0..len).map(|_| self.between(low, high)).collect()
    }
}

/// The content of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// Numbers in the kernel's usual range.
    Random,
    /// Zeros.
    Zero,
    /// Negative zeros.
    NegativeZero,
    /// Numbers that a GPU may flush to zero.
    Denormal,
    /// The largest numbers that the kernel accepts, of both signs.
    Huge,
    /// All of these, mixed.
    Mixed,
}

impl Fill {
    /// All fillings but the random one.
    pub const ADVERSARIAL: [Self; 5] =
        [Self::Zero, Self::NegativeZero, Self::Denormal, Self::Huge, Self::Mixed];

    /// Name in reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Zero => "zeros",
            Self::NegativeZero => "negative zeros",
            Self::Denormal => "denormals",
            Self::Huge => "huge",
            Self::Mixed => "mixed",
        }
    }

    /// `len` numbers of this kind. `usual` is the range of random ones, `huge` the size of huge ones.
    pub fn values(
        self,
        random: &mut Random,
        len: usize,
        [low, high]: [f32; 2],
        huge: f32,
    ) -> Vec<f32> {
        let of = |fill: Self, random: &mut Random| match fill {
            Self::Zero => 0.0,
            Self::NegativeZero => -0.0,
            Self::Denormal => random.between(-1.0, 1.0) * TINY,
            Self::Huge => {
                if random.below(2) == 0 {
                    huge
                } else {
                    -huge
                }
            }
            Self::Random | Self::Mixed => random.between(low, high),
        };
        let mixed = [Self::Zero, Self::NegativeZero, Self::Denormal, Self::Huge, Self::Random];
        (0..len)
            .map(|_| {
                let fill = if self == Self::Mixed { mixed[random.below(5) as usize] } else { self };
                of(fill, random)
            })
            .collect()
    }

    /// `len` vectors of such numbers.
    pub fn vectors(self, random: &mut Random, len: usize, usual: [f32; 2], huge: f32) -> Vec<Vec4> {
        let numbers = self.values(random, 4 * len, usual, huge);
        numbers.chunks_exact(4).map(Vec4::from_slice).collect()
    }
}

/// A random set of every size, and an adversarial set of every filling.
pub fn sets<T>(make: impl Fn(u32, Fill, &mut Random) -> T) -> Vec<(String, T)> {
    sets_of(SIZES, ITEMS, make)
}

/// A random set of each size, and an adversarial set of every filling and one size.
pub fn sets_of<T>(
    sizes: impl IntoIterator<Item = u32>,
    filled: u32,
    make: impl Fn(u32, Fill, &mut Random) -> T,
) -> Vec<(String, T)> {
    let sized = sizes.into_iter().map(|size| (size, Fill::Random));
    let all = sized.chain(Fill::ADVERSARIAL.map(|fill| (filled, fill)));
    let set = |(index, (size, fill)): (usize, (u32, Fill))| {
        let mut random = Random::new(index as u64);
        (format!("{}, size {size}", fill.name()), make(size, fill, &mut random))
    };
    all.enumerate().map(set).collect()
}
