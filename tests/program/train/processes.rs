//! Runs in separate processes, and the signals sent to them.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use organza::train::METRICS;

use crate::sandbox::{Outcome, Sandbox};

/// Starts the program, and captures its output.
pub fn start(sandbox: &Sandbox, words: &str) -> Child {
    start_command(sandbox.command(words))
}

/// Like [`start`], with any command.
pub fn start_command(mut command: Command) -> Child {
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// The number of steps in the log of a run, which may still be written.
pub fn steps(folder: &Path) -> usize {
    let text = fs::read_to_string(folder.join(METRICS)).unwrap_or_default();
    text.lines().filter(|line| line.starts_with("{\"kind\":\"step\"")).count()
}

/// Sends signals, such as `TERM`, one right after the other.
pub fn signal(child: &Child, signals: &str) {
    let kill = |signal: &str| format!("kill -{signal} {};", child.id());
    let kill: String = signals.split(' ').map(kill).collect();
    assert!(Command::new("sh").args(["-c", &kill]).status().expect("a shell").success());
}

/// Waits for the program's end, which must come within a minute. Returns its exit code.
pub fn wait_for_end(child: &mut Child) -> Option<i32> {
    let begin = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code();
        }
        if begin.elapsed() > Duration::from_secs(60) {
            let _ = child.kill();
            panic!("the signal was swallowed");
        }
        thread::sleep(Duration::from_millis(5));
    }
}

/// Like [`wait_for_end`], with the output.
pub fn end(mut child: Child) -> Outcome {
    wait_for_end(&mut child);
    child.wait_with_output().expect("it has ended").into()
}
