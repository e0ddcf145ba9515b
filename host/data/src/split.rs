//! Splits a capture into blocks: parts of the ground, each with the photographs that look into it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, absolute};

use glam::DVec3;
use organza_core::camera::Target;
use organza_core::error::invalid;
use organza_core::{Camera, Result};
use rayon::prelude::*;
use sha2::{Digest as _, Sha256};

use super::block::{Block, POINTS, is_within};
use super::fingerprint::digits;
use super::{Point, Poses, ply};

/// A photograph is divided into so many columns and rows, in which the nearest point counts.
const CELLS: usize = 16;
/// Most points that are looked at: others are left out evenly.
const MAX_POINTS: usize = 100_000;
/// Part of a photograph that must show a block, so that the block takes it.
const MIN_SHARE: f64 = 0.1;
/// The border of a block, as a part of the side of a mean block.
const BORDER: f64 = 0.1;
/// Part of the places that is left out at each end of an axis, so that a few far ones do not matter.
const LEFT_OUT: f64 = 0.05;
/// A gap that is wider than this part of all places' extent separates two captures.
const WIDE: f64 = 0.5;
/// With more than this part of the photographs in each block, a split saves no time.
const NEARLY_ALL: f64 = 0.9;
/// Distances of the places that a ray sees where there are no points, as multiples of the cameras' typical distance.
const DISTANCES: [f64; 3] = [0.5, 1.0, 1.5];

/// A capture in blocks.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Split {
    /// The blocks, in their order.
    pub blocks: Vec<Block>,
    /// The cameras of each block, as indices of [`Poses::cameras`].
    pub cameras: Vec<Vec<usize>>,
    /// The points of each block, as indices of the data set's points: all in the block and in its border, and elsewhere those that
    /// its photographs show.
    pub points: Vec<Vec<usize>>,
    /// Warnings.
    pub notes: Vec<String>,
}

/// What a photograph shows: places, and the indices of the points that lie at a quarter of them, if there are points.
struct Look {
    places: Vec<[f64; 3]>,
    points: Vec<usize>,
}

type Sides = [[Option<f64>; 2]; 2];

impl Split {
    /// Splits a data set into `count` blocks, 2 or more, of about equal work. The data set has its own placement, so that the ground is x
    /// and y.
    ///
    /// # Errors
    /// [`Error::Invalid`](organza_core::Error::Invalid) for a block without a photograph, or for a data set that is a block.
    pub fn new(poses: &Poses, count: usize) -> Result<Self> {
        let dataset = &poses.dataset;
        if dataset.block.is_some() {
            return invalid(&dataset.path, "this is a block already: split its whole data set");
        }
        let poses = poses.cameras()?;
        let cameras: Vec<_> = poses.iter().map(|pose| pose.camera.clone()).collect();
        let looks = looks(&cameras, &dataset.points);
        let places = looks.iter().flat_map(|look| &look.places);
        let mut places: Vec<_> = places.map(|[x, y, _]| [*x, *y]).collect();
        let lengths = [0, 1].map(|axis| extent(&mut places, axis));
        // what stands in a row has no width of its own
        let least = lengths[0].max(lengths[1]) / count as f64;
        let area: f64 = lengths.iter().map(|length| length.max(least)).product();
        let border = BORDER * (area / count as f64).sqrt();
        let mut notes = Vec::new();
        let mut sides = Vec::new();
        cut(&mut places, [[None; 2]; 2], count, &mut sides, &mut notes);
        let taken = photographs(&cameras, &looks, &sides);
        let trains = |of: &Vec<usize>| of.iter().any(|&camera| !poses[camera].held_out);
        if let Some(block) = taken.iter().position(|of| !trains(of)) {
            let name = Block::name(block);
            let reason = format!(
                "no photograph to train on looks into {name} of {count}; take fewer `--blocks`, or hold out fewer photographs"
            );
            return invalid(&dataset.path, reason);
        }
        notes.extend(doubts(&cameras, &taken, &sides));
        let points = |(sides, taken): (&Sides, &Vec<usize>)| {
            let is_inside = |point: &Point| is_within(*sides, border, point.position);
            let all = dataset.points.iter().enumerate();
            let inside = all.filter(|(_, point)| is_inside(point)).map(|(index, _)| index);
            let shown = taken.iter().flat_map(|&camera| looks[camera].points.iter().copied());
            inside.chain(shown).collect::<BTreeSet<_>>().into_iter().collect()
        };
        let points = sides.iter().zip(&taken).map(points).collect();
        let names = |of: &Vec<usize>| {
            of.iter().filter_map(|&camera| cameras[camera].file_path.clone()).collect()
        };
        let block = |(index, sides): (usize, Sides)| Block {
            split: String::new(),
            index,
            blocks: count,
            data: absolute(&dataset.path).unwrap_or_else(|_| dataset.path.clone()),
            placement: dataset.placement,
            sides,
            border,
            frames: names(&taken[index]),
        };
        let mut blocks: Vec<_> = sides.iter().copied().enumerate().map(block).collect();
        let told = |of: &Block| format!("{:?}{:?}{:?}", of.placement, of.sides, of.frames);
        let hash = blocks.iter().fold(Sha256::new(), |hash, block| hash.chain_update(told(block)));
        let split = digits(hash, 16);
        blocks.iter_mut().for_each(|block| block.split.clone_from(&split));
        Ok(Self { blocks, cameras: taken, points, notes })
    }

    /// Writes a block's files to its folder, which exists. `poses` is the data set that was split.
    ///
    /// # Errors
    /// [`Error::WriteFile`](organza_core::Error::WriteFile).
    pub fn save(&self, index: usize, folder: &Path, poses: &Poses) -> Result<()> {
        let dataset = &poses.dataset;
        let in_world = |&point: &usize| {
            let Point { position, color } = dataset.points[point];
            Point { position: dataset.placement.world(position), color }
        };
        let points: Vec<_> = self.points[index].iter().map(in_world).collect();
        if !points.is_empty() {
            ply::write(&folder.join(POINTS), &points)?;
        }
        self.blocks[index].save(folder)
    }
}

/// What each photograph shows: in each cell of its image, the nearest point. So walls hide what is behind them. Without points, places
/// along rays.
fn looks(cameras: &[Camera], points: &[Point]) -> Vec<Look> {
    let stride = points.len().div_ceil(MAX_POINTS).max(1);
    let distance = Target::from_cameras(cameras).distance;
    let cell = |camera: &Camera, [column, row]: [f64; 2]| {
        let at = |place: f64, side: u32| (place / f64::from(side) * CELLS as f64) as usize;
        [at(row, camera.height), at(column, camera.width)]
    };
    let look = |camera: &Camera| {
        if points.is_empty() {
            let eye = DVec3::from(camera.eye());
            let along = |at: usize| {
                let [x, y] = [at % CELLS, at / CELLS].map(|at| (at as f64 + 0.5) / CELLS as f64);
                let ray = camera.ray([x * f64::from(camera.width), y * f64::from(camera.height)]);
                DISTANCES.map(|times| (eye + times * distance * ray).to_array())
            };
            let places = (0..CELLS * CELLS).flat_map(along).collect();
            return Look { places, points: Vec::new() };
        }
        let mut nearest = BTreeMap::new();
        for (index, point) in points.iter().enumerate().step_by(stride) {
            let Some([column, row, depth]) = camera.project(point.position) else { continue };
            let found = nearest.entry(cell(camera, [column, row])).or_insert((depth, index));
            if depth < found.0 {
                *found = (depth, index);
            }
        }
        let places = nearest.values().map(|(_, index)| points[*index].position).collect();
        let coarse = nearest.iter().filter(|([row, column], _)| row % 2 + column % 2 == 0);
        Look { places, points: coarse.map(|(_, (_, index))| *index).collect() }
    };
    cameras.par_iter().map(look).collect()
}

/// The photographs of each block: those of which it fills enough, and those that show it most. A photograph that shows no point counts where
/// it was taken.
fn photographs(cameras: &[Camera], looks: &[Look], sides: &[Sides]) -> Vec<Vec<usize>> {
    let mut taken = vec![Vec::new(); sides.len()];
    for (index, (camera, look)) in cameras.iter().zip(looks).enumerate() {
        let eye = [camera.eye()];
        let places = if look.places.is_empty() { &eye[..] } else { &look.places };
        let shown =
            |sides: &Sides| places.iter().filter(|place| is_within(*sides, 0.0, **place)).count();
        let shown: Vec<_> = sides.iter().map(shown).collect();
        let most = shown.iter().max();
        let first = shown.iter().position(|part| Some(part) == most);
        for (block, part) in shown.iter().enumerate() {
            if Some(block) == first || *part as f64 >= MIN_SHARE * places.len() as f64 {
                taken[block].push(index);
            }
        }
    }
    taken
}

/// The length along an axis of most of the places, which are sorted.
fn extent(places: &mut [[f64; 2]], axis: usize) -> f64 {
    places.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let out = (LEFT_OUT * places.len() as f64) as usize;
    let ends = places.get(out).zip(places.get(places.len().saturating_sub(1 + out)));
    ends.map_or(0.0, |(first, last)| last[axis] - first[axis])
}

/// Cuts a part of the ground into `count` blocks: in two along its longer axis, and these again. A wide gap is where it is cut.
fn cut(
    places: &mut [[f64; 2]],
    sides: Sides,
    count: usize,
    found: &mut Vec<Sides>,
    notes: &mut Vec<String>,
) {
    if count == 1 {
        found.push(sides);
        return;
    }
    let lengths = [0, 1].map(|axis| extent(places, axis));
    let axis = usize::from(lengths[1] > lengths[0]);
    extent(places, axis);
    let len = places.len();
    let out = (LEFT_OUT * len as f64) as usize;
    let gap = |at: &usize| places[*at][axis] - places[*at - 1][axis];
    let widest = (out.max(1)..len.saturating_sub(out)).max_by(|a, b| gap(a).total_cmp(&gap(b)));
    let gap = widest.filter(|at| gap(at) > WIDE * lengths[axis]).map(|at| (at, gap(&at)));
    let (at, first) = match gap {
        Some((at, width)) => {
            let part = at as f64 / len as f64;
            notes.push(format!(
                "the capture lies in two places with a gap of {:.0}% of its length between them, where it is cut: {:.0}% and {:.0}% of the \
                 work; nothing joins them, so look whether they are one world",
                100.0 * width / lengths[axis],
                100.0 * part,
                100.0 * (1.0 - part)
            ));
            (at, ((part * count as f64).round() as usize).clamp(1, count - 1))
        }
        None => (len * (count / 2) / count, count / 2),
    };
    let place = |at: usize| places.get(at).map_or(0.0, |place| place[axis]);
    let border = (place(at.saturating_sub(1)) + place(at)) / 2.0;
    let (before, after) = places.split_at_mut(at);
    let side = |end: usize| {
        let mut sides = sides;
        sides[end][axis] = Some(border);
        sides
    };
    cut(before, side(1), first, found, notes);
    cut(after, side(0), count - first, found, notes);
}

/// Warnings of a capture that a split does not suit.
fn doubts(cameras: &[Camera], taken: &[Vec<usize>], sides: &[Sides]) -> Vec<String> {
    let mut notes = Vec::new();
    let all = cameras.len();
    let from = sides
        .iter()
        .position(|sides| cameras.iter().all(|camera| is_within(*sides, 0.0, camera.eye())));
    if let Some(block) = from {
        let name = Block::name(block);
        notes.push(format!(
            "all {all} cameras stand in {name}: the other blocks are only seen from there, so training on the whole capture is as good"
        ));
    }
    let sum: usize = taken.iter().map(Vec::len).sum();
    if sum as f64 >= NEARLY_ALL * (taken.len() * all) as f64 {
        notes.push(format!(
            "this capture needs no split: each block needs nearly all of the {all} photographs, so {} blocks take {} times the time",
            taken.len(),
            taken.len()
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places in a row fall into equal parts, each into one, and a gap is cut where it is.
    #[test]
    fn ground_is_cut_into_equal_parts() {
        let row = |places: &mut dyn Iterator<Item = usize>| -> Vec<[f64; 2]> {
            places.map(|at| [0.1 * (at % 3) as f64, at as f64]).collect()
        };
        let even = row(&mut (0..300));
        // three quarters, and far from them a quarter
        let apart = row(&mut (0..300).map(|at| if at < 225 { at } else { at + 1000 }));
        for (places, count, expected, noted) in [
            (&even, 3, [100, 100, 100].as_slice(), false),
            (&even, 4, &[75, 75, 75, 75], false),
            (&even, 5, &[60, 60, 60, 60, 60], false),
            (&apart, 4, &[75, 75, 75, 75], true),
            (&apart, 2, &[225, 75], true),
        ] {
            let mut sides = Vec::new();
            let mut notes = Vec::new();
            cut(&mut places.clone(), [[None; 2]; 2], count, &mut sides, &mut notes);
            let inside = |sides: &Sides| {
                places.iter().filter(|[x, y]| is_within(*sides, 0.0, [*x, *y, 0.0])).count()
            };
            let found: Vec<_> = sides.iter().map(inside).collect();
            assert_eq!((&found[..], !notes.is_empty()), (expected, noted), "{count}");
            let twice = |[x, y]: &[f64; 2]| {
                sides.iter().filter(|sides| is_within(**sides, 0.0, [*x, *y, 0.0])).count() != 1
            };
            assert!(!places.iter().any(twice), "{sides:?}");
        }
    }
}
