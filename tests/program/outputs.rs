//! Outputs replace no input, and are written through no link.

use std::fs;
use std::os::unix::fs::symlink;
use std::process::Command;

use organza::train::FolderLock;

use crate::sandbox::Sandbox;
use crate::train::runs::{self, TINY};

/// A sandbox with a data set in `data`, a run on it in `run`, and Gaussians in `splats.ply`.
fn sandbox() -> Sandbox {
    let sandbox = runs::sandbox();
    sandbox.rename("views", "data");
    let train = TINY.replace("views", "data");
    sandbox.run(&format!("{train} run --steps 2")).assert_ok();
    sandbox.run("export run -o splats.ply --steps 0 --side 16 --backend cpu").assert_ok();
    sandbox.copy_file("splats.ply", "data/points.ply");
    sandbox.copy_file("data/view-000.png", "data/mask.png");
    sandbox
}

#[test]
fn no_file_of_a_run_or_a_data_set_is_replaced() {
    let sandbox = sandbox();
    let data = "the data set";
    let run = "the run";
    for (words, replaced) in [
        ("import splats.ply data -o data/transforms.json --steps 1", data),
        ("tiles run data/transforms.json tiles.json -o data/view-000.png", data),
        ("tiles run tiles.json -o data/view-000.png", data),
        ("tiles run tiles.json -o run/config.toml", run),
        ("tiles run tiles.json -o run/evaluations.csv", run),
        ("tiles run/checkpoint.safetensors data tiles.json -o run/metrics.jsonl", run),
        ("export run data -o data/points.ply --steps 0 --side 16", data),
        ("export run -o data/points.ply --steps 0 --side 16", data),
        ("film run data -o data/mask.png --frames 2", data),
        ("film run -o run/pictures/mine.png --frames 2", run),
        ("export-web run --single-file -o data/transforms.json", data),
        ("export-web run data --single-file -o run/report.html", run),
    ] {
        // as it would have been
        let mut output = words.split_whitespace().skip_while(|word| *word != "-o");
        let output = sandbox.path(output.nth(1).expect("an output"));
        if !output.exists() {
            fs::write(output, "a file of the run").unwrap();
        }
        sandbox.assert_refuses(&format!("{words} --backend cpu"), &["would replace", replaced]);
    }
    // a file of the user's own in the run's folder is none of the run's
    for _ in 0..2 {
        sandbox.run("tiles run tiles.json -o run/tiles.safetensors --backend cpu").assert_ok();
    }
}

#[test]
fn no_output_goes_through_a_link_or_waits_for_a_pipe() {
    let sandbox = sandbox();
    let mine = sandbox.path("mine.txt");
    fs::write(&mine, "mine").unwrap();
    let pipe = |name: &str| {
        assert!(Command::new("mkfifo").arg(sandbox.path(name)).status().expect("mkfifo").success());
    };
    for folder in ["images", "frames", "pipes", "demo", "page"] {
        sandbox.make_folder(folder);
    }
    symlink(&mine, sandbox.path("images/view-000.png")).unwrap();
    symlink("/dev/zero", sandbox.path("frames/00000.png")).unwrap();
    pipe("pipes/00000.png");
    symlink(&mine, sandbox.path("demo/0000.png")).unwrap();
    symlink(&mine, sandbox.path("page/index.html")).unwrap();
    for words in [
        "render run -o images --split all --backend cpu",
        "film run -o frames --overwrite --frames 2 --backend cpu",
        "film run -o pipes --overwrite --frames 2 --backend cpu",
        "demo -o demo --views 2 --size 16 --backend cpu",
        "export-web run -o page --backend cpu",
    ] {
        sandbox.shell(&format!("timeout 60 \"$ORGANZA\" {words}")).assert_refused(&[]);
        assert_eq!(fs::read_to_string(&mine).unwrap(), "mine", "{words}");
    }
}

/// A run's folder that another user has made.
#[test]
fn training_writes_no_picture_through_a_link_and_does_not_wait_for_a_pipe() {
    let sandbox = sandbox();
    let mine = sandbox.path("mine.txt");
    fs::write(&mine, "mine").unwrap();
    let photograph = sandbox.path("run/pictures/view-1-photograph.jpg");
    let thumbnail = fs::read_dir(sandbox.path("run/pictures")).unwrap();
    let mut thumbnail = thumbnail.map(|entry| entry.unwrap().path());
    let thumbnail = thumbnail.find(|path| *path != photograph).expect("a picture");
    fs::remove_file(&photograph).unwrap();
    symlink(&mine, &photograph).unwrap();
    fs::remove_file(&thumbnail).unwrap();
    assert!(Command::new("mkfifo").arg(&thumbnail).status().unwrap().success());
    let resume = "train --resume run --steps 4 --backend cpu";
    let outcome = sandbox.shell(&format!("timeout 60 \"$ORGANZA\" {resume}"));
    assert_eq!(fs::read_to_string(&mine).unwrap(), "mine");
    assert!(outcome.stderr.contains("it is a link, a folder, a pipe"), "{outcome:?}");
}

/// Two commands that write into one folder would mix their images.
#[test]
fn one_command_at_a_time_writes_into_a_folder() {
    let sandbox = Sandbox::new("tiny");
    let render = "render scene.safetensors cameras.json -o out --backend cpu";
    let film = "film scene.safetensors cameras.json -o out --frames 2 --backend cpu";
    sandbox.make_folder("out");
    let lock = FolderLock::take(&sandbox.path("out")).unwrap().expect("it is free");
    for words in [render, film, "demo -o out --views 2 --size 16 --backend cpu"] {
        sandbox.assert_refuses(words, &["out: another command writes to this folder (process "]);
    }
    drop(lock);
    sandbox.run(render).assert_ok();
    assert!(!sandbox.path("out/.organza-lock").exists());
}

/// JSON shows a path as messages do. What cannot be written so is refused before there is a file.
#[cfg(target_os = "linux")]
#[test]
fn paths_need_not_be_utf8() {
    let sandbox = runs::sandbox();
    sandbox.run(&format!("{TINY} run --steps 2")).assert_ok();
    sandbox.shell("mkdir \"$(printf 'caf\\351')\"").assert_ok();
    let here = |words: &str| {
        let words = words.replace('@', "\"$(printf 'caf\\351')\"");
        sandbox.shell(&format!("\"$ORGANZA\" {words}"))
    };
    for words in [
        "train views --config tiny.toml --steps 2 -o @/run --backend cpu",
        "train --resume @/run --steps 4 --backend cpu",
        "eval @/run --backend cpu",
        "edit @/run -o @/new.safetensors --scale 2 --backend cpu",
        "render @/run -o @/images --channels depth --backend cpu",
        "film @/run -o @/film.png --frames 2 --size 16x16 --backend cpu",
        "tiles @/run tiles.json -o @/tiles.safetensors --backend cpu",
        "demo -o @/demo --views 2 --size 16 --backend cpu",
        "demo --photographs -o @/walk --views 2 --size 32",
        "info @/run",
        "info @/tiles.safetensors",
        "compare run @/run",
    ] {
        let json = here(&format!("{words} --json")).json().to_string();
        assert!(json.contains("caf\u{fffd}/") || words.starts_with("eval"), "{words}: {json}");
    }
    sandbox.shell("cp -r views \"$(printf 'caf\\351')/views\"").assert_ok();
    here("eval run @/views --backend cpu --json").json();
    let before = sandbox.files();
    for words in ["-o new --json", "-o new", "--print-config", "--print-config --json"] {
        let outcome = here(&format!("train @/views --config tiny.toml --backend cpu {words}"));
        outcome.assert_refused(&["`data.path` is", "caf\u{fffd}/views", "not UTF-8", "a link"]);
        assert!(before == sandbox.files(), "{words}");
    }
    sandbox.shell("ln -s \"$(printf 'caf\\351')\" cafe").assert_ok();
    sandbox.run("train cafe/views --config tiny.toml --steps 2 -o new --backend cpu").assert_ok();
}
