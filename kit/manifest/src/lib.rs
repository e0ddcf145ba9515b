//! The manifest of compiled kernels: the SPIR-V module of each kernel, the interface between kernel and host, and the
//! sources and the compiler of the modules.
//!
//! The kernel builder writes it, a build script [embeds](embed()) it, and tests compare it with the kernel sources.
//! Nothing in it depends on the machine that wrote it.

mod source;
mod table;
#[cfg(feature = "wgsl")]
mod wgsl;

use std::fs;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

pub use source::{STALE, embed, embed_compiled, locked_version, source_hash};
pub use table::{Table, grouped};
#[cfg(feature = "wgsl")]
pub use wgsl::to_wgsl;

/// Version of the manifest's layout that this crate reads and writes.
pub const FORMAT_VERSION: u32 = 4;

/// Name of the manifest's file, in the folder of the modules.
pub const FILE_NAME: &str = "manifest.json";

/// Errors about a manifest or about the sources that it describes.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A file could not be read.
    #[error("cannot read {}: {reason}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's error.
        reason: std::io::Error,
    },
    /// The text is not a manifest.
    #[error("the kernel manifest is malformed: {0}")]
    Malformed(serde_json::Error),
    /// The manifest's layout has a version that this crate does not know.
    #[error("the kernel manifest has format {0}, this crate reads format {FORMAT_VERSION}")]
    UnknownFormat(u32),
    /// The lock file lacks a package that the kernels are compiled with.
    #[error("{} does not name the package `{package}`", path.display())]
    NotLocked {
        /// The lock file.
        path: PathBuf,
        /// The missing package.
        package: String,
    },
}

/// Everything known about the compiled kernels.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// Always [`FORMAT_VERSION`].
    pub format_version: u32,
    /// Folders of the sources that the modules were compiled from, relative to the workspace.
    pub sources: Vec<String>,
    /// [`source_hash`] of those sources.
    pub source_hash: String,
    /// The compiler that compiled them.
    pub compiler: Compiler,
    /// The kernels, sorted by name.
    pub kernels: Vec<KernelEntry>,
    /// Whether the sources have changed since. Only the build script knows: see [`embed`].
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_stale: bool,
}

/// The compiler that made the modules.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Compiler {
    /// Version of Rust-GPU.
    pub rust_gpu: String,
    /// Version of the rustc with Rust-GPU's backend.
    pub rustc: String,
    /// The SPIR-V target.
    pub target: String,
}

/// One compiled kernel.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct KernelEntry {
    /// Name of the SPIR-V entry point: the kernel's, or its variant's.
    pub name: String,
    /// Package that declares the kernel.
    pub package: String,
    /// Rust source that declares it: relative to the workspace, or `package/src/..` if the package comes from
    /// elsewhere.
    pub file: String,
    /// Name of the module's file, in the manifest's folder.
    pub spirv: String,
    /// Length of the module, in bytes.
    pub spirv_bytes: u64,
    /// SHA-256 of the module, in lower-case hexadecimal.
    pub spirv_sha256: String,
    /// The interface between the kernel and the host.
    #[serde(flatten)]
    pub interface: Interface,
}

/// The interface between a kernel and the host that dispatches it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Interface {
    /// Number of invocations in one workgroup, along x, y and z.
    pub workgroup_size: [u32; 3],
    /// Number of items along x per invocation.
    pub each: u32,
    /// Buffers, all in descriptor set 0. A buffer's index is its binding number.
    pub bindings: Vec<Binding>,
    /// Arrays in workgroup memory.
    pub shared: Vec<Shared>,
    /// Whether it has operations of subgroups, which a device or a browser can lack.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub subgroups: bool,
    /// Bindings that are 64-bit integers, which a device can lack; to the host, these are two elements.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sums: Vec<String>,
    /// The shape of its products of cooperative matrices, which a device can lack.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tiles: Option<[u32; 3]>,
}

/// One buffer of a kernel.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Binding {
    /// Name of the kernel's parameter.
    pub name: String,
    /// Use of the buffer: `uniform`, `read` or `write`.
    pub access: String,
    /// Rust type of an element.
    pub element: String,
    /// Size of an element, in bytes.
    pub element_bytes: u32,
}

/// An array of a kernel in workgroup memory.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shared {
    /// Name of the kernel's parameter.
    pub name: String,
    /// Rust type of an element.
    pub element: String,
    /// Number of elements.
    pub len: u32,
    /// Size of the whole array, in bytes.
    pub bytes: u32,
}

impl Manifest {
    /// A manifest of these kernels, given in any order.
    pub fn new(
        sources: Vec<String>,
        source_hash: String,
        compiler: Compiler,
        mut kernels: Vec<KernelEntry>,
    ) -> Self {
        kernels.sort_by(|a, b| a.name.cmp(&b.name));
        Self {
            format_version: FORMAT_VERSION,
            sources,
            source_hash,
            compiler,
            kernels,
            is_stale: false,
        }
    }

    /// A manifest without kernels, as in a checkout whose kernels have not been compiled.
    pub fn empty() -> Self {
        Self::new(Vec::new(), String::new(), Compiler::default(), Vec::new())
    }

    /// Reads a manifest from its text.
    pub fn parse(json: &str) -> Result<Self, Error> {
        /// The only field that every format has.
        #[derive(Deserialize)]
        struct Head {
            format_version: u32,
        }
        let head: Head = serde_json::from_str(json).map_err(Error::Malformed)?;
        if head.format_version != FORMAT_VERSION {
            return Err(Error::UnknownFormat(head.format_version));
        }
        serde_json::from_str(json).map_err(Error::Malformed)
    }

    /// Reads the manifest file in a folder of compiled kernels.
    pub fn load(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(FILE_NAME);
        let json = fs::read_to_string(&path).map_err(|reason| Error::Read { path, reason })?;
        Self::parse(&json)
    }

    /// The manifest's text. It has the same bytes on every machine.
    pub fn to_json(&self) -> String {
        let json = serde_json::to_string_pretty(self);
        // Serialization only fails on maps with odd keys and on failing writers, and there are none.
        json.expect("a manifest is made of strings and numbers") + "\n"
    }

    /// The entry of one kernel.
    pub fn find(&self, name: &str) -> Option<&KernelEntry> {
        self.kernels.iter().find(|kernel| kernel.name == name)
    }
}

#[cfg(feature = "kernels")]
impl Interface {
    /// The interface that a kernel's source declares, for one of its entry points.
    pub fn new(kernel: &muslin_kernel::KernelInfo, point: &muslin_kernel::EntryPoint) -> Self {
        let binding = |binding: &muslin_kernel::BindingInfo| Binding {
            name: binding.name.to_owned(),
            access: binding.access.as_str().to_owned(),
            element: binding.element.to_owned(),
            element_bytes: binding.element_bytes,
        };
        let shared = |shared: &muslin_kernel::SharedInfo| Shared {
            name: shared.name.to_owned(),
            element: shared.element.to_owned(),
            len: shared.len,
            bytes: shared.bytes,
        };
        Self {
            workgroup_size: kernel.workgroup_size,
            each: kernel.each,
            bindings: kernel.bindings.iter().map(binding).collect(),
            shared: point.shared.iter().map(shared).collect(),
            subgroups: kernel.subgroups,
            sums: point.sums.iter().map(|&name| name.to_owned()).collect(),
            tiles: point.tiles,
        }
    }
}

/// The SHA-256 of some bytes, in lower-case hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    format!("{:x}", Sha256::digest(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(name: &str) -> KernelEntry {
        KernelEntry {
            name: name.into(),
            package: "kernels".into(),
            file: format!("shader-crate/src/{name}.rs"),
            spirv: format!("{name}.spv"),
            spirv_bytes: 4,
            spirv_sha256: sha256(b"test"),
            interface: Interface {
                workgroup_size: [64, 1, 1],
                each: 1,
                bindings: vec![Binding {
                    name: "data".into(),
                    access: "write".into(),
                    element: "f32".into(),
                    element_bytes: 4,
                }],
                shared: Vec::new(),
                subgroups: false,
                sums: Vec::new(),
                tiles: None,
            },
        }
    }

    #[test]
    fn text_is_sorted_and_survives_a_round_trip() {
        let manifest = Manifest::new(
            Vec::new(),
            "hash".into(),
            Compiler::default(),
            vec![entry("b"), entry("a")],
        );
        let json = manifest.to_json();
        assert!(json.ends_with("}\n"));
        assert!(json.find("\"a\"").unwrap() < json.find("\"b\"").unwrap());
        assert_eq!(Manifest::parse(&json).unwrap(), manifest);
        assert_eq!(manifest.find("b").unwrap(), &entry("b"));
    }

    #[test]
    fn other_formats_are_refused() {
        let error = Manifest::parse("{\"format_version\": 99}").unwrap_err();
        assert!(matches!(error, Error::UnknownFormat(99)));
        assert!(matches!(Manifest::parse("{").unwrap_err(), Error::Malformed(_)));
    }

    #[test]
    fn hash_is_the_published_one() {
        let want = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";
        assert_eq!(sha256(b"test"), want);
    }
}
