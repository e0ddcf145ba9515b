//! Reports tests that did not run.

use std::collections::BTreeSet;
use std::io::Write;
use std::sync::Mutex;

static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Reports, once, that something is not tested, and why.
///
/// The message bypasses the test harness, which hides the output of tests that pass.
///
/// # Panics
/// If standard error is closed.
pub fn skip(what: &str, reason: &str) {
    let line = format!("skipped {what}: {reason}");
    let mut said = SAID.lock().expect("no test panics there");
    if said.insert(line.clone()) {
        writeln!(std::io::stderr(), "{line}").expect("standard error is open");
    }
}
