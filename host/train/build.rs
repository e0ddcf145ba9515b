//! Embeds the commit that the program is built from.

use std::fs;
use std::path::Path;
use std::process::Command;

fn main() {
    let train = Path::new(env!("CARGO_MANIFEST_DIR"));
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=ORGANZA_COMMIT");
    if std::env::var_os("ORGANZA_COMMIT").is_none()
        && let Some(commit) = package_commit(train).or_else(|| repository_commit(train))
    {
        println!("cargo::rustc-env=ORGANZA_COMMIT={commit}");
    }
}

/// The commit that cargo recorded when it made the package: the same for everyone who builds it.
fn package_commit(train: &Path) -> Option<String> {
    let text = fs::read_to_string(train.join(".cargo_vcs_info.json")).ok()?;
    let info: serde_json::Value = serde_json::from_str(&text).ok()?;
    let commit = info["git"]["sha1"].as_str()?;
    let is_modified = info["git"]["dirty"].as_bool() == Some(true);
    Some(named(commit, is_modified))
}

/// The commit of this repository, from git. Only release builds ask: otherwise, each commit would recompile
/// everything.
fn repository_commit(train: &Path) -> Option<String> {
    const SOURCES: [&str; 5] = ["Cargo.toml", "Cargo.lock", "host", "kit", "shader-crate"];
    if std::env::var("PROFILE").is_ok_and(|profile| profile != "release") {
        return None;
    }
    // A copy of the package in another repository has another prefix.
    if git(train, &["rev-parse", "--show-prefix"])? != "host/train/" {
        return None;
    }
    for file in ["HEAD", "logs/HEAD"] {
        let path = git(train, &["rev-parse", "--path-format=absolute", "--git-path", file])?;
        println!("cargo::rerun-if-changed={path}");
    }
    let commit = git(train, &["rev-parse", "HEAD"])?;
    let mut status = vec!["status", "--porcelain", "--untracked-files=no", "--"];
    let root = train.join("../..");
    status.extend(SOURCES);
    for source in SOURCES {
        println!("cargo::rerun-if-changed={}", root.join(source).display());
    }
    let is_modified = !git(&root, &status)?.is_empty();
    Some(named(&commit, is_modified))
}

fn named(commit: &str, is_modified: bool) -> String {
    format!("{commit}{}", if is_modified { "-modified" } else { "" })
}

/// The output of git; `None` if git fails or is not installed.
fn git(folder: &Path, words: &[&str]) -> Option<String> {
    let output = Command::new("git").arg("-C").arg(folder).args(words).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
