//! The bytes that ranks send: counted, and compared with the formulas of `docs/cluster.md`.

use std::sync::{Arc, Mutex};

use organza::Renderer;
use organza::Result;
use organza::ranks::{Ranks, ThreadRanks};
use organza::render::share_bytes;
use organza::scene::MlpConfig;
use organza::train::{CheckpointShare, TrainConfig, Trainer};
use organza_tests::devices;

use super::runs::begun;

/// Sizes of a scene in the formulas.
struct Sizes {
    /// Number of values of a Gaussian.
    pub d: u64,
    /// Number of values of each grid.
    pub grids: [u64; 2],
    /// Parameters of each network, as devices have them: a hidden layer's outputs in multiples of 16, the last one's of 4.
    pub networks: [u64; 2],
    /// Layers of both networks.
    pub layers: u64,
}

impl Sizes {
    pub fn of(config: &TrainConfig) -> Self {
        let scene = &config.scene;
        let material = u64::from(scene.material);
        let extra = u64::from(scene.extra);
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
            networks: [
                network(networks[0], sh + features(0) + material),
                network(networks[1], features(1) + extra),
            ],
            layers: networks.iter().map(|mlp| mlp.hidden.len() as u64 + 1).sum(),
        }
    }

    /// Flags of blocks, and a status of each grid; with the poses of so many photographs.
    pub fn flags(&self, photographs: u64) -> u64 {
        let grids: u64 = self.grids.iter().map(|values| values.div_ceil(64) + 1).sum();
        let binned = self.networks.into_iter().chain([6 * photographs]);
        grids + binned.map(|values| (17 * values).div_ceil(64)).sum::<u64>()
    }

    /// The most bytes of sums.
    pub fn sums(&self) -> u64 {
        8 * (self.grids.iter().sum::<u64>() + 17 * self.networks.iter().sum::<u64>())
    }

    /// Bytes in a Gaussian's row: its index, its values, and three statistics.
    pub fn row(&self) -> u64 {
        4 * (self.d + 4)
    }
}

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

/// The bytes that each of `size` ranks sends, call by call.
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

/// Like the test below, but for a step with `--split gaussians`, followed by growth.
#[test]
fn a_step_of_shares_hands_over_what_the_formulas_say() {
    const RANKS: u64 = 2;
    let (mut config, mut checkpoint, dataset) = begun();
    config.run.steps = 40;
    checkpoint.progress.step = 9;
    let sizes = Sizes::of(&config);
    let gaussians = checkpoint.scene.gaussians.len() as u64;
    let all = counted(RANKS, |renderer, ranks| {
        let share = CheckpointShare::of(&checkpoint, ranks.rank(), RANKS as usize);
        let config = config.clone();
        let dataset = dataset.clone();
        let shares = RANKS as usize;
        let trainer = Trainer::resume_share(renderer, config, dataset, &share, ranks, shares);
        let report = trainer.expect("a trainer").step().expect("a step");
        assert!(report.grown.is_some());
    });
    let tiles = u64::from(config.run.tiles_per_step);
    let side = u64::from(config.run.tile_size);
    // the scene is a single slice, which the second rank has
    for (calls, held) in all.iter().zip([0, gaussians]) {
        let names: Vec<_> = calls.iter().map(|(name, _)| *name).collect();
        let expected = ["sum", "or", "sum", "max", "or", "sum", "gather", "exchange"];
        assert_eq!(names, expected);
        let bytes: Vec<_> = calls.iter().map(|(_, bytes)| *bytes).collect();
        let pixels = tiles * side * side;
        assert_eq!(bytes[..2], [8 * (4 * pixels + 5), 4 * pixels.div_ceil(8)]);
        assert_eq!(bytes[0] + bytes[1], share_bytes(tiles as usize, side as u32));
        assert_eq!(bytes[2..5], [16, 4 * (2 + sizes.layers), 4 * sizes.flags(0)]);
        assert!(bytes[5] > 0 && bytes[5] <= sizes.sums(), "{bytes:?}");
        assert_eq!(bytes[6], 8 * held);
        assert_eq!(bytes[7] % (12 * sizes.d), 0, "rows: {}", bytes[7]);
        let rows = bytes[7] / (12 * sizes.d);
        assert!(rows <= held && rows * 2 >= held, "{rows} of {held}");
    }
    assert_eq!(all[0][5], all[1][5], "all ranks add the same blocks");
}

/// Like the test above, but in two groups of two ranks.
#[test]
fn a_step_of_groups_hands_over_what_the_formulas_say() {
    const SHARES: u64 = 2;
    const GROUPS: u64 = 2;
    let (mut config, mut checkpoint, dataset) = begun();
    config.run.steps = 40;
    checkpoint.progress.step = 9;
    let sizes = Sizes::of(&config);
    let gaussians = checkpoint.scene.gaussians.len() as u64;
    let all = counted(SHARES * GROUPS, |renderer, ranks| {
        let share = ranks.rank() % SHARES as usize;
        let share = CheckpointShare::of(&checkpoint, share, SHARES as usize);
        let config = config.clone();
        let dataset = dataset.clone();
        let shares = SHARES as usize;
        let trainer = Trainer::resume_share(renderer, config, dataset, &share, ranks, shares);
        let report = trainer.expect("a trainer").step().expect("a step");
        assert!(report.grown.is_some());
    });
    let side = u64::from(config.run.tile_size);
    // values that the ranks of a group exchange for the sums that each of them owns
    let told = |share: u64, values: u64| values * (share + 1) / SHARES - values * share / SHARES;
    let mut tiles = 0;
    for (rank, calls) in (0..).zip(&all) {
        let names: Vec<_> = calls.iter().map(|(name, _)| *name).collect();
        let pixels = ["exchange"; 4];
        let added = ["sum", "max", "exchange", "exchange", "or", "sum", "gather"];
        assert_eq!(names, [&pixels[..], &added, &["exchange"; 2]].concat());
        let bytes: Vec<_> = calls.iter().map(|(_, bytes)| *bytes).collect();
        let (share, first) = (rank % SHARES, rank / SHARES * SHARES);
        let of_group = all[first as usize][10].1 / 40;
        tiles += of_group;
        assert_eq!(bytes[10], if share == 0 { 40 * of_group } else { 0 }, "losses");
        let (values, words) = (4 * of_group * side * side + 5, of_group * side * side / 8);
        assert_eq!(bytes[..2], [8 * values, 8 * SHARES * told(share, values)]);
        assert_eq!(bytes[2..4], [4 * words, 4 * SHARES * told(share, words)]);
        assert_eq!(bytes[4..6], [16, 4 * (2 + sizes.layers)]);
        assert_eq!(bytes[8], 4 * sizes.flags(0));
        assert!(bytes[9] > 0 && bytes[9] <= sizes.sums(), "{bytes:?}");
        // the scene is one slice, which the second share has: a number for each owner and camera, less than a row, and rows
        let held = [0, gaussians][share as usize];
        let units = bytes[6] % sizes.row() / (4 * GROUPS);
        assert_eq!((bytes[6] - 4 * GROUPS * units) % sizes.row(), 0, "rows of units");
        assert!(units <= of_group && (units > 0) == (held > 0), "{units} of {of_group}");
        assert_eq!(bytes[7] % (GROUPS * sizes.row()), 0, "sums of rows");
        let sums = bytes[7] / (GROUPS * sizes.row());
        assert!(sums <= held.div_ceil(GROUPS) && (sums > 0) == (held > 0), "{sums} of {held}");
        assert_eq!(bytes[11], SHARES * 8 * held);
        assert_eq!(bytes[12] % (12 * sizes.d), 0, "rows that move");
    }
    assert_eq!(tiles, SHARES * u64::from(config.run.tiles_per_step));
}

/// The bytes of a step, call by call, must match the table "What a step hands over".
#[test]
fn a_step_hands_over_what_the_formulas_say() {
    const RANKS: u64 = 2;
    let (mut config, checkpoint, dataset) = begun();
    config.poses.refine = true;
    let sizes = Sizes::of(&config);
    let gaussians = checkpoint.scene.gaussians.len() as u64;
    let all = counted(RANKS, |renderer, ranks| {
        let trainer = Trainer::resume(renderer, config.clone(), dataset.clone(), &checkpoint);
        let mut trainer = trainer.expect("a trainer").with_ranks(ranks);
        trainer.step().expect("a step");
    });
    let photographs = dataset.train_frames().count() as u64;
    let (mut units, mut tiles) = (0, 0);
    for calls in &all {
        let names: Vec<_> = calls.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, ["sum", "max", "exchange", "gather", "or", "sum", "gather"]);
        let bytes: Vec<_> = calls.iter().map(|(_, bytes)| *bytes).collect();
        assert_eq!(bytes[0], 16, "samples");
        assert_eq!(bytes[1], 4 * (2 + sizes.layers), "bounds");
        // a number for each owner and unit, less than a row, and rows
        let own = bytes[2] % sizes.row() / (4 * RANKS);
        let rows = bytes[2] - 4 * RANKS * own;
        assert_eq!(rows % sizes.row(), 0, "rows of units: {rows}");
        assert!((1..=own * gaussians).contains(&(rows / sizes.row())), "rows of units: {rows}");
        assert_eq!(bytes[3] % sizes.row(), 0, "sums of rows");
        assert!((1..=gaussians.div_ceil(RANKS)).contains(&(bytes[3] / sizes.row())), "{bytes:?}");
        assert_eq!(bytes[4], 4 * sizes.flags(photographs), "flags");
        let poses = 8 * 17 * 6 * photographs;
        assert!(bytes[5] > 0 && bytes[5] <= sizes.sums() + poses, "{bytes:?}");
        assert_eq!(bytes[6] % 40, 0, "losses");
        (units, tiles) = (units + own, tiles + bytes[6] / 40);
    }
    assert_eq!(all[0][5], all[1][5], "all ranks add the same blocks");
    assert_eq!(tiles, u64::from(config.run.tiles_per_step));
    assert!((2..=tiles).contains(&units), "{units}");
}

/// The page must have the sizes for the default settings.
#[test]
fn the_page_has_the_sizes() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/cluster.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let Sizes { d, grids, networks, .. } = Sizes::of(&TrainConfig::default());
    let p: u64 = networks.iter().sum();
    for fact in [format!("V = {} for each grid", grids[0]), format!("P = {p}"), format!("d = {d}")]
    {
        assert!(page.contains(&fact), "docs/cluster.md lacks `{fact}`");
    }
}
