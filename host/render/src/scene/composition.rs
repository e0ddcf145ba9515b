//! Scenes that are shown together. Each keeps its coordinates, its box and its fields.
//!
//! The first scene has the others in `beside`. A scene's `fields` are the other scenes' transmittance fields with its own Gaussians, whose
//! positions are in the other scene's coordinates: T of a Gaussian is the product of T over its own field and these.

use std::sync::Arc;

use super::device_scene::DeviceScene;
use muslin_device::Buffer;
use organza_core::error::argument;
use organza_core::scene::{Ground, Placement};
use organza_core::{Camera, Result};

/// Label of the buffers of cameras.
pub const CAMERAS: &str = "cameras";
/// The largest coordinate whose square is finite in f32.
const FARTHEST: f32 = 1e15;

impl DeviceScene {
    /// Shows another scene with this one, at a place in this one's coordinates: see [`Placement::place`].
    ///
    /// A pixel is one sum over the Gaussians of all scenes (Eq. 12), before this scene's background. The weight of a Gaussian has
    /// T of its own scene and, with a zero vector for u, of every other one: along the part of its ray in that scene's box (Eq.
    /// 11). Such scenes have no gradients. Scenes that [stand on a ground](Self::stand_on) are no such sum.
    ///
    /// # Errors
    /// [`Error::Argument`](organza_core::Error::Argument) for a scene of another device, one that has others already, one with a ground beside one
    /// without, or a place that is too far for f32; the same errors as [`Device::upload`](muslin_device::Device::upload). This scene is then
    /// not complete.
    pub fn put(&mut self, mut other: Self, place: Placement) -> Result<()> {
        if !Arc::ptr_eq(&self.device, &other.device) || !other.beside.is_empty() {
            return argument("the other scene is on another device, or is several scenes already");
        }
        if self.all().any(|scene| scene.ground.is_some() != other.ground.is_some()) {
            return argument("all scenes stand on a ground, or none");
        }
        other.place = place;
        if other.ground.is_some() {
            self.beside.push(other);
            return Ok(());
        }
        let mut beside = std::mem::take(&mut self.beside);
        for scene in beside.iter_mut().chain([&mut *self]) {
            let field = other.field_for(scene)?;
            other.fields.push(scene.field_for(&other)?);
            scene.fields.push(field);
        }
        beside.push(other);
        self.beside = beside;
        Ok(())
    }

    /// Says which part of the world the scene was trained for. Such scenes, [put](Self::put) beside each other, are not one sum over all
    /// Gaussians: each is rendered alone, and counts where its image shows its ground. See [`Ground::weight`].
    pub fn stand_on(&mut self, ground: Ground) {
        self.ground = Some(ground);
    }

    /// Whether these are several scenes that stand on grounds, so that each is rendered alone.
    pub(crate) fn is_blended(&self) -> bool {
        !self.beside.is_empty() && self.all().all(|scene| scene.ground.is_some())
    }

    /// The scenes that are rendered alone, each in its own coordinates, with its place in the first one's and its ground; `None` if all are
    /// one sum.
    pub(crate) fn grounds(&self) -> Option<Vec<(Self, Placement, &Ground)>> {
        if !self.is_blended() {
            return None;
        }
        let alone = |scene: &Self| {
            let place = Placement::default();
            Self { place, beside: Vec::new(), fields: Vec::new(), ..scene.clone() }
        };
        self.all().map(|scene| Some((alone(scene), scene.place, scene.ground.as_ref()?))).collect()
    }

    /// The same scenes, on the same memory, with the scene at `index` of [`DeviceScene::all`] at another place; `index` is not 0.
    ///
    /// # Errors
    /// The same errors as [`DeviceScene::put`].
    pub fn moved(&self, index: usize, place: Placement) -> Result<Self> {
        let mut all = Self { beside: Vec::new(), fields: Vec::new(), ..self.clone() };
        for (at, other) in self.all().enumerate().skip(1) {
            let place = if at == index { place } else { other.place };
            all.put(Self { fields: Vec::new(), ..other.clone() }, place)?;
        }
        Ok(all)
    }

    /// Where this scene lies in the coordinates of the first one.
    pub fn place(&self) -> &Placement {
        &self.place
    }

    /// This scene and those that are shown with it, in the order of [`DeviceScene::put`].
    pub fn all(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.beside)
    }

    /// This scene, and the other scenes' fields with its Gaussians.
    pub(crate) fn with_fields(&self) -> impl Iterator<Item = &Self> {
        std::iter::once(self).chain(&self.fields)
    }

    /// Cameras of the first scene, in this scene's coordinates, as kernels read them.
    pub(crate) fn cameras(&self, cameras: &[&Camera]) -> muslin_device::Result<Buffer<f32>> {
        let own = cameras.iter().map(|camera| self.place.own_camera(camera).for_kernels().pack());
        self.device.upload(CAMERAS, &own.flatten().collect::<Vec<_>>())
    }

    /// This scene's fields, with the Gaussians of another one, whose extra vectors are zero.
    fn field_for(&self, other: &Self) -> Result<Self> {
        let mut position =
            self.device.read(&other.tensors.gaussians.position.view::<[f32; 3]>())?;
        for place in &mut position {
            let shared = other.place.world(place.map(f64::from));
            *place = self.place.own(shared).map(|x| x as f32);
        }
        if !position.as_flattened().iter().all(|x| x.abs() < FARTHEST) {
            return argument("a scene is put so far away that coordinates overflow");
        }
        let extra = vec![0.0; other.len() * self.config.extra as usize];
        let none = Vec::new;
        let gaussians = other.gaussians;
        let mut field = Self { gaussians, beside: none(), fields: none(), ..self.clone() };
        let tensors = &mut field.tensors.gaussians;
        tensors.position = self.device.upload("others' positions", position.as_flattened())?;
        tensors.extra = self.device.upload("others' extra vectors", &extra)?;
        Ok(field)
    }
}
