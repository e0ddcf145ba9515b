//! A scene on a device as training has it: whole, or a shard of its Gaussians.

use std::borrow::Cow;
use std::sync::Arc;

use super::device_scene::DeviceScene;
use muslin_device::{Buffer, Device};
use organza_core::error::{Error, Result};
use organza_core::scene::{GaussianTensors, Gaussians, Scene, SceneConfig};

/// The size of the one block of a whole scene.
pub(crate) const WHOLE: usize = usize::MAX;

/// A scene on a device as training has it: the fields, and the Gaussians in blocks. A whole scene is one block. A
/// [shard](organza_core::scene::SceneShard) of one has them in [blocks](organza_core::scene::GAUSSIANS_PER_BLOCK).
#[derive(Debug)]
pub struct DeviceShard {
    /// The fields, with a Gaussian that is never rendered: a shard may have none.
    pub(crate) fields: DeviceScene,
    /// Scenes with the same fields, on the same memory.
    pub(super) blocks: Vec<DeviceScene>,
    /// The most Gaussians of a block, or [`WHOLE`].
    pub(super) block: usize,
}

/// A scene as a batch sees it: its Gaussians in blocks, each of which is a scene with the same fields.
#[derive(Clone, Copy, Debug)]
pub struct SceneBlocks<'a> {
    pub(crate) fields: &'a DeviceScene,
    pub(crate) blocks: &'a [DeviceScene],
    /// Whether other ranks may have other Gaussians.
    pub(crate) is_shard: bool,
}

impl<'a> From<&'a DeviceScene> for SceneBlocks<'a> {
    fn from(scene: &'a DeviceScene) -> Self {
        Self { fields: scene, blocks: std::slice::from_ref(scene), is_shard: false }
    }
}

impl<'a> From<&'a DeviceShard> for SceneBlocks<'a> {
    fn from(scene: &'a DeviceShard) -> Self {
        Self { fields: &scene.fields, blocks: &scene.blocks, is_shard: scene.block != WHOLE }
    }
}

impl DeviceShard {
    /// The scene, unless this is a shard.
    #[must_use]
    pub fn whole(&self) -> Option<&DeviceScene> {
        self.blocks.first().filter(|_| self.block == WHOLE)
    }

    /// The most Gaussians of a block.
    #[must_use]
    pub fn block(&self) -> usize {
        self.block
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
        for block in in_blocks(gaussians, self.block) {
            self.blocks.push(self.fields.with_gaussians(device, &block)?);
        }
        self.update_occupancy(device)
    }

    /// Finds anew where Gaussians are: to be called whenever some have moved. Of a shard, the ranks find it together before they
    /// render.
    ///
    /// # Errors
    /// The same errors as [`Device::dispatch`].
    pub fn update_occupancy(&self, device: &Device) -> Result<()> {
        match self.whole() {
            Some(scene) => SceneBlocks::from(scene).update_occupancy(device, None),
            None => Ok(()),
        }
    }

    /// The same shard, on the same memory: see [`DeviceScene::coarser`].
    pub fn coarser(&self, factor: u32, ray_steps: u32) -> Self {
        let of = |scene: &DeviceScene| scene.coarser(factor, ray_steps);
        let blocks = self.blocks.iter().map(of).collect();
        Self { fields: of(&self.fields), blocks, block: self.block }
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

/// Gaussians in [blocks](DeviceShard::block) of at most this many.
pub fn in_blocks(gaussians: &Gaussians, block: usize) -> impl Iterator<Item = Cow<'_, Gaussians>> {
    (0..gaussians.len()).step_by(block).map(move |first| {
        if block >= gaussians.len() {
            return Cow::Borrowed(gaussians);
        }
        let indices = first..gaussians.len().min(first + block);
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
    pub(crate) fn with_gaussians(&self, device: &Device, gaussians: &Gaussians) -> Result<Self> {
        let mut scene = self.clone();
        scene.gaussians = gaussians.len() as u32;
        let tensors = gaussians.tensors();
        scene.tensors.gaussians = tensors.try_map(|name, values| device.upload(name, values))?;
        scene.version = Arc::default();
        Ok(scene)
    }
}
