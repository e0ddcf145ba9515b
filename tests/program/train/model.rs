//! The tables of times of `docs/cluster.md`: a model.

use std::fs;
use std::path::Path;

use organza::image;
use organza::render::share_bytes;
use organza::scene::SLICE;
use organza::train::TrainConfig;

use super::volume::Sizes;

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

/// Units of a step, of one tile each.
const UNITS: u64 = 64;

/// The Gaussians that a unit sees. No Gaussian is seen twice.
fn seen(gaussians: f64) -> f64 {
    (0.02 * gaussians).min(50_000.0)
}

/// Seconds of so many units, and of Adam: a unit takes 10 ms, and its projection 100 bytes a Gaussian. Adam takes 28 bytes a
/// value.
fn computed(sizes: &Sizes, gaussians: f64, units: f64) -> f64 {
    units * (10e-3 + 100.0 * gaussians / MEMORY) + 28.0 * sizes.d as f64 * gaussians / MEMORY
}

/// Bytes of all sums of hash grids, and of what says which of them there are.
fn grids(sizes: &Sizes) -> f64 {
    8.0 * sizes.grids.iter().sum::<u64>() as f64 + 4.0 * sizes.flags() as f64
}

/// Seconds of a step over views: what is computed, and what is sent.
fn step_over_views(gaussians: f64, ranks: u64, gigabits: f64) -> [f64; 2] {
    let (sizes, network) = (Sizes::of(&TrainConfig::default()), Network::new(ranks, gigabits));
    let units = UNITS as f64;
    let seen = seen(gaussians);
    let own = (units / ranks as f64).ceil();
    let row = sizes.row() as f64;
    let computed = computed(&sizes, gaussians, own);
    let sent = network.added(grids(&sizes))
        + network.gathered(units * 4.0 * sizes.p as f64)
        + network.gathered(own * seen * row)
        + network.gathered((units * seen).min(gaussians) * row)
        + network.calls(9.0);
    [computed, sent]
}

/// Seconds of the same step with Gaussians that are dealt to ranks.
fn step_over_gaussians(gaussians: f64, ranks: u64, gigabits: f64) -> [f64; 2] {
    step_of_groups(gaussians, [1, ranks], gigabits)
}

/// As above, of 64 ranks in groups of so many.
fn step_over_both(gaussians: f64, shares: u64, gigabits: f64) -> [f64; 2] {
    step_of_groups(gaussians, [64 / shares, shares], gigabits)
}

/// Each rank takes the part of the time that it has of the Gaussians. A call within groups is one of all ranks.
fn step_of_groups(gaussians: f64, [groups, shares]: [u64; 2], gigabits: f64) -> [f64; 2] {
    let sizes = Sizes::of(&TrainConfig::default());
    let [group, same_share, all] =
        [shares, groups, groups * shares].map(|ranks| Network::new(ranks, gigabits));
    let (part, own) = (of_one_rank(gaussians, shares) / gaussians, UNITS.div_ceil(groups));
    let (seen, row) = (part * seen(gaussians), sizes.row() as f64);
    let sent = group.added(share_bytes(own as usize, 64) as f64)
        + same_share.gathered(own as f64 * seen * row)
        + same_share.gathered((UNITS as f64 * seen).min(part * gaussians) * row)
        + all.added(8.0 * sizes.p as f64 + grids(&sizes))
        + all.calls(if groups > 1 { 13.0 } else { 8.0 });
    [part * computed(&sizes, gaussians, own as f64), sent]
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
    for model in [step_over_views, step_over_gaussians, step_over_both, image_of_shares] {
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
