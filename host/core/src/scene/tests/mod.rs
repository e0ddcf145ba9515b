//! Scenes as files: the shared cases and round trips.

mod bad;

use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use super::*;
use crate::error::Error;

fn case_path(case: &str) -> PathBuf {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases");
    cases.join(case).join("scene.safetensors")
}

fn tiny_bytes() -> Vec<u8> {
    std::fs::read(case_path("tiny")).unwrap()
}

fn tiny() -> Scene {
    Scene::load(case_path("tiny")).unwrap()
}

/// The tiny case with an edited header and the same data.
fn with_header(edit: impl FnOnce(&mut Map<String, Value>)) -> Vec<u8> {
    let bytes = tiny_bytes();
    let length = u64::from_le_bytes(bytes[..8].try_into().unwrap()) as usize;
    let mut header = serde_json::from_slice(&bytes[8..8 + length]).unwrap();
    edit(&mut header);
    let header = serde_json::to_vec(&header).unwrap();
    [&(header.len() as u64).to_le_bytes(), header.as_slice(), &bytes[8 + length..]].concat()
}

/// The tiny case with an edited configuration.
fn with_config(edit: impl FnOnce(&mut Value)) -> Vec<u8> {
    with_header(|header| {
        let text = &mut header["__metadata__"]["config"];
        let mut config = serde_json::from_str(text.as_str().unwrap()).unwrap();
        edit(&mut config);
        *text = Value::from(config.to_string());
    })
}

fn load(bytes: &[u8]) -> Result<Scene> {
    Scene::from_bytes(bytes, "scene.safetensors")
}

#[test]
fn cases_load() {
    for (case, gaussians, entries) in [
        ("antialiased", 48, 3584),
        ("basic", 48, 10752),
        ("contracted", 48, 5632),
        ("crowded", 120, 10752),
        ("narrow", 48, 3072),
        ("occupied", 48, 3584),
        ("shaped", 48, 2560),
        ("sloped", 48, 2560),
        ("tiny", 1, 512),
        ("wide", 160, 14848),
    ] {
        let scene = Scene::load(case_path(case)).unwrap();
        assert_eq!(
            (scene.gaussians.len(), scene.config.color_grid.entries()),
            (gaussians, entries)
        );
        assert_eq!(scene.warnings(), Vec::<String>::new(), "{case}");
        assert_eq!(Scene::unused_tensors(case_path(case)).unwrap(), Vec::<String>::new());
    }
}

/// As the crate `safetensors` reads them.
#[test]
fn values_are_in_their_places() {
    let scene = Scene::load(case_path("basic")).unwrap();
    let bytes = std::fs::read(case_path("basic")).unwrap();
    let file = safetensors::SafeTensors::deserialize(&bytes).unwrap();
    for (spec, data) in scene.tensors() {
        let expected = file.tensor(&spec.name).unwrap();
        let bytes: &[u8] = bytemuck::cast_slice(data);
        assert_eq!(bytes, expected.data(), "{spec:?}");
    }
}

#[test]
fn round_trip_is_exact_and_repeatable() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.safetensors");
    for case in ["basic", "narrow", "tiny"] {
        let scene = Scene::load(case_path(case)).unwrap();
        scene.save(&path).unwrap();
        assert_eq!(Scene::load(&path).unwrap(), scene);
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(scene.to_bytes().unwrap(), bytes);
        assert_eq!(load(&bytes).unwrap(), scene);
        // Other programs must be able to read the file as safetensors, too.
        let file = safetensors::SafeTensors::deserialize(&bytes).unwrap();
        assert_eq!(file.len(), scene.tensors().len());
    }
}

#[test]
fn tensors_are_as_the_configuration_says() {
    let mut scene = Scene::load(case_path("basic")).unwrap();
    let specs = scene.config.tensors(scene.gaussians.len());
    let found = |(spec, data): (TensorSpec, &[f32])| (spec, data.len());
    let found: Vec<_> = scene.tensors().into_iter().map(found).collect();
    let found_mut = |(spec, data): (TensorSpec, &mut [f32])| (spec, data.len());
    let found_mut: Vec<_> = scene.tensors_mut().into_iter().map(found_mut).collect();
    let expected: Vec<_> = specs.into_iter().map(|spec| (spec.clone(), spec.values())).collect();
    assert_eq!((&found, &found_mut), (&expected, &expected));
}

#[test]
fn empty_vectors_may_be_absent_or_present() {
    let config = SceneConfig { material: 0, extra: 0, ..tiny().config };
    let mut scene = Scene::zeros(config, 2).unwrap();
    scene.gaussians.rotation.fill([1.0, 0.0, 0.0, 0.0]);
    let bytes = scene.to_bytes().unwrap();
    assert_eq!(load(&bytes).unwrap(), scene);
    let mut tensors = scene.tensors();
    let all = tensors.len();
    let config = serde_json::to_string(&scene.config).unwrap();
    tensors.retain(|(spec, _)| spec.values() > 0);
    assert_eq!(tensors.len(), all - 2);
    let bytes = tensors_to_bytes(&tensors, &scene_metadata(&config)).unwrap();
    assert_eq!(load(&bytes).unwrap(), scene);
}

#[test]
fn unknown_tensors_are_ignored_and_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.safetensors");
    let mut bytes = with_header(|header| {
        let end =
            header.values().filter_map(|info| info["data_offsets"][1].as_u64()).max().unwrap();
        let info = json!({"dtype": "I64", "shape": [1], "data_offsets": [end, end + 8]});
        header.insert("adam.step".to_owned(), info);
    });
    bytes.extend([7; 8]);
    std::fs::write(&path, bytes).unwrap();
    assert_eq!(Scene::load(&path).unwrap(), tiny());
    assert_eq!(Scene::unused_tensors(&path).unwrap(), ["adam.step"]);
}

#[test]
fn suspicious_scenes_are_warned_about() {
    let mut scene = tiny();
    scene.gaussians.position[0][0] = 1.6;
    scene.gaussians.rotation[0] = [0.0; 4];
    scene.gaussians.log_scale[0][2] = 2.0;
    scene.config.transmittance_grid.base_resolution = 9000.0;
    scene.config.blur = 0.0;
    let warnings = scene.warnings();
    let facts = ["1 of 1 Gaussians have their center", "zero", "scale larger", "9000", "blur is 0"];
    assert_eq!(warnings.len(), facts.len());
    for (warning, fact) in warnings.iter().zip(facts) {
        assert!(warning.contains(fact), "{warning}");
    }
    // one outside of many is usual after training
    let mut many = scene.clone();
    many.gaussians = many.gaussians.select(&[0; 20]);
    many.gaussians.position[1..].fill([0.0; 3]);
    assert!(!many.warnings().iter().any(|warning| warning.contains("have their center")));
    // 1.6 away from a box of 3 x 2.4 x 2.4, a scale of 7.4 is still too large
    scene.config.contraction = Contraction::Cube;
    let outside = |scene: &Scene| {
        let about = |fact: &str| scene.warnings().iter().any(|warning| warning.contains(fact));
        [about("have their center"), about("scale larger")]
    };
    assert_eq!(outside(&scene), [false, true]);
    scene.gaussians.position[0][0] = 8.0;
    assert_eq!(outside(&scene), [false, false]);
}

#[test]
fn batches_round_trip() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("batch.safetensors");
    let data: Vec<f32> = (0..24).map(|value| value as f32 * 0.5).collect();
    let spec = |name: &str, shape: &[usize]| TensorSpec {
        name: name.to_owned(),
        shape: shape.to_vec(),
        why: "",
    };
    let tiles = || (spec("tiles", &[2, 3, 2, 2]), &data[..]);
    write_tensors(&path, &[tiles()], &[("side", "2")]).unwrap();
    let tensors = read_tensors(&path).unwrap();
    assert_eq!(tensors["tiles"], Tensor { shape: vec![2, 3, 2, 2], data: data.clone() });
    for bad in [spec("tiles", &[5]), spec("", &[2, 3, 2, 2])] {
        let result = write_tensors(&path, &[(bad, &data[..])], &[]);
        assert!(matches!(result, Err(Error::Argument { .. })), "{result:?}");
    }
    let twice = write_tensors(&path, &[tiles(), tiles()], &[]).unwrap_err().to_string();
    assert!(twice.contains("`tiles`") && twice.contains("twice"), "{twice}");
    assert_eq!(read_tensors(&path).unwrap().len(), 1);
}

#[test]
fn large_and_faint_gaussians_far_away_do_not_count() {
    let mut position: Vec<_> = (0..200).map(|at| [at as f32 / 199.0, -1.0, 0.5]).collect();
    let mut log_scale = vec![[0.01_f32.ln(), -9.0, -9.0]; 200];
    let mut opacity = vec![2.0; 200];
    let near = bounds(&position, &log_scale, &opacity);
    let expected = [[-0.03, -1.03, 0.47], [1.03, -0.97, 0.53]];
    for (found, expected) in near.as_flattened().iter().zip(expected.as_flattened()) {
        assert!((found - expected).abs() < 0.02, "{near:?}");
    }
    // a tenth of all, of opacity 0.005
    for at in 0..20 {
        position.push([at as f32 * 5.0 - 50.0, 36.0, -25.0]);
        log_scale.push([3.0; 3]);
        opacity.push(-5.3);
    }
    let found = bounds(&position, &log_scale, &opacity);
    let apart = found.as_flattened().iter().zip(near.as_flattened()).map(|(a, b)| (a - b).abs());
    assert!(apart.fold(0.0, f64::max) < 0.01, "{found:?}, not {near:?}");
}

#[test]
fn one_gaussian_has_the_box_of_its_size() {
    let [low, high] = bounds(&[[1.0, 2.0, 3.0]], &[[0.0, -1.0, -2.0]], &[-1.0]);
    assert_eq!((low, high), ([-2.0, -1.0, 0.0], [4.0, 5.0, 6.0]));
}
