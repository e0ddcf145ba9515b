//! B3. Which cells of its tile an intersection can reach, so that a pixel can skip the other intersections.
//!
//! A tile is cut into 4 columns and 8 rows of cells; an intersection's cells are the bits of a word. They include everything that
//! [`touches`] accepts, because both round alike. So the image does not depend on them.

use glam::Vec4;

use crate::splat::VECTORS;
use crate::tile::Tile;
use crate::transmittance::owner;
use muslin::math::abs;
use muslin::prelude::*;

/// Columns of cells.
const COLUMNS: u32 = 4;
/// Rows of cells.
const ROWS: u32 = u32::BITS / COLUMNS;

/// How the pixels of a tile fall into cells.
#[derive(Clone, Copy)]
pub struct Cells {
    /// Width of a cell, in pixels: a multiple of the widest lanes, so that no lanes lie in two columns.
    width: u32,
    /// Height of a cell, in pixels.
    height: u32,
}

impl Cells {
    /// The cells of a tile of this side, in pixels.
    #[inline(always)]
    pub fn new(side: u32) -> Self {
        // the widest lanes
        let lanes = 16;
        Self { width: side.div_ceil(COLUMNS * lanes) * lanes, height: side.div_ceil(ROWS) }
    }

    /// The cell of a pixel of the tile, as a bit.
    #[inline(always)]
    pub fn bit(&self, column: u32, row: u32) -> u32 {
        1 << (row / self.height * COLUMNS + column / self.width)
    }
}

/// Parameters of [`tile_cells`].
#[params]
pub struct TileCellsParams {
    /// Intersections of all tiles.
    pub intersections: u32,
    /// Tiles of the part.
    pub tiles: u32,
    /// S, in pixels.
    pub side: u32,
}

/// Writes the cells of every intersection, `cells [intersections]`, by its splat's extent.
///
/// `tile_first [tiles + 1]`, `intersection [intersections]`, `splat [pairs, 3]`.
#[kernel(threads(64), over(params.intersections), iterations = 2 * u32::BITS + ROWS, counts(intersections))]
pub fn tile_cells(
    id: Invocation,
    params: &TileCellsParams,
    tile: Read<i32>,
    tile_first: Read<u32>,
    intersection: Read<u32>,
    splat: Read<Vec4>,
    cells: Write<u32>,
) {
    let index = id.index();
    if index < params.intersections {
        let tile = Tile::read(tile, owner(tile_first, params.tiles, index));
        let first = intersection.read(index) * VECTORS;
        let placed = splat.read(first);
        let conic = splat.read(first + 1);
        let grid = Cells::new(params.side);
        let mut bits = 0;
        let mut cell = 0;
        while cell < COLUMNS * ROWS {
            let column = cell % COLUMNS * grid.width;
            let row = cell / COLUMNS * grid.height;
            if reaches_cell(&tile, &grid, column, row, placed, conic) {
                bits |= 1 << cell;
            }
            cell += 1;
        }
        cells.write(index, bits);
    }
}

/// Whether a splat's support may reach pixels of a row, whose centers lie in `[first, last]` and at height `y`.
#[inline(always)]
pub fn touches(placed: Vec4, conic: Vec4, first: f32, last: f32, y: f32) -> bool {
    let beside = first - placed.x > placed.w || placed.x - last > placed.w;
    !(beside || abs(y - placed.y) > conic.w)
}

/// Whether a splat's extent meets the pixel centers of the cell that begins at a pixel.
#[inline(always)]
fn reaches_cell(
    tile: &Tile,
    grid: &Cells,
    column: u32,
    row: u32,
    placed: Vec4,
    conic: Vec4,
) -> bool {
    let first = tile.pixel_center(column, row);
    let last = tile.pixel_center(column + grid.width - 1, row + grid.height - 1);
    // the nearest of its rows
    let y = if placed.y < first.y {
        first.y
    } else if placed.y > last.y {
        last.y
    } else {
        placed.y
    };
    touches(placed, conic, first.x, last.x, y)
}
