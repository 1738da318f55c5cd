"""Common calls of World and WebWorld, based on their own requests."""

import dataclasses
import operator

import numpy as np

from .errors import ServerError
from .protocol import ErrorCode


@dataclasses.dataclass(frozen=True)
class Places:
    """Data of columns of base voxels, in the order of the request."""

    heights: np.ndarray  # float64, of the ground, in base voxels above y = 0
    looks: list  # if requested, the name of each column's look; "" without a look
    fields: dict  # if requested, float32 values by the field's name

    @classmethod
    def joined(cls, parts, fields):
        return cls(
            np.concatenate([part.heights for part in parts]) if parts else np.empty(0),
            [look for part in parts for look in part.looks],
            {name: np.concatenate([part.fields[name] for part in parts]) if parts else np.empty(0, np.float32)
             for name in fields},
        )


def _whole(value, column):
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"column {column}: {value!r} is not an int; math.floor() gives the base voxel that it lies in") from None


class Queries:
    """Mix-in for a class with get_chunks(keys), get_places(columns, looks, fields) and heights_per_request."""

    def chunk(self, x, y, z, lod=0):
        """One Chunk."""
        return next(self.chunks([(x, y, z, lod)]))

    def chunks(self, keys):
        """Yields a Chunk for each (x, y, z) or (x, y, z, lod), in their order."""
        return self.get_chunks(tuple(key) if len(key) == 4 else (*key, 0) for key in keys)

    def heights(self, columns):
        """Height of the ground at each (x, z), in base voxels above y = 0, as float64: exact multiples of 1/256.

        Columns are columns of base voxels, so x and z are integers, of Python or numpy.
        A voxel is solid if its centre is below the height, so the first free row is (256 * height + 127) // 256.
        """
        return self.places(columns, looks=False).heights

    def places(self, columns, looks=True, fields=()):
        """Places: heights, names of looks, and values of `fields`, names of the world's fields, at each (x, z)."""
        columns = [(_whole(x, (x, z)), _whole(z, (x, z))) for x, z in columns]
        most = max(1, self.heights_per_request)
        groups = [columns[i : i + most] for i in range(0, len(columns), most)][::-1]
        parts = []
        while groups:
            group = groups.pop()
            try:
                parts.append(self.get_places(group, looks, tuple(fields)))
            except ServerError as error:
                if error.code != ErrorCode.too_large or len(group) < 2:
                    raise
                # Distant columns cost more than their number suggests.
                groups += [group[len(group) // 2 :], group[: len(group) // 2]]
        return Places.joined(parts, fields)
