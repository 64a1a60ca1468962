// SPDX-License-Identifier: MIT
// Keinert's parallel look-ahead.
//
//   interpreter buffer   ├───────────────┼───────────────┼───────────────┤
//   task 0               ├───────────────┼~~~┤
//   task 1                          ├~~~~┼───────────────┼~~┤
//   task 2                                          ├~~~~┼───────────────┤
//
// ~~~ overlap: computed and discarded. The paper passes a buffer backwards, from rest; what its
// slope then accelerates by is passed forwards here in the same way, with an overlap on that side
// too.
#include "host/keinert.h"

#include "host/envelope.h" // nck_host_envelope_bad_double
#include "host/threads.h"  // nck_host_threads_run nck_host_clock_ns

#include "nck/base/envelope_math.h" // nck_envelope_backward nck_envelope_forward

typedef struct lookahead {
    const nck_host_keinert_settings_t *settings;
    const nck_host_problem_double_t *problem;
    const double *vv_feed;
    const nck_host_keinert_tables_t *tables;
    int64_t begin_ns;
} lookahead_t;

size_t nck_host_keinert_tasks(const nck_host_keinert_settings_t *settings, size_t n) {
    return settings->length == 0 ? 0 : (n + settings->length - 1) / settings->length;
}

size_t nck_host_keinert_rows(const nck_host_keinert_settings_t *settings) {
    return (size_t)settings->length + 2 * (size_t)settings->overlap_max + 1;
}

// The buffer of a task.
static nck_host_keinert_row_t *buffer_of(const lookahead_t *self, size_t task) {
    return self->tables->rows + task * nck_host_keinert_rows(self->settings);
}

// Blocks of overlap from node i on, in direction step (+1: behind, −1: before), `room` at most:
// as many as it takes to brake from, or to reach, the largest feed on the way. *too_short is
// raised if the largest overlap does not suffice.
static uint32_t choose_overlap(const lookahead_t *self, size_t i, int step, size_t room,
                               uint32_t *too_short) {
    const size_t most = room < self->settings->overlap_max ? room : self->settings->overlap_max;
    double reached = 0.0;
    double needed = 0.0;
    uint32_t k = 0;
    while (k < most && (k < self->settings->overlap_min || reached < needed || k == 0)) {
        const size_t piece = step > 0 ? i + k : i - 1 - k;
        if (self->vv_feed[piece] > needed) needed = self->vv_feed[piece];
        reached += self->problem->h[piece];
        k++;
    }
    // At the path's own ends the speed is known, whatever the length.
    if (k < room && (k == 0 || reached < needed)) *too_short = 1;
    return k;
}

// Copy a task's blocks and their overlaps into its own buffer. Returns the number of rows.
static size_t fill_buffer(const lookahead_t *self, const nck_host_keinert_task_t *task,
                          nck_host_keinert_row_t *rows) {
    const size_t begin = (size_t)task->first - task->overlap_before;
    const size_t behind = (size_t)task->first + task->count + task->overlap_behind;
    const size_t end = behind < self->problem->n ? behind + 1 : self->problem->n;
    for (size_t i = begin; i < end; i++) {
        const double h = i + 1 < self->problem->n ? self->problem->h[i] : 0.0;
        const double vv_cap = self->problem->vv_cap[i];
        rows[i - begin] = (nck_host_keinert_row_t){.number = i, .vv_cap = vv_cap, .h = h};
    }
    return end - begin;
}

// The last row comes to rest, unless it is the path's end: that has a speed of its own.
static void pass_backward(const lookahead_t *self, nck_host_keinert_row_t *rows, size_t count) {
    nck_host_keinert_row_t *last = &rows[count - 1];
    const int is_end = last->number + 1 == self->problem->n;
    last->vv_most = is_end ? nck_min(last->vv_cap, self->problem->vv_end) : last->vv_cap;
    last->vv = is_end ? last->vv_most : nck_envelope_backward(last->vv_cap, 0.0, 0.0);
    for (size_t i = count - 1; i-- > 0;) {
        const nck_host_keinert_row_t *next = &rows[i + 1];
        rows[i].vv = nck_envelope_backward(rows[i].vv_cap, next->vv, rows[i].h);
        rows[i].vv_most = nck_envelope_backward(rows[i].vv_cap, next->vv_most, rows[i].h);
    }
}

static void pass_forward(const lookahead_t *self, nck_host_keinert_row_t *rows, size_t count) {
    const int is_start = rows[0].number == 0;
    if (is_start) rows[0].vv_most = nck_min(rows[0].vv_most, self->problem->vv_start);
    rows[0].vv = is_start ? nck_min(rows[0].vv, self->problem->vv_start)
                         : nck_envelope_backward(rows[0].vv, 0.0, 0.0);
    for (size_t i = 1; i < count; i++) {
        const nck_host_keinert_row_t *before = &rows[i - 1];
        rows[i].vv = nck_envelope_forward(rows[i].vv, before->vv, before->h);
        rows[i].vv_most = nck_envelope_forward(rows[i].vv_most, before->vv_most, before->h);
    }
}

static void run_task(void *context, size_t index, int thread) {
    const lookahead_t *self = context;
    nck_host_keinert_task_t *task = &self->tables->tasks[index];
    nck_host_keinert_row_t *rows = buffer_of(self, index);
    const size_t first = index * self->settings->length;
    const size_t n = self->problem->n;
    const size_t left = n - first;
    *task = (nck_host_keinert_task_t){.first = first, .thread = thread};
    task->entry_ns = nck_host_clock_ns() - self->begin_ns;
    task->count = left < self->settings->length ? (uint32_t)left : self->settings->length;
    task->overlap_before = choose_overlap(self, first, -1, first, &task->too_short);
    const size_t end = first + task->count;
    if (end < n) {
        task->overlap_behind = choose_overlap(self, end, 1, n - 1 - end, &task->too_short);
    }
    const size_t count = fill_buffer(self, task, rows);
    pass_backward(self, rows, count);
    pass_forward(self, rows, count);
    const nck_host_keinert_row_t *own = rows + task->overlap_before;
    for (size_t i = 0; i < task->count; i++) task->dropped += own[i].vv < own[i].vv_most;
    task->exit_ns = nck_host_clock_ns() - self->begin_ns;
}

// Put the common profile together: own rows only, each to the place that its number says.
static void assemble(const lookahead_t *self, double *vv_out) {
    const size_t tasks = nck_host_keinert_tasks(self->settings, self->problem->n);
    for (size_t k = 0; k < tasks; k++) {
        const nck_host_keinert_task_t *task = &self->tables->tasks[k];
        const nck_host_keinert_row_t *own = buffer_of(self, k) + task->overlap_before;
        for (size_t i = 0; i < task->count; i++) vv_out[own[i].number] = own[i].vv;
    }
}

static int is_possible(const nck_host_keinert_settings_t *settings) {
    return settings->length >= 2 && settings->overlap_min <= settings->overlap_max &&
           settings->threads >= 1 && settings->threads <= NCK_HOST_THREADS_MAX;
}

// The first index with a bad number in any of the arrays; n if there is none.
static size_t first_bad(const lookahead_t *self) {
    const size_t bad = nck_host_envelope_bad_double(self->problem);
    for (size_t i = 0; i + 1 < self->problem->n && i < bad; i++) {
        const double vv_feed = self->vv_feed[i];
        if (!(vv_feed >= 0.0 && vv_feed - vv_feed == 0.0)) return i; // infinity − infinity is NaN
    }
    return bad;
}

nck_status_t nck_host_keinert(const nck_host_keinert_settings_t *settings,
                              const nck_host_problem_double_t *problem, const double *vv_feed,
                              const nck_host_keinert_tables_t *tables, double *vv_out,
                              size_t *bad_out) {
    lookahead_t self = {settings, problem, vv_feed, tables, nck_host_clock_ns()};
    *bad_out = problem->n;
    if (problem->n == 0 || !is_possible(settings)) return NCK_E_ARGUMENT;
    *bad_out = first_bad(&self);
    if (*bad_out < problem->n) return NCK_E_ARGUMENT;
    nck_host_threads_run(nck_host_keinert_tasks(settings, problem->n), settings->threads, run_task,
                         &self);
    assemble(&self, vv_out);
    return NCK_OK;
}
