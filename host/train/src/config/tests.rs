//! Settings as files.

use super::*;
use organza_core::camera::Camera;
use organza_data::{Frame, Photograph, Point};

fn parse(text: &str) -> Result<TrainConfig> {
    TrainConfig::parse(text, Path::new("config.toml"))
}

#[test]
fn a_file_reads_back() {
    let mut config = TrainConfig::default();
    config.data.path = Some("photographs".into());
    config.optimizer.grids.last = 1.234_567_890_123e-5;
    config.densification.rate = 0.3;
    assert_eq!(parse(&config.to_toml()).unwrap(), config);
    assert_eq!(parse("").unwrap(), TrainConfig::default());
}

#[test]
fn mistakes_are_named() {
    for (text, expected) in [
        ("[run]\nstep = 3", "line 2: unknown field `step`"),
        ("[run]\nlog_every = 0", "`run.log_every` is 0, expected 1 or more"),
        ("[run]\nsteps = -1", "line 2:"),
        ("[loss]\nssim_weight = 1.5", "`loss.ssim_weight` is 1.5, expected 0 to 1"),
        ("[loss]\nssim_weight = nan", "`loss.ssim_weight` is NaN"),
        ("[optimizer.grids]\nfirst = 0.1\nlast = 0.0", "`optimizer.grids.last` is 0"),
        ("[data]\nalpha = 'magic'", "unknown variant `magic`"),
        ("[data]\nhold_out_every = 1", "`data.hold_out_every` is 1, which leaves nothing"),
        ("steps", "line 1:"),
        ("[run]\ntiles_per_step = 100000000", "at most 174762 of side 64"),
        ("[start]\ngaussians = 4000000000", "`start.gaussians` is 4000000000"),
        ("[start]\nopacity = 0.00009", "`start.opacity` is 0.00009, expected 0.0001 to 0.9999"),
        ("[scene.color_mlp]\nhidden = []", "`scene.color_mlp.hidden` has 0 layers"),
        ("[scene.color_mlp]\nhidden = [8, 8, 8, 8, 8]", "`scene.color_mlp.hidden` has 5 layers"),
        ("[densification]\nrate = 7.0", "`densification.rate` is 7, expected 0 to 1"),
        ("[data]\nbackground = [0.0, 2.0, 0.0]", "`data.background, green,` is 2, expected 0 to 1"),
    ] {
        let error = parse(text).unwrap_err().to_string();
        assert!(error.contains(expected) && error.contains("config.toml"), "{error}");
    }
}

/// The f32 nearest to 1e-4 is less than the f64.
#[test]
fn the_ends_of_a_range_belong_to_it() {
    for text in ["[start]\nopacity = 1e-4", "[start]\nopacity = 0.9999", "[start]\nscale = 1e-4"] {
        parse(text).unwrap();
    }
}

#[test]
fn a_run_too_large_for_memory_is_refused_with_its_needs() {
    let mut config = TrainConfig::default();
    config.check_memory().unwrap();
    config.start.gaussians = 200_000_000;
    config.densification.max_gaussians = 200_000_000;
    let text = config.check_memory().unwrap_err().to_string();
    for fact in ["the tiles of a step 17.00 MiB", "Adam's moments 84.", "but", "are available"] {
        assert!(text.contains(fact), "{text}");
    }
    config.data.path = Some("data".into());
    config.check_memory().unwrap();
}

#[test]
fn rates_fall_by_the_same_factor() {
    let mut config = OptimizerConfig::default();
    let rate = Rate { first: 1e-2, last: 1e-4 };
    config.cooldown = 0.0;
    for (fraction, expected) in [(0.0, 1e-2), (0.5, 1e-3), (1.0, 1e-4), (2.0, 1e-4)] {
        assert!((config.rate_at(rate, fraction) / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn rates_cool_down_at_the_end() {
    let mut config = OptimizerConfig::default();
    let rate = Rate { first: 1e-2, last: 1e-2 };
    config.cooldown = 0.5;
    for (fraction, expected) in [(0.0, 1e-2), (0.5, 1e-2), (0.75, 5e-3), (1.0, 2e-4), (2.0, 2e-4)] {
        assert!((config.rate_at(rate, fraction) / expected - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_new_schedule_keeps_earlier_fractions() {
    let mut run = RunConfig { steps: 80, ..RunConfig::default() };
    assert_eq!([0, 20, 80, 90].map(|step| run.fraction(step)), [0.0, 0.25, 1.0, 1.0]);
    run.reschedule(0, 100);
    run.reschedule(50, 150);
    let fractions = [0, 25, 50, 100, 150].map(|step| run.fraction(step));
    assert_eq!(fractions, [0.0, 0.25, 0.5, 0.75, 1.0]);
    // a later schedule must not change earlier fractions by a single bit
    let before: Vec<_> = (0..=60).map(|step| run.fraction(step).to_bits()).collect();
    run.reschedule(61, 90);
    assert!((0..=60).map(|step| run.fraction(step).to_bits()).eq(before));
    assert_eq!(run.fraction(90), 1.0);
}

#[test]
fn only_a_schedule_that_a_run_can_write_is_read() {
    let parse = |text: &str| TrainConfig::parse(text, Path::new("run/config.toml"));
    let schedule = "[run]\nsteps = 90\nschedule = [[0, 100], [50, 90]]";
    let config = parse(schedule).unwrap();
    assert_eq!(parse(&config.to_toml()).unwrap(), config);
    for schedule in ["[[1, 90]]", "[[0, 9], [9, 90]]", "[[0, 50], [9, 60], [9, 90]]", "[[0, 100]]"]
    {
        let text =
            parse(&format!("[run]\nsteps = 90\nschedule = {schedule}")).unwrap_err().to_string();
        assert!(text.contains("`run.schedule`"), "{text}");
    }
}

/// Two photographs of one color, and points of the first one's color in the middle of both.
fn photographs(levels: [u8; 2]) -> Dataset {
    let frame = |level: u8| {
        let axes = ([0.0, 0.0, 4.0], [0.0; 3], [0.0, 1.0, 0.0]);
        let camera = Camera::look_at(axes.0, axes.1, axes.2, 0.8, [8, 8]).unwrap();
        let image = Photograph::new([8, 8], vec![[level; 3]; 64], None).unwrap();
        Frame { name: level.to_string(), camera, image }
    };
    let mut dataset = Dataset::from_frames(levels.map(frame).to_vec(), 0);
    dataset.points = vec![Point { position: [0.0; 3], color: Some([levels[0]; 3]) }; 60];
    dataset
}

#[test]
fn a_run_is_as_long_as_its_photographs_are_many() {
    let mut run = RunConfig { steps: 0, ..RunConfig::default() };
    // 20 times the pixels, of which a step draws 16 * 64 * 64 = 65,536
    for (photographs, size, on_cpu, on_gpu) in [
        (30, 270.0 * 480.0, 8_000, 8_000),
        (97, 1008.0 * 756.0, 10_000, 22_600),
        (100, 400.0 * 400.0, 8_000, 8_000),
        (100, 800.0 * 800.0, 10_000, 19_600),
        (300, 1600.0 * 1200.0, 10_000, 100_000),
    ] {
        let pixels = f64::from(photographs) * size;
        let steps = [true, false].map(|is_cpu_like| run.steps_for(pixels, is_cpu_like));
        assert_eq!(steps, [on_cpu, on_gpu], "{photographs} photographs");
    }
    // steps of twice as many pixels
    run.tiles_per_step = 32;
    assert_eq!(run.steps_for(64e6, true), 9_800);
    run.steps = 7;
    assert_eq!(run.steps_for(64e6, true), 7);
}

#[test]
fn a_gpu_has_as_many_gaussians_as_photographs_can_fill() {
    let mut config = TrainConfig::default();
    for (photographs, size, on_gpu) in [
        (30, 270.0 * 480.0, 30_000),
        (43, 960.0 * 720.0, 60_000),
        (84, 1008.0 * 756.0, 129_000),
        (100, 800.0 * 800.0, 128_000),
        (300, 1600.0 * 1200.0, 300_000),
    ] {
        let pixels = f64::from(photographs) * size;
        let gaussians = [true, false].map(|is_cpu_like| config.gaussians_for(pixels, is_cpu_like));
        assert_eq!(gaussians, [30_000, on_gpu], "{photographs} photographs");
    }
    // so few steps draw 131 million pixels, which is 20 times 6.6 million
    config.run.steps = 2_000;
    assert_eq!(config.gaussians_for(64e6, false), 30_000);
    config.run.steps = 20_000;
    assert_eq!(config.gaussians_for(576e6, false), 132_000);
    config.start.gaussians = 50_000;
    assert_eq!(config.gaussians_for(64e6, true), 50_000);
    config.densification.max_gaussians = 7;
    assert_eq!(config.gaussians_for(64e6, false), 7);
}

#[test]
fn exposures_are_learned_where_they_differ() {
    // ln(1.2) / 2 = 0.09 and ln(1.4) / 2 = 0.17
    let [alike, different] = [120, 140].map(|level| photographs([100, level]));
    for (learn, expected) in [
        (LearnExposure::Auto, [false, true]),
        (LearnExposure::On, [true; 2]),
        (LearnExposure::Off, [false; 2]),
    ] {
        let found = [&alike, &different].map(|dataset| learn.decide(dataset));
        assert_eq!(found, expected, "{learn:?}");
    }
    // nothing is known without points
    let dataset = Dataset::from_frames(different.frames, 0);
    assert!(!LearnExposure::Auto.decide(&dataset));
}
