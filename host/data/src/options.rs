//! Options for reading photographs.

use std::fmt;
use std::str::FromStr;

use organza_core::error::{Result, argument};
use organza_core::scene::{Placement, TrainedOn};
use serde::{Deserialize, Serialize};

/// Options for reading photographs, and for the choice of held-out frames.
///
/// ```
/// use organza_data::DatasetOptions;
///
/// let options = DatasetOptions { downscale: 2, ..Default::default() };
/// assert_eq!((options.downscale, options.hold_out_every), (2, 8));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DatasetOptions {
    /// Factor by which photographs are reduced, 1 or more. A pixel is the mean of a square of `downscale` x
    /// `downscale` pixels. Pixels that do not fill a square, at the right and lower edges, are cut off. Cameras
    /// change accordingly.
    pub downscale: u32,
    /// Every Nth frame is held out, starting with the first; 0 holds out none. If there is Blender's
    /// `transforms_test.json`, its frames are held out instead.
    pub hold_out_every: usize,
    /// Number of neighboring frames that are held out together, 1 or more: every Nth stretch of so many.
    pub hold_out_length: usize,
    /// Background of photographs with an alpha channel.
    pub background: Background,
    /// Meaning of an alpha channel.
    pub alpha: Alpha,
    /// Whether the data set may name files outside its own folder, by path or by link.
    pub allow_outside: bool,
    /// The coordinates of cameras and points: a scene's placement, or [`Placement::default`] for the files' own coordinates.
    /// `None` chooses a placement from the cameras: see [`Placement::of`].
    pub placement: Option<Placement>,
    /// What a scene was trained on. If the data set has any of these photographs, those are held out that the scene has not seen.
    pub trained_on: Option<TrainedOn>,
}

impl Default for DatasetOptions {
    fn default() -> Self {
        Self {
            downscale: 1,
            hold_out_every: 8,
            hold_out_length: 1,
            background: Background::Auto,
            alpha: Alpha::default(),
            allow_outside: false,
            placement: None,
            trained_on: None,
        }
    }
}

impl DatasetOptions {
    /// Whether the frame at a position in the data set's order is held out.
    #[must_use]
    pub fn holds_out(&self, position: usize) -> bool {
        let every = self.hold_out_every;
        // Only 0 is a multiple of 0. With 0, not even the first frame may be held out.
        let is_taken = |stretch: usize| every != 0 && stretch.is_multiple_of(every);
        position.checked_div(self.hold_out_length).is_some_and(is_taken)
    }

    pub(super) fn check(&self) -> Result<()> {
        if self.downscale == 0 {
            return argument("`downscale` is 0, expected 1 (full size) or more");
        }
        if self.hold_out_every == 1 {
            return argument(
                "`hold_out_every` is 1, which leaves nothing to train on; expected 2 or more, or 0 \
                 to hold no frame out"
                    .to_owned(),
            );
        }
        if self.hold_out_length == 0 {
            return argument("`hold_out_length` is 0, expected 1 or more");
        }
        let background = self.background.color();
        if !background.iter().all(|value| (0.0..=1.0).contains(value)) {
            return argument(format!("`background` is {background:?}, expected values of 0 to 1"));
        }
        Ok(())
    }
}

/// The meaning of an alpha channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Alpha {
    /// The photograph is composited over the background.
    #[default]
    Background,
    /// Pixels with an alpha below one half are not used, as if masked.
    Mask,
}

/// The color behind a scene, and behind photographs with an alpha channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Written", into = "Written")]
pub enum Background {
    /// White for a Blender data set, as in the tables of NeRF and its successors, unless alpha is a mask. Black for all others.
    #[default]
    Auto,
    /// Red, green and blue as sRGB values, 0 to 1.
    Color([f32; 3]),
}

/// The forms of a background in a file.
#[derive(Serialize, Deserialize)]
#[serde(untagged, expecting = "expected \"auto\", a color's name, or three numbers of 0 to 1")]
enum Written {
    Text(String),
    Color([f32; 3]),
}

impl Background {
    /// The color, if there is one; black for [`Background::Auto`].
    pub fn color(self) -> [f32; 3] {
        match self {
            Self::Auto => [0.0; 3],
            Self::Color(color) => color,
        }
    }
}

impl From<[f64; 3]> for Background {
    /// The background of a scene, which may be brighter than photographs.
    fn from(color: [f64; 3]) -> Self {
        Self::Color(color.map(|value| value.clamp(0.0, 1.0) as f32))
    }
}

impl FromStr for Background {
    type Err = String;

    /// Parses `auto`, three numbers such as `1,1,1` or `[1, 1, 1]`, or a CSS color: a name such as `white`, or
    /// `#ffffff`.
    fn from_str(text: &str) -> Result<Self, String> {
        if text == "auto" {
            return Ok(Self::Auto);
        }
        let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']'));
        let numbers: Option<Vec<f32>> =
            inner.unwrap_or(text).split(',').map(|part| part.trim().parse().ok()).collect();
        let color = match numbers.map(<[f32; 3]>::try_from) {
            Some(Ok(color)) => Some(color),
            _ => csscolorparser::parse(text).ok().map(|color| [color.r, color.g, color.b]),
        };
        let in_range = |color: &[f32; 3]| color.iter().all(|value| (0.0..=1.0).contains(value));
        color.filter(in_range).map(Self::Color).ok_or_else(|| {
            "expected auto, a color such as white or #ffffff, or three numbers from 0 to 1 such as 1,1,1"
                .to_owned()
        })
    }
}

impl fmt::Display for Background {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Auto => formatter.write_str("auto"),
            Self::Color([red, green, blue]) => write!(formatter, "{red},{green},{blue}"),
        }
    }
}

impl TryFrom<Written> for Background {
    type Error = String;

    fn try_from(written: Written) -> Result<Self, String> {
        match written {
            Written::Text(text) => text.parse(),
            // its range is checked together with all other settings
            Written::Color(color) => Ok(Self::Color(color)),
        }
    }
}

impl From<Background> for Written {
    fn from(background: Background) -> Self {
        match background {
            Background::Auto => Self::Text(background.to_string()),
            Background::Color(color) => Self::Color(color),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_have_names_and_numbers() {
        for (text, color) in [
            ("white", [1.0, 1.0, 1.0]),
            ("black", [0.0, 0.0, 0.0]),
            ("red", [1.0, 0.0, 0.0]),
            ("#00ff00", [0.0, 1.0, 0.0]),
            ("1, 0.5,0", [1.0, 0.5, 0.0]),
            ("[0, 0.5, 1]", [0.0, 0.5, 1.0]),
        ] {
            assert_eq!(text.parse(), Ok(Background::Color(color)), "{text}");
        }
        assert_eq!("auto".parse(), Ok(Background::Auto));
        for bad in ["", "1,1", "1,1,1,1", "1,1,2", "-0.1,0,0", "a,b,c", "NaN,0,0", "whitish"] {
            assert!(bad.parse::<Background>().is_err(), "{bad}");
        }
    }
}
