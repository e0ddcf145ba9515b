//! The addition theorem: what holds for spherical harmonics whatever their table or recurrence.

/// `P_l(x)` for l = 0..=degree.
fn legendre(degree: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for l in 2..=degree.max(1) {
        let k = l as f64;
        values.push(((2.0 * k - 1.0) * x * values[l - 1] - (k - 1.0) * values[l - 2]) / k);
    }
    values.truncate(degree + 1);
    values
}

/// Holds `sh [N, (degree + 1)^2]` of N directions to `sum_m Y_lm(a) Y_lm(b) = (2l + 1) / 4 pi P_l(a . b)`, for each band
/// and each two directions, and band 1 to its signs.
pub fn check(sh: &[f32], directions: &[[f64; 3]], degree: usize) {
    let width = (degree + 1) * (degree + 1);
    assert_eq!(sh.len(), directions.len() * width);
    let row = |i: usize| &sh[i * width..][..width];
    for (i, a) in directions.iter().enumerate() {
        for (j, b) in directions.iter().enumerate() {
            let cosine = a.iter().zip(b).map(|(a, b)| a * b).sum();
            for (l, polynomial) in legendre(degree, cosine).into_iter().enumerate() {
                let band = l * l..(l + 1) * (l + 1);
                let products = row(i)[band.clone()].iter().zip(&row(j)[band]);
                let sum: f64 = products.map(|(&a, &b)| f64::from(a) * f64::from(b)).sum();
                let exact = (2 * l + 1) as f64 / (4.0 * std::f64::consts::PI) * polynomial;
                assert!((sum - exact).abs() < 1e-5, "band {l} of {i} and {j}: {sum} for {exact}");
            }
        }
        let constant = (0.25 / std::f64::consts::PI).sqrt();
        assert!((f64::from(row(i)[0]) - constant).abs() < 6e-8, "band 0 is {}", row(i)[0]);
        if degree > 0 {
            let k = (3.0 / (4.0 * std::f64::consts::PI)).sqrt();
            for (found, exact) in row(i)[1..4].iter().zip([-k * a[1], k * a[2], -k * a[0]]) {
                assert!(
                    (f64::from(*found) - exact).abs() < 1e-6,
                    "band 1 of {i}: {found} for {exact}"
                );
            }
        }
    }
}
