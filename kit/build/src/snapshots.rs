//! `cargo xtask snapshots`: what pictures look like that are not as accepted, on a page.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use crate::{Project, tool};

/// Options for pictures.
#[derive(clap::Args)]
pub struct Options {
    /// Look again whenever a kernel source is saved, until interrupted. The page follows
    #[arg(long)]
    watch: bool,
    /// More arguments for the tests
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    more: Vec<String>,
}

/// Runs the project's snapshots, and makes the page of their failures.
pub fn run(project: &Project, options: &Options) -> Result<()> {
    match options.watch {
        true => tool::watch(project, || look(project, &options.more)),
        false => look(project, &options.more),
    }
}

fn look(project: &Project, more: &[String]) -> Result<()> {
    let folder = project.target.join("snapshot-failures");
    fs::create_dir_all(&folder)?;
    for picture in pictures(&folder)? {
        fs::remove_file(folder.join(picture))?;
    }
    let mut cargo = tool::cargo(project);
    cargo.args(project.snapshots.split_whitespace()).args(more);
    // a test goes on to its next picture, and accepts none
    cargo.envs([("INSTA_UPDATE", "no"), ("INSTA_FORCE_PASS", "1")]);
    let status = cargo.status().context("cannot run cargo")?;
    let page = folder.join("index.html");
    fs::write(&page, text(&pictures(&folder)?, status.success()))?;
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
fn text(pictures: &[String], is_ok: bool) -> String {
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
