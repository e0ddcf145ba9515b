//! `cargo xtask coverage`: how often each line of the kernels runs in tests on the CPU, by LLVM.
//!
//! Only the crate of kernels is compiled for it, and the tests: this program stands in for the compiler of the workspace's crates.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{env, fs};

use anyhow::{Context, Result, ensure};

use crate::{Project, tool};

/// Set where this program runs as the compiler.
const AS_COMPILER: &str = "MUSLIN_COVERAGE";

/// If cargo runs this program as the compiler of a crate, compiles it, and counts what runs in it if it is the kernels' crate.
pub fn as_compiler(kernels: &str) -> Option<ExitCode> {
    env::var_os(AS_COMPILER)?;
    let mut arguments = env::args_os().skip(1);
    let mut rustc = Command::new(arguments.next()?);
    let arguments: Vec<_> = arguments.collect();
    let is_of_kernels =
        arguments.windows(2).any(|two| two[0] == "--crate-name" && two[1] == kernels);
    // a test is linked with what writes the counts
    if is_of_kernels || arguments.iter().any(|argument| argument == "--test") {
        rustc.arg("-Cinstrument-coverage");
    }
    let status = rustc.args(arguments).status().ok()?;
    Some(if status.success() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Runs tests, prints a summary and writes a page for each source.
pub fn run(project: &Project, more: &[String]) -> Result<()> {
    // before minutes are spent on compiling
    let merge = llvm_tool("profdata")?;
    let show = llvm_tool("cov")?;
    let folder = project.target.join("coverage");
    fs::remove_dir_all(&folder).or_else(|error| match error.kind() {
        std::io::ErrorKind::NotFound => Ok(()),
        _ => Err(error),
    })?;
    let tests = tests_with_counts(project, more, &folder)?;
    let counts = folder.join("counts");
    let raw = fs::read_dir(&folder)?.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    ensure!(!raw.is_empty(), "no test has run");
    run_tool(Command::new(merge).args(["merge", "-sparse", "-o"]).arg(&counts).args(raw))?;
    let show = |how: &[&str]| {
        let mut tool = Command::new(&show);
        tool.args(how).arg(format!("-instr-profile={}", counts.display()));
        for (index, test) in tests.iter().enumerate() {
            // the first is the program, and others are more of them
            tool.args((index > 0).then_some("-object")).arg(test);
        }
        run_tool(tool.args(project.sources.iter().map(|source| project.root.join(source))))
    };
    show(&["report"])?;
    let pages = folder.join("html");
    show(&[
        "show",
        "-format=html",
        "-show-instantiations=false",
        &format!("-output-dir={}", pages.display()),
    ])?;
    println!("{}", pages.join("index.html").display());
    Ok(())
}

/// Compiles and runs tests, which write their counts to a folder. Returns their programs.
fn tests_with_counts(project: &Project, more: &[String], folder: &Path) -> Result<Vec<String>> {
    let cargo = || -> Result<Command> {
        let mut cargo = tool::cargo(project);
        cargo.env(AS_COMPILER, "1").env("RUSTC_WORKSPACE_WRAPPER", env::current_exe()?);
        cargo.env("LLVM_PROFILE_FILE", folder.join("%p-%m.profraw"));
        // only what runs on the CPU is counted
        cargo.env_remove("MUSLIN_REQUIRE_GPU");
        Ok(cargo)
    };
    let mut arguments: Vec<_> = project.coverage.split_whitespace().map(OsString::from).collect();
    arguments.extend(more.iter().map(OsString::from));
    let of_cargo = arguments.iter().take_while(|argument| *argument != "--");
    let mut compile = cargo()?;
    compile.args(of_cargo).args(["--no-run", "--message-format=json"]);
    let compiled =
        compile.stderr(std::process::Stdio::inherit()).output().context("cannot run cargo")?;
    ensure!(compiled.status.success(), "the tests do not compile");
    let said = String::from_utf8_lossy(&compiled.stdout).into_owned();
    let program =
        |line: &str| Some(line.split_once("\"executable\":\"")?.1.split_once('"')?.0.to_owned());
    let status = cargo()?.args(&arguments).status().context("cannot run cargo")?;
    ensure!(status.success(), "the tests fail");
    Ok(said.lines().filter_map(program).collect())
}

/// Finds a tool of LLVM: the one that `LLVM_COV` or `LLVM_PROFDATA` names, or the compiler's own.
fn llvm_tool(name: &str) -> Result<PathBuf> {
    if let Some(given) = env::var_os(format!("LLVM_{}", name.to_uppercase())) {
        return Ok(given.into());
    }
    let output = Command::new("rustc").args(["--print", "target-libdir"]).output()?;
    let libraries = String::from_utf8(output.stdout)?;
    let tool = Path::new(libraries.trim()).with_file_name("bin").join(format!("llvm-{name}"));
    ensure!(
        tool.exists(),
        "there is no {}: `rustup component add llvm-tools` installs it",
        tool.display()
    );
    Ok(tool)
}

fn run_tool(tool: &mut Command) -> Result<()> {
    let name = tool.get_program().display().to_string();
    let status = tool.status().with_context(|| format!("cannot run {name}"))?;
    ensure!(status.success(), "{name} failed: {status}");
    Ok(())
}
