//! The WebSocket of a page: requests in, frames out.
//!
//! Each OAK has at most one pending request, the newest; one frame is computed at a time. A frame that is being computed is
//! sent even if a newer request waits: otherwise a page that moves faster than frames are computed would see none.

use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex, PoisonError};

use axum::extract::ws::{Message, WebSocket};
use serde::Serialize;
use tokio::task::JoinHandle;

use crate::frame;
use crate::job::{self, Job};
use crate::probe;
use crate::protocol::{ClientMessage, Failure, FrameRequest, ProbeRequest, Rejection};
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

    /// Removes the next request. Probes take no time, so they come first.
    fn next(&mut self) -> Option<Request> {
        let probe = self.probes.pop_front().map(Request::Probe);
        probe.or_else(|| self.frames.pop_front().map(Request::Frame))
    }
}

/// Serves a page until it leaves.
pub(crate) async fn serve(mut socket: WebSocket, studio: Arc<Studio>) {
    let stations = Stations::default();
    let mut pending = Pending::default();
    let mut running: Option<JoinHandle<Message>> = None;
    loop {
        if running.is_none() {
            let next = pending.next();
            running = next.map(|request| start(&studio, &stations, request));
        }
        tokio::select! {
            received = socket.recv() => match received {
                Some(Ok(Message::Text(text))) => match read(&text) {
                    Ok(message) => pending.add(message),
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
    serde_json::from_str(text)
        .map(|message| match message {
            ClientMessage::Frame(request) => Request::Frame(request),
            ClientMessage::Probe(request) => Request::Probe(request),
        })
        .map_err(|error| {
            let failure = Failure::from(format!("invalid request: {error}; load the page again"));
            rejection(0, "", failure)
        })
}

/// Waits for the running request, or forever without one.
async fn completed(running: &mut Option<JoinHandle<Message>>) -> Message {
    let Some(task) = running.as_mut() else {
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
        // Frames of several pages share the processor.
        let compute = move |studio: &Studio, _: &Job| Ok(answer(studio, &stations, &request));
        let computed = job::run_in(&studio, &studio.computing, job::FRAME, compute).await;
        computed.unwrap_or_else(|failure| rejection(id, &oak, failure))
    })
}

fn answer(studio: &Studio, stations: &Stations, request: &Request) -> Message {
    let mut stations = stations.lock().unwrap_or_else(PoisonError::into_inner);
    match request {
        Request::Frame(request) => {
            if stations.len() >= MAX_OAKS && !stations.contains_key(&request.oak) {
                // Keys of removed OAKs are not used again.
                stations.clear();
            }
            let station = stations.entry(request.oak.clone()).or_default();
            match frame::frame(studio, station, request) {
                Ok(bytes) => Message::Binary(bytes.into()),
                Err(failure) => rejection(request.id, &request.oak, failure),
            }
        }
        Request::Probe(request) => {
            // A probe creates nothing: there may be any number of keys.
            match probe::probe(stations.get(&request.oak), request) {
                Ok(answer) => text(&answer),
                Err(failure) => rejection(request.id, &request.oak, failure),
            }
        }
    }
}

fn rejection(id: u64, oak: &str, failure: Failure) -> Message {
    text(&Rejection {
        id,
        oak: oak.to_owned(),
        failure,
    })
}

fn text(answer: &impl Serialize) -> Message {
    Message::Text(serde_json::to_string(answer).unwrap_or_default().into())
}
