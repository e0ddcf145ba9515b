//! Keeps photographs in memory or, if they do not fit, in a temporary file.

use std::fs::File;
use std::io::Write;
use std::marker::PhantomData;
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::{env, slice};

use bytemuck::NoUninit;
use memmap2::{Mmap, MmapOptions};
use serde::{Deserialize, Serialize};

use organza_core::error::{Error, Result, invalid};
use organza_core::memory;

/// The storage for photographs while they are used. Their bits do not depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// In memory if they take at most three quarters of the free memory, otherwise on disk.
    #[default]
    Auto,
    /// In memory. It is an error if they do not fit.
    Memory,
    /// In a temporary file without a name, which disappears with the program. The system reads parts on demand, and
    /// caches as much as memory allows.
    Disk,
}

/// Largest part of the free memory that photographs may take before they go to disk: training needs some, too.
const PART: f64 = 0.75;

impl Keep {
    /// Whether photographs of this many bytes are kept on disk.
    pub(super) fn is_on_disk(self, bytes: u64, available: Option<u64>) -> bool {
        match self {
            Self::Auto => available.is_some_and(|free| bytes as f64 > PART * free as f64),
            Self::Memory => false,
            Self::Disk => true,
        }
    }

    /// Creates the storage for photographs of this many bytes; `None` for memory.
    ///
    /// # Errors
    /// [`DeviceError::OutOfMemory`](organza_core::error::DeviceError::OutOfMemory) if they must be in memory and do not fit;
    /// [`Error::WriteFile`].
    pub(super) fn store(self, bytes: u64) -> Result<Option<Store>> {
        if self.is_on_disk(bytes, memory::available()) {
            return Store::new().map(Some);
        }
        let hint = "the photographs (a larger downscale makes them smaller; `data.keep` can keep them on disk)";
        memory::check(bytes, hint)?;
        Ok(None)
    }
}

/// A temporary file for photographs.
#[derive(Debug)]
pub(super) struct Store {
    folder: PathBuf,
    /// The file and its length.
    file: Mutex<(File, u64)>,
}

/// Alignment of a mapped part of the file: at least the page size of any known system.
const PAGE: u64 = 1 << 16;

impl Store {
    /// Creates an empty file in the folder that `TMPDIR` names, or else in `/var/tmp`: `/tmp` may be memory.
    fn new() -> Result<Self> {
        let lasting = Path::new("/var/tmp");
        let chosen = env::var_os("TMPDIR").filter(|folder| !folder.is_empty());
        let usual = if lasting.is_dir() { lasting.to_owned() } else { env::temp_dir() };
        Self::within(chosen.map_or(usual, PathBuf::from))
    }

    fn within(folder: PathBuf) -> Result<Self> {
        let file = tempfile::tempfile_in(&folder).or_else(|error| {
            let why = error.kind();
            let reason = format!(
                "no temporary file can be made there ({why}); let `TMPDIR` name another folder"
            );
            invalid(&folder, reason)
        })?;
        Ok(Self { folder, file: Mutex::new((file, 0)) })
    }

    /// The folder of the file.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Moves values to the file.
    ///
    /// # Errors
    /// [`Error::WriteFile`], for example if the disk is full.
    pub fn keep<T: NoUninit>(&self, values: &[T]) -> Result<Kept<T>> {
        let bytes: &[u8] = bytemuck::cast_slice(values);
        let mut guard = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        let (file, length) = &mut *guard;
        let begin = *length;
        let padding = bytes.len().next_multiple_of(PAGE as usize) - bytes.len();
        let mut write = || -> std::io::Result<Mmap> {
            file.write_all(bytes)?;
            file.write_all(&vec![0; padding])?;
            // SAFETY: the file has no name, so no other program opens it. This one writes only after the parts that
            // it has mapped.
            unsafe { MmapOptions::new().offset(begin).len(bytes.len()).map(&*file) }
        };
        let map = write().map_err(|source| Error::write(&self.folder, source))?;
        *length = begin + (bytes.len() + padding) as u64;
        Ok(Kept::Disk { map: Arc::new(map), values: PhantomData })
    }
}

/// Values that do not change, in memory or on disk.
#[derive(Clone, Debug)]
pub(super) enum Kept<T> {
    Memory(Vec<T>),
    /// In a store: [`Store::keep`] has written a slice of T.
    Disk {
        map: Arc<Mmap>,
        values: PhantomData<T>,
    },
}

impl<T: NoUninit> Kept<T> {
    /// Moves the values to a store.
    ///
    /// # Errors
    /// The same errors as [`Store::keep`].
    pub fn moved(self, store: &Store) -> Result<Self> {
        match &self {
            Self::Memory(values) if !values.is_empty() => store.keep(values),
            _ => Ok(self),
        }
    }
}

impl<T> Deref for Kept<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        match self {
            Self::Memory(values) => values,
            Self::Disk { map, .. } => {
                let len = map.len() / size_of::<T>();
                // SAFETY: `Store::keep` has written a slice of T, and nothing writes to these bytes anymore. A map
                // starts at the start of a page, which is aligned for every T.
                unsafe { slice::from_raw_parts(map.as_ptr().cast(), len) }
            }
        }
    }
}

impl<T: PartialEq> PartialEq for Kept<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T: Eq> Eq for Kept<T> {}

impl<T> From<Vec<T>> for Kept<T> {
    fn from(values: Vec<T>) -> Self {
        Self::Memory(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_on_disk_equal_values_in_memory() {
        let store = Store::new().unwrap();
        let colors: Kept<[u8; 3]> =
            (0..70_000_u32).map(|i| [i as u8, (i >> 8) as u8, 7]).collect::<Vec<_>>().into();
        let valid: Kept<bool> = (0..1000).map(|i| i % 3 == 0).collect::<Vec<_>>().into();
        let [on_disk, again] = [(); 2].map(|()| colors.clone().moved(&store).unwrap());
        let valid_on_disk = valid.clone().moved(&store).unwrap();
        assert!(matches!((&on_disk, &valid_on_disk), (Kept::Disk { .. }, Kept::Disk { .. })));
        assert!(on_disk == colors && again == colors && valid_on_disk == valid);
        drop(store);
        assert_eq!(on_disk.clone()[69_999], [111, 17, 7]);
        assert!(again != Kept::from(vec![[0; 3]; 70_000]));
    }

    #[test]
    fn a_folder_that_takes_no_files_is_the_variable_s() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        std::fs::write(&file, "").unwrap();
        Store::within(folder.path().to_owned()).unwrap();
        for bad in [file, folder.path().join("absent")] {
            let error = Store::within(bad.clone()).unwrap_err().to_string();
            let facts = [&*bad.to_string_lossy(), "let `TMPDIR` name another folder"];
            assert!(facts.iter().all(|fact| error.contains(fact)), "{error}");
        }
    }

    #[test]
    fn auto_leaves_training_a_quarter_of_memory() {
        for (keep, bytes, free, expected) in [
            (Keep::Auto, 75, Some(100), false),
            (Keep::Auto, 76, Some(100), true),
            (Keep::Auto, u64::MAX, None, false),
            (Keep::Memory, 200, Some(100), false),
            (Keep::Disk, 1, Some(100), true),
        ] {
            assert_eq!(keep.is_on_disk(bytes, free), expected, "{keep:?}, {bytes} of {free:?}");
        }
    }
}
