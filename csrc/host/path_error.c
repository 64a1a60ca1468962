// SPDX-License-Identifier: MIT
// Setpoints against the moves about them.
#include "host/path_error.h"

#include "nck/base/real.h" // nck_min nck_max

#define ON_PATH_MM 1e-9 // nearer needs no better
// How much longer than a distance the way along the path to the nearest point may be.
#define REACH 3.0

void nck_host_path_error_init(nck_host_path_error_t *self, const nck_machine_t *machine) {
    nck_host_course_init(&self->course, machine);
    self->first = 0;
    self->end = 0;
    self->at = 0;
    self->all_read = 0;
    self->largest = 0.0;
}

static nck_host_move_t *move_of(const nck_host_path_error_t *self, uint64_t number) {
    return &self->moves[number % self->move_max];
}

// Read on until half of the ring lies ahead. Returns NCK_OK or NCK_EMPTY.
static nck_status_t read_ahead(nck_host_path_error_t *self) {
    nck_status_t status = NCK_OK;
    while (status == NCK_OK && !self->all_read && self->end - self->at <= self->move_max / 2) {
        status = nck_host_course_next(&self->course, move_of(self, self->end));
        if (status == NCK_OK) self->end++;
        if (status == NCK_DONE) self->all_read = 1;
        if (self->end - self->first > self->move_max) self->first++;
    }
    return status == NCK_EMPTY ? NCK_EMPTY : NCK_OK;
}

// Go to the move that a path coordinate is on, the last one if it is on several. Returns as above.
static nck_status_t go_to(nck_host_path_error_t *self, double s) {
    while (self->at > self->first && move_of(self, self->at)->begin_s > s) self->at--;
    nck_status_t status = read_ahead(self);
    while (status == NCK_OK && self->at + 1 < self->end
           && move_of(self, self->at + 1)->begin_s <= s) {
        self->at++;
        status = read_ahead(self);
    }
    return status;
}

// How far a point is from the moves about the place of the run; more than that, if it is not more
// than the largest distance so far.
static double nearest(const nck_host_path_error_t *self, const double *point) {
    const nck_host_move_t *const own = move_of(self, self->at);
    const uint64_t behind = self->at - self->first;
    const uint64_t ahead = self->end - 1u - self->at;
    const double enough = nck_max(ON_PATH_MM, self->largest);
    double best = nck_host_course_distance(own, point);
    const double reach = REACH * best;
    int goes_on = 1;
    for (uint64_t k = 1; goes_on && best > enough; k++) {
        const nck_host_move_t *const below = move_of(self, self->at - (k < behind ? k : behind));
        const nck_host_move_t *const above = move_of(self, self->at + (k < ahead ? k : ahead));
        best = nck_min(best, nck_host_course_distance(below, point));
        best = nck_min(best, nck_host_course_distance(above, point));
        goes_on = (k < behind && own->begin_s - below->begin_s <= reach)
                  || (k < ahead && above->end_s - own->end_s <= reach);
    }
    return best;
}

nck_status_t nck_host_path_error_add(nck_host_path_error_t *self, const nck_pose_t *poses,
                                     size_t count, size_t *used_out) {
    nck_status_t status = NCK_OK;
    size_t k = 0;
    while (k < count && status == NCK_OK) {
        const nck_pose_t *const pose = &poses[k];
        const int counts = pose->line > 0 && pose->kind < NCK_SEG_THREAD;
        if (counts) status = go_to(self, pose->s);
        if (counts && status == NCK_OK && self->end > self->first) {
            self->largest = nck_max(self->largest, nearest(self, pose->axis));
        }
        if (status == NCK_OK) k++;
    }
    *used_out = k;
    return status;
}
