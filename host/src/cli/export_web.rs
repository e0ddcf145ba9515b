//! `organza export-web`: writes a page that renders a scene in a browser, by itself.

use std::fs;
use std::path::{Path, PathBuf};

use organza::error::format_bytes;
use organza::web::{PageOptions, WebPage};
use organza::{Camera, Renderer, Result, Scene};
use organza_core::write_atomic;

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, SceneSource};
use super::output::{Folder, check_file};
use super::{refuse, title};

const USAGE: &str = "organza export-web SCENE CAMERAS -o FOLDER";
/// Longest side of a page's images, in pixels.
const MAX_SIDE: u32 = 4096;

const EXAMPLES: &str = "\
Examples:
  organza export-web run -o page                     page/index.html and two files beside it, for any web server
  organza export-web run --single-file -o page.html  one file, to open or to send
  organza export-web scene.safetensors transforms.json -o page
  organza export-web run -o page --size 1920x1080    images of at most this size

The page renders with the visitor's GPU. It needs a browser with WebGPU, and no program and no server: it also opens from \
a folder. It begins at the first camera and turns around what the cameras look at; without cameras, around the scene's box.";

/// Write a page that renders a scene in a browser, by itself
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// The cameras to start from: nerfstudio's transforms.json, or a data set [default: those of the run, or views
    /// around the scene's box]
    cameras: Option<PathBuf>,
    /// The folder of the page, created if it does not exist; with --single-file, the file
    #[arg(short, long, value_name = "PATH")]
    output: PathBuf,
    /// Write a single file that contains everything
    #[arg(long)]
    single_file: bool,
    /// The most pixels that the page renders; a larger window shows them enlarged
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    size: [u32; 2],
    /// The name of the page [default: the scene's]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Keep both hash grids in full precision: the page is larger, and its images are those of `render`. Without
    /// this, each feature is off by at most 1/2048
    #[arg(long)]
    full_grids: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let source = SceneSource::find(&args.scene)?;
    let cameras = cameras(&source, args.cameras.as_deref(), &args.data, USAGE, console)?;
    let inputs: Vec<_> = [source.named()].into_iter().chain(args.cameras.as_deref()).collect();
    // checked before anything is computed
    let folder = match args.single_file {
        true => {
            check_file(&args.output, &inputs)?;
            None
        }
        false => Some(folder(&args.output)?),
    };
    let scene = source.load(console)?;
    let renderer = args.device.open(console)?;
    let options = PageOptions {
        title: args.title.clone().unwrap_or_else(|| title(source.named())),
        size: args.size,
        half_grids: !args.full_grids,
    };
    let page = make(&scene, &cameras, &renderer, &options, console)?;
    let (file, bytes) = match &folder {
        None => {
            let text = page.single_file();
            write(&args.output, &text)?;
            (args.output.clone(), text.len())
        }
        Some(folder) => {
            let files = page.files();
            for (name, text) in &files {
                write(&folder.file(name)?, text)?;
            }
            (folder.join(WebPage::FILES[0]), files.iter().map(|(_, text)| text.len()).sum())
        }
    };
    console.note(&format!(
        "wrote a page of {}: open {} in a browser with WebGPU",
        format_bytes(bytes as u64),
        file.display()
    ));
    Ok(())
}

/// Makes a page, and reports its contents.
pub fn make(
    scene: &Scene,
    cameras: &[Camera],
    renderer: &Renderer,
    options: &PageOptions,
    console: Console,
) -> Result<WebPage> {
    let page = console
        .during("measuring what images need", || WebPage::new(scene, cameras, renderer, options))?;
    let facts = page.facts;
    console.detail(&format!(
        "{} kernels, {} plans, room measured on {} cameras",
        facts.kernels, facts.plans, facts.measured
    ));
    Ok(page)
}

/// The cameras of a page: the named ones, or the run's. A scene's file alone has none.
pub fn cameras(
    source: &SceneSource,
    named: Option<&Path>,
    data: &DataArgs,
    usage: &str,
    console: Console,
) -> Result<Vec<Camera>> {
    if named.is_none() && !data.is_given() && source.settings()?.is_none() {
        return Ok(Vec::new());
    }
    Ok(Cameras::load(source, named, data, usage, console)?.list)
}

/// The page's folder. Refuses a folder that holds another page.
fn folder(path: &Path) -> Result<Folder> {
    let folder = Folder::make(path)?;
    let has = |name: &&str| folder.join(name).exists();
    let Some(name) = WebPage::FILES.iter().find(|name| has(name)) else {
        return Ok(folder);
    };
    match fs::read_to_string(folder.join(WebPage::FILES[0])) {
        Ok(text) if is_own(&text) => Ok(folder),
        _ => refuse(format!(
            "{} holds a {name} that organza did not write; choose another folder",
            path.display()
        )),
    }
}

/// Whether organza wrote a page.
fn is_own(text: &str) -> bool {
    text.contains("<meta name=\"generator\" content=\"organza ")
}

fn write(path: &Path, text: &str) -> Result<()> {
    write_atomic(path, |file| file.write_all(text.as_bytes()))
}

fn size(text: &str) -> Result<[u32; 2], String> {
    super::size(text, 16..=MAX_SIDE)
}
