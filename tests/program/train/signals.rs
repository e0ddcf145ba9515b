//! Signals at any time.
#![cfg(target_os = "linux")]

use std::thread;
use std::time::Duration;

use super::processes::{end, signal, start, start_command, steps, wait_for_end};
use super::runs::{BUILT_IN, TINY, add_views, sandbox};
use crate::sandbox::wait_until;

/// Rendering the views would take many minutes.
#[test]
fn a_signal_while_loading_ends_at_once_and_leaves_nothing() {
    let sandbox = sandbox();
    let before = sandbox.files();
    for (name, delay) in [("TERM", 0), ("INT", 100), ("HUP", 400)] {
        // the tests may run where signals are ignored
        let script = format!(
            "exec env --default-signal \"$ORGANZA\" {BUILT_IN} deep/run --set data.built_in_views=1000 \
             --set data.built_in_side=96"
        );
        let child = start_command(sandbox.shell_command(&script));
        wait_until("the folder is locked", || sandbox.path("deep/run/.organza-lock").exists());
        thread::sleep(Duration::from_millis(delay));
        signal(&child, name);
        end(child).assert_refused(&["stopped before training began", "nothing was written"]);
        assert!(before == sandbox.files(), "SIG{name} left {:?}", sandbox.files().keys());
    }
}

/// What the program writes is not read, so writing blocks: its messages, or its results after the first signal.
#[test]
fn a_signal_is_not_swallowed_where_output_blocks() {
    let sandbox = sandbox();
    sandbox.shell("mkfifo pipe").assert_ok();
    // a page is the unit in which pipes are filled
    let fill = "dd if=/dev/zero of=pipe bs=4096 oflag=nonblock 2>/dev/null";
    let start = |words: &str| {
        let script = format!("exec 3<>pipe; {fill}; exec \"$ORGANZA\" {TINY} {words}");
        start_command(sandbox.shell_command(&script))
    };
    let mut child = start("run 2>&3");
    // The folder is locked, and the next message names the device.
    wait_until("the folder is locked", || sandbox.path("run/.organza-lock").exists());
    thread::sleep(Duration::from_millis(500));
    signal(&child, "TERM");
    assert_eq!(wait_for_end(&mut child), Some(2));
    assert!(!sandbox.path("run").exists());
    let child = start("run --steps 100000 --json >&3");
    wait_until("a first step", || steps(&sandbox.path("run")) > 0);
    signal(&child, "TERM");
    thread::sleep(Duration::from_millis(600));
    signal(&child, "TERM");
    end(child).assert_refused(&["stopped by a second signal"]);
}

/// After each step, half of the views are measured. `timeout` sends two signals at once, which are one.
#[test]
fn a_signal_while_measuring_saves_and_stops() {
    let sandbox = sandbox();
    add_views(&sandbox, 60);
    let words = format!("{TINY} run --steps 100000 --hold-out-every 2 --evaluate-every 1");
    let child = start(&sandbox, &words);
    wait_until("a first step", || steps(&sandbox.path("run")) > 0);
    signal(&child, "TERM TERM");
    end(child).assert_ok().says(&["saved; `organza train --resume run`"]);
    assert!(sandbox.path("run/checkpoint.safetensors").exists());
    assert!(!sandbox.path("run/.organza-lock").exists());
}

/// A shell sends SIGHUP where its user logs out.
#[test]
fn a_run_under_nohup_outlives_the_login() {
    let sandbox = sandbox();
    let script = format!("exec nohup \"$ORGANZA\" {TINY} run --steps 100000");
    let child = start_command(sandbox.shell_command(&script));
    let folder = sandbox.path("run");
    wait_until("a first step", || steps(&folder) > 0);
    signal(&child, "HUP");
    let before = steps(&folder);
    wait_until("more steps", || steps(&folder) > before + 10);
    signal(&child, "TERM");
    end(child).assert_ok().says(&["saved; `organza train --resume run`"]);
}
