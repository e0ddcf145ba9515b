//! One value for each tensor of a scene: a buffer, a gradient, an optimizer's moments, or a learning rate.

use std::convert::Infallible;

use super::gaussians::GaussianTensors;

/// One `T` for each tensor of a scene. All layers of a network are one tensor, as on a device.
///
/// The fields have the same names as those of [`Scene`](super::Scene).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tensors<T> {
    /// The Gaussians' values.
    pub gaussians: GaussianTensors<T>,
    /// The color field's values.
    pub color: FieldTensors<T>,
    /// The transmittance field's values.
    pub transmittance: FieldTensors<T>,
}

/// One `T` for each tensor of a field.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FieldTensors<T> {
    /// The hash grid's table, `[entries, features]`.
    pub grid: T,
    /// All parameters of the network.
    pub network: T,
}

impl<T> Tensors<T> {
    /// Borrows each value.
    pub fn as_ref(&self) -> Tensors<&T> {
        Tensors {
            gaussians: self.gaussians.as_ref(),
            color: self.color.as_ref(),
            transmittance: self.transmittance.as_ref(),
        }
    }

    /// Calls `f` with each tensor's name and value, always in the same order. The names are those in a scene file.
    /// The networks are `color.mlp` and `transmittance.mlp`.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<U, E>(
        self,
        mut f: impl FnMut(&'static str, T) -> Result<U, E>,
    ) -> Result<Tensors<U>, E> {
        Ok(Tensors {
            gaussians: self.gaussians.try_map(&mut f)?,
            color: self.color.try_map(["color.grid", "color.mlp"], &mut f)?,
            transmittance: self
                .transmittance
                .try_map(["transmittance.grid", "transmittance.mlp"], &mut f)?,
        })
    }

    /// Like [`Tensors::try_map`], for an `f` that cannot fail.
    pub fn map<U>(self, mut f: impl FnMut(&'static str, T) -> U) -> Tensors<U> {
        let Ok(mapped) = self.try_map(|name, value| Ok::<_, Infallible>(f(name, value)));
        mapped
    }

    /// Pairs each value with the other's value for the same tensor.
    pub fn zip<U>(self, other: Tensors<U>) -> Tensors<(T, U)> {
        Tensors {
            gaussians: self.gaussians.zip(other.gaussians),
            color: self.color.zip(other.color),
            transmittance: self.transmittance.zip(other.transmittance),
        }
    }

    /// Each tensor's name and value.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &T)> {
        self.as_ref().into_iter()
    }
}

impl<T> IntoIterator for Tensors<T> {
    type Item = (&'static str, T);
    type IntoIter = std::vec::IntoIter<Self::Item>;

    fn into_iter(self) -> Self::IntoIter {
        let mut list = Vec::new();
        self.map(|name, value| list.push((name, value)));
        list.into_iter()
    }
}

impl<T> FieldTensors<T> {
    /// Borrows each value.
    pub fn as_ref(&self) -> FieldTensors<&T> {
        FieldTensors { grid: &self.grid, network: &self.network }
    }

    /// Calls `f` with each tensor's name and value.
    ///
    /// # Errors
    /// The first error of `f`.
    pub fn try_map<U, E>(
        self,
        [grid, network]: [&'static str; 2],
        mut f: impl FnMut(&'static str, T) -> Result<U, E>,
    ) -> Result<FieldTensors<U>, E> {
        Ok(FieldTensors { grid: f(grid, self.grid)?, network: f(network, self.network)? })
    }

    /// Pairs each value with the other's value for the same tensor.
    pub fn zip<U>(self, other: FieldTensors<U>) -> FieldTensors<(T, U)> {
        FieldTensors { grid: (self.grid, other.grid), network: (self.network, other.network) }
    }
}
