//! Settings of earlier versions, in their files.

use toml::Table;

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
/// Who asked for TensorBoard's file may have it from elsewhere.
const TENSORBOARD: &str =
    ". `python scripts/tensorboard.py RUN` writes TensorBoard's file of a run";

/// Replaces retired settings by those of today.
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
                "`{group}.{name}` is no setting any more, and this value of it means nothing today: remove it{hint}"
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::TrainConfig;

    #[test]
    fn files_of_earlier_versions_mean_what_they_meant() {
        let text = "[exposure]\nmethod = 'affine'\n[poses]\nmethod = 'refine'\n[growth]\nmethod = 'none'\n\
                    [start]\ntransmittance_bias = 5.0\n[optimizer]\nepsilon = 1e-12\n[run]\ntensorboard = false\n";
        let config = TrainConfig::parse(text, "config.toml".as_ref()).unwrap();
        assert!(config.exposure.learn && config.poses.refine);
        assert_eq!(config.growth.end, 0.0);
        let text =
            "[exposure]\nmethod = 'none'\n[poses]\nmethod = 'none'\n[growth]\nmethod = 'split'\n";
        let config = TrainConfig::parse(text, "config.toml".as_ref()).unwrap();
        assert_eq!(config, TrainConfig::default());
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
