//! What a case needs: `use organza_check::prelude::*;`

pub use crate::inputs::{self, Fill, ITEMS, Random, SIZES};
pub use crate::{Bound, KernelRunner, Output, Parity, Result, Rounding, Values, case, unwritten};
pub use organza_kernel::math::TINY;
