//! How coarse an image is while the camera moves, so that it is fluid on this device and with this scene.

/// The time that the rest of a moving image is to take, in seconds: projection, composite and encoding.
const DRAW: f64 = 0.030;
/// The time that colors and transmittances of a moving image are to take, in seconds.
const FIELDS: f64 = 0.040;
/// Sides of moving images are divided by up to this.
const MAX_SHRINK: u32 = 4;
/// Steps of T are up to so many times as long.
const MAX_STEPS: u16 = 32;

/// What a client's images are painted with while its camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Sides are divided by this.
    pub shrink: u32,
    /// Steps of T are longer by this.
    pub steps: u16,
}

impl Default for Pace {
    fn default() -> Self {
        Self { shrink: 2, steps: 4 }
    }
}

impl Pace {
    /// After an image whose fields and whose rest have taken so many seconds.
    pub fn learn(&mut self, fields: f64, draw: f64) {
        let per_side = f64::from(self.shrink) / f64::from(self.shrink.max(2) - 1);
        if draw > DRAW {
            self.shrink = (self.shrink + 1).min(MAX_SHRINK);
        } else if draw * per_side * per_side < 0.6 * DRAW {
            self.shrink = (self.shrink - 1).max(1);
        }
        // where all is known there is nothing to learn
        if fields > FIELDS {
            self.steps = (2 * self.steps).min(MAX_STEPS);
        } else if fields > 0.002 && 2.0 * fields < 0.6 * FIELDS {
            self.steps = (self.steps / 2).max(1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_settles_where_an_image_takes_its_time() {
        // seconds of a whole image, and of every sample
        for (whole, samples) in [(0.01, 0.01), (0.1, 0.1), (0.25, 0.5), (5.0, 5.0)] {
            let mut pace = Pace::default();
            let mut seen = Vec::new();
            for _ in 0..40 {
                let area = f64::from(pace.shrink * pace.shrink);
                pace.learn(samples / f64::from(pace.steps), whole / area);
                seen.push(pace);
            }
            assert!(seen[20..].iter().all(|pace| *pace == seen[20]), "{whole}: {seen:?}");
            let Pace { shrink, steps } = seen[20];
            let area = f64::from(shrink * shrink);
            assert!(whole / area <= DRAW || shrink == MAX_SHRINK, "{whole}: {shrink}");
            assert!(samples / f64::from(steps) <= FIELDS || steps == MAX_STEPS);
        }
    }
}
