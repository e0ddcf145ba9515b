//! Measures a device's peak computation and memory bandwidth.

use muslin_device::{Device, Result};
use muslin_kernel::peak::{
    MAX_PEAK_STEPS, PeakMultiplyAddKernel, PeakMultiplyAddParams, PeakReadKernel, PeakReadParams,
    READS,
};

/// The peak performance of a device, using all its threads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peaks {
    /// Billions of floating-point operations per second, from multiply-adds on registers.
    pub gflops: f64,
    /// Billions of bytes per second, from reading memory that no cache holds from end to end.
    pub gbs: f64,
}

/// Number of dispatches, of which the fastest counts.
const RUNS: usize = 12;
/// Target time of a dispatch, in seconds: long compared with the cost of starting it.
const SECONDS: f64 = 0.01;
/// Steps of an invocation of `peak_multiply_add`.
const STEPS: u32 = 512;
/// Invocations of its first dispatch, and the largest number.
const INVOCATIONS: [u32; 2] = [1 << 14, 1 << 22];
/// Bytes to read, if a buffer may be as large: caches are smaller.
const BYTES: u64 = 1 << 28;
/// Steps of an invocation of `peak_read`: a workgroup's 16 KiB stay in the innermost cache of a CPU.
const READ_STEPS: u32 = 16;
/// Invocations of a workgroup of `peak_read`.
const WORKGROUP: u32 = 64;

const _: () = assert!(STEPS <= MAX_PEAK_STEPS && READ_STEPS <= MAX_PEAK_STEPS);

impl Peaks {
    /// Measures a device, in about half a second.
    ///
    /// # Errors
    /// The same errors as [`Device::zeros`] and [`Device::dispatch`].
    pub fn measure(device: &Device) -> Result<Self> {
        device.time_dispatches(true);
        let peaks =
            multiply_add(device).and_then(|gflops| read(device).map(|gbs| Self { gflops, gbs }));
        device.time_dispatches(false);
        peaks
    }
}

/// Returns seconds, operations and bytes of a dispatch.
fn time(device: &Device, dispatch: &dyn Fn() -> Result<()>) -> Result<[f64; 3]> {
    let _ = device.take_timings();
    dispatch()?;
    let mut sums = [0.0; 3];
    for time in device.take_timings() {
        let found = [time.seconds, time.work.flops as f64, time.work.bytes as f64];
        sums = std::array::from_fn(|index| sums[index] + found[index]);
    }
    // a GPU may count in microseconds
    sums[0] = sums[0].max(1e-6);
    Ok(sums)
}

fn multiply_add(device: &Device) -> Result<f64> {
    let [mut count, most] = INVOCATIONS;
    let output = device.zeros("peak", most as usize)?;
    let run = |count: u32| {
        let params = PeakMultiplyAddParams { count, steps: STEPS, factor: 0.5, addend: 1.0 };
        let kernel = PeakMultiplyAddKernel { params, output: &output };
        time(device, &|| device.run(&kernel, count, 1))
    };
    // the first one may wake the device up
    run(count)?;
    let [seconds, ..] = run(count)?;
    let wanted = f64::from(count) * (SECONDS / seconds).max(1.0);
    count = (wanted.min(f64::from(most)) as u32).next_multiple_of(WORKGROUP).min(most);
    let mut best: f64 = 0.0;
    for _ in 0..RUNS {
        let [seconds, flops, _] = run(count)?;
        best = best.max(flops / seconds);
    }
    Ok(best / 1e9)
}

fn read(device: &Device) -> Result<f64> {
    let workgroup = u64::from(READ_STEPS * READS * WORKGROUP);
    let of_workgroup = workgroup * size_of::<f32>() as u64;
    let workgroups = BYTES.min(device.max_buffer_bytes()) / of_workgroup;
    let count = workgroups as u32 * WORKGROUP;
    let values = device.zeros::<f32>("peak", (workgroups * workgroup) as usize)?;
    // the system may not provide memory before it is written
    device.clear(&values);
    let output = device.zeros("peak", count as usize)?;
    let kernel = PeakReadKernel {
        params: PeakReadParams { count, steps: READ_STEPS },
        values: &values,
        output: &output,
    };
    let mut best: f64 = 0.0;
    for _ in 0..RUNS {
        let [seconds, _, bytes] = time(device, &|| device.run(&kernel, count, 1))?;
        best = best.max(bytes / seconds);
    }
    Ok(best / 1e9)
}
