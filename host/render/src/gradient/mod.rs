//! Gradients of a scene's tensors, on a device.

pub mod hash_grid;
pub mod ranks;

use std::ops::Range;
use std::sync::Arc;

use glam::Vec4;
use muslin::binned::ROWS;
use organza_shaders::binned::{BinnedGradientKernel, BinnedGradientParams};
use organza_shaders::count::ALL;
use organza_shaders::exposure::STRIDE;
use organza_shaders::pose_backward;

use self::hash_grid::HashGridGradient;
use crate::scene::device_scene::DeviceScene;
use crate::scene::field::DeviceField;
use crate::scene::packed::unpack;
use crate::stages::counts::NO_COUNTS;
use muslin_device::{Buffer, Count, Device};
use organza_core::error::{Error, Result};
use organza_core::scene::{FieldTensors, Gradient, SceneConfig, Tensors};

/// Numbers of a pose: a rotation vector and a shift. [`Camera::moved`](organza_core::Camera::moved) says what they mean.
pub const POSE: usize = pose_backward::VALUES as usize;

/// The tensors whose gradients `project_backward` adds to one buffer, in this order, which is the order of [`Tensors`], too.
pub const GEOMETRY: [&str; 5] = [
    "gaussians.position",
    "gaussians.rotation",
    "gaussians.log_scale",
    "gaussians.opacity",
    "gaussians.shape",
];

/// Gradients of all tensors of a scene; kernels add to them.
#[derive(Debug)]
pub struct SceneGradient {
    pub(crate) tensors: Tensors<TensorGradient>,
    /// `[11 N]`, or `[12 N]` with shapes: the gradients of [`GEOMETRY`], one after the other.
    pub(crate) geometry: Buffer<f32>,
    /// `[N]`: the sum of |dL/dmean2d| over cameras, how many cameras have shown the Gaussian, its largest radius in pixels, 0. Steps add to
    /// it; densification clears it.
    pub statistics: Buffer<Vec4>,
    /// The statistics as they were when the step began.
    statistics_before: Buffer<Vec4>,
    pub(crate) color: FieldGradient,
    pub(crate) transmittance: FieldGradient,
    /// Whether the backward pass computes the gradients of the transmittance field and of the extra vectors.
    pub has_transmittance: bool,
    /// The gradients of the cameras' poses, if [wanted](Self::with_poses).
    pub(crate) poses: Option<BinnedGradient>,
    /// The gradients of the photographs' exposures `[photographs, STRIDE]`, if [wanted](Self::with_exposures).
    pub exposures: Option<BinnedGradient>,
    /// `[COUNTS]`: the counts of [queued](crate::Renderer::queue_loss_gradient) batches.
    pub(crate) counts: Arc<Buffer<u32>>,
}

/// The gradient of one tensor, in the order of the tensor's values: a range of a buffer.
#[derive(Debug)]
pub struct TensorGradient {
    /// Several tensors can share a buffer.
    pub buffer: Buffer<f32>,
    /// The tensor's values in the buffer.
    pub range: Range<usize>,
    /// For a hash grid, one flag per block of 64 values: the optimizer skips blocks whose flag is 0.
    pub touched: Option<Buffer<u32>>,
}

/// Gradients of a hash grid and its network.
#[derive(Clone, Debug)]
pub struct FieldGradient {
    /// Packed as [`DeviceField::parameters`].
    pub network: BinnedGradient,
    /// Of the hash grid's table.
    pub table: HashGridGradient,
}

impl SceneGradient {
    /// Zeros, for a scene.
    ///
    /// # Errors
    /// [`Error::Argument`] where the scene's grids or networks are halves; as [`Device::zeros`].
    pub fn new(device: &Device, scene: &DeviceScene) -> Result<Self> {
        scene.require_gradients()?;
        let color = FieldGradient::new(device, &scene.color)?;
        let transmittance = FieldGradient::new(device, &scene.transmittance)?;
        Self::with_fields(device, scene, color, transmittance)
    }

    /// The gradient of the Gaussians that the scene has now, which is zero. The other gradients stay.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`].
    pub fn replace_gaussians(&mut self, device: &Device, scene: &DeviceScene) -> Result<()> {
        let Self { color, transmittance, has_transmittance, .. } = &*self;
        let gradient = Self::with_fields(device, scene, color.clone(), transmittance.clone())?;
        *self = Self {
            has_transmittance: *has_transmittance,
            poses: self.poses.take(),
            exposures: self.exposures.take(),
            ..gradient
        };
        Ok(())
    }

    fn with_fields(
        device: &Device,
        scene: &DeviceScene,
        color: FieldGradient,
        transmittance: FieldGradient,
    ) -> Result<Self> {
        const LABEL: &str = "gradient of the Gaussians";
        let of_scene = || scene.tensors.iter().filter(|(name, _)| GEOMETRY.contains(name));
        let geometry = device.zeros(LABEL, of_scene().map(|(_, values)| values.len()).sum())?;
        let mut end = 0;
        let gaussians = scene.tensors.gaussians.as_ref().try_map(|name, values| {
            let len = values.len();
            if !GEOMETRY.contains(&name) {
                return Ok(TensorGradient::whole(device.zeros(LABEL, len)?, None));
            }
            let range = end..end + len;
            end += len;
            Ok::<_, Error>(TensorGradient { buffer: geometry.clone(), range, touched: None })
        })?;
        Ok(Self {
            tensors: Tensors {
                gaussians,
                color: color.tensors(),
                transmittance: transmittance.tensors(),
            },
            geometry,
            statistics: device.zeros("statistics", scene.len())?,
            statistics_before: device.zeros("statistics before", scene.len())?,
            color,
            transmittance,
            has_transmittance: true,
            poses: None,
            exposures: None,
            counts: Arc::new(device.upload("counts of queued batches", &NO_COUNTS)?),
        })
    }

    /// Adds the gradients of the poses of `cameras` cameras: all that a batch may show.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`].
    pub fn with_poses(mut self, device: &Device, cameras: usize) -> Result<Self> {
        let label = "gradients of poses";
        self.poses = Some(BinnedGradient::new(device, label, POSE * cameras)?);
        Ok(self)
    }

    /// Adds the gradients of the exposures of `photographs` photographs: all that a batch may show.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`].
    pub fn with_exposures(mut self, device: &Device, photographs: usize) -> Result<Self> {
        let values = STRIDE as usize * photographs;
        self.exposures = Some(BinnedGradient::new(device, "gradients of exposures", values)?);
        Ok(self)
    }

    /// The gradients of the cameras' poses `[cameras, 6]`, or nothing if they are not wanted. Waits for the device.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn read_poses(&self, device: &Device) -> Result<Vec<[f32; POSE]>> {
        let Some(poses) = &self.poses else { return Ok(Vec::new()) };
        Ok(device.read(&poses.values)?.as_chunks().0.to_vec())
    }

    /// A count of `values`, or of none after a queued batch has failed: see [`Renderer::queue_loss_gradient`](crate::Renderer::queue_loss_gradient).
    pub fn unless_failed(&self, values: u32) -> Count {
        Count::on_device(&self.counts, ALL, values)
    }

    /// Forgets that a queued batch has failed. Later ones add to the gradient again.
    ///
    /// # Errors
    /// The same errors as [`Device::write`].
    pub fn clear_failure(&self, device: &Device) -> Result<()> {
        Ok(device.write(&self.counts, 0, &NO_COUNTS)?)
    }

    /// Every tensor's gradient.
    pub fn tensors(&self) -> &Tensors<TensorGradient> {
        &self.tensors
    }

    /// Checks that all gradients of the hash grids were finite.
    ///
    /// # Errors
    /// [`Error::Diverged`] where one was not; as [`Device::read`].
    pub fn check(&self, device: &Device) -> Result<()> {
        for (name, field) in [("color", &self.color), ("transmittance", &self.transmittance)] {
            if device.read(&field.table.status)?[0] != 0 {
                let reason = format!("a gradient of the {name} field is NaN or infinite");
                return Err(Error::Diverged { reason });
            }
        }
        Ok(())
    }

    /// Zeros, as [`SceneGradient::new`] makes them.
    pub fn clear(&self, device: &Device) {
        device.clear(&self.statistics);
        self.snapshot(device);
        self.rollback(device);
        for field in [&self.color, &self.transmittance] {
            device.clear(&field.table.status);
        }
    }

    /// Sets the scales of both hash grids' sums, for these numbers of samples of the color field and of the transmittance field.
    pub(crate) fn set_scales(
        &self,
        device: &Device,
        scene: &DeviceScene,
        [pairs, samples]: [&Count; 2],
    ) -> Result<()> {
        self.color.table.set_scale(device, &scene.color, pairs)?;
        if self.has_transmittance {
            self.transmittance.table.set_scale(device, &scene.transmittance, samples)?;
        }
        Ok(())
    }

    /// Adds all sums to the gradients, and clears the sums.
    pub(crate) fn finish(&self, device: &Device) -> Result<()> {
        for field in [&self.color, &self.transmittance] {
            field.table.finish(device)?;
            field.network.finish(device)?;
        }
        let mut per_photograph = self.poses.iter().chain(&self.exposures);
        Ok(per_photograph.try_for_each(|values| values.finish(device))?)
    }

    /// Remembers the statistics before a step, for [`Self::rollback`].
    pub(crate) fn snapshot(&self, device: &Device) {
        device.copy(&self.statistics, &self.statistics_before);
    }

    /// Restores the state before the step: zero gradients, and the statistics as they were then.
    pub fn rollback(&self, device: &Device) {
        device.copy(&self.statistics_before, &self.statistics);
        self.tensors.iter().for_each(|(_, tensor)| device.clear(&tensor.buffer));
        for field in [&self.color, &self.transmittance] {
            field.table.clear(device);
            field.network.clear(device);
        }
        self.clear_poses(device);
        self.exposures.iter().for_each(|exposures| exposures.clear(device));
    }

    /// Clears the gradients of the cameras' poses.
    pub fn clear_poses(&self, device: &Device) {
        self.poses.iter().for_each(|poses| poses.clear(device));
    }

    /// Clears the flags of the tables' blocks, for the next step.
    pub fn clear_touched(&self, device: &Device) {
        let touched = self.tensors.iter().filter_map(|(_, tensor)| tensor.touched.as_ref());
        touched.for_each(|touched| device.clear(touched));
    }

    /// The gradient on the host; `config` and `len` are the scene's.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn download(&self, device: &Device, config: &SceneConfig, len: usize) -> Result<Gradient> {
        let read = |tensor: &TensorGradient, values: &mut [f32]| {
            device.read_into(&tensor.buffer, tensor.range.start, values)
        };
        Ok(Gradient::new(unpack(config, len, self.tensors.as_ref(), read)?))
    }
}

impl TensorGradient {
    /// The gradient of a tensor that has a buffer of its own.
    pub fn whole(buffer: Buffer<f32>, touched: Option<Buffer<u32>>) -> Self {
        Self { range: 0..buffer.len(), buffer, touched }
    }

    /// The gradient's values.
    ///
    /// # Errors
    /// The same errors as [`Device::read`].
    pub fn read(&self, device: &Device) -> Result<Vec<f32>> {
        Ok(device.read_range(&self.buffer, self.range.start, self.range.len())?)
    }
}

impl FieldGradient {
    fn new(device: &Device, field: &DeviceField) -> Result<Self> {
        let values = 4 * field.parameters.len();
        Ok(Self {
            network: BinnedGradient::new(device, "gradient of a network", values)?,
            table: HashGridGradient::new(device, field)?,
        })
    }

    fn tensors(&self) -> FieldTensors<TensorGradient> {
        let touched = Some(self.table.touched.clone());
        FieldTensors {
            grid: TensorGradient::whole(self.table.gradient.clone(), touched),
            network: TensorGradient::whole(self.network.values.clone(), None),
        }
    }
}

/// A gradient, and the [binned](muslin::binned) sums that become part of it.
#[derive(Clone, Debug)]
pub struct BinnedGradient {
    /// [`BinnedGradient::finish`] adds to it.
    pub values: Buffer<f32>,
    /// `[17, values, 2]`: 64-bit integers, the low word first; kernels add to them.
    pub sum: Buffer<u32>,
}

impl BinnedGradient {
    /// Zeros.
    pub fn new(device: &Device, label: &'static str, values: usize) -> muslin_device::Result<Self> {
        let sum = device.zeros("sums of a gradient", 2 * ROWS as usize * values)?;
        Ok(Self { values: device.zeros(label, values)?, sum })
    }

    /// Adds the sums to the gradient, and clears them.
    pub fn finish(&self, device: &Device) -> muslin_device::Result<()> {
        let values = self.values.len() as u32;
        let kernel = BinnedGradientKernel {
            params: BinnedGradientParams { values },
            sum: &self.sum,
            gradient: &self.values,
        };
        device.run_all(&kernel)
    }

    /// Zeros, as in the beginning.
    pub fn clear(&self, device: &Device) {
        device.clear(&self.values);
        device.clear(&self.sum);
    }
}
