//! Trains a scene on a data set with the library, without a folder, and writes it.
//!
//! ```text
//! cargo run --release --example train -- data/fox scene.safetensors 500
//! ```

use organza::{Dataset, DatasetOptions, DeviceOptions, Renderer, TrainConfig, Trainer};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [data, output, steps] = std::env::args()
        .skip(1)
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| "expected DATA OUTPUT STEPS")?;

    let renderer = Renderer::new(organza::open_device(&DeviceOptions::default())?);
    let dataset = Dataset::load(data, &DatasetOptions::default())?;
    let mut config = TrainConfig::default();
    config.run.steps = steps.parse()?;

    let mut trainer = Trainer::start(&renderer, config, dataset)?;
    while !trainer.is_finished() {
        let report = trainer.step()?;
        if trainer.steps().is_multiple_of(50) {
            println!("step {}: {:.2} dB", trainer.steps(), report.psnr);
        }
    }
    println!("held-out views: {:?}", trainer.evaluate()?.mean);
    trainer.scene().download(renderer.device())?.save(output)?;
    Ok(())
}
