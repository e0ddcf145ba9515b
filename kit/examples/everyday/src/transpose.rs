//! The transpose of a matrix.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::transpose::{TransposeInputs, TransposeKernel, TransposeParams};

/// `[columns, rows]` of `input [rows, columns]`.
///
/// # Errors
/// Any error of the device.
pub fn transpose(
    device: &Device,
    params: TransposeParams,
    input: &Buffer<u32>,
) -> Result<Buffer<u32>> {
    let output = device.unwritten("transpose", input.len())?;
    device.run_all(&TransposeKernel { params, input, output: &output })?;
    Ok(output)
}

case!(pub Transpose(TransposeInputs));

impl Parity for Transpose {
    fn sets() -> Vec<(String, Self)> {
        let set = |[rows, columns]: [u32; 2]| {
            let mut random = Random::new((100 * rows + columns).into());
            let input: Vec<_> = (0..rows * columns).map(|_| random.bits()).collect();
            let output = unwritten(input.len());
            let params = TransposeParams { rows, columns };
            (format!("{rows} x {columns}"), Self(TransposeInputs { params, input, output }))
        };
        [[1, 1], [16, 16], [17, 3], [1, 100], [33, 47]].map(set).into()
    }

    fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
        let [rows, columns] = [self.params.rows, self.params.columns].map(|x| x as usize);
        Some(self.input[index % rows * columns + index / rows].into())
    }
}
