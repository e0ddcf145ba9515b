//! Explains an error of the SPIR-V compiler in words of ours, with the kernel and its line. Its own words follow.

use std::fs;
use std::path::Path;

use muslin_kernel::{KernelInfo, kernels};
use rspirv::dr::{self, Operand};

/// Parts of the compiler's messages, and our words for them.
const CAUSES: [(&str, &str); 20] = [
    (
        "used from within `<[",
        "GPUs have no slices; take the elements of an array by an index, or loop over it with `for`",
    ),
    (
        "function pointer",
        "GPUs call no function by its address; write a `match`, or a generic function",
    ),
    ("`f64` type", "GPUs lack `f64`; use `f32`"),
    (
        "raw_eq",
        "arrays are compared, by `==` or within a struct with `PartialEq`; compare their elements",
    ),
    (
        "case for source block",
        "two values are matched together, as in `zip` of two options, in which the compiler is wrong; write one `match` or `if let` within the other",
    ),
    (
        "PolymorphicIter",
        "an array becomes an iterator, and GPUs have no pointers; give it a name with `let`, and loop over it with `for`",
    ),
    (
        "cannot memcpy",
        "a value moves through a pointer, as in an enum within an enum (`Option<Result<..>>`) or in a slice; make it one enum, or use variables",
    ),
    (
        "to `*[",
        "an array becomes a slice, and GPUs have no pointers; take its elements by an index, or loop over it with `for`",
    ),
    (
        "found for type `f32`",
        "core lacks it; `muslin::math` has `floor`, `ceil`, `round`, `truncate`, `sqrt`, `exp` and others",
    ),
    ("to `*i8`", OF_SMALL_INTEGERS),
    ("to `*i16`", OF_SMALL_INTEGERS),
    (
        "cannot cast between pointer types",
        "a value changes its type through a pointer, which GPUs lack; an enum's variants have data of the same types, or use a struct of numbers",
    ),
    (
        "cannot offset a pointer",
        "a value is at a place that no type says, as in an enum of which one variant has a vector, or in a `dyn`; give the variant numbers, or use a struct",
    ),
    (
        "Bitcast",
        "an array of bytes, or the `bool` of an option or of compared tuples, becomes an integer; use `u32`, and shift",
    ),
    ("(signal: ", "the compiler crashes; leave out parts of the kernel to find which one it is"),
    ("globals are not", "GPUs have no `static`; make it a `const`"),
    (
        "Expected Constituents to be scalars",
        "a vector of `u32` is shifted by an `i32`, as a bare number is; write `v >> 3_u32`",
    ),
    (
        "unsupported unsized",
        "there is a slice, or a text as of a panic, and GPUs have none; give an array its length, `&[u32; 4]`",
    ),
    (
        "not implemented yet",
        "the compiler for GPUs lacks a method of integers; `muslin::math` has some",
    ),
    (
        "not supported yet",
        "the compiler for GPUs lacks a method of integers; `muslin::math` has some",
    ),
];

const OF_SMALL_INTEGERS: &str =
    "the compiler for GPUs has this method for 32 bits alone; write it of `x as i32`";

/// Most lines of the compiler's own words.
const LINES: usize = 30;

/// The message for what the compiler has said of the crate of kernels. `crashed` is the entry point in which it has ended without a word.
pub fn explain(said: &str, crashed: Option<&str>, root: &Path) -> String {
    let lines: Vec<_> = said.lines().collect();
    let begin = lines.iter().position(|line| line.starts_with("error")).unwrap_or(0);
    let error = &lines[begin..];
    // the first of several
    let is_start = |line: &&str| line.starts_with("error");
    let end = error.iter().skip(1).position(is_start).map_or(error.len(), |end| end + 1);
    let error = &error[..end];
    let headline = error.first().copied().unwrap_or("it says nothing");
    let headline = headline.split_once(": ").map_or(headline, |(_, headline)| headline);
    let user = error.iter().find(|line| line.contains("used from within"));
    let first = error.iter().take_while(|line| !line.contains("--> ")).chain(user);
    let has = |part: &&(&str, &str)| first.clone().any(|line| line.contains(part.0));
    let cause = CAUSES.iter().find(has);
    let cause = cause.map_or(headline, |(_, cause)| cause);
    let place = error.iter().find_map(|line| place(line));
    let named = error.iter().rev().find_map(|line| kernel(line));
    let named = named.or_else(|| error.iter().rev().find_map(|line| function(said, line)));
    let named = named.or_else(|| crashed.map(str::to_owned));
    let start = match (place, named) {
        (Some((file, line)), Some(name)) => format!("{file}:{line}: in `{name}`: "),
        (Some((file, line)), None) => format!("{file}:{line}: "),
        (None, Some(name)) => declaration(&name, root) + &format!("in `{name}`: "),
        // a crash of the compiler, as of `raw_eq`, says nothing of the place
        (None, None) => String::new(),
    };
    let rest = error.len().saturating_sub(LINES);
    let mut words = error[..error.len() - rest].join("\n  ");
    if rest > 0 {
        words += &format!("\n  and {rest} more lines");
    }
    format!("{start}{cause}. The compiler behind says:\n  {words}")
}

/// The file and the line that a line names, if it is one of the workspace's own.
fn place(line: &str) -> Option<(&str, usize)> {
    let (_, place) = line.split_once("--> ")?;
    let (place, _) = place.rsplit_once(':')?;
    let (file, line) = place.rsplit_once(':')?;
    let file = file.trim_matches(['<', '>']);
    (Path::new(file).is_relative() && !file.starts_with("..")).then_some((file, line.parse().ok()?))
}

/// The kernel that a line names: as the last one who calls, or by its module.
fn kernel(line: &str) -> Option<String> {
    let called = line.split_once("called by `").and_then(|(_, name)| name.split_once('`'));
    let module = line.split_once(".spvs/").and_then(|(_, name)| name.split_once(".spv"));
    let (name, _) = called.or(module)?;
    kernel_of(name).map(|_| name.to_owned())
}

/// The kernel that has an entry point of this name.
fn kernel_of(name: &str) -> Option<&'static KernelInfo> {
    kernels().find(|kernel| kernel.entry_points().any(|point| point.name == name))
}

/// The entry point with the block that a line names by its id, `(in %7)`, in the module that the compiler has saved.
fn function(said: &str, line: &str) -> Option<String> {
    let (_, id) = line.split_once(" in %")?;
    let id = id.split_once(')')?.0.parse().ok();
    let (_, path) = said.split_once("module was saved to ")?;
    let module = dr::load_bytes(fs::read(path.lines().next()?.trim()).ok()?).ok()?;
    let has_it =
        |function: &&dr::Function| function.blocks.iter().any(|block| block.label_id() == id);
    let found = module.functions.iter().find(has_it)?.def_id()?;
    let point =
        module.entry_points.iter().find(|point| point.operands.contains(&Operand::IdRef(found)))?;
    match &point.operands[2] {
        Operand::LiteralString(name) => Some(name.clone()),
        _ => None,
    }
}

/// The file of a kernel, with the line of its function.
pub fn declaration(name: &str, root: &Path) -> String {
    let Some(kernel) = kernel_of(name) else { return String::new() };
    let file = kernel.source();
    let text = fs::read_to_string(root.join(&file)).unwrap_or_default();
    let function = format!("fn {}", kernel.name);
    match text.lines().position(|line| line.contains(&function)) {
        Some(line) => format!("{file}:{}: ", line + 1),
        None => format!("{file}: "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the compiler says of `array.iter().sum()`, of bytes, and of a mistake in Rust.
    #[test]
    fn messages_begin_with_the_place_and_words_of_ours() {
        for (said, expected) in [
            (
                "   Compiling kernels\nerror: cannot cast between pointer types\n       from `*[u32; 3]`\n         to `*[u32]`\n   --> </lib/core/array.rs>:34:6\n \
                 note: called by `kernels::count_fill`\n --> <src/lib.rs>:7:43\nnote: called by `count_fill`\n",
                "src/lib.rs:7: in `count_fill`: an array becomes a slice",
            ),
            (
                "error: Expected Result Type to be a pointer: Bitcast\n  = note: module `/target/kernels.spvs/count_fill.spv`\n",
                "src/count.rs: in `count_fill`: an array of bytes, or the `bool` of an option",
            ),
            (
                "error[E0599]: no method named `sinh`\n --> src/lib.rs:2:7\n",
                "src/lib.rs:2: no method named `sinh`. The compiler behind says:\n  error[E0599]",
            ),
            (
                "error: cannot cast between pointer types\n --> </core/slice/mod.rs>:156:58\nnote: used from within `<[u32]>::first`\n \
                 note: called by `kernels::count_fill`\n --> <src/lib.rs>:7:43\nnote: called by `count_fill`\n",
                "src/lib.rs:7: in `count_fill`: GPUs have no slices",
            ),
            (
                "error: could not compile `kernels` (lib)\n\nCaused by:\n  rustc (signal: 6, SIGABRT)\n",
                "in `count_fill`: the compiler crashes; leave out parts",
            ),
            (
                "error: internal compiler error: raw_eq must be overridden\n",
                "arrays are compared, by `==` or within a struct",
            ),
        ] {
            let crashed = Some("count_fill").filter(|_| said.contains("signal"));
            let message = explain(said, crashed, Path::new("."));
            assert!(message.contains(expected), "{message}");
        }
    }
}
