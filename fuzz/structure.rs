//! Photographs with the right structure and any content: random bytes rarely have a valid checksum.

use arbitrary::{Arbitrary, Unstructured};
use miniz_oxide::deflate::compress_to_vec_zlib;

#[derive(Arbitrary, Debug)]
enum Photograph {
    Png {
        size: [u8; 2],
        depth: u8,
        color: u8,
        is_interlaced: bool,
        chunks: Vec<Chunk>,
        rows: Vec<u8>,
    },
    Jpeg {
        size: [u8; 2],
        process: u8,
        components: Vec<[u8; 3]>,
        segments: Vec<Segment>,
        scan: Vec<u8>,
    },
}

#[derive(Arbitrary, Debug)]
struct Chunk {
    name: u8,
    data: Vec<u8>,
}

#[derive(Arbitrary, Debug)]
struct Segment {
    marker: u8,
    data: Vec<u8>,
}

const CHUNKS: [&[u8; 4]; 12] = [
    b"PLTE", b"tRNS", b"gAMA", b"cHRM", b"iCCP", b"sRGB", b"pHYs", b"tEXt", b"zTXt", b"iTXt",
    b"acTL", b"fcTL",
];

impl Photograph {
    fn file(&self) -> Vec<u8> {
        match self {
            Self::Png { size, depth, color, is_interlaced, chunks, rows } => {
                let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
                let [width, height] = size.map(|side| u32::from(side % 40 + 1).to_be_bytes());
                let depth = [1, 2, 4, 8, 16][usize::from(depth % 5)];
                let color = [0, 2, 3, 4, 6][usize::from(color % 5)];
                let rest = [depth, color, 0, 0, u8::from(*is_interlaced)];
                chunk(&mut file, b"IHDR", &[width.as_slice(), &height, &rest].concat());
                for Chunk { name, data } in chunks {
                    chunk(&mut file, CHUNKS[usize::from(*name) % CHUNKS.len()], data);
                }
                // stored, so that a changed byte changes a pixel
                chunk(&mut file, b"IDAT", &compress_to_vec_zlib(rows, 0));
                chunk(&mut file, b"IEND", &[]);
                file
            }
            Self::Jpeg { size, process, components, segments, scan } => {
                let mut file = vec![0xff, 0xd8];
                for Segment { marker, data } in segments {
                    segment(
                        &mut file,
                        [0xdb, 0xc4, 0xdd, 0xe0, 0xe1, 0xe2, 0xee][usize::from(marker % 7)],
                        data,
                    );
                }
                let [width, height] = size.map(|side| u16::from(side % 70 + 1).to_be_bytes());
                let components = &components[..components.len().min(4)];
                let mut header =
                    [&[8], height.as_slice(), &width, &[components.len() as u8]].concat();
                components.iter().for_each(|component| header.extend(component));
                segment(&mut file, 0xc0 + process % 3, &header);
                let mut begin = vec![components.len() as u8];
                components.iter().for_each(|component| begin.extend([component[0], component[2]]));
                begin.extend([0, 63, 0]);
                segment(&mut file, 0xda, &begin);
                file.extend(scan);
                file.extend([0xff, 0xd9]);
                file
            }
        }
    }
}

fn segment(file: &mut Vec<u8>, marker: u8, data: &[u8]) {
    let data = &data[..data.len().min(60_000)];
    file.extend([0xff, marker]);
    file.extend((data.len() as u16 + 2).to_be_bytes());
    file.extend(data);
}

fn chunk(file: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    let body = [name.as_slice(), data].concat();
    file.extend((data.len() as u32).to_be_bytes());
    file.extend(&body);
    file.extend(crc32fast::hash(&body).to_be_bytes());
}

/// A photograph that the bytes describe.
pub fn photograph(bytes: &[u8]) {
    if let Ok(photograph) = Photograph::arbitrary_take_rest(Unstructured::new(bytes)) {
        organza::data::fuzz::photograph(&photograph.file());
    }
}
