"""Worlds in this process, without a server: libtalus-local by ctypes.

    from talus.local import World

    with World.open("world.toml") as world:               # or a save; World.open() is the built-in world
        voxels = world.generate(0, 3, 0)                  # uint16[y][z][x], edits included
        world.edit(writes=[((0, 100, 0), "granite")])
        world.save("game.talus")

Any thread may use a world; calls release the GIL. TALUS_LOCAL_LIBRARY names the library, else it is beside this file, or
the system's libtalus-local.so.1.
"""

import collections
import contextlib
import ctypes
import os
import threading

import numpy as np

from .edits import Fill

_CONFLICT, _SETTLES, _WITHOUT_EDITS, _READ_ONLY, _AS_GENERATED, _ANY = -29, 1, 1, 1, -1, -1
_PHASES = ("gas", "liquid", "solid")

Material = collections.namedtuple("Material", "id name colour phase")
Edited = collections.namedtuple("Edited", "revision changed chunks")
Edited.__doc__ = "The revision after an edit, how many voxels it changed, and the chunks that changed: (x, y, z, lod)."


class LocalError(Exception):
    """The library refused; `status` is a talus_status of talus_local.h."""

    def __init__(self, status, text):
        super().__init__(text)
        self.status = status


class Conflict(LocalError):
    """A guard does not hold, the one at `index`; nothing was changed."""

    def __init__(self, text, index):
        super().__init__(_CONFLICT, text)
        self.index = index


class _Sized(ctypes.Structure):
    def __init__(self, **fields):
        super().__init__(size=ctypes.sizeof(type(self)), **fields)


_u32, _i64, _u64, _pointer = ctypes.c_uint32, ctypes.c_int64, ctypes.c_uint64, ctypes.c_void_p
_size, _text = ctypes.c_size_t, ctypes.c_char_p


class _Key(ctypes.Structure):
    _fields_ = [("x", ctypes.c_int32), ("y", ctypes.c_int32), ("z", ctypes.c_int32), ("level", _u32)]


class _Options(_Sized):
    _fields_ = [("size", _u32), ("flags", _u32), ("toml", _text), ("toml_bytes", _u64), ("folder", _text),
                ("read_file", _pointer), ("user", _pointer)]


class _Info(_Sized):
    _fields_ = [("size", _u32), ("flags", _u32), ("fingerprint_low", _u64), ("fingerprint_high", _u64),
                ("min_y", _i64), ("max_y", _i64), ("spawn_x", _i64), ("spawn_y", _i64), ("spawn_z", _i64),
                ("revision", _u64), ("hash_low", _u64), ("hash_high", _u64), ("material_count", _u32),
                ("generator_version", _u32)]


class _Material(_Sized):
    _fields_ = [("size", _u32), ("id", _u32), ("colour", _u32), ("phase", _u32), ("name", _text)]


class _Edit(_Sized):
    _fields_ = [("size", _u32), ("flags", _u32), ("guard_voxels", _pointer), ("guard_materials", _pointer),
                ("write_voxels", _pointer), ("write_materials", _pointer), ("fill_corners", _pointer),
                ("fill_materials", _pointer), ("fill_only", _pointer), ("paste_voxels", _pointer), ("paste_x", _i64),
                ("paste_y", _i64), ("paste_z", _i64), ("subject", _text), ("guard_count", _u32),
                ("write_count", _u32), ("fill_count", _u32), ("reserved", _u32)]


class _EditResult(_Sized):
    _fields_ = [("size", _u32), ("conflict", ctypes.c_int32), ("changed_voxels", _u32), ("chunk_count", _u32),
                ("chunks", ctypes.POINTER(_Key)), ("revision", _u64)]


def _load():
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "libtalus-local.so")
    file = os.environ.get("TALUS_LOCAL_LIBRARY") or (beside if os.path.exists(beside) else "libtalus-local.so.1")
    try:
        library = ctypes.CDLL(file)
    except OSError as error:
        raise OSError(f"{error}; install the package libtalus-local1, or let TALUS_LOCAL_LIBRARY name "
                      "libtalus-local.so.1") from None
    for name, *parameters in [
        ("talus_world_open", _pointer, _pointer),
        ("talus_save_open", _text, _u32, _pointer),
        ("talus_save_create", _pointer, _text),
        ("talus_save_commit", _pointer),
        ("talus_world_get_info", _pointer, _pointer),
        ("talus_world_get_material", _pointer, _u32, _pointer),
        ("talus_workspace_create", _pointer, _u64, _pointer),
        ("talus_generate", _pointer, _pointer, _size, _u32, _pointer, _pointer),
        ("talus_heights", _pointer, _i64, _i64, _u32, _u32, _u32, _pointer, _size),
        ("talus_apply_edit", _pointer, _pointer, _pointer),
        ("talus_get_changed_chunks", _pointer, _pointer, _size, _pointer),
    ]:
        getattr(library, name).argtypes = parameters
    for name in ("talus_world_close", "talus_workspace_destroy"):
        getattr(library, name).argtypes, getattr(library, name).restype = [_pointer], None
    library.talus_local_error.restype = _text
    return library


_library = None


def _lib():
    global _library
    _library = _library or _load()
    return _library


def _check(status):
    if status < 0:
        raise LocalError(status, _lib().talus_local_error().decode())


class _Workspace:
    """A thread's memory."""

    def __init__(self, world):
        self.pointer = _pointer()
        self.destroy = _lib().talus_workspace_destroy
        _check(_lib().talus_workspace_create(world, 0, ctypes.byref(self.pointer)))

    def __del__(self):
        self.destroy(self.pointer)


class World:
    """A world with the edits made in it. Get one by open()."""

    def __init__(self, pointer):
        self._pointer = pointer
        self._calls, self._is_closed, self._lock = 0, False, threading.RLock()
        self._of_thread = threading.local()
        info = self._info()
        self.fingerprint = f"{info.fingerprint_high:016x}{info.fingerprint_low:016x}"
        self.rows = (info.min_y, info.max_y)
        self.spawn = (info.spawn_x, info.spawn_y, info.spawn_z)
        materials = (self._material(index) for index in range(info.material_count))
        self.materials = {material.id: material for material in materials}
        self._ids = {material.name: material.id for material in self.materials.values()}

    @classmethod
    def open(cls, path=None, *, settles=False, read_only=False):
        """Opens a world's file, NAME.toml, or a save, any other name; None: the built-in world.

        `settles`: loose material slides after edits; a save keeps what it was made with. `read_only`: of a save.
        """
        pointer = _pointer()
        options = _Options(flags=_SETTLES * settles)
        if path is not None and not os.fspath(path).endswith(".toml"):
            _check(_lib().talus_save_open(os.fsencode(path), _READ_ONLY * read_only, ctypes.byref(pointer)))
            return cls(pointer)
        if path is not None:
            with open(path, "rb") as file:
                toml = file.read()
            options.toml, options.toml_bytes = toml, len(toml)
            options.folder = os.fsencode(os.path.dirname(os.path.abspath(path)))
        _check(_lib().talus_world_open(ctypes.byref(options), ctypes.byref(pointer)))
        return cls(pointer)

    def generate(self, x, y, z, lod=0, *, edits=True):
        """Voxels of a chunk, uint16[y][z][x]. Coordinates count chunks of the level."""
        return self.generate_all([(x, y, z, lod)], edits=edits)[0]

    def generate_all(self, keys, *, edits=True):
        """Voxels of chunks (x, y, z) or (x, y, z, lod), uint16[chunk][y][z][x]. Neighbours share work."""
        keys = [_Key(*(tuple(key) + (0,))[:4]) for key in keys]
        voxels = np.empty((len(keys), 32, 32, 32), np.uint16)
        with self._workspace() as workspace:
            _check(_lib().talus_generate(workspace, (_Key * len(keys))(*keys), len(keys),
                                         _WITHOUT_EDITS * (not edits), voxels.ctypes.data, None))
        return voxels

    def heights(self, x, z, width, depth, lod=0):
        """Ground as generated of width * depth columns from (x, z) on, float64[z][x], in voxels of the level."""
        heights = np.empty((depth, width), np.int32)
        with self._open() as world:
            _check(_lib().talus_heights(world, x, z, width, depth, lod, heights.ctypes.data, heights.size))
        return heights / 256

    def edit(self, writes=(), *, guards=(), fills=()):
        """Changes voxels, all or none: ((x, y, z), material), with an id or a name; `fills` as talus.Fill.

        Raises Conflict if a guard does not hold. Lost when the world closes, unless save() keeps it.
        """
        fills = [Fill(*fill) for fill in fills]
        corners = [[pick(pair) for pair in zip(fill.first, fill.last)] for fill in fills for pick in (min, max)]
        lists = []  # alive until the call returns

        def numbers(values, kind):
            lists.append(np.ascontiguousarray(values, kind))
            return lists[-1].ctypes.data

        def voxels(pairs):
            return numbers([voxel for voxel, _ in pairs], np.int64), numbers([self._id(name) for _, name in pairs],
                                                                             np.uint16)

        writes, guards = list(writes), list(guards)
        edit = _Edit(guard_count=len(guards), write_count=len(writes), fill_count=len(fills))
        edit.guard_voxels, edit.guard_materials = voxels(guards)
        edit.write_voxels, edit.write_materials = voxels(writes)
        edit.fill_corners = numbers(corners, np.int64)
        for field, missing in (("material", _AS_GENERATED), ("only", _ANY)):
            given = [getattr(fill, field) for fill in fills]
            ids = numbers([missing if name is None else self._id(name) for name in given], np.int32)
            setattr(edit, "fill_materials" if field == "material" else "fill_only", ids)
        result = _EditResult()
        with self._workspace() as workspace:
            status = _lib().talus_apply_edit(workspace, ctypes.byref(edit), ctypes.byref(result))
            if status == _CONFLICT:
                raise Conflict(_lib().talus_local_error().decode(), result.conflict)
            _check(status)
            chunks = [(key.x, key.y, key.z, key.level) for key in result.chunks[: result.chunk_count]]
        return Edited(result.revision, result.changed_voxels, chunks)

    def save(self, path=None):
        """Keeps all edits: in a new file from now on, or in the world's save. They are on the disk when it returns."""
        with self._open() as world:
            if path is not None:
                _check(_lib().talus_save_create(world, os.fsencode(path)))
            else:
                _check(_lib().talus_save_commit(world))

    @property
    def revision(self):
        """Raised by each edit that changes something."""
        return self._info().revision

    @property
    def hash(self):
        """Of all edits: equal if all edited voxels are."""
        info = self._info()
        return f"{info.hash_high:016x}{info.hash_low:016x}"

    def changed_chunks(self):
        """The chunks (x, y, z) of level 0 that differ from the generated ones."""
        count, room = _size(), 0
        while True:
            keys = (_Key * room)()
            with self._open() as world:
                _check(_lib().talus_get_changed_chunks(world, keys, room, ctypes.byref(count)))
            if count.value <= room:
                return [(key.x, key.y, key.z) for key in keys[: count.value]]
            room = count.value

    def close(self):
        """Closes the world and its save, after calls that run in other threads. Edits not saved are lost."""
        with self._lock:
            self._is_closed = True
            self._free_if_unused()

    __del__ = close

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _free_if_unused(self):
        if self._is_closed and self._calls == 0 and self._pointer:
            self._of_thread = None  # destroys the workspaces of all threads
            _lib().talus_world_close(self._pointer)
            self._pointer = None

    @contextlib.contextmanager
    def _open(self):
        with self._lock:
            if self._is_closed:
                raise ValueError("the world is closed")
            self._calls += 1
        try:
            yield self._pointer
        finally:
            with self._lock:
                self._calls -= 1
                self._free_if_unused()

    @contextlib.contextmanager
    def _workspace(self):
        with self._open() as world:
            if not hasattr(self._of_thread, "workspace"):
                self._of_thread.workspace = _Workspace(world)
            yield self._of_thread.workspace.pointer

    def _info(self):
        info = _Info()
        with self._open() as world:
            _check(_lib().talus_world_get_info(world, ctypes.byref(info)))
        return info

    def _material(self, index):
        material = _Material()
        with self._open() as world:
            _check(_lib().talus_world_get_material(world, index, ctypes.byref(material)))
        return Material(material.id, material.name.decode(), material.colour, _PHASES[material.phase])

    def _id(self, material):
        if not isinstance(material, str):
            return material
        if material not in self._ids:
            raise ValueError(f"this world has no material {material!r}; it has {', '.join(self._ids)}")
        return self._ids[material]
