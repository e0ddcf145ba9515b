//! Warnings about a scene that is valid but probably not as intended.

use super::Scene;

/// From this resolution on, an f32 position keeps fewer than 11 bits of its fraction inside a cell.
const FINE_RESOLUTION: u32 = 8192;

/// There is no warning if fewer than one in this number of Gaussians is outside the box.
const USUAL: usize = 10;

impl Scene {
    /// One sentence, with counts, for each suspicious but valid property; empty for an ordinary scene.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.gaussian_warnings();
        for (name, grid) in [
            ("color_grid", &self.config.color_grid),
            ("transmittance_grid", &self.config.transmittance_grid),
        ] {
            let finest = grid.finest_resolution();
            if finest > FINE_RESOLUTION {
                warnings.push(format!(
                    "the finest level of {name} has resolution {finest}: above {FINE_RESOLUTION} \
                     f32 positions lose the fraction that interpolation needs"
                ));
            }
        }
        if self.config.blur == 0.0 {
            warnings.push(
                "blur is 0: Gaussians much smaller than a pixel vanish between pixel centers or \
                 are culled"
                    .to_owned(),
            );
        }
        warnings
    }

    fn gaussian_warnings(&self) -> Vec<String> {
        let gaussians = &self.gaussians;
        let [lo, hi] = self.config.aabb;
        let outside = |position: &&[f32; 3]| {
            let mut axes = position.iter().zip(lo).zip(hi);
            axes.any(|((&value, lo), hi)| !(lo..=hi).contains(&f64::from(value)))
        };
        let extents = lo.iter().zip(hi).map(|(lo, hi)| hi - lo);
        let diagonal = extents.map(|extent| extent * extent).sum::<f64>().sqrt();
        let is_contracted = !self.config.contraction.is_none();
        // cells are larger where space is contracted: a far Gaussian may be as large as its distance
        let far = |position: &[f32; 3]| {
            let axes = position.iter().zip(lo).zip(hi);
            axes.map(|((&at, lo), hi)| (f64::from(at) - (lo + hi) / 2.0).powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let huge = |(position, log_scale): &(&[f32; 3], &[f32; 3])| {
            let most = if is_contracted { diagonal.max(far(position)) } else { diagonal };
            log_scale.iter().any(|&value| f64::from(value).exp() > most)
        };
        // In f32, as in the kernels: small components may square to zero.
        let no_rotation = |rotation: &&[f32; 4]| {
            let squared: f32 = rotation.iter().map(|value| value * value).sum();
            !squared.is_normal()
        };
        let total = gaussians.len();
        // training leaves a few outside of any box
        let outside = gaussians.position.iter().filter(outside).count();
        let is_usual = is_contracted || outside * USUAL < total;
        let counts = [
            (
                if is_usual { 0 } else { outside },
                "have their center outside the scene's box, where the grids repeat the border",
            ),
            (
                gaussians.rotation.iter().filter(no_rotation).count(),
                "have a rotation of zero or overflowing norm and are culled",
            ),
            (
                gaussians.position.iter().zip(&gaussians.log_scale).filter(huge).count(),
                if is_contracted {
                    "have a scale larger than the diagonal of the scene's box and their distance from it"
                } else {
                    "have a scale larger than the diagonal of the scene's box"
                },
            ),
        ];
        let counted = counts.into_iter().filter(|(count, _)| *count > 0);
        counted.map(|(count, text)| format!("{count} of {total} Gaussians {text}")).collect()
    }
}
