//! Adam as its authors wrote it, in f64.

use organza::parity::adam::Adam;

use super::hold::hold;

#[test]
fn a_step_is_that_of_kingma_and_ba() {
    hold::<Adam>(|set, output, index| {
        let first = set.params.first_gradient as usize;
        if output == "gradient" {
            // what belongs to other groups, and behind the last, stays
            let is_own = index.checked_sub(first).is_some_and(|own| set.is_touched(own));
            return if is_own { Some(0.0) } else { set.gradient.get(index).map(|&g| f64::from(g)) };
        }
        let value = f64::from(*set.value.get(index)?);
        let (m, v) = (f64::from(set.first_moment[index]), f64::from(set.second_moment[index]));
        let params = set.params;
        let (beta1, beta2) = (f64::from(params.decay1), f64::from(params.decay2));
        let g = f64::from(set.gradient[index + first]);
        let is_touched = set.is_touched(index);
        let m = if is_touched { beta1 * m + (1.0 - beta1) * g } else { m };
        let v = if is_touched { beta2 * v + (1.0 - beta2) * g * g } else { v };
        Some(match output {
            "first_moment" => m,
            "second_moment" => v,
            _ if !is_touched => value,
            _ => {
                let size = (v.sqrt() * f64::from(params.correction2)) + f64::from(params.epsilon);
                value - f64::from(params.rate) * m / size
            }
        })
    });
}
