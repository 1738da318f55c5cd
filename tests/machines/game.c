/* What a game does, as one line that must be the same on every machine: joins, takes a View in, digs a hole
 * of 4 x 4 x 4 voxels, and fills it:
 *   game HOST PORT CA_FILE|- X Y Z */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <talus.h>

static talus_client* client;
static talus_event event = {.size = sizeof event};
static uint16_t voxels[TALUS_CHUNK_VOLUME];

static void check(talus_status status) {
  if (status >= 0) return;
  fprintf(stderr, "%s\n", talus_last_error(client));
  exit(1);
}

static uint32_t next_event(void) {
  const talus_status status = talus_poll(client, &event, 60000);
  check(status);
  if (status == TALUS_OK && event.status >= 0) return event.type;
  fprintf(stderr, "%s\n", status == TALUS_NO_EVENT ? "no event for a minute" : event.message);
  exit(1);
}

/* FNV-1a of the event's chunk: its place and its voxels. */
static uint64_t hash_of_chunk(void) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  const int64_t place[4] = {event.x, event.y, event.z, event.level};
  check(talus_decode(event.chunk, voxels, TALUS_CHUNK_VOLUME));
  for (int i = 0; i < 4; ++i) hash = (hash ^ (uint64_t)place[i]) * UINT64_C(0x100000001b3);
  for (int i = 0; i < TALUS_CHUNK_VOLUME; ++i) hash = (hash ^ voxels[i]) * UINT64_C(0x100000001b3);
  return hash;
}

/* Fills the box, and prints the chunk that changes by it. */
static void fill(const int64_t box[6], int32_t material) {
  talus_edit edit = {.size = sizeof edit, .fill_count = 1, .fill_corners = box, .fill_materials = &material};
  uint64_t hash = 0;
  uint32_t changed = 0;
  int stored = 0;
  check(talus_send_edit(client, &edit, NULL));
  while (!stored || hash == 0) {
    const uint32_t type = next_event();
    if (type == TALUS_EVENT_CHUNK) hash = hash_of_chunk();
    if (type == TALUS_EVENT_EDITED) {
      stored = 1;
      changed = event.changed_voxels;
    }
  }
  printf("; %" PRIu32 " changed: %016" PRIx64, changed, hash);
}

int main(int count, char** arguments) {
  talus_connect_options options = {.size = sizeof options};
  talus_view view = {.size = sizeof view, .horizontal_radius = 4, .vertical_radius = 3};
  int64_t box[6];
  uint64_t hashes = 0; /* their sum, which does not depend on the order */
  unsigned chunks = 0;
  uint32_t type = 0;

  if (count != 7) return 2;
  options.host = arguments[1];
  options.port = (uint32_t)strtoul(arguments[2], NULL, 10);
  if (strcmp(arguments[3], "-") != 0) {
    options.flags = TALUS_TLS;
    options.tls_ca_file = arguments[3];
    options.tls_server_name = "localhost";
  }
  for (int axis = 0; axis < 3; ++axis) {
    box[axis] = strtoll(arguments[4 + axis], NULL, 10);
    box[3 + axis] = box[axis] + 3;
  }
  view.centre_x = box[0];
  view.centre_y = box[1];
  view.centre_z = box[2];

  check(talus_create(&client));
  check(talus_connect(client, &options));
  while (type != TALUS_EVENT_VIEW_COMPLETE) {
    type = next_event();
    if (type == TALUS_EVENT_JOINED) check(talus_set_view(client, &view));
    if (type == TALUS_EVENT_CHUNK) {
      hashes += hash_of_chunk();
      ++chunks;
    }
  }
  printf("%u chunks: %016" PRIx64, chunks, hashes);
  fill(box, 0);
  fill(box, TALUS_AS_GENERATED);
  printf("\n");
  talus_destroy(client);
  return 0;
}
