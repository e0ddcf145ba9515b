//! Batches: cut into parts, rendered, recorded, dealt to ranks.

pub mod capacity;
pub mod eye;
pub mod frame;
pub mod plan;
pub mod recording;
pub mod renderer;
pub mod results;
pub mod shard;
