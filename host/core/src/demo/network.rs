//! Writing weights by hand: linear forms of a layer's inputs, and splines out of ReLUs.

use crate::scene::Layer;

/// A linear form of the inputs of a layer, or of the units of the layer before.
#[derive(Clone, Debug, Default)]
pub struct Form {
    terms: Vec<(usize, f32)>,
    constant: f32,
}

impl Form {
    pub fn input(index: usize) -> Self {
        Self { terms: vec![(index, 1.0)], constant: 0.0 }
    }

    pub fn constant(constant: f32) -> Self {
        Self { terms: Vec::new(), constant }
    }

    #[must_use]
    pub fn times(mut self, factor: f32) -> Self {
        for (_, weight) in &mut self.terms {
            *weight *= factor;
        }
        self.constant *= factor;
        self
    }

    /// `self + factor * other`
    #[must_use]
    pub fn plus(mut self, factor: f32, other: &Self) -> Self {
        self.terms.extend(other.terms.iter().map(|&(index, weight)| (index, factor * weight)));
        self.offset(factor * other.constant)
    }

    #[must_use]
    pub fn offset(mut self, constant: f32) -> Self {
        self.constant += constant;
        self
    }

    /// This form where `gate` is 1, and a value far below every knot where it is 0.
    #[must_use]
    pub fn gated(self, gate: &Self) -> Self {
        const CLOSED: f32 = 10.0;
        self.plus(CLOSED, gate).offset(-CLOSED)
    }
}

/// A layer whose units are allocated one by one.
#[derive(Debug)]
pub struct Units<'l> {
    layer: &'l mut Layer,
    used: usize,
}

impl<'l> Units<'l> {
    pub fn new(layer: &'l mut Layer) -> Self {
        Self { layer, used: 0 }
    }

    /// Allocates the next unit for a form. Returns the unit's value, for the next layer: `max(form, 0)` in a hidden
    /// layer, the form itself in the last one.
    pub fn take(&mut self, form: &Form) -> Form {
        let unit = self.used;
        assert!(unit < self.layer.outputs, "the layer has {} units", self.layer.outputs);
        self.used += 1;
        for &(input, weight) in &form.terms {
            self.layer.weight[unit * self.layer.inputs + input] += weight;
        }
        self.layer.bias[unit] += form.constant;
        Form::input(unit)
    }

    /// Passes a form unchanged to the next layer. It must be at least `min`.
    pub fn pass(&mut self, form: &Form, min: f32) -> Form {
        self.take(&form.clone().offset(-min)).offset(min)
    }

    /// The piecewise linear function of `x` through `knots`, as a sum of hinges `max(x - knot, 0)`. It is constant
    /// before the first knot, and continues straight after the last.
    pub fn spline(&mut self, x: &Form, knots: &[(f32, f32)]) -> Form {
        let mut sum = Form::constant(knots[0].1);
        let mut slope = 0.0;
        for pair in knots.windows(2) {
            let (from, low) = pair[0];
            let (to, high) = pair[1];
            let next = (high - low) / (to - from);
            sum = sum.plus(next - slope, &self.take(&x.clone().offset(-from)));
            slope = next;
        }
        sum
    }
}
