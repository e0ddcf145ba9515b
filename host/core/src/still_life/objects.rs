//! What stands on the table, its shapes and surfaces, and how the light falls on it.

use glam::{DMat3, DVec2, DVec3};
use rand::RngExt;
use rand_pcg::Pcg64;

/// Light of the sun and of the sky, on a surface that faces them.
const SUN: DVec3 = DVec3::new(0.95, 0.88, 0.76);
const SKY: DVec3 = DVec3::new(0.34, 0.38, 0.44);
/// Tangent of the sun's radius: larger than the true one, as through a window.
const SUN_RADIUS: f64 = 0.04;
/// Blinn and Phong's exponent of glossy surfaces.
const SHINE: f64 = 60.0;
/// Half the sides of the cloth.
const CLOTH: f64 = 1.05;

/// A thing of the still life.
#[derive(Clone, Copy, Debug)]
struct Thing {
    center: DVec3,
    /// World to the shape's axes.
    turn: DMat3,
    shape: Shape,
    surface: Surface,
}

/// A place that a ray has reached.
struct Place {
    position: DVec3,
    normal: DVec3,
    color: DVec3,
    gloss: f64,
    thing: Option<usize>,
}

/// All things, on a floor at z = 0.
#[derive(Debug)]
pub struct Objects {
    things: Vec<Thing>,
    sun: DVec3,
}

impl Objects {
    pub fn new() -> Self {
        let thing = |center: [f64; 3], degrees: f64, shape, surface| Thing {
            center: DVec3::from(center),
            turn: DMat3::from_rotation_z(-degrees.to_radians()),
            shape,
            surface,
        };
        let sphere = |radius| Shape::Sphere { radius };
        let block = |x, y, z| Shape::Block { half: DVec3::new(x, y, z) };
        let red = Surface::Book(DVec3::new(0.42, 0.07, 0.06));
        let green = Surface::Book(DVec3::new(0.10, 0.26, 0.16));
        let things = vec![
            thing([-0.38, 0.22, 0.06], 20.0, block(0.36, 0.27, 0.06), green),
            thing([-0.40, 0.20, 0.17], 33.0, block(0.31, 0.24, 0.05), red),
            thing([-0.42, 0.22, 0.42], 0.0, sphere(0.20), Surface::Stripes),
            thing(
                [0.34, 0.30, 0.21],
                0.0,
                Shape::Cylinder { radius: 0.17, half: 0.21 },
                Surface::Glaze,
            ),
            thing([0.52, -0.28, 0.13], -25.0, block(0.13, 0.13, 0.13), Surface::Diamonds),
            thing([0.06, -0.30, 0.12], 0.0, sphere(0.12), Surface::Peel),
            thing([-0.17, -0.42, 0.11], 0.0, sphere(0.11), Surface::Peel),
            thing([0.22, -0.55, 0.10], 0.0, sphere(0.10), Surface::Peel),
        ];
        Self { things, sun: DVec3::new(-0.55, -0.35, 0.85).normalize() }
    }

    /// The light that comes back along a ray, which starts above the floor.
    pub fn light(&self, origin: DVec3, direction: DVec3, random: &mut Pcg64) -> DVec3 {
        let Some(place) = self.place(origin, direction) else { return SKY };
        let mut any = || 2.0 * random.random::<f64>() - 1.0;
        let sun = (self.sun + SUN_RADIUS * DVec3::new(any(), any(), any())).normalize();
        let facing = place.normal.dot(sun).max(0.0);
        let is_lit = facing > 0.0 && !self.is_hidden(place.position + 1e-6 * place.normal, sun);
        let open = 0.5 * (1.0 + place.normal.z) * self.openness(&place) + 0.15;
        let mut light = open * SKY * place.color;
        if is_lit {
            let between = (sun - direction).normalize();
            let shine = place.gloss * place.normal.dot(between).max(0.0).powf(SHINE);
            light += SUN * (facing * place.color + DVec3::splat(shine));
        }
        light
    }

    /// The first thing that a ray meets.
    fn first(&self, origin: DVec3, direction: DVec3) -> Option<(usize, Meeting)> {
        let meetings = self.things.iter().enumerate().filter_map(|(index, thing)| {
            let from = thing.turn * (origin - thing.center);
            Some((index, thing.shape.meeting(from, thing.turn * direction)?))
        });
        meetings.min_by(|a, b| a.1.distance.total_cmp(&b.1.distance))
    }

    fn is_hidden(&self, origin: DVec3, direction: DVec3) -> bool {
        self.first(origin, direction).is_some()
    }

    /// Where a ray ends: at a thing or on the floor. A ray into the sky has no end.
    fn place(&self, origin: DVec3, direction: DVec3) -> Option<Place> {
        if let Some((index, meeting)) = self.first(origin, direction) {
            let thing = &self.things[index];
            let position = origin + meeting.distance * direction;
            let at = thing.turn * (position - thing.center);
            return Some(Place {
                position,
                normal: thing.turn.transpose() * meeting.normal,
                color: thing.surface.color(at, meeting.normal),
                gloss: thing.surface.gloss(),
                thing: Some(index),
            });
        }
        if direction.z >= 0.0 {
            return None;
        }
        let position = origin - origin.z / direction.z * direction;
        let is_cloth = position.truncate().abs().max_element() < CLOTH;
        let surface = if is_cloth { Surface::Cloth } else { Surface::Boards };
        let color = surface.color(position, DVec3::Z);
        Some(Place { position, normal: DVec3::Z, color, gloss: 0.0, thing: None })
    }

    /// The part of the sky that a place sees past the other things, each as a ball: a ball of radius r at distance d hides
    /// (r/d)^2 times the cosine of its direction.
    fn openness(&self, place: &Place) -> f64 {
        let others =
            self.things.iter().enumerate().filter(|(index, _)| place.thing != Some(*index));
        others
            .map(|(_, thing)| {
                let toward = thing.center - place.position;
                let part = (thing.shape.size() / toward.length()).min(1.0).powi(2);
                1.0 - part * place.normal.dot(toward.normalize()).clamp(0.0, 1.0)
            })
            .product()
    }
}

/// Shortest distance of a meeting: a ray that leaves a surface does not meet it again.
const NEAREST: f64 = 1e-6;

/// A shape around its own center, whose axis is z.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere {
        radius: f64,
    },
    /// Half its sides.
    Block {
        half: DVec3,
    },
    /// A cylinder with two lids.
    Cylinder {
        radius: f64,
        half: f64,
    },
}

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// Distance in lengths of the ray's direction.
    pub distance: f64,
    /// Outward unit normal.
    pub normal: DVec3,
}

impl Shape {
    /// The first place where a ray meets the shape. It starts outside.
    pub fn meeting(self, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        let distance = match self {
            Self::Sphere { radius } => sphere(origin, direction, radius),
            Self::Block { half } => block(origin, direction, half),
            Self::Cylinder { radius, half } => cylinder(origin, direction, radius, half),
        };
        let distance = distance.filter(|distance| *distance > NEAREST)?;
        Some(Meeting { distance, normal: self.normal(origin + distance * direction) })
    }

    /// Radius of a ball around the center that is as large as the shape, roughly.
    pub fn size(self) -> f64 {
        match self {
            Self::Sphere { radius } => radius,
            Self::Block { half } => half.element_product().cbrt() * 1.2,
            Self::Cylinder { radius, half } => (radius * radius * half).cbrt() * 1.1,
        }
    }

    /// The outward normal at a place of the surface.
    fn normal(self, place: DVec3) -> DVec3 {
        match self {
            Self::Sphere { .. } => place.normalize(),
            Self::Block { half } => {
                let part = place / half;
                let along = part.abs();
                let is_outermost = along.cmpeq(DVec3::splat(along.max_element()));
                DVec3::select(is_outermost, part.signum(), DVec3::ZERO).normalize()
            }
            Self::Cylinder { radius, half } => {
                let flat = place.truncate();
                match place.z.abs() / half > flat.length() / radius {
                    true => DVec3::Z * place.z.signum(),
                    false => flat.extend(0.0).normalize(),
                }
            }
        }
    }
}

/// The nearer root of `a t^2 + 2 b t + c`.
fn roots(a: f64, b: f64, c: f64) -> Option<[f64; 2]> {
    let root = (b * b - a * c).sqrt();
    (a > 0.0 && root.is_finite()).then(|| [(-b - root) / a, (-b + root) / a])
}

fn sphere(origin: DVec3, direction: DVec3, radius: f64) -> Option<f64> {
    let c = origin.length_squared() - radius * radius;
    Some(roots(direction.length_squared(), origin.dot(direction), c)?[0])
}

/// Where a ray is between the two planes of each axis (Kay and Kajiya, "Ray tracing complex scenes", 1986).
fn block(origin: DVec3, direction: DVec3, half: DVec3) -> Option<f64> {
    let low = (-half - origin) / direction;
    let high = (half - origin) / direction;
    let enters = low.min(high).max_element();
    let leaves = low.max(high).min_element();
    (enters <= leaves).then_some(enters)
}

fn cylinder(origin: DVec3, direction: DVec3, radius: f64, half: f64) -> Option<f64> {
    let at: DVec2 = origin.truncate();
    let along = direction.truncate();
    let c = at.length_squared() - radius * radius;
    let [enters, leaves] = roots(along.length_squared(), at.dot(along), c)?;
    let lids = [-half, half].map(|lid| (lid - origin.z) / direction.z);
    let enters = enters.max(lids[0].min(lids[1]));
    let leaves = leaves.min(lids[0].max(lids[1]));
    (enters <= leaves).then_some(enters)
}

/// What something is made of.
#[derive(Clone, Copy, Debug)]
pub enum Surface {
    /// Boards along y.
    Boards,
    /// A woven cloth with checks.
    Cloth,
    /// A ball with painted stripes.
    Stripes,
    /// A glazed vessel with a painted band.
    Glaze,
    /// An orange.
    Peel,
    /// A painted block with a pattern of diamonds.
    Diamonds,
    /// A book: pages between covers of a color.
    Book(DVec3),
}

impl Surface {
    /// The color at a place of the surface, as the part of light that it throws back: 0 to 1.
    pub fn color(self, at: DVec3, normal: DVec3) -> DVec3 {
        match self {
            Self::Boards => boards(at),
            Self::Cloth => cloth(at),
            Self::Stripes => stripes(at),
            Self::Glaze => glaze(at, normal),
            Self::Peel => peel(at),
            Self::Diamonds => diamonds(at, normal),
            Self::Book(cover) => book(at, normal, cover),
        }
    }

    /// How much of the light is thrown back as by a mirror.
    pub fn gloss(self) -> f64 {
        match self {
            Self::Glaze => 0.35,
            Self::Stripes | Self::Peel => 0.15,
            _ => 0.0,
        }
    }
}

fn boards(at: DVec3) -> DVec3 {
    let board = (at.x / 0.31).floor();
    let shift = at.y + 7.3 * noise(DVec3::new(board, 0.5, 0.5));
    let grain = clouds(DVec3::new(70.0 * at.x, 5.0 * shift, board));
    let tone = noise(DVec3::new(board, (shift / 2.2).floor(), 9.5));
    let joint = (at.x / 0.31 - board).min(0.5).min((shift / 2.2).rem_euclid(1.0) * 7.0);
    let dark = if joint < 0.02 { 0.35 } else { 1.0 };
    dark * (0.45 + 0.35 * tone + 0.5 * grain) * DVec3::new(0.42, 0.26, 0.14)
}

fn cloth(at: DVec3) -> DVec3 {
    let check = |x: f64| ((x / 0.16).rem_euclid(2.0) < 0.9) as u8;
    let color = match check(at.x) + check(at.y) {
        0 => DVec3::new(0.82, 0.78, 0.68),
        1 => DVec3::new(0.45, 0.52, 0.62),
        _ => DVec3::new(0.12, 0.20, 0.38),
    };
    let weave = (260.0 * at.x).sin() * (260.0 * at.y).sin();
    let thread = |x: f64| (x / 0.08).rem_euclid(4.0) < 0.12;
    let color = if thread(at.x) || thread(at.y) { DVec3::new(0.62, 0.12, 0.10) } else { color };
    (0.85 + 0.08 * weave + 0.3 * clouds(18.0 * at) - 0.15) * color
}

fn stripes(at: DVec3) -> DVec3 {
    const PAINTS: [DVec3; 4] = [
        DVec3::new(0.70, 0.13, 0.10),
        DVec3::new(0.85, 0.78, 0.62),
        DVec3::new(0.08, 0.34, 0.32),
        DVec3::new(0.85, 0.55, 0.12),
    ];
    let wave = 0.02 * (6.0 * at.y.atan2(at.x)).sin();
    let stripe = ((at.z + wave) / 0.065).floor();
    let paint = PAINTS[stripe.rem_euclid(4.0) as usize];
    (0.8 + 0.4 * clouds(14.0 * at)) * paint
}

fn glaze(at: DVec3, normal: DVec3) -> DVec3 {
    let white = (0.9 + 0.12 * clouds(30.0 * at)) * DVec3::new(0.80, 0.80, 0.76);
    let blue = DVec3::new(0.05, 0.12, 0.38);
    let angle = 8.0 * at.y.atan2(at.x) / std::f64::consts::TAU;
    let zigzag = 0.07 * (2.0 * (angle.rem_euclid(1.0) - 0.5).abs());
    let is_painted = (at.z - zigzag).abs() < 0.018 || (at.z + 0.09).abs() < 0.012;
    if is_painted && normal.z.abs() < 0.5 { blue } else { white }
}

fn peel(at: DVec3) -> DVec3 {
    let dimples = noise(110.0 * at);
    (0.75 + 0.25 * dimples + 0.2 * clouds(12.0 * at)) * DVec3::new(0.80, 0.36, 0.05)
}

fn diamonds(at: DVec3, normal: DVec3) -> DVec3 {
    let [u, v] = on_face(at, normal).to_array().map(|x| x / 0.11);
    let at_diamond = DVec2::new((u + v).floor(), (u - v).floor());
    let tone = hash([at_diamond.x as i64, at_diamond.y as i64, normal.x as i64 + 2]);
    let color = DVec3::new(0.14, 0.34, 0.20).lerp(DVec3::new(0.88, 0.74, 0.36), tone);
    (0.8 + 0.35 * clouds(20.0 * at)) * color
}

fn book(at: DVec3, normal: DVec3, cover: DVec3) -> DVec3 {
    if normal.z.abs() < 0.5 {
        let page = 0.75 + 0.25 * noise(DVec3::new(3.0 * at.x, 3.0 * at.y, 420.0 * at.z));
        return page * DVec3::new(0.78, 0.72, 0.58);
    }
    // Lines of print, which end where words do.
    let word = noise(DVec3::new(24.0 * at.x, (at.y / 0.036).floor(), 1.5));
    let is_print = (at.y / 0.036).rem_euclid(1.0) < 0.45 && at.y.abs() < 0.2 && word > 0.45;
    let worn = 0.75 + 0.5 * clouds(9.0 * at);
    if is_print { worn * DVec3::new(0.85, 0.76, 0.48) } else { worn * cover }
}

/// A place of a block's face, in the two axes of the face.
fn on_face(at: DVec3, normal: DVec3) -> DVec2 {
    let along = normal.abs();
    match along.max_element() {
        most if most == along.x => DVec2::new(at.y, at.z),
        most if most == along.y => DVec2::new(at.x, at.z),
        _ => DVec2::new(at.x, at.y),
    }
}

/// Noise of four octaves, 0 to 1.
fn clouds(at: DVec3) -> f64 {
    let octave = |octave: i32| {
        let scale = f64::from(1 << octave);
        noise(scale * at) / scale
    };
    (0..4).map(octave).sum::<f64>() / 1.875
}

/// Noise between the points of a lattice, 0 to 1 (Perlin's value noise).
fn noise(at: DVec3) -> f64 {
    let corner = at.floor();
    let part = at - corner;
    let part = part * part * (3.0 - 2.0 * part);
    let [x, y, z] = corner.to_array().map(|x| x as i64);
    let value = |bits: i64| hash([x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2)]);
    let mix = |a: f64, b: f64, part: f64| a + part * (b - a);
    let along_x = |bits: i64| mix(value(bits), value(bits + 1), part.x);
    let along_y = |bits: i64| mix(along_x(bits), along_x(bits + 2), part.y);
    mix(along_y(0), along_y(4), part.z)
}

/// A number from 0 to 1 for a point of a lattice.
fn hash([x, y, z]: [i64; 3]) -> f64 {
    let mut bits = (x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77);
    bits = (bits ^ (z as u32).wrapping_mul(0xc2b2_ae3d)).wrapping_mul(0x27d4_eb2f);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2c1b_3c6d);
    f64::from(bits ^ (bits >> 12)) / f64::from(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::random;
    use rand::RngExt;

    /// Negative inside, zero on the surface.
    fn outside(shape: Shape, at: DVec3) -> f64 {
        match shape {
            Shape::Sphere { radius } => at.length() - radius,
            Shape::Block { half } => (at.abs() - half).max_element(),
            Shape::Cylinder { radius, half } => {
                (at.truncate().length() - radius).max(at.z.abs() - half)
            }
        }
    }

    /// A march in small steps finds the same places, and differences of `outside` the same normals.
    #[test]
    fn rays_meet_shapes_where_a_march_does() {
        let mut random = random(5, 0, 0);
        let mut any = || 2.0 * random.random::<f64>() - 1.0;
        let half = DVec3::new(0.3, 0.5, 0.2);
        let block = Shape::Block { half };
        let cylinder = Shape::Cylinder { radius: 0.4, half: 0.3 };
        let mut met = 0;
        for shape in [Shape::Sphere { radius: 0.45 }, block, cylinder] {
            for _ in 0..300 {
                let origin = 2.0 * DVec3::new(any(), any(), any()).normalize();
                let direction = (0.6 * DVec3::new(any(), any(), any()) - origin).normalize();
                let place = |distance: f64| origin + distance * direction;
                let marched = (0..4000).map(|step| f64::from(step) * 1e-3);
                let marched = marched.into_iter().find(|&at| outside(shape, place(at)) < 0.0);
                let found = shape.meeting(origin, direction);
                let (Some(at), Some(found)) = (marched, found) else {
                    // A march passes over what is thinner than its steps.
                    assert!(marched.is_none(), "{shape:?} {origin} {direction}");
                    continue;
                };
                met += 1;
                assert!((0.0..2e-3).contains(&(at - found.distance)), "{at} {found:?}");
                let surface = place(found.distance);
                let slope = |axis: DVec3| {
                    let ahead = outside(shape, surface + 1e-7 * axis);
                    (ahead - outside(shape, surface - 1e-7 * axis)) / 2e-7
                };
                let slopes = DVec3::new(slope(DVec3::X), slope(DVec3::Y), slope(DVec3::Z));
                assert!(slopes.distance(found.normal) < 1e-3, "{slopes} {found:?}");
            }
        }
        assert!(met > 300, "{met}");
    }
}
