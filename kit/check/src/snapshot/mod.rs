//! Snapshots of tensors and pictures.

mod accept;
pub mod compare;
pub mod picture;
pub mod tensors;

pub use accept::Snapshots;
#[doc(hidden)]
pub use insta;

#[cfg(test)]
mod tests;
