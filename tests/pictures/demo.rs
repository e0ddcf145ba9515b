//! The built-in scene: the places that are lit, hidden and dimmed.

use glam::Vec3;
use organza::demo::{BACKGROUND, PEARL, key_light, scene, turntable};
use organza::{Renderer, Scene, Stages, TileBatch};
use organza_tests::devices;

/// The scene, made once, with all its stages in the first camera.
fn rendered() -> &'static (Scene, Stages) {
    static RENDERED: std::sync::OnceLock<(Scene, Stages)> = std::sync::OnceLock::new();
    RENDERED.get_or_init(|| {
        let scene = scene();
        let renderer = Renderer::new(devices::cpu(None));
        let device = renderer.upload(&scene).expect("a valid scene");
        let stages = renderer.stages(&device, &turntable(1, 64)[0]).expect("stages");
        (scene, stages)
    })
}

/// Indices of the Gaussians whose material sets a flag.
fn flagged(scene: &Scene, flag: usize) -> impl Iterator<Item = usize> + '_ {
    let materials =
        scene.gaussians.material.chunks_exact(scene.config.material as usize).enumerate();
    materials.filter(move |(_, material)| material[flag] == 1.0).map(|(index, _)| index)
}

/// The cosine of the angle between a Gaussian's normal and the direction to the first camera, and that direction.
fn facing(scene: &Scene, index: usize) -> (f32, Vec3) {
    let eye = Vec3::from_array(turntable(1, 64)[0].eye().map(|x| x as f32));
    let to_eye = (eye - Vec3::from_array(scene.gaussians.position[index])).normalize();
    let material = &scene.gaussians.material[index * scene.config.material as usize..];
    (Vec3::new(material[3], material[4], material[5]).dot(to_eye), to_eye)
}

#[test]
fn scene_is_valid_and_leaves_nothing_to_warn_of() {
    let (scene, _) = rendered();
    scene.validate().expect("a valid scene");
    assert_eq!(scene.warnings(), Vec::<String>::new());
    assert!((15_000..36_000).contains(&scene.gaussians.len()), "{}", scene.gaussians.len());
}

#[test]
fn scene_is_the_same_every_time() {
    assert!(scene() == rendered().0, "two calls differ");
}

#[test]
fn pearl_hides_its_back() {
    let (scene, stages) = rendered();
    let behind = flagged(scene, 7).filter(|&index| facing(scene, index).0 < -0.15);
    let behind: Vec<f32> = behind.map(|index| stages.transmittance[index]).collect();
    let most = behind.iter().copied().fold(0.0, f32::max);
    assert!(behind.len() > 2000 && most < 0.02, "{most} of {}", behind.len());
}

/// A Gaussian on the front of the pearl is unobstructed if no cloth is near the line to the camera.
#[test]
fn nothing_dims_what_is_not_obstructed() {
    let (scene, stages) = rendered();
    let position = |index: usize| Vec3::from_array(scene.gaussians.position[index]);
    let cloth: Vec<Vec3> = flagged(scene, 6).map(position).collect();
    let mut free = 0;
    for index in flagged(scene, 7).step_by(8) {
        let (facing, to_eye) = facing(scene, index);
        let near = |point: &Vec3| {
            let offset = *point - position(index);
            let along = offset.dot(to_eye);
            along > 0.0 && (offset - to_eye * along).length() < 0.06
        };
        if facing > 0.05 && !cloth.iter().any(near) {
            assert!(stages.transmittance[index] > 0.9, "{}", stages.transmittance[index]);
            free += 1;
        }
    }
    assert!(free > 100, "{free} are free");
}

#[test]
fn pearl_hides_the_cloth_behind_it() {
    let (scene, stages) = rendered();
    let mut hidden = 0;
    for index in flagged(scene, 6) {
        let position = Vec3::from_array(scene.gaussians.position[index]);
        let (_, to_eye) = facing(scene, index);
        let along = -position.dot(to_eye);
        let nearest = (position + to_eye * along).length();
        if along > 0.0 && nearest < 0.97 * PEARL {
            assert!(stages.transmittance[index] < 0.02, "{}", stages.transmittance[index]);
            hidden += 1;
        }
    }
    assert!(hidden > 500, "{hidden} hidden");
}

#[test]
fn one_layer_of_cloth_dims_by_about_its_coverage() {
    let (scene, stages) = rendered();
    // the lower front of the pearl is behind the blue sheet, or behind both
    let dimmed = flagged(scene, 7)
        .filter(|&index| facing(scene, index).0 > 0.3)
        .map(|index| stages.transmittance[index])
        .filter(|transmittance| *transmittance < 0.8);
    let dimmed: Vec<f32> = dimmed.collect();
    let mean = dimmed.iter().sum::<f32>() / dimmed.len() as f32;
    assert!(dimmed.len() > 200 && (0.25..0.7).contains(&mean), "{} of {mean}", dimmed.len());
}

#[test]
fn every_color_is_one() {
    let (_, stages) = rendered();
    assert!(stages.color.iter().all(|channel| (0.0..=1.0).contains(channel)));
    assert!(stages.radius.iter().all(|radius| radius.is_finite()));
}

/// The network's highlight must be exactly where Blinn and Phong put it.
#[test]
fn pearl_gleams_where_the_half_vector_says() {
    let (scene, stages) = rendered();
    for index in flagged(scene, 7) {
        let (facing, to_eye) = facing(scene, index);
        let material = &scene.gaussians.material[index * scene.config.material as usize..];
        let normal = Vec3::new(material[3], material[4], material[5]);
        let angle = normal.angle_between(key_light() + to_eye);
        let green = stages.color[index * 3 + 1];
        let baked = 1.0 / (1.0 + (-material[1]).exp());
        if angle < 0.05 {
            assert!(green > 0.985, "{green} at {angle}");
        } else if angle > 0.9 && facing > 0.8 {
            assert!(green < baked + 0.05, "{green} of {baked} at {angle}");
        }
    }
}

#[test]
fn turntable_goes_around_once() {
    let cameras = turntable(24, 384);
    assert_eq!(cameras.len(), 24);
    for (frame, camera) in cameras.iter().enumerate() {
        camera.validate(frame).expect("a valid camera");
        let eye = camera.eye();
        assert!(
            (eye[0].hypot(eye[1]) - cameras[0].eye()[0].hypot(cameras[0].eye()[1])).abs() < 1e-9
        );
        assert_eq!((camera.width, camera.height), (384, 384));
    }
    assert_ne!(cameras[0], cameras[12]);
    assert!(turntable(0, 384).is_empty());
    assert_eq!(turntable(1, 64)[0].eye(), cameras[0].eye());
}

/// The corners show paper and the center the pearl, and no pixel is out of range.
#[test]
fn picture_is_framed() {
    let (scene, _) = rendered();
    let renderer = Renderer::new(devices::cpu(None));
    let device = renderer.upload(scene).expect("a valid scene");
    let batch = TileBatch::cover(0, 64, 64, 64).expect("one tile");
    let tiles = renderer.render(&device, &turntable(1, 64), &batch).expect("a picture");
    let pixel = |x: usize, y: usize| [0, 1, 2].map(|c| tiles.data[(c * 64 + y) * 64 + x]);
    for (x, y) in [(0, 0), (63, 0), (63, 63)] {
        let [r, g, b] = pixel(x, y).map(f64::from);
        let [br, bg, bb] = BACKGROUND;
        assert!((r - br).abs() + (g - bg).abs() + (b - bb).abs() < 0.02, "{:?}", pixel(x, y));
    }
    let [r, g, b] = pixel(28, 24);
    assert!(r > 0.8 && r > g && g > b, "{:?}", pixel(28, 24));
    assert!(tiles.data.iter().all(|value| (0.0..=1.0).contains(value)));
}
