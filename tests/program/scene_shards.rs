//! `render --ranks` and `tiles --ranks`: Gaussians distributed over ranks.

use std::collections::BTreeMap;
use std::fs;

use organza::scene::{TensorRef, read_tensors, write_tensors};

use crate::sandbox::Sandbox;

const RENDER: &str = "render scene.safetensors cameras.json --backend cpu --views 0";

/// The only image of a folder: its bytes, and its pixels.
fn image(sandbox: &Sandbox, folder: &str) -> (Vec<u8>, Vec<u8>) {
    let mut images = sandbox.images(folder);
    let (_, file) = images.pop_first().expect("an image");
    assert!(images.is_empty(), "{:?}", images.keys());
    let pixels = image::load_from_memory(&file).expect("an image").to_rgb8().into_raw();
    (file, pixels)
}

#[test]
fn any_number_of_ranks_renders_the_same_image() {
    let sandbox = Sandbox::new("basic");
    sandbox.run(&format!("{RENDER} -o whole")).assert_ok();
    sandbox.run(&format!("{RENDER} -o one --ranks 1")).assert_ok();
    let json = sandbox.run(&format!("{RENDER} -o three --ranks 3 --json")).json();
    assert!(json["rendered"] == 1 && json["pairs"].as_u64() > Some(0), "{json}");
    let (one, pixels) = image(&sandbox, "one");
    assert!(image(&sandbox, "three").0 == one);
    // sums have another rounding
    let (_, whole) = image(&sandbox, "whole");
    let differ = pixels.iter().zip(&whole).filter(|(a, b)| a != b).count();
    assert!(pixels.iter().any(|&value| value > 50) && differ < pixels.len() / 100, "{differ}");
    assert!(pixels.iter().zip(&whole).all(|(a, b)| a.abs_diff(*b) <= 1));
    // existing images stay, for any number of ranks
    let outcome = sandbox.run(&format!("{RENDER} -o three --ranks 2 --missing")).assert_ok();
    assert!(outcome.stderr.contains("nothing to render"), "{}", outcome.stderr);
}

/// The basic case has 48 Gaussians, which are a single slice: most ranks have none.
#[test]
fn any_number_of_ranks_gives_the_same_tiles_and_gradients() {
    let sandbox = Sandbox::new("basic");
    let tiles = "tiles scene.safetensors cameras.json tiles.json --backend cpu";
    sandbox.run(&format!("{tiles} -o whole.safetensors")).assert_ok();
    let read = |name: &str| read_tensors(sandbox.path(name)).expect("tensors");
    let whole = read("whole.safetensors").remove("tiles").expect("tiles");
    let shape = &whole.shape[..];
    let data = &whole.data[..];
    let output = TensorRef { name: "grad_tiles", shape, data };
    write_tensors(sandbox.path("output.safetensors"), &[output], &[]).expect("a file");
    let gradient = "--grad-tiles output.safetensors --grad";
    sandbox.run(&format!("{tiles} {gradient} whole-grad.safetensors")).assert_ok();
    for ranks in [1, 3] {
        let files = format!("-o tiles-{ranks}.safetensors {gradient} grad-{ranks}.safetensors");
        sandbox.run(&format!("{tiles} {files} --ranks {ranks}")).assert_ok();
    }
    for [name, whole] in [["tiles", "whole"], ["grad", "whole-grad"]] {
        let [one, three] = [1, 3].map(|ranks| format!("{name}-{ranks}.safetensors"));
        assert!(fs::read(sandbox.path(&one)).unwrap() == fs::read(sandbox.path(&three)).unwrap());
        let shapes = |name: &str| -> BTreeMap<_, _> {
            read(name).into_iter().map(|(name, tensor)| (name, tensor.shape)).collect()
        };
        assert_eq!(shapes(&one), shapes(&format!("{whole}.safetensors")));
    }
}

#[test]
fn bad_options_of_ranks_are_refused() {
    let sandbox = Sandbox::new("basic");
    let refuses = |words: &str, facts: &[&str]| {
        sandbox.assert_refuses(&format!("{RENDER} -o out {words}"), facts);
    };
    refuses("--ranks 2 --channels depth", &["`--channels`", "leave out `--ranks`"]);
    refuses("--ranks 0", &["1 to 64, or `mpi`"]);
    refuses("--ranks mpi", &["built without MPI", "--features mpi"]);
    refuses("--mixed", &["--ranks"]);
    // a failing rank ends all, and its error is reported
    fs::write(sandbox.path("scene.safetensors"), "not a scene").unwrap();
    sandbox.assert_refuses(&format!("{RENDER} -o out --ranks 3"), &["scene.safetensors"]);
}
