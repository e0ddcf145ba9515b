//! Exposures, measured at points.

use crate::{Dataset, Frame, Photograph, Point};
use organza_core::camera::Camera;

/// Photographs of a wall of one color with these gains, and points on the wall. `hidden` of them have other colors, as if
/// something were in front of them.
fn wall(gains: &[f64], hidden: usize) -> Dataset {
    let color = [60.0, 90.0, 120.0];
    let frames = gains.iter().enumerate().map(|(index, gain)| {
        let eye = [0.1 * index as f64, 0.0, 4.0];
        let camera = Camera::look_at(eye, [0.0; 3], [0.0, 1.0, 0.0], 0.8, [32, 32]).unwrap();
        let pixel = color.map(|value| (value * gain).round() as u8);
        let image = Photograph::new([32, 32], vec![pixel; 32 * 32], None).unwrap();
        Frame { name: index.to_string(), camera, image }
    });
    let mut dataset = Dataset::from_frames(frames.collect(), 0);
    dataset.points = (0..200)
        .map(|index| {
            let position =
                [0.05 * f64::from(index % 20 - 10), 0.1 * f64::from(index / 20 - 5), 0.0];
            let is_hidden = (index as usize) < hidden;
            let color = if is_hidden { [20; 3] } else { color.map(|value| value as u8) };
            Point { position, color: Some(color) }
        })
        .collect();
    dataset
}

#[test]
fn exposures_differ_as_gains_do() {
    let gains = [0.5, 1.0, 1.0, 2.0];
    // logarithms are -l, 0, 0 and l
    let expected = 2f64.ln() * 0.5f64.sqrt();
    for hidden in [0, 80] {
        let found = wall(&gains, hidden).exposure_spread().unwrap();
        assert!((found - expected).abs() < 0.01, "{hidden} hidden: {found}");
    }
    assert!(wall(&[1.0; 5], 80).exposure_spread().unwrap() < 1e-12);
}

#[test]
fn exposure_spread_needs_fifty_points_with_colors() {
    let mut dataset = wall(&[0.5, 1.0], 0);
    dataset.points.truncate(49);
    assert_eq!(dataset.exposure_spread(), None);
    dataset.points.clear();
    assert_eq!(dataset.exposure_spread(), None);
    // one photograph is black
    assert_eq!(wall(&[0.0, 1.0], 0).exposure_spread(), None);
    let mut dataset = wall(&[0.5, 1.0], 0);
    dataset.points.iter_mut().for_each(|point| point.color = None);
    assert_eq!(dataset.exposure_spread(), None);
}
