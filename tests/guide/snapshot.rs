use organza_device::{Device, Result};
use organza_shaders::blend::{BlendKernel, BlendParams};
use organza_tests::devices;

/// Blends two images of one size.
fn blend(device: &Device, first: &[f32], second: &[f32], weight: f32) -> Result<Vec<f32>> {
    let params = BlendParams { count: first.len() as u32, weight };
    let output = device.unwritten("output", first.len())?;
    let kernel = BlendKernel {
        params,
        first: &device.upload("first", first)?,
        second: &device.upload("second", second)?,
        output: &output,
    };
    device.run(&kernel, params.count, 1)?;
    device.read(&output)
}

#[test]
fn two_gradients() {
    let first: Vec<_> = (0..6).map(|i| i as f32 / 5.0).collect();
    let second: Vec<_> = first.iter().rev().map(|value| value * value).collect();
    insta::allow_duplicates! {
        for (_, device) in devices::all() {
            let values = blend(&device, &first, &second, 0.25).unwrap();
            let text = format!("{values:.3?}");
            insta::assert_snapshot!(text, @"[0.250, 0.310, 0.390, 0.490, 0.610, 0.750]");
        }
    }
}
