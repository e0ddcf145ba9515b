//! `organza export`: a scene as a file for viewers that sort.

use std::path::PathBuf;

use organza::camera::Orbit;
use organza::data::{Dataset, Frame};
use organza::error::format_bytes;
use organza::splats::{self, Distilled, Fit, Format, Splat};
use organza::{Camera, DeviceScene, Renderer, Result, Scene, evaluate};

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, DataSet, SceneSource, Split};
use super::output::check_file;
use super::refuse;
use super::summary::count;

const USAGE: &str = "organza export SCENE CAMERAS -o FILE";
/// Cameras around a scene that has none: on each circle, and the circles' elevations in degrees.
const AROUND: usize = 16;
const ELEVATIONS: [f64; 3] = [-15.0, 17.0, 45.0];
/// Of cameras without photographs, every Nth is not fitted.
const JUDGES: usize = 8;

const EXAMPLES: &str = "\
Examples:
  organza export run -o scene.ply            for SuperSplat, Blender's add-ons and many others
  organza export run -o scene.spz            a tenth of the size
  organza export run -o scene.glb            glTF, with KHR_gaussian_splatting
  organza export scene.safetensors transforms.json -o scene.ply
  organza export run -o scene.ply --steps 2000

Other viewers sort Gaussians by depth and know no networks. So this command fits spherical harmonics to the colors, and \
opacities to the visibility. Then it renders as those viewers do, from the cameras and from between them, \
compares with the scene's own images, and corrects all values of the Gaussians, step by step. It prints how close it came, \
in views that the fit has not seen.";

/// Write a scene as Gaussians for viewers that sort: .ply, .spz, .glb or .splat
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The views to compare: nerfstudio's transforms.json, or a data set [default: those of the run, or views from all around the
    /// scene's box]
    cameras: Option<PathBuf>,
    /// The file. Its ending says how it is written: .ply has all values, .spz rounds them, .splat has one color for all
    /// directions
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// How often to compare a view and correct the Gaussians; 0 fits to the networks alone
    #[arg(long, value_name = "N", default_value_t = 500)]
    #[arg(value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    steps: u32,
    /// The longest side of a view that is compared, in pixels
    #[arg(long, value_name = "S", default_value_t = 480)]
    #[arg(value_parser = clap::value_parser!(u32).range(16..=4096))]
    side: u32,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

/// The views to compare.
struct Views {
    fitted: Vec<Camera>,
    judges: Vec<Camera>,
    /// With the photographs of the judges.
    data: Option<Dataset>,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let Some(format) = Format::of(&args.output) else {
        let output = args.output.display();
        return refuse(format!(
            "{output}: the ending of the file says how it is written: .ply, .spz, .glb or .splat"
        ));
    };
    let source = SceneSource::find(&args.scene)?;
    let inputs: Vec<_> =
        [Some(source.file()), args.cameras.as_deref()].into_iter().flatten().collect();
    check_file(&args.output, &inputs)?;
    let scene = source.load(console)?;
    let renderer = args.device.open(console)?;
    let views = Views::load(args, &source, &scene, &renderer, console)?;
    let uploaded = renderer.upload(&scene)?;
    let fit = Fit { steps: args.steps as usize, side: args.side };
    let distilled = {
        let progress = console.progress(u64::from(args.steps), "steps");
        progress.say("fitting");
        let cameras = [&views.fitted[..], &views.judges];
        splats::distill(&renderer, &scene, &uploaded, cameras, fit, &mut |step| progress.set(step))?
    };
    let up = Orbit::around(&views.fitted)?.up;
    splats::save(&distilled.splats, &args.output, format, up)?;
    views.say_psnr(&distilled, args.steps, console);
    views.say_photographs(&renderer, &scene, &uploaded, &distilled.splats, console)?;
    if format == Format::Splat {
        console
            .note("a .splat file has one color for all directions, so its images are less close");
    }
    let bytes = std::fs::metadata(&args.output).map_or(0, |file| file.len());
    console.note(&format!(
        "wrote {} to {}, {}",
        count(distilled.splats.len() as u64, "Gaussian"),
        args.output.display(),
        format_bytes(bytes)
    ));
    Ok(())
}

impl Views {
    fn load(
        args: &Args,
        source: &SceneSource,
        scene: &Scene,
        renderer: &Renderer,
        console: Console,
    ) -> Result<Self> {
        let named = args.cameras.as_deref();
        let has_photographs = match named {
            Some(named) => named.is_dir() || args.data.is_given(),
            None => args.data.is_given() || source.settings()?.is_some(),
        };
        if has_photographs {
            let settings = args.data.settings(source, named, USAGE)?;
            let data = DataSet::open(settings, console)?.read(renderer, console)?;
            return Self::of_data_set(data, args);
        }
        let cameras = match named {
            Some(_) => Cameras::load(source, named, &args.data, USAGE, console)?.list,
            None => all_around(scene.config.aabb)?,
        };
        let [fitted, judges] = with_judges(cameras);
        Ok(Self { fitted, judges, data: None })
    }

    /// Fits the frames that training saw, and judges by those that were held out.
    fn of_data_set(data: Dataset, args: &Args) -> Result<Self> {
        let split = args.data.split(Split::All);
        let [fitted, judges] = [false, true].map(|is_held_out| {
            let frames: Vec<&Frame> = match is_held_out {
                true => data.held_out_frames().collect(),
                false => data.train_frames().collect(),
            };
            let frames = frames.into_iter().filter(|_| split.takes(is_held_out));
            frames.map(|frame| frame.camera.clone()).collect::<Vec<_>>()
        });
        // with `--split held-out`, those are what there is
        let (fitted, judges) = if fitted.is_empty() { (judges, fitted) } else { (fitted, judges) };
        Ok(Self { fitted, judges, data: Some(data) })
    }

    fn say_psnr(&self, distilled: &Distilled, steps: u32, console: Console) {
        let (views, which) = match self.judges.len() {
            0 => (self.fitted.len(), ""),
            judges => (judges, " that the fit has not seen"),
        };
        console.note(&format!(
            "in {}{which}, images of the file are {:.2} dB from the scene's own ({:.2} dB before {})",
            count(views as u64, "view"),
            distilled.psnr,
            distilled.first_psnr,
            count(u64::from(steps), "step")
        ));
    }

    /// What the file loses beside photographs that training has not seen.
    fn say_photographs(
        &self,
        renderer: &Renderer,
        scene: &Scene,
        uploaded: &DeviceScene,
        splats: &[Splat],
        console: Console,
    ) -> Result<()> {
        let Some(data) = &self.data else { return Ok(()) };
        let frames: Vec<&Frame> = data.held_out_frames().collect();
        let Some(own) = evaluate(renderer, uploaded, &frames)?.mean.psnr else { return Ok(()) };
        let background = scene.config.background.map(|x| x as f32);
        let of = |frame: &&Frame| {
            let Frame { camera, image, .. } = frame;
            splats::psnr(splats, camera, background, image.pixels(), image.valid())
        };
        let found: Vec<_> = frames.iter().filter_map(of).collect();
        let sorted = found.iter().sum::<f64>() / found.len() as f64;
        console.note(&format!(
            "beside {}: {sorted:.2} dB, the scene itself {own:.2} dB, so the file loses {:.2} dB",
            count(found.len() as u64, "held-out photograph"),
            own - sorted
        ));
        Ok(())
    }
}

/// Cameras, and those of them that are only to measure.
pub fn with_judges(cameras: Vec<Camera>) -> [Vec<Camera>; 2] {
    let [mut fitted, mut judges] = [Vec::new(), Vec::new()];
    let is_enough = cameras.len() >= JUDGES;
    for (index, camera) in cameras.into_iter().enumerate() {
        let is_judge = is_enough && index % JUDGES == JUDGES / 2;
        if is_judge { judges.push(camera) } else { fitted.push(camera) }
    }
    [fitted, judges]
}

/// Cameras that see a whole box from all sides, a circle above the other.
pub fn all_around(aabb: [[f64; 3]; 2]) -> Result<Vec<Camera>> {
    let orbit = Orbit::of_box(aabb, [640, 480]);
    let circle = |elevation: f64| {
        Orbit { elevation: elevation.to_radians(), ..orbit.clone() }.cameras(AROUND)
    };
    let circles = ELEVATIONS.into_iter().map(circle).collect::<Result<Vec<_>>>()?;
    // one of each circle after the other: judges are of all circles
    Ok((0..AROUND).flat_map(|at| circles.iter().map(move |circle| circle[at].clone())).collect())
}
