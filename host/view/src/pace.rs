//! Chooses the coarseness of images while the camera moves, so that motion is fluid on this device and with this
//! scene.

/// Target time for the other parts of a moving image, in seconds: projection, composite and encoding.
const DRAW: f64 = 0.030;
/// Target time for colors and transmittances of a moving image, in seconds.
const FIELDS: f64 = 0.040;
/// Longest time for colors and transmittances with steps up to [`FAITHFUL_STEPS`], in seconds. Longer steps miss thin
/// surfaces, so a slower image comes first.
const FAITHFUL_FIELDS: f64 = 0.150;
/// Longest of T's steps that still find thin surfaces, as a multiple of sigma.
const FAITHFUL_STEPS: u16 = 2;
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
        Self { shrink: 2, steps: FAITHFUL_STEPS }
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
        if fields > Self::most(self.steps) {
            self.steps = (2 * self.steps).min(MAX_STEPS);
        } else if fields > 0.002 && 2.0 * fields < 0.6 * Self::most(self.steps / 2) {
            self.steps = (self.steps / 2).max(1);
        }
    }

    /// The most seconds that colors and transmittances may take with these steps.
    fn most(steps: u16) -> f64 {
        if steps == FAITHFUL_STEPS { FAITHFUL_FIELDS } else { FIELDS }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_settles_where_an_image_takes_its_time() {
        // seconds of a whole image, and of all its samples
        for (whole, samples) in [(0.01, 0.01), (0.1, 0.1), (0.1, 0.2), (0.25, 0.5), (5.0, 5.0)] {
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
            assert!(samples / f64::from(steps) <= Pace::most(steps) || steps == MAX_STEPS);
            // thin surfaces are missed only where the image would take too long
            assert!(
                steps <= FAITHFUL_STEPS || samples > 2.0 * FAITHFUL_FIELDS,
                "{samples}: {steps}"
            );
        }
    }
}
