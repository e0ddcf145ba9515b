//! Kernels with lanes and barriers: where a workgroup runs in lanes, and that it gives what one lane gives.

use muslin::prelude::*;
use muslin::workgroup::{SharedMemory, Workgroup};
use muslin_check::{devices, inputs::Random};
use muslin_device::Device;

use crate::{assert_contains, failure, line};

/// A grid.
#[params]
pub struct Grid {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Moves the values of 16 neighbors in a row around, by 3 in each of `rounds [1]`. Of the value x that comes to a place: `exp(x x + x)` to
/// `output [height, width]`, and how many invocations have run at once, to `together [height, width]`.
#[kernel(threads(16, 4), over(params.width, params.height, 1), lanes(width), iterations = 9)]
pub fn turns<L: Lane>(
    id: Invocation,
    params: &Grid,
    rounds: Read<u32>,
    input: Read<f32>,
    output: Write<f32>,
    together: Write<f32>,
    tile: Shared<f32, 64>,
) {
    let place = id.global();
    let own = id.local_index();
    let turned = L::ramp().index().wrapping_add(L::Index::splat(id.local.x + 3));
    let from = (turned & L::Index::splat(15)).wrapping_add(L::Index::splat(16 * id.local.y));
    let index = place.y * params.width + place.x;
    let end = if place.y < params.height { (place.y + 1) * params.width } else { 0 };
    let mut value = L::read_below(input, index, end);
    // the parameters do not say how many: the invocations vote
    for _ in 0..rounds.read(0) {
        value.write_shared(tile, own);
        id.barrier();
        value = L::gather_shared(tile, from);
        id.barrier();
    }
    if index < end && place.x < params.width {
        value.mul_add(value, value).exp().write(output, index);
        L::splat(L::WIDTH as f32).write(together, index);
    }
}

/// The sum of each row of `input [height, width]`, less that of the other row in a pair: an invocation takes a row in lanes.
#[kernel(threads(64), over(params.height), lanes, iterations = 40)]
pub fn differences<L: Lane>(
    id: Invocation,
    params: &Grid,
    input: Read<f32>,
    output: Write<f32>,
    sums: Shared<f32, 64>,
) {
    let row = id.index();
    let end = if row < params.height { (row + 1) * params.width } else { 0 };
    let mut at = row * params.width;
    let mut sum = L::splat(0.0);
    while at < end {
        sum = sum + L::read_below(input, at, end);
        at += L::WIDTH;
    }
    sums.write(id.local.x, sum.sum());
    id.barrier();
    if row < params.height {
        output.write(row, sum.sum() - sums.read(id.local.x ^ 1));
    }
}

/// Writes indices to `data [width]`, and moves the halves of each 64 to `output [width]`.
#[kernel(threads(64), over(params.width), lanes(width), storage_barriers)]
pub fn halves<L: Lane>(id: Invocation, params: &Grid, data: Write<f32>, output: Write<f32>) {
    let [index, other] = [id.index(), id.index() ^ 32];
    if index < params.width {
        (L::splat(index as f32) + L::ramp()).write(data, index);
    }
    id.storage_barrier();
    if index < params.width && other < params.width {
        L::read_written(data, other).write(output, index);
    }
}

/// A quarter of the workgroup waits.
#[kernel(threads(64), over(params.width), lanes(width))]
pub fn quarter_waits<L: Lane>(
    id: Invocation,
    params: &Grid,
    output: Write<f32>,
    values: Shared<f32, 64>,
) {
    let at = id.local.x;
    L::ramp().write_shared(values, at);
    if at < params.width / 4 {
        id.barrier();
    }
    L::read_shared(values, at).write(output, id.index());
}

/// Each instruction set of this CPU with its number of lanes, and the devices that check: these have one.
fn devices_and_lanes() -> Vec<(&'static str, Device, u32)> {
    let lanes = |name| match name {
        "scalar" => 1,
        "avx512" => 16,
        _ => 8,
    };
    let all = devices::cpus().into_iter().map(|(name, device)| (name, device, lanes(name)));
    let checked = [("checked", devices::checked(), 1), ("thorough", devices::thorough(3), 1)];
    all.chain(checked).collect()
}

#[test]
fn workgroups_of_items_run_in_lanes_and_others_one_by_one() {
    let devices = devices_and_lanes();
    for [width, height] in [[1, 1], [16, 4], [17, 5], [15, 9], [50, 3], [64, 1], [0, 0]] {
        let params = Grid { width, height };
        let count = (width * height) as usize;
        let input = Random::new(width.into()).values(count.max(1), -1.0, 1.0);
        for rounds in [0, 1, 6] {
            let place = |index: usize| (index as u32 % width, index as u32 / width);
            let value = |index: usize| {
                let (x, y) = place(index);
                let from = x / 16 * 16 + (x + 3 * rounds) % 16;
                if from < width { input[(y * width + from) as usize] } else { 0.0 }
            };
            let mut bits = Vec::new();
            for (name, device, lanes) in &devices {
                let all = || device.unwritten::<f32>("values", count.max(1)).unwrap();
                let [output, together] = [all(), all()];
                let input = device.upload("input", &input).unwrap();
                let rounds = device.upload("rounds", &[rounds]).unwrap();
                let (rounds, input) = (&rounds, &input);
                let kernel =
                    TurnsKernel { params, rounds, input, output: &output, together: &together };
                device.run_all(&kernel).unwrap();
                if count == 0 {
                    continue;
                }
                let together = device.read(&together).unwrap();
                let output = device.read(&output).unwrap();
                for (index, (found, together)) in output.iter().zip(together).enumerate() {
                    let is_whole = place(index).0 / 16 * 16 + 16 <= width;
                    let expected = if is_whole { *lanes } else { 1 };
                    assert_eq!(together, expected as f32, "{name}, {width} x {height}: {index}");
                    let x = f64::from(value(index));
                    let expected = (x * x + x).exp();
                    let error = (f64::from(*found) / expected - 1.0).abs();
                    assert!(error < 6e-7, "{name}: {found} at {index}, not {expected}");
                }
                bits.push((name.starts_with("avx"), output));
            }
            for is_fused in [false, true] {
                let mut same = bits.iter().filter(|of| of.0 == is_fused).map(|of| &of.1);
                let first = same.next();
                assert!(same.all(|other| Some(other) == first), "{width} x {height}");
            }
        }
    }
}

#[test]
fn an_invocation_can_have_all_lanes_and_barriers() {
    for (name, device, _) in devices_and_lanes() {
        for [width, height] in [[1, 64], [33, 65], [7, 3], [16, 200], [0, 5]] {
            let input: Vec<_> = (0..(width * height).max(1)).map(|i| (i * i % 97) as f32).collect();
            let row = |row: u32| match row < height {
                true => (row * width..(row + 1) * width).map(|at| input[at as usize]).sum(),
                false => 0.0_f32,
            };
            let expected: Vec<_> = (0..height).map(|at| row(at) - row(at ^ 1)).collect();
            let output = device.unwritten("output", expected.len()).unwrap();
            let input = device.upload("input", &input).unwrap();
            let params = Grid { width, height };
            device.run_all(&DifferencesKernel { params, input: &input, output: &output }).unwrap();
            assert_eq!(device.read(&output).unwrap(), expected, "{name}, {width} x {height}");
        }
    }
}

#[test]
fn storage_barriers_order_lanes() {
    for (name, device, _) in devices_and_lanes() {
        for width in [1_u32, 32, 64, 65, 100, 1000] {
            let data = device.unwritten("data", width as usize).unwrap();
            let output = device.zeros("output", width as usize).unwrap();
            let params = Grid { width, height: 1 };
            device.run_all(&HalvesKernel { params, data: &data, output: &output }).unwrap();
            let other = |i: u32| if i ^ 32 < width { (i ^ 32) as f32 } else { 0.0 };
            let expected: Vec<_> = (0..width).map(other).collect();
            assert_eq!(device.read(&output).unwrap(), expected, "{name}, {width}");
        }
    }
}

#[test]
fn lanes_that_do_not_wait_are_counted() {
    for (_, device, _) in devices_and_lanes() {
        let output = device.unwritten("output", 128).unwrap();
        let params = Grid { width: 128, height: 1 };
        let message = failure(&device, &QuarterWaitsKernel { params, output: &output }, 128);
        let source = ["lanes.rs", include_str!("lanes.rs")];
        let branch = line(source, "if at < params.width / 4 {");
        assert_contains(
            &message,
            &["(with 31 more) waits at", "[32, 0, 0] (with 31 more)", &branch],
        );
    }
}

#[test]
fn a_test_calls_a_kernel_with_lanes_and_barriers() {
    let params = Grid { width: 16, height: 4 };
    let input: [f32; 64] = core::array::from_fn(|i| i as f32 / 64.0);
    let [mut output, mut together] = [[0.0; 64]; 2];
    let [outputs, all] = [&mut output, &mut together].map(|all| Write::from(&mut all[..]));
    let rounds = Read::from(&[1][..]);
    let inputs = Read::from(&input[..]);
    let tile = SharedMemory::new();
    Workgroup::new([16, 4, 1])
        .run(|id| turns::<f32>(id, &params, rounds, inputs, outputs, all, tile.view()));
    for (at, (found, together)) in output.iter().zip(together).enumerate() {
        let x = input[at / 16 * 16 + (at + 3) % 16];
        assert!((found / (x * x + x).exp() - 1.0).abs() < 1e-6, "{at}: {found}");
        assert_eq!(together, 1.0);
    }
}
