// A plugin of qemu: prints how many instructions a program executed from its first in talus_counted_work() to its last there.
#include <inttypes.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

// Of qemu-plugin.h, which Debian does not ship.
struct qemu_plugin_tb;
struct qemu_plugin_insn;
void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id, void (*callback)(uint64_t id, struct qemu_plugin_tb* block));
void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb* block, int add, void* counter, uint64_t number);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn* instruction,
                                            void (*callback)(unsigned cpu, void* data), int registers, void* data);
void qemu_plugin_register_atexit_cb(uint64_t id, void (*callback)(uint64_t id, void* data), void* data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb* block);
struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb* block, size_t index);
const char* qemu_plugin_insn_symbol(const struct qemu_plugin_insn* instruction);

int qemu_plugin_version = 1;

static uint64_t executed, first, last;

static void see(unsigned cpu, void* data) {
  (void)cpu, (void)data;
  if (first == 0) first = executed;
  last = executed;
}

static void translate(uint64_t id, struct qemu_plugin_tb* block) {
  (void)id;
  const size_t count = qemu_plugin_tb_n_insns(block);
  qemu_plugin_register_vcpu_tb_exec_inline(block, 0, &executed, count);
  const char* symbol = qemu_plugin_insn_symbol(qemu_plugin_tb_get_insn(block, 0));
  if (symbol && strcmp(symbol, "talus_counted_work") == 0)
    qemu_plugin_register_vcpu_insn_exec_cb(qemu_plugin_tb_get_insn(block, 0), see, 0, NULL);
}

static void print(uint64_t id, void* data) {
  (void)id, (void)data;
  fprintf(stderr, "Collected : %" PRIu64 "\n", last - first);
}

int qemu_plugin_install(uint64_t id, const void* info, int argc, char** argv) {
  (void)info, (void)argc, (void)argv;
  qemu_plugin_register_vcpu_tb_trans_cb(id, translate);
  qemu_plugin_register_atexit_cb(id, print, NULL);
  return 0;
}
