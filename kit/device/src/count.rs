//! Numbers of items that either the host knows, or only the device.

use std::sync::Arc;

use muslin_kernel::count::{self, OVERFLOW};

use crate::buffer::{Buffer, Memory};

/// A number of items: known to the host, or written on the device by a kernel.
#[derive(Clone, Debug)]
pub struct Count {
    /// The number, or the capacity if only the device knows the number.
    upper_bound: u32,
    total: Option<Total>,
}

/// The total of which a number on the device is a part.
#[derive(Clone, Debug)]
pub(super) struct Total {
    /// The buffer of counts: see [`muslin_kernel::count`].
    pub counts: Arc<Buffer<u32>>,
    pub place: u32,
    /// Number of items before this piece.
    pub first: u32,
}

impl Count {
    /// A number that the host knows.
    #[must_use]
    pub fn known(number: u32) -> Self {
        Self { upper_bound: number, total: None }
    }

    /// The number at index `place` of `counts`. Tables have room for `upper_bound` items.
    pub fn on_device(counts: &Arc<Buffer<u32>>, place: u32, upper_bound: u32) -> Self {
        Self { upper_bound, total: Some(Total { counts: counts.clone(), place, first: 0 }) }
    }

    /// The number that determines the size of tables and dispatches.
    #[must_use]
    pub fn upper_bound(&self) -> u32 {
        self.upper_bound
    }

    /// The number of items from `first` on, at most `most`.
    #[must_use]
    pub fn piece(&self, first: u32, most: u32) -> Self {
        let upper_bound = count::piece(self.upper_bound, first, most);
        let further = |total: &Total| Total { first: total.first + first, ..total.clone() };
        Self { upper_bound, total: self.total.as_ref().map(further) }
    }

    /// Whether the host knows the number.
    #[must_use]
    pub fn is_known(&self) -> bool {
        self.total.is_none()
    }

    pub(super) fn total(&self) -> Option<&Total> {
        self.total.as_ref()
    }

    /// The number, on the CPU backend.
    pub(super) fn on_cpu(&self) -> u32 {
        let Some(total) = &self.total else { return self.upper_bound };
        let Memory::Cpu(memory) = &total.counts.raw().memory else {
            panic!("the counts belong to a GPU")
        };
        let counts: &[u32] = bytemuck::cast_slice(&memory.bytes()[..total.counts.bytes() as usize]);
        match counts[OVERFLOW as usize] {
            0 => count::piece(counts[total.place as usize], total.first, self.upper_bound),
            _ => 0,
        }
    }
}
