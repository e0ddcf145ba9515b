//! `organza split`, the training of its blocks, and their runs as one scene.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use image::{Rgb, RgbImage};
use organza::data::Block;
use organza::{Camera, Scene};
use serde_json::{Value, json};

use crate::sandbox::{Sandbox, wait_until};
use crate::train::processes::{signal, wait_for_end};
use crate::view::chromium::{Page, program};
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

/// The cameras of the photographs as the data set has them.
fn given(sandbox: &Sandbox) -> Vec<Camera> {
    Camera::load_all(sandbox.path("walk/transforms.json")).unwrap()
}

/// How far a camera of the world is over a block, and how much that grows along a ray.
fn over(block: &Block, camera: &Camera, ray: [f64; 3]) -> [f64; 2] {
    let Block { placement, sides, .. } = block;
    let eye = camera.eye();
    let [x, ahead] = [0.0, 1.0].map(|t| placement.own([0, 1, 2].map(|i| eye[i] + t * ray[i]))[0]);
    let [low, high] = sides.map(|side| side[0]);
    let inside = |x: f64| high.map_or_else(|| x - low.unwrap(), |high| high - x);
    [inside(x), inside(ahead) - inside(x)]
}

/// Each pixel of `images` is the mean of those of the blocks, by where the depth of each says that it lies. Each block has cameras of its own.
/// Where a pixel's ray does not come over a block, that block does not count.
fn assert_blended(
    sandbox: &Sandbox,
    images: &str,
    blocks: &[Block; 2],
    cameras: &[Vec<Camera>; 2],
) {
    for index in [0, 1] {
        let file = format!("cameras-{index}.json");
        Camera::save_all(sandbox.path(&file), &cameras[index]).unwrap();
        let scene = format!("runs/block-{index}/checkpoint.safetensors");
        let words =
            format!("render {scene} {file} -o alone-{index} --channels depth --backend cpu");
        sandbox.run(&format!("{words} --overwrite")).assert_ok();
    }
    let open = |name: &str| image::open(sandbox.path(name)).unwrap();
    let [mut mixed, mut apart] = [0; 2];
    for (view, camera) in cameras[0].iter().enumerate() {
        let name = camera.file_path.as_ref().unwrap().trim_end_matches(".png");
        let found = open(&format!("{images}/{name}.png")).to_rgb8();
        let alone = [0, 1].map(|block| open(&format!("alone-{block}/{name}.png")).to_rgb8());
        let depths =
            [0, 1].map(|block| open(&format!("alone-{block}/{name}.depth.png")).to_luma16());
        for (column, row, pixel) in found.enumerate_pixels() {
            let weights = [0, 1].map(|block| {
                let camera = &cameras[block][view];
                let ray = camera.ray([column, row].map(|at| f64::from(at) + 0.5)).to_array();
                let border = blocks[block].border;
                let [inside, gain] = over(&blocks[block], camera, ray);
                if inside < -0.5 * border && gain <= 0.0 {
                    return 0.0;
                }
                let depth = f64::from(depths[block].get_pixel(column, row).0[0]) / 1000.0;
                let weight = (0.5 + (inside + depth * gain) / border).clamp(1e-6, 1.0);
                if depth > 0.0 { weight } else { 1e-9 }
            });
            let sum: f64 = weights.iter().sum();
            mixed += usize::from(weights.iter().all(|weight| *weight > 0.2 * sum));
            apart += usize::from(weights.contains(&0.0));
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
                assert!(error < 4.0, "{name}: {column}, {row}: {error}");
            }
        }
    }
    assert!(mixed > 0 && apart > 0, "the blocks meet in no photograph, or in all");
}

/// A camera that turns away from a block shows the other one alone, at its cost.
fn assert_unseen_is_not_rendered(sandbox: &Sandbox) {
    let up = [0.0, 0.0, 1.0];
    let away = Camera::look_at([0.0, 0.0, 1.0], [-1.7, 3.0, 1.0], up, 1.0, [64, 64]).unwrap();
    Camera::save_all(sandbox.path("away.json"), &[away]).unwrap();
    let render = |scene: &str, images: &str| {
        let words = format!("render {scene} away.json -o {images} --backend cpu --json");
        sandbox.run(&words).json()
    };
    let both = render("runs", "of-both");
    let one = render("runs/block-0/checkpoint.safetensors", "of-one");
    assert!(one["pairs"].as_u64().unwrap() > 0);
    for what in ["pairs", "members", "samples"] {
        assert_eq!(both[what], one[what], "{what}");
    }
    let [both, one] =
        ["of-both", "of-one"].map(|images| sandbox.read(&format!("{images}/0000.png")));
    assert!(pixels(&both) == pixels(&one));
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
    assert_blended(&sandbox, "images", &blocks, &[0, 1].map(|_| given(&sandbox)));
    assert_unseen_is_not_rendered(&sandbox);
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
    // they are one scene, of which no part can be moved
    assert_eq!(viewer.scene()["scenes"], 1);
    let camera = &viewer.scene()["views"][8]["camera"];
    wait_for_blocks(&viewer, camera, [2, 0, 2]);
    let image = viewer.frame(camera, "exact", &json!({})).ok();
    assert!(pixels(&image.body) == pixels(&sandbox.read("images/08.png")));
    for words in ["edit runs -o a.safetensors --scale 1", "explain runs --view 0 --pixel 1,1"] {
        sandbox.assert_refuses(words, &["runs of a split", "name one of them"]);
    }
}

/// Waits until so many blocks are shown, could not be read, and are there.
fn wait_for_blocks(viewer: &Viewer, camera: &Value, expected: [usize; 3]) {
    let blocks = || viewer.frame(camera, "moving", &json!({})).ok().about()["blocks"].clone();
    wait_until("all blocks", || blocks() == json!(expected));
}

/// The nearest block comes first, and one that cannot be read keeps none of the others away.
#[test]
fn a_viewer_shows_blocks_as_they_come() {
    let sandbox = street();
    sandbox.run("split walk -o blocks --blocks 4").assert_ok();
    sandbox.run(&format!("{TRAIN} runs --steps 1")).assert_ok();
    let broken = "runs/block-2/checkpoint.safetensors";
    sandbox.write(broken, &sandbox.read(broken)[..20_000]);
    let mut viewer = Viewer::start(&sandbox, "view runs --port 0 --backend cpu");
    let scene = viewer.scene();
    let camera = &scene["home"];
    wait_for_blocks(&viewer, camera, [3, 1, 4]);
    if let Some(program) = program() {
        let mut page = Page::open(program, &viewer.url(), [700, 420]);
        let text = |id: &str| format!("document.getElementById('{id}').textContent");
        page.wait(&format!("{}.startsWith('1 of 4 blocks could not be read')", text("message")));
        page.wait(&format!("{} === 'incomplete'", text("quality")));
        page.wait(&format!("{}.startsWith('3 of 4 blocks')", text("numbers")));
    }
    signal(&viewer.child, "INT");
    wait_for_end(&mut viewer.child);
    let said = viewer.last_words();
    let pose: [[f64; 4]; 4] = serde_json::from_value(camera["camera_to_world"].clone()).unwrap();
    let first = Scene::load(sandbox.path("runs/block-0/checkpoint.safetensors")).unwrap();
    let eye = first.config.placement.world(pose.map(|row| row[3])[..3].try_into().unwrap());
    let far = |index: &usize| {
        let Block { placement, sides, .. } = block(&sandbox, &format!("blocks/block-{index}"));
        let x = placement.own(eye)[0];
        let [low, high] = sides.map(|side| side[0]);
        low.map_or(0.0, |low| low - x).max(high.map_or(0.0, |high| x - high)).max(0.0)
    };
    let mut expected = [1, 2, 3];
    expected.sort_by(|a, b| far(a).total_cmp(&far(b)));
    let of_block = |line: &String| {
        let after = line.split("runs/block-").nth(1)?;
        after.split(' ').next()?.parse::<usize>().ok().filter(|_| line.contains("shown"))
    };
    assert_eq!(said.iter().filter_map(of_block).collect::<Vec<_>>(), expected, "{said:?}");
    assert!(said.iter().any(|line| line.contains("runs/block-2 is not shown: ")), "{said:?}");
}

/// A block shows a photograph from where its own run has put the camera.
#[test]
fn refined_poses_are_those_of_each_block() {
    let sandbox = street();
    let settings = include_str!("train/tiny.toml");
    sandbox.write("tiny.toml", format!("{settings}pose = {{ first = 0.02, last = 0.02 }}\n"));
    sandbox.run(SPLIT).assert_ok();
    sandbox.run(&format!("{TRAIN} runs --refine-poses")).assert_ok();
    let blocks = [0, 1].map(|index| block(&sandbox, &format!("blocks/block-{index}")));
    let mut moved = 0;
    let cameras = [0, 1].map(|index| {
        let file = sandbox.path(&format!("runs/block-{index}/cameras.json"));
        let own = Camera::load_all(file).unwrap();
        let mut cameras = given(&sandbox);
        for (name, own) in blocks[index].frames.iter().zip(own) {
            let at = cameras.iter().position(|camera| camera.file_path.as_ref() == Some(name));
            let camera = &mut cameras[at.unwrap()];
            let far = (0..3).map(|i| (camera.eye()[i] - own.eye()[i]).abs()).fold(0.0, f64::max);
            moved += usize::from(far > 0.05);
            camera.camera_to_world = own.camera_to_world;
        }
        cameras
    });
    assert!(moved > 4, "{moved}");
    sandbox.run("render runs -o images --backend cpu").assert_ok();
    assert_blended(&sandbox, "images", &blocks, &cameras);
    // the scores are those of these images
    let found = sandbox.run("eval runs --split train --backend cpu --json").json();
    for view in found["views"].as_array().unwrap() {
        let name = view["name"].as_str().unwrap();
        let [image, truth] = ["images", "walk"]
            .map(|folder| image::open(sandbox.path(folder).join(name)).unwrap().to_rgb8());
        let pairs = image.iter().zip(truth.iter());
        let squares = pairs.map(|(a, b)| ((f64::from(*a) - f64::from(*b)) / 255.0).powi(2));
        let psnr = -10.0 * (squares.sum::<f64>() / image.len() as f64).log10();
        let error = (view["psnr"].as_f64().unwrap() - psnr).abs();
        assert!(error < 0.05, "{name}: {error}");
    }
    // a data set that is named is taken as it is
    sandbox.run("render runs walk -o given --backend cpu").assert_ok();
    assert_blended(&sandbox, "given", &blocks, &[0, 1].map(|_| given(&sandbox)));
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
