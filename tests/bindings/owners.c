/* libtalus.so for Owners.cs: the real one behind it, and how many clients and chunks are still owned. They
 * fall below 0 if something is freed twice. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdatomic.h>
#include <string.h>

#include <talus.h>

static atomic_int clients, chunks;

int owned_clients(void) {
  return clients;
}
int owned_chunks(void) {
  return chunks;
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

/* The library releases the chunks of its events by the same function. */
static int by_libtalus(void* caller) {
  Dl_info info;
  return dladdr(caller, &info) != 0 && strstr(info.dli_fname, "/libtalus.so.") != NULL;
}

talus_status talus_create(talus_client** client) {
  const talus_status status = REAL(talus_create)(client);
  if (status == TALUS_OK) ++clients;
  return status;
}

void talus_destroy(talus_client* client) {
  if (client != NULL) --clients;
  REAL(talus_destroy)(client);
}

void talus_chunk_retain(const talus_chunk* chunk) {
  if (!by_libtalus(__builtin_return_address(0))) ++chunks;
  REAL(talus_chunk_retain)(chunk);
}

void talus_chunk_release(const talus_chunk* chunk) {
  if (!by_libtalus(__builtin_return_address(0))) --chunks;
  REAL(talus_chunk_release)(chunk);
}
