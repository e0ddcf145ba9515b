//! Settings of earlier versions, in their files.

use super::ShapeConfig;
use toml::{Table, Value};

/// Group, name and TOML value of a retired setting, and its replacement today. The replacement is empty if the
/// program no longer has a choice.
const RETIRED: [[&str; 4]; 9] = [
    ["exposure", "method", "'none'", "learn = false"],
    ["exposure", "method", "'affine'", "learn = true"],
    ["poses", "method", "'none'", "refine = false"],
    ["poses", "method", "'refine'", "refine = true"],
    ["growth", "method", "'split'", ""],
    ["growth", "method", "'none'", "end = 0.0"],
    ["start", "transmittance_bias", "5.0", ""],
    ["optimizer", "epsilon", "1e-12", ""],
    ["run", "tensorboard", "false", ""],
];
/// A setting of `scene` that files of earlier runs do not have.
const ANTIALIASED: &str = "antialiased";
/// Who asked for TensorBoard's file may have it from elsewhere.
const TENSORBOARD: &str =
    ". `python scripts/tensorboard.py RUN` writes TensorBoard's file of a run";

/// Replaces retired settings by those of today, and says in the file of an earlier run that its scene is not antialiased.
///
/// # Errors
/// A sentence about a value without a replacement.
pub(super) fn replace(settings: &mut Table) -> Result<(), String> {
    for [group, name, value, today] in RETIRED {
        let parse = |text: &str| text.parse::<Table>().expect("TOML of the program");
        let Some(table) = settings.get_mut(group).and_then(|group| group.as_table_mut()) else {
            continue;
        };
        if table.get(name) == parse(&format!("{name} = {value}")).get(name) {
            table.remove(name);
            table.extend(parse(today));
        }
    }
    for [group, name, ..] in RETIRED {
        if settings.get(group).and_then(|group| group.get(name)).is_some() {
            let hint = if name == "tensorboard" { TENSORBOARD } else { "" };
            return Err(format!(
                "the setting `{group}.{name}` no longer exists, and no other setting replaces this value: remove it{hint}"
            ));
        }
    }
    if let Some(scene) = settings.get_mut("scene").and_then(Value::as_table_mut) {
        // a run's file has all settings, so one that lacks only this is from before there was a choice
        let all = Table::try_from(ShapeConfig::default()).expect("plain tables of numbers");
        if all.keys().all(|name| name == ANTIALIASED || scene.contains_key(name)) {
            scene.entry(ANTIALIASED).or_insert(Value::Boolean(false));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{LearnExposure, TrainConfig};

    #[test]
    fn files_of_earlier_versions_mean_what_they_meant() {
        let text = "[exposure]\nmethod = 'affine'\n[poses]\nmethod = 'refine'\n[growth]\nmethod = 'none'\n\
                    [start]\ntransmittance_bias = 5.0\n[optimizer]\nepsilon = 1e-12\n[run]\ntensorboard = false\n";
        let config = TrainConfig::parse(text, "config.toml".as_ref()).unwrap();
        assert!(config.exposure.learn == LearnExposure::On && config.poses.refine);
        assert_eq!(config.growth.end, 0.0);
        let text =
            "[exposure]\nmethod = 'none'\n[poses]\nmethod = 'none'\n[growth]\nmethod = 'split'\n";
        let config = TrainConfig::parse(text, "config.toml".as_ref()).unwrap();
        let mut expected = TrainConfig::default();
        expected.exposure.learn = LearnExposure::Off;
        assert_eq!(config, expected);
    }

    #[test]
    fn a_run_from_before_scenes_were_antialiased_has_one_that_is_not() {
        let mut file = TrainConfig::default().to_toml();
        assert!(TrainConfig::parse(&file, "config.toml".as_ref()).unwrap().scene.antialiased);
        file = file.replace("antialiased = true\n", "");
        assert!(!TrainConfig::parse(&file, "config.toml".as_ref()).unwrap().scene.antialiased);
        // a file that leaves out more is not a run's own
        file = file.replace("blur = 0.3\n", "");
        assert!(TrainConfig::parse(&file, "config.toml".as_ref()).unwrap().scene.antialiased);
    }

    #[test]
    fn what_nothing_stands_for_is_refused() {
        for (text, setting) in [
            ("[growth]\nmethod = 'relocate'", "growth.method"),
            ("[optimizer]\nepsilon = 1e-9", "optimizer.epsilon"),
            ("[run]\ntensorboard = true", "scripts/tensorboard.py"),
            ("[start]\ntransmittance_bias = 4.0", "start.transmittance_bias"),
        ] {
            let error = TrainConfig::parse(text, "config.toml".as_ref()).unwrap_err().to_string();
            assert!(error.contains(setting) && error.contains("config.toml"), "{error}");
        }
    }
}
