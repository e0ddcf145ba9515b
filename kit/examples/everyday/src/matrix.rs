//! The product of two matrices.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::matrix::{ProductInputs, ProductKernel, ProductParams};

/// `left [rows, inner]` times `right [inner, columns]`.
///
/// # Errors
/// Any error of the device.
pub fn product(
    device: &Device,
    params: ProductParams,
    left: &Buffer<f32>,
    right: &Buffer<f32>,
) -> Result<Buffer<f32>> {
    let output = device.unwritten("product", (params.rows * params.columns) as usize)?;
    device.run_all(&ProductKernel { params, left, right, output: &output })?;
    Ok(output)
}

case!(pub Product(ProductInputs));

impl Parity for Product {
    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, inner, columns]: [u32; 3]| {
            let mut random = Random::new((rows + inner + columns).into());
            let mut values = |count: u32| random.values(count as usize, -1.0, 1.0);
            let inputs = ProductInputs {
                params: ProductParams { rows, inner, columns },
                left: values(rows * inner),
                right: values(inner * columns),
                output: unwritten((rows * columns) as usize),
            };
            (format!("{rows} x {inner} times {inner} x {columns}"), Self(inputs))
        };
        [[1, 1, 1], [17, 17, 17], [16, 32, 48], [3, 100, 5], [64, 1, 33], [2, 0, 2]].map(set).into()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [inner, columns] = [self.params.inner, self.params.columns].map(|x| x as usize);
        let [row, column] = [index / columns, index % columns];
        let term = |k: usize| {
            let a = Rounded::from(self.left[row * inner + k]);
            a * Rounded::from(self.right[k * columns + column])
        };
        Some(Rounded::sum((0..inner).map(term)))
    }
}
