//! Snapshots of tensors and pictures: recording, comparison, and the output of a failure.

mod accept;
pub mod compare;
pub mod picture;
pub mod report;
pub mod tensors;

pub use accept::Snapshots;
#[doc(hidden)]
pub use insta;

#[cfg(test)]
mod tests;
