//! C alone, and A, B and C together: rendered tiles, as pictures and as values.

use organza::{Camera, RenderedTiles, Scene, Stages, Tile, TileBatch};

use crate::snapshots::exact::{self, Branches};
use crate::snapshots::generator::{Recipe, camera, camera_to, keep};
use crate::snapshots::{RENDERERS, SNAPSHOTS};
use muslin_check::snapshot::compare::Tolerance;
use muslin_check::snapshot::picture::Montage;
use muslin_check::snapshot::tensors::Tensors;

/// Weighted means of colors have no larger errors than the colors. Measured: 4e-7.
const TILES: Tolerance = Tolerance { absolute: 5e-6, relative: 5e-6 };
/// Approximate width of pictures, in pixels.
const WIDTH: usize = 320;

/// A scene, its cameras, and the tiles to render.
struct Shot<'a> {
    name: &'a str,
    description: &'a str,
    scene: Scene,
    cameras: Vec<Camera>,
    batch: TileBatch,
    /// Number of tiles in a row of the picture.
    columns: usize,
}

impl<'a> Shot<'a> {
    /// One tile of one camera.
    fn new(
        [name, description]: [&'a str; 2],
        scene: Scene,
        camera: Camera,
        (side, [x, y]): (u32, [i32; 2]),
    ) -> Self {
        let batch = TileBatch { side, tiles: vec![tile(0, x, y)] };
        Self { name, description, scene, cameras: vec![camera], batch, columns: 1 }
    }

    /// Compares the tiles with the equations and with both snapshots, on every device. `look` gets the results of
    /// each device.
    fn check(&self, look: impl Fn(&RenderedTiles, &[Stages], Branches)) {
        let [tiles, _, side, _] = self.batch.output_shape();
        let columns = self.columns.min(tiles);
        let scale = (WIDTH / (columns * (side + 1))).clamp(2, 16);
        let montage = Montage { tiles, side, columns, scale };
        for (backend, renderer) in RENDERERS.iter() {
            let scene = renderer.upload(&self.scene).expect("the scene fits");
            let found = renderer.render(&scene, &self.cameras, &self.batch).expect("it renders");
            let name = format!("{}_picture", self.name);
            SNAPSHOTS.assert_picture([&name, self.description], backend, &found.data, montage);
            let mut tensors = Tensors::default();
            tensors.push("tiles", &self.batch.output_shape(), &found.data);
            // more would not fit into a file, but the picture shows them
            if found.data.len() <= 5000 {
                let name = format!("{}_values", self.name);
                SNAPSHOTS.assert_tensors([&name, self.description], backend, &tensors, TILES);
            }
            let stages: Vec<Stages> = self
                .cameras
                .iter()
                .map(|camera| renderer.stages(&scene, camera).expect("the stages run"))
                .collect();
            let (exact, branches) = exact::tiles(&self.scene, &stages, &self.batch);
            for (index, (&found, exact)) in found.data.iter().zip(&exact).enumerate() {
                let apart = (f64::from(found) - exact).abs();
                assert!(
                    apart <= 2e-5,
                    "{} on {backend}: {found} for {exact} at {index}",
                    self.name
                );
            }
            look(&found, &stages, branches);
        }
    }
}

fn tile(camera: usize, x: i32, y: i32) -> Tile {
    Tile { camera, origin: [x, y] }
}

fn background(scene: &Scene) -> [f32; 3] {
    scene.config.background.map(|channel| channel as f32)
}

/// The pixel of a tile, in [0, 1].
fn pixel(found: &RenderedTiles, tile: usize, [column, row]: [usize; 2]) -> [f32; 3] {
    let side = found.side as usize;
    [0, 1, 2].map(|channel| found.data[((tile * 3 + channel) * side + row) * side + column])
}

fn is_background(found: &RenderedTiles, tile: usize, scene: &Scene) -> bool {
    let area = (found.side * found.side) as usize;
    let channels = found.data[tile * 3 * area..][..3 * area].chunks_exact(area);
    channels.zip(background(scene)).all(|(values, b)| values.iter().all(|&value| value == b))
}

#[test]
fn tiles_alone() {
    // no color and no loss: only projection, tiling and the falloff
    let recipe = Recipe { seed: 61, gaussians: 16, log_scale: [-2.6, -0.9], ..Recipe::default() };
    let mut scene = recipe.scene();
    for field in [&mut scene.color, &mut scene.transmittance] {
        for layer in &mut field.network.layers {
            layer.weight.fill(0.0);
            layer.bias.fill(0.0);
        }
    }
    let head = scene.color.network.layers.last_mut().expect("a network has layers");
    head.bias.copy_from_slice(&[3.0, 0.5, -2.0]);
    scene.transmittance.network.layers[1].bias[0] = 60.0;
    let tiles = [[4, 2], [24, 2], [4, 22], [24, 22]].map(|[x, y]| tile(0, x, y)).to_vec();
    let shot = Shot {
        name: "tiles_alone",
        description: "C alone: one color and T = 1, so that projection, tiling and falloff are left; 4 neighboring tiles",
        scene,
        cameras: vec![camera([0.4, 0.5, -3.2], [48, 44])],
        batch: TileBatch { side: 20, tiles },
        columns: 2,
    };
    shot.check(|_, stages, branches| {
        assert!(stages[0].transmittance.iter().all(|&t| (t - 1.0).abs() < 1e-6), "nothing is lost");
        for color in stages[0].color.chunks_exact(3) {
            let exact = [3.0f64, 0.5, -2.0].map(|x| 1.0 / (1.0 + (-x).exp()));
            let same =
                color.iter().zip(exact).all(|(&c, exact)| (f64::from(c) - exact).abs() < 1e-6);
            assert!(same, "{color:?}");
        }
        assert!(branches.mixed > 0 && branches.empty > 0, "{branches:?}");
    });
}

#[test]
fn one_gaussian() {
    let recipe = Recipe {
        seed: 74,
        gaussians: 1,
        clearness: 5.0,
        log_scale: [-2.0, -0.8],
        opacity: [2.0, 2.1],
        ..Recipe::default()
    };
    let mut scene = recipe.scene();
    scene.gaussians.position = vec![[0.0, 0.0, 0.2]];
    let text = "A, B and C: one Gaussian, its center on the middle pixel's, seen along an axis";
    let camera = camera([0.0, 0.0, -3.0], [23, 23]);
    let shot = Shot::new(["one_gaussian", text], scene.clone(), camera, (23, [0, 0]));
    shot.check(|found, stages, branches| {
        let stages = &stages[0];
        let opacity = 1.0 / (1.0 + (-f64::from(scene.gaussians.opacity[0])).exp());
        let alpha = opacity * f64::from(stages.transmittance[0]);
        for (channel, value) in pixel(found, 0, [11, 11]).into_iter().enumerate() {
            let b = scene.config.background[channel];
            let exact = alpha * f64::from(stages.color[channel]) + (1.0 - alpha) * b;
            assert!((f64::from(value) - exact).abs() < 1e-6, "{value} for {exact}");
        }
        assert_eq!(pixel(found, 0, [0, 0]), background(&scene), "the corner is background");
        assert!(stages.sample_count[0] > 4 && branches.divided == 0, "{branches:?}");
    });
}

#[test]
fn empty_tile() {
    let scene = Recipe { seed: 81, ..Recipe::default() }.scene();
    let text = "C: no Gaussian reaches the tile, which is background to the bit";
    let camera = camera([0.0, 0.4, -3.4], [48, 40]);
    let shot = Shot::new(["empty_tile", text], scene.clone(), camera, (8, [900, -700]));
    shot.check(|found, _, branches| {
        assert!(is_background(found, 0, &scene));
        assert_eq!((found.report.intersections, branches.empty), (0, 64));
    });
}

#[test]
fn crowded_tile() {
    let recipe = Recipe {
        seed: 92,
        gaussians: 300,
        clearness: 5.0,
        log_scale: [-2.7, -1.4],
        opacity: [1.0, 4.0],
        ..Recipe::default()
    };
    let text = "A, B and C: 300 Gaussians in one tile, Eq. 13 divides everywhere (S > 1)";
    let camera = camera([0.5, 0.4, -3.4], [48, 48]);
    let shot = Shot::new(["crowded_tile_divided", text], recipe.scene(), camera, (24, [13, 13]));
    shot.check(|found, stages, branches| {
        assert_eq!(branches, Branches { divided: 24 * 24, ..Branches::default() });
        // a weighted mean of the colors, without any background
        for channel in 0..3 {
            let colors = stages[0].color.iter().skip(channel).step_by(3);
            let low = colors.clone().copied().fold(f32::INFINITY, f32::min);
            let high = colors.copied().fold(f32::NEG_INFINITY, f32::max);
            let value = pixel(found, 0, [12, 12])[channel];
            assert!((low..=high).contains(&value), "{value} in {low}..{high}");
        }
    });
}

#[test]
fn sheer_tile() {
    let recipe = Recipe {
        seed: 101,
        gaussians: 24,
        clearness: 4.0,
        log_scale: [-2.4, -1.4],
        opacity: [-1.2, -0.2],
        ..Recipe::default()
    };
    let names = [
        "sheer_tile_over_background",
        "A, B and C: 24 sheer Gaussians, the background shows everywhere (S < 1)",
    ];
    let camera = camera([-0.6, 0.3, -3.3], [48, 48]);
    let shot = Shot::new(names, recipe.scene(), camera, (24, [12, 12]));
    shot.check(|_, _, branches| {
        assert!(branches.divided == 0 && branches.mixed > 300, "{branches:?}");
    });
}

/// Opaque and transparent Gaussians for both branches of Eq. 13.
fn both() -> Scene {
    let recipe = Recipe {
        seed: 112,
        gaussians: 60,
        clearness: 4.0,
        log_scale: [-2.6, -1.4],
        opacity: [0.0, 3.5],
        ..Recipe::default()
    };
    recipe.scene()
}

#[test]
fn both_branches() {
    let text = "A, B and C: S > 1 in the middle, S < 1 toward the edges of what is seen";
    let camera = camera([0.2, 0.9, -3.6], [36, 36]);
    let shot = Shot::new(["both_branches", text], both(), camera, (36, [0, 0]));
    shot.check(|_, _, branches| {
        assert!(
            branches.divided > 100 && branches.mixed > 100 && branches.empty > 0,
            "{branches:?}"
        );
    });
}

#[test]
fn tiles_over_the_border() {
    let origins =
        [[-9, -7], [12, -8], [33, -6], [-8, 10], [12, 9], [32, 11], [-7, 24], [13, 26], [31, 25]];
    let mut tiles: Vec<Tile> = origins.iter().map(|&[x, y]| tile(0, x, y)).collect();
    tiles.push(tile(0, -300, 5));
    let shot = Shot {
        name: "tiles_over_the_border",
        description: "C: tiles over every border of a 40 x 32 image, rendered all the same; the last lies far outside",
        scene: both(),
        cameras: vec![camera([0.1, 0.0, -2.2], [40, 32])],
        batch: TileBatch { side: 12, tiles },
        columns: 3,
    };
    shot.check(|found, _, _| {
        assert!(is_background(found, 9, &shot.scene), "nothing is out there");
        let touched = (0..9).filter(|&tile| !is_background(found, tile, &shot.scene)).count();
        assert!(touched >= 7, "Gaussians reach over the border: {touched}");
    });
}

#[test]
fn three_cameras_in_a_batch() {
    let eyes = [[0.2, 0.9, -3.6], [3.6, 0.4, 0.5], [-2.0, 2.6, -1.8]];
    let tiles = [(2, 4, 6), (0, 16, 8), (1, 4, 6), (0, 4, 8), (2, 16, 6), (1, 16, 6)];
    let tiles = tiles.map(|(camera, x, y)| tile(camera, x, y));
    let shot = Shot {
        name: "three_cameras",
        description: "C: three cameras in one batch, their tiles in no order: 2, 0, 1 / 0, 2, 1",
        scene: both(),
        cameras: eyes.map(|eye| camera(eye, [32, 32])).to_vec(),
        batch: TileBatch { side: 12, tiles: tiles.to_vec() },
        columns: 3,
    };
    shot.check(|found, _, _| {
        let (_, renderer) = &RENDERERS[0];
        let uploaded = renderer.upload(&shot.scene).expect("the scene fits");
        for (index, tile) in tiles.into_iter().enumerate() {
            let alone = TileBatch { side: 12, tiles: vec![tile] };
            let alone = renderer.render(&uploaded, &shot.cameras, &alone).expect("it renders");
            let values = &found.data[index * 432..][..432];
            let apart = values.iter().zip(&alone.data).map(|(a, b)| (a - b).abs());
            assert!(apart.fold(0.0, f32::max) < 1e-4, "tile {index} is another one alone");
        }
    });
}

#[test]
fn sides_of_tiles() {
    for (side, columns) in [(5, 7), (9, 4), (33, 1)] {
        let name = format!("tiles_of_side_{side:02}");
        let shot = Shot {
            name: &name,
            description: "C: one image of 33 x 33, cut into tiles of another side",
            scene: both(),
            cameras: vec![camera([0.2, 0.9, -3.6], [33, 33])],
            batch: TileBatch::cover(0, 33, 33, side).expect("a batch"),
            columns,
        };
        shot.check(|found, _, _| {
            assert_eq!(found.count, columns * columns);
        });
    }
}

#[test]
fn camera_inside_the_cube() {
    let recipe = Recipe { seed: 121, gaussians: 70, log_scale: [-2.8, -1.8], ..Recipe::default() };
    let text = "A, B and C: Gaussians around the camera; those behind it change nothing";
    let camera = camera_to([0.2, 0.1, -0.3], [-0.4, 0.0, 1.2], [28, 28]);
    let shot = Shot::new(["camera_inside_the_cube", text], recipe.scene(), camera, (28, [0, 0]));
    shot.check(|found, stages, branches| {
        let ahead: Vec<usize> = (0..70).filter(|&i| stages[0].radius[i] >= 0.0).collect();
        assert!((20..60).contains(&ahead.len()) && branches.mixed > 0, "{} ahead", ahead.len());
        let (_, renderer) = &RENDERERS[0];
        let kept = renderer.upload(&keep(&shot.scene, &ahead)).expect("the scene fits");
        let without = renderer.render(&kept, &shot.cameras, &shot.batch).expect("it renders");
        let apart = found.data.iter().zip(&without.data).map(|(a, b)| (a - b).abs());
        assert!(apart.fold(0.0, f32::max) < 1e-4, "what lies behind shows");
    });
}
