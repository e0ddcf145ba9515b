//! The case of `pixels`.

use muslin_check::prelude::*;
use organza_shaders::pixels::{PixelsInputs, PixelsParams};

case!(pub Pixels(PixelsInputs));

impl Pixels {
    fn new(tiles: u32, side: u32, fill: Fill) -> Self {
        let area = side * side;
        let count = tiles * area;
        let mut random = Random::new(5);
        // edges: halves, their neighbors, and both ends
        let edges = (0..256).flat_map(|level| {
            let half = (level as f32 + 0.5) / 255.0;
            [half.next_down(), half, half.next_up(), level as f32 / 255.0]
        });
        let random = fill.values(&mut random, 3 * count as usize, [-0.2, 1.2], 1e30);
        let image = edges.chain(random).take(3 * count as usize).collect();
        Self(PixelsInputs {
            params: PixelsParams { count, area },
            image,
            rgba: unwritten(count as usize),
        })
    }
}

impl Parity for Pixels {
    fn sets() -> Vec<(String, Self)> {
        let mut sets = vec![
            ("edges".into(), Self::new(3, 19, Fill::Random)),
            ("one pixel".into(), Self::new(1, 1, Fill::Random)),
        ];
        for fill in Fill::ADVERSARIAL {
            sets.push((fill.name().into(), Self::new(2, 33, fill)));
        }
        sets
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let area = self.params.area as usize;
        let pixel = |index: usize| {
            let at = index / area * 3 * area + index % area;
            let values = [0, 1, 2].map(|channel| self.image[at + channel * area]);
            let level = |value: f32| f64::from((value.clamp(0.0, 1.0) * 255.0).round() as u8);
            let levels: f64 =
                values.map(level).iter().rev().fold(0.0, |sum, level| 256.0 * sum + level);
            let finite = if values.iter().all(|value| value.is_finite()) { 255.0 } else { 0.0 };
            finite * 16_777_216.0 + levels
        };
        listed((0..self.params.count as usize).map(pixel))
    }
}
