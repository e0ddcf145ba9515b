//! Scores as CSV, a row for each view.

use std::io;
use std::path::Path;

use super::{Score, ViewScore};
use crate::atomic_file::write_atomic;
use crate::error::Result;

/// Writes the scores of views, atomically: `view,psnr,ssim,lpips`, after `step` where rows have one. LPIPS is left out
/// where no view has it. An infinite PSNR is `inf`; a score that a view does not have is empty.
pub(crate) fn save_csv(path: impl AsRef<Path>, rows: &[(Option<u64>, &ViewScore)]) -> Result<()> {
    let has_steps = rows.iter().any(|(step, _)| step.is_some());
    let has_lpips = rows.iter().any(|(_, view)| view.score.lpips.is_some());
    let cells = |step: String, view: &str, psnr: String, ssim: String, lpips: String| {
        let cells = [(has_steps, step), (true, view.to_owned()), (true, psnr), (true, ssim)];
        let cells = cells.into_iter().chain([(has_lpips, lpips)]);
        cells.filter_map(|(is_shown, cell)| is_shown.then_some(cell)).collect::<Vec<_>>()
    };
    let number = |value: Option<f64>| value.map_or(String::new(), |value| value.to_string());
    write_atomic(path, |writer| {
        let mut table = ::csv::Writer::from_writer(writer);
        let head = ["step", "psnr", "ssim", "lpips"].map(str::to_owned);
        let [step, psnr, ssim, lpips] = head;
        table.write_record(cells(step, "view", psnr, ssim, lpips)).map_err(io::Error::other)?;
        for (step, ViewScore { name, score: Score { psnr, ssim, lpips } }) in rows {
            let step = step.map_or(String::new(), |step| step.to_string());
            let row = cells(step, name, number(*psnr), number(*ssim), number(*lpips));
            table.write_record(row).map_err(io::Error::other)?;
        }
        table.flush()
    })
}
