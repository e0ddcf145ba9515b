//! One way through a batch: it is cut into parts, which go through the stages and back.

pub mod compare;
pub mod own_loss;
pub mod part;
#[allow(clippy::module_inception, reason = "the way itself")]
pub mod pass;
pub mod ranks;
pub mod recording;
pub mod renderer;
