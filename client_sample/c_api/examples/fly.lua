-- fly.c by LuaJIT's FFI: luajit fly.lua [HOST [PORT [TOKEN]]]
local ffi = require("ffi")
local here = arg[0]:match("^.*[/\\]") or ""
ffi.cdef(assert(io.open(here .. "../bindings/talus.cdef.h")):read("*a"))

local function fail(message)
  io.stderr:write(message, "\n")
  os.exit(1)
end

local windows = ffi.os == "Windows"
local found, talus = pcall(ffi.load, here .. (windows and "talus.dll" or "libtalus.so"))
if not found then
  found, talus = pcall(ffi.load, windows and "talus.dll" or "libtalus.so.1")
end
if not found then
  fail("libtalus is not found: copy libtalus.so (Windows: talus.dll) beside this program, or set LD_LIBRARY_PATH (" .. talus .. ")")
end

local function last_error(client)
  return ffi.string(talus.talus_last_error(client))
end

local slot = ffi.new("talus_client*[1]")
if talus.talus_create(slot) ~= talus.TALUS_OK then fail(last_error(nil)) end
local client = ffi.gc(slot[0], talus.talus_destroy)

local function check(status)
  if status < 0 then fail(last_error(client)) end
  return status
end

-- A struct with its size; the other fields are 0.
local function sized(name)
  return ffi.new(name, { size = ffi.sizeof(name) })
end

local options, event, world, view =
  sized("talus_connect_options"), sized("talus_event"), sized("talus_world"), sized("talus_view")
local host, token = arg[1] or "localhost", arg[3] -- kept: options only point to them
options.host, options.token, options.port = host, token, tonumber(arg[2]) or talus.TALUS_DEFAULT_PORT
view.horizontal_radius, view.vertical_radius = 8, 4
local voxels = ffi.new("uint16_t[?]", talus.TALUS_CHUNK_VOLUME)
local chunks, uniform, solid, complete, heights = 0, 0, 0, false, false

check(talus.talus_connect(client, options))
while not complete or not heights do
  local type = check(talus.talus_poll(client, event, 10000)) == talus.TALUS_OK and event.type or 0
  if type == talus.TALUS_EVENT_JOINED then
    check(talus.talus_get_world(client, world))
    view.centre_x, view.centre_y, view.centre_z = world.spawn_x, world.spawn_y, world.spawn_z
    check(talus.talus_set_view(client, view))
    check(talus.talus_get_heights(client, ffi.new("int64_t[2]", world.spawn_x, world.spawn_z), 1, nil))
  elseif type == talus.TALUS_EVENT_CHUNK then
    chunks = chunks + 1
    if event.uniform_material >= 0 then
      uniform = uniform + 1 -- nothing to mesh inside
    else
      check(talus.talus_decode(event.chunk, voxels, talus.TALUS_CHUNK_VOLUME))
      for i = 0, talus.TALUS_CHUNK_VOLUME - 1 do
        if voxels[i] > 1 then solid = solid + 1 end -- 0 is air, 1 water
      end
    end
  elseif type == talus.TALUS_EVENT_HEIGHTS then
    if event.status == talus.TALUS_OK then
      print(("ground at spawn: %.2f voxels"):format(event.heights_fx[0] / 256))
    end
    heights = true
  elseif type == talus.TALUS_EVENT_VIEW_COMPLETE then
    complete = true
  elseif type == talus.TALUS_EVENT_CLOSED then
    fail(ffi.string(event.message))
  end
end
print(("%s: %d chunks, %d of one material; in the others %d solid voxels"):format(ffi.string(world.server), chunks,
  uniform, solid))
