//! `organza export-web`: the page in a browser, compared with the program's images.

use std::path::Path;

use glam::DVec3;
use organza::render::{EyeCache, EyeOptions};
use organza::scene::{self, Contraction};
use organza::{
    Camera, DeviceScene, MODULES, RenderedTiles, Renderer, Scene, TileBatch, UploadOptions, demo,
};
use organza_tests::{cases, devices};
use serde_json::{Value, json};

use crate::sandbox::Sandbox;
use crate::view::chromium::{Page, base64, program};
use crate::view::declared::assert_fields;

/// Side of the page's tiles, in pixels.
const SIDE: u32 = 32;
const SIZE: [u32; 2] = [160, 128];
const WINDOW: [u32; 2] = [400, 320];
const AT_REST: &str = "document.documentElement.dataset.quality === 'rest'";

/// A sandbox with some of the built-in scene's Gaussians, enlarged, cameras around them, and cameras far away. `outside` is the
/// same scene, with a box that contains only half of it.
fn sandbox() -> (Sandbox, [Scene; 2], Vec<Camera>) {
    let sandbox = Sandbox::new("tiny");
    // each lies in several tiles
    let mut scene = cases::thinned(80, 2.2);
    // a browser without a GPU takes long for samples
    scene.config.step *= 4.0;
    let mut outside = scene.clone();
    outside.config.contraction = Contraction::Cube;
    outside.config.occupancy = 24;
    outside.config.aabb = scene.config.aabb.map(|corner| corner.map(|x| 0.4 * x));
    scene.save(sandbox.path("thin.safetensors")).expect("a scene");
    outside.save(sandbox.path("outside.safetensors")).expect("a scene");
    let near: Vec<_> =
        demo::turntable(6, SIZE[1]).iter().map(|camera| camera.with_size(SIZE)).collect();
    let mut far = near.clone();
    for camera in &mut far {
        (0..3).for_each(|row| camera.camera_to_world[row][3] *= 8.0);
    }
    Camera::save_all(sandbox.path("near.json"), &near).expect("cameras");
    Camera::save_all(sandbox.path("far.json"), &far).expect("cameras");
    (sandbox, [scene, outside], near)
}

fn url(path: &Path) -> String {
    format!("file://{}", path.display())
}

/// A camera in the page's form.
fn lens(camera: &Camera) -> Value {
    json!({"camera_to_world": camera.camera_to_world, "fl_x": camera.fl_x, "fl_y": camera.fl_y,
        "cx": camera.cx, "cy": camera.cy, "w": camera.width, "h": camera.height})
}

/// An image of the page: pixels, the numbers of pairs, intersections and samples, and the number of plans that were too
/// small.
fn played(page: &mut Page, camera: &Camera, steps: u16) -> (Vec<f32>, [u64; 3], u64) {
    let script = include_str!("played.js");
    let found = page.eval(&format!("({script})({}, {steps})", lens(camera)));
    let bytes = base64(found["pixels"].as_str().expect("pixels"));
    let counts = serde_json::from_value(found["counts"].clone()).expect("three numbers");
    (bytemuck::pod_collect_to_vec(&bytes), counts, found["small"].as_u64().expect("a number"))
}

/// Asserts that the page's image equals the program's on the CPU, with the same tiles. Returns the number of plans that were
/// too small.
fn assert_same(
    page: &mut Page,
    (cpu, scene): (&Renderer, &DeviceScene),
    camera: &Camera,
    steps: u16,
) -> u64 {
    let batch = TileBatch::cover(0, camera.width, camera.height, SIDE).expect("tiles");
    let options = EyeOptions {
        channels: &[],
        steps,
        renewed: None,
        background: None,
        is_cancelled: &|| false,
    };
    let rendered: RenderedTiles = cpu
        .render_from_eye(scene, camera, &batch, &mut EyeCache::default(), &options)
        .expect("an image")
        .expect("it was not cancelled");
    let (pixels, counts, small) = played(page, camera, steps);
    let report = &rendered.report;
    assert_eq!(counts, [report.pairs, report.intersections, report.samples], "steps x {steps}");
    assert!(report.samples > 1000, "{report:?}");
    let side = SIDE as usize;
    let width = camera.width as usize;
    let height = camera.height as usize;
    let mut apart = 0.0_f32;
    for (tile, place) in batch.tiles.iter().enumerate() {
        let [left, top] = place.origin.map(|at| at as usize);
        for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
            let column = left + x;
            let row = top + y;
            if column < width && row < height {
                let found = &pixels[3 * (row * width + column)..][..3];
                for (expected, found) in rendered.rgb(tile, x, y).iter().zip(found) {
                    assert!(found.is_finite(), "pixel {column}, {row}");
                    apart = apart.max((expected - found).abs());
                }
            }
        }
    }
    assert!(apart < 1e-4, "steps x {steps}: {apart}");
    small
}

/// The pose of a page's camera.
#[derive(Debug)]
struct Place {
    eye: DVec3,
    forward: DVec3,
    /// Center of the orbit.
    center: DVec3,
}

impl Place {
    fn measure(page: &mut Page) -> Self {
        let (pose, center): (Vec<[f64; 4]>, [f64; 3]) =
            page.value("[organza.camera.camera_to_world, organza.center]");
        let column = |at: usize| DVec3::new(pose[0][at], pose[1][at], pose[2][at]);
        Self { eye: column(3), forward: -column(2), center: center.into() }
    }

    fn distance(&self) -> f64 {
        self.eye.distance(self.center)
    }
}

/// Asserts that mouse, fingers and keys move the camera as the page's help says.
fn assert_controls(page: &mut Page) {
    let middle = [200.0, 160.0];
    let right = [260.0, 170.0];
    // each rotates the scene: the distance stays, and the direction changes
    let orbits: [&dyn Fn(&mut Page); 2] =
        [&|page| page.drag(middle, right), &|page| page.fingers(&[[middle, right]])];
    for (orbit, what) in orbits.iter().zip(["the mouse", "a finger"]) {
        let before = Place::measure(page);
        orbit(page);
        let after = Place::measure(page);
        assert!(after.forward.dot(before.forward) < 0.97, "{what}: {before:?} {after:?}");
        assert_eq!(after.center, before.center, "{what}");
        assert!((after.distance() / before.distance() - 1.0).abs() < 1e-6, "{what}");
    }

    // spreading two fingers brings the scene nearer, by the same factor
    let before = Place::measure(page);
    page.fingers(&[[[180.0, 160.0], [150.0, 160.0]], [[220.0, 160.0], [250.0, 160.0]]]);
    let after = Place::measure(page);
    let nearer = after.distance() / before.distance();
    assert!((nearer - 0.4).abs() < 0.01, "{nearer}: {before:?} {after:?}");
    assert!(after.forward.distance(before.forward) < 1e-6, "{before:?} {after:?}");
    // moving two fingers in parallel moves it
    page.fingers(&[[[180.0, 160.0], [180.0, 200.0]], [[220.0, 160.0], [220.0, 200.0]]]);
    let moved = Place::measure(page);
    let by = Place::measure(page).center - after.center;
    assert!((moved.distance() / after.distance() - 1.0).abs() < 1e-6);
    assert!(by.length() > 0.05 * after.distance(), "{by}");
    assert!(by.dot(after.forward).abs() < 1e-6 * by.length(), "{by} {after:?}");

    // holding a key flies along the line of sight
    page.letter("keyDown", 'w');
    page.wait(&format!("organza.center[0] !== {:?}", moved.center.x));
    page.letter("keyUp", 'w');
    let stopped = Place::measure(page);
    let by = stopped.eye - moved.eye;
    assert!(by.normalize().dot(moved.forward) > 1.0 - 1e-6, "{by} {moved:?}");
    page.wait(AT_REST);
    assert_eq!(Place::measure(page).eye, stopped.eye);
}

/// Asserts that the page turns slowly until it is touched, where visitors accept motion.
fn assert_turns(page: &mut Page, url: &str) {
    // as on a fast device, which a browser without a GPU is not
    const REVEAL: &str =
        "organza.revealed = false, organza.pace.shrink = 1, organza.reveal(), organza.turning";
    assert_eq!(page.eval(REVEAL), json!(false));
    assert_eq!(page.eval("document.getElementById('status').hidden"), json!(true));
    let motion =
        |value: &str| json!({"features": [{"name": "prefers-reduced-motion", "value": value}]});
    page.call("Emulation.setEmulatedMedia", motion("no-preference"));
    page.go(url);
    page.wait(AT_REST);
    assert_eq!(page.eval(REVEAL), json!(true));
    page.wait("organza.camera.camera_to_world[0][3] !== organza.header.way[0][0]");
    // a third of the way around, it has the distance of the cameras, and looks at the center
    page.eval("organza.touch(), organza.turnTo(1 / 3), organza.moved()");
    let place = Place::measure(page);
    let toward = (place.center - place.eye).normalize();
    assert!(toward.dot(place.forward) > 1.0 - 1e-6, "{place:?}");
    let place_of = |page: &mut Page| page.eval("organza.camera.camera_to_world");
    let before = place_of(page);
    page.wait(AT_REST);
    assert_eq!(place_of(page), before, "it turns although it was touched");
    page.screenshot("web-turned");
    page.call("Emulation.setEmulatedMedia", motion("reduce"));
    // counters come when they are asked for
    page.letter("keyDown", 'i');
    assert_eq!(page.eval("document.getElementById('status').hidden"), json!(false));
    page.go(&format!("{url}?embed"));
    page.wait(AT_REST);
    let title = "getComputedStyle(document.getElementById('title')).display";
    assert_eq!(page.eval(title), json!("none"));
    page.go(url);
    page.wait(AT_REST);
    assert_ne!(page.eval(title), json!("none"));
}

/// Asserts that the page begins at a camera, says if the view is far from all, and that a key goes to the nearest.
fn assert_knows_cameras(page: &mut Page, cameras: &[Camera]) {
    page.letter("keyDown", 'r');
    let at = |page: &mut Page| {
        let Place { eye, .. } = Place::measure(page);
        cameras.iter().position(|camera| eye.distance(camera.eye().into()) < 1e-5)
    };
    let is_far = "!document.getElementById('far').hidden";
    let home = at(page).expect("a camera");
    page.wait(AT_REST);
    assert_eq!(page.eval(is_far), json!(false));
    page.eval(
        "organza.camera.camera_to_world = organza.camera.camera_to_world.map((row, at) => \
         at < 3 ? [row[0], row[1], row[2], 2 * row[3]] : row), organza.moved()",
    );
    page.wait(AT_REST);
    page.wait(is_far);
    // about twice as far from the center is 1 / 0.35 times as far as 20 degrees, where (4 - 1 / 0.35) / 3 = 0.38 is left
    let opacity: f64 = page.value("+document.getElementById('view').style.opacity");
    assert!((opacity - 0.38).abs() < 0.01, "{opacity}");
    assert_eq!(page.eval("document.getElementById('status').hidden"), json!(false));
    page.letter("keyDown", 'n');
    assert_eq!(at(page), Some(home));
    page.wait(&format!("!({is_far})"));
}

/// Asserts that every kernel compiles on a device with the guaranteed limits.
fn assert_all_compile(page: &mut Page) {
    let kernel = |kernel: muslin_device::CompiledKernel| {
        let access = kernel.entry().interface.bindings.iter().map(|binding| &*binding.access);
        let access: Vec<_> = access.collect();
        let code = kernel.to_wgsl().expect("it is for browsers");
        json!({"name": kernel.entry().name, "access": access, "code": code})
    };
    // no variants
    let plain = muslin::kernels().map(|kernel| MODULES.find(kernel.name).expect("it is compiled"));
    let kernels: Vec<_> = plain.map(kernel).collect();
    let script = format!("({})({})", include_str!("compile.js"), json!(kernels));
    assert_eq!(page.eval(&script), json!([]));
}

#[test]
fn a_page_renders_by_itself() {
    let Some(program) = program() else { return };
    let (sandbox, scenes, cameras) = sandbox();
    let cpu = Renderer::new(devices::cpu(None));
    let halves = UploadOptions { half_grids: true };
    let [scene, outside] = scenes.each_ref().map(|scene| cpu.upload_with(scene, halves).unwrap());
    let words = "export-web thin.safetensors near.json -o page --size 160x128 --backend cpu";
    sandbox.run(words).assert_ok().says(&["open page/index.html in a browser"]);
    let folder = url(&sandbox.path("page/index.html"));
    let mut page = Page::open_with_webgpu(program, &folder, WINDOW);
    page.wait(AT_REST);
    assert_eq!(page.eval("document.title"), "thin \u{b7} organza");
    for (name, value) in [("Header", ""), ("Kernel", ".kernels[0]"), ("Plan", ".plans[0]")] {
        assert_fields(name, &page.eval(&format!("Object.keys(organza.header{value})")));
    }
    page.screenshot("web");
    for steps in [1, 2] {
        assert_eq!(assert_same(&mut page, (&cpu, &scene), &cameras[0], steps), 0);
    }
    assert_same(&mut page, (&cpu, &scene), &cameras[2].with_size([150, 70]), 1);
    assert_turns(&mut page, &folder);
    assert_knows_cameras(&mut page, &cameras);

    assert_controls(&mut page);
    page.wait(AT_REST);
    assert_all_compile(&mut page);
    assert_eq!(page.eval("organza.errors"), json!([]));

    // several scenes are a page, too
    let put = scene::Place {
        offset: [0.3, -0.2, 0.4],
        turn: [20.0, 0.0, 70.0],
        scale: 0.6,
        ..scene::Place::default()
    };
    sandbox.write("place.json", serde_json::to_string(&put).unwrap());
    let words = "export-web thin.safetensors outside.safetensors@place.json near.json -o both.html \
                 --single-file --size 160x128 --backend cpu";
    sandbox.run(words).assert_ok();
    page.go(&url(&sandbox.path("both.html")));
    page.wait(AT_REST);
    page.screenshot("web-together");
    let [first, second] = scenes.each_ref().map(|scene| &scene.config.placement);
    let mut both = scene.clone();
    both.put(outside.clone(), first.place(second, &put).unwrap()).unwrap();
    for steps in [1, 2] {
        assert_same(&mut page, (&cpu, &both), &cameras[1], steps);
    }
    assert_eq!(page.eval("organza.errors"), json!([]));

    // plans measured from far away are too small for a near camera: larger ones replace them
    let words = "export-web outside.safetensors far.json -o far.html --single-file --size 160x128";
    sandbox.run(&format!("{words} --title Far --backend cpu")).assert_ok();
    page.go(&url(&sandbox.path("far.html")));
    page.wait(AT_REST);
    assert_eq!(page.eval("document.title"), "Far \u{b7} organza");
    assert!(assert_same(&mut page, (&cpu, &outside), &cameras[0], 1) > 0, "no plan was too small");
    // the page itself does that: it shows the image of a larger plan, and no empty one
    let script = include_str!("grown.js");
    let grown = page.eval(&format!("({script})({})", lens(&cameras[0])));
    assert_eq!(grown, json!({"shown": 1, "grown": true}));
    assert_eq!(page.eval("document.getElementById('message').hidden"), json!(true));
    assert_eq!(page.eval("organza.errors"), json!([]));
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

#[test]
fn without_webgpu_a_page_says_so() {
    let Some(program) = program() else { return };
    let sandbox = Sandbox::new("tiny");
    sandbox.run("export-web scene.safetensors -o page.html --single-file --title Mine").assert_ok();
    let mut page = Page::open(program, &url(&sandbox.path("page.html")), WINDOW);
    let message: String = page.value("document.getElementById('message').textContent");
    assert!(message.contains("WebGPU") && message.contains("browser"), "{message}");
    assert_eq!(page.eval("document.getElementById('title').textContent"), "Mine");
    // a browser can show the poster
    let poster = "(async () => { const image = new Image(); image.src = getComputedStyle(document.getElementById('poster'))\
        .getPropertyValue('--picture').slice(4, -1); await image.decode(); return image.naturalWidth; })()";
    assert!(page.value::<u32>(poster) > 100);
    for (name, size) in [("wide", [1280, 720]), ("narrow", [390, 844])] {
        page.resize(size);
        page.screenshot(&format!("web-poster-{name}"));
    }
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

#[test]
fn a_page_that_was_copied_in_part_says_so() {
    let Some(program) = program() else { return };
    let sandbox = Sandbox::new("tiny");
    sandbox.run("export-web scene.safetensors -o page --size 64x48").assert_ok();
    let assert_says = |file: &str| {
        let mut page = Page::open(program, &url(&sandbox.path("page/index.html")), WINDOW);
        let message: String = page.value("document.getElementById('message').innerText");
        assert!(message.contains(file) && message.contains("copy the whole folder"), "{message}");
    };
    let whole = sandbox.text("page/scene.js");
    sandbox.write("page/scene.js", &whole[..whole.len() / 2]);
    assert_says("scene.js");
    sandbox.remove("page/scene.js");
    assert_says("scene.js");
    sandbox.write("page/scene.js", whole);
    sandbox.remove("page/page.js");
    assert_says("page.js");
}

#[test]
fn a_page_replaces_no_other() {
    let sandbox = Sandbox::new("tiny");
    sandbox.write("site/index.html", "<h1>mine</h1>");
    let facts = ["site", "index.html", "choose another folder"];
    sandbox.assert_refuses("export-web scene.safetensors -o site", &facts);
    let words = "export-web scene.safetensors -o scene.safetensors --single-file";
    sandbox.assert_refuses(words, &["would replace the input"]);
    sandbox.write("run/config.toml", "");
    let facts = ["run holds a training run", "choose another folder"];
    sandbox.assert_refuses("export-web scene.safetensors -o run", &facts);
    // a page of its own may
    let bytes_of_scene = |options: &str| {
        let words = format!("export-web scene.safetensors -o page --size 64x48 {options}");
        sandbox.run(&words).assert_ok();
        sandbox.read("page/scene.js").len()
    };
    assert!(bytes_of_scene("") < bytes_of_scene("--full-grids"));
    let files = sandbox.contents("page");
    assert!(
        files.keys().eq(&["index.html", "page.js", "poster.jpg", "scene.js"]),
        "{:?}",
        files.keys()
    );
    // the poster is a JPEG, as `view`'s images are
    assert!(files["poster.jpg"].starts_with(&[0xff, 0xd8]));
    for words in ["--size 5x5", "--size 9000x10", "--size wide"] {
        let words = format!("export-web scene.safetensors -o page {words}");
        assert_eq!(sandbox.run(&words).code, Some(2), "{words}");
    }
}
