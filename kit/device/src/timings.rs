//! The time that kernels took, and their work: operations and bytes.

use std::collections::BTreeMap;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use muslin_kernel::work::Work;

/// The total cost of a kernel's dispatches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KernelTime {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// Number of dispatches.
    pub dispatches: u64,
    /// Time of all dispatches, in seconds.
    pub seconds: f64,
    /// Operations and bytes of all dispatches, if they were counted.
    pub work: Work,
}

/// Sums over dispatches.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    dispatches: u64,
    time: Duration,
    work: Work,
}

/// Sums over the dispatches of each kernel.
#[derive(Debug, Default)]
pub struct Timings(Mutex<BTreeMap<&'static str, Sums>>);

impl Timings {
    fn sums(&self) -> MutexGuard<'_, BTreeMap<&'static str, Sums>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Adds a dispatch.
    pub fn add(&self, kernel: &'static str, time: Duration, work: Work) {
        let mut sums = self.sums();
        let sums = sums.entry(kernel).or_default();
        sums.dispatches += 1;
        sums.time += time;
        sums.work += work;
    }

    /// Adds the time of a dispatch that was counted before.
    pub fn add_time(&self, kernel: &'static str, time: Duration) {
        self.sums().entry(kernel).or_default().time += time;
    }

    /// Returns all sums, and resets them.
    pub fn take(&self) -> Vec<KernelTime> {
        let sums = std::mem::take(&mut *self.sums());
        let time = |(kernel, Sums { dispatches, time, work }): (&'static str, Sums)| KernelTime {
            kernel,
            dispatches,
            seconds: time.as_secs_f64(),
            work,
        };
        sums.into_iter().map(time).collect()
    }
}
