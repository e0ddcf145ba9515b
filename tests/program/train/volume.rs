//! What ranks hand over: counted, by formula, and the tables of `docs/cluster.md`.

use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};

use organza::Result;
use organza::ranks::{Ranks, ThreadRanks};
use organza::render::share_bytes;
use organza::scene::{MlpConfig, SLICE};
use organza::train::config::PoseMethod;
use organza::train::{CheckpointShare, ShareTrainer, TrainConfig, Trainer};
use organza::{Renderer, image};
use organza_tests::devices;

use super::runs::begun;

/// Numbers of a scene that the formulas are made of.
struct Sizes {
    /// Values of a Gaussian.
    d: u64,
    /// Values of each grid.
    grids: [u64; 2],
    /// Parameters of both networks, as devices have them: a hidden layer's outputs in multiples of 16, the last one's of 4.
    p: u64,
    /// Layers of both networks.
    layers: u64,
}

impl Sizes {
    fn of(config: &TrainConfig) -> Self {
        let scene = &config.scene;
        let (material, extra) = (u64::from(scene.material), u64::from(scene.extra));
        let grids = [&scene.color_grid, &scene.transmittance_grid];
        let features = |grid: usize| u64::from(grids[grid].levels * grids[grid].features);
        let sh = u64::from(scene.sh_degree + 1).pow(2);
        let network = |mlp: &MlpConfig, mut inputs: u64| {
            let mut parameters = 0;
            for &width in &mlp.hidden {
                parameters += (inputs + 1) * u64::from(width).next_multiple_of(16);
                inputs = u64::from(width);
            }
            parameters + (inputs + 1) * 4
        };
        let networks = [&scene.color_mlp, &scene.transmittance_mlp];
        Self {
            d: 11 + material + extra,
            grids: grids.map(|grid| grid.entries() as u64 * u64::from(grid.features)),
            p: network(networks[0], sh + features(0) + material)
                + network(networks[1], features(1) + extra),
            layers: networks.iter().map(|mlp| mlp.hidden.len() as u64 + 1).sum(),
        }
    }

    fn flags(&self) -> u64 {
        self.grids.iter().map(|values| values.div_ceil(64) + 1).sum()
    }

    /// Bytes of a Gaussian's row: its index, its values, and three statistics.
    fn row(&self) -> u64 {
        4 * (self.d + 4)
    }
}

/// Ranks that write down what they hand over.
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

/// What each of so many ranks hands over, call by call.
fn counted(
    size: u64,
    work: impl Fn(&Renderer, Arc<Counted>) + Sync,
) -> Vec<Vec<(&'static str, u64)>> {
    let work = |ranks: ThreadRanks| {
        let ranks = Arc::new(Counted { ranks, calls: Mutex::default() });
        work(&Renderer::new(devices::cpu(Some(1))), ranks.clone());
        let calls = std::mem::take(&mut *ranks.calls.lock().unwrap());
        assert_eq!(ranks.sent(), calls.iter().map(|(_, bytes)| bytes).sum::<u64>());
        calls
    };
    std::thread::scope(|scope| {
        let ranks = ThreadRanks::new(size as usize).into_iter();
        let threads: Vec<_> = ranks.map(|ranks| scope.spawn(|| work(ranks))).collect();
        threads.into_iter().map(|thread| thread.join().expect("a rank")).collect()
    })
}

/// As the test below, of a step with `--split gaussians`, and of growth after it.
#[test]
fn a_step_of_shares_hands_over_what_the_formulas_say() {
    const RANKS: u64 = 2;
    let (mut config, mut checkpoint, dataset) = begun();
    (config.run.steps, checkpoint.progress.step) = (40, 9);
    let sizes = Sizes::of(&config);
    let gaussians = checkpoint.scene.gaussians.len() as u64;
    let all = counted(RANKS, |renderer, ranks| {
        let share = CheckpointShare::of(&checkpoint, ranks.rank(), RANKS as usize);
        let (config, dataset) = (config.clone(), dataset.clone());
        let trainer = ShareTrainer::resume(renderer, config, dataset, &share, ranks);
        let report = trainer.expect("a trainer").step().expect("a step");
        assert!(report.grown.is_some());
    });
    let (tiles, side) = (u64::from(config.run.tiles_per_step), u64::from(config.run.tile_size));
    // the scene is one slice, which the second rank has
    for (calls, held) in all.iter().zip([0, gaussians]) {
        let names: Vec<_> = calls.iter().map(|(name, _)| *name).collect();
        let expected = ["sum", "or", "sum", "max", "max", "sum", "or", "sum", "gather", "exchange"];
        assert_eq!(names, expected);
        let bytes: Vec<_> = calls.iter().map(|(_, bytes)| *bytes).collect();
        let pixels = tiles * side * side;
        assert_eq!(bytes[..2], [8 * (4 * pixels + 5), 4 * pixels.div_ceil(8)]);
        assert_eq!(bytes[0] + bytes[1], share_bytes(tiles as usize, side as u32));
        assert_eq!(bytes[2..6], [16, 4 * (2 + sizes.layers), 4, 8 * sizes.p]);
        assert_eq!(bytes[6], 4 * sizes.flags());
        assert!(bytes[7] > 0 && bytes[7] <= 8 * sizes.grids.iter().sum::<u64>(), "{bytes:?}");
        assert_eq!(bytes[8], 8 * held);
        assert_eq!(bytes[9] % (12 * sizes.d), 0, "rows: {}", bytes[9]);
        let rows = bytes[9] / (12 * sizes.d);
        assert!(rows <= held && rows * 2 >= held, "{rows} of {held}");
    }
    assert_eq!(all[0][7], all[1][7], "all ranks add the same blocks");
}

/// The bytes of one step, call by call, are those of the table "What a step hands over".
#[test]
fn a_step_hands_over_what_the_formulas_say() {
    const RANKS: u64 = 2;
    let (mut config, checkpoint, dataset) = begun();
    config.poses.method = PoseMethod::Refine;
    let sizes = Sizes::of(&config);
    let gaussians = checkpoint.scene.gaussians.len() as u64;
    let all = counted(RANKS, |renderer, ranks| {
        let trainer = Trainer::resume(renderer, config.clone(), dataset.clone(), &checkpoint);
        let mut trainer = trainer.expect("a trainer").with_ranks(ranks);
        trainer.step().expect("a step");
    });
    let (mut units, mut tiles) = (0, 0);
    for calls in &all {
        let names: Vec<_> = calls.iter().map(|(name, _)| *name).collect();
        let expected =
            ["sum", "max", "gather", "exchange", "gather", "or", "sum", "gather", "gather"];
        assert_eq!(names, expected);
        let bytes: Vec<_> = calls.iter().map(|(_, bytes)| *bytes).collect();
        assert_eq!(bytes[0], 16, "samples");
        assert_eq!(bytes[1], 4 * (2 + sizes.layers), "bounds");
        assert_eq!(bytes[2] % (4 * sizes.p), 0, "networks: {} of {}", bytes[2], sizes.p);
        let own = bytes[2] / (4 * sizes.p);
        let rows = bytes[3] - 4 * RANKS * own;
        assert_eq!(rows % sizes.row(), 0, "rows of units: {rows}");
        assert!((1..=own * gaussians).contains(&(rows / sizes.row())), "rows of units: {rows}");
        assert_eq!(bytes[4] % sizes.row(), 0, "sums of rows");
        assert!((1..=gaussians.div_ceil(RANKS)).contains(&(bytes[4] / sizes.row())), "{bytes:?}");
        assert_eq!(bytes[5], 4 * sizes.flags(), "flags");
        assert!(bytes[6] > 0 && bytes[6] <= 8 * sizes.grids.iter().sum::<u64>(), "{bytes:?}");
        assert_eq!(bytes[8] % 32, 0, "losses");
        (units, tiles) = (units + own, tiles + bytes[8] / 32);
    }
    for calls in &all {
        assert_eq!(calls[7].1, 24 * units, "poses");
    }
    assert_eq!(all[0][6], all[1][6], "all ranks add the same blocks");
    assert_eq!(tiles, u64::from(config.run.tiles_per_step));
    assert!((2..=tiles).contains(&units), "{units}");
}

/// Seconds that bytes take: a ring for what is added, where each rank sends and receives all but its own part twice, and once
/// for what is gathered.
struct Network {
    ranks: f64,
    /// Bytes a second.
    speed: f64,
}

/// Seconds from one rank to another and back, for a call.
const LATENCY: f64 = 20e-6;
/// Bytes a second that a device reads or writes.
const MEMORY: f64 = 1e12;

impl Network {
    fn new(ranks: u64, gigabits: f64) -> Self {
        Self { ranks: ranks as f64, speed: gigabits * 1e9 / 8.0 }
    }

    fn gathered(&self, bytes: f64) -> f64 {
        (self.ranks - 1.0) / self.ranks * bytes / self.speed
    }

    fn added(&self, bytes: f64) -> f64 {
        2.0 * self.gathered(bytes)
    }

    fn calls(&self, calls: f64) -> f64 {
        if self.ranks > 1.0 { calls * LATENCY * self.ranks.log2() } else { 0.0 }
    }
}

/// Seconds of a step over views: what is computed, and what is sent. 64 units of one tile each see 2% of the Gaussians, at
/// most 50,000, and no Gaussian is seen twice. A unit takes 10 ms, and its projection 100 bytes a Gaussian. Adam takes 28
/// bytes a value.
fn step_over_views(gaussians: f64, ranks: u64, gigabits: f64) -> [f64; 2] {
    let (sizes, network) = (Sizes::of(&TrainConfig::default()), Network::new(ranks, gigabits));
    let units = 64.0;
    let seen = (0.02 * gaussians).min(50_000.0);
    let own = (units / ranks as f64).ceil();
    let row = sizes.row() as f64;
    let grids = 8.0 * sizes.grids.iter().sum::<u64>() as f64 + 4.0 * sizes.flags() as f64;
    let computed =
        own * (10e-3 + 100.0 * gaussians / MEMORY) + 28.0 * sizes.d as f64 * gaussians / MEMORY;
    let sent = network.added(grids)
        + network.gathered(units * 4.0 * sizes.p as f64)
        + network.gathered(own * seen * row)
        + network.gathered((units * seen).min(gaussians) * row)
        + network.calls(9.0);
    [computed, sent]
}

/// Seconds of the same step with Gaussians that are dealt to ranks. Each rank takes the part of the time that it has of the
/// Gaussians.
fn step_over_gaussians(gaussians: f64, ranks: u64, gigabits: f64) -> [f64; 2] {
    let (sizes, network) = (Sizes::of(&TrainConfig::default()), Network::new(ranks, gigabits));
    let units = 64;
    let part = of_one_rank(gaussians, ranks) / gaussians;
    let [alone, _] = step_over_views(gaussians, 1, gigabits);
    let grids = 8.0 * sizes.grids.iter().sum::<u64>() as f64 + 4.0 * sizes.flags() as f64;
    let pixels = share_bytes(units, 64) as f64;
    let sent = network.added(pixels + 8.0 * sizes.p as f64 + grids) + network.calls(8.0);
    [part * alone, sent]
}

/// The most Gaussians that a rank has, in whole slices.
fn of_one_rank(gaussians: f64, ranks: u64) -> f64 {
    let slices = (gaussians / SLICE as f64).ceil();
    ((slices / ranks as f64).ceil() * SLICE as f64).min(gaussians)
}

/// Seconds of an image of 1920 x 1080 pixels whose Gaussians are dealt to ranks. A Gaussian takes 10 ns, which counts all of
/// a rank's slices.
fn image_of_shares(gaussians: f64, ranks: u64, gigabits: f64) -> [f64; 2] {
    let network = Network::new(ranks, gigabits);
    let batches: Vec<_> = image::bands(0, [1920, 1080], 64).map(|batch| batch.unwrap()).collect();
    let bytes = |tiles: usize| network.added(share_bytes(tiles, 64) as f64) + network.calls(2.0);
    let sent = batches.iter().map(|batch| bytes(batch.tiles.len())).sum();
    [of_one_rank(gaussians, ranks) * 10e-9, sent]
}

fn milliseconds([computed, sent]: [f64; 2]) -> String {
    let number = |seconds: f64| match 1e3 * seconds {
        0.0 => "0".to_owned(),
        ms if ms < 9.95 => format!("{ms:.1}"),
        ms => format!("{ms:.0}"),
    };
    format!("{} + {}", number(computed), number(sent))
}

/// The tables of times are those of the formulas.
#[test]
fn the_page_has_the_times_of_the_model() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/cluster.md");
    let page = fs::read_to_string(page).expect("the page");
    let mut missing = Vec::new();
    for model in [step_over_views, step_over_gaussians, image_of_shares] {
        for (gaussians, name) in [(20e3, "20 k"), (1e6, "1 M"), (100e6, "100 M")] {
            for ranks in [1, 8, 64] {
                let times = [10.0, 100.0, 400.0].map(|speed| model(gaussians, ranks, speed));
                let times = times.map(milliseconds).join(" | ");
                let row = format!("| {name} | {ranks} | {times} |");
                if !page.contains(&row) {
                    missing.push(row);
                }
            }
        }
    }
    assert!(missing.is_empty(), "docs/cluster.md lacks\n{}", missing.join("\n"));
    let sizes = Sizes::of(&TrainConfig::default());
    let facts = [
        format!("V = {} for each grid", sizes.grids[0]),
        format!("P = {}", sizes.p),
        format!("d = {}", sizes.d),
    ];
    for fact in facts {
        assert!(page.contains(&fact), "docs/cluster.md lacks `{fact}`");
    }
}
