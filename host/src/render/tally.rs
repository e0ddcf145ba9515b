//! How many pairs, members and samples a part has: heard from the device, or left there.

use std::sync::Arc;

use organza_kernel::count::MISFIT;
use organza_shaders::count::{
    COUNTS, CountAdmitKernel, CountAdmitParams, CountWithholdKernel, CountWithholdParams, MEMBERS,
    PAIRS, SAMPLES,
};

use super::bin::Mask;
use organza_device::Result;
use organza_device::{Buffer, Count, Device};

/// How many there is room for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Room {
    /// (Gaussian, camera) pairs.
    pub pairs: u32,
    /// (Gaussian, tile) memberships.
    pub members: u32,
    /// Samples of the transmittance network.
    pub samples: u32,
}

/// What a part has found out about the room it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needed {
    /// So much.
    Room(Room),
    /// More than there was: all of the part is empty.
    More,
}

impl Needed {
    /// Of the values of [`Tally::counts`].
    pub fn of(counts: &[u32]) -> Self {
        let [pairs, members, samples] =
            [PAIRS, MEMBERS, SAMPLES].map(|place| counts[place as usize]);
        match counts[MISFIT as usize] {
            0 => Self::Room(Room { pairs, members, samples }),
            _ => Self::More,
        }
    }
}

/// Numbers that stay on the device: see [`organza_shaders::count`].
#[derive(Debug)]
pub struct Tally {
    counts: Arc<Buffer<u32>>,
    room: Room,
}

impl Tally {
    /// Of nothing yet.
    pub fn new(device: &Device, room: Room) -> Result<Self> {
        Ok(Self { counts: Arc::new(device.zeros("counts", COUNTS as usize)?), room })
    }

    /// The total at `last` of exclusive sums is the number at a place.
    pub fn admit(
        &self,
        device: &Device,
        place: u32,
        first: &Buffer<u32>,
        last: usize,
    ) -> Result<()> {
        let room = self.room_for(place);
        let params = CountAdmitParams { place, last: last as u32, room };
        device.run(&CountAdmitKernel { params, first, counts: &*self.counts }, 1, 1)
    }

    /// What was admitted counts from here on; where something did not fit, masks and ranges are empty.
    pub fn settle(
        &self,
        device: &Device,
        masks: [&Mask; 2],
        ranges: &[&Buffer<u32>],
    ) -> Result<()> {
        let of_masks = masks.into_iter().flat_map(|mask| [&mask.bits, &mask.first]);
        for table in of_masks.chain(ranges.iter().copied()) {
            let params = CountWithholdParams { len: table.len() as u32 };
            let kernel = CountWithholdKernel { params, counts: &*self.counts, table };
            device.run(&kernel, params.len, 1)?;
        }
        device.settle_counts();
        Ok(())
    }

    /// The number at a place.
    pub fn count(&self, place: u32) -> Count {
        Count::on_device(&self.counts, place, self.room_for(place))
    }

    /// Where the numbers are: what [`Needed::of`] makes sense of.
    pub fn counts(&self) -> &Buffer<u32> {
        &self.counts
    }

    fn room_for(&self, place: u32) -> u32 {
        match place {
            PAIRS => self.room.pairs,
            MEMBERS => self.room.members,
            SAMPLES => self.room.samples,
            _ => unreachable!("nothing else is counted"),
        }
    }
}
