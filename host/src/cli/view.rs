//! `organza view`: shows a scene in a browser.

mod blocks;

use std::net::IpAddr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use organza::Result;
use organza::data::{Point, Pose};
use organza::view::{About, Editor, FrameRenderer, Photographs, Places, Purpose, Queue, Server};

use blocks::Blocks;

use super::console::Console;
use super::device::SceneArgs;
use super::inputs::{Cameras, DataArgs, DataSet, SceneSource, Shown};
use super::{refuse, signals, title};

/// Look at a scene in a browser
#[derive(Debug, clap::Args)]
#[command(after_help = include_str!("help/view.txt"))]
pub struct Args {
    /// The scene, safetensors, or the folder of a training run
    scene: PathBuf,
    /// More scenes at their places, each as SCENE@PLACE.json; and a data set, or a transforms.json, with or without
    /// photographs [default: the run's]
    data: Vec<PathBuf>,
    /// Let the page remove Gaussians, and save what is left to this file. Later saves add a number to its name; no file is
    /// replaced
    #[arg(long, value_name = "SCENE", help_heading = "Page")]
    edit: Option<PathBuf>,
    #[command(flatten)]
    server: ServerArgs,
    #[command(flatten)]
    data_args: DataArgs,
    #[command(flatten)]
    scene_args: SceneArgs,
}

/// The address of the page.
#[derive(Debug, clap::Args)]
pub struct ServerArgs {
    /// The port of the page; 0 takes any free one [default: 4747, or any free one]
    #[arg(long, value_name = "N", help_heading = "Page")]
    port: Option<u16>,
    /// Let other machines see the page, at this address of this machine, such as 0.0.0.0. Keep the page's
    /// address secret: it has a token [default: only this machine]
    #[arg(long, value_name = "ADDRESS", help_heading = "Page")]
    bind: Option<IpAddr>,
    /// Open the page in a browser
    #[arg(long, help_heading = "Page")]
    open: bool,
}

impl ServerArgs {
    /// Whether the user gave any of these options.
    pub fn is_given(&self) -> bool {
        self.port.is_some() || self.bind.is_some() || self.open
    }

    /// Opens the port.
    pub fn listen(&self, console: Console) -> Result<Server> {
        let server = Server::listen(self.bind, self.port)?;
        if self.port.is_none() && server.port() != Server::PORT {
            let [wanted, port] = [Server::PORT, server.port()];
            console.note(&format!(
                "port {wanted} is taken by another program, so the page has port {port}: `ssh -L` needs this one"
            ));
        }
        if let Some(any) = self.bind.filter(IpAddr::is_unspecified) {
            console.note(&format!(
                "from another machine, open the address with this machine's name in place of {any}"
            ));
        }
        Ok(server)
    }

    /// Prints the page's address, even with `--quiet`, and opens the page if asked.
    pub fn announce(&self, url: &str, console: Console) {
        console.always(&format!("the page is at {url}"));
        if self.open && !open(url) {
            console.warn("no browser could be opened; open the address yourself");
        }
    }
}

/// Opens an address in the user's browser.
fn open(url: &str) -> bool {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new("xdg-open")
    };
    command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}

pub fn run(args: &Args, console: Console) -> Result<()> {
    let shown = Shown::find_images(&args.scene, &args.data)?;
    let source = &shown.source;
    let named = shown.cameras.as_deref();
    if args.edit.is_some() {
        shown.require_one()?;
    }
    let (poses, photographs, points) = surroundings(args, source, named, console)?;
    let mut scenes = match shown.is_blended() {
        true => vec![source.load(console)?],
        false => shown.load(console)?,
    };
    let server = args.server.listen(console)?;
    let renderer = args.scene_args.device.open(console)?;
    let uploaded = shown.upload(&scenes, args.scene_args.options(), &renderer)?;
    let title = title(source.named());
    let has_photographs = !photographs.is_empty();
    let purpose = if args.edit.is_some() { Purpose::Edit } else { Purpose::Look };
    let about = About::new(&title, &uploaded, &poses, has_photographs, &points, purpose);
    let editor = args.edit.as_ref();
    let editor =
        editor.map(|file| Editor::new(scenes.remove(0), poses, args.scene_args.options(), file));
    let editor = editor.transpose()?;
    let queue = Arc::new(Queue::default());
    let stopped = Arc::clone(&queue);
    // the first signal ends the program after the current image, the second at once
    signals::handle(move || match stopped.is_stopped() {
        true => std::process::exit(0),
        false => stopped.stop(),
    })?;
    let places = Places::new(&uploaded, shown.places());
    let mut frame_renderer =
        FrameRenderer::new(Arc::clone(&queue), photographs).with(editor, places);
    let home = about.home.clone();
    let url = server.url();
    server.start(Arc::clone(&queue), about, None)?;
    args.server.announce(&format!("{url} (Ctrl-C ends it)"), console);
    let mut blocks = Blocks::new(&shown, uploaded, args.scene_args.options(), &renderer, console);
    while !queue.is_stopped() {
        blocks.go_on(frame_renderer.camera().unwrap_or(&home))?;
        frame_renderer.serve(blocks.stage(), blocks.patience());
    }
    Ok(())
}

/// Cameras, photographs and points of the data set that the user named, or of the run's. A scene's file alone has none.
fn surroundings(
    args: &Args,
    source: &SceneSource,
    named: Option<&Path>,
    console: Console,
) -> Result<(Vec<Pose>, Photographs, Vec<Point>)> {
    if named.is_none() && source.settings()?.is_none() {
        if args.data_args.is_given() {
            return refuse("options of a data set were given, but no data set");
        }
        return Ok(Default::default());
    }
    if let Some(file) = named.filter(|file| !args.data_args.names_photographs(file)) {
        let cameras = Cameras::load(source, Some(file), &args.data_args, console)?;
        // a data set's file means that data set; another file has just cameras
        if !cameras.has_photographs() {
            let poses = cameras.list.into_iter().map(Pose::from).collect();
            return Ok((poses, Photographs::default(), Vec::new()));
        }
    }
    let data = DataSet::of(source, named, &args.data_args, None, console)?;
    let poses = data.cameras()?;
    let (photographs, points) = data.photographs();
    Ok((poses, photographs, points))
}
