//! Options for reading photographs.

use super::background::{Alpha, Background};
use super::keep::Keep;
use organza_core::error::{Error, Result};
use organza_core::scene::Placement;

/// Options for reading photographs, and for the choice of held-out frames.
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
    /// Factor by which photographs are reduced, 1 or more. A pixel is the mean of a square of `downscale` x
    /// `downscale` pixels. Pixels that do not fill a square, at the right and lower edges, are cut off. Cameras
    /// change accordingly.
    pub downscale: u32,
    /// Every Nth frame is held out, starting with the first; 0 holds out none. If there is Blender's
    /// `transforms_test.json`, its frames are held out instead.
    pub hold_out_every: usize,
    /// Background of photographs with an alpha channel.
    pub background: Background,
    /// Meaning of an alpha channel.
    pub alpha: Alpha,
    /// Whether the data set may name files outside its own folder, by path or by link.
    pub allow_outside: bool,
    /// Storage for the photographs.
    pub keep: Keep,
    /// The coordinates that cameras and points get: those of a scene, or [`Placement::default`] for those of the files.
    /// `None` finds the data set's own: see [`Placement::of`].
    pub placement: Option<Placement>,
}

impl Default for DatasetOptions {
    fn default() -> Self {
        let background = Background::Auto;
        let alpha = Alpha::default();
        let allow_outside = false;
        let keep = Keep::default();
        let placement = None;
        Self { downscale: 1, hold_out_every: 8, background, alpha, allow_outside, keep, placement }
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

    /// Sets [`placement`](Self::placement).
    #[must_use]
    pub fn placement(mut self, placement: impl Into<Option<Placement>>) -> Self {
        self.placement = placement.into();
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
