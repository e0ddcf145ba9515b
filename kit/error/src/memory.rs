//! Measures available memory, and allocates without being killed.

use std::cell::Cell;
use std::fs;
use std::path::Path;

use bytemuck::Zeroable;

use crate::{Error, Result};

/// Smaller allocations are made without a check, in bytes.
const SMALL: u64 = 64 << 20;

/// Fails if the system has less than `bytes` left.
///
/// Linux promises more memory than there is, and kills the process that uses it. So a successful allocation proves
/// nothing.
///
/// # Errors
/// [`Error::OutOfMemory`] with both numbers, and the purpose of the memory.
pub fn check(bytes: u64, what: &str) -> Result<()> {
    if bytes < SMALL {
        return Ok(());
    }
    match available() {
        Some(available) if available < bytes => {
            Err(Error::OutOfMemory { needed: bytes, available: Some(available), what: what.into() })
        }
        _ => Ok(()),
    }
}

/// Allocates `len` zeros, or fails with [`Error::OutOfMemory`].
pub fn zeros<T: Zeroable + Clone>(len: usize, what: &str) -> Result<Vec<T>> {
    let mut values = reserve(len, what)?;
    values.resize(len, T::zeroed());
    Ok(values)
}

/// Allocates an empty vector with room for `len` values, or fails with [`Error::OutOfMemory`].
pub fn reserve<T>(len: usize, what: &str) -> Result<Vec<T>> {
    let needed = (len as u64).saturating_mul(size_of::<T>() as u64);
    check(needed, what)?;
    let mut values = Vec::new();
    asking(|| values.try_reserve_exact(len)).map_err(|_| Error::OutOfMemory {
        needed,
        available: available(),
        what: what.into(),
    })?;
    Ok(values)
}

thread_local! {
    /// Whether this thread is making an allocation whose failure it can handle.
    static ASKING: Cell<bool> = const { Cell::new(false) };
}

/// Runs an allocation that may fail. The caller turns the failure into an error.
#[doc(hidden)]
pub fn asking<T>(allocate: impl FnOnce() -> T) -> T {
    let before = ASKING.replace(true);
    let result = allocate();
    ASKING.set(before);
    result
}

/// Whether the current allocation of this thread may fail. A program's allocator can ask. If it may not, the
/// allocator should end the program with a message.
#[doc(hidden)]
#[must_use]
pub fn may_fail() -> bool {
    ASKING.try_with(Cell::get).unwrap_or(false)
}

/// Bytes that this process can still allocate, if the system says so.
pub fn available() -> Option<u64> {
    [free_in_system(), free_in_address_space(), free_in_control_groups()]
        .into_iter()
        .flatten()
        .min()
}

/// Peak memory of this process, in bytes, if the system says so (Linux).
#[must_use]
pub fn peak() -> Option<u64> {
    kilobytes("/proc/self/status", "VmHWM:")
}

fn free_in_system() -> Option<u64> {
    kilobytes("/proc/meminfo", "MemAvailable:")
}

/// The rest under `ulimit -v`, in bytes.
fn free_in_address_space() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/limits").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: u64 = line.split_whitespace().next()?.parse().ok()?;
    Some(limit.saturating_sub(kilobytes("/proc/self/status", "VmSize:")?))
}

/// The rest under the tightest limit of a container or a service, in bytes.
fn free_in_control_groups() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    free_in_groups(&groups, Path::new("/sys/fs/cgroup"))
}

/// Control groups of version 2 are in one tree. In version 1, memory has a tree of its own, and other names.
fn free_in_groups(groups: &str, root: &Path) -> Option<u64> {
    let second = groups.lines().filter_map(|line| {
        let path = line.strip_prefix("0::/")?;
        Some((path, root.to_owned(), ["memory.max", "memory.current", "file "]))
    });
    let first = groups.lines().filter_map(|line| {
        let (kinds, path) = line.split_once(':')?.1.split_once(":/")?;
        let is_memory = kinds.split(',').any(|kind| kind == "memory");
        let names = ["memory.limit_in_bytes", "memory.usage_in_bytes", "total_cache "];
        is_memory.then(|| (path, root.join("memory"), names))
    });
    let number = |path: &Path| fs::read_to_string(path).ok()?.trim().parse::<u64>().ok();
    let left = |group: &Path, [limit, used, cache]: [&str; 3]| {
        let limit = number(&group.join(limit))?;
        // The page cache counts as used, but the system drops it before it refuses memory.
        let stat = fs::read_to_string(group.join("memory.stat")).ok()?;
        let cache = stat.lines().find_map(|line| line.strip_prefix(cache))?.parse().ok()?;
        let used = number(&group.join(used))?.saturating_sub(cache);
        Some(limit.saturating_sub(used))
    };
    let lefts = first.chain(second).flat_map(|(path, root, names)| {
        // A container sees its own group as the root.
        Path::new(path).ancestors().filter_map(move |group| left(&root.join(group), names))
    });
    lefts.min()
}

/// The number after a label, in the format of files in `/proc`.
fn kilobytes(path: &str, label: &str) -> Option<u64> {
    let text = fs::read_to_string(path).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(label))?;
    let number: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(number * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_are_zeros() {
        assert_eq!(zeros::<[f32; 3]>(2, "").unwrap(), [[0.0; 3]; 2]);
        assert!(zeros::<f32>(0, "").unwrap().is_empty());
    }

    #[test]
    fn too_much_is_an_error_that_says_how_much() {
        let error = zeros::<[f32; 4]>(1 << 56, "the test").unwrap_err();
        assert!(matches!(error, Error::OutOfMemory { needed: 0x1000_0000_0000_0000, .. }));
        assert!(zeros::<u64>(usize::MAX, "the test").is_err());
    }

    #[test]
    fn the_tightest_control_group_of_either_version_counts() {
        let root = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let path = root.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        let groups = "12:cpu,cpuacct:/docker/a\n5:memory:/docker/a\n0::/docker/a\n";
        assert_eq!(free_in_groups(groups, root.path()), None);
        // The path is the host's: in a container, the root is its group.
        write("memory/memory.limit_in_bytes", "5000\n");
        write("memory/memory.usage_in_bytes", "3000\n");
        write("memory/memory.stat", "cache 1\nrss 9\ntotal_cache 400\n");
        assert_eq!(free_in_groups(groups, root.path()), Some(2400));
        write("docker/a/memory.max", "900\n");
        write("docker/a/memory.current", "300\n");
        write("docker/a/memory.stat", "anon 250\nfile 50\n");
        write("memory.max", "max\n");
        assert_eq!(free_in_groups(groups, root.path()), Some(650));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn linux_reports_available_memory() {
        let available = available().unwrap();
        assert!((1 << 20..1 << 50).contains(&available), "{available}");
        check(available / 2, "").unwrap();
        assert!(check(u64::MAX, "").is_err());
    }
}
