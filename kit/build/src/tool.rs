//! The tools of a project: its tests, its machine code, and its snapshots; and running
//! something again whenever a source is saved.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use std::time::Duration;
use std::{env, fs, thread};

use anyhow::{Context, Result, ensure};
use clap::Args;
use muslin_isa::{FAMILIES, Report};
use muslin_manifest::{FILE_NAME, source_hash};

use crate::Project;

/// Cargo, in the workspace.
fn cargo(project: &Project) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.current_dir(&project.root);
    cargo
}

/// Runs cargo with arguments, and shows what it prints.
pub fn run(project: &Project, arguments: &str, more: &[String]) -> Result<()> {
    let mut cargo = cargo(project);
    cargo.args(arguments.split_whitespace()).args(more);
    let status = cargo.status().context("cannot run cargo")?;
    ensure!(status.success(), "`cargo {arguments}` failed: {status}");
    Ok(())
}

/// Longest time between saving a file and starting the compiler.
const INTERVAL: Duration = Duration::from_millis(300);

/// Does something now and after every change of the sources.
pub fn watch(project: &Project, mut each: impl FnMut() -> Result<()>) -> Result<()> {
    let mut compiled = None;
    loop {
        // A file may be missing for a moment while an editor replaces it.
        let hash = source_hash(&project.root, &project.sources).ok();
        if hash.is_some() && hash != compiled {
            each()?;
            println!("watching {} (end with Ctrl-C)", project.sources.join(", "));
            compiled = hash;
        }
        thread::sleep(INTERVAL);
    }
}

/// Runs `cargo xtask kernels`. It is a new process: the xtask contains the kernels' declarations, so it must be compiled again, too.
pub fn compile(project: &Project, validate: bool) -> Result<()> {
    let mut cargo = cargo(project);
    cargo.args(["run", "--quiet", "--package", "xtask"]);
    if cfg!(windows) {
        // A running program cannot be replaced there, so the child has its own folder.
        cargo.env("CARGO_TARGET_DIR", project.target.join("watch"));
    }
    cargo.args(["--", "kernels"]);
    if validate {
        cargo.arg("--validate");
    }
    // A failed build has printed its reason: wait for the next change.
    cargo.status().context("cannot run cargo")?;
    Ok(())
}

/// Options for the machine code of kernels.
#[derive(Args)]
pub struct IsaOptions {
    /// Show the machine code of this kernel's innermost loops instead of the table, and all of it where there is no loop
    #[arg(long, value_name = "KERNEL")]
    asm: Option<String>,
    /// A family of AMD GPUs, as Mesa's RADV names it; can be given several times
    #[arg(long, default_values = FAMILIES)]
    family: Vec<String>,
}

/// Prints the machine code that RADV makes of a project's compiled kernels. It needs no GPU.
pub fn isa(project: &Project, options: &IsaOptions) -> Result<()> {
    let folder = project.root.join(&project.kernels);
    if muslin_isa::answer(&folder) {
        return Ok(());
    }
    ensure!(
        folder.join(FILE_NAME).exists(),
        "there are no compiled kernels in {}: run `cargo xtask kernels` first",
        folder.display()
    );
    for family in &options.family {
        let mut child = Command::new(env::current_exe()?);
        let report = muslin_isa::compile(&folder, family, child.arg("isa"))?;
        match &options.asm {
            None => println!("{report}"),
            Some(kernel) => print_loops(&report, kernel)?,
        }
    }
    Ok(())
}

fn print_loops(report: &Report, kernel: &str) -> Result<()> {
    let found = report.kernels.iter().find(|found| found.name == kernel);
    let found = found.with_context(|| {
        format!("there is no kernel `{kernel}`: `cargo xtask isa` without `--asm` lists them")
    })?;
    let title = format!("{kernel}, {}, {}", report.family, report.driver);
    match found.loops.len() {
        0 => println!("{title}: no loop, so all of it\n\n{}", found.text),
        count => println!("{title}: {count} innermost loops"),
    }
    for found in &found.loops {
        println!("\n{} instructions\n{}", found.instructions, found.text);
    }
    Ok(())
}

/// Options for pictures.
#[derive(Args)]
pub struct SnapshotOptions {
    /// Look again whenever a kernel source is saved, until interrupted. The page follows
    #[arg(long)]
    watch: bool,
    /// More arguments for the tests
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    more: Vec<String>,
}

/// Runs the project's snapshots, and makes the page of their failures.
pub fn show_snapshots(project: &Project, options: &SnapshotOptions) -> Result<()> {
    match options.watch {
        true => watch(project, || look(project, &options.more)),
        false => look(project, &options.more),
    }
}

fn look(project: &Project, more: &[String]) -> Result<()> {
    let folder = project.target.join("snapshot-failures");
    fs::create_dir_all(&folder)?;
    for picture in pictures(&folder)? {
        fs::remove_file(folder.join(picture))?;
    }
    let mut cargo = cargo(project);
    cargo.args(project.snapshots.split_whitespace()).args(more);
    // a test goes on to its next picture, and accepts none
    cargo.envs([("INSTA_UPDATE", "no"), ("INSTA_FORCE_PASS", "1")]);
    let status = cargo.status().context("cannot run cargo")?;
    let page = folder.join("index.html");
    fs::write(&page, page_of(&pictures(&folder)?, status.success()))?;
    println!("{}", page.canonicalize()?.display());
    Ok(())
}

/// The names of the pictures in a folder.
fn pictures(folder: &Path) -> Result<Vec<String>> {
    let names =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names: Vec<_> = names.collect::<Result<_>>()?;
    names.retain(|name| name.ends_with(".png"));
    names.sort();
    Ok(names)
}

/// A page that loads itself again every second.
fn page_of(pictures: &[String], is_ok: bool) -> String {
    let mut page = "<!doctype html><meta charset=utf-8><meta http-equiv=refresh content=1><title>Snapshots</title>\n\
        <style>body{font:16px sans-serif}img{image-rendering:pixelated;max-width:100%}</style>\n"
        .to_owned();
    page += match pictures {
        [] => "<p>No picture differs from the accepted one.\n",
        _ => "<p>Expected, actual, difference:\n",
    };
    page += if is_ok { "" } else { "<p>A test failed: the terminal says why.\n" };
    for name in pictures {
        // writing to a String does not fail
        let _ = writeln!(page, "<h2>{name}</h2><img src=\"{name}\">");
    }
    page
}
