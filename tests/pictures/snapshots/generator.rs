//! Scenes from a recipe: small, built in code, the same on every system.

use organza::scene::{Contraction, GridConfig, MlpConfig, Network, Placement, SceneConfig};
use organza::{Camera, Scene};

/// Pseudo-random numbers in [0, 1).
#[derive(Clone, Debug)]
pub struct Noise(u32);

impl Noise {
    /// The next number.
    pub fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut x = self.0;
        x = (x ^ (x >> 16)).wrapping_mul(0x85eb_ca6b);
        x = (x ^ (x >> 13)).wrapping_mul(0xc2b2_ae35);
        ((x ^ (x >> 16)) >> 8) as f32 / (1 << 24) as f32
    }

    /// The next number in [low, high).
    pub fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.next()
    }
}

/// The parameters of a scene.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// Different seeds give independent scenes.
    pub seed: u32,
    /// Number of Gaussians.
    pub gaussians: usize,
    /// Degree of the harmonics.
    pub degree: u32,
    /// Width of the material.
    pub material: u32,
    /// Width of the extra vector.
    pub extra: u32,
    /// Bias of the transmittance network's output: a larger one is clearer.
    pub clearness: f32,
    /// Smallest and largest logarithm of a scale.
    pub log_scale: [f32; 2],
    /// Smallest and largest opacity logit.
    pub opacity: [f32; 2],
}

impl Default for Recipe {
    fn default() -> Self {
        Self {
            seed: 1,
            gaussians: 40,
            degree: 2,
            material: 3,
            extra: 2,
            clearness: 3.0,
            log_scale: [-2.4, -1.0],
            opacity: [-1.0, 2.0],
        }
    }
}

impl Recipe {
    /// The scene.
    pub fn scene(&self) -> Scene {
        let mut scene =
            Scene::zeros(self.config(), self.gaussians).expect("the recipe makes a valid scene");
        let mut noise = Noise(self.seed.wrapping_mul(0x1656_67b1));
        let [lo, hi] = scene.config.aabb.map(|corner| corner.map(|value| value as f32));
        let gaussians = &mut scene.gaussians;
        for position in &mut gaussians.position {
            *position = std::array::from_fn(|axis| noise.within(0.8 * lo[axis], 0.8 * hi[axis]));
        }
        for rotation in &mut gaussians.rotation {
            *rotation = std::array::from_fn(|axis| noise.within(-1.0, 1.0) + f32::from(axis == 0));
        }
        let [small, large] = self.log_scale;
        gaussians.log_scale.as_flattened_mut().fill_with(|| noise.within(small, large));
        gaussians.opacity.fill_with(|| noise.within(self.opacity[0], self.opacity[1]));
        // the material distinguishes Gaussians of one neighborhood
        gaussians.material.fill_with(|| noise.within(-4.0, 4.0));
        for values in [&mut gaussians.extra, &mut scene.color.grid, &mut scene.transmittance.grid] {
            values.fill_with(|| noise.within(-1.0, 1.0));
        }
        fill_network(&mut scene.color.network, &mut noise, [2.0, 0.0]);
        fill_network(&mut scene.transmittance.network, &mut noise, [1.0, self.clearness]);
        scene
    }

    /// Both grids have a dense level and hashed ones.
    fn config(&self) -> SceneConfig {
        let grid = |levels, features, log2_table, base_resolution| GridConfig {
            levels,
            features,
            log2_table,
            base_resolution,
            growth: 1.9,
        };
        let config = SceneConfig {
            sh_degree: self.degree,
            material: self.material,
            extra: self.extra,
            color_grid: grid(3, 2, 8, 5.0),
            transmittance_grid: grid(2, 4, 7, 4.5),
            color_mlp: MlpConfig { hidden: vec![24, 18] },
            transmittance_mlp: MlpConfig { hidden: vec![17] },
            step: 0.083,
            blur: 0.3,
            slope: 0,
            shape: 0,
            occupancy: 0,
            antialiased: false,
            background: [0.129, 0.499, 0.601],
            aabb: [[-1.5, -1.2, -1.0], [1.5, 1.2, 1.4]],
            contraction: Contraction::None,
            placement: Placement::default(),
            trained_on: None,
        };
        for grid in [&config.color_grid, &config.transmittance_grid] {
            let hashed = grid.levels_geometry().iter().filter(|level| level.hashed).count();
            assert!(hashed > 0 && hashed < grid.levels as usize, "{hashed} hashed levels");
        }
        config
    }
}

/// Fills weights that keep the size of values from layer to layer. The last layer has its own gain and bias.
fn fill_network(network: &mut Network, noise: &mut Noise, [gain, bias]: [f32; 2]) {
    let last = network.layers.len() - 1;
    for (index, layer) in network.layers.iter_mut().enumerate() {
        let size = (6.0 / layer.inputs as f32).sqrt() * if index == last { gain } else { 1.0 };
        layer.weight.fill_with(|| noise.within(-size, size));
        let middle = if index == last { bias } else { 0.0 };
        layer.bias.fill_with(|| noise.within(middle - 0.3, middle + 0.3));
    }
}

/// A camera at `eye` that looks at the center of the scenes' box.
pub fn camera(eye: [f64; 3], size: [u32; 2]) -> Camera {
    camera_to(eye, [0.0, 0.0, 0.2], size)
}

/// A camera at `eye` that looks at `target`.
pub fn camera_to(eye: [f64; 3], target: [f64; 3], size: [u32; 2]) -> Camera {
    Camera::look_at(eye, target, [0.0, 1.0, 0.0], 0.9, size).expect("a camera")
}

/// The scene with only these Gaussians.
pub fn keep(scene: &Scene, gaussians: &[usize]) -> Scene {
    Scene { gaussians: scene.gaussians.select(gaussians), ..scene.clone() }
}
