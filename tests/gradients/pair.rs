//! What the pairs of a Gaussian share: `L = sum over pairs of g sin(vector of its Gaussian)`.

use organza::parity::inputs::Random;
use organza_shaders::pair::{PairSumKernel, PairSumParams};

use super::numeric::{central, everywhere, hold};

#[test]
fn vectors_of_gaussians() {
    const GAUSSIANS: usize = 71;
    const WORDS: usize = 3;
    const CAMERAS: usize = 4;
    const WIDTH: usize = 3;
    let mut random = Random::new(3);
    let mut mask: Vec<_> = (0..CAMERAS * WORDS).map(|_| random.bits()).collect();
    // all bits, and none; none behind the last Gaussian
    (mask[0], mask[4]) = (u32::MAX, 0);
    mask.iter_mut().skip(2).step_by(3).for_each(|bits| *bits &= (1 << 7) - 1);
    let has = |camera: usize, gaussian: usize| {
        mask[camera * WORDS + gaussian / 32] >> (gaussian % 32) & 1 == 1
    };
    let slots = (0..CAMERAS * GAUSSIANS).filter(|slot| has(slot / GAUSSIANS, slot % GAUSSIANS));
    let pairs: Vec<_> = slots.map(|slot| slot % GAUSSIANS).collect();
    let mut count = 0;
    let mut first_pair = vec![0];
    first_pair.extend(mask.iter().map(|bits| {
        count += bits.count_ones();
        count
    }));
    assert_eq!(count as usize, pairs.len());

    let values: Vec<f64> =
        random.values(GAUSSIANS * WIDTH, -1.0, 1.0).into_iter().map(f64::from).collect();
    let weight: Vec<f64> =
        random.values(pairs.len() * WIDTH, -1.0, 1.0).into_iter().map(f64::from).collect();
    let terms = || {
        pairs.iter().enumerate().flat_map(|(pair, gaussian)| {
            (0..WIDTH).map(move |v| (pair * WIDTH + v, gaussian * WIDTH + v))
        })
    };
    let loss = |x: &[f64]| terms().map(|(term, at)| weight[term] * x[at].sin()).sum();
    let expected = central(&values, 1e-5, loss);
    let of_pairs: Vec<_> =
        terms().map(|(term, at)| (weight[term] * values[at].cos()) as f32).collect();
    for (name, device) in everywhere() {
        let found = device.upload("vectors", &vec![1.0_f32; GAUSSIANS * WIDTH]).unwrap();
        let kernel = PairSumKernel {
            params: PairSumParams {
                words: WORDS as u32,
                cameras: CAMERAS as u32,
                gaussians: GAUSSIANS as u32,
                width: WIDTH as u32,
            },
            mask: &device.upload("masks", &mask).unwrap(),
            first_pair: &device.upload("first pairs", &first_pair).unwrap(),
            pair_vector: &device.upload("pairs' vectors", &of_pairs).unwrap(),
            vector: &found,
        };
        device.run(&kernel, (GAUSSIANS * WIDTH) as u32, 1).unwrap();
        // added to what was there
        let found: Vec<_> = device.read(&found).unwrap().iter().map(|x| x - 1.0).collect();
        hold(name, &found, &expected);
    }
}
