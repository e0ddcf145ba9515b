//! Data sets that are malicious, or as damaged as if they were.
#![cfg(target_os = "linux")]

use serde_json::json;

use super::monstrous::soon;
use super::runs::{photographs, sandbox};
use crate::sandbox::Sandbox;

const TRAIN: &str = "train data --config tiny.toml --steps 2 --backend cpu -o run";

/// A data set of two photographs of 96 x 80 pixels.
fn data() -> Sandbox {
    let sandbox = sandbox();
    photographs(&sandbox);
    sandbox
}

/// A gray JPEG whose header announces a size, with a single block of data.
fn small_jpeg([width, height]: [u16; 2]) -> Vec<u8> {
    let mut file = vec![0xff, 0xd8, 0xff, 0xdb, 0, 67, 0];
    file.extend([1; 64]);
    file.extend([0xff, 0xc0, 0, 11, 8]);
    file.extend([height.to_be_bytes(), width.to_be_bytes()].as_flattened());
    file.extend([1, 1, 0x11, 0]);
    for table in [0x00, 0x10] {
        file.extend([0xff, 0xc4, 0, 20, table, 1]);
        file.extend([0; 15]);
        file.push(0);
    }
    file.extend([0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x3f, 0xff, 0xd9]);
    file
}

/// A chunk of a PNG with its checksum.
fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body = [name, data].concat();
    let crc = crc32fast::hash(&body).to_be_bytes();
    [&(data.len() as u32).to_be_bytes(), body.as_slice(), &crc].concat()
}

/// A PNG whose header announces a size, without any pixel.
fn small_png(size: [u32; 2], depth: u8, color: u8) -> Vec<u8> {
    let [width, height] = size.map(u32::to_be_bytes);
    let header = [width.as_slice(), &height, &[depth, color, 0, 0, 0]].concat();
    let nothing = [0x78, 0x9c, 3, 0, 0, 0, 0, 1];
    [
        b"\x89PNG\r\n\x1a\n".as_slice(),
        &chunk(b"IHDR", &header),
        &chunk(b"IDAT", &nothing),
        &chunk(b"IEND", b""),
    ]
    .concat()
}

/// Replaces the first photograph, and gives every camera its size.
fn replace_photograph(sandbox: &Sandbox, file: &[u8], [width, height]: [u32; 2]) {
    sandbox.write("data/images/0000.png", file);
    sandbox.edit_json("data/transforms.json", "/w", json!(width));
    sandbox.edit_json("data/transforms.json", "/h", json!(height));
}

#[test]
fn photographs_that_say_they_are_huge_are_refused() {
    let sandbox = data();
    for (file, size) in [
        (small_jpeg([30_000, 30_000]), [30_000, 30_000]),
        (small_jpeg([65_500, 65_500]), [65_500, 65_500]),
        (small_png([65_536, 65_536], 16, 6), [65_536, 65_536]),
        (small_png([30_000, 30_000], 1, 0), [30_000, 30_000]),
    ] {
        assert!(file.len() < 400);
        replace_photograph(&sandbox, &file, size);
        for more in ["", "--downscale 64"] {
            let words = format!("{TRAIN} --hold-out-every 0 {more}");
            // a tebibyte is no limit
            for kib in [1 << 30, 4_000_000] {
                soon(&words, || sandbox.run_within(kib, &words)).assert_refused(&[]);
                assert!(!sandbox.path("run").exists());
            }
        }
    }
}

/// Decoding one photograph may take more than the limit, whatever the process has taken already.
#[test]
fn decoding_has_a_budget() {
    let sandbox = data();
    let size = [8000, 6000];
    image::GrayImage::new(size[0], size[1]).save(sandbox.path("data/images/0000.png")).unwrap();
    let file = sandbox.read("data/images/0000.png");
    replace_photograph(&sandbox, &file, size);
    let frame = sandbox.read_json("data/transforms.json")["frames"][0].clone();
    sandbox.edit_json("data/transforms.json", "/frames", json!([frame]));
    let train = format!("{TRAIN} --downscale 50 --hold-out-every 0");
    let facts = ["out of memory", "decoding", "8000 x 6000", "are available"];
    sandbox.run_within(500_000, &train).assert_refused(&facts);
    sandbox.run(&train).assert_ok();
}

/// A zlib stream of `length` zeros, 158 times smaller: copies of 258 bytes, in 13 bits each.
fn zeros(length: usize) -> Vec<u8> {
    // a last block with fixed codes, a zero, 16 copies, and the end
    let bits = ["110", "00110000", &"1100010100000".repeat(16), "0000000"].concat();
    let mut bytes = vec![0; bits.len().div_ceil(8)];
    for (index, bit) in bits.bytes().enumerate() {
        bytes[index / 8] |= (bit - b'0') << (index % 8);
    }
    // eight copies are 13 bytes
    let more = bytes[2..15].repeat(length / 258 / 8);
    [&[0x78, 1], &bytes[..2], &more, &bytes[2..]].concat()
}

/// Color profiles are not needed here, and may be shorter than they say.
#[test]
fn profiles_that_grow_are_passed_over() {
    let sandbox = data();
    for name in ["0000", "0001"] {
        let name = format!("data/images/{name}.png");
        let file = sandbox.read(&name);
        let (header, rest) = file.split_at(33);
        let profile = chunk(b"iCCP", &[b"a\0\0", zeros(400 << 20).as_slice()].concat());
        sandbox.write(&name, [header, &profile, rest].concat());
    }
    sandbox.run_within(600_000, &format!("{TRAIN} --downscale 2 --hold-out-every 0")).assert_ok();
}

#[test]
fn many_missing_photographs_are_one_line() {
    let sandbox = data();
    let mut file = sandbox.read_json("data/transforms.json");
    let frames = file["frames"].as_array_mut().unwrap();
    let pose = frames[0]["transform_matrix"].clone();
    frames.extend((0..20_000).map(|number| {
        json!({"file_path": format!("images/lost-{number}.png"), "transform_matrix": pose})
    }));
    sandbox.write("data/transforms.json", file.to_string());
    let outcome = sandbox.run(&format!("{TRAIN} --downscale 2 --hold-out-every 0")).assert_ok();
    let facts = "missing, so left out: 20,000 photographs, the first is ";
    assert!(outcome.stderr.contains(facts) && outcome.stderr.len() < 2000, "{outcome:?}");
}

#[test]
fn files_outside_the_data_sets_folder_are_read_where_that_is_allowed() {
    let allow = format!("{TRAIN} --downscale 2 --hold-out-every 0 --allow-outside");
    let facts = ["outside of", "--allow-outside"];
    for link in [false, true] {
        let sandbox = data();
        sandbox.rename("data/images/0001.png", "other.png");
        if link {
            std::os::unix::fs::symlink("../../other.png", sandbox.path("data/images/0001.png"))
                .unwrap();
        } else {
            sandbox.edit_json("data/transforms.json", "/frames/1/file_path", json!("../other.png"));
        }
        sandbox.assert_refuses(TRAIN, &facts);
        sandbox.assert_refuses("eval scene.safetensors data --backend cpu", &facts);
        sandbox
            .run(&allow)
            .assert_ok()
            .says(&["read outside the data set's folder", "1 file, the first is "]);
        // the run's own settings allow it
        sandbox.run("train --resume run --backend cpu").assert_ok();
        sandbox
            .run("eval scene.safetensors data --split all --allow-outside --backend cpu")
            .assert_ok();
    }
}

#[test]
fn no_text_of_a_file_that_a_data_set_names_is_shown() {
    let sandbox = data();
    sandbox.write("data/secret", "root:hunter2:0:0\nply hunter2\n");
    let mut file = sandbox.read_json("data/transforms.json");
    for (points, facts) in [
        ("/etc/passwd", ["/etc/passwd", "--allow-outside"]),
        ("secret", ["secret", "not a whole PLY file"]),
    ] {
        file["ply_file_path"] = json!(points);
        sandbox.write("data/transforms.json", file.to_string());
        for more in ["", "--allow-outside"] {
            let outcome = sandbox.run(&format!("{TRAIN} {more}"));
            outcome.assert_refused(if more.is_empty() { &facts[..] } else { &facts[..1] });
            for secret in ["root", "hunter2"] {
                assert!(!outcome.stderr.contains(secret), "{outcome:?}");
            }
        }
    }
}

/// Empty lines are no records, and take no memory.
#[test]
fn logs_are_read_line_by_line() {
    let sandbox = sandbox();
    sandbox.run("train views --config tiny.toml --steps 2 --backend cpu -o run").assert_ok();
    let log = sandbox.read("run/metrics.jsonl");
    sandbox.write("run/metrics.jsonl", [log.as_slice(), &[b'\n'; 60 << 20]].concat());
    sandbox.run_within(900_000, "train --resume run --backend cpu").assert_ok();
    assert!(sandbox.read("run/metrics.jsonl").len() < 2 * log.len());
}

#[test]
fn settings_that_are_no_files_are_refused() {
    let sandbox = sandbox();
    sandbox
        .shell("mkfifo pipe; head -c 3000000 /dev/zero >large; printf '\\377' >bytes")
        .assert_ok();
    for (path, fact) in [
        ("pipe", "device or a pipe"),
        ("/dev/zero", "device or a pipe"),
        (".", "a folder"),
        ("large", "too large for settings"),
        ("bytes", "not UTF-8"),
    ] {
        let script = format!(
            "ulimit -v 2000000; timeout 60 \"$ORGANZA\" train --config {path} -o run --backend cpu"
        );
        sandbox.shell(&script).assert_refused(&[path, fact]);
    }
}

/// 1e38 at every pixel adds up to more than an f32 can represent.
#[test]
fn gradients_that_overflow_are_refused() {
    let sandbox = sandbox();
    let side = sandbox.run("info tiles.json --json").json()["side"].as_u64().unwrap() as usize;
    let shape = vec![4, 3, side, side];
    let values = vec![3.4e38_f32; shape.iter().product()];
    let spec = organza::scene::TensorSpec { name: "grad_tiles".to_owned(), shape, why: "" };
    organza::scene::write_tensors(sandbox.path("g.safetensors"), &[(spec, &values)], &[]).unwrap();
    let words = "tiles scene.safetensors cameras.json tiles.json --backend cpu \
                 --grad-tiles g.safetensors --grad out.safetensors";
    let outcome = sandbox.run(words);
    outcome.assert_refused(&["gradient", "lower the learning rates, or look for values"]);
    assert!(!sandbox.path("out.safetensors").exists());
}
