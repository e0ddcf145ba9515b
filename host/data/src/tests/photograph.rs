//! Reading, downscaling and undistorting single photographs.

use std::fs;
use std::path::PathBuf;

use super::super::develop::Shot;
use super::super::lens::{Lens, Undistortion};
use super::*;
use organza_core::Image;

fn camera(width: u32, height: u32) -> Camera {
    Camera {
        camera_to_world: POSE,
        fl_x: 90.0,
        fl_y: 80.0,
        cx: 0.45 * f64::from(width),
        cy: 0.52 * f64::from(height),
        width,
        height,
        file_path: None,
        distorted: true,
    }
}

fn shot(path: PathBuf, camera: Camera, lens: Lens) -> Shot {
    let name = "a".to_owned();
    let mask = None;
    Shot { name, path, mask, camera, pose: POSE, lens, factor: 1, held_out: false, trained: None }
}

/// A photograph to be reduced by `factor`.
fn smaller_shot(path: PathBuf, camera: Camera, lens: Lens, factor: u32) -> Shot {
    Shot { factor, ..shot(path, camera, lens) }
}

impl Shot {
    /// Reads the frame.
    fn developed(&self) -> Result<Frame> {
        self.develop(&in_the_world()).map(|developed| developed.frame)
    }
}

/// Writes a photograph with red = column and green = row.
fn ramp(path: &Path, width: u32, height: u32) {
    let pixel = |x: u32, y: u32| image::Rgb([x as u8, y as u8, 7]);
    image::RgbImage::from_fn(width, height, pixel).save(path).unwrap();
}

#[test]
fn sizes_and_masks_are_checked() {
    let pixels = vec![[1, 2, 3], [4, 5, 6]];
    let photograph = Photograph::new([2, 1], pixels.clone(), Some(vec![true, false])).unwrap();
    assert_eq!((photograph.width(), photograph.height()), (2, 1));
    assert_eq!(photograph.valid(), Some([true, false].as_slice()));
    assert!(photograph.is_valid(0, 0) && !photograph.is_valid(1, 0) && !photograph.all_valid());
    assert_eq!(photograph.color(1, 0), [4.0 / 255.0, 5.0 / 255.0, 6.0 / 255.0]);
    let valid = Photograph::new([1, 2], pixels.clone(), Some(vec![true; 2])).unwrap();
    assert!(valid.all_valid() && valid.valid().is_none() && valid.is_valid(0, 1));
    assert_facts(Photograph::new([2, 2], pixels.clone(), None), &["2 x 2 has 4 pixels, not 2"]);
    assert_facts(Photograph::new([2, 1], pixels, Some(vec![])), &["2 pixels, not 0"]);
    let image = Image::new(3, 2).unwrap();
    assert_eq!(Photograph::from(&image), Photograph::new([3, 2], vec![[0; 3]; 6], None).unwrap());
}

/// Bilinear sampling keeps linear ramps, so a pixel's color is its origin.
#[test]
fn undistorted_pixels_come_from_where_the_lens_put_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.png");
    ramp(&path, 120, 90);
    let lens = lens([0.12, -0.05, 0.01], [0.004, -0.003]);
    let camera = camera(120, 90);
    let way = Undistortion::new(&camera, &lens);
    let frame = shot(path, camera.clone(), lens).developed().unwrap();
    assert_eq!(frame.camera, Camera { distorted: false, ..camera.clone() });
    let mut inside = 0;
    let mut outside = 0;
    for (x, y) in (0..90).flat_map(|y| (0..120).map(move |x| (x, y))) {
        let source = way.source([f64::from(x) + 0.5, f64::from(y) + 0.5]);
        assert_eq!(frame.image.is_valid(x, y), source.is_some());
        let pixel = frame.image.pixels()[(y * 120 + x) as usize];
        let Some(source) = source else {
            assert_eq!(pixel, [0; 3]);
            outside += 1;
            continue;
        };
        for (channel, last) in [(0, 119.0), (1, 89.0)] {
            let expected = (source[channel] - 0.5).clamp(0.0, last);
            assert!((f64::from(pixel[channel]) - expected).abs() < 0.501, "{x},{y}: {source:?}");
        }
        assert_eq!(pixel[2], 7);
        inside += 1;
    }
    assert!(inside > 5000 && outside > 100, "{inside} {outside}");
}

#[test]
fn downscaling_takes_means_and_scales_the_camera() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.png");
    ramp(&path, 11, 7);
    let frame = smaller_shot(path.clone(), camera(11, 7), Lens::default(), 3).developed().unwrap();
    // The last two columns and the last row do not fill a square.
    assert_eq!((frame.image.width(), frame.image.height()), (3, 2));
    let expected = [[1, 1, 7], [4, 1, 7], [7, 1, 7], [1, 4, 7], [4, 4, 7], [7, 4, 7]];
    assert_eq!(frame.image.pixels(), expected);
    assert!(frame.image.all_valid());
    let small = frame.camera;
    assert_eq!((small.width, small.height), (3, 2));
    assert_eq!((small.fl_x, small.fl_y), (30.0, 80.0 / 3.0));
    assert_eq!((small.cx, small.cy), (0.45 * 11.0 / 3.0, 0.52 * 7.0 / 3.0));
    let result = smaller_shot(path, camera(11, 7), Lens::default(), 8).developed();
    assert_facts(result, &["ramp.png", "downscale of 8", "11 x 7"]);
}

/// A small pixel is valid only if its whole square is.
#[test]
fn downscaled_masks_are_strict() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.png");
    ramp(&path, 60, 40);
    let lens = lens([0.5, 0.0, 0.0], [0.0; 2]);
    let develop = |factor| smaller_shot(path.clone(), camera(60, 40), lens, factor).developed();
    let full = develop(1).unwrap().image;
    let half = develop(2).unwrap().image;
    assert!(!half.all_valid());
    for (x, y) in (0..20).flat_map(|y| (0..30).map(move |x| (x, y))) {
        let square = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| [2 * x + i, 2 * y + j]);
        let all = square.iter().all(|&[x, y]| full.is_valid(x, y));
        assert_eq!(half.is_valid(x, y), all);
        if all {
            let mean: f32 = square.iter().map(|&[x, y]| full.color(x, y)[0]).sum::<f32>() / 4.0;
            // Each is rounded once, because the means are not of rounded values.
            assert!((half.color(x, y)[0] - mean).abs() <= 1.01 / 255.0);
        }
    }
}

#[test]
fn every_depth_and_format_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let develop = |path: PathBuf| {
        shot(path, camera(5, 4), Lens::default()).developed().unwrap().image.pixels()[0]
    };
    let path = |name: &str| folder.path().join(name);
    image::GrayImage::from_pixel(5, 4, image::Luma([77])).save(path("gray.png")).unwrap();
    assert_eq!(develop(path("gray.png")), [77; 3]);
    let deep = image::Rgb([32768_u16, 0, 65535]);
    image::ImageBuffer::from_pixel(5, 4, deep).save(path("deep.png")).unwrap();
    assert_eq!(develop(path("deep.png")), [128, 0, 255]);
    // JPEG keeps gray, except for rounding.
    write_image(&path("b.jpg"), [5, 4], [60; 3]);
    assert!(develop(path("b.jpg")).iter().all(|&value| value.abs_diff(60) <= 1));
    // The content decides, not the name.
    fs::rename(path("gray.png"), path("gray.jpg")).unwrap();
    assert_eq!(develop(path("gray.jpg")), [77; 3]);
}

#[test]
fn sizes_must_match_the_camera() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    write_image(&path, [12, 8], [0; 3]);
    for (size, hint) in [
        ([24, 16], "`images_2`, and use `--downscale 2`"),
        ([37, 25], "`images_3`, and use `--downscale 3`"),
        ([18, 12], "resized"),
        ([8, 12], "rotated"),
        ([12, 9], "the right photograph"),
    ] {
        let result = shot(path.clone(), camera(size[0], size[1]), Lens::default()).developed();
        let expected = format!("camera {} x {}", size[0], size[1]);
        assert_facts(result, &["a.png", "12 x 8", &expected, hint]);
    }
}

/// What is missing at the right and lower edges is not valid, and what is too much is cut off.
#[test]
fn photographs_may_be_a_pixel_off_their_camera() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("ramp.png");
    for [width, height] in [[48, 35], [47, 36], [49, 37], [48, 36]] {
        ramp(&path, width, height);
        let image = shot(path.clone(), camera(48, 36), Lens::default()).developed().unwrap().image;
        for (x, y) in (0..36).flat_map(|y| (0..48).map(move |x| (x, y))) {
            assert_eq!(image.is_valid(x, y), x < width && y < height, "{width} {height}: {x},{y}");
            let expected = if image.is_valid(x, y) { [x as u8, y as u8, 7] } else { [0; 3] };
            assert_eq!(image.pixels()[(y * 48 + x) as usize], expected);
        }
    }
    ramp(&path, 48, 34);
    let result = shot(path, camera(48, 36), Lens::default()).developed();
    assert_facts(result, &["48 x 34", "camera 48 x 36"]);
}

#[test]
fn a_lens_without_valid_pixels_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    write_image(&path, [12, 8], [0; 3]);
    let lens = lens([0.0; 3], [1e30, 1e30]);
    let far = Camera { cx: 0.0, cy: 0.0, ..camera(12, 8) };
    assert_facts(shot(path, far, lens).developed(), &["a.png", "coefficients"]);
}

/// A photograph cut short anywhere must be an error, and never be half gray.
#[test]
fn damaged_photographs_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let noise =
        |x: u32, y: u32| image::Rgb([(x * y * 7) as u8, (x * x * 31) as u8, (y * 57) as u8]);
    for name in ["a.png", "b.jpg"] {
        let path = folder.path().join(name);
        image::RgbImage::from_fn(40, 30, noise).save(&path).unwrap();
        let whole = fs::read(&path).unwrap();
        shot(path.clone(), camera(40, 30), Lens::default()).developed().unwrap();
        // The last 12 bytes of a PNG only mark its end.
        for length in (0..whole.len() - 12).step_by(7).chain([whole.len() - 13]) {
            fs::write(&path, &whole[..length]).unwrap();
            let result = shot(path.clone(), camera(40, 30), Lens::default()).developed();
            assert_facts(result, &[name, "again"]);
        }
    }
    let path = folder.path().join("b.jpg");
    let folder_path = folder.path().to_owned();
    for (path, facts) in
        [(path.with_file_name("none.png"), "no such file"), (folder_path, "folder")]
    {
        assert_facts(shot(path, camera(40, 30), Lens::default()).developed(), &[facts]);
    }
}
