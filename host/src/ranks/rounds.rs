//! Long messages in rounds: MPI counts the bytes of a call in 31 bits.

use crate::Result;

/// The part of a message that is sent in the round that starts at byte `begin`: at most `max` bytes.
pub fn part(bytes: &[u8], begin: usize, max: usize) -> &[u8] {
    &bytes[begin.min(bytes.len())..begin.saturating_add(max).min(bytes.len())]
}

/// Receives messages of known lengths, in rounds of at most `max` bytes each. `longest` is the longest message that
/// any rank receives, so that all ranks take the same number of rounds. `round` is called with the byte where a round
/// begins and the number of bytes from each rank. It returns these bytes, one rank after the other.
pub fn receive(
    lengths: &[usize],
    longest: usize,
    max: usize,
    mut round: impl FnMut(usize, &[usize]) -> Result<Vec<u8>>,
) -> Result<Vec<Vec<u8>>> {
    let mut messages: Vec<_> = lengths.iter().map(|&length| Vec::with_capacity(length)).collect();
    for begin in (0..longest).step_by(max) {
        let counts: Vec<_> =
            lengths.iter().map(|length| length.saturating_sub(begin).min(max)).collect();
        let all = round(begin, &counts)?;
        let mut rest = &all[..];
        for (message, &count) in messages.iter_mut().zip(&counts) {
            let (mine, after) = rest.split_at(count);
            message.extend_from_slice(mine);
            rest = after;
        }
    }
    Ok(messages)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ranks::{Ranks, ThreadRanks};

    /// Rounds of three bytes give the same result as one call.
    #[test]
    fn messages_of_any_length_arrive() {
        let lengths = [[0, 1, 7], [3, 0, 4], [9, 2, 0]];
        let message = |from: usize, to: usize| -> Vec<u8> {
            (0..lengths[from][to]).map(|byte| (100 * from + 10 * to + byte) as u8).collect()
        };
        ThreadRanks::run(3, |ranks| {
            let rank = ranks.rank();
            let sent: Vec<_> = (0..3).map(|to| message(rank, to)).collect();
            let lengths = lengths.map(|lengths| lengths[rank]);
            let mut rounds = 0;
            let found = receive(&lengths, 9, 3, |begin, counts| {
                rounds += 1;
                let parts = sent.iter().map(|bytes| part(bytes, begin, 3).to_vec());
                let received = ranks.exchange(parts.collect())?;
                let found: Vec<_> = received.iter().map(Vec::len).collect();
                assert_eq!(found, counts);
                Ok(received.concat())
            });
            let expected: Vec<_> = (0..3).map(|from| message(from, rank)).collect();
            assert_eq!((found.unwrap(), rounds), (expected, 3));
        });
    }
}
