//! The patterns of surfaces: formulas of a place on them.

use glam::{DVec2, DVec3};

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
