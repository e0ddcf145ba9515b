//! One frame of one camera, as a plan: the recorded commands that a page in a browser runs.

use crate::pass::batch::BatchPart;
use crate::pass::part::Part;
use crate::scene::composition::CAMERAS;
use crate::stages::counts::PartCounts;
use crate::stages::cut::{PartTile, PartTiles};
use crate::stages::project::project;
use crate::stages::scan::total;
use crate::stages::tiles::TileBins;
use crate::stages::transmittance::Segments;
use crate::{Capacity, DeviceScene, Renderer};
use organza_core::camera::{Camera, MAX_IMAGE_SIDE};
use organza_core::scene::Placement;
use organza_core::{Result, Tile, TileBatch};

/// The sizes that all frames of a plan share.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameShape {
    /// Number of tiles. A frame puts the tiles that it does not need far outside of its image.
    pub tiles: u32,
    /// Side of a tile, in pixels.
    pub side: u32,
    /// The length of T's steps in multiples of sigma, Eq. 8.
    pub steps: u16,
    /// Capacities of the tables: see [`Renderer::capacities`]. A frame that needs more is empty, and its counts have the overflow flag.
    pub capacities: Vec<Capacity>,
}

/// A frame that a [planner](muslin_device::Device::planner) has recorded, and the numbers of the buffers that the page
/// writes and reads.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Buffers and steps.
    pub plan: muslin_device::DevicePlan,
    /// `[18]`: the camera, as [`organza_shaders::camera::Camera`] packs it, in the coordinates of these places.
    pub cameras: Vec<(u32, Placement)>,
    /// `[tiles, 4]`, for each scene: as [`organza_shaders::tile::Tile`] packs them.
    pub tiles: Vec<u32>,
    /// `[capacities, COUNTS]`: what the frame needed; the first number is a flag for an overflow.
    pub counts: u32,
    /// `[tiles, 3, S, S]`
    pub image: u32,
}

impl Renderer {
    /// The capacities that a camera's image needs, for each of some [steps](FrameShape::steps): one for a scene alone. With
    /// [several](DeviceScene::all), each scene is followed by the capacities of the others' fields, of which only samples matter.
    pub fn capacities(
        &self,
        scene: &DeviceScene,
        camera: &Camera,
        side: u32,
        steps: &[u16],
    ) -> Result<Vec<Vec<Capacity>>> {
        let batch = TileBatch::cover(0, camera.width, camera.height, side)?;
        let device = self.device();
        let scenes = scene.all().count();
        let mut all = vec![vec![Capacity::default(); scenes * scenes]; steps.len()];
        for (index, scene) in scene.all().enumerate() {
            let cameras = std::slice::from_ref(camera);
            for BatchPart { part_tiles, .. } in &self.pass(scene, cameras).cut(&batch)?.list {
                let projection = project(device, scene, &[camera], &part_tiles.windows())?;
                let bins = TileBins::new(scene, part_tiles, projection, None)?;
                let pairs = bins.pairs.count.upper_bound();
                let intersections = bins.intersections.upper_bound();
                for (&steps, all) in steps.iter().zip(&mut all) {
                    for (field, needed) in scene.with_fields().zip(&mut all[index * scenes..]) {
                        let field = &field.with_ray_steps(steps.into());
                        let moved = bins.pairs.with_cameras(field.cameras(&[camera])?);
                        let segments = Segments::new(field, &moved)?;
                        let samples = total(device, &segments.first_sample)?.upper_bound();
                        *needed = needed.plus(Capacity { pairs, intersections, samples });
                        // a pair counts once for each part that has it, so this may be more than needed
                        needed.pairs = needed.pairs.min(scene.gaussians);
                    }
                }
            }
        }
        Ok(all)
    }

    /// Records a frame. The renderer's device is a planner.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory) if a table is larger than a browser can bind.
    pub fn plan_frame(&self, scene: &DeviceScene, shape: &FrameShape) -> Result<Frame> {
        let device = self.device();
        // an earlier error may have left a plan
        drop(device.take_plan());
        // A frame may put its tiles anywhere to the right and below: Gaussians there must not be culled.
        let origin = |place| if place == 0 { [0, 0] } else { [MAX_IMAGE_SIDE as i32; 2] };
        let tile =
            |place| PartTile { tile: Tile { camera: 0, origin: origin(place) }, place, view: 0 };
        let part_tiles =
            PartTiles { side: shape.side, tiles: (0..shape.tiles as usize).map(tile).collect() };
        let eye = [0.0, -1.0, 0.0];
        let camera = Camera::look_at(eye, [0.0; 3], [0.0, 0.0, 1.0], 1.0, [shape.side; 2])?;
        let camera = std::slice::from_ref(&camera);
        let scene = &scene.with_ray_steps(shape.steps.into());
        let counts = PartCounts::new(device, shape.capacities.clone())?;
        let part = Part::evaluate(scene, camera, &part_tiles, false, Some(counts))?;
        let bins = &part.bins;
        let counts = bins.part_counts.as_ref().expect("there is a capacity").counts.planned();
        let number = |buffer: Option<u32>| buffer.expect("the device is a planner");
        let bins = std::iter::once(bins).chain(part.beside.iter().map(|other| &other.bins));
        let tiles = bins.map(|bins| number(bins.tile.planned())).collect();
        let image = number(part.composite.image.planned());
        let plan = device.take_plan();
        let numbered = plan.buffers.iter().zip(plan.first_buffer..);
        let cameras = numbered.filter(|(buffer, _)| buffer.label == CAMERAS);
        let seen = scene.all().flat_map(DeviceScene::with_fields);
        let cameras = cameras.zip(seen).map(|((_, number), scene)| (number, scene.place)).collect();
        Ok(Frame { cameras, tiles, counts: number(counts), image, plan })
    }
}
