/* A game for one player, without a server: opens a world or goes on with a save, walks east along the ground,
 * digs where it stands, saves, opens the save again and tells what it finds there: single_player SAVE
 * [WORLD.toml] */
#include <stdio.h>
#include <stdlib.h>
#include <talus_local.h>

static uint16_t voxels[TALUS_CHUNK_VOLUME];

static int failed(void) {
  fprintf(stderr, "%s\n", talus_local_error());
  return 1;
}

static int32_t floor_div(int64_t value, int64_t by) {
  return (int32_t)(value / by - (value % by < 0 ? 1 : 0));
}

/* The material of a base voxel, edits included; -1 after an error. A game keeps chunks and looks there. */
static int voxel_at(talus_workspace* workspace, int64_t x, int64_t y, int64_t z) {
  const talus_chunk_key key = {floor_div(x, 32), floor_div(y, 32), floor_div(z, 32), 0};
  if (talus_generate(workspace, &key, 1, 0, voxels, NULL) != TALUS_OK) return -1;
  return voxels[TALUS_VOXEL_INDEX(x & 31, y & 31, z & 31)];
}

static const char* name_of(talus_local_world* world, int id) {
  talus_material material = {.size = sizeof material};
  for (uint32_t i = 0; talus_world_get_material(world, i, &material) == TALUS_OK; ++i) {
    if ((int)material.id == id) return material.name;
  }
  return "unknown";
}

/* Opens the save if there is one, else the world, and a save for it. */
static talus_local_world* open_game(const char* save, const char* world_file) {
  talus_world_options options = {.size = sizeof options, .folder = "."};
  talus_local_world* world = NULL;
  char* toml = NULL;
  const talus_status opened = talus_save_open(save, 0, &world);
  if (opened == TALUS_OK) return world;
  if (opened != TALUS_FILE_FAILED) return NULL; /* there is one that cannot be used */
  if (world_file != NULL) {
    FILE* file = fopen(world_file, "rb");
    if (file == NULL) {
      perror(world_file);
      exit(1);
    }
    toml = malloc(1 << 20);
    options.toml = toml;
    options.toml_bytes = toml == NULL ? 0 : fread(toml, 1, 1 << 20, file);
    fclose(file);
  }
  if (talus_world_open(&options, &world) == TALUS_OK && talus_save_create(world, save) != TALUS_OK) {
    talus_world_close(world);
    world = NULL;
  }
  free(toml);
  return world;
}

int main(int count, char** arguments) {
  talus_world_info info = {.size = sizeof info};
  talus_edit dig = {.size = sizeof dig, .fill_count = 1};
  talus_edit_result result = {.size = sizeof result};
  int32_t ground_fx[16], air = 0;
  int64_t hole[6], y;
  talus_workspace* workspace = NULL;
  talus_local_world* world;
  int material;

  if (count < 2) return fprintf(stderr, "usage: single_player SAVE [WORLD.toml]\n"), 2;
  world = open_game(arguments[1], count > 2 ? arguments[2] : NULL);
  if (world == NULL || talus_world_get_info(world, &info) != TALUS_OK) return failed();
  if (talus_workspace_create(world, 0, &workspace) != TALUS_OK) return failed();
  printf("world %016llx%016llx, revision %llu\n", (unsigned long long)info.fingerprint_high,
         (unsigned long long)info.fingerprint_low, (unsigned long long)info.revision);

  /* Walk: the ground of 16 columns. The last row of rock or soil is under the feet. */
  if (talus_heights(world, info.spawn_x, info.spawn_z, 16, 1, 0, ground_fx, 16) != TALUS_OK) return failed();
  y = ((ground_fx[15] + 127) >> 8) - 1;
  hole[0] = hole[3] = info.spawn_x + 15;
  hole[1] = y - 3;
  hole[4] = y;
  hole[2] = hole[5] = info.spawn_z;
  material = voxel_at(workspace, hole[0], y, hole[2]);
  printf("walked 15 voxels to %lld, %lld, %lld: %s under the feet\n", (long long)hole[0], (long long)y + 1,
         (long long)hole[2], name_of(world, material));

  /* Dig four voxels down. */
  dig.fill_corners = hole;
  dig.fill_materials = &air;
  if (talus_apply_edit(workspace, &dig, &result) != TALUS_OK) return failed();
  if (talus_save_commit(world) != TALUS_OK) return failed();
  printf("dug: %u voxels in %u chunks of all levels\n", result.changed_voxels, result.chunk_count);
  talus_workspace_destroy(workspace);
  talus_world_close(world);

  /* What the save holds. */
  if (talus_save_open(arguments[1], TALUS_READ_ONLY, &world) != TALUS_OK) return failed();
  if (talus_workspace_create(world, 0, &workspace) != TALUS_OK) return failed();
  material = voxel_at(workspace, hole[0], y, hole[2]);
  if (material < 0 || talus_world_get_info(world, &info) != TALUS_OK) return failed();
  printf("saved: %s there, revision %llu\n", name_of(world, material), (unsigned long long)info.revision);
  talus_workspace_destroy(workspace);
  talus_world_close(world);
  return 0;
}
