#![doc = include_str!("../README.md")]
#![no_std]

pub use muslin_kernel::*;

/// Compiles kernels for GPUs: the tasks of a project's xtask. With the feature `build`.
#[cfg(feature = "build")]
pub use muslin_build as build;
/// Tests of kernels: parity between devices, and snapshots. With the feature `check`.
#[cfg(feature = "check")]
pub use muslin_check as check;
/// Devices, which run kernels. With the feature `device`.
#[cfg(feature = "device")]
pub use muslin_device as device;
