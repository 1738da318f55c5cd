"""A world over HTTP (PROTOCOL.md, HTTP): the same calls as World, through any cache, without a session.

Each call asks which columns of chunks were edited, in regions of 32 x 32: edited columns are fetched by revision, all
others as generated, which every cache keeps for ever.
"""

import http.client
import json
import math
import struct
import time
import urllib.error
import urllib.parse
import urllib.request

import numpy as np

from .chunk import Chunk
from .errors import ServerError, again_later
from .pace import LONGEST_WAIT_S
from .protocol import ErrorCode, Material, Phase, ProtocolError
from .queries import Places, Queries
from .view_shape import CHUNK_SIZE, level_boxes, world_heights

_MAX_BYTES = 4 << 20
_SQUARE = 4
_REGION = 32  # columns along each side
_TRIES = 5


class _NoRedirects(urllib.request.HTTPRedirectHandler):
    """talusd's redirects are followed explicitly; others could leak the token."""

    def redirect_request(self, *_):
        return None


class WebWorld(Queries):
    """Created by talus.connect("http://...")."""

    heights_per_request = 64  # fits the request line at any coordinates

    def __init__(self, address, token="", context=None, timeout=10):
        self._root = address.rstrip("/")
        self._headers = {"User-Agent": "talus for Python", **({"Authorization": f"Bearer {token}"} if token else {})}
        self._timeout = timeout
        handlers = [_NoRedirects()] + ([urllib.request.HTTPSHandler(context=context)] if context else [])
        self._opener = urllib.request.build_opener(*handlers)
        self.info = self._get_json("/v1/world")  # Welcome as JSON
        self._heights = world_heights(int(self.info["min_y"]), int(self.info["max_y"]))
        self._world = f"/v1/{self.info['fingerprint']}"
        self._store = self.info.get("store_id", "").strip("0") and self.info["store_id"]  # empty: no store

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._opener.close()

    @property
    def materials(self):
        """Materials by id, with id, name, colour (0xRRGGBB) and phase."""
        return {
            m["id"]: Material(id=m["id"], name=m["name"], colour=int(m["colour"][1:], 16), phase=Phase[m["phase"]])
            for m in self.info["materials"]
        }

    @property
    def spawn(self):
        """Base voxel (x, y, z) for a player's feet."""
        return tuple(self.info["spawn"])

    def get_chunks(self, keys):
        edited = _EditedColumns(self)
        for x, y, z, lod in keys:
            payload, revision = self._get_chunks(f"{lod}/{x}/{y}/{z}", edited.revision(x, z, lod))
            yield Chunk((x, y, z, lod), payload, revision=revision)

    def column(self, x, z, lod=0):
        """A Column: all chunks at (x, z), from the lowest of the world to the highest."""
        body, revision = self._get_chunks(f"{lod}/{x}/{z}", _EditedColumns(self).revision(x, z, lod))
        return Column(x, z, lod, body, revision)

    def square(self, x, z, n, lod=0):
        """n x n Columns, from west to east, then from north to south. n is 1, 2 or 4; x and z are multiples of it."""
        return self._square(x, z, n, lod, _EditedColumns(self))

    def _square(self, x, z, n, lod, edited):
        newest = max(edited.revision(x + place % n, z + place // n, lod) for place in range(n * n))
        body, newest = self._get_chunks(f"{lod}/{x}/{z}/{n}x{n}", newest)
        version, size, _ = _unpack("<BBH", body, 0)
        if (version, size) != (1, n):
            raise ProtocolError(f"a square of version {version} and size {size}; asked for were 1 and {n}")
        columns, at = [], 4
        for place in range(n * n):
            (length,) = _unpack("<I", body, at)
            column = body[at + 4 : at + 4 + length]
            if len(column) != length:
                raise ProtocolError("a square ends within a column")
            columns.append(Column(x + place % n, z + place // n, lod, column, newest))
            at += 4 + length
        if at != len(body):
            raise ProtocolError("a square has bytes after its last column")
        return columns

    def view(self, x, z, radius, *, y=None, vertical_radius=4, rings=(), horizon=False):
        """Yields every Chunk around base voxel (x, y, z), by squares of columns, nearest first."""
        if y is None:
            y = self.heights([(math.floor(x), math.floor(z))])[0]
        heights = self._heights if horizon else None
        edited = _EditedColumns(self)
        for box in level_boxes((math.floor(x), math.floor(y), math.floor(z)), radius, vertical_radius, rings, heights):
            squares = {(cx // _SQUARE, cz // _SQUARE) for cx in box.x for cz in box.z if box.has_column(cx, cz)}
            size = _SQUARE * CHUNK_SIZE << box.lod

            def distance(square):
                return ((square[0] + 0.5) * size - x) ** 2 + ((square[1] + 0.5) * size - z) ** 2

            for sx, sz in sorted(squares, key=distance):
                for column in self._square(sx * _SQUARE, sz * _SQUARE, _SQUARE, box.lod, edited):
                    if box.has_column(column.x, column.z):
                        for row in box.y:
                            yield column.chunk(row)

    def edit(self, *_, **__):
        """Not available over HTTP."""
        raise NotImplementedError(f"edits need a connection, and {self._root} is HTTP; connect to HOST:PORT of talusd's --listen")

    def get_places(self, columns, looks, fields):
        query = ["columns=" + ";".join(f"{x},{z}" for x, z in columns)]
        query += ["looks=1"] if looks else []
        query += ["fields=" + ",".join(urllib.parse.quote(name, safe="") for name in fields)] if fields else []
        found = self._get_json("/v1/heights?" + "&".join(query))
        try:
            places = Places(
                np.array(found["heights"], float) / found["subvoxels_per_voxel"],
                found.get("looks", []),
                {name: np.array(values, np.float32) for name, values in found.get("fields", {}).items()},
            )
            lists = [places.heights, *places.fields.values(), *([places.looks] if looks else [])]
            whole = all(len(each) == len(columns) for each in lists) and set(places.fields) == set(fields)
        except (KeyError, TypeError, ValueError, AttributeError, ZeroDivisionError):
            whole = False
        if not whole:
            raise ProtocolError("/v1/heights is not answered by a value for each column")
        return places

    def _get_chunks(self, name, revision):
        """Returns a body and its revision: `revision`, or a newer one after a redirect."""
        if revision == 0:
            return self._get(f"{self._world}/{self.info['codec']}/{name}"), 0
        path = f"{self._world}/{self._store}/{self.info['codec']}/{name}"
        for _ in range(_TRIES):
            body, revision = self._follow(f"{path}@{revision}", revision)
            if body is not None:
                return body, revision
        raise ServerError(ErrorCode.overloaded, f"{path} is edited faster than it is sent", 0)

    def _follow(self, path, revision):
        """Returns the body and its revision, or None and the newest revision."""
        try:
            body, said = self._get_with_revision(path)
            if said is not None and not _is_number(said):
                raise ProtocolError(f"{path} is answered by revision {said!r}")
            return body, revision if said is None else int(said)
        except _Moved as moved:
            there = urllib.parse.urljoin(path, moved.location)
            base, _, revision = there.rpartition("@")
            if there == path or base != path.rpartition("@")[0] or not _is_number(revision):
                raise ProtocolError(f"{path} leads to {moved.location!r}") from None
            return None, int(revision)

    def edited_columns(self, x, z, lod=0):
        """Revisions, by (x, z), of the edited columns of chunks in the region (x, z) of 32 x 32 columns."""
        if not self._store:
            return {}
        body = self._get(f"{self._world}/{self._store}/edits/{lod}/{x}/{z}")
        version, _, count = _unpack("<BBH", body, 0)
        if version != 1 or len(body) != 4 + 10 * count:
            raise ProtocolError(f"edited columns of version {version}, {count} in {len(body)} bytes")
        columns = {}
        for place, revision in struct.iter_unpack("<HQ", body[4:]):
            if place >= _REGION * _REGION:
                raise ProtocolError(f"an edited column {place} of {_REGION} x {_REGION}")
            columns[x * _REGION + place % _REGION, z * _REGION + place // _REGION] = revision
        return columns

    def _get_json(self, path):
        try:
            return json.loads(self._get(path))
        except (ValueError, RecursionError):
            raise ProtocolError(f"{path} is not answered by JSON") from None

    def _get(self, path):
        return self._get_with_revision(path)[0]

    def _get_with_revision(self, path):
        """Returns the body and Talus-Revision, which differs from the path's for land being edited; None if absent."""
        request = urllib.request.Request(self._root + path, headers=self._headers)
        for turn in range(_TRIES):
            try:
                with self._opener.open(request, timeout=self._timeout) as answer:
                    body = answer.read(_MAX_BYTES + 1)
                if len(body) > _MAX_BYTES:
                    raise ProtocolError(f"{path} is answered by over {_MAX_BYTES} bytes")
                return body, answer.headers.get("Talus-Revision")
            except http.client.HTTPException as error:
                raise ProtocolError(f"{path} is not answered by HTTP: {error!r}") from None
            except urllib.error.HTTPError as refusal:
                with refusal:
                    if refusal.code == 307:
                        raise _Moved(refusal.headers.get("Location", "")) from None
                    error = _error(path, refusal)
                if not again_later(error) or turn == _TRIES - 1:
                    raise error from None
                time.sleep(min(error.retry_after_ms / 1000, LONGEST_WAIT_S))
        raise AssertionError("not reached")


class _Moved(ServerError):
    def __init__(self, location):
        super().__init__(ErrorCode.internal, f"HTTP status 307 to {location!r}", 0)
        self.location = location


class _EditedColumns:
    """Requests each region once."""

    def __init__(self, world):
        self._world = world
        self._regions = {}

    def revision(self, x, z, lod):
        region = (x // _REGION, z // _REGION, lod)
        if region not in self._regions:
            self._regions[region] = self._world.edited_columns(*region)
        return self._regions[region].get((x, z), 0)


def _is_number(text):
    return text.isascii() and text.isdigit() and len(text) <= 20


def _error(path, refusal):
    """The ServerError of an answer with an error status."""
    path = path.partition("?")[0]
    try:
        said = json.loads(refusal.read(65536))["error"]
        return ServerError(ErrorCode[said["code"]], f"{path}: {said['text']}", int(said.get("retry_after_ms", 0)))
    except (ValueError, KeyError, TypeError):
        return ServerError(ErrorCode.internal, f"{path}: HTTP status {refusal.code}")


class Column:
    """All chunks of level `lod` at (x, z). `runs` are (first y, count, payload), from the bottom up.

    `revision` is the request's: the newest among its chunks, or its square's; 0: never edited.
    """

    def __init__(self, x, z, lod, body, revision=0):
        self.x, self.z, self.lod, self.revision = x, z, lod, revision
        version, _, count = _unpack("<BBH", body, 0)
        if version != 1:
            raise ProtocolError(f"a column of version {version}; this client knows 1")
        self.runs = []
        at = 4
        limit = 1 << 31 >> lod
        expected = -limit
        for _ in range(count):
            first, rows, length = _unpack("<iII", body, at)
            payload = body[at + 12 : at + 12 + length]
            if first != expected or rows == 0 or len(payload) != length:
                raise ProtocolError("a column with a gap, an empty run or one that is cut off")
            self.runs.append((first, rows, payload))
            expected = first + rows
            at += 12 + length
        if at != len(body) or expected != limit:
            raise ProtocolError("a column that does not end at the world's top")

    def chunk(self, y):
        for first, rows, payload in self.runs:
            if first <= y < first + rows:
                return Chunk((self.x, y, self.z, self.lod), payload, revision=self.revision)
        raise IndexError(f"the world has no chunk {y} of level {self.lod}")


def _unpack(form, body, at):
    try:
        return struct.unpack_from(form, body, at)
    except struct.error:
        raise ProtocolError("a column or square is cut off") from None
