//! The bytes that ranks send in a step. `docs/cluster.md` has the formulas for them.

use std::sync::Arc;

use organza::Renderer;
use organza::ranks::{Ranks, ThreadRanks};
use organza::scene::MlpConfig;
use organza::train::{TrainConfig, Trainer};
use organza_tests::devices;

use super::runs::begun;

/// If these numbers change, so do the tables in `docs/cluster.md`.
#[test]
fn a_step_sends_as_much_as_ever() {
    let (mut config, checkpoint, dataset) = begun();
    config.poses.refine = true;
    config.optimizer.transmittance_every = 1;
    let sent = ThreadRanks::run(2, |ranks| {
        let renderer = Renderer::new(devices::cpu(Some(1)));
        let ranks: Arc<dyn Ranks> = Arc::new(ranks);
        let trainer = Trainer::resume(&renderer, config.clone(), dataset.clone(), &checkpoint);
        let mut trainer = trainer.expect("a trainer").with_ranks(Arc::clone(&ranks));
        trainer.step().expect("a step");
        ranks.sent()
    });
    assert_eq!(sent, [37_272, 36_400]);
}

/// The page must have the sizes for the default settings.
#[test]
fn the_page_has_the_sizes() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/cluster.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let scene = TrainConfig::default().scene;
    // parameters of a network as devices have them: a hidden layer's outputs in multiples of 16, the last one's of 4
    let parameters = |mlp: &MlpConfig, mut inputs: u32| {
        let mut parameters = 0;
        for &width in &mlp.hidden {
            parameters += (inputs + 1) * width.next_multiple_of(16);
            inputs = width;
        }
        parameters + (inputs + 1) * 4
    };
    let [color, transmittance] = [&scene.color_grid, &scene.transmittance_grid];
    let sh = (scene.sh_degree + 1).pow(2);
    let p = parameters(&scene.color_mlp, sh + color.levels * color.features + scene.material)
        + parameters(
            &scene.transmittance_mlp,
            transmittance.levels * transmittance.features + scene.extra,
        );
    let d = 11 + scene.material + scene.extra;
    let v = color.entries() * color.features as usize;
    for fact in [format!("V = {v} for each grid"), format!("P = {p}"), format!("d = {d}")] {
        assert!(page.contains(&fact), "docs/cluster.md lacks `{fact}`");
    }
}
