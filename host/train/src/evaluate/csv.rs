//! Writes scores as CSV, with a row for each view.

use std::io;
use std::path::Path;

use super::{Score, ViewScore};
use organza_core::error::Result;
use organza_core::write_atomic;

/// Writes the scores of views, atomically: `view,psnr,ssim,lpips,psnr_fitted`, after `step` if rows have one. The
/// last two columns are left out if no view has them. An infinite PSNR is `inf`; a missing score is empty.
pub(crate) fn save_csv(path: impl AsRef<Path>, rows: &[(Option<u64>, &ViewScore)]) -> Result<()> {
    let has = |value: fn(&Score) -> Option<f64>| {
        rows.iter().any(|(_, view)| value(&view.score).is_some())
    };
    let is_shown = [
        rows.iter().any(|(step, _)| step.is_some()),
        true,
        true,
        true,
        has(|score| score.lpips),
        has(|score| score.psnr_fitted),
    ];
    let shown = |cells: [String; 6]| {
        cells.into_iter().zip(is_shown).filter_map(|(cell, is_shown)| is_shown.then_some(cell))
    };
    write_atomic(path, |writer| {
        let mut table = ::csv::Writer::from_writer(writer);
        let head = ["step", "view", "psnr", "ssim", "lpips", "psnr_fitted"].map(str::to_owned);
        table.write_record(shown(head)).map_err(io::Error::other)?;
        for (step, ViewScore { name, score }) in rows {
            let step = step.map_or(String::new(), |step| step.to_string());
            let [psnr, ssim] = [score.psnr, score.ssim].map(number);
            let [lpips, fitted] = [score.lpips, score.psnr_fitted].map(number);
            let row = shown([step, name.clone(), psnr, ssim, lpips, fitted]);
            table.write_record(row).map_err(io::Error::other)?;
        }
        table.flush()
    })
}

/// A number, or an empty cell for `None`.
fn number(value: Option<f64>) -> String {
    value.map_or(String::new(), |value| value.to_string())
}
