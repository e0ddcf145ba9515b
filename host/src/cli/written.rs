//! Keeps track of the images that earlier calls wrote to a folder, so that no image of another scene stays beside the
//! new ones.
//!
//! A hidden file in the folder, [`NAME`], lists each image that the program wrote. It has two SHA-256 sums: of the
//! image's content, and of its inputs. At the end of a call, images with other inputs are removed, unless the call
//! has written them again. Nothing else is ever removed: no unlisted file, and no file whose content has changed
//! since.
//!
//! The list is also saved while a call writes. So a film that was stopped, or even killed, continues where it was.
//!
//! Calls that write different shards to one folder at the same time have a list each, beside [`NAME`]. The next call
//! without a shard merges them into its own.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;
use std::fs::{self, File};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, Instant};

use organza::{Error, Result};
use organza_core::write_inside;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::console::Console;
use super::output::Folder;
use super::refuse;
use super::summary::count;

/// Name of the list.
const NAME: &str = ".organza-files.json";
/// Prefix and suffix of the names of shards' lists.
const SHARD: [&str; 2] = [".organza-files.shard-", ".json"];
/// Largest list, in bytes. No list needs as much; a larger file was not written by this program.
const MAX_BYTES: u64 = 64 << 20;
/// Interval between saves of the list.
const INTERVAL: Duration = Duration::from_secs(1);

/// The list during a call.
#[derive(Debug)]
pub struct Written {
    folder: PathBuf,
    source: String,
    /// See [`Written::with_options`].
    options: String,
    /// Name of this call's list.
    list: String,
    files: BTreeMap<String, Entry>,
    /// Lists of calls that may be running now: the file of each, and its entries.
    others: Vec<(PathBuf, BTreeMap<String, Entry>)>,
    /// Names that this call has written.
    now: BTreeSet<String>,
    saved: Instant,
}

/// The file under the name of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    Nothing,
    /// The image itself: an earlier call wrote it for the same scene and cameras.
    Image,
    /// An earlier call wrote it for another scene or other cameras, or was killed while writing it.
    Stale,
    /// No call has written it, or somebody has changed it.
    Foreign,
}

/// An image in the list.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Entry {
    /// SHA-256 of the file; empty until the file has been written.
    content: String,
    /// SHA-256 of the scene's file and of all cameras.
    source: String,
    /// See [`Written::with_options`].
    #[serde(default, skip_serializing_if = "String::is_empty")]
    options: String,
}

impl Written {
    /// Reads the list of a folder; a damaged one counts as empty. `scene` is the scene's file. `cameras` are all
    /// cameras of the file or data set, with everything else that images depend on. So a call that renders some views
    /// does not make the others stale.
    pub fn open(folder: &Folder, scene: &Path, cameras: &dyn Debug) -> Result<Self> {
        Self::open_shard(folder, scene, cameras, None)
    }

    /// Like [`Written::open`], but for a shard of the views: its index and the number of shards.
    pub fn open_shard(
        folder: &Folder,
        scene: &Path,
        cameras: &dyn Debug,
        shard: Option<[usize; 2]>,
    ) -> Result<Self> {
        let mut hash = Sha256::new();
        copy(scene, &mut hash).map_err(|source| Error::read(scene, source))?;
        hash.update(format!("{cameras:?}"));
        let source = hex(hash);
        let [begin, end] = SHARD;
        let list = shard.map(|[index, of]| format!("{begin}{index}-of-{of}{end}"));
        let list = list.unwrap_or_else(|| NAME.to_owned());
        let files = read(&folder.join(&list)).unwrap_or_default();
        let others = other_lists(folder.path(), &list);
        let others = others.into_iter().filter_map(|path| Some((path.clone(), read(&path)?)));
        let others = others.collect();
        let options = String::new();
        let folder = folder.path().to_owned();
        let now = BTreeSet::new();
        let saved = Instant::now();
        Ok(Self { folder, source, options, list, files, others, now, saved })
    }

    /// Sets what images depend on besides the scene and the cameras. An image with other options is not
    /// [`Found::Image`], but it is not removed for this reason.
    pub fn with_options(mut self, options: &dyn Debug) -> Self {
        self.options = format!("{options:?}");
        self
    }

    /// Indices of those `files` that do not exist yet. A file of somebody else in their place is kept, and is an
    /// error.
    pub fn missing<'a>(
        &self,
        files: impl IntoIterator<Item = &'a [PathBuf]>,
    ) -> Result<Vec<usize>> {
        let mut missing = Vec::new();
        for (index, files) in files.into_iter().enumerate() {
            for file in files {
                match self.found(file)? {
                    Found::Image => continue,
                    Found::Nothing | Found::Stale if missing.last() == Some(&index) => {}
                    Found::Nothing | Found::Stale => missing.push(index),
                    Found::Foreign => {
                        let folder = self.folder.display();
                        let file = file.display();
                        return refuse(format!(
                            "{file} is not an image that the program wrote, or was changed since; move it away from \
                             {folder}, or choose another place to write to"
                        ));
                    }
                }
            }
        }
        Ok(missing)
    }

    /// Compares the file in the place of an image with the list.
    pub fn found(&self, path: &Path) -> Result<Found> {
        match fs::symlink_metadata(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Found::Nothing),
            // A link may lead anywhere, and reading a pipe may block.
            Ok(found) if !found.is_file() => return Ok(Found::Foreign),
            _ => {}
        }
        let content = digest(path).map_err(|source| Error::read(path, source))?;
        let is_ours =
            |entry: &Entry| (&entry.source, &entry.options) == (&self.source, &self.options);
        let lists = std::iter::once(&self.files).chain(self.others.iter().map(|(_, files)| files));
        let entries: Vec<_> = lists.filter_map(|files| files.get(&name(path))).collect();
        let has_written = |entry: &&&Entry| entry.content == content;
        Ok(match entries.iter().find(has_written) {
            Some(_) if entries.iter().filter(has_written).any(|entry| is_ours(entry)) => {
                Found::Image
            }
            Some(_) => Found::Stale,
            None if entries.iter().any(|entry| entry.content.is_empty()) => Found::Stale,
            None => Found::Foreign,
        })
    }

    fn entry(&self, content: String) -> Entry {
        Entry { content, source: self.source.clone(), options: self.options.clone() }
    }

    /// Announces images that will be written. If the call is killed, files that it has written are then not taken for
    /// somebody else's.
    pub fn announce(&mut self, paths: &[PathBuf]) -> Result<()> {
        for path in paths {
            let entry = self.entry(String::new());
            self.files.insert(name(path), entry);
        }
        self.save()
    }

    /// Adds a file that was written to the folder.
    pub fn add(&mut self, path: &Path) -> Result<()> {
        let content = digest(path).map_err(|source| Error::read(path, source))?;
        let entry = self.entry(content);
        self.files.insert(name(path), entry);
        self.now.insert(name(path));
        if self.saved.elapsed() > INTERVAL {
            self.save()?;
            self.saved = Instant::now();
        }
        Ok(())
    }

    /// Removes stale images, with a note. Returns their number. A shard removes nothing, because another shard may be
    /// writing the image again.
    pub fn finish(mut self, console: Console) -> Result<usize> {
        if self.list != NAME {
            self.now.clear();
            return self.save().map(|()| 0);
        }
        let now = std::mem::take(&mut self.now);
        let shards = std::mem::take(&mut self.others);
        for (name, entry) in shards.iter().flat_map(|(_, files)| files) {
            let is_newer = entry.source == self.source && !entry.content.is_empty();
            if !self.files.contains_key(name) || is_newer && !now.contains(name) {
                self.files.insert(name.clone(), entry.clone());
            }
        }
        let (kept, stale): (BTreeMap<_, _>, BTreeMap<_, _>) = std::mem::take(&mut self.files)
            .into_iter()
            .partition(|(name, entry)| now.contains(name) || entry.source == self.source);
        self.files = kept;
        let [removed, changed] = self.remove(stale)?;
        let folder = self.folder.display();
        if removed > 0 {
            let images = count(removed, "image");
            console.note(&format!("removed {images} of an earlier call from {folder}"));
        }
        if changed > 0 {
            let images = count(changed, "image");
            console.warn(&format!(
                "changed since an earlier call wrote them, so kept: {images} in {folder}"
            ));
        }
        self.save()?;
        for (path, _) in shards {
            // this list has all its entries now
            let _ = fs::remove_file(path);
        }
        Ok(removed as usize)
    }

    /// Removes all images of the list, and the list. They have served their purpose.
    pub fn discard(mut self) -> Result<()> {
        self.now.clear();
        let files = std::mem::take(&mut self.files);
        self.remove(files)?;
        let path = self.folder.join(&self.list);
        match fs::remove_file(&path) {
            Err(source) if source.kind() != io::ErrorKind::NotFound => {
                Err(Error::write(&path, source))
            }
            _ => Ok(()),
        }
    }

    /// Removes files that are unchanged since they were listed. Returns the number of these, and of others that
    /// exist.
    fn remove(&self, files: BTreeMap<String, Entry>) -> Result<[u64; 2]> {
        let mut removed = 0;
        let mut changed = 0;
        for (name, entry) in files {
            let path = self.folder.join(&name);
            if !is_name(&name) || !fs::symlink_metadata(&path).is_ok_and(|found| found.is_file()) {
                continue;
            }
            if digest(&path).is_ok_and(|content| content == entry.content) {
                fs::remove_file(&path).map_err(|source| Error::write(&path, source))?;
                removed += 1;
            } else {
                changed += 1;
            }
        }
        Ok([removed, changed])
    }

    /// Whether something else has the list's name: a link, or a folder.
    fn is_taken(path: &Path) -> bool {
        fs::symlink_metadata(path).is_ok_and(|found| !found.is_file())
    }

    fn remove_list(&self) {
        let path = self.folder.join(&self.list);
        if !Self::is_taken(&path) {
            let _ = fs::remove_file(path);
        }
    }

    fn save(&self) -> Result<()> {
        let path = self.folder.join(&self.list);
        if self.files.is_empty() || Self::is_taken(&path) {
            return Ok(());
        }
        write_inside(path, |writer| {
            serde_json::to_writer_pretty(&mut *writer, &self.files)?;
            writer.write_all(b"\n")
        })
    }
}

impl Drop for Written {
    /// A failed call has written some files, which stay in the list. Images that were announced and not written are
    /// dropped. An empty list is removed.
    fn drop(&mut self) {
        let announced = self.files.len();
        let folder = &self.folder;
        self.files.retain(|name, entry| !entry.content.is_empty() || folder.join(name).exists());
        if self.files.is_empty() && announced > 0 {
            self.remove_list();
        } else if self.files.len() < announced || !self.now.is_empty() {
            let _ = self.save();
        }
    }
}

/// All lists in a folder but one: those of shards, and that of calls without a shard.
fn other_lists(folder: &Path, list: &str) -> Vec<PathBuf> {
    let [begin, end] = SHARD;
    let is_list = |name: &str| name == NAME || name.starts_with(begin) && name.ends_with(end);
    let names = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = names.filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<_> = names.filter(|name| is_list(name) && name != list).collect();
    names.sort();
    names.iter().map(|name| folder.join(name)).collect()
}

fn read(path: &Path) -> Option<BTreeMap<String, Entry>> {
    let found = fs::symlink_metadata(path).ok()?;
    if !found.is_file() || found.len() > MAX_BYTES {
        return None;
    }
    serde_json::from_slice(&fs::read(path).ok()?).ok()
}

/// Whether a name is that of a file directly in the folder.
fn is_name(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None))
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn digest(path: &Path) -> io::Result<String> {
    let mut hash = Sha256::new();
    copy(path, &mut hash)?;
    Ok(hex(hash))
}

fn copy(path: &Path, hash: &mut Sha256) -> io::Result<()> {
    io::copy(&mut File::open(path)?, hash).map(|_| ())
}

fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
