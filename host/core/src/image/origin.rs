//! The origin of an image, in its file. So a later call knows the images that the program wrote, and of what.
//!
//! A PNG has it as a text chunk, an EXR file as an attribute. Both have the key `organza`, and the text
//! `origin 1 SOURCE OPTIONS CONTENT`: three SHA-256 sums.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::hex;

/// Key of the text chunk or the attribute.
pub(super) const KEY: &str = "organza";
const BEGIN: &str = "origin 1 ";
/// Length of a SHA-256 sum in hexadecimal digits.
const DIGITS: usize = 64;
const TEXT: usize = BEGIN.len() + 3 * DIGITS + 2;
/// Both formats have the text near the beginning of the file.
const HEAD: usize = 4096;
/// Length of a PNG chunk's checksum, which follows the text.
const CRC: usize = 4;

/// Hashes of what an image was made from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// SHA-256 of the scene and of all cameras, in hexadecimal digits.
    pub source: String,
    /// SHA-256 of everything else that the image depends on.
    pub options: String,
}

/// A file that says where it is from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Marked {
    /// The sources of the image.
    pub origin: Origin,
    /// Whether the file is as it was written, and has its name still.
    pub unchanged: bool,
}

impl Origin {
    /// The origin with these hashes.
    #[must_use]
    pub fn new(source: Sha256, options: Sha256) -> Self {
        Self { source: hex(source), options: hex(options) }
    }

    /// The text in the file of an image, without the sum of the content.
    pub(super) fn text(&self) -> String {
        format!("{BEGIN}{} {} {}", self.source, self.options, "0".repeat(DIGITS))
    }
}

/// Puts the sum of the content of an encoded image into its text, and corrects the checksum of a PNG's text chunk.
pub(super) fn seal(file: &mut [u8], path: &Path) -> io::Result<()> {
    let text = find(file).ok_or_else(|| io::Error::other("an image without its origin"))?;
    let end = text + TEXT;
    let sum = content(file, text, path);
    file[end - DIGITS..end].copy_from_slice(sum.as_bytes());
    if file.starts_with(b"\x89PNG") {
        // The checksum covers the chunk's type, the key with its end, and the text.
        let kind = text - KEY.len() - 1 - 4;
        let crc = crc32fast::hash(&file[kind..end]);
        file[end..end + CRC].copy_from_slice(&crc.to_be_bytes());
    }
    Ok(())
}

/// Reads where an image is from. Returns `None` for a file that says nothing.
///
/// # Errors
/// Those of reading the file.
pub fn read_origin(path: &Path) -> io::Result<Option<Marked>> {
    let mut reader = File::open(path)?;
    let mut file = Vec::new();
    reader.by_ref().take(HEAD as u64).read_to_end(&mut file)?;
    let Some(text) = find(&file) else { return Ok(None) };
    reader.read_to_end(&mut file)?;
    let Ok(words) = std::str::from_utf8(&file[text..text + TEXT]) else { return Ok(None) };
    let mut words = words[BEGIN.len()..].split(' ').map(str::to_owned);
    let mut word = || words.next().filter(|word| word.len() == DIGITS);
    let (Some(source), Some(options), Some(sum)) = (word(), word(), word()) else {
        return Ok(None);
    };
    let unchanged = sum == content(&file, text, path);
    Ok(Some(Marked { origin: Origin { source, options }, unchanged }))
}

/// Where the text begins in a file.
fn find(file: &[u8]) -> Option<usize> {
    let head = &file[..file.len().min(HEAD)];
    let text = head.windows(BEGIN.len()).position(|bytes| bytes == BEGIN.as_bytes())?;
    let has_key = head[..text].windows(KEY.len() + 1).any(|bytes| bytes == b"organza\0");
    (has_key && text + TEXT + CRC <= file.len()).then_some(text)
}

/// SHA-256 of a file's name and of its bytes, but for the sum itself and the checksum of a PNG's chunk.
fn content(file: &[u8], text: usize, path: &Path) -> String {
    let end = text + TEXT;
    let mut hash = Sha256::new();
    hash.update(path.file_name().unwrap_or_default().as_encoded_bytes());
    hash.update(&file[..end - DIGITS]);
    hash.update(&file[end + CRC..]);
    hex(hash)
}
