//! Safetensors files of F32 tensors of any meaning.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, BufReader, Read, Seek, Write};
use std::path::Path;

use safetensors::tensor::{Dtype, Metadata, TensorInfo};
use serde_json::{Map, Value, json};

use super::tensor_spec::TensorSpec;
use crate::error::{argument, invalid};
use crate::input::open_regular;
use crate::{Error, Result, write_atomic};
use muslin_error::memory;

/// Largest header, in bytes. The few dozen tensors of a scene need far less; safetensors itself allows 100 MB.
const MAX_HEADER_BYTES: u64 = 16 << 20;
/// Bytes of the length before the header, and the alignment of the data.
const WORD: usize = 8;

/// A tensor in memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tensor {
    /// Shape, row-major.
    pub shape: Vec<usize>,
    /// Values, as many as the product of the shape.
    pub data: Vec<f32>,
}

/// Reads every tensor of a safetensors file. All must be F32.
///
/// # Errors
/// [`Error::ReadFile`]; [`Error::BadSafetensors`] for a file that is cut short, damaged or of another kind;
/// [`Error::Invalid`] for another type; [`DeviceError::OutOfMemory`](crate::error::DeviceError::OutOfMemory).
pub fn read_tensors(path: impl AsRef<Path>) -> Result<BTreeMap<String, Tensor>> {
    let path = path.as_ref();
    let (file, length) = open_regular(path)?;
    read_tensors_from(&mut BufReader::new(file), length, path)
}

/// [`read_tensors`] from a reader of `length` bytes. Errors name `origin`.
pub fn read_tensors_from(
    reader: &mut impl Read,
    length: u64,
    origin: &Path,
) -> Result<BTreeMap<String, Tensor>> {
    let header = Header::read(reader, length, origin)?;
    let mut tensors = BTreeMap::new();
    for name in header.names() {
        header.require_f32(name, origin)?;
        let shape = header.shape(name).unwrap_or_default().to_vec();
        // The header was checked against the file's length, so this allocates no more than the file has.
        let mut data = memory::zeros(shape.iter().product(), name)?;
        read_values(reader, &mut data, origin)?;
        tensors.insert(name.clone(), Tensor { shape, data });
    }
    Ok(tensors)
}

/// Reads a single tensor of a safetensors file of `length` bytes; `None` if the file has no tensor of that name. Errors
/// name `origin`.
///
/// # Errors
/// The same errors as [`read_tensors`].
pub fn read_tensor(
    reader: &mut (impl Read + Seek),
    (length, origin): (u64, &Path),
    name: &str,
) -> Result<Option<Tensor>> {
    let header = Header::read(reader, length, origin)?;
    header.require_f32(name, origin)?;
    let Some(shape) = header.shape(name).map(<[usize]>::to_vec) else { return Ok(None) };
    let mut data = memory::zeros(shape.iter().product(), name)?;
    let wanted = HashMap::from([(name.to_owned(), &mut data[..])]);
    header.read_wanted(reader, wanted, origin)?;
    Ok(Some(Tensor { shape, data }))
}

/// Reads an entry from the metadata of a safetensors file of `length` bytes.
pub fn read_metadata(
    reader: &mut impl Read,
    length: u64,
    origin: &Path,
    key: &str,
) -> Result<Option<String>> {
    Ok(Header::read(reader, length, origin)?.metadata(key).map(str::to_owned))
}

/// Writes tensors and metadata to a safetensors file, atomically. The same input gives the same bytes.
///
/// # Errors
/// [`Error::WriteFile`]; [`Error::Argument`] if a name occurs twice or is empty, or if a shape does not fit its data.
pub fn write_tensors(
    path: impl AsRef<Path>,
    tensors: &[(TensorSpec, &[f32])],
    metadata: &[(&str, &str)],
) -> Result<()> {
    let (header, tensors) = encode_tensors(tensors, metadata)?;
    write_atomic(path, |writer| write_all(writer, &header, &tensors))
}

/// [`write_tensors`] to memory.
pub fn tensors_to_bytes(
    tensors: &[(TensorSpec, &[f32])],
    metadata: &[(&str, &str)],
) -> Result<Vec<u8>> {
    let (header, tensors) = encode_tensors(tensors, metadata)?;
    let mut bytes = Vec::new();
    write_all(&mut bytes, &header, &tensors)
        .map_err(|error| Error::Argument { reason: error.to_string() })?;
    Ok(bytes)
}

/// The header of a safetensors file, checked against the file's length.
pub(super) struct Header {
    header: Metadata,
    /// Names in the order of their data, which has no gaps.
    names: Vec<String>,
}

impl Header {
    /// Reads the header at the start of a file of `length` bytes, and leaves `reader` at the data.
    pub fn read(reader: &mut impl Read, length: u64, origin: &Path) -> Result<Self> {
        let bad = |reason| Error::BadSafetensors { origin: origin.to_owned(), reason };
        if length < WORD as u64 {
            return Err(bad(format!("it has {length} bytes, too few for a header")));
        }
        let mut word = [0; WORD];
        reader.read_exact(&mut word).map_err(|source| Error::read(origin, source))?;
        let header_bytes = u64::from_le_bytes(word);
        let rest = length - WORD as u64;
        if header_bytes > MAX_HEADER_BYTES.min(rest) {
            return Err(bad(format!(
                "its first eight bytes announce a header of {header_bytes} bytes, but {rest} bytes \
                 follow: it is another kind of file or was cut short"
            )));
        }
        let mut text: Vec<u8> = memory::zeros(header_bytes as usize, "a header")?;
        reader.read_exact(&mut text).map_err(|source| Error::read(origin, source))?;
        let header: Metadata = serde_json::from_slice(&text)
            .map_err(|error| bad(format!("its header does not parse: {error}")))?;
        let found = rest - header_bytes;
        let expected = header.data_len() as u64;
        if found < expected {
            return Err(bad(format!(
                "its header announces {expected} bytes of data and {found} are there: it was cut \
                 short, so copy it again"
            )));
        }
        if found > expected {
            let extra = found - expected;
            return Err(bad(format!("{extra} bytes follow the last tensor: it is damaged")));
        }
        let names = header.offset_keys();
        Ok(Self { header, names })
    }

    /// The tensors' names in the order of their data.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The metadata entry of that name.
    pub fn metadata(&self, key: &str) -> Option<&str> {
        self.header.metadata().as_ref()?.get(key).map(String::as_str)
    }

    /// The shape of the tensor named `name`, if there is one.
    pub fn shape(&self, name: &str) -> Option<&[usize]> {
        self.header.info(name).map(|info| info.shape.as_slice())
    }

    /// Fails if the tensor exists and is not F32.
    pub fn require_f32(&self, name: &str, origin: &Path) -> Result<()> {
        match self.header.info(name) {
            Some(TensorInfo { dtype, .. }) if *dtype != Dtype::F32 => invalid(
                origin,
                format!("tensor `{name}` is {dtype:?}, expected F32; convert it and save again"),
            ),
            _ => Ok(()),
        }
    }

    /// Reads the data into the slice for each name, and skips tensors without a slice. The tensors must be F32 and as long as
    /// their slices.
    pub fn read_wanted(
        &self,
        reader: &mut (impl Read + Seek),
        mut wanted: HashMap<String, &mut [f32]>,
        origin: &Path,
    ) -> Result<()> {
        for name in &self.names {
            let (start, end) = self.header.info(name).map_or((0, 0), |info| info.data_offsets);
            match wanted.remove(name) {
                Some(values) => read_values(reader, values, origin)?,
                None => {
                    let skipped = reader.seek_relative((end - start) as i64);
                    skipped.map_err(|source| Error::read(origin, source))?;
                }
            }
        }
        Ok(())
    }
}

fn read_values(reader: &mut impl Read, values: &mut [f32], origin: &Path) -> Result<()> {
    reader
        .read_exact(bytemuck::cast_slice_mut(values))
        .map_err(|source| Error::read(origin, source))?;
    if cfg!(target_endian = "big") {
        for value in values {
            *value = f32::from_bits(value.to_bits().swap_bytes());
        }
    }
    Ok(())
}

/// Returns the header's bytes, length included, and the tensors' values in the order of the file.
fn encode_tensors<'a>(
    tensors: &[(TensorSpec, &'a [f32])],
    metadata: &[(&str, &str)],
) -> Result<(Vec<u8>, Vec<&'a [f32]>)> {
    let mut tensors: Vec<_> = tensors.iter().collect();
    tensors.sort_by_key(|(spec, _)| &spec.name);
    for (TensorSpec { name, shape, .. }, data) in &tensors {
        if count(shape) != Some(data.len()) {
            let length = data.len();
            return argument(format!("tensor `{name}` of shape {shape:?} has {length} values"));
        }
    }
    let header = encode_header(tensors.iter().map(|(spec, _)| spec), metadata)?;
    Ok((header, tensors.into_iter().map(|(_, data)| *data).collect()))
}

/// The number of values of a shape; `None` on overflow.
fn count(shape: &[usize]) -> Option<usize> {
    shape.iter().try_fold(1_usize, |values, &size| values.checked_mul(size))
}

/// Returns the header's bytes, length included, for tensors in the order of their names.
///
/// The safetensors crate writes metadata in an order that changes from run to run, so it cannot be used here.
fn encode_header<'a>(
    tensors: impl Iterator<Item = &'a TensorSpec>,
    metadata: &[(&str, &str)],
) -> Result<Vec<u8>> {
    let mut header = Map::new();
    let metadata: Map<_, _> =
        metadata.iter().map(|&(key, value)| (key.to_owned(), Value::from(value))).collect();
    if !metadata.is_empty() {
        header.insert("__metadata__".to_owned(), Value::Object(metadata));
    }
    let mut start = 0;
    for TensorSpec { name, shape, .. } in tensors {
        let bytes = count(shape).and_then(|values| values.checked_mul(size_of::<f32>()));
        let Some(end) = bytes.and_then(|bytes| bytes.checked_add(start)) else {
            return argument(format!("tensor `{name}` of shape {shape:?} is too large"));
        };
        let info = json!({"dtype": "F32", "shape": shape, "data_offsets": [start, end]});
        if name.is_empty() || name == "__metadata__" || header.insert(name.clone(), info).is_some()
        {
            return argument(format!("the tensor name `{name}` is empty, reserved or used twice"));
        }
        start = end;
    }
    let mut text = Value::Object(header).to_string().into_bytes();
    text.resize(text.len().next_multiple_of(WORD), b' ');
    let mut bytes = (text.len() as u64).to_le_bytes().to_vec();
    bytes.append(&mut text);
    Ok(bytes)
}

fn write_all(writer: &mut dyn Write, header: &[u8], tensors: &[&[f32]]) -> io::Result<()> {
    writer.write_all(header)?;
    tensors.iter().try_for_each(|values| write_values(writer, values))
}

fn write_values(writer: &mut dyn Write, values: &[f32]) -> io::Result<()> {
    if cfg!(target_endian = "little") {
        return writer.write_all(bytemuck::cast_slice(values));
    }
    values.iter().try_for_each(|value| writer.write_all(&value.to_le_bytes()))
}
