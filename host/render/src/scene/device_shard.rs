//! A scene on a device as training has it: whole, or a shard of its Gaussians.

use std::borrow::Cow;
use std::sync::Arc;

use super::device_scene::DeviceScene;
use muslin_device::{Buffer, Device};
use organza_core::error::{Error, Result};
use organza_core::scene::{GAUSSIANS_PER_BLOCK, GaussianTensors, Gaussians, Scene, SceneConfig};

/// A scene on a device as training has it: the fields, and the Gaussians in blocks. A whole scene is one block. A
/// [shard](organza_core::scene::SceneShard) of one has them in [blocks](organza_core::scene::GAUSSIANS_PER_BLOCK).
#[derive(Debug)]
pub struct DeviceShard {
    /// The fields, with a Gaussian that is never rendered: a shard may have none.
    pub(crate) fields: DeviceScene,
    /// Scenes with the same fields, on the same memory.
    pub(super) blocks: Vec<DeviceScene>,
    pub(super) is_whole: bool,
}

impl DeviceShard {
    /// A whole scene.
    pub fn from_scene(device: &Device, scene: DeviceScene) -> Result<Self> {
        let fields = scene.with_gaussians(device, &Gaussians::zeros(scene.config(), 1)?)?;
        Ok(Self { fields, blocks: vec![scene], is_whole: true })
    }

    /// The scene, if it is whole.
    #[must_use]
    pub fn whole(&self) -> Option<&DeviceScene> {
        self.blocks.first().filter(|_| self.is_whole)
    }

    /// The Gaussians that are here, in pieces: each is a scene with the same fields.
    pub fn blocks(&self) -> &[DeviceScene] {
        &self.blocks
    }

    /// The configuration of the scene.
    #[must_use]
    pub fn config(&self) -> &SceneConfig {
        &self.fields.config
    }

    /// Gaussians of the shard.
    #[must_use]
    pub fn len(&self) -> usize {
        self.blocks.iter().map(DeviceScene::len).sum()
    }

    /// Whether the shard has no Gaussians.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty()
    }

    /// The shard has these Gaussians from now on.
    ///
    /// # Errors
    /// The same errors as [`Device::upload`]. Some Gaussians are missing then.
    pub fn replace_gaussians(&mut self, device: &Device, gaussians: &Gaussians) -> Result<()> {
        // not both at once
        self.blocks.clear();
        for block in in_blocks(gaussians, self.is_whole) {
            self.blocks.push(self.fields.with_gaussians(device, &block)?);
        }
        Ok(())
    }

    /// The same shard, on the same memory: see [`DeviceScene::coarser`].
    pub fn coarser(&self, factor: u32, ray_steps: u32) -> Self {
        let of = |scene: &DeviceScene| scene.coarser(factor, ray_steps);
        let blocks = self.blocks.iter().map(of).collect();
        Self { fields: of(&self.fields), blocks, is_whole: self.is_whole }
    }

    /// Eq. 13 divides no sum.
    pub fn never_divide(&mut self) {
        let scenes = self.blocks.iter_mut().chain([&mut self.fields]);
        scenes.for_each(|scene| scene.divide_above = f32::MAX);
    }

    /// The fields and the shard's Gaussians as they are now.
    ///
    /// # Errors
    /// The same errors as [`DeviceScene::download`].
    pub fn download(&self, device: &Device) -> Result<Scene> {
        let mut scene = self.fields.download(device)?;
        scene.gaussians = Gaussians::zeros(self.config(), self.len())?;
        let blocks = self.blocks.iter().map(|block| block.tensors.gaussians.as_ref());
        read_blocks(device, blocks, &mut scene.gaussians)?;
        Ok(scene)
    }

    /// A scene with the fields, and a Gaussian that is never rendered.
    pub fn fields(&self) -> &DeviceScene {
        &self.fields
    }
}

/// The Gaussians of a shard in blocks; those of a whole scene as they are.
pub fn in_blocks(
    gaussians: &Gaussians,
    is_whole: bool,
) -> impl Iterator<Item = Cow<'_, Gaussians>> {
    let size = if is_whole { gaussians.len().max(1) } else { GAUSSIANS_PER_BLOCK };
    (0..gaussians.len()).step_by(size).map(move |first| {
        if size >= gaussians.len() {
            return Cow::Borrowed(gaussians);
        }
        let indices = first..gaussians.len().min(first + size);
        Cow::Owned(gaussians.select(&indices.collect::<Vec<_>>()))
    })
}

/// Reads the tensors of blocks, one after the other.
pub fn read_blocks<'a>(
    device: &Device,
    blocks: impl Iterator<Item = GaussianTensors<&'a Buffer<f32>>>,
    gaussians: &mut Gaussians,
) -> Result<()> {
    let mut rest = gaussians.tensors_mut();
    for block in blocks {
        rest = rest.zip(block).try_map(|_, (values, buffer)| {
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
