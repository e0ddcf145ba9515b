//! The kernels together: the results of scenes on every device.

mod batch;
mod channels;
mod demo;
mod edges;
mod extremes;
mod eye;
mod failures;
mod loss;
mod properties;
mod reference_cases;
mod reproducible;
mod snapshots;
mod steadiness;
mod together;
