//! Trainings whose ranks are processes of MPI's. They need a program that was built with the feature `mpi`, whose path is in
//! `ORGANZA_MPI`: `scripts/mpi.sh` builds it and runs these.

use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{fs, thread};

use super::runs::{TINY, assert_same, bits, records, sandbox, without_times};
use crate::sandbox::Sandbox;

/// The program, and `mpirun`'s options: CI is root, and has fewer cores than there are ranks.
fn mpirun(sandbox: &Sandbox, ranks: usize, words: &str) -> Option<Command> {
    let program = PathBuf::from(std::env::var_os("ORGANZA_MPI")?);
    let mut command = Command::new("mpirun");
    command.args(["--allow-run-as-root", "--oversubscribe", "-n", &ranks.to_string()]);
    command.arg(program).args(words.split(' ')).args(["--ranks", "mpi"]);
    command.current_dir(sandbox.path("."));
    Some(command)
}

#[test]
fn any_number_of_processes_gives_the_same_bits() {
    let sandbox = sandbox();
    let words = |run: &str| format!("{TINY} {run} --threads 1");
    sandbox.run(&format!("{} --ranks 2", words("threads"))).assert_ok();
    let threads = bits(&sandbox, "threads");
    assert!(threads["gaussians.opacity"].1.len() > 200, "the scene has grown");
    let told = |run: &str| without_times(&records(&sandbox.path(run)));
    for ranks in 1..=4 {
        let run = format!("of-{ranks}");
        let Some(mut command) = mpirun(&sandbox, ranks, &words(&run)) else { return };
        let output = command.output().expect("mpirun");
        assert!(output.status.success(), "{ranks}: {output:?}");
        assert_same(&run, &bits(&sandbox, &run), &threads);
        assert_eq!(told(&run), told("threads"));
    }
}

/// All end with the rank that is killed; another number of ranks goes on from the checkpoint.
#[test]
fn a_killed_rank_ends_all_and_another_number_goes_on() {
    let sandbox = sandbox();
    let words = format!("{TINY} run --threads 1 --steps 120 --evaluate-every 0");
    let Some(mut command) = mpirun(&sandbox, 3, &words) else { return };
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("mpirun");
    let begin = Instant::now();
    while !sandbox.path("run/checkpoint.safetensors").exists() {
        assert!(begin.elapsed() < Duration::from_secs(60), "no checkpoint");
        thread::sleep(Duration::from_millis(20));
    }
    let mut processes = children(child.id());
    processes.sort_unstable();
    assert!(processes.len() >= 3, "{processes:?}");
    // the last one that was started is not the first rank
    let last = processes.pop().expect("a process").to_string();
    assert!(Command::new("kill").args(["-KILL", &last]).status().expect("kill").success());
    assert!(!child.wait().expect("mpirun").success());
    assert!(begin.elapsed() < Duration::from_secs(60), "the others went on");

    let resume = "train --resume run --backend cpu --threads 1";
    let output = mpirun(&sandbox, 2, resume).expect("the program").output().expect("mpirun");
    assert!(output.status.success(), "{output:?}");
    sandbox
        .run(&format!("{TINY} whole --threads 1 --steps 120 --evaluate-every 0 --ranks 1"))
        .assert_ok();
    assert_same("resumed", &bits(&sandbox, "run"), &bits(&sandbox, "whole"));
}

#[test]
fn a_rank_that_fails_says_why() {
    let sandbox = sandbox();
    fs::create_dir(sandbox.path("run")).unwrap();
    fs::write(sandbox.path("run/config.toml"), "mine").unwrap();
    let Some(mut command) = mpirun(&sandbox, 2, &format!("{TINY} run")) else { return };
    let output = command.output().expect("mpirun");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && told.contains("rank 0: "), "{told}");
    assert!(told.contains("the folder already holds a run"), "{told}");
}

/// The processes that a process has started.
fn children(parent: u32) -> Vec<u32> {
    let output = Command::new("ps").args(["-o", "pid=", "--ppid", &parent.to_string()]).output();
    let text = String::from_utf8(output.expect("ps").stdout).expect("numbers");
    text.split_whitespace().filter_map(|word| word.parse().ok()).collect()
}
