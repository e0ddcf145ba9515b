//! The program as a user meets it: a process, its exit code, and what it leaves behind.

#[path = "program/bad_files.rs"]
mod bad_files;
#[path = "program/bad_requests.rs"]
mod bad_requests;
#[path = "program/bench.rs"]
mod bench;
#[path = "program/corpus.rs"]
mod corpus;
#[path = "program/eval.rs"]
mod eval;
#[path = "program/hostile.rs"]
mod hostile;
#[path = "program/kernels.rs"]
mod kernels;
#[path = "program/limits.rs"]
mod limits;
#[path = "program/mutate.rs"]
mod mutate;
#[path = "program/mutations.rs"]
mod mutations;
#[path = "program/parity.rs"]
mod parity;
#[path = "program/results.rs"]
mod results;
#[path = "program/sandbox.rs"]
mod sandbox;
