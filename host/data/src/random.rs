//! Random numbers that a resumed run draws again.

use rand::SeedableRng;
use rand_pcg::Pcg64;

/// Random numbers for a purpose and a time, independent of all other purposes and times.
pub fn random(seed: u64, purpose: u64, time: u64) -> Pcg64 {
    // splitmix64's increment and an odd constant keep neighbors apart; the generator's own seeding mixes them
    let mixed = seed
        .wrapping_add(purpose.wrapping_mul(0x9e37_79b9_7f4a_7c15))
        .wrapping_add(time.wrapping_mul(0xd134_2543_de82_ef95));
    Pcg64::seed_from_u64(mixed)
}
