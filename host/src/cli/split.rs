//! `organza split`: a capture that is larger than a machine, in blocks.

use std::fs;
use std::path::PathBuf;

use organza::data::{Block, DatasetOptions, Pose, Poses, Split};
use organza::train::REPORT;
use organza::train::config::PIXELS_PER_GAUSSIAN;
use organza::train::report::write_split_report;
use organza::{Camera, Error, Result};

use super::console::Console;
use super::inputs::{FileKind, told_apart};
use super::output::Folder;
use super::summary::{count, grouped};
use super::{quoted, refuse};

const EXAMPLES: &str = "\
Examples:
  organza split data/town -o blocks --blocks 4
  organza split data/town -o blocks --gaussians-per-block 300000
  organza train blocks -o runs                 one after the other; the same command continues
  organza train blocks/block-2 -o runs/block-2 on another machine
  organza render runs -o images                all blocks as one scene

A block is a part of the ground, and the photographs that look into it. All blocks have about the same work. A block is a data set: \
its folder names photographs of DATA, and copies none. What lies beyond the block is trained along, coarsely. Where blocks are shown \
together, each counts where it shows its own part of the ground. report.html shows the blocks from above.";

/// Split a capture that is larger than a machine into blocks, to train one after the other or on many machines
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The data set: a folder of nerfstudio, Blender or COLMAP, or a transforms.json
    data: PathBuf,
    /// The folder for the blocks; created if it does not exist
    #[arg(short, long, value_name = "BLOCKS")]
    output: PathBuf,
    /// Number of blocks
    #[arg(long, value_name = "N", required_unless_present = "gaussians_per_block")]
    #[arg(value_parser = clap::value_parser!(u32).range(2..=10_000))]
    blocks: Option<u32>,
    /// As many blocks as are needed with this many Gaussians in each: the capture has one for each of its points, or for 500 pixels
    #[arg(long, value_name = "N", conflicts_with = "blocks")]
    #[arg(value_parser = clap::value_parser!(u32).range(1000..))]
    gaussians_per_block: Option<u32>,
    /// Read files that the data set names outside its own folder, by path or by link
    #[arg(long)]
    allow_outside: bool,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let options = DatasetOptions { allow_outside: args.allow_outside, ..DatasetOptions::default() };
    let poses = Poses::load(&args.data, &options);
    let poses = poses.map_err(|error| told_apart(error, &args.data, FileKind::DataSet))?;
    poses.dataset.notes.iter().for_each(|note| console.warn(note));
    let cameras = poses.cameras()?;
    let blocks = number_of_blocks(args, &poses, &cameras)?;
    let split = console.during("splitting", || Split::new(&poses, blocks))?;
    if fs::read_dir(&args.output).is_ok_and(|mut entries| entries.next().is_some()) {
        let output = args.output.display();
        return refuse(format!("{output} has files already; choose another folder"));
    }
    let mut folder = Folder::make(&args.output)?;
    folder.lock()?;
    let points = &poses.dataset.points;
    for block in &split.blocks {
        let path = folder.join(&Block::name(block.index));
        fs::create_dir(&path).map_err(|source| Error::write(&path, source))?;
        split.save(block.index, &path, &poses)?;
    }
    let seen: Vec<Camera> = cameras.into_iter().map(|pose| pose.camera).collect();
    write_split_report(&folder.file(REPORT)?, &split, &seen, points)?;
    split.notes.iter().for_each(|note| console.warn(note));
    let sizes = split.cameras.iter().map(|of| grouped(of.len() as u64)).collect::<Vec<_>>();
    let output = quoted(&args.output);
    console.note(&format!(
        "wrote {blocks} blocks to {}, with {} of {}; {} shows them from above\n\
         next: organza train {output} -o RUNS, then organza view RUNS",
        args.output.display(),
        sizes.join(", "),
        count(seen.len() as u64, "photograph"),
        folder.join(REPORT).display(),
    ));
    Ok(())
}

/// The number that is asked for, or that follows from the Gaussians.
fn number_of_blocks(args: &Args, poses: &Poses, cameras: &[Pose]) -> Result<usize> {
    let Some(per_block) = args.gaussians_per_block else {
        return Ok(args.blocks.unwrap_or(2) as usize);
    };
    let pixels = |pose: &Pose| f64::from(pose.camera.width) * f64::from(pose.camera.height);
    let pixels: f64 = cameras.iter().filter(|pose| !pose.held_out).map(pixels).sum();
    let all = (pixels / PIXELS_PER_GAUSSIAN).max(poses.dataset.points.len() as f64);
    let blocks = (all / f64::from(per_block)).ceil() as usize;
    match blocks {
        ..2 => refuse(format!(
            "this capture needs no split: it has about {} Gaussians, which one block of {} holds; train it as it is: `organza train {} -o RUN`",
            grouped(all as u64),
            grouped(per_block.into()),
            quoted(&args.data)
        )),
        2..=10_000 => Ok(blocks),
        _ => refuse(format!(
            "{blocks} blocks are too many, at most 10,000: raise `--gaussians-per-block`"
        )),
    }
}
