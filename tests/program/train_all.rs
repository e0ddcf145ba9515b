//! `organza train-all`: the table must have the results of the runs.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use organza::train::metrics::{MetricsLog, Record};
use organza::train::{CHECKPOINT, METRICS};
use safetensors::tensor::{Dtype, TensorView};

use crate::flags::assert_documented;
use crate::sandbox::Sandbox;

#[test]
fn captures_are_trained_on_and_compared() {
    let sandbox = Sandbox::new("tiny");
    fs::write(sandbox.path("tiny.toml"), include_str!("train/tiny.toml")).unwrap();
    for name in ["one", "two"] {
        sandbox
            .run(&format!("render scene.safetensors cameras.json -o {name}/images --backend cpu"))
            .assert_ok();
        fs::copy(sandbox.path("cameras.json"), sandbox.path(name).join("transforms.json")).unwrap();
    }
    let words = "train-all one two/transforms.json -o results --config tiny.toml --steps 8 \
                 --downscale 2 --hold-out-every 2 --backend cpu";
    let table = sandbox.run(words).assert_ok().stdout;
    let markdown = fs::read_to_string(sandbox.path("results/results.md")).unwrap();
    let csv = fs::read_to_string(sandbox.path("results/results.csv")).unwrap();
    assert_eq!(csv.lines().next(), Some("capture,PSNR,SSIM,steps,Gaussians,MB,minutes"));
    for name in ["one", "two"] {
        let run = sandbox.path("results").join(name);
        let records = MetricsLog::read(run.join(METRICS)).unwrap();
        let Some(Record::Evaluation { step: 8, psnr: Some(psnr), ssim: Some(ssim), .. }) =
            records.iter().rfind(|record| matches!(record, Record::Evaluation { .. }))
        else {
            panic!("{records:?}")
        };
        let gaussians = organza::Scene::load(run.join(CHECKPOINT)).unwrap().gaussians.len();
        let row = format!("\"{name}\",{psnr:.2},{ssim:.4},8,{gaussians},");
        assert!(csv.contains(&row), "{row} is not in\n{csv}");
        assert!(markdown.contains(&format!("| [{name}]({name}/report.html) | {psnr:.2} |")));
        assert!(run.join("report.html").exists());
        assert!(table.contains(&format!("{psnr:.2}")), "{table}");
    }
    // finished runs are included unchanged
    assert_eq!(sandbox.run(words).assert_ok().stdout, table);
    assert_eq!(fs::read_to_string(sandbox.path("results/results.csv")).unwrap(), csv);
    let json = sandbox.run(&format!("{words} --json --quiet")).json();
    assert_documented("train-all", &[json]);
    with_lpips(&sandbox, words);
    sandbox.assert_refuses("train-all one one -o again --backend cpu", &["two captures", "one"]);
    assert!(!sandbox.path("again").exists());
}

/// The additional column has the mean that `organza eval` prints.
fn with_lpips(sandbox: &Sandbox, words: &str) {
    save_weights(&sandbox.path("weights.safetensors"));
    let words = format!("{words} --lpips weights.safetensors");
    let json = sandbox.run(&format!("{words} --json --quiet")).json();
    let csv = fs::read_to_string(sandbox.path("results/results.csv")).unwrap();
    assert!(csv.starts_with("capture,PSNR,SSIM,LPIPS,steps,"), "{csv}");
    for (name, capture) in ["one", "two"].iter().zip(json["captures"].as_array().unwrap()) {
        let eval = format!("eval results/{name} --lpips weights.safetensors --json --backend cpu");
        let eval = sandbox.run(&eval).json();
        assert!(eval["mean"]["lpips"].as_f64().is_some_and(|lpips| lpips > 0.0), "{eval}");
        assert_eq!(capture["lpips"], eval["mean"]["lpips"]);
        let row = csv.lines().find(|line| line.starts_with(&format!("\"{name}\","))).unwrap();
        assert_eq!(
            row.split(',').nth(3).unwrap(),
            format!("{:.4}", capture["lpips"].as_f64().unwrap())
        );
    }
    // refused before any training
    let refused = "train-all one -o late --lpips cameras.json --backend cpu";
    sandbox.assert_refuses(refused, &["cameras.json"]);
    assert!(!sandbox.path("late").exists());
}

/// Weights in AlexNet's shapes, as described in docs/pipeline.md, from a formula: trained weights are too large
/// for the repository.
fn save_weights(path: &Path) {
    let mut tensors = Vec::new();
    let mut add = |name: String, shape: Vec<usize>, lowest: f32| {
        let count: usize = shape.iter().product();
        let value = |i: usize| (i as f64 * 0.618).fract() as f32 + lowest;
        let bytes: Vec<u8> = (0..count).flat_map(|i| value(i).to_le_bytes()).collect();
        tensors.push((name, shape, bytes));
    };
    let convolutions = [[11, 3, 64], [5, 64, 192], [3, 192, 384], [3, 384, 256], [3, 256, 256]];
    for (index, [side, inputs, outputs]) in convolutions.into_iter().enumerate() {
        add(format!("conv.{index}.weight"), vec![side, side, inputs, outputs], -0.5);
        add(format!("conv.{index}.bias"), vec![outputs], -0.5);
        add(format!("linear.{index}.weight"), vec![outputs], 0.0);
    }
    let views = tensors.iter().map(|(name, shape, bytes)| {
        (name, TensorView::new(Dtype::F32, shape.clone(), bytes).unwrap())
    });
    let metadata = [("format", "organza.lpips"), ("network", "alex")];
    let metadata = metadata.map(|(key, value)| (key.to_owned(), value.to_owned()));
    safetensors::serialize_to_file(views, Some(HashMap::from(metadata)), path).unwrap();
}
