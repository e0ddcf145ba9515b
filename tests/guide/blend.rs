//! A blend of two images.

use organza_kernel::prelude::*;

/// Parameters of [`blend`].
#[params]
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
    use organza_kernel::workgroup::Workgroup;

    #[test]
    fn a_quarter_of_the_way() {
        let (first, second) = ([0.0, 8.0, -4.0], [4.0, 8.0, 0.0]);
        let mut output = [0.0; 3];
        let params = BlendParams { count: 3, weight: 0.25 };
        let (first, second) = (Read::from(&first[..]), Read::from(&second[..]));
        let view = Write::from(&mut output[..]);
        Workgroup::new([64, 1, 1]).run(|id| blend(id, &params, first, second, view));
        assert_eq!(output, [1.0, 8.0, -3.0]);
    }
}
