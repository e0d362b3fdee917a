//! The addresses of readers.

use std::net::{Ipv4Addr, SocketAddrV4, UdpSocket};

use super::packet::OVERHEAD;

/// The bytes of a datagram that a network passes on whole: Ethernet's 1500 without the headers of IP and UDP.
const ETHERNET: u16 = 1500 - 28;
/// The bytes of a datagram within this machine. Linux takes up to 65507; other systems take less by default.
const LOCAL: u16 = if cfg!(target_os = "linux") { 61_440 } else { 8_192 };

/// Where a participant's readers receive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Route {
    /// The address.
    pub(super) address: SocketAddrV4,
    /// The bytes of data in a datagram, a multiple of 4.
    pub(super) fragment: u16,
}

/// What this machine knows about addresses.
pub(super) trait Host {
    /// Whether an address is one of this machine's.
    fn is_own(&self, address: Ipv4Addr) -> bool;
    /// The own address from which another one is reached, if there is a way.
    fn source(&self, address: Ipv4Addr) -> Option<Ipv4Addr>;
}

/// The system.
pub(super) struct System;

impl Host for System {
    fn is_own(&self, address: Ipv4Addr) -> bool {
        // Only an own address can be bound.
        UdpSocket::bind((address, 0)).is_ok()
    }

    fn source(&self, address: Ipv4Addr) -> Option<Ipv4Addr> {
        let socket = UdpSocket::bind((Ipv4Addr::UNSPECIFIED, 0)).ok()?;
        // Nothing is sent; the system only looks for the way.
        socket.connect((address, 9)).ok()?;
        match socket.local_addr().ok()?.ip() {
            std::net::IpAddr::V4(own) => Some(own),
            std::net::IpAddr::V6(_) => None,
        }
    }
}

/// Chooses one of the addresses that a reader announces. Every machine announces its loopback address, and bridges of containers
/// have the same address on each machine: a reader is on this machine only if all of its addresses are. A reader on another
/// machine is reached at the address that is closest to one of this machine's.
pub(super) fn route(announced: &[SocketAddrV4], host: &impl Host) -> Option<Route> {
    let (loopback, others): (Vec<SocketAddrV4>, Vec<SocketAddrV4>) =
        announced.iter().partition(|one| one.ip().is_loopback());
    let is_foreign = |one: &&SocketAddrV4| !host.is_own(*one.ip());
    let foreign: Vec<SocketAddrV4> = others.iter().filter(is_foreign).copied().collect();
    if foreign.is_empty() {
        return Some(Route {
            address: *loopback.first().or(others.first())?,
            fragment: LOCAL,
        });
    }
    let near = |one: &SocketAddrV4| {
        let source = host.source(*one.ip())?;
        Some((one.ip().to_bits() ^ source.to_bits()).leading_zeros())
    };
    let reachable = foreign.into_iter().filter_map(|one| Some((near(&one)?, one)));
    let (_, address) = reachable.max_by_key(|(near, one)| (*near, std::cmp::Reverse(*one)))?;
    Some(Route {
        address,
        fragment: (ETHERNET - OVERHEAD) & !3,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A machine with an address in a local network and a bridge of containers.
    struct Machine;

    const LAN: Ipv4Addr = Ipv4Addr::new(192, 168, 1, 10);
    const CONTAINERS: Ipv4Addr = Ipv4Addr::new(172, 17, 0, 1);

    impl Host for Machine {
        fn is_own(&self, address: Ipv4Addr) -> bool {
            [LAN, CONTAINERS].contains(&address)
        }

        fn source(&self, address: Ipv4Addr) -> Option<Ipv4Addr> {
            match address.octets() {
                [172, 17, ..] => Some(CONTAINERS),
                [10, ..] => None,
                _ => Some(LAN),
            }
        }
    }

    fn chosen(announced: &[Ipv4Addr]) -> Option<(Ipv4Addr, bool)> {
        let announced: Vec<_> = announced
            .iter()
            .map(|address| SocketAddrV4::new(*address, 7411))
            .collect();
        route(&announced, &Machine).map(|route| (*route.address.ip(), route.fragment == LOCAL))
    }

    #[test]
    fn readers_on_this_machine_are_reached_within_it() {
        let loopback = Ipv4Addr::LOCALHOST;
        assert_eq!(chosen(&[loopback]), Some((loopback, true)));
        assert_eq!(chosen(&[LAN]), Some((LAN, true)));
        assert_eq!(chosen(&[LAN, CONTAINERS, loopback]), Some((loopback, true)));
        assert_eq!(chosen(&[]), None);
    }

    #[test]
    fn readers_elsewhere_are_reached_at_the_closest_address() {
        let other = Ipv4Addr::new(192, 168, 1, 20);
        // It has a bridge of containers, too.
        let all = [Ipv4Addr::LOCALHOST, CONTAINERS, other];
        assert_eq!(chosen(&all), Some((other, false)));
        let far = Ipv4Addr::new(203, 0, 113, 5);
        assert_eq!(chosen(&[far, other]), Some((other, false)));
        assert_eq!(chosen(&[far]), Some((far, false)));
        let container = Ipv4Addr::new(172, 17, 0, 2);
        assert_eq!(chosen(&[container]), Some((container, false)));
        assert_eq!(chosen(&[Ipv4Addr::new(10, 0, 0, 1)]), None);
    }

    #[test]
    fn fragments_are_whole_words_that_fit_into_a_datagram() {
        let fragment = |address| {
            let announced = [SocketAddrV4::new(address, 7411)];
            route(&announced, &Machine).unwrap().fragment
        };
        for (address, limit) in [(LAN, 65_507), (Ipv4Addr::new(192, 168, 1, 20), 1472)] {
            let fragment = fragment(address);
            assert_eq!(fragment % 4, 0);
            assert!(fragment + OVERHEAD <= limit && fragment > 1000);
        }
    }
}
