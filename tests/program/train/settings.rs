//! The table of settings in `docs/training.md` must match the program.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use organza::train::{ConfigBuilder, Preset, TrainConfig};
use serde_json::Value;

use crate::sandbox::Sandbox;

/// The values of every setting: a single one, those of a list, or the first and the last of a rate.
fn defaults() -> BTreeMap<String, Vec<Value>> {
    fn walk(name: &str, value: &Value, found: &mut BTreeMap<String, Vec<Value>>) {
        let dotted =
            |key: &str| if name.is_empty() { key.to_owned() } else { format!("{name}.{key}") };
        match value {
            Value::Object(rate) if rate.len() == 2 && rate.contains_key("first") => {
                found.insert(name.to_owned(), vec![rate["first"].clone(), rate["last"].clone()]);
            }
            Value::Object(table) => {
                table.iter().for_each(|(key, value)| walk(&dotted(key), value, found));
            }
            Value::Array(values) => {
                found.insert(name.to_owned(), values.clone());
            }
            value => {
                found.insert(name.to_owned(), vec![value.clone()]);
            }
        }
    }
    // through text, so that an f32 keeps its own digits
    let text = serde_json::to_string(&TrainConfig::default()).expect("plain values");
    let mut found = BTreeMap::new();
    walk("", &serde_json::from_str(&text).expect("JSON"), &mut found);
    // paths have no default, so they are not in the text
    found.insert("data.path".to_owned(), Vec::new());
    found.insert("start.path".to_owned(), Vec::new());
    // it is only written if it is true
    found.insert("data.allow_outside".to_owned(), vec![Value::Bool(false)]);
    found
}

fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/training.md");
    fs::read_to_string(path).expect("the page")
}

/// The rows of the table: names in backticks in the first cell, values in the second.
fn documented() -> BTreeMap<String, Vec<Value>> {
    let text = page();
    let (_, table) = text.split_once("| setting | default |").expect("a table");
    let mut found = BTreeMap::new();
    for row in table.lines().skip(2).take_while(|line| line.starts_with('|')) {
        let cells: Vec<_> = row.split('|').map(str::trim).collect();
        let values = serde_json::from_str(&format!("[{}]", cells[2]));
        let values: Vec<Value> = values.unwrap_or_else(|error| panic!("{row}: {error}"));
        assert!(!cells[3].is_empty(), "{row}: what is it?");
        for name in cells[1].split(", ") {
            let is_new = found.insert(name.trim_matches('`').to_owned(), values.clone()).is_none();
            assert!(is_new, "{name} comes twice");
        }
    }
    found
}

fn is_same(a: &Value, b: &Value) -> bool {
    match (a.as_f64(), b.as_f64()) {
        (Some(a), Some(b)) => (a - b).abs() <= 1e-9 * a.abs(),
        _ => a == b,
    }
}

#[test]
fn the_table_of_settings_is_that_of_the_program() {
    let expected = defaults();
    let found = documented();
    let names =
        |settings: &BTreeMap<String, Vec<Value>>| settings.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&found), names(&expected), "docs/training.md");
    for (name, expected) in &expected {
        let found = &found[name];
        let same =
            found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| is_same(a, b));
        assert!(same, "docs/training.md says that `{name}` is {found:?}, but it is {expected:?}");
    }
}

#[test]
fn the_settings_of_the_built_in_scene_are_those_of_the_program() {
    let page = page();
    let (_, text) = page.split_once("### The built-in scene\n").expect("a heading");
    let (_, text) = text.split_once("```toml\n").expect("settings");
    let (text, _) = text.split_once("```").expect("an end");
    let found = TrainConfig::parse(text, Path::new("docs/training.md")).expect("settings");
    let preset =
        |preset| ConfigBuilder::new(preset).and_then(ConfigBuilder::build).expect("settings");
    assert_eq!(found, preset(Preset::BuiltIn));
    assert_eq!(preset(Preset::Default), TrainConfig::default());
    for other in [Preset::Fast, Preset::Best, Preset::BuiltIn] {
        assert_ne!(preset(other), TrainConfig::default(), "{}", other.name());
    }
}

/// The settings that `--print-config` prints for some options.
#[track_caller]
fn printed(words: &str) -> TrainConfig {
    let outcome = Sandbox::new("tiny").run(&format!("train --print-config {words}")).assert_ok();
    assert_eq!(outcome.stderr, "");
    TrainConfig::parse(&outcome.stdout, Path::new("the printed settings")).expect("settings")
}

#[test]
fn later_settings_override_earlier_ones() {
    let sandbox = Sandbox::new("tiny");
    let file = sandbox.path("mine.toml");
    fs::write(&file, "[run]\nsteps = 11\ntile_size = 32\nseed = 5\n").unwrap();
    let best = printed("/data --preset best");
    let mut expected = TrainConfig::parse(Preset::Best.toml(), Path::new("best.toml")).unwrap();
    expected.data.path = Some("/data".into());
    assert_eq!(best, expected);
    let words = format!("/data --preset best --config {}", file.display());
    let config = printed(&words);
    assert_eq!((config.run.steps, config.run.tile_size, config.run.seed), (11, 32, 5));
    assert_eq!(config.growth, best.growth, "what the file leaves out is the preset's");
    // only a part of a table
    let grid = sandbox.path("grid.toml");
    fs::write(&grid, "[scene.color_grid]\nlevels = 9\n[optimizer]\ngrids.last = 1e-3\n").unwrap();
    let config = printed(&format!("/data --preset best --config {}", grid.display()));
    let mut expected = best.clone();
    expected.scene.color_grid.levels = 9;
    expected.optimizer.grids.last = 1e-3;
    assert_eq!(config, expected);
    let config =
        printed(&format!("{words} --set run.steps=12 --set run.steps=13 --set run.seed=6"));
    assert_eq!((config.run.steps, config.run.tile_size, config.run.seed), (13, 32, 6));
    let config = printed(&format!("{words} --set run.steps=12 --steps 14"));
    assert_eq!((config.run.steps, config.run.seed), (14, 5));
    // without a data set
    let built_in = printed("");
    assert_eq!(built_in, printed("--preset built-in"));
    assert_eq!(built_in.run.steps, 1000);
    assert_eq!(printed("--preset default"), TrainConfig::default());
    assert_eq!(
        printed(&format!("--config {}", file.display())).growth,
        TrainConfig::default().growth
    );
    let config = printed("--sh-degree 3 --evaluate-every 7 --checkpoint-every 9");
    assert_eq!(
        (config.scene.sh_degree, config.run.evaluate_every, config.run.checkpoint_every),
        (3, 7, 9)
    );
}
