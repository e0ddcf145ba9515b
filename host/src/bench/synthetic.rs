//! A workload without files, which is the same on every machine.

use std::f64::consts::TAU;

use crate::camera::Camera;
use crate::error::Result;
use crate::scene::{
    Contraction, Field, Gaussians, GridConfig, Layer, MlpConfig, Placement, Scene, SceneConfig,
};
use crate::tile::{Tile, TileBatch};
use muslin_check::inputs::Random;

const GAUSSIANS: usize = 20_000;
const VIEWS: usize = 16;
/// Width and height of an image, in pixels.
const SIZE: [u32; 2] = [640, 480];
/// Focal length, in pixels.
const FOCAL: f64 = 620.0;
const TILES: usize = 64;
/// S, in pixels.
const SIDE: u32 = 64;
/// Width of both hidden layers of both networks.
const HIDDEN: u32 = 64;
/// Median scale of a Gaussian, in world units.
const SCALE: f64 = 0.6;
/// Logit of a transmittance that lets most of the light through.
const CLEAR: f32 = 3.0;

/// 20,000 Gaussians in a shell, 16 views around them, and 64 tiles of 64 x 64. Networks have two hidden layers of 64,
/// and hash grids have 16 levels of 2 features in at most 2^19 entries. The output of `bench/synthetic.py` has the
/// same distribution.
#[derive(Clone, Debug)]
pub struct Synthetic {
    /// Cameras on a wavy circle that look at its center.
    pub cameras: Vec<Camera>,
    /// Tiles at random places of the images.
    pub batch: TileBatch,
}

impl Synthetic {
    /// The cameras and the tiles.
    ///
    /// # Errors
    /// None: the cameras are valid.
    pub fn new() -> Result<Self> {
        let angle = 2.0 * (f64::from(SIZE[0]) / 2.0 / FOCAL).atan();
        let camera = |view: usize| {
            let turn = TAU * view as f64 / VIEWS as f64;
            let eye = [3.4 * turn.cos(), 3.4 * turn.sin(), 0.6 * (3.0 * turn).sin()];
            Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], angle, SIZE)
        };
        let mut random = Random::new(6);
        let mut tile = |_| Tile {
            camera: random.below(VIEWS as u32) as usize,
            origin: SIZE.map(|side| random.below(side - SIDE) as i32),
        };
        let tiles = (0..TILES).map(&mut tile).collect();
        Ok(Self {
            cameras: (0..VIEWS).map(camera).collect::<Result<_>>()?,
            batch: TileBatch { side: SIDE, tiles },
        })
    }

    /// Makes the scene anew, because a caller may not want to keep it while rendering.
    ///
    /// # Errors
    /// The same errors as [`Scene::zeros`].
    pub fn scene(&self) -> Result<Scene> {
        let mut scene = Scene::zeros(config(), GAUSSIANS)?;
        let mut random = Random::new(5);
        fill_gaussians(&mut scene.gaussians, &mut random);
        fill_field(&mut scene.color, 0.0, &mut random);
        fill_field(&mut scene.transmittance, CLEAR, &mut random);
        Ok(scene)
    }
}

fn config() -> SceneConfig {
    let grid = GridConfig {
        levels: 16,
        features: 2,
        log2_table: 19,
        base_resolution: 16.0,
        growth: 1.447_269_2,
    };
    let network = MlpConfig { hidden: vec![HIDDEN; 2] };
    SceneConfig {
        sh_degree: 3,
        material: 32,
        extra: 2,
        color_grid: grid.clone(),
        transmittance_grid: grid,
        color_mlp: network.clone(),
        transmittance_mlp: network,
        step: 0.03,
        blur: 0.3,
        occupancy: 0,
        antialiased: false,
        background: [0.1, 0.2, 0.3],
        aabb: [[-1.5; 3], [1.5; 3]],
        contraction: Contraction::None,
        placement: Placement::default(),
    }
}

/// A normally distributed number.
fn normal(random: &mut Random, mean: f32, deviation: f32) -> f32 {
    // 1 - x is never 0
    let radius = (-2.0 * (1.0 - random.between(0.0, 1.0)).ln()).sqrt();
    mean + deviation * radius * (std::f32::consts::TAU * random.between(0.0, 1.0)).cos()
}

fn fill(values: &mut [f32], random: &mut Random, mean: f32, deviation: f32) {
    values.iter_mut().for_each(|value| *value = normal(random, mean, deviation));
}

fn fill_gaussians(gaussians: &mut Gaussians, random: &mut Random) {
    for position in &mut gaussians.position {
        fill(position, random, 0.0, 1.0);
        let length = position.iter().map(|value| value * value).sum::<f32>().sqrt();
        let radius = random.between(0.3, 1.2) / length.max(f32::MIN_POSITIVE);
        *position = position.map(|value| value * radius);
    }
    fill(gaussians.rotation.as_flattened_mut(), random, 0.0, 1.0);
    let scale = (SCALE / (GAUSSIANS as f64).cbrt()).ln() as f32;
    fill(gaussians.log_scale.as_flattened_mut(), random, scale, 0.4);
    fill(&mut gaussians.opacity, random, 0.0, 1.5);
    fill(&mut gaussians.material, random, 0.0, 1.0);
    fill(&mut gaussians.extra, random, 0.0, 1.0);
}

/// Weights by He et al. `shift` is added to the last layer's biases.
fn fill_field(field: &mut Field, shift: f32, random: &mut Random) {
    fill(&mut field.grid, random, 0.0, 0.3);
    for Layer { weight, bias, inputs, .. } in &mut field.network.layers {
        fill(weight, random, 0.0, (2.0 / *inputs as f32).sqrt());
        fill(bias, random, 0.0, 0.1);
    }
    if let Some(last) = field.network.layers.last_mut() {
        last.bias.iter_mut().for_each(|bias| *bias += shift);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_workload_is_valid_and_the_same_each_time() {
        let synthetic = Synthetic::new().unwrap();
        synthetic.batch.validate(&synthetic.cameras).unwrap();
        assert_eq!((synthetic.cameras.len(), synthetic.batch.tiles.len()), (16, 64));
        let scene = synthetic.scene().unwrap();
        assert_eq!(scene.gaussians.len(), 20_000);
        assert_eq!(scene.transmittance.network.widths(), [34, 64, 64, 1]);
        for (tensor, values) in scene.tensors() {
            assert!(values.iter().all(|value| value.is_finite()), "{tensor:?}");
        }
        let size = |position: &[f32; 3]| position.iter().map(|x| x * x).sum::<f32>().sqrt();
        assert!(scene.gaussians.position.iter().map(size).all(|size| 0.29 < size && size < 1.21));
        assert!(scene == Synthetic::new().unwrap().scene().unwrap());
    }

    #[test]
    fn numbers_are_normal() {
        let mut random = Random::new(1);
        let values: Vec<_> =
            (0..10_000).map(|_| f64::from(normal(&mut random, 3.0, 2.0))).collect();
        let mean = values.iter().sum::<f64>() / 1e4;
        let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / 1e4;
        assert!((mean - 3.0).abs() < 0.1 && (variance.sqrt() - 2.0).abs() < 0.1, "{mean}");
    }
}
