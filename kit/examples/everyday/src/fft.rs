//! The discrete Fourier transform.

use std::f64::consts::PI;

use glam::Vec2;
use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::fft::{FftParams, FftPassInputs, FftPassKernel};

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
        let params = FftParams { half: count / 2, done, sign };
        let next = device.unwritten("transforms", values.len())?;
        device.run_all(&FftPassKernel { params, input: &now, output: &next })?;
        now = next;
        done *= 2;
    }
    Ok(now)
}

case!(pub FftPass(FftPassInputs));

impl Parity for FftPass {
    fn sets() -> Vec<(String, Self)> {
        let set = |[half, done]: [u32; 2]| {
            let mut random = Random::new((half + done).into());
            let mut value = |_| Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            let inputs = FftPassInputs {
                params: FftParams { half, done, sign: -1.0 },
                input: (0..2 * half).map(&mut value).collect(),
                output: unwritten(2 * half as usize),
            };
            (format!("{done} of {}", 2 * half), Self(inputs))
        };
        [[1, 1], [4, 2], [64, 64], [512, 1], [512, 32]].map(set).into()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let FftParams { half, done, sign } = self.params;
        let mut all = vec![None; 4 * half as usize];
        for index in 0..half {
            let k = index % done;
            let angle = f64::from(sign) * PI * f64::from(k) / f64::from(done);
            // `math::sin` and `cos`, of a product and a quotient
            let [cos, sin] = [angle.cos(), angle.sin()].map(|x| Rounded::within(x, 1e-6));
            let read = |at: u32| {
                let value = self.input[at as usize];
                [value.x, value.y].map(Rounded::from)
            };
            let [a, b] = [read(index), read(index + half)];
            let b = [b[0] * cos - b[1] * sin, b[0] * sin + b[1] * cos];
            let to = ((index - k) * 2 + k) as usize;
            for axis in 0..2 {
                all[2 * to + axis] = Some(a[axis] + b[axis]);
                all[2 * (to + done as usize) + axis] = Some(a[axis] - b[axis]);
            }
        }
        all
    }
}
