//! Each system call that writes in a training fails once, or is the last before a kill. Then the run resumes.
#![cfg(target_os = "linux")]

use std::collections::BTreeMap;
use std::fs;
use std::process::Command;

use organza::train::{BEST, CHECKPOINT, CONFIG, EVALUATIONS, METRICS, PICTURES, REPORT};

use super::runs::{Bits, assert_readable, assert_same, bits, photographs, sandbox};
use crate::sandbox::{Outcome, Sandbox, program};

/// System calls that write, or make writes durable.
const CALLS: &str = "write,fsync,rename,renameat,renameat2,unlink,ftruncate,openat";
/// One call in this many is tested, unless the environment asks for all.
const SAMPLE: usize = 8;
const RUN: &str = "train data --config tiny.toml --downscale 2 --hold-out-every 2 --backend cpu --threads 1 --steps 6 --checkpoint-every 2 -o run";
const RESUME: &str = "train --resume run --backend cpu --threads 1";

/// The name of a system call, and its number among calls of that name, from 1.
type Place = (String, usize);

/// Runs the program under strace with additional options.
fn strace(sandbox: &Sandbox, options: &[&str], words: &str) -> Outcome {
    let mut command = Command::new("strace");
    command.args(["-f", "-qq", "-y"]).args(options).arg(program()).args(words.split(' '));
    command.current_dir(sandbox.path("")).env_remove("RUST_BACKTRACE");
    command.output().expect("strace runs").into()
}

/// The calls of a run that concern its folder. strace counts the calls of each thread separately, and these belong to
/// the first one.
fn places(sandbox: &Sandbox) -> Vec<Place> {
    let trace = sandbox.path("trace");
    let options = ["-o", trace.to_str().expect("a path"), "-e", &format!("trace={CALLS}")];
    strace(sandbox, &options, RUN).assert_ok();
    let text = fs::read_to_string(&trace).unwrap();
    let first = text.split_whitespace().next().expect("a process").to_owned();
    let mut counts = BTreeMap::<String, usize>::new();
    let mut places = Vec::new();
    for line in text.lines() {
        let Some((thread, call)) = line.split_once(' ') else { continue };
        let Some((name, arguments)) = call.trim_start().split_once('(') else { continue };
        if thread != first || name.starts_with('<') {
            continue;
        }
        let count = counts.entry(name.to_owned()).or_default();
        *count += 1;
        let is_read = name == "openat" && !arguments.contains("O_CREAT");
        let is_about_it = arguments.contains("/run") || arguments.contains("\"run/");
        if is_about_it && !is_read {
            places.push((name.to_owned(), *count));
        }
    }
    fs::remove_dir_all(sandbox.path("run")).unwrap();
    places
}

/// Asserts that the run resumes and ends with the same bits, and that no other file is left.
fn assert_goes_on(sandbox: &Sandbox, what: &str, expected: &Bits) {
    let folder = sandbox.path("run");
    assert_readable(&folder);
    let outcome = sandbox.run(if folder.join(CONFIG).exists() { RESUME } else { RUN });
    assert_eq!(outcome.code, Some(0), "{what}: {outcome:?}");
    assert_same(what, &bits(sandbox, "run"), expected);
    let names: Vec<_> = sandbox.contents("run").into_keys().collect();
    assert_eq!(names, [BEST, CHECKPOINT, CONFIG, EVALUATIONS, METRICS, PICTURES, REPORT], "{what}");
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_run_goes_on_after_any_failed_write() {
    if std::env::var_os("ORGANZA_VALIDATION").is_some() {
        // none of this depends on Vulkan
        return;
    }
    if Command::new("strace").arg("-V").output().is_err() {
        assert!(std::env::var_os("ORGANZA_REQUIRE_STRACE").is_none(), "install strace");
        eprintln!("skipped: there is no strace");
        return;
    }
    let sandbox = sandbox();
    photographs(&sandbox);
    sandbox.run(RUN).assert_ok();
    let expected = bits(&sandbox, "run");
    fs::remove_dir_all(sandbox.path("run")).unwrap();
    let places = places(&sandbox);
    assert!(places.len() > 40, "{places:?}");
    for call in ["write", "fsync", "rename", "unlink"] {
        assert!(places.iter().any(|(name, _)| name.starts_with(call)), "no {call}: {places:?}");
    }
    let every = if std::env::var_os("ORGANZA_ALL_FAULTS").is_some() { 1 } else { SAMPLE };
    let faults = ["signal=KILL", "error=ENOSPC", "error=EIO"];
    let mut killed = 0;
    let mut refused = 0;
    for (number, (call, count)) in places.iter().enumerate() {
        for (which, fault) in faults.iter().enumerate() {
            // each fault at different places
            if !(number + 2 * which).is_multiple_of(every) {
                continue;
            }
            let what = format!("{fault} at {call} {count}");
            let inject = format!("inject={call}:{fault}:when={count}");
            let options = ["-o", "/dev/null", "-e", &format!("trace={call}"), "-e", &inject];
            let outcome = strace(&sandbox, &options, RUN);
            match outcome.code {
                // strace ends in the same way as its program
                None => killed += 1,
                Some(2) => {
                    outcome.assert_refused(&["cannot write"]);
                    if fault.ends_with("ENOSPC") {
                        outcome.assert_refused(&["the disk is full; ", "free some space"]);
                        let resume = outcome.stderr.contains(", then `organza train --resume run`");
                        assert_eq!(
                            resume,
                            sandbox.path("run").join(CONFIG).exists(),
                            "{outcome:?}"
                        );
                    }
                    refused += 1;
                }
                // some operations are optional, because a file system may not support them: syncing a folder,
                // removing a file
                code => assert_eq!(code, Some(0), "{what}: {outcome:?}"),
            }
            if sandbox.path("run").exists() {
                assert_goes_on(&sandbox, &what, &expected);
            }
        }
    }
    eprintln!("{} places: {killed} killed, {refused} refused", places.len());
    assert!(killed > 5 && refused > 10, "{killed} killed, {refused} refused");
}
