"""Counts the datagrams that reach an interface until the input ends: multicasts of discovery and of data, and the rest."""

import json
import select
import socket
import struct
import sys

from ros_network import DOMAIN

# OMG "DDSI-RTPS" 9.6.1.
DISCOVERY_PORT = 7400 + 250 * DOMAIN
ALL_PROTOCOLS, OUTGOING = 0x0003, 4


def main() -> None:
    sniffer = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(ALL_PROTOCOLS))
    sniffer.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 64 << 20)
    sniffer.bind(("eth0", 0))
    print("ready", flush=True)
    counts = {"discovery": 0, "multicast_data": 0, "unicast": 0, "bytes": 0}
    while True:
        ready, _, _ = select.select([sniffer, sys.stdin], [], [])
        if sniffer in ready:
            frame, about = sniffer.recvfrom(1 << 16)
            is_udp = struct.unpack_from("!H", frame, 12) == (0x0800,) and frame[23] == socket.IPPROTO_UDP
            if not is_udp or about[2] == OUTGOING:
                continue
            port = struct.unpack_from("!H", frame, 14 + 4 * (frame[14] & 15) + 2)[0]
            is_multicast = 224 <= frame[30] < 240
            kind = ("discovery" if port == DISCOVERY_PORT else "multicast_data") if is_multicast else "unicast"
            counts[kind] += 1
            counts["bytes"] += len(frame)
        elif not sys.stdin.read(1):
            break
    print(json.dumps(counts))


if __name__ == "__main__":
    main()
