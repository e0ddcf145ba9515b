use organza_shaders::steps::{fraction_of, mix};
use organza_shaders::transmittance_backward::{survives, survivor};

/// As many hashes as the tests take rays.
fn hashes() -> impl Iterator<Item = u32> {
    (0..30_000).map(mix)
}

#[test]
fn roulette_keeps_the_mean_of_gradients_and_leaves_large_ones_alone() {
    let faint = 0.25;
    for gradient in [0.005, -0.02, 0.1, -0.249, 0.25, -7.0] {
        let played = |hash| match survives(faint, gradient, hash) {
            true => f64::from(survivor(faint, gradient)),
            false => 0.0,
        };
        let mean = hashes().map(played).sum::<f64>() / 30_000.0;
        // a tenth more than three standard deviations of the mean
        let chance = f64::from(gradient.abs() / faint).min(1.0);
        let away = 3.3 * (chance * (1.0 - chance) / 30_000.0).sqrt() * f64::from(faint);
        assert!((mean - f64::from(gradient)).abs() <= away, "{mean} of {gradient}");
    }
    assert!(hashes().all(|hash| !survives(faint, 0.0, hash)));
    assert!(hashes().all(|hash| survives(0.0, -1e-20, hash)));
}

/// Which of a ray's steps survive says nothing of its gradient.
#[test]
fn gradients_and_steps_have_chances_of_their_own() {
    let late: Vec<_> = hashes().filter(|&hash| fraction_of(hash) >= 0.5).collect();
    let survivors = late.iter().filter(|&&hash| survives(0.25, 0.1, hash)).count();
    let share = survivors as f64 / late.len() as f64;
    assert!((share - 0.4).abs() < 0.015, "{share}");
}
