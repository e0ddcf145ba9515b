//! Parses functions in the form that `spirv-dis` prints, and runs them.

use std::collections::HashMap;

use rspirv::dr::{Block, Builder, Instruction, Module, Operand};
use rspirv::grammar::INSTRUCTION_TABLE;
use rspirv::spirv::{
    AddressingModel, Capability, ExecutionMode, ExecutionModel, FunctionControl, LoopControl,
    MemoryModel, Op, SelectionControl, Word,
};

use crate::loops::{block, id, incoming, label};

/// A module with a function of `%a` and `%b`. Numbers up to 7, `%true`, `%false` and `%undefined` are constants.
pub fn module(text: &str) -> Module {
    let mut b = Builder::new();
    b.set_version(1, 5);
    b.capability(Capability::Shader);
    b.memory_model(AddressingModel::Logical, MemoryModel::GLSL450);
    let void = b.type_void();
    let uint = b.type_int(32, 0);
    let bool = b.type_bool();
    let mut ids = HashMap::from([("uint".to_owned(), uint), ("bool".to_owned(), bool)]);
    for value in 0..8 {
        ids.insert(value.to_string(), b.constant_bit32(uint, value));
    }
    ids.insert("true".into(), b.constant_true(bool));
    ids.insert("false".into(), b.constant_false(bool));
    ids.insert("undefined".into(), b.undef(uint, None));
    let kind = b.type_function(uint, [uint, uint]);
    b.begin_function(uint, None, FunctionControl::NONE, kind).unwrap();
    ids.insert("a".into(), b.function_parameter(uint).unwrap());
    ids.insert("b".into(), b.function_parameter(uint).unwrap());
    b.begin_block(None).unwrap();
    b.unreachable().unwrap();
    b.end_function().unwrap();
    let kind = b.type_function(void, []);
    let main = b.begin_function(void, None, FunctionControl::NONE, kind).unwrap();
    b.begin_block(None).unwrap();
    b.ret().unwrap();
    b.end_function().unwrap();
    b.entry_point(ExecutionModel::GLCompute, main, "main", []);
    b.execution_mode(main, ExecutionMode::LocalSize, [1, 1, 1]);
    let mut module = b.module();
    let bound = &mut module.header.as_mut().unwrap().bound;
    let mut blocks = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty()) {
        let instruction = read(line, &mut |name| {
            *ids.entry(name.to_owned()).or_insert_with(|| {
                *bound += 1;
                *bound - 1
            })
        });
        if instruction.class.opcode == Op::Label {
            blocks.push(Block { label: Some(instruction), instructions: Vec::new() });
        } else {
            let block = blocks.last_mut().expect("a function begins with a label");
            block.instructions.push(instruction);
        }
    }
    module.functions[0].blocks = blocks;
    module
}

/// One line: `%result = OpName %type %operand ..`
fn read(line: &str, number: &mut impl FnMut(&str) -> Word) -> Instruction {
    let (result, rest) = match line.split_once(" = ") {
        Some((result, rest)) => (Some(number(&result[1..])), rest),
        None => (None, line),
    };
    let mut words = rest.split_whitespace();
    let name = words.next().and_then(|word| word.strip_prefix("Op")).expect("an instruction");
    let class = INSTRUCTION_TABLE.iter().find(|class| class.opname == name);
    let opcode = class.expect("an instruction of SPIR-V").opcode;
    let mut operands: Vec<Operand> = words
        .map(|word| match (word.strip_prefix('%'), opcode) {
            (Some(name), _) => Operand::IdRef(number(name)),
            (None, Op::LoopMerge) => Operand::LoopControl(LoopControl::NONE),
            (None, Op::SelectionMerge) => Operand::SelectionControl(SelectionControl::NONE),
            (None, _) => Operand::LiteralBit32(word.parse().expect("a number")),
        })
        .collect();
    let kind = match (result, opcode) {
        (None, _) | (_, Op::Label) => None,
        _ => operands.remove(0).id_ref_any(),
    };
    Instruction::new(opcode, kind, result, operands)
}

/// Runs the first function of a module. Returns its result, and every operation in order, with its arguments. An
/// undefined value is a number that nothing else produces.
pub fn run(module: &Module, a: u32, b: u32) -> (u32, Vec<(Op, Vec<u32>)>) {
    let function = &module.functions[0];
    let mut values = HashMap::new();
    for constant in &module.types_global_values {
        let value = match (constant.class.opcode, constant.operands.first()) {
            (Op::Constant, Some(&Operand::LiteralBit32(value))) => value,
            (Op::ConstantTrue, _) => 1,
            (Op::ConstantFalse, _) => 0,
            (Op::Undef, _) => 0xdead,
            _ => continue,
        };
        values.insert(constant.result_id.unwrap(), value);
    }
    for (parameter, value) in function.parameters.iter().zip([a, b]) {
        values.insert(parameter.result_id.unwrap(), value);
    }
    let mut trace = Vec::new();
    let mut from = 0;
    let mut at = label(&function.blocks[0]);
    for _ in 0..1000 {
        let all = &block(function, at).instructions;
        let (phis, rest): (Vec<_>, Vec<_>) = all.iter().partition(|i| i.class.opcode == Op::Phi);
        let chosen = phis.iter().map(|phi| values[&incoming(phi, from).expect("a value")]);
        for (phi, value) in phis.iter().zip(chosen.collect::<Vec<_>>()) {
            values.insert(phi.result_id.unwrap(), value);
        }
        for instruction in rest {
            let value = |at| values[&id(instruction, at)];
            let next = match instruction.class.opcode {
                Op::SelectionMerge | Op::LoopMerge => continue,
                Op::Branch => id(instruction, 0),
                Op::BranchConditional => id(instruction, if value(0) == 1 { 1 } else { 2 }),
                Op::Switch => {
                    let matches = instruction.operands[2] == Operand::LiteralBit32(value(0));
                    id(instruction, if matches { 3 } else { 1 })
                }
                Op::Select => {
                    let chosen = value(if value(0) == 1 { 1 } else { 2 });
                    values.insert(instruction.result_id.unwrap(), chosen);
                    continue;
                }
                Op::ReturnValue => return (value(0), trace),
                opcode => {
                    let arguments = vec![value(0), value(1)];
                    let result = operation(opcode, &arguments);
                    trace.push((opcode, arguments));
                    values.insert(instruction.result_id.unwrap(), result);
                    continue;
                }
            };
            from = at;
            at = next;
        }
    }
    panic!("a loop does not end");
}

fn operation(opcode: Op, arguments: &[u32]) -> u32 {
    let [a, b] = *arguments else { panic!("{opcode:?} has two arguments") };
    match opcode {
        Op::IAdd => a + b,
        Op::ULessThan => (a < b).into(),
        Op::ULessThanEqual => (a <= b).into(),
        Op::IEqual => (a == b).into(),
        _ => panic!("{opcode:?} is not known here"),
    }
}
