//! Shapes and where rays meet them.

use glam::{DVec2, DVec3};

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
