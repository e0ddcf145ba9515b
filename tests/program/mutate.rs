//! Random changes, the same for the same seed.

/// Texts that replace a number or any other word.
const VALUES: [&str; 22] = [
    "0",
    "-1",
    "1",
    "1e39",
    "-1e39",
    "1e-46",
    "1e308",
    "1e999",
    "nan",
    "null",
    "true",
    "[]",
    "{}",
    "\"\"",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "18446744073709551615",
    "0.5",
    "[[1e300]]",
    "\"\\u001b[2J\"",
    "3.4e38",
];

/// Random numbers from splitmix64.
pub struct Random(pub u64);

impl Random {
    /// A number from 0 to `end` - 1.
    pub fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % end.max(1) as u64) as usize
    }

    /// One of the texts.
    pub fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.below(of.len())]
    }
}

/// Changes bytes at one place.
pub fn mutate_bytes(bytes: &mut Vec<u8>, random: &mut Random) {
    if bytes.is_empty() {
        return bytes.push(random.below(256) as u8);
    }
    let at = random.below(bytes.len());
    let end = (at + 1 + random.below(16)).min(bytes.len());
    match random.below(7) {
        0 => bytes.truncate(at),
        1 => bytes[at..end].iter_mut().for_each(|byte| *byte ^= 1 << random.below(8)),
        2 => bytes[at..end].fill([0, 0xff, 0x7f, 0x80][random.below(4)]),
        3 => drop(bytes.drain(at..end)),
        4 => {
            let copy = bytes[at..end].to_vec();
            bytes.splice(at..at, copy);
        }
        // replaces a number in text
        5 => {
            let is_number = |byte: &u8| byte.is_ascii_digit() || b".-+e".contains(byte);
            let from = (at..bytes.len()).find(|&i| is_number(&bytes[i])).unwrap_or(at);
            let length = bytes[from..].iter().take_while(|byte| is_number(byte)).count();
            bytes.splice(from..from + length, random.one(&VALUES).bytes());
        }
        _ => drop(bytes.splice(at..end, random.one(&VALUES).bytes())),
    }
}

/// A number from an environment variable.
pub fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}
