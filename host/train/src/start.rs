//! The start of training: the scene's first Gaussians, and fields that let light through.

use std::num::NonZero;
use std::path::Path;

use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rand::RngExt;
use rand_distr::{Distribution, StandardNormal};
use rand_pcg::Pcg64;
use rayon::prelude::*;

use super::config::TrainConfig;
use super::points::{distinct, objection, resolution};
use super::requirements;
use super::space::scene_box;
use organza_core::camera::{Camera, Target};
use organza_core::error::{Error, Result};
use organza_core::scene::{Network, Scene, along_a_curve, logit};
use organza_data::random;
use organza_data::{Dataset, Frame, Point, sweep};
use organza_splats::{self as splats, Splat};

const PLACES: u64 = 2;
const FIELDS: u64 = 3;

/// Part of the Gaussians that are spread along rays, behind the cameras' target. The others fill a ball.
const BEHIND: f64 = 0.25;
/// Scale of Gaussians at places that photographs suggest, relative to those at points of a surface. These places fill a volume, so
/// many lie in front of each other.
const FILLING: f32 = 0.5;
/// Last bias of the transmittance network: a large logit, because space is empty at first.
const TRANSMITTANCE_BIAS: f32 = 5.0;

/// What a run says about its first scene.
#[derive(Debug)]
pub(super) enum StartNote {
    /// A warning for the user.
    Warning(String),
    /// There are no points to start from: training starts from `places` that the photographs suggest, and from so many
    /// `random` ones.
    Suggested { places: usize, random: usize },
}

/// The scene before the first step of a run, and what there is to say about it: if training does not start from the data
/// set's points, or if Gaussians to start from do not fit.
///
/// # Errors
/// [`Error::Invalid`] if a setting is out of range or no frame is left to train on; the same errors as [`start`] and [`start_from`].
pub(super) fn first_scene(
    config: &TrainConfig,
    dataset: &Dataset,
) -> Result<(Scene, Vec<StartNote>)> {
    requirements::check(config, dataset)?;
    let frames: Vec<_> = dataset.train_frames().collect();
    let cameras: Vec<_> = frames.iter().map(|frame| frame.camera.clone()).collect();
    let (mut scene, notes) = match &config.start.path {
        Some(path) => start_from(path, config, dataset, &frames, &cameras)?,
        None => start_at_points(config, dataset, &frames, &cameras)?,
    };
    // neighbors read the same entries of the grids
    scene.gaussians = scene.gaussians.select(&along_a_curve(&scene.gaussians.position));
    scene.config.placement = dataset.placement;
    if let Some(block) = &dataset.block {
        block.bound(&mut scene.config)?;
    }
    Ok((scene, notes))
}

/// A first scene with Gaussians at the data set's points. Where it has none that fit, photographs suggest places.
fn start_at_points(
    config: &TrainConfig,
    dataset: &Dataset,
    frames: &[&Frame],
    cameras: &[Camera],
) -> Result<(Scene, Vec<StartNote>)> {
    let mut notes = Vec::new();
    let target = Target::from_cameras(cameras);
    let resolution = resolution(&target, dataset.points.len());
    let mut known = distinct(&dataset.points, |point| point.position, resolution);
    if !known.is_empty()
        && let Some(reason) = objection(&dataset.points, known.len(), frames)
    {
        let file = dataset.points_file.as_deref().unwrap_or(&dataset.path).display();
        notes.push(StartNote::Warning(format!("{file}: {reason}; so its points are not used")));
        known.clear();
    }
    if !known.is_empty() {
        return Ok((start(config, dataset.background, cameras, &known)?, notes));
    }
    let [found, random] = suggested(config, frames, cameras)?;
    notes.push(StartNote::Suggested { places: found.len(), random: random.len() });
    let mut scene = start(config, dataset.background, cameras, &[found, random].concat())?;
    let scales = scene.gaussians.log_scale.as_flattened_mut();
    scales.iter_mut().for_each(|scale| *scale += FILLING.ln());
    Ok((scene, notes))
}

/// The scene before the first step.
///
/// Gaussians lie at `points`. Their scale is the distance to their neighbors. With the transmittance network's last bias, T starts
/// near 1. Otherwise everything would be dark.
pub(super) fn start(
    config: &TrainConfig,
    background: [f64; 3],
    cameras: &[Camera],
    points: &[Point],
) -> Result<Scene> {
    let max = config.densification.max_gaussians as usize;
    requirements::check_scene(config, max.min(points.len()) as u64)?;
    let mut random_places = random(config.run.seed, PLACES, 0);
    let target = Target::from_cameras(cameras);
    let (places, colors) = choose(points, max, &mut random_places);
    let aabb = scene_box(cameras, &target, points);
    let mut scene = Scene::zeros(config.scene_config(background, aabb), places.len())?;
    place(config, &mut scene, &places, &target, &mut random_places);
    fill_vectors(config, &mut scene, &colors, &mut random_places);
    fill_fields(config, &mut scene);
    Ok(scene)
}

/// A first scene with the Gaussians of another program: their positions, shapes and opacities. Their materials start
/// with the mean color over all directions.
///
/// # Errors
/// The same errors as [`splats::load`] and [`Scene::zeros`]; [`Error::Invalid`] if there are more Gaussians than a run may have,
/// or if no camera sees them.
fn start_from(
    path: &Path,
    config: &TrainConfig,
    dataset: &Dataset,
    frames: &[&Frame],
    cameras: &[Camera],
) -> Result<(Scene, Vec<StartNote>)> {
    let file = splats::load(path)?;
    let count = file.splats.len();
    let max = config.densification.max_gaussians;
    if count > max as usize {
        let reason = format!(
            "it has {count} Gaussians, more than the {max} of `densification.max_gaussians`: raise that with `--max-gaussians`"
        );
        return Err(Error::Invalid { origin: path.to_owned(), reason });
    }
    let mut file = file.fitted(frames, &dataset.placement);
    let path = path.display();
    let warning = |note| StartNote::Warning(format!("{path}: {note}"));
    let notes = std::mem::take(&mut file.notes).into_iter().map(warning).collect();
    let splats = file.into_seen(&dataset.placement, cameras)?;
    Ok((from_splats(&splats, config, dataset.background, cameras)?, notes))
}

/// [`start_from`], with Gaussians already read from a file.
pub(super) fn from_splats(
    splats: &[Splat],
    config: &TrainConfig,
    background: [f64; 3],
    cameras: &[Camera],
) -> Result<Scene> {
    requirements::check_scene(config, splats.len() as u64)?;
    let point = |splat: &Splat| Point { position: splat.position.map(f64::from), color: None };
    let points: Vec<_> = splats.iter().map(point).collect();
    let aabb = scene_box(cameras, &Target::from_cameras(cameras), &points);
    let mut scene = Scene::zeros(config.scene_config(background, aabb), splats.len())?;
    let gaussians = &mut scene.gaussians;
    for (i, splat) in splats.iter().enumerate() {
        gaussians.position[i] = splat.position;
        gaussians.rotation[i] = splat.rotation;
        gaussians.log_scale[i] = splat.log_scale;
        gaussians.opacity[i] = splat.opacity;
        // a zero quaternion is no rotation
        if splat.rotation == [0.0; 4] {
            gaussians.rotation[i][0] = 1.0;
        }
    }
    let color = |splat: &Splat| Some(splats::base_color(splat).map(|value| (255.0 * value) as u8));
    let colors: Vec<_> = splats.iter().map(color).collect();
    fill_vectors(config, &mut scene, &colors, &mut random(config.run.seed, PLACES, 0));
    fill_fields(config, &mut scene);
    Ok(scene)
}

/// Points to start from where the data set has none: those found in its photographs, and a random place that cameras see for each
/// ray without a match in another photograph.
///
/// # Errors
/// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory).
fn suggested(
    config: &TrainConfig,
    frames: &[&Frame],
    cameras: &[Camera],
) -> Result<[Vec<Point>; 2]> {
    requirements::check_scene(config, config.first_gaussians().into())?;
    let target = Target::from_cameras(cameras);
    let count = config.first_gaussians() as usize;
    let seed = config.run.seed;
    let found = sweep::points(frames, target.distance, count, seed);
    let rest = scatter(&target, cameras, count - found.len(), &mut random(seed, PLACES, 1));
    Ok([found, rest])
}

/// Random places that cameras see: most in a ball around the target, the others behind it, along rays.
pub(super) fn scatter(
    target: &Target,
    cameras: &[Camera],
    count: usize,
    random: &mut Pcg64,
) -> Vec<Point> {
    let needed = 2.min(cameras.len());
    (0..count)
        .map(|_| {
            if random.random_bool(BEHIND) {
                return along_a_ray(target, cameras, random);
            }
            let seen = |place: &DVec3| {
                let shows = |camera: &&Camera| camera.depth_in_image(place.to_array()).is_some();
                cameras.iter().filter(shows).take(needed).count()
            };
            let mut tries = (0..100).map(|_| in_ball(target, random));
            match tries.find(|place| seen(place) == needed) {
                Some(place) => place,
                // the cameras look outward
                None => along_a_ray(target, cameras, random),
            }
        })
        .map(|place| Point { position: place.to_array(), color: None })
        .collect()
}

/// A random place in the ball around the target, with uniform density.
fn in_ball(target: &Target, random: &mut Pcg64) -> DVec3 {
    let mut place = || DVec3::from_array(std::array::from_fn(|_| random.random_range(-1.0..1.0)));
    let mut inside = place();
    while inside.length_squared() > 1.0 {
        inside = place();
    }
    target.center + inside * target.radius
}

/// A random place along a ray, from the target's distance to four times as far, uniform in the inverse depth.
fn along_a_ray(target: &Target, cameras: &[Camera], random: &mut Pcg64) -> DVec3 {
    let camera = &cameras[random.random_range(0..cameras.len())];
    let place = [camera.width, camera.height].map(|side| random.random::<f64>() * f64::from(side));
    let depth = target.distance / random.random_range(0.25..1.0);
    DVec3::from(camera.eye()) + camera.ray(place) * depth
}

/// At most `count` of the points, chosen at random, with their colors.
fn choose(
    points: &[Point],
    count: usize,
    random: &mut Pcg64,
) -> (Vec<DVec3>, Vec<Option<[u8; 3]>>) {
    let mut chosen =
        rand::seq::index::sample(random, points.len(), count.min(points.len())).into_vec();
    chosen.sort_unstable();
    chosen.into_iter().map(|i| (DVec3::from(points[i].position), points[i].color)).unzip()
}

/// Root mean square distance of each place to its three nearest neighbors. Neighbors nearer than the `resolution` are the
/// same place. A place without neighbors gets `alone`.
fn spacing(places: &[DVec3], resolution: f64, alone: f64) -> Vec<f64> {
    let entries: Vec<_> = places.iter().map(DVec3::to_array).collect();
    let tree = ImmutableKdTree::new_from_slice(&distinct(&entries, |place| *place, resolution));
    let neighbors = NonZero::new(4).expect("four is not zero");
    let Ok(tree) = tree else { return vec![alone; places.len()] };
    entries
        .par_iter()
        .map(|entry| {
            // one of the results is the place itself
            let found = tree.query(entry).nearest_n::<SquaredEuclidean<f64>>(neighbors).execute();
            let (sum, count) = found
                .iter()
                .filter(|item| item.distance > resolution * resolution)
                .take(3)
                .fold((0.0, 0.0), |(sum, count), item| (sum + item.distance, count + 1.0));
            if count > 0.0 { f64::sqrt(sum / count) } else { alone }
        })
        .collect()
}

fn place(
    config: &TrainConfig,
    scene: &mut Scene,
    places: &[DVec3],
    target: &Target,
    random: &mut Pcg64,
) {
    let start = &config.start;
    let logit = logit(start.opacity);
    let spacing = spacing(places, resolution(target, places.len()), target.radius);
    let gaussians = &mut scene.gaussians;
    for (i, place) in places.iter().enumerate() {
        gaussians.position[i] = place.as_vec3().to_array();
        let scale = (spacing[i] * f64::from(start.scale)).ln() as f32;
        gaussians.log_scale[i] = [scale; 3];
        gaussians.rotation[i] = std::array::from_fn(|_| StandardNormal.sample(random));
        gaussians.opacity[i] = logit;
    }
}

/// Random materials and extra vectors.
fn fill_vectors(
    config: &TrainConfig,
    scene: &mut Scene,
    colors: &[Option<[u8; 3]>],
    random: &mut Pcg64,
) {
    let spread = config.start.spread;
    let gaussians = &mut scene.gaussians;
    let mut uniform = |values: &mut [f32]| {
        values.iter_mut().for_each(|value| *value = spread * (2.0 * random.random::<f32>() - 1.0));
    };
    uniform(&mut gaussians.material);
    uniform(&mut gaussians.extra);
    // the network reads the point's color in the first values of the material
    let material = config.scene.material as usize;
    for (values, color) in gaussians.material.chunks_mut(material.max(1)).zip(colors) {
        for (value, channel) in values.iter_mut().zip(color.iter().flatten()) {
            *value = f32::from(*channel) / 127.5 - 1.0;
        }
    }
}

/// Random networks (He et al. 2015), and grids with the start values of Instant NGP.
fn fill_fields(config: &TrainConfig, scene: &mut Scene) {
    let mut random = random(config.run.seed, FIELDS, 0);
    for field in [&mut scene.color, &mut scene.transmittance] {
        field.grid.iter_mut().for_each(|value| *value = random.random_range(-1e-4..1e-4));
        fill_network(&mut field.network, &mut random);
    }
    let last = scene.transmittance.network.layers.last_mut().expect("a network has layers");
    last.bias[0] = TRANSMITTANCE_BIAS;
}

fn fill_network(network: &mut Network, random: &mut Pcg64) {
    let count = network.layers.len();
    for (index, layer) in network.layers.iter_mut().enumerate() {
        // the head starts with the gain of a linear layer
        let gain = if index + 1 < count { 2.0 } else { 1.0 };
        let deviation = f32::sqrt(gain / layer.inputs as f32);
        let normal: fn(&mut Pcg64) -> f32 = |random| StandardNormal.sample(random);
        layer.weight.iter_mut().for_each(|weight| *weight = deviation * normal(random));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cameras on a circle of radius 5 around (1, 2, 3).
    fn circle() -> Vec<Camera> {
        (0..12)
            .map(|i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 12.0).sin_cos();
                let eye = [1.0 + 4.0 * cos, 2.0 + 4.0 * sin, 6.0];
                Camera::look_at(eye, [1.0, 2.0, 3.0], [0.0, 0.0, 1.0], 0.8, [64, 48]).unwrap()
            })
            .collect()
    }

    #[test]
    fn gaussians_are_spread_where_cameras_see_them() {
        let mut config = TrainConfig::default();
        config.densification.max_gaussians = 2000;
        let cameras = circle();
        let target = Target::from_cameras(&cameras);
        let places = scatter(&target, &cameras, 500, &mut random(0, PLACES, 1));
        let scene = start(&config, [0.0; 3], &cameras, &places).unwrap();
        assert_eq!(scene.gaussians.len(), 500);
        let is_seen = |place: &[f32; 3]| {
            let place = place.map(f64::from);
            cameras.iter().any(|camera| camera.depth_in_image(place).is_some())
        };
        assert!(scene.gaussians.position.iter().all(is_seen));
        assert_eq!(scene, start(&config, [0.0; 3], &cameras, &places).unwrap());
        scene.validate().unwrap();
    }

    /// The size of a Gaussian is the distance to its neighbors, even if its place is repeated.
    #[test]
    fn repeated_places_have_the_size_of_the_space_between_places() {
        let grid = |by: f64| {
            (0..100).map(move |i| DVec3::new(f64::from(i % 10) + by, f64::from(i / 10), 0.0) * 0.1)
        };
        for (copies, by) in [(1, 0.0), (4, 0.0), (4, 1e-7)] {
            let places: Vec<_> = (0..copies).flat_map(|copy| grid(by * f64::from(copy))).collect();
            // the neighbors are at 0.1, and in a corner one is at 0.14
            for spacing in spacing(&places, 1e-3, 1.0) {
                assert!((0.0999..0.12).contains(&spacing), "{copies}: {spacing}");
            }
        }
    }

    #[test]
    fn points_give_places_colors_and_a_box_without_outliers() {
        let mut config = TrainConfig::default();
        config.densification.max_gaussians = 2000;
        let mut points: Vec<_> = (0..1000)
            .map(|i| {
                let t = f64::from(i) * 0.1;
                Point {
                    position: [t.sin(), t.cos(), 0.5 * (t * 0.7).sin()],
                    color: Some([255, 0, 51]),
                }
            })
            .collect();
        points.push(Point { position: [1e4, 0.0, 0.0], color: None });
        let scene = start(&config, [0.0; 3], &circle(), &points).unwrap();
        assert_eq!(scene.gaussians.len(), 1001);
        let [low, high] = scene.config.aabb;
        assert!(high[0] < 1e3 && low[1] <= -0.99 && high[1] >= 0.99, "{:?}", scene.config.aabb);
        assert_eq!(scene.gaussians.material[..3], [1.0, -1.0, -0.6]);
        // neighbors on the curve are 0.1 apart, and less
        let scale = scene.gaussians.log_scale[500][0].exp();
        assert!((0.005..0.3).contains(&scale), "{scale}");
    }
}
