//! Measures the differences between a device's outputs and the CPU's.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::number::Rounded;

/// One output of a kernel.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Name, usually the binding's.
    pub name: &'static str,
    /// Its values. f64 represents every f32 and integer exactly, and sums of two.
    pub values: Vec<f64>,
    /// Whether they must be equal, as integers must be. Others may differ by rounding.
    pub is_exact: bool,
}

impl Output {
    /// An output that may differ by rounding.
    pub fn float(name: &'static str, values: impl IntoIterator<Item = impl Into<f64>>) -> Self {
        Self { name, values: values.into_iter().map(Into::into).collect(), is_exact: false }
    }

    /// An output of integers, which must be equal.
    pub fn exact(name: &'static str, values: impl IntoIterator<Item = impl Into<f64>>) -> Self {
        Self { is_exact: true, ..Self::float(name, values) }
    }

    /// The values of an output of `u32`.
    #[must_use]
    pub fn words(&self) -> Vec<u32> {
        self.values.iter().map(|&value| value as u32).collect()
    }
}

/// The largest difference of one kind, and its place.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Worst {
    /// The difference.
    pub value: f64,
    /// Name of the set of inputs.
    pub set: String,
    /// Name of the output.
    pub output: &'static str,
    /// Index of the element.
    pub index: usize,
    /// The CPU's value.
    pub cpu: f64,
    /// The device's value.
    pub found: f64,
}

/// The largest differences of a kernel on a device.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Measure {
    /// Largest absolute difference, among elements with terms below 1e9: for terms of 1e30 it would mean nothing.
    pub absolute: Worst,
    /// Largest difference as a fraction of the allowed error: above 1 it is a failure.
    pub share: Worst,
    /// Number of compared values.
    pub values: usize,
    /// Number of values that exceed the allowed error.
    pub failures: usize,
    /// For each output that is compared with the equations: the number of elements with a value in the equations, and
    /// the number that the kernel has written.
    #[serde(skip)]
    pub compared: BTreeMap<&'static str, [usize; 2]>,
}

impl Measure {
    /// Compares one output. `allowed` gives the error of each element that may differ.
    ///
    /// NaN never equals anything: no kernel may produce one.
    pub fn add(
        &mut self,
        set: &str,
        cpu: &Output,
        found: &Output,
        allowed: impl Fn(usize) -> Rounded,
    ) {
        let [expected, actual] = [cpu, found].map(|output| &output.values);
        assert_eq!(expected.len(), actual.len(), "lengths of `{}` differ", cpu.name);
        self.values += expected.len();
        for (index, (&cpu_value, &value)) in expected.iter().zip(actual).enumerate() {
            // equal infinities, too
            if cpu_value == value {
                continue;
            }
            let difference = nan_is_infinite((cpu_value - value).abs());
            let Rounded { error, terms, .. } =
                if cpu.is_exact { Rounded::exact(cpu_value) } else { allowed(index) };
            // an equation's number may be too large for an f32
            let is_beyond = cpu_value.is_finite() && cpu_value.abs() > f64::from(f32::MAX);
            if (error.is_infinite() || is_beyond && error > 0.0) && !value.is_nan() {
                continue;
            }
            let share = if error > 0.0 { difference / error } else { f64::INFINITY };
            let share = nan_is_infinite(share);
            self.failures += usize::from(share > 1.0);
            let worst = |size: f64| Worst {
                value: size,
                set: set.to_owned(),
                output: cpu.name,
                index,
                cpu: cpu_value,
                found: value,
            };
            raise(&mut self.share, share, worst);
            if terms < 1e9 {
                raise(&mut self.absolute, difference, worst);
            }
        }
    }

    /// Whether all values are within the allowed error.
    #[must_use]
    pub fn is_ok(&self) -> bool {
        self.failures == 0
    }
}

fn nan_is_infinite(value: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { value }
}

fn raise(largest: &mut Worst, value: f64, worst: impl Fn(f64) -> Worst) {
    if value > largest.value {
        *largest = worst(value);
    }
}

#[cfg(test)]
mod tests {
    use muslin_kernel::math::TINY;

    use super::*;

    fn measure(cpu: Output, found: Output, tolerance: f64) -> Measure {
        let mut measure = Measure::default();
        measure.add("set", &cpu, &found, |index| {
            let value = cpu.values[index];
            let size = value.abs().min(f32::MAX.into());
            Rounded::within(value, tolerance * size + f64::from(TINY))
        });
        measure
    }

    #[test]
    fn differences_are_found_where_they_are() {
        let cpu = Output::float("out", [1.0, 2.0, 0.0]);
        let found = Output::float("out", [1.0, 2.0 + 2.0 * f32::EPSILON, 1e-39]);
        let apart = measure(cpu, found, 1e-6);
        assert!(apart.is_ok(), "{apart:?}");
        assert_eq!(apart.absolute.index, 1);
        assert_eq!(apart.absolute.value, f64::from(2.0 * f32::EPSILON));
    }

    #[test]
    fn nan_and_infinity_are_no_rounding() {
        for (cpu, found, ok) in [
            (f32::NAN, f32::NAN, false),
            (1.0, f32::NAN, false),
            (f32::INFINITY, f32::INFINITY, true),
            (f32::INFINITY, f32::MAX, false),
            (f32::MAX, f32::INFINITY, false),
            (0.0, -0.0, true),
        ] {
            let apart = measure(Output::float("out", [cpu]), Output::float("out", [found]), 1e-3);
            assert_eq!(apart.is_ok(), ok, "{found} for {cpu}");
        }
    }

    #[test]
    fn integers_are_equal_or_wrong() {
        let apart = measure(Output::exact("n", [7, 8]), Output::exact("n", [7, 9]), 1.0);
        assert_eq!((apart.failures, apart.absolute.index), (1, 1));
        assert!(measure(Output::exact("n", [7]), Output::exact("n", [7]), 0.0).is_ok());
    }
}
