//! The blocks of a split come in behind the images: the first one is there before, and the others follow, the nearest to the camera first.

use std::thread::{self, JoinHandle};
use std::time::Duration;

use organza::view::Stage;
use organza::{Camera, DeviceScene, Renderer, Result, Scene, UploadOptions, error};

use crate::cli::console::Console;
use crate::cli::inputs::{SceneSource, Shown};

/// What is shown, and what will be.
pub struct Blocks<'a> {
    shown: &'a Shown,
    options: UploadOptions,
    renderer: &'a Renderer,
    console: Console,
    /// What is shown now.
    scene: DeviceScene,
    version: u64,
    /// Numbers and scenes of the blocks that are there. What is kept of an eye has their order, so a new one comes last; in the end, they
    /// have the order of `organza render`, whose sums are these to the bit.
    there: Vec<(usize, DeviceScene)>,
    /// Those that nobody has read yet.
    left: Vec<usize>,
    reading: Option<(usize, JoinHandle<Result<Scene>>)>,
    failed: usize,
}

impl<'a> Blocks<'a> {
    /// The first block is there, or all scenes that are no blocks.
    pub fn new(
        shown: &'a Shown,
        scene: DeviceScene,
        options: UploadOptions,
        renderer: &'a Renderer,
        console: Console,
    ) -> Self {
        let left = if shown.is_blended() { (1..shown.sources().count()).collect() } else { vec![] };
        let there = vec![(0, scene.clone())];
        Self {
            shown,
            options,
            renderer,
            console,
            scene,
            version: 0,
            there,
            left,
            reading: None,
            failed: 0,
        }
    }

    /// What to show now.
    pub fn stage(&self) -> Stage<'_> {
        let Self { renderer, scene, version, .. } = self;
        let counts = || [self.there.len(), self.failed, self.shown.sources().count()];
        let blocks = self.shown.is_blended().then(counts);
        Stage { renderer, scene, version: *version, blocks }
    }

    /// How long to wait for a request.
    pub fn patience(&self) -> Duration {
        Duration::from_millis(if self.reading.is_some() { 20 } else { 1000 })
    }

    /// Shows a block that has been read, and begins with the next one.
    pub fn go_on(&mut self, camera: &Camera) -> Result<()> {
        if let Some((index, reading)) = self.reading.take_if(|(_, reading)| reading.is_finished()) {
            let read = reading.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            self.take(index, read)?;
        }
        if self.reading.is_none()
            && let Some(at) = self.nearest(camera)
        {
            let index = self.left.swap_remove(at);
            let file = self.source(index).file().to_owned();
            self.reading = Some((index, thread::spawn(move || Scene::load(file))));
        }
        Ok(())
    }

    fn source(&self, index: usize) -> &SceneSource {
        self.shown.sources().nth(index).expect("a block")
    }

    /// The position in `left` of the block whose ground is nearest to the camera.
    fn nearest(&self, camera: &Camera) -> Option<usize> {
        let eye = self.scene.config().placement.world(camera.eye());
        let inside =
            |index: usize| self.source(index).ground().map_or(0.0, |ground| ground.inside(eye));
        let insides = self.left.iter().map(|&index| inside(index)).enumerate();
        insides.max_by(|(_, a), (_, b)| a.total_cmp(b)).map(|(at, _)| at)
    }

    /// Shows a block, or says why it is not shown. The others are shown all the same.
    fn take(&mut self, index: usize, read: Result<Scene>) -> Result<()> {
        let upload = |scene| self.shown.upload_one(index, &scene, self.options, self.renderer);
        let name = self.source(index).named().display().to_string();
        match read.and_then(upload) {
            Ok(scene) => {
                self.there.push((index, scene));
                let [there, all] = [self.there.len(), self.shown.sources().count()];
                self.console.note(&format!("{name} is shown, {there} of {all} blocks"));
            }
            Err(error) => {
                self.failed += 1;
                self.console.warn(&format!("{name} is not shown: {}", error::chain(&error)));
            }
        }
        if self.left.is_empty() {
            self.there.sort_by_key(|(index, _)| *index);
            self.version += 1;
        }
        self.scene = self.shown.join(self.there.clone())?;
        Ok(())
    }
}
