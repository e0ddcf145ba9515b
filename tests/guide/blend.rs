//! A blend of two images.

use organza_kernel::prelude::*;

/// Parameters of [`blend`].
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct BlendParams {
    /// Values of an image.
    pub count: u32,
    /// Weight of the second image, 0 to 1.
    pub weight: f32,
}

/// `output = (1 - weight) first + weight second`
#[kernel(threads(64))]
pub fn blend(
    id: Invocation,
    params: &BlendParams,
    first: Read<f32>,
    second: Read<f32>,
    output: Write<f32>,
) {
    let index = id.index();
    if index < params.count {
        let (a, b) = (first.read(index), second.read(index));
        output.write(index, (1.0 - params.weight) * a + params.weight * b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec3;

    #[test]
    fn a_quarter_of_the_way() {
        let (first, second) = ([0.0, 8.0, -4.0], [4.0, 8.0, 0.0]);
        let mut output = [0.0; 3];
        let params = BlendParams { count: 3, weight: 0.25 };
        for x in 0..64 {
            let local = UVec3::new(x, 0, 0);
            let id = Invocation::new(local, UVec3::ZERO, UVec3::ONE, UVec3::new(64, 1, 1));
            let output = Write::from(output.as_mut_slice());
            blend(id, &params, Read::from(&first[..]), Read::from(&second[..]), output);
        }
        assert_eq!(output, [1.0, 8.0, -3.0]);
    }
}
