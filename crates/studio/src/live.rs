//! The WebSocket of a page: requests in, frames out.
//!
//! Each OAK has at most one pending request, the newest; one frame is computed at a time. A preview that is being computed is
//! sent even if a newer request waits: otherwise a page that moves faster than frames are computed would see none. Previews
//! come before images for rest, and interrupt one that is being computed.

use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex, PoisonError};

use axum::extract::ws::{Message, WebSocket};
use tokio::task::JoinHandle;

use crate::frame;
use crate::job::{self, Job};
use crate::probe;
use crate::protocol::{
    Failure, FrameRequest, Kind, Pose, ProbeRequest, Rejection, RequestKind, ServerMessage,
};
use crate::station::Station;
use crate::studio::Studio;

/// The maximum number of OAKs on a page.
const MAX_OAKS: usize = 16;
/// The maximum number of waiting probes: of more, the oldest are dropped.
const MAX_PROBES: usize = 8;
/// The maximum length of a request, bytes.
pub(crate) const MAX_MESSAGE_BYTES: usize = 1 << 16;

/// The OAKs of a page by their keys.
pub(crate) type Stations = Arc<Mutex<HashMap<String, Station>>>;

/// The requests that wait.
#[derive(Debug, Default)]
struct Pending {
    frames: VecDeque<Box<FrameRequest>>,
    probes: VecDeque<ProbeRequest>,
}

/// A request that is computed.
#[derive(Debug)]
pub(crate) enum Request {
    Frame(Box<FrameRequest>),
    Probe(ProbeRequest),
}

impl Pending {
    /// Adds a request, which replaces an older one of the same OAK.
    fn add(&mut self, request: Request) {
        match request {
            Request::Frame(request) => {
                match self.frames.iter_mut().find(|known| known.oak == request.oak) {
                    Some(known) => *known = request,
                    None => self.frames.push_back(request),
                }
                while self.frames.len() > MAX_OAKS {
                    self.frames.pop_front();
                }
            }
            Request::Probe(request) => {
                self.probes.retain(|known| known.oak != request.oak);
                self.probes.push_back(request);
                while self.probes.len() > MAX_PROBES {
                    self.probes.pop_front();
                }
            }
        }
    }

    /// Puts a frame that was interrupted back, unless a newer request replaces it.
    fn put_back(&mut self, request: Box<FrameRequest>) {
        if self.frames.iter().all(|known| known.oak != request.oak) {
            self.frames.push_front(request);
        }
    }

    /// Removes the next request. Probes take no time, so they come first; images for rest come last.
    fn next(&mut self) -> Option<Request> {
        if let Some(probe) = self.probes.pop_front() {
            return Some(Request::Probe(probe));
        }
        let preview = self.frames.iter().position(|request| request.is_preview);
        self.frames.remove(preview.unwrap_or(0)).map(Request::Frame)
    }

    /// Whether a preview waits that sees something else than images for rest do. Those with other parameters need the same light.
    fn has_other_preview(&self, at_rest: &FrameRequest) -> bool {
        let mut previews = self.frames.iter().filter(|request| request.is_preview);
        previews.any(|request| view(request) != view(at_rest))
    }
}

/// What determines the light of a request.
fn view(request: &FrameRequest) -> (&str, &str, [&str; 3], Option<&str>, Pose) {
    let state = &request.state;
    let cameras = [&state.model, &state.sensor, &state.lens].map(String::as_str);
    let calibration = state.calibration.as_deref();
    (&request.oak, &request.scene, cameras, calibration, state.pose)
}

/// A request that is being computed.
#[derive(Debug)]
struct Running {
    task: JoinHandle<Message>,
    /// The request, if it is for images at rest.
    at_rest: Option<Box<FrameRequest>>,
}

impl Running {
    fn new(studio: &Arc<Studio>, stations: &Stations, request: Request) -> Self {
        let at_rest = match &request {
            Request::Frame(request) if !request.is_preview => Some(request.clone()),
            Request::Frame(_) | Request::Probe(_) => None,
        };
        Self {
            task: start(studio, stations, request),
            at_rest,
        }
    }
}

/// Interrupts images for rest if a preview of something else waits for them. The computation ends at its next row or tile.
fn interrupt(running: &mut Option<Running>, pending: &mut Pending) {
    let is_in_the_way = |running: &mut Running| {
        let at_rest = running.at_rest.as_ref().filter(|_| !running.task.is_finished());
        at_rest.is_some_and(|at_rest| pending.has_other_preview(at_rest))
    };
    if let Some(Running { task, at_rest }) = running.take_if(is_in_the_way) {
        task.abort();
        at_rest.into_iter().for_each(|request| pending.put_back(request));
    }
}

/// Serves a page until it leaves.
pub(crate) async fn serve(mut socket: WebSocket, studio: Arc<Studio>) {
    let stations = Stations::default();
    let mut pending = Pending::default();
    let mut running: Option<Running> = None;
    loop {
        if running.is_none() {
            let next = pending.next();
            running = next.map(|request| Running::new(&studio, &stations, request));
        }
        tokio::select! {
            received = socket.recv() => match received {
                Some(Ok(Message::Text(text))) => match read(&text) {
                    Ok(message) => {
                        pending.add(message);
                        interrupt(&mut running, &mut pending);
                    }
                    Err(rejected) => {
                        if socket.send(rejected).await.is_err() {
                            break;
                        }
                    }
                },
                Some(Ok(Message::Ping(_) | Message::Pong(_))) => {}
                Some(Ok(Message::Binary(_) | Message::Close(_)) | Err(_)) | None => break,
            },
            answer = completed(&mut running) => {
                if socket.send(answer).await.is_err() {
                    break;
                }
            }
            () = studio.stopped() => break,
        }
    }
}

/// Reads a request, or returns what is answered to something else.
pub(crate) fn read(text: &str) -> Result<Request, Message> {
    let message = serde_json::from_str(text).and_then(|Kind { is }| match is {
        RequestKind::Frame => serde_json::from_str(text).map(Request::Frame),
        RequestKind::Probe => serde_json::from_str(text).map(Request::Probe),
    });
    message.map_err(|error| {
        let failure = Failure::from(format!("invalid request: {error}; load the page again"));
        rejection(0, "", failure)
    })
}

/// Waits for the running request, or forever without one.
async fn completed(running: &mut Option<Running>) -> Message {
    let Some(Running { task, .. }) = running.as_mut() else {
        return std::future::pending().await;
    };
    let answer = task.await;
    *running = None;
    answer.unwrap_or_else(|_| {
        rejection(
            0,
            "",
            Failure::from("the frame failed; please report this".to_owned()),
        )
    })
}

/// Computes the answer to a request.
pub(crate) fn start(studio: &Arc<Studio>, stations: &Stations, request: Request) -> JoinHandle<Message> {
    let (studio, stations) = (Arc::clone(studio), Arc::clone(stations));
    let (id, oak) = match &request {
        Request::Frame(request) => (request.id, request.oak.clone()),
        Request::Probe(request) => (request.id, request.oak.clone()),
    };
    tokio::spawn(async move {
        let is_at_rest = matches!(&request, Request::Frame(request) if !request.is_preview);
        let compute = move |studio: &Studio, job: &Job| {
            let answer = || answer(studio, &stations, &request, job);
            Ok(match is_at_rest {
                true => job.interruptibly(answer),
                false => answer(),
            })
        };
        // Frames of several pages share the processor.
        let computed = job::run_in(&studio, &studio.computing, job::FRAME, compute).await;
        computed.unwrap_or_else(|failure| rejection(id, &oak, failure))
    })
}

fn answer(studio: &Studio, stations: &Stations, request: &Request, job: &Job) -> Message {
    let mut stations = stations.lock().unwrap_or_else(PoisonError::into_inner);
    match request {
        Request::Frame(request) => {
            if stations.len() >= MAX_OAKS && !stations.contains_key(&request.oak) {
                // Keys of removed OAKs are not used again.
                stations.clear();
            }
            let station = stations.entry(request.oak.clone()).or_default();
            match frame::frame(studio, station, request, job) {
                Ok(bytes) => Message::Binary(bytes.into()),
                Err(failure) => rejection(request.id, &request.oak, failure),
            }
        }
        Request::Probe(request) => {
            // A probe creates nothing: there may be any number of keys.
            match probe::probe(stations.get(&request.oak), request) {
                Ok(answer) => text(&ServerMessage::Probe(answer)),
                Err(failure) => rejection(request.id, &request.oak, failure),
            }
        }
    }
}

fn rejection(id: u64, oak: &str, failure: Failure) -> Message {
    text(&ServerMessage::Error(Rejection {
        id,
        oak: oak.to_owned(),
        failure,
    }))
}

fn text(answer: &ServerMessage) -> Message {
    Message::Text(serde_json::to_string(answer).unwrap_or_default().into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(id: u64, oak: &str, is_preview: bool) -> Box<FrameRequest> {
        let state = r#"{"model":"OAK4-D","calibration":null,"pose":{"position":[0,0,0],"quaternion":[0,0,0,1]},"sensor":"depth_stereo",
            "lens":"pinhole","engine":"stereo-noise","preset":null,"filters":null,"parameters":{},"extendedDisparity":false,"seed":0,
            "deviceSeed":null,"projector":0,"ambient":1}"#;
        let text = format!(
            r#"{{"type":"frame","id":{id},"oak":"{oak}","scene":"first","state":{state},"size":null,"images":[],"region":[0,0,1,1],"isPreview":{is_preview}}}"#
        );
        match read(&text).unwrap() {
            Request::Frame(request) => request,
            Request::Probe(_) => unreachable!(),
        }
    }

    fn ids(pending: &mut Pending) -> Vec<u64> {
        std::iter::from_fn(|| pending.next())
            .map(|request| match request {
                Request::Frame(request) => request.id,
                Request::Probe(request) => request.id,
            })
            .collect()
    }

    #[test]
    fn previews_come_first_and_newer_requests_replace_older_ones() {
        let mut pending = Pending::default();
        for request in [frame(1, "a", false), frame(2, "b", true), frame(3, "a", false)] {
            pending.add(Request::Frame(request));
        }
        assert_eq!(ids(&mut pending), [2, 3]);
    }

    #[test]
    fn previews_with_other_parameters_wait_for_the_same_light() {
        let at_rest = frame(1, "a", false);
        let waiting = |request: Box<FrameRequest>| {
            let mut pending = Pending::default();
            pending.add(Request::Frame(request));
            pending.has_other_preview(&at_rest)
        };
        assert!(!waiting(frame(2, "a", false)));
        assert!(waiting(frame(2, "b", true)));
        let mut tuned = frame(2, "a", true);
        tuned.state.parameters.insert("bias".to_owned(), "0.1".to_owned());
        assert!(!waiting(tuned.clone()));
        tuned.state.pose.position[0] = 1.0;
        assert!(waiting(tuned));
    }

    #[test]
    fn an_interrupted_frame_is_computed_later_unless_a_newer_one_replaces_it() {
        let mut pending = Pending::default();
        pending.add(Request::Frame(frame(2, "b", true)));
        pending.put_back(frame(1, "a", false));
        assert_eq!(ids(&mut pending), [2, 1]);
        pending.add(Request::Frame(frame(4, "a", true)));
        pending.put_back(frame(3, "a", false));
        assert_eq!(ids(&mut pending), [4]);
    }
}
