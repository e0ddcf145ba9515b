use std::collections::BTreeMap;

use super::*;

/// CRC-32C from its definition: the remainder by the polynomial 0x1edc6f41, bits reversed.
fn crc(bytes: &[u8]) -> u32 {
    let mut crc = !0_u32;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ (0x82f6_3b78 * (crc & 1));
        }
    }
    !crc
}

fn check(bytes: &[u8], found: &[u8]) {
    let crc = crc(bytes);
    let masked = crc.rotate_right(15).wrapping_add(0xa282_ead8);
    assert_eq!(found, masked.to_le_bytes());
}

/// A field of a protobuf message.
#[derive(Clone, Debug)]
enum Field {
    Integer(u64),
    Fixed(Vec<u8>),
    Bytes(Vec<u8>),
}

fn varint(bytes: &mut &[u8]) -> u64 {
    let mut value = 0;
    for shift in (0..).step_by(7) {
        let byte = bytes[0];
        *bytes = &bytes[1..];
        value |= u64::from(byte & 127) << shift;
        if byte < 128 {
            break;
        }
    }
    value
}

fn take(bytes: &mut &[u8], length: usize) -> Vec<u8> {
    let (taken, rest) = bytes.split_at(length);
    *bytes = rest;
    taken.to_vec()
}

/// The fields of a protobuf message by number, read as its specification says.
fn fields(mut bytes: &[u8]) -> BTreeMap<u64, Vec<Field>> {
    let mut found: BTreeMap<u64, Vec<Field>> = BTreeMap::new();
    while !bytes.is_empty() {
        let key = varint(&mut bytes);
        let field = match key & 7 {
            0 => Field::Integer(varint(&mut bytes)),
            1 => Field::Fixed(take(&mut bytes, 8)),
            5 => Field::Fixed(take(&mut bytes, 4)),
            2 => {
                let length = varint(&mut bytes);
                Field::Bytes(take(&mut bytes, length as usize))
            }
            other => panic!("wire type {other}"),
        };
        found.entry(key >> 3).or_default().push(field);
    }
    found
}

fn bytes(field: &Field) -> &[u8] {
    match field {
        Field::Bytes(bytes) | Field::Fixed(bytes) => bytes,
        Field::Integer(_) => panic!("{field:?}"),
    }
}

fn integer(fields: &BTreeMap<u64, Vec<Field>>, number: u64) -> u64 {
    match fields.get(&number).map(|found| &found[0]) {
        Some(Field::Integer(value)) => *value,
        None => 0,
        other => panic!("{other:?}"),
    }
}

/// Step, tag, and number or picture of every value in a file.
fn read(run: &Path) -> Vec<(u64, String, Result<f32, Vec<u8>>)> {
    let file = fs::read(run.join(TENSORBOARD).join(FILE)).unwrap();
    let mut rest = &file[..];
    let mut found = Vec::new();
    let mut versions = 0;
    while !rest.is_empty() {
        let length = u64::from_le_bytes(rest[..8].try_into().unwrap()) as usize;
        check(&rest[..8], &rest[8..12]);
        check(&rest[12..12 + length], &rest[12 + length..16 + length]);
        let event = fields(&rest[12..12 + length]);
        rest = &rest[16 + length..];
        let time = f64::from_le_bytes(bytes(&event[&1][0]).try_into().unwrap());
        assert!(time > 1.7e9, "{time}");
        if let Some(version) = event.get(&3) {
            assert_eq!(bytes(&version[0]), b"brain.Event:2");
            versions += 1;
            continue;
        }
        for value in &fields(bytes(&event[&5][0]))[&1] {
            let value = fields(bytes(value));
            let tag = String::from_utf8(bytes(&value[&1][0]).to_vec()).unwrap();
            let content = match value.get(&2) {
                Some(number) => Ok(f32::from_le_bytes(bytes(&number[0]).try_into().unwrap())),
                None => {
                    let picture = fields(bytes(&value[&4][0]));
                    let png = bytes(&picture[&4][0]).to_vec();
                    let decoded = ::image::load_from_memory(&png).unwrap().to_rgb8();
                    let size = [integer(&picture, 2), integer(&picture, 1)];
                    assert_eq!(size, [decoded.width(), decoded.height()].map(u64::from));
                    assert_eq!(integer(&picture, 3), 3);
                    Err(png)
                }
            };
            found.push((integer(&event, 2), tag, content));
        }
    }
    assert_eq!(versions, 1);
    found
}

#[test]
fn crc_of_the_standard() {
    // RFC 3720, B.4
    assert_eq!(crc(&[0; 32]), 0x8a91_36aa);
    assert_eq!(crc(b"123456789"), 0xe306_9283);
}

#[test]
fn another_reader_finds_what_was_written() {
    let run = tempfile::tempdir().unwrap();
    let mut log = EventLog::create(run.path()).unwrap();
    let scalars = [("loss", Some(0.25)), ("psnr", None), ("gaussians", Some(4000.0))];
    log.scalars(300, scalars.map(|(tag, value)| (tag.to_owned(), value))).unwrap();
    log.picture(300, "held_out/a/rendered".to_owned(), &Image::new(1500, 20).unwrap()).unwrap();
    let found = read(run.path());
    let names: Vec<_> = found.iter().map(|(step, tag, _)| (*step, tag.as_str())).collect();
    assert_eq!(names, [(300, "loss"), (300, "gaussians"), (300, "held_out/a/rendered")]);
    assert_eq!([&found[0].2, &found[1].2], [&Ok(0.25), &Ok(4000.0)]);
    let picture = ::image::load_from_memory(found[2].2.as_ref().unwrap_err()).unwrap();
    assert_eq!([picture.width(), picture.height()], [500, 6]);
}

#[test]
fn a_resumed_file_has_each_step_once() {
    let run = tempfile::tempdir().unwrap();
    let write = |log: &mut EventLog, steps: std::ops::Range<u64>| {
        for step in steps {
            log.scalars(step, [("loss".to_owned(), Some(step as f64))]).unwrap();
        }
    };
    let mut log = EventLog::create(run.path()).unwrap();
    write(&mut log, 1..8);
    drop(log);
    // killed in the middle of a record
    let path = run.path().join(TENSORBOARD).join(FILE);
    let whole = fs::read(&path).unwrap();
    fs::write(&path, &whole[..whole.len() - 3]).unwrap();
    for step in [5, 2] {
        let mut log = EventLog::resume(run.path(), step).unwrap();
        write(&mut log, step + 1..10);
        let steps: Vec<_> = read(run.path()).into_iter().map(|(step, ..)| step).collect();
        assert_eq!(steps, (1..10).collect::<Vec<_>>());
    }
    let empty = tempfile::tempdir().unwrap();
    drop(EventLog::resume(empty.path(), 3).unwrap());
    assert!(read(empty.path()).is_empty());
}

#[test]
fn damage_ends_a_file() {
    let event = |step| Event { step, summary: Some(Summary::default()), ..Event::default() };
    let bytes: Vec<_> = (1..4).flat_map(|step| record(&event(step))).collect();
    assert_eq!(events(&bytes).count(), 3);
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 64;
        assert_eq!(events(&damaged).count(), at / (bytes.len() / 3), "byte {at}");
    }
    let huge = [u64::MAX.to_le_bytes().to_vec(), checksum(&u64::MAX.to_le_bytes()).to_vec()];
    assert_eq!(events(&huge.concat()).count(), 0);
}
