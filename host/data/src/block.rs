//! A block of a capture: a data set that takes some of another one's photographs. [`Split`](super::Split) makes blocks.

use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};

#[cfg(doc)]
use organza_core::Error;
use organza_core::error::invalid;
use organza_core::input::read_json;
use organza_core::scene::{Contraction, Ground, Place, Placement, Scene, SceneConfig};
use organza_core::{Result, write_inside};
use serde::{Deserialize, Serialize};

use super::{Layout, Poses, folder_of, ply};

/// The file that makes a folder a block.
pub const BLOCK: &str = "block.json";
/// The points to start from, beside it.
pub(super) const POINTS: &str = "points.ply";
/// Most blocks that are named as missing.
const MAX_NAMED: usize = 8;
/// What the folder of a block and of its run is called, before its number.
const NAME: &str = "block-";

/// A block of a capture that was split: a part of the ground, and the photographs that look into it. Its Gaussians are those whose
/// centers lie above or below this part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Block {
    /// Identifies the split.
    pub split: String,
    /// Its number, from 0.
    pub index: usize,
    /// Number of blocks of the split.
    pub blocks: usize,
    /// The data set that was split.
    pub data: PathBuf,
    /// The coordinates of `sides`: x and y lie on the ground.
    pub placement: Placement,
    /// Lowest x and y, and highest ones. `None` is open: nothing of the capture lies beyond.
    pub sides: [[Option<f64>; 2]; 2],
    /// How far training looks beyond the sides, so that neighbors agree there.
    pub border: f64,
    /// Names of the frames that look into the block.
    pub frames: Vec<String>,
}

impl Block {
    /// The name of the folder of the block with this number, and of its run.
    #[must_use]
    pub fn name(index: usize) -> String {
        format!("{NAME}{index}")
    }

    /// Reads a block from its folder.
    ///
    /// # Errors
    /// [`Error::ReadFile`], [`Error::BadJson`], or [`Error::Invalid`] for a file that says something else.
    pub fn load(folder: &Path) -> Result<Self> {
        let file = folder.join(BLOCK);
        let block = serde_json::from_value::<Self>(read_json(&file)?);
        let block = block
            .or_else(|error| invalid(&file, format!("this is no block of a split: {error}")))?;
        Placement::from_json(&serde_json::json!(block.placement), &file)?;
        match block.index < block.blocks {
            true => Ok(block),
            false => invalid(&file, format!("block {} of {}", block.index, block.blocks)),
        }
    }

    /// Writes the block to a folder.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn save(&self, folder: &Path) -> Result<()> {
        write_inside(folder.join(BLOCK), |writer| Ok(serde_json::to_writer_pretty(writer, self)?))
    }

    /// The blocks in a folder, or the finished runs of blocks, in their order; `None` if it has none.
    ///
    /// # Errors
    /// [`Error::Invalid`] if one is missing, or belongs to another split; the errors of [`Self::load`].
    pub fn all_in(folder: &Path) -> Result<Option<Vec<(PathBuf, Self)>>> {
        let mut found = Vec::<(PathBuf, Self)>::new();
        for path in fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
            if path.join(BLOCK).exists() {
                let block = Self::load(&path)?;
                found.push((path, block));
            }
        }
        found.sort_by(|(a, one), (b, other)| (one.index, a).cmp(&(other.index, b)));
        let Some((first, Self { split, blocks, .. })) = found.first() else { return Ok(None) };
        if let Some((path, _)) = found.iter().find(|(_, block)| block.split != *split) {
            let reason = format!(
                "this is a block of another split than {}: move one of them away",
                first.display()
            );
            return invalid(path, reason);
        }
        if let Some(pair) = found.windows(2).find(|pair| pair[0].1.index == pair[1].1.index) {
            let other = pair[0].0.display();
            return invalid(
                &pair[1].0,
                format!("{other} is the same block: move one of them away"),
            );
        }
        let is_missing = |index: &usize| found.iter().all(|(_, block)| block.index != *index);
        let missing = (0..*blocks).filter(is_missing).map(Self::name);
        let named = missing.take(MAX_NAMED).collect::<Vec<_>>().join(", ");
        match blocks.saturating_sub(found.len()) {
            0 => Ok(Some(found)),
            count => invalid(
                folder,
                format!(
                    "{count} of the {blocks} blocks of this split are missing or not finished: {named}"
                ),
            ),
        }
    }

    /// Whether a place of the world belongs to the block. Each place belongs to one block of a split.
    #[must_use]
    pub fn has(&self, place: [f64; 3]) -> bool {
        is_within(self.sides, 0.0, self.placement.own(place))
    }

    /// Where the block's scene shows the world best.
    #[must_use]
    pub fn ground(&self) -> Ground {
        let Self { placement, sides, border, .. } = *self;
        Ground { placement, sides, border, motions: BTreeMap::new() }
    }

    /// Removes the Gaussians that belong to other blocks.
    ///
    /// # Errors
    /// [`Error::Invalid`] if none is left.
    pub fn crop(&self, scene: &mut Scene) -> Result<()> {
        let world = scene.config.placement;
        let all = scene.gaussians.position.iter().map(|place| place.map(f64::from));
        let kept = all.enumerate().filter(|(_, place)| self.has(world.world(*place)));
        let kept: Vec<_> = kept.map(|(index, _)| index).collect();
        if kept.is_empty() {
            let name = Self::name(self.index);
            return invalid(
                name,
                "no Gaussian lies in the block: its photographs show nothing there",
            );
        }
        scene.gaussians = scene.gaussians.select(&kept);
        Ok(())
    }

    /// Gives a new scene the block with its border as its box, and contracts what is outside.
    ///
    /// # Errors
    /// The same errors as [`Placement::place`].
    pub fn bound(&self, config: &mut SceneConfig) -> Result<()> {
        let world = Place { same_world: true, ..Place::default() };
        let place = self.placement.place(&config.placement, &world)?;
        let mut inner = place.world_box(config.aabb);
        for axis in 0..2 {
            let [low, high] = self.sides.map(|side| side[axis]);
            let low = low.map_or(inner[0][axis], |low| inner[0][axis].max(low - self.border));
            let high = high.map_or(inner[1][axis], |high| inner[1][axis].min(high + self.border));
            // what the photographs show may lie beside the block
            if low < high {
                inner[0][axis] = low;
                inner[1][axis] = high;
            }
        }
        config.aabb = place.own_box(inner);
        config.contraction = Contraction::Cube;
        Ok(())
    }

    /// The placement of the block's scene: that of its cameras, with the axes of the split.
    pub(super) fn aligned(&self, own: Placement) -> Placement {
        let Placement { up, right, .. } = self.placement;
        Placement { up, right, ..own }
    }
}

/// Whether a place lies between sides that are moved outward by `border`.
pub(super) fn is_within(sides: [[Option<f64>; 2]; 2], border: f64, place: [f64; 3]) -> bool {
    let [low, high] = sides;
    (0..2).all(|axis| {
        low[axis].is_none_or(|low| place[axis] >= low - border)
            && high[axis].is_none_or(|high| place[axis] < high + border)
    })
}

/// Lists a block: the frames of its data set that it names, and its own points.
pub(super) fn list(poses: &mut Poses, folder: &Path) -> Result<()> {
    let block = Block::load(folder)?;
    let file = folder.join(BLOCK);
    let data = folder_of(&block.data);
    if !data.exists() {
        let data = data.display();
        let reason = format!(
            "the data set that was split is no longer at {data}; if it has moved, write its new place to `data`"
        );
        return invalid(file, reason);
    }
    if matches!(Layout::detect(&data), Some(Layout::Block(_))) {
        return invalid(file, "its data set is a block itself; split the whole data set again");
    }
    let mut whole = Poses::new(&data, &poses.options)?;
    super::list(&mut whole)?;
    let names: HashSet<_> = block.frames.iter().collect();
    whole.shots.retain(|shot| names.contains(&shot.name));
    let left_out = names.len() > whole.shots.len();
    if whole.shots.is_empty() {
        let reason = format!(
            "none of the block's {} photographs is in {}: split it again",
            names.len(),
            data.display()
        );
        return invalid(file, reason);
    }
    let points = folder.join(POINTS);
    let mut dataset = whole.dataset;
    dataset.path = folder.to_owned();
    dataset.points = if points.exists() { ply::read(&points)? } else { Vec::new() };
    dataset.points_file = Some(points).filter(|points| points.exists());
    if !left_out {
        dataset.missing.clear();
    }
    dataset.block = Some(block);
    let options = std::mem::take(&mut poses.options);
    *poses = Poses { dataset, bad: Vec::new(), options, ..whole };
    Ok(())
}
