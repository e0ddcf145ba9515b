//! Everyday kernels, one subject a file. The files of the same names in `../src` run them.
#![no_std]

pub mod blur;
pub mod compact;
pub mod fft;
pub mod halves;
pub mod hash_table;
pub mod histogram;
pub mod k_means;
pub mod matrix;
pub mod matrix_tiles;
pub mod prefix_sum;
pub mod radix_sort;
pub mod random;
pub mod sum;
pub mod transpose;
