"""The chunks of a View (PROTOCOL.md, View), as one box of chunks for each level of detail."""

import dataclasses

from .protocol import ProtocolError

CHUNK_SIZE = 32
_EDGE = CHUNK_SIZE << 31
_MAX_WORLD_ROWS = 1 << 17
_EMPTY = range(0)


@dataclasses.dataclass(frozen=True)
class LevelBox:
    """Chunks x, y, z of level `lod`, without the columns in both `inner_x` and `inner_z`."""

    lod: int
    x: range
    y: range
    z: range
    inner_x: range = _EMPTY
    inner_z: range = _EMPTY

    def has_column(self, x, z):
        return x in self.x and z in self.z and not (x in self.inner_x and z in self.inner_z)

    def __contains__(self, key):
        x, y, z, lod = key
        return lod == self.lod and y in self.y and self.has_column(x, z)

    def __len__(self):
        inner = len(_overlap(self.x, self.inner_x)) * len(_overlap(self.z, self.inner_z))
        return (len(self.x) * len(self.z) - inner) * len(self.y)


def world_heights(min_y, max_y):
    """Returns (min_y, max_y) if a world may have them: a View with a horizon contains all rows in between."""
    if not (-_EDGE <= min_y <= max_y <= _EDGE and max_y - min_y <= _MAX_WORLD_ROWS):
        raise ProtocolError(f"heights from {min_y} to {max_y}; a world has at most {_MAX_WORLD_ROWS} rows")
    return min_y, max_y


def level_boxes(centre, horizontal_radius, vertical_radius, rings=(), heights=None, cut=True):
    """The box of level 0, then one for each ring, (lod, radius).

    `centre` is in base voxels, radii are in base chunks. `heights`, (min_y, max_y) of Welcome, if the View has a
    horizon. Without `cut`, chunks outside the world are included.
    """
    x, y, z = (coordinate // CHUNK_SIZE for coordinate in centre)
    boxes = [
        LevelBox(
            0, _touching(x, horizontal_radius, 0), _touching(y, vertical_radius, 0), _touching(z, horizontal_radius, 0)
        )
    ]
    for lod, radius in rings:
        finer = boxes[-1]
        rows = _touching(y, vertical_radius, lod) if heights is None else _rows_of_world(*heights, lod)
        box = LevelBox(lod, _touching(x, radius, lod), rows, _touching(z, radius, lod))
        if heights is None or finer.lod > 0:  # with a horizon, level 0 does not contain all rows of its columns
            inner_x, inner_z = (_wholly_inside(part, finer.lod, lod) for part in (finer.x, finer.z))
            box = dataclasses.replace(box, inner_x=inner_x, inner_z=inner_z)
        boxes.append(box)
    return [_cut(box) for box in boxes] if cut else boxes


def _touching(centre, radius, lod):
    return range(centre - radius >> lod, (centre + radius >> lod) + 1)


def _wholly_inside(finer, finer_lod, lod):
    """Chunks of `lod` entirely inside `finer`, a range of chunks of `finer_lod`."""
    begin, end = finer.start << finer_lod, finer.stop << finer_lod
    return range(-(-begin >> lod), end >> lod)


def _rows_of_world(min_y, max_y, lod):
    low, high = (min(max(y, -_EDGE), _EDGE) for y in (min_y, max_y))
    return range(((low >> lod) - 1) // CHUNK_SIZE, (high - 1 >> lod) // CHUNK_SIZE + 1)


def _overlap(a, b):
    return range(max(a.start, b.start), min(a.stop, b.stop))


def _cut(box):
    limit = 1 << 31 >> box.lod
    world = range(-limit, limit)
    names = ("x", "y", "z", "inner_x", "inner_z")
    return dataclasses.replace(box, **{name: _overlap(getattr(box, name), world) for name in names})
