//! Keeps track of the written bytes of a buffer, on a device that checks for unwritten reads.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes that share one flag.
const WORD: usize = 4;

/// For each word of a buffer, whether it was written.
#[derive(Debug)]
pub struct Written(Box<[AtomicBool]>);

impl Written {
    /// Flags for a buffer of `bytes` bytes, all unwritten.
    pub fn none(bytes: usize) -> Self {
        Self((0..bytes.div_ceil(WORD)).map(|_| AtomicBool::new(false)).collect())
    }

    fn words(&self, bytes: Range<usize>) -> &[AtomicBool] {
        let end = bytes.end.div_ceil(WORD).min(self.0.len());
        &self.0[(bytes.start / WORD).min(end)..end]
    }

    /// Whether all of these bytes were written.
    pub fn has(&self, bytes: Range<usize>) -> bool {
        self.words(bytes).iter().all(|word| word.load(Ordering::Relaxed))
    }

    /// Marks bytes as written or unwritten.
    pub fn set(&self, bytes: Range<usize>, written: bool) {
        self.words(bytes).iter().for_each(|word| word.store(written, Ordering::Relaxed));
    }

    /// Copies the flags of `range`, which belongs to `from`, to the bytes starting at `begin`.
    pub fn copy(&self, from: Option<&Self>, range: Range<usize>, begin: usize) {
        let target = self.words(begin..begin + range.len());
        for (at, word) in target.iter().enumerate() {
            let source = range.start + at * WORD;
            let written = from.is_none_or(|from| from.has(source..source + WORD));
            word.store(written, Ordering::Relaxed);
        }
    }
}
