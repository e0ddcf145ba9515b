//! A mesh of what cameras see: their surfaces become one signed distance (Curless and Levoy, A Volumetric Method for Building Complex
//! Models from Range Images, 1996), and surface nets find where it is 0.

use std::sync::atomic::Ordering::Relaxed;
use std::sync::atomic::{AtomicBool, AtomicUsize};

use fast_surface_nets::ndshape::{RuntimeShape, Shape};
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::DVec3;
use organza_core::error::{Result, argument};
use organza_core::memory;
use organza_render::Surface;
use petgraph::unionfind::UnionFind;
use rayon::prelude::*;

/// Distances count up to this many cells on both sides of a surface.
const BAND: f64 = 4.0;
/// Side of a block of points, which are looked at if a surface is near.
const BLOCK: u32 = 8;
/// Parts with a smaller share of all triangles float, and are left out.
const SMALLEST_PART: f64 = 0.01;
/// Fewest cells along the longest side.
const FEWEST_CELLS: u32 = 8;
/// Surface nets count points in 32 bits.
const MOST_POINTS: u64 = u32::MAX as u64;
/// Bytes of a point: its distance, and whether it is seen.
const GRID_BYTES: usize = 5;
/// Bytes of a point that surface nets add.
const NET_BYTES: usize = size_of::<u32>();
/// Purpose of the grid's memory.
const GRID: &str = "a mesh's grid (a smaller `--size` needs less)";
/// Color of a vertex that no camera sees.
const GRAY: [u8; 3] = [128; 3];

/// A mesh with a color at each vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// `[V, 3]`, in the coordinates of the scene.
    pub position: Vec<[f64; 3]>,
    /// `[V, 3]`: sRGB.
    pub color: Vec<[u8; 3]>,
    /// `[F, 3]`: vertices of triangles, counterclockwise as seen from outside.
    pub face: Vec<[u32; 3]>,
}

impl Mesh {
    /// The mesh of the surfaces that cameras see, in a box. Its longest side has `cells` cells; fewer if there would be more than `max`
    /// triangles. What no camera sees has no triangles. `progress` is called with the number of finished layers of the box, and of all.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory);
    /// [`Error::Argument`](organza_core::Error::Argument) if there is no surface in the box, or `max` is too small.
    pub fn of_surfaces(
        surfaces: &[Surface],
        limits: [[f64; 3]; 2],
        cells: u32,
        max: usize,
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Self> {
        let mut cells = cells;
        while cells >= FEWEST_CELLS {
            let grid = Grid::new(limits, cells);
            let mut mesh = grid.mesh(&grid.distances(surfaces, progress)?)?;
            mesh.remove_floating();
            let faces = mesh.face.len();
            if faces == 0 {
                return argument("the views show no surface: all pixels are mostly background");
            }
            if faces <= max {
                mesh.color = mesh.position.par_iter().map(|at| grid.color(surfaces, *at)).collect();
                return Ok(mesh);
            }
            // triangles grow with the square
            cells = (0.97 * f64::from(cells) * (max as f64 / faces as f64).sqrt()) as u32;
        }
        argument(format!("{max} triangles are too few for this scene"))
    }

    /// Removes parts of few triangles, and vertices without triangles.
    fn remove_floating(&mut self) {
        let mut parts = UnionFind::<u32>::new(self.position.len());
        for &[a, b, c] in &self.face {
            parts.union(a, b);
            parts.union(a, c);
        }
        let part = parts.into_labeling();
        let mut triangles = vec![0_usize; part.len()];
        for face in &self.face {
            triangles[part[face[0] as usize] as usize] += 1;
        }
        let fewest = SMALLEST_PART * self.face.len() as f64;
        self.face.retain(|face| triangles[part[face[0] as usize] as usize] as f64 >= fewest);
        let mut place = vec![u32::MAX; self.position.len()];
        let mut kept = Vec::new();
        for vertex in self.face.as_flattened_mut() {
            let place = &mut place[*vertex as usize];
            if *place == u32::MAX {
                *place = kept.len() as u32;
                kept.push(self.position[*vertex as usize]);
            }
            *vertex = *place;
        }
        self.position = kept;
    }
}

/// A box of points at equal distances.
struct Grid {
    low: DVec3,
    cell: f64,
    size: [u32; 3],
}

/// What cameras say of the points of a grid.
struct Distances {
    /// Distance from the surface in multiples of the [`BAND`], up to 1; negative behind it. 1 where no camera looks.
    distance: Vec<f32>,
    is_seen: Vec<bool>,
}

impl Grid {
    fn new([low, high]: [[f64; 3]; 2], cells: u32) -> Self {
        let low = DVec3::from(low);
        let sides = DVec3::from(high) - low;
        let cell = sides.max_element() / f64::from(cells);
        Self { low, cell, size: sides.to_array().map(|side| (side / cell).ceil() as u32 + 2) }
    }

    /// The block of a point.
    fn block(&self, at: [u32; 3]) -> usize {
        let [across, down, _] = self.size.map(|points| points.div_ceil(BLOCK) as usize);
        let [x, y, z] = at.map(|at| (at / BLOCK) as usize);
        (z * down + y) * across + x
    }

    /// Whether a surface is in the band of each block of points.
    fn near(&self, surfaces: &[Surface]) -> Vec<AtomicBool> {
        let [x, y, z] = self.size.map(|points| points - 1);
        let mut near = Vec::new();
        near.resize_with(self.block([x, y, z]) + 1, AtomicBool::default);
        surfaces.par_iter().for_each(|surface| {
            for place in surface.places() {
                let at = (place - self.low) / self.cell;
                for corner in 0..8_u32 {
                    let offset = DVec3::from([1, 2, 4].map(|bit| f64::from((corner & bit).min(1))));
                    let at = (at + BAND * (2.0 * offset - 1.0)).to_array();
                    let mut sides = at.iter().zip(self.size);
                    if sides.all(|(&at, n)| (0.0..f64::from(n)).contains(&at)) {
                        near[self.block(at.map(|at| at as u32))].store(true, Relaxed);
                    }
                }
            }
        });
        near
    }

    /// Means over the cameras that see a point, or see that it is less than a band behind a surface. Only points near surfaces are
    /// looked at.
    fn distances(
        &self,
        surfaces: &[Surface],
        progress: &(dyn Fn(usize, usize) + Sync),
    ) -> Result<Distances> {
        let [width, height, _] = self.size.map(|points| points as usize);
        let points = self.size.iter().map(|&points| u64::from(points)).product::<u64>();
        if points > MOST_POINTS {
            let [x, y, z] = self.size;
            return argument(format!(
                "a grid of {x} x {y} x {z} points is too large, at most {MOST_POINTS} are counted: choose a smaller `--size`"
            ));
        }
        let points = points as usize;
        // that of surface nets, too, which have a number for each point
        memory::check((points * (GRID_BYTES + NET_BYTES)) as u64, GRID)?;
        let mut distance = memory::zeros(points, GRID)?;
        let mut is_seen = memory::zeros(points, GRID)?;
        let near = self.near(surfaces);
        let layers =
            distance.par_chunks_mut(width * height).zip(is_seen.par_chunks_mut(width * height));
        let done = AtomicUsize::new(0);
        layers.enumerate().for_each(|(z, (distance, is_seen))| {
            for (at, (distance, is_seen)) in distance.iter_mut().zip(is_seen).enumerate() {
                *distance = 1.0;
                let at = [at % width, at / width, z];
                if !near[self.block(at.map(|at| at as u32))].load(Relaxed) {
                    continue;
                }
                let place = self.low + self.cell * DVec3::from(at.map(|at| at as f64));
                let of_view = |surface: &Surface| self.in_front(surface, place.to_array());
                let seen = surfaces.iter().filter_map(of_view).map(|(_, cells)| cells / BAND);
                let (sum, views) = seen
                    .filter(|&part| part >= -1.0)
                    .fold((0.0, 0.0), |(sum, views), part| (sum + part.min(1.0), views + 1.0));
                if views > 0.0 {
                    *is_seen = true;
                    *distance = (sum / views) as f32;
                }
            }
            progress(1 + done.fetch_add(1, Relaxed), self.size[2] as usize);
        });
        Ok(Distances { distance, is_seen })
    }

    /// The pixel that shows a place, and how many cells the place is in front of the surface there. `None` if the camera sees no
    /// surface there.
    fn in_front(&self, surface: &Surface, place: [f64; 3]) -> Option<(usize, f64)> {
        let [column, row, depth] = surface.camera.project(place)?;
        let pixel = row as usize * surface.camera.width as usize + column as usize;
        let there = surface.depth[pixel];
        (there > 0.0).then(|| (pixel, (f64::from(there) - depth) / self.cell))
    }

    /// The surface between seen points.
    fn mesh(&self, distances: &Distances) -> Result<Mesh> {
        let shape = RuntimeShape::<u32, 3>::new(self.size);
        let last = self.size.map(|points| points - 1);
        let mut net = SurfaceNetsBuffer::default();
        surface_nets(&distances.distance, &shape, [0; 3], last, &mut net);
        let corner = |corner: u32| shape.linearize([corner & 1, corner >> 1 & 1, corner >> 2]);
        let is_seen = |vertex: u32| {
            let first = net.surface_strides[vertex as usize];
            (0..8).all(|at| distances.is_seen[(first + corner(at)) as usize])
        };
        let position = net.positions.iter().map(|&[x, y, z]| {
            (self.low + self.cell * DVec3::new(x.into(), y.into(), z.into())).to_array()
        });
        let (faces, _) = net.indices.as_chunks::<3>();
        let face = faces.iter().filter(|face| face.iter().all(|&vertex| is_seen(vertex)));
        Ok(Mesh { position: position.collect(), color: Vec::new(), face: face.copied().collect() })
    }

    /// The mean color of a place of the surface in the views that show it.
    fn color(&self, surfaces: &[Surface], place: [f64; 3]) -> [u8; 3] {
        let pixel = |surface: &Surface| {
            let (pixel, cells) = self.in_front(surface, place)?;
            Some((cells.abs() <= BAND).then(|| surface.color[pixel].map(f64::from)))
        };
        let shown = surfaces.iter().filter_map(pixel).flatten().map(DVec3::from);
        let (sum, views) = shown.fold((DVec3::ZERO, 0.0), |(sum, n), color| (sum + color, n + 1.0));
        if views == 0.0 { GRAY } else { (sum / views).round().to_array().map(|level| level as u8) }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::HashMap;

    use organza_core::Camera;

    use super::*;

    const NO_BAR: &(dyn Fn(usize, usize) + Sync) = &|_, _| {};

    /// What cameras around a ball of radius 1 see of it; the red of a pixel is the ball's height there. One sees a small thing in
    /// front of it, too.
    fn ball() -> Vec<Surface> {
        let of_view = |index: usize| {
            let turn = 2.4 * index as f64;
            let z: f64 = 0.9 - index as f64 * 0.06;
            let across = (1.0 - z * z).sqrt();
            let eye = 4.0 * DVec3::new(across * turn.cos(), across * turn.sin(), z);
            let up = [0.0, 0.1, 1.0];
            let camera = Camera::look_at(eye.to_array(), [0.0; 3], up, 0.7, [120, 120]).unwrap();
            let pixel = |at: usize| {
                let ray = camera.ray([at % 120, at / 120].map(|at| at as f64 + 0.5));
                let [a, b] = [ray.length_squared(), ray.dot(eye)];
                let root = b * b - a * (eye.length_squared() - 1.0);
                let depth = if root < 0.0 { 0.0 } else { (-b - root.sqrt()) / a };
                let height = ((eye + depth * ray).z * 100.0 + 128.0) as u8;
                let is_floating = index == 0 && (58..62).contains(&(at % 120)) && at / 120 == 60;
                (if is_floating { 2.0 } else { depth as f32 }, [height, 0, 0])
            };
            let (depth, color) = (0..120 * 120).map(pixel).unzip();
            Surface { camera, depth, color }
        };
        (0..31).map(of_view).collect()
    }

    #[test]
    fn the_mesh_of_a_ball_is_the_ball() {
        let limits = [[-1.5; 3], [1.5; 3]];
        let mesh = Mesh::of_surfaces(&ball(), limits, 60, usize::MAX, NO_BAR).unwrap();
        let cell = 3.0 / 60.0;
        let off = mesh.position.iter().map(|at| (DVec3::from(*at).length() - 1.0).abs());
        let mean = off.clone().sum::<f64>() / mesh.position.len() as f64;
        assert!(off.fold(0.0, f64::max) < cell && mean < 0.2 * cell, "{mean}");
        // closed: as many triangles on one side of an edge as on the other
        let mut edges = HashMap::new();
        for &[a, b, c] in &mesh.face {
            for edge in [[a, b], [b, c], [c, a]] {
                *edges.entry(edge).or_insert(0) += 1;
            }
        }
        assert!(edges.iter().all(|([a, b], n)| edges.get(&[*b, *a]) == Some(n)));
        let corner = |vertex: u32| DVec3::from(mesh.position[vertex as usize]);
        let volume = mesh.face.iter().map(|&[a, b, c]| corner(a).dot(corner(b).cross(corner(c))));
        let volume = volume.sum::<f64>() / 6.0;
        assert!((volume - 4.189).abs() < 0.1, "the volume is {volume}");
        for (place, color) in mesh.position.iter().zip(&mesh.color) {
            let expected = place[2] * 100.0 + 128.0;
            assert!((f64::from(color[0]) - expected).abs() < 8.0, "{place:?} {color:?}");
        }
    }

    #[test]
    fn triangles_are_limited_and_what_is_not_seen_has_none() {
        let limits = [[-1.5; 3], [1.5; 3]];
        let mesh = Mesh::of_surfaces(&ball(), limits, 60, 2000, NO_BAR).unwrap();
        assert!((1000..=2000).contains(&mesh.face.len()), "{}", mesh.face.len());
        let one = Mesh::of_surfaces(&ball()[..1], limits, 60, usize::MAX, NO_BAR).unwrap();
        let eye = DVec3::from(ball()[0].camera.eye()).normalize();
        let is_before = |at: &[f64; 3]| DVec3::from(*at).dot(eye) > 0.0;
        assert!(one.position.iter().all(is_before), "the side that the camera sees");
        assert!(Mesh::of_surfaces(&ball(), limits, 60, 3, NO_BAR).is_err());
        let nothing = ball().into_iter().map(|view| Surface { depth: vec![0.0; 14_400], ..view });
        let large = Mesh::of_surfaces(&[], limits, 2048, usize::MAX, NO_BAR).unwrap_err();
        assert!(large.to_string().contains("2050 x 2050 x 2050 points"), "{large}");
        assert!(Mesh::of_surfaces(&nothing.collect::<Vec<_>>(), limits, 60, 2000, NO_BAR).is_err());
    }
}
