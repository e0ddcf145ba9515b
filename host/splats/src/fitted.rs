//! Compares the Gaussians of a file with photographs, in its own axes and in other files' axes.

use glam::{DMat3, DVec3, Vec3};
use organza_core::scene::Placement;
use organza_core::{Camera, Error, Result};
use organza_data::Frame;
use rayon::prelude::*;

use super::files::{SYSTEMS, from_axes};
use super::placed::FARTHEST;
use super::{Splat, SplatFile, bounds, render};

/// Most photographs to compare with.
pub const PHOTOGRAPHS: usize = 8;
/// The longest side of their coarse images, in pixels.
const SIDE: u32 = 64;
/// Most Gaussians in a coarse image.
const MAX_SPLATS: usize = 20_000;
/// The least share of the photographs' variance that Gaussians must explain more in other axes to be turned.
const BETTER: f64 = 0.1;
/// Gaussians that explain less do not belong to the photographs. Trained ones explain more than a half; moved to
/// another place, a quarter at most.
const MIN_COVERAGE: f64 = 0.3;

/// The part of a pixel from which on it counts as covered.
const COVERED: f32 = 0.5;

/// A photograph as a coarse image.
struct Coarse {
    camera: Camera,
    /// Without a color where no pixel of the photograph is valid.
    colors: Vec<Option<[f32; 3]>>,
}

impl Coarse {
    fn new(frame: &Frame) -> Self {
        let camera = frame.camera.within(SIDE);
        let image = &frame.image;
        let pixel = |at: u32| {
            let range = |at: u32, of: u32, all: u32| at * all / of..((at + 1) * all).div_ceil(of);
            let columns = range(at % camera.width, camera.width, image.width());
            let rows = range(at / camera.width, camera.height, image.height());
            let places = rows.flat_map(|y| columns.clone().map(move |x| (x, y)));
            let valid = places.filter(|(x, y)| image.is_valid(*x, *y));
            let (sum, count) = valid.fold((Vec3::ZERO, 0.0), |(sum, count), (x, y)| {
                (sum + Vec3::from(image.color(x, y)), count + 1.0)
            });
            (count > 0.0).then(|| (sum / count).to_array())
        };
        let colors = (0..camera.width * camera.height).into_par_iter().map(pixel).collect();
        Self { camera, colors }
    }

    /// The image of some Gaussians before the color that the photograph has around them, and how much of each pixel they cover.
    fn shown(&self, splats: &[Splat], is_antialiased: bool) -> Vec<([f32; 3], f32)> {
        let [black, white] =
            [0.0, 1.0].map(|level| render(splats, &self.camera, [level; 3], is_antialiased));
        let open = black.iter().zip(&white).map(|(black, white)| white[0] - black[0]);
        let open: Vec<_> = open.map(|open| open.clamp(0.0, 1.0)).collect();
        // least squares of `color = black + open background`
        let mut sum = Vec3::ZERO;
        let mut squares = 0.0;
        for ((black, open), color) in black.iter().zip(&open).zip(&self.colors) {
            let Some(color) = color else { continue };
            squares += open * open;
            sum += *open * (Vec3::from(*color) - Vec3::from(*black));
        }
        let background = if squares > 0.0 { sum / squares } else { Vec3::ZERO };
        let pixel = |(black, open): (&[f32; 3], &f32)| {
            ((Vec3::from(*black) + *open * background).to_array(), 1.0 - open)
        };
        black.iter().zip(&open).map(pixel).collect()
    }
}

/// How well Gaussians explain photographs: 1 if their images differ in nothing but contrast and brightness.
#[derive(Clone, Copy, Debug, Default)]
struct Score {
    /// In whole photographs.
    whole: f64,
    /// Where there are Gaussians.
    covered: f64,
}

impl Score {
    fn new(splats: &[Splat], views: &[Coarse], is_antialiased: bool) -> Self {
        let images: Vec<_> = views.iter().map(|view| view.shown(splats, is_antialiased)).collect();
        let share = |min: f32| {
            let pairs = images.iter().zip(views);
            let pairs = pairs.map(|(image, view)| variance(image, &view.colors, min));
            let [explained, all] =
                pairs.fold([0.0; 2], |sum, pair| [sum[0] + pair[0], sum[1] + pair[1]]);
            if all > 0.0 { explained / all } else { 0.0 }
        };
        Self { whole: share(0.0), covered: share(COVERED) }
    }
}

/// The variance of colors, summed over pixels and channels: the part that an image explains by a gain and an offset, and all.
/// Pixels of which Gaussians cover less than `min` do not count.
fn variance(image: &[([f32; 3], f32)], colors: &[Option<[f32; 3]>], min: f32) -> [f64; 2] {
    let pairs = image.iter().zip(colors).filter(|((_, cover), _)| *cover >= min);
    let pairs: Vec<_> = pairs.filter_map(|((found, _), color)| Some([*found, (*color)?])).collect();
    let mut sums = [0.0; 2];
    for channel in 0..3 {
        let value = |pair: &[[f32; 3]; 2], of: usize| f64::from(pair[of][channel]);
        let mean = |of| pairs.iter().map(|pair| value(pair, of)).sum::<f64>() / pairs.len() as f64;
        let means = [mean(0), mean(1)];
        let product = |a: usize, b: usize| -> f64 {
            let term = |pair| (value(pair, a) - means[a]) * (value(pair, b) - means[b]);
            pairs.iter().map(term).sum()
        };
        let both = product(0, 1).max(0.0);
        let own = product(0, 0);
        sums[0] += if own > 0.0 { both * both / own } else { 0.0 };
        sums[1] += product(1, 1);
    }
    sums
}

impl SplatFile {
    /// The same file, turned to the axes in which photographs show its Gaussians, unless it says where it lies. A note says so,
    /// and it says what does not fit in any axes. `placement` is the photographs' cameras'.
    #[must_use]
    pub fn fitted(self, frames: &[&Frame], placement: &Placement) -> Self {
        let some = frames.iter().step_by(frames.len().div_ceil(PHOTOGRAPHS).max(1));
        let views: Vec<_> = some.map(|frame| Coarse::new(frame)).collect();
        if views.is_empty() {
            return self;
        }
        let few = self.few();
        let score = |axes: DMat3| {
            let own = few.clone().turned(axes).into_own(placement);
            // Gaussians that do not fit into the scene explain nothing
            own.map_or(Score::default(), |splats| Score::new(&splats, &views, self.is_antialiased))
        };
        let mut best = (DMat3::IDENTITY, score(DMat3::IDENTITY));
        if !self.is_placed {
            let others = (0..SYSTEMS).map(from_axes).filter(|axes| *axes != DMat3::IDENTITY);
            let others = others.map(|axes| (axes, score(axes)));
            let other = others.max_by(|a, b| a.1.whole.total_cmp(&b.1.whole));
            best = other.filter(|other| other.1.whole > best.1.whole + BETTER).unwrap_or(best);
        }
        let (axes, Score { covered, .. }) = best;
        if covered < MIN_COVERAGE {
            let axes = if self.is_placed { "" } else { ", in any of the usual axes" };
            return self.noted(format!(
                "the photographs show something else where its Gaussians are{axes}; are the cameras, the origin and the scale \
                 those that the Gaussians were trained with?"
            ));
        }
        if axes == DMat3::IDENTITY {
            return self;
        }
        self.turned(axes).noted(format!(
            "the photographs show its Gaussians in other axes, so they are turned: x, y, z become {}",
            named(axes)
        ))
    }

    fn noted(mut self, note: String) -> Self {
        self.notes.push(note);
        self
    }

    /// The Gaussians in the space of a scene, some of which its cameras must see.
    ///
    /// # Errors
    /// [`Error::Invalid`] if they see none; errors of [`SplatFile::into_own`].
    pub fn into_seen(self, placement: &Placement, cameras: &[Camera]) -> Result<Vec<Splat>> {
        let origin = self.path.clone();
        let splats = self.into_own(placement)?;
        let is_seen = |splat: &Splat| {
            let place = splat.position.map(f64::from);
            let depth = |camera: &Camera| camera.depth_in_image(place);
            cameras.iter().filter_map(depth).any(|depth| depth < FARTHEST)
        };
        if splats.iter().any(is_seen) {
            return Ok(splats);
        }
        let [low, high] = bounds(&splats);
        let middle = placement.world([0, 1, 2].map(|axis| (low[axis] + high[axis]) / 2.0));
        let reason = format!(
            "the cameras see none of its Gaussians, which lie around {:?}, while the cameras look at {:?}; name the cameras \
             that the Gaussians were trained with",
            middle.map(rounded),
            placement.offset.map(rounded)
        );
        Err(Error::Invalid { origin, reason })
    }

    /// Few Gaussians that are as large as all of them together.
    fn few(&self) -> Self {
        let stride = self.splats.len().div_ceil(MAX_SPLATS).max(1);
        let larger = (stride as f32).sqrt().ln();
        let some = self.splats.iter().step_by(stride).copied();
        let splats =
            some.map(|splat| Splat { log_scale: splat.log_scale.map(|log| log + larger), ..splat });
        let placement = self.placement;
        Self { placement, ..Self::new(&self.path, self.format, splats.collect()) }
    }
}

/// With three digits after the point.
fn rounded(x: f64) -> f64 {
    (1e3 * x).round() / 1e3
}

/// What x, y and z become, such as `x, -y, -z`.
fn named(axes: DMat3) -> String {
    let name = |axis: DVec3| {
        let parts = axis.to_array();
        let at = parts.iter().position(|part| *part != 0.0).unwrap_or(0);
        let sign = if parts[at] < 0.0 { "-" } else { "" };
        format!("{sign}{}", ["x", "y", "z"][at])
    };
    [0, 1, 2].map(|row| name(axes.row(row))).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Views;
    use organza_core::image::to_8_bit;
    use organza_data::Photograph;

    /// Opaque Gaussians of all colors, which look different from all sides.
    fn file() -> SplatFile {
        let value = |i: usize, k: usize| ((i * 37 + k * 61) % 97) as f32 / 97.0 - 0.5;
        let splat = |i: usize| Splat {
            position: [value(i, 0) * 3.0, value(i * i, 1) * 2.0, value(i, 2) + 0.3],
            rotation: [1.0, 0.0, 0.0, 0.0],
            log_scale: [-1.6; 3],
            opacity: 3.0,
            color: std::array::from_fn(|h| {
                std::array::from_fn(|c| if h == 0 { 3.0 * value(i * 7, c) } else { 0.0 })
            }),
        };
        SplatFile::new("a.ply".as_ref(), "PLY", (0..60).map(splat).collect())
    }

    /// Photographs of them, in a world far away that is a tenth as large.
    fn frames() -> (Vec<Frame>, Placement) {
        let placement = Placement { offset: [3e5, -2e6, 7.0], scale: 0.1, ..Placement::default() };
        let splats = file().splats;
        let frame = |camera: Camera| {
            let camera = camera.within(80);
            let pixels = render(&splats, &camera, [0.0; 3], false).into_iter();
            let pixels = pixels.map(|color| color.map(to_8_bit)).collect();
            let image = Photograph::new([camera.width, camera.height], pixels, None).unwrap();
            Frame { name: String::new(), camera, image }
        };
        let views = Views::around(bounds(&splats)).unwrap();
        (views.held_out.into_iter().map(frame).collect(), placement)
    }

    fn positions(file: SplatFile, placement: &Placement) -> Vec<[f32; 3]> {
        file.into_own(placement).unwrap().iter().map(|splat| splat.position).collect()
    }

    #[test]
    fn photographs_tell_the_axes() {
        let (frames, placement) = frames();
        let frames: Vec<_> = frames.iter().collect();
        let expected = file();
        let placed = SplatFile { placement, ..expected.clone() };
        let found = placed.clone().fitted(&frames, &placement);
        assert_eq!(found, placed);
        let mut names = Vec::new();
        for axes in (0..SYSTEMS).map(from_axes).filter(|axes| *axes != DMat3::IDENTITY) {
            let turned = placed.clone().turned(axes.transpose());
            let found = turned.clone().fitted(&frames, &placement);
            let [note] = &found.notes[..] else { panic!("{:?}", found.notes) };
            names.push(note.rsplit("become ").next().unwrap().to_owned());
            for (a, b) in positions(found, &placement).iter().zip(&expected.splats) {
                let apart = DVec3::from(a.map(f64::from)) - DVec3::from(b.position.map(f64::from));
                assert!(apart.length() < 1e-5, "{axes}: {apart}");
            }
            // what a file says is not changed, but said
            let sure = SplatFile { is_placed: true, ..turned };
            let found = sure.clone().fitted(&frames, &placement);
            assert!(found.notes[0].contains("something else"), "{:?}", found.notes);
            assert_eq!(found.placement, sure.placement);
        }
        assert!(
            ["x, -y, -z", "x, -z, y", "-x, y, -z"]
                .iter()
                .all(|name| names.contains(&(*name).into()))
        );
    }

    #[test]
    fn what_does_not_fit_is_said_or_refused() {
        let (frames, placement) = frames();
        let frames: Vec<_> = frames.iter().collect();
        let at = |scale: f64, off: f64| {
            let offset = placement.world([off, 0.0, 0.0]);
            let placement = Placement { offset, scale: scale * placement.scale, ..placement };
            SplatFile { placement, ..file() }
        };
        for file in [at(0.3, 0.0), at(50.0, 0.0), at(1.0, 1.5)] {
            let found = file.fitted(&frames, &placement);
            assert!(found.notes[0].contains("something else"), "{:?}", found.notes);
        }
        let cameras: Vec<_> = frames.iter().map(|frame| frame.camera.clone()).collect();
        assert!(at(1.0, 1.5).into_seen(&placement, &cameras).is_ok());
        // without its offset, in the direction in which some camera looks
        let error = file().into_seen(&placement, &cameras).unwrap_err().to_string();
        assert!(error.contains("see none") && error.contains("300000.0, -2000000.0"), "{error}");
    }
}
