//! Everything that a case needs: `use muslin_check::prelude::*;`

pub use crate::inputs::{self, Fill, ITEMS, Random, SIZES};
pub use crate::number::{Dual, Number, Rounded, gradient, listed};
pub use crate::{KernelRunner, Output, Parity, Result, case, unwritten};
pub use muslin_kernel::given::Inputs;
pub use muslin_kernel::math::TINY;
