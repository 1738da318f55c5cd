#!/usr/bin/env python3
"""fly.c by ctypes, without a compiler: fly.py [HOST [PORT [TOKEN]]]"""

import ctypes
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "bindings"))
import talus_ctypes as c

try:
    talus = c.load()
except OSError as error:
    sys.exit(f"libtalus is not found: copy libtalus.so (Windows: talus.dll) beside this program, or set LD_LIBRARY_PATH ({error})")
client = ctypes.c_void_p()


def check(status):
    if status < 0:
        sys.exit(talus.talus_last_error(client).decode())
    return status


def main(host="localhost", port=c.TALUS_DEFAULT_PORT, token=""):
    event, world = c.talus_event(), c.talus_world()
    view = c.talus_view(horizontal_radius=8, vertical_radius=4)
    voxels = (ctypes.c_uint16 * c.TALUS_CHUNK_VOLUME)()
    chunks = uniform = solid = 0
    missing = {c.TALUS_EVENT_VIEW_COMPLETE, c.TALUS_EVENT_HEIGHTS}

    check(talus.talus_create(client))
    check(talus.talus_connect(client, c.talus_connect_options(host=host.encode(), port=int(port), token=token.encode())))
    while missing:
        if check(talus.talus_poll(client, event, 10000)) == c.TALUS_NO_EVENT:
            continue
        if event.type == c.TALUS_EVENT_JOINED:
            check(talus.talus_get_world(client, world))
            view.centre_x, view.centre_y, view.centre_z = world.spawn_x, world.spawn_y, world.spawn_z
            check(talus.talus_set_view(client, view))
            check(talus.talus_get_heights(client, (ctypes.c_int64 * 2)(world.spawn_x, world.spawn_z), 1, None))
        elif event.type == c.TALUS_EVENT_CHUNK:
            chunks += 1
            if event.uniform_material >= 0:
                uniform += 1  # nothing to mesh inside
            elif check(talus.talus_decode(event.chunk, voxels, len(voxels))) == c.TALUS_OK:
                ids = voxels[:]
                solid += len(ids) - ids.count(0) - ids.count(1)  # air, water
        elif event.type == c.TALUS_EVENT_HEIGHTS and event.status == c.TALUS_OK:
            print(f"ground at spawn: {event.heights_fx[0] / 256:.2f} voxels")
        elif event.type == c.TALUS_EVENT_CLOSED:
            sys.exit(event.message.decode())
        missing.discard(event.type)
    server = world.server.decode()
    print(f"{server}: {chunks} chunks, {uniform} of one material; in the others {solid} solid voxels")
    talus.talus_destroy(client)


main(*sys.argv[1:])
