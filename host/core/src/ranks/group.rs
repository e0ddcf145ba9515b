//! Groups of ranks, which are ranks of their own.

use super::Ranks;
use crate::error::{Error, Result};

/// Ranks in groups. Each group has the whole scene, and each rank of a group has one shard of it. Rank r has shard `r
/// % shards` and is in group `r / shards`.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    /// All ranks.
    pub all: &'a dyn Ranks,
    /// Number of ranks in a group.
    pub shards: usize,
}

impl<'a> Grid<'a> {
    /// # Errors
    /// [`Error::Argument`] if `shards` does not divide the number of ranks.
    pub fn new(all: &'a dyn Ranks, shards: usize) -> Result<Self> {
        let size = all.size();
        if shards > 0 && size.is_multiple_of(shards) {
            return Ok(Self { all, shards });
        }
        let reason = format!("`--shards` must divide the number of ranks, {size}: found {shards}");
        Err(Error::Argument { reason })
    }

    /// All ranks in one group.
    pub fn one_group(all: &'a dyn Ranks) -> Self {
        Self { all, shards: all.size() }
    }

    /// Index of this rank's shard.
    pub fn shard(self) -> usize {
        self.all.rank() % self.shards
    }

    /// Index of this rank's group.
    pub fn group(self) -> usize {
        self.all.rank() / self.shards
    }

    /// Number of groups.
    pub fn groups(self) -> usize {
        self.all.size() / self.shards
    }

    /// The ranks of this rank's group.
    pub fn row(self) -> Group<'a> {
        let first = self.group() * self.shards;
        Group { all: self.all, first, step: 1, size: self.shards }
    }

    /// The ranks that have this rank's shard, one of each group.
    pub fn column(self) -> Group<'a> {
        Group { all: self.all, first: self.shard(), step: self.shards, size: self.groups() }
    }
}

/// The ranks `first`, `first + step`, and so on. A call of a group is a call of all ranks, so all groups of a
/// [`Grid`] must make the same calls at the same time.
#[derive(Clone, Copy, Debug)]
pub struct Group<'a> {
    all: &'a dyn Ranks,
    first: usize,
    step: usize,
    size: usize,
}

impl Group<'_> {
    fn members(&self) -> impl Iterator<Item = usize> {
        (self.first..).step_by(self.step).take(self.size)
    }

    fn is_all(&self) -> bool {
        self.size == self.all.size()
    }

    /// Each member sums a part of all values, and sends the sums to the others.
    fn reduce<T: bytemuck::Pod>(
        &self,
        values: &mut [T],
        combine: impl Fn(T, T) -> T,
    ) -> Result<()> {
        let len = values.len();
        let part = |member: usize| len * member / self.size..len * (member + 1) / self.size;
        let bytes = |values: &[T]| bytemuck::cast_slice(values).to_vec();
        let parts = self.exchange((0..self.size).map(|to| bytes(&values[part(to)])).collect())?;
        let mine = &mut values[part(self.rank())];
        for (_, other) in parts.iter().enumerate().filter(|(from, _)| *from != self.rank()) {
            let other: Vec<T> = bytemuck::pod_collect_to_vec(other);
            mine.iter_mut().zip(other).for_each(|(sum, value)| *sum = combine(*sum, value));
        }
        let sums = self.gather(bytes(mine))?;
        for (member, sums) in sums.iter().enumerate() {
            values[part(member)].copy_from_slice(&bytemuck::pod_collect_to_vec::<u8, T>(sums));
        }
        Ok(())
    }
}

impl Ranks for Group<'_> {
    fn rank(&self) -> usize {
        (self.all.rank() - self.first) / self.step
    }

    fn size(&self) -> usize {
        self.size
    }

    fn max(&self, values: &mut [u32]) -> Result<()> {
        if self.is_all() { self.all.max(values) } else { self.reduce(values, u32::max) }
    }

    fn or(&self, values: &mut [u32]) -> Result<()> {
        if self.is_all() { self.all.or(values) } else { self.reduce(values, |a, b| a | b) }
    }

    fn sum(&self, values: &mut [i64]) -> Result<()> {
        if self.is_all() { self.all.sum(values) } else { self.reduce(values, i64::wrapping_add) }
    }

    fn gather(&self, mine: Vec<u8>) -> Result<Vec<Vec<u8>>> {
        match self.is_all() {
            true => self.all.gather(mine),
            false => self.exchange(vec![mine; self.size]),
        }
    }

    fn exchange(&self, for_each: Vec<Vec<u8>>) -> Result<Vec<Vec<u8>>> {
        if self.size == 1 {
            return Ok(for_each);
        }
        let mut messages = vec![Vec::new(); self.all.size()];
        self.members().zip(for_each).for_each(|(member, bytes)| messages[member] = bytes);
        let mut received = self.all.exchange(messages)?;
        Ok(self.members().map(|member| std::mem::take(&mut received[member])).collect())
    }

    fn broadcast(&self, mine: Vec<u8>) -> Result<Vec<u8>> {
        let mine = if self.rank() == 0 { mine } else { Vec::new() };
        Ok(self.gather(mine)?.swap_remove(0))
    }

    fn fail(&self, message: &str) {
        self.all.fail(message);
    }

    fn sent(&self) -> u64 {
        self.all.sent()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ranks::ThreadRanks;

    /// Six ranks as three groups of two, two groups of three, and so on. Calls along rows and columns must stay in
    /// their group.
    #[test]
    fn groups_are_ranks_of_their_own() {
        for shards in [1, 2, 3, 6] {
            ThreadRanks::run(6, |ranks| {
                let grid = Grid::new(&ranks, shards).expect("a grid");
                let rank = ranks.rank();
                let first = ranks.rank() / shards * shards;
                let row: Vec<_> = (first..first + shards).collect();
                let column: Vec<_> = (rank % shards..6).step_by(shards).collect();
                // a call must not disturb the next
                for _ in 0..8 {
                    assert_calls(rank, grid.row(), &row);
                    assert_calls(rank, grid.column(), &column);
                    assert_eq!(ranks.broadcast(vec![rank as u8]).unwrap(), [0]);
                }
            });
        }
    }

    /// Asserts what a rank receives from every call of a group with these members.
    fn assert_calls(rank: usize, group: Group<'_>, members: &[usize]) {
        let place = members.iter().position(|&member| member == rank).expect("a member");
        assert_eq!((group.rank(), group.size()), (place, members.len()));
        // more values than members, and fewer
        for len in [0, 1, 7] {
            let value = |rank: usize, at: usize| (37 * rank + 11 * at) % 64;
            let values = |rank: usize| (0..len).map(move |at| value(rank, at));
            let of_all = |at: usize| members.iter().map(move |&member| value(member, at));
            let (mut max, mut or): (Vec<_>, Vec<_>) =
                values(rank).map(|value| (value as u32, value as u32)).unzip();
            let mut sum: Vec<_> = values(rank).map(|value| value as i64 - 32).collect();
            group.max(&mut max).unwrap();
            group.or(&mut or).unwrap();
            group.sum(&mut sum).unwrap();
            for at in 0..len {
                assert_eq!(max[at] as usize, of_all(at).max().unwrap());
                assert_eq!(or[at] as usize, of_all(at).fold(0, |all, value| all | value));
                assert_eq!(sum[at], of_all(at).map(|value| value as i64 - 32).sum::<i64>());
            }
        }
        let of_members = |bytes: &dyn Fn(usize) -> Vec<u8>| -> Vec<Vec<u8>> {
            members.iter().map(|&member| bytes(member)).collect()
        };
        let message = |from: usize, to: usize| vec![(10 * from + to) as u8; from];
        let gathered = group.gather(message(rank, 0)).unwrap();
        assert_eq!(gathered, of_members(&|member| message(member, 0)));
        let exchanged = group.exchange(of_members(&|member| message(rank, member))).unwrap();
        assert_eq!(exchanged, of_members(&|member| message(member, rank)));
        assert_eq!(group.broadcast(vec![rank as u8]).unwrap(), [members[0] as u8]);
    }

    #[test]
    fn groups_come_out_even() {
        let ranks = ThreadRanks::new(1).remove(0);
        for shards in [0, 2] {
            let error = Grid::new(&ranks, shards).unwrap_err().to_string();
            assert!(error.contains(&format!("the number of ranks, 1: found {shards}")), "{error}");
        }
    }
}
