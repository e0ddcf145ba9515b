//! A scene on a device: its upload, and its layout there.

pub mod composition;
pub mod device_scene;
pub mod field;
pub mod network;
pub mod occupancy;
pub mod options;
pub mod packed;
pub mod upload;
