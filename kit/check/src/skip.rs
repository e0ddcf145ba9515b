//! Reports what was not tested.

use std::collections::BTreeSet;
use std::io::Write;
use std::sync::Mutex;

static SAID: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// Says, once, that something is left out, and why.
///
/// It goes past the test harness, which shows nothing of what tests print that pass.
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
