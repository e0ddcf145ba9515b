use std::fs;

use super::*;
use organza_core::error::chain;

fn step(step: u64) -> Record {
    let seconds = step as f64 / 3.0;
    let loss = 1.0 / step as f64;
    let rates = [("networks".to_owned(), 1e-3), ("position".to_owned(), 2.5e-4)].into();
    let l1 = 0.125;
    let ssim = 0.75;
    let psnr = 20.5;
    let tiles_per_second = 1e3;
    let gaussians = 10 + step;
    Record::Step { step, seconds, loss, l1, ssim, psnr, tiles_per_second, gaussians, rates }
}

fn evaluation(step: u64) -> Record {
    let score = Score { psnr: Some(f64::INFINITY), ssim: Some(0.5), ..Score::default() };
    let views = vec![ViewScore { name: "a \"b\"\n.png".to_owned(), score }];
    Record::evaluation(step, 2.0, &Evaluation { mean: score, views, not_finite: 0 })
}

fn timing(step: u64) -> Record {
    let row = TimingRow { stage: "forward".to_owned(), seconds: 1.5, share: 0.25 };
    Record::Timing { step, rows: vec![row] }
}

fn densification(step: u64) -> Record {
    Record::Densification { step, split: 1, pruned: 3, gaussians: 10 }
}

fn change(step: u64) -> Record {
    let name = "run.steps".to_owned();
    let from = 40.into();
    let to = 60.into();
    Record::Change(Change { step, name, from, to })
}

fn write(records: &[Record]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("metrics.jsonl");
    let mut log = MetricsLog::create(&path).unwrap();
    records.iter().for_each(|record| log.append(record).unwrap());
    (folder, path)
}

fn session(step: u64) -> Record {
    let session = SessionInfo {
        date: "2026-01-31T09:30:00Z".to_owned(),
        command: Some("organza train -o run".to_owned()),
        version: "0.1.0".to_owned(),
        commit: None,
        device: "cpu: 2 threads".to_owned(),
    };
    Record::Session { step, session }
}

#[test]
fn records_are_lines_of_json() {
    let (_folder, path) =
        write(&[session(0), step(1), evaluation(2), densification(3), timing(3), change(3)]);
    let text = fs::read_to_string(&path).unwrap();
    let expected = [
        r#"{"kind":"session","step":0,"date":"2026-01-31T09:30:00Z","command":"organza train -o run","version":"0.1.0","commit":null,"device":"cpu: 2 threads"}"#,
        r#"{"kind":"step","step":1,"seconds":0.3333333333333333,"loss":1.0,"l1":0.125,"ssim":0.75,"psnr":20.5,"tiles_per_second":1000.0,"gaussians":11,"rates":{"networks":0.001,"position":0.00025}}"#,
        r#"{"kind":"evaluation","step":2,"seconds":2.0,"psnr":null,"ssim":0.5,"views":[{"name":"a \"b\"\n.png","psnr":null,"ssim":0.5}]}"#,
        r#"{"kind":"densification","step":3,"split":1,"pruned":3,"gaussians":10}"#,
        r#"{"kind":"timing","step":3,"rows":[{"stage":"forward","seconds":1.5,"share":0.25}]}"#,
        r#"{"kind":"change","step":3,"name":"run.steps","from":40,"to":60}"#,
    ];
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
    let records = MetricsLog::read(&path).unwrap();
    let expected = [&session(0), &step(1), &densification(3), &timing(3)];
    assert_eq!([&records[0], &records[1], &records[3], &records[4]], expected);
    assert_eq!(records[5], change(3));
    assert!(matches!(
        &records[2],
        Record::Evaluation { mean: Score { psnr: None, ssim: Some(0.5), .. }, .. }
    ));
}

#[test]
fn infinite_values_are_read_as_nan() {
    let mut record = step(1);
    let Record::Step { loss, .. } = &mut record else { unreachable!() };
    *loss = f64::INFINITY;
    let (_folder, path) = write(&[record]);
    let records = MetricsLog::read(&path).unwrap();
    assert!(matches!(records[0], Record::Step { loss, .. } if loss.is_nan()), "{records:?}");
}

#[test]
fn resuming_drops_later_records() {
    let (_folder, path) =
        write(&[step(1), change(1), step(2), change(2), evaluation(2), step(3), densification(4)]);
    let mut log = MetricsLog::resume(&path, 2).unwrap();
    log.append(&step(3)).unwrap();
    log.append(&timing(3)).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    let (_other, expected) =
        write(&[step(1), change(1), step(2), evaluation(2), step(3), timing(3)]);
    assert_eq!(text, fs::read_to_string(expected).unwrap());
}

#[test]
fn half_a_line_is_dropped() {
    let (folder, path) = write(&[step(1), step(2)]);
    let whole = fs::read(&path).unwrap();
    for cut in [1, 2, 20, 60] {
        fs::write(&path, &whole[..whole.len() - cut]).unwrap();
        // a record without its line break is complete
        let kept = if cut == 1 { 2 } else { 1 };
        assert_eq!(MetricsLog::read(&path).unwrap().len(), kept, "{cut}");
        MetricsLog::resume(&path, 9).unwrap().append(&step(3)).unwrap();
        let records = MetricsLog::read(&path).unwrap();
        assert_eq!((records.len(), records.last()), (kept + 1, Some(&step(3))), "{cut}");
    }
    let names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap()).collect();
    assert_eq!(names.len(), 1, "{names:?}");
}

#[test]
fn a_log_is_begun_where_there_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("metrics.jsonl");
    let text = chain(&MetricsLog::read(&path).unwrap_err());
    assert!(text.contains("metrics.jsonl") && text.contains("no such file"), "{text}");
    MetricsLog::resume(&path, 5).unwrap().append(&step(1)).unwrap();
    assert_eq!(MetricsLog::read(&path).unwrap(), [step(1)]);
    MetricsLog::create(&path).unwrap();
    assert!(MetricsLog::read(&path).unwrap().is_empty());
}

#[test]
fn a_line_that_is_no_record_is_named() {
    let (_folder, path) = write(&[step(1), step(2)]);
    let mut text = fs::read_to_string(&path).unwrap();
    text.insert_str(0, "\n{\"kind\":\"another\"}\n");
    fs::write(&path, &text).unwrap();
    let errors = [
        MetricsLog::read(&path).unwrap_err().to_string(),
        MetricsLog::resume(&path, 1).unwrap_err().to_string(),
    ];
    for error in errors {
        assert!(error.contains("metrics.jsonl: line 2 is no record"), "{error}");
    }
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn a_wrong_clock_has_a_date() {
    let day = Duration::from_secs(24 * 60 * 60);
    for (time, expected) in [
        (UNIX_EPOCH + 10 * day, "1970-01-11T00:00:00Z"),
        (UNIX_EPOCH - day, "1970-01-01T00:00:00Z"),
        (UNIX_EPOCH + 4_000_000 * day, "9999-12-31T23:59:59Z"),
    ] {
        assert_eq!(date(time), expected);
    }
}
