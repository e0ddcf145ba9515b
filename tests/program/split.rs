//! `organza split`, the training of its blocks, and their runs as one scene.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use image::{Rgb, RgbImage};
use organza::data::Block;
use organza::{Camera, Scene};
use serde_json::{Value, json};

use crate::sandbox::Sandbox;
use crate::view::client::{Viewer, pixels};

const SPLIT: &str = "split walk -o blocks --blocks 2";
const TRAIN: &str = "train blocks --config tiny.toml --backend cpu -o";

/// A sandbox with `walk`: photographs along a wall in the plane y = 3 from each `eye`, which is its x and y, and 16 points for each of the
/// wall's meters from `low` to `high`.
fn walk(eyes: impl Iterator<Item = [f64; 2]>, walls: &[[i32; 2]]) -> Sandbox {
    let sandbox = Sandbox::new("tiny");
    sandbox.write("tiny.toml", include_str!("train/tiny.toml"));
    let color = |x: f64, z: f64| {
        let level =
            |phase: f64| (128.0 + 100.0 * (1.7 * x + phase).sin() * (z + phase).cos()) as u8;
        Rgb([level(0.0), level(1.0), level(2.0)])
    };
    let mut cameras = Vec::new();
    for (index, [x, y]) in eyes.enumerate() {
        let up = [0.0, 0.0, 1.0];
        let mut camera = Camera::look_at([x, y, 1.0], [x, 3.0, 1.0], up, 1.0, [32, 32]).unwrap();
        let image = RgbImage::from_fn(32, 32, |column, row| {
            let ray = camera.ray([column, row].map(|at| f64::from(at) + 0.5));
            color(x + (3.0 - y) * ray.x, 1.0 + (3.0 - y) * ray.z)
        });
        let name = format!("{index:02}.png");
        sandbox.make_folder("walk");
        image.save(sandbox.path("walk").join(&name)).unwrap();
        camera.file_path = Some(name);
        cameras.push(camera);
    }
    Camera::save_all(sandbox.path("walk/transforms.json"), &cameras).unwrap();
    let mut points = Vec::new();
    for at in walls.iter().flat_map(|[low, high]| 4 * low..4 * high) {
        for z in [-0.2, 0.6, 1.4, 2.2] {
            let x = f64::from(at) / 4.0;
            let Rgb([red, green, blue]) = color(x, z);
            points.push(format!("{x} 3 {z} {red} {green} {blue}\n"));
        }
    }
    if !points.is_empty() {
        let names = ["x", "y", "z"].map(|name| format!("property float {name}\n")).concat();
        let colors = ["red", "green", "blue"].map(|name| format!("property uchar {name}\n"));
        let head = format!("ply\nformat ascii 1.0\nelement vertex {}\n{names}", points.len());
        let text = format!("{head}{}end_header\n{}", colors.concat(), points.concat());
        sandbox.write("walk/points.ply", text);
        let mut json = sandbox.read_json("walk/transforms.json");
        json["ply_file_path"] = json!("points.ply");
        sandbox.write("walk/transforms.json", json.to_string());
    }
    sandbox
}

/// 16 photographs along a wall of 18 meters.
fn street() -> Sandbox {
    walk((0..16).map(|x| [f64::from(x), 0.0]), &[[-1, 17]])
}

fn block(sandbox: &Sandbox, folder: &str) -> Block {
    Block::load(&sandbox.path(folder)).unwrap()
}

/// The Gaussians of a scene in the world.
fn places(sandbox: &Sandbox, file: &str) -> Vec<[f64; 3]> {
    let scene = Scene::load(sandbox.path(file)).unwrap();
    let world = scene.config.placement;
    scene.gaussians.position.iter().map(|place| world.world(place.map(f64::from))).collect()
}

/// Each pixel of `images` is the mean of those of the blocks, by where the depth of each says that it lies.
fn assert_blended(sandbox: &Sandbox, blocks: &[Block; 2]) {
    for index in [0, 1] {
        let scene = format!("runs/block-{index}/checkpoint.safetensors");
        let words = format!("render {scene} walk -o alone-{index} --channels depth --backend cpu");
        sandbox.run(&words).assert_ok();
    }
    let open = |name: &str| image::open(sandbox.path(name)).unwrap();
    let cameras = Camera::load_all(sandbox.path("walk/transforms.json")).unwrap();
    let mut mixed = 0;
    for (view, camera) in cameras.iter().enumerate() {
        let found = open(&format!("images/{view:02}.png")).to_rgb8();
        let alone = [0, 1].map(|block| open(&format!("alone-{block}/{view:02}.png")).to_rgb8());
        let depths =
            [0, 1].map(|block| open(&format!("alone-{block}/{view:02}.depth.png")).to_luma16());
        for (column, row, pixel) in found.enumerate_pixels() {
            let ray = camera.ray([column, row].map(|at| f64::from(at) + 0.5));
            let weights = [0, 1].map(|block| {
                let depth = f64::from(depths[block].get_pixel(column, row).0[0]) / 1000.0;
                let Block { placement, sides, border, .. } = &blocks[block];
                let x = placement.own([0, 1, 2].map(|i| camera.eye()[i] + depth * ray[i]))[0];
                let inside =
                    if block == 0 { sides[1][0].unwrap() - x } else { x - sides[0][0].unwrap() };
                if depth > 0.0 { (0.5 + inside / border).clamp(1e-6, 1.0) } else { 1e-9 }
            });
            let sum: f64 = weights.iter().sum();
            mixed += usize::from(weights.iter().all(|weight| *weight > 0.2 * sum));
            for channel in 0..3 {
                let value =
                    |block: usize| f64::from(alone[block].get_pixel(column, row).0[channel]);
                // a color outside of 0 to 1 is only clamped in the end
                if [0, 1].iter().any(|block| [0.0, 255.0].contains(&value(*block))) {
                    continue;
                }
                let mean = (weights[0] * value(0) + weights[1] * value(1)) / sum;
                // depths and colors are rounded
                let error = (mean - f64::from(pixel.0[channel])).abs();
                assert!(error < 4.0, "{view}: {column}, {row}: {error}");
            }
        }
    }
    assert!(mixed > 0, "the blocks meet in no photograph");
}

#[test]
fn blocks_are_trained_apart_and_shown_as_one_scene() {
    let sandbox = street();
    sandbox.run(SPLIT).assert_ok().says(&["wrote 2 blocks", "of 16 photographs"]);
    let blocks = [0, 1].map(|index| block(&sandbox, &format!("blocks/block-{index}")));
    let names: BTreeSet<_> = blocks.iter().flat_map(|block| &block.frames).collect();
    assert_eq!(names.len(), 16, "each photograph is in a block");
    let counts = blocks.each_ref().map(|block| block.frames.len());
    assert!(counts.iter().all(|count| (8..=11).contains(count)), "{counts:?}");
    // the middle of what the photographs see, to a point's distance
    let [side, other] = [blocks[0].sides[1][0], blocks[1].sides[0][0]].map(Option::unwrap);
    let middle = blocks[0].placement.world([side, 0.0, 0.0])[0];
    assert!(side == other && (middle - 7.5).abs() < 0.5, "{middle}");
    let report = sandbox.text("blocks/report.html");
    assert_eq!(report.matches("<rect").count(), 2);
    assert_eq!(report.matches("<line").count(), 16);
    sandbox.run(&SPLIT.replace("blocks", "again").replace("--again", "--blocks")).assert_ok();
    assert!(sandbox.contents("blocks/block-1") == sandbox.contents("again/block-1"));

    sandbox.run(&format!("{TRAIN} runs")).assert_ok();
    for (index, own) in blocks.iter().enumerate() {
        let kept = places(&sandbox, &format!("runs/block-{index}/block.safetensors"));
        let all = places(&sandbox, &format!("runs/block-{index}/checkpoint.safetensors"));
        assert!(kept.iter().all(|place| own.has(*place) && !blocks[1 - index].has(*place)));
        assert_eq!(kept.len(), all.iter().filter(|place| own.has(**place)).count());
        assert!((1..all.len()).contains(&kept.len()), "{} of {}", kept.len(), all.len());
    }
    let before = sandbox.files();
    sandbox.run(&format!("{TRAIN} runs")).assert_ok().says(&["block-1 is finished already"]);
    assert!(before == sandbox.files(), "a finished block was trained");

    // as the page's array of Slurm does it, one of them twice, with ranks, to the same bits
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/cluster.md");
    let page = fs::read_to_string(page).unwrap();
    let job = page.split("```text").find(|block| block.contains("--array")).expect("a job");
    let job = job.split("```").next().unwrap().replace("runs/", "array/");
    let new = "case \"$*\" in *--resume*) ;; *) set -- \"$@\" --config tiny.toml --ranks 2; esac";
    let program = format!("organza() {{ {new}; \"$ORGANZA\" \"$@\" --backend cpu; }}");
    let array = "for SLURM_ARRAY_TASK_ID in 1 0 0; do";
    sandbox
        .shell(&format!("set -e; srun() {{ \"$@\"; }}; {program}; {array} {job} done"))
        .assert_ok();
    for run in ["block-0", "block-1"] {
        let scene = |folder: &str| sandbox.read(&format!("{folder}/{run}/block.safetensors"));
        assert!(scene("runs") == scene("array"), "{run}");
    }

    sandbox.run("render runs -o images --backend cpu").assert_ok().says(&["16 images"]);
    assert_blended(&sandbox, &blocks);
    let found = sandbox.run("eval runs --backend cpu --json").json();
    let views: Vec<_> =
        found["views"].as_array().unwrap().iter().map(|view| &view["name"]).collect();
    let held_out = ["00", "03", "06", "09", "12", "15"].map(|name| json!(format!("{name}.png")));
    assert_eq!(views, held_out.iter().collect::<Vec<_>>());
    let one = |run: &str| {
        let words = format!("eval runs/{run}/block.safetensors walk --backend cpu --json");
        sandbox.run(&words).json()["mean"]["psnr"].as_f64().unwrap()
    };
    let both = found["mean"]["psnr"].as_f64().unwrap();
    let alone = ["block-0", "block-1"].map(one);
    assert!(alone.iter().all(|alone| both > alone + 0.5), "{both}, alone {alone:?}");
    sandbox.run("film runs -o film --frames 2 --size 32x32 --backend cpu").assert_ok();
    sandbox.run("export-web runs -o page --size 64x48 --backend cpu").assert_ok();
    sandbox.run("export runs -o all.ply --steps 0 --side 32 --backend cpu").assert_ok();
    let exported = organza::splats::load(sandbox.path("all.ply")).unwrap();
    for own in &blocks {
        let inside = |splat: &organza::splats::Splat| own.has(splat.position.map(f64::from));
        assert!(exported.splats.iter().any(inside), "the file lacks a block");
    }
    sandbox.run("mesh runs -o all.obj --size 32 --backend cpu").assert_ok();
    let mesh = sandbox.text("all.obj");
    let vertex = |line: &str| {
        let mut numbers = line.strip_prefix("v ")?.split(' ').map(|x| x.parse().unwrap());
        Some([(); 3].map(|()| numbers.next().unwrap()))
    };
    for own in &blocks {
        assert!(mesh.lines().filter_map(vertex).any(|place| own.has(place)), "no surface there");
    }
    let viewer = Viewer::start(&sandbox, "view runs --port 0 --backend cpu");
    assert_eq!(viewer.scene()["scenes"], 2);
    let camera = &viewer.scene()["views"][8]["camera"];
    let image = viewer.frame(camera, "exact", &json!({})).ok();
    assert!(pixels(&image.body) == pixels(&sandbox.read("images/08.png")));
    for words in ["edit runs -o a.safetensors --scale 1", "explain runs --view 0 --pixel 1,1"] {
        sandbox.assert_refuses(words, &["runs of a split", "name one of them"]);
    }
}

#[test]
fn the_rest_goes_on_where_a_block_fails_or_stops() {
    let sandbox = street();
    sandbox.run(SPLIT).assert_ok();
    let broken = "walk/15.png";
    sandbox.rename(broken, "kept.png");
    sandbox.write(broken, "no picture");
    // the last photograph looks only into one of them
    let fails = block(&sandbox, "blocks/block-1").frames.contains(&"15.png".to_owned());
    let [bad, good] = if fails { ["block-1", "block-0"] } else { ["block-0", "block-1"] };
    let outcome = sandbox.run(&format!("{TRAIN} runs"));
    outcome.assert_refused(&["1 of 2 blocks failed", bad, "the same command"]);
    outcome.says(&[&format!("{bad} failed: "), broken]);
    assert!(sandbox.path(&format!("runs/{good}/block.safetensors")).exists());
    let missing = format!("missing or not finished: {bad}");
    sandbox.assert_refuses("render runs -o images --backend cpu", &["of the 2 blocks", &missing]);
    sandbox.rename("kept.png", broken);
    let mended = sandbox.run(&format!("{TRAIN} runs")).assert_ok();
    mended.says(&[&format!("{good} is finished already")]).says_not(&[&format!("{bad} is fin")]);

    // a run without its end goes on from its checkpoint, to the same bits
    let scene = format!("runs/{good}/block.safetensors");
    let whole = sandbox.read(&scene);
    sandbox.remove(&format!("runs/{good}/block.json"));
    sandbox.remove(&scene);
    let ended = sandbox.run(&format!("{TRAIN} runs --json")).json();
    assert_eq!(ended.as_array().map(Vec::len), Some(1));
    assert_eq!(ended[0]["outcome"], "finished");
    assert!(whole == sandbox.read(&scene), "other bits");
}

#[test]
fn captures_that_cannot_be_split_are_refused_or_doubted() {
    let sandbox = street();
    let many = "split walk -o new --gaussians-per-block";
    sandbox.assert_refuses(&format!("{many} 1000000"), &["needs no split", "train walk -o RUN"]);
    sandbox.assert_refuses("split walk -o new", &["--blocks"]);
    sandbox.assert_refuses("split none -o new --blocks 2", &["none", "no such file"]);
    sandbox.assert_refuses("split walk -o walk --blocks 2", &["walk has files already"]);
    // more blocks than the photographs can tell apart
    let refused = sandbox.run("split walk -o new --blocks 300");
    refused.assert_refused(&["no photograph to train on looks into block-", "fewer `--blocks`"]);
    sandbox.run(SPLIT).assert_ok();
    sandbox.assert_refuses("split blocks/block-0 -o new --blocks 2", &["this is a block already"]);
    for (eyes, walls, words) in [
        // two walls, a kilometer apart
        (
            vec![0, 1, 2, 3, 1000, 1001, 1002, 1003],
            vec![[-2, 5], [998, 1005]],
            "lies in two places",
        ),
        // all photographs from one place, far away, which see everything
        (vec![0; 6], vec![[-1, 1]], "needs no split"),
        (vec![0; 6], vec![[-1, 1]], "stand in block-"),
    ] {
        let eyes = eyes.into_iter().enumerate();
        let sandbox = walk(eyes.map(|(at, x)| [f64::from(x) + 0.3, -0.1 * at as f64]), &walls);
        sandbox.run(SPLIT).assert_ok().says(&[words]);
    }
    // without points, cameras say where the work is
    let sandbox = walk((0..16).map(|x| [f64::from(x), 0.0]), &[]);
    sandbox.run(SPLIT).assert_ok();
    let first = block(&sandbox, "blocks/block-0").frames.len();
    assert!((6..16).contains(&first), "{first} of 16");
}

#[test]
fn blocks_and_runs_that_do_not_belong_together_are_refused() {
    let sandbox = street();
    sandbox.run(SPLIT).assert_ok();
    let steps = "train blocks --config tiny.toml --backend cpu --steps 1 -o runs";
    sandbox.run(steps).assert_ok();
    sandbox.run("split walk -o others --blocks 3").assert_ok();
    let others = steps.replace("blocks", "others");
    sandbox.assert_refuses(&others, &["runs/block-0", "run of another split than others"]);
    let render = "render runs -o images --backend cpu";
    let file = "blocks/block-0/block.json";
    let edited = |key: &str, value: Value| {
        let mut json = sandbox.read_json(file);
        json[key] = value;
        json.to_string()
    };
    let kept = sandbox.text(file);
    let here: PathBuf = sandbox.path("blocks/block-0");
    for (content, facts) in [
        (edited("split", json!("0123")), ["another split than", "move one of them away"]),
        (edited("index", json!(1)), ["block-0", "is the same block"]),
        (edited("index", json!(7)), ["block.json", "block 7 of 2"]),
        (edited("blocks", json!(3)), ["1 of the 3 blocks", "finished: block-2"]),
        (edited("blocks", json!(u64::MAX)), ["missing or not finished: block-2", "block-9"]),
        (edited("data", json!("/none/here")), ["no longer at /none/here", "`data`"]),
        (edited("data", json!(here)), ["block.json", "is a block itself"]),
        (
            edited("frames", json!(["a.png"])),
            ["none of the block's 1 photographs", "split it again"],
        ),
        (edited("frames", json!([])), ["none of the block's 0 photographs", "split it again"]),
        (edited("border", json!("wide")), ["block.json", "no block of a split"]),
        ("{".to_owned(), ["block.json", "line 1"]),
    ] {
        sandbox.write(file, &content);
        let one = sandbox.run("train blocks --config tiny.toml --backend cpu -o new");
        let is_of_block = one.stderr.contains("block-0 failed");
        assert_eq!(one.code, Some(2), "{content}: {one:?}");
        for fact in facts {
            assert!(one.stderr.contains(fact), "{fact}: {one:?}");
        }
        assert_eq!(is_of_block, one.stderr.contains("1 of 2 blocks failed"), "{one:?}");
        sandbox.shell("rm -rf new").assert_ok();
    }
    sandbox.write(file, &kept);
    // runs of two splits in one folder, and one of them missing
    sandbox.copy_file("others/block-1/block.json", "runs/block-1/block.json");
    sandbox.assert_refuses(render, &["runs/block-1", "another split than runs/block-0"]);
    sandbox.shell("mv runs/block-1 away").assert_ok();
    sandbox.assert_refuses(render, &["of the 2 blocks", "missing or not finished: block-1"]);
    sandbox.assert_refuses("eval runs", &["missing or not finished: block-1"]);
    sandbox.remove("runs/block-0/block.safetensors");
    sandbox.shell("mv away runs/block-1; cp blocks/block-1/block.json runs/block-1").assert_ok();
    sandbox.assert_refuses(render, &["runs/block-0/block.safetensors", "no such file"]);
}
