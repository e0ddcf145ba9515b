//! The images of a capture: the sharpest frames of a video, or photographs.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use organza::data::{panorama, photograph_size, upright};
use organza::{Error, Result};

use super::CaptureJob;
use super::programs::{command, output};
use super::source::{Photograph, Source, sort_naturally};
use crate::cli::summary::count;
use crate::cli::{absolute, refuse};

/// Folder of the images, in the work.
pub const IMAGES: &str = "images";
/// Width and height at which frames are compared. The shape of a video does not matter for that.
const PROBE: [usize; 2] = [960, 540];
/// Transfer functions of videos with a high dynamic range, as ffmpeg names them, and for people.
const HDR: [[&str; 2]; 2] = [["arib-std-b67", "HLG"], ["smpte2084", "PQ"]];
/// Maps these to the colors of screens. White, which shows 203 candelas per square meter (ITU-R BT.2408), stays below 1, and
/// what shines more is compressed.
const TO_SDR: &str = "zscale=t=linear:npl=203,format=gbrpf32le,zscale=p=bt709,tonemap=mobius:desat=0,\
                      zscale=t=bt709:m=bt709:r=full,format=gbrp,";

/// What one look at a video tells.
#[derive(Default)]
struct VideoStats {
    /// How sharp each frame is.
    sharpness: Vec<f64>,
    /// The shape of each frame.
    shapes: Vec<Shape>,
    /// The transfer function, as ffmpeg names it.
    transfer: Option<String>,
}

/// A frame's width and height in pixels, and the shape of a pixel: its width by its height.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Shape {
    size: [u32; 2],
    pixel: [u32; 2],
}

impl CaptureJob<'_> {
    /// Collects the images, and returns their names, in their natural order. COLMAP knows only lenses.
    pub fn images(&self, source: &Source<'_>) -> Result<Vec<String>> {
        self.step(IMAGES, |folder| match source {
            Source::Video(video) => self.frames(video, folder),
            Source::Photographs(photographs) => self.copy_upright(photographs, folder),
        })?;
        let folder = self.path(IMAGES);
        let names = names(&folder)?;
        let is_panorama =
            |name: &&String| photograph_size(&folder.join(name)).is_ok_and(panorama::is_panorama);
        let panoramas = names.iter().filter(is_panorama).count();
        if panoramas > 0 && self.args.camera_model.is_none() {
            self.console.warn(&format!(
                "{} twice as wide as high: cut panoramas of 360 degrees into flat views first",
                count(panoramas as u64, "image")
            ));
        }
        Ok(names)
    }

    /// Copies photographs, each of which is checked as training checks it. A camera that was held on its side says so in the
    /// file, which COLMAP does not read, so the pixels of such a photograph are turned.
    fn copy_upright(&self, photographs: &[Photograph], folder: &Path) -> Result<()> {
        for Photograph { path, name, .. } in photographs {
            self.programs.check()?;
            let to = folder.join(name);
            match upright(path)? {
                Some(turned) => fs::write(&to, turned),
                None => fs::copy(path, &to).map(drop),
            }
            .map_err(|source| Error::write(&to, source))?;
        }
        Ok(())
    }

    /// Writes the sharpest frame of each of N equal parts of a video.
    fn frames(&self, video: &Path, folder: &Path) -> Result<()> {
        let seen = self.look(video)?;
        let all = seen.sharpness.len();
        let Some(shape) = usual(&seen.shapes) else {
            return refuse(format!("{} has no frames, expected 3 or more", video.display()));
        };
        let is_usual = |at: &usize| seen.shapes.get(*at).is_none_or(|other| *other == shape);
        let usual: Vec<_> = (0..all).filter(is_usual).collect();
        if usual.len() < all {
            let [width, height] = shape.size;
            self.console.warn(&format!(
                "the frames of {} change their size: {width} x {height} pixels are used, and {} of {all} are left out",
                video.display(),
                all - usual.len()
            ));
        }
        let sharpness: Vec<_> = usual.iter().map(|&at| seen.sharpness[at]).collect();
        let chosen = sharpest(&sharpness, self.args.frames as usize);
        let chosen: Vec<_> = chosen.into_iter().map(|at| usual[at]).collect();
        if chosen.len() < 3 {
            let frames = count(usual.len() as u64, "frame");
            return refuse(format!("{} has {frames}, expected 3 or more", video.display()));
        }
        self.console.note(&format!("taking the {} sharpest of {all} frames", chosen.len()));
        let select: Vec<_> = chosen.iter().map(|frame| format!("eq(n,{frame})")).collect();
        let colors = self.colors(video, seen.transfer.as_deref())?;
        let [width, height] = shape.fit(self.args.side);
        let mut ffmpeg = ffmpeg(video, "error");
        let filters = format!("select='{}',{colors}scale={width}:{height}", select.join("+"));
        ffmpeg.arg("-vf").arg(filters).args(["-fps_mode", "passthrough"]);
        // a folder's own name may have a percent sign
        ffmpeg.current_dir(folder).arg("%05d.png");
        self.console.during("writing frames", || self.programs.run(ffmpeg, |_| {}))?;
        // ffmpeg counts what it writes. A name says which frame of the video it is.
        for (written, frame) in chosen.iter().enumerate() {
            let from = folder.join(format!("{:05}.png", written + 1));
            let to = folder.join(format!("frame-{frame:06}.png"));
            fs::rename(&from, &to).map_err(|source| Error::write(&to, source))?;
        }
        Ok(())
    }

    /// Looks at each frame of a video.
    fn look(&self, video: &Path) -> Result<VideoStats> {
        let [width, height] = PROBE;
        let mut ffmpeg = ffmpeg(video, "level+info");
        ffmpeg.arg("-vf").arg(format!("showinfo=checksum=0,scale={width}:{height}"));
        ffmpeg.args(["-fps_mode", "passthrough", "-pix_fmt", "gray", "-f", "rawvideo", "-"]);
        let VideoStats { mut sharpness, mut shapes, mut transfer } = VideoStats::default();
        let look = |gray: &[u8]| sharpness.push(sharpness_of(gray, width));
        let hear = |line: &str| {
            if line.contains("_showinfo_") {
                shapes.extend(Shape::of(line));
                transfer = transfer.take().or_else(|| word(line, "color_trc:").map(str::to_owned));
            }
        };
        self.console.during("looking for sharp frames", || {
            self.programs
                .read(ffmpeg, width * height, look, hear)
                .or_else(|error| refuse(format!("{error}. Is {} a video?", video.display())))
        })?;
        Ok(VideoStats { sharpness, shapes, transfer })
    }

    /// The filter that maps a video's colors to a screen's, if it has others.
    fn colors(&self, video: &Path, transfer: Option<&str>) -> Result<&'static str> {
        let Some([_, name]) = HDR.iter().find(|[known, _]| Some(*known) == transfer) else {
            return Ok("");
        };
        let help = output(command("ffmpeg").args(["-hide_banner", "-h", "filter=zscale"]))?;
        if help.contains("Filter zscale") {
            self.console.note(&format!("mapping the colors of {name} to a screen's"));
            return Ok(TO_SDR);
        }
        self.console.warn(&format!(
            "{} has colors of {name}, and this ffmpeg has no filter `zscale`, which maps them to a screen's: images will \
             look pale. Install an ffmpeg with zimg, or film without HDR",
            video.display()
        ));
        Ok("")
    }
}

/// ffmpeg, 5.1 or later, reading the first stream of a video that is no cover picture. It prints messages of one level.
fn ffmpeg(video: &Path, level: &str) -> Command {
    let mut ffmpeg = command("ffmpeg");
    // A name such as `-x` or `http:x` is a file's, too.
    let mut name = OsString::from("file:");
    name.push(absolute(video));
    ffmpeg.args(["-v", level, "-hide_banner", "-nostats", "-nostdin", "-y"]);
    // A filter that begins again where the size changes would count frames from 0.
    ffmpeg.args(["-reinit_filter", "0", "-i"]).arg(name).args(["-map", "0:V:0"]);
    ffmpeg
}

impl Shape {
    /// The shape in a line of ffmpeg's filter `showinfo`: `n:   0 pts: 0 sar:1/1 s:640x360 i:P`.
    fn of(line: &str) -> Option<Self> {
        let pair = |text: &str, between: char| {
            let (a, b) = text.split_once(between)?;
            Some([a.parse().ok()?, b.parse().ok()?])
        };
        let size = pair(word(line, "s:")?, 'x')?;
        let pixel = word(line, "sar:").and_then(|shape| pair(shape, '/'));
        // 0/1 is unknown
        Some(Self { size, pixel: pixel.filter(|pixel| !pixel.contains(&0)).unwrap_or([1, 1]) })
    }

    /// The size with square pixels and at most `side` of them a side.
    fn fit(self, side: u32) -> [u32; 2] {
        let [width, height] = self.size.map(f64::from);
        let [wide, high] = self.pixel.map(f64::from);
        let size = [width * wide / high, height];
        let factor = (f64::from(side) / size[0].max(size[1])).min(1.0);
        size.map(|side| (side * factor).round().max(1.0) as u32)
    }
}

/// The rest of the word that begins so.
fn word<'l>(line: &'l str, begin: &str) -> Option<&'l str> {
    line.split_whitespace().find_map(|word| word.strip_prefix(begin))
}

/// The shape of most frames, of which the first is first; `None` without frames.
fn usual(shapes: &[Shape]) -> Option<Shape> {
    let mut counts: Vec<(Shape, usize)> = Vec::new();
    for &shape in shapes {
        match counts.iter_mut().find(|(known, _)| *known == shape) {
            Some((_, count)) => *count += 1,
            None => counts.push((shape, 1)),
        }
    }
    counts.into_iter().rev().max_by_key(|(_, count)| *count).map(|(shape, _)| shape)
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

/// The names of the files in a folder, in their natural order.
fn names(folder: &Path) -> Result<Vec<String>> {
    let entries = fs::read_dir(folder).map_err(|source| Error::read(folder, source))?;
    let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut names: Vec<_> = names.collect();
    sort_naturally(&mut names, |name| name.clone());
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
    fn frames_have_square_pixels_and_fit() {
        let line = "[Parsed_showinfo_0 @ 0x1] [info] n:   0 pts:      0 pts_time:0 fmt:yuv420p sar:4/3 s:240x180 i:P iskey:1";
        let shape = Shape::of(line).unwrap();
        assert_eq!(shape, Shape { size: [240, 180], pixel: [4, 3] });
        assert_eq!(shape.fit(1920), [320, 180]);
        assert_eq!(shape.fit(160), [160, 90]);
        let of = |line: &str| Shape::of(line).unwrap();
        assert_eq!(of("sar:0/1 s:1600x800").fit(301), [301, 151]);
        assert_eq!(Shape::of("color_range:tv color_trc:arib-std-b67"), None);
        let [wide, high] = [of("s:64x36"), of("s:36x64")];
        assert_eq!(usual(&[wide, high, high]), Some(high));
        assert_eq!(usual(&[wide, high]), Some(wide));
        assert_eq!(usual(&[]), None);
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
