//! The registry of kernels, and everything that the host needs to run one.

extern crate std;

use bytemuck::Pod;
use glam::UVec3;

pub use crate::binding::{CpuBinding, Number, Params, SharedInfo};
pub use crate::casts::{check_cast, check_usize};
pub use crate::fused::{fused, is_far, regrouped};
use crate::invocation::Invocation;
pub use crate::regions::{RegionRuns, RegionsRun};
pub use crate::running::{PanicContext, allow_iterations, enter, iterate};
pub use crate::stop::Scope;

/// The way in which a kernel uses a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// A uniform buffer.
    Uniform,
    /// A storage buffer that is only read.
    Read,
    /// A storage buffer that is read and written.
    Write,
}

impl Access {
    /// Name of the access: `uniform`, `read` or `write`.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Read => "read",
            Self::Write => "write",
        }
    }
}

/// One binding of a kernel. Its number is its index in [`KernelInfo::bindings`], in descriptor set 0.
#[derive(Clone, Copy, Debug)]
pub struct BindingInfo {
    /// Name of the parameter.
    pub name: &'static str,
    /// Use of the buffer.
    pub access: Access,
    /// Type of an element.
    pub element: &'static str,
    /// Size of an element, in bytes.
    pub element_bytes: u32,
    /// Size of what a GPU reads at once: a vector of [`Fours`](crate::memory::Fours), otherwise an element.
    pub device_bytes: u32,
}

/// The bytes of a kernel's parameters.
#[doc(hidden)]
pub fn params_bytes<T: Params>(params: &T) -> &[u8] {
    bytemuck::bytes_of(params)
}

/// Most bytes of workgroup memory in a kernel: every implementation of WebGPU offers these.
pub const MAX_WORKGROUP_BYTES: u32 = 16_384;

/// Most storage buffers of a kernel: every implementation of WebGPU offers these.
pub const MAX_STORAGE_BUFFERS: u32 = 8;

/// Most invocations of a workgroup: every implementation of WebGPU offers these.
pub const MAX_WORKGROUP_INVOCATIONS: u32 = 256;

/// Bytes of all arrays in workgroup memory.
pub const fn workgroup_bytes(shared: &[SharedInfo]) -> u32 {
    let mut bytes = 0;
    let mut i = 0;
    while i < shared.len() {
        // a GPU has words for small integers
        let words = 4 * shared[i].len;
        bytes += if shared[i].bytes < words { words } else { shared[i].bytes };
        i += 1;
    }
    bytes
}

/// One of a kernel's SPIR-V entry points. All have the same body and bindings.
#[derive(Clone, Copy, Debug)]
pub struct EntryPoint {
    /// Name of the entry point, and of its module.
    pub name: &'static str,
    /// Workgroup memory: the kernel's, and in the variant also of its [shared tiles](crate::shared_tile).
    pub shared: &'static [SharedInfo],
    /// Bindings that are [integers of 64 bits](crate::atomic::SumWord), which a device can lack.
    pub sums: &'static [&'static str],
    /// In the variant of a kernel with [tiles](crate::tile), the shape of their products: rows, columns, and products in a sum.
    pub tiles: Option<[u32; 3]>,
}

/// The declaration of a kernel.
pub struct KernelInfo {
    /// Name of the function and of the plain SPIR-V entry point.
    pub name: &'static str,
    /// Package that declares the kernel: two packages can have kernels of the same name.
    pub package: &'static str,
    /// Source file in the compiler's form: relative to the workspace, or to a package from elsewhere.
    pub file: &'static str,
    /// Number of invocations in a workgroup, per axis.
    pub workgroup_size: [u32; 3],
    /// Upper limit for the iterations of all loops of one invocation together; `None` without a loop.
    pub iterations: Option<u32>,
    /// Whether drivers may fuse and regroup its arithmetic.
    pub fused: bool,
    /// Whether it has operations of [subgroups](crate::subgroup).
    pub subgroups: bool,
    /// Whether the CPU runs workgroups with the same z one after another, on one thread.
    pub z_serial: bool,
    /// Whether the CPU runs workgroups with the same x and y one after another.
    pub z_innermost: bool,
    /// Number of items along x that an invocation handles on a GPU.
    pub each: u32,
    /// Bindings, by number.
    pub bindings: &'static [BindingInfo],
    /// Workgroup memory.
    pub shared: &'static [SharedInfo],
    /// The second entry point of a kernel with shared tiles or sums: the variant, in which tiles are in workgroup memory, and sums are
    /// integers of 64 bits.
    pub variant: Option<EntryPoint>,
    /// What a dispatch runs over, if the kernel declares it.
    pub over: Option<OverOf>,
    /// Bindings whose elements come in any order.
    pub unordered: &'static [&'static str],
    /// The CPU execution.
    pub run: CpuRun,
    /// Why the CPU runs it as coroutines, which is slow; `None` if it does not.
    pub coroutines: Option<&'static str>,
    /// The CPU execution of the variant: one invocation, with the workgroup memory of the variant after the bindings.
    ///
    /// # Safety
    /// The same as for [`CpuRun`].
    pub run_variant: Option<InvocationRun>,
    /// One invocation of the plain entry point, with arithmetic that a driver may choose: fused, and regrouped. `None` if that changes nothing,
    /// if the kernel is `fused` anyway, and in release builds.
    ///
    /// # Safety
    /// The same as for [`CpuRun`].
    pub run_arithmetic: [Option<InvocationRun>; 2],
}

impl KernelInfo {
    /// The plain entry point.
    pub const fn plain(&self) -> EntryPoint {
        EntryPoint { name: self.name, shared: self.shared, sums: &[], tiles: None }
    }

    /// The source file with a name that does not depend on the machine: relative to the workspace, or
    /// `package/src/..` if the package comes from elsewhere.
    pub fn source(&self) -> std::string::String {
        let file = self.file.replace('\\', "/");
        match std::path::Path::new(self.file).is_relative() && !file.starts_with("../") {
            true => file,
            false => {
                let begin = file.rfind("/src/").or(file.rfind('/')).unwrap_or(0);
                std::format!("{}{}", self.package, &file[begin..])
            }
        }
    }

    /// All entry points, the plain one first.
    pub fn entry_points(&self) -> impl Iterator<Item = EntryPoint> {
        core::iter::once(self.plain()).chain(self.variant)
    }
}

/// The items that a dispatch runs over, as `over(..)` declares them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Items {
    /// Items for `id.index()`, and workgroups along z.
    Line(u32, u32),
    /// Width, height and depth for `id.global()`.
    Grid([u32; 3]),
}

/// What a kernel runs over: of the parameters' bytes, and of the number of elements of each storage buffer.
pub type OverOf = fn(&[u8], &[u64]) -> Items;

/// The length of a buffer, in an expression of `over(..)`.
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Elements(pub u64);

#[expect(clippy::len_without_is_empty, reason = "it stands for a buffer in expressions of `over`")]
impl Elements {
    /// Number of elements.
    pub fn len(self) -> u32 {
        self.0 as u32
    }
}

/// The function with which the CPU runs a kernel.
///
/// # Safety
/// All functions take the bindings in the order of [`KernelInfo::bindings`], then of [`KernelInfo::shared`].
/// Each contains values of the declared type, with its alignment. Nobody else writes to a written binding meanwhile.
#[derive(Clone, Copy)]
pub enum CpuRun {
    /// Runs a workgroup.
    Workgroup(WorkgroupRun),
    /// Runs one invocation, which may wait at barriers.
    Invocation(InvocationRun),
    /// Runs a workgroup region by region; and one invocation, like `Invocation`.
    Regions(RegionRuns, InvocationRun),
    /// Like `Workgroup`, for each instruction set.
    Lanes(LaneRuns<WorkgroupRun>),
    /// Like `Regions`, for each instruction set: where nothing is watched, and where something is.
    LaneRegions([LaneRuns<RegionsRun>; 2], InvocationRun),
}

impl CpuRun {
    /// The run of one invocation, if invocations wait for each other.
    pub const fn waiting(self) -> Option<InvocationRun> {
        match self {
            Self::Invocation(run) | Self::Regions(_, run) | Self::LaneRegions(_, run) => Some(run),
            Self::Workgroup(_) | Self::Lanes(_) => None,
        }
    }

    /// The run of an instruction set, which must be [available](InstructionSet::is_available).
    #[must_use]
    pub const fn with(self, set: InstructionSet) -> Self {
        match self {
            Self::Lanes(runs) => Self::Workgroup(runs.get(set)),
            Self::LaneRegions([plain, watched], run) => {
                let runs = RegionRuns { plain: plain.get(set), watched: watched.get(set) };
                Self::Regions(runs, run)
            }
            run => run,
        }
    }
}

/// Runs one invocation of a kernel on the CPU, as [`CpuRun`] says.
pub type InvocationRun = unsafe fn(&[CpuBinding], Invocation);

/// Runs a workgroup: bindings, workgroup, workgroups, and the first of its invocations with the end of them, along each axis.
///
/// # Safety
/// The same as for [`CpuRun`]. One of [`LaneRuns`] also needs a CPU that has its instruction set.
pub type WorkgroupRun = unsafe fn(&[CpuBinding], UVec3, UVec3, [UVec3; 2]);

/// A kernel that is generic over [`Lane`](crate::lane::Lane), compiled for each instruction set.
#[derive(Clone, Copy)]
pub struct LaneRuns<R> {
    runs: [R; InstructionSet::ALL.len()],
}

impl<R: Copy> LaneRuns<R> {
    /// The runs, in the order of [`InstructionSet::ALL`].
    pub const fn new(runs: [R; InstructionSet::ALL.len()]) -> Self {
        Self { runs }
    }

    /// The run of an instruction set, which must be [available](InstructionSet::is_available).
    pub const fn get(&self, set: InstructionSet) -> R {
        self.runs[set as usize]
    }
}

/// The instruction set of kernels with lanes on the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InstructionSet {
    /// One lane: for debuggers, and to find races between invocations.
    Scalar,
    /// Eight lanes, with the instructions that the program is compiled for.
    Plain,
    /// AVX2 and FMA: eight lanes.
    Avx2,
    /// AVX-512: sixteen lanes.
    Avx512,
}

impl InstructionSet {
    /// All instruction sets, the best last.
    pub const ALL: [Self; 4] = [Self::Scalar, Self::Plain, Self::Avx2, Self::Avx512];

    /// Name: `scalar`, `plain`, `avx2` or `avx512`.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Plain => "plain",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }

    /// Whether this CPU has the instruction set.
    pub fn is_available(self) -> bool {
        match self {
            Self::Scalar | Self::Plain => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => {
                std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma")
            }
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.is_available()
                    && std::is_x86_feature_detected!("avx512f")
                    && std::is_x86_feature_detected!("avx512vl")
                    && std::is_x86_feature_detected!("avx512dq")
                    && std::is_x86_feature_detected!("avx512bw")
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// The best instruction set of this CPU.
    pub fn best() -> Self {
        let best = Self::ALL.into_iter().rfind(|set| set.is_available());
        best.unwrap_or(Self::Scalar)
    }
}

/// Compiles a function that is generic over lanes for each instruction set. If it is also generic over samples, these are as many
/// [`Vectors`](crate::samples::Vectors) as the registers hold four sums of, and their terms. `$more` is its last generic argument.
#[doc(hidden)]
#[macro_export]
macro_rules! lane_runs {
    ($run:ident $parameters:tt -> $result:ty $(, $vectors:ident)? $(; $more:block)?) => {{
        use $crate::lane::Wide;
        $(use $crate::samples::$vectors;)?
        $crate::kernel::lane_run! {
            scalar $parameters -> $result: $run[Wide<1, false> $(, $vectors<1, false, 1>)? $(, $more)?]
        }
        $crate::kernel::lane_run! {
            plain $parameters -> $result: $run[Wide<8, false> $(, $vectors<8, false, 1>)? $(, $more)?]
        }
        #[cfg(target_arch = "x86_64")]
        $crate::kernel::lane_run! {
            #[target_feature(enable = "avx2,fma")]
            avx2 $parameters -> $result: $run[Wide<8, true> $(, $vectors<8, true, 2>)? $(, $more)?]
        }
        #[cfg(target_arch = "x86_64")]
        $crate::kernel::lane_run! {
            #[target_feature(enable = "avx2,fma,avx512f,avx512vl,avx512dq,avx512bw")]
            avx512 $parameters -> $result: $run[Wide<16, true> $(, $vectors<16, true, 4>)? $(, $more)?]
        }
        #[cfg(target_arch = "x86_64")]
        let runs = $crate::kernel::LaneRuns::new([scalar, plain, avx2, avx512]);
        #[cfg(not(target_arch = "x86_64"))]
        let runs = $crate::kernel::LaneRuns::new([scalar, plain, plain, plain]);
        runs
    }};
}
pub use crate::lane_runs;

/// One function of [`lane_runs`].
#[doc(hidden)]
#[macro_export]
macro_rules! lane_run {
    ($(#[$attribute:meta])* $name:ident($($parameter:ident: $ty:ty),*) -> $result:ty: $run:ident[$($generics:tt)*]) => {
        // SAFETY: called as `CpuRun` says, on a CPU with these features: see `LaneRuns::get`
        $(#[$attribute])*
        unsafe fn $name($($parameter: $ty),*) -> $result {
            // SAFETY: the caller's
            unsafe { $run::<$($generics)*>($($parameter),*) }
        }
    };
}
pub use crate::lane_run;

/// The types of buffers. The host implements it once for all its backends.
pub trait Storage {
    /// A buffer of `T`.
    type Buffer<T: Pod>;
    /// A buffer without its element type.
    type Binding<'a>;
    /// A number of items that only the device may know.
    type Count;
    /// Removes the element type.
    fn bind<T: Pod>(buffer: &Self::Buffer<T>) -> Self::Binding<'_>;
    /// The number, or an upper bound if only the device knows it.
    fn upper_bound(count: &Self::Count) -> u32;
}

/// A kernel with all its bindings, ready to run. `#[kernel]` implements it.
pub trait Dispatch<'a, S: Storage> {
    /// The kernel's declaration.
    fn info(&self) -> &'static KernelInfo;
    /// Bytes of the uniform buffer; empty if the kernel has none.
    fn uniform(&self) -> &[u8];
    /// Visits the storage buffers in order.
    fn bind(&self, visit: &mut dyn FnMut(S::Binding<'a>));
    /// Parameters that only the device may know, with their offset in the uniform buffer, in bytes. The buffer has
    /// their upper bounds.
    fn counts(&self) -> &[(usize, &'a S::Count)] {
        &[]
    }
}

/// A dispatch with parameters that only the device may know. A kernel that declares `counts(..)` has a function
/// `counted`, which makes it.
pub struct Counted<'a, S: Storage, K, const N: usize> {
    kernel: K,
    counts: [(usize, &'a S::Count); N],
}

impl<'a, S: Storage, K, const N: usize> Counted<'a, S, K, N> {
    /// A kernel and its counts, with their offsets in bytes.
    #[doc(hidden)]
    pub const fn new(kernel: K, counts: [(usize, &'a S::Count); N]) -> Self {
        Self { kernel, counts }
    }
}

impl<'a, S: Storage, K: Dispatch<'a, S>, const N: usize> Dispatch<'a, S> for Counted<'a, S, K, N> {
    fn info(&self) -> &'static KernelInfo {
        self.kernel.info()
    }

    fn uniform(&self) -> &[u8] {
        self.kernel.uniform()
    }

    fn bind(&self, visit: &mut dyn FnMut(S::Binding<'a>)) {
        self.kernel.bind(visit);
    }

    fn counts(&self) -> &[(usize, &'a S::Count)] {
        &self.counts
    }
}

/// Every kernel that the program is linked with. `#[kernel]` adds to it.
#[linkme::distributed_slice]
pub static KERNELS: [KernelInfo];

/// Every kernel that the program is linked with, including its dependencies'.
pub fn kernels() -> impl Iterator<Item = &'static KernelInfo> {
    KERNELS.iter()
}

/// The kernels of one package, such as `env!("CARGO_PKG_NAME")`.
pub fn kernels_of(package: &str) -> impl Iterator<Item = &'static KernelInfo> {
    kernels().filter(move |kernel| kernel.package == package)
}
