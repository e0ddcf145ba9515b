//! Converts results to 8-bit colors.

use colorous::{Color, Gradient};

use super::message::Mode;
use organza_core::error::refuse;
use organza_core::image::{ChannelImage, Image};
use organza_core::metrics::{ERROR_FACTOR, error_levels};
use organza_core::{Camera, Channel, Result};
use organza_data::Photograph;
use organza_render::DeviceScene;

/// JPEG quality of images that are not exact, out of 100.
const QUALITY: u8 = 85;

/// The values at both ends of a color scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    pub low: f64,
    pub high: f64,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Self; 7] = [
        Self::Color,
        Self::Visibility,
        Self::Weight,
        Self::Depth,
        Self::Normal,
        Self::Gaussians,
        Self::Error,
    ];

    /// The channels that the mode needs.
    pub fn channels(self) -> &'static [Channel] {
        match self {
            Self::Visibility => &[Channel::Visibility],
            Self::Weight => &[Channel::Alpha],
            Self::Depth => &[Channel::Depth],
            Self::Normal => &[Channel::Normal],
            Self::Color | Self::Gaussians | Self::Error => &[],
        }
    }

    /// The color gradient of the mode's numbers.
    fn gradient(self) -> Option<Gradient> {
        match self {
            Self::Visibility => Some(colorous::VIRIDIS),
            Self::Weight => Some(colorous::CIVIDIS),
            Self::Depth => Some(colorous::TURBO),
            Self::Gaussians => Some(colorous::MAGMA),
            Self::Error => Some(colorous::INFERNO),
            Self::Color | Self::Normal => None,
        }
    }

    /// `count` colors from the lowest to the highest value. Near is red and far is blue, as in films.
    fn colors(self, count: usize) -> Option<Vec<Color>> {
        let gradient = self.gradient()?;
        let color = |at: usize| match self {
            Self::Depth => gradient.eval_rational(count - 1 - at, count),
            _ => gradient.eval_rational(at, count),
        };
        Some((0..count).map(color).collect())
    }

    /// Colors from the lowest to the highest value, for the page's scale.
    pub fn ramp(self) -> Option<Vec<String>> {
        Some(self.colors(17)?.iter().map(|color| format!("#{color:x}")).collect())
    }
}

/// The image of a channel.
pub fn channel_image(
    mode: Mode,
    channel: &ChannelImage,
    scene: &DeviceScene,
    camera: &Camera,
) -> (Image, Option<Range>) {
    let size = channel.size();
    let values = channel.values();
    if mode == Mode::Normal {
        let area = values.len() / 3;
        let level = |value: f32| (127.5 * value + 127.5).clamp(0.0, 255.0).round() as u8;
        let pixel = |at: usize| [0, 1, 2].map(|axis| level(values[axis * area + at]));
        let pixels: Vec<_> = (0..area).map(pixel).collect();
        return (Image::from_pixels(size, &pixels), None);
    }
    let range = match mode {
        Mode::Depth => depths(scene, camera),
        // Eq. 13 divides above 1, so this end is always there
        Mode::Weight => Range { low: 0.0, high: round_up(highest(values).max(2.0)) },
        _ => Range { low: 0.0, high: 1.0 },
    };
    (scaled(mode, size, values.iter().map(|&value| f64::from(value)), range), Some(range))
}

/// The image of the number of Gaussians in each pixel's sum.
pub fn count_image(count: &[u32], size: [u32; 2]) -> (Image, Option<Range>) {
    let max = count.iter().copied().max().unwrap_or(0).max(8);
    let range = Range { low: 0.0, high: round_up(f64::from(max)) };
    (scaled(Mode::Gaussians, size, count.iter().map(|&n| f64::from(n)), range), Some(range))
}

/// The largest finite value.
fn highest(values: &[f32]) -> f64 {
    values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f32::max).into()
}

/// The next 1, 2 or 5 times a power of ten: the end of a scale that rarely changes.
fn round_up(value: f64) -> f64 {
    let power = 10.0_f64.powf(value.log10().floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|times| times * power)
        .into_iter()
        .find(|end| *end >= value)
        .unwrap_or(value)
}

/// The image of the difference from a photograph: the mean over the channels, from 0 to 1 / [`ERROR_FACTOR`].
pub fn error_image(image: &Image, truth: &Photograph) -> Result<(Image, Option<Range>)> {
    if image.size() != [truth.width(), truth.height()] {
        return refuse("the photograph has another size");
    }
    let levels = error_levels(truth.pixels(), image.pixels(), truth.valid());
    let range = Range { low: 0.0, high: 1.0 / f64::from(ERROR_FACTOR) };
    let values = levels.iter().map(|&level| f64::from(level) / 255.0 * range.high);
    Ok((scaled(Mode::Error, image.size(), values, range), Some(range)))
}

fn scaled(
    mode: Mode,
    size: [u32; 2],
    values: impl Iterator<Item = f64>,
    Range { low, high }: Range,
) -> Image {
    let table = mode.colors(256).expect("the mode has a scale");
    let level = |value: f64| (255.0 * ((value - low) / (high - low)).clamp(0.0, 1.0)).round();
    let color = |value: f64| match mode {
        // nothing is there
        Mode::Depth if value <= 0.0 => [0; 3],
        _ => table[level(value) as usize].into_array(),
    };
    let pixels: Vec<_> = values.map(color).collect();
    Image::from_pixels(size, &pixels)
}

/// The range of depths of the scene's box, as a camera sees it.
fn depths(scene: &DeviceScene, camera: &Camera) -> Range {
    let [low, high] = scene.config().aabb;
    let depth = |corner: usize| {
        let axis = |axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
        camera.depth(std::array::from_fn(axis))
    };
    let (near, far) = (0..8)
        .map(depth)
        .fold((f64::INFINITY, 0.0_f64), |(near, far), depth| (near.min(depth), far.max(depth)));
    let [near, far] = [near, far].map(|depth| depth * scene.config().placement.scale);
    let far = if far > 0.0 { far } else { 1.0 };
    Range { low: near.clamp(0.0, 0.99 * far), high: far }
}

/// The bytes of a JPEG file.
pub fn encode_jpeg(image: &Image) -> Result<Vec<u8>> {
    organza_data::encode_jpeg(image.size(), image.pixels().as_flattened(), QUALITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_at_1_2_or_5_times_a_power_of_ten() {
        for (value, end) in [(2.0, 2.0), (2.1, 5.0), (8.0, 10.0), (14.2, 20.0), (1000.0, 1000.0)] {
            assert_eq!(round_up(value), end, "{value}");
        }
        assert_eq!(round_up(0.03), 0.05);
    }

    #[test]
    fn near_is_red_far_is_blue_and_empty_is_black() {
        let range = Range { low: 1.0, high: 2.0 };
        let image = scaled(Mode::Depth, [3, 1], [1.1, 1.9, 0.0].into_iter(), range);
        let [near, far, nothing] = *image.pixels() else { panic!("three pixels") };
        assert!(near[0] > near[2] && far[2] > far[0], "{near:?} {far:?}");
        assert_eq!(nothing, [0; 3]);
        assert_eq!(
            Mode::Depth.ramp().unwrap()[0],
            format!("#{:x}", colorous::TURBO.eval_rational(16, 17))
        );
    }
}
