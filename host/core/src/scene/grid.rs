//! The multiresolution hash grids: their configuration and the geometry of their levels.

use organza_shaders::hash_grid::GridLevel;
use organza_shaders::limits::MAX_FEATURES;
pub use organza_shaders::limits::MAX_LEVELS;
use serde::{Deserialize, Serialize};

use crate::error::{Result, bad_config};

/// Finest resolution of a level: beyond it, an f32 position has no useful fraction left.
pub const MAX_RESOLUTION: u32 = 1 << 20;
/// The largest base-2 logarithm of a level's entry count.
pub const MAX_LOG2_TABLE: u32 = 24;
/// Allowed numbers of features per entry.
pub const FEATURE_WIDTHS: [u32; 4] = [1, 2, 4, MAX_FEATURES];
/// Below this the first level's scale is less than -0.5 and a position could land in cell -1.
const MIN_BASE_RESOLUTION: f64 = 0.5;

/// The configuration of one hash grid, as in a scene's `color_grid` and `transmittance_grid`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GridConfig {
    /// Number of levels, 1 to [`MAX_LEVELS`].
    pub levels: u32,
    /// Features per entry, one of [`FEATURE_WIDTHS`].
    pub features: u32,
    /// Base-2 logarithm of the most entries a level has, 1 to [`MAX_LOG2_TABLE`].
    pub log2_table: u32,
    /// Resolution of level 0, in cells per axis; need not be an integer.
    pub base_resolution: f64,
    /// Factor from one level's resolution to the next, at least 1.
    pub growth: f64,
}

/// Place of a level in the table, and its mapping from positions to cells.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GridLevelGeometry {
    /// Stride of a dense index, in cells per axis.
    pub resolution: u32,
    /// `position = x' * scale + 0.5`, in cells, for x' in the unit cube.
    pub scale: f64,
    /// The level's first entry in the table of all levels.
    #[serde(skip)]
    pub first: u32,
    /// The level's number of entries.
    #[serde(rename = "entries")]
    pub count: u32,
    /// Whether cells are hashed to entries rather than numbered.
    pub hashed: bool,
}

impl GridLevelGeometry {
    /// The level in the form that kernels read.
    pub fn for_kernels(&self) -> GridLevel {
        GridLevel::new(self.scale, self.resolution, self.first, self.count, self.hashed)
    }
}

impl GridConfig {
    /// The geometry of every level, coarsest first, computed in f64.
    ///
    /// Meaningful only for a valid configuration. An invalid one gives saturated numbers, and never panics.
    pub fn levels_geometry(&self) -> Vec<GridLevelGeometry> {
        let largest = 1_u64 << self.log2_table.min(31);
        let mut first = 0_u32;
        let level_geometry = |level| {
            let scale = self.scale(level);
            let resolution = (scale.ceil() + 1.0) as u32;
            let dense = u64::from(resolution).saturating_pow(3);
            let count = dense.checked_next_multiple_of(8).unwrap_or(u64::MAX).min(largest) as u32;
            let geometry = GridLevelGeometry {
                scale,
                resolution,
                first,
                count,
                hashed: dense > u64::from(count),
            };
            first = first.saturating_add(count);
            geometry
        };
        (0..self.levels.min(MAX_LEVELS)).map(level_geometry).collect()
    }

    /// The levels in the form that kernels read, coarsest first.
    pub fn levels_for_kernels(&self) -> Vec<GridLevel> {
        self.levels_geometry().iter().map(GridLevelGeometry::for_kernels).collect()
    }

    /// Number of entries of all levels: the table has shape `[entries, features]`.
    pub fn entries(&self) -> usize {
        self.levels_geometry().iter().map(|level| level.count as usize).sum()
    }

    /// Number of values that encode a position, `levels * features`.
    pub fn width(&self) -> usize {
        (self.levels as usize).saturating_mul(self.features as usize)
    }

    /// The resolution of the finest level, in cells per axis.
    pub fn finest_resolution(&self) -> u32 {
        self.levels_geometry().last().map_or(0, |level| level.resolution)
    }

    fn scale(&self, level: u32) -> f64 {
        // powf and not powi: the reference's `growth ** level` is the C library's pow, too. A difference in the last
        // bit would change the ceil.
        self.base_resolution * self.growth.powf(f64::from(level)) - 1.0
    }

    /// Checks every field; `name` is the grid's own field in the scene's configuration.
    pub(super) fn check(&self, name: &str) -> Result<()> {
        let problem = |field: &str, reason| bad_config(format!("{name}.{field}"), reason);
        if !(1..=MAX_LEVELS).contains(&self.levels) {
            return problem("levels", format!("is {}, expected 1 to {MAX_LEVELS}", self.levels));
        }
        if !FEATURE_WIDTHS.contains(&self.features) {
            return problem("features", format!("is {}, expected 1, 2, 4 or 8", self.features));
        }
        if !(1..=MAX_LOG2_TABLE).contains(&self.log2_table) {
            let found = self.log2_table;
            return problem("log2_table", format!("is {found}, expected 1 to {MAX_LOG2_TABLE}"));
        }
        let base = self.base_resolution;
        if !(base.is_finite() && base >= MIN_BASE_RESOLUTION) {
            let reason =
                format!("is {base}, expected at least {MIN_BASE_RESOLUTION} cells per axis");
            return problem("base_resolution", reason);
        }
        if !(self.growth.is_finite() && self.growth >= 1.0) {
            return problem("growth", format!("is {}, expected at least 1", self.growth));
        }
        let widest = f64::from(MAX_RESOLUTION);
        if base > widest {
            return problem("base_resolution", format!("is {base}, expected at most {widest}"));
        }
        let finest = self.scale(self.levels - 1).ceil() + 1.0;
        if finest.is_nan() || finest > widest {
            let reason = format!(
                "is {}, which makes the finest of {} levels {finest} cells wide, more than \
                 {widest}, where f32 positions lose their fraction: lower growth, levels or \
                 base_resolution",
                self.growth, self.levels
            );
            return problem("growth", reason);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(levels: u32, log2_table: u32, base_resolution: f64, growth: f64) -> GridConfig {
        GridConfig { levels, features: 2, log2_table, base_resolution, growth }
    }

    /// The expected numbers are from `grid_levels` in tests/reference/reference.py, for the grid of the case `basic`.
    #[test]
    fn geometry_is_the_references() {
        let expected = [
            (7.0, 8, 0, 512, false),
            (12.6, 14, 512, 2048, true),
            (22.119_999_999_999_997, 24, 2560, 2048, true),
            (38.303_999_999_999_99, 40, 4608, 2048, true),
            (65.816_799_999_999_99, 67, 6656, 2048, true),
            (112.588_559_999_999_97, 114, 8704, 2048, true),
        ];
        let levels = grid(6, 11, 8.0, 1.7).levels_geometry();
        assert_eq!(levels.len(), expected.len());
        for (level, (scale, resolution, first, count, hashed)) in levels.iter().zip(expected) {
            assert!((level.scale - scale).abs() < 1e-12, "{level:?}");
            let found = (level.resolution, level.first, level.count, level.hashed);
            assert_eq!(found, (resolution, first, count, hashed));
        }
        assert_eq!(grid(6, 11, 8.0, 1.7).entries(), 10752);
    }

    #[test]
    fn dense_levels_are_rounded_up_to_eight() {
        let levels = grid(2, 19, 5.0, 2.0).levels_geometry();
        assert_eq!((levels[0].resolution, levels[0].count), (5, 128)); // 125 -> 128
        assert_eq!((levels[1].resolution, levels[1].count), (10, 1000));
        assert_eq!(levels[1].first, 128);
        assert!(!levels[0].hashed && !levels[1].hashed);
    }

    /// A table of exactly `resolution^3` entries is dense. With one more cell of resolution, it is hashed.
    #[test]
    fn hashed_begins_beyond_the_table() {
        assert!(!grid(1, 9, 8.0, 1.0).levels_geometry()[0].hashed);
        assert!(grid(1, 9, 8.5, 1.0).levels_geometry()[0].hashed);
    }

    #[test]
    fn fractional_base_resolution_rounds_up() {
        let level = grid(1, 19, 16.25, 1.0).levels_geometry()[0];
        assert_eq!((level.scale, level.resolution), (15.25, 17));
    }

    #[test]
    fn widest_grid_is_counted_without_overflow() {
        let grid = grid(32, 24, 1_048_000.0, 1.0);
        grid.check("color_grid").unwrap();
        assert_eq!(grid.entries(), 32 << 24);
        let last = grid.levels_geometry()[31];
        assert_eq!(last.first, 31 << 24);
        assert!(last.hashed);
    }

    #[test]
    fn unchecked_numbers_do_not_panic() {
        for growth in [f64::NAN, f64::INFINITY, -1e300, 0.0] {
            for base in [f64::NAN, f64::MAX, -5.0] {
                let grid = grid(u32::MAX, u32::MAX, base, growth);
                assert!(grid.check("color_grid").is_err());
                assert_eq!(grid.levels_geometry().len(), MAX_LEVELS as usize);
            }
        }
    }

    #[test]
    fn each_field_is_held_to_its_range() {
        type Change = fn(&mut GridConfig);
        let changes: [(&str, &str, Change); 13] = [
            ("levels", "1 to 32", |grid| grid.levels = 0),
            ("levels", "1 to 32", |grid| grid.levels = 33),
            ("features", "1, 2, 4 or 8", |grid| grid.features = 3),
            ("log2_table", "1 to 24", |grid| grid.log2_table = 0),
            ("log2_table", "1 to 24", |grid| grid.log2_table = 25),
            ("base_resolution", "0.5", |grid| grid.base_resolution = 0.0),
            ("base_resolution", "NaN", |grid| grid.base_resolution = f64::NAN),
            ("base_resolution", "1048576", |grid| grid.base_resolution = 1e7),
            ("growth", "at least 1", |grid| grid.growth = 0.9),
            ("growth", "at least 1", |grid| grid.growth = f64::NAN),
            ("growth", "inf", |grid| grid.growth = f64::INFINITY),
            ("growth", "1048576", |grid| grid.growth = 100.0),
            ("growth", "1048576", |grid| grid.growth = 1e300),
        ];
        for (field, text, change) in changes {
            let mut grid = grid(4, 11, 8.0, 1.7);
            grid.check("color_grid").unwrap();
            change(&mut grid);
            let error = grid.check("color_grid").unwrap_err().to_string();
            let start = format!("config field `color_grid.{field}`: ");
            assert!(error.starts_with(&start) && error.contains(text), "{error}");
        }
    }
}
