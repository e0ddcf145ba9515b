//! Runs forward and backward over a batch, and recovers from running out of memory.
//!
//! A view batch has a batch's tiles of one camera, at most as many as fit into a part. Its gradients have the same bits on any rank,
//! alone or in one part with others. So the sum depends neither on how a batch is cut into parts, nor on how many
//! [ranks](organza_core::ranks) share it. View batches are dealt to ranks: rank v mod R has the one with the number v.
//!
//! - **Hash grids** are summed as 64-bit integers, which are exact in any order. All view batches share one scale: its
//!   bound is the largest of all bounds.
//! - **Networks and poses** are summed as [binned](muslin::binned) sums, which are exact, too.
//! - **Gaussians** are summed camera by camera; between ranks as [`Rows`].
//!
//! A CPU waits for the counts of each part before it allocates tables. A GPU allocates what [earlier parts](super::capacity) needed, and
//! reads the counts together with the part's results. Where that was too little, [`Pass::read`] finds it, and the part runs again.

use std::ops::Range;
use std::sync::Arc;

use super::capacity::BatchKind;
use super::output::Output;
use super::part::Part;
use super::renderer::Renderer;
use crate::gradient::SceneGradient;
use crate::gradient::ranks::{self, Rows};
use crate::loss::compare::LossSource;
use crate::scene::device_scene::DeviceScene;
use crate::stages::composite::PairGradients;
use crate::stages::counts::{Capacity, NO_COUNTS, PartCounts};
use crate::stages::cut::{Limits, PartTiles, by_camera, cut};
use muslin_device::{Buffer, Count, Device};
use organza_core::error::argument;
use organza_core::ranks::Ranks;
use organza_core::{Camera, Error, Result, TileBatch};

/// Bytes of parts that are kept from the forward to the backward pass: this many, or this share of a GPU's memory if that is more. Other
/// parts are rendered again.
const KEPT_BYTES: u64 = 2 << 30;
const KEPT_SHARES: u64 = 4;
/// About how many bytes of tables a pair or a sample takes.
const SAMPLE_BYTES: u64 = 128;

/// What all parts of a batch share.
#[derive(Clone, Copy)]
pub struct Pass<'a> {
    pub renderer: &'a Renderer,
    pub scene: &'a DeviceScene,
    pub cameras: &'a [Camera],
    /// The ranks that share the batch, if there are several.
    pub ranks: Option<&'a dyn Ranks>,
    /// The counts of [queued](Pass::queue) batches, which the host does not wait for.
    pub queue_counts: Option<&'a Arc<Buffer<u32>>>,
}

/// This rank's parts of a batch.
#[derive(Debug)]
pub struct Parts {
    pub list: Vec<BatchPart>,
    /// View batches of all ranks.
    views: usize,
    /// Pairs and samples that may still be kept.
    keep_budget: u64,
    /// Whether a [tape](super::tape::Tape) has the parts: it may run the backward pass again, so they are kept after it, too.
    is_taped: bool,
}

/// A part of a batch.
#[derive(Debug)]
pub struct BatchPart {
    pub part_tiles: PartTiles,
    need: Need,
    /// Whether it is rendered for [`Pass::backward`].
    is_for_gradients: bool,
    /// The results of the stages; `None` before they run, and after they were released.
    part: Option<Part>,
    /// Whether the part has taken its share of [`Parts::keep_budget`].
    is_kept: bool,
    /// dL/dY `[tiles, 3, S, S]`
    d_tiles: Option<Buffer<f32>>,
    /// `[pairs, 3]`, of a part that is kept.
    d_pairs: Option<PairGradients>,
}

/// What the host knows of a part's pairs, intersections and samples.
#[derive(Clone, Copy, Debug)]
enum Need {
    /// Nothing: it may be predicted.
    Unknown,
    /// A prediction was too small: the host waits for the counts before it allocates.
    Underestimated,
    /// The counts.
    Known(Capacity),
}

impl Need {
    fn known(self) -> Option<Capacity> {
        match self {
            Self::Known(capacity) => Some(capacity),
            Self::Unknown | Self::Underestimated => None,
        }
    }
}

impl Parts {
    fn new(parts: Vec<PartTiles>, views: usize) -> Self {
        let list = parts.into_iter().map(BatchPart::new).collect();
        Self { list, views, keep_budget: 0, is_taped: false }
    }

    /// Gives up the memory of kept parts.
    pub fn release(&mut self) {
        self.keep_budget = 0;
        self.list.iter_mut().for_each(BatchPart::release);
    }

    /// Whether the last camera of a part continues in the next one.
    fn continues(&self, index: usize) -> bool {
        let last = self.list[index].part_tiles.tiles.last();
        let next = self.list.get(index + 1).and_then(|next| next.part_tiles.tiles.first());
        last.zip(next).is_some_and(|(last, next)| last.view == next.view)
    }
}

impl BatchPart {
    fn new(part_tiles: PartTiles) -> Self {
        Self {
            part_tiles,
            need: Need::Unknown,
            is_for_gradients: false,
            part: None,
            is_kept: false,
            d_tiles: None,
            d_pairs: None,
        }
    }

    fn release(&mut self) {
        self.part = None;
        self.is_kept = false;
        self.d_pairs = None;
    }

    /// After the part was read: keeps it if the budget allows it, and releases it otherwise.
    fn keep_or_release(&mut self, budget: &mut u64) {
        let needed = self.need.known().expect("it was read");
        let takes = u64::from(needed.pairs) + u64::from(needed.samples);
        if !self.is_kept && takes <= *budget {
            *budget -= takes;
            self.is_kept = true;
        }
        if !self.is_kept {
            self.release();
        }
    }
}

impl<'a> Pass<'a> {
    fn device(&self) -> &'a Device {
        self.renderer.device()
    }

    /// The largest number of pairs and samples in kept parts.
    fn kept_samples(&self) -> u64 {
        self.device().memory_share(KEPT_SHARES, KEPT_BYTES) / SAMPLE_BYTES
    }

    /// Cuts this rank's tiles of a batch into parts that fit the device.
    pub fn cut(&self, batch: &TileBatch) -> Result<Parts> {
        batch.validate(self.cameras)?;
        let bytes = self.renderer.part_bytes();
        let max_tiles = Limits::new(self.scene, batch.side, bytes)?.tiles;
        let mut tiles = by_camera(batch, max_tiles);
        let views = tiles.last().map_or(0, |tile| tile.view + 1);
        if let Some(ranks) = self.ranks {
            tiles.retain(|tile| tile.view % ranks.size() == ranks.rank());
        }
        Ok(Parts::new(cut(self.scene, batch.side, &tiles, bytes)?, views))
    }

    /// Renders all parts, and calls `progress` after each with the number of tiles that are done. With `keep`, parts are kept
    /// for [`Pass::backward`].
    pub fn forward(
        &self,
        parts: &mut Parts,
        keep: bool,
        output: &mut Output<'_>,
        progress: &mut dyn FnMut(usize),
    ) -> Result<()> {
        parts.keep_budget = if keep { self.kept_samples() } else { 0 };
        parts.is_taped = keep;
        let mut done = 0;
        let mut index = 0;
        while let Some(at) = parts.list.get_mut(index) {
            match self.read_tiles(at, keep, output) {
                Ok(false) => {}
                Ok(true) => {
                    at.keep_or_release(&mut parts.keep_budget);
                    done += at.part_tiles.tiles.len();
                    progress(done);
                    index += 1;
                }
                Err(error) => self.make_room(error, parts, index..index + 1)?,
            }
        }
        Ok(())
    }

    /// Renders a part, and reads its tiles. Returns false if it had too little room: it must be rendered again.
    fn read_tiles(&self, at: &mut BatchPart, keep: bool, output: &mut Output<'_>) -> Result<bool> {
        let part = self.evaluate(at, keep)?;
        let contexts = part.context(self.scene).all(&part.beside);
        let (buffers, sums) = output.buffers(&contexts, &part.composite)?;
        let scenes = contexts.len();
        let Some((words, needed)) = self.read(at, buffers)? else { return Ok(false) };
        output.take(self.device(), &at.part_tiles, scenes, sums, words, needed)?;
        Ok(true)
    }

    /// The part, which is rendered unless it was kept.
    fn evaluate<'p>(&self, at: &'p mut BatchPart, keep: bool) -> Result<&'p Part> {
        if at.part.is_none() {
            at.is_for_gradients = keep;
            let counts = self.part_counts(at)?;
            at.part = Some(Part::evaluate(self.scene, self.cameras, &at.part_tiles, keep, counts)?);
        }
        Ok(at.part.as_ref().expect("it was just made"))
    }

    /// Counts on the device, with room for what the part is known or predicted to need. `None` where the host must wait for the counts.
    fn part_counts(&self, at: &BatchPart) -> Result<Option<PartCounts>> {
        let is_one_scene = self.scene.beside.is_empty();
        if !self.device().has_indirect_counts() || !is_one_scene {
            return Ok(None);
        }
        let predicted = || self.renderer.predictor().predict(self.kind(at), self.size(at));
        let capacity = match at.need {
            Need::Unknown => predicted(),
            Need::Underestimated => None,
            Need::Known(capacity) => Some(capacity),
        };
        let Some(capacity) = capacity else { return Ok(None) };
        let counts = match self.queue_counts {
            Some(counts) => counts.clone(),
            None => Arc::new(self.device().upload("counts", &NO_COUNTS)?),
        };
        Ok(Some(PartCounts::with(counts, capacity)))
    }

    fn kind(&self, at: &BatchPart) -> BatchKind {
        BatchKind {
            side: at.part_tiles.side,
            is_for_gradients: at.is_for_gradients,
            ray_steps: self.scene.ray_steps,
        }
    }

    /// Tiles and Gaussians.
    fn size(&self, at: &BatchPart) -> [u32; 2] {
        [at.part_tiles.tiles.len() as u32, self.scene.gaussians]
    }

    /// Reads buffers of a part, and what it needed. Waits once, or not at all if nothing is left to read. `None` if the part had too
    /// little room: the host waits for its counts next time.
    fn read(
        &self,
        at: &mut BatchPart,
        mut buffers: Vec<Buffer<u32>>,
    ) -> Result<Option<(Vec<Vec<u32>>, Capacity)>> {
        let part = at.part.as_ref().expect("it was evaluated");
        let counts = part.bins.part_counts.as_ref().filter(|_| at.need.known().is_none());
        buffers.extend(counts.map(|counts| counts.counts.view()));
        let mut words = match &buffers[..] {
            [] => Vec::new(),
            buffers => self.device().read_all(buffers)?,
        };
        let needed = match counts {
            Some(_) => Capacity::needed(&words.pop().expect("the counts were read")),
            None => at.need.known().or(Some(part.capacity)),
        };
        let Some(needed) = needed else {
            at.release();
            at.need = Need::Underestimated;
            return Ok(None);
        };
        if at.need.known().is_none() && self.device().has_indirect_counts() {
            self.renderer.predictor().observe(self.kind(at), self.size(at), needed);
        }
        at.need = Need::Known(needed);
        Ok(Some((words, needed)))
    }

    /// Adds dL/dtensor to gradients that are zero. The statistics may have values already.
    ///
    /// First, all parts go from tiles to splats, which gives the scale of the hash grids' sums. Then all go from splats to
    /// tensors. A batch of one part is one submission to a GPU, and one wait at its end.
    ///
    /// # Errors
    /// As [`Renderer::render`]. The gradients are then as they were before.
    pub fn backward(
        &self,
        parts: &mut Parts,
        loss: &mut LossSource<'_>,
        into: &SceneGradient,
    ) -> Result<()> {
        if !parts.is_taped {
            parts.keep_budget = self.kept_samples();
        }
        loop {
            let splats = self.backward_to_splats(parts, loss, into);
            // other ranks have gone on, and do not begin again
            let is_shared = self.ranks.is_some() && splats.is_ok();
            match splats.and_then(|()| self.backward_to_tensors(parts, loss, into)) {
                Ok(true) => return Ok(()),
                Ok(false) => {}
                Err(error) => {
                    into.rollback(self.device());
                    if is_shared {
                        return Err(error);
                    }
                    self.make_room(error, parts, 0..parts.list.len())?;
                }
            }
        }
    }

    /// Queues what [`Self::backward`] does, and waits for nothing. Returns the kind and the size of the batch. `None`, with nothing
    /// queued, where the host must wait: for a batch of several parts, and if it does not know the room that such batches need.
    ///
    /// If the batch has too little room, or its loss is not finite, it raises [`OVERFLOW`](muslin::count::OVERFLOW) in the counts,
    /// and it adds nothing. Nor do later batches, until the flag is cleared.
    pub fn queue(
        &self,
        parts: &mut Parts,
        loss: &mut LossSource<'_>,
        into: &SceneGradient,
    ) -> Result<Option<(BatchKind, [u32; 2])>> {
        let [at] = &mut parts.list[..] else { return Ok(None) };
        at.is_for_gradients = true;
        let kind = self.kind(at);
        let size = self.size(at);
        if self.renderer.predictor().predict(kind, size).is_none() {
            return Ok(None);
        }
        into.snapshot(self.device());
        let splats = self.backward_to_splats(parts, loss, into);
        let tensors = splats.and_then(|()| self.backward_to_tensors(parts, loss, into));
        tensors.inspect_err(|_| into.rollback(self.device()))?;
        Ok(Some((kind, size)))
    }

    /// Whether a batch has one part, whose counts the host need not know.
    fn is_alone(&self, parts: &Parts) -> bool {
        parts.list.len() == 1 && self.ranks.is_none()
    }

    /// From the tiles of each part to its splats, whose gradients raise the bounds of both hash grids' sums.
    fn backward_to_splats(
        &self,
        parts: &mut Parts,
        loss: &mut LossSource<'_>,
        into: &SceneGradient,
    ) -> Result<()> {
        let device = self.device();
        let is_alone = self.is_alone(parts);
        let mut index = 0;
        while let Some(at) = parts.list.get_mut(index) {
            self.evaluate(at, true)?;
            let part = at.part.as_ref().expect("it was evaluated");
            let image = &part.composite.image;
            let is_queued = self.queue_counts.is_some();
            let d_tiles =
                loss.backward(device, &at.part_tiles, &part.bins, is_queued, image, into)?;
            let d_pairs = device.run_in_pool(|| {
                let context = part.context(self.scene);
                let d_pairs = part.composite.backward(context, &d_tiles)?;
                part.raise_bounds(self.scene, &d_pairs.splat, into)?;
                Ok::<_, Error>(d_pairs)
            })?;
            at.d_tiles = Some(d_tiles);
            at.d_pairs = Some(d_pairs);
            if !is_alone {
                let Some((words, _)) = self.read(at, loss.buffers())? else { continue };
                loss.take(&at.part_tiles, &words);
                at.keep_or_release(&mut parts.keep_budget);
            }
            index += 1;
        }
        Ok(())
    }

    /// From the splats of each part to the tensors. Returns false if a batch's only part had too little room: nothing was
    /// added then.
    fn backward_to_tensors(
        &self,
        parts: &mut Parts,
        loss: &mut LossSource<'_>,
        into: &SceneGradient,
    ) -> Result<bool> {
        let device = self.device();
        let is_alone = self.is_alone(parts);
        let [pairs, samples] = self.samples(parts, into)?;
        device.run_in_pool(|| into.set_scales(device, self.scene, [&pairs, &samples]))?;
        let mut rows = match self.ranks {
            Some(ranks) => Some(Rows::new(device, ranks, into)?),
            None => None,
        };
        for index in 0..parts.list.len() {
            let continues = parts.continues(index);
            let at = &mut parts.list[index];
            self.evaluate(at, true)?;
            let part = at.part.as_ref().expect("it was evaluated");
            device.run_in_pool(|| {
                let d_pairs = match at.d_pairs.take() {
                    Some(d_pairs) => d_pairs,
                    None => {
                        let d_tiles = at.d_tiles.as_ref().expect("`backward_to_splats` has set it");
                        part.composite.backward(part.context(self.scene), d_tiles)?
                    }
                };
                part.backward(self.scene, &d_pairs, into, rows.as_mut(), continues)
            })?;
            at.d_tiles = None;
            if !(is_alone || parts.is_taped && at.is_kept) {
                at.release();
            }
        }
        if let (Some(ranks), Some(rows)) = (self.ranks, rows) {
            rows.add(parts.views)?;
            ranks::sum(device, ranks, into)?;
        }
        device.run_in_pool(|| into.finish(device))?;
        if is_alone && self.queue_counts.is_none() {
            let at = &mut parts.list[0];
            let Some((words, _)) = self.read(at, loss.buffers())? else { return Ok(false) };
            loss.take(&at.part_tiles, &words);
            if !(parts.is_taped && at.is_kept) {
                at.release();
            }
        }
        Ok(true)
    }

    /// The number of samples of the color field and of the transmittance field, over all parts and ranks. Ranks also share their bounds.
    fn samples(&self, parts: &Parts, into: &SceneGradient) -> Result<[Count; 2]> {
        if self.is_alone(parts) {
            let part = parts.list[0].part.as_ref().expect("it was evaluated");
            return Ok([part.bins.pairs.count.clone(), part.transmittance.samples.clone()]);
        }
        let mut samples = [0_i64; 2];
        for needed in parts.list.iter().filter_map(|at| at.need.known()) {
            samples[0] += i64::from(needed.pairs);
            samples[1] += i64::from(needed.samples);
        }
        if let Some(ranks) = self.ranks {
            ranks::share_bounds(self.device(), ranks, into, &mut samples)?;
        }
        match samples.map(u32::try_from) {
            [Ok(pairs), Ok(samples)] => Ok([pairs, samples].map(Count::known)),
            _ => argument(format!(
                "the step has {} samples, and their gradients are counted in 32 bits: use fewer tiles in a step",
                samples[1]
            )),
        }
    }

    /// Calls `evaluate` for every part of a batch. A part for which memory runs out is cut into smaller ones, and comes again.
    ///
    /// # Errors
    /// The errors of `evaluate`, and of [`Self::make_room`].
    pub fn each_part(
        &self,
        batch: &TileBatch,
        mut evaluate: impl FnMut(&PartTiles) -> Result<()>,
    ) -> Result<()> {
        let mut parts = self.cut(batch)?;
        let mut index = 0;
        while let Some(at) = parts.list.get(index) {
            match evaluate(&at.part_tiles) {
                Err(error) => self.make_room(error, &mut parts, index..index + 1)?,
                Ok(()) => index += 1,
            }
        }
        Ok(())
    }

    /// After memory ran out, releases the parts that were kept. If there are none, cuts the parts of `range` into smaller ones. If they have
    /// one tile each, forgets the predictions, because a part may need less.
    ///
    /// # Errors
    /// The error, if it is another one or if there is nothing more to give up.
    pub fn make_room(&self, error: Error, parts: &mut Parts, range: Range<usize>) -> Result<()> {
        if !error.is_out_of_memory() {
            return Err(error);
        }
        parts.list[range.clone()].iter_mut().for_each(BatchPart::release);
        if parts.keep_budget > 0 {
            parts.release();
            return Ok(());
        }
        if parts.list[range.clone()].iter().all(|at| at.part_tiles.tiles.len() == 1) {
            return if self.renderer.predictor().forget() { Ok(()) } else { Err(error) };
        }
        loop {
            // the next batch will not fit, either
            let bytes = self.renderer.halve_part_bytes();
            let mut smaller = Vec::new();
            for BatchPart { part_tiles, .. } in &parts.list[range.clone()] {
                smaller.extend(cut(self.scene, part_tiles.side, &part_tiles.tiles, bytes)?);
            }
            if smaller.len() > range.len() {
                parts.list.splice(range, smaller.into_iter().map(BatchPart::new));
                return Ok(());
            }
        }
    }
}
