//! Photographs on a GPU, so that a step need not upload the pixels of its tiles.

use std::borrow::Cow;

use super::sampler::Target;
use muslin_device::{Buffer, Device};
use organza_core::{Error, Result, Tile, TileBatch};
use organza_data::{Frame, Photograph};
use organza_render::Photographs;
use organza_shaders::target::{TargetParams, TargetTile, TargetTilesKernel};

/// Bytes of photographs that stay on a GPU: this many, or this share of its memory if that is more. Tiles of other photographs are uploaded
/// in each step.
const RESIDENT_BYTES: u64 = 1 << 30;
const RESIDENT_SHARES: u64 = 4;
/// Bytes of a page.
const PAGE_BYTES: usize = 64 << 20;

/// Photographs that stay on a GPU.
#[derive(Debug)]
pub struct ResidentPhotographs {
    /// `[256]`: colors of 8 bits from 0 to 1.
    level: Buffer<f32>,
    /// Photographs, one after the other: words as [`organza_shaders::target`] reads them.
    pages: Vec<Buffer<u32>>,
    /// The page and the first word of each photograph that is on the GPU.
    places: Vec<(usize, u32)>,
}

impl ResidentPhotographs {
    /// Uploads as many photographs as fit. `None` on a CPU, which has them already.
    ///
    /// # Errors
    /// [`DeviceError::DeviceLost`](organza_core::error::DeviceError::DeviceLost).
    pub fn new(device: &Device, frames: &[&Frame]) -> Result<Option<Self>> {
        match device.backend() {
            "cpu" => Ok(None),
            _ => Self::on_pages(device, frames, PAGE_BYTES).map(Some),
        }
    }

    /// Like [`Self::new`], with pages of `page_bytes`; a larger photograph has a page of its own.
    fn on_pages(device: &Device, frames: &[&Frame], page_bytes: usize) -> Result<Self> {
        let level: Vec<_> = (0..=u8::MAX).map(|level| f32::from(level) / 255.0).collect();
        let level = device.upload("levels of colors", &level)?;
        let mut all = Self { level, pages: Vec::new(), places: Vec::new() };
        let max_bytes = device.memory_share(RESIDENT_SHARES, RESIDENT_BYTES);
        let mut bytes = 0;
        while all.places.len() < frames.len() {
            let mut words = Vec::new();
            let mut places = Vec::new();
            for frame in &frames[all.places.len()..] {
                let count = frame.image.pixels().len();
                if !words.is_empty() && (words.len() + count) * size_of::<u32>() > page_bytes {
                    break;
                }
                places.push((all.pages.len(), words.len() as u32));
                words.extend((0..count).map(|index| word(&frame.image, index)));
            }
            bytes += (words.len() * size_of::<u32>()) as u64;
            if bytes > max_bytes {
                break;
            }
            match device.upload("photographs", &words).map_err(Error::from) {
                Ok(page) => all.pages.push(page),
                Err(error) if error.is_out_of_memory() => break,
                Err(error) => return Err(error),
            }
            // the bytes go to the device before the next page's
            device.submit();
            all.places.extend(places);
        }
        Ok(all)
    }
}

/// A pixel: red in the lowest byte, then green, blue, and 255 if it is valid.
fn word(photograph: &Photograph, index: usize) -> u32 {
    let [red, green, blue] = photograph.pixels()[index];
    let is_valid = photograph.valid().is_none_or(|valid| valid[index]);
    u32::from_le_bytes([red, green, blue, if is_valid { 255 } else { 0 }])
}

/// The photographs behind the tiles of a step.
#[derive(Debug)]
pub struct StepPhotographs<'a> {
    pub resident: Option<&'a ResidentPhotographs>,
    pub frames: &'a [&'a Frame],
    pub batch: &'a TileBatch,
    /// Factor by which the images are smaller than the photographs.
    pub factor: u32,
}

impl Photographs for StepPhotographs<'_> {
    fn on_device(&self, device: &Device, places: &[usize]) -> Result<[Buffer<f32>; 2]> {
        let tiles = places.iter().map(|&place| self.batch.tiles[place]);
        let side = self.batch.side;
        let Some(resident) = self.resident else {
            let tiles = TileBatch { side, tiles: tiles.collect() };
            let target = device.run_in_pool(|| Target::new(&tiles, self.factor, self.frames));
            let Target { image, valid } = target?;
            return Ok([device.upload("photographs", &image)?, device.upload("masks", &valid)?]);
        };
        let pixels = places.len() * (side * side) as usize;
        let image = device.unwritten("photographs' tiles", 3 * pixels)?;
        let valid = device.unwritten("masks", pixels)?;
        let mut on_pages = vec![Vec::new(); resident.pages.len()];
        let mut on_own = Vec::new();
        let mut own = Vec::new();
        for (place, tile) in tiles.enumerate() {
            let photograph = &self.frames[tile.camera].image;
            let place = place as u32;
            if let Some(&(page, first)) = resident.places.get(tile.camera) {
                let [x, y] = tile.origin;
                let width = photograph.width();
                let height = photograph.height();
                on_pages[page].push(TargetTile { first, width, height, x, y, place });
                continue;
            }
            let side = side * self.factor;
            let first = own.len() as u32;
            on_own.push(TargetTile { first, width: side, height: side, x: 0, y: 0, place });
            square(photograph, &tile, self.factor, side, &mut own);
        }
        let own = match own.is_empty() {
            true => None,
            false => Some(device.upload("photographs of a step", &own)?),
        };
        let pages = resident.pages.iter().zip(on_pages).chain(own.iter().zip([on_own]));
        for (page, tiles) in pages.filter(|(_, tiles)| !tiles.is_empty()) {
            let factor = self.factor;
            let kernel = TargetTilesKernel {
                params: TargetParams { side, factor, share: 1.0 / (factor * factor) as f32 },
                tile: &device.upload("tiles of photographs", &tiles)?,
                level: &resident.level,
                pixels: page,
                image: &image,
                valid: &valid,
            };
            device.run_all(&kernel)?;
        }
        Ok([image, valid])
    }

    fn on_host(&self) -> Result<[Cow<'_, [f32]>; 2]> {
        let Target { image, valid } = Target::new(self.batch, self.factor, self.frames)?;
        Ok([image.into(), valid.into()])
    }
}

/// Adds the words of the `length` x `length` pixels of a photograph behind a tile. Pixels outside of the photograph are not valid.
fn square(photograph: &Photograph, tile: &Tile, factor: u32, length: u32, words: &mut Vec<u32>) {
    let [left, top] = tile.origin.map(|at| i64::from(at) * i64::from(factor));
    let [width, height] = [photograph.width(), photograph.height()].map(i64::from);
    for y in top..top + i64::from(length) {
        for x in left..left + i64::from(length) {
            let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
            words.push(if is_inside { word(photograph, (y * width + x) as usize) } else { 0 });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use muslin_check::devices;
    use organza_core::demo;

    /// Photographs, the second one with a mask.
    fn frames() -> Vec<Frame> {
        let sizes = [[40, 30], [33, 41], [7, 9], [40, 30]];
        let frame = |(index, size): (usize, [u32; 2])| {
            let count = size[0] * size[1];
            let color = |at: u32| [at, at / 3, at * 7 + 100].map(|value| value as u8);
            let valid = (index == 1).then(|| (0..count).map(|at| at % 23 > 2).collect());
            let pixels = (0..count).map(color).collect();
            let image = Photograph::new(size, pixels, valid).expect("a photograph");
            Frame { name: String::new(), camera: demo::turntable(1, 8).remove(0), image }
        };
        sizes.into_iter().enumerate().map(frame).collect()
    }

    /// Tiles within photographs and across their borders.
    fn batch(side: u32) -> TileBatch {
        let origins = [[0, 0], [-5, 3], [9, -2], [14, 11], [100, 0]];
        let of = |camera| origins.map(|origin| Tile { camera, origin });
        TileBatch { side, tiles: (0..4).flat_map(of).collect() }
    }

    #[test]
    fn a_gpu_cuts_the_bits_of_the_host() {
        let frames = frames();
        let frames: Vec<_> = frames.iter().collect();
        for (name, device) in devices::all(&organza_render::MODULES) {
            // one page, a page for each photograph, and memory that ends after the first page
            for (page_bytes, refused, resident) in [(PAGE_BYTES, 0, 4), (1, 0, 4), (1, 3, 1)] {
                device.refuse_one(refused);
                let photographs = ResidentPhotographs::on_pages(&device, &frames, page_bytes);
                let photographs = photographs.expect("a device");
                assert_eq!(photographs.places.len(), resident, "{name}");
                for (side, factor) in [(8, 1), (11, 2)] {
                    let batch = &batch(side);
                    let resident = Some(&photographs);
                    let step = StepPhotographs { resident, frames: &frames, batch, factor };
                    let places: Vec<_> = (0..batch.tiles.len()).rev().step_by(3).collect();
                    let found = step.on_device(&device, &places).expect("tiles");
                    let found = found.map(|values| device.read(&values).expect("values"));
                    let tiles = places.iter().map(|&place| batch.tiles[place]).collect();
                    let expected = Target::new(&TileBatch { side, tiles }, factor, &frames);
                    let Target { image, valid } = expected.expect("memory");
                    assert!(found == [image, valid], "{name}, {page_bytes}, side {side}");
                }
            }
        }
    }
}
