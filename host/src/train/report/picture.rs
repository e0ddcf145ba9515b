//! Photograph, rendered image and error picture of a view, as data that a page carries with it.

use std::io;
use std::path::Path;

use ::image::codecs::jpeg::JpegEncoder;
use ::image::codecs::png::PngEncoder;
use ::image::imageops::{self, FilterType};
use ::image::{ExtendedColorType, GrayImage, ImageEncoder, RgbImage};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::ReportView;
use crate::error::{Error, Result};

/// The error picture shows the difference times this.
pub const ERROR_FACTOR: u32 = 5;
/// Images of at most so many pixels are kept as they are, as PNG.
const LOSSLESS_PIXELS: u32 = 128 * 128;
/// JPEG's quality, of 100.
const QUALITY: u8 = 88;
/// The longer side of a picture, in pixels: the largest with which all of them take at most [`MOST_BYTES`].
const SIDES: [u32; 4] = [800, 560, 400, 280];
/// What all pictures together may take in the page.
const MOST_BYTES: usize = 8 << 20;

/// A picture in the page.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Its size in pixels.
    pub size: [u32; 2],
    /// A `data:` address.
    pub data: String,
}

/// Photograph, rendered image and error of each view, small enough to be in one page.
pub fn pictures(views: &[ReportView<'_>]) -> Result<Vec<[Picture; 3]>> {
    let mut found = Vec::new();
    for side in SIDES {
        found = views.iter().map(|view| of_view(view, side)).collect::<Result<_>>()?;
        let bytes: usize = found.iter().flatten().map(|picture: &Picture| picture.data.len()).sum();
        if bytes <= MOST_BYTES {
            break;
        }
    }
    Ok(found)
}

fn of_view(view: &ReportView<'_>, side: u32) -> Result<[Picture; 3]> {
    let [width, height] = view.rendered.size();
    let (truth, rendered) = (view.truth.pixels(), view.rendered.pixels());
    let has_size = [view.truth.width(), view.truth.height()] == [width, height];
    let error = error_levels(truth, rendered, view.truth.valid());
    let images = has_size.then(|| {
        let rgb =
            |pixels: &[[u8; 3]]| RgbImage::from_raw(width, height, pixels.as_flattened().to_vec());
        Some((rgb(truth)?, rgb(rendered)?, GrayImage::from_raw(width, height, error)?))
    });
    let Some((truth, rendered, error)) = images.flatten() else {
        let reason = format!("the image of view {} is not of its photograph's size", view.name);
        return Err(Error::Argument { reason });
    };
    // Errors are made smaller as numbers, and colored after that.
    Ok([
        encode(&shrink(&truth, side))?,
        encode(&shrink(&rendered, side))?,
        encode(&colored(&shrink(&error, side)))?,
    ])
}

/// The mean absolute difference of the channels times [`ERROR_FACTOR`]; 0 where the photograph has no pixel.
fn error_levels(truth: &[[u8; 3]], rendered: &[[u8; 3]], valid: Option<&[bool]>) -> Vec<u8> {
    let level = |(at, (a, b)): (usize, (&[u8; 3], &[u8; 3]))| {
        let sum: u32 = a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
        let is_valid = valid.is_none_or(|valid| valid[at]);
        if is_valid { ((sum * ERROR_FACTOR + 1) / 3).min(255) as u8 } else { 0 }
    };
    truth.iter().zip(rendered).enumerate().map(level).collect()
}

fn colored(levels: &GrayImage) -> RgbImage {
    let color = |&::image::Luma([level])| ::image::Rgb(error_color(f64::from(level) / 255.0));
    let mut image = RgbImage::new(levels.width(), levels.height());
    image.pixels_mut().zip(levels.pixels()).for_each(|(pixel, level)| *pixel = color(level));
    image
}

/// The color of an error of 0 to 1, the factor included.
pub fn error_color(level: f64) -> [u8; 3] {
    colorous::INFERNO.eval_continuous(level.clamp(0.0, 1.0)).into_array()
}

/// An image whose longer side has at most so many pixels.
fn shrink<P>(
    image: &::image::ImageBuffer<P, Vec<u8>>,
    side: u32,
) -> ::image::ImageBuffer<P, Vec<u8>>
where
    P: ::image::Pixel<Subpixel = u8> + 'static,
{
    let (width, height) = image.dimensions();
    let longer = width.max(height);
    if longer <= side {
        return image.clone();
    }
    let scaled = |size: u32| (u64::from(size) * u64::from(side)).div_ceil(u64::from(longer)) as u32;
    imageops::resize(image, scaled(width), scaled(height), FilterType::Triangle)
}

fn encode(image: &RgbImage) -> Result<Picture> {
    let (width, height) = image.dimensions();
    let mut bytes = Vec::new();
    let rgb = ExtendedColorType::Rgb8;
    let is_small = width * height <= LOSSLESS_PIXELS;
    let (encoded, kind) = if is_small {
        (PngEncoder::new(&mut bytes).write_image(image, width, height, rgb), "png")
    } else {
        (
            JpegEncoder::new_with_quality(&mut bytes, QUALITY).encode(image, width, height, rgb),
            "jpeg",
        )
    };
    encoded.map_err(|error| Error::write(Path::new("a picture"), io::Error::other(error)))?;
    let data = format!("data:image/{kind};base64,{}", STANDARD.encode(bytes));
    Ok(Picture { size: [width, height], data })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::Photograph;
    use crate::image::Image;

    #[test]
    fn errors_are_what_they_should_be() {
        let truth = [[0, 0, 0], [10, 20, 30], [255; 3], [9; 3]];
        let rendered = [[0, 0, 0], [13, 20, 24], [0; 3], [19; 3]];
        let valid = [true, true, true, false];
        assert_eq!(error_levels(&truth, &rendered, Some(&valid)), [0, 15, 255, 0]);
        assert_eq!(error_levels(&truth, &rendered, None)[3], 50);
        let brightness =
            |level| error_color(level).iter().map(|&value| u32::from(value)).sum::<u32>();
        assert!(
            (1..=10)
                .all(|at| brightness(f64::from(at) / 10.0) > brightness(f64::from(at - 1) / 10.0))
        );
    }

    #[test]
    fn pictures_are_no_larger_than_the_page_allows() {
        // noise does not compress
        let mut state = 1_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let size = [1000, 700];
        let pixels = (0..size[0] * size[1]).map(|_| [noise(), noise(), noise()]).collect();
        let truth = Photograph::new(size, pixels, None).unwrap();
        let view = |name: &str| ReportView {
            name: name.to_owned(),
            truth: &truth,
            rendered: Image::new(size[0], size[1]).unwrap(),
            psnr: None,
            ssim: None,
        };
        let found = pictures(&[view("a")]).unwrap();
        assert_eq!(found[0][0].size, [800, 560]);
        let many: Vec<_> = (0..8).map(|_| view("a")).collect();
        let found = pictures(&many).unwrap();
        let bytes: usize = found.iter().flatten().map(|picture| picture.data.len()).sum();
        assert!(bytes <= MOST_BYTES, "{bytes}");
        let other = ReportView { rendered: Image::new(3, 700).unwrap(), ..view("b \"") };
        let text = pictures(&[other]).unwrap_err().to_string();
        assert!(text.contains("view b \""), "{text}");
    }
}
