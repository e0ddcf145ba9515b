//! Text that controls terminals, closed streams, folders without write permission, and what a container lacks.

use std::fs;

use organza_tests::devices;
use serde_json::json;

use crate::sandbox::{Outcome, Sandbox, TILES};
use crate::train::runs;

/// Clears the screen, rings the bell, reverses text, and starts new lines.
const NASTY: &str = "a\x1b[2Jb\x07c\u{9b}31md\u{202e}e\u{61c}f\rg\nh\u{2028}i";

#[track_caller]
fn assert_plain(outcome: &Outcome) {
    for text in [&outcome.stdout, &outcome.stderr] {
        let marks = ['\u{61c}', '\u{2028}', '\u{202e}'];
        let bad = |c: char| c != '\n' && (c.is_control() || marks.contains(&c));
        assert!(!text.contains(bad), "{text:?}");
    }
}

#[test]
fn messages_do_not_control_the_terminal_and_are_short() {
    let sandbox = Sandbox::new("tiny");
    let run = |words: &[&str]| -> Outcome {
        let mut command = sandbox.command("");
        command.args(words).output().expect("the program starts").into()
    };
    let long = NASTY.to_owned() + &"long".repeat(25_000);
    let long = long.as_str();
    for words in [&["info", long][..], &[long], &["render", "--views", long]] {
        let outcome = run(words);
        outcome.assert_refused(&["\\u{202e}", " ... "]);
        assert_plain(&outcome);
        assert!(outcome.stderr.lines().count() <= 4, "{outcome:?}");
        assert!(outcome.stderr.len() < 4000, "{outcome:?}");
    }
    // names inside of files, also in messages of a success
    sandbox.edit_json("cameras.json", "/frames/0/file_path", json!(NASTY));
    for words in [
        &["info", "cameras.json", "--json"][..],
        &["explain", "scene.safetensors", "cameras.json", "--pixel", "1,1"],
        &["render", "scene.safetensors", "cameras.json", "-o", NASTY, "--backend", "cpu"],
    ] {
        assert_plain(&run(words).assert_ok());
    }
    assert!(sandbox.path(NASTY).is_dir());
    let info = run(&["info", "cameras.json", "--json"]).json();
    assert_eq!(info["cameras"][0]["file_path"], json!(NASTY), "JSON says it all the same");
}

#[cfg(target_os = "linux")]
#[test]
fn closed_streams_are_no_bug() {
    let sandbox = Sandbox::new("tiny");
    for (streams, code) in [("<&-", 0), ("2>&-", 0), ("<&- >&- 2>&-", 0), ("2>/dev/full", 0)] {
        let outcome = sandbox.shell(&format!("\"$ORGANZA\" {TILES} -o out {streams}"));
        assert_eq!(outcome.code, Some(code), "{streams}: {outcome:?}");
        assert!(fs::metadata(sandbox.path("out")).unwrap().len() > 1000, "{streams}");
        // a scene must not be written into the file that replaces a closed stream
        sandbox.remove("out");
    }
    for streams in ["2>&-", "2>/dev/full", ">&- 2>&-"] {
        let outcome = sandbox.shell(&format!("\"$ORGANZA\" info absent {streams}"));
        assert_eq!((outcome.code, outcome.stdout.as_str()), (Some(2), ""), "{streams}");
    }
    let outcome = sandbox.shell("\"$ORGANZA\" info tiles.json >/dev/full");
    outcome.assert_refused(&["standard output", "disk is full"]);
}

/// Root ignores permissions, but not a read-only mount.
#[cfg(target_os = "linux")]
#[test]
fn folders_that_are_read_only_are_said() {
    let sandbox = Sandbox::new("tiny");
    sandbox.make_folder("locked");
    let mount = "mount -t tmpfs -o ro none locked";
    if sandbox.shell(&format!("unshare -rm {mount}")).code != Some(0) {
        eprintln!("skipped: no file system can be mounted here");
        return;
    }
    for words in [
        format!("{TILES} -o locked/out"),
        "render scene.safetensors cameras.json -o locked/images --backend cpu".to_owned(),
        "demo -o locked --backend cpu".to_owned(),
        "train -o locked --backend cpu".to_owned(),
        "train -o locked/run --backend cpu".to_owned(),
    ] {
        let outcome =
            sandbox.shell(&format!("unshare -rm sh -c '{mount} && \"$ORGANZA\" {words}'"));
        outcome.assert_refused(&["cannot write", "locked", "ead-only"]);
    }
}

/// Mesa and libwayland look for a desktop's sockets in a folder that only a desktop has. That must not print
/// anything.
#[test]
fn a_missing_desktop_prints_nothing() {
    let sandbox = runs::sandbox();
    let backends = if devices::has_gpu() { &["auto", "gpu"][..] } else { &["auto"] };
    for backend in backends {
        for words in [
            format!("render scene.safetensors cameras.json -o images-{backend}"),
            format!("train views --config tiny.toml -o run-{backend} --steps 1"),
        ] {
            let mut command = sandbox.command(&format!("{words} -q --backend {backend}"));
            command.env_remove("XDG_RUNTIME_DIR").env_remove("NODEVICE_SELECT");
            let outcome: Outcome = command.output().expect("the program starts").into();
            assert_eq!(outcome.assert_ok().stderr, "", "{words}");
        }
    }
}
