//! Chooses the coarseness of images while the camera moves, so that motion is fluid on this device and with this
//! scene.

/// Target time for the other parts of a moving image, in seconds: projection, composite and encoding.
const DRAW: f64 = 0.030;
/// Target time for colors and transmittances of a moving image, in seconds.
const FIELDS: f64 = 0.040;
/// Largest divisor of the sides of moving images.
const MAX_SHRINK: u32 = 4;
/// Largest length of T's steps, as a multiple of sigma.
const MAX_STEPS: u16 = 32;

/// The coarseness of a client's images while its camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Divisor of the image's sides.
    pub shrink: u32,
    /// Factor of the length of T's steps.
    pub steps: u16,
}

impl Default for Pace {
    fn default() -> Self {
        Self { shrink: 2, steps: 4 }
    }
}

impl Pace {
    /// Adapts to an image whose fields and other parts took this many seconds.
    pub fn learn(&mut self, fields: f64, draw: f64) {
        let per_side = f64::from(self.shrink) / f64::from(self.shrink.max(2) - 1);
        if draw > DRAW {
            self.shrink = (self.shrink + 1).min(MAX_SHRINK);
        } else if draw * per_side * per_side < 0.6 * DRAW {
            self.shrink = (self.shrink - 1).max(1);
        }
        // if all was known already, the time says nothing
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
        // seconds of a whole image, and of all its samples
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
