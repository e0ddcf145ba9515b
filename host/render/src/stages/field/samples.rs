//! The samples of a field, in blocks: what its hash grid and its network read.
//!
//! From large to small:
//!
//! - A **block** is what the hash grid takes at once, level by level: so a level's entries are read from memory once for many samples.
//! - A **group** has the chunks of a block whose gradients are added to the hash grid together.
//! - A **span** has neighboring chunks that are all full, except for the last one: one dispatch of the hash grid's kernels.
//! - A **chunk** is what the network takes at once: so its activations stay in a CPU's caches. On a GPU, a block is one chunk.
//! - A **slice** has samples of one camera, whose gradients of the network are summed in f32. A CPU adds several samples of a slice at
//!   once: there, a chunk is one slice, and ends where its camera's samples end.

use std::ops::Range;

use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::limits::{MAX_HIDDEN_WIDTH, MAX_INPUTS, MAX_SLICE};

use muslin_device::{Buffer, Count, Device, Result, TAIL_ALIGNMENT};

/// Samples of a block, in whole chunks.
const BLOCK: u32 = 1 << 17;
/// Samples whose gradients are added to the hash grid together, in whole chunks. Every level reads them again, so they must
/// fit into a CPU's last-level cache.
const GROUP: u32 = 1 << 14;
/// Samples of a chunk on a CPU. With gradients, a chunk has about 300 rows, which fit into the L2 cache.
const CPU_CHUNK: u32 = 1 << 11;
/// Smallest and largest number of samples of a chunk on a GPU. The largest fills any GPU, and there are few dispatches.
const GPU_CHUNKS: [u32; 2] = [BLOCK, 1 << 20];
/// One chunk has all samples on a GPU while its widest table takes at most this many bytes, or this share of the memory if that is more.
const CHUNK_BYTES: u64 = 64 << 20;
const CHUNK_SHARES: u64 = 64;
/// Rows of the widest table of a chunk.
const MAX_ROWS: u32 = if MAX_INPUTS > MAX_HIDDEN_WIDTH { MAX_INPUTS } else { MAX_HIDDEN_WIDTH };
/// Samples of a slice on a GPU: a chunk has enough slices to fill it.
const GPU_SLICE: u32 = 1 << 8;
/// Bytes of a field's blocks that are kept for the backward pass: this many, or this share of a GPU's memory if that is more. The backward
/// pass computes all other blocks again.
const KEPT_BYTES: u64 = 256 << 20;
const KEPT_SHARES: u64 = 8;
/// Rows of a point: its position, and one more for the stage.
pub const ROWS_OF_POINT: u32 = POINT_ROWS + 1;

/// Values between which rows begin.
const ALIGNED: u32 = (TAIL_ALIGNMENT / size_of::<f32>()) as u32;

const _: () = assert!(CPU_CHUNK <= MAX_SLICE && GPU_SLICE <= MAX_SLICE);

/// How samples lie in memory: `[chunks, rows, stride]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Largest number of samples of a chunk.
    pub chunk: u32,
    /// Distance between two rows of a chunk, in values.
    pub stride: u32,
    /// Largest number of chunks of a block.
    chunks: u32,
    /// Largest number of chunks of a group.
    pub group: u32,
    /// Largest number of samples of a slice.
    pub slice: u32,
}

impl Layout {
    /// The layout, if at most `largest` samples lie between two places where chunks must end.
    fn new(device: &Device, largest: u32) -> Self {
        let [max, slice] = match device.is_cpu_like() {
            true => [CPU_CHUNK, CPU_CHUNK],
            false => {
                let share = device.memory_share(CHUNK_SHARES, CHUNK_BYTES);
                [gpu_chunk(largest, device.max_buffer_bytes(), share), GPU_SLICE]
            }
        };
        let chunk = largest.clamp(1, max).next_multiple_of(ALIGNED);
        // not a power of two: rows would share the sets of a cache
        let stride = chunk + ALIGNED;
        let chunks = (BLOCK / chunk).max(1);
        // enough for every thread
        let group = (GROUP / chunk).max(2 * device.threads() as u32).clamp(1, chunks);
        Self { chunk, stride, chunks, group, slice }
    }

    /// Offset of a chunk, in values, where chunks have `rows` rows.
    pub fn begin(&self, chunk: u32, rows: u32) -> usize {
        chunk as usize * rows as usize * self.stride as usize
    }
}

/// Largest number of samples of a chunk on a GPU: all of them, if its tables fit a share of the memory, and about an eighth otherwise, if they fit
/// a binding.
fn gpu_chunk(samples: u32, max_buffer_bytes: u64, share: u64) -> u32 {
    let [min, max] = GPU_CHUNKS;
    let row_bytes = u64::from(MAX_ROWS) * size_of::<f32>() as u64;
    let samples_in = |bytes: u64| (bytes / row_bytes).min(u32::MAX.into()) as u32;
    // room for the distance between rows
    let fitting = samples_in(max_buffer_bytes).saturating_sub(ALIGNED);
    let wanted = samples.min(samples_in(share)).max(samples / 8).min(max).next_power_of_two();
    wanted.min(fitting).max(min) / ALIGNED * ALIGNED
}

/// Memory of a block's samples.
#[derive(Debug)]
struct Block {
    /// `[chunks, 7, stride]`
    point: Buffer<f32>,
    /// `[chunks, rows, stride]`
    input: Buffer<f32>,
}

/// All samples of a field. The first blocks have memory of their own; all others share the last one's.
#[derive(Debug)]
pub struct Blocks {
    pub layout: Layout,
    /// Rows of the network's input.
    pub rows: u32,
    /// Number of samples; the host may know only an upper bound.
    pub count: Count,
    /// First sample of each chunk, and the end of the last one.
    first: Vec<u32>,
    blocks: Vec<Block>,
}

/// A range of chunks in the current block: all chunks, a group, a span, or one chunk.
#[derive(Clone, Debug)]
pub struct Chunks<'a> {
    pub all: &'a Blocks,
    /// Memory of the block.
    block: &'a Block,
    /// Whether the values of the forward pass are still there.
    pub is_kept: bool,
    /// The block's first chunk.
    first_of_block: usize,
    /// First chunk of the block, or of the group: [`Self::index`] counts from it.
    first_of_group: usize,
    range: Range<usize>,
}

impl Blocks {
    /// Memory for `count` samples with `rows` rows of network input. With `keep`, as many blocks as fit into [`KEPT_BYTES`],
    /// or a GPU's share, have memory of their own.
    ///
    /// A chunk ends at each of the `ends`, which ascend to the number of samples. Without `ends`, chunks may end anywhere.
    pub fn new(
        device: &Device,
        rows: usize,
        count: Count,
        keep: bool,
        ends: &[u32],
    ) -> Result<Self> {
        let samples = count.upper_bound();
        let ends = if ends.is_empty() { &[samples] } else { ends };
        let begins = std::iter::once(&0).chain(ends);
        let ranges: Vec<_> = begins.zip(ends).map(|(&begin, &end)| begin..end).collect();
        let largest = ranges.iter().map(|range| range.len() as u32).max().unwrap_or(0);
        let mut layout = Layout::new(device, largest);
        let chunks = ranges.into_iter().flat_map(|range| range.step_by(layout.chunk as usize));
        let mut first: Vec<_> = chunks.collect();
        layout.chunks = layout.chunks.min(first.len() as u32);
        layout.group = layout.group.clamp(1, layout.chunks.max(1));
        let rows = rows as u32;
        let all = first.len().div_ceil(layout.chunks.max(1) as usize);
        first.push(samples);
        let len = |rows| layout.begin(layout.chunks, rows);
        let bytes = ((len(ROWS_OF_POINT) + len(rows)) * size_of::<f32>()) as u64;
        let room = device.memory_share(KEPT_SHARES, KEPT_BYTES) / bytes.max(1);
        let kept = if keep { all.min(room as usize) } else { 1 };
        let mut blocks = Vec::new();
        for _ in 0..kept.max(1) {
            let point = device.unwritten("points", len(ROWS_OF_POINT))?;
            let input = device.unwritten("network input", len(rows))?;
            blocks.push(Block { point, input });
        }
        Ok(Self { layout, rows, count, first, blocks })
    }

    /// The blocks, in order.
    pub fn iter(&self) -> impl Iterator<Item = Chunks<'_>> {
        let chunks = self.first.len() - 1;
        let last = self.blocks.len() - 1;
        let size = self.layout.chunks.max(1) as usize;
        let count = chunks.div_ceil(size);
        (0..count).map(move |index| {
            let begin = index * size;
            Chunks {
                all: self,
                block: &self.blocks[index.min(last)],
                is_kept: index < last || count == self.blocks.len(),
                first_of_block: begin,
                first_of_group: begin,
                range: begin..chunks.min(begin + size),
            }
        })
    }
}

impl<'a> Chunks<'a> {
    /// Index of the first sample among all samples.
    pub fn first(&self) -> u32 {
        self.all.first[self.range.start]
    }

    /// Number of samples, or an upper bound.
    pub fn samples(&self) -> u32 {
        self.all.first[self.range.end] - self.first()
    }

    /// Number of samples; on a GPU, it may be known to the device alone.
    pub fn count(&self) -> Count {
        self.all.count.piece(self.first(), self.samples())
    }

    /// Distance between two rows, in values.
    pub fn stride(&self) -> u32 {
        self.all.layout.stride
    }

    /// The first chunk's place in its block or group.
    pub fn index(&self) -> u32 {
        (self.range.start - self.first_of_group) as u32
    }

    /// Points: `[chunks, 7, stride]`.
    pub fn point(&self) -> Buffer<f32> {
        self.block.point.tail(self.begin(ROWS_OF_POINT))
    }

    /// Inputs: `[chunks, rows, stride]`.
    pub fn input(&self) -> Buffer<f32> {
        self.block.input.tail(self.begin(self.all.rows))
    }

    fn begin(&self, rows: u32) -> usize {
        self.all.layout.begin((self.range.start - self.first_of_block) as u32, rows)
    }

    fn with(&self, first_of_group: usize, range: Range<usize>) -> Self {
        Self { first_of_group, range, ..self.clone() }
    }

    /// The block's groups, in order.
    pub fn groups(&self) -> impl Iterator<Item = Self> {
        let size = self.all.layout.group as usize;
        let end = self.range.end;
        let begins = self.range.clone().step_by(size);
        begins.map(move |begin| self.with(begin, begin..end.min(begin + size)))
    }

    /// The spans, in order: all chunks of a span are full, except for the last one.
    pub fn spans(&self) -> impl Iterator<Item = Self> {
        let full = self.all.layout.chunk;
        let first = &self.all.first;
        let mut rest = self.range.clone();
        std::iter::from_fn(move || {
            let begin = rest.next()?;
            let mut last = begin;
            while first[last + 1] - first[last] == full && !rest.is_empty() {
                last = rest.next()?;
            }
            Some(self.with(self.first_of_group, begin..last + 1))
        })
    }

    /// Each chunk, in order.
    pub fn chunks(&self) -> impl Iterator<Item = Self> {
        self.range.clone().map(|index| self.with(self.first_of_group, index..index + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use muslin_device::DeviceOptions;

    #[test]
    fn many_samples_are_few_chunks_on_a_card() {
        const CARD: u64 = (1 << 31) - 1;
        // of 80 GB, whose binding holds 932,000 samples, and one that does not tell its memory
        for (share, all) in [(80 << 24, [1, 1, 1, 2]), (CHUNK_BYTES, [1, 1, 3, 8])] {
            for (samples, expected) in [1, 1 << 17, 300_000, 1 << 20].into_iter().zip(all) {
                let chunks = u32::div_ceil(samples, gpu_chunk(samples, CARD, share));
                assert_eq!(chunks, expected, "{samples} with {share} bytes");
            }
            let chunks = u32::div_ceil(8_000_000, gpu_chunk(8_000_000, CARD, share));
            assert!((8..=9).contains(&chunks), "{chunks}");
        }
        // a software device, and browsers
        assert_eq!(gpu_chunk(8_000_000, 128 << 20, CHUNK_BYTES), BLOCK);
        let chunk = u64::from(gpu_chunk(8_000_000, 1 << 29, 80 << 24));
        assert!((chunk + u64::from(ALIGNED)) * u64::from(MAX_ROWS) * 4 <= 1 << 29, "{chunk}");
    }

    #[test]
    fn chunks_end_where_cameras_do() {
        let device = crate::open_device(&DeviceOptions::cpu(Some(2))).expect("the CPU");
        let ends = [100, 100, 4300, 5000];
        let blocks = Blocks::new(&device, 3, Count::known(5000), true, &ends).expect("blocks");
        let all: Vec<_> = blocks.iter().collect();
        let [block] = &all[..] else { panic!("{} blocks", all.len()) };
        let range = |first: u32, samples: u32| first..first + samples;
        let chunks: Vec<_> = block.chunks().map(|c| range(c.first(), c.samples())).collect();
        assert_eq!(chunks, [0..100, 100..2148, 2148..4196, 4196..4300, 4300..5000]);
        let spans: Vec<_> = block.spans().map(|s| (s.index(), s.first(), s.samples())).collect();
        assert_eq!(spans, [(0, 0, 100), (1, 100, 4200), (4, 4300, 700)]);
        // without `ends`, only the last chunk is not full
        let blocks = Blocks::new(&device, 3, Count::known(5000), true, &[]).expect("blocks");
        let block = blocks.iter().next().expect("a block");
        let chunks: Vec<_> = block.chunks().map(|c| range(c.first(), c.samples())).collect();
        assert_eq!(chunks, [0..2048, 2048..4096, 4096..5000]);
        assert_eq!(block.spans().count(), 1);
    }
}
