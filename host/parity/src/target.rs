//! The case of `target_tiles`.

use muslin_check::prelude::*;
use organza_shaders::target::{TargetParams, TargetTile, TargetTilesInputs};

case!(pub TargetTiles(TargetTilesInputs));

/// Width and height of the photographs, one after the other in `pixels`.
const SIZES: [[u32; 2]; 2] = [[21, 13], [9, 30]];

impl TargetTiles {
    /// Tiles that lie within a photograph, across each of its borders, and outside; one in `invalid` pixels is not valid.
    fn new(side: u32, factor: u32, invalid: u32) -> Self {
        let mut random = Random::new(u64::from(side + 100 * factor));
        let mut first = 0;
        let mut tiles = Vec::new();
        for [width, height] in SIZES {
            let far = (width.max(height) / factor) as i32;
            for [x, y] in [[0, 0], [-3, 2], [2, -(side as i32)], [far - 4, 1], [1, far - 2]] {
                tiles.push(TargetTile { first, width, height, x, y, place: 0 });
            }
            first += width * height;
        }
        // in the reverse order
        for (place, tile) in tiles.iter_mut().rev().enumerate() {
            tile.place = place as u32;
        }
        let pixel = |random: &mut Random| {
            let is_valid = random.below(invalid) > 0;
            random.bits() >> 8 | if is_valid { 255 << 24 } else { 0 }
        };
        let values = tiles.len() * (side * side) as usize;
        Self(TargetTilesInputs {
            params: TargetParams { side, factor, share: 1.0 / (factor * factor) as f32 },
            tile: tiles,
            level: (0..256).map(|level| level as f32 / 255.0).collect(),
            pixels: (0..first).map(|_| pixel(&mut random)).collect(),
            image: unwritten(3 * values),
            valid: unwritten(values),
        })
    }

    /// Red, green and blue of a pixel of a tile's place, if it is valid.
    fn color(&self, place: usize, at: usize) -> Option<[Rounded; 3]> {
        let TargetParams { side, factor, .. } = self.params;
        let tile = self.tile.iter().find(|tile| tile.place as usize == place)?;
        let x = tile.x + at as i32 % side as i32;
        let y = tile.y + at as i32 / side as i32;
        let within = |at: i32, length: u32| (0..(length / factor) as i32).contains(&at);
        if !within(x, tile.width) || !within(y, tile.height) {
            return None;
        }
        let mut sum = [Rounded::exact(0.0); 3];
        for row in y as u32 * factor..(y as u32 + 1) * factor {
            for column in x as u32 * factor..(x as u32 + 1) * factor {
                let [r, g, b, valid] =
                    self.pixels[(tile.first + row * tile.width + column) as usize].to_le_bytes();
                if valid == 0 {
                    return None;
                }
                let levels = [r, g, b].map(|byte| Rounded::from(f64::from(byte) / 255.0));
                sum.iter_mut().zip(levels).for_each(|(sum, level)| *sum = *sum + level);
            }
        }
        Some(sum.map(|sum| sum / Rounded::from(factor * factor)))
    }
}

impl Parity for TargetTiles {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = Vec::new();
        for [side, factor, invalid] in
            [[1, 1, 9], [8, 1, 3], [17, 1, 50], [8, 2, 20], [5, 2, 1], [7, 3, 100], [40, 1, 9]]
        {
            let name = format!("side {side}, factor {factor}, one of {invalid} not valid");
            sets.push((name, Self::new(side, factor, invalid)));
        }
        sets
    }

    fn exact_at(&self, output: &str, index: usize) -> Option<Rounded> {
        let area = (self.params.side * self.params.side) as usize;
        let plane = index / area;
        Some(match output {
            "valid" => u32::from(self.color(plane, index % area).is_some()).into(),
            _ => self.color(plane / 3, index % area).map_or(0.into(), |color| color[plane % 3]),
        })
    }
}
