//! Every command in the README and in `docs/` runs as written, with the program in place of `cargo run`, or is listed
//! in [`NOT_RUN`] with a reason. So do blocks of Python, if Python has the modules that they import.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::sandbox::{Sandbox, program};

/// Beginnings of commands that are not run here, with the reason.
const NOT_RUN: &[(&str, &str)] = &[
    ("cargo test", "these tests"),
    ("INSTA_UPDATE=always", "it changes the repository"),
    ("MUSLIN_WRITE_ISA=1", "it changes the repository"),
    ("cargo insta ", "it is installed apart, and asks questions"),
    ("cargo xtask", "`.ci/run` runs it: it needs the shader compiler"),
    ("scripts/build-rust-gpu-toolchain.sh", "`.ci/run` runs it: it takes 25 minutes at first"),
    ("cargo run -- parity", "tests/program/parity.rs runs it"),
    ("cargo build", "it compiles"),
    ("cargo install", "it compiles; `.ci/run` runs it"),
    ("organza view", "it shows a page until Ctrl-C; tests/program/view does that"),
    ("cd tests/cases", "a debugger follows"),
    ("rust-gdb", "it is a debugger, and asks questions"),
    ("perf record", "it is a profiler, and not everywhere"),
    ("organza bench [", "it shows the syntax"),
    ("python bench/", "it takes minutes, and needs other programs"),
    ("organza film run -o film.mp4", "it needs ffmpeg, which not everybody has"),
    ("SHARD=7/40 scripts/mutants.sh", "it takes hours, and needs cargo-mutants"),
    ("apt install", "it changes the machine"),
    ("organza capture", "it needs ffmpeg and COLMAP; `.ci/nightly` runs it"),
    ("organza train garden", "it needs ffmpeg and COLMAP; tests/program/capture.rs has stand-ins"),
    ("organza train still", "it needs what `organza capture` makes"),
    ("organza split", "it needs more photographs; tests/program/split.rs runs these"),
    ("organza train blocks", "it needs what `organza split` makes"),
    ("organza render runs", "it needs what `organza train` makes of blocks"),
    ("organza mesh", "a scene of so few steps has no surfaces; tests/program/mesh.rs runs it"),
    ("organza film garden", "it needs ffmpeg, which not everybody has"),
    ("organza export-web garden", "it needs what `organza train` makes of a video"),
    ("pip ", "it needs PyPI"),
    ("python scripts/lpips.py", "it needs packages of PyPI"),
    ("python scripts/reproducibility.py", "it trains ten times"),
    ("python scripts/tensorboard.py", "it needs packages of TensorBoard"),
    ("tensorboard --logdir", "it shows a page until Ctrl-C"),
];

/// Pages whose trainings show the built-in scene, as they say.
const BUILT_IN: [&str; 3] = ["README.md", "docs/editing.md", "docs/splats.md"];

/// The program, with options that make it quick.
const ORGANZA: &str = include_str!("stand_ins/organza.sh");

/// Replaces cargo: it only runs the program.
const CARGO: &str = include_str!("stand_ins/cargo.sh");

/// A block of code on a page.
#[derive(Debug)]
struct Block {
    page: String,
    language: String,
    text: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The blocks of the README and of `docs/`, by page.
fn blocks() -> Vec<Block> {
    let docs = fs::read_dir(root().join("docs")).expect("docs");
    let docs = docs.map(|entry| format!("docs/{}", entry.unwrap().file_name().display()));
    let pages: BTreeSet<_> = docs.filter(|page| page.ends_with(".md")).collect();
    let mut blocks = Vec::new();
    for page in ["README.md".to_owned()].into_iter().chain(pages) {
        let text = fs::read_to_string(root().join(&page)).expect("a page");
        let fences: Vec<_> = text.split("\n```").collect();
        assert!(fences.len() % 2 == 1, "{page}: a block has no end");
        for block in fences.iter().skip(1).step_by(2) {
            let (language, text) = block.split_once('\n').unwrap_or((block, ""));
            let page = page.clone();
            let language = language.trim().to_owned();
            blocks.push(Block { page, language, text: text.to_owned() });
        }
    }
    blocks
}

/// The commands of a block, one per line. A line that ends in `\` continues.
fn commands(text: &str) -> Vec<String> {
    let joined = text.replace("\\\n", " ");
    let without_comment = |line: &str| line.split(" #").next().unwrap_or("").trim().to_owned();
    joined.lines().map(without_comment).filter(|line| !line.is_empty()).collect()
}

/// A folder for a page: a scene, its cameras, tiles, the data sets that the page names, and programs in `bin`. Only
/// [`BUILT_IN`] train on the built-in scene, other pages on photographs.
fn prepare(page: &str, blocks: &[Block]) -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    sandbox.write_program("organza", ORGANZA);
    sandbox.write_program("cargo", CARGO);
    // not everybody has it, and it is not under test
    if Command::new("jq").arg("--version").output().is_err() {
        sandbox.write_program("jq", "#!/bin/sh\ncat\n");
    }
    let texts = blocks.iter().filter(|block| block.page == page).map(|block| &block.text);
    let words = texts.flat_map(|text| text.split_whitespace());
    let named = words.filter(|word| word.starts_with("data/"));
    let own = (!BUILT_IN.contains(&page)).then_some("photographs");
    let data: BTreeSet<_> = named.chain(own).collect();
    for folder in data {
        let words =
            format!("render scene.safetensors cameras.json -o {folder}/images --backend cpu");
        sandbox.run(&words).assert_ok();
        let transforms = sandbox.path(folder).join("transforms.json");
        fs::copy(sandbox.path("cameras.json"), transforms).unwrap();
    }
    sandbox
}

/// Runs a program in a page's folder.
fn run(sandbox: &Sandbox, page: &str, words: &[&str]) {
    let bin = sandbox.path("bin");
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths([bin].into_iter().chain(std::env::split_paths(&path)));
    let output = Command::new(words[0])
        .args(&words[1..])
        .current_dir(sandbox.path(""))
        .env("PATH", path.unwrap())
        .env("PROGRAM", program())
        .output()
        .unwrap_or_else(|error| panic!("{}: {error}", words[0]));
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{page}: {}\n{}\n{text}", words.join(" "), output.status);
}

#[test]
fn every_command_of_the_pages_runs() {
    let blocks = blocks();
    let pages: BTreeSet<_> = blocks.iter().map(|block| block.page.clone()).collect();
    let mut ran = 0;
    let mut unused = NOT_RUN.iter().collect::<Vec<_>>();
    for page in pages {
        let shell = blocks.iter().filter(|block| block.page == page && block.language == "sh");
        let mut sandbox = None;
        for block in shell {
            let mut script = Vec::new();
            for command in commands(&block.text) {
                let is_not_run = |(begin, _): &&(&str, &str)| command.starts_with(begin);
                match NOT_RUN.iter().find(is_not_run) {
                    Some(entry) => unused.retain(|other| *other != entry),
                    None => script.push(command),
                }
            }
            if !script.is_empty() {
                ran += script.len();
                let sandbox = sandbox.get_or_insert_with(|| prepare(&page, &blocks));
                run(sandbox, &page, &["sh", "-euxc", &script.join("\n")]);
            }
        }
    }
    assert!(ran >= 10, "only {ran} commands were found");
    assert!(unused.is_empty(), "no page has a command that begins with one of {unused:?}");
}

#[test]
fn every_block_of_python_runs() {
    let has_modules = Command::new("python3").args(["-c", "import numpy, safetensors"]).output();
    if !has_modules.is_ok_and(|output| output.status.success()) {
        println!("skipped: python3 with numpy and safetensors is not here");
        return;
    }
    let blocks = blocks();
    let python: Vec<_> = blocks.iter().filter(|block| block.language == "python").collect();
    assert!(!python.is_empty(), "no page has a block of Python");
    for block in python {
        run(&prepare(&block.page, &blocks), &block.page, &["python3", "-c", &block.text]);
    }
}

/// Rust code of the README is in the library's documentation, and of the guide in the example. A block that begins with the
/// path of a file is in that file. All of these are compiled.
#[test]
fn rust_of_the_pages_is_compiled() {
    let read = |path: &str| fs::read_to_string(root().join(path)).expect("a file");
    let library = read("host/src/lib.rs");
    let lines = library.lines().filter_map(|line| line.strip_prefix("//!"));
    let lines = lines.map(|line| line.strip_prefix(' ').unwrap_or(line));
    let library = lines.filter(|line| !line.starts_with("# ")).collect::<Vec<_>>().join("\n");
    let example = ["kernels/src/lib.rs", "src/lib.rs", "tests/kernels.rs"];
    let example = example.map(|file| read(&format!("kit/examples/picture/{file}"))).concat();
    let mut shown = 0;
    for Block { page, language, text } in blocks() {
        let named = text.strip_prefix("// ").and_then(|text| text.split_once('\n'));
        let (file, code) = match (named, &*page, &*language) {
            (Some((path, code)), ..) if path.ends_with(".rs") => (read(path), code),
            (_, "README.md", "rust") => (library.clone(), &*text),
            (_, "docs/adding-a-kernel.md", "rust") => (example.clone(), &*text),
            _ => continue,
        };
        assert!(file.contains(code.trim()), "{page}: in no file that is compiled:\n{text}");
        shown += 1;
    }
    assert!(shown >= 8, "the pages show {shown} blocks");
}

/// A block that the tests above do not know would never be run.
#[test]
fn blocks_are_marked_with_their_language() {
    let known = ["sh", "python", "rust", "toml", "json", "text", "math", "wgsl", "glsl", ""];
    for Block { page, language, text } in blocks() {
        assert!(known.contains(&&*language), "{page}: `{language}` is not a language of {known:?}");
        let command = ["organza ", "cargo ", "python "];
        let looks = |line: &str| command.iter().any(|name| line.starts_with(name));
        let is_marked = language == "sh" || !text.lines().any(looks);
        assert!(is_marked, "{page}: commands belong in a block of `sh`:\n{text}");
    }
}
