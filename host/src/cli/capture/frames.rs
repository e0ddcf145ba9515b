//! The images of a capture: the sharpest frames of a video, or photographs.

use std::collections::HashSet;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::slice;

use image::codecs::jpeg::JpegEncoder;
use image::metadata::Orientation;
use image::{
    DynamicImage, ImageDecoder, ImageEncoder, ImageError, ImageFormat, ImageReader, ImageResult,
};
use organza::data::Frame;
use organza::data::panorama::{self, FACES, HEADINGS, View, panorama_of};
use organza::{Camera, Error, Result};

use super::programs::command;
use super::{CaptureJob, Source};
use crate::cli::summary::count;
use crate::cli::{absolute, refuse};

/// Folder of the images, in the work.
pub const IMAGES: &str = "images";
/// Folder of the panoramas, in the work. COLMAP sees views of them in their place.
const PANORAMAS: &str = "panoramas";
/// JPEG quality of photographs that are turned, out of 100.
const QUALITY: u8 = 98;
/// Width and height at which frames are compared. The shape of a video does not matter for that.
const PROBE: [usize; 2] = [960, 540];

impl CaptureJob<'_> {
    /// Collects the images, and returns their names, sorted.
    pub fn images(&self, source: &Source<'_>) -> Result<Vec<String>> {
        self.step(IMAGES, |folder| {
            match source {
                Source::Video(video) => self.frames(video, folder)?,
                Source::Photographs(files) => self.copy_upright(files, folder)?,
            }
            self.cut_panoramas(folder)
        })?;
        names(&self.path(IMAGES))
    }

    /// Copies photographs. A camera that was held on its side says so in the file, which COLMAP does not read, so the pixels
    /// of such a photograph are turned.
    fn copy_upright(&self, files: &[PathBuf], folder: &Path) -> Result<()> {
        for file in files {
            self.programs.check()?;
            let to = folder.join(file.file_name().expect("a file has a name"));
            let is_turned = turn_upright(file, &to)
                .or_else(|error| refuse(format!("{}: {error}", file.display())))?;
            if !is_turned {
                copy(slice::from_ref(file), folder)?;
            }
        }
        Ok(())
    }

    /// Replaces panoramas by views that overlap, because COLMAP knows only lenses. A named lens says that there are none.
    fn cut_panoramas(&self, folder: &Path) -> Result<()> {
        let is_panorama = |name: &String| {
            let size = image::image_dimensions(folder.join(name));
            size.is_ok_and(|(width, height)| panorama::is_panorama([width, height]))
        };
        let mut names = names(folder)?;
        names.retain(is_panorama);
        if names.is_empty() || self.args.camera_model.is_some() {
            return Ok(());
        }
        let images = count(names.len() as u64, "image");
        self.console.note(&format!(
            "{images} twice as wide as high: cutting each, as a panorama of 360 degrees, into views. If a lens took them, name it \
             with `--camera-model`"
        ));
        let panoramas = self.path(PANORAMAS);
        fs::create_dir_all(&panoramas).map_err(|source| Error::write(&panoramas, source))?;
        for name in &names {
            let to = panoramas.join(name);
            fs::rename(folder.join(name), &to).map_err(|source| Error::write(&to, source))?;
        }
        self.cut(&names, folder, &HEADINGS)
    }

    /// Cuts panoramas into views.
    fn cut(&self, names: &[String], folder: &Path, views: &[View]) -> Result<()> {
        let progress = self.console.progress("cutting panoramas", names.len(), "panoramas");
        for (done, name) in names.iter().enumerate() {
            self.programs.check()?;
            let path = self.path(PANORAMAS).join(name);
            for Frame { name, image, .. } in panorama::cut(&path, self.args.side, views)? {
                let to = folder.join(name);
                let [width, height] = [image.width(), image.height()];
                let pixels = image.pixels().as_flattened();
                image::save_buffer(&to, pixels, width, height, image::ColorType::Rgb8)
                    .or_else(|error| refuse(format!("{}: {error}", to.display())))?;
            }
            progress.set(done + 1);
        }
        Ok(())
    }

    /// Cuts the panoramas of these views into the views to train on.
    pub fn cut_faces(&self, cameras: &[Camera], folder: &Path) -> Result<()> {
        let posed = cameras.iter().filter_map(|camera| camera.file_path.as_deref());
        let posed: HashSet<_> = posed.filter_map(|name| panorama_of(name, &FACES)).collect();
        let mut names = names(&self.path(PANORAMAS))?;
        names.retain(|name| posed.contains(panorama::stem(name)));
        self.cut(&names, folder, &FACES)
    }

    /// Writes the sharpest frame of each of N equal parts of a video.
    fn frames(&self, video: &Path, folder: &Path) -> Result<()> {
        let mut sharpness = Vec::new();
        self.console.during("looking for sharp frames", || {
            let [width, height] = PROBE;
            let mut ffmpeg = ffmpeg(video);
            ffmpeg.arg("-vf").arg(format!("scale={width}:{height}"));
            ffmpeg.args(["-vsync", "passthrough", "-pix_fmt", "gray", "-f", "rawvideo", "-"]);
            self.programs
                .read(ffmpeg, width * height, |gray| sharpness.push(sharpness_of(gray, width)))
                .or_else(|error| refuse(format!("{error}. Is {} a video?", video.display())))
        })?;
        let chosen = sharpest(&sharpness, self.args.frames as usize);
        if chosen.len() < 3 {
            let frames = count(sharpness.len() as u64, "frame");
            return refuse(format!("{} has {frames}, expected 3 or more", video.display()));
        }
        let all = sharpness.len();
        self.console.note(&format!("taking the {} sharpest of {all} frames", chosen.len()));
        let select: Vec<_> = chosen.iter().map(|frame| format!("eq(n,{frame})")).collect();
        let side = self.args.side;
        // A panorama's view has a 3.14th part of its columns.
        let wide = if self.args.camera_model.is_some() { side } else { side * 22 / 7 };
        // Pixels of a video may not be square, and those of its frames are.
        let most = format!("if(eq(iw,2*ih),{wide},{side})");
        let scale = format!(
            "scale='iw*sar':ih,scale='min(iw,{most})':'min(ih,{most})':force_original_aspect_ratio=decrease"
        );
        let mut ffmpeg = ffmpeg(video);
        ffmpeg.arg("-vf").arg(format!("select='{}',{scale}", select.join("+")));
        ffmpeg.args(["-vsync", "passthrough"]).arg(folder.join("%05d.png"));
        self.console.during("writing frames", || self.programs.run(ffmpeg, |_| {}))?;
        // ffmpeg counts what it writes. A name says which frame of the video it is.
        for (written, frame) in chosen.iter().enumerate() {
            let from = folder.join(format!("{:05}.png", written + 1));
            let to = folder.join(format!("frame-{frame:06}.png"));
            fs::rename(&from, &to).map_err(|source| Error::write(&to, source))?;
        }
        Ok(())
    }
}

/// Writes a JPEG file that is to be shown turned with its pixels turned instead; `false` if it is not to be turned. The rest
/// of what the camera wrote, such as the focal length, stays.
fn turn_upright(from: &Path, to: &Path) -> ImageResult<bool> {
    let reader = ImageReader::open(from)?.with_guessed_format()?;
    if reader.format() != Some(ImageFormat::Jpeg) {
        return Ok(false);
    }
    let mut decoder = reader.into_decoder()?;
    let orientation = decoder.orientation()?;
    if orientation == Orientation::NoTransforms {
        return Ok(false);
    }
    let mut exif = decoder.exif_metadata()?.unwrap_or_default();
    let mut image = DynamicImage::from_decoder(decoder)?;
    image.apply_orientation(orientation);
    let _ = Orientation::remove_from_exif_chunk(&mut exif);
    let mut encoder = JpegEncoder::new_with_quality(BufWriter::new(File::create(to)?), QUALITY);
    encoder.set_exif_metadata(exif).map_err(ImageError::Unsupported)?;
    image.write_with_encoder(encoder)?;
    Ok(true)
}

/// ffmpeg, reading the first stream of a video.
fn ffmpeg(video: &Path) -> Command {
    let mut ffmpeg = command("ffmpeg");
    // A name such as `-x` or `http:x` is a file's, too.
    let mut name = OsString::from("file:");
    name.push(absolute(video));
    ffmpeg.args(["-v", "error", "-nostdin", "-y", "-i"]).arg(name).args(["-map", "0:v:0"]);
    ffmpeg
}

/// How sharp a gray image is: the variance of its Laplacian. Pech-Pacheco et al., "Diatom autofocusing in brightfield
/// microscopy" (2000).
fn sharpness_of(gray: &[u8], width: usize) -> f64 {
    let at = |place: usize| f64::from(gray[place]);
    let height = gray.len() / width;
    let mut sum = 0.0;
    let mut squares = 0.0;
    for row in 1..height - 1 {
        for place in row * width + 1..(row + 1) * width - 1 {
            let neighbors = at(place - 1) + at(place + 1) + at(place - width) + at(place + width);
            let laplacian = neighbors - 4.0 * at(place);
            sum += laplacian;
            squares += laplacian * laplacian;
        }
    }
    let count = ((height - 2) * (width - 2)) as f64;
    squares / count - (sum / count).powi(2)
}

/// The sharpest frame of each of `count` equal parts of a video, in order; all frames if there are fewer.
fn sharpest(sharpness: &[f64], count: usize) -> Vec<usize> {
    let frames = sharpness.len();
    let count = count.min(frames);
    (0..count)
        .map(|part| {
            let part = part * frames / count..(part + 1) * frames / count;
            part.max_by(|a, b| sharpness[*a].total_cmp(&sharpness[*b])).expect("a part has a frame")
        })
        .collect()
}

/// The names of the files in a folder, sorted.
fn names(folder: &Path) -> Result<Vec<String>> {
    let entries = fs::read_dir(folder).map_err(|source| Error::read(folder, source))?;
    let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<_> = names.collect();
    names.sort();
    Ok(names)
}

/// Copies files, so that the data set needs no other folder.
pub fn copy(files: &[PathBuf], folder: &Path) -> Result<()> {
    for file in files {
        let to = folder.join(file.file_name().expect("a file has a name"));
        fs::copy(file, &to).map_err(|source| Error::read(file, source))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_of_a_video_gives_its_sharpest_frame() {
        let sharpness = [1.0, 3.0, 2.0, 9.0, 8.0, 7.0, 0.5];
        assert_eq!(sharpest(&sharpness, 3), [1, 3, 4]);
        assert_eq!(sharpest(&sharpness, 7), [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(sharpest(&sharpness, 90), [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(sharpest(&[], 3), [0_usize; 0]);
    }

    #[test]
    fn blur_lowers_sharpness() {
        let width = 40;
        let stripes: Vec<u8> = (0..width * 30).map(|at| 200 * (at % width / 2 % 2) as u8).collect();
        let blurred: Vec<u8> = (0..stripes.len())
            .map(|at| {
                let near = stripes[at.saturating_sub(2)..(at + 3).min(stripes.len())].iter();
                (near.map(|&value| u32::from(value)).sum::<u32>() / 5) as u8
            })
            .collect();
        assert_eq!(sharpness_of(&vec![77; width * 30], width), 0.0);
        assert!(sharpness_of(&stripes, width) > 4.0 * sharpness_of(&blurred, width));
    }
}
