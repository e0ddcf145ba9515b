//! A file of a run for other programs: the table of scores.

use std::fs;
use std::path::Path;

use organza::train::metrics::{MetricsLog, Record};
use organza::train::{EVALUATIONS, METRICS};

use super::runs::{TINY, sandbox};

/// The rows of a table without quoted cells.
fn rows(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

#[test]
fn scores_of_a_run_are_a_table() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 12 --evaluate-every 5")).assert_ok();
    let records = MetricsLog::read(sandbox.path("run").join(METRICS)).unwrap();
    let mut expected = vec![["step", "view", "psnr", "ssim"].map(str::to_owned).to_vec()];
    for record in records {
        if let Record::Evaluation { step, views, .. } = record {
            expected.extend(views.iter().map(|view| {
                let [psnr, ssim] = [view.score.psnr, view.score.ssim].map(|score| score.unwrap());
                vec![step.to_string(), view.name.clone(), psnr.to_string(), ssim.to_string()]
            }));
        }
    }
    assert!(expected.len() >= 4, "evaluations after 5, 10 and 12 steps: {expected:?}");
    assert_eq!(rows(&sandbox.path("run").join(EVALUATIONS)), expected);

    let json = sandbox.run("eval run --backend cpu --json --csv scores.csv").assert_ok().stdout;
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let found = rows(&sandbox.path("scores.csv"));
    assert_eq!(found[0], ["view", "psnr", "ssim"]);
    let views = json["views"].as_array().unwrap();
    assert_eq!(found.len(), 1 + views.len());
    for (row, view) in found[1..].iter().zip(views) {
        assert_eq!(row[0], view["name"].as_str().unwrap());
        for (cell, score) in row[1..].iter().zip(["psnr", "ssim"]) {
            assert_eq!(cell.parse::<f64>().unwrap(), view[score].as_f64().unwrap());
        }
    }
    sandbox.assert_refuses("eval run --csv run/checkpoint.safetensors", &["checkpoint", "replace"]);
    sandbox
        .assert_refuses("eval run --lpips run/checkpoint.safetensors", &["organza.scene", "LPIPS"]);
}
