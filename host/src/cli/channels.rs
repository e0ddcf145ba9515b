//! Options that ask for channels besides color.

use clap::ValueEnum;
use organza::Channel;
use organza::image::PNG_DEPTH_SCALE;

/// The channels to write.
#[derive(Debug, clap::Args)]
pub struct ChannelArgs {
    /// Channels to write besides the color: any of depth, alpha, visibility and normal, separated by commas
    #[arg(long, value_name = "LIST", value_enum, value_delimiter = ',')]
    channels: Vec<ChannelName>,
}

impl ChannelArgs {
    /// The channels, each only once.
    pub fn list(&self) -> Vec<Channel> {
        let is_asked =
            |channel: &Channel| self.channels.iter().any(|name| name.channel() == *channel);
        Channel::ALL.into_iter().filter(is_asked).collect()
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

#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ChannelName {
    /// Mean depth of the Gaussians along the camera's axis, in world units
    Depth,
    /// Sum of the Gaussians' weights
    Alpha,
    /// Mean transmittance of the Gaussians
    Visibility,
    /// Mean direction of the Gaussians' shortest axes, in world space
    Normal,
}

impl ChannelName {
    /// The channel in the library.
    pub fn channel(self) -> Channel {
        match self {
            Self::Depth => Channel::Depth,
            Self::Alpha => Channel::Alpha,
            Self::Visibility => Channel::Visibility,
            Self::Normal => Channel::Normal,
        }
    }
}
