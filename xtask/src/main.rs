//! `cargo xtask new` makes a separate project: the example in `kit/examples/`, with paths to the kit's crates. All else is done by the
//! kit's tools, an example of this package. So this program is compiled in a second.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::Path;
use std::process::{Command, ExitCode};

/// Path of the example in the workspace.
const EXAMPLE: &str = "kit/examples/picture";

/// Beginning of the paths to the kit's crates.
const KIT: &str = "path = \"../..";

fn main() -> ExitCode {
    // Asks cargo at run time: a copy of the workspace may share the compiled xtask.
    let xtask = env::var_os("CARGO_MANIFEST_DIR").unwrap_or(env!("CARGO_MANIFEST_DIR").into());
    let root = Path::new(&xtask).parent().expect("a folder of the workspace");
    let arguments: Vec<_> = env::args_os().skip(1).collect();
    let result = match &arguments[..] {
        [task, folder] if task == "new" && folder != "--help" => new(root, Path::new(folder)),
        [] => Err("usage: `cargo xtask new FOLDER`, or `cargo xtask kernels`".into()),
        [task, ..] if task == "new" => {
            Err("usage: `cargo xtask new FOLDER`: it must be new or empty".into())
        }
        [task, rest @ ..] if task == "kit" => tools("kit", rest),
        [task, rest @ ..] if task == "everyday" => tools("everyday", rest),
        _ => tools("tools", &arguments),
    };
    match result {
        Ok(code) => code,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Builds the kit's tools, for organza's kernels or for its own, and runs them. With the whole workspace and an example, dependencies have the features that they have in
/// `cargo test --workspace`, so nothing is compiled twice.
fn tools(example: &str, arguments: &[OsString]) -> Result<ExitCode, String> {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(["build", "--quiet", "--workspace", "--example", example]);
    let own = env::current_exe().map_err(|error| error.to_string())?;
    let mut tools = Command::new(own.with_file_name("examples").join(example));
    for command in [&mut cargo, tools.args(arguments)] {
        let status = command.status().map_err(|error| format!("{command:?}: {error}"))?;
        if !status.success() {
            return Ok(ExitCode::FAILURE);
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Copies the example to a folder, and adapts the paths to the kit of this workspace.
fn new(root: &Path, folder: &Path) -> Result<ExitCode, String> {
    let is_empty = fs::read_dir(folder).map_or(!folder.exists(), |mut all| all.next().is_none());
    let name = folder.display();
    if !is_empty {
        return Err(format!("{name} is there already, and not empty"));
    }
    copy(root, folder).map_err(|error| format!("{name}: {error}"))?;
    println!(
        "{name} has three kernels and their tests. Now:\n  \
         cd {name}\n  \
         cargo test -p picture-kernels   # the kernels as functions, on the CPU\n  \
         cargo test                      # on the CPU in every way that it has\n  \
         cargo xtask kernels             # compiles them for GPUs\n  \
         cargo test --features gpu       # also on a GPU, in two ways"
    );
    Ok(ExitCode::SUCCESS)
}

fn copy(root: &Path, folder: &Path) -> io::Result<()> {
    copy_tree(&root.join(EXAMPLE), folder)?;
    let manifest = folder.join("Cargo.toml");
    let kit = root.canonicalize()?.join("kit").display().to_string().replace('\\', "/");
    fs::write(&manifest, fs::read_to_string(&manifest)?.replace(KIT, &format!("path = \"{kit}")))?;
    // the versions that the kit was tested with; cargo removes packages that the project does not use
    fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    Ok(())
}

fn copy_tree(from: &Path, to: &Path) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        // cargo's build output
        if entry.file_name() == "target" {
            continue;
        }
        let target = to.join(entry.file_name());
        match entry.file_type()?.is_dir() {
            true => copy_tree(&entry.path(), &target)?,
            false => drop(fs::copy(entry.path(), target)?),
        }
    }
    Ok(())
}
