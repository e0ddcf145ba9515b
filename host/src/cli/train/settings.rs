//! The options of `organza train` for settings, most of which the table of settings names.

use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, FromArgMatches};
use organza::Result;
use organza::train::config::{SETTINGS, Setting};
use organza::train::{self, ConfigBuilder, Preset, TrainConfig};

use crate::cli::{absolute, number_in};

/// The examples, and the settings for `--set`.
pub fn long_help(examples: &str) -> String {
    let mut text = format!(
        "{examples}\nSettings are overridden in this order: defaults, --preset, --config, --set, other options. \
         Settings for --set and --config, with their defaults (docs/training.md describes them):\n"
    );
    let hidden = |name: &str| SETTINGS.iter().any(|row| row.is_hidden() && row.name == name);
    for (name, value) in train::config::defaults().into_iter().filter(|(name, _)| !hidden(name)) {
        text += &format!("  {name}={value}\n");
    }
    text
}

/// Options for the settings of a training.
#[derive(Debug, clap::Args)]
pub struct SettingsArgs {
    /// The settings to start from: a settings file that is part of the program
    /// [default: default]
    #[arg(long, value_name = "NAME")]
    #[arg(value_parser = PossibleValuesParser::new(Preset::ALL.map(Preset::name)))]
    preset: Option<String>,
    /// A settings file, TOML, such as a run's config.toml; overrides the preset
    #[arg(long, value_name = "TOML")]
    config: Option<PathBuf>,
    /// Any setting, such as run.steps=3000; overrides the settings file. Give it once for each setting
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    options: SettingOptions,
    /// Choose the number of steps so that the run takes this many minutes, evaluations included. config.toml keeps the
    /// number
    #[arg(long, value_name = "M", conflicts_with = "run.steps")]
    // a hundredth is enough for a few steps of anything, and nothing is trained for a year
    #[arg(value_parser = number_in(0.01..=500_000.0, "a number of minutes, such as 10 or 0.5"))]
    pub minutes: Option<f64>,
}

/// The options of single settings, such as `--steps`. [`SETTINGS`] has them.
#[derive(Debug, Default)]
struct SettingOptions {
    /// Names of settings and the values that were given, as `--set` takes them.
    given: Vec<(&'static str, String)>,
}

impl SettingOptions {
    fn get(&self, name: &str) -> Option<&str> {
        self.given.iter().find(|(given, _)| *given == name).map(|(_, value)| &**value)
    }

    /// The option of a setting that has one.
    fn arg(setting: &'static Setting) -> Option<Arg> {
        let (name, value) = match setting.option.split_once(' ') {
            Some((name, value)) => (name, Some(value)),
            None => (setting.option, None),
        };
        let arg = Arg::new(setting.name).long(name.strip_prefix("--")?).help(setting.text());
        let Some(value) = value else { return Some(arg.action(ArgAction::SetTrue)) };
        let parse = |text: &str| setting.check(text).map(|()| text.to_owned());
        Some(arg.value_name(value.trim_matches(['<', '>'])).value_parser(parse))
    }
}

impl clap::Args for SettingOptions {
    fn augment_args(command: clap::Command) -> clap::Command {
        command.args(SETTINGS.iter().filter_map(Self::arg))
    }

    fn augment_args_for_update(command: clap::Command) -> clap::Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for SettingOptions {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut options = Self::default();
        options.update_from_arg_matches(matches)?;
        Ok(options)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        for setting in SETTINGS.iter().filter(|setting| !setting.option.is_empty()) {
            if matches.value_source(setting.name) != Some(ValueSource::CommandLine) {
                continue;
            }
            let value = match setting.option.contains(' ') {
                true => matches.get_one::<String>(setting.name).cloned(),
                false => Some("true".to_owned()),
            };
            self.given.extend(value.map(|value| (setting.name, value)));
        }
        Ok(())
    }
}

impl SettingsArgs {
    /// The settings of a resumed run: its own, with the changes that the options make.
    pub fn resumed(&self, folder: &Path) -> Result<TrainConfig> {
        let mut config = train::changed_settings_of(folder, |config| {
            self.adjusted(ConfigBuilder::from_config(&config))?.build()
        })?;
        config.data.path = config.data.path.map(|path| absolute(&path));
        Ok(config)
    }

    /// The settings to train on a data set, or on the built-in scene, and whether they leave the size of photographs open.
    pub fn settings(&self, data: Option<&Path>) -> Result<(TrainConfig, bool)> {
        let named = self.preset.as_deref();
        let preset = match Preset::ALL.into_iter().find(|preset| Some(preset.name()) == named) {
            Some(preset) => preset,
            None if data.is_none() && self.config.is_none() => Preset::BuiltIn,
            None => Preset::Default,
        };
        let mut builder = ConfigBuilder::new(preset)?;
        if let Some(path) = &self.config {
            builder = builder.file(path)?;
        }
        builder = self.adjusted(builder)?;
        let shrinks = !builder.has("data", "downscale");
        let mut config = builder.build()?;
        if let Some(data) = data {
            config.data.path = Some(data.to_owned());
        }
        // a run can be resumed from any folder
        for path in [&mut config.data.path, &mut config.start.path].into_iter().flatten() {
            *path = absolute(path);
        }
        config.validate()?;
        Ok((config, shrinks))
    }

    /// Settings with single values from the command line.
    fn adjusted(&self, mut builder: ConfigBuilder) -> Result<ConfigBuilder> {
        for assignment in &self.set {
            builder = builder.set(assignment)?;
        }
        if self.options.get("run.steps").is_some() || self.minutes.is_some() {
            builder = builder.set("run.schedule=")?;
        }
        for (name, value) in &self.options.given {
            builder = builder.set(&format!("{name}={value}"))?;
        }
        Ok(builder)
    }
}
