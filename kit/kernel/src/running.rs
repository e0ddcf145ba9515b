//! The invocation that a CPU thread runs, for error messages.

extern crate std;

use core::cell::Cell;
use core::fmt;
use core::panic::Location;

use glam::UVec3;

use crate::invocation::Invocation;
pub use crate::phase::storage as storage_phase;

/// An invocation of a kernel.
#[derive(Clone, Copy)]
pub struct RunningInvocation {
    /// Name of the kernel.
    pub kernel: &'static str,
    /// The invocation.
    pub id: Invocation,
    /// Whether the device checks what kernels do.
    pub is_checked: bool,
    /// Whether its workgroup is additional: only a device that checks runs it.
    pub is_additional: bool,
}

std::thread_local! {
    /// The first invocation of the workgroup.
    static WORKGROUP: Cell<Option<RunningInvocation>> = const { Cell::new(None) };
    /// Index of the invocation in it.
    static INVOCATION: Cell<u32> = const { Cell::new(0) };
    /// Number of iterations that its loops may still run.
    static ITERATIONS: Cell<u32> = const { Cell::new(u32::MAX) };
    /// Whether invocations are ending that have not failed: they print nothing.
    static SILENT: Cell<bool> = const { Cell::new(false) };
    /// Where arithmetic that was regrouped first gave something else than what is written.
    static REGROUPED: Cell<Option<&'static Location<'static>>> = const { Cell::new(None) };
}

/// Sets the thread's workgroup by its first invocation; `None` after the dispatch.
#[inline]
pub fn begin(workgroup: Option<RunningInvocation>) {
    WORKGROUP.set(workgroup);
}

/// Sets the thread's invocation in its workgroup. It takes only the index, which costs nothing: storing the whole
/// invocation would cost a tenth of a render.
#[inline(always)]
pub fn enter(invocation: u32) {
    INVOCATION.set(invocation);
}

/// Sets the number of iterations that the invocation's loops may run from now on. In debug builds, `#[kernel]` and
/// `#[loops]` count them.
#[inline(always)]
pub fn allow_iterations(max: u32) {
    ITERATIONS.set(max);
}

/// The number of iterations left.
#[inline(always)]
pub fn iterations_left() -> u32 {
    ITERATIONS.get()
}

/// Counts one iteration.
#[inline(always)]
#[track_caller]
pub fn iterate() {
    let left = ITERATIONS.get();
    if left == 0 {
        too_many_iterations();
    }
    ITERATIONS.set(left - 1);
}

#[cold]
#[inline(never)]
#[track_caller]
fn too_many_iterations() -> ! {
    panic!("the loops take more iterations than the kernel declares with `iterations`");
}

/// Notes the place, if it is the first.
pub(crate) fn note_regrouped(place: &'static Location<'static>) {
    REGROUPED.set(REGROUPED.get().or(Some(place)));
}

/// Takes the place that was noted.
pub fn take_regrouped() -> Option<&'static Location<'static>> {
    REGROUPED.take()
}

/// Sets whether invocations are ending that have not failed.
pub(crate) fn silence(silent: bool) {
    SILENT.set(silent);
}

/// Index of the thread's invocation.
#[inline(always)]
pub fn invocation() -> u32 {
    INVOCATION.get()
}

/// The thread's invocation; `None` outside of a dispatch.
pub fn current() -> Option<RunningInvocation> {
    let mut place = WORKGROUP.get()?;
    place.id.local = unlinear(u64::from(INVOCATION.get()), place.id.size);
    Some(place)
}

/// The position of the element `index` in a box of `size`, such as an invocation in its workgroup or a workgroup in
/// its dispatch. x is the fastest axis.
#[inline]
pub fn unlinear(index: u64, size: UVec3) -> UVec3 {
    let [x, y] = [size.x, size.y].map(u64::from);
    UVec3::new((index % x) as u32, (index / x % y) as u32, (index / x / y) as u32)
}

/// Prints the invocation if a kernel panics outside of a dispatch, as in a unit test that calls it. In debug builds
/// every kernel creates one.
pub struct PanicContext(RunningInvocation);

impl PanicContext {
    /// The context of an invocation, in a kernel with workgroups of `threads`.
    ///
    /// # Panics
    /// If a test calls the kernel with workgroups of another size.
    #[inline(always)]
    pub fn new(kernel: &'static str, id: Invocation, threads: [u32; 3]) -> Self {
        let size = id.size.to_array();
        assert!(
            size == threads,
            "kernel `{kernel}` has workgroups of {threads:?}, and this one has {size:?}"
        );
        Self(RunningInvocation { kernel, id, is_checked: false, is_additional: false })
    }

    /// Prints the invocation.
    pub(crate) fn tell(&self) {
        std::eprintln!("in kernel `{}`, {}", self.0.kernel, self.0);
    }
}

impl Drop for PanicContext {
    fn drop(&mut self) {
        if std::thread::panicking() && WORKGROUP.get().is_none() && !SILENT.get() {
            self.tell();
        }
    }
}

impl fmt::Display for RunningInvocation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Invocation { local, workgroup, .. } = self.id;
        let global = self.id.global();
        write!(f, "invocation {local} of workgroup {workgroup}, {global} in the dispatch")?;
        match self.is_additional {
            true => f.write_str(
                ": this device runs one workgroup more than needed, so is a test of the index missing?",
            ),
            false => Ok(()),
        }
    }
}
