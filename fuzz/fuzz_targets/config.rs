#![no_main]

#[path = "../held.rs"]
mod held;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| held::run(organza::fuzz::config, bytes, "config"));
