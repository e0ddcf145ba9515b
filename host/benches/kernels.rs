//! Measures every hot kernel alone, on one thread, for each instruction set of this CPU.
//!
//! ```sh
//! cargo bench --bench kernels
//! ```
//!
//! The module's name says what an item is: a floating-point operation in `flops` (a multiply-add is two, so Gitem/s
//! are GFLOP/s), a sample, a Gaussian, or a pair of a member and a pixel of its tile. Sizes are those of rendering on
//! a CPU: chunks of 4,096 samples forward and 2,048 backward, layers of 64 x 64, grids of 16 levels with 2 features
//! in 2^19 entries, tiles of 64 x 64.

mod common;

fn main() {
    divan::main();
}

/// Items are floating-point operations.
mod flops {
    use divan::Bencher;
    use glam::Vec4;
    use muslin::binned::ROWS;
    use muslin::peak::{MULTIPLY_ADDS, PeakMultiplyAddKernel, PeakMultiplyAddParams};
    use organza::InstructionSet;
    use organza_shaders::dense::{DenseKernel, DenseParams, OUTPUTS_PER_INVOCATION};
    use organza_shaders::dense_backward::{
        DenseBackwardKernel, DenseBackwardParams, DenseWeightBackwardKernel,
        DenseWeightBackwardParams, INPUTS_PER_INVOCATION, weight_invocations,
    };

    use crate::common::{BACKWARD, Bench, FORWARD, sets};

    /// Inputs and outputs of the layer.
    const WIDTH: u32 = 64;
    /// Columns of four outputs.
    const COLUMNS: u32 = WIDTH / 4;
    /// Index of the biases, after the weights.
    const BIAS: u32 = WIDTH * COLUMNS;
    /// Number of vectors of weights and biases.
    const PARAMETERS: u32 = BIAS + COLUMNS;

    /// Number of operations of a layer: a multiply-add for each weight and sample.
    fn operations(samples: u32) -> u64 {
        2 * u64::from(samples) * u64::from(WIDTH * WIDTH)
    }

    /// The CPU's peak: multiply-adds on registers.
    #[divan::bench(args = sets())]
    fn peak(bencher: Bencher, set: InstructionSet) {
        let bench = Bench::new(set);
        let count = 1_024;
        let steps = 512;
        let params = PeakMultiplyAddParams { count, steps, factor: 0.5, addend: 1.0 };
        let kernel = PeakMultiplyAddKernel { params, output: &bench.zeros::<f32>(count) };
        let items = 2 * u64::from(count) * u64::from(steps * MULTIPLY_ADDS);
        bench.run(bencher, items, &kernel, [count, 1]);
    }

    #[divan::bench(args = sets())]
    fn dense(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let stride = FORWARD.stride;
        let params = DenseParams {
            samples: FORWARD.samples,
            stride,
            inputs: WIDTH,
            columns: COLUMNS,
            weight: 0,
            bias: BIAS,
        };
        let kernel = DenseKernel {
            params,
            parameters: &bench.vectors(PARAMETERS),
            input: &bench.numbers(WIDTH * stride, [0.0, 1.0]),
            output: &bench.zeros::<f32>(WIDTH * stride),
        };
        let size = [FORWARD.samples, WIDTH / OUTPUTS_PER_INVOCATION];
        bench.run(bencher, operations(FORWARD.samples), &kernel, size);
    }

    #[divan::bench(args = sets())]
    fn dense_backward(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let stride = BACKWARD.stride;
        let params = DenseBackwardParams {
            samples: BACKWARD.samples,
            stride,
            inputs: WIDTH,
            columns: COLUMNS,
            weight: 0,
            first_input: 0,
            end_input: WIDTH,
            rectified: 1,
        };
        let kernel = DenseBackwardKernel {
            params,
            parameters: &bench.vectors(PARAMETERS),
            input: &bench.numbers(WIDTH * stride, [-1.0, 1.0]),
            output_gradient: &bench.numbers(WIDTH * stride, [-1.0, 1.0]),
            input_gradient: &bench.zeros::<f32>(WIDTH * stride),
        };
        let size = [BACKWARD.samples, WIDTH / INPUTS_PER_INVOCATION];
        bench.run(bencher, operations(BACKWARD.samples), &kernel, size);
    }

    #[divan::bench(args = sets())]
    fn dense_weight_backward(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let stride = BACKWARD.stride;
        let params = DenseWeightBackwardParams {
            samples: BACKWARD.samples,
            first_sample: 0,
            stride,
            inputs: WIDTH,
            columns: COLUMNS,
            weight: 0,
            bias: BIAS,
            cameras: 1,
            words: 1,
            of_rays: 0,
            slice: BACKWARD.samples,
            parameters: PARAMETERS,
            turn: 0,
        };
        let kernel = DenseWeightBackwardKernel {
            params,
            // one camera, which has one slice
            first_pair: &bench.upload(&[0, BACKWARD.samples]),
            first_sample: &bench.upload(&[0]),
            input: &bench.numbers(WIDTH * stride, [-1.0, 1.0]),
            output_gradient: &bench.numbers(WIDTH * stride, [-1.0, 1.0]),
            carry: &bench.zeros::<Vec4>(2 * PARAMETERS),
            sum: &bench.zeros::<u32>(2 * ROWS * 4 * PARAMETERS),
        };
        let size = [weight_invocations(WIDTH, COLUMNS), 1];
        bench.run(bencher, operations(BACKWARD.samples), &kernel, size);
    }
}

/// Items are samples.
mod samples {
    use divan::Bencher;
    use organza::InstructionSet;
    use organza::scene::GridConfig;
    use organza_shaders::hash_grid::{HashGridKernel, HashGridParams, POINT_ROWS};
    use organza_shaders::hash_grid_backward::{HashGridBackwardKernel, VALUES_PER_FLAG};
    use organza_shaders::segment::SEGMENT_VECTORS;
    use organza_shaders::transmittance::{TransmittanceInputsKernel, TransmittanceInputsParams};

    use crate::common::{BACKWARD, Bench, FORWARD, sets};

    /// Number of samples per pair.
    const PER_PAIR: u32 = 16;

    fn grid() -> GridConfig {
        GridConfig {
            levels: 16,
            features: 2,
            log2_table: 19,
            base_resolution: 16.0,
            growth: 1.447_269_2,
        }
    }

    fn params([samples, stride]: [u32; 2]) -> HashGridParams {
        HashGridParams {
            points: samples,
            stride,
            first_row: 0,
            features: 2,
            chunk: samples,
            point_rows: POINT_ROWS,
            rows: 0,
        }
    }

    /// Points all over the unit cube, as `[6, stride]`: coarse parts, and fine parts of zero.
    fn points(bench: &mut Bench, stride: u32) -> Vec<f32> {
        let mut points = bench.random.values((3 * stride) as usize, 0.0, 1.0);
        points.resize((POINT_ROWS * stride) as usize, 0.0);
        points
    }

    #[divan::bench(args = sets())]
    fn hash_grid(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let grid = grid();
        let stride = FORWARD.stride;
        let points = points(&mut bench, stride);
        let kernel = HashGridKernel {
            params: params([FORWARD.samples, stride]),
            levels: &bench.upload(&grid.levels_for_kernels()),
            table: &bench.numbers(2 * grid.entries() as u32, [-1.0, 1.0]),
            position: &bench.upload(&points),
            output: &bench.zeros::<f32>(grid.width() as u32 * stride),
        };
        bench.run(bencher, FORWARD.samples.into(), &kernel, [FORWARD.samples, grid.levels]);
    }

    #[divan::bench(args = sets())]
    fn hash_grid_backward(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let grid = grid();
        let stride = BACKWARD.stride;
        let points = points(&mut bench, stride);
        let values = 2 * grid.entries() as u32;
        // the unit, its inverse and the limit: sums of a million times as many samples still fit
        let unit = f32::from_bits((127 + 20) << 23);
        let kernel = HashGridBackwardKernel {
            params: params([BACKWARD.samples, stride]),
            levels: &bench.upload(&grid.levels_for_kernels()),
            position: &bench.upload(&points),
            feature_gradient: &bench.numbers(grid.width() as u32 * stride, [-1.0, 1.0]),
            scale: &bench.upload(&[unit, unit.recip(), 2.0]),
            sum: &bench.zeros::<u32>(2 * values),
            touched: &bench.zeros::<u32>(values.div_ceil(VALUES_PER_FLAG)),
            status: &bench.zeros::<u32>(1),
        };
        bench.run(bencher, BACKWARD.samples.into(), &kernel, [BACKWARD.samples, grid.levels]);
    }

    #[divan::bench(args = sets())]
    fn transmittance_inputs(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let samples = FORWARD.samples;
        let stride = FORWARD.stride;
        let pairs = samples / PER_PAIR;
        let first_sample: Vec<_> = (0..=pairs).map(|pair| pair * PER_PAIR).collect();
        let pair: Vec<_> = (0..pairs).collect();
        let params = TransmittanceInputsParams {
            samples,
            first_sample: 0,
            stride,
            pairs,
            gaussians: pairs,
            extra: 2,
            extra_row: 32,
            contracted: 0,
        };
        let kernel = TransmittanceInputsKernel {
            params,
            pair: &bench.upload(&pair),
            first_sample: &bench.upload(&first_sample),
            segment: &bench.numbers(4 * SEGMENT_VECTORS * pairs, [0.0, 0.5]).view(),
            extra: &bench.numbers(2 * pairs, [-1.0, 1.0]),
            point: &bench.zeros::<f32>((POINT_ROWS + 1) * stride),
            input: &bench.zeros::<f32>(34 * stride),
        };
        bench.run(bencher, samples.into(), &kernel, [samples, 1]);
    }
}

/// Items are pairs of a tile's member and a pixel of the tile. A kernel skips most pixels that a splat does not
/// reach.
mod member_pixels {
    use divan::Bencher;
    use glam::Vec4;
    use organza::InstructionSet;
    use organza_shaders::composite::{CompositeKernel, CompositeParams, SUM_PLANES};
    use organza_shaders::composite_backward::{CompositeBackwardKernel, CompositeBackwardParams};
    use organza_shaders::splat::VECTORS;

    use crate::common::{Bench, SIDE, Tiles, sets};

    #[divan::bench(args = sets())]
    fn composite(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let tiles = Tiles::new(&mut bench.random);
        let kernel = CompositeKernel {
            params: CompositeParams { side: SIDE, skip: 0 },
            tile: &bench.upload(&tiles.tile),
            tile_first: &bench.upload(&tiles.tile_first),
            member: &bench.upload(&tiles.member),
            cells: &bench.upload(&vec![u32::MAX; tiles.member.len()]),
            splat: &bench.upload(&tiles.splat),
            sum: &bench.zeros::<f32>(tiles.count() * SUM_PLANES * SIDE * SIDE),
        };
        bench.run_over(bencher, tiles.items(), &kernel, [SIDE, SIDE, tiles.count()]);
    }

    #[divan::bench(args = sets())]
    fn composite_backward(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let tiles = Tiles::new(&mut bench.random);
        let members = tiles.member.len() as u32;
        let sums = tiles.count() * SUM_PLANES * SIDE * SIDE;
        let tiles_of = tiles.count();
        let rows = SIDE;
        let params = CompositeBackwardParams {
            members,
            tiles: tiles_of,
            side: SIDE,
            first_row: 0,
            rows,
            colors: 1,
            compensated_blur: 0.0,
        };
        let kernel = CompositeBackwardKernel {
            params,
            tile: &bench.upload(&tiles.tile),
            tile_first: &bench.upload(&tiles.tile_first),
            member: &bench.upload(&tiles.member),
            splat: &bench.upload(&tiles.splat),
            sum_gradient: &bench.numbers(sums, [-1.0, 1.0]),
            member_gradient: &bench.zeros::<Vec4>(members * VECTORS),
        };
        bench.run(bencher, tiles.items(), &kernel, [members, 1]);
    }
}

/// Items are Gaussians.
mod gaussians {
    use divan::Bencher;
    use glam::{Vec2, Vec3, Vec4};
    use organza::InstructionSet;
    use organza_shaders::camera::Camera;
    use organza_shaders::project::{EVERYWHERE, ProjectKernel, ProjectParams};

    use crate::common::{Bench, sets};

    const GAUSSIANS: u32 = 20_000;

    #[divan::bench(args = sets())]
    fn project(bencher: Bencher, set: InstructionSet) {
        let mut bench = Bench::new(set);
        let camera = Camera {
            rotation: [Vec3::X, Vec3::Y, Vec3::Z],
            eye: Vec3::new(0.0, 0.0, -4.0),
            focal: Vec2::splat(620.0),
            center: Vec2::new(320.0, 240.0),
            size: Vec2::new(640.0, 480.0),
        };
        let kernel = ProjectKernel {
            params: ProjectParams { gaussians: GAUSSIANS, blur: 0.3 },
            camera: &bench.upload(&camera.pack()),
            window: &bench.upload(&EVERYWHERE),
            position: &bench.numbers(3 * GAUSSIANS, [-1.0, 1.0]),
            rotation: &bench.numbers(4 * GAUSSIANS, [0.1, 1.0]),
            log_scale: &bench.numbers(3 * GAUSSIANS, [-5.0, -2.0]),
            projection: &bench.zeros::<Vec4>(2 * GAUSSIANS),
            degenerate: &bench.zeros::<u32>(1),
        };
        bench.run(bencher, GAUSSIANS.into(), &kernel, [GAUSSIANS, 1]);
    }
}
