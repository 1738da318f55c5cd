-- dig.lua CDEF PORT: as dig.py.
local ffi = require("ffi")
ffi.cdef(assert(io.open(arg[1])):read("*a"))
local talus = ffi.load("libtalus.so.1")
local client

local function fail(message)
  io.stderr:write(ffi.string(message), "\n")
  os.exit(1)
end

local function check(status)
  if status < 0 then fail(talus.talus_last_error(client)) end
end

local function sized(name, fields)
  local struct = ffi.new(name, fields or {})
  struct.size = ffi.sizeof(name)
  return struct
end

local slot, request = ffi.new("talus_client*[1]"), ffi.new("uint32_t[1]")
local event, world, material = sized("talus_event"), sized("talus_world"), sized("talus_material")

local function wait(type, asked)
  while event.type ~= type or event.request ~= asked do
    check(talus.talus_poll(client, event, 60000))
    if event.type == talus.TALUS_EVENT_CLOSED then fail(event.message) end
  end
end

local function edit(fields)
  check(talus.talus_send_edit(client, sized("talus_edit", fields), request))
  wait(talus.TALUS_EVENT_EDITED, request[0])
  print(("edited: %d %d"):format(event.status, event.changed_voxels))
end

check(talus.talus_create(slot))
client = ffi.gc(slot[0], talus.talus_destroy)
local host = "127.0.0.1"
check(talus.talus_connect(client, sized("talus_connect_options", { host = host, port = tonumber(arg[2]) })))
wait(talus.TALUS_EVENT_JOINED, 0)
check(talus.talus_get_world(client, world))
while material.phase ~= talus.TALUS_SOLID do
  check(talus.talus_get_material(client, material.id + 1, material))
end
local x, y, z = tonumber(world.spawn_x), tonumber(world.spawn_y), tonumber(world.spawn_z)
local spawn = ffi.new("int64_t[3]", x, y, z)

local function get_chunk(known)
  check(talus.talus_get_chunk(client, math.floor(x / 32), math.floor(y / 32), math.floor(z / 32), 0, known, request))
end

local solid, air = ffi.new("uint16_t[1]", material.id), ffi.new("uint16_t[1]", 0)
local build = {
  guard_voxels = spawn, guard_materials = air, guard_count = 1,
  write_voxels = spawn, write_materials = solid, write_count = 1,
}
edit(build)
edit(build)

get_chunk(nil)
wait(talus.TALUS_EVENT_CHUNK_ANSWER, request[0])
local voxels = ffi.new("uint16_t[?]", talus.TALUS_CHUNK_VOLUME)
check(talus.talus_decode(event.chunk, voxels, talus.TALUS_CHUNK_VOLUME))
local index = (y % 32 * 32 + z % 32) * 32 + x % 32 -- TALUS_VOXEL_INDEX
print(("built: %d of %s %d"):format(voxels[index], ffi.string(material.name), material.id))
get_chunk(ffi.new("uint64_t[2]", event.hash_low, event.hash_high))
wait(talus.TALUS_EVENT_CHUNK_ANSWER, request[0])
print(("known: %d %s"):format(event.status, event.chunk == nil and "True" or "False"))
get_chunk(nil)
check(talus.talus_cancel(client, request[0]))
wait(talus.TALUS_EVENT_CHUNK_ANSWER, request[0])
local cancelled = event.status == talus.TALUS_OK or event.status == talus.TALUS_CANCELLED
print("cancelled: " .. (cancelled and "True" or "False"))

local field = talus.talus_field_name(client, 0)
check(talus.talus_get_places(client, ffi.new("int64_t[2]", x, z), 1, ffi.new("const char*[1]", field), 1, request))
wait(talus.TALUS_EVENT_HEIGHTS, request[0])
local look = ffi.string(talus.talus_look_name(client, event.looks[0]))
print(("place: %d %s %s %d"):format(event.heights_fx[0], look, ffi.string(field), event.values[0] * 100))

local corners = ffi.new("int64_t[6]", x, y, z, x, y, z)
local generated = ffi.new("int32_t[1]", talus.TALUS_AS_GENERATED)
edit({ fill_corners = corners, fill_materials = generated, fill_count = 1 })

local view, chunks = sized("talus_view", { horizontal_radius = 8, vertical_radius = 4 }), ffi.new("uint64_t[1]")
check(talus.talus_fill_rings(view, 256))
check(talus.talus_count_view(client, view, chunks))
io.write("rings:")
for level = 0, 5 do io.write(" ", view.ring_radius[level]) end
print(" " .. tonumber(chunks[0]))
