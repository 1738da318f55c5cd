"""Frames over a TCP connection, with or without TLS."""

import socket
import ssl
import time

from . import protocol

PING_AFTER_S = 20  # without sending, or sooner if the server's limit is lower
SHORTEST_PING_AFTER_S = 0.005  # prevents a flood, whatever the server asks for
DEAD_AFTER_S = 60


class Connection:
    """Sends and receives messages with blocking calls. Sends pings by itself while waiting."""

    def __init__(self, host, port, context, receive_bytes, connect_timeout):
        addresses = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
        deadline = time.monotonic() + connect_timeout
        for place, (family, kind, number, _, address) in enumerate(addresses):
            self.socket = socket.socket(family, kind, number)
            try:
                # Before connecting, for TCP to offer a window of this size.
                self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_bytes)
                self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                self.socket.settimeout(max(deadline - time.monotonic(), 0.1))
                self.socket.connect(address)
                if context:
                    self.socket = context.wrap_socket(self.socket, server_hostname=host)
                break
            except OSError:
                self.socket.close()
                if place == len(addresses) - 1:
                    raise
        self.obey_idle_timeout(0)
        self.buffer = bytearray()
        self.sent_at = self.heard_at = time.monotonic()

    def close(self):
        self.socket.close()

    def obey_idle_timeout(self, idle_timeout_ms):
        """Pings at a third of the time-out: if one is late, the next is still in time. 0: no time-out."""
        self.ping_after_s = PING_AFTER_S
        if idle_timeout_ms:
            self.ping_after_s = max(min(PING_AFTER_S, idle_timeout_ms / 3000), SHORTEST_PING_AFTER_S)
        self.socket.settimeout(self.ping_after_s)

    def send(self, message):
        self.socket.settimeout(PING_AFTER_S)
        self.socket.sendall(protocol.write(message))
        self.socket.settimeout(self.ping_after_s)
        self.sent_at = time.monotonic()

    def idle_s(self):
        """Seconds since something was sent."""
        return time.monotonic() - self.sent_at

    def keep_alive(self):
        if self.idle_s() > self.ping_after_s:
            self.send(protocol.Ping())

    def sleep(self, seconds):
        """Like time.sleep(), but sends pings if it is long."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.keep_alive()
            time.sleep(min(left, self.ping_after_s / 2))

    def receive(self):
        """Returns the next message and the number of bytes of its frame."""
        while True:
            length = protocol.frame_length(self.buffer[:4]) if len(self.buffer) >= 4 else None
            if length and len(self.buffer) >= length:
                frame = bytes(self.buffer[:length])
                del self.buffer[:length]
                message = protocol.read(frame)
                if message is not None:
                    return message, length
            else:
                self._receive_bytes()

    def _receive_bytes(self):
        self.keep_alive()
        try:
            data = self.socket.recv(65536)
        except (TimeoutError, socket.timeout):
            if time.monotonic() - self.heard_at > DEAD_AFTER_S:
                raise TimeoutError(f"the server said nothing for {DEAD_AFTER_S} s") from None
            return
        if not data:
            raise ConnectionError("the server closed the connection")
        self.heard_at = time.monotonic()
        self.buffer += data


def tls_context(ca):
    """`ca`: a PEM file of trusted certificates; None: the system's."""
    context = ssl.create_default_context(cafile=ca)
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    return context
