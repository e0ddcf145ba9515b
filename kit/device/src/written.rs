//! Which bytes of a buffer were written, on a device that checks that nothing else is read.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// Bytes that are written or not together.
const WORD: usize = 4;

/// For each word of a buffer, whether it was written.
#[derive(Debug)]
pub struct Written(Box<[AtomicBool]>);

impl Written {
    /// Of a buffer of so many bytes, with nothing written.
    pub fn none(bytes: usize) -> Self {
        Self((0..bytes.div_ceil(WORD)).map(|_| AtomicBool::new(false)).collect())
    }

    fn words(&self, bytes: Range<usize>) -> &[AtomicBool] {
        let end = bytes.end.div_ceil(WORD).min(self.0.len());
        &self.0[(bytes.start / WORD).min(end)..end]
    }

    /// Whether all of these bytes were.
    pub fn has(&self, bytes: Range<usize>) -> bool {
        self.words(bytes).iter().all(|word| word.load(Ordering::Relaxed))
    }

    /// Says whether these bytes were.
    pub fn set(&self, bytes: Range<usize>, written: bool) {
        self.words(bytes).iter().for_each(|word| word.store(written, Ordering::Relaxed));
    }

    /// The bytes from `begin` on are copies of those of `range`, which belong to `from`.
    pub fn copy(&self, from: Option<&Self>, range: Range<usize>, begin: usize) {
        let target = self.words(begin..begin + range.len());
        for (at, word) in target.iter().enumerate() {
            let source = range.start + at * WORD;
            let written = from.is_none_or(|from| from.has(source..source + WORD));
            word.store(written, Ordering::Relaxed);
        }
    }
}
