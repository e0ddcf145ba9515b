//! The test case of every kernel: one file per stage, with the names of `shader-crate`.
//!
//! A case implements [`Parity`](muslin_check::Parity): it dispatches its kernel with random inputs and with inputs that break careless
//! code. [`Measure`](muslin_check::Measure) says how far a device is from the CPU. [`cases`] lists all cases: a kernel without
//! one fails a test.

mod adam;
mod binned;
mod channels;
mod color;
mod color_backward;
mod composite;
mod composite_backward;
mod count;
mod dense;
mod dense_backward;
mod distortion;
pub mod exact;
mod exposure;
mod hash_grid;
mod hash_grid_backward;
mod hash_grid_half;
mod hash_grid_scale;
mod loss;
mod occupancy;
mod pair;
mod peak;
mod pixels;
mod pose_backward;
pub mod project;
pub mod project_backward;
mod resolve;
mod scan;
pub mod segment;
mod splat;
mod ssim;
mod statistics;
mod target;
pub mod tile;
mod tile_cells;
mod transmittance;
mod transmittance_backward;

use muslin_check::Case;

/// The case of every kernel. Add a new kernel's here.
pub fn cases() -> Vec<Case> {
    vec![
        Case::new::<project::Project>(),
        Case::new::<tile::TileMask>(),
        Case::new::<tile::TileFill>(),
        Case::new::<tile::TileRange>(),
        Case::new::<count::RecordTotal>(),
        Case::new::<count::ClearOnOverflow>(),
        Case::new::<count::CountFill>(),
        Case::new::<pair::PairMask>(),
        Case::new::<pair::PairFill>(),
        Case::new::<scan::ScanBlock>(),
        Case::new::<scan::ScanAdd>(),
        Case::new::<color::ColorInputs>(),
        Case::new::<hash_grid::HashGrid>(),
        Case::new::<hash_grid_half::HashGridHalf>(),
        Case::new::<dense::Dense>(),
        Case::new::<color::ColorHead>(),
        Case::new::<occupancy::OccupancyAdd>(),
        Case::new::<occupancy::Occupancy>(),
        Case::new::<segment::Segment>(),
        Case::new::<transmittance::TransmittanceInputs>(),
        Case::new::<transmittance::TransmittanceHead>(),
        Case::new::<transmittance::SegmentProduct>(),
        Case::new::<channels::PairChannels>(),
        Case::new::<splat::Splat>(),
        Case::new::<tile_cells::TileCells>(),
        Case::new::<composite::Composite>(),
        Case::new::<resolve::Resolve>(),
        Case::new::<pixels::Pixels>(),
        Case::new::<target::TargetTiles>(),
        Case::new::<exposure::Expose>(),
        Case::new::<loss::LossTerms>(),
        Case::new::<ssim::SsimRows>(),
        Case::new::<ssim::SsimColumns>(),
        Case::new::<ssim::SsimRowsBackward>(),
        Case::new::<loss::LossRows>(),
        Case::new::<loss::LossGradient>(),
        Case::new::<exposure::ExposeBackward>(),
        Case::new::<distortion::PairInverseDistance>(),
        Case::new::<distortion::DistortionBackward>(),
        Case::new::<adam::Adam>(),
        Case::new::<hash_grid_scale::HashGridPeak>(),
        Case::new::<hash_grid_scale::HashGridNorm>(),
        Case::new::<hash_grid_scale::HashGridScale>(),
        Case::new::<hash_grid_backward::HashGridBackward>(),
        Case::new::<hash_grid_backward::HashGridGradient>(),
        Case::new::<dense_backward::DenseBackward>(),
        Case::new::<dense_backward::DenseWeightBackward>(),
        Case::new::<binned::BinnedGradient>(),
        Case::new::<color_backward::ColorHeadBackward>(),
        Case::new::<color_backward::MaterialBackward>(),
        Case::new::<transmittance_backward::SegmentProductBackward>(),
        Case::new::<transmittance_backward::TransmittanceHeadBackward>(),
        Case::new::<transmittance_backward::ExtraBackward>(),
        Case::new::<pair::PairSum>(),
        Case::new::<resolve::ResolveBackward>(),
        Case::new::<composite_backward::CompositeBackward>(),
        Case::new::<splat::SplatBackward>(),
        Case::new::<project_backward::ProjectBackward>(),
        Case::new::<pose_backward::PoseBackward>(),
        Case::new::<statistics::Statistics>(),
        Case::new::<peak::PeakMultiplyAdd>(),
        Case::new::<peak::PeakRead>(),
    ]
}
