//! Where a run finds its data set after it has moved.

use std::fs;
use std::path::{Path, PathBuf, absolute};

/// The folder in a run for a data set that is made first.
pub const CAPTURED: &str = "data";

/// The way from a run's folder to its data set. `None` if there is none, or if its name is not UTF-8.
pub(super) fn way(folder: &Path, data: &Path) -> Option<String> {
    // what is a link in the folder stays one
    let inside = absolute(data).ok()?.strip_prefix(absolute(folder).ok()?).map(Path::to_owned);
    let way = inside.or_else(|_| {
        let [from, to] = [fs::canonicalize(folder)?, fs::canonicalize(data)?];
        let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
        let up = from.iter().skip(common).map(|_| "..".as_ref());
        Ok::<PathBuf, std::io::Error>(up.chain(to.iter().skip(common)).collect())
    });
    way.ok()?.to_str().map(str::to_owned)
}

/// Finds the data set: in the run's folder if it was there, also where the old one is there still; or on the same way from it, if
/// both have moved. Otherwise it stays at its old place.
pub(super) fn find(data: &mut Option<PathBuf>, folder: &Path, way: Option<&str>) {
    let found = data.as_ref().and_then(|old| moved(old, folder, way));
    *data = found.or_else(|| data.take());
}

fn moved(old: &Path, folder: &Path, way: Option<&str>) -> Option<PathBuf> {
    // without a way, only what a run makes itself is known
    let way = way.map(Path::new).or_else(|| old.ends_with(CAPTURED).then(|| CAPTURED.as_ref()))?;
    let is_inside = !way.starts_with("..");
    let found = fs::canonicalize(folder.join(way)).ok()?;
    match fs::canonicalize(old) {
        Ok(old) if old == found || !is_inside => None,
        _ => Some(found),
    }
}
