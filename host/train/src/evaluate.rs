//! Compares a scene with photographs. Each is rendered whole and compared by PSNR and SSIM.
//!
//! The rendered f32 values are clamped to 0 to 1, as in a picture, but not rounded to 8 bits; NaN is black. Pixels that
//! are not valid, as after undistorting, are ignored: PSNR is over the valid pixels, and SSIM over windows of valid
//! pixels.

#[cfg(test)]
mod tests;

use std::io;
use std::path::Path;

use serde::{Deserialize, Serialize};

use muslin_device::memory;
use organza_core::image::{Image, TILE_SIDE, bands};
use organza_core::metrics::{psnr, psnr_of, ssim};
use organza_core::{Camera, Error, RenderedTiles, Result, TileBatch, write_atomic};
use organza_data::Frame;
use organza_render::{DeviceScene, Renderer};
use organza_splats::Splat;

/// The result of comparing an image with its photograph.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Score {
    /// The peak signal-to-noise ratio in decibels. Infinite, null in JSON, if the image equals the photograph.
    /// `None`, also null, if no pixel of the photograph is valid.
    pub psnr: Option<f64>,
    /// The structural similarity, at most 1. `None`, null in JSON, if no window of 11 x 11 pixels is valid.
    pub ssim: Option<f64>,
    /// PSNR after fitting a gain and an offset for each channel, where each half of the image uses the other half's
    /// fit. Only [`evaluate_with`] measures it, on request.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub psnr_fitted: Option<f64>,
}

/// The score of one frame.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ViewScore {
    /// Path of the photograph, as the data set writes it.
    pub name: String,
    /// Scores of the rendered image.
    #[serde(flatten)]
    pub score: Score,
}

/// The scores of frames. As JSON: `{"mean": {"psnr", "ssim"}, "views": [{"name", "psnr", "ssim"}, ...]}`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Evaluation {
    /// Means over the views that have the value; `None` if no view has it.
    pub mean: Score,
    /// Scores of the frames, in the given order.
    pub views: Vec<ViewScore>,
    /// Number of pixels, in all views, that were rendered as NaN or infinity. Not part of the JSON.
    #[serde(skip)]
    pub not_finite: u64,
}

/// Progress of [`evaluate_with`].
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub enum Event<'a> {
    /// Tiles were rendered.
    Tiles {
        /// Number of finished tiles.
        done: usize,
        /// Number of tiles of all frames.
        total: usize,
    },
    /// A view is finished.
    View {
        /// Index of the frame.
        index: usize,
        /// Scores of the view.
        score: &'a ViewScore,
        /// The rendered image, of the photograph's size.
        image: &'a Image,
    },
}

/// The number of tiles of some frames.
fn tiles(frames: &[&Frame]) -> usize {
    frames.iter().map(|frame| across(frame.camera.width) * across(frame.camera.height)).sum()
}

/// Number of tiles that cover some pixels in a row or a column.
fn across(pixels: u32) -> usize {
    pixels.div_ceil(TILE_SIDE) as usize
}

/// Renders each frame and compares it with its photograph. Only one image is in memory at a time, and the part that
/// is rendered at once is bounded.
///
/// ```
/// use organza_core::demo;
/// use muslin_device::DeviceOptions;
/// use organza_render::Renderer;
/// use organza_train::{built_in, evaluate};
///
/// let renderer = Renderer::new(organza_render::open_device(&DeviceOptions::cpu(None))?);
/// let dataset = built_in::dataset(&renderer, 2, 24, 2)?;
/// let scene = renderer.upload(&demo::scene())?;
/// let frames: Vec<_> = dataset.held_out_frames().collect();
/// let evaluation = evaluate(&renderer, &scene, &frames)?;
/// // the photographs are renderings of this scene, rounded to 8 bits
/// assert!(evaluation.mean.psnr.is_some_and(|psnr| psnr > 50.0));
/// # Ok::<(), organza_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Argument`] if a photograph does not have its camera's size; the same errors as [`Renderer::render`].
pub fn evaluate(renderer: &Renderer, scene: &DeviceScene, frames: &[&Frame]) -> Result<Evaluation> {
    evaluate_with(renderer, scene, frames, false, &mut |_| {})
}

/// Like [`evaluate`], but calls `watch` with the progress. `fitted` also measures [`Score::psnr_fitted`].
///
/// # Errors
/// The same errors as [`evaluate`].
pub fn evaluate_with(
    renderer: &Renderer,
    scene: &DeviceScene,
    frames: &[&Frame],
    fitted: bool,
    watch: &mut dyn FnMut(Event<'_>),
) -> Result<Evaluation> {
    let mut parts = Vec::with_capacity(frames.len());
    let total = tiles(frames);
    let mut done = 0;
    for (index, frame) in frames.iter().enumerate() {
        let mut advance = |tiles| {
            done += tiles;
            watch(Event::Tiles { done, total });
        };
        let (part, image) = evaluate_view(frame, fitted, &mut |cameras, batch| {
            let mut before = 0;
            let mut progress = |done, _| advance(done - std::mem::replace(&mut before, done));
            renderer.render_channels(scene, cameras, batch, &[], &mut progress)
        })?;
        watch(Event::View { index, score: &part.views[0], image: &image });
        parts.push(part);
    }
    Ok(Evaluation::join(parts))
}

/// Renders tiles.
type Render<'r> = dyn FnMut(&[Camera], &TileBatch) -> Result<RenderedTiles> + 'r;

/// Like [`evaluate`], but for one frame; `render` may do so together with other ranks.
pub(crate) fn evaluate_view(
    frame: &Frame,
    fitted: bool,
    render: &mut Render<'_>,
) -> Result<(Evaluation, Image)> {
    let rendered = RenderedFrame::new(frame, render)?;
    let score = rendered.score(frame, fitted)?;
    let views = vec![ViewScore { name: frame.name.clone(), score }];
    let not_finite = rendered.image.not_finite();
    Ok((Evaluation { mean: mean(&views), views, not_finite }, rendered.image))
}

impl Evaluation {
    /// Joins evaluations of parts of the frames, in order.
    pub(crate) fn join(parts: Vec<Self>) -> Self {
        let not_finite = parts.iter().map(|part| part.not_finite).sum();
        let views: Vec<_> = parts.into_iter().flat_map(|part| part.views).collect();
        Self { mean: mean(&views), views, not_finite }
    }
}

/// The means over the views that have the value.
fn mean(views: &[ViewScore]) -> Score {
    let mean = |value: fn(&Score) -> Option<f64>| {
        let values: Vec<_> = views.iter().filter_map(|view| value(&view.score)).collect();
        (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
    };
    Score {
        psnr: mean(|score| score.psnr),
        ssim: mean(|score| score.ssim),
        psnr_fitted: mean(|score| score.psnr_fitted),
    }
}

/// A rendered frame.
struct RenderedFrame {
    image: Image,
    /// Colors, `[height, width]`, from 0 to 1.
    colors: Vec<[f32; 3]>,
}

impl RenderedFrame {
    fn new(frame: &Frame, render: &mut Render<'_>) -> Result<Self> {
        let camera = &frame.camera;
        let size = [camera.width, camera.height];
        let found = [frame.image.width(), frame.image.height()];
        if size != found {
            let reason = format!(
                "the photograph of frame {} has {} x {} pixels, but its camera {} x {}",
                frame.name, found[0], found[1], size[0], size[1]
            );
            return Err(Error::Argument { reason });
        }
        let mut rendered =
            Self { image: Image::new(size[0], size[1])?, colors: colors(frame, "an image")? };
        for batch in bands(0, size, TILE_SIDE) {
            let batch = batch?;
            let tiles = render(std::slice::from_ref(camera), &batch)?;
            rendered.image.paste(&batch, &tiles)?;
            rendered.paste(&batch, &tiles);
        }
        Ok(rendered)
    }

    /// Like [`Image::paste`], but without rounding.
    fn paste(&mut self, batch: &TileBatch, tiles: &RenderedTiles) {
        let [width, height] = self.image.size().map(|size| size as usize);
        let side = batch.side as usize;
        for (index, tile) in batch.tiles.iter().enumerate() {
            // `bands` starts at 0 and covers the image
            let [left, top] = tile.origin.map(|origin| origin as usize);
            for y in top..(top + side).min(height) {
                for x in left..(left + side).min(width) {
                    let color = tiles.rgb(index, x - left, y - top);
                    self.colors[y * width + x] = color.map(displayed);
                }
            }
        }
    }

    fn score(&self, frame: &Frame, fitted: bool) -> Result<Score> {
        let photograph = &frame.image;
        let mut truth = colors(frame, "a photograph")?;
        for (color, pixel) in truth.iter_mut().zip(photograph.pixels()) {
            *color = pixel.map(|value| f32::from(value) / 255.0);
        }
        let size = self.image.size().map(|size| size as usize);
        let valid = photograph.valid();
        Ok(Score {
            psnr: psnr(&self.colors, &truth, valid),
            ssim: ssim(size, &self.colors, &truth, valid),
            psnr_fitted: fitted.then(|| psnr_fitted(size, &self.colors, &truth, valid)).flatten(),
        })
    }
}

/// Allocates the colors of a frame's pixels.
fn colors(frame: &Frame, what: &str) -> Result<Vec<[f32; 3]>> {
    let width = frame.image.width();
    let height = frame.image.height();
    let what = format!("the colors of {what} of {width} x {height} pixels");
    Ok(memory::zeros(frame.image.pixels().len(), &what)?)
}

/// The value that a display shows.
fn displayed(value: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) }
}

/// Writes the scores of views, atomically: `step,view,psnr,ssim,psnr_fitted`. The
/// last column is left out if no view has it. An infinite PSNR is `inf`; a missing score is empty.
pub(crate) fn save_csv(path: impl AsRef<Path>, rows: &[(u64, &ViewScore)]) -> Result<()> {
    let has_fitted = rows.iter().any(|(_, view)| view.score.psnr_fitted.is_some());
    let shown = |cells: [String; 5]| cells.into_iter().take(if has_fitted { 5 } else { 4 });
    write_atomic(path, |writer| {
        let mut table = ::csv::Writer::from_writer(writer);
        let head = ["step", "view", "psnr", "ssim", "psnr_fitted"].map(str::to_owned);
        table.write_record(shown(head)).map_err(io::Error::other)?;
        for (step, ViewScore { name, score }) in rows {
            let [psnr, ssim, fitted] = [score.psnr, score.ssim, score.psnr_fitted].map(number);
            let row = shown([step.to_string(), name.clone(), psnr, ssim, fitted]);
            table.write_record(row).map_err(io::Error::other)?;
        }
        table.flush()
    })
}

/// A number, or an empty cell for `None`.
fn number(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}

/// Mean PSNRs compared with photographs, in dB.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SplatComparison {
    /// Number of photographs.
    pub photographs: usize,
    /// PSNR of the scene's own images.
    pub scene: f64,
    /// PSNR of the Gaussians' images, as a viewer that sorts shows them.
    pub splats: f64,
}

/// Compares a scene, and Gaussians that were [distilled from it](organza_splats::distill()), with photographs. `None` without
/// photographs that have a valid pixel.
///
/// # Errors
/// The same errors as [`Renderer::render`].
pub fn compare_splats(
    renderer: &Renderer,
    scene: &DeviceScene,
    splats: &[Splat],
    photographs: &[&Frame],
) -> Result<Option<SplatComparison>> {
    let Some(own) = evaluate(renderer, scene, photographs)?.mean.psnr else { return Ok(None) };
    let background = scene.config().background.map(|x| x as f32);
    let of = |frame: &&Frame| {
        let Frame { camera, image, .. } = frame;
        organza_splats::psnr(splats, camera, background, image.pixels(), image.valid())
    };
    let found: Vec<_> = photographs.iter().filter_map(of).collect();
    let splats = found.iter().sum::<f64>() / found.len() as f64;
    Ok(Some(SplatComparison { photographs: found.len(), scene: own, splats }))
}

/// PSNR with a gain and an offset for each channel, fitted by least squares. The left and the right half of the image
/// each use the other half's fit, so no pixel takes part in its own fit. `None` if one half has no valid pixel.
fn psnr_fitted(
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
