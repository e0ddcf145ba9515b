//! Keeps track of the written bytes of a buffer, on a device that checks for unwritten reads.

use std::ops::Range;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Mutex, PoisonError};

/// Bytes that share one flag.
const WORD: usize = 4;

/// Nothing has written it.
const UNWRITTEN: u8 = 0;
/// Only an additional workgroup has written it, which no other device runs.
const ADDITIONAL: u8 = 1;
const WRITTEN: u8 = 2;

/// For each word of a buffer, whether it was written.
#[derive(Debug)]
pub struct Written {
    words: Box<[AtomicU8]>,
    /// The kernel that may have written last, and its name for the buffer.
    kernel: Mutex<Option<[&'static str; 2]>>,
}

/// Elements that nothing has written.
pub struct Missing {
    /// Offset of its first byte.
    pub at: usize,
    /// Whether an additional workgroup has written it.
    pub is_additional: bool,
}

impl Written {
    /// Flags for a buffer of `bytes` bytes, all unwritten.
    pub fn none(bytes: usize) -> Self {
        let words = (0..bytes.div_ceil(WORD)).map(|_| AtomicU8::new(UNWRITTEN)).collect();
        Self { words, kernel: Mutex::default() }
    }

    fn words(&self, bytes: Range<usize>) -> &[AtomicU8] {
        let end = bytes.end.div_ceil(WORD).min(self.words.len());
        &self.words[(bytes.start / WORD).min(end)..end]
    }

    /// Whether all of these bytes were written.
    pub fn has(&self, bytes: Range<usize>) -> bool {
        self.words(bytes).iter().all(|word| word.load(Ordering::Relaxed) == WRITTEN)
    }

    /// The first of these bytes that were not written.
    pub fn missing(&self, bytes: Range<usize>) -> Option<Missing> {
        let first = bytes.start / WORD * WORD;
        let flags = self.words(bytes).iter().map(|word| word.load(Ordering::Relaxed));
        let (index, flag) = flags.enumerate().find(|(_, flag)| *flag != WRITTEN)?;
        Some(Missing { at: first + index * WORD, is_additional: flag == ADDITIONAL })
    }

    /// Marks bytes as written or unwritten.
    pub fn set(&self, bytes: Range<usize>, written: bool) {
        let flag = if written { WRITTEN } else { UNWRITTEN };
        self.words(bytes).iter().for_each(|word| word.store(flag, Ordering::Relaxed));
    }

    /// Marks bytes as written by an additional workgroup, unless others have written them.
    pub fn set_additional(&self, bytes: Range<usize>) {
        for word in self.words(bytes) {
            word.fetch_max(ADDITIONAL, Ordering::Relaxed);
        }
    }

    /// Copies the flags of `range`, which belongs to `from`, to the bytes starting at `begin`.
    pub fn copy(&self, from: Option<&Self>, range: Range<usize>, begin: usize) {
        let target = self.words(begin..begin + range.len());
        for (at, word) in target.iter().enumerate() {
            let source = range.start + at * WORD;
            let written = from.is_none_or(|from| from.has(source..source + WORD));
            word.store(if written { WRITTEN } else { UNWRITTEN }, Ordering::Relaxed);
        }
    }

    /// The flags, for [`Written::restore`].
    pub fn save(&self) -> Vec<u8> {
        self.words.iter().map(|word| word.load(Ordering::Relaxed)).collect()
    }

    /// Sets all flags to what they were.
    pub fn restore(&self, flags: &[u8]) {
        for (word, flag) in self.words.iter().zip(flags) {
            word.store(*flag, Ordering::Relaxed);
        }
    }

    /// Notes the kernel that may write next, and its name for the buffer.
    pub fn set_kernel(&self, kernel: &'static str, name: &'static str) {
        *self.kernel.lock().unwrap_or_else(PoisonError::into_inner) = Some([kernel, name]);
    }

    /// The kernel that may have written last, and its name for the buffer.
    pub fn kernel(&self) -> Option<[&'static str; 2]> {
        *self.kernel.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
