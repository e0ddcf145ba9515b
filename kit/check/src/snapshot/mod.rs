//! Snapshots of tensors and pictures: how they are recorded and compared, and what a failure writes.

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
