//! Runs as processes of their own, and the signals that they get.
#![cfg(unix)]

use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::sandbox::Sandbox;

/// Starts the program; what it says is kept.
pub fn start(sandbox: &Sandbox, words: &str) -> Child {
    let mut command = sandbox.command(words);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// Sends a signal, such as `TERM`.
pub fn signal(child: &Child, signal: &str) {
    let kill = format!("kill -{signal} {}", child.id());
    assert!(Command::new("sh").args(["-c", &kill]).status().expect("a shell").success());
}

/// The program ends within seconds.
pub fn wait_for_end(child: &mut Child) {
    let begin = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if begin.elapsed() > Duration::from_secs(10) {
            let _ = child.kill();
            panic!("the signal was swallowed");
        }
        thread::sleep(Duration::from_millis(5));
    }
}
