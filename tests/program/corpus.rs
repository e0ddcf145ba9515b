//! Every parser on the corpus: each file unchanged, cut short, with flipped bits, and with random changes.

use std::fs;
use std::path::Path;

use allocation_counter::measure;
use muslin_check::inputs::Random;
use organza::fuzz::TARGETS;
use serde_json::Value;

/// Most bytes that a parser may hold at once, besides an amount that grows with its input.
const MAX_BYTES: usize = 96 << 20;
/// Additional bytes for each byte of the input.
const MAX_PER_BYTE: usize = 256;

/// Number of random changes of each file. `ORGANZA_MUTATIONS` replaces it, as in `.ci/nightly`, and `ORGANZA_MUTATION_SEED`
/// sets the seed.
const MUTATIONS: u64 = 50;

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

/// Runs a parser on bytes. Panics if it held too much memory.
fn run(target: fn(&[u8]), bytes: &[u8], what: &str) {
    let most = measure(|| target(bytes)).bytes_max as usize;
    assert!(most <= MAX_BYTES + MAX_PER_BYTE * bytes.len(), "{what} took {most} bytes of memory");
}

/// Changes bytes at one place.
fn mutate_bytes(bytes: &mut Vec<u8>, random: &mut Random) {
    let mut below = |end: usize| random.below(end as u32) as usize;
    if bytes.is_empty() {
        return bytes.push(below(256) as u8);
    }
    let at = below(bytes.len());
    let end = (at + 1 + below(16)).min(bytes.len());
    match below(8) {
        0 => bytes.truncate(at),
        1 => bytes[at..end].iter_mut().for_each(|byte| *byte ^= 1 << below(8)),
        2 => bytes[at..end].fill([0, 0xff, 0x7f, 0x80][below(4)]),
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
            bytes.splice(from..from + length, VALUES[below(VALUES.len())].bytes());
        }
        6 => drop(bytes.splice(at..end, VALUES[below(VALUES.len())].bytes())),
        _ => mutate_json(bytes, random),
    }
}

/// Replaces a value of a JSON file, or of the header of a safetensors file.
fn mutate_json(bytes: &mut Vec<u8>, random: &mut Random) {
    let length = bytes.first_chunk().map_or(0, |word| u64::from_le_bytes(*word));
    let header = 8..8_usize.saturating_add(length as usize);
    let text = bytes.get(header.clone()).unwrap_or(bytes);
    let Ok(mut json) = serde_json::from_slice(text) else { return };
    let is_header = text.len() < bytes.len();
    replace_value(&mut json, random);
    let text = json.to_string().into_bytes();
    if is_header {
        bytes.splice(..8, (text.len() as u64).to_le_bytes());
        bytes.splice(header, text);
    } else {
        *bytes = text;
    }
}

/// Replaces one value at any depth. A text may be JSON itself, as a scene's configuration is.
fn replace_value(root: &mut Value, random: &mut Random) {
    let mut places = Vec::new();
    add_places(root, String::new(), &mut places);
    let is_json = |place: &&String| {
        root.pointer(place).and_then(Value::as_str).is_some_and(|text| text.starts_with('{'))
    };
    let texts: Vec<_> = places.iter().filter(is_json).cloned().collect();
    let some = if !texts.is_empty() && random.below(2) == 0 { texts } else { places };
    let place = &some[random.below(some.len() as u32) as usize];
    let Some(value) = root.pointer_mut(place) else { return };
    let within = value.as_str().and_then(|text| serde_json::from_str(text).ok());
    *value = match within.filter(Value::is_object) {
        Some(mut json) => {
            replace_value(&mut json, random);
            json.to_string().into()
        }
        None => {
            let other = VALUES[random.below(VALUES.len() as u32) as usize];
            serde_json::from_str(other).unwrap_or_default()
        }
    };
}

/// The JSON pointers of a value and of all values in it.
fn add_places(value: &Value, place: String, places: &mut Vec<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                add_places(value, format!("{place}/{key}"), places);
            }
        }
        Value::Array(list) => {
            for (at, value) in list.iter().enumerate() {
                add_places(value, format!("{place}/{at}"), places);
            }
        }
        _ => {}
    }
    places.push(place);
}

/// A number from an environment variable.
fn number(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

#[test]
fn the_corpus_is_parsed_or_refused() {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    let mut folders: Vec<_> = fs::read_dir(&corpus)
        .expect("a corpus")
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    folders.sort();
    let mut names = TARGETS.map(|(name, _)| name.to_owned());
    names.sort();
    assert_eq!(folders, names, "a folder for each target");
    for (name, target) in TARGETS {
        run(target, b"", name);
        let mut files = 0;
        for entry in fs::read_dir(corpus.join(name)).unwrap() {
            let path = entry.unwrap().path();
            let bytes = fs::read(&path).unwrap();
            let what = path.display().to_string();
            assert!(bytes.len() < 64 << 10, "{what} is large for a corpus");
            run(target, &bytes, &what);
            let step = (bytes.len() / 40).max(1);
            for at in (0..bytes.len()).step_by(step) {
                run(target, &bytes[..at], &format!("{what}, the first {at} bytes,"));
                let mut flipped = bytes.clone();
                flipped[at] ^= 1 << (at % 8);
                run(target, &flipped, &format!("{what}, byte {at} changed,"));
                flipped[at] = 0xff;
                run(target, &flipped, &format!("{what}, byte {at} 0xff,"));
            }
            let seed = number("ORGANZA_MUTATION_SEED", 1);
            for round in 0..number("ORGANZA_MUTATIONS", MUTATIONS) {
                let mut random = Random::new(seed << 40 ^ round << 20 ^ files);
                let mut changed = bytes.clone();
                (0..=random.below(6)).for_each(|_| mutate_bytes(&mut changed, &mut random));
                run(target, &changed, &format!("{what}, changed, round {round},"));
            }
            files += 1;
        }
        assert!(files > 0, "{name} has no corpus");
    }
}
