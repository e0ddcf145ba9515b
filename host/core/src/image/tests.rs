use super::*;
use crate::{Channel, Tile};

/// The content of a tile: a value that encodes column, row and channel.
fn rendered(batch: &TileBatch, value: impl Fn(i32, i32, usize) -> f32) -> RenderedTiles {
    let side = batch.side as i32;
    let mut data = Vec::new();
    for tile in &batch.tiles {
        for channel in 0..3 {
            for row in 0..side {
                for column in 0..side {
                    data.push(value(tile.origin[0] + column, tile.origin[1] + row, channel));
                }
            }
        }
    }
    let side = batch.side;
    RenderedTiles { side, count: batch.tiles.len(), data, ..RenderedTiles::default() }
}

fn gradient(x: i32, y: i32, channel: usize) -> f32 {
    [x as f32 / 255.0, y as f32 / 255.0, (x ^ y) as f32 / 255.0][channel]
}

#[test]
fn an_image_does_not_depend_on_how_it_was_cut() {
    let width = 53;
    let height = 31;
    let mut images = Vec::new();
    for side in [1, 7, 16, 31, 53, 64] {
        let mut image = Image::new(width, height).unwrap();
        for batch in bands(0, [width, height], side) {
            let batch = batch.unwrap();
            image.paste(&batch, &rendered(&batch, gradient)).unwrap();
        }
        images.push(image);
    }
    assert!(images.iter().all(|image| *image == images[0]));
    assert_eq!(images[0].pixels()[0], [0, 0, 0]);
    assert_eq!(images[0].pixels()[17 * 53 + 40], [40, 17, 40 ^ 17]);
    assert_eq!(images[0].not_finite(), 0);
}

#[test]
fn bands_cover_every_pixel_once() {
    let cuts =
        [([9000, 9000], 512, 18), ([65536, 3], 1, 1), ([1, 65536], 4096, 16), ([1, 1], 64, 1)];
    for (size, side, expected) in cuts {
        let mut next = 0;
        let mut batches = 0;
        for batch in bands(3, size, side) {
            let batch = batch.unwrap();
            let row = size[0].div_ceil(side) as usize;
            assert_eq!(batch.tiles[0], Tile { camera: 3, origin: [0, next] });
            next += (batch.tiles.len() / row) as i32 * side as i32;
            batches += 1;
        }
        assert_eq!(next as u32, size[1].next_multiple_of(side));
        assert_eq!(batches, expected);
    }
}

#[test]
fn bad_sizes_are_errors() {
    for (size, side) in [([0, 5], 8), ([5, 0], 8), ([5, 5], 10_000)] {
        assert!(bands(0, size, side).next().unwrap().is_err(), "{size:?} {side}");
    }
    let batch = TileBatch::cover(0, 8, 8, 4).unwrap();
    let mut tiles = rendered(&batch, gradient);
    tiles.data.pop();
    assert!(Image::new(8, 8).unwrap().paste(&batch, &tiles).is_err());
}

#[test]
fn tiles_are_cut_off_at_the_edge() {
    let origins = [[-2, -3], [100, 0], [0, -100], [3, 2]];
    let tiles = origins.map(|origin| Tile { camera: 0, origin }).to_vec();
    let batch = TileBatch { side: 4, tiles };
    let mut image = Image::new(5, 4).unwrap();
    image.paste(&batch, &rendered(&batch, |_, _, _| 1.0)).unwrap();
    let white = |index: &usize| image.pixels()[*index] == [255; 3];
    assert_eq!((0..20).filter(white).collect::<Vec<_>>(), [0, 1, 13, 14, 18, 19]);
}

#[test]
fn values_are_rounded_and_clamped() {
    let levels = [-1.0, 0.0, 0.49 / 255.0, 0.51 / 255.0, 0.5, 1.0, 2.0, f32::INFINITY, f32::NAN];
    assert_eq!(levels.map(to_8_bit), [0, 0, 0, 1, 128, 255, 255, 255, 0]);
    for level in 0..=255 {
        assert_eq!(to_8_bit(f32::from(level) / 255.0), level);
    }
    let batch = TileBatch::cover(0, 4, 4, 4).unwrap();
    let mut image = Image::new(4, 4).unwrap();
    let bad = |x, y, _| if x == y { f32::NAN } else { 0.5 };
    image.paste(&batch, &rendered(&batch, bad)).unwrap();
    assert_eq!(image.not_finite(), 4);
}

fn decode(path: &Path) -> (png::Info<'static>, Vec<u8>) {
    let decoder = png::Decoder::new(io::BufReader::new(std::fs::File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    (reader.info().clone(), pixels)
}

#[test]
fn other_programs_read_the_files() {
    let folder = tempfile::tempdir().unwrap();
    let mut image = Image::new(37, 21).unwrap();
    let batch = TileBatch::cover(0, 37, 21, 8).unwrap();
    image.paste(&batch, &rendered(&batch, gradient)).unwrap();
    let png = folder.path().join("view.png");
    image.save_png(&png).unwrap();
    let (info, pixels) = decode(&png);
    assert_eq!((info.width, info.height), (37, 21));
    assert_eq!(pixels, image.pixels().as_flattened());

    let mut depth = ChannelImage::new(Channel::Depth, 5, 3).unwrap();
    let batch = TileBatch::cover(0, 5, 3, 8).unwrap();
    let mut tiles = rendered(&batch, gradient);
    let depths: Vec<_> = (0..64).map(|at| at as f32 + 0.25).collect();
    tiles.channels.insert(Channel::Depth, depths);
    depth.paste(&batch, &tiles).unwrap();
    let png = folder.path().join("view.depth.png");
    depth.save(&png, PNG_DEPTH_SCALE).unwrap();
    let levels: Vec<_> = depth.values().iter().map(|depth| (1000.0 * depth) as u16).collect();
    let expected: Vec<_> = levels.iter().flat_map(|level| level.to_be_bytes()).collect();
    assert_eq!(decode(&png).1, expected);
}
