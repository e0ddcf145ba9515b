//! The path of a film's camera.

use std::path::Path;

use organza::camera::{CameraPath, Orbit};
use organza::scene::Placement;
use organza::{Camera, Result, Scene};

use crate::cli::console::Console;
use crate::cli::inputs::{Cameras, DataArgs, SceneSource};
use crate::cli::summary::count;
use crate::cli::views::ViewList;
use crate::cli::{image_size, number_in, numbers, refuse};

const USAGE: &str = "organza film SCENE CAMERAS -o FILE";
/// Longer side of a film by default, in pixels: photographs may be several times as large.
const LONGEST_SIDE: u32 = 1920;

/// Options of the camera's path.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Camera")]
pub struct PathArgs {
    /// Turn once around the point that the cameras look at [default for a scene without cameras]. Without CAMERAS, the
    /// default for a run is an arc or a ring where its cameras stood
    #[arg(long, conflicts_with = "between")]
    orbit: bool,
    /// Move smoothly through the cameras, in their order [default with CAMERAS]
    #[arg(long)]
    between: bool,
    /// The cameras to move through, such as 0,8 or 0-3 [default: all]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true, conflicts_with = "orbit")]
    views: Option<ViewList>,
    /// Return from the last camera to the first
    #[arg(long = "loop", conflicts_with = "orbit")]
    is_closed: bool,
    /// Center of the orbit, in world units [default: the point that the cameras look at, or the middle of the scene's
    /// box]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, requires = "orbit")]
    center: Option<[f64; 3]>,
    /// Axis of the orbit, upward in the film [default: the cameras' own, or 0,0,1]
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true, requires = "orbit")]
    up: Option<[f64; 3]>,
    /// Distance from the center, in world units [default: the cameras' median]
    #[arg(long, value_name = "D", requires = "orbit")]
    #[arg(value_parser = number_in(Orbit::DISTANCES, "a number above 0"))]
    distance: Option<f64>,
    /// Angle above the horizon, in degrees, -89 to 89 [default: the cameras' median]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, requires = "orbit")]
    #[arg(value_parser = number_in(Orbit::ELEVATIONS, "degrees from -89 to 89"))]
    elevation: Option<f64>,
    /// Horizontal field of view of an orbit, in degrees, 1 to 170 [default: the first camera's]
    #[arg(long, value_name = "DEGREES", requires = "orbit")]
    #[arg(value_parser = number_in(Orbit::FIELDS_OF_VIEW, "degrees from 1 to 170"))]
    field_of_view: Option<f64>,
    /// Width and height in pixels, such as 1280x720 [default: the first camera's, if that has at most 1920 pixels a side]
    #[arg(long, value_name = "WxH", value_parser = image_size)]
    size: Option<[u32; 2]>,
}

/// The inputs of a film.
pub struct Inputs<'a> {
    pub source: &'a SceneSource,
    pub scene: &'a Scene,
    /// The cameras that the user named.
    pub named: Option<&'a Path>,
    pub data: &'a DataArgs,
}

/// The camera of each frame.
#[derive(Debug)]
pub struct FilmPath {
    pub frames: Vec<Camera>,
    /// The cameras that the path was made from, if there are any.
    pub cameras: Option<Cameras>,
}

impl PathArgs {
    /// The cameras of `count` frames. Without `--size`, width and height are even if `is_even` is true.
    pub fn frames(
        &self,
        inputs: &Inputs<'_>,
        frames: usize,
        is_even: bool,
        console: Console,
    ) -> Result<FilmPath> {
        let Inputs { source, named, data, .. } = *inputs;
        let placement = &inputs.scene.config.placement;
        let is_between = self.between || (named.is_some() && !self.orbit);
        let has_cameras = named.is_some() || data.is_given() || source.settings()?.is_some();
        let cameras = match is_between || has_cameras {
            true => Some(Cameras::load(source, named, data, USAGE, console)?),
            false => None,
        };
        let size = |camera: &Camera| match self.size {
            Some(size) => size,
            None => default_size(camera, is_even),
        };
        let frames = match &cameras {
            Some(cameras) if is_between => self.between(cameras, frames, size)?,
            Some(cameras) if !self.orbit => Orbit::among(&cameras.list, frames)?
                .iter()
                .map(|camera| camera.with_size(size(camera)))
                .collect(),
            Some(cameras) => {
                let mut orbit = Orbit::around(&cameras.list)?;
                orbit.size = [cameras.list[0].width, cameras.list[0].height];
                self.orbit(orbit, placement, frames, size)?
            }
            None => {
                let aabb = inputs.scene.visible_box();
                let orbit = Orbit::from_box(aabb, self.size.unwrap_or(Orbit::SIZE));
                self.orbit(orbit, placement, frames, size)?
            }
        };
        Ok(FilmPath { frames, cameras })
    }

    fn between(
        &self,
        cameras: &Cameras,
        frames: usize,
        size: impl Fn(&Camera) -> [u32; 2],
    ) -> Result<Vec<Camera>> {
        let list = &cameras.list;
        let views = match &self.views {
            Some(views) => views.resolve(list.len(), &cameras.origin)?,
            None => (0..list.len()).collect(),
        };
        if let [only] = views[..] {
            let origin = cameras.origin.display();
            return refuse(format!(
                "a film between cameras needs two at least; {origin} gives one, view {only}: try `--orbit`"
            ));
        }
        let size = size(&list[views[0]]);
        let keys: Vec<_> = views.iter().map(|&view| list[view].with_size(size)).collect();
        Ok(CameraPath::through(&keys, self.is_closed)?.cameras(frames))
    }

    fn orbit(
        &self,
        found: Orbit,
        placement: &Placement,
        frames: usize,
        size: impl Fn(&Camera) -> [u32; 2],
    ) -> Result<Vec<Camera>> {
        // the user gives coordinates of the world
        let orbit = Orbit {
            center: self.center.map_or(found.center, |center| placement.own(center)),
            up: self.up.map_or(found.up, |up| placement.own_direction(up)),
            distance: self.distance.map_or(found.distance, |far| far / placement.scale),
            elevation: self.elevation.map_or(found.elevation, f64::to_radians),
            angle: self.field_of_view.map_or(found.angle, f64::to_radians),
            ..found
        };
        let cameras = orbit.cameras(frames)?;
        // a field of view that the user gave is the film's
        if self.field_of_view.is_some() {
            let size = size(&cameras[0]);
            return Orbit { size, ..orbit }.cameras(frames);
        }
        Ok(cameras.iter().map(|camera| camera.with_size(size(camera))).collect())
    }
}

/// A camera's own size, or a smaller one of the same shape.
fn default_size(camera: &Camera, is_even: bool) -> [u32; 2] {
    let size = [camera.width, camera.height];
    let longest = size[0].max(size[1]);
    let scale = f64::from(longest.min(LONGEST_SIDE)) / f64::from(longest);
    size.map(|side| {
        let side = ((f64::from(side) * scale).round() as u32).max(1);
        if is_even { side.next_multiple_of(2) } else { side }
    })
}

/// Length, size and frames of a film: `6.0 s of 640 x 480, 180 frames`
pub fn described(frames: &[Camera], fps: u32) -> String {
    let number = frames.len();
    let width = frames[0].width;
    let height = frames[0].height;
    let seconds = number as f64 / f64::from(fps);
    format!("{seconds:.1} s of {width} x {height}, {}", count(number as u64, "frame"))
}

fn vector(text: &str) -> Result<[f64; 3], String> {
    numbers(text).ok_or_else(|| "expected three numbers X,Y,Z such as 0,0,1.5".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_are_read_or_refused() {
        assert_eq!(vector(" 1,-2.5, 3e1"), Ok([1.0, -2.5, 30.0]));
        assert_eq!(image_size("1280x720"), Ok([1280, 720]));
        for bad in ["", "1,2", "1,2,3,4", "1,,2", "nan,0,0", "inf,0,0"] {
            assert!(vector(bad).is_err(), "{bad}");
        }
        for bad in ["", "640", "640x", "0x480", "70000x8", "-1x4", "1.5x2", "6 40x2"] {
            assert!(image_size(bad).is_err(), "{bad}");
        }
        for (range, good, bad) in [
            (Orbit::ELEVATIONS, "-89", ["90", "nan"]),
            (Orbit::DISTANCES, "0.1", ["0", "inf"]),
            (Orbit::FIELDS_OF_VIEW, "170", ["0.5", ""]),
        ] {
            let parse = number_in(range, "a number");
            assert!(parse(good).is_ok() && bad.into_iter().all(|bad| parse(bad).is_err()));
        }
    }

    #[test]
    fn large_photographs_make_a_smaller_film() {
        let of =
            |size| Camera::look_at([0.0, -1.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0], 0.7, size).unwrap();
        assert_eq!(default_size(&of([67, 120]), false), [67, 120]);
        assert_eq!(default_size(&of([67, 120]), true), [68, 120]);
        assert_eq!(default_size(&of([6000, 4000]), false), [1920, 1280]);
        assert_eq!(default_size(&of([65536, 1]), true), [1920, 2]);
    }
}
