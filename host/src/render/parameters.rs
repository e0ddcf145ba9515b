//! A scene's tensors as plain numbers on the device: what an optimizer moves, and the way back to the host.

use glam::Vec4;

use super::DeviceScene;
use super::field::DeviceField;
use super::gradient::{FieldGradient, SceneGradient};
use crate::error::Result;
use crate::scene::{Field, Network, Scene, SceneConfig};
use organza_device::{Buffer, Device};

/// A group of parameters that share a learning rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// `[N, 3]`
    Position,
    /// `[N, 4]`
    Rotation,
    /// `[N, 3]`
    LogScale,
    /// `[N]`
    Opacity,
    /// `[N, M]`
    Material,
    /// `[N, U]`
    Extra,
    /// `[entries, features]`
    ColorGrid,
    /// All layers, as kernels read them.
    ColorNetwork,
    /// `[entries, features]`
    TransmittanceGrid,
    /// All layers, as kernels read them.
    TransmittanceNetwork,
}

impl DeviceScene {
    /// Every group with its values; writing to them changes the scene.
    #[must_use]
    pub fn parameters(&self) -> [(Parameter, Buffer<f32>); 10] {
        use Parameter as P;
        [
            (P::Position, self.position.view()),
            (P::Rotation, self.rotation.view()),
            (P::LogScale, self.log_scale.view()),
            (P::Opacity, self.opacity.view()),
            (P::Material, self.material.view()),
            (P::Extra, self.extra.view()),
            (P::ColorGrid, self.color.table.view()),
            (P::ColorNetwork, self.color.parameters.view()),
            (P::TransmittanceGrid, self.transmittance.table.view()),
            (P::TransmittanceNetwork, self.transmittance.parameters.view()),
        ]
    }

    /// Half the longest side of the scene's box, in world units.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let [low, high] = self.config.aabb;
        (0..3).map(|axis| (high[axis] - low[axis]) / 2.0).fold(0.0, f64::max)
    }

    /// The scene as it is now.
    ///
    /// # Errors
    /// As [`Device::read`]; [`Error::Argument`](crate::Error::Argument) where the grids are halves.
    pub fn download(&self, device: &Device) -> Result<Scene> {
        self.require_full_grids()?;
        let mut scene = Scene::zeros(self.config.clone(), self.len())?;
        let gaussians = &mut scene.gaussians;
        let copy = |target: &mut [f32], source: &Buffer<f32>| -> Result<()> {
            target.copy_from_slice(&device.read(source)?);
            Ok(())
        };
        copy(gaussians.position.as_flattened_mut(), &self.position)?;
        copy(gaussians.rotation.as_flattened_mut(), &self.rotation)?;
        copy(gaussians.log_scale.as_flattened_mut(), &self.log_scale)?;
        copy(&mut gaussians.opacity, &self.opacity)?;
        copy(&mut gaussians.material, &self.material)?;
        copy(&mut gaussians.extra, &self.extra)?;
        self.color.download(device, &mut scene.color)?;
        self.transmittance.download(device, &mut scene.transmittance)?;
        Ok(scene)
    }
}

impl DeviceField {
    fn download(&self, device: &Device, field: &mut Field) -> Result<()> {
        field.grid.copy_from_slice(&device.read(&self.table)?);
        unpack_network(&device.read(&self.parameters)?, &mut field.network);
        Ok(())
    }
}

impl SceneGradient {
    /// A group's gradient, where it begins in its buffer, and the flags of blocks that are not zero, where it has them.
    #[must_use]
    pub(crate) fn of(
        &self,
        parameter: Parameter,
        gaussians: usize,
    ) -> (Buffer<f32>, usize, Option<&Buffer<u32>>) {
        use Parameter as P;
        let geometry = |first: usize| (self.gaussians.view(), first * gaussians, None);
        match parameter {
            P::Position => geometry(0),
            P::Rotation => geometry(3),
            P::LogScale => geometry(7),
            P::Opacity => geometry(10),
            P::Material => (self.material.view(), 0, None),
            P::Extra => (self.extra.view(), 0, None),
            P::ColorGrid => (self.color.table.gradient.view(), 0, Some(&self.color.table.touched)),
            P::ColorNetwork => (self.color.parameters.view(), 0, None),
            P::TransmittanceGrid => {
                let table = &self.transmittance.table;
                (table.gradient.view(), 0, Some(&table.touched))
            }
            P::TransmittanceNetwork => (self.transmittance.parameters.view(), 0, None),
        }
    }

    /// The gradient as a scene: each tensor is dLoss/dtensor.
    ///
    /// # Errors
    /// As [`Device::read`].
    pub fn download(&self, device: &Device, config: &SceneConfig, len: usize) -> Result<Scene> {
        let mut scene = Scene::zeros(config.clone(), len)?;
        let gaussians = &mut scene.gaussians;
        let geometry = device.read(&self.gaussians)?;
        let (position, rest) = geometry.split_at(3 * len);
        let (rotation, rest) = rest.split_at(4 * len);
        let (log_scale, opacity) = rest.split_at(3 * len);
        gaussians.position.as_flattened_mut().copy_from_slice(position);
        gaussians.rotation.as_flattened_mut().copy_from_slice(rotation);
        gaussians.log_scale.as_flattened_mut().copy_from_slice(log_scale);
        gaussians.opacity.copy_from_slice(opacity);
        gaussians.material.copy_from_slice(&device.read(&self.material)?);
        gaussians.extra.copy_from_slice(&device.read(&self.extra)?);
        self.color.download(device, &mut scene.color)?;
        self.transmittance.download(device, &mut scene.transmittance)?;
        Ok(scene)
    }
}

impl FieldGradient {
    fn download(&self, device: &Device, field: &mut Field) -> Result<()> {
        field.grid.copy_from_slice(&device.read(&self.table.gradient)?);
        unpack_network(&device.read(&self.parameters)?, &mut field.network);
        Ok(())
    }
}

/// The inverse of [`super::field::pack_network`]: what pads the columns is left out.
pub fn unpack_network(parameters: &[Vec4], network: &mut Network) {
    let (_, layers) = super::field::pack_network(network);
    for (layer, place) in network.layers.iter_mut().zip(layers) {
        let columns = place.columns as usize;
        for output in 0..layer.outputs {
            let (column, row) = (output / 4, output % 4);
            for input in 0..layer.inputs {
                layer.weight[output * layer.inputs + input] =
                    parameters[place.weight as usize + input * columns + column][row];
            }
            layer.bias[output] = parameters[place.bias as usize + column][row];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Layer;

    #[test]
    fn a_network_is_unpacked_as_it_was_packed() {
        let layer = |inputs: usize, outputs: usize| Layer {
            weight: (0..inputs * outputs).map(|i| 1.0 + i as f32).collect(),
            bias: (0..outputs).map(|i| -1.0 - i as f32).collect(),
            inputs,
            outputs,
        };
        let network = Network { layers: vec![layer(2, 5), layer(5, 3)] };
        let (packed, _) = super::super::field::pack_network(&network);
        let mut found = Network::zeros(&network.widths());
        unpack_network(&packed, &mut found);
        assert_eq!(found, network);
    }
}
