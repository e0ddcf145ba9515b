//! What a scene was trained on.

use std::collections::HashSet;

use serde::{Deserialize, Serialize};

/// The photographs that a scene was trained on, how they were read, and those that training has not seen.
///
/// ```
/// use organza_core::scene::TrainedOn;
///
/// let [seen, held_out] = [vec!["1.jpg".to_owned()], vec!["0.jpg".to_owned()]];
/// let trained_on = TrainedOn { seen, held_out, downscale: 1, alpha_is_mask: false };
/// assert_eq!(trained_on.held_out_of(["0.jpg", "1.jpg", "2.jpg"]), Some(vec![true, false, false]));
/// // other photographs
/// assert_eq!(trained_on.held_out_of(["a.jpg"]), None);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct TrainedOn {
    /// Names of the frames that training saw.
    pub seen: Vec<String>,
    /// Names of the frames that were held out.
    pub held_out: Vec<String>,
    /// Factor by which the photographs were reduced.
    pub downscale: u32,
    /// Whether their alpha channel was a mask.
    pub alpha_is_mask: bool,
}

impl TrainedOn {
    /// Which frames of a data set were held out, given their names. `None` if it has none of these photographs.
    #[must_use]
    pub fn held_out_of<'a>(
        &self,
        names: impl IntoIterator<Item = &'a str> + Clone,
    ) -> Option<Vec<bool>> {
        let seen = names_of(&self.seen);
        let held_out = names_of(&self.held_out);
        let is_known = |name: &str| seen.contains(name) || held_out.contains(name);
        let held_out = |name: &str| held_out.contains(name);
        names.clone().into_iter().any(is_known).then(|| names.into_iter().map(held_out).collect())
    }

    /// Number of frames that training saw, given their names.
    #[must_use]
    pub fn seen_of<'a>(&self, names: impl Iterator<Item = &'a str>) -> usize {
        let seen = names_of(&self.seen);
        names.filter(|name| seen.contains(name)).count()
    }
}

fn names_of(names: &[String]) -> HashSet<&str> {
    names.iter().map(String::as_str).collect()
}
