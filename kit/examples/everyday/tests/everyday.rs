//! Each subject on every device, beside ordinary Rust: with no values, one, sizes that no workgroup fits, and many.

use std::collections::HashMap;

use glam::Vec2;
use muslin_check::{assert_parity, devices, inputs::Random};
use muslin_device::{Device, DeviceOptions, Modules};
use muslin_everyday::*;
use muslin_everyday_kernels::blur::GridParams;
use muslin_everyday_kernels::matrix::ProductParams;
use muslin_everyday_kernels::matrix_tiles::TilesParams;
use muslin_everyday_kernels::transpose::TransposeParams;

#[test]
fn every_kernel_is_right_on_every_device() {
    assert_parity(&cases(), &MODULES);
}

/// The plain, the checked and the thorough CPU, and the GPU both ways. None runs an additional workgroup, which would take a ticket of
/// [`prefix_sum::look_back`].
fn all() -> Vec<(&'static str, Device)> {
    let more = [("checked", DeviceOptions::checked()), ("thorough", DeviceOptions::thorough(7))];
    let more = more.map(|(name, options)| {
        let options = options.extra_workgroup(false);
        (name, Device::open(&options, Modules::none()).expect("the CPU"))
    });
    devices::all(&MODULES).into_iter().chain(more).collect()
}

/// Numbers of values.
const COUNTS: [usize; 8] = [0, 1, 63, 64, 256, 257, 1000, 70_001];

#[test]
fn sums() {
    for (name, device) in all() {
        for count in COUNTS {
            let values = Random::new(1).values(count, 0.0, 1.0);
            let exact: f64 = values.iter().copied().map(f64::from).sum();
            let found = sum::sum(&device, &device.upload("values", &values).unwrap()).unwrap();
            assert!((f64::from(found) - exact).abs() <= 1e-6 * exact, "{name}, {count}: {found}");
        }
    }
}

#[test]
fn prefix_sums() {
    for (name, device) in all() {
        for count in COUNTS {
            let mut random = Random::new(2);
            let values: Vec<_> = (0..count).map(|_| random.below(1000)).collect();
            let exact: Vec<u32> = running(&values);
            let values = device.upload("values", &values).unwrap();
            for of in [prefix_sum::in_passes, prefix_sum::look_back] {
                let found = device.read(&of(&device, &values).unwrap()).unwrap();
                assert!(found == exact, "{name}, {count}");
            }
        }
    }
}

/// The sum of all values before each one.
fn running(values: &[u32]) -> Vec<u32> {
    let sum = |sum: &mut u32, value: &u32| {
        let before = *sum;
        *sum += value;
        Some(before)
    };
    values.iter().scan(0, sum).collect()
}

#[test]
fn sorts() {
    for (name, device) in all() {
        for count in COUNTS {
            let mut random = Random::new(3);
            let keys: Vec<_> = (0..count).map(|_| random.bits() % 5000).collect();
            let values: Vec<_> = (0..count as u32).collect();
            let mut exact: Vec<_> = keys.iter().copied().zip(values.iter().copied()).collect();
            exact.sort_by_key(|(key, _)| *key);
            let [keys, values] = [keys, values].map(|all| device.upload("pairs", &all).unwrap());
            let (keys, values) = radix_sort::radix_sort(&device, &keys, &values).unwrap();
            let values = device.read(&values).unwrap();
            let found = device.read(&keys).unwrap().into_iter().zip(values);
            assert!(found.eq(exact), "{name}, {count}");
        }
    }
}

#[test]
fn histograms() {
    for (name, device) in all() {
        for count in COUNTS {
            let mut random = Random::new(4);
            let values: Vec<u8> = (0..count).map(|_| random.bits() as u8 & 0x3f).collect();
            let mut exact = vec![0; 256];
            values.iter().for_each(|value| exact[usize::from(*value)] += 1);
            let found = histogram::histogram(&device, &device.upload("values", &values).unwrap());
            assert_eq!(found.unwrap(), exact, "{name}, {count}");
        }
    }
}

#[test]
fn products() {
    let variants = devices::variants(&MODULES).into_iter().map(|(name, [_, best])| (name, best));
    for (name, device) in all().into_iter().chain(variants) {
        for side in [1_u32, 17, 130, 144] {
            let mut random = Random::new(5);
            let len = (side * side) as usize;
            // small whole numbers: their products and sums are exact
            let mut matrix = || (0..len).map(|_| random.below(9) as f32 - 4.0).collect::<Vec<_>>();
            let left = matrix();
            let right = matrix();
            let at = |row: usize, column: usize| -> f32 {
                let side = side as usize;
                (0..side).map(|k| left[row * side + k] * right[k * side + column]).sum()
            };
            let exact: Vec<_> =
                (0..len).map(|index| at(index / side as usize, index % side as usize)).collect();
            let words = [&left, &right].map(|all| matrix_tiles::words(all));
            let [left, right] = [&left, &right].map(|all| device.upload("matrix", all).unwrap());
            let params = ProductParams { rows: side, inner: side, columns: side };
            let found = matrix::product(&device, params, &left, &right).unwrap();
            assert!(device.read(&found).unwrap() == exact, "{name}, {side}");
            if side.is_multiple_of(matrix_tiles::SIDE) {
                let [left, right] = words.map(|all| device.upload("matrix", &all).unwrap());
                let params = TilesParams { rows: side, inner: side, columns: side };
                let found = matrix_tiles::product(&device, params, &left, &right).unwrap();
                assert!(device.read(&found).unwrap() == exact, "{name}, {side}, in tiles");
            }
        }
    }
}

/// With cooperative matrices, the GPU runs them where it offers the shape, and never through naga. Mesa's software GPU has some since 26.
#[test]
fn tiles_are_cooperative_matrices_where_a_device_has_them() {
    for (name, devices) in devices::variants(&MODULES) {
        let [plain, variants] = &devices;
        println!("{name}: {:?}", variants.tiles());
        assert!(plain.tiles().is_empty());
        assert!(variants.tiles().is_empty() || name == "gpu passthrough");
        for kernel in muslin_device::kernels_of("muslin-everyday-kernels") {
            let Some(shape) = kernel.variant.and_then(|variant| variant.tiles) else { continue };
            let has_it = variants.tiles().contains(&shape);
            assert_eq!(plain.entry_point(kernel).name, kernel.name);
            assert_eq!(variants.entry_point(kernel).name != kernel.name, has_it, "{name}");
        }
    }
}

#[test]
fn blurs_and_heat() {
    for (name, device) in all() {
        for [width, height] in [[1, 1], [16, 16], [37, 19]] {
            let params = GridParams { width, height, rate: 0.25 };
            // a picture of one color keeps it
            let input = device.upload("input", &vec![0.5; (width * height) as usize]).unwrap();
            let blurred = device.read(&blur::blur(&device, params, &input).unwrap()).unwrap();
            assert!(blurred.iter().all(|value| (value - 0.5).abs() < 1e-6), "{name}");
            // a slope is a steady state
            let slope: Vec<_> = (0..width * height).map(|at| (at % width) as f32).collect();
            let input = device.upload("input", &slope).unwrap();
            let found = device.read(&blur::heat(&device, params, &input, 5).unwrap()).unwrap();
            assert!(found == slope, "{name}");
        }
    }
}

#[test]
fn transposes() {
    for (name, device) in all() {
        for [rows, columns] in [[1, 1], [16, 16], [1, 257], [50, 33]] {
            let input: Vec<_> = (0..rows * columns).collect();
            let exact = (0..rows * columns).map(|at| at % rows * columns + at / rows);
            let input = device.upload("input", &input).unwrap();
            let params = TransposeParams { rows, columns };
            let found = transpose::transpose(&device, params, &input).unwrap();
            assert!(device.read(&found).unwrap().into_iter().eq(exact), "{name}, {rows}");
        }
    }
}

#[test]
fn compactions() {
    for (name, device) in all() {
        for count in COUNTS {
            let values = Random::new(6).values(count, -1.0, 1.0);
            let exact: Vec<_> = values.iter().copied().filter(|value| *value >= 0.5).collect();
            let values = device.upload("values", &values).unwrap();
            assert!(compact::compact(&device, &values, 0.5).unwrap() == exact, "{name}, {count}");
        }
    }
}

#[test]
fn hash_tables() {
    for (name, device) in all() {
        for count in COUNTS {
            let mut random = Random::new(7);
            let keys: Vec<_> = (0..count).map(|_| 1 + random.below(500)).collect();
            let mut exact = HashMap::new();
            keys.iter().for_each(|key| *exact.entry(*key).or_insert(0) += 1);
            let wanted: Vec<u32> = (1..700).collect();
            let exact = wanted.iter().map(|key| exact.get(key).copied().unwrap_or(0));
            let exact: Vec<u32> = exact.collect();
            let [keys, wanted] = [keys, wanted].map(|all| device.upload("keys", &all).unwrap());
            let found = hash_table::occurrences(&device, &keys, &wanted).unwrap();
            assert!(device.read(&found).unwrap() == exact, "{name}, {count}");
        }
    }
}

#[test]
fn halves_of_numbers() {
    for (name, device) in all() {
        let values = Random::new(10).values(2000, -100.0, 100.0);
        let pairs: Vec<_> = values.chunks(2).map(Vec2::from_slice).collect();
        let halves = halves::pack(&device, &device.upload("numbers", &pairs).unwrap()).unwrap();
        let sums = device.upload("sums", &vec![Vec2::ZERO; 1000]).unwrap();
        halves::add(&device, &halves, &sums).unwrap();
        // a half of 2^(e - 1) to 2^e is off by 2^(e - 12) at most
        for (sum, pair) in device.read(&sums).unwrap().iter().zip(&pairs) {
            assert!(
                (*sum - *pair).abs().cmple(pair.abs() / 2048.0).all(),
                "{name}: {sum} of {pair}"
            );
        }
    }
}

#[test]
fn transforms() {
    for (name, device) in all() {
        for count in [1_usize, 2, 64, 1024] {
            let mut random = Random::new(8);
            let mut number = || random.between(-1.0, 1.0);
            let values: Vec<_> = (0..count).map(|_| Vec2::new(number(), number())).collect();
            let input = device.upload("values", &values).unwrap();
            let found = fft::fft(&device, &input, -1.0).unwrap();
            // by the definition, for some of them
            for k in [0, count / 2, count - 1] {
                let mut exact = [0.0; 2];
                for (n, value) in values.iter().enumerate() {
                    let turn = -std::f64::consts::TAU * (k * n % count) as f64 / count as f64;
                    let [x, y] = [value.x, value.y].map(f64::from);
                    exact[0] += x * turn.cos() - y * turn.sin();
                    exact[1] += x * turn.sin() + y * turn.cos();
                }
                let found = device.read(&found).unwrap()[k];
                let away = (f64::from(found.x) - exact[0]).hypot(f64::from(found.y) - exact[1]);
                assert!(away < 1e-5 * (count as f64).sqrt() + 1e-6, "{name}, {count}: {away}");
            }
            let back = device.read(&fft::fft(&device, &found, 1.0).unwrap()).unwrap();
            for (back, value) in back.iter().zip(&values) {
                assert!((*back / count as f32 - *value).length() < 1e-5, "{name}, {count}");
            }
        }
    }
}

#[test]
fn clusters() {
    for (name, device) in all() {
        let mut random = Random::new(9);
        // three heaps, far from each other
        let heaps = [[0.0, 0.0], [100.0, 0.0], [0.0, 100.0]];
        let mut at = |center: f32| center + random.between(-1.0, 1.0);
        let points: Vec<_> = (0..1000).map(|i| Vec2::from(heaps[i % 3].map(&mut at))).collect();
        let begin = [0, 1, 2].map(|i| points[i]);
        let points = device.upload("points", &points).unwrap();
        let (centers, nearest) = k_means::k_means(&device, &points, &begin, 4).unwrap();
        assert!(nearest.iter().enumerate().all(|(i, cluster)| *cluster == i as u32 % 3), "{name}");
        for (center, heap) in centers.iter().zip(heaps) {
            assert!((*center - Vec2::from(heap)).length() < 0.2, "{name}: {center}");
        }
    }
}

#[test]
fn random_numbers() {
    for (name, device) in all() {
        let numbers = device.read(&random::pcg(&device, 100_000, 1).unwrap()).unwrap();
        assert!(numbers.iter().all(|number| (0.0..1.0).contains(number)), "{name}");
        let mean = numbers.iter().copied().map(f64::from).sum::<f64>() / 1e5;
        // of 100,000 uniform numbers it has a standard deviation of 0.0009
        assert!((mean - 0.5).abs() < 0.004, "{name}: {mean}");
        let words = device.read(&random::philox(&device, 1000, 1).unwrap()).unwrap();
        let ones: u32 = words.iter().flat_map(|word| word.to_array()).map(u32::count_ones).sum();
        assert!((ones as f64 / (1000.0 * 128.0) - 0.5).abs() < 0.006, "{name}: {ones}");
    }
}
