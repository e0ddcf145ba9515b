//! A shard of a scene: some of its Gaussians, and all of its fields.

use std::collections::HashMap;
use std::io::{BufReader, Read, Seek};
use std::ops::Range;
use std::path::Path;

use super::file::{check_declared, count_gaussians, read_config};
use super::tensor_file::Header;
use super::tensors::TensorSpec;
use super::validate::check_sizes;
use crate::input::open_regular;
use crate::{Result, Scene};
use muslin_device::memory;

/// Number of Gaussians in a block. A scene is cut into blocks by index, and each rank has whole blocks. So rounding
/// does not depend on the number of ranks.
pub const GAUSSIANS_PER_BLOCK: usize = 1 << 14;

/// The Gaussians of one rank, and the fields of the scene.
///
/// ```
/// use organza_core::demo;
/// use organza_core::scene::SceneShard;
///
/// let scene = demo::scene();
/// let [first, second] = [0, 1].map(|rank| SceneShard::new(&scene, rank, 2));
/// assert_eq!((first.range.start, first.range.end), (0, second.range.start));
/// assert_eq!(second.range.end, scene.gaussians.len());
/// assert_eq!(first.scene.gaussians.len() + second.scene.gaussians.len(), scene.gaussians.len());
/// ```
#[derive(Clone, Debug)]
pub struct SceneShard {
    /// The configuration, the fields, and the shard's Gaussians. With more ranks than blocks, some have no Gaussians.
    pub scene: Scene,
    /// Indices of the shard's Gaussians in the whole scene.
    pub range: Range<usize>,
    /// Number of Gaussians in the whole scene.
    pub gaussians: usize,
}

impl SceneShard {
    /// The shard of a rank, from a scene in memory.
    #[must_use]
    pub fn new(scene: &Scene, rank: usize, ranks: usize) -> Self {
        let gaussians = scene.gaussians.len();
        let range = range_of(gaussians, rank, ranks);
        let indices: Vec<_> = range.clone().collect();
        let scene = Scene {
            config: scene.config.clone(),
            gaussians: scene.gaussians.select(&indices),
            color: scene.color.clone(),
            transmittance: scene.transmittance.clone(),
        };
        Self { scene, range, gaussians }
    }

    /// Reads the shard of a rank from a scene file, and nothing more. A tensor of the whole file may be larger than
    /// kernels can address.
    ///
    /// # Errors
    /// The same errors as [`Scene::load`], for the shard.
    pub fn load(path: impl AsRef<Path>, rank: usize, ranks: usize) -> Result<Self> {
        let path = path.as_ref();
        let (file, length) = open_regular(path)?;
        let mut reader = BufReader::new(file);
        Self::read_with(&mut reader, (length, path), (rank, ranks), [], None)
            .map(|(shard, ..)| shard)
    }

    /// Like [`SceneShard::load`], from a reader of `length` bytes that errors name `origin`. Also reads other data of the
    /// same Gaussians: scenes of the same shape, whose tensors' names have these prefixes, and the rows of another tensor,
    /// given its name and width.
    pub fn read_with<const P: usize>(
        reader: &mut (impl Read + Seek),
        (length, origin): (u64, &Path),
        (rank, ranks): (usize, usize),
        prefixes: [&str; P],
        other: Option<(&str, usize)>,
    ) -> Result<(Self, [Scene; P], Vec<f32>)> {
        let header = Header::read(reader, length, origin)?;
        let config = read_config(&header, origin)?;
        let gaussians = count_gaussians(&header, &config, origin)?;
        for prefix in [""].iter().chain(&prefixes) {
            for mut spec in config.tensors(gaussians) {
                spec.name.insert_str(0, prefix);
                check_declared(&header, &spec, origin)?;
            }
        }
        if let Some((name, width)) = other {
            let shape = vec![gaussians, width];
            let why = "a row for each Gaussian";
            check_declared(&header, &TensorSpec { name: name.to_owned(), shape, why }, origin)?;
        }
        let range = range_of(gaussians, rank, ranks);
        check_sizes(config.tensors(range.len()).iter(), origin)?;
        // every tensor allocated here is declared in the file, so no header can request more memory than the file is long
        let mut scene = Scene::zeros(config, range.len())?;
        let mut more = prefixes.map(|_| scene.clone());
        let width = other.map_or(0, |(_, width)| width);
        let mut rows = memory::zeros(range.len() * width, "rows of a shard")?;
        let mut targets = HashMap::new();
        for (prefix, scene) in
            [("", &mut scene)].into_iter().chain(prefixes.into_iter().zip(&mut more))
        {
            for (spec, values) in scene.tensors_mut() {
                let is_row = spec.name.starts_with("gaussians.");
                let row = if is_row { values.len() / range.len().max(1) } else { 0 };
                targets.insert(format!("{prefix}{}", spec.name), (row * range.start, values));
            }
        }
        if let Some((name, width)) = other {
            targets.insert(name.to_owned(), (width * range.start, &mut rows));
        }
        header.read_ranges(reader, targets, origin)?;
        if !range.is_empty() {
            scene.validate_at(origin)?;
        }
        Ok((Self { scene, range, gaussians }, more, rows))
    }
}

/// The Gaussians of a rank: whole blocks, distributed as evenly as possible.
pub fn range_of(gaussians: usize, rank: usize, ranks: usize) -> Range<usize> {
    let blocks = gaussians.div_ceil(GAUSSIANS_PER_BLOCK);
    let begin = |rank: usize| (blocks * rank / ranks * GAUSSIANS_PER_BLOCK).min(gaussians);
    begin(rank)..begin(rank + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranks_split_all_gaussians_in_whole_blocks() {
        for (gaussians, ranks) in [
            (1, 1),
            (1, 3),
            (GAUSSIANS_PER_BLOCK, 2),
            (10 * GAUSSIANS_PER_BLOCK + 5, 4),
            (100_000_000, 64),
        ] {
            let ranges: Vec<_> = (0..ranks).map(|rank| range_of(gaussians, rank, ranks)).collect();
            assert_eq!((ranges[0].start, ranges[ranks - 1].end), (0, gaussians));
            assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(
                ranges
                    .iter()
                    .all(|range| range.is_empty() || range.start % GAUSSIANS_PER_BLOCK == 0)
            );
            let lengths = ranges.iter().map(|range| range.len().div_ceil(GAUSSIANS_PER_BLOCK));
            let least = lengths.clone().min().unwrap();
            let most = lengths.max().unwrap();
            assert!(most - least <= 1, "{gaussians} for {ranks}: {least} to {most} blocks");
        }
    }

    #[test]
    fn a_shard_that_is_read_is_that_of_the_whole_scene() {
        let mut scene = crate::demo::scene();
        let len = scene.gaussians.len();
        let indices: Vec<_> = (0..GAUSSIANS_PER_BLOCK + 10).map(|index| index * 7 % len).collect();
        scene.gaussians = scene.gaussians.select(&indices);
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.safetensors");
        scene.save(&path).expect("a file");
        let mut found = Vec::new();
        for rank in 0..3 {
            let shard = SceneShard::load(&path, rank, 3).expect("a shard");
            let expected = SceneShard::new(&scene, rank, 3);
            assert_eq!(
                (&shard.range, shard.gaussians),
                (&expected.range, GAUSSIANS_PER_BLOCK + 10)
            );
            assert!(shard.scene == expected.scene, "rank {rank}");
            found.extend(shard.scene.gaussians.opacity);
        }
        assert!(found == scene.gaussians.opacity);
    }
}
