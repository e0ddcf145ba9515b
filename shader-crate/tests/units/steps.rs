use organza_shaders::steps::roulette;

#[test]
fn roulette_keeps_the_mean_of_a_ray_and_leaves_the_rest_alone() {
    let faint = 0.25;
    for value in [0.002, 0.03, 0.2, 0.249] {
        let mut sum = 0.0;
        let mut survivors = 0;
        for ray in 0..1000_u32 {
            // any spread of seeds
            let seed = ray as f32 / 1000.0;
            for k in 0..30 {
                let played = roulette(faint, seed, k as f32, value);
                assert!(played == 0.0 || played == faint, "{played}");
                sum += f64::from(played) / 30_000.0;
                survivors += u32::from(played > 0.0);
            }
        }
        assert!((sum / f64::from(value) - 1.0).abs() < 0.01, "{sum} of {value}");
        let expected = 30_000.0 * value / faint;
        assert!((survivors as f32 / expected - 1.0).abs() < 0.01, "{survivors} of {expected}");
    }
    assert_eq!(roulette(faint, 0.5, 3.0, 0.0), 0.0);
    for value in [0.25, 0.7, 1.0] {
        assert_eq!(roulette(faint, 0.5, 3.0, value), value);
    }
}

#[test]
fn survivors_spread_along_a_ray() {
    // of 30 steps with a chance of a fifth, 6 survive, give or take one, wherever the sequence begins
    for ray in 0..100 {
        let played = (0..30).map(|k| roulette(0.25_f32, ray as f32 / 100.0, k as f32, 0.05));
        let survivors = played.filter(|&full| full > 0.0).count();
        assert!((5..=7).contains(&survivors), "{survivors}");
    }
}
