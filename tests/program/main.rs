//! The program from a user's point of view: a process, its exit code, and the files that it leaves.

mod arguments;
mod bad_files;
mod bad_requests;
mod bench;
mod capture;
mod corpus;
#[cfg(target_os = "linux")]
mod docs;
mod edit;
mod eval;
mod film;
mod flags;
mod hostile;
mod limits;
mod mesh;
#[cfg(unix)]
mod outputs;
mod parity;
mod results;
mod sandbox;
mod splats;
#[cfg(target_os = "linux")]
mod split;
mod together;
mod train;
mod view;
#[cfg(target_os = "linux")]
mod web;
