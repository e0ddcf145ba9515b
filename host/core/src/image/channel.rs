//! Channels besides color as images: 16-bit PNG.

use std::io;
use std::path::Path;

use png::{BitDepth, ColorType};

use super::{png_of, visible_pixels};
use crate::error::argument;
use crate::{Channel, RenderedTiles, Result, TileBatch, write_atomic};
use muslin_error::memory;

/// Default levels of a 16-bit PNG for one unit of depth. A level is a thousandth, as in the depth images that
/// nerfstudio reads.
pub const PNG_DEPTH_SCALE: f32 = 1000.0;

/// A channel of a whole view.
#[derive(Clone, Debug, PartialEq)]
pub struct ChannelImage {
    channel: Channel,
    size: [u32; 2],
    values: Vec<f32>,
}

impl ChannelImage {
    /// An image of zeros.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn new(channel: Channel, width: u32, height: u32) -> Result<Self> {
        let pixels = u64::from(width) * u64::from(height);
        let what = format!("the channel {} of {width} x {height} pixels", channel.name());
        let len = usize::try_from(pixels * channel.planes() as u64).unwrap_or(usize::MAX);
        Ok(Self { channel, size: [width, height], values: memory::zeros(len, &what)? })
    }

    /// Fails if there is not enough memory to make and write an image. Writing may take twice as much as the image
    /// again.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
    pub fn check_memory(channels: &[Channel], width: u32, height: u32) -> Result<()> {
        let planes: usize = channels.iter().map(|channel| channel.planes()).sum();
        let largest = channels.iter().map(|channel| channel.planes()).max().unwrap_or(0);
        let plane = 4 * u64::from(width) * u64::from(height);
        let what = format!("the channels of an image of {width} x {height} pixels");
        Ok(memory::check(plane * (planes + 2 * largest) as u64, &what)?)
    }

    /// The channel that it shows.
    pub fn channel(&self) -> Channel {
        self.channel
    }

    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Values, `[planes, height, width]`.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// Copies a rendered channel to the places of its tiles in `batch`. Parts beyond the edge are cut off.
    ///
    /// # Errors
    /// [`Error::Argument`](crate::Error::Argument) if the tiles do not belong to the batch, or do not have the channel.
    pub fn paste(&mut self, batch: &TileBatch, tiles: &RenderedTiles) -> Result<()> {
        let area = (batch.side * batch.side) as usize;
        let planes = self.channel.planes();
        let rendered = tiles.channels.get(&self.channel);
        let rendered = rendered.filter(|values| values.len() == batch.tiles.len() * planes * area);
        let Some(rendered) = rendered else {
            let name = self.channel.name();
            return argument(format!(
                "the rendered tiles do not have the channel {name} of this batch"
            ));
        };
        let pixels = self.size[0] as usize * self.size[1] as usize;
        visible_pixels(batch, self.size, |tile, at, place| {
            for plane in 0..planes {
                self.values[plane * pixels + place] = rendered[(tile * planes + plane) * area + at];
            }
        });
        Ok(())
    }

    /// Number of pixels whose depth exceeds a 16-bit PNG's range: they get its largest level.
    pub fn clipped(&self, depth_scale: f32) -> u64 {
        let is_clipped = |depth: &&f32| **depth * depth_scale >= 65_535.5;
        match self.channel {
            Channel::Depth => self.values.iter().filter(is_clipped).count() as u64,
            _ => 0,
        }
    }

    /// Number of values that are NaN or infinite: networks with huge weights and Gaussians far away can cause that.
    pub fn not_finite(&self) -> u64 {
        self.values.iter().filter(|value| !value.is_finite()).count() as u64
    }

    /// Writes the image, atomically: depth times `depth_scale`, usually [`PNG_DEPTH_SCALE`]; alpha and visibility from 0 to 1;
    /// each component of a normal from -1 to 1. Values are clamped, and rounded to the nearest of 65,536 levels. NaN is 0.
    ///
    /// # Errors
    /// [`Error::WriteFile`](crate::Error::WriteFile).
    pub fn save(&self, path: impl AsRef<Path>, depth_scale: f32) -> Result<()> {
        write_atomic(path, |writer| writer.write_all(&self.encode(depth_scale)?))
    }

    fn encode(&self, depth_scale: f32) -> io::Result<Vec<u8>> {
        let planes = self.channel.planes();
        let pixels = self.values.len() / planes;
        let level = |value: f32| match self.channel {
            Channel::Depth => to_16_bit(value * depth_scale / 65_535.0),
            Channel::Alpha | Channel::Visibility => to_16_bit(value),
            Channel::Normal => to_16_bit(0.5 * value + 0.5),
        };
        let values = (0..pixels).flat_map(|at| (0..planes).map(move |plane| plane * pixels + at));
        let levels: Vec<_> = values.map(|at| level(self.values[at]).to_be_bytes()).collect();
        let color = if planes == 3 { ColorType::Rgb } else { ColorType::Grayscale };
        png_of(levels.as_flattened(), self.size, color, BitDepth::Sixteen)
    }
}

/// Rounds a value from 0 to 1 to the nearest of 65,536 levels. Values outside are clamped, and NaN is 0.
fn to_16_bit(value: f32) -> u16 {
    (value.clamp(0.0, 1.0) * 65_535.0).round() as u16
}
