//! Writes films: MP4 through ffmpeg, an animated PNG, or a folder of frames.

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread;

use organza::{Error, Image, Result};
use organza_core::write_atomic;

use crate::cli::output::Folder;
use crate::cli::refuse;

/// The format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmKind {
    /// H.264, encoded by ffmpeg.
    Mp4,
    /// An animated PNG.
    Png,
    /// A folder of frames.
    Frames,
}

impl FilmKind {
    /// The format for a path, by its extension. A path without one, or of a folder, means a folder of frames.
    ///
    /// # Errors
    /// For another extension.
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

    /// Fails early if the film could not be written after hours of rendering: for an MP4 with odd sides, or without ffmpeg.
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
        match Command::new("ffmpeg").arg("-version").stdin(Stdio::null()).output() {
            Ok(_) => Ok(()),
            Err(error) if error.kind() == io::ErrorKind::NotFound => refuse(
                "an MP4 needs the program ffmpeg, which is not installed; install it, or write an animated PNG \
                 (`-o film.png`) or a folder of frames (`-o film`)",
            ),
            Err(error) => refuse(format!("cannot run ffmpeg: {error}")),
        }
    }
}

/// Writes each frame to a folder.
pub fn write_folder(folder: &Folder, frames: impl Iterator<Item = Result<Image>>) -> Result<()> {
    for (index, frame) in frames.enumerate() {
        frame?.save_png(folder.file(&format!("{index:05}.png"))?)?;
    }
    Ok(())
}

/// Writes an MP4 when all its frames are there. ffmpeg seeks in its output, so it gets a file of its own beside it.
pub fn write_mp4(
    output: &Path,
    fps: u32,
    frames: impl Iterator<Item = Result<Image>>,
) -> Result<()> {
    let failed = |source| Error::write(output, source);
    let folder = std::path::absolute(output).map_err(failed)?;
    let folder = folder.parent().unwrap_or(&folder);
    let beside = tempfile::Builder::new().prefix(".organza-").suffix(".tmp").tempfile_in(folder);
    let beside = beside.map_err(failed)?.into_temp_path();
    let mut child = match ffmpeg(fps, &beside).spawn() {
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
    match (status, fed) {
        (Err(error), _) => return refuse(format!("cannot wait for ffmpeg: {error}")),
        (Ok(_), Err(Fed::Frame(error))) => return Err(error),
        // ffmpeg's own message says more than a broken pipe
        (Ok(status), _) if !status.success() => {
            let last = said.lines().rev().find(|line| !line.trim().is_empty());
            return refuse(format!("ffmpeg ended with {status}: {}", last.unwrap_or("no message")));
        }
        (Ok(_), Err(Fed::Pipe(error))) => {
            return refuse(format!("cannot send frames to ffmpeg: {error}"));
        }
        (Ok(_), Ok(())) => {}
    }
    let mut film = File::open(&beside).map_err(|source| Error::read(&beside, source))?;
    write_atomic(output, |writer| io::copy(&mut film, writer).map(drop))
}

/// Why ffmpeg did not get all frames.
enum Fed {
    Frame(Error),
    Pipe(io::Error),
}

fn feed(child: &mut Child, frames: impl Iterator<Item = Result<Image>>) -> Result<(), Fed> {
    let mut pipe = child.stdin.take().expect("it is piped");
    for frame in frames {
        let png = frame.map_err(Fed::Frame)?.encode_png().map_err(Fed::Pipe)?;
        pipe.write_all(&png).map_err(Fed::Pipe)?;
    }
    Ok(())
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

/// Writes an animated PNG when all its frames are there.
pub fn write_animated_png(
    output: &Path,
    [width, height]: [u32; 2],
    fps: u32,
    frames: impl ExactSizeIterator<Item = Result<Image>>,
) -> Result<()> {
    // an error about a frame is not an error of writing
    let mut failed = None;
    let written = write_atomic(output, |writer| {
        let mut encoder = png::Encoder::new(writer, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        // 0 plays means forever
        encoder.set_animated(frames.len() as u32, 0)?;
        encoder.set_frame_delay(1, fps as u16)?;
        let mut writer = encoder.write_header()?;
        for frame in frames {
            match frame {
                Ok(image) => writer.write_image_data(image.pixels().as_flattened())?,
                Err(error) => {
                    failed = Some(error);
                    return Err(io::ErrorKind::InvalidData.into());
                }
            }
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
