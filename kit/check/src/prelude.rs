//! Everything that a case needs: `use muslin_check::prelude::*;`

pub use crate::inputs::{self, Fill, ITEMS, Random, SIZES};
pub use crate::{Bound, KernelRunner, Output, Parity, Result, Rounding, Values, case, unwritten};
pub use muslin_kernel::math::TINY;
