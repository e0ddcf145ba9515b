//! How photographs are read.

use super::background::{Alpha, Background};
use super::keep::Keep;
use organza_core::error::{Error, Result};

/// How photographs are read, and which of them are kept from training.
///
/// ```
/// use organza_data::DatasetOptions;
///
/// let options = DatasetOptions::default().downscale(2).background([1.0; 3]);
/// assert_eq!((options.downscale, options.hold_out_every), (2, 8));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DatasetOptions {
    /// Photographs become smaller by this factor, 1 or more: a pixel is the mean of a square of
    /// `downscale` by `downscale` pixels. What is left over at the right and the lower edge, where
    /// a side does not divide, is cut off. Cameras follow.
    pub downscale: u32,
    /// Every Nth frame is held out, beginning with the first; 0 holds none out. The frames
    /// of Blender's `transforms_test.json`, where there is one, are held out instead.
    pub hold_out_every: usize,
    /// What photographs with an alpha channel are put in front of.
    pub background: Background,
    /// What an alpha channel is for.
    pub alpha: Alpha,
    /// Whether the data set may name files outside its own folder, by their paths or by links.
    pub allow_outside: bool,
    /// Where photographs are kept.
    pub keep: Keep,
}

impl Default for DatasetOptions {
    fn default() -> Self {
        let (background, alpha) = (Background::Auto, Alpha::default());
        let (allow_outside, keep) = (false, Keep::default());
        Self { downscale: 1, hold_out_every: 8, background, alpha, allow_outside, keep }
    }
}

impl DatasetOptions {
    /// Sets [`downscale`](Self::downscale).
    #[must_use]
    pub fn downscale(mut self, downscale: u32) -> Self {
        self.downscale = downscale;
        self
    }

    /// Sets [`hold_out_every`](Self::hold_out_every).
    #[must_use]
    pub fn hold_out_every(mut self, every: usize) -> Self {
        self.hold_out_every = every;
        self
    }

    /// Sets [`background`](Self::background).
    #[must_use]
    pub fn background(mut self, background: impl Into<Background>) -> Self {
        self.background = background.into();
        self
    }

    /// Sets [`alpha`](Self::alpha).
    #[must_use]
    pub fn alpha(mut self, alpha: Alpha) -> Self {
        self.alpha = alpha;
        self
    }

    /// Sets [`allow_outside`](Self::allow_outside).
    #[must_use]
    pub fn allow_outside(mut self, allow: bool) -> Self {
        self.allow_outside = allow;
        self
    }

    /// Sets [`keep`](Self::keep).
    #[must_use]
    pub fn keep(mut self, keep: Keep) -> Self {
        self.keep = keep;
        self
    }

    pub(super) fn check(&self) -> Result<()> {
        let refuse = |reason: String| Err(Error::Argument { reason });
        if self.downscale == 0 {
            return refuse("`downscale` is 0, expected 1 (full size) or more".to_owned());
        }
        if self.hold_out_every == 1 {
            return refuse(
                "`hold_out_every` is 1, which leaves nothing to train on; expected 2 or more, or 0 \
                 to hold no frame out"
                    .to_owned(),
            );
        }
        let background = self.background.color();
        if !background.iter().all(|value| (0.0..=1.0).contains(value)) {
            return refuse(format!("`background` is {background:?}, expected values of 0 to 1"));
        }
        Ok(())
    }
}
