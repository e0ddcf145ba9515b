//! Every parser on the corpus: each file unchanged, cut short, with flipped bits, and with random changes.

use std::fs;
use std::path::Path;

use organza::fuzz::TARGETS;

use crate::held::run;
use crate::mutate::{Random, mutate_bytes, number};

/// Number of random changes of each file. `ORGANZA_MUTATIONS` replaces it, as in `.ci/nightly`, and `ORGANZA_MUTATION_SEED`
/// sets the seed.
const MUTATIONS: u64 = 50;

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
                let mut random =
                    Random((seed ^ round << 32).wrapping_mul(0x2545_f491_4f6c_dd1d) ^ files);
                let mut changed = bytes.clone();
                (0..=random.below(6)).for_each(|_| mutate_bytes(&mut changed, &mut random));
                run(target, &changed, &format!("{what}, changed, round {round},"));
            }
            files += 1;
        }
        assert!(files > 0, "{name} has no corpus");
    }
}
