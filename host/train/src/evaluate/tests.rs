use super::*;
use muslin_device::DeviceOptions;
use organza_core::demo;
use organza_core::metrics::psnr;
use organza_data::Photograph;

/// Two views of the built-in scene, with a size that no tile divides, and a renderer.
fn setup() -> (Renderer, DeviceScene, Vec<Frame>) {
    let renderer =
        Renderer::new(organza_render::open_device(&DeviceOptions::cpu(Some(1))).unwrap());
    let mut scene = demo::scene();
    // Most of the time would go into samples.
    scene.config.step *= 8.0;
    let scene = renderer.upload(&scene).unwrap();
    let frame = |(index, camera): (usize, organza_core::Camera)| {
        let mut image = Image::new(camera.width, camera.height).unwrap();
        for batch in bands(0, image.size(), 17) {
            let batch = batch.unwrap();
            let cameras = std::slice::from_ref(&camera);
            image.paste(&batch, &renderer.render(&scene, cameras, &batch).unwrap()).unwrap();
        }
        Frame { name: format!("{index}.png"), camera, image: Photograph::from(&image) }
    };
    let frames = demo::turntable(2, 75).into_iter().enumerate().map(frame).collect();
    (renderer, scene, frames)
}

#[test]
fn a_scene_is_as_close_to_its_own_images_as_rounding_allows() {
    let (renderer, scene, mut frames) = setup();
    // one column is wrong, but not valid
    let pixels = frames[1].image.pixels().iter().enumerate();
    let spoiled = pixels.map(|(at, &pixel)| if at % 75 == 7 { [0, 255, 0] } else { pixel });
    let valid = (0..75 * 75).map(|at| at % 75 != 7).collect();
    frames[1].image = Photograph::new([75, 75], spoiled.collect(), Some(valid)).unwrap();
    let mut tiles = Vec::new();
    let mut seen = Vec::new();
    let frames: Vec<_> = frames.iter().collect();
    let evaluation = evaluate_with(&renderer, &scene, &frames, false, &mut |event| match event {
        Event::Tiles { done, total } => tiles.push((done, total)),
        Event::View { index, score, image } => {
            assert_eq!(score.name, frames[index].name);
            seen.push(Photograph::from(image));
        }
    })
    .unwrap();
    assert_eq!((tiles.last(), seen.len()), (Some(&(8, 8)), 2));
    assert!(tiles.is_sorted() && evaluation.not_finite == 0, "{tiles:?}");
    assert_eq!(seen[0], frames[0].image);
    // Rounding to 256 levels has a variance of 1/12 of a level, and a little less for large areas of background.
    for view in &evaluation.views {
        let psnr = view.score.psnr.unwrap();
        let ssim = view.score.ssim.unwrap();
        assert!((58.0..63.0).contains(&psnr) && ssim > 0.999, "{view:?}");
    }
    let [a, b] = [0, 1].map(|at| evaluation.views[at].score);
    assert_eq!(evaluation.mean.psnr, Some((a.psnr.unwrap() + b.psnr.unwrap()) / 2.0));
    assert_eq!(evaluation.mean.ssim, Some((a.ssim.unwrap() + b.ssim.unwrap()) / 2.0));
}

#[test]
fn a_known_difference_has_its_psnr() {
    let (renderer, scene, mut frames) = setup();
    let frame = &mut frames[0];
    let off = |value: u8| if value < 128 { value + 51 } else { value - 51 };
    let pixels = frame.image.pixels().iter().map(|pixel| pixel.map(off)).collect();
    frame.image = Photograph::new([75, 75], pixels, None).unwrap();
    let score = evaluate(&renderer, &scene, &[frame]).unwrap().mean;
    // 51/255 is 0.2, and -20 log10(0.2) is 13.979. Rounding the large background always the same way moves it a
    // little
    assert!((score.psnr.unwrap() - 13.979).abs() < 0.03, "{score:?}");
}

#[test]
fn sizes_must_agree() {
    let (renderer, scene, mut frames) = setup();
    frames[0].camera.width = 74;
    let error = evaluate(&renderer, &scene, &[&frames[0]]).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("frame 0.png has 75 x 75") && text.contains("74 x 75"), "{text}");
}

#[test]
fn missing_values_are_null_in_json_and_outside_the_mean() {
    let view = |name: &str, psnr, ssim| ViewScore {
        name: name.into(),
        score: Score { psnr, ssim, ..Score::default() },
    };
    let views =
        vec![view("a", Some(20.0), None), view("b", None, None), view("c", Some(30.0), None)];
    let evaluation = Evaluation { mean: mean(&views), views, not_finite: 3 };
    assert_eq!(evaluation.mean, Score { psnr: Some(25.0), ..Score::default() });
    let json = serde_json::to_string(&evaluation).unwrap();
    let start =
        r#"{"mean":{"psnr":25.0,"ssim":null},"views":[{"name":"a","psnr":20.0,"ssim":null},"#;
    assert!(json.starts_with(start), "{json}");
    let infinite = Score { psnr: Some(f64::INFINITY), ssim: Some(1.0), ..Score::default() };
    assert_eq!(serde_json::to_string(&infinite).unwrap(), r#"{"psnr":null,"ssim":1.0}"#);
    assert_eq!(mean(&[]), Score::default());
}

/// 8 x 4 pixels of different colors.
fn image() -> Vec<[f32; 3]> {
    (0..32_u16)
        .map(|at| [at, (at * 7) % 32, (at * 11) % 32].map(|value| f32::from(value) / 64.0))
        .collect()
}

#[test]
fn exposure_and_white_balance_do_not_count() {
    let truth: Vec<_> =
        image().iter().map(|[r, g, b]| [0.8 * r + 0.1, 1.5 * g, 1.2 * b + 0.05]).collect();
    let plain = psnr(&image(), &truth, None).unwrap();
    let psnr = psnr_fitted([8, 4], &image(), &truth, None).unwrap();
    assert!(psnr > 120.0 && plain < 20.0, "{psnr} {plain}");
    // with a single color, there is only an offset
    let gray = vec![[0.25; 3]; 32];
    let psnr = psnr_fitted([8, 4], &gray, &vec![[0.5; 3]; 32], None).unwrap();
    assert!(psnr > 120.0, "{psnr}");
}

/// A pixel must not fit itself: with each half fitted to itself, no error would be left.
#[test]
fn each_half_is_measured_with_the_fit_of_the_other() {
    let mut truth = image();
    let right = |at: usize| at % 8 >= 4;
    (0..32).filter(|&at| right(at)).for_each(|at| truth[at] = truth[at].map(|v| v + 0.25));
    let psnr = psnr_fitted([8, 4], &image(), &truth, None).unwrap();
    // the left half's fit leaves the right half 0.25 too dark, and the right half's fit makes the left half
    // 0.25 too bright: -20 log10(0.25)
    assert!((psnr - 12.041).abs() < 1e-3, "{psnr}");
}

#[test]
fn pixels_that_are_not_valid_do_not_count() {
    let mut truth = image();
    truth[3] = [1.0, 0.0, 1.0];
    let valid: Vec<_> = (0..32).map(|at| at != 3).collect();
    assert!(psnr_fitted([8, 4], &image(), &truth, Some(&valid)).unwrap() > 120.0);
    assert!(psnr_fitted([8, 4], &image(), &truth, None).unwrap() < 40.0);
    let left: Vec<_> = (0..32).map(|at| at % 8 < 4).collect();
    assert_eq!(psnr_fitted([8, 4], &image(), &truth, Some(&left)), None);
}
