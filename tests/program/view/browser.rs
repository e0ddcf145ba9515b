//! The page in a browser, used like a person would.

use glam::{DQuat, DVec3};
use image::RgbImage;
use organza::scene::Place;
use serde_json::{Value, json};

use super::chromium::{Page, base64, program};
use super::client::{VIEW, Viewer, pixels};
use crate::sandbox::Sandbox;
use crate::train::runs::{TINY, photographs, sandbox};

const REST: &str = "document.documentElement.dataset.quality === 'exact' && !organza.frames.busy \
    && !organza.frames.wanted";
/// The bytes of the displayed image, in base64.
const SHOWN: &str = "new Promise((done) => { const reader = new FileReader(); reader.onload = () => \
    done(reader.result.split(',')[1]); reader.readAsDataURL(organza.view.shown.blob); })";

/// The only scene.
const ALONE: &str = "scene.safetensors";
/// Whether the page says that the view is far from all photographs.
const FAR: &str = "!document.getElementById('far').hidden";

/// The center of the canvas on the screen.
fn middle(page: &mut Page) -> [f64; 2] {
    page.value(
        "(() => { const box = document.getElementById('overlay').getBoundingClientRect(); \
         return [box.left + box.width / 2, box.top + box.height / 2]; })()",
    )
}

/// Where a handle of a tool is on the screen.
fn handle_of(page: &mut Page, tool: &str, index: usize) -> [f64; 2] {
    page.value(&format!(
        "(async () => {{ const {{ project }} = await import('./camera.js'); \
         const {{ place }} = organza.{tool}.handles()[{index}]; const {{ camera }} = organza.view; \
         const [x, y] = project(camera, place); \
         const box = document.getElementById('overlay').getBoundingClientRect(); \
         return [box.left + x / camera.w * box.width, box.top + y / camera.h * box.height]; }})()"
    ))
}

/// The displayed image.
fn shown(page: &mut Page) -> RgbImage {
    pixels(&base64(&page.value::<String>(SHOWN)))
}

/// The camera of the displayed image.
fn camera(page: &mut Page) -> Value {
    page.eval("organza.view.camera")
}

/// The output of `render` for these scenes and the camera of the page.
fn rendered(sandbox: &Sandbox, viewer: &Viewer, camera: &Value, scenes: &str) -> RgbImage {
    sandbox.write("shown.json", viewer.post("/cameras.json", &json!([camera])).ok().body);
    sandbox.run(&format!("render {scenes} shown.json -o shown --backend cpu")).assert_ok();
    pixels(&sandbox.read("shown/0000.png"))
}

#[test]
fn a_scene_in_a_browser() {
    let Some(program) = program() else { return };
    let sandbox = Sandbox::new("basic");
    photographs(&sandbox);
    let viewer = Viewer::start(
        &sandbox,
        "view scene.safetensors data/transforms.json --port 0 --backend cpu",
    );
    let mut page = Page::open(program, &viewer.url(), [700, 420]);
    page.wait(REST);
    let before = shown(&mut page);
    let first = camera(&mut page);
    assert!(before == rendered(&sandbox, &viewer, &first, ALONE), "at rest");

    // dragging moves the camera around its target
    let [x, y] = middle(&mut page);
    page.drag([x, y], [x + 60.0, y + 25.0]);
    page.wait(REST);
    let after = shown(&mut page);
    let moved = camera(&mut page);
    assert!(moved["camera_to_world"] != first["camera_to_world"] && after != before);
    assert_eq!(moved["fl_x"], first["fl_x"]);
    assert!(after == rendered(&sandbox, &viewer, &moved, ALONE), "after a drag");
    let far = |page: &mut Page| -> f64 {
        page.value(
            "organza.view.camera.camera_to_world.slice(0, 3).reduce(\
             (sum, row, at) => sum + (row[3] - organza.view.center[at]) ** 2, 0) ** 0.5",
        )
    };
    let farther = far(&mut page);
    page.mouse("mouseWheel", [x, y]);
    page.wait(REST);
    let near = far(&mut page);
    assert!(near < 0.95 * farther, "{near} {farther}");
    let closer = camera(&mut page);
    assert!(shown(&mut page) == rendered(&sandbox, &viewer, &closer, ALONE), "after the wheel");

    assert_explains(&mut page, [x, y], &viewer, &sandbox);
    assert_reads_depth(&mut page, [x, y]);
    assert_keeps_keyframes(&mut page, [x, y], &sandbox);
    let (index, view) = assert_compares(&mut page, &viewer);
    assert!(
        shown(&mut page) == rendered(&sandbox, &viewer, &view, ALONE),
        "a camera of the data set"
    );
    assert_says_far(&mut page, &viewer, index);
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

/// A click explains the pixel.
fn assert_explains(page: &mut Page, at: [f64; 2], viewer: &Viewer, sandbox: &Sandbox) {
    page.click(at);
    page.wait("organza.explain.answer");
    let answer = page.eval("organza.explain.answer");
    let pixel = answer["pixel"].clone();
    sandbox.write("shown.json", viewer.post("/cameras.json", &json!([camera(page)])).ok().body);
    let words =
        format!("explain scene.safetensors shown.json --pixel {},{} --json", pixel[0], pixel[1]);
    let expected = sandbox.run(&words).json();
    assert_eq!(answer["color"], expected["color"]);
    assert_eq!(answer["alpha_sum"], expected["alpha_sum"]);
    let count = expected["gaussians"].as_array().unwrap().len();
    let rows: usize = page.value("document.querySelectorAll('#rows tr').length");
    assert!(count > 0 && rows == count.min(61), "{rows} of {count}");

    let bar = "document.querySelector('#rows .share').getBoundingClientRect()";
    assert_eq!(page.eval(&format!("{bar}.height")), 9);
    page.screenshot("viewer-explain");
}

/// Keys work after a click on a box, and the pointer shows the depth.
fn assert_reads_depth(page: &mut Page, [x, y]: [f64; 2]) {
    page.eval("document.getElementById('show-cameras').focus()");
    page.key("4");
    page.wait(REST);
    page.mouse("mouseMoved", [x + 1.0, y]);
    page.wait("organza.view.depth");
    let depth: f64 = page.value("organza.view.depth");
    let range: [f64; 2] = page.value("organza.view.shown.about.range");
    assert!(range[0] < depth && depth < range[1], "{depth} in {range:?}");
    page.screenshot("viewer-depth");
    page.key("5");
    page.wait(REST);
    let scale: String = page.value("document.getElementById('scale').innerText");
    assert!(scale.contains("red"), "{scale}");
    page.key("1");
    page.wait(REST);
}

/// Keyframes survive saving and loading.
fn assert_keeps_keyframes(page: &mut Page, [x, y]: [f64; 2], sandbox: &Sandbox) {
    page.eval("document.getElementById('add-keyframe').click()");
    page.drag([x, y], [x - 40.0, y]);
    page.key("k");
    let keyframes = page.eval("organza.keyframes.list.map((one) => one.camera)");
    assert_eq!(keyframes.as_array().map(Vec::len), Some(2));
    page.wait("organza.keyframes.path?.length > 1");
    let save = "(async () => { let saved; const make = URL.createObjectURL; URL.createObjectURL = \
        (blob) => { saved = blob; return make(blob); }; await organza.keyframes.save(); \
        URL.createObjectURL = make; return saved.text(); })()";
    let saved: String = page.value(save);
    sandbox.write("keyframes.json", &saved);
    sandbox.run("info keyframes.json").assert_ok();
    page.eval("organza.keyframes.list = []; organza.keyframes.changed()");
    page.eval(&format!("organza.keyframes.load({})", json!(saved)));
    assert_eq!(page.eval("organza.keyframes.list.map((one) => one.camera)"), keyframes);
}

/// Shows a camera of the data set, beside its photograph. Returns its index and the camera.
fn assert_compares(page: &mut Page, viewer: &Viewer) -> (usize, Value) {
    page.eval("document.getElementById('compare').click()");
    page.wait(REST);
    page.wait("document.getElementById('photograph').complete");
    let index: usize = page.value("organza.view.index");
    let view = viewer.scene()["views"][index]["camera"].clone();
    // JavaScript writes 0 where Rust writes 0.0
    assert_eq!(camera(page), page.eval(&format!("({view})")));
    (index, view)
}

/// The page has begun at a photograph. Far from all it says so, and a key goes to the nearest, which is the camera `index`.
fn assert_says_far(page: &mut Page, viewer: &Viewer, index: usize) {
    let scene = viewer.scene();
    let views = scene["views"].as_array().expect("a list");
    assert!(views.iter().any(|view| view["camera"] == scene["home"]), "{scene}");
    assert_eq!(page.eval(FAR), false);
    page.eval(
        "organza.view.leave(); organza.view.camera.camera_to_world = organza.view.camera.camera_to_world \
         .map((row, at) => at < 3 ? [row[0], row[1], row[2], 3 * row[3]] : row); organza.view.moved()",
    );
    page.wait(REST);
    assert_eq!(page.eval(FAR), true);
    // three times as far from the scene's center is 5.7 times as far as 20 degrees
    assert_eq!(page.eval("document.getElementById('image').style.opacity"), "0.333333");
    page.screenshot("viewer-far");
    page.key("n");
    page.wait(&format!("organza.view.index === {index}"));
    page.wait(REST);
    assert_eq!(page.eval(FAR), false);
}

#[test]
fn a_training_in_a_browser() {
    let Some(program) = program() else { return };
    let sandbox = sandbox();
    let words = format!("{TINY} run --view --port 0 --view-share 50 --steps 100000");
    let viewer = Viewer::start(&sandbox, &words);
    let mut page = Page::open(program, &viewer.url(), [390, 760]);
    page.wait("document.querySelectorAll('#charts canvas').length === 2");
    page.wait("organza.view.shown?.about.version > 0");
    let version = page.eval("organza.view.shown.about.version");
    page.wait(&format!("organza.view.shown.about.version > {version}"));
    page.wait("document.getElementById('quality').textContent === 'live'");
    page.wait("organza.training.state.curve.step.length > 200");
    let psnr: Vec<Option<f64>> = page.value("organza.training.state.curve.psnr");
    let mean = |values: &[Option<f64>]| -> f64 {
        values.iter().flatten().sum::<f64>() / values.len() as f64
    };
    let first = mean(&psnr[..10]);
    let last = mean(&psnr[psnr.len() - 10..]);
    assert!(last > first + 1.0, "PSNR rises: {first} {last}");
    page.wait("document.getElementById('progress').textContent.includes('left')");
    page.screenshot("viewer-training");
    page.eval("document.getElementById('pause').click()");
    page.wait("organza.training.state.paused");
    page.wait(REST);
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

/// Handles move a scene that is shown with the first one, and what is saved renders as what was shown.
#[test]
fn a_scene_is_moved_in_a_browser() {
    let Some(program) = program() else { return };
    let sandbox = Sandbox::new("basic");
    sandbox.copy_file("scene.safetensors", "b.safetensors");
    sandbox.write("b.json", r#"{"offset": [0.2, 0, 0.1], "turn": [30, 0, 40], "scale": 0.5}"#);
    let both = "scene.safetensors b.safetensors@b.json";
    let words = format!("view {both} cameras.json --port 0 --backend cpu");
    let viewer = Viewer::start(&sandbox, &words);
    let mut page = Page::open(program, &viewer.url(), [700, 640]);
    page.wait("organza.places.scenes.length === 1");
    let said =
        |page: &mut Page| -> String { page.value("document.getElementById('place-words').value") };
    let place = |page: &mut Page| -> Place {
        page.eval("organza.places.asked");
        serde_json::from_str(&said(page)).expect("a place")
    };
    page.eval("{ const box = document.getElementById('scene'); box.value = 1; box.onchange(); }");
    page.wait(REST);
    let pose = camera(&mut page);
    let first = place(&mut page);
    let ball = "organza.places.scene.center.concat(organza.places.scene.radius)";
    let ball = |page: &mut Page| -> [f64; 4] { page.value(ball) };
    let mut before = first;
    let mut at = ball(&mut page);
    for (handle, by) in [(0, [40.0, 12.0]), (1, [5.0, -30.0]), (2, [50.0, 0.0]), (3, [20.0, 0.0])] {
        let from = handle_of(&mut page, "places", handle);
        page.drag(from, [from[0] + by[0], from[1] + by[1]]);
        let after = place(&mut page);
        let moved = ball(&mut page);
        let off: Vec<_> = moved.iter().zip(at).map(|(to, from)| to - from).collect();
        let is_still = off[..3].iter().all(|x| x.abs() < 1e-3);
        match handle {
            0 => assert!(!is_still && (after.turn, after.scale) == (first.turn, first.scale)),
            1 => assert!(off[2] > 0.01 && off[..2].iter().all(|x| x.abs() < 1e-3), "{off:?}"),
            2 => assert!(is_still && after.turn != before.turn && after.scale == first.scale),
            _ => assert!(is_still && off[3] > 0.01 && after.scale > first.scale, "{off:?}"),
        }
        before = after;
        at = moved;
    }
    assert_eq!(camera(&mut page), pose, "the camera moves with the scene");
    page.wait(REST);
    page.screenshot("viewer-places");
    let moved = shown(&mut page);
    sandbox.write("b.json", said(&mut page));
    assert!(moved == rendered(&sandbox, &viewer, &pose, both), "another place was saved");

    // a turn is composed as in the program
    let up = DVec3::Z;
    let turned: [f64; 3] = page.value(
        "import('./places.js').then(({ followed }) => followed([30, 0, 40], [0, 0, 1], 0.5))",
    );
    let quaternion =
        |turn: [f64; 3]| DQuat::from_scaled_axis(DVec3::from(turn.map(f64::to_radians)));
    let expected = DQuat::from_axis_angle(up, 0.5) * quaternion([30.0, 0.0, 40.0]);
    assert!(quaternion(turned).angle_between(expected) < 1e-6, "{turned:?}");

    // what is written counts, and undo takes it back
    page.eval(
        "{ const words = document.getElementById('place-words'); words.value = '{\"scale\": 0.25}'; words.onchange(); }",
    );
    assert_eq!(place(&mut page), Place { scale: 0.25, ..Place::default() });
    page.wait(REST);
    assert!(shown(&mut page) != moved);
    page.key("z");
    assert_eq!(place(&mut page), before);
    page.wait(REST);
    assert!(shown(&mut page) == moved, "undo");
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

/// A box and a brush remove Gaussians, undo brings them back, and what is saved renders as what was shown.
#[test]
fn a_scene_is_edited_in_a_browser() {
    let Some(program) = program() else { return };
    let sandbox = Sandbox::new("basic");
    let viewer = Viewer::start(&sandbox, &format!("{VIEW} --edit cut.safetensors"));
    let mut page = Page::open(program, &viewer.url(), [700, 640]);
    page.wait(REST);
    page.wait("organza.edit.answer");
    let all = left(&mut page);
    let whole = shown(&mut page);
    let middle = middle(&mut page);

    let inside = crop(&mut page, middle, &sandbox, all);
    assert_eq!(left(&mut page), inside);
    assert!(shown(&mut page) != whole, "nothing has changed");
    undo(&mut page);
    assert!(left(&mut page) == all && shown(&mut page) == whole, "undo");

    assert_cleans(&mut page, (all, &whole));
    assert_knows_the_world(&mut page);

    // the brush
    page.key("g");
    page.drag([middle[0] - 40.0, middle[1]], [middle[0] + 40.0, middle[1]]);
    page.wait("organza.edit.answer.selected > 0");
    page.screenshot("viewer-brush");
    let selected: u64 = page.value("organza.edit.answer.selected");
    page.eval("document.getElementById('remove-selected').click(); organza.edit.asked");
    page.wait(&format!("organza.edit.answer.left === {}", all - selected));
    page.wait(REST);
    let painted = shown(&mut page);

    // measuring puts the brush aside; a known distance gives the saved scene meters
    let distance = measure(&mut page, middle, &viewer);
    page.eval("document.getElementById('meters').value = 0.25; organza.measure.say()");
    page.screenshot("viewer-measure");
    page.eval("document.getElementById('set-meters').click(); organza.edit.asked");
    page.wait("document.getElementById('distance').textContent === '0.2500 m'");
    page.eval("document.getElementById('save-edit').click(); organza.edit.asked");
    page.wait("organza.edit.answer.saved");
    page.screenshot("viewer-saved");
    let camera = camera(&mut page);
    let saved = organza::Scene::load(sandbox.path("cut.safetensors")).unwrap();
    let meters = saved.config.placement.meters.expect("meters");
    assert!((meters * distance / 0.25 - 1.0).abs() < 1e-6, "{meters}");
    sandbox.rename("cut.safetensors", "scene.safetensors");
    assert!(
        painted == rendered(&sandbox, &viewer, &camera, ALONE),
        "what was saved is not what was shown"
    );
    assert!(page.errors.is_empty(), "{:?}", page.errors);
}

/// The number of Gaussians that are left.
fn left(page: &mut Page) -> u64 {
    page.value("organza.edit.answer.left")
}

fn undo(page: &mut Page) {
    page.eval("document.getElementById('undo-edit').click(); organza.edit.asked");
    page.wait(REST);
}

/// Draws the box smaller with its handle, and removes the rest. Returns the number of Gaussians in the box.
fn crop(page: &mut Page, middle: [f64; 2], sandbox: &Sandbox, all: u64) -> u64 {
    page.key("b");
    let high = |page: &mut Page| -> f64 { page.value("organza.edit.box[1][0]") };
    let before = high(page);
    let pose = camera(page);
    let from = handle_of(page, "edit", 1);
    let to = [0, 1].map(|axis| from[axis] + 0.4 * (middle[axis] - from[axis]));
    page.drag(from, to);
    assert!(high(page) != before, "the handle does not move");
    assert_eq!(camera(page), pose, "the camera moves with the box");
    page.screenshot("viewer-box");
    page.eval("document.getElementById('remove-outside').click(); organza.edit.asked");
    page.wait(&format!("organza.edit.answer.left < {all}"));
    page.wait(REST);
    let bounds: [[f32; 3]; 2] = page.value("organza.edit.box");
    let scene = organza::Scene::load(sandbox.path("scene.safetensors")).unwrap();
    let is_inside = |p: &&[f32; 3]| (0..3).all(|i| bounds[0][i] <= p[i] && p[i] <= bounds[1][i]);
    scene.gaussians.position.iter().filter(is_inside).count() as u64
}

/// The slider hides what most photographs see through, and says what that is. Then it goes.
fn assert_cleans(page: &mut Page, (all, whole): (u64, &RgbImage)) {
    let slide = |page: &mut Page, strength: f64| {
        page.eval(&format!(
            "{{ const slider = document.getElementById('clean'); slider.value = {strength}; slider.dispatchEvent(new Event('input')) }}"
        ));
        page.wait("!organza.edit.cleaning");
        page.wait(REST);
    };
    slide(page, 0.5);
    let hidden: u64 = page.value("organza.edit.answer.clean.hidden");
    assert!(hidden > 0 && left(page) == all - hidden && shown(page) != *whole);
    let said: String = page.value("document.getElementById('clean-said').textContent");
    assert!(
        said.starts_with(&format!("{hidden} hidden, ")) && said.ends_with("--clean 0.5"),
        "{said}"
    );
    page.screenshot("viewer-floaters");
    slide(page, 0.0);
    assert!(left(page) == all && shown(page) == *whole, "nothing is hidden");
    slide(page, 0.5);
    page.eval("document.getElementById('keep-clean').click(); organza.edit.asked");
    page.wait(
        "document.getElementById('clean').value === '0' && organza.edit.answer.removals === 1",
    );
    undo(page);
    assert!(left(page) == all && shown(page) == *whole, "undo");
}

/// The page shows world coordinates as the program computes them.
fn assert_knows_the_world(page: &mut Page) {
    let placement = organza::scene::Placement {
        offset: [5e5, -20.0, 3.0],
        scale: 0.25,
        up: [0.6, 0.0, 0.8],
        right: [0.0, 1.0, 0.0],
        meters: None,
    };
    let world: [f64; 3] = page.value(&format!(
        "(async () => {{ const {{ toWorld }} = await import('./camera.js'); \
         return toWorld({}, [1.5, -2.0, 0.5]); }})()",
        serde_json::to_value(placement).unwrap()
    ));
    for (shown, expected) in world.into_iter().zip(placement.world([1.5, -2.0, 0.5])) {
        assert!((shown - expected).abs() < 1e-9, "{shown} {expected}");
    }
}

/// Measures the distance of two clicked places, and returns it as the pixels' depths have it.
fn measure(page: &mut Page, middle: [f64; 2], viewer: &Viewer) -> f64 {
    page.key("m");
    let clicked = [-30.0, 30.0].map(|across| {
        page.click([middle[0] + across, middle[1]]);
        page.wait(if across < 0.0 {
            "organza.measure.places[0]"
        } else {
            "organza.measure.distance"
        });
        page.value::<f64>(&format!(
            "(() => {{ const box = document.getElementById('overlay').getBoundingClientRect(); \
             return organza.view.camera.w * ({} - box.left) / box.width; }})()",
            middle[0] + across
        ))
    });
    let camera = camera(page);
    let ends = clicked.map(|column| {
        let row = camera["h"].as_f64().unwrap() / 2.0;
        let pixel = [column.floor() as i32, row.floor() as i32];
        let answer = viewer.post("/explain", &json!({"camera": camera, "pixel": pixel})).json();
        let depth = answer["gaussians"][0]["depth"].as_f64().expect("a depth");
        let beside = |at: f64, lens: &str, center: &str| {
            (at - camera[center].as_f64().unwrap()) / camera[lens].as_f64().unwrap() * depth
        };
        [beside(column, "fl_x", "cx"), beside(row, "fl_y", "cy"), depth]
    });
    let expected = (0..3).map(|i| (ends[0][i] - ends[1][i]).powi(2)).sum::<f64>().sqrt();
    let distance: f64 = page.value("organza.measure.distance");
    assert!((distance / expected - 1.0).abs() < 1e-6, "{distance} {expected}");
    expected
}
