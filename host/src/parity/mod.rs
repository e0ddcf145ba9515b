//! Every kernel on a device beside the same kernel on the CPU: one file a stage, as in `shader-crate`.
//!
//! A [`Parity`] case builds its kernel's typed dispatch from inputs that are random, and from those that break
//! careless code; [`Measure`] says how far a device is from the CPU.  [`cases`] lists all of them: a kernel
//! without a case fails a test.

pub mod bench;
mod case;
pub mod color;
pub mod composite;
pub mod dense;
pub mod hash_grid;
pub mod inputs;
mod measure;
pub mod pair;
pub mod project;
mod report;
pub mod scan;
pub mod segment;
pub mod splat;
pub mod tile;
pub mod transmittance;

pub use bench::{Bench, Canary};
pub use case::{Case, Parity, Rounding, missing};
pub use measure::{Bound, Measure, Output, Values, Worst};
pub use report::{Report, Row};

/// The case of every kernel.  A new kernel's goes here.
#[must_use]
pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<project::Project>(),
        Case::of::<tile::TileMask>(),
        Case::of::<tile::TileFill>(),
        Case::of::<tile::TileRange>(),
        Case::of::<pair::PairMask>(),
        Case::of::<pair::PairFill>(),
        Case::of::<scan::ScanBlock>(),
        Case::of::<scan::ScanAdd>(),
        Case::of::<color::ColorInputs>(),
        Case::of::<hash_grid::HashGrid>(),
        Case::of::<dense::Dense>(),
        Case::of::<color::ColorHead>(),
        Case::of::<segment::Segment>(),
        Case::of::<transmittance::TransmittanceInputs>(),
        Case::of::<transmittance::TransmittanceHead>(),
        Case::of::<transmittance::SegmentProduct>(),
        Case::of::<splat::Splat>(),
        Case::of::<composite::Composite>(),
        Case::of::<composite::Resolve>(),
    ]
}
