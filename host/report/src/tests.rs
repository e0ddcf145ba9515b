use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use html5ever::tendril::TendrilSink;
use html5ever::{ParseOpts, parse_document};
use markup5ever_rcdom::{Handle, NodeData, RcDom};
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::charts::Number;
use super::pictures::Pictures;
use super::*;
use organza_core::image::Image;
use organza_data::Photograph;
use organza_train::evaluate::{Score, ViewScore};
use organza_train::metrics::{MetricsLog, Record, SessionInfo, TimingRow};
use organza_train::{CONFIG, Change, METRICS, TrainConfig};

/// Text that must not become part of a page's markup.
const NASTY: &str =
    "</title></script><script>alert(\"1\")</script><img src=x onerror=alert(1)>&amp;\0'\u{1b}";
/// The same text as a page shows it.
const SHOWN: &str = "</title></script><script>alert(\"1\")</script><img src=x onerror=alert(1)>&amp;\u{fffd}'\u{fffd}";

fn step(step: u64) -> Record {
    let t = step as f64 / 2000.0;
    let noise = (step as f64 * 1.7).sin() * (step as f64 * 0.31).cos();
    let loss = 0.02 + 0.4 * (-12.0 * t).exp() + 0.006 * noise;
    Record::Step {
        step,
        seconds: 760.0 * t,
        loss,
        l1: 0.8 * loss,
        ssim: 1.0 - 1.2 * loss,
        psnr: 27.0 - 14.0 * (-6.0 * t).exp() + 1.2 * noise,
        tiles_per_second: 90.0 - 30.0 * t + 5.0 * noise,
        gaussians: 1000 + step,
        rates: BTreeMap::new(),
    }
}

fn evaluation(step: u64, names: &[&str]) -> Record {
    let score = Score {
        psnr: Some(20.0 + step as f64 / 777.0),
        ssim: Some(0.5 + step as f64 / 7e3),
        ..Score::default()
    };
    let view = |name: &&str| ViewScore { name: (*name).to_owned(), score };
    let views = names.iter().map(view).collect();
    Record::Evaluation { step, seconds: 0.38 * step as f64, mean: score, views }
}

/// 1500 steps of 2000, three evaluations.
fn records(names: &[&str]) -> Vec<Record> {
    let session = SessionInfo {
        date: "2026-01-31T09:30:00Z".to_owned(),
        command: Some("organza train garden -o 'a run'".to_owned()),
        version: "0.1.0".to_owned(),
        commit: Some("0123abc".to_owned()),
        device: "cpu: 2 threads".to_owned(),
    };
    let mut records = vec![Record::Session { step: 0, session }];
    for at in (10..=1500).step_by(10) {
        records.push(step(at));
        if at % 500 == 0 && at < 1500 {
            let split = 23_000;
            let pruned = 1_500;
            records.push(Record::Densification { step: at, split, pruned, gaussians: 1000 + at });
            records.push(evaluation(at, names));
        }
    }
    let name = "run.steps".to_owned();
    let from = 1500.into();
    records.push(Record::Change(Change { step: 1000, name, from, to: 2000.into() }));
    let row = |stage: &str, seconds| TimingRow { stage: stage.to_owned(), seconds, share: 0.5 };
    let rows = vec![row("composite", 100.0), row("adam", 100.0)];
    records.push(Record::Timing { step: 1500, rows });
    records
}

/// Writes a run's folder, with pictures of the first two views after steps 0, 500 and 1000.
fn run(folder: &Path, config: &str, records: &[Record]) -> Run {
    fs::create_dir_all(folder).unwrap();
    TrainConfig::parse(config, Path::new("")).unwrap().save(folder.join(CONFIG)).unwrap();
    let mut log = MetricsLog::create(folder.join(METRICS)).unwrap();
    records.iter().for_each(|record| log.append(record).unwrap());
    let pictures = Pictures::from_run(folder);
    pictures.begin(0).unwrap();
    let image = Image::new(30, 20).unwrap();
    pictures.write_first(&image).unwrap();
    for step in [500, 1000] {
        for view in 0..2 {
            pictures.write(view, step, &Photograph::from(&image), &image).unwrap();
        }
        pictures.keep(step);
    }
    Run::load(folder).unwrap()
}

/// An element: its name, its attributes and its text.
#[derive(Debug)]
struct Element {
    tag: String,
    attributes: BTreeMap<String, String>,
    text: String,
}

/// Every element of a page, after a parser of HTML has accepted it.
fn elements(html: &str) -> Vec<Element> {
    let page = parse_document(RcDom::default(), ParseOpts::default()).one(html);
    assert!(page.errors.borrow().is_empty(), "{:?}", page.errors.borrow());
    let mut found = Vec::new();
    walk(&page.document, &mut found);
    found
}

fn walk(node: &Handle, found: &mut Vec<Element>) {
    if let NodeData::Element { name, attrs, .. } = &node.data {
        let attributes = attrs.borrow();
        let attributes =
            attributes.iter().map(|one| (one.name.local.to_string(), one.value.to_string()));
        let tag = name.local.to_string();
        found.push(Element { tag, attributes: attributes.collect(), text: text(node) });
    }
    node.children.borrow().iter().for_each(|child| walk(child, found));
}

fn text(node: &Handle) -> String {
    match &node.data {
        NodeData::Text { contents } => contents.borrow().to_string(),
        _ => node.children.borrow().iter().map(text).collect(),
    }
}

fn texts<'a>(elements: &'a [Element], tag: &str) -> Vec<&'a str> {
    let found = elements.iter().filter(|element| element.tag == tag);
    found.map(|element| element.text.as_str()).collect()
}

/// Asserts that a browser would fetch nothing, and that the page's script is the only one.
fn assert_alone(elements: &[Element]) {
    let policy = elements.iter().find_map(|element| element.attributes.get("content")).unwrap();
    assert!(policy.starts_with("default-src 'none'; img-src data:;"), "{policy}");
    let mut scripts = 0;
    for Element { tag, attributes, text } in elements {
        for tags in ["iframe", "object", "embed", "a", "base", "form", "svg", "video", "audio"] {
            assert!(tag != tags, "{tag}");
        }
        for (name, value) in attributes {
            assert!(!name.starts_with("on") && !["srcset", "action"].contains(&&**name), "{name}");
            let is_target = ["src", "href", "data", "poster"].contains(&&**name);
            assert!(!is_target || value.starts_with("data:"), "{name}={value}");
            assert!(name != "style" || !value.contains("url("), "{value}");
        }
        match tag.as_str() {
            "style" => assert!(!text.contains("url(") && !text.contains("@import"), "{text}"),
            "script" if attributes.get("type").is_some_and(|kind| kind == "application/json") => {}
            "script" => {
                scripts += 1;
                let hash = STANDARD.encode(Sha256::digest(text));
                assert!(policy.contains(&format!("script-src 'sha256-{hash}'")), "{policy}");
            }
            _ => {}
        }
    }
    assert_eq!(scripts, 1);
}

fn data(elements: &[Element]) -> Value {
    let is_data = |element: &&Element| element.attributes.get("id").is_some_and(|id| id == "data");
    serde_json::from_str(&elements.iter().find(is_data).unwrap().text).unwrap()
}

/// A series of a chart: the steps, the seconds and the values.
fn series(data: &Value, chart: &str, name: &str) -> [Vec<Value>; 3] {
    let named = |list: &Value, key: &str, name: &str| {
        let list = list.as_array().unwrap();
        list.iter().find(|item| item[key] == name).unwrap_or_else(|| panic!("{name}")).clone()
    };
    let series = named(&named(&data["charts"], "title", chart)["series"], "name", name);
    let table = &data["tables"][series["table"].as_u64().unwrap() as usize];
    [&table["step"], &table["seconds"], &series["y"]]
        .map(|values| values.as_array().unwrap().clone())
}

#[test]
fn every_number_that_is_drawn_is_in_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let records = records(&["a", "b", "c"]);
    let run = run(folder.path(), "", &records);
    let path = folder.path().join("report.html");
    write_report(&path, &run).unwrap();
    let page = elements(&fs::read_to_string(path).unwrap());
    assert_alone(&page);
    let data = data(&page);
    // as text: a JSON value would hold the digits of an f64
    let number = |value: &Value| -> Value {
        let text = serde_json::to_string(&Number::from(value.as_f64().unwrap())).unwrap();
        serde_json::from_str(&text).unwrap()
    };
    let logged: Vec<_> =
        records.iter().map(|record| serde_json::to_value(record).unwrap()).collect();
    let mut count = 0;
    for (chart, name, kind, key) in [
        ("Loss", "training batch", "step", "loss"),
        ("PSNR", "training batch", "step", "psnr"),
        ("L1", "training batch", "step", "l1"),
        ("SSIM", "training batch", "step", "ssim"),
        ("Gaussians", "Gaussians", "step", "gaussians"),
        ("Speed", "tiles", "step", "tiles_per_second"),
        ("PSNR", "held-out views", "evaluation", "psnr"),
        ("SSIM", "held-out views", "evaluation", "ssim"),
    ] {
        let of_kind: Vec<_> = logged.iter().filter(|record| record["kind"] == kind).collect();
        let column = |key: &str| of_kind.iter().map(|record| number(&record[key])).collect();
        let steps: Vec<_> = of_kind.iter().map(|record| record["step"].clone()).collect();
        let expected = [steps, column("seconds"), column(key)];
        assert_eq!(series(&data, chart, name), expected, "{chart}: {name}");
        count += of_kind.len();
    }
    assert_eq!(count, 6 * 150 + 2 * 2);
}

#[test]
fn the_page_shows_the_command_and_its_progress() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[run]\nsteps = 2000\n[loss]\nssim_weight = 0.3\n[optimizer]\nbeta1 = 0.8\n";
    let run = run(&folder.path().join("garden run"), text, &records(&["a", "b", "c"]));
    let page = elements(&single::html(&run));
    // from the last evaluation, not from the last step
    let facts = texts(&page, "dd");
    for fact in ["21.29 dB", "0.6429", "1,000 of 2,000", "6 min 20 s", "2,000"] {
        assert!(facts.contains(&fact), "{fact}: {facts:?}");
    }
    for fact in [
        "organza train garden -o 'a run'",
        "2026-01-31 09:30 UTC",
        "cpu: 2 threads",
        "0.1.0, commit 0123abc",
    ] {
        assert!(facts.contains(&fact), "{fact}: {facts:?}");
    }
    let notes = texts(&page, "p").join("\n");
    for note in [
        "Training run in the folder garden run",
        "went on to step 1,500",
        "2 times: 46,000 split",
        "changed run.steps from 1500 to 2000",
    ] {
        assert!(notes.contains(note), "{note}: {notes}");
    }
    let cells = texts(&page, "td");
    for row in [["loss.ssim_weight", "0.3", "0.2"], ["run.steps", "2000", "run.schedule"]] {
        assert!(cells.windows(3).any(|cells| cells == row), "{row:?}: {cells:?}");
    }
    let pictures: Vec<_> = page
        .iter()
        .filter_map(|element| element.attributes.get("alt"))
        .map(String::as_str)
        .collect();
    let times = ["a after 0 steps", "a after 500 steps", "a after 1000 steps"];
    let views = ["a", "b"].map(|view| {
        ["Rendering of", "Trained scene in", "Error of"].map(|what| format!("{what} {view}"))
    });
    let views = views.as_flattened().iter().map(String::as_str);
    assert_eq!(pictures, views.chain(times).collect::<Vec<_>>());
}

#[test]
fn text_of_a_run_is_escaped() {
    let folder = tempfile::tempdir().unwrap();
    let mut records = records(&[NASTY, NASTY]);
    let nasty = || NASTY.to_owned();
    let session = SessionInfo {
        date: nasty(),
        command: Some(nasty()),
        version: nasty(),
        commit: Some(nasty()),
        device: nasty(),
    };
    records.insert(0, Record::Session { step: 0, session });
    for record in &mut records {
        if let Record::Step { loss, l1, .. } = record {
            *loss = f64::NAN;
            *l1 = -1.0;
        }
    }
    let row = TimingRow { stage: nasty(), seconds: f64::MAX, share: -1e300 };
    records.push(Record::Timing { step: 1500, rows: vec![row] });
    let run = run(folder.path(), "", &records);
    let page = elements(&single::html(&run));
    assert_alone(&page);
    for tag in ["dd", "code", "td", "span"] {
        assert!(texts(&page, tag).contains(&SHOWN), "{tag}: {:?}", texts(&page, tag));
    }
}

#[test]
fn scores_with_exposures_fitted_are_shown_where_a_run_has_them() {
    let folder = tempfile::tempdir().unwrap();
    let title = "PSNR with exposures fitted, dB";
    let mut records = records(&["a", "b"]);
    let page = elements(&single::html(&run(&folder.path().join("without"), "", &records)));
    assert!(!texts(&page, "th").contains(&title));
    for record in &mut records {
        if let Record::Evaluation { views, mean, .. } = record {
            mean.psnr_fitted = Some(30.5);
            views.iter_mut().for_each(|view| view.score.psnr_fitted = Some(31.256));
        }
    }
    let page = elements(&single::html(&run(&folder.path().join("with"), "", &records)));
    assert_eq!(texts(&page, "th").iter().filter(|text| **text == title).count(), 2);
    let cells = |value| texts(&page, "td").iter().filter(|text| **text == value).count();
    assert_eq!([cells("31.26"), cells("30.50")], [2, 2]);
    assert!(texts(&page, "dt").contains(&"With exposures fitted"));
    assert!(texts(&page, "span").contains(&"31.26 dB with its exposure fitted"));
}

#[test]
fn an_empty_run_has_a_page() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join(CONFIG), "").unwrap();
    fs::write(path.join(METRICS), "").unwrap();
    let page = elements(&single::html(&Run::load(path).unwrap()));
    assert_alone(&page);
    assert_eq!(texts(&page, "h2"), ["Settings"]);
}

#[test]
fn a_long_run_is_thinned_out() {
    let folder = tempfile::tempdir().unwrap();
    let records: Vec<_> = (1..=30_000).map(step).collect();
    let html = single::html(&run(folder.path(), "", &records));
    assert!(html.len() < 1 << 20, "{}", html.len());
    let [steps, ..] = series(&data(&elements(&html)), "Loss", "training batch");
    assert_eq!(
        (steps.len(), &steps[0], &steps[3750]),
        (3751, &Value::from(1), &Value::from(30_000))
    );
}

#[test]
fn different_settings_are_found() {
    let folder = tempfile::tempdir().unwrap();
    // a schedule says what `--minutes` did, not what the user chose
    let text = "[run]\nseed = 7\nsteps = 2000\nschedule = [[0, 2000]]\n[data]\npath = \"garden\"\n";
    let first = run(&folder.path().join("a"), "[run]\nsteps = 2000\n", &records(&["x", "y"]));
    let second = run(&folder.path().join("b"), text, &records(&["y", "z"]));
    let found: Vec<_> = differences([&first, &second])
        .into_iter()
        .map(|found| (found.setting, found.values))
        .collect();
    let value = |text: &str| Some(text.to_owned());
    let expected = [
        ("run.seed".to_owned(), vec![value("0"), value("7")]),
        ("data.path".to_owned(), vec![None, value("\"garden\"")]),
    ];
    assert_eq!(found, expected);
}
