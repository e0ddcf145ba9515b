//! The compiled kernels that this program carries: SPIR-V modules, as `cargo xtask kernels` made them.

use std::borrow::Cow;
use std::sync::LazyLock;

use organza_kernels::KernelInfo;
use organza_manifest::{Interface, KernelEntry, Manifest};

use crate::error::{Error, Result};

/// Bytes that begin at a multiple of four, so that they can be read as words.
#[repr(C, align(4))]
struct Aligned<T: ?Sized>(T);

/// The modules by kernel name. The build script leaves out those that were not compiled yet.
static MODULES: &[(&str, &Aligned<[u8]>)] = &include!(concat!(env!("OUT_DIR"), "/kernels.rs"));

static MANIFEST: LazyLock<Manifest> = LazyLock::new(|| {
    let json = include_str!(concat!(env!("OUT_DIR"), "/manifest.json"));
    Manifest::parse(json).expect("the build script wrote the manifest")
});

static KERNELS: LazyLock<Vec<EmbeddedKernel>> = LazyLock::new(|| {
    let embedded = |(name, spirv): &(&str, &'static Aligned<[u8]>)| EmbeddedKernel {
        entry: MANIFEST.find(name).expect("the build script embeds what the manifest names"),
        spirv: &spirv.0,
    };
    MODULES.iter().map(embedded).collect()
});

/// A compiled kernel.
#[derive(Clone, Copy, Debug)]
pub struct EmbeddedKernel {
    entry: &'static KernelEntry,
    spirv: &'static [u8],
}

impl EmbeddedKernel {
    /// What the manifest says about the kernel.
    pub fn entry(&self) -> &'static KernelEntry {
        self.entry
    }

    /// The module as it lies in the file.
    pub fn spirv(&self) -> &'static [u8] {
        self.spirv
    }

    /// The module as the words that SPIR-V is made of.
    pub fn spirv_words(&self) -> Cow<'static, [u32]> {
        match bytemuck::try_cast_slice(self.spirv) {
            Ok(words) if cfg!(target_endian = "little") => Cow::Borrowed(words),
            _ => {
                let (words, _) = self.spirv.as_chunks();
                Cow::Owned(words.iter().map(|word| u32::from_le_bytes(*word)).collect())
            }
        }
    }
}

/// The manifest that the program was compiled with; without kernels, if there was none.
pub fn manifest() -> &'static Manifest {
    &MANIFEST
}

/// All compiled kernels, sorted by name.
pub fn all() -> &'static [EmbeddedKernel] {
    &KERNELS
}

/// The compiled kernel of a name.
///
/// # Errors
/// [`Error::StaleKernels`] when the kernel was not compiled yet.
pub fn find(name: &str) -> Result<EmbeddedKernel> {
    let kernel = KERNELS.iter().find(|kernel| kernel.entry.name == name);
    kernel.copied().ok_or_else(|| stale(format!("`{name}` is not among them")))
}

/// The compiled form of a kernel, which must expect of the host what the sources declare: a driver
/// trusts the bindings it is given.
///
/// # Errors
/// [`Error::StaleKernels`] when the kernel was not compiled since its declaration changed.
pub fn of(kernel: &KernelInfo) -> Result<EmbeddedKernel> {
    let embedded = find(kernel.name)?;
    if embedded.entry.interface != Interface::of(kernel) {
        return Err(stale(format!("the declaration of `{}` has changed", kernel.name)));
    }
    Ok(embedded)
}

fn stale(reason: String) -> Error {
    Error::StaleKernels { reason }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_begin_with_the_magic_word() {
        for kernel in all() {
            let words = kernel.spirv_words();
            assert_eq!(words[0], 0x0723_0203, "{}", kernel.entry.name);
            assert_eq!(words.len() * 4, kernel.spirv.len());
            assert!(matches!(words, Cow::Borrowed(_)) || cfg!(target_endian = "big"));
        }
    }

    #[test]
    fn an_unknown_kernel_is_stale() {
        let error = find("no such kernel").unwrap_err();
        assert!(error.to_string().contains("`no such kernel`"), "{error}");
    }
}
