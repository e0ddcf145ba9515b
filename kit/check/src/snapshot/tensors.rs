//! Named tensors as text: the content of a tensor snapshot.
//!
//! `# name [shape]`, then the values: one line per row of the last axis, with seven significant digits. That is more than any
//! tolerance needs, and readable in a diff. With `exact` after the shape, the values must be equal.

use std::fmt::{self, Write};

/// A named tensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Tensor {
    /// Name, without spaces.
    pub name: String,
    /// Shape, row-major.
    pub shape: Vec<usize>,
    /// Whether values must be equal, as counts must be.
    pub exact: bool,
    /// Values, row-major.
    pub values: Vec<f64>,
}

/// The tensors of a snapshot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tensors(pub Vec<Tensor>);

impl Tensors {
    /// Adds a tensor.
    pub fn push(&mut self, name: &str, shape: &[usize], values: &[f32]) {
        self.add(name, shape, false, values.iter().map(|&value| f64::from(value)).collect());
    }

    /// Adds a tensor whose values must be equal.
    pub fn push_counts(&mut self, name: &str, shape: &[usize], counts: &[u32]) {
        self.add(name, shape, true, counts.iter().map(|&count| f64::from(count)).collect());
    }

    fn add(&mut self, name: &str, shape: &[usize], exact: bool, values: Vec<f64>) {
        assert_eq!(shape.iter().product::<usize>(), values.len(), "{name}: {shape:?}");
        self.0.push(Tensor { name: name.to_owned(), shape: shape.to_vec(), exact, values });
    }

    /// Parses the text that [`fmt::Display`] wrote.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut tensors = Vec::<Tensor>::new();
        for line in text.lines() {
            if let Some(header) = line.strip_prefix("# ") {
                tensors.push(parse_header(header).ok_or(format!("no header: `{line}`"))?);
            } else if let Some(tensor) = tensors.last_mut() {
                for word in line.split_whitespace() {
                    tensor.values.push(word.parse().map_err(|_| format!("no number: `{word}`"))?);
                }
            }
        }
        for tensor in &tensors {
            let name = &tensor.name;
            let shape = &tensor.shape;
            let values = tensor.values.len();
            if shape.iter().product::<usize>() != values {
                return Err(format!("`{name}` of shape {shape:?} has {values} values"));
            }
        }
        Ok(Self(tensors))
    }
}

fn parse_header(header: &str) -> Option<Tensor> {
    let (name, rest) = header.split_once(" [")?;
    let (shape, exact) = rest.split_once(']')?;
    let sizes = shape.split(", ").filter(|size| !size.is_empty());
    let shape = sizes.map(|size| size.parse().ok()).collect::<Option<_>>()?;
    let exact = !exact.trim().is_empty();
    Some(Tensor { name: name.to_owned(), shape, exact, values: Vec::new() })
}

impl fmt::Display for Tensors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for tensor in &self.0 {
            let exact = if tensor.exact { " exact" } else { "" };
            writeln!(f, "# {} {:?}{exact}", tensor.name, tensor.shape)?;
            let row = tensor.shape.last().copied().unwrap_or(1).max(1);
            for values in tensor.values.chunks(row) {
                let mut line = String::new();
                for &value in values {
                    write!(line, "{} ", Digits(value))?;
                }
                writeln!(f, "{}", line.trim_end())?;
            }
        }
        Ok(())
    }
}

/// Prints a number with seven significant digits.
struct Digits(f64);

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rounded: f64 = format!("{:.6e}", self.0).parse().unwrap_or(self.0);
        match rounded.abs() {
            size if rounded == 0.0 || (1e-3..1e7).contains(&size) => write!(f, "{rounded}"),
            _ => write!(f, "{rounded:e}"),
        }
    }
}
