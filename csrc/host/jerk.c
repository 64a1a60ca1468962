// SPDX-License-Identifier: MIT
// Lay a ladder, plan, divide what lasts too long, plan again; then the cells.
#include "host/jerk.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memset

#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_…
#include "nck/prep/5_slope/profile.h"     // nck_profile_t

enum { ARRAYS = 11, PARTS_MOST = 1000 };

// No cell is capped in rule R while the ladder is still coarse.
#define UNCAPPED_PERIODS 1e9

// The ladder under construction: the profile's arrays, and the segment of every cell.
typedef struct ladder {
    const nck_host_path_t *path;
    const nck_host_jerk_t *how;
    double j_scale;
    size_t room;  // nodes
    size_t cells; // of the ladder, whether there is room for them or not
    nck_profile_t profile;
    uint32_t *seg;
} ladder_t;

size_t nck_host_jerk_bytes(size_t nodes) {
    return nodes * (ARRAYS * sizeof(double) + 2 * sizeof(uint32_t));
}

static int is_positive(double x) { return x > 0.0 && x <= DBL_MAX; }

static int is_good(const nck_host_path_t *path, size_t i) {
    return is_positive(path->length[i]) && is_positive(path->v_cap[i])
           && is_positive(path->a_max[i]) && is_positive(path->j_max[i]) && path->v_node[i] >= 0.0;
}

static size_t first_bad(const nck_host_path_t *path, const nck_host_jerk_t *how) {
    if (!is_positive(how->period_s) || !is_positive(how->step_s)) return path->n;
    if (how->step_s > 4.0 * how->period_s) return path->n;
    if (!(how->j_scale >= 0.0 && how->j_scale <= 1.0)) return path->n;
    for (size_t i = 0; i < path->n; i++) {
        if (!is_good(path, i)) return i;
    }
    return path->n > 0 && path->v_node[path->n] >= 0.0 ? path->n + 1 : path->n;
}

static void share_out(ladder_t *self, void *work, size_t nodes) {
    double *const first = work;
    double **const arrays[ARRAYS] = {
        &self->profile.h, &self->profile.vv_cap, &self->profile.a_max, &self->profile.j_max,
        &self->profile.vv, &self->profile.s,     &self->profile.up,    &self->profile.down,
        &self->profile.e, &self->profile.z,     &self->profile.j};
    for (size_t k = 0; k < ARRAYS; k++) *arrays[k] = first + k * nodes;
    void *const behind = first + ARRAYS * nodes;
    self->profile.stack = behind;
    self->seg = self->profile.stack + nodes;
    self->room = nodes;
}

static double square(double x) { return x * x; }

static double junction_cap(const ladder_t *self, size_t node) {
    const nck_host_path_t *const path = self->path;
    const size_t n = path->n;
    if (node == 0 || node == n) return 0.0;
    const double v = nck_min(path->v_node[node], nck_min(path->v_cap[node - 1], path->v_cap[node]));
    return square(v);
}

static void push(ladder_t *self, uint32_t seg, double h) {
    if (self->cells + 1 < self->room) {
        self->profile.h[self->cells] = h;
        self->seg[self->cells] = seg;
    }
    self->cells++;
}

static void lay_segment(ladder_t *self, uint32_t seg) {
    const nck_host_path_t *const path = self->path;
    const double vv0 = junction_cap(self, seg);
    const double vv1 = junction_cap(self, (size_t)seg + 1);
    const nck_ladder_piece_t piece = {vv0, vv1, square(path->v_cap[seg]), path->a_max[seg],
                                      path->j_max[seg] * self->j_scale};
    // From rest to rest takes two cells at least.
    const double most = vv0 == 0.0 && vv1 == 0.0 ? 0.25 * path->length[seg] : path->length[seg];
    double x = 0.0;
    while (self->cells < NCK_HOST_JERK_NODES) {
        const double left = path->length[seg] - x;
        const double step = nck_ladder_step(&piece, x, left, self->how->step_s);
        const double h = nck_min(most, step);
        push(self, seg, left < 1.5 * h ? left : h);
        if (left < 1.5 * h) return;
        x += h;
    }
}

// 1 if the nodes of the ladder find room.
static int fits(const ladder_t *self) { return self->cells + 1 <= self->room; }

// Cells that the path has at least: none but the last of a segment is longer than D·v_cap, and that
// one by half.
static double least_cells(const ladder_t *self) {
    double count = 0.0;
    for (size_t i = 0; i < self->path->n; i++) {
        count += self->path->length[i] / (1.5 * self->how->step_s * self->path->v_cap[i]);
    }
    return count;
}

static int lay(ladder_t *self) {
    const int many = !(least_cells(self) < (double)NCK_HOST_JERK_NODES);
    self->cells = many ? NCK_HOST_JERK_NODES : 0;
    for (size_t i = 0; !many && i < self->path->n; i++) lay_segment(self, (uint32_t)i);
    if (fits(self)) self->profile.n = (uint32_t)self->cells;
    return fits(self);
}

static double cell_duration(const ladder_t *self, uint32_t i) {
    const nck_profile_t *const p = &self->profile;
    const double v_sum = nck_sqrt(p->vv[i]) + nck_sqrt(p->vv[i + 1]);
    return v_sum > 0.0 ? 2.0 * p->h[i] / v_sum : DBL_MAX;
}

static int parts_of(const ladder_t *self, uint32_t i) {
    return nck_ladder_parts(cell_duration(self, i), self->how->step_s, PARTS_MOST);
}

// Divide a cell into parts of equal time, the last one first, downward from place `to`.
static uint32_t divide(ladder_t *self, uint32_t from, uint32_t to, int parts) {
    nck_profile_t *const p = &self->profile;
    const double h = p->h[from];
    const double q = cell_duration(self, from);
    const double v = nck_sqrt(p->vv[from]);
    const double a = (p->vv[from + 1] - p->vv[from]) / (2.0 * h);
    const uint32_t seg = self->seg[from];
    double end = h;
    for (int k = parts - 1; k >= 0; k--) {
        const double t = q * (double)k / (double)parts;
        const double begin = parts == 1 || q == DBL_MAX ? h * (double)k / (double)parts
                                                        : t * (v + 0.5 * a * t);
        to--;
        p->h[to] = end - begin;
        self->seg[to] = seg;
        end = begin;
    }
    return to;
}

// In place, from the last cell to the first: what grows never overtakes what is still to be read.
static int divide_long(ladder_t *self) {
    nck_profile_t *const p = &self->profile;
    self->cells = 0;
    for (uint32_t i = 0; i < p->n; i++) self->cells += (size_t)parts_of(self, i);
    if (!fits(self)) return 0;
    uint32_t to = (uint32_t)self->cells;
    for (uint32_t i = p->n; i-- > 0;) to = divide(self, i, to, parts_of(self, i));
    p->n = (uint32_t)self->cells;
    return 1;
}

// The segment of the first cell that would last for ever, because both of its ends are at rest; n
// if there is none.
static size_t first_standing(const ladder_t *self) {
    const nck_profile_t *const p = &self->profile;
    for (uint32_t i = 0; i < p->n; i++) {
        if (!(p->vv[i] + p->vv[i + 1] > 0.0)) return self->seg[i];
    }
    return self->path->n;
}

// Caps and limits of every node and cell, and the plan. q_cap: see nck_profile_t. Returns as
// first_standing.
static size_t plan(ladder_t *self, double q_cap, int is_last) {
    nck_profile_t *const p = &self->profile;
    const nck_host_path_t *const path = self->path;
    for (uint32_t i = 0; i < p->n; i++) {
        const uint32_t seg = self->seg[i];
        const int junction = i == 0 || self->seg[i - 1] != seg;
        p->a_max[i] = path->a_max[seg];
        p->j_max[i] = path->j_max[seg] * self->j_scale;
        p->vv_cap[i] = junction ? junction_cap(self, seg) : square(path->v_cap[seg]);
    }
    p->q_cap = q_cap;
    p->count = is_last ? p->n : 0;
    p->v = p->a = p->q = 0.0;
    nck_profile_begin(p);
    while (nck_profile_step(p, UINT32_MAX) != NCK_DONE) continue;
    return first_standing(self);
}

// All rounds. Returns NCK_OK, NCK_FULL, or NCK_E_STATE and the segment where the path would stand.
static nck_status_t plan_in_rounds(ladder_t *self, double q_cap, size_t *bad_out) {
    if (!lay(self)) return NCK_FULL;
    for (uint32_t round = 0; round < self->how->rounds; round++) {
        *bad_out = plan(self, UNCAPPED_PERIODS * self->how->period_s, 0);
        if (*bad_out < self->path->n) return NCK_E_STATE;
        if (!divide_long(self)) return NCK_FULL;
    }
    *bad_out = plan(self, q_cap, 1);
    return *bad_out < self->path->n ? NCK_E_STATE : NCK_OK;
}

static void draw(const ladder_t *self, double *v_out, nck_cell_t *cells) {
    const nck_profile_t *const p = &self->profile;
    double s = 0.0;
    for (uint32_t i = 0; i < p->n; i++) {
        nck_cell_t *const cell = &cells[i];
        const int first = i == 0 || self->seg[i - 1] != self->seg[i];
        memset(cell, 0, sizeof *cell);
        if (first) s = 0.0;
        cell->seg = self->seg[i];
        cell->last = i + 1 == p->n || self->seg[i + 1] != self->seg[i];
        cell->stop = p->vv[i + 1] == 0.0;
        cell->s = s;
        cell->length = p->h[i];
        cell->v = nck_sqrt(p->vv[i]);
        cell->duration = cell_duration(self, i);
        cell->a = (p->vv[i + 1] - p->vv[i]) / (2.0 * p->h[i]);
        if (first) v_out[cell->seg] = cell->v;
        s += p->h[i];
    }
    v_out[self->path->n] = 0.0;
}

nck_status_t nck_host_jerk(const nck_host_path_t *path, const nck_host_jerk_t *how,
                           const nck_host_jerk_area_t *area, size_t *cell_count_out,
                           size_t *bad_out) {
    ladder_t self;
    *cell_count_out = 0;
    *bad_out = first_bad(path, how);
    if (*bad_out <= path->n) return NCK_E_ARGUMENT;
    memset(&self, 0, sizeof self);
    self.path = path;
    self.how = how;
    const double q_cap = NCK_LADDER_STRETCH * how->step_s;
    const double excess = nck_ladder_excess(q_cap, how->period_s, 1);
    self.j_scale = how->j_scale > 0.0 ? how->j_scale : 1.0 / (1.0 + excess);
    share_out(&self, area->work, area->nodes);
    const nck_status_t status = plan_in_rounds(&self, q_cap, bad_out);
    *cell_count_out = status == NCK_FULL ? self.cells + 1 : self.profile.n;
    if (status == NCK_OK) draw(&self, area->v_node, area->cells);
    return status;
}
