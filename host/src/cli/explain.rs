//! `organza explain`: the parts of one pixel, Gaussian by Gaussian.

use std::fmt::Write as _;
use std::path::PathBuf;

use organza::render::Contribution;
use organza::{Camera, DeviceOptions, Inspection, Renderer, Result};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::refuse;
use super::summary::{Table, count};
use super::views::{no_view, warn_distorted};

/// Break one pixel down, Gaussian by Gaussian; always computed on the CPU
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/explain.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The cameras: nerfstudio's transforms.json, or a data set [default: the run's]
    cameras: Option<PathBuf>,
    /// The view of the pixel
    #[arg(long, value_name = "V", default_value_t = 0)]
    view: usize,
    /// Column and row of the pixel, from the upper left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    pixel: [i32; 2],
    /// Also show Gaussians whose falloff is zero at the pixel
    #[arg(long)]
    all: bool,
    /// Print JSON
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArgs,
}

fn parse_pixel(text: &str) -> Result<[i32; 2], String> {
    let pixel = text.split_once(',').and_then(|(x, y)| Some([number(x)?, number(y)?]));
    pixel.ok_or_else(|| "expected two whole numbers X,Y such as 192,96".to_owned())
}

fn number(text: &str) -> Option<i32> {
    text.trim().parse().ok()
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let source = SceneSource::find(&args.scene)?;
    let cameras = Cameras::load(&source, args.cameras.as_deref(), &args.data, console)?;
    let Cameras { list: cameras, origin, .. } = cameras;
    let Args { view, pixel, .. } = *args;
    let Some(camera) = cameras.get(view) else { return no_view(view, cameras.len(), &origin) };
    check_pixel(pixel, view, camera)?;
    warn_distorted(console, &cameras, &[view]);
    let scene = source.load(console)?;
    let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
    let scene = renderer.upload(&scene)?;
    let mut inspection = renderer.inspect(&scene, &cameras, view, pixel)?;
    let reaching = inspection.contributions.len();
    if !args.all {
        inspection.contributions.retain(|contribution| contribution.falloff > 0.0);
    }
    let hidden = reaching - inspection.contributions.len();
    if args.json {
        let gaussians = &inspection.contributions;
        let inspection = &inspection;
        return print_json(&Explanation { view, pixel, gaussians, hidden, inspection });
    }
    print(&(title(pixel, view, camera) + &text(&inspection, hidden)))
}

/// Fails if the pixel is not in the view's image.
fn check_pixel(pixel @ [x, y]: [i32; 2], view: usize, camera: &Camera) -> Result<()> {
    let size @ [width, height] = [camera.width, camera.height];
    let is_within = |(at, side): (i32, u32)| (0..i64::from(side)).contains(&i64::from(at));
    if pixel.into_iter().zip(size).all(is_within) {
        return Ok(());
    }
    refuse(format!(
        "pixel {x},{y} is outside view {view}, which has {width} x {height} pixels: columns 0 to {}, rows 0 to {}",
        width - 1,
        height - 1
    ))
}

fn title([x, y]: [i32; 2], view: usize, camera: &Camera) -> String {
    let Camera { width, height, file_path, .. } = camera;
    let image = file_path.as_ref().map_or(String::new(), |path| format!("{path}, "));
    format!("pixel {x},{y} of view {view} ({image}{width} x {height})\n\n")
}

fn text(inspection: &Inspection, hidden: usize) -> String {
    let mut text = String::new();
    if !inspection.contributions.is_empty() {
        text += &table(&inspection.contributions).to_string();
        text.push('\n');
    }
    text += &verdict(inspection, hidden);
    text
}

fn table(contributions: &[Contribution]) -> Table {
    let titles = [
        "Gaussian",
        "distance",
        "falloff",
        "opacity",
        "samples",
        "T",
        "alpha",
        "color (RGB)",
        "C (RGB)",
        "S",
    ];
    let mut table = Table::new(0, titles);
    for row in contributions {
        table.row([
            row.gaussian.to_string(),
            format!("{:.2}", row.distance),
            format!("{:.5}", row.falloff),
            format!("{:.5}", row.opacity),
            row.samples.to_string(),
            format!("{:.5}", row.transmittance),
            format!("{:.5}", row.alpha),
            rgb(row.color),
            rgb(row.color_sum),
            format!("{:.5}", row.alpha_sum),
        ]);
    }
    table
}

fn verdict(inspection: &Inspection, hidden: usize) -> String {
    let shown = inspection.contributions.len();
    let mut text = count((shown + hidden) as u64, "Gaussian") + " with the pixel inside the radius";
    if hidden > 0 {
        let _ = write!(text, "; {hidden} not shown: falloff is zero (--all shows them)");
    }
    text.push('\n');
    let weight = inspection.alpha_sum;
    let _ = writeln!(text, "Eq. 12   C = ({}), S = {weight:.5}", rgb(inspection.color_sum));
    if inspection.divided {
        let _ = writeln!(text, "Eq. 13   S > 1, so I = C / S");
    } else {
        let background = rgb(inspection.background);
        let _ = writeln!(text, "Eq. 13   S <= 1, so I = C + (1 - S) b with b = ({background})");
    }
    let [r, g, b] = inspection.color_8_bit;
    let _ = writeln!(
        text,
        "pixel    I = ({}), in 8 bits {r} {g} {b} (#{r:02x}{g:02x}{b:02x})",
        rgb(inspection.color)
    );
    text
}

fn rgb([r, g, b]: [f32; 3]) -> String {
    format!("{r:.4} {g:.4} {b:.4}")
}

/// The output of `--json`: numbers with all their digits.
#[derive(Debug, Serialize)]
struct Explanation<'a> {
    view: usize,
    pixel: [i32; 2],
    gaussians: &'a [Contribution],
    hidden: usize,
    #[serde(flatten)]
    inspection: &'a Inspection,
}
