//! A kernel's buffers as a case gives them: in the host's memory.

use muslin_device::{Buffer, Host};
use muslin_kernel::KernelInfo;
use muslin_kernel::given::Given;
use muslin_kernel::kernel::{Access, BindingInfo, Dispatch, Storage};

use super::measure::{Output, Values};
use super::runner::Canary;

/// The contents of a kernel's storage buffers.
pub(super) fn contents<'a>(
    kernel: &impl Dispatch<'a, Given>,
) -> Vec<(&'static BindingInfo, &'a [u8])> {
    let mut given = Vec::new();
    kernel.bind(&mut |bytes| given.push(bytes));
    let bindings = kernel.info().bindings.iter();
    bindings.filter(|binding| binding.access != Access::Uniform).zip(given).collect()
}

/// The type of a binding's elements, without its path.
fn element(binding: &BindingInfo) -> &str {
    binding.element.rsplit(':').next().unwrap_or_default().trim()
}

/// Whether a binding has numbers that may differ by rounding.
fn is_float(binding: &BindingInfo) -> bool {
    ["f32", "Vec2", "Vec4"].contains(&element(binding))
}

/// A word that no kernel computes, and another one.
pub(super) fn canaries(binding: &BindingInfo) -> [u32; 2] {
    match is_float(binding) {
        true => [f32::CANARY.to_bits(), f32::OTHER_CANARY.to_bits()],
        false => [u32::CANARY, u32::OTHER_CANARY],
    }
}

/// The outputs of a kernel, by the names of their bindings.
pub(super) fn output(binding: &BindingInfo, words: Vec<u32>) -> Output {
    let float = |word| f64::from(f32::from_bits(word));
    let values = match element(binding) {
        _ if is_float(binding) => Values::Float(words.into_iter().map(float).collect()),
        "i32" | "IVec2" | "IVec4" => {
            Values::Signed(words.into_iter().map(u32::cast_signed).collect())
        }
        _ => Values::Exact(words),
    };
    Output { name: binding.name, values }
}

/// A kernel with buffers of a device.
pub(super) struct Uploaded<'a> {
    pub info: &'static KernelInfo,
    pub uniform: &'a [u8],
    pub buffers: &'a [Buffer<u8>],
}

impl<'a> Dispatch<'a, Host> for Uploaded<'a> {
    fn info(&self) -> &'static KernelInfo {
        self.info
    }

    fn uniform(&self) -> &[u8] {
        self.uniform
    }

    fn bind(&self, visit: &mut dyn FnMut(<Host as Storage>::Binding<'a>)) {
        self.buffers.iter().for_each(|buffer| visit(Host::bind(buffer)));
    }
}
