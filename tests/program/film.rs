//! Films: their frames, their files, and interruptions.

use std::fs;
use std::io::BufReader;

use image::{AnimationDecoder, RgbImage};

use crate::sandbox::{Outcome, Sandbox};

const FILM: &str = "film scene.safetensors cameras.json --backend cpu";

fn pixels(sandbox: &Sandbox, name: &str) -> RgbImage {
    image::open(sandbox.path(name)).unwrap_or_else(|error| panic!("{name}: {error}")).into_rgb8()
}

/// The largest difference of two images, in 8-bit levels.
fn difference(a: &RgbImage, b: &RgbImage) -> u8 {
    assert_eq!(a.dimensions(), b.dimensions());
    a.iter().zip(b.iter()).map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

#[test]
fn a_film_begins_and_ends_at_its_keys() {
    let sandbox = Sandbox::new("tiny");
    sandbox.run("render scene.safetensors cameras.json -o images --backend cpu").assert_ok();
    sandbox.run(&format!("{FILM} -o frames --frames 3")).assert_ok();
    let key = |name: &str| pixels(&sandbox, &format!("images/{name}"));
    let frame = |name: &str| pixels(&sandbox, &format!("frames/{name}"));
    // a pose is converted to a quaternion and back
    assert!(difference(&key("0000.png"), &frame("00000.png")) <= 1);
    assert!(difference(&key("0001.png"), &frame("00002.png")) <= 1);
    assert!(difference(&frame("00000.png"), &frame("00001.png")) > 10);
    // in reverse order, and back to the start
    sandbox.run(&format!("{FILM} -o loop --frames 2 --views 1,0 --loop")).assert_ok();
    let frame = |name: &str| pixels(&sandbox, &format!("loop/{name}"));
    assert!(difference(&key("0001.png"), &frame("00000.png")) <= 1);
    assert!(difference(&key("0000.png"), &frame("00001.png")) <= 1);
}

#[test]
fn an_animated_png_has_the_frames_and_their_pace() {
    let sandbox = Sandbox::new("tiny");
    let orbit = "film scene.safetensors --backend cpu --frames 3 --size 40x33";
    sandbox.run(&format!("{orbit} -o frames")).assert_ok();
    let made = sandbox.run(&format!("{orbit} --fps 20 -o film.png --json")).json();
    assert_eq!((&made["frames"], &made["fps"]), (&3.into(), &20.into()));
    let file = BufReader::new(fs::File::open(sandbox.path("film.png")).unwrap());
    let decoder = image::codecs::png::PngDecoder::new(file).unwrap().apng().unwrap();
    let frames = decoder.into_frames().collect_frames().unwrap();
    assert_eq!(frames.len(), 3);
    for (index, frame) in frames.iter().enumerate() {
        assert_eq!(frame.delay().numer_denom_ms(), (50, 1));
        let expected = pixels(&sandbox, &format!("frames/{index:05}.png"));
        let found = image::DynamicImage::from(frame.buffer().clone()).into_rgb8();
        assert_eq!(difference(&found, &expected), 0);
    }
}

#[test]
fn bad_options_are_refused_at_once() {
    let sandbox = Sandbox::new("tiny");
    let scene = "film scene.safetensors --backend cpu";
    for (words, facts) in [
        (format!("{FILM} -o film.avi"), ["film.avi", ".mp4"]),
        (format!("{FILM} -o out --views 1"), ["needs two", "view 1"]),
        (format!("{FILM} -o out --views 7"), ["no view 7", "0 to 1"]),
        (format!("{FILM} -o out --frames 0"), ["--frames", "1..=99999"]),
        (format!("{FILM} -o out --size 0x7"), ["--size", "1280x720"]),
        (format!("{FILM} -o film.mp4 --size 33x32"), ["even width", "33x32"]),
        (format!("{FILM} -o cameras.json/film.png"), ["cameras.json is a file", ""]),
        (format!("{scene} -o out --loop"), ["does not say what it was trained on", "CAMERAS"]),
        (format!("{FILM} -o out --size 65536x65536"), ["65536", "memory"]),
    ] {
        sandbox.assert_refuses(&words, &facts);
    }
}

/// Replaces ffmpeg, so that tests do not need it. It can fail on demand.
#[cfg(unix)]
mod mp4 {
    use std::path::PathBuf;

    use super::*;

    /// The output file has the input bytes. A file beside the program has the arguments.
    const FFMPEG: &str = include_str!("stand_ins/encoder.sh");

    fn ffmpeg(sandbox: &Sandbox) -> PathBuf {
        sandbox.write_program("ffmpeg", FFMPEG);
        sandbox.path("bin")
    }

    fn run(sandbox: &Sandbox, words: &str, path: &str) -> Outcome {
        sandbox.command(words).env("PATH", path).output().unwrap().into()
    }

    #[test]
    fn ffmpeg_gets_every_frame_and_a_failure_leaves_the_older_film() {
        let sandbox = Sandbox::new("tiny");
        let bin = ffmpeg(&sandbox);
        let path = format!("{}:/usr/bin:/bin", bin.display());
        let words = format!("{FILM} -o film.mp4 --frames 3 --fps 24");
        sandbox.write("film.mp4", "an older film");

        fs::write(bin.join("broken"), "").unwrap();
        let outcome = run(&sandbox, &words, &path);
        outcome.assert_refused(&["ffmpeg ended with", "3", "no space on the moon"]);
        assert_eq!(sandbox.read("film.mp4"), b"an older film");

        fs::remove_file(bin.join("broken")).unwrap();
        run(&sandbox, &words, &path).assert_ok();
        let arguments = fs::read_to_string(bin.join("arguments")).unwrap();
        assert!(
            arguments.contains("-framerate 24") && arguments.contains("libx264"),
            "{arguments}"
        );
        let left: Vec<_> =
            sandbox.files().into_keys().filter(|path| !path.starts_with(&bin)).collect();
        assert_eq!(left.len(), 4, "{left:?}");
        run(&sandbox, &format!("{FILM} -o frames --frames 3"), &path).assert_ok();
        let frames = (0..3).flat_map(|frame| sandbox.read(&format!("frames/{frame:05}.png")));
        assert!(sandbox.read("film.mp4") == frames.collect::<Vec<u8>>());
    }

    #[test]
    fn a_missing_ffmpeg_is_refused_before_rendering() {
        let sandbox = Sandbox::new("tiny");
        let before = sandbox.files();
        let outcome = run(&sandbox, &format!("{FILM} -o film.mp4"), "/nowhere");
        outcome.assert_refused(&["ffmpeg, which is not installed", "-o film.png"]);
        assert!(before == sandbox.files());
    }
}

#[cfg(target_os = "linux")]
mod signals {
    use super::*;
    use crate::sandbox::wait_until;
    use crate::train::processes::{end, signal, start};

    #[test]
    fn a_film_that_was_stopped_leaves_nothing_behind() {
        let sandbox = Sandbox::new("tiny");
        sandbox.write("film.png", "an older film");
        let before = sandbox.files();
        let child = start(&sandbox, &format!("{FILM} --frames 9999 -o film.png"));
        wait_until("a new file", || sandbox.files().len() > before.len());
        signal(&child, "TERM TERM");
        end(child).assert_refused(&["stopped by a signal"]);
        assert!(before == sandbox.files());
    }
}
