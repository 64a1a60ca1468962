// SPDX-License-Identifier: MIT
// The parallel look-ahead of Keinert et al. (2014), section 4: the interpreter's buffer is cut
// into look-ahead buffers with an overlap, each is a task for a thread, and the results are put
// together by the blocks' numbers. As published: an overlap that is too short gives a lower
// profile, and says so.
#ifndef NCK_HOST_KEINERT_H
#define NCK_HOST_KEINERT_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t int64_t

#include "host/envelope.h"   // nck_host_problem_double_t
#include "nck/base/status.h" // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// The paper's case study: 300, 5, 50.
typedef struct nck_host_keinert_settings {
    uint32_t length;      // blocks of a look-ahead buffer without its overlaps, 2 at least
    uint32_t overlap_min; // blocks on either side
    uint32_t overlap_max; // overlap_min at least
    int32_t threads;      // 1 to NCK_HOST_THREADS_MAX
} nck_host_keinert_settings_t;

// An element of a look-ahead buffer: the start of a block.
typedef struct nck_host_keinert_row {
    uint64_t number; // of the block: its place in the interpreter's buffer
    double vv_cap;   // [mm²/s²]
    double h;        // [mm²/s²]
    double vv;       // found: from rest at both ends of the buffer, never too high
    double vv_most;  // no profile can be above: from the caps at both ends
} nck_host_keinert_row_t;

// A task: one look-ahead buffer.
typedef struct nck_host_keinert_task {
    uint64_t first;          // number of its first own block
    uint32_t count;          // own blocks
    uint32_t overlap_before; // blocks, as chosen
    uint32_t overlap_behind;
    uint32_t too_short;      // 1: overlap_max was not enough to reach the feed
    uint32_t dropped;        // own blocks whose vv is not certain: it may be lower than needed
    int32_t thread;          // who ran it
    int64_t entry_ns;        // since the call [ns]
    int64_t exit_ns;
} nck_host_keinert_task_t;

// Where the tasks work and what they tell, the caller's.
typedef struct nck_host_keinert_tables {
    nck_host_keinert_row_t *rows;   // nck_host_keinert_tasks × nck_host_keinert_rows: the buffers
    nck_host_keinert_task_t *tasks; // nck_host_keinert_tasks
} nck_host_keinert_tables_t;

// Tasks of n nodes: rows of the task table. 0 if n or length is 0. Cost: constant. Context: any.
size_t nck_host_keinert_tasks(const nck_host_keinert_settings_t *settings, size_t n);

// Rows that one task takes in the row table. Cost: constant. Context: any.
size_t nck_host_keinert_rows(const nck_host_keinert_settings_t *settings);

// The look-ahead of a whole interpreter buffer by parallel tasks.
// vv_feed: n − 1 blocks, programmed feed squared [mm²/s²]: an overlap ends where the path from its
// border suffices to brake from there, or to reach it. tables: filled. vv_out: n nodes, not the
// problem's vv_cap: equal to the exact envelope wherever no task reports a drop, never above it.
// Returns NCK_OK; NCK_E_ARGUMENT if n is 0 or the settings are out of range (*bad_out = n), or a
// number is NaN, infinite or negative (*bad_out: its index); nothing is written to vv_out then.
// Cost: linear. Context: prep.
nck_status_t nck_host_keinert(const nck_host_keinert_settings_t *settings,
                              const nck_host_problem_double_t *problem, const double *vv_feed,
                              const nck_host_keinert_tables_t *tables, double *vv_out,
                              size_t *bad_out);

#ifdef __cplusplus
}
#endif

#endif
