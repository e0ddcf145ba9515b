//! A scene on a device as training has it: whole, or a share of its Gaussians.

use std::sync::Arc;

use super::options::UploadOptions;
use super::renderer::Renderer;
use super::scene::DeviceScene;
use crate::error::{Error, Result};
use crate::scene::{GaussianTensors, Gaussians, SLICE, Scene, SceneConfig, SceneShare};
use organza_device::{Buffer, Device};

/// A [share](SceneShare) of a scene on a device: slices of Gaussians, which have the fields in common. A whole scene is in one
/// piece.
#[derive(Debug)]
pub struct DeviceShare {
    /// A whole scene. Otherwise the fields, and a Gaussian that is never rendered: a share may have none.
    pub(super) fields: DeviceScene,
    pub(super) slices: Vec<DeviceScene>,
    is_whole: bool,
}

impl DeviceShare {
    /// The Gaussians of `scene`, which are a share, and its fields.
    ///
    /// # Errors
    /// As [`Renderer::upload_with`].
    pub(crate) fn upload(
        renderer: &Renderer,
        scene: &Scene,
        options: UploadOptions,
    ) -> Result<Self> {
        let Scene { config, gaussians, color, transmittance } = scene;
        if !gaussians.is_empty() {
            scene.validate()?;
        }
        let mut fields = Scene::zeros(config.clone(), 1)?;
        (fields.color, fields.transmittance) = (color.clone(), transmittance.clone());
        let fields = renderer.upload_with(&fields, options)?;
        let mut uploaded = Self { fields, slices: Vec::new(), is_whole: false };
        uploaded.replace_gaussians(renderer.device(), gaussians)?;
        Ok(uploaded)
    }

    /// A whole scene.
    pub(crate) fn of_whole(scene: DeviceScene) -> Self {
        Self { fields: scene, slices: Vec::new(), is_whole: true }
    }

    /// The scene, if it is whole.
    #[must_use]
    pub fn whole(&self) -> Option<&DeviceScene> {
        self.is_whole.then_some(&self.fields)
    }

    /// The pieces of the Gaussians that are here, each of which is a scene with the same fields.
    pub(crate) fn blocks(&self) -> &[DeviceScene] {
        if self.is_whole { std::slice::from_ref(&self.fields) } else { &self.slices }
    }

    /// The configuration of the scene.
    #[must_use]
    pub fn config(&self) -> &SceneConfig {
        &self.fields.config
    }

    /// Gaussians of the share.
    #[must_use]
    pub fn len(&self) -> usize {
        self.blocks().iter().map(DeviceScene::len).sum()
    }

    /// Whether the share has no Gaussians.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.blocks().is_empty()
    }

    /// The share has these Gaussians from now on.
    ///
    /// # Errors
    /// As [`Device::upload`]. Some Gaussians are missing then.
    pub(crate) fn replace_gaussians(
        &mut self,
        device: &Device,
        gaussians: &Gaussians,
    ) -> Result<()> {
        if self.is_whole {
            self.fields = self.fields.with_gaussians(device, gaussians)?;
            return Ok(());
        }
        // not both at once
        self.slices.clear();
        for slice in in_slices(gaussians) {
            self.slices.push(self.fields.with_gaussians(device, &slice)?);
        }
        Ok(())
    }

    /// The same share, on the same memory: see [`DeviceScene::coarser`].
    pub(crate) fn coarser(&self, factor: u32, ray_steps: u32) -> Self {
        let of = |scene: &DeviceScene| scene.coarser(factor, ray_steps);
        let slices = self.slices.iter().map(of).collect();
        Self { fields: of(&self.fields), slices, ..*self }
    }

    /// Eq. 13 divides no sum.
    pub(crate) fn never_divide(&mut self) {
        let scenes = self.slices.iter_mut().chain([&mut self.fields]);
        scenes.for_each(|scene| scene.divide_above = f32::MAX);
    }

    /// The fields and the share's Gaussians as they are now.
    ///
    /// # Errors
    /// As [`DeviceScene::download`].
    pub fn download(&self, device: &Device) -> Result<Scene> {
        let mut scene = self.fields.download(device)?;
        if self.is_whole {
            return Ok(scene);
        }
        scene.gaussians = Gaussians::zeros(self.config(), self.len())?;
        let slices = self.slices.iter().map(|slice| slice.tensors.gaussians.as_ref());
        read_slices(device, slices, &mut scene.gaussians)?;
        Ok(scene)
    }

    /// A scene with the fields. Its Gaussians are those of a whole scene; otherwise there is one that is never rendered.
    pub(crate) fn fields(&self) -> &DeviceScene {
        &self.fields
    }
}

/// The slices of a share's Gaussians.
pub(crate) fn in_slices(gaussians: &Gaussians) -> impl Iterator<Item = Gaussians> {
    let first = (0..gaussians.len()).step_by(SLICE);
    first.map(|first| {
        let indices = first..gaussians.len().min(first + SLICE);
        gaussians.select(&indices.collect::<Vec<_>>())
    })
}

/// Reads the tensors of slices, one after the other.
pub(crate) fn read_slices<'a>(
    device: &Device,
    slices: impl Iterator<Item = GaussianTensors<&'a Buffer<f32>>>,
    gaussians: &mut Gaussians,
) -> Result<()> {
    let mut rest = gaussians.tensors_mut();
    for slice in slices {
        rest = rest.zip(slice).try_map(|_, (values, buffer)| {
            let (values, after) = values.split_at_mut(buffer.len());
            device.read_into(buffer, 0, values)?;
            Ok::<_, Error>(after)
        })?;
    }
    Ok(())
}

impl DeviceScene {
    /// Other Gaussians, with the same fields on the same memory.
    fn with_gaussians(&self, device: &Device, gaussians: &Gaussians) -> Result<Self> {
        let mut scene = self.view();
        scene.gaussians = gaussians.len() as u32;
        let tensors = gaussians.tensors();
        scene.tensors.gaussians = tensors.try_map(|name, values| device.upload(name, values))?;
        scene.version = Arc::default();
        Ok(scene)
    }
}

impl Renderer {
    /// Copies a share to the device.
    ///
    /// # Errors
    /// As [`Renderer::upload_with`].
    pub fn upload_share(&self, share: &SceneShare, options: UploadOptions) -> Result<DeviceShare> {
        DeviceShare::upload(self, &share.scene, options)
    }
}
