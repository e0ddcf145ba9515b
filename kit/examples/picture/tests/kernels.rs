//! The kernels on the CPU and, two ways, on a GPU: beside each other, beside the equations in f64, and as a picture.

use organza_check::snapshot::{Snapshots, picture::Montage};
use organza_check::{Case, KernelRunner, Output, Parity, Result, assert_parity, devices, inputs};
use picture::{MODULES, picture};
use picture_kernels::*;

const SNAPSHOTS: Snapshots = organza_check::snapshots!("tests/snapshots");

/// Inputs of `ripples`: the side.
struct Ripples(u32);

impl Parity for Ripples {
    const KERNEL: &'static str = "ripples";
    const TOLERANCE: f64 = 1e-5;
    const WHY: &'static str = "five roundings of up to 6 ripples, beside a gray of 0.2";

    fn sets() -> Vec<(String, Self)> {
        [1, 7, 8, 33].map(|side| (format!("side {side}"), Self(side))).into()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let params = Picture { side: self.0, pixels: self.0 * self.0 };
        let gray = runner.unwritten(params.pixels as usize);
        runner.run_over(&RipplesKernel { params, gray: &gray }, self.0, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let at = |place: u32| (2.0 * f64::from(place) + 1.0) / f64::from(self.0) - 1.0;
        let waves = (0..self.0).flat_map(|y| (0..self.0).map(move |x| 4.0 * at(x).hypot(at(y))));
        waves.map(|wave| Some(1.0 - 0.8 * (2.0 * wave.fract() - 1.0).abs())).collect()
    }
}

/// Inputs of `histogram`: the gray of each pixel.
struct Histogram(Vec<f32>);

impl Parity for Histogram {
    const KERNEL: &'static str = "histogram";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| Self(random.values(count as usize, 0.0, 1.0)))
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let params = Picture { side: 0, pixels: self.0.len() as u32 };
        let kernel = HistogramKernel { params, gray: &self.0, bins: &vec![0; BINS] };
        runner.run(&kernel, params.pixels, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let count = |bin| self.0.iter().filter(|gray| (*gray * 15.99) as usize == bin).count();
        (0..BINS).map(|bin| Some(count(bin) as f64)).collect()
    }
}

/// Inputs of `tint`: the gray of each pixel.
struct Tint(Vec<f32>);

impl Parity for Tint {
    const KERNEL: &'static str = "tint";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "one rounding";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|count, _, random| Self(random.values(count as usize, 0.0, 1.0)))
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        let params = Picture { side: 0, pixels: self.0.len() as u32 };
        let color = runner.unwritten(3 * self.0.len());
        runner.run(&TintKernel { params, gray: &self.0, color: &color }, params.pixels, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let tints = [|x| x, |x| x * x, |x| 0.5 - 0.25 * x] as [fn(f64) -> f64; 3];
        tints.iter().flat_map(|tint| self.0.iter().map(|&x| Some(tint(x.into())))).collect()
    }
}

#[test]
fn every_kernel_is_right_on_every_device() {
    assert_parity(&[Case::of::<Ripples>(), Case::of::<Histogram>(), Case::of::<Tint>()], &MODULES);
}

#[test]
fn the_picture_stays_the_same() {
    let montage = Montage { tiles: 1, side: 64, columns: 1, scale: 4 };
    for (name, device) in devices::all(&MODULES) {
        let (color, bins) = picture(&device, 64).unwrap();
        assert_eq!(bins.iter().sum::<u32>(), 64 * 64, "{name}");
        SNAPSHOTS.assert_picture(["ripples", "rings around the middle"], name, &color, montage);
    }
    picture(&devices::checked(), 63).expect("no race, and no read of what nothing has written");
}
