//! Options that all commands share: `--quiet`, `--verbose`, `--json`, help and completions.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use organza::scene::Placement;
use organza::splats::{self, Format, Splat};
use serde_json::Value;

use crate::sandbox::Sandbox;
use crate::train::runs;

/// How the examples of a help text begin.
const EXAMPLES: &str = "Examples:\n  organza ";

/// The commands, from the program's own help.
pub fn commands(sandbox: &Sandbox) -> Vec<String> {
    let help = sandbox.run("-h").assert_ok().stdout;
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    // The continuation of a description is indented further.
    let lines = lines.take_while(|line| !line.is_empty()).filter(|line| !line.starts_with("   "));
    let names: Vec<_> = lines.filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 10 && help.contains(EXAMPLES), "{help}");
    names.into_iter().filter(|name| *name != "help").map(str::to_owned).collect()
}

#[test]
fn every_command_has_examples_and_can_be_quiet_or_verbose() {
    let sandbox = Sandbox::new("tiny");
    for command in commands(&sandbox) {
        let help = sandbox.run(&format!("{command} -h")).assert_ok().stdout;
        for text in ["-q, --quiet", "-v, --verbose", EXAMPLES] {
            assert!(help.contains(text), "{command}: {help}");
        }
        sandbox.run(&format!("{command} -q -v")).assert_refused(&["--quiet", "--verbose"]);
    }
    let render = "render scene.safetensors cameras.json -o out --backend cpu";
    let said = |words: &str| sandbox.run(words).assert_ok().stderr;
    assert_eq!(said(&format!("{render} -q")), "");
    assert_eq!(said(&format!("-q {render}")), "");
    let some = said(render);
    let all = said(&format!("{render} -v"));
    assert!(!some.contains("detail: "), "{some}");
    for detail in [
        "detail: scene scene.safetensors: ",
        "detail: cameras cameras.json: 2 views",
        "detail: opened",
    ] {
        assert!(all.contains(detail), "{all}");
    }
    for words in ["info scene.safetensors", "completions bash"] {
        assert_eq!(said(words), "", "{words}");
        assert!(said(&format!("{words} -v")).starts_with("detail: "), "{words}");
    }
}

#[test]
fn the_nearest_command_is_suggested_first() {
    let outcome = Sandbox::new("tiny").run("trian -o run");
    outcome.assert_refused(&["unrecognized subcommand 'trian'"]);
    let tip = outcome.stderr.lines().find(|line| line.starts_with("tip: ")).expect("a tip");
    assert!(tip.split('\'').nth(1) == Some("train"), "{tip}");
}

/// Device options appear only in the long help, under their own heading.
#[test]
fn the_short_help_is_short() {
    let sandbox = Sandbox::new("tiny");
    let options = [
        "--backend",
        "--spirv",
        "--adapter",
        "--variants",
        "--threads",
        "--instruction-set",
        "--half-grids",
    ];
    for command in ["render", "film", "tiles", "eval", "bench"] {
        let [short, long] = ["-h", "--help"]
            .map(|help| sandbox.run(&format!("{command} {help}")).assert_ok().stdout);
        let device = long.split("\nDevice:\n").nth(1).expect("a heading");
        for option in options {
            // the examples may have it
            let options = short.split("\nExamples:").next().unwrap();
            assert!(
                !options.contains(&format!("{option} ")),
                "{command}: {option} is in {options}"
            );
            assert!(
                device.contains(&format!("\n      {option}"))
                    || device.starts_with(&format!("      {option}")),
                "{device}"
            );
        }
        assert!(!short.contains("Device:"), "{short}");
        assert!(short.contains("see more with '--help'"), "{short}");
    }
}

/// `docs/json.md` has a list of keys for each command that prints JSON.
fn documented(command: &str) -> BTreeSet<String> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/json.md");
    let page = fs::read_to_string(page).unwrap();
    let section = page.split("\n## ").find(|section| section.starts_with(&format!("{command}\n")));
    let section = section.unwrap_or_else(|| panic!("no section `{command}`"));
    let rows = section.lines().filter_map(|line| line.strip_prefix("- `")?.split_once("`: "));
    let keys = rows.flat_map(|(keys, _)| keys.split("`, `"));
    keys.flat_map(expanded).collect()
}

/// `a.{b,c}` stands for `a.b` and `a.c`.
fn expanded(key: &str) -> Vec<String> {
    let parts = key.split_once('{').and_then(|(begin, rest)| Some((begin, rest.split_once('}')?)));
    let Some((begin, (choices, end))) = parts else { return vec![key.to_owned()] };
    choices.split(',').flat_map(|choice| expanded(&format!("{begin}{choice}{end}"))).collect()
}

/// Every key, with the path of its objects: `views[].name`.
fn add_keys(value: &Value, above: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                // Keys of a scene's configuration are documented with the scene's file.
                let value = if key == "config" { &Value::Null } else { value };
                let key = if above.is_empty() { key.clone() } else { format!("{above}.{key}") };
                add_keys(value, &key, found);
            }
        }
        Value::Array(values) if values.iter().any(Value::is_object) => {
            values.iter().for_each(|value| add_keys(value, &format!("{above}[]"), found));
        }
        _ => {
            found.insert(above.to_owned());
        }
    }
}

/// Asserts that a command printed exactly the keys in its list.
#[track_caller]
pub fn assert_documented(command: &str, results: &[Value]) {
    let mut found = BTreeSet::new();
    results.iter().for_each(|result| add_keys(result, "", &mut found));
    assert_eq!(found, documented(command), "{command}");
}

/// Standard output has only JSON, with the documented keys.
#[test]
fn results_are_json_with_documented_keys() {
    let sandbox = runs::sandbox();
    runs::photographs(&sandbox);
    let splat = Splat {
        position: [1.0; 3],
        rotation: [1.0; 4],
        log_scale: [0.0; 3],
        opacity: 1.0,
        color: [[0.1; 3]; 16],
    };
    let path = sandbox.path("scene.ply");
    splats::save(&[splat], path, Format::Ply, [0.0; 3], &Placement::default()).unwrap();
    let info = ["run", "cameras.json", "data", "tiles.json", "out", "scene.ply"]
        .map(|x| format!("info {x}"));
    let train = "train data --config tiny.toml --steps 20 --hold-out-every 2 -o run --backend cpu";
    for (command, calls) in [
        ("train", vec![train]),
        ("eval", vec!["eval run --backend cpu"]),
        ("render", vec!["render run -o images --channels depth --backend cpu"]),
        ("film", vec!["film run -o film.png --frames 2 --backend cpu"]),
        ("tiles", vec!["tiles run tiles.json -o out --backend cpu"]),
        ("demo", vec!["demo -o demo --views 2 --size 16 --backend cpu"]),
        ("info", info.iter().map(String::as_str).collect()),
        ("bench", vec!["bench run data tiles.json --repeat 1 --backend cpu"]),
    ] {
        let result = |words| sandbox.run(&format!("{words} --json")).json();
        assert_documented(command, &calls.into_iter().map(result).collect::<Vec<_>>());
    }
    let words = "explain scene.safetensors cameras.json --pixel 48,40 --json";
    assert_documented("explain", &[Sandbox::new("crowded").run(words).json()]);
}

#[test]
fn shells_complete_commands_and_options() {
    let sandbox = Sandbox::new("tiny");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = sandbox.run(&format!("completions {shell}")).assert_ok().stdout;
        for word in commands(&sandbox).iter().map(String::as_str).chain(["hold-out-every"]) {
            assert!(script.contains(word), "{shell}: {word}");
        }
        sandbox.write(&format!("organza.{shell}"), script);
    }
    sandbox.run("completions cmd").assert_refused(&["'cmd'", "bash"]);
    // checked by bash itself
    #[cfg(target_os = "linux")]
    if Path::new("/bin/bash").exists() {
        let complete = |line: &str| {
            let words: Vec<_> = line.split(' ').collect();
            let [.., before, last] = words.as_slice() else { panic!("{line}") };
            let script = format!(
                "source organza.bash; COMP_WORDS=({line}); COMP_CWORD={}; \
                 _organza organza '{last}' '{before}'; echo \"${{COMPREPLY[@]}}\"",
                words.len() - 1
            );
            sandbox.write("complete", script);
            sandbox.shell("bash complete").assert_ok().stdout
        };
        assert_eq!(complete("organza ren").trim(), "render");
        assert_eq!(complete("organza render --spl").trim(), "--split");
        assert_eq!(complete("organza render --split h").trim(), "held-out");
    }
}
