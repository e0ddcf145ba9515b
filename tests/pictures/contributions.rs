//! Contributions of Gaussians to whole views, on every device: compared with the equations in f64, and with a scene whose
//! weights are known.

use organza::render::Contributions;
use organza::{Camera, Renderer, Scene, demo};
use organza_tests::cases::{self, Case};
use organza_tests::devices;

use crate::channels::{Member, members};

/// Relative, as in [`crate::channels`].
const TOLERANCE: f64 = 2e-4;

/// The sum of `alpha / max(S, 1)` over a camera's pixels, for each member; and how far it may be off, because of pixels at
/// which rounding decides whether the member counts.
fn by_equations(members: &[Member], camera: &Camera) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 2]; members.len()];
    for at in 0..camera.width * camera.height {
        let place = [at % camera.width, at / camera.width].map(|x| f64::from(x) + 0.5);
        let alphas: Vec<_> = members.iter().map(|member| member.splat.term(place)[3]).collect();
        let most = alphas.iter().sum::<f64>().max(1.0);
        let is_near = |member: &Member| member.is_at_its_end(place);
        let unsure = members.iter().filter(|member| is_near(member));
        let unsure: f64 = unsure.map(|member| member.splat.weight / 255.0).sum();
        for ((sum, member), alpha) in sums.iter_mut().zip(members).zip(alphas) {
            sum[0] += alpha / most;
            // another member that counts or not changes S
            sum[1] += alpha / most * unsure;
            sum[1] += if is_near(member) { member.splat.weight / 255.0 } else { 0.0 };
        }
    }
    sums
}

/// A Gaussian's contribution to a camera's pixels, and how far it may be off: see [`by_equations`].
fn expected(case: &Case, camera: usize) -> Vec<[f64; 2]> {
    let members = members(case, camera);
    let mut expected = vec![[0.0; 2]; case.scene.gaussians.len()];
    for (member, sum) in members.iter().zip(by_equations(&members, &case.cameras[camera])) {
        expected[member.gaussian] = sum;
    }
    expected
}

#[test]
fn contributions_match_the_equations() {
    // The equations take longer than the devices, so each case has its values once.
    let cases = cases::all();
    let expected: Vec<Vec<_>> = cases
        .iter()
        .map(|case| (0..case.cameras.len()).map(|camera| expected(case, camera)).collect())
        .collect();
    for (backend, device) in devices::all() {
        let renderer = Renderer::new(device);
        for (case, expected) in cases.iter().zip(&expected) {
            let scene = renderer.upload(&case.scene).expect("the scene fits");
            for (view, expected) in case.cameras.iter().zip(expected) {
                let mut found = Contributions::new(scene.len());
                renderer.add_contributions(&scene, view, true, &mut found).expect("it renders");
                check(&format!("{} on {backend}", case.name), &found, expected);
            }
        }
    }
}

fn check(what: &str, found: &Contributions, expected: &[[f64; 2]]) {
    for (gaussian, [sum, unsure]) in expected.iter().enumerate() {
        let pixels = found.pixels(gaussian);
        assert!(
            (pixels - sum).abs() <= TOLERANCE * sum + unsure,
            "{what}: Gaussian {gaussian} contributes {pixels}, not {sum}"
        );
        let views = if pixels > 0.0 { 1.0 } else { 0.0 };
        assert!((found.views(gaussian) - views).abs() < 1e-12);
    }
}

/// Two cameras look at a wall from both ends of a corridor. Haze hangs before the eye of the first.
fn corridor() -> (Scene, [Camera; 2]) {
    let mut scene = Scene::zeros(demo::config(), 3).unwrap();
    // all light passes
    let last = scene.transmittance.network.layers.last_mut().unwrap();
    last.bias[0] = 50.0;
    let gaussians = &mut scene.gaussians;
    // the wall, haze near the first camera, and what lies behind the wall for the first
    gaussians.position = vec![[0.0, 0.0, 4.0], [0.0, 0.0, 1.0], [0.0, 0.0, 5.0]];
    gaussians.rotation.fill([1.0, 0.0, 0.0, 0.0]);
    // so large that falloff is 1 in the middle
    gaussians.log_scale = vec![[9.0, 9.0, -9.0]; 3];
    let weights: [f32; 3] = [0.9, 0.5, 0.2];
    gaussians.opacity = weights.map(|weight| (weight / (1.0 - weight)).ln()).to_vec();
    let up = [0.0, 1.0, 0.0];
    let camera = |z, to| Camera::look_at([0.0, 0.0, z], [0.0, 0.0, to], up, 0.5, [20, 12]).unwrap();
    (scene, [camera(0.0, 4.0), camera(4.5, 5.0)])
}

#[test]
fn haze_is_in_front_of_the_surfaces_of_few_views() {
    for (backend, device) in devices::all() {
        let renderer = Renderer::new(device);
        let (scene, [first, second]) = corridor();
        let scene = renderer.upload(&scene).unwrap();
        let mut found = Contributions::new(3);
        renderer.add_contributions(&scene, &first, true, &mut found).unwrap();
        let close = |found: f64, expected: f64| {
            assert!((found - expected).abs() < 1e-4 * expected.max(1.0), "{backend}: {found}");
        };
        // S is 1.6 everywhere, and the view has 240 pixels
        close(found.pixels(0), 240.0 * 0.9 / 1.6);
        close(found.pixels(1), 240.0 * 0.5 / 1.6);
        close(found.pixels(2), 240.0 * 0.2 / 1.6);
        assert_eq!([0, 1, 2].map(|i| found.in_front(i)), [0.0, 1.0, 0.0], "{backend}");
        // only the last Gaussian is before the second camera
        renderer.add_contributions(&scene, &second, true, &mut found).unwrap();
        close(found.pixels(0), 240.0 * 0.9 / 1.6);
        close(found.pixels(2), 240.0 * (0.2 / 1.6 + 0.2));
        close(found.views(1), 1.0);
        let [a, b]: [f64; 2] = [0.2 / 1.6, 0.2];
        close(found.views(2), (a + b).powi(2) / (a * a + b * b));
        // without surfaces, nothing is in front
        let mut found = Contributions::new(3);
        renderer.add_contributions(&scene, &first, false, &mut found).unwrap();
        assert_eq!(found.in_front(1), 0.0);
        close(found.pixels(1), 240.0 * 0.5 / 1.6);
    }
}
