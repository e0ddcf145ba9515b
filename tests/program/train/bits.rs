//! The same settings come to the same bits.

use std::fs;

use organza::train::TrainConfig;
use organza_tests::devices;

use super::runs::{TINY, assert_same, bits, records, sandbox, without_times};

#[test]
fn the_same_settings_give_the_same_bits_on_any_number_of_threads() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} one --threads 1")).assert_ok();
    sandbox.run(&format!("{TINY} two --threads 2")).assert_ok();
    sandbox.run("train --config one/config.toml --backend cpu -o again").assert_ok();
    let one = bits(&sandbox, "one");
    assert_same("two threads", &bits(&sandbox, "two"), &one);
    assert_same("a run's own settings", &bits(&sandbox, "again"), &one);
    let told = |run: &str| without_times(&records(&sandbox.path(run)));
    assert_eq!(told("two"), told("one"));
    let config = |run: &str| fs::read_to_string(sandbox.path(run).join("config.toml")).unwrap();
    assert_eq!(config("again"), config("one"));
    let read = |name: &str| TrainConfig::load(sandbox.path(name)).expect("settings");
    assert_eq!(read("one/config.toml"), read("tiny.toml"));
}

#[test]
fn another_seed_gives_another_scene() {
    let sandbox = sandbox();
    let [a, b] = [0, 1].map(|seed| {
        sandbox.run(&format!("{TINY} {seed} --steps 5 --seed {seed}")).assert_ok();
        bits(&sandbox, &seed.to_string())
    });
    let name = "gaussians.position";
    assert_eq!(a[name].0, b[name].0);
    let same = a[name].1.iter().zip(&b[name].1).filter(|(a, b)| a == b).count();
    assert!(same < 6, "{same} of 600 coordinates are the same");
}

#[test]
fn a_gpu_comes_to_the_same_bits_twice() {
    if !devices::has_gpu() {
        return;
    }
    let sandbox = sandbox();
    let [first, second] = ["first", "second"].map(|run| {
        let words = "train --config tiny.toml --backend gpu --steps 14 -o";
        sandbox.run(&format!("{words} {run}")).assert_ok();
        bits(&sandbox, run)
    });
    assert!(first["gaussians.opacity"].1.len() > 200, "the scene has grown");
    assert_same("the second run", &second, &first);
}
