//! Reads RADV's assembly.

use serde::{Deserialize, Serialize};

/// An innermost loop.
#[derive(Debug, Serialize, Deserialize)]
pub struct Loop {
    /// All its instructions.
    pub instructions: usize,
    /// Copies from one vector register to another.
    pub moves: usize,
    /// Multiply-adds of floats.
    pub multiply_adds: usize,
    /// Multiplications of 32-bit integers.
    pub integer_multiplies: usize,
    /// Loads of one value for each invocation, from buffers and from workgroup memory.
    pub loads: usize,
    /// Loads of values that are the same for the whole subgroup.
    pub scalar_loads: usize,
    /// The text.
    pub text: String,
}

/// A block without branches, but for its end.
struct Block<'a> {
    label: &'a str,
    lines: Vec<&'a str>,
}

/// The innermost loops of a kernel, the largest first.
pub fn loops(assembly: &str) -> Vec<Loop> {
    let blocks = blocks(assembly);
    let mut spans = Vec::new();
    for (end, block) in blocks.iter().enumerate() {
        for line in &block.lines {
            let target = line.strip_prefix("s_").and_then(|_| line.split_whitespace().nth(1));
            let is_branch = line.starts_with("s_branch") || line.starts_with("s_cbranch");
            let start = blocks[..=end].iter().position(|block| Some(block.label) == target);
            spans.extend(start.filter(|_| is_branch).map(|start| (start, end)));
        }
    }
    // A loop may branch back from several places.
    let merged: Vec<(usize, usize)> = spans
        .iter()
        .map(|&(start, _)| (start, spans.iter().filter(|s| s.0 == start).map(|s| s.1).max()))
        .filter_map(|(start, end)| Some((start, end?)))
        .collect();
    let contains = |a: &(usize, usize), b: &(usize, usize)| a != b && a.0 <= b.0 && b.1 <= a.1;
    let mut innermost: Vec<_> =
        merged.iter().filter(|&a| !merged.iter().any(|b| contains(a, b))).collect();
    innermost.dedup();
    let mut loops: Vec<Loop> =
        innermost.iter().map(|&&(start, end)| measure(&blocks[start..=end])).collect();
    loops.sort_by_key(|it| std::cmp::Reverse(it.instructions));
    loops
}

/// The multiplications of integers that a GPU takes long for: products of numbers of 24 bits are not among them.
pub fn integer_multiplies(assembly: &str) -> usize {
    let all = blocks(assembly);
    all.iter().map(|block| count(&block.lines, &INTEGER_MULTIPLIES)).sum()
}

const INTEGER_MULTIPLIES: [&str; 4] = ["v_mul_lo_", "v_mul_hi_", "v_mad_u64_", "v_mad_i64_"];

/// How many lines begin with one of these names.
fn count(lines: &[&str], names: &[&str]) -> usize {
    lines.iter().filter(|line| names.iter().any(|name| line.starts_with(name))).count()
}

/// Splits a text such as `BB3:`, then lines such as `s_add_u32 s0, s6, s7 ; 80000706`.
fn blocks(assembly: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    for line in assembly.lines() {
        if let Some(label) = line.strip_suffix(':').filter(|label| label.starts_with("BB")) {
            blocks.push(Block { label, lines: Vec::new() });
        } else if let (Some(block), Some(line)) = (blocks.last_mut(), line.strip_prefix('\t')) {
            block.lines.push(line.split(';').next().unwrap_or_default().trim_end());
        }
    }
    blocks
}

/// A whole kernel, without the words that its instructions become.
pub fn text(assembly: &str) -> String {
    text_of(&blocks(assembly))
}

fn text_of(blocks: &[Block<'_>]) -> String {
    let text = blocks.iter().map(|block| {
        let lines: String = block.lines.iter().map(|line| format!("    {line}\n")).collect();
        format!("{}:\n{lines}", block.label)
    });
    text.collect()
}

fn measure(blocks: &[Block<'_>]) -> Loop {
    let lines: Vec<&str> = blocks.iter().flat_map(|block| &block.lines).copied().collect();
    let count = |names: &[&str]| count(&lines, names);
    Loop {
        instructions: lines.len(),
        moves: count(&["v_mov_"]),
        multiply_adds: count(&["v_fma", "v_mac_f", "v_mad_f", "v_pk_fma", "v_madmk", "v_madak"]),
        integer_multiplies: count(&INTEGER_MULTIPLIES),
        loads: count(&["buffer_load", "global_load", "ds_read"]),
        scalar_loads: count(&["s_buffer_load", "s_load"]),
        text: text_of(blocks),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_LOOPS: &str = "
BB0:
\ts_mov_b32 s0, s3                 ; be800303
BB1:
\tv_mov_b32_e32 v0, v1             ; 7e000301
BB2:
\tbuffer_load_dword v2, v3, s[0:3], 0 offen ; e0301000 80010302
\tv_fmac_f32_e32 v0, v2, v2        ; 56000502
\tv_mul_lo_u32 v1, v1, s11         ; d5690001
\ts_cbranch_scc1 BB2               ; bf85fffc
BB3:
\ts_branch BB1                     ; bf82fff8
BB4:
\ts_buffer_load_dword s0, s[12:15], null ; f4200006 fa000000
\ts_cbranch_execz BB6              ; bf880001
BB5:
\ts_branch BB4                     ; bf82fffc
BB6:
\ts_endpgm                         ; bf810000
";

    #[test]
    fn the_loops_that_hold_no_other_are_found() {
        let found = loops(TWO_LOOPS);
        let sizes: Vec<_> = found.iter().map(|it| it.instructions).collect();
        // that of BB1 has the one of BB2 within, and a branch forward is none
        assert_eq!(sizes, [4, 3]);
        let [inner, last] = &found[..] else { panic!() };
        let counts = |it: &Loop| {
            [it.moves, it.multiply_adds, it.integer_multiplies, it.loads, it.scalar_loads]
        };
        assert_eq!(counts(inner), [0, 1, 1, 1, 0]);
        assert_eq!(counts(last), [0, 0, 0, 0, 1]);
        assert_eq!(integer_multiplies(TWO_LOOPS), 1);
        assert!(text(TWO_LOOPS).ends_with("BB6:\n    s_endpgm\n"));
        assert!(inner.text.starts_with("BB2:\n    buffer_load_dword v2, v3, s[0:3], 0 offen\n"));
    }
}
