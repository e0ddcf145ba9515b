//! What the subjects take, beside ordinary Rust with rayon: `cargo test --release -p muslin-everyday --test times -- --ignored --nocapture`.

use std::collections::HashMap;
use std::time::Instant;

use glam::{Vec2, Vec3};
use muslin::math::unpack_half_2x16;
use muslin_check::{devices, inputs::Random};
use muslin_device::{Buffer, Device, Result};
use muslin_everyday::*;
use muslin_everyday_kernels::blur::GridParams;
use muslin_everyday_kernels::matrix::ProductParams;
use muslin_everyday_kernels::matrix_tiles::TilesParams;
use muslin_everyday_kernels::random::{pcg, unit};
use muslin_everyday_kernels::transpose::TransposeParams;
use rayon::prelude::*;

/// Values of most subjects.
const COUNT: usize = 1 << 22;
/// Rows and columns of matrices, and of pictures.
const SIDE: u32 = 512;
const WIDE: u32 = 2048;

/// Milliseconds of the fastest of seven runs.
fn best(mut run: impl FnMut()) -> f64 {
    let time = |_| {
        let begin = Instant::now();
        run();
        begin.elapsed().as_secs_f64() * 1e3
    };
    (0..7).map(time).fold(f64::INFINITY, f64::min)
}

/// What is measured on a device, which has the inputs.
type Run<'d> = Box<dyn Fn() -> Result<()> + 'd>;

/// Gives a device the inputs.
type Prepare = Box<dyn Fn(&Device) -> Result<Run<'_>>>;

/// A subject: its name, ordinary Rust, and its run on a device.
struct Subject {
    name: &'static str,
    rust: Box<dyn Fn()>,
    device: Prepare,
}

fn subject<R>(
    name: &'static str,
    rust: impl Fn() -> R + 'static,
    device: impl Fn(&Device) -> Result<Run<'_>> + 'static,
) -> Subject {
    let rust = Box::new(move || drop(std::hint::black_box(rust())));
    Subject { name, rust, device: Box::new(device) }
}

/// Inputs of the test, which live as long as it.
fn kept<T>(values: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(values.into_iter().collect())
}

fn subjects() -> Vec<Subject> {
    let values = kept(Random::new(1).values(COUNT, 0.0, 1.0));
    let mut random = Random::new(2);
    let words = kept((0..COUNT).map(|_| random.bits() % 200));
    let keys = kept((0..COUNT / 4).map(|_| random.bits()));
    let bytes = kept(words.iter().map(|word| *word as u8));
    let matrix = kept(Random::new(3).values((SIDE * SIDE) as usize, -1.0, 1.0));
    let halves = kept(matrix.iter().map(|value| (value * 64.0).round() / 64.0));
    let picture = kept(Random::new(4).values((WIDE * WIDE) as usize, 0.0, 1.0));
    let pixels = kept(picture.iter().map(|value| value.to_bits()));
    let prefix_sum = |name, of: fn(&Device, &Buffer<u32>) -> Result<Buffer<u32>>| {
        subject(
            name,
            || prefix(words),
            move |device| {
                let values = device.upload("values", words)?;
                Ok(Box::new(move || of(device, &values).and_then(|all| done(device, &all))))
            },
        )
    };
    let all = [
        subject(
            "sum of 2^22",
            || values.par_iter().sum::<f32>(),
            |device| {
                let values = device.upload("values", values)?;
                Ok(Box::new(move || sum::sum(device, &values).map(drop)))
            },
        ),
        prefix_sum("prefix sum of 2^22, in passes", prefix_sum::in_passes),
        prefix_sum("prefix sum of 2^22, looking back", prefix_sum::look_back),
        subject(
            "radix sort of 2^20 pairs",
            || {
                let mut pairs: Vec<_> = keys.iter().copied().zip(0_u32..).collect();
                pairs.par_sort_by_key(|(key, _)| *key);
                pairs
            },
            |device| {
                let values: Vec<_> = (0..keys.len() as u32).collect();
                let keys = device.upload("keys", keys)?;
                let values = device.upload("values", &values)?;
                Ok(Box::new(move || {
                    let (sorted, _) = radix_sort::radix_sort(device, &keys, &values)?;
                    done(device, &sorted)
                }))
            },
        ),
        subject(
            "histogram of 2^22",
            || {
                let count = |mut bins: Vec<u32>, value: &u8| {
                    bins[usize::from(*value)] += 1;
                    bins
                };
                let add = |a: Vec<u32>, b: Vec<u32>| a.iter().zip(&b).map(|(a, b)| a + b).collect();
                bytes.par_iter().fold(|| vec![0; 256], count).reduce(|| vec![0; 256], add)
            },
            |device| {
                let values = device.upload("values", bytes)?;
                Ok(Box::new(move || histogram::histogram(device, &values).map(drop)))
            },
        ),
        subject(
            "product of 512 x 512",
            || product(matrix, matrix),
            |device| {
                let matrix = device.upload("matrix", matrix)?;
                let params = ProductParams { rows: SIDE, inner: SIDE, columns: SIDE };
                let product = move || matrix::product(device, params, &matrix, &matrix);
                Ok(Box::new(move || done(device, &product()?)))
            },
        ),
        subject(
            "product of 512 x 512 halves, in tiles",
            || product(halves, halves),
            |device| {
                let matrix = device.upload("matrix", &matrix_tiles::words(halves))?;
                let params = TilesParams { rows: SIDE, inner: SIDE, columns: SIDE };
                let product = move || matrix_tiles::product(device, params, &matrix, &matrix);
                Ok(Box::new(move || done(device, &product()?)))
            },
        ),
        subject(
            "blur 5 x 5 of 2048 x 2048",
            || blurred(picture),
            |device| {
                let input = device.upload("picture", picture)?;
                let params = GridParams { width: WIDE, height: WIDE, rate: 0.0 };
                Ok(Box::new(move || done(device, &blur::blur(device, params, &input)?)))
            },
        ),
        subject(
            "transpose of 2048 x 2048",
            || {
                let side = WIDE as usize;
                let row = |x: usize| (0..side).map(|y| pixels[y * side + x]).collect::<Vec<_>>();
                (0..side).into_par_iter().flat_map_iter(row).collect::<Vec<_>>()
            },
            |device| {
                let input = device.upload("matrix", pixels)?;
                let params = TransposeParams { rows: WIDE, columns: WIDE };
                Ok(Box::new(move || done(device, &transpose::transpose(device, params, &input)?)))
            },
        ),
        subject(
            "compaction of 2^22",
            || values.par_iter().copied().filter(|value| *value >= 0.5).collect::<Vec<_>>(),
            |device| {
                let values = device.upload("values", values)?;
                Ok(Box::new(move || compact::compact(device, &values, 0.5).map(drop)))
            },
        ),
        subject(
            "random numbers, PCG, 2^22",
            || {
                let seed = pcg(1);
                let numbers =
                    (0..COUNT as u32).into_par_iter().map(|index| unit(pcg(index ^ seed)));
                numbers.collect::<Vec<_>>()
            },
            |device| Ok(Box::new(move || done(device, &random::pcg(device, COUNT as u32, 1)?))),
        ),
    ];
    all.into_iter().chain(others()).collect()
}

/// Subjects of pairs and of integers.
fn others() -> [Subject; 4] {
    let mut random = Random::new(5);
    let points = kept(
        (0..COUNT / 16).map(|_| Vec2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0))),
    );
    let keys = kept((0..COUNT / 4).map(|_| random.below(COUNT as u32 / 16)));
    let terms = kept((0..COUNT / 2).map(|_| random.below(0x3c00) << 16 | random.below(0x3c00)));
    [
        subject(
            "FFT of 2^18",
            || transformed(points),
            |device| {
                let values = device.upload("values", points)?;
                Ok(Box::new(move || done(device, &fft::fft(device, &values, -1.0)?)))
            },
        ),
        subject(
            "k-means of 2^18 points, 16 centers, 4 rounds",
            || clustered(points, 4),
            |device| {
                let centers = &points[..CENTERS];
                let points = device.upload("points", points)?;
                Ok(Box::new(move || k_means::k_means(device, &points, centers, 4).map(drop)))
            },
        ),
        subject(
            "hash table of 2^20 keys, all looked up",
            || {
                let mut counts = HashMap::<u32, u32>::new();
                keys.iter().for_each(|key| *counts.entry(*key).or_default() += 1);
                keys.par_iter().map(|key| counts[key]).collect::<Vec<_>>()
            },
            |device| {
                let keys = device.upload("keys", keys)?;
                Ok(Box::new(move || done(device, &hash_table::occurrences(device, &keys, &keys)?)))
            },
        ),
        subject(
            "2^22 halves, added to numbers",
            || {
                let sums = terms.par_iter().map(|term| Vec2::ONE + unpack_half_2x16(*term));
                sums.collect::<Vec<_>>()
            },
            |device| {
                let numbers = device.upload("numbers", &vec![Vec2::ONE; terms.len()])?;
                let terms = device.upload("terms", terms)?;
                Ok(Box::new(move || {
                    halves::add(device, &terms, &numbers)?;
                    done(device, &numbers)
                }))
            },
        ),
    ]
}

/// Centers of clusters.
const CENTERS: usize = 16;

/// The discrete Fourier transform, in passes over pairs.
fn transformed(values: &[Vec2]) -> Vec<Vec2> {
    let half = values.len() / 2;
    let mut now = values.to_vec();
    let mut next = now.clone();
    let mut size = 1;
    while size < values.len() {
        next.par_chunks_mut(2 * size).enumerate().for_each(|(group, out)| {
            let (first, second) = out.split_at_mut(size);
            for j in 0..size {
                let turn = Vec2::from_angle(-std::f32::consts::PI * j as f32 / size as f32);
                let a = now[group * size + j];
                let b = now[group * size + j + half].rotate(turn);
                first[j] = a + b;
                second[j] = a - b;
            }
        });
        std::mem::swap(&mut now, &mut next);
        size *= 2;
    }
    now
}

/// Centers that move to the means of the nearest points.
fn clustered(points: &[Vec2], rounds: usize) -> Vec<Vec2> {
    let mut centers = points[..CENTERS].to_vec();
    for _ in 0..rounds {
        let add = |mut sums: [Vec3; CENTERS], point: &Vec2| {
            let distance = |at: &usize| centers[*at].distance_squared(*point);
            let nearest = (0..CENTERS).min_by(|a, b| distance(a).total_cmp(&distance(b)));
            sums[nearest.expect("a center")] += point.extend(1.0);
            sums
        };
        let none = || [Vec3::ZERO; CENTERS];
        let both = |a: [Vec3; CENTERS], b: [Vec3; CENTERS]| std::array::from_fn(|at| a[at] + b[at]);
        let sums = points.par_iter().fold(none, add).reduce(none, both);
        centers = sums.map(|sum| sum.truncate() / sum.z.max(1.0)).to_vec();
    }
    centers
}

/// Waits for a result, and reads a value.
fn done<T: bytemuck::Pod>(device: &Device, buffer: &Buffer<T>) -> Result<()> {
    device.read_range(buffer, 0, 1).map(drop)
}

/// Exclusive prefix sums, in two passes over parts.
fn prefix(values: &[u32]) -> Vec<u32> {
    const PART: usize = 1 << 16;
    let sums: Vec<u32> = values.par_chunks(PART).map(|part| part.iter().sum()).collect();
    let next = |sum: &mut u32, value: &u32| {
        let before = *sum;
        *sum += value;
        Some(before)
    };
    let before: Vec<_> = sums.iter().scan(0, next).collect();
    let of = |(part, begin): (&[u32], &u32)| part.iter().scan(*begin, next).collect::<Vec<_>>();
    values.par_chunks(PART).zip(&before).flat_map_iter(of).collect()
}

/// The product of two square matrices, row by row.
fn product(left: &[f32], right: &[f32]) -> Vec<f32> {
    let side = SIDE as usize;
    let row = |left: &[f32]| {
        let mut sums = vec![0.0; side];
        for (a, right) in left.iter().zip(right.chunks(side)) {
            sums.iter_mut().zip(right).for_each(|(sum, b)| *sum += a * b);
        }
        sums
    };
    left.par_chunks(side).flat_map_iter(row).collect()
}

/// The mean of 5 x 5 pixels.
fn blurred(input: &[f32]) -> Vec<f32> {
    let side = WIDE as usize;
    let last = side as i64 - 1;
    let row = |y: usize| {
        (0..side).map(move |x| {
            let mut sum = 0.0;
            for dy in -2..=2 {
                let row = (y as i64 + dy).clamp(0, last) as usize * side;
                for dx in -2..=2 {
                    sum += input[row + (x as i64 + dx).clamp(0, last) as usize];
                }
            }
            sum / 25.0
        })
    };
    (0..side).into_par_iter().flat_map_iter(row).collect()
}

#[test]
#[ignore = "it measures"]
fn times() {
    let mut devices = devices::all(&MODULES);
    let variants = devices::variants(&MODULES).into_iter().take(1);
    devices.extend(variants.map(|(_, [_, device])| ("gpu variants", device)));
    let names = devices.iter().map(|(name, _)| format!(" {name} |"));
    println!("| milliseconds | Rust with rayon |{} ", names.collect::<String>());
    // `SUBJECT=product` measures those alone
    let wanted = std::env::var("SUBJECT").unwrap_or_default();
    for Subject { name, rust, device } in subjects() {
        if !name.contains(&wanted) {
            continue;
        }
        let mut line = format!("| {name} | {:.1} |", best(&*rust));
        for (_, of) in &devices {
            let run = device(of).expect("the inputs");
            let time = best(|| run().expect("it runs"));
            line += &format!(" {time:.1} |");
        }
        println!("{line}");
    }
}
