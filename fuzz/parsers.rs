//! The fuzzer of one parser, which `ORGANZA_FUZZ` names.
#![no_main]

use std::process::exit;
use std::sync::OnceLock;

use libfuzzer_sys::fuzz_target;
use organza::fuzz::{TARGETS, Target};

mod held;

static TARGET: OnceLock<(&str, Target)> = OnceLock::new();

fn named() -> (&'static str, Target) {
    let name = std::env::var("ORGANZA_FUZZ").unwrap_or_default();
    let targets = TARGETS.into_iter();
    targets.clone().find(|(target, _)| *target == name).unwrap_or_else(|| {
        let names: Vec<_> = targets.map(|(target, _)| target).collect();
        eprintln!("ORGANZA_FUZZ = `{name}`, expected one of {}", names.join(", "));
        exit(2)
    })
}

fuzz_target!(|bytes: &[u8]| {
    let (name, target) = *TARGET.get_or_init(named);
    held::run(target, bytes, name);
});
