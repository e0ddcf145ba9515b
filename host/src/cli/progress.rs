//! The progress of a training: a bar on a terminal, or lines in a log file.

use std::time::Duration;

use indicatif::FormattedDuration;
use organza::Evaluation;
use organza::metrics::psnr_of;
use organza::train::{Change, Event, Outcome, StepReport};

use super::console::{Console, Progress, between_lines, left};
use super::summary::{count, grouped, score};

/// Fewest seconds between lines.
const SHORTEST: f64 = 2.0;

/// Shows a training to the user.
#[derive(Debug)]
pub struct TrainingProgress {
    console: Console,
    bar: Progress,
    steps: u32,
    /// Whether the number of steps is an estimate, which a run with `--minutes` changes as it goes.
    is_scheduled: bool,
    time_limit: Option<f64>,
    lines: Lines,
    step: u32,
    seconds: f64,
    gaussians: Option<usize>,
}

impl TrainingProgress {
    /// For a training of `steps` steps, including steps before a resume.
    pub fn new(console: Console, steps: u32, time_limit: Option<f64>) -> Self {
        // a log has lines of its own
        let bar = match console.has_terminal() {
            true => console.progress("training", steps as usize, "steps"),
            false => console.hidden(),
        };
        Self {
            console,
            bar,
            steps,
            is_scheduled: false,
            time_limit,
            lines: Lines::default(),
            step: 0,
            seconds: 0.0,
            gaussians: None,
        }
    }

    /// Shows an event.
    pub fn show(&mut self, event: &Event<'_>) {
        match event {
            Event::Warning(text) => self.bar.warn(self.console, text),
            Event::Suggested { places, random } => {
                let places = count(*places as u64, "place");
                let random = grouped(*random as u64);
                let text = format!(
                    "without points, training starts from {places} that the photographs suggest, and {random} random ones"
                );
                self.bar.note(self.console, &text);
            }
            Event::Begin(step) => self.begin(*step),
            Event::Changed(Change { name, from, to, .. }) => {
                self.bar.note(self.console, &format!("{name} is {to} from here on; it was {from}"));
            }
            Event::Scheduled(steps) => {
                self.steps = *steps;
                self.is_scheduled = true;
                self.bar.set_of(self.step as usize, *steps as usize);
            }
            Event::Step { step, seconds, report, gaussians, .. } => {
                self.step = *step;
                self.seconds = *seconds;
                self.gaussians = Some(*gaussians);
                self.step(report);
            }
            Event::Evaluating => self.bar.say("measuring the held-out views"),
            Event::Evaluated(evaluation) => self.evaluated(evaluation),
            _ => {}
        }
    }

    fn begin(&mut self, step: u32) {
        self.step = step;
        if step == 0 {
            return;
        }
        self.bar.set(step as usize);
        self.bar.restart_clock();
        self.console.note(&match step < self.steps {
            true => format!("continuing after step {step}"),
            false => format!("all {step} steps are done; `--steps N` extends the run"),
        });
    }

    fn step(&mut self, report: &StepReport) {
        self.bar.set(self.step as usize);
        let pace = Some(self.bar.speed()).filter(|speed| *speed > 0.0);
        let speed = pace.map_or_else(String::new, |speed| format!(", {} steps/s", rounded(speed)));
        self.bar.say(&format!(
            "{}, {}{speed}",
            error(report.loss, report.psnr),
            self.gaussian_count(),
        ));
        if self.console.has_terminal() {
            return;
        }
        let Some([loss, psnr]) = self.lines.add(self.seconds, report.loss, report.psnr) else {
            return;
        };
        self.console.note(&format!(
            "step {} of {}{}: {}, {}{speed}{}",
            grouped(self.step.into()),
            if self.is_scheduled { "about " } else { "" },
            grouped(self.steps.into()),
            error(loss, psnr),
            self.gaussian_count(),
            left(pace.map(|speed| self.seconds_left(speed))),
        ));
    }

    fn evaluated(&self, evaluation: &Evaluation) {
        let fitted = evaluation.mean.psnr_fitted.map_or_else(String::new, |psnr| {
            format!(", {psnr:.2} dB after each photograph's exposure is fitted")
        });
        let text = format!(
            "step {}: {}: PSNR {} dB{fitted}, SSIM {}",
            grouped(self.step.into()),
            count(evaluation.views.len() as u64, "held-out view"),
            score(evaluation.mean.psnr, 2),
            score(evaluation.mean.ssim, 4),
        );
        self.bar.note(self.console, &text);
    }

    /// Prints how the training ended, and removes the bar.
    pub fn end(self, outcome: Outcome) {
        drop(self.bar);
        // no step was taken
        let Some(gaussians) = self.gaussians else { return };
        let what = match outcome {
            Outcome::TimeLimit => "finished at the time limit",
            Outcome::Stopped => "stopped",
            _ => "finished",
        };
        let time = FormattedDuration(Duration::from_secs_f64(self.seconds));
        let steps = count(self.step.into(), "step");
        let gaussians = count(gaussians as u64, "Gaussian");
        self.console.note(&format!("{what}: {steps} in {time} of training, {gaussians}"));
    }

    fn gaussian_count(&self) -> String {
        count(self.gaussians.unwrap_or(0) as u64, "Gaussian")
    }

    /// Estimates the seconds left at a number of steps a second.
    fn seconds_left(&self, speed: f64) -> f64 {
        let limit = self.time_limit.map_or(f64::INFINITY, |limit| (limit - self.seconds).max(0.0));
        (f64::from(self.steps.saturating_sub(self.step)) / speed).min(limit)
    }
}

/// Decides when a line is due, and computes the means since the last one.
#[derive(Debug, Default)]
struct Lines {
    /// Seconds at the first step, and seconds at which the next line is due.
    times: Option<[f64; 2]>,
    sums: [f64; 2],
    count: f64,
}

impl Lines {
    /// Adds a step's loss and PSNR. Returns their means since the last line if another one is due. PSNRs are averaged
    /// as squared errors, because the PSNR of a batch without any error is infinite.
    fn add(&mut self, seconds: f64, loss: f64, psnr: f64) -> Option<[f64; 2]> {
        let values = [loss, 10f64.powf(-psnr / 10.0)];
        self.sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        self.count += 1.0;
        let [begin, due] = *self.times.get_or_insert([seconds; 2]);
        if seconds < due {
            return None;
        }
        let wait = between_lines(seconds - begin, SHORTEST);
        self.times = Some([begin, seconds + wait]);
        let [loss, squared] = self.sums.map(|sum| sum / self.count);
        self.sums = [0.0; 2];
        self.count = 0.0;
        Some([loss, psnr_of(squared)])
    }
}

/// Formats a loss and a PSNR. Of equal images, the latter is infinite.
fn error(loss: f64, psnr: f64) -> String {
    match psnr.is_infinite() {
        true => format!("loss {loss:.4}, all pixels are equal to the photographs'"),
        false => format!("loss {loss:.4}, PSNR {psnr:.1} dB"),
    }
}

/// Formats a number with three digits, or with all digits before the point.
pub fn rounded(value: f64) -> String {
    let digits = if value < 10.0 { 2 } else { usize::from(value < 100.0) };
    format!("{value:.digits$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_become_rarer_and_tell_means() {
        let mut lines = Lines::default();
        // resumed after 1000 s; then ten steps per second for an hour
        let due: Vec<_> = (0..36_000)
            .filter_map(|step| {
                let seconds = 0.1 * f64::from(step);
                lines.add(1000.0 + seconds, f64::from(step), 0.0).map(|means| (seconds, means))
            })
            .collect();
        assert_eq!(due[0], (0.0, [0.0, 0.0]));
        // the mean over steps 1 to 20
        assert!((due[1].0 - 2.0).abs() < 0.15 && (due[1].1[0] - 10.5).abs() < 1.0, "{:?}", due[1]);
        assert!((85..105).contains(&due.len()), "{} lines", due.len());
        let last = due[due.len() - 1].0 - due[due.len() - 2].0;
        assert!((last - 60.0).abs() < 0.2, "{last}");
    }

    #[test]
    fn a_batch_without_an_error_leaves_the_mean_finite() {
        let mut lines = Lines::default();
        let first = lines.add(0.0, 0.0, f64::INFINITY);
        assert_eq!(first, Some([0.0, f64::INFINITY]));
        let none = [(0.1, f64::INFINITY), (0.2, 20.0)].map(|(at, psnr)| lines.add(at, 0.0, psnr));
        assert_eq!(none, [None; 2]);
        // squared errors of 0, 0.01 and 0.02
        let [_, psnr] = lines.add(5.0, 0.0, 10.0 * 50f64.log10()).unwrap();
        assert!((psnr - 20.0).abs() < 1e-9, "{psnr}");
    }

    #[test]
    fn speeds_have_three_digits() {
        assert_eq!([0.123, 1.234, 12.34, 1234.4].map(rounded), ["0.12", "1.23", "12.3", "1234"]);
    }
}
