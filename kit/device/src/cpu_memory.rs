//! Memory of the CPU backend, and which of its bytes are written. It is reused: a step gets the memory that the previous step has freed.

use std::alloc::{self, Layout};
use std::collections::VecDeque;
use std::ops::Range;
use std::panic::Location;
use std::ptr::NonNull;
use std::sync::atomic::{AtomicU8, Ordering};
use std::sync::{Arc, OnceLock};

use parking_lot::Mutex;

/// Bytes of a large page of most CPUs.
const LARGE_PAGE: usize = 2 << 20;

/// Most unused memory that is kept, in bytes.
const SPARE_BYTES: usize = 256 << 20;

/// Aligned memory that kernels write through pointers.
#[derive(Debug)]
pub struct CpuMemory {
    block: Option<Allocation>,
    pool_memory: MemoryPool,
    /// The written parts of the memory, if not all counts as written.
    written: OnceLock<Written>,
}

/// Unused memory. The block that was unused for the longest time is first.
#[derive(Clone, Debug, Default)]
pub struct MemoryPool(Arc<Mutex<VecDeque<Allocation>>>);

impl MemoryPool {
    /// Takes memory of at least `bytes` bytes from the pool, if there is any. Its old content remains.
    pub fn take(&self, bytes: u64) -> Option<CpuMemory> {
        let layout = layout(bytes)?;
        let block = {
            let mut blocks = self.0.lock();
            let place = blocks.iter().rposition(|block| block.layout == layout)?;
            blocks.remove(place)?
        };
        Some(CpuMemory::new(block, self.clone()))
    }

    /// Allocates memory of at least `bytes` bytes, all zeros; `None` if the system has none.
    pub fn allocate(&self, bytes: u64) -> Option<CpuMemory> {
        let layout = layout(bytes)?;
        // SAFETY: the size is not zero
        let data = NonNull::new(crate::memory::asking(|| unsafe { alloc::alloc(layout) }))?;
        if layout.align() == LARGE_PAGE {
            ask_for_large_pages(data, layout.size());
        }
        // SAFETY: it has just been allocated, with this size
        unsafe { data.write_bytes(0, layout.size()) };
        Some(CpuMemory::new(Allocation { data, layout }, self.clone()))
    }

    /// Returns all memory to the system.
    pub fn clear(&self) {
        self.0.lock().clear();
    }

    fn put(&self, block: Allocation) {
        let mut blocks = self.0.lock();
        blocks.push_back(block);
        let mut bytes: usize = blocks.iter().map(|block| block.layout.size()).sum();
        while bytes > SPARE_BYTES {
            bytes -= blocks.pop_front().map_or(bytes, |block| block.layout.size());
        }
    }
}

/// A layout with one of four sizes between powers of two, so that batches of similar size can share memory.
fn layout(bytes: u64) -> Option<Layout> {
    let bytes = usize::try_from(bytes).ok()?.max(64);
    let step = (bytes.checked_next_power_of_two()? / 8).max(64);
    // a cache line is enough for every element type and for SIMD
    let align = if bytes < LARGE_PAGE { 64 } else { LARGE_PAGE };
    Layout::from_size_align(bytes.checked_next_multiple_of(step)?, align).ok()
}

/// Asks the system for large pages, before anything is written. Kernels read and add up anywhere in a hash grid's table, where most accesses
/// would have to look up a small page first. A system without large pages has small ones.
fn ask_for_large_pages(data: NonNull<u8>, bytes: usize) {
    #[cfg(target_os = "linux")]
    // SAFETY: advice about memory that has just been allocated
    unsafe {
        libc::madvise(data.as_ptr().cast(), bytes, libc::MADV_HUGEPAGE);
    }
    #[cfg(not(target_os = "linux"))]
    let _ = (data, bytes);
}

impl CpuMemory {
    fn new(block: Allocation, pool_memory: MemoryPool) -> Self {
        Self { block: Some(block), pool_memory, written: OnceLock::new() }
    }

    /// The written parts of the memory; `None` if everything counts as written.
    pub fn written(&self) -> Option<&Written> {
        self.written.get()
    }

    /// Marks bytes as unwritten.
    pub fn forget(&self, bytes: std::ops::Range<usize>) {
        let mut is_new = false;
        let written = self.written.get_or_init(|| {
            is_new = true;
            Written::none(self.bytes().len())
        });
        if is_new {
            written.set(0..self.bytes().len(), true);
        }
        written.set(bytes, false);
    }

    fn block(&self) -> &Allocation {
        self.block.as_ref().expect("it has one until it is dropped")
    }

    /// Address of the first byte.
    pub fn data(&self) -> *mut u8 {
        self.block().data.as_ptr()
    }

    pub fn bytes(&self) -> &[u8] {
        let block = self.block();
        // SAFETY: initialized at allocation, and dispatches have returned before the host reads
        unsafe { std::slice::from_raw_parts(block.data.as_ptr(), block.layout.size()) }
    }

    pub fn bytes_mut(&mut self) -> &mut [u8] {
        let block = self.block();
        // SAFETY: as above
        unsafe { std::slice::from_raw_parts_mut(block.data.as_ptr(), block.layout.size()) }
    }
}

impl Drop for CpuMemory {
    fn drop(&mut self) {
        if let Some(block) = self.block.take() {
            self.pool_memory.put(block);
        }
    }
}

/// Memory from the system.
#[derive(Debug)]
struct Allocation {
    data: NonNull<u8>,
    layout: Layout,
}

// SAFETY: plain bytes; kernels that run at the same time do not write to the same element
unsafe impl Send for Allocation {}
// SAFETY: as above
unsafe impl Sync for Allocation {}

impl Drop for Allocation {
    fn drop(&mut self) {
        // SAFETY: allocated with this layout
        unsafe { alloc::dealloc(self.data.as_ptr(), self.layout) }
    }
}

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
    /// The kernel that may have written last.
    writer: Mutex<Option<Writer>>,
}

/// A kernel that may have written a buffer.
#[derive(Clone, Debug)]
pub struct Writer {
    pub kernel: &'static str,
    /// Its name for the buffer.
    pub name: &'static str,
    pub ticket: Ticket,
}

/// Where the additional workgroup of a dispatch has changed an element of any buffer atomically: it may have taken what another workgroup should.
pub type Ticket = Arc<OnceLock<&'static Location<'static>>>;

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
        Self { words, writer: Mutex::default() }
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

    /// Notes the kernel that may write next.
    pub fn set_writer(&self, writer: Writer) {
        *self.writer.lock() = Some(writer);
    }

    /// The kernel that may have written last.
    pub fn writer(&self) -> Option<Writer> {
        self.writer.lock().clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_at_most_a_quarter_larger() {
        for bytes in [0, 1, 64, 65, 1000, 4096, 4097, 1 << 20, (1 << 20) + 1, 7 << 30] {
            let size = layout(bytes).expect("it exists").size() as u64;
            assert!(size >= bytes && size as f64 <= 1.25 * bytes as f64 + 128.0, "{bytes}: {size}");
        }
        assert!(layout(u64::MAX).is_none());
    }

    #[test]
    fn memory_is_used_again() {
        let pool_memory = MemoryPool::default();
        assert!(pool_memory.take(1000).is_none());
        let mut memory = pool_memory.allocate(1000).expect("memory");
        memory.bytes_mut().fill(7);
        let data = memory.data();
        drop(memory);
        assert!(pool_memory.take(5000).is_none());
        let again = pool_memory.take(990).expect("what was dropped");
        assert_eq!(again.data(), data);
        drop(again);
        pool_memory.clear();
        assert!(pool_memory.take(1000).is_none());
    }

    #[test]
    fn only_so_much_lies_unused() {
        let pool_memory = MemoryPool::default();
        let all: Vec<_> =
            (0..5).map(|_| pool_memory.allocate(100 << 20).expect("memory")).collect();
        drop(all);
        let left: usize = pool_memory.0.lock().iter().map(|block| block.layout.size()).sum();
        assert!(left > 0 && left <= SPARE_BYTES);
    }
}
