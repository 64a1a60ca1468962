// SPDX-License-Identifier: MIT
// Setpoints against the moves about them.
#include "host/path_error.h"

#include <string.h> // memcpy memset

#include "host/seg_distance.h" // nck_host_chord_distance
#include "nck/base/real.h"     // nck_fabs nck_min nck_max

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
    self->missed = 0.0;
    memset(&self->corner, 0, sizeof self->corner);
    memset(self->before, 0, sizeof self->before);
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

// Motions begin to overlap at the end of the move that ends nearest to a path coordinate.
static void begin_corner(nck_host_path_error_t *self, double s) {
    nck_host_corner_t *const corner = &self->corner;
    const uint64_t last = self->at + 1u < self->end ? self->at + 1u : self->at;
    const uint64_t first = self->at > self->first ? self->at - 1u : self->at;
    uint64_t best = first;
    for (uint64_t k = first; k <= last; k++) {
        const double apart = nck_fabs(move_of(self, k)->end_s - s);
        if (apart < nck_fabs(move_of(self, best)->end_s - s)) best = k;
    }
    const nck_host_move_t *const move = move_of(self, best);
    const nck_host_move_t *const next = move_of(self, best + 1u < self->end ? best + 1u : best);
    memcpy(corner->point, move->end, sizeof corner->point);
    corner->tolerance = nck_min(move->tolerance, next->tolerance);
    corner->apart = nck_host_course_apart(self->before, corner->point);
}

// The run comes to a setpoint.
static void come_near(nck_host_path_error_t *self, const double *point) {
    nck_host_corner_t *const corner = &self->corner;
    const double apart = nck_host_chord_distance(self->before, point, corner->point);
    corner->apart = nck_min(corner->apart, apart);
}

static void end_corner(nck_host_path_error_t *self) {
    const nck_host_corner_t *const corner = &self->corner;
    self->largest = nck_max(self->largest, corner->apart);
    if (!(corner->tolerance > 0.0)) return;
    self->missed = nck_max(self->missed, corner->apart / corner->tolerance);
}

// The next setpoint, and the corner that the run overlaps at. Less and less is left of the first
// motion; when it is more, it is another one.
static void pass_corner(nck_host_path_error_t *self, const nck_pose_t *pose) {
    nck_host_corner_t *const corner = &self->corner;
    const int was_on = corner->left > 0.0;
    const int begins = pose->left > corner->left;
    if (was_on) come_near(self, pose->axis);
    if (was_on && (begins || !(pose->left > 0.0))) end_corner(self);
    if (begins) {
        begin_corner(self, pose->s + pose->left);
        come_near(self, pose->axis);
    }
    corner->left = pose->left;
    memcpy(self->before, pose->axis, sizeof self->before);
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
            pass_corner(self, pose);
        }
        if (status == NCK_OK) k++;
    }
    *used_out = k;
    return status;
}
