//! Snapshots of tensors and pictures: how they are recorded and compared, and what a failure writes.

pub mod compare;
pub mod picture;
pub mod report;
pub mod tensors;

#[cfg(test)]
mod tests;
