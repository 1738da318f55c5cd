"""Errors of a server."""

from .protocol import ErrorCode


class ServerError(Exception):
    """The server refused. `code` is an ErrorCode; `retry_after_ms` is 0 if a retry does not help."""

    def __init__(self, code, text, retry_after_ms=0):
        super().__init__(f"{getattr(code, 'name', code)}: {text}")
        self.code = code
        self.retry_after_ms = retry_after_ms


class WorldChanged(ConnectionError):
    """After a reconnect the server had another world."""


class OutcomeUnknown(Exception):
    """The edit was sent, and it can no longer be known whether it was applied."""


class ServerLeaving(ConnectionError):
    """The server is shutting down, and asks to wait `retry_after_ms` before reconnecting."""

    def __init__(self, reason, retry_after_ms):
        super().__init__(f"the server ends the session: {reason}")
        self.retry_after_ms = retry_after_ms


def again_later(error):
    return error.code == ErrorCode.overloaded and error.retry_after_ms > 0
