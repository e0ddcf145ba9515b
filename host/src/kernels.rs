//! The compiled kernels that this program carries: SPIR-V modules, as `cargo xtask kernels` made them.

use std::borrow::Cow;
use std::sync::LazyLock;

use organza_kernels::{EntryPoint, KernelInfo};
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

/// What a module's code consists of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct CodeSize {
    /// Instructions of functions, without labels and what else computes nothing.
    pub instructions: u32,
    /// Loops.
    pub loops: u32,
}

impl CodeSize {
    /// Counts in a module: each instruction begins with its length and its number.
    #[must_use]
    pub fn of(spirv: &[u32]) -> Self {
        const HEADER: usize = 5;
        const FUNCTION: u32 = 54;
        const FUNCTION_END: u32 = 56;
        const LOOP_MERGE: u32 = 246;
        // line, no line, parameter, variable, selection merge, label
        const SILENT: [u32; 6] = [8, 317, 55, 59, 247, 248];
        let (mut size, mut at, mut inside) = (Self::default(), HEADER, false);
        while let Some(word) = spirv.get(at) {
            match word & 0xffff {
                FUNCTION => inside = true,
                FUNCTION_END => inside = false,
                LOOP_MERGE => size.loops += 1,
                number => size.instructions += u32::from(inside && !SILENT.contains(&number)),
            }
            at += (word >> 16).max(1) as usize;
        }
        size
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

/// The compiled form of a kernel's entry point, which must expect of the host what the sources declare: a driver
/// trusts the bindings it is given.
///
/// # Errors
/// [`Error::StaleKernels`] when the kernel was not compiled since its declaration changed.
pub fn of(kernel: &KernelInfo, point: &EntryPoint) -> Result<EmbeddedKernel> {
    let embedded = find(point.name)?;
    if embedded.entry.interface != Interface::of(kernel, point) {
        return Err(stale(format!("the declaration of `{}` has changed", point.name)));
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
    fn code_is_counted_in_functions_alone() {
        let word = |number: u32, length: u32| length << 16 | number;
        // a constant; a function with a label, a loop's merge and branch, a return
        let module = [
            &[0x0723_0203, 0x10500, 0, 9, 0][..],
            &[word(43, 4), 1, 2, 246],
            &[word(54, 5), 1, 3, 0, 4],
            &[word(248, 2), 5],
            &[word(246, 4), 6, 7, 0],
            &[word(249, 2), 5],
            &[word(253, 1)],
            &[word(56, 1)],
        ]
        .concat();
        assert_eq!(CodeSize::of(&module), CodeSize { instructions: 2, loops: 1 });
    }

    #[test]
    fn an_unknown_kernel_is_stale() {
        let error = find("no such kernel").unwrap_err();
        assert!(error.to_string().contains("`no such kernel`"), "{error}");
    }
}
