//! The test case of every kernel: one file per stage, with the names of `shader-crate`.
//!
//! A case implements [`Parity`](muslin_check::Parity): it dispatches its kernel with random inputs and with inputs that break careless
//! code. [`Measure`](muslin_check::Measure) says how far a device is from the CPU. [`cases`] lists all cases: a kernel without
//! one fails a test.

pub mod adam;
pub mod binned;
pub mod channels;
pub mod color;
pub mod color_backward;
pub mod composite;
pub mod composite_backward;
pub mod count;
pub mod dense;
pub mod dense_backward;
pub mod distortion;
pub mod elementary;
pub mod exact;
pub mod exposure;
pub mod hash_grid;
pub mod hash_grid_backward;
pub mod hash_grid_half;
pub mod hash_grid_scale;
pub mod loss;
pub mod pair;
pub mod peak;
pub mod pose_backward;
pub mod project;
pub mod project_backward;
pub mod resolve;
pub mod scan;
pub mod segment;
pub mod splat;
pub mod ssim;
pub mod statistics;
pub mod tile;
pub mod tile_cells;
pub mod transmittance;
pub mod transmittance_backward;
#[cfg(test)]
mod transpose;

use muslin_check::Case;

/// The case of every kernel. Add a new kernel's here.
pub fn cases() -> Vec<Case> {
    vec![
        Case::of::<project::Project>(),
        Case::of::<tile::TileMask>(),
        Case::of::<tile::TileFill>(),
        Case::of::<tile::TileRange>(),
        Case::of::<count::RecordTotal>(),
        Case::of::<count::ClearOnOverflow>(),
        Case::of::<count::CountFill>(),
        Case::of::<pair::PairMask>(),
        Case::of::<pair::PairFill>(),
        Case::of::<scan::ScanBlock>(),
        Case::of::<scan::ScanAdd>(),
        Case::of::<color::ColorInputs>(),
        Case::of::<hash_grid::HashGrid>(),
        Case::of::<hash_grid_half::HashGridHalf>(),
        Case::of::<dense::Dense>(),
        Case::of::<color::ColorHead>(),
        Case::of::<segment::Segment>(),
        Case::of::<transmittance::TransmittanceInputs>(),
        Case::of::<transmittance::TransmittanceHead>(),
        Case::of::<transmittance::SegmentProduct>(),
        Case::of::<channels::PairChannels>(),
        Case::of::<splat::Splat>(),
        Case::of::<tile_cells::TileCells>(),
        Case::of::<composite::Composite>(),
        Case::of::<resolve::Resolve>(),
        Case::of::<exposure::Expose>(),
        Case::of::<loss::LossTerms>(),
        Case::of::<ssim::SsimRows>(),
        Case::of::<ssim::SsimColumns>(),
        Case::of::<ssim::SsimRowsBackward>(),
        Case::of::<loss::LossRows>(),
        Case::of::<loss::LossGradient>(),
        Case::of::<exposure::ExposeBackward>(),
        Case::of::<distortion::PairInverseDistance>(),
        Case::of::<distortion::DistortionBackward>(),
        Case::of::<adam::Adam>(),
        Case::of::<hash_grid_scale::HashGridPeak>(),
        Case::of::<hash_grid_scale::HashGridNorm>(),
        Case::of::<hash_grid_scale::HashGridScale>(),
        Case::of::<hash_grid_backward::HashGridBackward>(),
        Case::of::<hash_grid_backward::HashGridGradient>(),
        Case::of::<dense_backward::DenseBackward>(),
        Case::of::<dense_backward::DenseWeightBackward>(),
        Case::of::<binned::BinnedGradient>(),
        Case::of::<color_backward::ColorHeadBackward>(),
        Case::of::<color_backward::MaterialBackward>(),
        Case::of::<transmittance_backward::SegmentProductBackward>(),
        Case::of::<transmittance_backward::TransmittanceHeadBackward>(),
        Case::of::<transmittance_backward::ExtraBackward>(),
        Case::of::<pair::PairSum>(),
        Case::of::<resolve::ResolveBackward>(),
        Case::of::<composite_backward::CompositeBackward>(),
        Case::of::<splat::SplatBackward>(),
        Case::of::<project_backward::ProjectBackward>(),
        Case::of::<pose_backward::PoseBackward>(),
        Case::of::<statistics::Statistics>(),
        Case::of::<peak::PeakMultiplyAdd>(),
        Case::of::<peak::PeakRead>(),
        Case::of::<elementary::Elementary>(),
    ]
}
