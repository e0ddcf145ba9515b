//! What a run learns, and its report.

use std::fs;

use organza::train::metrics::Record;
use roxmltree::{Document, ParsingOptions};

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

#[test]
fn the_report_is_xml_with_curves_and_views() {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5")).assert_ok();
    let text = fs::read_to_string(sandbox.path("run/report.html")).unwrap();
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let page = Document::parse_with_options(&text, options).expect("XML");
    let labels = |tag: &str, label: &str| -> Vec<String> {
        let found = page
            .descendants()
            .filter(|node| node.has_tag_name(tag) || node.tag_name().name() == tag);
        found.filter_map(|node| node.attribute(label)).map(str::to_owned).collect()
    };
    let curves = labels("svg", "aria-label");
    for curve in ["Loss over steps", "PSNR over steps", "Gaussians over steps"] {
        assert!(curves.iter().any(|label| label == curve), "{curve}: {curves:?}");
    }
    let views = labels("img", "alt");
    for view in ["view-000", "view-003"] {
        for picture in ["Photograph", "Rendered", "Error"] {
            let expected = format!("{picture} of {view}");
            assert!(views.contains(&expected), "{expected}: {views:?}");
        }
    }
    assert!(!labels("img", "src").iter().any(|source| !source.starts_with("data:image/")));
    assert!(labels("script", "src").is_empty() && !text.contains("<script"));
}

/// A photograph alone, smaller than a tile: nothing is held out, and nothing is in the tile's other pixels.
#[test]
fn one_small_photograph_is_enough() {
    let sandbox = sandbox();
    photographs(&sandbox);
    let frames = sandbox.path("data/transforms.json");
    let mut json: serde_json::Value = serde_json::from_slice(&fs::read(&frames).unwrap()).unwrap();
    json["frames"].as_array_mut().unwrap().truncate(1);
    fs::write(frames, json.to_string()).unwrap();
    let words = "train data --config tiny.toml --backend cpu --steps 5 -o run";
    // 96 x 80 pixels become 6 x 5
    sandbox.run(&format!("{words} --hold-out-every 0 --downscale 16 --tile-size 64")).assert_ok();
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
