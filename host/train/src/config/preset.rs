//! Presets: settings files that are part of the program.

/// A settings file that is part of the program: `host/train/presets/NAME.toml`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preset {
    /// A first look, in a fraction of the time.
    Fast,
    /// The defaults of all settings.
    #[default]
    Default,
    /// An hour or more: more steps, more Gaussians, finer colors.
    Best,
    /// For the built-in scene.
    BuiltIn,
}

impl Preset {
    /// Every preset.
    pub const ALL: [Self; 4] = [Self::Fast, Self::Default, Self::Best, Self::BuiltIn];

    /// Name of the preset and of its file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Default => "default",
            Self::Best => "best",
            Self::BuiltIn => "built-in",
        }
    }

    /// Text of the preset's file, TOML. Settings that it leaves out have their default.
    #[must_use]
    pub const fn toml(self) -> &'static str {
        match self {
            Self::Fast => include_str!("../../presets/fast.toml"),
            Self::Default => include_str!("../../presets/default.toml"),
            Self::Best => include_str!("../../presets/best.toml"),
            Self::BuiltIn => include_str!("../../presets/built-in.toml"),
        }
    }
}
