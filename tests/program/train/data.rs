//! The data behind a run: commands that take both say if it has changed, or is no longer there.

use image::imageops::FilterType;
use organza::train::{CONFIG, TrainConfig};
use serde_json::json;

use super::runs::{TINY, VIEWS, sandbox};
use crate::sandbox::Sandbox;

/// A sandbox with a run of five steps on the photographs in `views`, every third of which is held out.
fn trained() -> Sandbox {
    let sandbox = sandbox();
    sandbox.run(&format!("{TINY} run --steps 5 --hold-out-every 3")).assert_ok();
    sandbox
}

/// Moves the first frame to the end, so that others are held out.
fn reorder(sandbox: &Sandbox) {
    let frames = sandbox.read_json("views/transforms.json")["frames"].clone();
    let mut frames = frames.as_array().expect("a list").clone();
    frames.rotate_left(1);
    sandbox.edit_json("views/transforms.json", "/frames", json!(frames));
}

#[test]
fn every_command_notices_another_order_of_frames() {
    let sandbox = trained();
    let score = |words: &str| sandbox.run(&format!("eval {words} --backend cpu --json")).json();
    let before = score("run");
    reorder(&sandbox);
    for words in [
        "eval run --backend cpu",
        "eval run --split all --backend cpu",
        "eval run --hold-out-every 2 --backend cpu",
        "edit run -o new.safetensors --clean 0.3 --backend cpu",
        "render run -o new --backend cpu",
        "film run -o new.png --backend cpu",
        "explain run --pixel 1,1",
        "export run -o new.ply --backend cpu",
        "export-web run -o new --backend cpu",
        "view run --backend cpu",
        "train --resume run --steps 9 --backend cpu",
    ] {
        let facts = ["views", "order", "not those that", "was trained on", "the data set"];
        sandbox.assert_refuses(words, &facts);
    }
    // what is named is taken as it is
    for scene in ["run", "run/checkpoint.safetensors"] {
        let words = format!("eval {scene} views --backend cpu");
        sandbox.run(&words).assert_ok().says(&["warning: views: its frames"]);
    }
    sandbox.shell("cp -r views other").assert_ok();
    let outcome = sandbox.run("eval run other --backend cpu").assert_ok();
    assert!(outcome.stderr.starts_with("other: its frames"), "{outcome:?}");
    // the order differs from the files' on disk
    (1..VIEWS).for_each(|_| reorder(&sandbox));
    assert_eq!(score("run"), before);
}

#[test]
fn another_photograph_is_noticed_where_it_is_read() {
    let sandbox = trained();
    let before = sandbox.read("views/view-000.png");
    sandbox.copy_file("views/view-004.png", "views/view-000.png");
    let facts = ["view-000.png", "has changed since the run was trained", "name the data set"];
    sandbox.assert_refuses("eval run --backend cpu", &facts);
    // it is not read, or is smaller than the run's, or was named
    sandbox.run("eval run --split train --backend cpu").assert_ok();
    sandbox.run("render run -o images --backend cpu").assert_ok();
    sandbox.run("edit run -o new.safetensors --clean 0.3 --backend cpu").assert_ok();
    sandbox.run("eval run views --backend cpu").assert_ok();
    sandbox.write("views/view-000.png", before);
    sandbox.run("eval run --backend cpu").assert_ok();
}

#[test]
fn runs_on_different_data_are_told_apart() {
    let sandbox = trained();
    sandbox.shell("cp -r run same").assert_ok();
    let compare = |words: &str| sandbox.run(&format!("compare {words}")).assert_ok().stderr;
    assert!(!compare("run same").contains("warning"));
    reorder(&sandbox);
    let text = compare("run same");
    assert_eq!(text.matches("have changed since").count(), 2, "{text}");
    sandbox.run(&format!("{TINY} other --steps 5 --hold-out-every 3")).assert_ok();
    let text = compare("run other");
    assert!(text.contains("warning: run and other were trained on different data"), "{text}");
    assert!(text.contains("have changed since run was trained"), "{text}");
}

#[test]
fn a_data_set_that_has_moved_is_named() {
    let sandbox = trained();
    sandbox.rename("views", "moved");
    for words in ["eval run", "view run", "train --resume run --steps 9"] {
        let facts = ["views", "no longer there", "`data.path` in run/config.toml"];
        sandbox.assert_refuses(&format!("{words} --backend cpu"), &facts);
    }
    sandbox.run("eval run moved --backend cpu").assert_ok();
    sandbox.shell("sed -i 's|/views\"|/moved\"|' run/config.toml").assert_ok();
    sandbox.run("eval run --backend cpu").assert_ok();
    // a run can be resumed from any folder
    sandbox.rename("moved", "views");
    sandbox.run("train --resume run --steps 9 --set data.path=views --backend cpu").assert_ok();
    sandbox.shell("mkdir elsewhere && cd elsewhere && \"$ORGANZA\" eval ../run").assert_ok();
}

/// A run finds the data in its folder first, also beside the old one. Data elsewhere may move with the run.
#[test]
fn a_run_moves_with_its_data() {
    let sandbox = sandbox();
    sandbox.shell("mkdir -p a/run && cp -r views a/run/data && cp -r views a/views").assert_ok();
    for (data, run) in [("a/run/data", "a/run"), ("a/views", "a/beside")] {
        let train = TINY.replace(" views ", &format!(" {data} "));
        sandbox.run(&format!("{train} {run} --steps 5")).assert_ok();
    }
    let score = |run: &str| sandbox.run(&format!("eval {run} --backend cpu --json")).json();
    let before = score("a/run");
    sandbox.shell("cp -r a b && rm a/run/data/view-000.png").assert_ok();
    assert_eq!(score("b/run"), before);
    sandbox.shell("rm -r a && mv b c").assert_ok();
    for words in [
        "eval c/run",
        "edit c/beside -o new.safetensors --clean 0.1",
        "train --resume c/run --steps 9",
    ] {
        sandbox.run(&format!("{words} --backend cpu")).assert_ok();
    }
    sandbox.run("compare c/run c/beside").assert_ok();
    let config = TrainConfig::load(sandbox.path("c/run").join(CONFIG)).unwrap();
    assert_eq!(config.data.path, sandbox.path("c/run/data").canonicalize().ok());
    // without a checkpoint, too
    sandbox.shell("rm c/run/*.safetensors && mv c/run d").assert_ok();
    sandbox.run("train --resume d --backend cpu").assert_ok();
}

/// A run, its checkpoint and its edited scene are measured on the frames that training has not seen.
#[test]
fn a_scene_knows_its_held_out_frames() {
    let sandbox = sandbox();
    let hold_out = "--hold-out-every 3 --set data.hold_out_length=2";
    sandbox.run(&format!("{TINY} run --steps 5 {hold_out}")).assert_ok();
    let edit = "edit run -o edited.safetensors --min-contribution=0.001 --backend cpu";
    sandbox.run(edit).assert_ok();
    let eval = |words: &str| sandbox.run(&format!("eval {words} --backend cpu --json"));
    let run = eval("run").json();
    assert_eq!(eval("run/checkpoint.safetensors views").json(), run);
    let names = |found: &serde_json::Value| -> Vec<_> {
        found["views"].as_array().expect("views").iter().map(|view| view["name"].clone()).collect()
    };
    let edited = eval("edited.safetensors views").says_not(&["held out here"]).json();
    assert_eq!(names(&edited), names(&run));
    // others, in another order, and fewer
    reorder(&sandbox);
    assert_eq!(names(&eval("edited.safetensors views").json()).len(), names(&run).len());
    let seen = "warning: edited.safetensors was trained on";
    eval("edited.safetensors views --hold-out-every 2").assert_ok().says(&[seen]);
    // a scene that does not say, and names that do not fit
    sandbox.edit_tensors("edited.safetensors", |metadata, _| {
        let config = metadata.get_mut("config").expect("it has one");
        *config = config.replace("view-", "other-");
    });
    eval("edited.safetensors views").assert_ok().says(&["no frame here has the name of one"]);
    eval("scene.safetensors views")
        .assert_ok()
        .says(&["scene.safetensors does not say what it was trained on"]);
}

/// Two steps draw far fewer pixels than two photographs of 3200 x 64 have.
#[test]
fn large_photographs_shrink_to_what_the_steps_draw() {
    let sandbox = sandbox();
    let frames = sandbox.read_json("views/transforms.json")["frames"].clone();
    sandbox.edit_json("views/transforms.json", "/frames", json!([frames[0], frames[1]]));
    let lens = [("fl_x", 3200), ("fl_y", 3200), ("cx", 1600), ("cy", 32), ("w", 3200), ("h", 64)];
    for (key, value) in lens {
        sandbox.edit_json("views/transforms.json", &format!("/{key}"), json!(value));
    }
    for view in ["view-000", "view-001"] {
        let path = sandbox.path(&format!("views/{view}.png"));
        image::open(&path).unwrap().resize_exact(3200, 64, FilterType::Nearest).save(path).unwrap();
    }
    let train = format!("{TINY} @ --steps 2 --hold-out-every 0 --max-gaussians 100");
    let downscale = |run: &str, words: &str| {
        let outcome = sandbox.run(words).assert_ok();
        let config = TrainConfig::load(sandbox.path(run).join(CONFIG)).unwrap();
        let said = outcome.stderr.contains("so they shrink by 2: `--downscale 1` keeps their size");
        (config.data.downscale, said)
    };
    assert_eq!(downscale("run", &train.replace('@', "run")), (2, true));
    let eval = |words: &str| {
        sandbox.run(&format!("eval {words} --split train --backend cpu --json")).json()
    };
    let info = eval("run");
    assert_eq!(info["views"].as_array().map(Vec::len), Some(2), "{info}");
    assert_eq!(eval("run/checkpoint.safetensors views"), info);
    let whole = train.replace('@', "whole --downscale 1");
    assert_eq!(downscale("whole", &whole), (1, false));
    let again = "train views -o again --config whole/config.toml --backend cpu";
    assert_eq!(downscale("again", again), (1, false));
    // as many as both have
    let enough = train.replace('@', "enough --tiles-per-step 1024");
    assert_eq!(downscale("enough", &enough), (1, false));
}

#[test]
fn a_run_plans_its_steps_by_its_photographs() {
    let sandbox = sandbox();
    let planned = |run: &str, words: &str| {
        let words = format!("train views -o {run} {words} --time-limit 1 --backend cpu");
        let said = sandbox.run(&words).assert_ok().stderr;
        let config = TrainConfig::load(sandbox.path(run).join(CONFIG)).unwrap();
        (config.run.steps, said.contains("planned: 8,000 steps of "))
    };
    assert_eq!(planned("run", "--config tiny.toml --steps 0"), (8000, true));
    assert_eq!(planned("again", "--config run/config.toml"), (8000, true));
    assert_eq!(planned("own", "--config run/config.toml --steps 8001"), (8001, false));
}

#[test]
fn a_checkpoint_of_another_version_goes_on_with_a_warning() {
    let sandbox = trained();
    sandbox.edit_tensors("run/checkpoint.safetensors", |metadata, _| {
        let run = metadata.get_mut("run").expect("it is bound");
        let own = format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION"));
        assert!(run.contains(&own), "{run}");
        *run = run.replace(&own, "\"version\":\"0.0.7\"");
    });
    sandbox
        .run("train --resume run --steps 9 --backend cpu")
        .assert_ok()
        .says(&["warning: organza 0.0.7 wrote the checkpoint"]);
}

/// Training says what it starts from, if not from the data set's points.
#[test]
fn a_start_without_points_is_told() {
    let sandbox = sandbox();
    let told = |run: &str| sandbox.run(&format!("{TINY} {run} --steps 1")).assert_ok().stderr;
    // photographs that look from so far apart suggest nothing
    let start = "without points, training starts from 0 places that the photographs suggest, and 200 random ones\n";
    let text = told("without");
    assert!(text.contains(start) && !text.contains("warning"), "{text}");
    let mut file = sandbox.read_json("views/transforms.json");
    file["ply_file_path"] = json!("points.ply");
    sandbox.write("views/transforms.json", file.to_string());
    for (run, x, facts) in [("with", 0, &[][..]), ("away", 999, &["show only 0%", "are not used"])]
    {
        let points: String =
            (0..27).map(|i| format!("{}.{} 0.{} 0.{}\n", x, i % 3, i / 3 % 3, i / 9)).collect();
        let head = "ply\nformat ascii 1.0\nelement vertex 27\nproperty float x\nproperty float y\n\
                    property float z\nend_header\n";
        sandbox.write("views/points.ply", [head, &points].concat());
        let text = told(run);
        assert_eq!(text.contains(start), !facts.is_empty(), "{text}");
        assert!(facts.iter().all(|fact| text.contains(fact)), "{text}");
    }
}
