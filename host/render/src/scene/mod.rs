//! A scene on a device: how it gets there, how it lies there, and the shard of it that one rank has.

pub mod device_scene;
pub mod device_shard;
pub mod field;
pub mod network;
pub mod options;
pub mod packed;
pub mod upload;
