//! The discrete Fourier transform.

use std::f64::consts::PI;

use glam::Vec2;
use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::fft::{
    FftParams, FftPass4Inputs, FftPass4Kernel, FftPassInputs, FftPassKernel,
};

/// The transform of complex numbers, whose number is a power of two; with a `sign` of 1 in place of -1, the inverse without its factor.
///
/// # Errors
/// Any error of the device.
///
/// # Panics
/// If the number is no power of two.
pub fn fft(device: &Device, values: &Buffer<Vec2>, sign: f32) -> Result<Buffer<Vec2>> {
    let count = values.len() as u32;
    assert!(count.is_power_of_two(), "{count} values are no power of two");
    let mut now = values.clone();
    let mut done = 1;
    while done < count {
        let radix = if count / done >= 4 { 4 } else { 2 };
        let params = FftParams { part: count / radix, done, sign };
        let next = device.unwritten("transforms", values.len())?;
        match radix {
            4 => device.run_all(&FftPass4Kernel { params, input: &now, output: &next })?,
            _ => device.run_all(&FftPassKernel { params, input: &now, output: &next })?,
        }
        now = next;
        done *= radix;
    }
    Ok(now)
}

case!(pub FftPass(FftPassInputs));
case!(pub FftPass4(FftPass4Inputs));

/// What a pass of this radix binds.
type Bound = (FftParams, Vec<Vec2>, Vec<Vec2>);

/// Named sets of the passes of a radix.
fn sets<T>(radix: u32, new: impl Fn(Bound) -> T) -> Vec<(String, T)> {
    let set = |[part, done]: [u32; 2]| {
        let mut random = Random::new((part + done).into());
        let mut value = |_| Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let count = radix * part;
        let params = FftParams { part, done, sign: -1.0 };
        let input = (0..count).map(&mut value).collect();
        (format!("{done} of {count}"), new((params, input, unwritten(count as usize))))
    };
    [[1, 1], [4, 2], [64, 64], [512, 1], [512, 32]].map(set).into()
}

/// Transforms of `radix` times the length: the sums of the definition.
fn joined(radix: u32, params: FftParams, input: &[Vec2]) -> Vec<Option<Rounded>> {
    let FftParams { part, done, sign } = params;
    let error = 1e-6 * f64::from(radix - 1);
    let mut all = vec![None; 2 * input.len()];
    for index in 0..part {
        let k = index % done;
        for output in 0..radix {
            let mut sum = [Rounded::from(0.0_f64); 2];
            for term in 0..radix {
                // the turns of the values, which the kernel takes from `math::sin` and `cos`, and of their own transform
                let turns = f64::from(term * (k + output * done)) / f64::from(radix * done);
                let angle = 2.0 * PI * f64::from(sign) * turns;
                let [cos, sin] = [angle.cos(), angle.sin()].map(|x| Rounded::within(x, error));
                let value = input[(index + term * part) as usize];
                let [x, y] = [value.x, value.y].map(Rounded::from);
                sum = [sum[0] + x * cos - y * sin, sum[1] + x * sin + y * cos];
            }
            let to = ((index - k) * radix + k + output * done) as usize;
            [all[2 * to], all[2 * to + 1]] = sum.map(Some);
        }
    }
    all
}

impl Parity for FftPass {
    fn sets() -> Vec<(String, Self)> {
        sets(2, |(params, input, output)| Self(FftPassInputs { params, input, output }))
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        joined(2, self.params, &self.input)
    }
}

impl Parity for FftPass4 {
    fn sets() -> Vec<(String, Self)> {
        sets(4, |(params, input, output)| Self(FftPass4Inputs { params, input, output }))
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        joined(4, self.params, &self.input)
    }
}
