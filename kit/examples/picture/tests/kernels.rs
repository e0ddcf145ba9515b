//! The kernels on the CPU and, two ways, on a GPU: beside each other, beside the equations in f64, and as a picture.

use muslin::check::snapshot::{Snapshots, picture::Montage};
use muslin::check::{Case, assert_parity, devices, prelude::*};
use picture::{MODULES, draw_ripples, picture};
use picture_kernels::*;

const SNAPSHOTS: Snapshots = muslin::check::snapshots!("tests/snapshots");

#[test]
fn ripples_begin_in_the_middle_on_every_device() {
    draw_ripples(&devices::checked(), 7).unwrap();
    for (name, device) in devices::all(&MODULES) {
        let gray = draw_ripples(&device, 8).unwrap();
        assert!((gray[4 * 8 + 4] - 0.668_629).abs() < 1e-6, "{name}: {}", gray[4 * 8 + 4]);
    }
}

case!(Ripples(RipplesInputs));

impl Parity for Ripples {
    const KERNEL: &'static str = "ripples";
    const TOLERANCE: f64 = 1e-5;
    const WHY: &'static str = "five roundings of up to 6 ripples, beside a gray of 0.2";

    fn sets() -> Vec<(String, Self)> {
        let set = |side: u32| {
            let params = Picture { side, pixels: side * side };
            let gray = unwritten(params.pixels as usize);
            (format!("side {side}"), Self(RipplesInputs { params, gray }))
        };
        [1, 7, 8, 33].map(set).into()
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run_over(&self.kernel(), [self.params.side, self.params.side, 1])
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let side = self.params.side;
        let at = |place: u32| (2.0 * f64::from(place) + 1.0) / f64::from(side) - 1.0;
        let waves = (0..side).flat_map(|y| (0..side).map(move |x| 4.0 * at(x).hypot(at(y))));
        waves.map(|wave| Some(1.0 - 0.8 * (2.0 * wave.fract() - 1.0).abs())).collect()
    }
}

case!(Histogram(HistogramInputs));

impl Parity for Histogram {
    const KERNEL: &'static str = "histogram";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|pixels, _, random| {
            let gray = random.values(pixels as usize, 0.0, 1.0);
            let params = Picture { side: 0, pixels };
            Self(HistogramInputs { params, gray, bins: vec![0; BINS] })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pixels, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let count = |bin| self.gray.iter().filter(|gray| (*gray * 15.99) as usize == bin).count();
        (0..BINS).map(|bin| Some(count(bin) as f64)).collect()
    }
}

case!(Tint(TintInputs));

impl Parity for Tint {
    const KERNEL: &'static str = "tint";
    const TOLERANCE: f64 = 1.2e-7;
    const WHY: &'static str = "one rounding";

    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|pixels, _, random| {
            let gray = random.values(pixels as usize, 0.0, 1.0);
            let params = Picture { side: 0, pixels };
            Self(TintInputs { params, gray, color: unwritten(3 * pixels as usize) })
        })
    }

    fn run(&self, runner: &KernelRunner<'_>) -> Result<Vec<Output>> {
        runner.run(&self.kernel(), self.params.pixels, 1)
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<f64>> {
        let tints = [|x| x, |x| x * x, |x| 0.5 - 0.25 * x] as [fn(f64) -> f64; 3];
        tints.iter().flat_map(|tint| self.gray.iter().map(|&x| Some(tint(x.into())))).collect()
    }
}

#[test]
fn every_kernel_is_right_on_every_device() {
    assert_parity(
        &[Case::new::<Ripples>(), Case::new::<Histogram>(), Case::new::<Tint>()],
        &MODULES,
    );
}

#[test]
#[ignore = "`cargo xtask bench` runs it"]
fn bench() {
    muslin::check::bench::bench(&MODULES, |device| picture(device, 2048).map(drop));
}

#[test]
fn the_picture_stays_the_same() {
    picture(&devices::checked(), 63).expect("no race, and no read of what nothing has written");
    let montage = Montage { tiles: 1, side: 64, columns: 1, scale: 4 };
    for (name, device) in devices::all(&MODULES) {
        let (color, bins) = picture(&device, 64).unwrap();
        assert_eq!(bins.iter().sum::<u32>(), 64 * 64, "{name}");
        SNAPSHOTS.assert_picture(["ripples", "rings around the middle"], name, &color, montage);
    }
}
