//! What is shown at the moment.

use organza_render::{DeviceScene, Renderer};

/// The current scene.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// The renderer of the scene.
    pub renderer: &'a Renderer,
    /// The scene.
    pub scene: &'a DeviceScene,
    /// Changes with the scene: the number of training steps.
    pub version: u64,
    /// Of a split: how many blocks are shown, how many could not be read, and all. Others follow.
    pub blocks: Option<[usize; 3]>,
}
