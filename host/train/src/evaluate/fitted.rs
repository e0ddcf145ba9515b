//! PSNR after a fit of the colors, which removes a camera's exposure and white balance.

use organza_core::metrics::psnr_of;

/// PSNR with a gain and an offset for each channel, fitted by least squares. The left and the right half of the image
/// each have the fit of the other half, so no pixel takes part in its own fit. `None` if one half has no valid pixel.
pub(super) fn psnr_fitted(
    [width, _]: [usize; 2],
    rendered: &[[f32; 3]],
    truth: &[[f32; 3]],
    valid: Option<&[bool]>,
) -> Option<f64> {
    let half_of = |at: usize| usize::from(at % width >= width / 2);
    let is_valid = |at: &usize| valid.is_none_or(|valid| valid[*at]);
    let mut sums = [[Sums::default(); 3]; 2];
    for at in (0..truth.len()).filter(is_valid) {
        for (channel, sums) in sums[half_of(at)].iter_mut().enumerate() {
            sums.add(rendered[at][channel].into(), truth[at][channel].into());
        }
    }
    if sums.iter().any(|half| half[0].count == 0.0) {
        return None;
    }
    let fits = sums.map(|half| half.map(|sums| sums.fit()));
    let squared = (0..truth.len()).filter(is_valid).map(|at| {
        let fits = &fits[1 - half_of(at)];
        let error = |channel: usize| {
            let [gain, offset] = fits[channel];
            let shown = (gain * f64::from(rendered[at][channel]) + offset).clamp(0.0, 1.0);
            (shown - f64::from(truth[at][channel])).powi(2)
        };
        (0..3).map(error).sum::<f64>()
    });
    let count = sums.iter().map(|half| half[0].count).sum::<f64>();
    Some(psnr_of(squared.sum::<f64>() / (3.0 * count)))
}

/// Sums over the pixels of a channel: of the rendered x and of the photographed y.
#[derive(Clone, Copy, Default)]
struct Sums {
    count: f64,
    x: f64,
    y: f64,
    xx: f64,
    xy: f64,
}

impl Sums {
    fn add(&mut self, x: f64, y: f64) {
        self.count += 1.0;
        self.x += x;
        self.y += y;
        self.xx += x * x;
        self.xy += x * y;
    }

    /// Gain and offset with the least squared error. An image of one color has a gain of 1.
    fn fit(&self) -> [f64; 2] {
        let x = self.x / self.count;
        let y = self.y / self.count;
        let variance = self.xx / self.count - x * x;
        let gain = if variance > 1e-6 { (self.xy / self.count - x * y) / variance } else { 1.0 };
        [gain, y - gain * x]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::metrics::psnr;

    /// 8 x 4 pixels of different colors.
    fn image() -> Vec<[f32; 3]> {
        (0..32_u16)
            .map(|at| [at, (at * 7) % 32, (at * 11) % 32].map(|value| f32::from(value) / 64.0))
            .collect()
    }

    #[test]
    fn exposure_and_white_balance_do_not_count() {
        let truth: Vec<_> =
            image().iter().map(|[r, g, b]| [0.8 * r + 0.1, 1.5 * g, 1.2 * b + 0.05]).collect();
        let plain = psnr(&image(), &truth, None).unwrap();
        let psnr = psnr_fitted([8, 4], &image(), &truth, None).unwrap();
        assert!(psnr > 120.0 && plain < 20.0, "{psnr} {plain}");
        // with a single color, there is only an offset
        let gray = vec![[0.25; 3]; 32];
        let psnr = psnr_fitted([8, 4], &gray, &vec![[0.5; 3]; 32], None).unwrap();
        assert!(psnr > 120.0, "{psnr}");
    }

    /// A pixel must not fit itself: with each half fitted to itself, no error would be left.
    #[test]
    fn each_half_is_measured_with_the_fit_of_the_other() {
        let mut truth = image();
        let right = |at: usize| at % 8 >= 4;
        (0..32).filter(|&at| right(at)).for_each(|at| truth[at] = truth[at].map(|v| v + 0.25));
        let psnr = psnr_fitted([8, 4], &image(), &truth, None).unwrap();
        // the fit of the left half leaves the right one 0.25 too dark, and the fit of the right half makes the left
        // one 0.25 too bright: -20 log10(0.25)
        assert!((psnr - 12.041).abs() < 1e-3, "{psnr}");
    }

    #[test]
    fn pixels_that_are_not_valid_do_not_count() {
        let mut truth = image();
        truth[3] = [1.0, 0.0, 1.0];
        let valid: Vec<_> = (0..32).map(|at| at != 3).collect();
        assert!(psnr_fitted([8, 4], &image(), &truth, Some(&valid)).unwrap() > 120.0);
        assert!(psnr_fitted([8, 4], &image(), &truth, None).unwrap() < 40.0);
        let left: Vec<_> = (0..32).map(|at| at % 8 < 4).collect();
        assert_eq!(psnr_fitted([8, 4], &image(), &truth, Some(&left)), None);
    }
}
