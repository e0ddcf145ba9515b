//! A scene's tensors in the kernels' layout: upload and download.

use std::borrow::Cow;

use super::network::{pack_network, packed_len, unpack_network};
use muslin_device::{Buffer, Device};
use organza_core::error::Result;
use organza_core::scene::{Field, FieldTensors, Gaussians, Network, Scene, SceneConfig, Tensors};

/// A scene's tensors as kernels read them.
pub fn pack(scene: &Scene) -> Tensors<Cow<'_, [f32]>> {
    Tensors {
        gaussians: scene.gaussians.tensors().map(Cow::Borrowed),
        color: pack_field(&scene.color),
        transmittance: pack_field(&scene.transmittance),
    }
}

/// A field's tensors as kernels read them.
pub fn pack_field(field: &Field) -> FieldTensors<Cow<'_, [f32]>> {
    FieldTensors {
        grid: Cow::Borrowed(&field.grid),
        network: Cow::Owned(pack_network(&field.network)),
    }
}

/// Copies tensors to a device.
///
/// # Errors
/// The same errors as [`Device::upload`].
pub fn upload(
    device: &Device,
    tensors: Tensors<Cow<'_, [f32]>>,
) -> muslin_device::Result<Tensors<Buffer<f32>>> {
    tensors.try_map(|name, values| device.upload(name, &values))
}

/// Replaces the Gaussians' tensors. Old and new tensors are never on the device together.
///
/// # Errors
/// The same errors as [`Device::upload`]. Some tensors are then empty.
pub fn replace_gaussians(
    device: &Device,
    tensors: &mut Tensors<Buffer<f32>>,
    gaussians: &Gaussians,
) -> muslin_device::Result<()> {
    for gaussians in [&Gaussians::default(), gaussians] {
        let values = gaussians.tensors();
        tensors.gaussians = values.try_map(|name, values| device.upload(name, values))?;
    }
    Ok(())
}

/// The host memory that a tensor is downloaded to.
enum Target<'a> {
    Values(&'a mut [f32]),
    Network(&'a mut Network),
}

fn field_targets(field: &mut Field) -> FieldTensors<Target<'_>> {
    FieldTensors {
        grid: Target::Values(&mut field.grid),
        network: Target::Network(&mut field.network),
    }
}

/// A scene of `gaussians` Gaussians. `read` fills in each tensor, in the kernels' layout.
///
/// # Errors
/// The same errors as [`Scene::zeros`]; any error of `read`.
pub fn unpack<T>(
    config: &SceneConfig,
    gaussians: usize,
    tensors: Tensors<T>,
    read: impl Fn(T, &mut [f32]) -> muslin_device::Result<()>,
) -> Result<Scene> {
    let mut scene = Scene::zeros(config.clone(), gaussians)?;
    let targets = Tensors {
        gaussians: scene.gaussians.tensors_mut().map(Target::Values),
        color: field_targets(&mut scene.color),
        transmittance: field_targets(&mut scene.transmittance),
    };
    targets.zip(tensors).try_map(|_, (target, tensor)| -> Result<()> {
        match target {
            Target::Values(target) => read(tensor, target)?,
            Target::Network(network) => {
                let mut values = vec![0.0; packed_len(network)];
                read(tensor, &mut values)?;
                unpack_network(&values, network);
            }
        }
        Ok(())
    })?;
    Ok(scene)
}
