//! Settings of any size: too large ones are refused at once, with the memory needed and the memory available.
#![cfg(target_os = "linux")]

use std::time::{Duration, Instant};

use super::runs::{photographs, sandbox};

/// Address space of an ordinary machine with some memory in use, in KiB.
const LIMIT: u32 = 6_000_000;

/// Runs what must be refused soon. That includes the program's start, on a slow and busy machine.
#[track_caller]
pub fn soon<T>(what: &str, run: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = run();
    let took = start.elapsed();
    assert!(took < Duration::from_secs(30), "{what}: {took:?}");
    result
}

/// The color grid with a replacement in it.
fn grid(from: &str, to: &str) -> String {
    let grid = "[scene.color_grid]\nlevels = 8\nfeatures = 2\nlog2_table = 14\nbase_resolution = 16.0\n\
                growth = 1.35\n";
    let changed = grid.replace(from, to);
    assert_ne!(changed, grid);
    changed
}

#[test]
fn monstrous_settings_are_refused_at_once() {
    let sandbox = sandbox();
    for (settings, facts) in [
        ("[run]\ntile_size = 512\ntiles_per_step = 1000", ["tiles of a step 5.91 GiB", "needs"]),
        ("[run]\ntiles_per_step = 4294967295\ntile_size = 1", ["`run.tiles_per_step`", "at most"]),
        ("[run]\ntiles_per_step = 700000000\ntile_size = 1", ["out of memory", "tiles of a step"]),
        (
            "[start]\ngaussians = 4000000000\n[densification]\nmax_gaussians = 4000000000",
            ["`start.gaussians` is 4000000000", "expected 1 to"],
        ),
        (
            "[start]\ngaussians = 100000000\n[densification]\nmax_gaussians = 100000000",
            ["out of memory", "Adam's moments"],
        ),
        ("[data]\nbuilt_in_views = 1000\nbuilt_in_side = 2048", ["views 11.72 GiB", "available"]),
        ("[data]\nbuilt_in_views = 4294967295", ["`data.built_in_views`", "2 to 1000"]),
        ("[data]\nbuilt_in_side = 65536", ["`data.built_in_side`", "16 to 2048"]),
        (&grid("levels = 8", "levels = 4294967295"), ["color_grid.levels", "4294967295"]),
        (&grid("log2_table = 14", "log2_table = 4294967295"), ["log2_table", "4294967295"]),
        (
            &grid("base_resolution = 16.0", "base_resolution = 1e300"),
            ["base_resolution", "at most"],
        ),
        ("[scene.color_mlp]\nhidden = [4294967295]", ["color_mlp.hidden", "4294967295"]),
        ("[scene]\nmaterial = 4294967295", ["`scene.material`", "4294967295"]),
        ("[scene]\nsh_degree = 4294967295", ["`scene.sh_degree`", "4294967295"]),
        ("[scene]\nstep = 1e-30", ["`scene.step`", "16384 samples"]),
    ] {
        // sizes that a file leaves out have their defaults
        sandbox.write("monster.toml", settings);
        let before = sandbox.files();
        let words = "train --config monster.toml --backend cpu -o new";
        soon(settings, || sandbox.run_within(LIMIT, words)).assert_refused(&facts);
        assert!(before == sandbox.files(), "{settings} left {:?}", sandbox.files().keys());
    }
}

#[test]
fn monstrous_options_are_refused_at_once() {
    let sandbox = sandbox();
    photographs(&sandbox);
    for (words, facts) in [
        (
            "train data -o new --backend cpu --downscale 4294967295",
            ["4294967295", "leaves nothing"],
        ),
        (
            "train data -o new --backend cpu --downscale 4",
            [
                "0000.png",
                "leaves 24 x 20 pixels, and training needs 32 a side; use `--downscale 2`",
            ],
        ),
        ("train -o new --backend cpu --steps 99999999999", ["99999999999", "--steps"]),
    ] {
        soon(words, || sandbox.assert_refuses(words, &facts));
    }
}
