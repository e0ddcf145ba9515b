//! `organza view` and `train --view`, as a browser and as other programs meet them.
#![cfg(target_os = "linux")]

mod browser;
pub mod chromium;
pub mod client;
mod film;
mod images;
mod protocol;
mod training;
