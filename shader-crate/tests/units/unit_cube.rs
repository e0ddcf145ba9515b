use glam::Vec3;
use organza_shaders::unit_cube::{PARTS, SceneBox, Split, contract, from_center};

#[test]
fn positions_are_known_better_than_an_f32_tells() {
    for (low, high) in [
        (-1.5, 1.5),
        (-1.2, 1.2),
        (-1.0, 1.4),
        (0.0, 1.0),
        (-317.3, 511.9),
        (10.0, 10.3),
        (-1e-3, 2e-3),
    ] {
        let scene_box = SceneBox::new([[low; 3], [high; 3]], false);
        for step in 0..=1000 {
            let x = (low + (high - low) * f64::from(step) / 1000.0) as f32;
            let exact = 0.05 + 0.9 * (f64::from(x) - low) / (high - low);
            let [split, ..] = scene_box.split([x; 3]);
            let found = f64::from(split.coarse) + f64::from(split.fine);
            assert!((found - exact).abs() < 2e-10, "{found} for {exact} in {low}..{high}");
            assert_eq!(split.coarse * PARTS, libm::floorf(split.coarse * PARTS));
            assert!((-1e-9..=1.0 / PARTS + 1e-9).contains(&split.fine), "{split:?}");
        }
    }
}

#[test]
fn places_outside_are_clamped() {
    let scene_box = SceneBox::new([[-1.0; 3], [1.0; 3]], false);
    let [low, middle, high] = scene_box.split([-3.0, 0.0, 1e30]).map(Split::clamped);
    assert_eq!((low.coarse, low.fine), (0.0, 0.0));
    assert!((middle.coarse + middle.fine - 0.5).abs() < 1e-7);
    assert_eq!((high.coarse, high.fine), (1.0, 0.0));
}

#[test]
fn all_of_space_is_contracted_to_the_cube() {
    let scene_box = SceneBox::new([[-1.0; 3], [1.0; 3]], true);
    let contracted = |point| {
        let q = from_center(scene_box.split(Vec3::to_array(&point)));
        Vec3::from_array(contract(q).map(Split::value))
    };
    // the box keeps its place; at twice its size a half of the margin is left, at four times a quarter
    for (point, expected) in [
        (Vec3::new(1.0, -0.5, 0.0), Vec3::new(0.75, 0.375, 0.5)),
        (Vec3::new(2.0, -1.0, 0.0), Vec3::new(0.875, 0.3125, 0.5)),
        (Vec3::new(0.0, 0.0, -4.0), Vec3::new(0.5, 0.5, 0.0625)),
        (Vec3::new(1e30, 1e30, -1e30), Vec3::new(1.0, 1.0, 0.0)),
    ] {
        let found = contracted(point);
        assert!((found - expected).length() < 2e-7, "{point} to {found}, not {expected}");
    }
}
