//! Limits the memory that all decoding threads take together.

use std::sync::{Condvar, Mutex, PoisonError};

use muslin_device::memory;
use organza_core::error::{DeviceError, Result};

/// Part of the free memory that decoding may take. Threads and the allocator need some, too.
const PART: f64 = 0.75;

/// A number of bytes to share. A thread that needs more than are left waits for the others.
#[derive(Debug)]
pub(super) struct Budget {
    total: u64,
    used: Mutex<u64>,
    returned: Condvar,
}

/// Bytes of a [`Budget`], returned on drop.
#[derive(Debug)]
pub(super) struct Share<'a> {
    budget: &'a Budget,
    bytes: u64,
}

impl Budget {
    /// A budget of the memory that is free now, without `results` bytes that are kept.
    pub fn beside(results: u64) -> Self {
        let free = memory::available().map(|bytes| bytes.saturating_sub(results));
        Self::new(free.map_or(u64::MAX, |bytes| (bytes as f64 * PART) as u64))
    }

    /// A budget of exactly `total` bytes.
    pub fn new(total: u64) -> Self {
        Self { total, used: Mutex::new(0), returned: Condvar::new() }
    }

    /// Takes bytes. Waits if other threads have them.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`] for more than the whole budget. `what` describes the purpose.
    pub fn take(&self, bytes: u64, what: impl FnOnce() -> String) -> Result<Share<'_>> {
        if bytes > self.total {
            let needed = bytes;
            let available = Some(self.total);
            return Err(DeviceError::OutOfMemory { needed, available, what: what() }.into());
        }
        let used = self.used.lock().unwrap_or_else(PoisonError::into_inner);
        let mut used = self
            .returned
            .wait_while(used, |used| *used > self.total - bytes)
            .unwrap_or_else(PoisonError::into_inner);
        *used += bytes;
        Ok(Share { budget: self, bytes })
    }
}

impl Drop for Share<'_> {
    fn drop(&mut self) {
        *self.budget.used.lock().unwrap_or_else(PoisonError::into_inner) -= self.bytes;
        self.budget.returned.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU64, Ordering};
    use std::thread;

    use super::*;

    #[test]
    fn more_than_the_budget_is_refused_at_once() {
        let budget = Budget::new(10);
        let _all = budget.take(10, String::new).unwrap();
        let error = budget.take(11, || "the photograph".to_owned()).unwrap_err().to_string();
        assert!(error.contains("the photograph needs 11 bytes but 10 bytes are"), "{error}");
    }

    #[test]
    fn threads_never_hold_more_than_there_is() {
        let budget = Budget::new(100);
        let held = AtomicU64::new(0);
        thread::scope(|scope| {
            for thread in 0..8 {
                let budget = &budget;
                let held = &held;
                scope.spawn(move || {
                    for round in 0..200 {
                        let bytes = 1 + (thread * 31 + round * 17) % 100;
                        let share = budget.take(bytes, String::new).unwrap();
                        let all = held.fetch_add(bytes, Ordering::SeqCst) + bytes;
                        assert!(all <= 100, "{all}");
                        held.fetch_sub(bytes, Ordering::SeqCst);
                        drop(share);
                    }
                });
            }
        });
    }
}
