//! `.splat`: 32 bytes for each Gaussian, and nothing else. Center and scales are floats, color and opacity bytes, and the parts
//! of the quaternion bytes around 128.

use std::io::{self, Write};
use std::path::Path;

use muslin::math::sigmoid;

use super::{Splat, SplatFile, ZEROS, base_color, byte, log_of, logit_of, omitted, turned};
use crate::harmonics::{FIRST, HARMONICS, MIDDLE};
use organza_core::error::{Result, invalid};

/// Bytes of a Gaussian.
const BYTES: usize = 32;

pub fn write(splats: &[Splat], file: &mut dyn Write) -> io::Result<()> {
    // the largest and most opaque first: viewers show a file while it loads
    let weight =
        |splat: &&Splat| splat.log_scale.iter().sum::<f32>().exp() * sigmoid(splat.opacity);
    let mut order: Vec<_> = splats.iter().collect();
    order.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
    for splat in order {
        for value in splat.position.into_iter().chain(splat.log_scale.map(f32::exp)) {
            file.write_all(&value.to_le_bytes())?;
        }
        file.write_all(&base_color(splat).map(|value| byte(255.0 * value)))?;
        file.write_all(&[byte(255.0 * sigmoid(splat.opacity))])?;
        file.write_all(&turned(splat).map(|part| byte(part * 128.0 + 128.0)))?;
    }
    Ok(())
}

pub fn read(bytes: &[u8], path: &Path) -> Result<SplatFile> {
    let (rows, rest) = bytes.as_chunks::<BYTES>();
    if !rest.is_empty() {
        let reason = format!(
            "a .splat file has {BYTES} bytes for each Gaussian, and {} is no multiple of that; the file was cut \
             short or is another one",
            bytes.len()
        );
        return invalid(path, reason);
    }
    let splat = |row: &[u8; BYTES]| {
        let float = |at: usize| f32::from_le_bytes(std::array::from_fn(|byte| row[4 * at + byte]));
        let mut color = [[0.0; 3]; HARMONICS];
        color[0] = [24, 25, 26].map(|at| (f32::from(row[at]) / 255.0 - MIDDLE) / FIRST);
        Splat {
            position: [0, 1, 2].map(float),
            rotation: [28, 29, 30, 31].map(|at| (f32::from(row[at]) - 128.0) / 128.0),
            log_scale: [3, 4, 5].map(|at| log_of(float(at))),
            opacity: logit_of(row[27]),
            color,
        }
    };
    let splats: Vec<_> = rows.iter().filter(|row| **row != [0; BYTES]).map(splat).collect();
    let note = omitted(rows.len() - splats.len(), rows.len(), ZEROS);
    Ok(SplatFile { notes: Vec::from_iter(note), ..SplatFile::new(path, ".splat", splats) })
}

#[cfg(test)]
mod tests {
    use super::super::tests::splats;
    use super::*;
    use organza_core::error::chain;

    #[test]
    fn a_splat_file_has_32_bytes_for_each_of_them() {
        let splats = splats();
        let mut bytes = Vec::new();
        write(&splats, &mut bytes).unwrap();
        assert_eq!(bytes.len(), 32 * splats.len());
        let float = |at: usize| f32::from_le_bytes(std::array::from_fn(|byte| bytes[at + byte]));
        let found = splats.iter().find(|splat| splat.position[0] == float(0)).unwrap();
        for axis in 0..3 {
            assert_eq!(float(4 * axis), found.position[axis]);
            assert_eq!(float(12 + 4 * axis), found.log_scale[axis].exp());
            let color = 255.0 * (0.5 + 0.282_094_8 * found.color[0][axis]);
            assert!((f32::from(bytes[24 + axis]) - color).abs() < 0.51);
        }
        assert!((f32::from(bytes[27]) - 255.0 * sigmoid(found.opacity)).abs() < 0.51);
        let w = (f32::from(bytes[28]) - 128.0) / 128.0;
        assert!((w - turned(found)[0]).abs() < 0.01);
    }

    #[test]
    fn bytes_are_read_as_they_are_described() {
        let floats = [1.0_f32, -2.0, 3.5, 0.5, 1.0, 2.0];
        let mut bytes: Vec<u8> = floats.iter().flat_map(|value| value.to_le_bytes()).collect();
        bytes.extend([255, 0, 51, 204, 128, 255, 128, 0]);
        let path = Path::new("a.SPLAT");
        let file = super::super::read_from(&[&bytes[..], &[0; 64]].concat(), path).unwrap();
        assert!(file.notes[0].starts_with("2 of 3 Gaussians"), "{:?}", file.notes);
        let [splat] = file.splats[..] else { panic!() };
        assert_eq!(splat.position, [1.0, -2.0, 3.5]);
        assert_eq!(splat.log_scale, [0.5_f32.ln(), 0.0, 2.0_f32.ln()]);
        assert_eq!(splat.rotation, [0.0, 127.0 / 128.0, 0.0, -1.0]);
        let color = base_color(&splat);
        assert!(color.iter().zip([1.0, 0.0, 0.2]).all(|(a, b)| (a - b).abs() < 1e-6), "{color:?}");
        assert!((sigmoid(splat.opacity) - 0.8).abs() < 1e-6);
        assert_eq!(splat.color[1..], [[0.0; 3]; HARMONICS - 1]);
        let error = chain(&super::super::read_from(&bytes[..31], path).unwrap_err());
        assert!(error.contains("31 is no multiple"), "{error}");
    }
}
