//! A scene on a device: how it gets there, and how it lies there.

pub mod device_scene;
pub mod field;
pub mod network;
pub mod occupancy;
pub mod options;
pub mod packed;
pub mod upload;
