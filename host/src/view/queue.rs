//! The queue where requests wait for the frame renderer.

use std::collections::BTreeMap;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use tokio::sync::oneshot;

use super::message::{FrameRequest, Quality};
use crate::camera::Camera;

/// Number of clients that are remembered.
const MAX_CLIENTS: usize = 256;
/// Most waiting questions; more are refused.
const MAX_QUESTIONS: usize = 64;

/// An answer: its bytes and the facts for the page, or an error message.
pub type Answer = Result<Rendered, String>;

/// An image, or another file.
#[derive(Debug)]
pub struct Rendered {
    pub kind: &'static str,
    pub bytes: Vec<u8>,
    /// Facts for the page, as JSON.
    pub about: String,
}

/// An image to paint.
#[derive(Debug)]
pub struct FrameJob {
    pub request: FrameRequest,
    pub camera: Camera,
    /// Closed if nobody waits for the image anymore.
    pub reply: oneshot::Sender<Answer>,
}

/// Other requests to the frame renderer.
#[derive(Debug)]
pub enum Question {
    /// A pixel's column and row, in an image of the camera.
    Pixel([i32; 2], Box<Camera>),
    /// The photograph of a view in the data set.
    Photograph(usize),
}

/// The next request to handle.
#[derive(Debug)]
pub enum Job {
    Frame(Box<FrameJob>),
    Question(Question, oneshot::Sender<Answer>),
}

#[derive(Debug, Default)]
struct Client {
    job: Option<Box<FrameJob>>,
    /// Sequence number of the newest request.
    sequence: u64,
    /// Time of the last request, counted in requests.
    last: u64,
    /// Time that its images have taken.
    spent: Duration,
}

#[derive(Debug, Default)]
struct State {
    clients: BTreeMap<u64, Client>,
    questions: VecDeque<(Question, oneshot::Sender<Answer>)>,
    requests: u64,
}

/// Waiting requests.
#[derive(Debug, Default)]
pub struct Queue {
    state: Mutex<State>,
    wake: Condvar,
    stopped: AtomicBool,
}

impl Queue {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Ends the waiting for requests forever.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
        let mut state = self.state();
        // whoever waits for an answer gets to know
        state.clients.clear();
        state.questions.clear();
        self.wake.notify_all();
    }

    /// Whether [`Queue::stop`] was called.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// Adds an image request, in place of the client's older one.
    pub(super) fn post(&self, job: Box<FrameJob>) {
        let mut state = self.state();
        if self.is_stopped() {
            return;
        }
        state.requests += 1;
        let now = state.requests;
        let id = job.request.client;
        if !state.clients.contains_key(&id) && state.clients.len() >= MAX_CLIENTS {
            let idle = state.clients.iter().filter(|(_, client)| client.job.is_none());
            let oldest = idle.min_by_key(|(_, client)| client.last).map(|(id, _)| *id);
            match oldest {
                Some(oldest) => state.clients.remove(&oldest),
                // dropping the job drops its reply
                None => return,
            };
        }
        // time that a client did not use is not saved up
        let least = state.clients.values().filter(|client| client.is_waiting());
        let least = least.map(|client| client.spent).min().unwrap_or_default();
        let client = state.clients.entry(id).or_default();
        if client.job.is_none() {
            client.spent = client.spent.max(least);
        }
        client.last = now;
        // requests may overtake each other on the way
        if job.request.sequence >= client.sequence {
            client.sequence = job.request.sequence;
            client.job = Some(job);
            self.wake.notify_all();
        }
    }

    /// Adds a question.
    pub(super) fn ask(&self, question: Question, reply: oneshot::Sender<Answer>) {
        let mut state = self.state();
        if state.questions.len() < MAX_QUESTIONS && !self.is_stopped() {
            state.questions.push_back((question, reply));
            self.wake.notify_all();
        }
    }

    /// Returns an interrupted request, unless the client has a newer one by now.
    pub(super) fn put_back(&self, job: Box<FrameJob>) {
        let mut state = self.state();
        if let Some(client) = state.clients.get_mut(&job.request.client)
            && client.job.is_none()
            && client.sequence == job.request.sequence
        {
            client.job = Some(job);
        }
    }

    /// Notes that a client's image has taken some time.
    pub(super) fn charge(&self, client: u64, spent: Duration) {
        if let Some(client) = self.state().clients.get_mut(&client) {
            client.spent += spent;
        }
    }

    /// Takes the next request, waiting for it for up to `patience`. It is that of the client whose images have taken
    /// the least time.
    pub(super) fn take(&self, patience: Duration) -> Option<Job> {
        let mut state = self.state();
        if !state.is_waiting() && !self.is_stopped() && !patience.is_zero() {
            state =
                self.wake.wait_timeout(state, patience).unwrap_or_else(PoisonError::into_inner).0;
        }
        if self.is_stopped() {
            return None;
        }
        state.questions.retain(|(_, reply)| !reply.is_closed());
        if let Some((question, reply)) = state.questions.pop_front() {
            return Some(Job::Question(question, reply));
        }
        let waiting = state.clients.iter().filter(|(_, client)| client.is_waiting());
        let next = *waiting.min_by_key(|(id, client)| (client.spent, **id))?.0;
        state.clients.get_mut(&next).and_then(|client| client.job.take()).map(Job::Frame)
    }

    /// Whether an image is obsolete: nobody waits for it, or its client wants another one.
    pub(super) fn is_outdated(&self, job: &FrameJob) -> bool {
        let newest = self.state().clients.get(&job.request.client).map(|client| client.sequence);
        job.reply.is_closed()
            || self.is_stopped()
            || newest.is_some_and(|newest| newest > job.request.sequence)
    }

    /// Whether a request waits that has priority over an exact image.
    pub(super) fn has_urgent(&self) -> bool {
        let state = self.state();
        !state.questions.is_empty()
            || state.clients.values().any(|client| client.job.as_deref().is_some_and(is_urgent))
    }

    /// Whether anything waits.
    #[must_use]
    pub fn has_work(&self) -> bool {
        self.state().is_waiting()
    }
}

fn is_urgent(job: &FrameJob) -> bool {
    job.request.quality != Quality::Exact
}

impl Client {
    fn is_waiting(&self) -> bool {
        self.job.as_ref().is_some_and(|job| !job.reply.is_closed())
    }
}

impl State {
    fn is_waiting(&self) -> bool {
        self.questions.iter().any(|(_, reply)| !reply.is_closed())
            || self.clients.values().any(Client::is_waiting)
    }
}
