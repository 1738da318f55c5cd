"""What both ways to a world offer, made of what each of them asks for."""

import dataclasses
import operator

import numpy as np

from .errors import ServerError
from .protocol import ErrorCode


@dataclasses.dataclass(frozen=True)
class Places:
    """Columns of base voxels, in the order in which they were asked for."""

    heights: np.ndarray  # float64, of the ground, in base voxels above y = 0
    looks: list  # the name of each column's look, where asked for; "" for none
    fields: dict  # float32 values by the field's name, where asked for

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
    """Of a class with get_chunks(keys), get_places(columns, looks, fields) and heights_per_request."""

    def chunk(self, x, y, z, lod=0):
        """One Chunk."""
        return next(self.chunks([(x, y, z, lod)]))

    def chunks(self, keys):
        """Yields a Chunk for each (x, y, z) or (x, y, z, lod), in their order."""
        return self.get_chunks(tuple(key) if len(key) == 4 else (*key, 0) for key in keys)

    def heights(self, columns):
        """Height of the ground at each (x, z), in base voxels above y = 0, as float64: exact multiples of 1/256.

        A column is one of the base voxels, so x and z are whole numbers, of Python or numpy.
        A voxel row is solid where its centre is below the height, so the first free row is (256 * height + 127) // 256.
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
                # Columns far apart cost more than their number says.
                groups += [group[len(group) // 2 :], group[: len(group) // 2]]
        return Places.joined(parts, fields)
