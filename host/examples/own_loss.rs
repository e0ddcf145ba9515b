//! Trains a scene on a data set with a loss of one's own, Charbonnier's: the mean of `sqrt(d^2 + 1e-6)` over all values,
//! where d is the difference of the rendered tiles from the photographs.
//!
//! ```text
//! cargo run --release --example own_loss -- data/fox scene.safetensors 500
//! ```

use organza::render::{LossBatch, LossGradient};
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
        let report = trainer.step_with(|batch| Ok(charbonnier(batch)))?;
        if trainer.steps().is_multiple_of(50) {
            println!("step {}: loss {:.4}", trainer.steps(), report.loss);
        }
    }
    println!("held-out views: {:?}", trainer.evaluate()?.mean);
    trainer.scene().download(renderer.device())?.save(output)?;
    Ok(())
}

/// The loss, and its gradient with respect to the tiles, `[K, 3, S, S]`.
fn charbonnier(batch: &LossBatch<'_>) -> LossGradient {
    let rendered = &batch.rendered.data;
    let count = rendered.len() as f32;
    let mut loss = 0.0;
    let slope = |(y, truth): (&f32, &f32)| {
        let difference = y - truth;
        let length = (difference * difference + 1e-6).sqrt();
        loss += f64::from(length / count);
        difference / length / count
    };
    let grad_tiles = rendered.iter().zip(batch.target.image).map(slope).collect();
    LossGradient { loss, grad_tiles }
}
