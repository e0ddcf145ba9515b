//! Makes integers of the `bool`s in workgroup memory: through naga, an NVIDIA H200 always reads `false` there.

use std::collections::{BTreeMap, BTreeSet};

use rspirv::dr::{Builder, Module, Operand};
use rspirv::spirv::{Op, StorageClass};

use crate::declarations::merge_types;
use crate::module::rewrite;

/// Widens single values and arrays. A value is 1 or 0.
pub fn widen(module: &mut Module) {
    let mut builder = Builder::new_from_module(std::mem::take(module));
    let word = builder.type_int(32, 0);
    let [zero, one] = [0, 1].map(|value| builder.constant_bit32(word, value));
    let mut wide = BTreeMap::from([(builder.type_bool(), word)]);
    for of in builder.module_ref().types_global_values.clone() {
        if let (Op::TypeArray, Some(array), &[Operand::IdRef(element), Operand::IdRef(len)]) =
            (of.class.opcode, of.result_id, &of.operands[..])
            && let Some(&widened) = wide.get(&element)
        {
            wide.insert(array, builder.type_array(widened, len));
        }
    }
    *module = builder.module();
    let mut pointers = BTreeSet::new();
    for of in &mut module.types_global_values {
        if let (
            Op::TypePointer,
            Some(pointer),
            [Operand::StorageClass(StorageClass::Workgroup), Operand::IdRef(to)],
        ) = (of.class.opcode, of.result_id, &mut of.operands[..])
            && let Some(widened) = wide.get(to)
        {
            *to = *widened;
            pointers.insert(pointer);
        }
    }
    if pointers.is_empty() {
        return;
    }
    let places =
        module.all_inst_iter().filter(|of| of.result_type.is_some_and(|of| pointers.contains(&of)));
    let places: BTreeSet<_> = places.filter_map(|of| of.result_id).collect();
    rewrite(module, |writer, mut of| {
        let result = of.result_type.zip(of.result_id);
        match (of.class.opcode, result, &mut of.operands[..]) {
            (Op::Load, Some((kind, id)), [Operand::IdRef(place), ..]) if places.contains(place) => {
                let loaded = writer.add(Op::Load, word, &[*place]);
                writer.push(Op::INotEqual, kind, id, &[loaded, zero]);
            }
            (Op::Store, None, [Operand::IdRef(place), Operand::IdRef(value), ..])
                if places.contains(place) =>
            {
                *value = writer.add(Op::Select, word, &[*value, one, zero]);
                writer.instructions.push(of);
            }
            _ => writer.instructions.push(of),
        }
    });
    merge_types(module);
}
