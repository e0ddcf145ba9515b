//! `organza benchmark`: what the table says is what the runs came to.

use std::fs;

use organza::train::metrics::{MetricsLog, Record};
use organza::train::{CHECKPOINT, METRICS};

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
    let words = "benchmark one two/transforms.json -o results --config tiny.toml --steps 8 \
                 --downscale 4 --hold-out-every 2 --backend cpu";
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
    // what is there is counted as it is
    assert_eq!(sandbox.run(words).assert_ok().stdout, table);
    assert_eq!(fs::read_to_string(sandbox.path("results/results.csv")).unwrap(), csv);
    let json = sandbox.run(&format!("{words} --json --quiet")).assert_ok().stdout;
    assert_documented("benchmark", &[serde_json::from_str(&json).expect("JSON")]);
    sandbox.assert_refuses("benchmark one one -o again --backend cpu", &["two captures", "one"]);
    assert!(!sandbox.path("again").exists());
}
