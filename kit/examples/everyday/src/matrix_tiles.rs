//! The product of two matrices of halves.

use muslin_check::prelude::*;
use muslin_device::{Buffer, Device, Result};
use muslin_everyday_kernels::matrix_tiles::{
    ProductTiles8Inputs, ProductTiles8Kernel, ProductTiles16Inputs, ProductTiles16Kernel,
    TilesParams,
};

use crate::halves::{bits, exact_halves};

/// The sides of matrices are multiples of this: of all sides of tiles.
pub const SIDE: u32 = 16;

/// `left [rows, inner]` times `right [inner, columns]`, of halves, two in a word. All sides are multiples of [`SIDE`]. It takes the tiles that the device
/// has as cooperative matrices.
///
/// # Errors
/// Any error of the device.
pub fn product(
    device: &Device,
    params: TilesParams,
    left: &Buffer<u32>,
    right: &Buffer<u32>,
) -> Result<Buffer<f32>> {
    let output = device.unwritten("product", (params.rows * params.columns) as usize)?;
    match device.tiles().contains(&[16; 3]) {
        true => {
            device.run_all(&ProductTiles16Kernel { params, left, right, output: &output })?;
        }
        false => device.run_all(&ProductTiles8Kernel { params, left, right, output: &output })?,
    }
    Ok(output)
}

/// Words of pairs of numbers that are exact as halves; beside a last one stands 0.
#[must_use]
pub fn words(numbers: &[f32]) -> Vec<u32> {
    let word = |pair: &[f32]| bits(pair[0]) | pair.get(1).map_or(0, |second| bits(*second) << 16);
    numbers.chunks(2).map(word).collect()
}

/// The parity case of a kernel.
macro_rules! tiles {
    ($case:ident: $inputs:ident) => {
        case!(pub $case($inputs) {
            /// The numbers of the left matrix.
            left_numbers: Vec<f32>,
            /// The numbers of the right matrix.
            right_numbers: Vec<f32>,
        });

        impl Parity for $case {
            fn sets() -> Vec<(String, Self)> {
                let set = |[rows, inner, columns]: [u32; 3]| {
                    let mut random = Random::new((rows + inner + columns).into());
                    let mut numbers = |count: u32| exact_halves(count, &mut random);
                    let left_numbers = numbers(rows * inner);
                    let right_numbers = numbers(inner * columns);
                    let inputs = $inputs {
                        params: TilesParams { rows, inner, columns },
                        left: words(&left_numbers),
                        right: words(&right_numbers),
                        output: unwritten((rows * columns) as usize),
                    };
                    let name = format!("{rows} x {inner} times {inner} x {columns}");
                    (name, Self { inputs, left_numbers, right_numbers })
                };
                [[16, 16, 16], [32, 16, 48], [16, 128, 64], [144, 32, 16], [16, 0, 16]].map(set).into()
            }

            // sums of products that are exact: in any order, and twice rounded toward zero
            fn exact_at(&self, _: &str, index: usize) -> Option<Rounded> {
                let [inner, columns] = [self.params.inner, self.params.columns].map(|x| x as usize);
                let [row, column] = [index / columns, index % columns];
                let term = |k: usize| {
                    let a = self.left_numbers[row * inner + k];
                    let b = self.right_numbers[k * columns + column];
                    Rounded::exact(f64::from(a) * f64::from(b))
                };
                Some(Rounded::sum((0..inner).map(term)))
            }
        }
    };
}

tiles!(ProductTiles8: ProductTiles8Inputs);
tiles!(ProductTiles16: ProductTiles16Inputs);
