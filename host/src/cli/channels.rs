//! Options that ask for channels besides color.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use organza::Channel;
use organza::image::PNG_DEPTH_SCALE;

/// The channels to write.
#[derive(Debug, clap::Args)]
pub struct ChannelArgs {
    /// Channels to write besides the color: any of depth, alpha, visibility and normal, separated by commas
    #[arg(long, value_name = "LIST", value_parser = channel(), value_delimiter = ',')]
    channels: Vec<Channel>,
}

impl ChannelArgs {
    /// The channels, each only once.
    pub fn list(&self) -> Vec<Channel> {
        Channel::ALL.into_iter().filter(|channel| self.channels.contains(channel)).collect()
    }
}

/// The levels of channels' images.
#[derive(Debug, clap::Args)]
pub struct LevelArgs {
    /// Levels of a PNG for one world unit of depth: the largest depth is 65,535 levels
    #[arg(long, value_name = "N", default_value_t = PNG_DEPTH_SCALE, requires = "channels")]
    #[arg(value_parser = depth_scale)]
    pub depth_scale: f32,
}

fn depth_scale(text: &str) -> Result<f32, String> {
    let scale = text.parse().ok().filter(|scale: &f32| *scale > 0.0 && scale.is_finite());
    scale.ok_or_else(|| "expected a number above 0".to_owned())
}

/// Parses the name of a channel.
fn channel() -> impl TypedValueParser<Value = Channel> {
    let help = |channel| match channel {
        Channel::Depth => "Mean depth of the Gaussians along the camera's axis, in world units",
        Channel::Alpha => "Sum of the Gaussians' weights",
        Channel::Visibility => "Mean transmittance of the Gaussians",
        Channel::Normal => "Mean direction of the Gaussians' shortest axes, in world space",
    };
    let names = Channel::ALL.map(|channel| PossibleValue::new(channel.name()).help(help(channel)));
    let named = |name: String| Channel::ALL.into_iter().find(|channel| channel.name() == name);
    PossibleValuesParser::new(names).map(move |name| named(name).expect("one of these"))
}
