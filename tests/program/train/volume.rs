//! The bytes that ranks send in a step, call by call. `docs/cluster.md` has the formulas for them.

use std::sync::{Arc, Mutex};

use organza::ranks::{Ranks, ThreadRanks};
use organza::scene::MlpConfig;
use organza::train::{TrainConfig, Trainer};
use organza::{Renderer, Result};
use organza_tests::devices;

use super::runs::begun;

/// Ranks that record the bytes that they send.
#[derive(Debug)]
struct Counted {
    ranks: ThreadRanks,
    calls: Mutex<Vec<(&'static str, u64)>>,
}

impl Counted {
    fn count(&self, call: &'static str, bytes: usize) {
        self.calls.lock().unwrap().push((call, bytes as u64));
    }
}

impl Ranks for Counted {
    fn rank(&self) -> usize {
        self.ranks.rank()
    }
    fn size(&self) -> usize {
        self.ranks.size()
    }
    fn max(&self, values: &mut [u32]) -> Result<()> {
        self.count("max", size_of_val(values));
        self.ranks.max(values)
    }
    fn or(&self, values: &mut [u32]) -> Result<()> {
        self.count("or", size_of_val(values));
        self.ranks.or(values)
    }
    fn sum(&self, values: &mut [i64]) -> Result<()> {
        self.count("sum", size_of_val(values));
        self.ranks.sum(values)
    }
    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>> {
        self.count("gather", mine.len());
        self.ranks.gather(mine)
    }
    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        self.count("exchange", for_each.iter().map(Vec::len).sum());
        self.ranks.exchange(for_each)
    }
    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        self.count("broadcast", mine.len());
        self.ranks.broadcast(mine)
    }
    fn fail(&self, message: &str) {
        self.ranks.fail(message);
    }
    fn sent(&self) -> u64 {
        self.ranks.sent()
    }
}

/// The bytes that each of `size` ranks sends, a line for each.
fn sent(size: usize, work: impl Fn(&Renderer, Arc<Counted>) + Sync) -> String {
    let lines = ThreadRanks::run(size, |ranks| {
        let ranks = Arc::new(Counted { ranks, calls: Mutex::default() });
        work(&Renderer::new(devices::cpu(Some(1))), ranks.clone());
        let calls = std::mem::take(&mut *ranks.calls.lock().unwrap());
        assert_eq!(ranks.sent(), calls.iter().map(|(_, bytes)| bytes).sum::<u64>());
        let calls = calls.iter().map(|(call, bytes)| format!("{call} {bytes}"));
        calls.collect::<Vec<_>>().join(", ") + "\n"
    });
    lines.concat()
}

/// If these numbers change, so do the tables in `docs/cluster.md`.
#[test]
fn a_step_sends_as_much_as_ever() {
    let (mut config, checkpoint, dataset) = begun();
    config.poses.refine = true;
    config.optimizer.transmittance_every = 1;
    let views = sent(2, |renderer, ranks| {
        let trainer = Trainer::resume(renderer, config.clone(), dataset.clone(), &checkpoint);
        let mut trainer = trainer.expect("a trainer").with_ranks(ranks);
        trainer.step().expect("a step");
    });
    insta::assert_snapshot!(views, @"
    sum 16, max 24, exchange 11896, gather 6336, or 488, sum 18432, gather 80
    sum 16, max 24, exchange 10592, gather 6768, or 488, sum 18432, gather 80
    ");
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
