use super::*;

fn taken(count: usize, size: [u32; 2], index: usize) -> Image {
    photograph(&cameras(count, size).unwrap()[index], index).unwrap()
}

/// Variance of the differences of neighbors in a row: sharp images have large ones.
fn sharpness(image: &Image) -> f64 {
    let pairs = image.pixels().windows(2);
    let count = pairs.len() as f64;
    pairs.map(|pair| (f64::from(pair[0][1]) - f64::from(pair[1][1])).powi(2)).sum::<f64>() / count
}

#[test]
fn shaken_photographs_are_blurred() {
    let of = |shaken: bool| {
        let chosen = (0..36).filter(|&index| is_shaken(index) == shaken).take(4);
        chosen.map(|index| sharpness(&taken(36, [160, 120], index))).sum::<f64>() / 4.0
    };
    let [steady, shaken] = [of(false), of(true)];
    assert!(shaken < 0.8 * steady, "{shaken} {steady}");
}

#[test]
fn a_photograph_is_taken_again_to_the_bit() {
    let of = |index| taken(5, [64, 48], index);
    assert_eq!(of(2), of(2));
    assert_ne!(of(2), of(3));
}

#[test]
fn noise_has_its_variance() {
    let mut random = random(1, 2, 3);
    let count = 100_000;
    for light in [0.0, 0.5] {
        let off: Vec<_> = (0..count).map(|_| noisy(light, &mut random) - light).collect();
        let mean = off.iter().sum::<f64>() / f64::from(count);
        let variance = off.iter().map(|off| off * off).sum::<f64>() / f64::from(count);
        let expected = NOISE[0] + NOISE[1] * light;
        assert!(mean.abs() < 5.0 * (expected / f64::from(count)).sqrt(), "{mean}");
        assert!((variance / expected - 1.0).abs() < 0.03, "{variance} {expected}");
    }
}

/// Where a ray enters the ball: the smaller root.
fn enters_ball(half: DVec3, origin: DVec3, direction: DVec3) -> Option<f64> {
    let b = origin.dot(direction);
    let root = (b * b - origin.length_squared() + half.x * half.x).sqrt();
    root.is_finite().then_some(-b - root)
}

/// Where a ray enters the block: the last of the slabs' near planes.
fn enters_block(half: DVec3, origin: DVec3, direction: DVec3) -> Option<f64> {
    let [low, high] = [-half, half].map(|side| (side - origin) / direction);
    let enters = low.min(high).max_element();
    (enters <= low.max(high).min_element()).then_some(enters)
}

#[test]
fn a_march_ends_where_a_ray_meets_a_solid() {
    type Enters = fn(DVec3, DVec3, DVec3) -> Option<f64>;
    let mut random = random(5, 0, 0);
    let mut any = || 2.0 * random.random::<f64>() - 1.0;
    let mut met = 0;
    let ball: (usize, DVec3, Enters) = (2, DVec3::splat(0.45), enters_ball);
    for (row, half, enters) in [ball, (0, DVec3::new(0.3, 0.5, 0.2), enters_block)] {
        let solid = solids().swap_remove(row);
        let solids = [Solid { pose: DAffine3::IDENTITY, half, ..solid }];
        for _ in 0..300 {
            let origin = 2.0 * DVec3::new(any(), any(), any()).normalize();
            let direction = (0.6 * DVec3::new(any(), any(), any()) - origin).normalize();
            match (march(&solids, origin, direction), enters(half, origin, direction)) {
                (Some((far, _)), Some(expected)) => {
                    met += 1;
                    // a ray that grazes a surface is near before it meets it
                    assert!((0.0..0.05).contains(&(expected - far)), "{far} {expected}");
                }
                (None, Some(expected)) => panic!("solid {row} is missed at {expected}"),
                // it passes within `NEAR`
                (Some((far, solid)), None) => {
                    assert!(solid.distance(origin + far * direction) < NEAR);
                }
                (None, None) => {}
            }
        }
    }
    assert!(met > 200, "{met}");
}
