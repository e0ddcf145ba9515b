//! Rows of the [table](super::table) for the projection and for splats: what moves, what the forward kernel makes of it, and where
//! both gradients lie.

use glam::{Mat3, Quat, Vec3};
use muslin_check::prelude::*;
use muslin_device::Device;
use organza_shaders::splat::{SplatInputs, SplatParams};

use super::table::{Row, flat, output, vectors, wide};
use crate::pose_backward::PoseBackward;
use crate::project::Project;
use crate::project_backward::ProjectBackward;
use crate::splat::{Splat, SplatBackward};

/// Positions, rotations and the logarithms of axes.
impl Row for ProjectBackward {
    const STEP: f64 = 1.0 / 1024.0;
    const ALLOWED: f64 = 1e-3;

    fn point(&self) -> Vec<f32> {
        let set = &self.forward;
        [&set.position[..], &set.rotation, &set.log_scale].concat()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let mut set = self.forward.clone();
        let (position, rest) = point.split_at(set.position.len());
        let (rotation, log_scale) = rest.split_at(set.rotation.len());
        set.position = position.to_vec();
        set.rotation = rotation.to_vec();
        set.log_scale = log_scale.to_vec();
        self.project_pairs(cpu, &set)
    }

    fn slopes(&self) -> Vec<f64> {
        self.pair_gradient.iter().flat_map(|[a, b, _]| wide([a.x, a.y, b.x, b.y, b.z])).collect()
    }

    fn leave_out(&mut self, output: usize) {
        let [center, conic, _] = &mut self.pair_gradient[output / 5];
        match output % 5 {
            part @ 0..2 => center[part] = 0.0,
            part => conic[part - 2] = 0.0,
        }
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "gradient");
        let added = found.iter().zip(&self.gradient).map(|(found, &x)| found - f64::from(x));
        added.take(self.point().len()).collect()
    }
}

impl ProjectBackward {
    /// Center and conic of every pair, as `project` projects a scene.
    fn project_pairs(&self, cpu: &Device, scene: &Project) -> Vec<f64> {
        let mean = output(cpu, scene, "mean2d");
        let conic = output(cpu, scene, "conic");
        let count = scene.gaussians as usize;
        let mut pairs = vec![[0.0; 5]; self.pair_gradient.len()];
        for slot in 0..scene.cameras.len() * count {
            if let Some(pair) = self.pair(slot / count, slot % count) {
                pairs[pair][..2].copy_from_slice(&mean[2 * slot..][..2]);
                pairs[pair][2..].copy_from_slice(&conic[3 * slot..][..3]);
            }
        }
        pairs.into_flattened()
    }
}

/// The six values of each camera's pose.
impl Row for PoseBackward {
    const STEP: f64 = 1.0 / 1024.0;
    const ALLOWED: f64 = 1e-3;

    fn point(&self) -> Vec<f32> {
        vec![0.0; 6 * self.0.forward.cameras.len()]
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let mut scene = self.0.forward.clone();
        for (camera, pose) in scene.cameras.iter_mut().zip(point.chunks_exact(6)) {
            let turn = Mat3::from_quat(Quat::from_scaled_axis(Vec3::from_slice(pose)));
            // W' = exp([w]x) W, and the eye is where t' is 0
            let rows = Mat3::from_cols_array_2d(&camera.rotation.map(|row| row.to_array()));
            let turned = rows * turn.transpose();
            camera.rotation = [turned.x_axis, turned.y_axis, turned.z_axis];
            camera.eye -= turned * Vec3::from_slice(&pose[3..]);
        }
        self.0.project_pairs(cpu, &scene)
    }

    fn slopes(&self) -> Vec<f64> {
        self.0.slopes()
    }

    fn leave_out(&mut self, output: usize) {
        self.0.leave_out(output);
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "sum");
        let before = self.before();
        let of = |value: usize| found[value] - f64::from(before[value]);
        let places = self.places().into_iter();
        places.flat_map(|place| (6 * place as usize..6 * place as usize + 6).map(of)).collect()
    }
}

/// Centers and conics of the projection, opacities, transmittances and colors.
impl Row for SplatBackward {
    fn point(&self) -> Vec<f32> {
        let slots = 2 * self.params.gaussians as usize;
        let mut random = Random::new(8);
        let projection = random.values(8 * slots, -10.0, 10.0);
        let color = random.values(3 * self.pair.len(), 0.0, 1.0);
        [&projection[..], &self.opacity, &self.transmittance, &color].concat()
    }

    fn forward(&self, cpu: &Device, point: &[f32]) -> Vec<f64> {
        let SplatParts { projection, opacity, transmittance, color } = self.parts(point);
        let set = Splat(SplatInputs {
            params: SplatParams {
                pairs: self.params.pairs,
                gaussians: self.params.gaussians,
                // `composite_backward` has the gradient of a compensation
                compensated_blur: 0.0,
            },
            pair: self.pair.clone(),
            projection: vectors(projection),
            opacity: opacity.to_vec(),
            transmittance: transmittance.to_vec(),
            color: color.to_vec(),
            splat: unwritten(3 * self.pair.len()),
        });
        let splats = output(cpu, &set, "splat");
        let mut members = vec![0.0; 4 * self.member_gradient.len()];
        for (pair, &slot) in self.pair.iter().enumerate() {
            for member in self.members(slot) {
                let member = &mut members[12 * member..][..12];
                member.copy_from_slice(&splats[12 * pair..][..12]);
                // the extents have no gradient
                member[3] = 0.0;
                member[7] = 0.0;
            }
        }
        members
    }

    fn slopes(&self) -> Vec<f64> {
        wide(flat(&self.member_gradient))
    }

    fn gradient(&self, cpu: &Device) -> Vec<f64> {
        let found = output(cpu, self, "pair_gradient");
        let gaussians = self.params.gaussians as usize;
        let mut projection = vec![0.0; 16 * gaussians];
        let mut opacity = vec![0.0; gaussians];
        let mut transmittance = Vec::new();
        let mut color = Vec::new();
        for (pair, &slot) in found.chunks_exact(12).zip(&self.pair) {
            let to = 8 * slot as usize;
            projection[to..to + 2].copy_from_slice(&pair[..2]);
            projection[to + 4..to + 7].copy_from_slice(&pair[4..7]);
            opacity[slot as usize % gaussians] += pair[2];
            transmittance.push(pair[3]);
            color.extend_from_slice(&pair[8..11]);
        }
        [projection, opacity, transmittance, color].concat()
    }
}

/// The inputs of `splat`, apart.
struct SplatParts<'a> {
    projection: &'a [f32],
    opacity: &'a [f32],
    transmittance: &'a [f32],
    color: &'a [f32],
}

impl SplatBackward {
    fn parts<'a>(&self, point: &'a [f32]) -> SplatParts<'a> {
        let (projection, rest) = point.split_at(16 * self.params.gaussians as usize);
        let (opacity, rest) = rest.split_at(self.opacity.len());
        let (transmittance, color) = rest.split_at(self.transmittance.len());
        SplatParts { projection, opacity, transmittance, color }
    }
}
