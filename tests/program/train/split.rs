//! Trainings whose Gaussians are distributed over ranks: the same bits for any number of ranks.

use std::path::Path;
use std::sync::Arc;

use organza::ranks::{Ranks, ThreadRanks};
use organza::scene::GAUSSIANS_PER_BLOCK;
use organza::train::metrics::Record;
use organza::train::{Checkpoint, TrainConfig, Trainer};
use organza::{Dataset, Error, Renderer};
use organza_tests::devices;

use super::runs::{TINY, assert_same_run, begun, bits, records, sandbox, state_bits};

type Begun = (TrainConfig, Checkpoint, Arc<Dataset>);

/// One Gaussian in this many is rendered.
const VISIBLE: usize = 64;

/// A run with just two blocks of Gaussians, which grows to three after two more steps. Most Gaussians have no
/// rotation, so they are not rendered, which would take long.
fn begun_of_slices() -> Begun {
    let (mut config, mut checkpoint, dataset) = begun();
    config.run.steps = 40;
    // sums of this step's terms hardly cancel
    config.run.coarse = 0.0;
    config.exposure.learn = true.into();
    config.poses.refine = true;
    config.growth.max_gaussians = 2 * GAUSSIANS_PER_BLOCK as u32 + 200;
    let mut scene = checkpoint.scene;
    let len = scene.gaussians.len();
    let indices: Vec<_> =
        (0..2 * GAUSSIANS_PER_BLOCK - 10).map(|index| index / VISIBLE % len).collect();
    scene.gaussians = scene.gaussians.select(&indices);
    for (index, position) in scene.gaussians.position.iter_mut().enumerate() {
        position[index % 3] += 1e-3 * (index / VISIBLE / len) as f32;
    }
    for (index, rotation) in scene.gaussians.rotation.iter_mut().enumerate() {
        if index % VISIBLE > 0 {
            *rotation = [0.0; 4];
        }
    }
    checkpoint = Checkpoint::begin(scene, &config).expect("a state");
    checkpoint.progress.step = 8;
    (config, checkpoint, dataset)
}

/// Runs `work` on each of `size` ranks.
fn on_ranks<R: Send>(size: usize, work: impl Fn(Arc<dyn Ranks>) -> R + Sync) -> Vec<R> {
    ThreadRanks::run(size, |ranks| work(Arc::new(ranks)))
}

/// The trainer of a rank in a group of `shards` ranks.
fn trainer(begun: &Begun, name: &str, ranks: Arc<dyn Ranks>, shards: usize) -> Trainer {
    let (config, checkpoint, dataset) = begun;
    let device = match name {
        "cpu" | "a part a camera" | "a part a tile" => devices::cpu(Some(1)),
        _ => devices::named(name),
    };
    let renderer = Renderer::new(device);
    // a tile takes 10 kB
    let renderer = match name {
        "a part a camera" => renderer.with_part_bytes(130_000),
        "a part a tile" => renderer.with_part_bytes(15_000),
        _ => renderer,
    };
    let shard = checkpoint.shard(ranks.rank() % shards, shards);
    let config = config.clone();
    let dataset = dataset.clone();
    let trainer = Trainer::resume_shard(&renderer, config, dataset, &shard, ranks, shards);
    trainer.expect("a trainer")
}

/// Trains on several ranks in groups, and joins the shards of a group. All groups have the same. With a path, the
/// state is also written to a file.
fn train(
    begun: &Begun,
    name: &str,
    [size, shards]: [usize; 2],
    steps: u32,
    file: Option<&Path>,
) -> Checkpoint {
    let mut all = on_ranks(size, |ranks| {
        let mut trainer = trainer(begun, name, ranks.clone(), shards);
        for _ in 0..steps {
            trainer.step().expect("a step");
        }
        let shard = trainer.checkpoint(0.0).expect("a state");
        match file {
            Some(path) if ranks.rank() == 0 => {
                shard.save_shards(path, None, &trainer.group().expect("a group")).expect("a file");
            }
            Some(_) => shard.hand_over(&trainer.group().expect("a group")).expect("a file"),
            None => {}
        }
        shard
    });
    for (rank, shard) in all.split_off(shards).iter().enumerate() {
        assert!(*shard == all[rank % shards], "{size} ranks in groups of {shards}");
    }
    join(all)
}

fn join(shards: Vec<Checkpoint>) -> Checkpoint {
    let mut rest = shards.into_iter();
    let mut whole = rest.next().expect("a rank");
    for shard in rest {
        assert_eq!((whole.range.end, whole.gaussians), (shard.range.start, shard.gaussians));
        whole.range.end = shard.range.end;
        let mine = [&mut whole.scene].into_iter().chain(&mut whole.moments);
        for (mine, other) in mine.zip([&shard.scene].into_iter().chain(&shard.moments)) {
            assert!(mine.color == other.color && mine.transmittance == other.transmittance);
            mine.gaussians.append(&other.gaussians);
        }
        whole.statistics.extend(shard.statistics);
    }
    assert_eq!((whole.scene.gaussians.len(), whole.range.end), (whole.gaussians, whole.gaussians));
    whole
}

/// With four shards, one has no Gaussians. A step has at most four cameras, so one of five groups has nothing to
/// render.
#[test]
fn any_number_of_ranks_and_groups_gives_the_same_bits_on_every_device() {
    let begun = begun_of_slices();
    for (name, _) in devices::all() {
        let one = train(&begun, name, [1, 1], 3, None);
        assert_eq!(one.progress.step, 11);
        assert_eq!(
            one.scene.gaussians.len(),
            2 * GAUSSIANS_PER_BLOCK + 200,
            "{name}: the scene has grown"
        );
        assert!(one.statistics.iter().any(|[_, views, ..]| *views > 0.0), "{name}");
        // a software GPU is slow
        let grids = match name {
            "cpu" => &[[2, 2], [3, 3], [4, 4], [4, 2], [5, 1], [8, 4]][..],
            _ => &[[2, 2], [2, 1]],
        };
        for &grid in grids {
            let many = train(&begun, name, grid, 3, None);
            assert!(state_bits(&many) == state_bits(&one), "{name}: {grid:?}");
            assert!(many.exposures == one.exposures && many.poses == one.poses, "{name}: {grid:?}");
        }
    }
}

/// Each block is rendered in parts, the last ones first. If a camera's tiles are in several parts, the sums of these
/// parts belong to one unit.
#[test]
fn parts_of_slices_give_the_same_bits() {
    let mut begun = begun_of_slices();
    begun.0.run.tiles_per_step = 12;
    let one = train(&begun, "cpu", [1, 1], 1, None);
    for grid in [[1, 1], [2, 1]] {
        let parts = train(&begun, "a part a camera", grid, 1, None);
        assert!(state_bits(&parts) == state_bits(&one), "{grid:?}");
        assert!(parts.exposures == one.exposures && parts.poses == one.poses, "{grid:?}");
        let cut = train(&begun, "a part a tile", grid, 1, None);
        for (a, b) in cut.moments[0].tensors().into_iter().zip(one.moments[0].tensors()) {
            let largest = b.1.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
            let is_near = |(a, b): (&f32, &f32)| (a - b).abs() <= 1e-4 * largest;
            assert!(a.1.iter().zip(b.1).all(is_near), "{} {grid:?}", a.0.name);
        }
    }
}

/// Ranks write one file, like any run, and each rank reads its shard of it.
#[test]
fn ranks_write_one_checkpoint_and_read_their_shards() {
    let begun = begun_of_slices();
    let sandbox = sandbox();
    let path = sandbox.path("state.safetensors");
    let joined = train(&begun, "cpu", [4, 2], 1, Some(&path));
    assert!(Checkpoint::load(&path).expect("a checkpoint") == joined);
    let again = sandbox.path("again.safetensors");
    joined.save(&again, None).expect("a file");
    assert!(std::fs::read(&path).unwrap() == std::fs::read(&again).unwrap());
    for size in [1, 2, 4] {
        for rank in 0..size {
            let shard = Checkpoint::load_shard(&path, rank, size).expect("a shard");
            assert!(shard == joined.shard(rank, size), "rank {rank} of {size}");
        }
    }
    // a state that one rank has lost is not written
    let failed = on_ranks(2, |ranks| {
        let mut shard = joined.shard(ranks.rank(), 2);
        if ranks.rank() == 0 {
            return shard.save_shards(&path, None, &*ranks);
        }
        shard.moments[0].gaussians.opacity[3] = f32::NAN;
        shard.hand_over(&*ranks).inspect_err(|error| ranks.fail(&error.to_string()))
    });
    let [Err(Error::Rank { rank: 1, .. }), Err(Error::NotFinite { .. })] = &failed[..] else {
        panic!("{failed:?}")
    };
    assert!(std::fs::read(&path).unwrap() == std::fs::read(&again).unwrap());
}

/// Both sum the same terms, but round differently.
#[test]
fn ranks_train_like_one_trainer() {
    let begun = begun_of_slices();
    let (config, checkpoint, dataset) = begun.clone();
    let renderer = Renderer::new(devices::cpu(None));
    let mut alone = Trainer::resume(&renderer, config, dataset, &checkpoint).expect("a trainer");
    let expected = alone.step().expect("a step");
    let reports = on_ranks(2, |ranks| trainer(&begun, "cpu", ranks, 2).step().expect("a step"));
    for report in reports {
        assert!((report.loss - expected.loss).abs() < 1e-6 * expected.loss);
        assert!((report.psnr - expected.psnr).abs() < 1e-4 && report.tiles == expected.tiles);
    }
    let alone = alone.checkpoint(0.0).expect("a state");
    let shared = train(&begun, "cpu", [2, 2], 1, None);
    for (moment, (alone, shared)) in alone.moments.iter().zip(&shared.moments).enumerate() {
        for ((spec, alone), (_, shared)) in alone.tensors().into_iter().zip(shared.tensors()) {
            let largest = alone.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
            assert!(largest > 0.0 || spec.values() == 0, "{}", spec.name);
            // the second moments are of squares
            let most = if moment == 0 { 1e-4 } else { 2e-4 } * largest;
            for (a, b) in alone.iter().zip(shared) {
                assert!((a - b).abs() <= most, "{} {moment}: {a} {b}", spec.name);
            }
        }
    }
    let of_photographs = |state: &Checkpoint| {
        let both = [&state.exposures, &state.poses];
        both.map(|found| found.as_ref().expect("they are learned").moments[0].concat())
    };
    for (alone, shared) in of_photographs(&alone).iter().zip(of_photographs(&shared)) {
        let largest = alone.iter().fold(0.0_f32, |most, value| most.max(value.abs()));
        assert!(largest > 0.0, "no photograph has moved");
        for (a, b) in alone.iter().zip(&shared) {
            assert!((a - b).abs() <= 1e-4 * largest, "{a} {b}");
        }
    }
    for (a, b) in alone.statistics.iter().zip(&shared.statistics) {
        let near = |a: f32, b: f32| (a - b).abs() <= 1e-3 * a.abs() + 1e-9;
        assert!(a.iter().zip(b).all(|(a, b)| near(*a, *b)), "{a:?} {b:?}");
    }
}

/// All Gaussians are in one block: the other shards have none.
#[test]
fn a_run_of_shards_is_one_run() {
    let sandbox = sandbox();
    let run = |name: &str, words: &str| {
        let learned = "--set exposure.learn=on --refine-poses";
        let words = format!("{TINY} {name} --steps 24 --split gaussians {learned} {words}");
        sandbox.run(&words).assert_ok();
    };
    run("one", "--ranks 1");
    let one = bits(&sandbox, "one");
    assert!(one["gaussians.opacity"].1.len() > 200, "the scene has grown");
    let loss = |record: &Record| match record {
        Record::Step { loss, .. } => Some(*loss),
        _ => None,
    };
    let losses: Vec<_> = records(&sandbox.path("one")).iter().filter_map(loss).collect();
    let mean = |losses: &[f64]| losses.iter().sum::<f64>() / losses.len() as f64;
    assert!(mean(&losses[16..]) < 0.9 * mean(&losses[..8]), "{losses:?}");
    // stopped, and continued with another number of ranks
    run("other", "--ranks 3 --threads 1 --time-limit 1");
    sandbox.run("train --resume other --ranks 2 --split gaussians --backend cpu").assert_ok();
    run("grid", "--ranks 4 --shards 2 --threads 1 --time-limit 1");
    sandbox
        .run("train --resume grid --ranks 3 --split gaussians --shards 1 --backend cpu")
        .assert_ok();
    for resumed in ["other", "grid"] {
        assert_same_run(&sandbox, resumed, "one");
    }
    let refuses = |words: &str, facts: &[&str]| {
        sandbox.assert_refuses(&format!("{TINY} no {words}"), facts);
    };
    refuses("--split gaussians", &["--ranks"]);
    refuses("--ranks 2 --split pixels", &["views, gaussians"]);
    refuses("--ranks 2 --shards 2", &["--split"]);
    refuses("--ranks 2 --split views --shards 2", &["`--shards`", "`--split gaussians`"]);
    let facts = ["`--shards` must divide the number of ranks, 4: found 3"];
    refuses("--ranks 4 --split gaussians --shards 3", &facts);
    refuses("--ranks 2 --split gaussians --view", &["`--view`", "leave out"]);
    let distortion = "--ranks 2 --split gaussians --set loss.distortion_weight=0.1";
    refuses(distortion, &["loss.distortion_weight", "share the views"]);
}
