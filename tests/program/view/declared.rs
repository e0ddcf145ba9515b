//! What the page declares of its protocol, against what the program sends.

use std::collections::BTreeMap;

use serde_json::Value;

const PROTOCOL: &str = include_str!("../../../host/view/src/page/protocol.d.ts");
const WEB: &str = include_str!("../../../host/view/src/web/page/types.d.ts");

/// The types of answers, by their paths. A frame's is in its head.
const ANSWERS: [(&str, &str); 7] = [
    ("/scene.json", "Scene"),
    ("/explain", "Explanation"),
    ("/edit", "EditAnswer"),
    ("/places", "PlacedScene"),
    ("/path", "Cameras"),
    ("/keyframes", "Cameras"),
    ("/training.json", "TrainingState"),
];

/// The fields of an interface and their types; `None` if it is no interface.
fn fields(name: &str) -> Option<BTreeMap<&'static str, &'static str>> {
    let head = format!("export interface {name} {{\n");
    let rest = [PROTOCOL, WEB].into_iter().find_map(|text| text.split(&*head).nth(1))?;
    let (body, _) = rest.split_once("\n}")?;
    let lines = body.lines().map(str::trim).filter(|line| !line.starts_with("/**"));
    lines.map(|line| line.trim_end_matches(';').split_once(": ")).collect()
}

/// Asserts that these are the fields of an interface.
pub fn assert_fields(name: &str, found: &Value) {
    let mut found: Vec<_> =
        found.as_array().expect("names").iter().filter_map(Value::as_str).collect();
    found.sort_unstable();
    assert!(fields(name).expect("an interface").into_keys().eq(found), "{name}");
}

/// Asserts that a value has the declared fields of an interface, and no others; of a list, each value.
pub fn assert_declared(name: &str, value: &Value) {
    if let Value::Array(values) = value {
        return values.iter().for_each(|value| assert_declared(name, value));
    }
    let Some(mut declared) = fields(name) else { return };
    for (field, value) in value.as_object().unwrap_or_else(|| panic!("{name}: {value}")) {
        let found = declared.remove(&**field).or(declared.remove(&*format!("{field}?")));
        let kind = found.unwrap_or_else(|| panic!("the page does not declare `{field}` of {name}"));
        let is_null = value.is_null() && kind.ends_with(" | null");
        if !is_null {
            assert_declared(kind.trim_end_matches(" | null").trim_end_matches("[]"), value);
        }
    }
    declared.retain(|field, _| !field.ends_with('?'));
    assert!(declared.is_empty(), "the program does not send {declared:?} of {name}");
}

/// Asserts that an answer is what the page declares.
pub fn assert_answer(path: &str, headers: &str, body: &[u8]) {
    if path == "/frame" {
        let about = headers.lines().find_map(|line| line.strip_prefix("x-organza: "));
        let about = serde_json::from_str(about.expect("a head")).expect("JSON");
        assert_declared("FrameAbout", &about);
    }
    if let Some((_, name)) = ANSWERS.into_iter().find(|(answered, _)| *answered == path) {
        assert_declared(name, &serde_json::from_slice(body).expect("JSON"));
    }
}

/// The page's elements have the declared ids.
#[test]
fn the_page_declares_its_elements() {
    let page = include_str!("../../../host/view/src/page/index.html");
    let declared = include_str!("../../../host/view/src/page/elements.d.ts");
    let ids = page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let names = declared.lines().filter_map(|line| line.strip_prefix("  ")?.split_once(": HTML"));
    let names = names.map(|(name, _)| name.trim_matches('"'));
    assert_eq!(ids.collect::<Vec<_>>(), names.collect::<Vec<_>>());
}
