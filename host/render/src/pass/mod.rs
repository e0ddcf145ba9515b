//! One way through a batch: it is cut into parts, which go through the stages and back.

pub mod capacity;
pub mod compare;
pub mod field_sums;
pub mod in_parts;
pub mod own_loss;
pub mod part;
pub mod ranks;
pub mod recording;
pub mod recording_backward;
pub mod renderer;
pub mod results;
pub mod shard;
pub mod step;
