//! Renders a batch of tiles with the library, and prints its cost.
//!
//! ```text
//! cargo run --release --example render_tiles -- scene.safetensors cameras.json tiles.json
//! ```

use std::time::Instant;

use organza::{DeviceOptions, Renderer, Scene, TileBatch};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [scene, cameras, tiles] = std::env::args()
        .skip(1)
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| "expected SCENE CAMERAS TILES")?;

    // a GPU if there is one, otherwise all cores
    let renderer = Renderer::new(organza::open_device(&DeviceOptions::default())?);
    println!("{}", renderer.device().choice());

    let scene = Scene::load(scene)?;
    let cameras = scene.load_cameras(cameras)?;
    let scene = renderer.upload(&scene)?;
    let batch = TileBatch::load(tiles)?;

    let start = Instant::now();
    let rendered = renderer.render(&scene, &cameras, &batch)?;
    println!("{:?} in {:.3} s", rendered.report, start.elapsed().as_secs_f64());

    // Y [K, 3, S, S]: tile after tile, red, green, blue, row after row
    let area = (rendered.side * rendered.side) as usize;
    for (index, tile) in rendered.data.chunks_exact(3 * area).take(4).enumerate() {
        let mean =
            |channel: usize| tile[channel * area..][..area].iter().sum::<f32>() / area as f32;
        println!("tile {index}: mean color {:.3} {:.3} {:.3}", mean(0), mean(1), mean(2));
    }
    Ok(())
}
