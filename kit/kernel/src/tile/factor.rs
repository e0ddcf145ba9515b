//! The elements of factors.

/// An element of a left factor: a half.
#[derive(Clone, Copy, Default)]
pub struct Left(#[allow(dead_code)] pub(super) f32);

/// An element of a right factor: a half.
#[derive(Clone, Copy, Default)]
pub struct Right(#[allow(dead_code)] pub(super) f32);
