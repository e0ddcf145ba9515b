//! The queue where requests wait for the frame renderer.

use std::collections::{BTreeMap, VecDeque};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use parking_lot::{Condvar, Mutex};
use tokio::sync::oneshot;

use super::editor::EditRequest;
use super::message::{FrameRequest, Quality};
use super::places::PlaceRequest;
use organza_core::camera::Camera;

/// Number of clients that are remembered.
const MAX_CLIENTS: usize = 256;
/// Most waiting questions; more are refused.
const MAX_QUESTIONS: usize = 64;

/// An answer: its bytes and the facts for the page, or an error message.
pub type Answer = Result<Payload, String>;

/// An image, or another file.
#[derive(Debug)]
pub struct Payload {
    pub kind: &'static str,
    pub bytes: Vec<u8>,
    /// Facts for the page, as JSON.
    pub about: String,
}

/// An image to paint.
#[derive(Debug)]
pub struct FrameJob {
    pub request: FrameRequest,
    /// Closed if the client no longer waits for the image.
    pub reply: oneshot::Sender<Answer>,
}

/// Other requests to the frame renderer.
#[derive(Debug)]
pub enum Question {
    /// A pixel's column and row, in an image of the camera.
    Pixel([i32; 2], Box<Camera>),
    /// The photograph of a view in the data set.
    Photograph(usize),
    /// A change to the scene.
    Edit(Box<EditRequest>),
    /// A scene's new place; `None` changes nothing.
    Place(Option<PlaceRequest>),
}

/// The next request to handle.
#[derive(Debug)]
pub enum NextJob {
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
    /// Its last turn, 0 before the first.
    turn: u64,
}

#[derive(Debug, Default)]
struct QueueState {
    clients: BTreeMap<u64, Client>,
    questions: VecDeque<(Question, oneshot::Sender<Answer>)>,
    requests: u64,
    /// Number of images that were taken.
    turns: u64,
}

/// Waiting requests.
#[derive(Debug, Default)]
pub struct Queue {
    state: Mutex<QueueState>,
    wake: Condvar,
    stopped: AtomicBool,
}

impl Queue {
    /// Ends the waiting for requests forever.
    pub fn stop(&self) {
        self.stopped.store(true, Ordering::Relaxed);
        let mut state = self.state.lock();
        // clients that wait for an answer learn of it
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
        let mut state = self.state.lock();
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
        let client = state.clients.entry(id).or_default();
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
        let mut state = self.state.lock();
        if state.questions.len() < MAX_QUESTIONS && !self.is_stopped() {
            state.questions.push_back((question, reply));
            self.wake.notify_all();
        }
    }

    /// Returns an interrupted request, unless the client has a newer one by now.
    pub(super) fn put_back(&self, job: Box<FrameJob>) {
        let mut state = self.state.lock();
        if let Some(client) = state.clients.get_mut(&job.request.client)
            && client.job.is_none()
            && client.sequence == job.request.sequence
        {
            client.job = Some(job);
        }
    }

    /// Takes the next request, waiting for it for up to `patience`. An image belongs to the client whose last turn
    /// was the longest ago.
    pub(super) fn take(&self, patience: Duration) -> Option<NextJob> {
        let mut state = self.state.lock();
        if !state.is_waiting() && !self.is_stopped() && !patience.is_zero() {
            self.wake.wait_for(&mut state, patience);
        }
        if self.is_stopped() {
            return None;
        }
        state.questions.retain(|(_, reply)| !reply.is_closed());
        if let Some((question, reply)) = state.questions.pop_front() {
            return Some(NextJob::Question(question, reply));
        }
        let waiting = state.clients.iter().filter(|(_, client)| client.is_waiting());
        let (&next, _) = waiting.min_by_key(|(id, client)| (client.turn, **id))?;
        state.turns += 1;
        let turn = state.turns;
        let client = state.clients.get_mut(&next)?;
        client.turn = turn;
        client.job.take().map(NextJob::Frame)
    }

    /// Whether an image is obsolete: its client no longer waits for it, or wants another one.
    pub(super) fn is_outdated(&self, job: &FrameJob) -> bool {
        let newest =
            self.state.lock().clients.get(&job.request.client).map(|client| client.sequence);
        job.reply.is_closed()
            || self.is_stopped()
            || newest.is_some_and(|newest| newest > job.request.sequence)
    }

    /// Whether a request waits that has priority over an exact image.
    pub(super) fn has_urgent(&self) -> bool {
        let state = self.state.lock();
        !state.questions.is_empty()
            || state.clients.values().any(|client| {
                client.job.as_ref().is_some_and(|job| job.request.quality != Quality::Exact)
            })
    }
}

impl Client {
    fn is_waiting(&self) -> bool {
        self.job.as_ref().is_some_and(|job| !job.reply.is_closed())
    }
}

impl QueueState {
    fn is_waiting(&self) -> bool {
        self.questions.iter().any(|(_, reply)| !reply.is_closed())
            || self.clients.values().any(Client::is_waiting)
    }
}

#[cfg(test)]
mod tests {
    use super::super::message::Mode;
    use super::*;

    /// Adds a request of a client. Its answer is awaited until the receiver is dropped.
    fn post(queue: &Queue, client: u64, sequence: u64) -> oneshot::Receiver<Answer> {
        let (reply, answer) = oneshot::channel();
        let request = FrameRequest {
            client,
            sequence,
            camera: organza_core::demo::turntable(1, 16).remove(0),
            mode: Mode::Color,
            quality: Quality::Still,
            background: None,
            view: None,
        };
        queue.post(Box::new(FrameJob { request, reply }));
        answer
    }

    #[test]
    fn clients_take_turns() {
        let queue = Queue::default();
        let mut answers: Vec<_> = (0..3).map(|client| post(&queue, client, 0)).collect();
        let mut take = |sequence: u64| {
            let Some(NextJob::Frame(job)) = queue.take(Duration::ZERO) else { panic!("all wait") };
            let client = job.request.client;
            // a client may ask for more at once, and one has gone
            if client != 1 {
                answers[client as usize] = post(&queue, client, sequence);
            }
            client
        };
        assert_eq!([1, 2, 3, 4, 5, 6].map(&mut take), [0, 1, 2, 0, 2, 0]);
    }
}
