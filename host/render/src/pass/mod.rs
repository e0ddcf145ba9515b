//! Runs the stages over a batch, in parts that fit into memory: forward and backward.

pub mod batch;
pub mod blend;
pub mod capacity;
pub mod loss_gradient;
pub mod output;
pub mod part;
pub mod render;
pub mod renderer;
pub mod tape;
