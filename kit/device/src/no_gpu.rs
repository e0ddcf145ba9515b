//! Stands in for the GPU backend where the feature `gpu` is off: there is no GPU.

use std::time::Duration;

use muslin_kernel::{EntryPoint, KernelInfo};

use crate::buffer::{Count, GpuBuffer, RawBuffer};
use crate::{AdapterInfo, DeviceOptions, Error, Modules, Result, Traffic};

/// Every GPU that the system offers: none, because the feature `gpu` is off.
#[must_use]
pub fn adapters() -> Vec<AdapterInfo> {
    Vec::new()
}

#[derive(Debug)]
pub enum Gpu {}

#[derive(Debug)]
pub struct Reading;

impl Gpu {
    pub fn open(_: &DeviceOptions, _: &'static Modules) -> Result<Self> {
        Err(Error::NoGpu { reason: "muslin-device is compiled without its feature `gpu`".into() })
    }
}

/// Stubs: without the feature `gpu`, no value of these types exists.
macro_rules! methods {
    ($($name:ident($($argument:ty),*) -> $result:ty;)*) => {
        impl Gpu {$(
            pub fn $name(&self, $(_: $argument),*) -> $result {
                match *self {}
            }
        )*}
    };
}

methods! {
    name() -> &str;
    description() -> String;
    driver() -> String;
    entry_point(&KernelInfo) -> EntryPoint;
    tiles() -> &[[u32; 3]];
    is_software() -> bool;
    max_buffer_bytes() -> u64;
    memory_bytes() -> Option<u64>;
    allocate(&'static str, u64, bool) -> Result<GpuBuffer>;
    write(&GpuBuffer, &[u8]) -> ();
    read(&[(&RawBuffer, u64, usize)], impl FnMut(&[u8]) -> Result<()>) -> Result<()>;
    read_later(&[(&RawBuffer, u64, usize)]) -> Reading;
    finish_reading(Reading, impl FnMut(&[u8]) -> Result<()>) -> Result<()>;
    dispatch(&'static KernelInfo, &[u8], &[(usize, &Count)], &[&RawBuffer], [u32; 3]) -> Result<()>;
    clear(&RawBuffer) -> ();
    copy(&RawBuffer, &RawBuffer, u64) -> ();
    publish_counts() -> ();
    submit() -> ();
    wait() -> Result<()>;
    time_dispatches(bool) -> bool;
    take_times() -> Vec<(&'static str, Duration)>;
    traffic() -> Traffic;
    lose() -> ();
}
