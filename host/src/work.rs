//! What a dispatch computes and moves: counted from its parameters, by formulas that docs/performance.md lists.

use std::ops::AddAssign;

use bytemuck::Pod;
use organza_kernels::color::{ColorHeadParams, ColorInputsParams};
use organza_kernels::color_backward::{ColorHeadBackwardParams, MaterialBackwardParams};
use organza_kernels::composite::CompositeParams;
use organza_kernels::composite_backward::CompositeBackwardParams;
use organza_kernels::dense::DenseParams;
use organza_kernels::dense_backward::{
    DenseBackwardParams, DenseWeightBackwardParams, DenseWeightSumParams,
};
use organza_kernels::hash_grid::HashGridParams;
use organza_kernels::kernel::KernelInfo;
use organza_kernels::peak::{MULTIPLY_ADDS, PeakMultiplyAddParams, PeakReadParams, READS};
use organza_kernels::project::ProjectParams;
use organza_kernels::resolve::ResolveParams;
use organza_kernels::splat::SplatParams;
use organza_kernels::transmittance::{TransmittanceHeadParams, TransmittanceInputsParams};

/// What was computed and moved; zeros where that is not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Floating-point operations: a multiply-add is two, an elementary function one.
    pub flops: u64,
    /// Bytes that must be read and written where each value that stays the same is read once a dispatch.
    pub bytes: u64,
}

impl AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.flops += other.flops;
        self.bytes += other.bytes;
    }
}

/// A dispatch.
#[derive(Clone, Copy, Debug)]
struct Call<'a> {
    uniform: &'a [u8],
    /// Elements of each storage buffer.
    elements: &'a [u64],
    /// Workgroups along z.
    layers: u64,
}

impl Call<'_> {
    /// The parameters, which must be the kernel's.
    fn params<P: Pod>(&self) -> P {
        bytemuck::pod_read_unaligned(self.uniform)
    }
}

/// Bytes of an `f32` or `u32`.
const NUMBER: u64 = 4;
/// Bytes of a `Vec4`.
const VECTOR: u64 = 16;
/// Bytes of a splat: three vectors.
const SPLAT: u64 = 3 * VECTOR;
/// Operations that place a point in a level: 9 an axis, and 15 for the weights of eight corners.
const CELL: u64 = 3 * 9 + 15;
/// Operations that smoothstep adds.
const SMOOTHSTEP: u64 = 3 * 4;
/// Bytes of a point: coarse and fine parts.
const POINT: u64 = 6 * NUMBER;
/// Operations of a member at a pixel.
const COMPOSITE: u64 = 20;
/// Operations of a member at a pixel on the way back.
const COMPOSITE_BACKWARD: u64 = 30;

type Count = fn(Call<'_>) -> Work;

/// The kernels that are counted, and how.
const COUNTED: [(&str, Count); 23] = [
    ("dense", dense),
    ("dense_half", dense_half),
    ("dense_backward", dense_backward),
    ("dense_weight_backward", dense_weight_backward),
    ("dense_weight_sum", dense_weight_sum),
    ("transmittance_inputs", transmittance_inputs),
    ("transmittance_head", transmittance_head),
    ("transmittance_head_backward", transmittance_head_backward),
    ("color_inputs", color_inputs),
    ("color_head", color_head),
    ("color_head_backward", color_head_backward),
    ("material_backward", material_backward),
    ("hash_grid", hash_grid),
    ("hash_grid_half", hash_grid_half),
    ("hash_grid_backward", hash_grid_backward),
    ("composite", composite),
    ("composite_backward", composite_backward),
    ("resolve", resolve),
    ("resolve_backward", resolve_backward),
    ("project", project),
    ("splat", splat),
    ("peak_multiply_add", peak_multiply_add),
    ("peak_read", peak_read),
];

impl Work {
    /// Of a dispatch of a kernel with these parameters, elements of its storage buffers, and workgroups along z; zeros
    /// where the kernel is not counted.
    #[must_use]
    pub fn of(kernel: &KernelInfo, uniform: &[u8], elements: &[u64], layers: u32) -> Self {
        let count = COUNTED.iter().find(|(name, _)| *name == kernel.name);
        let call = Call { uniform, elements, layers: u64::from(layers) };
        count.map_or_else(Self::default, |(_, count)| count(call))
    }
}

/// As numbers to calculate with.
fn wide<const N: usize>(numbers: [u32; N]) -> [u64; N] {
    numbers.map(u64::from)
}

fn dense(call: Call<'_>) -> Work {
    let params: DenseParams = call.params();
    let [samples, inputs, outputs] = wide([params.samples, params.inputs, 4 * params.columns]);
    Work {
        flops: 2 * samples * inputs * outputs,
        bytes: NUMBER * (samples * (inputs + outputs) + (inputs + 1) * outputs),
    }
}

fn dense_half(call: Call<'_>) -> Work {
    let Work { flops, bytes } = dense(call);
    let params: DenseParams = call.params();
    let [inputs, outputs] = wide([params.inputs, 4 * params.columns]);
    // of a weight half of the bytes
    Work { flops, bytes: bytes - NUMBER / 2 * inputs * outputs }
}

fn dense_backward(call: Call<'_>) -> Work {
    let params: DenseBackwardParams = call.params();
    let inputs = params.end_input - params.first_input;
    let [samples, inputs, outputs] = wide([params.samples, inputs, 4 * params.columns]);
    let masked = u64::from(params.rectified) * inputs;
    Work {
        flops: 2 * samples * inputs * outputs,
        bytes: NUMBER * (samples * (inputs + masked + outputs) + inputs * outputs),
    }
}

fn dense_weight_backward(call: Call<'_>) -> Work {
    let params: DenseWeightBackwardParams = call.params();
    let [samples, inputs, outputs] = wide([params.samples, params.inputs, 4 * params.columns]);
    Work {
        flops: samples * (2 * inputs + 1) * outputs,
        bytes: NUMBER * (samples * (inputs + outputs) + call.layers * (inputs + 1) * outputs),
    }
}

fn dense_weight_sum(call: Call<'_>) -> Work {
    let params: DenseWeightSumParams = call.params();
    let [parameters, slices] = wide([params.parameters, params.slices]);
    Work { flops: 4 * parameters * slices, bytes: VECTOR * parameters * (slices + 2) }
}

/// The last layer of a network: `outputs`, and `more` values of each sample beside its inputs.
fn head(samples: u32, inputs: u32, outputs: u64, more: u64) -> Work {
    let [samples, inputs] = wide([samples, inputs]);
    Work {
        flops: 2 * samples * inputs * outputs,
        bytes: NUMBER * samples * (inputs + more) + VECTOR * (inputs + 1),
    }
}

fn transmittance_head(call: Call<'_>) -> Work {
    let params: TransmittanceHeadParams = call.params();
    head(params.samples, params.inputs, 1, 2)
}

fn transmittance_head_backward(call: Call<'_>) -> Work {
    let params: TransmittanceHeadParams = call.params();
    head(params.samples, params.inputs, 1, 3)
}

fn color_head(call: Call<'_>) -> Work {
    let params: ColorHeadParams = call.params();
    head(params.samples, params.inputs, 3, 3)
}

fn color_head_backward(call: Call<'_>) -> Work {
    let params: ColorHeadBackwardParams = call.params();
    let samples = u64::from(params.samples);
    Work { flops: 3 * 3 * samples, bytes: samples * (2 * 3 * NUMBER + VECTOR) }
}

/// Values that are written alone: what they come from has many samples.
fn transmittance_inputs(call: Call<'_>) -> Work {
    let params: TransmittanceInputsParams = call.params();
    let [samples, extra] = wide([params.samples, params.extra]);
    Work { flops: 0, bytes: samples * (POINT + NUMBER + NUMBER * extra) }
}

fn color_inputs(call: Call<'_>) -> Work {
    let params: ColorInputsParams = call.params();
    let [pairs, degree, material] = wide([params.pairs, params.sh_degree, params.material]);
    // the pair and its position; harmonics; materials are read and written
    let values = 1 + 3 + (degree + 1).pow(2) + 2 * material;
    Work { flops: 0, bytes: pairs * (POINT + NUMBER * values) }
}

fn material_backward(call: Call<'_>) -> Work {
    let params: MaterialBackwardParams = call.params();
    let [samples, material] = wide([params.samples, params.material]);
    Work { flops: 0, bytes: 2 * NUMBER * samples * material }
}

/// Operations of a point in a level beside those of its features.
fn cell(params: &HashGridParams) -> u64 {
    CELL + SMOOTHSTEP * u64::from(params.smoothstep)
}

fn hash_grid(call: Call<'_>) -> Work {
    let params: HashGridParams = call.params();
    let [points, features] = wide([params.points, params.features]);
    let cells = points * call.layers;
    Work {
        flops: cells * (cell(&params) + 15 * features),
        bytes: points * POINT + cells * (8 + 1) * features * NUMBER,
    }
}

fn hash_grid_half(call: Call<'_>) -> Work {
    let params: HashGridParams = call.params();
    let [points, features] = wide([params.points, params.features]);
    // a word holds two of a corner's features; a product of two powers of two makes a half a number
    let words = 8 * call.layers * features.div_ceil(2);
    let full = hash_grid(call);
    let halved = NUMBER * points * (8 * call.layers * features - words);
    Work { flops: full.flops + 2 * points * words, bytes: full.bytes - halved }
}

fn hash_grid_backward(call: Call<'_>) -> Work {
    let params: HashGridParams = call.params();
    let [points, features] = wide([params.points, params.features]);
    let cells = points * call.layers;
    // a feature's gradient is read, and eight sums of 64 bits are read and written
    Work {
        flops: cells * (cell(&params) + 17 * features),
        bytes: points * POINT + cells * (NUMBER + 8 * 2 * 2 * NUMBER) * features,
    }
}

/// At most: every member at every pixel of its tile.
fn composite(call: Call<'_>) -> Work {
    const MEMBER: usize = 2;
    let params: CompositeParams = call.params();
    let area = u64::from(params.side).pow(2);
    // a fuller tile takes more dispatches: the first one stands for all of its members
    let members = if params.skip == 0 { call.elements[MEMBER] } else { 0 };
    let sums = call.layers * area * VECTOR;
    // a member's pair, cells and splat
    Work { flops: COMPOSITE * members * area, bytes: members * (2 * NUMBER + SPLAT) + 2 * sums }
}

/// At most: every member at every pixel of its tile.
fn composite_backward(call: Call<'_>) -> Work {
    let params: CompositeBackwardParams = call.params();
    let [members, tiles, side, rows] =
        wide([params.members, params.tiles, params.side, params.rows]);
    Work {
        flops: COMPOSITE_BACKWARD * members * side * rows,
        bytes: members * (NUMBER + SPLAT + 2 * SPLAT) + tiles * side * rows * VECTOR,
    }
}

fn resolve(call: Call<'_>) -> Work {
    let params: ResolveParams = call.params();
    let pixels = call.layers * u64::from(params.side).pow(2);
    Work { flops: 11 * pixels, bytes: pixels * (4 + 3) * NUMBER }
}

fn resolve_backward(call: Call<'_>) -> Work {
    let params: ResolveParams = call.params();
    let pixels = call.layers * u64::from(params.side).pow(2);
    Work { flops: 16 * pixels, bytes: pixels * (4 + 3 + 4) * NUMBER }
}

fn project(call: Call<'_>) -> Work {
    let params: ProjectParams = call.params();
    let gaussians = u64::from(params.gaussians);
    Work { flops: 0, bytes: gaussians * (10 * NUMBER + call.layers * 2 * VECTOR) }
}

fn splat(call: Call<'_>) -> Work {
    let params: SplatParams = call.params();
    // the pair, its projection, opacity, transmittance and color
    Work { flops: 0, bytes: u64::from(params.pairs) * (6 * NUMBER + 2 * VECTOR + SPLAT) }
}

fn peak_multiply_add(call: Call<'_>) -> Work {
    let params: PeakMultiplyAddParams = call.params();
    let [count, steps, each] = wide([params.count, params.steps, MULTIPLY_ADDS]);
    Work { flops: 2 * count * steps * each, bytes: count * NUMBER }
}

fn peak_read(call: Call<'_>) -> Work {
    let params: PeakReadParams = call.params();
    let [count, steps, each] = wide([params.count, params.steps, READS]);
    Work { flops: count * steps * each, bytes: count * (steps * each + 1) * NUMBER }
}

#[cfg(test)]
mod tests {
    use bytemuck::Zeroable;

    use super::*;

    fn of(name: &str, params: &impl Pod, elements: &[u64], layers: u32) -> Work {
        let kernel = organza_kernels::kernels().find(|kernel| kernel.name == name).expect(name);
        Work::of(kernel, bytemuck::bytes_of(params), elements, layers)
    }

    #[test]
    fn what_is_counted_is_there() {
        for (name, _) in COUNTED {
            assert!(organza_kernels::kernels().any(|kernel| kernel.name == name), "{name}");
        }
        let member = organza_kernels::kernels().find(|kernel| kernel.name == "composite");
        // a uniform buffer comes before the storage buffers
        assert_eq!(member.expect("composite").bindings[1 + 2].name, "member");
    }

    /// Reading parameters of another size would panic.
    #[test]
    fn parameters_are_as_large_as_the_kernels() {
        for (name, count) in COUNTED {
            let kernel = organza_kernels::kernels().find(|kernel| kernel.name == name).unwrap();
            let uniform = vec![0; kernel.bindings[0].element_bytes as usize];
            let call = Call { uniform: &uniform, elements: &[0; 12], layers: 0 };
            assert_eq!(count(call).flops, 0, "{name}");
        }
    }

    #[test]
    fn what_is_not_counted_is_nothing() {
        assert_eq!(of("scan_add", &[7_u32; 4], &[9; 4], 3), Work::default());
    }

    #[test]
    fn layers_are_their_multiply_adds() {
        let params = DenseParams { samples: 100, inputs: 32, columns: 4, ..Zeroable::zeroed() };
        let flops = 2 * 100 * 32 * 16;
        let bytes = 4 * (100 * (32 + 16) + 33 * 16);
        assert_eq!(of("dense", &params, &[], 1), Work { flops, bytes });

        // eight of 32 inputs
        let params = DenseBackwardParams {
            samples: 100,
            inputs: 32,
            columns: 4,
            first_input: 24,
            end_input: 32,
            rectified: 1,
            ..Zeroable::zeroed()
        };
        let bytes = 4 * (100 * (8 + 8 + 16) + 8 * 16);
        assert_eq!(of("dense_backward", &params, &[], 1), Work { flops: flops / 4, bytes });

        let params = DenseWeightBackwardParams {
            samples: 100,
            inputs: 32,
            columns: 4,
            ..Zeroable::zeroed()
        };
        let bytes = 4 * (100 * (32 + 16) + 3 * 33 * 16);
        let flops = flops + 100 * 16;
        assert_eq!(of("dense_weight_backward", &params, &[], 3), Work { flops, bytes });
    }

    #[test]
    fn a_grid_reads_eight_corners() {
        let params = HashGridParams { points: 10, features: 2, ..Zeroable::zeroed() };
        let work = of("hash_grid", &params, &[], 16);
        assert_eq!(work, Work { flops: 160 * (42 + 30), bytes: 10 * 24 + 160 * (64 + 8) });
        let smooth = HashGridParams { smoothstep: 1, ..params };
        assert_eq!(of("hash_grid", &smooth, &[], 16).flops, 160 * (54 + 30));
    }

    #[test]
    fn members_are_counted_once() {
        let elements = [0, 0, 7, 0, 0];
        let params = CompositeParams { side: 8, ..Zeroable::zeroed() };
        let first = of("composite", &params, &elements, 2);
        let sums = 2 * 64 * 16 * 2;
        assert_eq!(first, Work { flops: 7 * 64 * 20, bytes: 7 * 56 + sums });
        let second = CompositeParams { skip: 16_384, ..params };
        assert_eq!(of("composite", &second, &elements, 2), Work { flops: 0, bytes: sums });
    }
}
