//! The views in which a scene is compared with Gaussians of other programs, and the box of these.

use super::Splat;
use organza_core::camera::{Camera, Orbit};
use organza_core::error::Result;
use organza_core::scene;
use organza_data::{Dataset, Frame};

/// Number of cameras on each circle around a box.
const AROUND: usize = 16;
const ELEVATIONS: [f64; 3] = [-15.0, 17.0, 45.0];
/// Width and height of their images, in pixels.
const SIZE: [u32; 2] = [640, 480];
/// Without photographs, every Nth camera is only measured.
const JUDGES: usize = 8;

/// The views of a fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Views {
    /// Views that the fit sees.
    pub fitted: Vec<Camera>,
    /// Views in which its result is only measured.
    pub judges: Vec<Camera>,
}

impl Views {
    /// Every eighth camera is only measured. With fewer than eight, none is.
    #[must_use]
    pub fn from_cameras(cameras: Vec<Camera>) -> Self {
        let mut fitted = Vec::new();
        let mut judges = Vec::new();
        let is_enough = cameras.len() >= JUDGES;
        for (index, camera) in cameras.into_iter().enumerate() {
            let is_judge = is_enough && index % JUDGES == JUDGES / 2;
            if is_judge { judges.push(camera) } else { fitted.push(camera) }
        }
        Self { fitted, judges }
    }

    /// The frames of a data set. Those that training saw are fitted, and the held-out ones are only measured. If
    /// there are no frames of one kind, the others are fitted.
    #[must_use]
    pub fn from_data_set(data: &Dataset) -> Self {
        let cameras = |frames: &mut dyn Iterator<Item = &Frame>| -> Vec<_> {
            frames.map(|frame| frame.camera.clone()).collect()
        };
        let fitted = cameras(&mut data.train_frames());
        let judges = cameras(&mut data.held_out_frames());
        let (fitted, judges) = if fitted.is_empty() { (judges, fitted) } else { (fitted, judges) };
        Self { fitted, judges }
    }

    /// Cameras on several circles that see a whole box from all sides. Every eighth is only measured.
    ///
    /// # Errors
    /// [`Error::Camera`](organza_core::Error::Camera) if the box has no outside.
    pub fn around(aabb: [[f64; 3]; 2]) -> Result<Self> {
        let orbit = Orbit::from_box(aabb, SIZE);
        let circle = |elevation: f64| {
            Orbit { elevation: elevation.to_radians(), ..orbit.clone() }.cameras(AROUND)
        };
        let circles = ELEVATIONS.into_iter().map(circle).collect::<Result<Vec<_>>>()?;
        // alternates between the circles, so that the measured cameras come from all of them
        let at = |at: usize| circles.iter().map(move |circle| circle[at].clone());
        Ok(Self::from_cameras((0..AROUND).flat_map(at).collect()))
    }
}

/// The box of nearly all of the opacity, as [`scene::bounds`] says.
#[must_use]
pub fn bounds(splats: &[Splat]) -> [[f64; 3]; 2] {
    let position: Vec<_> = splats.iter().map(|splat| splat.position).collect();
    let log_scale: Vec<_> = splats.iter().map(|splat| splat.log_scale).collect();
    let opacity: Vec<_> = splats.iter().map(|splat| splat.opacity).collect();
    scene::bounds(&position, &log_scale, &opacity)
}
