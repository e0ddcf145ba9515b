//! `report.html`: one page about a run, which opens offline.
//!
//! A [`Reporter`] listens to a run, and keeps its page. A page is made only from the files in the run's folder. It contains everything it shows: pictures in base64, and
//! the numbers of the curves as JSON, which uPlot draws. A content security policy forbids every request, and every
//! script but the page's own. Without scripts the page shows everything but the curves.

mod charts;
mod page;
mod pictures;
mod reporter;
mod run;
mod single;
mod split;
#[cfg(test)]
mod tests;

pub use reporter::Reporter;
pub use run::{Difference, Run, Summary, differences};
pub use single::write_report;
pub use split::write_split_report;

/// uPlot, which draws the curves.
pub const UPLOT_SCRIPT: &str = include_str!("assets/uPlot.iife.min.js");
/// The style of uPlot.
pub const UPLOT_STYLE: &str = include_str!("assets/uPlot.min.css");

/// Number of views that a report shows; others are left out.
pub const MAX_VIEWS: usize = 8;
