"""Talus for Python: voxels of a Talus world as numpy arrays.

    import talus

    with talus.connect("127.0.0.1:4780") as world:
        chunk = world.chunk(0, 3, 0)                      # chunk.voxels: uint16[y][z][x]
        heights = world.heights([(0, 0), (1, 0)])
        for chunk in world.view(0, 0, radius=4):
            ...

`talus.protocol` and `talus.decode` can be used alone, by programs with their own event loop.
"""

from .chunk import Chunk
from .content_hash import content_hash
from .decoder import DecodeError, decode
from .edits import EditDone, Fill
from .errors import OutcomeUnknown, ServerError, ServerLeaving
from .protocol import ErrorCode, ProtocolError
from .queries import Places

__all__ = [
    "Chunk",
    "DecodeError",
    "EditDone",
    "ErrorCode",
    "Fill",
    "OutcomeUnknown",
    "Places",
    "ProtocolError",
    "ServerError",
    "ServerLeaving",
    "connect",
    "content_hash",
    "decode",
]


def connect(address, *, token="", tls=False, ca=None, timeout=10):
    """Returns a World at "HOST:PORT", or a world over HTTP at "http://HOST:PORT" or "https://HOST:PORT".

    "HOST:PORT,HOST:PORT": servers of one world. If one cannot be reached, goes away or disconnects, the next is tried,
    then around again. One address is enough if a balancer covers all servers.

    `token`: the secret or JSON Web Token that the server requires. `tls`: use TLS, trusting the system's certificates;
    `ca`: use TLS, trusting the certificates in this PEM file. `timeout`: seconds for connecting.
    Raises OSError if nothing answers, and ServerError if the server refuses.
    """
    from .connection import tls_context

    if "@" in address:  # the message must not repeat a password
        raise ValueError("the address has a user or password, which are never sent; pass token= instead")
    by_http = address.startswith(("http://", "https://"))
    context = tls_context(ca) if tls or ca or address.startswith("https://") else None
    if by_http:
        from .web import WebWorld

        return WebWorld(address, token, context, timeout)
    from .world import World

    servers = []
    for each in address.split(","):
        host, separator, port = each.rpartition(":")
        if not separator or not host or not port.isdigit() or int(port) > 65535:
            raise ValueError(f"address {each!r} is not HOST:PORT, such as 127.0.0.1:4780 or [::1]:4780")
        servers.append((host.strip("[]"), int(port)))
    return World(servers, token, context, timeout)
