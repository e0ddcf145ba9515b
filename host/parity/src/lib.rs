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
pub mod core_functions;
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
pub mod language;
pub mod loss;
pub mod pair;
pub mod peak;
pub mod pixels;
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
        Case::new::<elementary::Elementary>(),
        Case::new::<language::ByteHistogram>(),
        Case::new::<language::SortRows>(),
        Case::new::<language::KeepPositive>(),
        Case::new::<language::AsWritten>(),
        Case::new::<language::Compared>(),
        Case::new::<language::Signed>(),
        Case::new::<core_functions::CoreFunctions>(),
    ]
}
