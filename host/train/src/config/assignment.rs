//! Assignments `key=value`, which set one setting in its own type.

use std::sync::LazyLock;

use serde::Deserialize;
use toml::{Table, Value};

use super::{Setting, TrainConfig};

/// Similarity of two names, 0 to 1, from which one is suggested for the other.
const ALIKE: f64 = 0.8;

/// A table with all settings, including those that a file omits if they have their default.
static TEMPLATE: LazyLock<Table> = LazyLock::new(|| {
    let mut config = TrainConfig::default();
    config.data.path = Some("the built-in scene".into());
    config.start.path = Some("the data set's points".into());
    config.data.allow_outside = true;
    // through text, so that an f32 keeps its own digits
    let mut table: Table = toml::from_str(&config.to_toml()).expect("it was just written");
    // a file has it only if it is true: so it was set, to be in the table
    table["data"]["allow_outside"] = Value::Boolean(false);
    table
});

impl Setting {
    /// Fails for a value that is not of the setting's type, as `--set` writes it.
    ///
    /// # Errors
    /// A sentence that says what is expected.
    pub fn check(&self, value: &str) -> Result<(), String> {
        parse(&format!("{}={value}", self.name)).map(|_| ())
    }
}

/// Every setting as `table.name`, and its default. A learning rate is one setting.
#[must_use]
pub fn defaults() -> Vec<(String, String)> {
    let text = |value: &Value| match value {
        Value::Table(rate) => rate.values().map(Value::to_string).collect::<Vec<_>>().join(","),
        Value::String(text) => text.clone(),
        value => value.to_string().replace(['[', ']', ' '], ""),
    };
    let settings = leaves(&TEMPLATE, is_rate);
    settings.into_iter().map(|(name, value)| (name, text(value))).collect()
}

/// Checks that every name in a file's table is a setting.
pub fn check_names(table: &Table) -> Result<(), String> {
    leaves(table, |_| false).into_iter().try_for_each(|(name, _)| find(&name).map(drop))
}

/// Every value of a table with its name, such as `run.steps`. A table is a value of its own if `is_leaf` says so.
pub fn leaves(table: &Table, is_leaf: fn(&Value) -> bool) -> Vec<(String, &Value)> {
    let mut found = Vec::new();
    for (key, value) in table {
        match value {
            Value::Table(inner) if !is_leaf(value) => {
                let below = leaves(inner, is_leaf).into_iter();
                found.extend(below.map(|(name, value)| (format!("{key}.{name}"), value)));
            }
            value => found.push((key.clone(), value)),
        }
    }
    found
}

/// Overwrites values of the table `under` with the values of `over`.
pub fn merge(under: &mut Table, over: Table) {
    for (key, value) in over {
        match (under.get_mut(&key), value) {
            (Some(Value::Table(under)), Value::Table(over)) => merge(under, over),
            (_, value) => drop(under.insert(key, value)),
        }
    }
}

/// A table with one value.
fn wrapped(value: Value, key: &str) -> Table {
    let wrap = |value, name: &str| Value::Table(Table::from_iter([(name.to_owned(), value)]));
    let Value::Table(table) = key.rsplit('.').fold(value, wrap) else {
        unreachable!("a key has at least one name")
    };
    table
}

/// Parses an assignment into a table with one setting.
pub fn parse(text: &str) -> Result<Table, String> {
    let Some((key, value)) = text.split_once('=') else {
        return Err(format!("`{text}` has no value; write KEY=VALUE, such as run.steps=3000"));
    };
    let key = key.trim();
    let text = value.trim();
    let default = find(key)?;
    let value = read(&default, text)
        .ok_or_else(|| format!("`{key}` is `{text}`, expected {}", kind(&default)))?;
    let table = wrapped(value, key);
    let mut all = TEMPLATE.clone();
    merge(&mut all, table.clone());
    match TrainConfig::deserialize(all) {
        Ok(_) => Ok(table),
        Err(error) => Err(format!("`{key}` is `{text}`: {}", error.message())),
    }
}

/// The default of a setting. If there is none of that name, the error suggests a similar one.
fn find(key: &str) -> Result<Value, String> {
    let mut names = key.split('.');
    let first = names.next().and_then(|name| TEMPLATE.get(name));
    let found = first.and_then(|value| names.try_fold(value, |value, name| value.get(name)));
    match found {
        Some(value @ Value::Table(table)) if !is_rate(value) => {
            let first = table.keys().next().map_or("", String::as_str);
            Err(format!("`{key}` is a group of settings; name one of them, such as {key}.{first}"))
        }
        Some(value) => Ok(value.clone()),
        None => {
            let nearest =
                nearest(key).map_or(String::new(), |name| format!("; did you mean `{name}`?"));
            Err(format!("there is no setting `{key}`{nearest}"))
        }
    }
}

/// The setting that a key means: its name, with or without its table, begins with the key or is most similar to it.
fn nearest(key: &str) -> Option<String> {
    let alike = |name: &str| {
        let last = name.rsplit('.').next().unwrap_or(name);
        if !key.is_empty() && (name.starts_with(key) || last.starts_with(key)) {
            return 1.0;
        }
        strsim::jaro_winkler(key, name).max(strsim::jaro_winkler(key, last))
    };
    let rated = defaults().into_iter().map(|(name, _)| (alike(&name), name));
    let best = rated.max_by(|(a, _), (b, _)| a.total_cmp(b));
    best.filter(|(rating, _)| *rating >= ALIKE).map(|(_, name)| name)
}

/// Parses a value that the user wrote, in the type of a default.
fn read(default: &Value, text: &str) -> Option<Value> {
    match default {
        Value::Integer(_) => text.replace('_', "").parse().ok().map(Value::Integer),
        Value::Float(_) => text.parse().ok().map(Value::Float),
        Value::Boolean(_) => text.parse().ok().map(Value::Boolean),
        Value::Array(values) => {
            let Some(first) = values.first() else {
                // values that a run itself writes, such as its schedule, can be removed
                let inner = text.trim_matches(['[', ']']).trim();
                return inner.is_empty().then(|| Value::Array(Vec::new()));
            };
            list(text).map(|part| read(first, part)).collect::<Option<_>>().map(Value::Array)
        }
        Value::Table(_) => {
            let numbers: Option<Vec<f64>> = list(text).map(|part| part.parse().ok()).collect();
            let (first, last) = match *numbers?.as_slice() {
                [both] => (both, both),
                [first, last] => (first, last),
                _ => return None,
            };
            Some(Value::Table(Table::from_iter([
                ("first".to_owned(), first.into()),
                ("last".to_owned(), last.into()),
            ])))
        }
        _ => Some(Value::String(text.trim_matches(['"', '\'']).to_owned())),
    }
}

/// The elements of a list, with or without its brackets.
fn list(text: &str) -> impl Iterator<Item = &str> {
    let inner = text.strip_prefix('[').and_then(|text| text.strip_suffix(']'));
    inner.unwrap_or(text).split(',').map(str::trim)
}

/// Describes the form of a value that has a default's type.
fn kind(default: &Value) -> &'static str {
    match default {
        Value::Integer(_) => "a whole number",
        Value::Float(_) => "a number",
        Value::Boolean(_) => "true or false",
        Value::Array(values) if matches!(values.first(), Some(Value::Integer(_))) => {
            "whole numbers, such as 32,32"
        }
        Value::Array(_) => "numbers, such as 0.5,0.5,0.5",
        Value::Table(_) => "the first and the last rate, such as 1e-2,1e-3",
        _ => "a word",
    }
}

/// Whether a table is a learning rate, which counts as one setting.
fn is_rate(value: &Value) -> bool {
    value.get("first").is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn text(assignment: &str) -> String {
        toml::to_string(&parse(assignment).unwrap()).unwrap()
    }

    #[test]
    fn a_value_has_its_settings_type() {
        for (assignment, expected) in [
            ("run.steps=3_000", "[run]\nsteps = 3000\n"),
            (" loss.ssim_weight = 1 ", "[loss]\nssim_weight = 1.0\n"),
            ("data.allow_outside=true", "[data]\nallow_outside = true\n"),
            ("data.path=/a=b", "[data]\npath = \"/a=b\"\n"),
            ("data.alpha=\"mask\"", "[data]\nalpha = \"mask\"\n"),
            ("scene.color_grid.levels=4", "[scene.color_grid]\nlevels = 4\n"),
            ("scene.color_mlp.hidden=64", "[scene.color_mlp]\nhidden = [64]\n"),
            ("scene.color_mlp.hidden=[64, 16]", "[scene.color_mlp]\nhidden = [64, 16]\n"),
            ("optimizer.grids=0.5,1e-3", "[optimizer.grids]\nfirst = 0.5\nlast = 0.001\n"),
            ("optimizer.grids=0.5", "[optimizer.grids]\nfirst = 0.5\nlast = 0.5\n"),
            ("optimizer.grids.last=0.5", "[optimizer.grids]\nlast = 0.5\n"),
        ] {
            assert_eq!(text(assignment), expected, "{assignment}");
        }
    }

    #[test]
    fn mistakes_are_named() {
        for (assignment, expected) in [
            ("run.steps", "`run.steps` has no value; write KEY=VALUE"),
            ("run.stesp=3", "no setting `run.stesp`; did you mean `run.steps`?"),
            ("max_gaussians=3", "did you mean `densification.max_gaussians`?"),
            ("densification.max=3", "did you mean `densification.max_gaussians`?"),
            ("opacity=3", "did you mean `"),
            ("xyz=3", "there is no setting `xyz`"),
            ("=3", "there is no setting ``"),
            ("run=3", "`run` is a group of settings; name one of them, such as run."),
            ("run.steps.x=3", "there is no setting `run.steps.x`; did you mean `run.steps`?"),
            ("run.steps=many", "`run.steps` is `many`, expected a whole number"),
            ("run.steps=1.5", "expected a whole number"),
            ("run.steps=-1", "`run.steps` is `-1`: "),
            ("run.steps=", "`run.steps` is ``, expected a whole number"),
            ("loss.ssim_weight=x", "expected a number"),
            ("ablation.divide=yes", "expected true or false"),
            ("data.alpha=magic", "`data.alpha` is `magic`: unknown variant"),
            ("optimizer.grids=1,2,3", "expected the first and the last rate"),
        ] {
            let error = parse(assignment).unwrap_err();
            assert!(error.contains(expected), "{assignment}: {error}");
        }
    }

    #[test]
    fn every_listed_default_can_be_set() {
        let defaults = defaults();
        assert!(defaults.len() > 50, "{defaults:?}");
        for (name, value) in defaults {
            assert!(parse(&format!("{name}={value}")).is_ok(), "{name}={value}");
        }
    }
}
