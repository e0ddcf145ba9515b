//! Everything that a kernel and the test beside it need: `use muslin::prelude::*`.

pub use bytemuck::{Pod, Zeroable};
pub use glam::{IVec2, IVec3, IVec4, UVec2, UVec3, UVec4, Vec2, Vec3, Vec4};
pub use muslin_macros::{kernel, loops, params};

#[cfg(target_arch = "spirv")]
pub use crate::atomic::AtomicBuffer;
pub use crate::atomic::SumWord;
pub use crate::invocation::Invocation;
pub use crate::lane::{Lane, LaneIndex};
pub use crate::memory::{Packed, Read, ReadFours, Shared, Write, WriteFours};
#[cfg(target_arch = "spirv")]
pub use crate::memory::{ReadBuffer, SharedBuffer, WriteBuffer};
pub use crate::shared_tile::{SharedTile, Source};
#[cfg(not(target_arch = "spirv"))]
pub use crate::workgroup::{SharedMemory, Workgroup};
