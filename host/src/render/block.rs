//! The samples of a field, in blocks: what its hash grid and its network read.
//!
//! A grid is evaluated level by level for a whole block, so that a level's entries are read from memory once for many
//! samples; a network chunk by chunk, so that a chunk's activations stay in a CPU's caches.

use organza_shaders::hash_grid::POINT_ROWS;
use organza_shaders::limits::{MAX_SLICE, MAX_SLICES};

use organza_device::{Buffer, Count, Device, Result, TAIL_ALIGNMENT};

/// Samples of a block, in whole chunks.
const BLOCK: u32 = 1 << 17;
/// Samples whose gradients go to the hash grid at once, in whole chunks: what is read again for each level stays in a
/// CPU's last cache.
const GROUP: u32 = 1 << 14;
/// Samples of a chunk on a CPU: with its gradients, about 300 rows that its second cache holds.
const CPU_CHUNK: u32 = 1 << 11;
/// Samples of a chunk on a GPU: enough to fill it.
const GPU_CHUNK: u32 = 1 << 16;
/// Memory for the blocks of a field that are kept for the gradients, in bytes; other blocks are computed again.
const KEPT_BYTES: u64 = 256 << 20;
/// Rows of a point: its position, and one more for the stage.
pub const ROWS_OF_POINT: u32 = POINT_ROWS + 1;

const _: () = assert!(CPU_CHUNK <= MAX_SLICE && BLOCK.is_multiple_of(GPU_CHUNK));

/// How samples lie in memory: `[chunks, rows, stride]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Samples of a chunk.
    pub chunk: u32,
    /// Distance of two rows of a chunk.
    pub stride: u32,
    /// Chunks of a block.
    chunks: u32,
    /// Chunks of a group.
    pub group: u32,
}

impl Layout {
    /// For `samples` samples, in as many blocks as it takes.
    pub fn new(device: &Device, samples: u32) -> Self {
        const ALIGNED: u32 = (TAIL_ALIGNMENT / size_of::<f32>()) as u32;
        let largest = if device.is_cpu_like() { CPU_CHUNK } else { GPU_CHUNK };
        let chunk = samples.clamp(1, largest).next_multiple_of(ALIGNED);
        // not a power of two: rows would fall into the same sets of a cache
        let stride = chunk + ALIGNED;
        let chunks = samples.min(BLOCK).div_ceil(chunk);
        // enough for every thread
        let group = (GROUP / chunk).max(2 * device.threads() as u32).min(MAX_SLICES);
        Self { chunk, stride, chunks, group: group.clamp(1, chunks.max(1)) }
    }

    /// Room for a block: `[chunks, rows, stride]`.
    fn room(&self, device: &Device, label: &'static str, rows: u32) -> Result<Buffer<f32>> {
        device.unwritten(label, self.first(self.chunks, rows))
    }

    /// Room for a group: `[chunks, rows, stride]`.
    pub fn room_for_group(
        &self,
        device: &Device,
        label: &'static str,
        rows: u32,
    ) -> Result<Buffer<f32>> {
        device.unwritten(label, self.first(self.group, rows))
    }

    /// A chunk's part of a buffer `[chunks, rows, stride]`.
    pub fn of_chunk(&self, buffer: &Buffer<f32>, chunk: u32, rows: u32) -> Buffer<f32> {
        buffer.tail(self.first(chunk, rows))
    }

    fn first(&self, chunk: u32, rows: u32) -> usize {
        chunk as usize * rows as usize * self.stride as usize
    }

    /// Samples of a block.
    fn block(&self) -> u32 {
        self.chunk * self.chunks
    }
}

/// A block's samples, as they lie on a device.
#[derive(Debug)]
pub struct Block {
    /// `[chunks, 7, stride]`
    point: Buffer<f32>,
    /// `[chunks, rows, stride]`
    input: Buffer<f32>,
    /// Rows of the network's input.
    pub rows: u32,
    pub layout: Layout,
}

impl Block {
    fn new(device: &Device, layout: Layout, rows: u32) -> Result<Self> {
        Ok(Self {
            point: layout.room(device, "points", ROWS_OF_POINT)?,
            input: layout.room(device, "network input", rows)?,
            rows,
            layout,
        })
    }
}

/// Some of the blocks' samples.
#[derive(Debug)]
pub struct Chunk {
    /// The first, counted from the first block's.
    pub first: u32,
    /// Their number, or the capacity.
    pub samples: u32,
    pub count: Count,
    /// Its place in its block or group.
    pub index: u32,
    /// `[7, stride]`
    pub point: Buffer<f32>,
    /// `[rows, stride]`
    pub input: Buffer<f32>,
    pub stride: u32,
}

/// All samples of a field: some of their blocks have memory of their own, the others share the last one's.
#[derive(Debug)]
pub struct Blocks {
    layout: Layout,
    count: Count,
    blocks: Vec<Block>,
}

/// A block that is being worked on, or a group of its chunks.
#[derive(Clone, Copy, Debug)]
pub struct BlockOf<'a> {
    /// Its memory.
    pub block: &'a Block,
    /// The first chunk's place in it.
    first_chunk: u32,
    /// Whether what was written there before is still there.
    pub is_kept: bool,
    /// Its first sample.
    pub first: u32,
    /// Their number, or the capacity.
    pub samples: u32,
    /// All blocks together.
    total: &'a Count,
}

impl Blocks {
    /// For `count` samples, and as many `rows` of inputs.  Where they are to be kept, as many blocks as
    /// [`KEPT_BYTES`] holds have memory of their own.
    pub fn new(device: &Device, rows: usize, count: Count, keep: bool) -> Result<Self> {
        let samples = count.at_most();
        let (layout, rows) = (Layout::new(device, samples), rows as u32);
        let first = Block::new(device, layout, rows)?;
        let mut blocks = vec![first];
        if keep {
            let bytes = blocks[0].point.bytes() + blocks[0].input.bytes();
            let kept =
                samples.div_ceil(layout.block().max(1)).min((KEPT_BYTES / bytes.max(1)) as u32);
            for _ in 1..kept {
                blocks.push(Block::new(device, layout, rows)?);
            }
        }
        Ok(Self { layout, count, blocks })
    }

    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// Their number, or the capacity.
    pub fn samples(&self) -> u32 {
        self.count.at_most()
    }

    /// In order.
    pub fn iter(&self) -> impl Iterator<Item = BlockOf<'_>> {
        let (size, samples, total) = (self.layout.block(), self.samples(), &self.count);
        let count = samples.div_ceil(size.max(1)) as usize;
        let last = self.blocks.len() - 1;
        (0..count).map(move |index| {
            let first = index as u32 * size;
            let is_kept = index < last || count == self.blocks.len();
            let block = &self.blocks[index.min(last)];
            let samples = size.min(samples - first);
            BlockOf { block, first_chunk: 0, is_kept, first, samples, total }
        })
    }
}

impl<'a> BlockOf<'a> {
    /// How many samples it has.
    pub fn count(&self) -> Count {
        self.total.piece(self.first, self.samples)
    }

    /// Its points: `[chunks, 7, stride]`.
    pub fn point(&self) -> Buffer<f32> {
        self.block.layout.of_chunk(&self.block.point, self.first_chunk, ROWS_OF_POINT)
    }

    /// Its inputs: `[chunks, rows, stride]`.
    pub fn input(&self) -> Buffer<f32> {
        self.block.layout.of_chunk(&self.block.input, self.first_chunk, self.block.rows)
    }

    /// Its groups, in order.
    pub fn groups(self) -> impl Iterator<Item = BlockOf<'a>> {
        let layout = self.block.layout;
        let size = layout.group * layout.chunk;
        (0..self.samples.div_ceil(size)).map(move |index| BlockOf {
            first_chunk: self.first_chunk + index * layout.group,
            first: self.first + index * size,
            samples: size.min(self.samples - index * size),
            ..self
        })
    }

    /// Its chunks, in order.
    pub fn chunks(self) -> impl Iterator<Item = Chunk> + use<'a> {
        let layout = self.block.layout;
        (0..self.samples.div_ceil(layout.chunk)).map(move |index| {
            let begin = index * layout.chunk;
            Chunk {
                first: self.first + begin,
                samples: layout.chunk.min(self.samples - begin),
                count: self.total.piece(self.first + begin, layout.chunk),
                index,
                point: layout.of_chunk(&self.point(), index, ROWS_OF_POINT),
                input: layout.of_chunk(&self.input(), index, self.block.rows),
                stride: layout.stride,
            }
        })
    }
}
