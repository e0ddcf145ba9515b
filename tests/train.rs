//! `organza train` as a user meets it: what a run leaves, whatever happens to it.

#[path = "train/bits.rs"]
mod bits;
#[path = "train/endings.rs"]
mod endings;
#[path = "train/eval.rs"]
mod eval;
#[path = "train/hook.rs"]
mod hook;
#[path = "train/memory.rs"]
mod memory;
#[path = "train/mistakes.rs"]
mod mistakes;
#[path = "train/results.rs"]
mod results;
#[path = "train/runs.rs"]
mod runs;
// shared with `program`, which uses more of it
#[allow(dead_code)]
#[path = "program/sandbox.rs"]
mod sandbox;
#[path = "train/settings.rs"]
mod settings;
#[path = "train/waits.rs"]
mod waits;
