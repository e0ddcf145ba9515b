use super::*;

/// Kind, size, PSNR and SSIM.
type Known = (&'static str, [usize; 2], f64, f64);

/// The results of scikit-image 0.26.0, as `python3 tests/reference/metrics.py` prints them.
const KNOWN: [Known; 10] = [
    ("random", [11, 11], 7.4093023022983, -0.000915114326176488),
    ("random", [40, 12], 7.7584137641086, 0.0833364611368309),
    ("random", [12, 40], 7.7584137641086, 0.0284092332501902),
    ("random", [64, 48], 7.7623455455435, 0.00899673250568878),
    ("random", [97, 61], 7.7420213829204, 0.00127701747912294),
    ("natural", [11, 11], 23.348953942893, 0.822907720325421),
    ("natural", [40, 12], 23.509418222622, 0.842846075078564),
    ("natural", [12, 40], 23.516590837863, 0.821774022694759),
    ("natural", [64, 48], 23.448991699376, 0.831616102106734),
    ("natural", [97, 61], 23.25718814591, 0.832593291326186),
];

type Pixels = Vec<[f32; 3]>;

/// The same as in `tests/reference/metrics.py`.
fn noise(index: u32) -> u32 {
    let mut x = index.wrapping_add(1).wrapping_mul(0x9e37_79b9);
    x = (x ^ (x >> 16)).wrapping_mul(0x85eb_ca6b);
    x = (x ^ (x >> 13)).wrapping_mul(0xc2b2_ae35);
    (x ^ (x >> 16)) >> 8
}

/// The same as in `tests/reference/metrics.py`.
fn scene(x: u32, y: u32, channel: u32) -> u32 {
    let ramp = (5 * x + (3 + channel) * y) % 512;
    let block = if (x / 9 + y / 7 + channel).is_multiple_of(3) { 200 } else { 0 };
    let stripe = 60 * ((x * (channel + 1) + 2 * y) / 3 % 5);
    (ramp + block + stripe) % 1024
}

/// An image and a photograph, the same as in `tests/reference/metrics.py`.
fn images(kind: &str, [width, height]: [usize; 2]) -> (Pixels, Pixels) {
    let value = |at: usize, channel: u32| {
        let index = 3 * at as u32 + channel;
        if kind == "random" {
            let size = (1 << 24) as f32;
            return (noise(2 * index) as f32 / size, noise(2 * index + 1) as f32 / size);
        }
        let x = (at % width) as u32;
        let y = (at / width) as u32;
        let size = (1 << 14) as f32;
        let smooth = 7 * (scene(x, y, channel) + scene(x + 1, y, channel));
        let image = smooth + 300 + noise(index) % 800;
        (image as f32 / size, (14 * scene(x, y, channel)) as f32 / size)
    };
    let pixel = |at| {
        let values = [0, 1, 2].map(|channel| value(at, channel));
        (values.map(|value| value.0), values.map(|value| value.1))
    };
    (0..width * height).map(pixel).unzip()
}

#[test]
fn psnr_and_ssim_match_scikit_image() {
    let mut worst: f64 = 0.0;
    for (kind, size, expected_psnr, expected_ssim) in KNOWN {
        let (image, truth) = images(kind, size);
        let found = (
            psnr(&image, &truth, None).expect("pixels"),
            ssim(size, &image, &truth, None).expect("windows"),
        );
        let apart = [found.0 - expected_psnr, found.1 - expected_ssim].map(f64::abs);
        worst = worst.max(apart[0]).max(apart[1]);
        assert!(apart[0] < 1e-10, "{kind} {size:?}: PSNR {} for {expected_psnr}", found.0);
        assert!(apart[1] < 1e-10, "{kind} {size:?}: SSIM {} for {expected_ssim}", found.1);
        // PSNR and SSIM are symmetric
        let other = ssim(size, &truth, &image, None).expect("windows");
        assert!((other - found.1).abs() < 1e-14, "{kind} {size:?}: {other} the other way round");
    }
    println!("{worst:.1e} from scikit-image at most");
}

#[test]
fn equal_images_are_infinitely_close() {
    let size = [17, 12];
    let (image, _) = images("natural", size);
    assert_eq!(psnr(&image, &image, None), Some(f64::INFINITY));
    let found = ssim(size, &image, &image, None).expect("windows");
    assert!((found - 1.0).abs() < 1e-14, "{found}");
    let black = vec![[0.0; 3]; 4];
    let white = vec![[1.0; 3]; 4];
    let found = psnr(&black, &white, None).expect("pixels");
    assert!(found == 0.0 && found.is_sign_positive(), "{found}");
}

#[test]
fn a_window_does_not_fit_into_less_than_eleven_pixels() {
    for size in [[10, 40], [40, 10], [0, 0], [1, 1]] {
        let (image, truth) = images("random", size);
        assert_eq!(ssim(size, &image, &truth, None), None, "{size:?}");
    }
    assert_eq!(psnr(&[], &[], None), None);
}

#[test]
fn invalid_pixels_do_not_count() {
    let size = [30, 24];
    let (mut image, truth) = images("natural", size);
    // only the right 11 columns and the lower 12 rows are valid: two windows
    let valid: Vec<_> = (0..30 * 24).map(|at| at % 30 >= 19 && at / 30 >= 12).collect();
    let cut = |pixels: &Pixels| -> Pixels {
        pixels.iter().zip(&valid).filter(|(_, valid)| **valid).map(|(pixel, _)| *pixel).collect()
    };
    let alone = (cut(&image), cut(&truth));
    image
        .iter_mut()
        .zip(&valid)
        .filter(|(_, valid)| !**valid)
        .for_each(|(x, _)| *x = [f32::NAN; 3]);
    let found = ssim(size, &image, &truth, Some(&valid)).expect("windows");
    let expected = ssim([11, 12], &alone.0, &alone.1, None).expect("windows");
    assert!((found - expected).abs() < 1e-14, "{found} for {expected}");
    let found = psnr(&image, &truth, Some(&valid)).expect("pixels");
    let expected = psnr(&alone.0, &alone.1, None).expect("pixels");
    assert!((found - expected).abs() < 1e-12, "{found} for {expected}");
    assert_eq!(psnr(&image, &truth, Some(&[false; 30 * 24])), None);
    assert_eq!(ssim(size, &image, &truth, Some(&[false; 30 * 24])), None);
}
