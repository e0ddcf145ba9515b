//! `organza mesh`: writes the surfaces of a scene as a mesh.

use std::path::PathBuf;

use organza::camera::Target;
use organza::error::format_bytes;
use organza::splats::{Mesh, MeshFormat, save_mesh};
use organza::{Camera, Result};
use organza_core::memory;

use super::console::Console;
use super::device::SceneArgs;
use super::inputs::{Cameras, DataArgs, Shown};
use super::output::{check_file, relative_to};
use super::summary::grouped;

/// Write the surfaces that the cameras see as a mesh: .glb, .ply or .obj
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/mesh.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The cameras: nerfstudio's transforms.json, or a data set [default: the run's]
    cameras: Option<PathBuf>,
    /// The file. Its extension chooses the format
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Cells of the grid along the longest side of the scene
    #[arg(long, value_name = "N", default_value_t = 384)]
    #[arg(value_parser = clap::value_parser!(u32).range(16..=2048))]
    size: u32,
    /// The largest number of triangles: with more, the grid has larger cells
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    #[arg(value_parser = clap::value_parser!(u32).range(100..))]
    faces: u32,
    /// Longest side of the views, in pixels
    #[arg(long, value_name = "S", default_value_t = 512)]
    #[arg(value_parser = clap::value_parser!(u32).range(16..=4096))]
    side: u32,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let format = MeshFormat::from_path(&args.output)?;
    let shown = Shown::find(&args.scene, &[])?;
    let source = &shown.source;
    check_file(&args.output, [source.named()].into_iter().chain(args.cameras.as_deref()))?;
    let Cameras { list: cameras, all, .. } =
        Cameras::load(source, args.cameras.as_deref(), &args.data, console)?;
    let scenes = shown.load(console)?;
    let renderer = args.scene_args.device.open(console)?;
    let uploaded = shown.upload(&scenes, args.scene_args.options(), &renderer)?;
    let mut surfaces = Vec::new();
    {
        let progress = console.progress("finding surfaces", cameras.len(), "views");
        for camera in &cameras {
            surfaces.push(renderer.surface(&uploaded, &camera.within(args.side))?);
            progress.advance(1);
        }
    }
    let limits = limits(shown.visible_box(&scenes), &cameras);
    let mesh = {
        let bar = console.progress("putting surfaces together", 0, "layers");
        let progress = |done, all| bar.set_of(done, all);
        Mesh::of_surfaces(&surfaces, limits, args.size, args.faces as usize, &progress)?
    };
    let placement = &scenes[0].config.placement;
    let up = placement.upward(&all);
    if let Some(left_out) = save_mesh(&mesh, &args.output, format, up, placement)? {
        console.warn(&(relative_to(left_out) + ", as it says itself"));
    }
    let bytes = std::fs::metadata(&args.output).map_or(0, |file| file.len());
    let file = args.output.display();
    let [triangles, vertices] = [mesh.face.len(), mesh.position.len()].map(|n| grouped(n as u64));
    let size = format_bytes(bytes);
    let peak = memory::peak().map(|peak| format!("; at most {} of memory", format_bytes(peak)));
    let peak = peak.unwrap_or_default();
    console.note(&format!(
        "wrote {triangles} triangles with {vertices} vertices to {file}, {size}{peak}"
    ));
    Ok(())
}

/// The box of the mesh: what has nearly all of the opacity. If the cameras look at one place, only what their images show around it.
fn limits([low, high]: [[f64; 3]; 2], cameras: &[Camera]) -> [[f64; 3]; 2] {
    let target = Target::from_cameras(cameras);
    if !target.is_met {
        return [low, high];
    }
    let [lowest, highest] = target.ball(1.0);
    [lowest.max(low.into()).to_array(), highest.min(high.into()).to_array()]
}
