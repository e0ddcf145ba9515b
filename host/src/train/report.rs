//! `report.html`: a run on one page that opens offline, and a page that compares runs.
//!
//! A page is made from the files of the runs' folders alone. It holds everything it shows: pictures in base64, and the
//! numbers of the curves as JSON, which uPlot draws. A content security policy forbids every request, and every script
//! but the page's own. Without scripts the page shows everything but the curves.

mod charts;
mod comparison;
mod page;
mod pictures;
mod run;
mod single;
#[cfg(test)]
mod tests;

pub use comparison::{Difference, differences, write_comparison};
pub use pictures::PICTURES;
pub(super) use pictures::Pictures;
pub(crate) use pictures::{ERROR_FACTOR, error_levels};
pub use run::{Run, Summary};
pub use single::write_report;

/// Views that a report shows; further ones are left out.
pub const MAX_VIEWS: usize = 8;
