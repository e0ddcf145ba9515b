//! Chooses the coarseness of images while the camera moves, so that motion is fluid on this device and with this
//! scene.

use organza_render::FieldWork;

/// Target time for the other parts of a moving image, in seconds: projection, composite and encoding.
const DRAW: f64 = 0.030;
/// Target time for colors and transmittances of a moving image, in seconds. If the other parts take longer, so may these.
const FIELDS: f64 = 0.060;
/// Their longest time. A fast motion may ask for that much: an image that comes late is better than a wrong one.
const LONGEST: f64 = 1.0;
/// Longest of T's steps, as a multiple of sigma. Longer ones miss thin surfaces.
const MAX_STEPS: u16 = 2;
/// The values of a Gaussian are at most about this many images old, however slow the device is.
const MAX_AGE: usize = 16;
/// Largest divisor of the sides of moving images.
const MAX_SHRINK: u32 = 4;

/// The coarseness of a client's images while its camera moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pace {
    /// Divisor of the image's sides.
    pub shrink: u32,
    /// Factor of the length of T's steps.
    pub steps: u16,
    /// The smallest and the largest number of Gaussians whose values are computed again for each image.
    pub renewed: [usize; 2],
}

impl Default for Pace {
    fn default() -> Self {
        Self { shrink: 2, steps: MAX_STEPS, renewed: [1 << 12, 1 << 16] }
    }
}

impl Pace {
    /// Adapts to an image whose fields took this work, and whose other parts took this many seconds.
    pub fn learn(&mut self, fields: FieldWork, draw: f64) {
        let per_side = f64::from(self.shrink) / f64::from(self.shrink.max(2) - 1);
        if draw > DRAW {
            self.shrink = (self.shrink + 1).min(MAX_SHRINK);
        } else if draw * per_side * per_side < 0.6 * DRAW {
            self.shrink = (self.shrink - 1).max(1);
        }
        // if all was known already, the time says nothing
        if fields.evaluated == 0 {
            return;
        }
        let rate = fields.evaluated as f64 / fields.seconds.max(1e-9);
        let all = fields.gaussians as f64;
        let oldest = fields.gaussians.div_ceil(MAX_AGE);
        self.renewed = [FIELDS, LONGEST].map(|time| ((rate * time.max(draw)) as usize).max(oldest));
        let affordable = rate * FIELDS;
        if affordable < all {
            self.steps = MAX_STEPS;
        } else if self.steps > 1 && affordable > 3.0 * all {
            // all of them at steps of half the length
            self.steps /= 2;
            self.renewed = self.renewed.map(|count| count / 2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_settles_where_an_image_takes_its_time() {
        const GAUSSIANS: usize = 100_000;
        // seconds of a whole image, and of all its samples
        for (whole, samples) in [(0.01, 0.01), (0.1, 0.1), (0.1, 0.2), (0.25, 0.5), (5.0, 5.0)] {
            let mut pace = Pace::default();
            let mut seen = Vec::new();
            for _ in 0..40 {
                let area = f64::from(pace.shrink * pace.shrink);
                let evaluated = pace.renewed[0].min(GAUSSIANS);
                let part = evaluated as f64 / GAUSSIANS as f64;
                let seconds = part * samples / f64::from(pace.steps);
                pace.learn(FieldWork { seconds, gaussians: GAUSSIANS, evaluated }, whole / area);
                seen.push((pace, seconds));
            }
            let settled: Vec<_> =
                seen[20..].iter().map(|(pace, _)| (pace.shrink, pace.steps)).collect();
            assert!(settled.iter().all(|pace| *pace == settled[0]), "{whole}: {seen:?}");
            let (Pace { shrink, steps, renewed: [renewed, _] }, seconds) = seen[39];
            let area = f64::from(shrink * shrink);
            assert!(whole / area <= DRAW || shrink == MAX_SHRINK, "{whole}: {shrink}");
            let oldest = GAUSSIANS / MAX_AGE;
            // less than the other parts take would make no image faster
            let time = FIELDS.max(whole / area);
            assert!(seconds <= 1.01 * time || renewed == oldest, "{samples}: {seconds}");
            let is_used = seconds >= 0.99 * time || renewed >= GAUSSIANS;
            assert!(is_used || renewed == oldest, "{samples}: {seconds}");
            // no device that has time for all of them leaves some out
            assert!(renewed >= GAUSSIANS || samples / f64::from(steps) > time, "{samples}");
            assert!(renewed >= oldest, "{samples}: {renewed}");
        }
    }
}
