//! Splits a capture into blocks: parts of the ground, each with the photographs that look into it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, absolute};

use organza_core::camera::Target;
use organza_core::error::invalid;
use organza_core::scene::Placement;
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
    /// The work in each block: the part of all photographs' images that shows it, 0 to 1.
    pub work: Vec<f64>,
    /// Warnings.
    pub notes: Vec<String>,
}

/// What a photograph shows: places, and the indices of the points that lie there.
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
            return invalid(
                &dataset.path,
                "this is a block already: split the whole data set into more",
            );
        }
        let poses = poses.cameras()?;
        let cameras: Vec<_> = poses.iter().map(|pose| pose.camera.clone()).collect();
        let looks = looks(&cameras, &dataset.points);
        let all = looks.iter().flat_map(|look| &look.places);
        let mut all: Vec<_> = all.map(|[x, y, _]| [*x, *y]).collect();
        let extent = [0, 1].map(|axis| extent(&mut all, axis));
        // what stands in a row has no width of its own
        let [x, y] = extent.map(|length| length.max(extent[0].max(extent[1]) / count as f64));
        let border = BORDER * (x * y / count as f64).sqrt();
        let mut notes = Vec::new();
        let mut sides = Vec::new();
        cut(&mut all, [[None; 2]; 2], count, &mut sides, &mut notes);
        let shares: Vec<_> =
            cameras.iter().zip(&looks).map(|of| shares(of, &sides, border)).collect();
        let taken = |block: usize| {
            let takes = |share: &[f64]| {
                let best =
                    (0..count).fold(0, |best, at| if share[at] > share[best] { at } else { best });
                block == best || share[block] >= MIN_SHARE
            };
            (0..cameras.len()).filter(|&camera| takes(&shares[camera])).collect::<Vec<_>>()
        };
        let taken: Vec<_> = (0..count).map(taken).collect();
        let trains = |of: &Vec<usize>| of.iter().any(|&camera| !poses[camera].held_out);
        if let Some(block) = taken.iter().position(|of| !trains(of)) {
            let name = Block::name(block);
            let reason = format!(
                "no photograph to train on looks into {name} of {count}; take fewer `--blocks`, or hold out fewer photographs"
            );
            return invalid(&dataset.path, reason);
        }
        notes.extend(doubts(&cameras, &taken, &sides));
        let block = |(index, sides): (usize, &Sides)| Block {
            split: String::new(),
            index,
            blocks: count,
            data: absolute(&dataset.path).unwrap_or_else(|_| dataset.path.clone()),
            placement: dataset.placement,
            sides: *sides,
            border,
            frames: taken[index]
                .iter()
                .filter_map(|&camera| cameras[camera].file_path.clone())
                .collect(),
        };
        let mut blocks: Vec<_> = sides.iter().enumerate().map(block).collect();
        let told =
            |block: &Block| format!("{:?}{:?}{:?}", block.placement, block.sides, block.frames);
        let split = blocks.iter().fold(Sha256::new(), |hash, block| hash.chain_update(told(block)));
        let split = digits(split, 16);
        blocks.iter_mut().for_each(|block| block.split.clone_from(&split));
        let points = |(sides, taken): (&Sides, &Vec<usize>)| {
            let inside = (0..dataset.points.len())
                .filter(|&point| is_within(*sides, border, dataset.points[point].position));
            let shown = taken.iter().flat_map(|&camera| looks[camera].points.iter().copied());
            inside.chain(shown).collect::<BTreeSet<_>>().into_iter().collect()
        };
        let points = sides.iter().zip(&taken).map(points).collect();
        let work = (0..count).map(|block| {
            let own = |look: &&Look| {
                look.places.iter().filter(|place| is_within(sides[block], 0.0, **place)).count()
            };
            looks.iter().map(|look| own(&look)).sum::<usize>() as f64 / all.len().max(1) as f64
        });
        let work = work.collect();
        Ok(Self { blocks, cameras: taken, points, work, notes })
    }

    /// Writes a block's files to its folder, which exists. `points` and `placement` are the data set's.
    ///
    /// # Errors
    /// [`Error::WriteFile`](organza_core::Error::WriteFile).
    pub fn save(
        &self,
        index: usize,
        folder: &Path,
        points: &[Point],
        placement: &Placement,
    ) -> Result<()> {
        let points = self.points[index].iter().map(|&point| {
            let Point { position, color } = points[point];
            Point { position: placement.world(position), color }
        });
        let points: Vec<_> = points.collect();
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
            let ray = |at: usize| {
                let [x, y] = [at % CELLS, at / CELLS].map(|at| (at as f64 + 0.5) / CELLS as f64);
                camera.ray([x * f64::from(camera.width), y * f64::from(camera.height)])
            };
            let places = (0..CELLS * CELLS).map(ray).flat_map(|ray| {
                DISTANCES.map(|times| {
                    (ray * times * distance + glam::DVec3::from(camera.eye())).to_array()
                })
            });
            return Look { places: places.collect(), points: Vec::new() };
        }
        let mut nearest = BTreeMap::new();
        for (index, point) in points.iter().enumerate().step_by(stride) {
            let Some([column, row, depth]) = camera.project(point.position) else { continue };
            let found = nearest.entry(cell(camera, [column, row])).or_insert((depth, index));
            if depth < found.0 {
                *found = (depth, index);
            }
        }
        let points_of: Vec<_> = nearest.into_values().map(|(_, index)| index).collect();
        let places = points_of.iter().map(|&index| points[index].position).collect();
        Look { places, points: points_of }
    };
    cameras.par_iter().map(look).collect()
}

/// The part of a photograph's places that lies in each block or its border. A photograph that shows no point counts where it was taken.
fn shares((camera, look): (&Camera, &Look), sides: &[Sides], border: f64) -> Vec<f64> {
    let eye = [camera.eye()];
    let places = if look.places.is_empty() { &eye[..] } else { &look.places };
    let share = |sides: &Sides| {
        places.iter().filter(|place| is_within(*sides, border, **place)).count() as f64
            / places.len() as f64
    };
    sides.iter().map(share).collect()
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
            assert!(!places.iter().any(|place| twice(place)), "{sides:?}");
        }
    }
}
