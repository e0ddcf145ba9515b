//! The kernels on the CPU and, two ways, on a GPU: beside each other, beside the equations in f64, and as a picture.

use muslin::check::snapshot::{Snapshots, picture::Montage};
use muslin::check::{assert_parity, cases, devices, prelude::*};
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
    fn sets() -> Vec<(String, Self)> {
        let set = |side: u32| {
            let params = Picture { side, pixels: side * side };
            let gray = unwritten(params.pixels as usize);
            (format!("side {side}"), Self(RipplesInputs { params, gray }))
        };
        [1, 7, 8, 33].map(set).into()
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let side = self.params.side;
        let number = |x: f64| Rounded::from(x);
        let middle = number(0.5) * Rounded::from(side);
        let at = |place: u32| Rounded::from(place) + number(0.5) - middle;
        let gray = |x: Rounded, y: Rounded| {
            let wave = number(4.0) * (x * x + y * y).sqrt() / middle;
            // a whole wave begins where the last one ends
            let slope = number(2.0) * (wave - Rounded::exact(wave.value.floor())) - number(1.0);
            number(1.0) - number(0.8) * slope.abs()
        };
        listed((0..side).flat_map(|y| (0..side).map(move |x| gray(at(x), at(y)))))
    }
}

case!(Histogram(HistogramInputs));

impl Parity for Histogram {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|pixels, _, random| {
            let gray = random.values(pixels as usize, 0.0, 1.0);
            let params = Picture { side: 0, pixels };
            Self(HistogramInputs { params, gray, bins: vec![0; BINS] })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let count = |bin| self.gray.iter().filter(|gray| (*gray * 15.99) as usize == bin).count();
        listed((0..BINS).map(|bin| count(bin) as f64))
    }
}

case!(Tint(TintInputs));

impl Parity for Tint {
    fn sets() -> Vec<(String, Self)> {
        inputs::sets(|pixels, _, random| {
            let gray = random.values(pixels as usize, 0.0, 1.0);
            let params = Picture { side: 0, pixels };
            Self(TintInputs { params, gray, color: unwritten(3 * pixels as usize) })
        })
    }

    fn exact(&self, _: &str, _: usize) -> Vec<Option<Rounded>> {
        let [half, quarter] = [0.5, 0.25].map(Rounded::from);
        let tints = |x: Rounded| [x, x * x, half - quarter * x];
        listed((0..3).flat_map(|row| self.gray.iter().map(move |&x| tints(x.into())[row])))
    }
}

#[test]
fn every_kernel_is_right_on_every_device() {
    assert_parity(&cases(env!("CARGO_PKG_NAME")), &MODULES);
}

#[test]
#[ignore = "it measures"]
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
