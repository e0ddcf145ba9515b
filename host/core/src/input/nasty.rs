//! JSON values that parsers stumble over, and a way to put them anywhere.

use proptest::prelude::*;
use proptest::sample::Index;
use serde_json::{Value, json};

/// Wrong types, and numbers at the edges of every range.
pub fn nasty_value() -> impl Strategy<Value = Value> {
    let edges = vec![
        json!(null),
        json!(true),
        json!("text"),
        json!([]),
        json!({}),
        json!([[1e300]]),
        json!(0),
        json!(-1),
        json!(1),
        json!(0.5),
        json!(-0.0),
        json!(f64::MIN_POSITIVE),
        json!(f64::MAX),
        json!(1e39),
        json!(u32::MAX),
        json!(u64::MAX),
        json!(i64::MIN),
        json!(i64::MAX / 12),
    ];
    prop_oneof![
        prop::sample::select(edges),
        any::<f64>().prop_map(|number| json!(number)),
        any::<i64>().prop_map(|number| json!(number)),
        (0..40).prop_map(|number| json!(number)),
    ]
}

/// Replaces one value at any depth.
pub fn replace_value(root: &mut Value, place: Index, with: Value) {
    let mut pointers = Vec::new();
    collect(root, String::new(), &mut pointers);
    let pointer = &pointers[place.index(pointers.len())];
    if let Some(value) = root.pointer_mut(pointer) {
        *value = with;
    }
}

fn collect(value: &Value, pointer: String, pointers: &mut Vec<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                collect(value, format!("{pointer}/{key}"), pointers);
            }
        }
        Value::Array(array) => {
            for (index, value) in array.iter().enumerate() {
                collect(value, format!("{pointer}/{index}"), pointers);
            }
        }
        _ => {}
    }
    pointers.push(pointer);
}
