/* Joins a server, asks for the chunks around the spawn, decodes them all and tells what came:
 *   fly [HOST [PORT [TOKEN]]] */
#include <stdio.h>
#include <stdlib.h>
#include <talus.h>

static uint16_t voxels[TALUS_CHUNK_VOLUME];

static int failed(talus_client* client) {
  fprintf(stderr, "%s\n", talus_last_error(client));
  talus_destroy(client);
  return 1;
}

int main(int count, char** arguments) {
  talus_client* client = NULL;
  talus_connect_options options = {.size = sizeof options};
  talus_event event = {.size = sizeof event};
  talus_world world = {.size = sizeof world};
  talus_view view = {.size = sizeof view, .horizontal_radius = 8, .vertical_radius = 4};
  unsigned long chunks = 0, uniform = 0, solid = 0;
  int complete = 0, heights = 0;

  if (talus_create(&client) != TALUS_OK) return failed(client);
  options.host = count > 1 ? arguments[1] : "localhost";
  options.port = count > 2 ? (uint32_t)strtoul(arguments[2], NULL, 10) : TALUS_DEFAULT_PORT;
  options.token = count > 3 ? arguments[3] : NULL;
  if (talus_connect(client, &options) != TALUS_OK) return failed(client);

  while (!complete || !heights) { /* a game polls each frame, with time-out 0, until TALUS_NO_EVENT */
    const talus_status status = talus_poll(client, &event, 10000);
    if (status < 0) return failed(client);
    if (status == TALUS_NO_EVENT) continue;
    switch (event.type) {
      case TALUS_EVENT_JOINED: { /* now the world is known */
        int64_t column[2];
        if (talus_get_world(client, &world) != TALUS_OK) return failed(client);
        view.centre_x = column[0] = world.spawn_x;
        view.centre_y = world.spawn_y;
        view.centre_z = column[1] = world.spawn_z;
        if (talus_set_view(client, &view) != TALUS_OK) return failed(client);
        if (talus_get_heights(client, column, 1, NULL) != TALUS_OK) return failed(client);
        break;
      }
      case TALUS_EVENT_CHUNK:
        ++chunks;
        if (event.uniform_material >= 0) {
          ++uniform; /* nothing to mesh inside */
        } else if (talus_decode(event.chunk, voxels, TALUS_CHUNK_VOLUME) == TALUS_OK) {
          for (int i = 0; i < TALUS_CHUNK_VOLUME; ++i) solid += voxels[i] > 1; /* 0 is air, 1 water */
        }
        break;
      case TALUS_EVENT_HEIGHTS:
        if (event.status == TALUS_OK) printf("ground at spawn: %.2f voxels\n", event.heights_fx[0] / 256.0);
        heights = 1;
        break;
      case TALUS_EVENT_VIEW_COMPLETE:
        complete = 1;
        break;
      case TALUS_EVENT_CLOSED:
        fprintf(stderr, "%s\n", event.message);
        talus_destroy(client);
        return 1;
    }
  }
  printf("%s: %lu chunks, %lu of one material; in the others %lu solid voxels\n", world.server, chunks,
         uniform, solid);
  talus_destroy(client);
  return 0;
}
