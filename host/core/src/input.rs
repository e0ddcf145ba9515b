//! Opens files that a user names, without trusting them.

use std::ffi::OsStr;
use std::fs::{self, File, Metadata};
use std::io::{self, Read};
use std::path::Path;

use serde_json::Value;

use crate::error::{Error, Result, format_bytes, invalid};
use muslin_error::memory;

/// Largest JSON file, in bytes. No camera or tile list needs more; a larger file was named by mistake.
const MAX_JSON_BYTES: u64 = 256 << 20;

/// Whether a file's name ends with one of these extensions, in lower or upper case.
pub fn has_extension(path: &Path, extensions: &[&str]) -> bool {
    let extension = path.extension().and_then(OsStr::to_str).map(str::to_lowercase);
    extension.is_some_and(|extension| extensions.contains(&&*extension))
}

/// Opens a regular file and returns it with its length in bytes.
///
/// Anything else is refused before it is opened: a pipe may block, and a device may never end. If another file takes
/// its place meanwhile, that one is refused too.
pub fn open_regular(path: &Path) -> Result<(File, u64)> {
    let check = |found: &Metadata| match found {
        _ if found.is_dir() => Err(io::Error::other("it is a folder, expected a file")),
        _ if !found.is_file() => {
            Err(io::Error::other("it is a device or a pipe, expected a regular file"))
        }
        _ => Ok(()),
    };
    let open = || {
        check(&fs::metadata(path)?)?;
        let mut options = File::options();
        options.read(true);
        // With this flag, opening a pipe does not wait for its other end.
        #[cfg(unix)]
        std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, libc::O_NONBLOCK);
        let file = options.open(path)?;
        let found = file.metadata()?;
        check(&found)?;
        Ok((file, found.len()))
    };
    open().map_err(|source| Error::read(path, source))
}

/// Reads a regular file of at most `limit` bytes. `what` names the expected content in the message.
pub fn read_file(path: &Path, limit: u64, what: &str) -> Result<Vec<u8>> {
    let (file, length) = open_regular(path)?;
    if length > limit {
        let length = format_bytes(length);
        let limit = format_bytes(limit);
        return invalid(
            path,
            format!(
                "the file has {length}, too large for {what} (limit {limit}): is it the right file?"
            ),
        );
    }
    let mut bytes = memory::reserve(length as usize, what)?;
    // The file may have grown: read no more than was checked.
    file.take(length).read_to_end(&mut bytes).map_err(|source| Error::read(path, source))?;
    Ok(bytes)
}

/// [`read_file`] of UTF-8 text.
pub fn read_text(path: &Path, limit: u64, what: &str) -> Result<String> {
    String::from_utf8(read_file(path, limit, what)?).map_err(|_| Error::Invalid {
        origin: path.to_owned(),
        reason: format!("the file is not UTF-8 text, so it is not {what}: is it the right file?"),
    })
}

/// Reads and parses a JSON file.
pub fn read_json(path: &Path) -> Result<Value> {
    parse_json(&read_file(path, MAX_JSON_BYTES, "JSON")?, path)
}

/// Most memory that parsing the JSON takes, in bytes. An object is a tree node, and every value has a slot in one or
/// in an array. Both may be twice as large as their content.
fn bytes_to_parse(text: &[u8]) -> u64 {
    let cost = |byte: &u8| match byte {
        b'{' => 700,
        b',' => 200,
        b'[' => 160,
        _ => 1,
    };
    text.iter().map(cost).sum()
}

/// Parses JSON. A byte order mark, which some editors leave, is skipped.
pub fn parse_json(bytes: &[u8], origin: &Path) -> Result<Value> {
    memory::check(bytes_to_parse(bytes), &format!("parsing {}", origin.display()))?;
    if matches!(bytes, [0xff, 0xfe, ..] | [0xfe, 0xff, ..]) {
        return invalid(origin, "it is UTF-16 text, expected UTF-8: save it in this encoding");
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    serde_json::from_slice(text).map_err(|error| Error::json(origin, "JSON", text, &error))
}

/// The kind of a JSON value, for messages.
pub fn kind(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a boolean",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "an array",
        Value::Object(_) => "an object",
    }
}

/// A JSON number without a fraction, whether written `3` or `3.0`.
pub fn integer(value: &Value) -> Option<i64> {
    /// Up to this number, every integer is an f64.
    const EXACT: f64 = 9_007_199_254_740_992.0;
    value.as_i64().or_else(|| {
        let number = value.as_f64()?;
        (number.fract() == 0.0 && number.abs() <= EXACT).then_some(number as i64)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::chain;
    use serde_json::json;

    #[test]
    fn only_regular_files_are_opened() {
        let folder = tempfile::tempdir().unwrap();
        let text = chain(&open_regular(folder.path()).unwrap_err());
        assert!(text.contains("folder"), "{text}");
        let text = chain(&open_regular(&folder.path().join("absent")).unwrap_err());
        assert!(text.contains("absent") && text.contains("no such file"), "{text}");
        if cfg!(unix) {
            let text = chain(&open_regular(Path::new("/dev/zero")).unwrap_err());
            assert!(text.contains("device"), "{text}");
        }
    }

    #[test]
    fn json_is_read_with_and_without_a_mark() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.json");
        for text in ["{\"a\": 1}", "\u{feff}{\"a\": 1}"] {
            fs::write(&path, text).unwrap();
            assert_eq!(read_json(&path).unwrap(), json!({"a": 1}));
        }
        fs::write(&path, "{\"a\": 1").unwrap();
        assert!(matches!(read_json(&path), Err(Error::BadJson { line: 1, .. })));
        // as PowerShell writes what a program prints
        fs::write(&path, b"\xff\xfe{\0}\0").unwrap();
        assert!(chain(&read_json(&path).unwrap_err()).contains("UTF-16"));
    }

    #[test]
    fn numbers_that_json_does_not_have_are_explained() {
        for number in ["NaN", "Infinity", "-Infinity", "-NaN"] {
            for text in [format!("{{\"a\": {number}}}"), format!("[1,\n{number},2]")] {
                let error = chain(&parse_json(text.as_bytes(), Path::new("a.json")).unwrap_err());
                assert!(error.contains("no NaN and no Infinity"), "{text}: {error}");
            }
        }
        let error = chain(&parse_json(b"[1, Nobody]", Path::new("a.json")).unwrap_err());
        assert!(!error.contains("Infinity"), "{error}");
    }

    #[test]
    fn deep_nesting_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep.json");
        fs::write(&path, "[".repeat(1 << 20)).unwrap();
        assert!(matches!(read_json(&path), Err(Error::BadJson { .. })));
    }

    #[test]
    fn integers_may_be_written_as_floats() {
        assert_eq!(integer(&json!(-3)), Some(-3));
        assert_eq!(integer(&json!(3.0)), Some(3));
        assert_eq!(integer(&json!(3.5)), None);
        assert_eq!(integer(&json!(1e300)), None);
        assert_eq!(integer(&json!("3")), None);
    }
}
