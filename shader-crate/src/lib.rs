//! The kernels of organza, one file per stage. Each kernel is an ordinary function in the language of [`muslin`].
//!
//! The pipeline, in order: [`project`], [`tile`], [`pair`], [`scan`], [`occupancy`], [`segment`], [`steps`], [`transmittance`], [`color`] (both with
//! [`hash_grid`] and [`dense`]), [`splat`], [`slope`], [`shape`], [`tile_cells`], [`composite`], [`resolve`], [`pixels`]. Gradients run the other way, in the same
//! files or those named `_backward`; [`loss`], [`ssim`], [`exposure`] and [`adam`] are for training.
//! `docs/architecture.md` has the map. `docs/pipeline.md` has the equations, in sections A, B1, B2, B3 and C, which a file names first.
//!
//! In the description of a kernel, `name [rows, columns]` is a buffer and its shape.
//!
//! Rust-GPU compiles this crate to SPIR-V. The host compiles it too, to run kernels on the CPU and to dispatch them.
#![no_std]
// the shader compiler cannot compile what clippy suggests instead
#![allow(clippy::implicit_saturating_sub, clippy::manual_range_contains, clippy::manual_clamp)]

pub mod adam;
pub mod binned;
pub mod camera;
pub mod channels;
pub mod color;
pub mod color_backward;
pub mod composite;
pub mod composite_backward;
pub mod count;
pub mod dense;
pub mod dense_backward;
pub mod dense_weight_backward;
pub mod exposure;
pub mod hash_grid;
pub mod hash_grid_backward;
pub mod hash_grid_half;
pub mod hash_grid_scale;
pub mod limits;
pub mod loss;
pub mod occupancy;
pub mod pair;
pub mod pinhole;
pub mod pixels;
pub mod pose_backward;
pub mod project;
pub mod project_backward;
pub mod resolve;
pub mod scan;
pub mod segment;
pub mod shape;
pub mod slope;
pub mod spherical_harmonics;
pub mod splat;
pub mod ssim;
pub mod statistics;
pub mod steps;
pub mod target;
pub mod tile;
pub mod tile_cells;
pub mod transmittance;
pub mod transmittance_backward;
pub mod unit_cube;
pub mod weight_slice;
pub mod weight_tile;
