use super::*;
use crate::scene::{TensorRef, write_tensors};

/// `count` numbers from 0 to 1. In Python: `modf((arange(count) + 1) * 0.618... + seed * 0.37)[0]` in f64.
fn numbers(count: usize, seed: f64) -> impl Iterator<Item = f64> {
    (0..count).map(move |i| ((i + 1) as f64 * 0.618_033_988_749_894_9 + seed * 0.37).fract())
}

/// Weights from a formula: trained weights are too large for the repository.
fn made(network: &'static str, steps: &'static [Step]) -> Lpips {
    let mut convolutions = Vec::new();
    let mut weights = Vec::new();
    let mut channels = 3;
    for step in steps {
        match *step {
            Step::Convolve { outputs, side, .. } => {
                let seed = convolutions.len() as f64;
                let inputs = side * side * channels;
                let bound = (6.0 / inputs as f64).sqrt();
                let weight =
                    numbers(inputs * outputs, seed).map(|u| ((2.0 * u - 1.0) * bound) as f32);
                let bias = numbers(outputs, seed + 0.5).map(|u| ((2.0 * u - 1.0) * 0.1) as f32);
                convolutions.push([weight.collect(), bias.collect()]);
                channels = outputs;
            }
            Step::Compare => {
                let seed = 100.0 + weights.len() as f64;
                weights.push(numbers(channels, seed).map(|u| u as f32).collect());
            }
            Step::Pool { .. } => {}
        }
    }
    Lpips { network, steps, convolutions, weights }
}

/// Two images that have something in common.
fn images([width, height]: [usize; 2]) -> [Vec<[f32; 3]>; 2] {
    let colors = |at: usize| {
        let x = (at % width) as f64;
        let y = (at / width) as f64;
        [0.0, 1.0, 2.0].map(|c| {
            let a = (x * 0.037 + y * 0.061 * (c + 1.0) + 0.11).fract();
            let b = (x * y * 0.0173 + c * 0.21).fract();
            [a as f32, (0.7 * a + 0.3 * b) as f32]
        })
    };
    [0, 1].map(|image| (0..width * height).map(|at| colors(at).map(|c| c[image])).collect())
}

/// The expected numbers are from the Python package `lpips` 0.1.4 with torch 2.15, for the same weights and images.
#[test]
fn distances_match_the_python_package() {
    let [first, second] = images([70, 53]);
    for (network, steps, expected) in [("alex", ALEX, 1.987_197_9), ("vgg", VGG, 0.520_979_4)] {
        let lpips = made(network, steps);
        let found = lpips.distance([70, 53], &first, &second).unwrap().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-5, "{network}: {found} for {expected}");
        assert_eq!(lpips.distance([70, 53], &first, &first).unwrap(), Some(0.0));
        println!("{network}: {found} for {expected}");
    }
}

#[test]
fn images_may_be_too_small() {
    let lpips = made("alex", ALEX);
    for (side, is_large_enough) in [(31, true), (30, false), (2, false), (0, false)] {
        let [first, second] = images([40, side]);
        let found = lpips.distance([40, side], &first, &second).unwrap();
        assert_eq!(found.is_some(), is_large_enough, "{side}");
    }
}

/// Tests the trained weights, if `ORGANZA_LPIPS` names the folder with `lpips-alex.safetensors` and
/// `lpips-vgg.safetensors` that `scripts/lpips-weights.py` writes. The expected numbers are from the Python package
/// `lpips` 0.1.4, too.
#[test]
fn trained_weights_give_the_numbers_of_the_python_package() {
    let Some(folder) = std::env::var_os("ORGANZA_LPIPS") else { return };
    for (network, sizes) in [
        ("alex", [([70, 53], 0.019_626_161), ([40, 33], 0.011_823_940)]),
        ("vgg", [([70, 53], 0.147_447_54), ([40, 33], 0.068_124_771)]),
    ] {
        let path = Path::new(&folder).join(format!("lpips-{network}.safetensors"));
        let lpips = Lpips::load(path).unwrap();
        assert_eq!(lpips.network(), network);
        for (size, expected) in sizes {
            let [first, second] = images(size);
            let found = lpips.distance(size, &first, &second).unwrap().unwrap();
            assert!((found / expected - 1.0).abs() < 1e-5, "{network}: {found} for {expected}");
        }
    }
}

#[test]
fn other_files_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("weights.safetensors");
    let bias = vec![0.0; 64];
    let tensor = TensorRef { name: "conv.0.bias", shape: &[64], data: &bias };
    for (metadata, reason) in [
        (vec![], "no `format`"),
        (vec![("format", "organza.scene")], "its format is `organza.scene`"),
        (vec![("format", FORMAT), ("network", "squeeze")], "neither `alex` nor `vgg`"),
        (vec![("format", FORMAT), ("network", "alex")], "conv.0.weight"),
    ] {
        write_tensors(&path, &[tensor], &metadata).unwrap();
        let text = Lpips::load(&path).unwrap_err().to_string();
        assert!(text.contains(reason), "{text}");
    }
}
