//! Chooses the number of steps that fit into the time of a run: `organza train --minutes`.

use super::config::TrainConfig;
use super::held_out;

/// The share of a step's time that grows with the number of Gaussians. Pixels, rays and fields take the rest.
const PER_GAUSSIAN: f64 = 0.3;
/// At first, a new schedule is made after steps 1, 2, 4 and so on, up to this one.
const FIRST_STEPS: u32 = 64;
/// Then the time of the run is cut into this many equal parts, and a new schedule is made after each.
const UPDATES: f64 = 20.0;
/// After this part of the time, the schedule stays: a run that is nearly done ends as chosen.
const LAST: f64 = 0.97;
/// Smallest number of steps in a schedule before anything is measured. Only the first step depends on it.
const UNKNOWN: u32 = 1000;
/// An upper limit for the number of steps of any run.
const MAX_STEPS: u32 = 100_000_000;

/// The state of a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Now {
    /// Steps done.
    pub step: u32,
    /// Number of Gaussians.
    pub gaussians: usize,
    /// Seconds of training so far.
    pub training: f64,
    /// Seconds of the run so far: training, evaluations and files.
    pub elapsed: f64,
}

/// Chooses the number of steps of a run, and updates it while the run goes on.
#[derive(Clone, Debug)]
pub(super) struct Scheduler {
    /// Seconds that the run should take.
    seconds: f64,
    /// Number of held-out views.
    views: usize,
    per_view: f64,
    /// State at the last schedule.
    last: Option<Now>,
}

impl Scheduler {
    /// The schedule of a run of `seconds`, with `views` held-out views.
    pub fn new(seconds: f64, views: usize) -> Self {
        Self { seconds, views, per_view: 0.0, last: None }
    }

    /// Records that an evaluation of `views` views took `seconds`.
    pub fn evaluated(&mut self, seconds: f64, views: usize) {
        self.per_view = seconds / views.max(1) as f64;
    }

    /// The total number of steps, if it is time for a new schedule.
    pub fn schedule(&mut self, config: &TrainConfig, now: Now) -> Option<u32> {
        let Some(last) = self.last else {
            self.last = Some(now);
            return Some(now.step.saturating_add(config.run.steps.max(UNKNOWN)));
        };
        let is_early = now.step <= FIRST_STEPS && now.step.is_power_of_two();
        let is_due = is_early || now.elapsed - last.elapsed >= self.seconds / UPDATES;
        let is_late = !is_early && now.elapsed >= LAST * self.seconds;
        if now.step <= last.step || now.step >= config.run.steps || !is_due || is_late {
            return None;
        }
        let per_step = (now.training - last.training) / f64::from(now.step - last.step);
        self.last = Some(now);
        Some(now.step.saturating_add(self.steps_left(config, now, per_step.max(1e-6))))
    }

    /// Number of further steps that fit if one takes `per_step` seconds now, following the number of Gaussians to the
    /// end.
    fn steps_left(&self, config: &TrainConfig, now: Now, per_step: f64) -> u32 {
        let densification = &config.densification;
        let per_evaluation = match config.run.evaluate_every {
            0 => 0.0,
            every => {
                let views = held_out::chosen(self.views, config.run.evaluate_views).len();
                self.per_view * views as f64 / f64::from(every)
            }
        };
        // the last evaluation measures all views
        let last = self.per_view * self.views as f64;
        let time = (self.seconds - now.elapsed - last).max(0.0);
        let mut used = 0.0;
        let mut steps = 0_u32;
        let mut gaussians = now.gaussians as f64;
        loop {
            let more = gaussians / now.gaussians.max(1) as f64;
            let cost = per_step * (1.0 - PER_GAUSSIAN + PER_GAUSSIAN * more) + per_evaluation;
            let next = cost * f64::from(densification.every);
            if used + next >= time || steps > MAX_STEPS {
                return steps.saturating_add(((time - used) / cost) as u32).max(1);
            }
            used += next;
            steps = steps.saturating_add(densification.every);
            let fraction = (now.elapsed + used) / self.seconds;
            if (densification.begin..=densification.end).contains(&fraction) {
                let max = f64::from(densification.max_gaussians);
                gaussians = (gaussians * (1.0 + densification.rate)).min(max.max(gaussians));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simulates a run. A step takes `cost(fraction, gaussians)` seconds. Returns the run's seconds and its settings.
    fn run(seconds: f64, cost: impl Fn(f64, f64) -> f64) -> (f64, TrainConfig) {
        let mut config = TrainConfig::default();
        config.run.evaluate_views = 5;
        config.densification.max_gaussians = 30_000;
        let start = f64::from(config.start.gaussians);
        let evaluation = 4.0;
        let mut scheduler = Scheduler::new(seconds, 10);
        // the evaluation of one view before the first step
        scheduler.evaluated(evaluation / 5.0, 1);
        let mut now = Now { step: 0, gaussians: start as usize, training: 0.0, elapsed: 0.0 };
        loop {
            if let Some(steps) = scheduler.schedule(&config, now) {
                config.run.reschedule(now.step, steps);
            }
            if now.step >= config.run.steps {
                return (now.elapsed + 2.0 * evaluation, config);
            }
            if now.step > 0 && now.step.is_multiple_of(config.run.evaluate_every) {
                now.elapsed += evaluation;
                scheduler.evaluated(evaluation, 5);
            }
            let fraction = config.run.fraction(now.step);
            let took = cost(fraction, now.gaussians as f64);
            now.step += 1;
            now.training += took;
            now.elapsed += took;
            let densification = &config.densification;
            let fraction = config.run.fraction(now.step);
            if now.step.is_multiple_of(densification.every)
                && (densification.begin..=densification.end).contains(&fraction)
            {
                let more = now.gaussians as f64 * (1.0 + densification.rate);
                now.gaussians = (more as usize).min(densification.max_gaussians as usize);
            }
        }
    }

    #[test]
    fn a_run_ends_at_its_time() {
        let costs: [fn(f64, f64) -> f64; 6] = [
            |_, _| 0.1,
            |_, gaussians| 0.05 + 3e-6 * gaussians,
            |_, gaussians| 1e-5 * gaussians,
            // steps become slower, and faster toward the end
            |fraction, gaussians| (0.03 + 2e-6 * gaussians) * (1.0 + fraction * (1.0 - fraction)),
            // coarse to fine: the remaining steps take longer, or less long
            |fraction, _| if fraction < 0.8 { 0.1 } else { 0.13 },
            |fraction, _| if fraction < 0.8 { 0.13 } else { 0.1 },
        ];
        for (index, cost) in costs.into_iter().enumerate() {
            for seconds in [120.0, 600.0, 3600.0] {
                let (took, config) = run(seconds, cost);
                let error = took / seconds - 1.0;
                assert!(error.abs() < 0.05, "cost {index}, {seconds} s: {took}");
                assert!((config.run.fraction(config.run.steps) - 1.0).abs() < 1e-12);
                // fractions follow time: half of the run is done after about half of its time
                let middle = config.run.fraction(config.run.steps / 2);
                assert!((0.3..0.7).contains(&middle), "cost {index}, {seconds} s: {middle}");
                TrainConfig::parse(&config.to_toml(), std::path::Path::new("a schedule")).unwrap();
            }
        }
    }

    #[test]
    fn a_time_that_is_over_at_once_gives_one_step_more() {
        let (_, config) = run(0.5, |_, _| 1.0);
        assert!(config.run.steps <= 3, "{}", config.run.steps);
    }
}
