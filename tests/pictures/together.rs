//! Several scenes in one picture, on every device.

use std::collections::BTreeMap;
use std::fs;

use organza::render::{EyeCache, EyeOptions};
use organza::scene::{Ground, Place, Placement, read_tensors};
use organza::{Camera, Channel, DeviceScene, RenderedTiles, Renderer, Scene, Tile, TileBatch};
use organza_tests::cases::{self, Case};
use organza_tests::compare::{assert_close, bits};

use crate::eye::{EXACT, render_anew, whole};
use crate::snapshots::RENDERERS;

/// Absolute tolerance of the tiles.
const TILES: f64 = 2e-4;

fn basic() -> Case {
    Case::load(&cases::folder().join("basic"))
}

/// The scenes of `cases/together`, which have no [`Placement`].
fn together(renderer: &Renderer) -> DeviceScene {
    let folder = cases::folder().join("together");
    let text = fs::read_to_string(folder.join("scenes.toml")).expect("a list");
    let list: toml::Table = text.parse().expect("TOML");
    let mut scenes = list["scene"].as_array().expect("scenes").iter().map(|listed| {
        let path = folder.join(listed["path"].as_str().expect("a path"));
        let scene = Scene::load(path).expect("a scene");
        let world = Placement::default();
        let place = listed.get("place").map(|place| place.clone().try_into().expect("a place"));
        let place: Place = place.unwrap_or_default();
        (renderer.upload(&scene).expect("memory"), world.place(&world, &place).expect("a place"))
    });
    let (mut all, _) = scenes.next().expect("a scene");
    scenes.for_each(|(scene, place)| all.put(scene, place).expect("memory"));
    all
}

#[test]
fn scenes_together_match_the_reference() {
    let case = basic();
    let expected = read_tensors(cases::folder().join("together/tiles.safetensors"));
    let expected = &expected.expect("tensors")["tiles"].data;
    for (device, renderer) in RENDERERS.iter() {
        let scene = together(renderer);
        let tiles = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
        assert_close(&format!("scenes together on {device}"), &tiles.data, expected, TILES);
        assert!(renderer.record(&scene, &case.cameras, &case.tiles).is_err(), "a gradient");
        assert!(renderer.inspect(&scene, &case.cameras, 0, [40, 40]).is_err(), "a pixel");

        // the viewer's images have the same bits, also after the eye has moved
        let camera = &case.cameras[0];
        let batch = whole(camera);
        let mut cache = EyeCache::default();
        let mut seen = |camera, steps| {
            let options = EyeOptions { steps, ..EXACT };
            let tiles = renderer.render_from_eye(&scene, camera, &batch, &mut cache, &options);
            tiles.expect("an image").expect("it was not cancelled")
        };
        seen(&case.cameras[1], 1);
        seen(camera, 3);
        let found = seen(camera, 1);
        let expected = renderer
            .render_channels(&scene, &case.cameras, &batch, &Channel::ALL, &mut |_, _| {})
            .expect("an image");
        assert!(bits(&found.data) == bits(&expected.data), "{device}");
        for (channel, values) in &expected.channels {
            assert!(bits(&found.channels[channel]) == bits(values), "{device}: {channel:?}");
        }
    }
}

/// Light passes through a scene that no ray meets.
#[test]
fn a_scene_far_away_changes_no_bit() {
    let case = basic();
    for (device, renderer) in RENDERERS.iter() {
        let mut scene = renderer.upload(&case.scene).expect("memory");
        let alone = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
        let far = Placement { offset: [0.0, 0.0, 1e4], ..Placement::default() };
        let other = renderer.upload(&case.scene).expect("memory");
        scene.put(other.clone(), far).expect("memory");
        let with = renderer.render(&scene, &case.cameras, &case.tiles).expect("it renders");
        assert!(bits(&with.data) == bits(&alone.data), "{device}");
        let too_far = Placement { offset: [1e300, 0.0, 0.0], ..Placement::default() };
        assert!(scene.put(other.clone(), too_far).is_err(), "coordinates overflow");
        let mut standing = renderer.upload(&case.scene).expect("memory");
        let sides = [[None; 2]; 2];
        standing.stand_on(Ground { placement: far, sides, border: 1.0, motions: BTreeMap::new() });
        assert!(standing.put(other, far).is_err(), "only one stands on a ground");
    }
}

/// Beside a scene that is clear as air, another one looks as if it were alone, but for the place and its units.
#[test]
fn a_scene_in_clear_air_keeps_its_channels() {
    let case = basic();
    let mut air = case.scene.clone();
    air.gaussians.opacity.fill(-200.0);
    air.transmittance.network.layers.last_mut().expect("a layer").bias[0] = 200.0;
    // a third of a turn around (1, 1, 1): x is y, y is z, z is x
    let put = Place {
        offset: [0.3, 0.2, -0.4],
        turn: [120.0 / 3_f64.sqrt(); 3],
        scale: 1.7,
        ..Place::default()
    };
    let place = Placement::default().place(&Placement::default(), &put).expect("a place");
    for (device, renderer) in RENDERERS.iter() {
        let [mut all, alone] =
            [&air, &case.scene].map(|scene| renderer.upload(scene).expect("memory"));
        all.put(alone.clone(), place).expect("memory");
        let camera = &case.cameras[0];
        let together = render_anew(renderer, &all, camera, &EXACT);
        let apart = render_anew(renderer, &alone, &place.own_camera(camera), &EXACT);
        assert_close(&format!("a scene in air on {device}"), &together.data, &apart.data, 1e-5);
        for channel in Channel::ALL {
            let found = &together.channels[&channel];
            let mut expected = apart.channels[&channel].clone();
            match channel {
                Channel::Depth => expected.iter_mut().for_each(|depth| *depth *= 1.7),
                Channel::Normal => {
                    expected.chunks_mut(3 * 16 * 16).for_each(|tile| tile.rotate_right(16 * 16))
                }
                Channel::Alpha | Channel::Visibility => {}
            }
            let pairs = found.iter().zip(&expected);
            let far_off =
                pairs.filter(|(found, expected)| (*found - *expected).abs() > 1e-3).count();
            // where a Gaussian ends, rounding decides
            assert!(far_off * 1000 < found.len(), "{device}, {channel:?}: {far_off}");
        }
    }
}

/// The mean of two standing scenes, from the image and the depth of each alone. The side of their grounds is the plane x = 0.3.
fn mean_of(alone: &[RenderedTiles; 2], camera: &Camera, tiles: &[Tile]) -> (Vec<f32>, Vec<f32>) {
    let mut color = vec![0.0; alone[0].data.len()];
    let mut depth = vec![0.0; color.len() / 3];
    let [side, area] = [16, 16 * 16];
    for (pixel, mean) in depth.iter_mut().enumerate() {
        let [tile, at] = [pixel / area, pixel % area];
        let [column, row] = [at % side, at / side];
        let place = [column, row].map(|at| at as f64 + 0.5);
        let ray = camera.ray([0, 1].map(|axis| f64::from(tiles[tile].origin[axis]) + place[axis]));
        let depths = [0, 1].map(|index| alone[index].channels[&Channel::Depth][pixel]);
        let weight = |index: usize| {
            let inside = |x: f64| if index == 0 { 0.3 - x } else { x - 0.3 };
            // far along the ray, or where it begins, it is over the ground and half of the ramp
            let is_met = [1e9, 0.0].iter().any(|t| inside(camera.eye()[0] + t * ray.x) > -0.2);
            let x = camera.eye()[0] + f64::from(depths[index]) * ray.x;
            match (is_met, depths[index] > 0.0) {
                (false, _) => 0.0,
                (true, false) => 1e-9,
                (true, true) => (0.5 + inside(x) / 0.4).clamp(1e-6, 1.0),
            }
        };
        let weights = [0, 1].map(weight);
        let part = [0, 1].map(|index| weights[index] / (weights[0] + weights[1]));
        let of = |values: [f32; 2]| (0..2).map(|i| part[i] * f64::from(values[i])).sum::<f64>();
        *mean = of(depths) as f32;
        for channel in 0..3 {
            let at = (3 * tile + channel) * area + at;
            color[at] = of([0, 1].map(|index| alone[index].data[at])) as f32;
        }
    }
    (color, depth)
}

/// Each scene counts where it shows its ground, and is rendered only in tiles from which a ray comes there.
#[test]
fn scenes_on_grounds_are_a_mean_of_their_images() {
    let case = basic();
    let mut right = case.scene.clone();
    right.config.placement = Placement { offset: [0.6, 0.0, 0.0], ..Placement::default() };
    let put = Place { same_world: true, ..Place::default() };
    let place = Placement::default().place(&right.config.placement, &put).expect("a place");
    let placement = Placement::default();
    let ground = |sides| Ground { placement, sides, border: 0.4, motions: BTreeMap::new() };
    let [left_ground, right_ground] =
        [[[None; 2], [Some(0.3), None]], [[Some(0.3), None], [None; 2]]].map(ground);
    let look = |eye, target| {
        Camera::look_at(eye, target, [0.0, 0.0, 1.0], 1.0, [96, 80]).expect("a camera")
    };
    // from before the side, along it, and away from it
    let cameras = [
        look([0.2, -3.0, 0.6], [0.3, 0.0, 0.0]),
        look([0.0, -3.0, 0.3], [0.0, 0.0, 0.3]),
        look([0.0, -2.0, 0.3], [-1.4, 0.0, 0.0]),
    ];
    for (device, renderer) in RENDERERS.iter() {
        let alone = [&case.scene, &right].map(|scene| renderer.upload(scene).expect("memory"));
        let [mut all, mut other] = alone.clone();
        all.stand_on(left_ground.clone());
        other.stand_on(right_ground.clone());
        all.put(other, place).expect("memory");
        let mut cache = EyeCache::default();
        for (index, camera) in cameras.iter().enumerate() {
            let batch = whole(camera);
            let render = |scene: &DeviceScene, camera: &Camera, batch: &TileBatch| {
                let cameras = std::slice::from_ref(camera);
                renderer
                    .render_channels(scene, cameras, batch, &Channel::ALL, &mut |_, _| {})
                    .expect("it renders")
            };
            let found = render(&all, camera, &batch);
            let own = [camera.clone(), place.own_camera(camera)];
            let images = [0, 1].map(|at| render(&alone[at], &own[at], &batch));
            let (color, depth) = mean_of(&images, camera, &batch.tiles);
            let what = format!("camera {index} on {device}");
            assert_close(&what, &found.data, &color, 1e-5);
            assert_close(&what, &found.channels[&Channel::Depth], &depth, 1e-4);
            // columns of tiles in which no ray goes to the right
            let first = [0, 48, 96][index];
            let right = batch.tiles.iter().filter(|tile| tile.origin[0] >= first);
            let right = TileBatch { side: 16, tiles: right.copied().collect() };
            let mut expected = images[0].report;
            if !right.tiles.is_empty() {
                expected.add(&render(&alone[1], &own[1], &right).report);
            }
            assert_eq!(found.report, expected, "{what}");
            let seen = renderer.render_from_eye(&all, camera, &batch, &mut cache, &EXACT);
            let seen = seen.expect("an image").expect("it was not cancelled");
            assert!(bits(&seen.data) == bits(&found.data), "{what}");
        }
    }
}
