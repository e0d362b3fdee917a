//! Best-effort delivery of samples to each reader.
//!
//! The DDS library sends samples to the multicast address that a reader announces, whatever else it announces: a stream of images
//! then floods every machine of the network, also if its only reader is on this machine. Discovery remains the library's, and
//! so do the writers that it announces; their samples are sent from here, to one address of each participant with readers.

mod packet;
mod route;

use std::collections::BTreeSet;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, UdpSocket};
use std::time::{Duration, SystemTime};

use byteorder::LittleEndian;
use rustdds::cdr_encoding;
use serde::Serialize;

use packet::{Sample, payload};
use route::{Route, System, route};

/// The longest time that the network may take for a datagram.
const PATIENCE: Duration = Duration::from_millis(200);

/// Sends the samples of a writer.
#[derive(Debug)]
pub(crate) struct UnicastSender {
    socket: UdpSocket,
    writer: [u8; 16],
    last: u64,
    announced: BTreeSet<Vec<SocketAddrV4>>,
    routes: BTreeSet<Route>,
}

impl UnicastSender {
    /// Creates the sender of a writer's samples, which the identifier `writer` names.
    pub(crate) fn new(writer: [u8; 16]) -> io::Result<Self> {
        let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0))?;
        socket.set_write_timeout(Some(PATIENCE))?;
        Ok(Self {
            socket,
            writer,
            last: 0,
            announced: BTreeSet::new(),
            routes: BTreeSet::new(),
        })
    }

    /// Sets the readers, each with the addresses that it announces.
    pub(crate) fn set_readers(&mut self, readers: impl Iterator<Item = Vec<SocketAddr>>) {
        let announced = readers.map(|addresses| {
            let v4 = addresses.into_iter().filter_map(|address| match address {
                SocketAddr::V4(address) => Some(address),
                SocketAddr::V6(_) => None,
            });
            v4.collect::<Vec<_>>()
        });
        let announced: BTreeSet<_> = announced.collect();
        if announced != self.announced {
            self.routes = announced.iter().filter_map(|one| route(one, &System)).collect();
            self.announced = announced;
        }
    }

    /// Sends a message to all readers. A reader that cannot be reached does not keep it from the others.
    pub(crate) fn send(&mut self, message: &impl Serialize) -> Result<(), String> {
        self.last += 1;
        if self.routes.is_empty() {
            return Ok(());
        }
        let payload = payload(|to| cdr_encoding::to_writer::<_, LittleEndian, _>(to, message));
        let payload = payload.map_err(|error| error.to_string())?;
        let since_1970 = SystemTime::now()
            .duration_since(SystemTime::UNIX_EPOCH)
            .unwrap_or_default();
        let fraction = (u64::from(since_1970.subsec_nanos()) << 32) / 1_000_000_000;
        let sample = Sample {
            writer: self.writer,
            number: self.last,
            time: since_1970.as_secs() << 32 | fraction,
            payload: &payload,
        };
        let mut result = Ok(());
        for Route { address, fragment } in &self.routes {
            let sent = sample.send(*fragment, |datagram| {
                self.socket.send_to(datagram, address).map(|_| ())
            });
            if let Err(error) = sent {
                result = Err(format!("{address}: {error}"));
            }
        }
        result
    }
}
