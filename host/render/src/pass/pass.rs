//! The one way through a batch: cut, render, keep, go back, and make room where memory ends.
//!
//! A view batch is a batch's tiles of one camera. Its gradients have the same bits on any rank, alone or in one
//! part with others. So the sum depends neither on how a batch is cut into parts, nor on how many
//! [ranks](organza_core::ranks) share it. View batches are dealt to ranks: rank v mod R has the one with the number v.
//!
//! - **hash grids** are summed as 64-bit integers, which are exact in any order. All view batches share one scale: its
//!   bound is the largest of all bounds.
//! - **networks and poses** are summed as [binned](muslin::binned) sums, which are exact, too.
//! - **Gaussians** are summed camera by camera; between ranks as [`Rows`].

use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

use glam::Vec4;

use super::part::{Part, TileGradient};
use super::ranks::{Rows, finish, set_scales};
use crate::stages::cut::{Limits, PartTiles, PlannedTile, by_camera, cut, values_of_tiles};
use crate::{Capacity, DeviceScene, Renderer, SceneGradient};
use muslin_device::{Buffer, Device};
use organza_core::ranks::Ranks;
use organza_core::{Camera, Result, TileBatch};

/// The most pairs and samples of parts that are kept between both directions: about 2 GiB of tables. Other parts are
/// rendered again.
const KEPT_SAMPLES: u64 = 1 << 24;

/// A batch on its way through the stages.
#[derive(Clone, Copy)]
pub struct Pass<'a> {
    pub renderer: &'a Renderer,
    pub scene: &'a DeviceScene,
    pub cameras: &'a [Camera],
    /// Those that share the batch, if there are several.
    pub ranks: Option<&'a dyn Ranks>,
    /// View batches of all ranks.
    pub views: usize,
}

/// The parts of a batch.
#[derive(Debug, Default)]
pub struct Parts {
    list: Vec<PassPart>,
    /// Pairs and samples that may still be kept.
    room: u64,
    /// Whether parts are kept after the way back, too.
    stays: bool,
}

/// A part of a batch.
#[derive(Debug)]
pub struct PassPart {
    pub plan: PartTiles,
    /// Once it was rendered: pairs and samples.
    needed: [u64; 2],
    /// None where it is rendered again.
    part: Option<Arc<Part>>,
    /// Between both passes of the way back.
    of_tiles: Option<TileGradient>,
    /// `[pairs, 3]`, of a part that is kept.
    of_pairs: Option<Buffer<Vec4>>,
}

/// Takes dL/dY of a part.
pub type GoBack<'b> = dyn FnMut(TileGradient) -> Result<()> + 'b;

impl Parts {
    /// Gives up the memory of kept parts.
    pub fn release(&mut self) {
        self.room = 0;
        for part in &mut self.list {
            part.part = None;
            part.of_pairs = None;
        }
    }

    /// Whether the last camera of a part continues in the next one.
    fn continues(&self, at: usize) -> bool {
        let part = &self.list[at];
        self.list.get(at + 1).is_some_and(|next| {
            let [last, first] = [part.plan.tiles.last(), next.plan.tiles.first()];
            last.map(|tile| tile.view) == first.map(|tile| tile.view)
        })
    }
}

impl PassPart {
    fn new(plan: PartTiles) -> Self {
        Self { plan, needed: [0; 2], part: None, of_tiles: None, of_pairs: None }
    }

    /// Keeps a rendered part, if there is room.
    fn keep(&mut self, part: Arc<Part>, needed: Capacity, room: &mut u64) {
        self.needed = [needed.pairs, needed.samples].map(u64::from);
        let takes: u64 = self.needed.iter().sum();
        if self.part.is_none() && takes <= *room {
            *room -= takes;
            self.part = Some(part);
        }
    }
}

impl<'a> Pass<'a> {
    fn device(&self) -> &'a Device {
        self.renderer.device()
    }

    /// This rank's tiles of a batch, by camera, and how many view batches all ranks have.
    pub fn deal(&self, batch: &TileBatch) -> Result<(Vec<PlannedTile>, usize)> {
        let most = Limits::new(self.scene, batch.side, self.renderer.part_bytes())?.tiles;
        let mut tiles = by_camera(batch, most);
        let views = tiles.last().map_or(0, |tile| tile.view + 1);
        if let Some(ranks) = self.ranks {
            tiles.retain(|tile| tile.view % ranks.size() == ranks.rank());
        }
        Ok((tiles, views))
    }

    /// Cuts a batch into parts that fit the device.
    pub fn cut(&self, batch: &TileBatch) -> Result<Parts> {
        self.cut_tiles(batch.side, &by_camera(batch, usize::MAX))
    }

    /// Like [`Pass::cut`], for some tiles, ordered by camera.
    pub fn cut_tiles(&self, side: u32, tiles: &[PlannedTile]) -> Result<Parts> {
        let plans = cut(self.scene, side, tiles, self.renderer.part_bytes())?;
        let list = plans.into_iter().map(PassPart::new).collect();
        Ok(Parts { list, ..Parts::default() })
    }

    /// Renders all parts, and shows each to `each`, which [reads](Part::read) what it needs: nothing waits for the
    /// device before. With `keep`, parts are kept for [`Pass::backward`].
    pub fn forward(
        &self,
        parts: &mut Parts,
        keep: bool,
        mut each: impl FnMut(&PartTiles, &Part) -> Result<Option<Capacity>>,
    ) -> Result<()> {
        parts.room = if keep { KEPT_SAMPLES } else { 0 };
        parts.stays = keep;
        let all = self.visit(parts, |at, room| {
            let (part, needed) = self.render(at, keep, |part| each(&at.plan, part))?;
            at.keep(part, needed, room);
            Ok(true)
        });
        all.map(drop)
    }

    /// Adds dL/dtensor to gradients that are zero, but for the statistics. `of_tiles` says dL/dY of each part: it calls the
    /// function that it gets with it, and then [reads](Part::read) what it needs.
    ///
    /// A batch of one part is one submission to a GPU, and one wait. Otherwise, a first pass finds the scale of the sums,
    /// and a second one adds.
    ///
    /// # Errors
    /// As [`Renderer::render`]. The gradients are then as they were before.
    pub fn backward(
        &self,
        parts: &mut Parts,
        mut of_tiles: impl FnMut(&PartTiles, &Part, &mut GoBack<'_>) -> Result<Option<Capacity>>,
        into: &SceneGradient,
    ) -> Result<()> {
        if !parts.stays {
            parts.room = KEPT_SAMPLES;
        }
        loop {
            let added = match self.find_scales(parts, &mut of_tiles, into) {
                Ok(true) => Ok(()),
                Ok(false) => self.add_all(parts, into),
                Err(error) => Err(error),
            };
            let Err(error) = added else { return Ok(()) };
            into.rollback(self.device());
            let all = 0..parts.list.len();
            // other ranks do not begin again
            let again = error.is_out_of_memory() && self.ranks.is_none();
            if !(again && self.make_room(parts, all)?) {
                return Err(error);
            }
        }
    }

    /// [`Pass::backward`] of `grad_tiles [K, 3, S, S]`, dL/dY of the batch.
    pub fn backward_from(
        &self,
        parts: &mut Parts,
        grad_tiles: &[f32],
        into: &SceneGradient,
    ) -> Result<()> {
        let device = self.device();
        let of_tiles = |plan: &PartTiles, part: &Part, back: &mut GoBack<'_>| {
            let values = values_of_tiles(grad_tiles, &plan.tiles, 3 * plan.area());
            let grad_tiles = device.upload("gradient of the tiles", &values)?;
            back(TileGradient { grad_tiles, distortion: None })?;
            Ok(part.read(device, Vec::new())?.map(|(_, needed)| needed))
        };
        self.backward(parts, of_tiles, into)
    }

    /// The first pass: goes back to the pairs of each part, and raises the bounds of both hash grids' sums. A batch of one
    /// part goes all the way. Returns whether it did.
    fn find_scales(
        &self,
        parts: &mut Parts,
        of_tiles: &mut impl FnMut(&PartTiles, &Part, &mut GoBack<'_>) -> Result<Option<Capacity>>,
        into: &SceneGradient,
    ) -> Result<bool> {
        let device = self.device();
        let is_alone = self.ranks.is_none();
        let tiles: usize = parts.list.iter().map(|part| part.plan.tiles.len()).sum();
        let mut is_done = false;
        self.visit(parts, |at, room| {
            let is_only = is_alone && at.plan.tiles.len() == tiles;
            let mut found = None;
            let rendered = self.render(at, true, |part| {
                of_tiles(&at.plan, part, &mut |of_tiles| {
                    found = device.run_in_pool(|| {
                        let of_pairs = self.pair_gradient(at, part, &of_tiles)?;
                        if is_only {
                            part.backward(self.scene, &of_pairs, into)?;
                        }
                        Ok::<_, organza_core::Error>(Some((of_tiles, of_pairs)))
                    })?;
                    Ok(())
                })
            });
            let rollback = |_: &_| {
                if is_only {
                    into.rollback(device)
                }
            };
            let (part, needed) = rendered.inspect_err(rollback)?;
            is_done = is_only;
            if !is_only && let Some((of_tiles, of_pairs)) = found {
                device.run_in_pool(|| part.raise_bounds(device, &of_pairs, into))?;
                at.keep(part, needed, room);
                at.of_pairs = at.part.is_some().then_some(of_pairs);
                at.of_tiles = Some(of_tiles);
            }
            Ok(true)
        })?;
        Ok(is_done)
    }

    /// The second pass: adds the gradients of all parts, and those of all ranks.
    fn add_all(&self, parts: &mut Parts, into: &SceneGradient) -> Result<()> {
        let device = self.device();
        let samples = [0, 1]
            .map(|field| parts.list.iter().map(|part| part.needed[field] as i64).sum::<i64>());
        set_scales(device, self.ranks, self.scene, into, samples)?;
        let rows = self.ranks.map(|ranks| Rows::new(device, ranks, into));
        let mut rows = rows.transpose()?;
        for index in 0..parts.list.len() {
            let continues = parts.continues(index);
            let at = &mut parts.list[index];
            let rows = rows.as_mut();
            let read = |part: &Part| Ok(part.read(device, Vec::new())?.map(|(_, needed)| needed));
            let (part, _) = self.render(at, true, read)?;
            let of_pairs = at.of_pairs.take();
            let of_tiles = at.of_tiles.take().expect("of the first pass");
            device.run_in_pool(|| {
                let of_pairs = match of_pairs {
                    Some(of_pairs) => of_pairs,
                    None => self.pair_gradient(at, &part, &of_tiles)?,
                };
                part.add_pairs(self.scene, &of_pairs, into, rows, continues)
            })?;
            if !parts.stays {
                parts.list[index].part = None;
            }
        }
        rows.map_or(Ok(()), |rows| rows.add(self.views))?;
        finish(device, self.ranks, into)
    }

    /// `[pairs, 3]`
    fn pair_gradient(
        &self,
        at: &PassPart,
        part: &Part,
        of_tiles: &TileGradient,
    ) -> Result<Buffer<Vec4>> {
        part.pair_gradient(self.scene, at.plan.side, of_tiles)
    }

    /// A part that was kept, or that is rendered again, with a predicted capacity. If that was too small, or without a
    /// prediction, it has room for everything. `read` has read what the part needed.
    fn render(
        &self,
        at: &PassPart,
        keep: bool,
        mut read: impl FnMut(&Part) -> Result<Option<Capacity>>,
    ) -> Result<(Arc<Part>, Capacity)> {
        if let Some(part) = &at.part {
            let needed = read(part)?.expect("it was read before");
            return Ok((part.clone(), needed));
        }
        let mut capacity = self.renderer.predict(self.scene, &at.plan);
        loop {
            let evaluate = || Part::evaluate(self.scene, self.cameras, &at.plan, keep, capacity);
            let part = self.device().run_in_pool(evaluate)?;
            match read(&part)? {
                Some(needed) => {
                    self.renderer.observe(self.scene, &at.plan, needed);
                    return Ok((Arc::new(part), needed));
                }
                None => capacity = None,
            }
        }
    }

    /// Calls `work` with each part, as long as it returns true, and with how much may still be kept. Where memory ends, it
    /// is called again for the part, or for its pieces. Returns whether it was called to the end.
    pub fn visit(
        &self,
        parts: &mut Parts,
        mut work: impl FnMut(&mut PassPart, &mut u64) -> Result<bool>,
    ) -> Result<bool> {
        let mut index = 0;
        while let Some(part) = parts.list.get_mut(index) {
            match work(part, &mut parts.room) {
                Ok(true) => index += 1,
                Ok(false) => return Ok(false),
                Err(error) if error.is_out_of_memory() => {
                    if !self.make_room(parts, index..index + 1)? {
                        return Err(error);
                    }
                }
                Err(error) => return Err(error),
            }
        }
        Ok(true)
    }

    /// After memory ran out, gives up what was kept; then cuts some parts into pieces; then forgets what was predicted, as
    /// a part may need less. Returns false if there is nothing more to give up.
    fn make_room(&self, parts: &mut Parts, range: Range<usize>) -> Result<bool> {
        if parts.list.iter().any(|part| part.part.is_some()) {
            parts.release();
            return Ok(true);
        }
        if parts.list[range.clone()].iter().all(|part| part.plan.tiles.len() == 1) {
            return Ok(self.renderer.forget());
        }
        loop {
            // the next batch will not fit, either
            let bytes = self.renderer.halve_part_bytes();
            let mut pieces = Vec::new();
            for PassPart { plan, .. } in &parts.list[range.clone()] {
                let plans = cut(self.scene, plan.side, &plan.tiles, bytes)?;
                pieces.extend(plans.into_iter().map(PassPart::new));
            }
            if pieces.len() > range.len() {
                parts.list.splice(range, pieces);
                return Ok(true);
            }
        }
    }
}

/// Batches that a prediction takes into account.
const BATCHES: usize = 16;
/// Extra capacity, as a fraction of the largest number that one of them needed.
const MARGIN: f64 = 0.125;
/// Extra capacity that does not depend on the batches.
const LEAST: f64 = 1024.0;
/// Kernels count items in 32 bits, and some of them in steps of three.
const MOST: f64 = (u32::MAX / 4) as f64;

/// The room that recent batches needed, per tile.
#[derive(Debug, Default, PartialEq)]
pub struct CapacityPredictor {
    /// The scene's Gaussians and the tiles' side: other kinds of batches need other capacities.
    kind: [u32; 2],
    seen: VecDeque<[f64; 3]>,
}

impl CapacityPredictor {
    /// Records what a batch of `tiles` tiles has needed.
    pub fn observe(&mut self, kind: [u32; 2], tiles: usize, needed: Capacity) {
        if kind != self.kind {
            (self.kind, self.seen) = (kind, VecDeque::new());
        }
        self.seen.truncate(BATCHES - 1);
        let Capacity { pairs, members, samples } = needed;
        self.seen
            .push_front([pairs, members, samples].map(|number| f64::from(number) / tiles as f64));
    }

    /// The capacity for a batch of `tiles` tiles; `None` before the first batch of this kind, or if it exceeds 32 bits.
    pub fn predict(&self, kind: [u32; 2], tiles: usize) -> Option<Capacity> {
        if kind != self.kind {
            return None;
        }
        let most = |which: usize| self.seen.iter().map(|seen| seen[which]).reduce(f64::max);
        let capacity = |which| {
            let number = most(which)? * tiles as f64 * (1.0 + MARGIN) + LEAST;
            (number < MOST).then(|| rounded_up(number as u32))
        };
        Some(Capacity { pairs: capacity(0)?, members: capacity(1)?, samples: capacity(2)? })
    }
}

/// With four significant bits. So tables mostly have the size of the last step's, and with it their memory and bind groups.
fn rounded_up(number: u32) -> u32 {
    number.next_multiple_of(1 << number.ilog2().saturating_sub(3))
}

#[cfg(test)]
mod tests {
    use super::*;

    const KIND: [u32; 2] = [100, 16];

    fn needed(samples: u32) -> Capacity {
        Capacity { pairs: 10, members: 20, samples }
    }

    #[test]
    fn room_is_for_the_most_that_was_seen_lately() {
        let mut predictor = CapacityPredictor::default();
        assert_eq!(predictor.predict(KIND, 4), None);
        predictor.observe(KIND, 4, needed(80_000));
        for _ in 0..BATCHES - 1 {
            predictor.observe(KIND, 4, needed(8_000));
        }
        let capacity = predictor.predict(KIND, 8).expect("seen");
        // 22, 45 and 180,000, and 1024 more, with four significant bits
        assert_eq!(capacity, Capacity { pairs: 1152, members: 1152, samples: 196_608 });
        predictor.observe(KIND, 4, needed(8_000));
        assert_eq!(predictor.predict(KIND, 4).expect("seen").samples, 10_240);
        // another scene
        assert_eq!(predictor.predict([101, 16], 4), None);
        predictor.observe([101, 16], 4, needed(800));
        assert_eq!(predictor.predict([101, 16], 4).expect("seen").samples, 2048);
        assert_eq!(predictor.predict(KIND, 4), None);
    }

    #[test]
    fn counts_beyond_the_limit_are_not_predicted() {
        let mut predictor = CapacityPredictor::default();
        predictor.observe(KIND, 1, needed(u32::MAX));
        assert_eq!(predictor.predict(KIND, 1), None);
    }
}
