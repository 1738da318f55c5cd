"""dig.py PORT: the calls that fly.py does not make, as lines that every language prints (dig.lua, Dig.cs)."""

import ctypes
import sys

import talus_ctypes as c

talus = c.load()
client, request = ctypes.c_void_p(), ctypes.c_uint32()
event, world, material = c.talus_event(), c.talus_world(), c.talus_material()


def check(status):
    if status < 0:
        sys.exit(talus.talus_last_error(client).decode())


def wait(type_, asked):
    while (event.type, event.request) != (type_, asked):
        check(talus.talus_poll(client, event, 60000))
        if event.type == c.TALUS_EVENT_CLOSED:
            sys.exit(event.message.decode())


def edit(**fields):
    check(talus.talus_send_edit(client, c.talus_edit(**fields), request))
    wait(c.TALUS_EVENT_EDITED, request.value)
    print(f"edited: {event.status} {event.changed_voxels}")


def get_chunk(known=None):
    check(talus.talus_get_chunk(client, *(at >> 5 for at in spawn), 0, known, request))


check(talus.talus_create(client))
check(talus.talus_connect(client, c.talus_connect_options(host=b"127.0.0.1", port=int(sys.argv[1]))))
wait(c.TALUS_EVENT_JOINED, 0)
check(talus.talus_get_world(client, world))
while material.phase != c.TALUS_SOLID:
    check(talus.talus_get_material(client, material.id + 1, material))
spawn = (ctypes.c_int64 * 3)(world.spawn_x, world.spawn_y, world.spawn_z)

solid, air = ctypes.c_uint16(material.id), ctypes.c_uint16(0)
build = dict(guard_voxels=spawn, guard_materials=ctypes.pointer(air), guard_count=1,
             write_voxels=spawn, write_materials=ctypes.pointer(solid), write_count=1)
edit(**build)
edit(**build)

get_chunk()
wait(c.TALUS_EVENT_CHUNK_ANSWER, request.value)
voxels = (ctypes.c_uint16 * c.TALUS_CHUNK_VOLUME)()
check(talus.talus_decode(event.chunk, voxels, len(voxels)))
print(f"built: {voxels[c.TALUS_VOXEL_INDEX(*(at & 31 for at in spawn))]} of {material.name.decode()} {material.id}")
get_chunk((ctypes.c_uint64 * 2)(event.hash_low, event.hash_high))
wait(c.TALUS_EVENT_CHUNK_ANSWER, request.value)
print(f"known: {event.status} {event.chunk is None}")
get_chunk()
check(talus.talus_cancel(client, request.value))
wait(c.TALUS_EVENT_CHUNK_ANSWER, request.value)
print(f"cancelled: {event.status in (c.TALUS_OK, c.TALUS_CANCELLED)}")

columns, fields = (ctypes.c_int64 * 2)(spawn[0], spawn[2]), (ctypes.c_char_p * 1)(talus.talus_field_name(client, 0))
check(talus.talus_get_places(client, columns, 1, fields, 1, request))
wait(c.TALUS_EVENT_HEIGHTS, request.value)
print(f"place: {event.heights_fx[0]} {talus.talus_look_name(client, event.looks[0]).decode()} {fields[0].decode()} {int(event.values[0] * 100)}")

corners, generated = (ctypes.c_int64 * 6)(*spawn, *spawn), ctypes.c_int32(c.TALUS_AS_GENERATED)
edit(fill_corners=corners, fill_materials=ctypes.pointer(generated), fill_count=1)

view, chunks = c.talus_view(horizontal_radius=8, vertical_radius=4), ctypes.c_uint64()
check(talus.talus_fill_rings(view, 256))
check(talus.talus_count_view(client, view, chunks))
print("rings:", *view.ring_radius, chunks.value)
talus.talus_destroy(client)
