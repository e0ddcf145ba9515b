//! Settings as files.

use super::*;

fn parse(text: &str) -> Result<TrainConfig> {
    TrainConfig::parse(text, Path::new("config.toml"))
}

#[test]
fn a_file_reads_back() {
    let mut config = TrainConfig::default();
    config.data.path = Some("photographs".into());
    config.optimizer.grids.last = 1.234_567_890_123e-5;
    config.growth.method = GrowthMethod::Relocate;
    assert_eq!(parse(&config.to_toml()).unwrap(), config);
    assert_eq!(parse("").unwrap(), TrainConfig::default());
}

#[test]
fn mistakes_are_named() {
    for (text, expected) in [
        ("[run]\nstep = 3", "line 2: unknown field `step`"),
        ("[run]\nsteps = 0", "`run.steps` is 0, expected 1 or more"),
        ("[run]\nsteps = -1", "line 2:"),
        ("[loss]\nssim_weight = 1.5", "`loss.ssim_weight` is 1.5, expected 0 to 1"),
        ("[loss]\nssim_weight = nan", "`loss.ssim_weight` is NaN"),
        ("[optimizer.grids]\nfirst = 0.1\nlast = 0.0", "`optimizer.grids.last` is 0"),
        ("[growth]\nmethod = 'magic'", "unknown variant `magic`"),
        ("[growth]\nmax_gaussians = 9", "`start.gaussians` is 4000, more than the 9 of"),
        ("[data]\nhold_out_every = 1", "`data.hold_out_every` is 1, which leaves nothing"),
        ("steps", "line 1:"),
    ] {
        let error = parse(text).unwrap_err().to_string();
        assert!(error.contains(expected) && error.contains("config.toml"), "{error}");
    }
}

#[test]
fn rates_fall_by_the_same_factor() {
    let rate = Rate { first: 1e-2, last: 1e-4 };
    for (step, expected) in [(0, 1e-2), (50, 1e-3), (100, 1e-4), (200, 1e-4)] {
        assert!((rate.at(step, 100) / expected - 1.0).abs() < 1e-12);
    }
}
