// SPDX-License-Identifier: MIT
// Caps of b: rows of one node each, which nothing breaks or, SOFT, at a price.
#include "nck/base/motion_math.h" // nck_num_max
#include "nck/base/motion_rows.h" // nck_motion_t

// Room of a cap that nothing gives way to, and 1/slack, as of any other row.
typedef struct cap {
    nck_num room, per;
    int is_broken;
} cap_t;

static cap_t cap_of(const nck_motion_t *self, int k) {
    const nck_num least = self->iteration > 0 ? NCK_MOTION_ROOM_MIN : self->room;
    cap_t cap;
    cap.room = (self->cap[k + 1] - self->b[k + 1]) * self->scale[k + 1];
    cap.is_broken = cap.room <= least;
    cap.per = cap.is_broken ? self->work->cap_z[k + 1] * self->slack_per : NCK_NUM_OF(1) / cap.room;
    return cap;
}

// Slack s = room + e, multipliers z of it and y = price − z of the excess e: s z = e y = μ. Of
// either pair one is small and the other is not, so all four are kept, to all of their digits.
typedef struct soft_cap {
    nck_num room, s, e, z, y, weight;
} soft_cap_t;

static soft_cap_t soft_cap_of(const nck_motion_t *self, int k) {
    soft_cap_t cap;
    cap.room = (self->cap[k + 1] - self->b[k + 1]) * self->scale[k + 1];
    cap.e = self->work->excess[k + 1];
    cap.s = self->work->slack[k + 1];
    cap.z = self->work->cap_z[k + 1];
    cap.y = self->work->cap_y[k + 1];
    cap.weight = NCK_NUM_OF(1) / (cap.s / cap.z + cap.e / cap.y);
    return cap;
}

int nck_motion_is_soft(const nck_motion_t *self, int k) {
    const int is_firm = (self->wish.ends & NCK_MOTION_FIRM_END) && k == self->wish.nodes - 2;
    return (self->wish.ends & NCK_MOTION_SOFT) && !is_firm;
}

// What a cap's unit costs, over τ: price/c^(3/2) for each 1 of b beyond the cap c. By itself it
// wins half of 1/c^(3/2): a cell lasts τ/√b.
static nck_num price_of(const nck_motion_t *self, int k) {
    const nck_num cap = self->cap[k + 1];
    return self->price / (self->scale[k + 1] * cap * NCK_NUM_SQRT(cap));
}

static void seed_cap(nck_motion_t *self, int k) {
    const nck_num room = (self->cap[k + 1] - self->b[k + 1]) * self->scale[k + 1];
    const nck_num slack = nck_num_max(room, self->room);
    const nck_num z = self->mu_was / slack;
    if (!nck_motion_is_soft(self, k)) {
        self->work->cap_z[k + 1] = z;
        return;
    }
    const nck_num half = NCK_NUM_OF(0.5) * price_of(self, k);
    self->work->cap_z[k + 1] = z < half ? z : half;
    self->work->cap_y[k + 1] = NCK_NUM_OF(2) * half - self->work->cap_z[k + 1];
    self->work->excess[k + 1] = nck_num_max(slack - room, self->mu_was / self->work->cap_y[k + 1]);
    self->work->slack[k + 1] = room + self->work->excess[k + 1];
}

static void assemble_cap(nck_motion_t *self, int k) {
    const cap_t cap = cap_of(self, k);
    const nck_num scale = self->scale[k + 1];
    const nck_num z = self->work->cap_z[k + 1];
    const nck_num weight = z * cap.per;
    self->work->g[k + 1] += scale * self->mu * cap.per;
    if (cap.is_broken) self->work->g[k + 1] += scale * (z - weight * cap.room);
    self->work->h0[k + 1] += scale * scale * weight;
    self->sums.gone[0] += cap.is_broken ? self->mu_was : cap.room * z;
    self->sums.most[0] = nck_num_max(self->sums.most[0], NCK_NUM_OF(1) - cap.room);
}

static void assemble_soft_cap(nck_motion_t *self, int k) {
    const soft_cap_t cap = soft_cap_of(self, k);
    const nck_num scale = self->scale[k + 1];
    const nck_num apart = self->mu / cap.z - self->mu / cap.y;
    self->work->g[k + 1] += scale * (cap.z + cap.weight * (apart - cap.room));
    self->work->h0[k + 1] += scale * scale * cap.weight;
    self->sums.gone[0] += cap.s * cap.z + cap.e * cap.y;
    self->sums.paid[0] += (cap.z + cap.y) * cap.e;
}

static void direct_cap(nck_motion_t *self, int k) {
    const cap_t cap = cap_of(self, k);
    const nck_num rise = self->scale[k + 1] * self->work->step_b[k + 1];
    const nck_num z = self->work->cap_z[k + 1];
    nck_num now = (self->mu + z * rise) * cap.per;
    if (cap.is_broken) now += z - z * cap.room * cap.per;
    if (!cap.is_broken) self->sums.up[0] = nck_num_max(self->sums.up[0], rise * cap.per);
    self->sums.back[0] = nck_num_max(self->sums.back[0], -now - z);
    self->work->cap_z[k + 1] = nck_motion_renewed(now, z);
}

// Multipliers of a cap at a price, z + y = price: the smaller one is kept to all of its digits.
static void renew_soft_cap(nck_motion_t *self, int k, nck_num dz) {
    nck_num *const cap_z = &self->work->cap_z[k + 1];
    nck_num *const cap_y = &self->work->cap_y[k + 1];
    const nck_num z = *cap_z;
    const nck_num y = *cap_y;
    const nck_num price = z + y;
    *cap_z = nck_num_max(z + dz, NCK_FALL * z);
    *cap_y = nck_num_max(y - dz, NCK_FALL * y);
    if (z + dz < NCK_FALL * z) *cap_y = price - *cap_z;
    if (y - dz < NCK_FALL * y) *cap_z = price - *cap_y;
    self->sums.back[0] = nck_num_max(self->sums.back[0],
                                nck_num_max(-dz - NCK_NUM_OF(2) * z, dz - NCK_NUM_OF(2) * y));
}

static void direct_soft_cap(nck_motion_t *self, int k) {
    const soft_cap_t cap = soft_cap_of(self, k);
    const nck_num rise = self->scale[k + 1] * self->work->step_b[k + 1];
    const nck_num apart = self->mu / cap.z - self->mu / cap.y;
    const nck_num dz = cap.weight * (apart - cap.room + rise);
    const nck_num de = (self->mu + cap.e * dz) / cap.y - cap.e;
    const nck_num ds = de - rise + cap.room + cap.e - cap.s;
    self->sums.up[0] = nck_num_max(self->sums.up[0], nck_num_max(-de / cap.e, -ds / cap.s));
    self->work->step_excess[k + 1] = de;
    self->work->step_slack[k + 1] = ds;
    renew_soft_cap(self, k, dz);
}

// Whether a node has a cap, and one at a price.
static int has_cap(const nck_motion_t *self, int k) {
    return k >= self->cap_low && k <= self->high;
}

nck_num nck_motion_price_of_start(const nck_motion_t *self) {
    nck_num sum = 0;
    for (int k = self->cap_low; k <= self->high; k++) {
        const nck_num excess = (self->b[k + 1] - self->cap[k + 1]) * self->scale[k + 1];
        if (nck_motion_is_soft(self, k) && excess > 0) sum += price_of(self, k) * excess;
    }
    return sum;
}

void nck_motion_seed_caps(nck_motion_t *self, int first) {
    for (int k = first; k < first + NCK_MOTION_LANES; k++) {
        if (has_cap(self, k)) seed_cap(self, k);
    }
}

void nck_motion_assemble_caps(nck_motion_t *self, int first) {
    for (int k = first; k < first + NCK_MOTION_LANES; k++) {
        if (has_cap(self, k) && nck_motion_is_soft(self, k)) assemble_soft_cap(self, k);
        if (has_cap(self, k) && !nck_motion_is_soft(self, k)) assemble_cap(self, k);
    }
}

void nck_motion_direct_caps(nck_motion_t *self, int first) {
    for (int k = first; k < first + NCK_MOTION_LANES; k++) {
        if (has_cap(self, k) && nck_motion_is_soft(self, k)) direct_soft_cap(self, k);
        if (has_cap(self, k) && !nck_motion_is_soft(self, k)) direct_cap(self, k);
    }
}
