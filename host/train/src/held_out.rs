//! The held-out views that a run measures.

use crate::evaluate::ViewScore;
use organza_data::{Dataset, Frame};

/// The held-out frames that an evaluation measures: all, or the few of an intermediate evaluation. `views` is
/// [`RunConfig::evaluate_views`](super::config::RunConfig::evaluate_views).
pub(super) fn frames(dataset: &Dataset, views: u32, all: bool) -> Vec<&Frame> {
    let frames: Vec<_> = dataset.held_out_frames().collect();
    let views = if all { 0 } else { views };
    chosen(frames.len(), views).into_iter().map(|place| frames[place]).collect()
}

/// Indices of `views` of `count` views, evenly spaced from the first; all if `views` is 0 or at least `count`.
pub(super) fn chosen(count: usize, views: u32) -> Vec<usize> {
    let views = if views == 0 { count } else { count.min(views as usize) };
    (0..views).map(|place| place * count / views).collect()
}

/// The mean PSNR over the views that every evaluation of a run measures. It decides which checkpoint is the best.
/// `count` is the number of held-out views. `scores` has all of them, or only the chosen ones.
pub(super) fn comparable(scores: &[ViewScore], count: usize, views: u32) -> Option<f64> {
    let has_all = scores.len() == count;
    let places = if has_all { chosen(count, views) } else { (0..scores.len()).collect() };
    let psnr: Vec<_> = places.into_iter().filter_map(|place| scores[place].score.psnr).collect();
    (!psnr.is_empty()).then(|| psnr.iter().sum::<f64>() / psnr.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::Score;

    #[test]
    fn chosen_views_are_evenly_spaced() {
        assert_eq!(chosen(10, 0), (0..10).collect::<Vec<_>>());
        assert_eq!(chosen(10, 11), chosen(10, 0));
        assert_eq!(chosen(10, 3), [0, 3, 6]);
        assert_eq!(chosen(8, 4), [0, 2, 4, 6]);
        assert_eq!(chosen(0, 4), [0_usize; 0]);
    }

    #[test]
    fn evaluations_of_all_and_of_some_are_compared_by_the_same_views() {
        let view = |psnr: Option<f64>| {
            let score = Score { psnr, ..Score::default() };
            ViewScore { name: String::new(), score }
        };
        let all = [20.0, 30.0, 24.0, 0.0].map(|psnr| view(Some(psnr)));
        assert_eq!(comparable(&all, 4, 2), Some(22.0));
        assert_eq!(comparable(&all, 4, 0), Some(18.5));
        let some = [all[0].clone(), all[2].clone()];
        assert_eq!(comparable(&some, 4, 2), Some(22.0));
        assert_eq!(comparable(&[view(None)], 1, 0), None);
    }
}
