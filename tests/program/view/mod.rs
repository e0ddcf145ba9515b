//! `organza view` and `train --view`, for browsers and for other programs.
#![cfg(target_os = "linux")]

mod browser;
pub mod chromium;
pub mod client;
pub mod declared;
mod images;
mod protocol;
mod training;
