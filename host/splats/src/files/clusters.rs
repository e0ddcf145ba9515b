//! Replaces many values by a few: vector quantization by repeated halving.

use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Values of D numbers, put into clusters.
pub struct Clusters<const D: usize> {
    /// The mean of each cluster.
    pub centers: Vec<[f32; D]>,
    /// The cluster of each value.
    pub labels: Vec<u32>,
}

/// A cluster while it may still be split.
struct Cell<const D: usize> {
    /// The cluster's part of the sorted indices.
    begin: usize,
    end: usize,
    mean: [f64; D],
    /// The axis of the largest variance.
    axis: usize,
    /// Sum of the squared distances from the mean.
    error: f64,
}

impl<const D: usize> Cell<D> {
    fn new(values: &[[f32; D]], indices: &[u32], begin: usize, end: usize) -> Self {
        let part = &indices[begin..end];
        let count = part.len() as f64;
        let mut mean = [0.0; D];
        for &index in part {
            let value = &values[index as usize];
            mean.iter_mut().zip(value).for_each(|(mean, &value)| *mean += f64::from(value));
        }
        mean.iter_mut().for_each(|mean| *mean /= count);
        let mut squares = [0.0; D];
        for &index in part {
            for (axis, square) in squares.iter_mut().enumerate() {
                *square += (f64::from(values[index as usize][axis]) - mean[axis]).powi(2);
            }
        }
        let axis = (0..D).max_by(|&a, &b| squares[a].total_cmp(&squares[b])).unwrap_or(0);
        // equal values have no error, even if their mean is rounded
        let first = &values[part[0] as usize];
        let is_one_value = part.iter().all(|&index| values[index as usize] == *first);
        let error = if is_one_value { 0.0 } else { squares.iter().sum() };
        Self { begin, end, mean, axis, error }
    }

    /// The cell with its key: the last of all is the one to split. Errors are at least 0, so their bits have their order.
    fn keyed(self) -> ((u64, Reverse<usize>), Self) {
        ((self.error.to_bits(), Reverse(self.begin)), self)
    }
}

/// Puts values into at most `max` clusters, 1 or more. The cluster with the largest sum of squares is halved at its mean,
/// across the axis of the largest variance, until there are enough. Equal values are always in one cluster.
pub fn clusters<const D: usize>(values: &[[f32; D]], max: usize) -> Clusters<D> {
    let mut indices: Vec<u32> = (0..values.len() as u32).collect();
    let mut cells: BTreeMap<_, Cell<D>> = BTreeMap::new();
    if !values.is_empty() {
        cells.extend([Cell::new(values, &indices, 0, values.len()).keyed()]);
    }
    while cells.len() < max && cells.last_key_value().is_some_and(|(_, cell)| cell.error > 0.0) {
        let (_, cell) = cells.pop_last().expect("there is one");
        let middle = cell.mean[cell.axis];
        let part = &mut indices[cell.begin..cell.end];
        let is_low = |index: &u32| f64::from(values[*index as usize][cell.axis]) <= middle;
        part.sort_by_key(|index| !is_low(index));
        let split = cell.begin + part.partition_point(is_low);
        if split == cell.end {
            cells.extend([Cell { error: 0.0, ..cell }.keyed()]);
            continue;
        }
        let halves = [(cell.begin, split), (split, cell.end)];
        cells.extend(halves.map(|(begin, end)| Cell::new(values, &indices, begin, end).keyed()));
    }
    let mut cells: Vec<_> = cells.into_values().collect();
    cells.sort_by_key(|cell| cell.begin);
    let mut labels = vec![0; values.len()];
    for (label, cell) in cells.iter().enumerate() {
        indices[cell.begin..cell.end].iter().for_each(|&at| labels[at as usize] = label as u32);
    }
    let centers = cells.iter().map(|cell| cell.mean.map(|mean| mean as f32)).collect();
    Clusters { centers, labels }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_values_are_kept() {
        let values = [[3.0, 1.0], [0.1, 1.0], [3.0, 1.0], [0.1, -2.0]];
        let Clusters { centers, labels } = clusters(&values, 8);
        assert_eq!(centers.len(), 3);
        for (value, label) in values.iter().zip(&labels) {
            assert_eq!(*value, centers[*label as usize]);
        }
        assert!(clusters::<2>(&[], 8).centers.is_empty());
    }

    /// Uniform values in n equal parts have the mean squared error `(1 / n)^2 / 12`, which is the least there is.
    #[test]
    fn the_error_is_near_the_least() {
        let values: Vec<_> = (0..64_000).map(|at| [(at as f32 + 0.5) / 64_000.0]).collect();
        let Clusters { centers, labels } = clusters(&values, 256);
        assert_eq!(centers.len(), 256);
        assert!(centers.is_sorted_by(|a, b| a[0] < b[0]), "one axis is in order");
        let squares = values.iter().zip(&labels).map(|(value, &label)| {
            (f64::from(value[0]) - f64::from(centers[label as usize][0])).powi(2)
        });
        let mean = squares.sum::<f64>() / 64_000.0;
        let min = (1.0_f64 / 256.0).powi(2) / 12.0;
        assert!((0.99..1.05).contains(&(mean / min)), "{}", mean / min);
    }
}
