//! Cases of the float64 reference: `tests/cases`, and a folder of further cases in the environment variable
//! `ORGANZA_CASES`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use organza::scene::{Tensor, read_tensors};
use organza::{Camera, DeviceScene, Renderer, Scene, TileBatch, demo};

use crate::devices;

/// A case of the reference.
#[derive(Debug)]
pub struct Case {
    /// Name of its folder.
    pub name: String,
    /// The scene.
    pub scene: Scene,
    /// The cameras.
    pub cameras: Vec<Camera>,
    /// The batch of tiles.
    pub tiles: TileBatch,
    /// Tensors of the reference, by name.
    pub expected: BTreeMap<String, Tensor>,
}

impl Case {
    /// Loads the case in a folder.
    pub fn load(folder: &Path) -> Self {
        let file = |name: &str| folder.join(name);
        Self {
            name: folder.file_name().expect("a folder has a name").to_string_lossy().into_owned(),
            scene: Scene::load(file("scene.safetensors")).expect("a scene"),
            cameras: Camera::load_all(file("cameras.json")).expect("cameras"),
            tiles: TileBatch::load(file("tiles.json")).expect("tiles"),
            expected: read_tensors(file("expected.safetensors")).expect("expected tensors"),
        }
    }

    /// A tensor of the reference.
    pub fn expected(&self, name: &str) -> &[f32] {
        &self.expected.get(name).unwrap_or_else(|| panic!("{}: no tensor `{name}`", self.name)).data
    }
}

/// The folder of the cases in the repository.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cases")
}

/// Every case, by name.
pub fn all() -> Vec<Case> {
    let mut folders = subfolders(&folder());
    assert!(!folders.is_empty(), "no cases in {}", folder().display());
    if let Some(more) = std::env::var_os("ORGANZA_CASES") {
        folders.extend(subfolders(Path::new(&more)));
    }
    folders.iter().map(|folder| Case::load(folder)).collect()
}

/// Checks every case on every device, with its scene uploaded. The device's name is for messages.
pub fn on_every_device(check: impl Fn(&str, &Renderer, &Case, &DeviceScene)) {
    for (backend, device) in devices::all() {
        let renderer = Renderer::new(device);
        for case in all() {
            let scene = renderer.upload(&case.scene).expect("the scene fits");
            check(backend, &renderer, &case, &scene);
        }
    }
}

/// Every nth Gaussian of the built-in scene, with log scales increased by `wider` so that they cover it.
pub fn thinned(nth: usize, wider: f32) -> Scene {
    let mut scene = demo::scene();
    let some: Vec<_> = (0..scene.gaussians.len()).step_by(nth).collect();
    scene.gaussians = scene.gaussians.select(&some);
    scene.gaussians.log_scale.as_flattened_mut().iter_mut().for_each(|scale| *scale += wider);
    scene
}

/// The folders of cases in a folder.
pub fn subfolders(folder: &Path) -> Vec<PathBuf> {
    let entries =
        std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut folders: Vec<_> = entries
        .map(|entry| entry.expect("a folder's entry").path())
        .filter(|path| path.join("expected.safetensors").exists())
        .collect();
    folders.sort();
    folders
}
