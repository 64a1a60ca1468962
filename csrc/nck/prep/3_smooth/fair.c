// SPDX-License-Identifier: MIT
// Inside room 3: the smoothest curve within a tolerance, by an interior point method in slices.
#include "nck/base/tuning.h"              // NCK_ROOM NCK_WAY …
#include "nck/prep/3_smooth/basis_math.h" // nck_basis_…
#include "nck/prep/3_smooth/fair.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_FAIR_BETTER …

#include <string.h> // memset

#define JAMS NCK_NUM_OF(1e-3) // of a step: where a curve is within the limits each goes further
#define WORK 8000 // operations a call: 40 000 instructions of a processor without vectors

// Operations of an interval's dearest phase: 4 rows enter a triangle of (4 axes)²/2 elements, each
// of the axes' rows is eliminated from as many, and what is linear in them.
static int operations(int axes) { return 64 * axes * axes + 16 * axes * axes * axes + 150 * axes; }

void nck_fair_begin(nck_fair_t *self, const nck_fair_task_t *task) {
    self->task = *task;
    self->phase = NCK_FAIR_LOOK;
    self->at = 0;
    self->slice = WORK / operations(task->axes) > 1 ? WORK / operations(task->axes) : 1;
    self->unknown = task->ends ? task->knots - 3 : task->knots;
    self->bins = 0;
    self->iterations = 0;
    self->sound = 0;
    memset(&self->sum, 0, sizeof self->sum);
    memset(self->y, 0, sizeof self->y);
    memset(self->dy, 0, sizeof self->dy);
    self->first[0] = 0;
    self->first[1] = 0;
}

void nck_fair_set_jerk(nck_fair_t *self, int i, const nck_num *jerk) {
    const int axes = self->task.axes;
    for (int a = 0; a < axes; a++) self->jerk[i * axes + a] = jerk[a];
}

int nck_fair_room(const nck_fair_t *self) {
    const int to_come = self->task.knots * NCK_FAIR_BINS - self->bins;
    const int own = self->first[self->bins] == self->first[self->bins + 1];
    return NCK_FAIR_SAMPLES - self->first[self->bins + 1] - to_come + 1 - own;
}

void nck_fair_add_sample(nck_fair_t *self, nck_num place, const nck_num *off) {
    const int axes = self->task.axes;
    const int k = self->first[self->bins + 1];
    if (k > self->first[self->bins] && nck_fair_room(self) <= 0) return;
    self->place[k] = place;
    for (int a = 0; a < axes; a++) self->off[k * axes + a] = off[a];
    self->first[self->bins + 1] = (uint16_t)(k + 1);
}

void nck_fair_close_bin(nck_fair_t *self, nck_num limit) {
    self->limit[self->bins] = limit * limit;
    self->bins++;
    if (self->bins < NCK_FAIR_ROWS) self->first[self->bins + 1] = self->first[self->bins];
}

// Take the step found last, of the control point and rows that interval i brings.
static inline void take_step(nck_fair_t *self, int axes, int i) {
    const nck_num step = self->sum.step;
    for (int u = (i + 3) * axes; u < (i + 4) * axes; u++) {
        self->y[u] += step * self->dy[u];
    }
    for (int b = NCK_FAIR_BINS * i; b < NCK_FAIR_BINS * (i + 1); b++) {
        const nck_num s = self->slack[b];
        const nck_num z = self->price[b];
        const nck_num d_price = (self->sum.mu - z * (s + self->d_slack[b])) / s;
        self->slack[b] = s + step * self->d_slack[b];
        self->price[b] = z + self->sum.step_price * d_price;
    }
}

// |e|² of a sample; e: where the curve is, from it.
static inline nck_num measure(const nck_fair_t *self, int axes, int k, nck_num (*cubic)[4],
                              nck_num *e_out) {
    nck_num sum = 0;
    for (int a = 0; a < axes; a++) {
        e_out[a] = self->off[k * axes + a] + nck_basis_value(cubic[a], self->place[k]);
        sum += e_out[a] * e_out[a];
    }
    return sum;
}

// Find the worst sample of a bin and how far the curve is off it. Returns |e|².
static inline nck_num find_worst(nck_fair_t *self, int axes, int b, nck_num (*cubic)[4]) {
    nck_num *const e = &self->e[b * axes];
    nck_num other[NCK_AXIS_MAX];
    int kept = self->iterations > 0 ? self->kept[b] : self->first[b];
    nck_num most = measure(self, axes, kept, cubic, e);
    const nck_num bar = self->iterations > 0 ? NCK_FAIR_BETTER : 0;
    int found = kept;
    nck_num worst = most;
    for (int k = self->first[b]; k < self->first[b + 1]; k++) {
        const nck_num here = k == kept ? most : measure(self, axes, k, cubic, other);
        if (here > worst) {
            worst = here;
            found = k;
        }
    }
    if (found != kept && worst > most + bar) {
        kept = found;
        most = measure(self, axes, kept, cubic, e);
    }
    self->kept[b] = (uint16_t)kept;
    return most;
}

// Look at a row: a slack below its row's would jam the steps, so it is raised.
static inline void look_at_row(nck_fair_t *self, int axes, int b, nck_num (*cubic)[4]) {
    const nck_num room = self->limit[b] - find_worst(self, axes, b, cubic);
    if (self->iterations == 0) self->slack[b] = nck_num_max(room, NCK_NUM_OF(NCK_ROOM));
    else self->slack[b] = nck_num_max(room, self->slack[b]);
    self->sum.primal = nck_num_max(self->sum.primal, self->slack[b] - room);
    if (self->iterations > 0) self->sum.complement += self->slack[b] * self->price[b];
}

// Jerk of an axis in interval i, over its limit.
static inline nck_num jerk_of(const nck_fair_t *self, int axes, int i, int a) {
    const nck_num *const y = &self->y[i * axes + a];
    const nck_num third = y[3 * axes] - y[0] + 3 * (y[axes] - y[2 * axes]);
    return self->jerk[i * axes + a] + self->task.scale * third;
}

// What an axis' jerk costs in an interval, and how that changes with it: a fourth power beside a
// square, beyond the axis' limit on with the slope and the curvature that it has there.
typedef struct cost {
    nck_num all;
    nck_num slope; // by the jerk
    nck_num curve; // half the second derivative
} cost_t;

static inline cost_t cost_of(const nck_fair_t *self, int axes, int i, int a) {
    const nck_num share = self->task.share[a];
    const nck_num jerk = share * jerk_of(self, axes, i, a);
    const nck_num size = NCK_NUM_ABS(jerk);
    const nck_num low = size < 1 ? size : 1;
    const nck_num raised = self->task.even * low * low;
    const nck_num curve = 1 + 6 * raised;
    const nck_num slope = 2 * low * (1 + 2 * raised);
    const nck_num over = size - low;
    cost_t cost;
    cost.all = low * low * (1 + raised) + over * (slope + curve * over);
    cost.slope = share * (slope + 2 * curve * over);
    if (jerk < 0) cost.slope = -cost.slope;
    cost.curve = share * share * curve;
    return cost;
}

static inline void look_at(nck_fair_t *self, int axes, int i) {
    nck_num cubic[NCK_AXIS_MAX][4];
    if (self->iterations > 0) take_step(self, axes, i);
    for (int a = 0; a < axes; a++) {
        self->sum.objective += cost_of(self, axes, i, a).all;
        nck_basis_cubic(&self->y[i * axes + a], axes, cubic[a]);
    }
    for (int b = NCK_FAIR_BINS * i; b < NCK_FAIR_BINS * (i + 1); b++) {
        look_at_row(self, axes, b, cubic);
    }
}

// What the four rows of an interval put into Newton's system: by control points, weights times
// this.
enum { NCK_BLOCK_SIZE = NCK_AXIS_MAX * (NCK_AXIS_MAX + 1) / 2 };
typedef struct pulls {
    nck_num curve[NCK_AXIS_MAX];                  // of the jerk's share, its second derivative
    nck_num weight[NCK_FAIR_BINS][4];             // of the control points
    nck_num pull[NCK_FAIR_BINS][NCK_AXIS_MAX];    // on every axis
    nck_num block[NCK_FAIR_BINS][NCK_BLOCK_SIZE]; // 4 z/s e eᵀ + 2 (z + stay) I, half of it
} pulls_t;

// The share of row b.
static inline void share_row(const nck_fair_t *self, int axes, int b, pulls_t *out) {
    const int k = b % NCK_FAIR_BINS;
    const nck_num *const e = &self->e[b * axes];
    const nck_num per_slack = 1 / self->slack[b];
    const nck_num z = self->price[b];
    const nck_num z_per_slack = z * per_slack;
    const nck_num even = 2 * (z + self->task.stay);
    nck_num miss = self->slack[b] - self->limit[b];
    for (int a = 0; a < axes; a++) miss += e[a] * e[a];
    const nck_num pull = 2 * (self->sum.mu * per_slack + z_per_slack * miss + self->task.stay);
    int at = 0;
    for (int a = 0; a < axes; a++) {
        const nck_num raised = 4 * z_per_slack * e[a];
        out->pull[k][a] = pull * e[a];
        out->block[k][at++] = raised * e[a] + even;
        for (int c = a + 1; c < axes; c++) out->block[k][at++] = raised * e[c];
    }
    nck_basis_weights(self->place[self->kept[b]], out->weight[k]);
}

// Jerk is a third difference of control points.
static const nck_num difference[4] = {-1, 3, -3, 1};

// Pull the interval's control point p, the unknown point j, by the rows and the jerk.
static inline void add_pull(nck_fair_t *self, int axes, const int at[2], const pulls_t *pulls,
                            const nck_num *jerk_pull) {
    const int p = at[0];
    const int j = at[1];
    const nck_num w0 = pulls->weight[0][p];
    const nck_num w1 = pulls->weight[1][p];
    const nck_num w2 = pulls->weight[2][p];
    const nck_num w3 = pulls->weight[3][p];
    for (int a = 0; a < axes; a++) {
        const nck_num rows = w0 * pulls->pull[0][a] + w1 * pulls->pull[1][a]
                               + (w2 * pulls->pull[2][a] + w3 * pulls->pull[3][a]);
        self->dy[(3 + j) * axes + a] -= rows + difference[p] * jerk_pull[a];
    }
}

// Couple the interval's control points p and q ≥ p, p being the unknown point j: a block of the
// matrix, of which the band has the upper half.
static inline void add_block(nck_fair_t *self, int axes, const int at[2], int q,
                             const pulls_t *pulls) {
    const int p = at[0];
    const int j = at[1];
    const int width = 4 * axes;
    const nck_num w0 = pulls->weight[0][p] * pulls->weight[0][q];
    const nck_num w1 = pulls->weight[1][p] * pulls->weight[1][q];
    const nck_num w2 = pulls->weight[2][p] * pulls->weight[2][q];
    const nck_num w3 = pulls->weight[3][p] * pulls->weight[3][q];
    const nck_num jerk = 2 * self->task.scale * self->task.scale * difference[p] * difference[q];
    int k = 0;
    for (int a = 0; a < axes; a++) {
        nck_num *const row = &self->band[(j * axes + a) * width + (q - p) * axes];
        row[0] += jerk * pulls->curve[a];
        for (int c = 0; c < axes - a; c++) {
            const nck_num rows = w0 * pulls->block[0][k] + w1 * pulls->block[1][k]
                                   + (w2 * pulls->block[2][k] + w3 * pulls->block[3][k]);
            row[c] += rows;
            if (q > p && c > 0) row[c * width - c] += rows;
            k++;
        }
    }
}

// Eliminate the axes of the unknown point j: the band's rows become those of D Lᵀ, 1/D in front.
static inline void eliminate(nck_fair_t *self, int axes, int j) {
    const int width = 4 * axes;
    for (int a = 0; a < axes; a++) {
        const int u = j * axes + a;
        const int left = self->unknown * axes - u;
        const int count = left < width - a ? left : width - a;
        nck_num *const row = &self->band[u * width];
        nck_num *const dy = &self->dy[3 * axes + u];
        const nck_num inverse = row[0] > 0 ? 1 / row[0] : 0; // 0: no curve is within the limits
        const nck_num pull = dy[0] * inverse;
        for (int p = 1; p < count; p++) {
            const nck_num share = row[p] * inverse;
            nck_num *const below = &row[p * width] - p;
            for (int q = p; q < count; q++) below[q] -= share * row[q];
            dy[p] -= pull * row[p];
        }
        row[0] = inverse;
    }
}

// Make room for the unknown point j in Newton's system.
static inline void clear(nck_fair_t *self, int axes, int j) {
    const int width = 4 * axes;
    if (j >= self->unknown) return;
    memset(&self->band[j * axes * width], 0, (size_t)(axes * width) * sizeof *self->band);
    memset(&self->dy[(3 + j) * axes], 0, (size_t)axes * sizeof *self->dy);
}

// Newton's system: what interval i adds to it, and the elimination of what is complete then.
static inline void solve_at(nck_fair_t *self, int axes, int i) {
    pulls_t pulls;
    nck_num jerk_pull[NCK_AXIS_MAX];
    memset(pulls.weight, 0, sizeof pulls.weight); // cppcheck does not see that they are set
    clear(self, axes, i);
    for (int k = 0; k < NCK_FAIR_BINS; k++) share_row(self, axes, NCK_FAIR_BINS * i + k, &pulls);
    for (int a = 0; a < axes; a++) {
        const cost_t cost = cost_of(self, axes, i, a);
        jerk_pull[a] = self->task.scale * cost.slope;
        pulls.curve[a] = cost.curve;
    }
    const int low = i < 3 ? 3 - i : 0;
    const int high = self->unknown + 3 - i < 4 ? self->unknown + 3 - i : 4;
    for (int p = low; p < high; p++) {
        const int at[2] = {p, i - 3 + p};
        add_pull(self, axes, at, &pulls, jerk_pull);
        for (int q = p; q < high; q++) add_block(self, axes, at, q, &pulls);
    }
    if (i >= 3 && i - 3 < self->unknown) eliminate(self, axes, i - 3);
    if (i + 1 < self->task.knots) return;
    for (int j = i - 2; j < self->unknown; j++) eliminate(self, axes, j);
}

// The step of the unknown point j, those behind it known.
static inline void substitute(nck_fair_t *self, int axes, int j) {
    const int width = 4 * axes;
    for (int a = axes - 1; a >= 0; a--) {
        const int u = j * axes + a;
        const int left = self->unknown * axes - u;
        const int count = left < width - a ? left : width - a;
        const nck_num *const row = &self->band[u * width];
        nck_num *const dy = &self->dy[3 * axes + u];
        nck_num value = dy[0];
        for (int p = 1; p < count; p++) value -= row[p] * dy[p];
        dy[0] = value * row[0];
    }
}

// How a row's slack and price change under the step, a cubic in every axis.
static inline void respond(nck_fair_t *self, int axes, int b, nck_num (*cubic)[4]) {
    const nck_num *const e = &self->e[b * axes];
    const nck_num w = self->place[self->kept[b]];
    nck_num miss = self->slack[b] - self->limit[b];
    for (int a = 0; a < axes; a++) miss += e[a] * (e[a] + 2 * nck_basis_value(cubic[a], w));
    const nck_num s = self->slack[b];
    const nck_num z = self->price[b];
    self->d_slack[b] = -miss;
    self->sum.shrink = nck_num_max(self->sum.shrink, miss / s);
    self->sum.cheapen = nck_num_max(self->sum.cheapen, 1 - (self->sum.mu + z * miss) / (s * z));
}

// Substitute what interval i needs, from the last on, and find what its rows do.
static inline void back_at(nck_fair_t *self, int axes, int i) {
    nck_num cubic[NCK_AXIS_MAX][4];
    if (i + 1 == self->task.knots) {
        for (int j = self->unknown - 1; j > i - 3; j--) substitute(self, axes, j);
    }
    if (i >= 3 && i - 3 < self->unknown) substitute(self, axes, i - 3);
    for (int a = 0; a < axes; a++) nck_basis_cubic(&self->dy[i * axes + a], axes, cubic[a]);
    for (int k = 0; k < NCK_FAIR_BINS; k++) respond(self, axes, NCK_FAIR_BINS * i + k, cubic);
}

// All prices for the first iteration; least: what μ is led to at the end.
static void set_prices(nck_fair_t *self, nck_num least) {
    const int rows = self->task.knots * NCK_FAIR_BINS;
    self->sum.mu = nck_num_max(self->sum.objective / (nck_num)(2 * rows), least);
    for (int b = 0; b < rows; b++) self->price[b] = self->sum.mu / self->slack[b];
    self->sum.complement = (nck_num)rows * self->sum.mu;
}

// All rows are looked at: is this the answer? If not, how far the next step is to lead.
static int is_done(nck_fair_t *self) {
    const nck_num rows = (nck_num)(self->task.knots * NCK_FAIR_BINS);
    const nck_num bar = self->task.gap * (self->sum.objective + NCK_FAIR_SMALL * rows);
    const nck_num least = NCK_AIM * bar / rows;
    const nck_num sound = NCK_FAIR_SOUND * self->task.gap;
    if (self->iterations == 0) set_prices(self, least);
    else if (self->sum.complement <= bar && self->sum.primal < sound) self->sound = 1;
    if (self->sound || self->iterations >= self->task.most) return 1;
    if (self->iterations > 0 && self->sum.step < JAMS) return 1;
    self->sum.mu = nck_num_max(NCK_FALL * self->sum.complement / rows, least);
    self->sum.shrink = 0;
    self->sum.cheapen = 0;
    return 0;
}

// Newton's step is known: how much of it keeps slacks and prices positive.
static void set_steps(nck_fair_t *self) {
    self->sum.step = self->sum.shrink > NCK_WAY ? NCK_WAY / self->sum.shrink : 1;
    self->sum.step_price = self->sum.cheapen > NCK_WAY ? NCK_WAY / self->sum.cheapen : 1;
    self->sum.objective = 0;
    self->sum.complement = 0;
    self->sum.primal = 0;
    self->iterations++;
}

// A phase is over: the next one.
static void turn(nck_fair_t *self) {
    const int last = self->task.knots - 1;
    if (self->phase == NCK_FAIR_LOOK) {
        self->phase = is_done(self) ? NCK_FAIR_DONE : NCK_FAIR_SOLVE;
        self->at = 0;
    } else if (self->phase == NCK_FAIR_SOLVE) {
        self->phase = NCK_FAIR_BACK;
        self->at = last;
    } else {
        set_steps(self);
        self->phase = NCK_FAIR_LOOK;
        self->at = 0;
    }
}

// A slice of work. axes: as in the task; where it is a constant, loops over it are unrolled.
static inline void work(nck_fair_t *self, int axes) {
    const int last = self->task.knots - 1;
    for (int k = 0; k < self->slice && self->phase != NCK_FAIR_DONE; k++) {
        const int i = self->at;
        const int is_back = self->phase == NCK_FAIR_BACK;
        if (is_back) back_at(self, axes, i);
        else if (self->phase == NCK_FAIR_SOLVE) solve_at(self, axes, i);
        else look_at(self, axes, i);
        self->at += is_back ? -1 : 1;
        if (i == (is_back ? 0 : last)) turn(self);
    }
}

nck_num nck_fair_tightness(const nck_fair_t *self, int i, int intervals) {
    nck_num sum = 0;
    for (int b = NCK_FAIR_BINS * i; b < NCK_FAIR_BINS * (i + intervals); b++) sum += self->price[b];
    return sum;
}

NCK_LANES nck_status_t nck_fair_step(nck_fair_t *self) {
    switch (self->task.axes) {
    case 2: work(self, 2); break;
    case 3: work(self, 3); break;
    default: work(self, self->task.axes); break;
    }
    return self->phase == NCK_FAIR_DONE ? NCK_DONE : NCK_OK;
}
