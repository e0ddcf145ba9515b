//! The path of a film's camera.

use organza::camera::{CameraPath, Orbit};
use organza::{Camera, Result, Scene};

use crate::cli::console::Console;
use crate::cli::inputs::{Cameras, DataArgs, Shown};
use crate::cli::summary::count;
use crate::cli::views::ViewList;
use crate::cli::{image_size, refuse};

/// Longer side of a film by default, in pixels: photographs may be several times as large.
const LONGEST_SIDE: u32 = 1920;

/// Options of the camera's path.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Camera")]
pub struct PathArgs {
    /// The cameras to move through, such as 0,8 or 0-3 [default: all of CAMERAS]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    views: Option<ViewList>,
    /// Move through the cameras, and return from the last one to the first
    #[arg(long = "loop")]
    is_closed: bool,
    /// Width and height in pixels, such as 1280x720 [default: the first camera's, if that has at most 1920 pixels a side]
    #[arg(long, value_name = "WxH", value_parser = image_size)]
    size: Option<[u32; 2]>,
}

impl PathArgs {
    /// The camera of each of so many frames, and the cameras that the path was made from, if there are any. Without `--size`,
    /// width and height are even if `is_even` is true.
    pub fn frames(
        &self,
        (shown, scene): (&Shown, &Scene),
        data: &DataArgs,
        frames: usize,
        is_even: bool,
        console: Console,
    ) -> Result<(Vec<Camera>, Option<Cameras>)> {
        let source = &shown.source;
        let named = shown.cameras.as_deref();
        let is_between = named.is_some() || self.views.is_some() || self.is_closed;
        if !is_between && !data.is_given() && source.settings()?.is_none() {
            let size = self.size.unwrap_or(Orbit::SIZE);
            return Ok((Orbit::from_box(scene.visible_box(), size).cameras(frames)?, None));
        }
        let cameras = Cameras::load(source, named, data, console)?;
        let size = |camera: &Camera| self.size.unwrap_or_else(|| default_size(camera, is_even));
        let frames = if is_between {
            self.between(&cameras, frames, size)?
        } else {
            let way = Orbit::among(&cameras.list, frames)?;
            way.iter().map(|camera| camera.with_size(size(camera))).collect()
        };
        Ok((frames, Some(cameras)))
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
                "a film between cameras needs two at least; {origin} gives one, view {only}"
            ));
        }
        let size = size(&list[views[0]]);
        let keys: Vec<_> = views.iter().map(|&view| list[view].with_size(size)).collect();
        Ok(CameraPath::through(&keys, self.is_closed)?.cameras(frames))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments_are_read_or_refused() {
        assert_eq!(image_size("1280x720"), Ok([1280, 720]));
        for bad in ["", "640", "640x", "0x480", "70000x8", "-1x4", "1.5x2", "6 40x2"] {
            assert!(image_size(bad).is_err(), "{bad}");
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
