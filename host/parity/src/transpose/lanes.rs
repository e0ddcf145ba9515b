//! The rows whose forward kernel takes all that it differentiates through lanes: its slopes are computed in f64.

use muslin::dual::{Dual, Slopes};
use muslin::prelude::{Invocation, Read, Workgroup, Write};
use muslin_check::prelude::*;
use muslin_check::{assert_transpose, devices};
use organza_shaders::dense::{OUTPUTS_PER_INVOCATION, dense};
use organza_shaders::hash_grid::hash_grid;
use organza_shaders::resolve::resolve;
use organza_shaders::transmittance::transmittance_head;

use crate::dense_backward::DenseBackward;
use crate::hash_grid::{HashGrid, features};
use crate::hash_grid_backward::HashGridBackward;
use crate::resolve::ResolveBackward;
use crate::transmittance::{head_params, points};
use crate::transmittance_backward::TransmittanceHeadBackward;

/// The random sets of a case, and the first output that the CPU gives for each.
fn sets<P: Parity>() -> impl Iterator<Item = (String, P, Vec<f64>)> {
    let sets = P::sets().into_iter();
    let sets = sets.filter(|(name, _)| name.starts_with("random") && !name.contains(" 0 items"));
    sets.map(|(name, set)| {
        let cpu = devices::cpu(None);
        let outputs = set.run(&KernelRunner::new(&cpu, P::KERNEL)).expect("the kernel runs");
        let gradient = outputs[0].to_f64();
        (format!("{}, {name}", P::KERNEL), set, gradient)
    })
}

/// A direction, 0 where the function says no.
fn direction(len: usize, is_free: impl Fn(usize) -> bool) -> Vec<f64> {
    let mut random = Random::new(len as u64);
    let mut slope = |index| {
        let slope = f64::from(random.between(-1.0, 1.0));
        if is_free(index) { slope } else { 0.0 }
    };
    (0..len).map(&mut slope).collect()
}

/// Runs a kernel over workgroups.
fn run(size: [u32; 3], workgroups: [u32; 3], kernel: impl Fn(Invocation)) {
    let [x, y, z] = workgroups;
    for index in 0..x * y * z {
        let place = [index % x, index / x % y, index / x / y];
        Workgroup::new(size).at(place, workgroups).run(&kernel);
    }
}

fn wide(values: &[f32]) -> Vec<f64> {
    values.iter().copied().map(f64::from).collect()
}

#[test]
fn resolve_backward_is_the_transpose_of_resolve() {
    for (name, set, gradient) in sets::<ResolveBackward>() {
        let side = set.params.side;
        let area = (side * side) as usize;
        let tiles = set.sum.len() / 4 / (side * side) as usize;
        let v = direction(set.sum.len(), |_| true);
        let slopes = Slopes::new(&set.sum, &v);
        let mut image = vec![0.0; set.image_gradient.len()];
        let tile = Read::from(&set.tile[..]);
        let sum = Read::from(&set.sum[..]);
        let output = Write::from(&mut image[..]);
        let workgroups = [side.div_ceil(16), side.div_ceil(4), tiles as u32];
        run([16, 4, 1], workgroups, |id| resolve::<Dual>(id, &set.params, tile, sum, output));
        // the case has the channels of a pixel next to each other
        let plane = |index: usize| {
            let tile = index / 4 / area;
            let channel = index / area % 4;
            let at = index % area;
            gradient[4 * (tile * area + at) + channel]
        };
        let backward: Vec<_> = (0..v.len()).map(plane).collect();
        let u = wide(&set.image_gradient);
        assert_transpose(&name, [&slopes.at(&image), &u], [&v, &backward], 1e-6);
    }
}

#[test]
fn dense_backward_is_the_transpose_of_dense() {
    for (name, mut set, gradient) in sets::<DenseBackward>() {
        let layer = &mut set.layer;
        if !layer.columns.is_multiple_of(OUTPUTS_PER_INVOCATION / 4) {
            continue;
        }
        // above 0, the activation of the outputs does nothing
        let params = layer.params();
        layer.parameters[params.bias as usize..].fill(glam::Vec4::splat(1e4));
        let layer = &set.layer;
        let stride = set.layer.stride;
        // below 0, that of the inputs lets nothing through
        let v = direction(layer.input.len(), |index| {
            let row = index as u32 / stride;
            let is_on = !set.rectified || layer.input[index] > 0.0;
            (set.first..layer.inputs).contains(&row) && layer.place(index).is_some() && is_on
        });
        let slopes = Slopes::new(&layer.input, &v);
        let mut output = vec![0.0; set.gradient.len()];
        let (weights, input, view) = (
            Read::from(&layer.parameters[..]),
            Read::from(&layer.input[..]),
            Write::from(&mut output[..]),
        );
        let z = layer.columns * 4 / OUTPUTS_PER_INVOCATION;
        let workgroups = [layer.samples.div_ceil(64), 1, z];
        run([64, 1, 1], workgroups, |id| dense::<Dual>(id, &params, weights, input, view));
        let u = wide(&set.gradient);
        assert_transpose(&name, [&slopes.at(&output), &u], [&v, &gradient], 1e-6);
    }
}

/// The backward kernel goes as far as the logit, which is linear in the inputs.
#[test]
fn transmittance_head_backward_is_the_transpose_of_transmittance_head() {
    for (name, set, gradient) in sets::<TransmittanceHeadBackward>() {
        let layer = &set.layer;
        let params = head_params(&set.layer);
        let v = direction(layer.input.len(), |index| layer.place(index).is_some());
        let slopes = Slopes::new(&layer.input, &v);
        let place = points(layer, &set.factor);
        let mut log_rho = vec![0.0; (params.first_sample + layer.samples) as usize];
        let (weights, point, input, view) = (
            Read::from(&layer.parameters[..]),
            Read::from(&place[..]),
            Read::from(&layer.input[..]),
            Write::from(&mut log_rho[..]),
        );
        run([64, 1, 1], [layer.samples.div_ceil(64), 1, 1], |id| {
            transmittance_head::<Dual>(id, &params, weights, point, input, view);
        });
        let logit = |sample: usize| -> f64 {
            let along = |row: u32| v[(row * layer.stride) as usize + sample];
            (0..layer.inputs).map(|row| layer.weight(row, 0) * along(row)).sum()
        };
        let samples = layer.samples as usize;
        let logits: Vec<_> = (0..samples).map(logit).collect();
        let found = &slopes.at(&log_rho)[params.first_sample as usize..];
        let u = wide(&set.gradient[..samples]);
        assert_transpose(&name, [found, &u], [&logits, &gradient[..samples]], 1e-6);
    }
}

/// The features are linear in the table.
#[test]
fn hash_grid_backward_is_the_transpose_of_hash_grid() {
    for (name, set, sums) in sets::<HashGridBackward>() {
        let table = vec![0.0; sums.len()];
        let grid = set.grid.clone();
        let points = set.points.clone();
        let forward = HashGrid { grid, points, table, is_unrounded: false };
        let v = direction(sums.len(), |_| true);
        let slopes = Slopes::new(&forward.table, &v);
        let levels = forward.levels();
        let position = forward.positions();
        let params = forward.params();
        let mut output = vec![0.0; forward.output_len()];
        let (levels, table, position, view) = (
            Read::from(&levels[..]),
            Read::from(&forward.table[..]),
            Read::from(&position[..]),
            Write::from(&mut output[..]),
        );
        let workgroups = [params.points.div_ceil(64), 1, set.grid.levels];
        run([64, 1, 1], workgroups, |id| {
            hash_grid::<Dual>(id, &params, levels, table, position, view);
        });
        let u = features(&set.grid, set.points.len(), &set.gradient);
        // what is no feature has no gradient
        let u: Vec<_> = u.iter().map(|&u| if u.is_nan() { 0.0 } else { f64::from(u) }).collect();
        let gradient: Vec<_> = sums.iter().map(|sum| sum / f64::from(set.scale)).collect();
        assert_transpose(&name, [&slopes.at(&output), &u], [&v, &gradient], 1e-6);
    }
}
