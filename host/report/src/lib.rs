//! `report.html`: one page about a run, which opens offline, and a page that compares runs.
//!
//! A [`Reporter`] listens to a run, and keeps its page. A page is made only from the files in the runs' folders. It contains everything it shows: pictures in base64, and
//! the numbers of the curves as JSON, which uPlot draws. A content security policy forbids every request, and every
//! script but the page's own. Without scripts the page shows everything but the curves.

mod charts;
mod comparison;
mod page;
mod pictures;
mod reporter;
mod run;
mod single;
#[cfg(test)]
mod tests;

pub use comparison::{Difference, differences, write_comparison};
pub use reporter::Reporter;
pub use run::{Run, Summary};
pub use single::write_report;

/// uPlot, which draws the curves of every page.
pub const UPLOT_SCRIPT: &str = include_str!("assets/uPlot.iife.min.js");
/// The style of uPlot.
pub const UPLOT_STYLE: &str = include_str!("assets/uPlot.min.css");

/// Number of views that a report shows; others are left out.
pub const MAX_VIEWS: usize = 8;
