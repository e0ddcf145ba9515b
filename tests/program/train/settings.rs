//! The list of settings in `docs/training.md` must match the program.

use std::fs;
use std::path::{Path, PathBuf};

use organza::train::config::{self, SETTINGS};
use organza::train::{Preset, TrainConfig};

use crate::sandbox::Sandbox;

fn path() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/training.md")
}

fn page() -> String {
    fs::read_to_string(path()).expect("the page")
}

/// The list of settings, from the program.
fn list() -> String {
    let defaults = config::defaults();
    // as `--set` takes it; a default in words is in the meaning
    let assignment = |name: &str, value: &str| match value.is_empty() || value.contains(' ') {
        true => format!("`{name}`"),
        false => format!("`{name}={value}`"),
    };
    let assignments = |name: &str| {
        if let Some((_, value)) = defaults.iter().find(|(other, _)| other == name) {
            return assignment(name, value);
        }
        let parts = defaults.iter().filter_map(|(other, value)| {
            let key = other.strip_prefix(name)?;
            key.starts_with('.').then(|| assignment(key, value))
        });
        format!("`{name}` {}", parts.collect::<Vec<_>>().join(" "))
    };
    let mut list = String::new();
    for setting in SETTINGS.iter().filter(|setting| !setting.is_hidden()) {
        let option = setting.option.split(' ').next().filter(|option| !option.is_empty());
        let option = option.map_or(String::new(), |option| format!(" (`{option}`)"));
        let see = match setting.see {
            "" => String::new(),
            link => format!("; [more]({link})"),
        };
        let name = setting.name;
        let text = setting.text();
        assert!(!text.is_empty(), "{name} has no meaning");
        list += &format!("- {}{option}: {text}{see}\n", assignments(name));
    }
    list
}

/// `INSTA_UPDATE=always` writes the list into the page.
#[test]
fn the_list_of_settings_is_the_programs() {
    let page = page();
    let expected = list();
    let start = page.find("- `data.path`").expect("a list");
    let length = page[start..].find("\n\n").expect("text behind the list") + 1;
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        let text = [&page[..start], &expected, &page[start + length..]].concat();
        fs::write(path(), text).expect("the page");
    } else {
        let found = &page[start..start + length];
        assert!(found == expected, "docs/training.md: run this test with INSTA_UPDATE=always");
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
    assert_eq!(
        config.densification, best.densification,
        "what the file leaves out is the preset's"
    );
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
        printed(&format!("--config {}", file.display())).densification,
        TrainConfig::default().densification
    );
    let config = printed("--sh-degree 3 --evaluate-every 7 --checkpoint-every 9");
    assert_eq!(
        (config.scene.sh_degree, config.run.evaluate_every, config.run.checkpoint_every),
        (3, 7, 9)
    );
}
