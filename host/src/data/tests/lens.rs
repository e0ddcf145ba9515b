//! The lens, held to OpenCV.

use super::super::lens::{Lens, Undistortion};
use super::*;

fn camera([width, height]: [u32; 2], [fl_x, fl_y, cx, cy]: [f64; 4]) -> Camera {
    let camera_to_world = POSE;
    let (file_path, distorted) = (None, true);
    Camera { camera_to_world, fl_x, fl_y, cx, cy, width, height, file_path, distorted }
}

const WIDE: ([u32; 2], [f64; 4]) = ([640, 480], [500.0, 510.0, 321.25, 238.5]);
const PORTRAIT: ([u32; 2], [f64; 4]) = ([270, 480], [343.88, 343.6225, 138.6395, 241.317]);

/// Where OpenCV 5.0 puts the centers of pixels: `cv2.projectPoints` of `((x + 0.5 - cx) / fl_x,
/// (y + 0.5 - cy) / fl_y, 1)` with the camera matrix of `cx - 0.5` and `cy - 0.5` (its pixels have
/// their centers at whole numbers) and the coefficients `(k1, k2, p1, p2, k3)`, plus 0.5.
/// `cv2.initUndistortRectifyMap` gave the same, in f32.
type Table = [([u32; 2], [f64; 2]); 5];
const PHONE: Table = [
    ([0, 0], [-0.116033784, -0.854650846]),
    ([269, 0], [270.282068777, -1.090749564]),
    ([17, 479], [17.038782344, 480.266858848]),
    ([135, 240], [135.499982900, 240.499964329]),
    ([200, 100], [201.080780661, 99.134881739]),
];
const BARREL: Table = [
    ([0, 0], [46.635323253, 35.281476517]),
    ([639, 0], [593.094396916, 35.422132574]),
    ([17, 479], [58.424564003, 447.227839185]),
    ([320, 240], [320.499988898, 240.500023940]),
    ([200, 100], [204.755011303, 105.495988787]),
];
const PINCUSHION: Table = [
    ([0, 0], [-21.703278230, -15.975074727]),
    ([639, 0], [661.306522797, -15.807784527]),
    ([17, 479], [-2.292189271, 495.203432475]),
    ([320, 240], [320.499998546, 240.500003878]),
    ([200, 100], [198.752816721, 98.503219110]),
];
const TILTED: Table = [
    ([0, 0], [-11.029778611, -0.176316525]),
    ([639, 0], [622.197921389, 11.957654475]),
    ([17, 479], [1.324551447, 490.655016287]),
    ([320, 240], [320.499719889, 240.500366769]),
    ([200, 100], [198.671623157, 100.584598769]),
];

#[test]
fn places_are_those_of_opencv() {
    for ((size, intrinsics), radial, tangential, table) in [
        (PORTRAIT, [0.0578421, -0.0805099, 0.0], [-0.000980296, 0.00015575], PHONE),
        (WIDE, [-0.28, 0.09, -0.015], [0.0012, -0.0007], BARREL),
        (WIDE, [0.11, 0.0, 0.0], [0.0, 0.0], PINCUSHION),
        (WIDE, [0.0, 0.0, 0.0], [0.01, -0.02], TILTED),
    ] {
        let (camera, lens) = (camera(size, intrinsics), Lens { radial, tangential });
        let way = Undistortion::new(&camera, &lens);
        for (pixel, expected) in table {
            let [x, y] = pixel.map(|place| f64::from(place) + 0.5);
            let plane = [(x - camera.cx) / camera.fl_x, (y - camera.cy) / camera.fl_y];
            let bent = lens.distort(plane);
            let found = [camera.fl_x * bent[0] + camera.cx, camera.fl_y * bent[1] + camera.cy];
            let off = [0, 1].map(|axis| (found[axis] - expected[axis]).abs());
            assert!(off.iter().all(|&off| off < 1e-8), "{pixel:?}: {found:?}, {expected:?}");
            let inside = [0, 1].map(|i| (0.0..=f64::from(size[i])).contains(&expected[i]));
            assert_eq!(way.source([x, y]), (inside == [true; 2]).then_some(found));
        }
    }
}

#[test]
fn a_pinhole_bends_nothing() {
    assert!(Lens::default().is_pinhole());
    assert_eq!(Lens::default().distort([0.3, -0.7]), [0.3, -0.7]);
    assert!(!Lens { radial: [0.0, 0.0, 1e-9], tangential: [0.0; 2] }.is_pinhole());
    assert!(!Lens { radial: [0.0; 3], tangential: [0.0, 1e-9] }.is_pinhole());
}

/// r (1 - r^2 / 3) turns around at r = 1, and is back in the middle of the photograph at 1.7.
#[test]
fn what_lies_beyond_the_fold_is_outside() {
    let camera = camera([400, 400], [100.0, 100.0, 200.0, 200.0]);
    let lens = Lens { radial: [-1.0 / 3.0, 0.0, 0.0], tangential: [0.0; 2] };
    let way = Undistortion::new(&camera, &lens);
    let at = |radius: f64| way.source([200.0 + 100.0 * radius, 200.0]);
    let found = at(0.9).unwrap();
    assert!((found[0] - 265.7).abs() < 1e-9 && found[1] == 200.0, "{found:?}");
    assert!(at(0.999).is_some());
    for radius in [1.001, 1.2, 1.7, 1.99] {
        assert_eq!(at(radius), None, "{radius}");
    }
}
