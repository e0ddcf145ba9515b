//! `organza explain`: the parts of one pixel, Gaussian by Gaussian.

use std::fmt::Write as _;
use std::path::PathBuf;

use organza::render::{Contribution, Leakage};
use organza::{Camera, DeviceOptions, DeviceScene, Inspection, Renderer, Result};
use serde::Serialize;

use super::console::{Console, print, print_json};
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::refuse;
use super::summary::{Table, count};
use super::views::{ViewList, warn_distorted};

const EXAMPLES: &str = "\
Examples:
  organza explain scene.safetensors cameras.json --view 0 --pixel 192,192
  organza explain scene.safetensors cameras.json --view 3 --pixel 10,20 --all --json
  organza explain run --split held-out --view 0 --pixel 64,64
  organza explain run --split held-out --summary
  organza explain run --summary --views 0-3

The columns follow docs/pipeline.md: alpha = opacity * falloff * T, where opacity is the \
sigmoid of the logit. C and S are the sums of Eq. 12 up to and including the row's Gaussian.

--summary looks at up to 1024 evenly spaced pixels of each view. The surface of a pixel is the median depth of its \
weights: Gaussians with half of S are nearer. The table shows the shares of the weight that are more than 12% deeper \
(behind) or nearer (in front) than the surface, and the share of the pixels that show the background: S < 0.98.";

/// Break one pixel down, Gaussian by Gaussian, or sum up views; always computed on the CPU
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The cameras: nerfstudio's transforms.json, or a data set [default: the run's]
    cameras: Option<PathBuf>,
    /// The view of the pixel, or the views to sum up: a list such as 0,8 or 0-3 [default: 0; all with --summary]
    #[arg(long, value_name = "V", visible_alias = "views")]
    view: Option<ViewList>,
    /// Column and row of the pixel, from the upper left
    #[arg(long, value_name = "X,Y", value_parser = parse_pixel, allow_hyphen_values = true)]
    #[arg(required_unless_present = "summary")]
    pixel: Option<[i32; 2]>,
    /// Measure how much of the views' weight is not at the surface, instead of explaining a pixel
    #[arg(long, conflicts_with_all = ["pixel", "all"])]
    summary: bool,
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
    let usage = "organza explain SCENE CAMERAS";
    let cameras = Cameras::load(&source, args.cameras.as_deref(), &args.data, usage, console)?;
    let Cameras { list: cameras, origin, .. } = cameras;
    let views = match &args.view {
        Some(views) => views.resolve(cameras.len(), &origin)?,
        None if args.summary => (0..cameras.len()).collect(),
        None => vec![0],
    };
    if args.pixel.is_some() && views.len() > 1 {
        return refuse("a pixel is of one view; several are for `--summary`");
    }
    let at = args.pixel.map(|pixel| Place { view: views[0], pixel });
    if let Some(at) = at {
        at.check(&cameras[at.view])?;
    }
    warn_distorted(console, &cameras, &views);
    let scene = source.load(console)?;
    let renderer = Renderer::new(organza::open_device(&DeviceOptions::cpu(None))?);
    let scene = renderer.upload(&scene)?;
    let Some(at) = at else {
        return summarize(&renderer, &scene, &cameras, &views, args.json, console);
    };
    let mut inspection = renderer.inspect(&scene, &cameras, at.view, at.pixel)?;
    let reaching = inspection.contributions.len();
    if !args.all {
        inspection.contributions.retain(|contribution| contribution.falloff > 0.0);
    }
    let hidden = reaching - inspection.contributions.len();
    if args.json {
        let Place { view, pixel } = at;
        let gaussians = &inspection.contributions;
        let inspection = &inspection;
        return print_json(&Explanation { view, pixel, gaussians, hidden, inspection });
    }
    print(&text(at, &cameras[at.view], &inspection, hidden))
}

/// A pixel of a view.
#[derive(Clone, Copy, Debug)]
struct Place {
    view: usize,
    pixel: [i32; 2],
}

impl Place {
    /// Fails if the pixel is not in the view's image.
    fn check(self, camera: &Camera) -> Result<()> {
        let [x, y] = self.pixel;
        let width = camera.width;
        let height = camera.height;
        if is_within(x, width) && is_within(y, height) {
            return Ok(());
        }
        refuse(format!(
            "pixel {x},{y} is outside view {}, which has {width} x {height} pixels: columns 0 \
             to {}, rows 0 to {}",
            self.view,
            width - 1,
            height - 1
        ))
    }
}

fn is_within(at: i32, side: u32) -> bool {
    (0..i64::from(side)).contains(&i64::from(at))
}

fn text(at: Place, camera: &Camera, inspection: &Inspection, hidden: usize) -> String {
    let [x, y] = at.pixel;
    let image = camera.file_path.as_ref().map_or(String::new(), |path| format!("{path}, "));
    let mut text = format!(
        "pixel {x},{y} of view {} ({image}{} x {})\n\n",
        at.view, camera.width, camera.height
    );
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

/// Number of pixels per view that are measured.
const PIXELS: u32 = 1024;

/// The output of `--json`.
#[derive(Debug, Serialize)]
struct Summary {
    views: Vec<ViewSummary>,
    mean: Leakage,
}

#[derive(Debug, Serialize)]
struct ViewSummary {
    view: usize,
    name: Option<String>,
    #[serde(flatten)]
    leakage: Leakage,
}

/// Measures and prints the views with these indices.
fn summarize(
    renderer: &Renderer,
    scene: &DeviceScene,
    cameras: &[Camera],
    views: &[usize],
    json: bool,
    console: Console,
) -> Result<()> {
    let bar = console.progress("summing up", views.len(), "views");
    let measure = |(done, &view): (usize, &usize)| {
        let leakage = renderer.leakage(scene, cameras, view, PIXELS)?;
        bar.set_of(done + 1, views.len());
        Ok(ViewSummary { view, name: cameras[view].file_path.clone(), leakage })
    };
    let views = views.iter().enumerate().map(measure).collect::<Result<Vec<_>>>()?;
    drop(bar);
    let parts: Vec<_> = views.iter().map(|view| view.leakage).collect();
    let summary = Summary { views, mean: Leakage::mean(&parts) };
    if json { print_json(&summary) } else { print(&summary_text(&summary)) }
}

fn summary_text(summary: &Summary) -> String {
    let titles = ["view", "image", "pixels", "Gaussians a pixel", "behind", "in front", "S < 0.98"];
    let mut table = Table::new(2, titles);
    let mut row = |view: &str, name: &str, leakage: &Leakage| {
        table.row([
            view.to_owned(),
            name.to_owned(),
            leakage.pixels.to_string(),
            format!("{:.1}", leakage.gaussians),
            percent(leakage.behind),
            percent(leakage.in_front),
            percent(leakage.open),
        ]);
    };
    for view in &summary.views {
        row(&view.view.to_string(), view.name.as_deref().unwrap_or(""), &view.leakage);
    }
    row("mean", "", &summary.mean);
    table.to_string()
}

fn percent(share: f64) -> String {
    format!("{:.1}%", 100.0 * share)
}
