//! Files of a run for other programs: a table of scores, and TensorBoard's event file.

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

/// The step of each event in a file: the second field, after 8 bytes of time. The first event has the version.
fn steps(file: &Path) -> Vec<u64> {
    let bytes = fs::read(file).unwrap();
    let mut rest = &bytes[..];
    let mut steps = Vec::new();
    while !rest.is_empty() {
        let length = u64::from_le_bytes(rest[..8].try_into().unwrap()) as usize;
        let event = &rest[12..12 + length];
        assert_eq!(event[0], 0x09, "a time comes first");
        if event[9] == 0x10 {
            // below 128, so one byte is enough
            steps.push(u64::from(event[10]));
        } else {
            assert!(steps.is_empty() && event.ends_with(b"brain.Event:2"));
        }
        rest = &rest[16 + length..];
    }
    steps
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

#[test]
fn events_have_each_step_once() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 12 --evaluate-every 5 --tensorboard")).assert_ok();
    let files: Vec<_> = fs::read_dir(sandbox.path("run/tensorboard"))
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    assert_eq!(files.len(), 1);
    let all = steps(&files[0]);
    let mut distinct = all.clone();
    distinct.dedup();
    assert_eq!(distinct, (1..=12).collect::<Vec<_>>());
    // numbers of a step; with an evaluation also its scores and pictures
    let of = |step| all.iter().filter(|&&other| other == step).count();
    assert_eq!(of(4), 1);
    let pictures = of(10) - 2;
    assert!(pictures >= 1);
    assert_eq!(of(5) - 2, 2 * pictures, "the first evaluation has the photographs, too");
    assert_eq!(of(12), of(10));
    // a finished run adds nothing
    sandbox.run("train --resume run --backend cpu").assert_ok();
    assert_eq!(steps(&files[0]), all);
}
