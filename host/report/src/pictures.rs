//! A run's folder `pictures`: small JPEG files of held-out views, for the report.
//!
//! `view-1-photograph.jpg` is the first view's photograph, `view-1-step-000500.jpg` its rendered image after 500
//! steps, and `view-1-error-000500.jpg` its error. Only the last evaluation's are kept. `over-time-000500.jpg`
//! stays: a thumbnail of the first view after each evaluation.

use std::fs;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};

use ::image::imageops::{self, FilterType};
use ::image::{GrayImage, ImageBuffer, ImageFormat, ImageReader, RgbImage};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::MAX_VIEWS;
use organza_core::error::argument;
use organza_core::input::read_file;
use organza_core::metrics::error_levels;
use organza_core::{Error, Image, Result, remove_leftovers, write_inside};
use organza_data::{Photograph, encode_jpeg};
use organza_train::PICTURES;

/// JPEG quality, out of 100.
const QUALITY: u8 = 88;
/// Sizes of a view's pictures: the longer side in pixels. The largest is used with which they take at most
/// [`VIEW_BYTES`] together.
const SIDES: [u32; 4] = [800, 560, 400, 280];
const VIEW_BYTES: usize = 768 << 10;
/// Longer side of a thumbnail, in pixels.
const THUMBNAIL: u32 = 320;
/// Largest picture file, in bytes. A larger file was not written by this program.
const MAX_BYTES: u64 = 4 << 20;

/// The pictures in a run's folder.
#[derive(Clone, Debug)]
pub struct Pictures {
    folder: PathBuf,
}

/// The content of a view's picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    Photograph,
    /// The rendered image after this many steps.
    Rendered(u64),
    /// The error after this many steps.
    Error(u64),
}

/// A picture in the form that pages contain.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// A `data:` URL.
    pub data: String,
}

impl Pictures {
    /// The pictures of the run in a folder.
    pub fn from_run(folder: &Path) -> Self {
        Self { folder: folder.join(PICTURES) }
    }

    /// Creates the folder, and removes pictures of later steps than `step`.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn begin(&self, step: u64) -> Result<()> {
        let made = match fs::create_dir(&self.folder) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists => Err(error),
            _ => Ok(()),
        };
        made.map_err(|source| Error::write(&self.folder, source))?;
        remove_leftovers(&self.folder);
        self.remove(|name| step_of(name).is_some_and(|found| found > step));
        Ok(())
    }

    /// Writes the pictures of the view at `index`, rendered after `step` steps.
    ///
    /// # Errors
    /// [`Error::WriteFile`]; [`Error::Argument`] if the image does not have its photograph's size.
    pub fn write(&self, index: usize, step: u64, truth: &Photograph, image: &Image) -> Result<()> {
        if index == 0 {
            self.save(&thumbnail_name(step), &encode(&shrink(&rgb(image), THUMBNAIL))?)?;
        }
        if index >= MAX_VIEWS {
            return Ok(());
        }
        let [photograph, rendered, error] = encode_view(truth, image)?;
        self.save(&name(index, Content::Photograph), &photograph)?;
        self.save(&name(index, Content::Rendered(step)), &rendered)?;
        self.save(&name(index, Content::Error(step)), &error)
    }

    /// Writes the thumbnail of a view before the first step.
    ///
    /// # Errors
    /// [`Error::WriteFile`].
    pub fn write_first(&self, image: &Image) -> Result<()> {
        self.save(&thumbnail_name(0), &encode(&shrink(&rgb(image), THUMBNAIL))?)
    }

    /// Removes the views of all evaluations but the one after `step` steps. Thumbnails stay.
    pub fn keep(&self, step: u64) {
        self.remove(|name| name.starts_with("view-") && step_of(name).is_some_and(|at| at != step));
    }

    /// Reads a view's picture, if it exists.
    pub fn view(&self, index: usize, kind: Content) -> Option<Picture> {
        self.read(&name(index, kind))
    }

    /// Reads the thumbnail after `step` steps, if it exists.
    pub fn thumbnail(&self, step: u64) -> Option<Picture> {
        self.read(&thumbnail_name(step))
    }

    fn save(&self, name: &str, bytes: &[u8]) -> Result<()> {
        write_inside(self.folder.join(name), |writer| writer.write_all(bytes))
    }

    /// Reads a picture. If it is missing or invalid, the page leaves it out.
    fn read(&self, name: &str) -> Option<Picture> {
        let bytes = read_file(&self.folder.join(name), MAX_BYTES, "a picture").ok()?;
        let reader = ImageReader::with_format(Cursor::new(&bytes), ImageFormat::Jpeg);
        let (width, height) = reader.into_dimensions().ok()?;
        let data = format!("data:image/jpeg;base64,{}", STANDARD.encode(bytes));
        Some(Picture { size: [width, height], data })
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.folder).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok()).collect()
    }

    /// Removes pictures. Failures are ignored: pages show only what the log has.
    fn remove(&self, is_gone: impl Fn(&str) -> bool) {
        for name in self.names().iter().filter(|name| is_gone(name)) {
            let _ = fs::remove_file(self.folder.join(name));
        }
    }
}

fn thumbnail_name(step: u64) -> String {
    format!("over-time-{step:06}.jpg")
}

fn name(index: usize, kind: Content) -> String {
    let view = index + 1;
    match kind {
        Content::Photograph => format!("view-{view}-photograph.jpg"),
        Content::Rendered(step) => format!("view-{view}-step-{step:06}.jpg"),
        Content::Error(step) => format!("view-{view}-error-{step:06}.jpg"),
    }
}

/// The step in a file's name; `None` if the name has none, or is not one of ours.
fn step_of(name: &str) -> Option<u64> {
    let (_, step) = name.strip_suffix(".jpg")?.rsplit_once('-')?;
    let step = step.parse().ok()?;
    let is_ours = name == thumbnail_name(step)
        || (0..MAX_VIEWS).any(|index| {
            [Content::Rendered(step), Content::Error(step)]
                .iter()
                .any(|&kind| name == self::name(index, kind))
        });
    is_ours.then_some(step)
}

/// Photograph, rendered image and error of a view, each reduced to fit a page.
fn encode_view(truth: &Photograph, image: &Image) -> Result<[Vec<u8>; 3]> {
    let [width, height] = image.size();
    if [truth.width(), truth.height()] != [width, height] {
        return argument("a rendered image is not of its photograph's size");
    }
    let error = error_levels(truth.pixels(), image.pixels(), truth.valid());
    let photograph = truth.pixels().as_flattened().to_vec();
    let images = RgbImage::from_raw(width, height, photograph)
        .zip(GrayImage::from_raw(width, height, error));
    let (photograph, error) = images.expect("as many pixels as the size says");
    let rendered = rgb(image);
    let mut found = Default::default();
    for side in SIDES {
        // Errors are reduced as numbers, and colored afterwards.
        found = [
            encode(&shrink(&photograph, side))?,
            encode(&shrink(&rendered, side))?,
            encode(&colored(&shrink(&error, side)))?,
        ];
        if found.iter().map(Vec::len).sum::<usize>() <= VIEW_BYTES {
            break;
        }
    }
    Ok(found)
}

fn rgb(image: &Image) -> RgbImage {
    let [width, height] = image.size();
    let pixels = image.pixels().as_flattened().to_vec();
    RgbImage::from_raw(width, height, pixels).expect("as many pixels as the size says")
}

fn colored(levels: &GrayImage) -> RgbImage {
    let color = |&::image::Luma([level])| ::image::Rgb(error_color(f64::from(level) / 255.0));
    let mut image = RgbImage::new(levels.width(), levels.height());
    image.pixels_mut().zip(levels.pixels()).for_each(|(pixel, level)| *pixel = color(level));
    image
}

/// The color of an error from 0 to 1, with the factor included.
pub fn error_color(level: f64) -> [u8; 3] {
    colorous::INFERNO.eval_continuous(level.clamp(0.0, 1.0)).into_array()
}

/// Shrinks an image so that its longer side has at most `side` pixels.
fn shrink<P>(image: &ImageBuffer<P, Vec<u8>>, side: u32) -> ImageBuffer<P, Vec<u8>>
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

fn encode(image: &RgbImage) -> Result<Vec<u8>> {
    encode_jpeg(image.dimensions().into(), image.as_raw(), QUALITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn larger_errors_are_brighter() {
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
    fn pictures_are_no_larger_than_a_page_allows() {
        // noise does not compress
        let mut state = 1_u32;
        let mut noise = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        };
        let size = [1000, 700];
        let pixels = (0..size[0] * size[1]).map(|_| [noise(), noise(), noise()]).collect();
        let truth = Photograph::new(size, pixels, None).unwrap();
        let found = encode_view(&truth, &Image::new(size[0], size[1]).unwrap()).unwrap();
        let bytes: usize = found.iter().map(Vec::len).sum();
        assert!((100 << 10..=VIEW_BYTES).contains(&bytes), "{bytes}");
        encode_view(&truth, &Image::new(3, 700).unwrap()).unwrap_err();
    }

    #[test]
    fn only_our_names_have_steps() {
        for (name, step) in [
            ("over-time-000000.jpg", Some(0)),
            ("view-8-step-000500.jpg", Some(500)),
            ("view-1-error-1234567.jpg", Some(1_234_567)),
            ("view-1-photograph.jpg", None),
            ("view-1-step-500.jpg", None),
            ("view-9-step-000500.jpg", None),
            ("holiday-2024-000500.jpg", None),
        ] {
            assert_eq!(step_of(name), step, "{name}");
        }
    }

    #[test]
    fn a_resume_drops_later_pictures_and_an_evaluation_earlier_ones() {
        let folder = tempfile::tempdir().unwrap();
        let pictures = Pictures::from_run(folder.path());
        let image = Image::new(20, 10).unwrap();
        let truth = Photograph::from(&image);
        pictures.begin(0).unwrap();
        pictures.write_first(&image).unwrap();
        for step in [5, 10, 15] {
            pictures.write(0, step, &truth, &image).unwrap();
            pictures.write(1, step, &truth, &image).unwrap();
            pictures.keep(step);
        }
        let thumbnails =
            || -> Vec<u64> { (0..20).filter(|step| pictures.thumbnail(*step).is_some()).collect() };
        assert_eq!(thumbnails(), [0, 5, 10, 15]);
        assert!(pictures.view(1, Content::Rendered(10)).is_none());
        assert_eq!(pictures.view(1, Content::Error(15)).unwrap().size, [20, 10]);
        let other = folder.path().join(PICTURES).join("mine.jpg");
        fs::write(&other, "not a picture").unwrap();
        pictures.begin(12).unwrap();
        assert_eq!(thumbnails(), [0, 5, 10]);
        assert!(pictures.view(0, Content::Rendered(15)).is_none() && other.exists());
        assert!(pictures.view(0, Content::Photograph).is_some());
    }
}
