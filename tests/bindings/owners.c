/* libtalus.so for Owners.cs: the real one behind it; how many clients and chunks are still owned, which falls
 * below 0 if something is freed twice; a gate that holds a call of another thread; and events that repeat. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>

#include <talus.h>

static atomic_int clients, chunks;

int owned_clients(void) {
  return clients;
}
int owned_chunks(void) {
  return chunks;
}

/* ---- The gate: between a call's work and its return ---- */

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static enum { OPEN, CLOSED, HOLDS_CALL } gate;
static int held_type;

static void set_gate(int to) {
  pthread_mutex_lock(&mutex);
  gate = to;
  pthread_cond_broadcast(&changed);
  pthread_mutex_unlock(&mutex);
}

/* Holds the next talus_poll() or talus_decode(), until gate_open(). */
void gate_close(void) {
  set_gate(CLOSED);
}
void gate_open(void) {
  set_gate(OPEN);
}

/* Waits for a call at the gate: its event's type; 0: it has no event; -1: no call came within a minute. */
int gate_await(void) {
  struct timespec end;
  clock_gettime(CLOCK_REALTIME, &end);
  end.tv_sec += 60;
  pthread_mutex_lock(&mutex);
  while (gate == CLOSED && pthread_cond_timedwait(&changed, &mutex, &end) == 0) {
  }
  const int type = gate == HOLDS_CALL ? held_type : -1;
  pthread_mutex_unlock(&mutex);
  return type;
}

static void pass_gate(int type) {
  pthread_mutex_lock(&mutex);
  if (gate == CLOSED) {
    gate = HOLDS_CALL;
    held_type = type;
    pthread_cond_broadcast(&changed);
    while (gate == HOLDS_CALL) pthread_cond_wait(&changed, &mutex);
  }
  pthread_mutex_unlock(&mutex);
}

/* ---- libtalus's functions ---- */

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

static atomic_int repeats;
static talus_client* _Atomic last;

/* The client of the last event gets it again by its next calls of talus_poll(). */
void repeat_event(int times) {
  repeats = times;
}

talus_status talus_poll(talus_client* client, talus_event* event, int32_t timeout_ms) {
  if (client == last && repeats > 0) {
    --repeats;
    return TALUS_OK;
  }
  const talus_status status = REAL(talus_poll)(client, event, timeout_ms);
  if (status == TALUS_OK) last = client;
  pass_gate(status == TALUS_OK ? (int)event->type : 0);
  return status;
}

talus_status talus_decode(const talus_chunk* chunk, uint16_t* voxels, size_t count) {
  const talus_status status = REAL(talus_decode)(chunk, voxels, count);
  pass_gate(0);
  return status;
}

void talus_chunk_retain(const talus_chunk* chunk) {
  if (!by_libtalus(__builtin_return_address(0))) ++chunks;
  REAL(talus_chunk_retain)(chunk);
}

void talus_chunk_release(const talus_chunk* chunk) {
  if (!by_libtalus(__builtin_return_address(0))) --chunks;
  REAL(talus_chunk_release)(chunk);
}
