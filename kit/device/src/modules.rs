//! The compiled kernels of a program: SPIR-V modules, as the kernel builder wrote them.

use std::borrow::Cow;
use std::sync::OnceLock;

use muslin_kernel::{EntryPoint, KernelInfo};
use muslin_manifest::{Interface, KernelEntry, Manifest};

use crate::{Error, Result};

/// Bytes aligned to four, so that they can be read as words.
#[derive(Debug)]
#[repr(C, align(4))]
pub struct Aligned<T: ?Sized>(pub T);

/// Name of an entry point, and its module.
type Module = (&'static str, &'static Aligned<[u8]>);

/// The compiled kernels of a program, by entry point; [`modules`](crate::modules!) embeds them.
#[derive(Debug)]
pub struct Modules {
    /// Text of the manifest.
    json: &'static str,
    table: &'static [Module],
    manifest: OnceLock<Manifest>,
}

/// Embeds the modules that the build script has found: see `muslin_manifest::embed`.
///
/// ```ignore
/// static MODULES: muslin_device::Modules = muslin_device::modules!();
/// ```
#[macro_export]
macro_rules! modules {
    () => {
        $crate::Modules::new(include_str!(concat!(env!("OUT_DIR"), "/manifest.json")), {
            use $crate::Aligned;
            static TABLE: &[(&str, &Aligned<[u8]>)] =
                &include!(concat!(env!("OUT_DIR"), "/kernels.rs"));
            TABLE
        })
    };
}

/// A compiled kernel.
#[derive(Clone, Copy, Debug)]
pub struct CompiledKernel {
    entry: &'static KernelEntry,
    spirv: &'static [u8],
}

impl CompiledKernel {
    /// The kernel's entry in the manifest.
    #[must_use]
    pub fn entry(&self) -> &'static KernelEntry {
        self.entry
    }

    /// The bytes of the module's file.
    #[must_use]
    pub fn spirv(&self) -> &'static [u8] {
        self.spirv
    }

    /// The module in WGSL, for browsers.
    ///
    /// # Errors
    /// [`Error::StaleKernels`] if it needs what browsers do not have, as most variants do.
    #[cfg(feature = "wgsl")]
    pub fn to_wgsl(&self) -> Result<String> {
        muslin_manifest::to_wgsl(self.spirv).map_err(|error| {
            let reason = format!("`{}` is not for browsers: {error}", self.entry.name);
            Error::StaleKernels { reason }
        })
    }

    /// The module as SPIR-V words.
    #[must_use]
    pub fn spirv_words(&self) -> Cow<'static, [u32]> {
        match bytemuck::try_cast_slice(self.spirv) {
            Ok(words) => Cow::Borrowed(words),
            _ => {
                let (words, _) = self.spirv.as_chunks();
                Cow::Owned(words.iter().map(|word| u32::from_le_bytes(*word)).collect())
            }
        }
    }
}

impl Modules {
    /// No modules: the CPU needs none.
    #[must_use]
    pub fn none() -> &'static Self {
        static NONE: Modules = Modules::new("", &[]);
        &NONE
    }

    /// Modules by entry point, and the text of their manifest.
    #[doc(hidden)]
    #[must_use]
    pub const fn new(json: &'static str, table: &'static [Module]) -> Self {
        Self { json, table, manifest: OnceLock::new() }
    }

    /// The manifest that was embedded; without kernels, if there was none.
    pub fn manifest(&'static self) -> &'static Manifest {
        self.manifest.get_or_init(|| match self.json {
            "" => Manifest::empty(),
            json => Manifest::parse(json).expect("the build script wrote the manifest"),
        })
    }

    /// All compiled kernels, sorted by name.
    pub fn all(&'static self) -> impl Iterator<Item = CompiledKernel> {
        self.table.iter().map(|module| self.compiled(module))
    }

    fn compiled(&'static self, (name, spirv): &'static Module) -> CompiledKernel {
        let entry = self.manifest().find(name).expect("the manifest names what is embedded");
        CompiledKernel { entry, spirv: &spirv.0 }
    }

    /// The compiled kernel named `name`.
    ///
    /// # Errors
    /// [`Error::StaleKernels`] if the kernel has not been compiled yet.
    pub fn find(&'static self, name: &str) -> Result<CompiledKernel> {
        let module = self.table.iter().find(|(found, ..)| *found == name);
        let missing = || Error::StaleKernels { reason: format!("`{name}` is not among them") };
        let module = module.ok_or_else(missing)?;
        Ok(self.compiled(module))
    }

    /// The compiled form of a kernel's entry point. It must match the declaration in the sources, because a driver
    /// trusts its bindings.
    ///
    /// # Errors
    /// [`Error::StaleKernels`] if the kernel has not been compiled since its declaration changed.
    pub fn compiled_kernel(
        &'static self,
        kernel: &KernelInfo,
        point: &EntryPoint,
    ) -> Result<CompiledKernel> {
        let compiled = self.find(point.name)?;
        if compiled.entry.package != kernel.package {
            let package = kernel.package;
            let other = &compiled.entry.package;
            let reason =
                format!("`{}` of {package} is not among them, only the one of {other}", point.name);
            return Err(Error::StaleKernels { reason });
        }
        if compiled.entry.interface != Interface::new(kernel, point) {
            let reason = format!("the declaration of `{}` has changed", point.name);
            return Err(Error::StaleKernels { reason });
        }
        Ok(compiled)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_unknown_kernel_is_stale() {
        let error = Modules::none().find("no such kernel").unwrap_err();
        assert!(error.to_string().contains("`no such kernel`"), "{error}");
    }
}
