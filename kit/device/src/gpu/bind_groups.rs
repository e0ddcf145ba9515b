//! Bind groups. They are kept while their buffers come back: making one takes longer than recording its dispatch.

use std::collections::HashMap;

use super::memory::SUBMISSIONS;

/// What a bind group is made of: its layout, and each buffer with an offset and a size.
type Key = (wgpu::BindGroupLayout, Vec<(wgpu::Buffer, u64, u64)>);

/// Bind groups, each with the number of the submission of its last use.
#[derive(Debug, Default)]
pub struct BindGroups {
    made: HashMap<Key, (wgpu::BindGroup, u64)>,
    /// Number of submissions so far.
    submissions: u64,
}

impl BindGroups {
    /// The bind group of these buffers, made if there is none.
    pub fn get(&mut self, key: Key, make: impl FnOnce() -> wgpu::BindGroup) -> &wgpu::BindGroup {
        let now = self.submissions;
        let (group, used) = self.made.entry(key).or_insert_with(|| (make(), now));
        *used = now;
        group
    }

    /// Declares that all recorded commands are submitted. Bind groups go no later than the unused memory that they hold.
    pub fn submitted(&mut self) {
        self.submissions += 1;
        let now = self.submissions;
        self.made.retain(|_, (_, used)| now - *used < SUBMISSIONS);
    }

    /// Forgets all bind groups, and so the memory that they hold.
    pub fn clear(&mut self) {
        self.made.clear();
    }
}
