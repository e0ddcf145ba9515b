//! SPIR-V as a list of instructions.

/// One instruction of a module.
#[derive(Clone, Copy, Debug)]
pub struct Instruction<'a> {
    /// Index of its first word in the module.
    pub at: usize,
    /// Opcode in the specification.
    pub opcode: u32,
    /// Words after the first one.
    pub operands: &'a [u32],
}

/// The instructions of a module.
pub fn instructions(words: &[u32]) -> impl Iterator<Item = Instruction<'_>> {
    const HEADER: usize = 5;
    let mut at = HEADER;
    std::iter::from_fn(move || {
        let length = (words.get(at)? >> 16) as usize;
        let opcode = words[at] & 0xffff;
        let found = Instruction { at, opcode, operands: &words[at + 1..at + length] };
        at += length;
        Some(found)
    })
}
