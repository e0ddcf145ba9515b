//! Makes films of frames: MP4 through ffmpeg, or an animated PNG.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread;

use serde::{Deserialize, Serialize};

use organza_core::error::{invalid, refuse};
use organza_core::{Error, Result, write_atomic};

/// The format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FilmKind {
    /// H.264, encoded by ffmpeg.
    Mp4,
    /// An animated PNG.
    Png,
    /// A folder of frames.
    Frames,
}

/// The frames of a film.
pub struct Frames<'a> {
    /// PNG images of one size.
    pub files: &'a [PathBuf],
    /// Frames per second.
    pub fps: u32,
    /// A folder for unfinished files.
    pub scratch: &'a Path,
    /// Called after each frame.
    pub progress: &'a dyn Fn(),
}

impl FilmKind {
    /// The format for a path, by its extension. A path without one, or of a folder, means a folder of frames.
    ///
    /// # Errors
    /// [`Error::Invalid`] for another extension.
    pub fn from_path(output: &Path) -> Result<Self> {
        let extension = output.extension().map(OsStr::to_ascii_lowercase);
        match extension.as_deref().and_then(OsStr::to_str) {
            _ if output.is_dir() => Ok(Self::Frames),
            Some("mp4") => Ok(Self::Mp4),
            Some("png" | "apng") => Ok(Self::Png),
            None if extension.is_none() => Ok(Self::Frames),
            _ => {
                let output = output.display();
                refuse(format!(
                    "{output}: a film is written as .mp4, as .png (animated), or to a folder, frame by frame"
                ))
            }
        }
    }

    /// Fails early if the film could not be written after hours of rendering.
    ///
    /// # Errors
    /// [`Error::Invalid`] for an MP4 with odd sides, or without ffmpeg.
    pub fn check(self, size: [u32; 2]) -> Result<()> {
        if self != Self::Mp4 {
            return Ok(());
        }
        let [width, height] = size;
        if !(width.is_multiple_of(2) && height.is_multiple_of(2)) {
            return refuse(format!(
                "an MP4 needs an even width and an even height, not {width}x{height}; give another `--size`"
            ));
        }
        let found = Command::new("ffmpeg").arg("-version").stdin(Stdio::null()).output();
        match found {
            Ok(output) if output.status.success() => Ok(()),
            Ok(output) => refuse(format!("`ffmpeg -version` fails: {}", output.status)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => refuse(
                "an MP4 needs the program ffmpeg, which is not installed; install it, or write an animated PNG \
                 (`-o film.png`) or a folder of frames (`-o film`)",
            ),
            Err(error) => refuse(format!("cannot run ffmpeg: {error}")),
        }
    }

    /// Writes the film.
    ///
    /// # Errors
    /// [`Error::ReadFile`] for a frame; [`Error::WriteFile`]; [`Error::Invalid`] with ffmpeg's message.
    pub fn write(self, frames: &Frames<'_>, output: &Path) -> Result<()> {
        match self {
            Self::Mp4 => mp4(frames, output),
            Self::Png => animated_png(frames, output),
            Self::Frames => Ok(()),
        }
    }
}

/// Writes an MP4. ffmpeg seeks in its output, so it gets a file of its own.
fn mp4(frames: &Frames<'_>, output: &Path) -> Result<()> {
    let Frames { fps, scratch, .. } = *frames;
    let beside = tempfile::Builder::new().prefix(".organza-").suffix(".tmp").tempfile_in(scratch);
    let beside = beside.map_err(|source| Error::write(scratch, source))?;
    let path = std::path::absolute(beside.path()).map_err(|source| Error::read(scratch, source))?;
    let mut child = match ffmpeg(fps, &path).spawn() {
        Ok(child) => child,
        Err(error) => return refuse(format!("cannot run ffmpeg: {error}")),
    };
    let mut stderr = child.stderr.take().expect("it is piped");
    let said = thread::spawn(move || {
        let mut text = Vec::new();
        let _ = stderr.read_to_end(&mut text);
        String::from_utf8_lossy(&text).into_owned()
    });
    let fed = feed(&mut child, frames);
    let status = child.wait();
    let said = said.join().unwrap_or_default();
    match status {
        // if ffmpeg has failed, its own message says more than a broken pipe
        Ok(status) if !status.success() && !matches!(fed, Err(Error::ReadFile { .. })) => {
            let last = said.lines().rev().find(|line| !line.trim().is_empty());
            return refuse(format!("ffmpeg ended with {status}: {}", last.unwrap_or("no message")));
        }
        Ok(_) => fed?,
        Err(error) => return refuse(format!("cannot wait for ffmpeg: {error}")),
    }
    let mut film = File::open(&path).map_err(|source| Error::read(&path, source))?;
    write_atomic(output, |writer| io::copy(&mut film, writer).map(drop))
}

/// H.264 for every player: 4:2:0, with the color matrix of HD written in the file.
fn ffmpeg(fps: u32, output: &Path) -> Command {
    let mut command = Command::new("ffmpeg");
    command
        .args(["-hide_banner", "-loglevel", "error", "-nostdin"])
        .args(["-f", "image2pipe", "-c:v", "png", "-framerate", &fps.to_string(), "-i", "pipe:0"])
        .args(["-vf", "scale=out_color_matrix=bt709,format=yuv420p"])
        .args(["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"])
        .args(["-c:v", "libx264", "-preset", "medium", "-crf", "17"])
        .args(["-movflags", "+faststart", "-f", "mp4", "-y"])
        .arg(output)
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped());
    command
}

fn feed(child: &mut Child, frames: &Frames<'_>) -> Result<()> {
    let mut pipe = child.stdin.take().expect("it is piped");
    for frame in frames.files {
        let bytes = fs::read(frame).map_err(|error| Error::read(frame, error))?;
        let sent = pipe.write_all(&bytes);
        sent.or_else(|error| refuse(format!("cannot send frames to ffmpeg: {error}")))?;
        (frames.progress)();
    }
    Ok(())
}

fn animated_png(frames: &Frames<'_>, output: &Path) -> Result<()> {
    let Frames { files, fps, progress, .. } = *frames;
    let pixels = |frame: &PathBuf| match ::image::open(frame) {
        Ok(image) => Ok(image.into_rgb8()),
        Err(error) => invalid(frame, format!("the frame cannot be read again: {error}")),
    };
    let (width, height) = pixels(&files[0])?.dimensions();
    // an error about a frame is not an error of writing
    let mut failed = None;
    let written = write_atomic(output, |writer| {
        let mut encoder = png::Encoder::new(writer, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        // 0 plays means forever
        encoder.set_animated(files.len() as u32, 0)?;
        encoder.set_frame_delay(1, fps as u16)?;
        let mut writer = encoder.write_header()?;
        for frame in files {
            match pixels(frame) {
                Ok(pixels) => writer.write_image_data(&pixels)?,
                Err(error) => {
                    failed = Some(error);
                    return Err(io::ErrorKind::InvalidData.into());
                }
            }
            progress();
        }
        Ok(writer.finish()?)
    });
    failed.map_or(written, Err)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_extension_chooses_the_format() {
        let kind = |name: &str| FilmKind::from_path(Path::new(name)).ok();
        assert_eq!(kind("a/film.mp4"), Some(FilmKind::Mp4));
        assert_eq!(kind("film.MP4"), Some(FilmKind::Mp4));
        assert_eq!(kind("film.png"), Some(FilmKind::Png));
        assert_eq!(kind("film.apng"), Some(FilmKind::Png));
        assert_eq!(kind("frames"), Some(FilmKind::Frames));
        assert_eq!(kind("."), Some(FilmKind::Frames));
        assert_eq!((kind("film.avi"), kind("film.")), (None, None));
    }
}
