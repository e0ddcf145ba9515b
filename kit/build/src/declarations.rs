//! Orders the declarations of a module by their first use, and leaves out what nothing uses.
//!
//! The compiler declares the types and constants of all kernels together. Without this, a change in one kernel would move declarations in
//! the modules of others: `.ci/run` adds a kernel, and compares them.

use std::collections::{BTreeSet, HashMap};

use rspirv::dr::{Instruction, Module, Operand};
use rspirv::spirv::{Decoration, Op, StorageClass, Word};

/// Orders types, constants and global variables, and everything that lists them.
pub fn sort(module: &mut Module) {
    let mut order = Order::default();
    for instruction in std::mem::take(&mut module.types_global_values) {
        if let Some(id) = instruction.result_id {
            order.unsorted.insert(id, instruction);
        }
    }
    for function in &module.functions {
        function.all_inst_iter().for_each(|instruction| order.visit(instruction));
    }
    // built-in variables that no instruction uses
    module.entry_points.iter().for_each(|instruction| order.visit(instruction));
    let Order { ranks, sorted, .. } = order;
    let rank = |operand: &Operand| operand.id_ref_any().and_then(|id| ranks.get(&id).copied());
    let key = |instruction: &Instruction| {
        let rest: Vec<_> = instruction.operands[1..].iter().map(ToString::to_string).collect();
        (rank(&instruction.operands[0]), rest)
    };
    for list in [&mut module.annotations, &mut module.debug_names] {
        list.retain(|instruction| rank(&instruction.operands[0]).is_some());
        list.sort_by_cached_key(key);
    }
    for entry_point in &mut module.entry_points {
        // the model, the function and the name come before the variables
        entry_point.operands[3..].sort_by_key(rank);
    }
    for list in [&mut module.capabilities, &mut module.extensions] {
        list.sort_by_cached_key(|instruction| instruction.operands[0].to_string());
    }
    module.types_global_values = sorted;
}

/// Replaces ids.
pub fn rename<'a>(
    instructions: impl IntoIterator<Item = &'a mut Instruction>,
    names: &HashMap<Word, Word>,
) {
    for instruction in instructions {
        let operands = instruction.operands.iter_mut().filter_map(|operand| match operand {
            Operand::IdRef(id) => Some(id),
            _ => None,
        });
        for id in operands.chain(&mut instruction.result_type) {
            *id = *names.get(id).unwrap_or(id);
        }
    }
}

/// Declares each type once, after passes that add or change some. Structs and arrays have a layout, and remain.
pub fn merge_types(module: &mut Module) {
    let mut first = HashMap::new();
    let mut names = HashMap::new();
    module.types_global_values.retain_mut(|of| {
        rename([&mut *of], &names);
        let is_unique = [Op::TypeInt, Op::TypeVector, Op::TypePointer, Op::TypeFunction];
        let (true, Some(id)) = (is_unique.contains(&of.class.opcode), of.result_id) else {
            return true;
        };
        let key = format!("{:?} {:?}", of.class.opcode, of.operands);
        let kept = *first.entry(key).or_insert(id);
        if kept != id {
            names.insert(id, kept);
        }
        kept == id
    });
    rename(module.all_inst_iter_mut(), &names);
}

/// The types of memory that the host fills or reads, and their parts.
pub fn host_types(module: &Module) -> BTreeSet<Word> {
    let declared = |id: Word| {
        module.types_global_values.iter().find(move |instruction| instruction.result_id == Some(id))
    };
    let is_of_host = |variable: &&Instruction| match variable.operands.first() {
        Some(Operand::StorageClass(of)) => {
            matches!(of, StorageClass::StorageBuffer | StorageClass::Uniform)
        }
        _ => false,
    };
    let variables = module.types_global_values.iter().filter(is_of_host);
    let variables = variables.filter(|variable| variable.class.opcode == Op::Variable);
    let mut left: Vec<_> = variables.filter_map(|variable| variable.result_type).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = left.pop() {
        if seen.insert(id) {
            let operands = declared(id).into_iter().flat_map(|of| &of.operands);
            left.extend(operands.filter_map(Operand::id_ref_any));
        }
    }
    seen
}

/// Drops the layouts of types that only the kernel knows. The compiler packs them as Rust does, in bytes that naga refuses.
pub fn drop_layouts(module: &mut Module) {
    let of_host = host_types(module);
    module.annotations.retain(|annotation| {
        let is_layout = annotation.operands.iter().any(|operand| {
            matches!(operand, Operand::Decoration(Decoration::Offset | Decoration::ArrayStride))
        });
        let of = annotation.operands[0].id_ref_any();
        !is_layout || of.is_some_and(|id| of_host.contains(&id))
    });
}

/// Declarations in the order of their first use.
#[derive(Default)]
struct Order {
    unsorted: HashMap<Word, Instruction>,
    sorted: Vec<Instruction>,
    /// How many ids came before an id.
    ranks: HashMap<Word, usize>,
}

impl Order {
    /// Declares what an instruction uses, and the id that it defines.
    fn visit(&mut self, instruction: &Instruction) {
        let operands = instruction.operands.iter().filter_map(Operand::id_ref_any);
        let uses: Vec<_> = instruction.result_type.into_iter().chain(operands).collect();
        for id in uses {
            self.declare(id);
        }
        self.rank(instruction.result_id);
    }

    /// Declares an id, after everything that its declaration uses. Ids of functions are declared there.
    fn declare(&mut self, id: Word) {
        if let Some(instruction) = self.unsorted.remove(&id) {
            self.visit(&instruction);
            self.sorted.push(instruction);
        }
    }

    fn rank(&mut self, id: Option<Word>) {
        let next = self.ranks.len();
        if let Some(id) = id {
            self.ranks.entry(id).or_insert(next);
        }
    }
}

/// Numbers all ids in order of appearance, starting at 1. The compiler numbers the ids of all kernels together: without this, a
/// change in one kernel would give others new numbers.
pub fn renumber(module: &mut Module) {
    let mut numbers: HashMap<Word, Word> = HashMap::new();
    let mut number = |id: &mut Word| {
        let next = numbers.len() as Word + 1;
        *id = *numbers.entry(*id).or_insert(next);
    };
    for instruction in module.all_inst_iter_mut() {
        instruction.result_type.iter_mut().for_each(&mut number);
        instruction.result_id.iter_mut().for_each(&mut number);
        for operand in &mut instruction.operands {
            match operand {
                Operand::IdRef(id) | Operand::IdScope(id) | Operand::IdMemorySemantics(id) => {
                    number(id);
                }
                _ => {}
            }
        }
    }
    let bound = numbers.len() as Word + 1;
    if let Some(header) = &mut module.header {
        header.bound = bound;
    }
}
