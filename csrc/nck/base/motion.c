// SPDX-License-Identifier: MIT
// The iteration: objective and caps, the Newton step, how far it is gone, when it is enough.
#include "nck/base/motion.h"

#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/motion_rows.h" // nck_motion_assemble
#include "nck/base/tuning.h"      // NCK_MET NCK_WAY …

// What a step does next. A window goes BEGIN, SEED …, then round by round ASSEMBLE …, SOLVE,
// DIRECT …, GO, until SOLVE finds it good enough; then CHECK ….
enum { BEGIN, SEED, ASSEMBLE, SOLVE, DIRECT, GO, CHECK, END };

// A limit broken by so much is met; so much more may be taken between rows.
#define MET NCK_NUM_OF(NCK_MET)
// A pivot is no smaller than this share of its diagonal: rounding.
#define PIVOT_MIN NCK_NUM_OF(sizeof(nck_num) == 4 ? 1e-7 : 1e-15)
// A free node's b is no less: τ/√b⁵ is a number of either type. Where no motion is within the
// limits, as for a hold that comes too late, step after step would take it to nothing.
#define FREE_MIN NCK_NUM_OF(1e-14)
// Keeps 1/√b finite at a rest.
#define SPEED_MIN NCK_NUM_OF(1e-9)

static nck_num *line_of(nck_num *line) { return line + 1; }

// Beyond its ends a line is even.
static void mirror(nck_num *line, int nodes) {
    line[-1] = line[1];
    line[nodes] = line[nodes - 2];
}

// ---- objective: Σ 2τ/(√b_k + √b_{k+1}), convex in b

static nck_num time_of(const nck_motion_t *self) {
    const nck_num tau = self->tau;
    nck_num time = 0;
    nck_num v = NCK_NUM_SQRT(self->b[1]);
    for (int k = 1; k < self->wish.nodes; k++) {
        const nck_num next = NCK_NUM_SQRT(self->b[k + 1]);
        time += NCK_NUM_OF(2) * tau / (v + next);
        v = next;
    }
    return time;
}

// Derivatives of a chunk's cells by b at their ends v², v1²: −τ/((v + v1)²v) …
static void add_time(nck_motion_t *self, int chunk) {
    const int first = chunk * NCK_MOTION_LANES + 1;
    nck_motion_lanes_t here, behind, before2, cross2, behind2;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const int is_cell = chunk * NCK_MOTION_LANES + k < self->wish.nodes - 1;
        const nck_num tau = (nck_num)is_cell * self->tau;
        const nck_num v = NCK_NUM_SQRT(self->b[first + k]) + SPEED_MIN;
        const nck_num v1 = NCK_NUM_SQRT(self->b[first + k + 1]) + SPEED_MIN;
        const nck_num per = NCK_NUM_OF(1) / (v + v1);
        const nck_num per_v = NCK_NUM_OF(1) / v;
        const nck_num per_v1 = NCK_NUM_OF(1) / v1;
        const nck_num force = tau * per * per;
        const nck_num curve = force * per;
        here[k] = -force * per_v;
        behind[k] = -force * per_v1;
        before2[k] = NCK_NUM_OF(0.5) * curve * (NCK_NUM_OF(3) * v + v1) * per_v * per_v * per_v;
        cross2[k] = curve * per_v * per_v1;
        behind2[k] = NCK_NUM_OF(0.5) * curve * (NCK_NUM_OF(3) * v1 + v) * per_v1 * per_v1 * per_v1;
        self->sums.time[k] += NCK_NUM_OF(2) * tau * per;
    }
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        self->work->g[first + k] += here[k];
        self->work->g[first + k + 1] += behind[k];
        self->work->h0[first + k] += before2[k];
        self->work->h1[first + k] += cross2[k];
        self->work->h0[first + k + 1] += behind2[k];
    }
}

// ---- the Newton step: five diagonals, L D Lᵀ

// Beyond its ends b is even: what rows tell of node −1 is told of node 1.
static void fold(nck_motion_t *self) {
    nck_num *const h0 = line_of(self->work->h0);
    nck_num *const h1 = line_of(self->work->h1);
    nck_num *const h2 = line_of(self->work->h2);
    const int last = self->wish.nodes - 1;
    h0[1] += h0[-1] + NCK_NUM_OF(2) * h2[-1];
    h1[0] += h1[-1];
    h0[last - 1] += h0[last + 1] + NCK_NUM_OF(2) * h2[last - 1];
    h1[last - 1] += h1[last];
    self->work->g[2] += self->work->g[0];
    self->work->g[last] += self->work->g[last + 2];
}

// Factors in place of the matrix: 1/D, and L below it. Where rounding has taken a pivot away its
// node stays in this step.
static void factor(nck_motion_t *self) {
    nck_num *const h0 = line_of(self->work->h0);
    nck_num *const h1 = line_of(self->work->h1);
    nck_num *const h2 = line_of(self->work->h2);
    nck_num *const least = line_of(self->work->step_b);
    for (int k = self->wish.fixed; k < self->free_end; k++) least[k] = PIVOT_MIN * h0[k];
    for (int k = self->wish.fixed; k < self->free_end; k++) {
        const nck_num per = h0[k] > least[k] ? NCK_NUM_OF(1) / h0[k] : NCK_NUM_OF(0);
        const nck_num one = h1[k] * per;
        const nck_num two = h2[k] * per;
        h0[k + 1] -= one * h1[k];
        h1[k + 1] -= one * h2[k];
        h0[k + 2] -= two * h2[k];
        h0[k] = per;
        h1[k] = one;
        h2[k] = two;
    }
}

// L D Lᵀ step = −gradient; nodes that are not free stay.
static void substitute(nck_motion_t *self) {
    const nck_num *const h0 = line_of(self->work->h0);
    const nck_num *const h1 = line_of(self->work->h1);
    const nck_num *const h2 = line_of(self->work->h2);
    nck_num *const x = line_of(self->work->step_b);
    const int low = self->wish.fixed;
    const int end = self->free_end;
    memset(self->work->step_b, 0, sizeof self->work->step_b);
    for (int k = low; k < end; k++) x[k] = -self->work->g[k + 1];
    for (int k = low; k < end; k++) {
        if (k + 1 < end) x[k + 1] -= h1[k] * x[k];
        if (k + 2 < end) x[k + 2] -= h2[k] * x[k];
    }
    for (int k = end - 1; k >= low; k--) {
        x[k] *= h0[k];
        if (k + 1 < end) x[k] -= h1[k] * x[k + 1];
        if (k + 2 < end) x[k] -= h2[k] * x[k + 2];
    }
    mirror(x, self->wish.nodes);
}

// ---- sums, in lanes

static nck_num sum_of(const nck_num *lanes) {
    nck_num sum = 0;
    for (int k = 0; k < NCK_MOTION_LANES; k++) sum += lanes[k];
    return sum;
}

static nck_num most_of(const nck_num *lanes) {
    nck_num most = 0;
    for (int k = 0; k < NCK_MOTION_LANES; k++) most = nck_num_max(most, lanes[k]);
    return most;
}

static void clear_system(nck_motion_t *self) {
    memset(self->work->h0, 0, sizeof self->work->h0);
    memset(self->work->h1, 0, sizeof self->work->h1);
    memset(self->work->h2, 0, sizeof self->work->h2);
    memset(self->work->g, 0, sizeof self->work->g);
    memset(&self->sums, 0, sizeof self->sums);
}

// ---- what is done in one step each

// 1 if an axis stands in all of the window: it has no rows.
static int stands(const nck_motion_t *self, int axis) {
    for (int k = 1; k <= self->wish.nodes; k++) {
        if (self->p1[axis][k] != 0 || self->p2[axis][k] != 0) return 0;
    }
    return 1;
}

// 1 if what moves could pass a limit of the path within its own: along none of its directions do
// axes have more than the root of their squares' sum.
static int may_pass(const nck_motion_t *self) {
    const nck_motion_wish_t *const wish = &self->wish;
    double aa = 0.0;
    double jj = 0.0;
    for (int n = 0; n < self->moving; n++) {
        const int axis = self->axis[n];
        aa += wish->a[axis] * wish->a[axis];
        jj += wish->j[axis] * wish->j[axis];
    }
    return wish->along[0] * wish->along[0] < aa || wish->along[1] * wish->along[1] < jj;
}

static void find_moving(nck_motion_t *self) {
    self->moving = 0;
    for (int axis = 0; axis < self->wish.axes; axis++) {
        if (!stands(self, axis)) self->axis[self->moving++] = (uint8_t)axis;
    }
    self->limited = self->moving;
    if (self->wish.along[0] > 0.0 && may_pass(self)) self->axis[self->limited++] = NCK_MOTION_ALONG;
}

// Beyond its ends the path goes on as it is there; b is even about them.
static void extend(nck_motion_t *self) {
    const int last = self->wish.nodes;
    for (int axis = 0; axis < self->wish.axes; axis++) {
        nck_num *const p2 = self->p2[axis];
        p2[0] = p2[1] - (p2[2] - p2[1]);
        p2[last + 1] = p2[last] + (p2[last] - p2[last - 1]);
    }
    mirror(line_of(self->b), last);
}

static void count_rows(nck_motion_t *self) {
    const int nodes = self->high - self->low + 1;
    const int last = self->wish.nodes - 1;
    const int cells = (self->high < last ? self->high : last - 1) - self->low + 1;
    const int before = self->high - (self->low > 0 ? self->low : 1) + 1;
    const int caps = self->high - self->cap_low + 1;
    const int in_middles = 2 * cells + before;
    const int is_rough = (self->wish.ends & NCK_MOTION_COARSE) != 0;
    const int at_nodes = is_rough ? 0 : NCK_MOTION_ROWS * nodes;
    self->rows = self->limited * (at_nodes + in_middles) + caps;
}

// The next μ: by the gap that will be left, and no smaller than the last one has to be.
static void lower_mu(nck_motion_t *self, nck_num gone) {
    const nck_num broken = self->most - NCK_NUM_OF(1);
    const nck_num last = NCK_AIM * self->gap * (self->time + self->paid);
    const nck_num least = NCK_MOTION_BROKEN * self->time * (broken < 1 ? broken : NCK_NUM_OF(1));
    self->mu = nck_num_max(nck_num_max(NCK_FALL * gone, last), least) / (nck_num)self->rows;
}

static void begin_rounds(nck_motion_t *self) {
    find_moving(self);
    extend(self);
    count_rows(self);
    for (int k = 0; k < self->wish.nodes; k++) {
        const int has_rows = k >= self->low && k <= self->high;
        const int is_cell = k < self->wish.nodes - 1;
        self->on_node[k + 1] = (nck_num)has_rows;
        self->on_cell[k + 1] = (nck_num)is_cell;
    }
    self->time = time_of(self);
    const nck_num all = self->time + nck_motion_price_of_start(self);
    self->mu_was = NCK_MOTION_FIRST * all / (nck_num)self->rows;
    self->slack_per = NCK_NUM_OF(1) / self->mu_was;
    self->most = NCK_NUM_OF(1) + NCK_NUM_OF(2) * MET; // for all that is known
    lower_mu(self, NCK_MOTION_FIRST * all);
    clear_system(self);
}

static int is_met(const nck_motion_t *self) { return self->most <= NCK_NUM_OF(1) + MET; }

static int is_good(const nck_motion_t *self) {
    return self->iteration > 0 && is_met(self)
           && self->gone <= self->gap * (self->time + self->paid) && self->step > NCK_MOTION_WHOLE
           && most_of(self->sums.back) <= 0;
}

static nck_status_t solve(nck_motion_t *self) {
    self->time = sum_of(self->sums.time);
    self->paid = NCK_MOTION_PAID * sum_of(self->sums.paid);
    self->gone = sum_of(self->sums.gone);
    self->most = most_of(self->sums.most);
    if (is_good(self) || self->iteration >= self->wish.most) {
        self->phase = CHECK;
        return NCK_OK;
    }
    fold(self);
    factor(self);
    substitute(self);
    memset(&self->sums, 0, sizeof self->sums);
    self->phase = DIRECT;
    return NCK_OK;
}

// How far the step goes: nearly to the nearest limit, and never near b = 0.
static nck_num step_length(const nck_motion_t *self) {
    const nck_num up = most_of(self->sums.up);
    nck_num step = up > NCK_WAY ? NCK_WAY / up : NCK_NUM_OF(1);
    nck_num down = 0;
    for (int k = self->wish.fixed; k < self->free_end; k++) {
        down = nck_num_max(down, -self->work->step_b[k + 1] / self->b[k + 1]);
    }
    if (down * step > NCK_WAY) step = NCK_WAY / down;
    return step;
}

static void go(nck_motion_t *self) {
    const nck_num step = step_length(self);
    nck_motion_lanes_t back;
    for (int k = self->wish.fixed; k < self->free_end; k++) {
        const nck_num b = self->b[k + 1] + step * self->work->step_b[k + 1];
        self->b[k + 1] = nck_num_max(b, FREE_MIN);
    }
    for (int k = self->cap_low; k <= self->high; k++) {
        self->work->excess[k + 1] += step * self->work->step_excess[k + 1];
        self->work->slack[k + 1] += step * self->work->step_slack[k + 1];
    }
    mirror(line_of(self->b), self->wish.nodes);
    self->step = step;
    const nck_num rows = (nck_num)self->rows;
    self->mu_was = self->mu;
    self->slack_per = NCK_NUM_OF(1) / self->mu;
    lower_mu(self, (NCK_NUM_OF(1) - step) * self->gone + step * self->mu * rows);
    self->iteration++;
    memcpy(back, self->sums.back, sizeof back);
    clear_system(self);
    memcpy(self->sums.back, back, sizeof back);
}

// The end; or, where more than the limits is taken between rows, a few rounds more with reserves.
static nck_status_t finish(nck_motion_t *self) {
    self->found = most_of(self->sums.most);
    const int is_rough = (self->wish.ends & NCK_MOTION_COARSE) != 0;
    const int may_mend = !is_rough && self->iteration < self->wish.most;
    if (may_mend && is_met(self) && self->found > NCK_NUM_OF(1) + MET) {
        self->most = self->found;
        self->step = 0; // rows that are nearly met have to give way all the same
        lower_mu(self, self->gone);
        self->phase = ASSEMBLE;
        clear_system(self);
        return NCK_OK;
    }
    self->phase = END;
    return NCK_DONE;
}

// A chunk of what the phase does; the next phase behind the last one.
static void do_chunk(nck_motion_t *self, int next) {
    const int chunk = self->chunk;
    if (self->phase == SEED) {
        nck_motion_seed(self, chunk);
        nck_motion_seed_caps(self, chunk * NCK_MOTION_LANES);
    }
    if (self->phase == ASSEMBLE) {
        nck_motion_assemble(self, chunk);
        add_time(self, chunk);
        nck_motion_assemble_caps(self, chunk * NCK_MOTION_LANES);
    }
    if (self->phase == DIRECT) {
        nck_motion_direct(self, chunk);
        nck_motion_direct_caps(self, chunk * NCK_MOTION_LANES);
    }
    if (self->phase == CHECK) nck_motion_check(self, chunk);
    self->chunk++;
    if (self->chunk * NCK_MOTION_LANES < self->wish.nodes) return;
    self->chunk = 0;
    self->phase = next;
}

// ---- the door

static int is_in_range(const nck_motion_wish_t *wish) {
    const int is_window = wish->nodes >= 2 && wish->nodes <= NCK_MOTION_NODES;
    const int is_fixed = wish->fixed >= 0 && wish->fixed <= wish->nodes - 2;
    return wish->tau > 0.0 && wish->axes >= 1 && wish->axes <= NCK_AXIS_MAX && is_window && is_fixed
           && wish->gap >= 1e-7 && wish->gap <= 1.0 && wish->room > 0.0;
}

nck_status_t nck_motion_begin(nck_motion_t *self, nck_motion_work_t *work,
                              const nck_motion_wish_t *wish) {
    if (!is_in_range(wish)) return NCK_E_ARGUMENT;
    memset(self, 0, offsetof(nck_motion_t, p1));
    memset(work, 0, offsetof(nck_motion_work_t, z)); // which the first round begins
    for (int axis = 0; axis < wish->axes; axis++) {
        memset(self->p1[axis], 0, sizeof self->p1[axis]);
        memset(self->p2[axis], 0, sizeof self->p2[axis]);
    }
    self->work = work;
    for (int k = 0; k < NCK_MOTION_LINE; k++) self->b[k] = NCK_NUM_OF(1);
    self->wish = *wish;
    self->low = wish->fixed > 0 ? wish->fixed - 1 : 0;
    if (wish->ends & NCK_MOTION_INSIDE) self->low = 1;
    self->high = wish->nodes - (wish->ends & NCK_MOTION_OPEN_END ? 2 : 1);
    self->cap_low = self->low > wish->fixed ? self->low : wish->fixed;
    const int is_free = (wish->ends & (NCK_MOTION_OPEN_END | NCK_MOTION_FREE_END)) != 0;
    self->free_end = wish->nodes - !is_free;
    self->tau = (nck_num)wish->tau;
    self->gap = (nck_num)wish->gap;
    self->room = (nck_num)wish->room;
    self->price = (nck_num)(wish->price * wish->tau);
    for (int axis = 0; axis < wish->axes; axis++) {
        const double a = wish->a[axis];
        self->ratio[axis] = (nck_num)(a / (wish->j[axis] * wish->tau));
        if (wish->v[axis] > 0.0) self->speed[axis] = (nck_num)(2.0 * wish->tau * a / wish->v[axis]);
        if (wish->along[0] > 0.0) self->share[axis] = (nck_num)(a / wish->along[0]);
    }
    if (wish->along[0] > 0.0) {
        self->ratio[NCK_MOTION_ALONG] = (nck_num)(wish->along[0] / (wish->along[1] * wish->tau));
    }
    return NCK_OK;
}

void nck_motion_node(nck_motion_t *self, int k, const nck_num *p1, const nck_num *p2,
                     const nck_num *cap_and_b) {
    const nck_num cap = cap_and_b[0];
    const nck_num b = cap_and_b[1];
    for (int axis = 0; axis < self->wish.axes; axis++) {
        const nck_num a = (nck_num)self->wish.a[axis];
        self->p1[axis][k + 1] = p1[axis] / (NCK_NUM_OF(2) * self->tau * a);
        self->p2[axis][k + 1] = p2[axis] / a;
    }
    self->cap[k + 1] = cap;
    self->b[k + 1] = b;
    self->scale[k + 1] = NCK_NUM_OF(1) / (nck_motion_is_soft(self, k) && b > cap ? b : cap);
}

nck_status_t nck_motion_step(nck_motion_t *self) {
    switch (self->phase) {
    case BEGIN:
        begin_rounds(self);
        self->phase = SEED;
        return NCK_OK;
    case SEED:
        do_chunk(self, ASSEMBLE);
        return NCK_OK;
    case ASSEMBLE:
        do_chunk(self, SOLVE);
        return NCK_OK;
    case SOLVE:
        return solve(self);
    case DIRECT:
        do_chunk(self, GO);
        return NCK_OK;
    case GO:
        go(self);
        self->phase = ASSEMBLE;
        return NCK_OK;
    case CHECK:
        do_chunk(self, END);
        return self->phase == END ? finish(self) : NCK_OK;
    default:
        return NCK_DONE;
    }
}

uint32_t nck_motion_price(const nck_motion_t *self) {
    static const uint8_t pass[][2] = {{55, 0}, {12, 6}, {24, 18}, {107, 0}, {16, 16}, {27, 0},
                                      {20, 54}, {0, 0}}; // as it is, and for each axis
    static const uint8_t rough[][2] = {{19, 9}, {13, 8}};
    const int is_rough = (self->wish.ends & NCK_MOTION_COARSE) != 0;
    const uint8_t *price = pass[self->phase];
    if (is_rough && self->phase == ASSEMBLE) price = rough[0];
    if (is_rough && self->phase == DIRECT) price = rough[1];
    return price[0] + price[1] * (uint32_t)self->limited;
}

nck_num nck_motion_b(const nck_motion_t *self, int k) { return self->b[k + 1]; }

void nck_motion_told(const nck_motion_t *self, nck_motion_told_t *told_out) {
    told_out->iterations = self->iteration;
    told_out->time = (double)self->time;
    told_out->least = 1.0 - (double)self->most;
    told_out->gap = (double)(self->gone / self->time);
    told_out->share = (double)self->found;
}
