// SPDX-License-Identifier: MIT
// A plugin of QEMU's translator: exact counts of executed instructions between two addresses.
//
//     -plugin count.so,out=FILE,span=NAME:BEGIN:END[,span=…]
//
// A span is open from the instruction at BEGIN on, up to the one at END, which does not count. FILE
// gets a line for each: name, how often it was run, the sum, the most.
//
// No package brings qemu-plugin.h. The prototypes are those of the interface's version 1 (QEMU 4.2
// and later; docs/devel/tcg-plugins.rst in QEMU's sources).
#include <inttypes.h> // PRIu64
#include <stdint.h>   // uint64_t
#include <stdio.h>    // FILE
#include <stdlib.h>   // strtoull
#include <string.h>   // strncmp

typedef uint64_t plugin_id_t;
struct qemu_plugin_tb;
struct qemu_plugin_insn;

void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id_t id,
                                           void (*call)(plugin_id_t, struct qemu_plugin_tb *));
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn,
                                            void (*call)(unsigned, void *), int flags, void *user);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn *insn, int operation,
                                                void *word, uint64_t value);
void qemu_plugin_register_atexit_cb(plugin_id_t id, void (*call)(plugin_id_t, void *), void *user);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t k);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *insn);

extern int qemu_plugin_version;
int qemu_plugin_version = 1;
int qemu_plugin_install(plugin_id_t id, const void *info, int count, char **words);

enum { NO_REGISTERS = 0, ADD_U64 = 0, SPAN_MAX = 8, NAME_MAX = 32 };

typedef struct span {
    char name[NAME_MAX];
    uint64_t begin, end;     // addresses
    uint64_t from;           // the count when it was opened
    uint64_t runs, sum, most;
    int open;
} span_t;

static span_t spans[SPAN_MAX];
static size_t span_count;
static uint64_t executed; // instructions, this one included
static const char *out_name;

static void on_begin(unsigned cpu, void *user) {
    span_t *const span = user;
    (void)cpu;
    span->from = executed;
    span->open = 1;
}

static void on_end(unsigned cpu, void *user) {
    span_t *const span = user;
    (void)cpu;
    if (!span->open) return;
    const uint64_t count = executed - span->from;
    span->open = 0;
    span->runs++;
    span->sum += count;
    if (count > span->most) span->most = count;
}

static void on_translation(plugin_id_t id, struct qemu_plugin_tb *block) {
    (void)id;
    for (size_t k = 0; k < qemu_plugin_tb_n_insns(block); k++) {
        struct qemu_plugin_insn *const insn = qemu_plugin_tb_get_insn(block, k);
        const uint64_t address = qemu_plugin_insn_vaddr(insn);
        qemu_plugin_register_vcpu_insn_exec_inline(insn, ADD_U64, &executed, 1);
        for (size_t n = 0; n < span_count; n++) {
            span_t *const span = &spans[n];
            void (*const call)(unsigned, void *) = address == span->begin ? on_begin : on_end;
            if (address != span->begin && address != span->end) continue;
            qemu_plugin_register_vcpu_insn_exec_cb(insn, call, NO_REGISTERS, span);
        }
    }
}

static void on_exit(plugin_id_t id, void *user) {
    FILE *const file = fopen(out_name, "w");
    (void)id;
    (void)user;
    if (!file) return;
    for (size_t k = 0; k < span_count; k++) {
        const span_t *const span = &spans[k];
        fprintf(file, "%s %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", span->name, span->runs, span->sum,
                span->most);
    }
    fclose(file);
}

static int read_span(const char *text) {
    span_t *const span = &spans[span_count];
    const char *const colon = strchr(text, ':');
    char *rest = NULL;
    if (span_count == SPAN_MAX || !colon || colon - text >= NAME_MAX) return 0;
    memcpy(span->name, text, (size_t)(colon - text));
    span->begin = strtoull(colon + 1, &rest, 0);
    if (*rest != ':') return 0;
    span->end = strtoull(rest + 1, &rest, 0);
    span_count++;
    return *rest == '\0';
}

int qemu_plugin_install(plugin_id_t id, const void *info, int count, char **words) {
    (void)info;
    for (int k = 0; k < count; k++) {
        if (strncmp(words[k], "out=", 4) == 0) {
            out_name = words[k] + 4;
        } else if (strncmp(words[k], "span=", 5) != 0 || !read_span(words[k] + 5)) {
            return -1;
        }
    }
    if (!out_name) return -1;
    qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
    qemu_plugin_register_atexit_cb(id, on_exit, NULL);
    return 0;
}
