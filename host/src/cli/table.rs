//! Aligned columns.

use std::fmt;

/// Widest column, in characters: a longer cell pushes the rest of its row aside. The formatter accepts no width above
/// 65,535.
const WIDEST: usize = 200;

/// Rows of text. Columns of numbers are aligned right, those of words left.
#[derive(Debug)]
pub struct Table {
    words: usize,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table whose first `words` columns hold words.
    pub fn new<'a>(words: usize, titles: impl IntoIterator<Item = &'a str>) -> Self {
        Self { words, rows: vec![titles.into_iter().map(str::to_owned).collect()] }
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().collect());
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |column: usize| {
            let cells = self.rows.iter().filter_map(|row| row.get(column));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0).min(WIDEST)
        };
        let widths: Vec<_> = (0..self.rows[0].len()).map(width).collect();
        for row in &self.rows {
            let mut line = String::new();
            for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
                line += if column == 0 { "" } else { "  " };
                line += &if column < self.words {
                    format!("{cell:<width$}")
                } else {
                    format!("{cell:>width$}")
                };
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

/// A number with five significant digits.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    if !(1e-4..1e6).contains(&size) {
        return format!("{value:.4e}");
    }
    let digits = (4 - size.log10().floor() as i32).clamp(0, 8) as usize;
    format!("{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_aligned() {
        let mut table = Table::new(1, ["name", "value"]);
        table.row(["a".into(), "10".into()]);
        table.row(["longer".into(), "5".into()]);
        assert_eq!(table.to_string(), "name    value\na          10\nlonger      5\n");
    }

    #[test]
    fn a_cell_of_any_length_is_written() {
        let mut table = Table::new(1, ["name", "value"]);
        table.row(["a".repeat(70_000), "b".repeat(70_000)]);
        assert_eq!(table.to_string().lines().last().unwrap().len(), 140_002);
    }

    #[test]
    fn numbers_have_five_digits() {
        let cases = [
            (-0.0, "0"),
            (1.0, "1.0000"),
            (-12.345678, "-12.346"),
            (0.00123456, "0.0012346"),
            (123_456.7, "123457"),
            (1.5e-7, "1.5000e-7"),
            (f64::NAN, "NaN"),
        ];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
