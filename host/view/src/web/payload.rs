//! All data of a page, packed: gzip in base64, so that it can be part of a script and needs no server.
//!
//! Unpacked, it has the length of the JSON in bytes (u32, little endian), the JSON, zeros up to a multiple of 4, and
//! the buffers of the scene. The bytes of a buffer are sorted by their place in a 32-bit word, because the high bytes
//! of floats are similar.

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::Value;

use muslin_device::PlannedBuffer;

/// Packs a page's data.
pub fn pack(header: &Value, buffers: &[PlannedBuffer]) -> String {
    let mut json = serde_json::to_vec(header).expect("numbers and names");
    let length = json.len() as u32;
    json.resize(json.len().next_multiple_of(4), 0);
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    let mut write = |bytes: &[u8]| packed.write_all(bytes).expect("memory can be written to");
    write(&length.to_le_bytes());
    write(&json);
    for buffer in buffers {
        match &buffer.contents {
            Some(contents) => write(&by_place(contents)),
            None => write(&vec![0; buffer.bytes as usize]),
        }
    }
    STANDARD.encode(packed.finish().expect("memory can be written to"))
}

/// The first bytes of all words, followed by all second bytes, and so on.
fn by_place(bytes: &[u8]) -> Vec<u8> {
    (0..4).flat_map(|place| bytes.iter().skip(place).step_by(4).copied()).collect()
}
