//! Hashes as text.

use sha2::{Digest, Sha256};

/// The 64 hexadecimal digits of a SHA-256 sum.
pub fn hex(hash: Sha256) -> String {
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
