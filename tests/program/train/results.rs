//! The success of training, and the run's report.

use std::fs;

use organza::train::metrics::Record;

use super::runs::{TINY, photographs, records, sandbox};

#[test]
fn held_out_views_come_closer() {
    let sandbox = sandbox();
    let config = fs::read_to_string(sandbox.path("tiny.toml")).unwrap();
    let often = config.replace("evaluate_every = 20", "evaluate_every = 5");
    assert_ne!(often, config);
    fs::write(sandbox.path("tiny.toml"), often).unwrap();
    sandbox.run(&format!("{TINY} run --steps 150")).assert_ok();
    let evaluations: Vec<_> = records(&sandbox.path("run"))
        .into_iter()
        .filter_map(|record| match record {
            Record::Evaluation { step, psnr, .. } => Some((step, psnr.expect("a number"))),
            _ => None,
        })
        .collect();
    assert_eq!(evaluations.len(), 30);
    let [first, .., last] = evaluations.as_slice() else { unreachable!("30 are more than 2") };
    assert_eq!([first.0, last.0], [5, 150]);
    // measured: 9.6 and 13.6 dB
    assert!(last.1 > first.1 + 2.5, "{first:?} {last:?}");
}

/// With a box around the part in focus, and all of space around it.
#[test]
fn a_contracted_scene_learns_and_info_names_the_contraction() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --set scene.contraction=cube")).assert_ok();
    let psnr = records(&sandbox.path("run")).into_iter().filter_map(|record| match record {
        Record::Evaluation { psnr, .. } => psnr,
        _ => None,
    });
    let psnr: Vec<_> = psnr.collect();
    // measured: 11.6 and 12.4 dB
    assert!(psnr.len() == 2 && psnr[1] > psnr[0] + 0.5, "{psnr:?}");
    let info = sandbox.run("info run").assert_ok().stdout;
    assert!(info.contains("outside the box        contracted to the unit cube"), "{info}");
    sandbox.run(&format!("{TINY} other --set scene.contraction=sphere")).assert_refused(&[
        "scene.contraction",
        "sphere",
        "`none` or `cube`",
    ]);
}

/// The page's module has tests of its content.
#[test]
fn the_report_shows_the_run() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let page = fs::read_to_string(sandbox.path("run/report.html")).unwrap();
    for text in [
        "<code>organza train views --config tiny.toml --backend cpu -o run --steps 5</code>",
        "<small>of 5</small>",
        "Photograph of view-000",
        "Error of view-003",
        "view-000 after 0 steps",
        "view-000 after 5 steps",
        "<td>start.gaussians</td><td>200</td>",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn runs_are_compared() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} a --steps 3")).assert_ok();
    sandbox.run(&format!("{TINY} b --steps 3 --seed 1")).assert_ok();
    let outcome = sandbox.run("compare a b").assert_ok();
    assert!(outcome.stdout.ends_with("run.seed\n  a: 0\n  b: 1\n"), "{outcome:?}");
    let page = fs::read_to_string(sandbox.path("comparison.html")).unwrap();
    for text in ["Photograph of view-000", "view-000, rendered by b", "<td>run.seed</td>"] {
        assert!(page.contains(text), "{text}");
    }
    let json = sandbox.run("compare a b --json -o other.html").assert_ok().stdout;
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    crate::flags::assert_documented("compare", std::slice::from_ref(&json));
    let settings = serde_json::json!([{ "name": "run.seed", "values": ["0", "1"] }]);
    assert_eq!(json["settings"], settings);
    for (at, run) in ["a", "b"].into_iter().enumerate() {
        let logged = records(&sandbox.path(run)).into_iter().find_map(|record| match record {
            Record::Evaluation { psnr, .. } => psnr,
            _ => None,
        });
        assert_eq!(json["runs"][at]["run"], run);
        assert_eq!(json["runs"][at]["psnr"].as_f64(), logged);
    }
    sandbox.assert_refuses("compare a", &["2 values", "RUN"]);
    sandbox.assert_refuses("compare a a", &["a", "named twice"]);
    sandbox.assert_refuses("compare a nowhere", &["nowhere", "config.toml"]);
    sandbox.assert_refuses("compare a b -o a/report.html", &["would replace a file of the run"]);
}

/// A single photograph, smaller than a tile: nothing is held out, and the tile's other pixels are empty.
#[test]
fn one_small_photograph_is_enough() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let frames = sandbox.path("data/transforms.json");
    let mut json: serde_json::Value = serde_json::from_slice(&fs::read(&frames).unwrap()).unwrap();
    json["frames"].as_array_mut().unwrap().truncate(1);
    fs::write(frames, json.to_string()).unwrap();
    let words = "train data --config tiny.toml --backend cpu --steps 5 -o run";
    // 96 x 80 pixels become 48 x 40
    sandbox.run(&format!("{words} --hold-out-every 0 --downscale 2 --tile-size 64")).assert_ok();
    let losses: Vec<_> = records(&sandbox.path("run"))
        .into_iter()
        .filter_map(|record| match record {
            Record::Step { loss, psnr, .. } => Some((loss, psnr)),
            Record::Evaluation { .. } => panic!("nothing is held out"),
            _ => None,
        })
        .collect();
    assert_eq!(losses.len(), 5);
    assert!(losses.iter().all(|(loss, psnr)| loss.is_finite() && psnr.is_finite()), "{losses:?}");
    let outcome = sandbox.run("eval run --backend cpu");
    outcome.assert_refused(&["no frame", "held out", "--split train"]);
}
