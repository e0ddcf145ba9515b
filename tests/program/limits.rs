//! Too little memory, full disks, and readers that leave.

use std::fs::{self, File};
use std::io::Write;
use std::process::Stdio;

use organza_tests::devices::skip;
use serde_json::json;

use crate::sandbox::{Sandbox, TILES};

#[cfg(target_os = "linux")]
mod memory {
    use super::*;
    use crate::train::monstrous::soon;

    /// Address space in KiB: enough for the program and the tiny case.
    const LIMIT: u32 = 1_000_000;

    #[track_caller]
    fn assert_refused(sandbox: &Sandbox, words: &str, facts: &[&str]) {
        let before = sandbox.files();
        sandbox.run_within(LIMIT, words).assert_refused(facts);
        assert!(before == sandbox.files(), "{words} left {:?}", sandbox.files().keys());
    }

    /// An object with one entry takes a hundred times the memory of its text.
    #[test]
    fn json_is_held_to_it_before_it_is_parsed() {
        let sandbox = Sandbox::new("tiny");
        let text = format!("{{\"frames\": [{}0]}}", "{\"\":0},".repeat(400_000));
        sandbox.write("cameras.json", text);
        let facts = ["out of memory: parsing cameras.json needs", "are available"];
        sandbox.run_within(200_000, "info cameras.json").assert_refused(&facts);
        sandbox.assert_refuses("info cameras.json", &["frame 0", "`transform_matrix` is missing"]);
    }

    #[test]
    fn a_small_batch_fits() {
        Sandbox::new("tiny").run_within(LIMIT, &format!("{TILES} -o out")).assert_ok();
    }

    #[test]
    fn a_batch_that_does_not_fit() {
        let sandbox = Sandbox::new("tiny");
        sandbox.edit_json("tiles.json", "/side", json!(4096));
        let tile = json!({"camera": 0, "origin": [0, 0]});
        sandbox.edit_json("tiles.json", "/tiles", json!(vec![tile; 8]));
        let facts = ["out of memory", "needs 1.50 GiB", "are available"];
        assert_refused(&sandbox, &format!("{TILES} -o out"), &facts);
    }

    /// Tiles of one pixel are as many as the pixels. Photographs of 24 million pixels would have 24 million tiles.
    #[test]
    fn an_image_that_does_not_fit() {
        let sandbox = Sandbox::new("tiny");
        for side in ["/w", "/h"] {
            sandbox.edit_json("cameras.json", side, json!(65536));
        }
        let words = "render scene.safetensors cameras.json -o images --backend cpu";
        let facts = ["65536 x 65536", "needs 12.00 GiB", "are available"];
        soon("it was rendered first", || assert_refused(&sandbox, words, &facts));
    }

    /// The file has holes, so it takes no space on the disk.
    #[test]
    fn a_scene_that_does_not_fit() {
        const GAUSSIANS: u64 = 50_000_000;
        let sandbox = Sandbox::new("tiny");
        let path = sandbox.path("scene.safetensors");
        let (header, length) = holey_header(&fs::read(&path).unwrap(), GAUSSIANS);
        let mut file = File::create(&path).unwrap();
        file.write_all(&header).unwrap();
        file.set_len(header.len() as u64 + length).unwrap();
        let facts = ["out of memory", "the scene needs 2.42 GiB", "are available"];
        sandbox.run_within(LIMIT, "info scene.safetensors").assert_refused(&facts);
    }

    /// The header of a scene's file with another number of Gaussians, and the length of the data that it announces.
    fn holey_header(file: &[u8], gaussians: u64) -> (Vec<u8>, u64) {
        let length = u64::from_le_bytes(file[..8].try_into().unwrap()) as usize;
        let mut header: serde_json::Map<_, _> =
            serde_json::from_slice(&file[8..8 + length]).unwrap();
        let mut begin = 0;
        for (name, info) in header.iter_mut().filter(|(name, _)| *name != "__metadata__") {
            if name.starts_with("gaussians.") {
                info["shape"][0] = json!(gaussians);
            }
            let sizes = info["shape"].as_array().unwrap().iter();
            let end = begin + 4 * sizes.map(|size| size.as_u64().unwrap()).product::<u64>();
            info["data_offsets"] = json!([begin, end]);
            begin = end;
        }
        let header = serde_json::to_vec(&header).unwrap();
        ([&(header.len() as u64).to_le_bytes(), header.as_slice()].concat(), begin)
    }
}

#[cfg(target_os = "linux")]
#[test]
fn full_disks() {
    let sandbox = Sandbox::new("tiny");
    sandbox.assert_refuses(&format!("{TILES} -o /dev/full"), &["/dev/full", "disk is full"]);

    // A file system of a few pages, if the user may mount one.
    sandbox.make_folder("small");
    let mount = |pages: u32| format!("mount -t tmpfs -o size={}k none small", 4 * pages);
    if sandbox.shell(&format!("unshare -rm {}", mount(1))).code != Some(0) {
        skip("a full disk of a page", "no file system can be mounted here");
        return;
    }
    let run = |pages: u32, words: &str| {
        let script = format!(
            "{} && echo old >small/out && \"$ORGANZA\" {words}; code=$?
             cat small/out >&2; ls -A small >&2; exit $code",
            mount(pages)
        );
        sandbox.shell(&format!("unshare -rm sh -c '{script}'"))
    };
    let outcome = run(1, &format!("{TILES} -o small/out"));
    outcome.assert_refused(&["small/out", "disk is full", "free some space"]);
    assert!(outcome.stderr.ends_with("\nold\nout\n"), "{outcome:?}");
    // The lock comes first, and then an image.
    let files = ["small/.organza-lock", "small/0000.png"];
    for (pages, full) in (1..).zip(files) {
        let outcome =
            run(pages, "render scene.safetensors cameras.json -o small --overwrite --backend cpu");
        outcome.assert_refused(&[full, "disk is full"]);
        assert!(outcome.stderr.ends_with("\nold\nout\n"), "{outcome:?}");
    }
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let sandbox = Sandbox::new("basic");
    for words in [
        "info scene.safetensors",
        "info scene.safetensors --json",
        "explain scene.safetensors cameras.json --pixel 40,30",
        "--help",
        "--version",
    ] {
        let mut child = sandbox.command(words).stdout(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait().unwrap().code(), Some(0), "{words}");
    }
    let mut child =
        sandbox.command(&format!("{TILES} -o out")).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stderr.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
