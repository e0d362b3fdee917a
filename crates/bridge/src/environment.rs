//! ROS's environment variables about discovery.

use std::net::{IpAddr, Ipv4Addr, UdpSocket};

use oaktwin::diagnostic::{Finding, Level};

use crate::BridgeError;

/// The highest domain whose ports exist (OMG "DDSI-RTPS" 9.6.1.1).
const MAX_DOMAIN: u16 = 232;

/// The part of the network on which other nodes are found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Network {
    /// The domain; nodes of other domains are invisible.
    pub domain: u16,
    /// Whether only nodes of this machine are found.
    pub is_local: bool,
    /// The address of the only interface on which nodes of other machines are found; `None` for all interfaces.
    pub interface: Option<Ipv4Addr>,
}

impl Network {
    /// Reads `ROS_DOMAIN_ID`, `ROS_LOCALHOST_ONLY`, `ROS_AUTOMATIC_DISCOVERY_RANGE` and `ROS_STATIC_PEERS`.
    ///
    /// # Errors
    /// Returns an error if a value is invalid or unsupported.
    pub fn from_environment() -> Result<(Self, Vec<Finding>), BridgeError> {
        Self::read(|name| std::env::var(name).ok())
    }

    fn read(variable: impl Fn(&str) -> Option<String>) -> Result<(Self, Vec<Finding>), BridgeError> {
        let variable = |name| variable(name).filter(|value| !value.is_empty());
        let wrong = |name: &'static str, value: &str, remedy: &str| BridgeError::Environment {
            name,
            value: value.chars().take(40).collect(),
            remedy: remedy.to_owned(),
        };
        let domain = match variable("ROS_DOMAIN_ID") {
            None => 0,
            Some(text) => match text.parse() {
                Ok(domain) if domain <= MAX_DOMAIN => domain,
                _ => return Err(wrong("ROS_DOMAIN_ID", &text, "set a number from 0 to 232")),
            },
        };
        let by_range = match variable("ROS_AUTOMATIC_DISCOVERY_RANGE") {
            None => None,
            Some(text) => match text.as_str() {
                "SUBNET" | "SYSTEM_DEFAULT" => Some(false),
                "LOCALHOST" => Some(true),
                "OFF" => {
                    let remedy = "the bridge finds its topics by discovery; set LOCALHOST or SUBNET";
                    return Err(wrong("ROS_AUTOMATIC_DISCOVERY_RANGE", &text, remedy));
                }
                _ => {
                    let remedy = "expected SUBNET, LOCALHOST or SYSTEM_DEFAULT";
                    return Err(wrong("ROS_AUTOMATIC_DISCOVERY_RANGE", &text, remedy));
                }
            },
        };
        // The older variable counts more where it is set, as in ROS.
        let is_local = match variable("ROS_LOCALHOST_ONLY").as_deref() {
            Some("1") => true,
            Some("0") | None => by_range.unwrap_or(false),
            Some(text) => return Err(wrong("ROS_LOCALHOST_ONLY", text, "set 0 or 1")),
        };
        let mut findings = Vec::new();
        if variable("ROS_STATIC_PEERS").is_some() {
            findings.push(Finding::new(
                "static-peers",
                Level::Warning,
                "ROS_STATIC_PEERS",
                "has no effect: peers are found by multicast and on this machine",
                "run the bridge on the machine of the publisher",
            ));
        }
        let network = Self {
            domain,
            is_local,
            interface: None,
        };
        Ok((network, findings))
    }

    /// Restricts the network to this machine and the interface with an address, whatever the environment says.
    ///
    /// # Errors
    /// Returns an error if no interface has the address.
    pub fn on(self, address: Ipv4Addr) -> Result<Self, BridgeError> {
        // Only an own address can be bound.
        if address.is_unspecified() || UdpSocket::bind((address, 0)).is_err() {
            return Err(BridgeError::Interface(address));
        }
        Ok(Self {
            is_local: address.is_loopback(),
            interface: Some(address).filter(|address| !address.is_loopback()),
            ..self
        })
    }

    /// The addresses on which nodes are found, if not all.
    pub(crate) fn only(&self) -> Option<Vec<IpAddr>> {
        let restricted = self.is_local || self.interface.is_some();
        let addresses = self.interface.into_iter().chain([Ipv4Addr::LOCALHOST]);
        restricted.then(|| addresses.map(IpAddr::V4).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(variables: &[(&str, &str)]) -> Result<Network, String> {
        let variable = |name: &str| {
            let found = variables.iter().find(|(known, _)| *known == name);
            found.map(|(_, value)| (*value).to_owned())
        };
        Network::read(variable)
            .map(|(network, _)| network)
            .map_err(|error| error.to_string())
    }

    #[test]
    fn variables_choose_the_network() {
        let network = |domain, is_local| {
            Ok(Network {
                domain,
                is_local,
                interface: None,
            })
        };
        assert_eq!(read(&[]), network(0, false));
        assert_eq!(
            read(&[("ROS_DOMAIN_ID", "42"), ("ROS_LOCALHOST_ONLY", "")]),
            network(42, false)
        );
        assert_eq!(read(&[("ROS_LOCALHOST_ONLY", "1")]), network(0, true));
        let range = |range| [("ROS_AUTOMATIC_DISCOVERY_RANGE", range)];
        assert_eq!(read(&range("LOCALHOST")), network(0, true));
        assert_eq!(read(&range("SUBNET")), network(0, false));
        let both = [
            ("ROS_AUTOMATIC_DISCOVERY_RANGE", "SUBNET"),
            ("ROS_LOCALHOST_ONLY", "1"),
        ];
        assert_eq!(read(&both), network(0, true));
    }

    #[test]
    fn an_interface_counts_more_than_the_environment() {
        let (network, _) = Network::read(|_| None).unwrap();
        assert_eq!(network.only(), None);
        let local = network.clone().on(Ipv4Addr::LOCALHOST).unwrap();
        assert!(local.is_local && local.interface.is_none());
        assert_eq!(local.only(), Some(vec![IpAddr::V4(Ipv4Addr::LOCALHOST)]));
        // An address for documentation (RFC 5737), and none at all.
        for address in [Ipv4Addr::new(198, 51, 100, 7), Ipv4Addr::UNSPECIFIED] {
            let error = network.clone().on(address).unwrap_err().to_string();
            assert!(error.starts_with(&format!("{address}: ")), "{error}");
        }
    }

    #[test]
    fn invalid_values_are_rejected() {
        for (name, value, expected) in [
            ("ROS_DOMAIN_ID", "233", "from 0 to 232"),
            ("ROS_DOMAIN_ID", "-1", "from 0 to 232"),
            ("ROS_DOMAIN_ID", "one", "from 0 to 232"),
            ("ROS_LOCALHOST_ONLY", "yes", "0 or 1"),
            ("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF", "LOCALHOST or SUBNET"),
            ("ROS_AUTOMATIC_DISCOVERY_RANGE", "local", "SUBNET"),
        ] {
            let error = read(&[(name, value)]).unwrap_err();
            assert!(
                error.starts_with(&format!("{name}: ")) && error.contains(expected),
                "{error}"
            );
        }
        let (_, findings) =
            Network::read(|name| (name == "ROS_STATIC_PEERS").then(|| "host".to_owned())).unwrap();
        assert_eq!(findings[0].code, "static-peers");
    }
}
