//! Whether a run learns the photographs' exposures.

use serde::{Deserialize, Serialize};

use organza_data::Dataset;

/// Exposures that differ by more than this are learned: see [`Dataset::exposure_spread`].
// docs/experiments.md has the measurements: 10% is not worth it, 13% is.
const SPREAD: f64 = 0.12;

/// Whether a run learns the photographs' exposures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LearnExposure {
    /// If they differ by more than 12%, measured at the data set's points. Without points, none are learned.
    #[default]
    Auto,
    /// Yes.
    On,
    /// No.
    Off,
}

impl LearnExposure {
    /// Whether exposures of these photographs are learned.
    #[must_use]
    pub fn decide(self, dataset: &Dataset) -> bool {
        match self {
            Self::Auto => dataset.exposure_spread().is_some_and(|spread| spread > SPREAD),
            Self::On => true,
            Self::Off => false,
        }
    }
}

impl From<bool> for LearnExposure {
    fn from(learn: bool) -> Self {
        if learn { Self::On } else { Self::Off }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use organza_core::camera::Camera;
    use organza_data::{Frame, Photograph, Point};

    /// Two photographs of one color, and points of the first one's color in the middle of both.
    fn photographs(levels: [u8; 2]) -> Dataset {
        let frame = |level: u8| {
            let axes = ([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0]);
            let camera = Camera::look_at(axes.0, axes.1, axes.2, 0.8, [8, 8]).unwrap();
            let image = Photograph::new([8, 8], vec![[level; 3]; 64], None).unwrap();
            Frame { name: level.to_string(), camera, image }
        };
        let mut dataset = Dataset::from_frames(levels.map(frame).to_vec(), 0);
        dataset.points = vec![Point { position: [0.0; 3], color: Some([levels[0]; 3]) }; 60];
        dataset
    }

    #[test]
    fn exposures_are_learned_where_they_differ() {
        // half the logarithm of 1.2 is 0.09, and that of 1.4 is 0.17
        let [alike, different] = [120, 140].map(|level| photographs([100, level]));
        for (learn, expected) in [
            (LearnExposure::Auto, [false, true]),
            (LearnExposure::On, [true; 2]),
            (LearnExposure::Off, [false; 2]),
        ] {
            let found = [&alike, &different].map(|dataset| learn.decide(dataset));
            assert_eq!(found, expected, "{learn:?}");
        }
        // nothing is known without points
        let dataset = Dataset::from_frames(different.frames, 0);
        assert!(!LearnExposure::Auto.decide(&dataset));
    }
}
