//! Random changes of command lines and files. The program must always end properly.
#![cfg(target_os = "linux")]

use std::process::{Command, Stdio};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};
use std::{fs, thread};

use crate::mutate::{Random, mutate_bytes, number};
use crate::sandbox::{Outcome, Sandbox, program};

/// Number of inputs in a test run. `ORGANZA_MUTATIONS` replaces it, as in `.ci/nightly`, and `ORGANZA_MUTATION_SEED`
/// sets the seed.
const INPUTS: u64 = 50;
/// A run that takes longer counts as hanging.
const LONGEST: Duration = Duration::from_secs(30);
/// Memory limit in KiB.
const MEMORY: u64 = 4_000_000;

/// Working commands to be changed. Each ends soon with any number in it.
const COMMANDS: [&str; 18] = [
    "info scene.safetensors",
    "info cameras.json --json",
    "info tiles.json",
    "info run/checkpoint.safetensors",
    "tiles scene.safetensors cameras.json tiles.json -o out --backend cpu --threads 1",
    "tiles scene.safetensors cameras.json tiles.json -o out --backend cpu --half-grids",
    "tiles scene.safetensors cameras.json tiles.json --backend cpu --grad-tiles g --grad out",
    "render scene.safetensors cameras.json -o images --backend cpu --views 0",
    "explain scene.safetensors cameras.json --pixel 48,40 --view 1",
    "explain scene.safetensors cameras.json --pixel 48,40 --all --json",
    "demo -o demo --views 1 --size 8 --backend cpu --quiet",
    "parity --adapter none",
    "bench scene.safetensors cameras.json tiles.json --backend cpu --repeat 1 --forward",
    "eval run --backend cpu",
    "eval scene.safetensors data --backend cpu --split all --downscale 4 --json",
    "edit run -o new --backend cpu --clean=0.3 --min-contribution=1",
    "train data --config small.toml --backend cpu -o new --time-limit 1 --downscale 2",
    "train --resume run --backend cpu --time-limit 1",
];

/// Input files, one of which is changed.
const FILES: [&str; 12] = [
    "scene.safetensors",
    "cameras.json",
    "tiles.json",
    "g",
    "small.toml",
    "run/checkpoint.safetensors",
    "run/config.toml",
    "run/metrics.jsonl",
    "data/transforms.json",
    "data/images/0000.png",
    "data/images/0001.png",
    "data/points.ply",
];

/// A sandbox with all inputs of the commands.
fn template() -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    let tiny = include_str!("train/tiny.toml");
    sandbox.write("tiny.toml", tiny);
    let small = tiny.replace("steps = 40", "steps = 3");
    assert_ne!(small, tiny);
    sandbox.write("small.toml", small);
    sandbox.run("render scene.safetensors cameras.json -o data/images --backend cpu").assert_ok();
    sandbox.run("tiles scene.safetensors cameras.json tiles.json -o out --backend cpu").assert_ok();
    let tiles = organza::scene::read_tensors(sandbox.path("out")).unwrap().remove("tiles").unwrap();
    let name = "grad_tiles".to_owned();
    let spec = organza::scene::TensorSpec { name, shape: tiles.shape, why: "" };
    organza::scene::write_tensors(sandbox.path("g"), &[(spec, &tiles.data)], &[]).unwrap();
    sandbox.remove("out");
    let ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
               property float z\nend_header\n0 0 0\n1 2 3\n0.5 0.1 -1\n";
    sandbox.write("data/points.ply", ply);
    let cameras = sandbox.text("cameras.json");
    let named = cameras.replacen('{', "{\"ply_file_path\": \"points.ply\",", 1);
    sandbox.write("data/transforms.json", named);
    let words =
        "train data --config small.toml --backend cpu --downscale 2 --hold-out-every 2 -o run";
    sandbox.run(words).assert_ok();
    sandbox
}

/// The words of a changed command. None is a path to files outside the sandbox.
fn mutate_words(command: &str, random: &mut Random) -> Vec<String> {
    let mut bytes = command.as_bytes().to_vec();
    (0..=random.below(2)).for_each(|_| mutate_bytes(&mut bytes, random));
    let text = String::from_utf8_lossy(&bytes).replace("..", "").replace('\0', "");
    text.split(' ').map(|word| word.trim_start_matches('/').to_owned()).collect()
}

/// Runs the program with limits; `None` if it did not end.
fn bounded(sandbox: &Sandbox, words: &[String]) -> Option<Outcome> {
    let script = format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &script]).arg(program()).args(words).current_dir(sandbox.path(""));
    command.stdin(Stdio::null()).env_remove("RUST_BACKTRACE").env_remove("XDG_RUNTIME_DIR");
    let out = fs::File::create(sandbox.path(".stdout")).unwrap();
    let err = fs::File::create(sandbox.path(".stderr")).unwrap();
    let mut child = command.stdout(out).stderr(err).spawn().expect("a shell");
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begin.elapsed() > LONGEST {
            let _ = child.kill();
            let _ = child.wait();
            return None;
        }
        thread::sleep(Duration::from_millis(3));
    }
    let read =
        |name: &str| String::from_utf8(sandbox.read(name)).expect("the program writes UTF-8");
    let code = child.wait().unwrap().code();
    Some(Outcome { code, stdout: read(".stdout"), stderr: read(".stderr") })
}

/// The fault of an outcome; `None` if it is proper.
fn fault(outcome: Option<&Outcome>) -> Option<&'static str> {
    let Some(Outcome { code, stdout, stderr }) = outcome else { return Some("hangs") };
    let is_control = |c: char| c != '\n' && (c.is_control() || c == '\u{202e}');
    let error = stderr.find("error: ").map_or("", |at| &stderr[at..]);
    if !matches!(code, Some(0 | 2)) {
        return Some("another exit code than 0 and 2");
    }
    if stderr.contains("bug in organza") || stderr.contains("panicked") {
        return Some("a bug");
    }
    if stdout.contains(is_control) || stderr.contains(is_control) {
        return Some("control characters");
    }
    if *code == Some(2) && error.is_empty() {
        return Some("no message");
    }
    (error.lines().count() > 4 || error.len() > 6000).then_some("a long message")
}

/// One input: its own sandbox, and the command to run in it.
fn input(template: &Sandbox, number: u64, seed: u64) -> (Sandbox, Vec<String>, String) {
    let mut random = Random(seed.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(number));
    let sandbox = Sandbox::copy(template);
    let command = random.one(&COMMANDS);
    let mut words: Vec<_> = command.split(' ').map(str::to_owned).collect();
    let mut changed = String::new();
    if random.below(3) == 0 {
        words = mutate_words(command, &mut random);
    } else {
        // one of the files that the command reads, if there are any
        let read: Vec<_> = FILES
            .into_iter()
            .filter(|file| {
                command.split(' ').any(|word| {
                    word == *file || matches!(word, "run" | "data") && file.starts_with(word)
                })
            })
            .collect();
        let name = if read.is_empty() { random.one(&FILES) } else { random.one(&read) };
        let mut bytes = sandbox.read(name);
        (0..=random.below(3)).for_each(|_| mutate_bytes(&mut bytes, &mut random));
        sandbox.write(name, bytes);
        changed = format!("{name} changed");
    }
    (sandbox, words, changed)
}

#[test]
fn mutated_commands_end_in_good_order() {
    if std::env::var_os("ORGANZA_VALIDATION").is_some() {
        // none of this depends on Vulkan
        return;
    }
    let inputs = number("ORGANZA_MUTATIONS", INPUTS);
    let seed = number("ORGANZA_MUTATION_SEED", 1);
    static TEMPLATE: OnceLock<Sandbox> = OnceLock::new();
    let template = TEMPLATE.get_or_init(template);
    let next = AtomicU64::new(0);
    let refused = AtomicU64::new(0);
    let work = || {
        let mut faults = Vec::new();
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= inputs {
                return faults;
            }
            let (sandbox, words, changed) = input(template, number, seed);
            let outcome = bounded(&sandbox, &words);
            let code = outcome.as_ref().and_then(|outcome| outcome.code);
            refused.fetch_add(u64::from(code == Some(2)), Ordering::Relaxed);
            if let Some(fault) = fault(outcome.as_ref()) {
                faults.push(format!("input {number}: {fault}: {words:?} {changed}\n{outcome:?}"));
            }
        }
    };
    let faults: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..2).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("no panic")).collect()
    });
    assert!(faults.is_empty(), "{} of {inputs}:\n{}", faults.len(), faults.join("\n"));
    let refused = refused.into_inner();
    eprintln!("{inputs} inputs: {refused} refused");
    assert!(refused > inputs / 4 && refused < inputs, "{refused} of {inputs} were refused");
}
