//! `organza train` as a user meets it: what a run leaves, whatever happens to it.

#[path = "train/bits.rs"]
mod bits;
#[path = "train/endings.rs"]
mod endings;
#[path = "train/eval.rs"]
mod eval;
#[path = "train/faults.rs"]
mod faults;
#[path = "train/folder.rs"]
mod folder;
#[path = "train/hostile.rs"]
mod hostile;
#[path = "train/memory.rs"]
mod memory;
#[path = "train/mistakes.rs"]
mod mistakes;
#[path = "train/monstrous.rs"]
mod monstrous;
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
#[path = "train/signals.rs"]
mod signals;
#[path = "train/waits.rs"]
mod waits;
