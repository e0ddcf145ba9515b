//! Trainings whose ranks are MPI processes. They need a program with the feature `mpi`, whose path is in
//! `ORGANZA_MPI`: `scripts/mpi.sh` builds it and runs these tests.

use std::fs;
use std::process::{Command, Stdio};

use super::processes::wait_for_end;
use super::runs::{TINY, assert_same, assert_same_run, bits, photographs, sandbox};
use crate::sandbox::{Outcome, Sandbox, wait_until};

/// Starts a number of processes for each command line. CI is root, and has fewer cores than there are ranks.
fn mpirun(sandbox: &Sandbox, parts: &[(usize, &str)]) -> Command {
    let program = std::env::var_os("ORGANZA_MPI").expect("scripts/mpi.sh sets it");
    let mut command = Command::new("mpirun");
    command.args(["--allow-run-as-root", "--oversubscribe"]);
    for (index, (ranks, words)) in parts.iter().enumerate() {
        command.args(if index > 0 { &[":"][..] } else { &[] });
        command.args(["-n", &ranks.to_string()]).arg(&program).args(words.split(' '));
        command.args(["--ranks", "mpi"]);
    }
    // a container may forbid reading another process's memory, and Open MPI would report that
    command.env("OMPI_MCA_btl_vader_single_copy_mechanism", "none");
    command.current_dir(sandbox.path("."));
    command
}

/// Asserts that a command succeeds.
#[track_caller]
fn assert_ok(mut command: Command) {
    let output = command.output().expect("mpirun");
    assert!(output.status.success(), "{output:?}");
}

/// Asserts that a command fails, with these words in its message.
#[track_caller]
fn assert_fails(mut command: Command, words: &[&str]) {
    let outcome = Outcome::from(command.output().expect("mpirun")).says(words);
    assert_ne!(outcome.code, Some(0), "{outcome:?}");
}

#[test]
#[ignore = "scripts/mpi.sh runs it"]
fn any_number_of_processes_gives_the_same_bits() {
    let sandbox = sandbox();
    let words = |run: &str| format!("{TINY} {run} --threads 1 --steps 14");
    sandbox.run(&format!("{} --ranks 2", words("threads"))).assert_ok();
    let threads = bits(&sandbox, "threads");
    assert!(threads["gaussians.opacity"].1.len() > 200, "the scene has grown");
    for ranks in 1..=4 {
        let run = format!("of-{ranks}");
        assert_ok(mpirun(&sandbox, &[(ranks, &words(&run))]));
        assert_same_run(&sandbox, &run, "threads");
    }
}

/// If a rank is killed, all end. Another number of ranks continues from the checkpoint.
#[test]
#[ignore = "scripts/mpi.sh runs it"]
fn a_killed_rank_ends_all_and_another_number_goes_on() {
    let sandbox = sandbox();
    let words = format!("{TINY} run --threads 1 --steps 40 --evaluate-every 0");
    let mut child = mpirun(&sandbox, &[(3, &words)])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("mpirun");
    wait_until("a checkpoint", || sandbox.path("run/checkpoint.safetensors").exists());
    let mut processes = children(child.id());
    processes.sort_unstable();
    assert!(processes.len() >= 3, "{processes:?}");
    // the process started last is not the first rank
    let last = processes.pop().expect("a process").to_string();
    assert!(Command::new("kill").args(["-KILL", &last]).status().expect("kill").success());
    assert_ne!(wait_for_end(&mut child), Some(0));

    assert_ok(mpirun(&sandbox, &[(2, "train --resume run --backend cpu --threads 1")]));
    sandbox
        .run(&format!("{TINY} whole --threads 1 --steps 40 --evaluate-every 0 --ranks 1"))
        .assert_ok();
    assert_same("resumed", &bits(&sandbox, "run"), &bits(&sandbox, "whole"));
}

#[test]
#[ignore = "scripts/mpi.sh runs it"]
fn a_rank_that_fails_says_why() {
    let sandbox = sandbox();
    sandbox.write("run/config.toml", "mine");
    let command = mpirun(&sandbox, &[(2, &format!("{TINY} run"))]);
    assert_fails(command, &["rank 0: ", "the folder already holds a run"]);
}

#[test]
#[ignore = "scripts/mpi.sh runs it"]
fn processes_that_round_differently_must_be_allowed() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let words = |set: &str| {
        format!(
            "train data --config tiny.toml --backend cpu --steps 2 -o run --instruction-set {set}"
        )
    };
    let plain = words("plain");
    let scalar = words("scalar");
    let command = mpirun(&sandbox, &[(1, &plain), (1, &scalar)]);
    assert_fails(command, &["rank 1: it is", "scalar", "`--instruction-set`", "`--mixed`"]);
    let mixed = [plain, scalar].map(|words| words.replace(" run ", " mixed ") + " --mixed");
    assert_ok(mpirun(&sandbox, &[(1, &mixed[0]), (1, &mixed[1])]));
}

/// The child processes of a process.
fn children(parent: u32) -> Vec<u32> {
    let processes = fs::read_dir("/proc").expect("Linux").flatten();
    let numbers = processes.filter_map(|entry| entry.file_name().to_str()?.parse().ok());
    let is_child = |process: &u32| {
        let stat = fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
        // after the program's name: the state, and the parent's id
        let after = stat.rsplit(") ").next().unwrap_or_default();
        after.split(' ').nth(1) == Some(&parent.to_string())
    };
    numbers.filter(is_child).collect()
}
