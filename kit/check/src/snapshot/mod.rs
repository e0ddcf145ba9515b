//! Snapshots of tensors and pictures: what is recorded, how two records are compared, and what a failure leaves behind.

pub mod compare;
pub mod picture;
pub mod report;
pub mod tensors;

#[cfg(test)]
mod tests;
