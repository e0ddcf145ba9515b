//! Reports as text.

use std::fmt;

use crate::{Kernel, Report};

/// One line for each kernel. A line depends on nothing but its kernel.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{}, {}; of the largest innermost loop on the right",
            self.family, self.driver
        )?;
        writeln!(
            f,
            "{:28} {:>9} {:>6} {:>7} {:>6} {:>9} {:>12} {:>4} | {:>12} {:>5} {:>4} {:>4} {:>5} {:>12}",
            "kernel",
            "registers",
            "spills",
            "scratch",
            "shared",
            "subgroups",
            "instructions",
            "imul",
            "instructions",
            "moves",
            "fma",
            "imul",
            "loads",
            "scalar loads"
        )?;
        self.kernels.iter().try_for_each(|kernel| kernel.write(f))
    }
}

impl Kernel {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, registers, spills, scratch, shared, subgroups, instructions, .. } = self;
        write!(
            f,
            "{name:28} {registers:>9} {spills:>6} {scratch:>7} {shared:>6} {subgroups:>9} \
             {instructions:>12} {:>4} |",
            self.integer_multiplies
        )?;
        if let Some(hot) = self.loops.first() {
            write!(
                f,
                " {:>12} {:>5} {:>4} {:>4} {:>5} {:>12}",
                hot.instructions,
                hot.moves,
                hot.multiply_adds,
                hot.integer_multiplies,
                hot.loads,
                hot.scalar_loads
            )?;
        }
        writeln!(f)
    }
}
