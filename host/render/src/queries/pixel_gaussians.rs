//! The Gaussians of single pixels, as the host sees them.

use glam::{Vec2, Vec4};
use organza_shaders::composite::{alpha, splat_distance};
use organza_shaders::project::in_support;
use organza_shaders::splat::VECTORS;
use organza_shaders::tile::Tile as KernelTile;

use crate::pass::part::Part;
use crate::stages::tiles::TileBins;
use muslin_device::{Buffer, Device};
use organza_core::{Camera, Result};

/// A Gaussian that reaches a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelGaussian {
    pub gaussian: usize,
    /// Along the camera's axis, in world units.
    pub depth: f64,
    /// alpha of Eq. 12
    pub weight: f64,
    /// The factor of alpha that is 1 at the Gaussian's center.
    pub falloff: f64,
    /// Red, green and blue.
    pub color: [f64; 3],
}

/// The splats and tiles of a part with one camera, to find the Gaussians of its pixels.
#[derive(Debug)]
pub struct PartSplats {
    /// `[pairs]`: with one camera, these are Gaussians.
    pub pair: Vec<u32>,
    first: Vec<u32>,
    intersection: Vec<u32>,
    splat: Vec<Vec4>,
    slope: Vec<[Vec4; 2]>,
}

impl PartSplats {
    pub fn read(device: &Device, part: &Part) -> Result<Self> {
        let own = Self::of(device, &part.bins, &part.composite.splat)?;
        Ok(Self { slope: part.composite.read_slopes(device)?, ..own })
    }

    /// Those of each scene that a part shows, the first one's first, without slopes.
    pub fn read_all(device: &Device, part: &Part) -> Result<Vec<Self>> {
        let beside = part.beside.iter().map(|other| &other.bins);
        let bins = std::iter::once(&part.bins).chain(beside);
        let splats = std::iter::once(&part.composite.splat).chain(&part.composite.others);
        bins.zip(splats).map(|(bins, splats)| Self::of(device, bins, splats)).collect()
    }

    fn of(device: &Device, bins: &TileBins, splats: &Buffer<Vec4>) -> Result<Self> {
        Ok(Self {
            pair: device.read(&bins.pairs.pair)?,
            first: device.read(&bins.tile_first)?,
            intersection: device.read(&bins.intersection)?,
            splat: device.read(splats)?,
            slope: Vec::new(),
        })
    }

    /// The Gaussians of a part's tile, with their splats.
    pub fn in_tile(&self, tile: usize) -> impl Iterator<Item = (usize, [Vec4; 3])> {
        let range = self.first[tile] as usize..self.first[tile + 1] as usize;
        self.intersection[range].iter().map(|&pair| {
            let at = pair as usize * VECTORS as usize;
            let splat = std::array::from_fn(|vector| self.splat[at + vector]);
            (self.pair[pair as usize] as usize, splat)
        })
    }

    /// The Gaussians that reach a pixel of the image, which lies in the part's tile `tile`. `depth` gives a Gaussian's depth.
    pub fn at(
        &self,
        tile: usize,
        pixel: [i32; 2],
        depth: impl Fn(usize) -> f64,
    ) -> Vec<PixelGaussian> {
        let square = KernelTile { camera: 0, origin: pixel, output: 0 };
        let center = square.pixel_center(0, 0);
        let range = self.first[tile] as usize..self.first[tile + 1] as usize;
        let reaching = |&pair: &u32| {
            let at = pair as usize * VECTORS as usize;
            let q = splat_distance(self.splat[at], self.splat[at + 1], center.x, center.y);
            let gaussian = self.pair[pair as usize] as usize;
            let placed = self.splat[at];
            let [weight, falloff] =
                [placed, Vec4::ONE].map(|placed| alpha(placed, self.splat[at + 2], true, q).into());
            let apart = center - Vec2::new(placed.x, placed.y);
            let color = color_at(self.splat[at + 2], self.slope.get(pair as usize), apart);
            let color = color.truncate().to_array().map(f64::from);
            let depth = || depth(gaussian);
            in_support(q).then(|| PixelGaussian {
                gaussian,
                depth: depth(),
                weight,
                falloff,
                color,
            })
        };
        self.intersection[range].iter().filter_map(reaching).collect()
    }
}

/// The color of a pair at a distance from its center, in pixels.
pub fn color_at(color: Vec4, slope: Option<&[Vec4; 2]>, apart: Vec2) -> Vec4 {
    slope.map_or(color, |[along_x, along_y]| color + *along_x * apart.x + *along_y * apart.y)
}

/// The depth of a pixel's surface, and S, the sum of the weights. The surface is the median: Gaussians with half of the weight
/// are nearer. Sorts them by depth. `None` if S is 0.
pub fn surface(reaching: &mut [PixelGaussian]) -> Option<(f64, f64)> {
    reaching.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let sum: f64 = reaching.iter().map(|one| one.weight).sum();
    let half = depth_of(reaching, 0.5 * sum);
    half.filter(|_| sum > 0.0).map(|depth| (depth, sum))
}

/// The depth up to which Gaussians, sorted by depth, have a weight together.
pub fn depth_of(reaching: &[PixelGaussian], weight: f64) -> Option<f64> {
    let mut before = 0.0;
    let found = reaching.iter().find(|one| {
        before += one.weight;
        before >= weight
    });
    found.map(|one| one.depth)
}

/// Depths of points `[N, 3]` along a camera's axis.
pub fn depths(position: &[f32], camera: &Camera) -> Vec<f64> {
    let depth = |place: &[f32; 3]| camera.depth(place.map(f64::from));
    position.as_chunks::<3>().0.iter().map(depth).collect()
}
