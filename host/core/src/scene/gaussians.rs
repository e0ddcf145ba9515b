//! The table of per-Gaussian tensors, and everything generated from it.

use super::config::SceneConfig;
use super::tensor_spec::TensorSpec;
use crate::error::Result;
use muslin_error::memory;

/// Calls the macro `$with` with the table of per-Gaussian tensors: one line per tensor.
///
/// A line has the tensor's name, the shape of one Gaussian's row, and the reason for this shape, for error messages.
/// A row is `[]` for one number, `[3]` for three, and `[field]` if a field of [`SceneConfig`] gives the length.
///
/// The name appears as a field of [`Gaussians`], as the tensor `gaussians.name` of a scene file, and as the learning
/// rate `optimizer.name` of a training run. The two numbers are the default rate of the first and of the last step.
#[macro_export]
macro_rules! gaussian_tensors {
    ($with:ident) => {
        $with! {
            /// Centers in world space.
            position: [3], "x, y, z of each Gaussian", [2e-3, 1e-4];
            /// Quaternions w x y z, not normalized.
            rotation: [4], "a quaternion w, x, y, z for each Gaussian of gaussians.position", [4e-3, 4e-3];
            /// Natural logarithms of the scales along the rotated axes, in world units.
            log_scale: [3], "three scales for each Gaussian of gaussians.position", [2e-2, 2e-2];
            /// Opacity logits.
            opacity: [], "one logit for each Gaussian of gaussians.position", [1e-1, 1e-1];
            /// Material vectors, `[N, material]`, row-major.
            material: [material], "config field `material` values for each Gaussian", [2e-2, 2e-2];
            /// Extra vectors, `[N, extra]`, row-major.
            extra: [extra], "config field `extra` values for each Gaussian", [2e-2, 2e-2];
            /// How much colors grow per standard deviation, `[N, slope]`: red, green and blue along each axis.
            slope: [slope], "config field `slope` values for each Gaussian", [5e-3, 5e-3];
            /// How flat falloffs are, `[N, shape]`: 0 for a Gaussian's, more for a disc's.
            shape: [shape], "config field `shape` values for each Gaussian", [4e-2, 4e-2];
        }
    };
}

/// The type of a vector's elements on the host.
macro_rules! element {
    ([$width:literal]) => {
        [f32; $width]
    };
    ($other:tt) => {
        f32
    };
}

/// The elements of a vector on the host.
macro_rules! elements {
    ($config:expr, $gaussians:expr, [$field:ident]) => {
        $gaussians * $config.$field as usize
    };
    ($config:expr, $gaussians:expr, $other:tt) => {
        $gaussians
    };
}

/// The shape of a tensor.
macro_rules! shape {
    ($config:expr, $gaussians:expr, []) => {
        vec![$gaussians]
    };
    ($config:expr, $gaussians:expr, [$width:literal]) => {
        vec![$gaussians, $width]
    };
    ($config:expr, $gaussians:expr, [$field:ident]) => {
        vec![$gaussians, $config.$field as usize]
    };
}

/// The field of the configuration that gives a row's length, and its value.
macro_rules! length {
    ($config:expr, [$field:ident]) => {
        Some((stringify!($field), $config.$field))
    };
    ($config:expr, $other:tt) => {
        None
    };
}

macro_rules! define {
    ($($(#[$doc:meta])* $name:ident: $row:tt, $why:literal, $rate:tt;)+) => {
        /// N Gaussians, with one vector per tensor.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Gaussians {
            $($(#[$doc])* pub $name: Vec<element!($row)>,)+
        }

        /// One `T` for each tensor of the Gaussians.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct GaussianTensors<T> {
            $($(#[$doc])* pub $name: T,)+
        }

        impl Gaussians {
            /// `len` Gaussians, with every value 0.
            pub fn zeros(config: &SceneConfig, len: usize) -> Result<Self> {
                Ok(Self {
                    $($name: memory::zeros(elements!(config, len, $row), file_name!($name))?,)+
                })
            }

            /// The values of each tensor, row-major.
            pub fn tensors(&self) -> GaussianTensors<&[f32]> {
                GaussianTensors { $($name: bytemuck::cast_slice(&self.$name),)+ }
            }

            /// The values of each tensor for writing, row-major.
            pub fn tensors_mut(&mut self) -> GaussianTensors<&mut [f32]> {
                GaussianTensors { $($name: bytemuck::cast_slice_mut(&mut self.$name),)+ }
            }

            /// Appends other Gaussians. Their vectors must have the same lengths.
            pub fn append(&mut self, other: &Self) {
                $(self.$name.extend_from_slice(&other.$name);)+
            }

            /// The Gaussians with these indices, in this order. An index can occur more than once.
            ///
            /// # Panics
            /// If an index is N or more.
            #[must_use]
            pub fn select(&self, indices: &[usize]) -> Self {
                let len = self.len();
                Self { $($name: select(&self.$name, len, indices),)+ }
            }
        }

        impl SceneConfig {
            /// The name and shape of each tensor of N Gaussians.
            pub(super) fn gaussian_specs(&self, gaussians: usize) -> GaussianTensors<TensorSpec> {
                GaussianTensors {
                    $($name: TensorSpec {
                        name: file_name!($name).to_owned(),
                        shape: shape!(self, gaussians, $row),
                        why: $why,
                    },)+
                }
            }

            /// Each field that gives the length of a Gaussian's vector, and its value.
            pub(super) fn vector_lengths(&self) -> impl Iterator<Item = (&'static str, u32)> {
                [$(length!(self, $row)),+].into_iter().flatten()
            }
        }

        impl<T> GaussianTensors<T> {
            /// Borrows each value.
            pub fn as_ref(&self) -> GaussianTensors<&T> {
                GaussianTensors { $($name: &self.$name,)+ }
            }

            /// Calls `f` with each value, in the table's order.
            pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> GaussianTensors<U> {
                GaussianTensors { $($name: f(self.$name),)+ }
            }

            /// Calls `f` with each tensor's name and value, in the table's order.
            ///
            /// # Errors
            /// The first error of `f`.
            pub fn try_map<U, E>(
                self,
                mut f: impl FnMut(&'static str, T) -> Result<U, E>,
            ) -> Result<GaussianTensors<U>, E> {
                Ok(GaussianTensors { $($name: f(file_name!($name), self.$name)?,)+ })
            }

            /// Pairs each value with the other's value for the same tensor.
            pub fn zip<U>(self, other: GaussianTensors<U>) -> GaussianTensors<(T, U)> {
                GaussianTensors { $($name: (self.$name, other.$name),)+ }
            }

            /// All values, in the table's order.
            pub fn into_vec(self) -> Vec<T> {
                vec![$(self.$name),+]
            }
        }
    };
}

/// A tensor's name in a scene file.
macro_rules! file_name {
    ($name:ident) => {
        concat!("gaussians.", stringify!($name))
    };
}

gaussian_tensors!(define);

impl Gaussians {
    /// N, the number of Gaussians.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}

/// The rows with these indices, from `values` with `len` rows.
fn select<E: Copy>(values: &[E], len: usize, indices: &[usize]) -> Vec<E> {
    let width = values.len() / len.max(1);
    indices.iter().flat_map(|&index| &values[index * width..][..width]).copied().collect()
}

/// Bits of a coordinate in a place on the curve.
const CURVE_BITS: u32 = 21;

/// Indices of positions along a Morton curve through their box: what is near in space is mostly near in the list.
#[must_use]
pub fn along_a_curve(positions: &[[f32; 3]]) -> Vec<usize> {
    let all = [f64::INFINITY, f64::NEG_INFINITY];
    let ranges = [0, 1, 2].map(|axis| {
        let values = positions.iter().map(|position| f64::from(position[axis]));
        values.fold(all, |[low, high], value| [low.min(value), high.max(value)])
    });
    let cell = |value: f32, [low, high]: [f64; 2]| {
        let max = f64::from((1 << CURVE_BITS) - 1);
        // NaN in a box without a width becomes 0
        ((f64::from(value) - low) / (high - low) * max).round() as u64
    };
    let key = |position: &[f32; 3]| -> u64 {
        let cells = [0, 1, 2].map(|axis| cell(position[axis], ranges[axis]));
        (0..3 * CURVE_BITS).map(|bit| (cells[bit as usize % 3] >> (bit / 3) & 1) << bit).sum()
    };
    let mut order: Vec<_> = (0..positions.len()).collect();
    order.sort_by_cached_key(|&index| key(&positions[index]));
    order
}

/// The logit of an opacity between 0 and 1, both excluded.
pub fn logit(opacity: f32) -> f32 {
    (opacity / (1.0 - opacity)).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn octants_follow_one_another() {
        // the octants in the reverse of the curve's order: x has the lowest bit
        let octant = |index: usize| [0, 1, 2].map(|axis| ((7 - index) >> axis & 1) as f32);
        let octants: Vec<_> = (0..8).map(octant).collect();
        assert_eq!(along_a_curve(&octants), [7, 6, 5, 4, 3, 2, 1, 0]);
        // a box without a width keeps the order
        assert_eq!(along_a_curve(&[[0.5; 3]; 3]), [0, 1, 2]);
    }

    #[test]
    fn rows_are_selected_from_every_tensor() {
        let config = crate::demo::config();
        let mut gaussians = Gaussians::zeros(&config, 3).unwrap();
        for values in gaussians.tensors_mut().into_vec() {
            values.iter_mut().zip(0..).for_each(|(value, i)| *value = i as f32);
        }
        let selected = gaussians.select(&[2, 0, 2, 1]);
        assert_eq!((selected.len(), selected.position[0]), (4, [6.0, 7.0, 8.0]));
        for (from, to) in gaussians.tensors().zip(selected.tensors()).into_vec() {
            let width = from.len() / 3;
            let expected = [2, 0, 2, 1].map(|i| &from[i * width..][..width]);
            assert_eq!(to, expected.concat());
        }
        assert!(gaussians.select(&[]).is_empty());
    }
}
