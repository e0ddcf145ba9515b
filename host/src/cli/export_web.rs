//! `organza export-web`: writes a page that renders a scene in a browser, by itself.

use std::fs;
use std::path::{Path, PathBuf};

use organza::error::format_bytes;
use organza::web::{PageOptions, WebPage};
use organza::{Camera, Renderer, Result, UploadOptions};
use organza_core::write_atomic;

use super::console::Console;
use super::device::DeviceArgs;
use super::inputs::{Cameras, DataArgs, SceneSource, Shown};
use super::output::{Folder, check_file, refuse_run};
use super::{refuse, title};

/// Longest side of a page's images, in pixels.
const MAX_SIDE: u32 = 4096;

/// Write a page that renders a scene in a browser, by itself
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/export-web.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// More scenes at their places, each as SCENE@PLACE.json; and the cameras to start from: nerfstudio's transforms.json,
    /// or a data set [default: the run's, or views around the scene]
    cameras: Vec<PathBuf>,
    /// The folder of the page, created if it does not exist; with --single-file, the file
    #[arg(short, long, value_name = "PATH")]
    output: PathBuf,
    /// Write a single file that contains everything
    #[arg(long)]
    single_file: bool,
    /// The most pixels that the page renders; a larger window shows them enlarged
    #[arg(long, value_name = "WxH", default_value = "1280x720", value_parser = size)]
    size: [u32; 2],
    /// The title of the page [default: the scene's name]
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Keep both hash grids in full precision: the page is larger, and its images equal `render`'s. Without
    /// this, each feature is off by at most 1/2048
    #[arg(long)]
    full_grids: bool,
    #[command(flatten)]
    data: DataArgs,
    #[command(flatten)]
    device: DeviceArgs,
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let shown = Shown::find(&args.scene, &args.cameras)?;
    let cameras = cameras(&shown, &args.data, console)?;
    // checked before anything is computed
    let folder = match args.single_file {
        true => {
            let inputs = [shown.source.named()].into_iter().chain(shown.cameras.as_deref());
            check_file(&args.output, inputs)?;
            None
        }
        false => Some(folder(&args.output)?),
    };
    let renderer = args.device.open(console)?;
    let title = args.title.clone().unwrap_or_else(|| page_title(&shown.source));
    let page = PageOptions { title, size: args.size };
    let scenes = shown.load(console)?;
    let options = UploadOptions { half_grids: !args.full_grids };
    let upload = |renderer: &Renderer| shown.upload(&scenes, options, renderer);
    let page = console.during("measuring what images need", || {
        WebPage::new(&scenes[0], &upload, &cameras, &renderer, &page)
    })?;
    let (file, bytes) = match &folder {
        None => {
            let text = page.single_file();
            write(&args.output, text.as_bytes())?;
            (args.output.clone(), text.len())
        }
        Some(folder) => (folder.join(WebPage::FILES[0]), write_page(&page, folder)?),
    };
    console.note(&format!(
        "wrote a page of {}: open {} in a browser with WebGPU",
        format_bytes(bytes as u64),
        file.display()
    ));
    Ok(())
}

/// A scene's name, without the extension of a file.
fn page_title(source: &SceneSource) -> String {
    let name = title(source.named());
    name.strip_suffix(".safetensors").map_or_else(|| name.clone(), str::to_owned)
}

/// Writes the files of a page, and returns their bytes.
fn write_page(page: &WebPage, folder: &Folder) -> Result<usize> {
    let files = page.files();
    for (name, bytes) in &files {
        write(&folder.file(name)?, bytes)?;
    }
    Ok(files.iter().map(|(_, bytes)| bytes.len()).sum())
}

/// The cameras of a page: the named ones, or the run's. A scene's file alone has none.
fn cameras(shown: &Shown, data: &DataArgs, console: Console) -> Result<Vec<Camera>> {
    let Shown { source, cameras: named, .. } = shown;
    let named = named.as_deref();
    if named.is_none() && !data.is_given() && source.settings()?.is_none() {
        return Ok(Vec::new());
    }
    Ok(Cameras::load(source, named, data, console)?.list)
}

/// The page's folder. Refuses a folder that holds another page, or a training run.
fn folder(path: &Path) -> Result<Folder> {
    refuse_run(path)?;
    let folder = Folder::make(path)?;
    let has = |name: &&str| folder.join(name).exists();
    let Some(name) = WebPage::FILES.iter().find(|name| has(name)) else { return Ok(folder) };
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

fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    write_atomic(path, |file| file.write_all(bytes))
}

fn size(text: &str) -> Result<[u32; 2], String> {
    super::size(text, 16..=MAX_SIDE)
}
