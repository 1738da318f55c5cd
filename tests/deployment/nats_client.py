"""NATS' protocol as far as the tests here need it, over one socket: https://docs.nats.io/reference/reference-protocols."""

import json
import re
import secrets
import socket
import ssl
import time


class RefusedError(Exception):
    """The server said -ERR, or ended the connection."""


class NatsClient:
    """A connection to HOST:PORT by a certificate of `folder`: "talusd" is talusd.pem and talusd-key.pem. None: without one. Without
    a folder: without TLS."""

    def __init__(self, port, folder=None, certificate=None, *, authority="ca", host="127.0.0.1", hello=None, timeout=120):
        self.inbox = "_INBOX." + secrets.token_hex(8)
        self.buffer = b""
        self.requests = 0
        self.timeout = timeout
        self.socket = socket.create_connection((host, port), timeout=timeout)
        try:
            if not self._line().startswith(b"INFO "):
                raise RefusedError("no INFO")
            if folder:
                context = ssl.create_default_context(cafile=f"{folder}/{authority}.pem")
                context.check_hostname = host != "127.0.0.1"
                if certificate:
                    context.load_cert_chain(f"{folder}/{certificate}.pem", f"{folder}/{certificate}-key.pem")
                self.socket = context.wrap_socket(self.socket, server_hostname=host)
            self._send(b"CONNECT " + json.dumps({"verbose": False, "pedantic": False, "headers": True, "protocol": 1,
                                                 "no_responders": True, **(hello or {})}).encode() + b"\r\n")
            self.flush()
        except (OSError, RefusedError) as failure:
            self.socket.close()
            raise RefusedError(str(failure)) from failure

    def close(self):
        self.socket.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _send(self, data):
        self.socket.sendall(data)

    def _more(self):
        data = self.socket.recv(65536)
        if not data:
            raise RefusedError("the server ended the connection")
        self.buffer += data

    def _line(self):
        while b"\r\n" not in self.buffer:
            self._more()
        line, self.buffer = self.buffer.split(b"\r\n", 1)
        return line

    def _payload(self, length):
        while len(self.buffer) < length + 2:
            self._more()
        payload, self.buffer = self.buffer[:length], self.buffer[length + 2:]
        return payload

    def next(self):
        """The next message as (subject, head, payload), or "PONG". -ERR raises."""
        until = time.monotonic() + self.timeout
        while True:
            if time.monotonic() > until:
                raise RefusedError("nothing but PING")
            words = self._line().split()
            match words[0]:
                case b"PING":
                    self._send(b"PONG\r\n")
                case b"PONG":
                    return "PONG"
                case b"-ERR":
                    raise RefusedError(b" ".join(words).decode())
                case b"MSG":
                    return words[1].decode(), b"", self._payload(int(words[-1]))
                case b"HMSG":
                    whole, head = self._payload(int(words[-1])), int(words[-2])
                    return words[1].decode(), whole[:head], whole[head:]

    def flush(self):
        """Returns once the server has read all that was sent; what it refused of that raises."""
        self._send(b"PING\r\n")
        messages = []
        while (message := self.next()) != "PONG":
            messages.append(message)
        return messages

    def subscribe(self, subject, number):
        self._send(f"SUB {subject} {number}\r\n".encode())
        return self.flush()

    def publish(self, subject, payload=b"", reply="", headers=None):
        if not headers:
            self._send(f"PUB {subject} {reply} {len(payload)}\r\n".encode() + payload + b"\r\n")
            return
        head = ("NATS/1.0\r\n" + "".join(f"{name}: {value}\r\n" for name, value in headers.items()) + "\r\n").encode()
        self._send(f"HPUB {subject} {reply} {len(head)} {len(head) + len(payload)}\r\n".encode() + head + payload + b"\r\n")

    def request(self, subject, payload=b"", headers=None):
        """(head, payload) of the answer."""
        reply = f"{self.inbox}.{secrets.token_hex(4)}"
        # Each its own: an answer that nobody listens does not end what it came by, and the number would go on as the old one.
        self.requests += 1
        number = f"request{self.requests}"
        self._send(f"SUB {reply} {number}\r\nUNSUB {number} 1\r\n".encode())
        self.publish(subject, payload, reply, headers)
        while True:
            message = self.next()
            if message != "PONG" and message[0] == reply:
                return message[1:]

    def ask(self, subject, **question):
        """A request whose question and answer are JSON."""
        return json.loads(self.request(subject, json.dumps(question).encode() if question else b"")[1])


def status(head):
    """The number in a head's first line, None where there is none."""
    found = re.match(rb"NATS/1\.0 (\d+)", head)
    return int(found[1]) if found else None
