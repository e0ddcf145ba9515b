//! What the facts about a file look like as text.

use serde_json::Value;

use crate::cli::summary::{Table, grouped, number};

/// Most rows of a table, which could have as many as a data set has photographs.
const MAX_ROWS: usize = 24;

/// Facts under the names that `--json` has for them: a line for each, and a table for each list of objects.
pub fn text(facts: &Value) -> String {
    let mut lines = Vec::new();
    let mut tables = String::new();
    add(&mut lines, &mut tables, String::new(), facts);
    let width = lines.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let lines = lines.iter().map(|(name, fact)| format!("{name:<width$}  {fact}\n"));
    lines.collect::<String>() + &tables
}

fn add(lines: &mut Vec<(String, String)>, tables: &mut String, name: String, fact: &Value) {
    match fact {
        Value::Null => {}
        Value::Object(facts) => {
            for (inner, fact) in facts {
                let name = if name.is_empty() { inner.clone() } else { format!("{name}.{inner}") };
                add(lines, tables, name, fact);
            }
        }
        Value::Array(rows) if rows.first().is_some_and(Value::is_object) => {
            *tables += &format!("\n{name}\n{}", table(rows));
            if rows.len() > MAX_ROWS {
                *tables += &format!("... and {} more (--json has all)\n", rows.len() - MAX_ROWS);
            }
            lines.push((name, grouped(rows.len() as u64)));
        }
        Value::Array(texts) if texts.iter().all(Value::is_string) => {
            let shown = texts.iter().take(MAX_ROWS).filter_map(Value::as_str);
            lines.extend(shown.map(|text| (name.clone(), text.to_owned())));
        }
        Value::String(text) => lines.push((name, text.clone())),
        fact => lines.push((name, fact.as_u64().map_or_else(|| fact.to_string(), grouped))),
    }
}

/// Objects of the same keys, those with words first.
fn table(rows: &[Value]) -> Table {
    let keys = rows[0].as_object().into_iter().flat_map(|row| row.keys().map(String::as_str));
    let is_known = |key: &&str| rows.iter().any(|row| !row[*key].is_null());
    let is_word = |key: &&str| rows.iter().any(|row| row[*key].is_string());
    let (words, numbers): (Vec<_>, Vec<_>) = keys.filter(is_known).partition(is_word);
    let titles = [&words[..], &numbers].concat();
    let mut table = Table::new(words.len(), titles.iter().copied());
    for row in rows.iter().take(MAX_ROWS) {
        table.row(titles.iter().map(|key| cell(&row[*key])));
    }
    table
}

fn cell(value: &Value) -> String {
    match value {
        Value::Null => "-".to_owned(),
        Value::String(text) => text.clone(),
        Value::Number(found) if found.is_f64() => number(found.as_f64().unwrap_or(f64::NAN)),
        Value::Array(all) => all.iter().map(cell).collect::<Vec<_>>().join(" "),
        value => value.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn facts_have_lines_and_tables() {
        let rows: Vec<_> =
            (0..30).map(|row| json!({"at": row, "half": 0.5, "name": "é"})).collect();
        let facts = json!({
            "kind": "scene", "file_bytes": 1_234_567, "config": {"step": 0.25, "box": [[0.5, 1], [2, 3]]},
            "missing": null, "warnings": ["a", "b"], "rows": rows,
        });
        let text = text(&facts);
        let lines: Vec<_> = text.lines().collect();
        for line in [
            "kind         scene",
            "file_bytes   1,234,567",
            "config.box   [[0.5,1],[2,3]]",
            "config.step  0.25",
            "rows         30",
            "warnings     a",
            "warnings     b",
            "name  at     half",
            "é      0  0.50000",
            "... and 6 more (--json has all)",
        ] {
            assert!(lines.contains(&line), "{line}: {text}");
        }
    }
}
