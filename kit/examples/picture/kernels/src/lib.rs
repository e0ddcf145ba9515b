//! Three kernels. Each is an ordinary function: the CPU runs it, and `cargo xtask kernels` compiles it for every GPU.
#![no_std]

use muslin::{math, prelude::*};

/// Parameters of all kernels: `pixels` is `side * side`.
#[params]
pub struct Picture {
    pub side: u32,
    pub pixels: u32,
}

/// A plain kernel. `gray [side, side]`: ripples around the middle, 0.2 to 1.
#[kernel(threads(8, 8), over(params.side, params.side, 1))]
pub fn ripples(id: Invocation, params: &Picture, gray: Write<f32>) {
    let place = id.global();
    if place.x < params.side && place.y < params.side {
        let middle = 0.5 * params.side as f32;
        let x = place.x as f32 + 0.5 - middle;
        let y = place.y as f32 + 0.5 - middle;
        let wave = 4.0 * math::sqrt(x * x + y * y) / middle;
        let slope = math::abs(2.0 * (wave - math::truncate(wave)) - 1.0);
        gray.write(place.y * params.side + place.x, 1.0 - 0.8 * slope);
    }
}

/// Bins of [`histogram`].
pub const BINS: usize = 16;

/// With workgroup memory and barriers. Adds to `bins [BINS]` how many pixels have a gray of each sixteenth of 0 to 1.
#[kernel(threads(64), over(params.pixels))]
pub fn histogram(
    id: Invocation,
    params: &Picture,
    gray: Read<f32>,
    bins: Write<u32>,
    counts: Shared<u32, BINS>,
) {
    if id.local.x < BINS as u32 {
        counts.write(id.local.x, 0);
    }
    id.barrier();
    if id.index() < params.pixels {
        counts.atomic_add((gray.read(id.index()) * 15.99) as u32, 1);
    }
    id.barrier();
    if id.local.x < BINS as u32 {
        bins.atomic_add(id.local.x, counts.read(id.local.x));
    }
}

/// With lanes: the CPU computes several pixels at once. `color [3, pixels]`: dark is blue, bright is yellow.
#[kernel(threads(64), over(params.pixels), lanes(pixels))]
pub fn tint<L: Lane>(id: Invocation, params: &Picture, gray: Read<f32>, color: Write<f32>) {
    let index = id.index();
    if index < params.pixels {
        let bright = L::read(gray, index);
        bright.write(color, index);
        (bright * bright).write(color, params.pixels + index);
        (L::splat(0.5) - bright * L::splat(0.25)).write(color, 2 * params.pixels + index);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A test beside a kernel needs no device: it calls the kernel, one workgroup at a time.
    #[test]
    fn ripples_begin_in_the_middle() {
        let params = Picture { side: 8, pixels: 64 };
        let mut gray = [0.0; 64];
        let pixels = Write::from(&mut gray[..]);
        Workgroup::new([8, 8, 1]).run(|id| ripples(id, &params, pixels));
        // the middle of four pixels: half a pixel away in x and y, the wave is at sqrt(1/2)
        let slope = 2.0 * math::sqrt(0.5) - 1.0;
        let expected = 1.0 - 0.8 * slope;
        assert!((gray[4 * 8 + 4] - expected).abs() < 1e-6, "{}", gray[4 * 8 + 4]);
    }

    /// The test makes the workgroup memory.
    #[test]
    fn pixels_are_counted() {
        let params = Picture { side: 2, pixels: 4 };
        let gray = [0.0, 0.03, 0.52, 1.0];
        let mut bins = [0; BINS];
        let counts = SharedMemory::new();
        let input = Read::from(&gray[..]);
        let sums = Write::from(&mut bins[..]);
        Workgroup::new([64, 1, 1]).run(|id| histogram(id, &params, input, sums, counts.view()));
        assert_eq!((bins[0], bins[8], bins[15]), (2, 1, 1));
    }
}
