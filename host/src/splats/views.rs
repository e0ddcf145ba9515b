//! The views in which a scene and Gaussians of other programs are compared.

use super::{Splat, psnr};
use crate::camera::{Camera, Orbit};
use crate::data::{Dataset, Frame};
use crate::error::Result;
use crate::evaluate::evaluate;
use crate::render::{DeviceScene, Renderer};

/// Cameras around a box: on each circle, and the circles' elevations in degrees.
const AROUND: usize = 16;
const ELEVATIONS: [f64; 3] = [-15.0, 17.0, 45.0];
/// Width and height of their images, in pixels.
const SIZE: [u32; 2] = [640, 480];
/// Of cameras without photographs, every Nth is only measured.
const JUDGES: usize = 8;

/// The views of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Views {
    /// Those that the fit sees.
    pub fitted: Vec<Camera>,
    /// Those in which its result is only measured.
    pub judges: Vec<Camera>,
}

impl Views {
    /// Every eighth camera is only measured; with fewer than eight, none is.
    #[must_use]
    pub fn of_cameras(cameras: Vec<Camera>) -> Self {
        let [mut fitted, mut judges] = [Vec::new(), Vec::new()];
        let is_enough = cameras.len() >= JUDGES;
        for (index, camera) in cameras.into_iter().enumerate() {
            let is_judge = is_enough && index % JUDGES == JUDGES / 2;
            if is_judge { judges.push(camera) } else { fitted.push(camera) }
        }
        Self { fitted, judges }
    }

    /// The frames of a data set: those that training saw are fitted, those that were held out are only measured. Where one kind is
    /// missing, the other is fitted.
    #[must_use]
    pub fn of_data_set(data: &Dataset) -> Self {
        let cameras = |frames: &mut dyn Iterator<Item = &Frame>| -> Vec<_> {
            frames.map(|frame| frame.camera.clone()).collect()
        };
        let fitted = cameras(&mut data.train_frames());
        let judges = cameras(&mut data.held_out_frames());
        let (fitted, judges) = if fitted.is_empty() { (judges, fitted) } else { (fitted, judges) };
        Self { fitted, judges }
    }

    /// Cameras that see a whole box from all sides, a circle above the other; every eighth is only measured.
    ///
    /// # Errors
    /// [`Error::Camera`](crate::Error::Camera) if the box has no outside.
    pub fn around(aabb: [[f64; 3]; 2]) -> Result<Self> {
        let orbit = Orbit::of_box(aabb, SIZE);
        let circle = |elevation: f64| {
            Orbit { elevation: elevation.to_radians(), ..orbit.clone() }.cameras(AROUND)
        };
        let circles = ELEVATIONS.into_iter().map(circle).collect::<Result<Vec<_>>>()?;
        // one of each circle after the other: judges are of all circles
        let at = |at: usize| circles.iter().map(move |circle| circle[at].clone());
        Ok(Self::of_cameras((0..AROUND).flat_map(at).collect()))
    }
}

/// How close images are to photographs, in dB: mean PSNRs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// How many photographs there are.
    pub photographs: usize,
    /// Of the scene's own images.
    pub scene: f64,
    /// Of the Gaussians' images, as a viewer that sorts shows them.
    pub splats: f64,
}

/// Compares a scene and Gaussians that were [made of it](super::distill()) with photographs. None without photographs that have a valid
/// pixel.
///
/// # Errors
/// The same errors as [`Renderer::render`].
pub fn beside(
    renderer: &Renderer,
    scene: &DeviceScene,
    splats: &[Splat],
    photographs: &[&Frame],
) -> Result<Option<Beside>> {
    let Some(own) = evaluate(renderer, scene, photographs)?.mean.psnr else { return Ok(None) };
    let background = scene.config().background.map(|x| x as f32);
    let of = |frame: &&Frame| {
        let Frame { camera, image, .. } = frame;
        psnr(splats, camera, background, image.pixels(), image.valid())
    };
    let found: Vec<_> = photographs.iter().filter_map(of).collect();
    let splats = found.iter().sum::<f64>() / found.len() as f64;
    Ok(Some(Beside { photographs: found.len(), scene: own, splats }))
}
