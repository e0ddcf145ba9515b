//! Takes one step of gradient descent on a scene's opacities, by a loss of one's own.
//!
//! ```text
//! cargo run --release --example gradient -- scene.safetensors cameras.json
//! ```

use organza::{DeviceOptions, Renderer, Scene, TileBatch};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [scene, cameras] = std::env::args()
        .skip(1)
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| "expected SCENE CAMERAS")?;

    let renderer = Renderer::new(organza::open_device(&DeviceOptions::default())?);
    let mut scene = Scene::load(scene)?;
    let cameras = scene.load_cameras(cameras)?;
    let [width, height] = [cameras[0].width, cameras[0].height];
    let batch = TileBatch::cover(0, width, height, 32)?;

    // the loss is half the mean square of all values, so dL/dY is Y / n, and a step makes the image darker
    let loss = |values: &[f32]| {
        let squares = values.iter().map(|value| f64::from(*value).powi(2));
        squares.sum::<f64>() / (2.0 * values.len() as f64)
    };
    for _ in 0..2 {
        let uploaded = renderer.upload(&scene)?;
        let tape = renderer.record(&uploaded, &cameras, &batch)?;
        let values = &tape.tiles().data;
        println!("loss {:.6}", loss(values));
        let count = values.len() as f32;
        let grad_tiles: Vec<f32> = values.iter().map(|value| value / count).collect();
        let gradient = tape.backward(&grad_tiles)?;
        let slopes = &gradient.gaussians.opacity;
        for (opacity, slope) in scene.gaussians.opacity.iter_mut().zip(slopes) {
            *opacity -= 1e3 * slope;
        }
    }
    Ok(())
}
