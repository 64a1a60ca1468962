// SPDX-License-Identifier: MIT
// prep/5_slope/profile.h on random ladders: caps, acceleration and rule R hold, every profile ends
// at rest, steps of any size give the same bits, and higher caps are not slower.
#include <math.h>   // pow sqrt fmin
#include <string.h> // memcmp

#include "check.h"
#include "nck/base/limits.h"          // NCK_HAS_BEST
#include "nck/prep/5_slope/profile.h" // nck_profile_t

enum { CELLS = 300, CASES = 3000, WORK = 27 * CELLS };

// Rule R is met to this share of the acceleration limit: rounding of vv over short cells.
#define RULE_TOLERANCE 1e-6
// The method is near-optimal, not optimal: higher caps may cost so much time. Seen: 2 %.
#define SLOWER_MOST 0.05

typedef struct ladder {
    nck_profile_t profile;
    double h[CELLS], vv_cap[CELLS + 1], a_max[CELLS], j_max[CELLS], vv[CELLS + 1], s[CELLS + 1];
    double up[CELLS], down[CELLS], e[CELLS + 1], z[CELLS + 1], j[CELLS + 1];
    uint32_t stack[CELLS + 1];
} ladder_t;

static ladder_t ladder;
static uint64_t seed;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static double random_real(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static void bind(ladder_t *self)
{
    nck_profile_t *const p = &self->profile;
    memset(p, 0, sizeof *p);
    p->h = self->h;
    p->vv_cap = self->vv_cap;
    p->a_max = self->a_max;
    p->j_max = self->j_max;
    p->vv = self->vv;
    p->s = self->s;
    p->up = self->up;
    p->down = self->down;
    p->e = self->e;
    p->z = self->z;
    p->j = self->j;
    p->stack = self->stack;
}

// A walk of cap, A and J, with steps of up to ten times; stops inside in one case of three.
static void draw_ladder(ladder_t *self, uint64_t first_seed)
{
    seed = (first_seed + 1u) * 0x9e3779b97f4a7c15u;
    bind(self);
    nck_profile_t *const p = &self->profile;
    p->n = 3 + (uint32_t)((CELLS - 3) * random_real());
    p->count = p->n;
    p->q_cap = 1e-3 * (0.5 + random_real());
    double cap = 50.0;
    double a = 1000.0;
    double j = 20000.0;
    const double change = random_real() < 0.3 ? 0.0 : 0.1;
    const double stops = random_real() < 0.3 ? 0.02 : 0.0;
    for (uint32_t i = 0; i < p->n; i++) {
        if (random_real() < change) cap = 0.5 * pow(200.0, random_real());
        if (random_real() < change) a = 200.0 * pow(10.0, random_real());
        if (random_real() < change) j = 5000.0 * pow(10.0, random_real());
        const int rests = i > 1 && random_real() < stops && self->vv_cap[i - 1] > 0.0;
        self->h[i] = cap * p->q_cap * (0.05 + random_real());
        self->vv_cap[i] = rests ? 0.0 : cap * cap;
        self->a_max[i] = a;
        self->j_max[i] = j;
    }
    self->vv_cap[p->n - 1] = fmax(self->vv_cap[p->n - 1], 1.0);
    self->vv_cap[p->n] = 0.0;
}

static void plan(ladder_t *self, uint32_t budget)
{
    nck_profile_begin(&self->profile);
    for (uint32_t n = 0; n < WORK && nck_profile_step(&self->profile, budget) == NCK_OK; n++) {
        continue;
    }
}

static double share_of(const ladder_t *self, uint32_t i)
{
    const double v_sum = sqrt(self->vv[i]) + sqrt(self->vv[i + 1]);
    const double q_cap = self->profile.q_cap;
    return 0.5 * fmin(q_cap, v_sum > 0.0 ? 2.0 * self->h[i] / v_sum : q_cap);
}

static double a_of(const ladder_t *self, uint32_t i)
{
    return (self->vv[i + 1] - self->vv[i]) / (2.0 * self->h[i]);
}

// Caps, acceleration, rule R at inner nodes that are passed, rest at the end.
static int holds(const ladder_t *self)
{
    const uint32_t n = self->profile.n;
    int good = self->vv[n] == 0.0;
    for (uint32_t i = 0; i < n; i++) {
        const double a = a_of(self, i);
        const double slack = RULE_TOLERANCE * self->a_max[i];
        good = good && self->vv[i] >= 0.0 && self->vv[i] <= self->vv_cap[i];
        good = good && fabs(a) <= self->a_max[i] + slack;
        if (i == 0 || !(self->vv[i] > 0.0)) continue;
        const double j = fmin(self->j_max[i - 1], self->j_max[i]);
        const double most = j * (share_of(self, i - 1) + share_of(self, i));
        good = good && fabs(a - a_of(self, i - 1)) <= most + slack;
    }
    return good;
}

static double time_of(const ladder_t *self)
{
    double time = 0.0;
    for (uint32_t i = 0; i < self->profile.n; i++) {
        time += 2.0 * self->h[i] / (sqrt(self->vv[i]) + sqrt(self->vv[i + 1]));
    }
    return time;
}

static void profile_from_rest_keeps_caps_and_rule_r(check_t *check)
{
    for (uint64_t k = 0; k < CASES; k++) {
        draw_ladder(&ladder, k);
        plan(&ladder, 1000000);
        if (!CHECK(check, holds(&ladder))) printf("    case %d\n", (int)k);
        CHECK(check, nck_profile_joins(&ladder.profile));
    }
}

// The rest of the ladder from its node m on, in the state of the plan there.
static void move_on(ladder_t *self, uint32_t m)
{
    nck_profile_t *const p = &self->profile;
    const double q = 2.0 * share_of(self, m - 1);
    p->a = a_of(self, m - 1);
    p->q = q;
    p->v = sqrt(self->vv[m]);
    p->n -= m;
    p->count = p->n;
    memmove(self->h, self->h + m, p->n * sizeof self->h[0]);
    memmove(self->a_max, self->a_max + m, p->n * sizeof self->h[0]);
    memmove(self->j_max, self->j_max + m, p->n * sizeof self->h[0]);
    memmove(self->vv_cap, self->vv_cap + m, (p->n + 1) * sizeof self->h[0]);
}

static int meets_entry(const ladder_t *self)
{
    const nck_profile_t *const p = &self->profile;
    const double most = self->j_max[0] * (0.5 * fmin(p->q, p->q_cap) + share_of(self, 0));
    const int meets_speed = fabs(self->vv[0] - p->v * p->v) <= 1e-9 * p->v * p->v;
    return meets_speed && fabs(a_of(self, 0) - p->a) <= most + RULE_TOLERANCE * self->a_max[0];
}

// Wherever a plan is left it can be taken up again; where that is denied the caller keeps the old
// plan. What is granted must hold.
static void joins_tells_the_truth(check_t *check)
{
    int granted = 0;
    int asked = 0;
    for (uint64_t k = 0; k < CASES; k++) {
        draw_ladder(&ladder, k);
        plan(&ladder, 1000000);
        const uint32_t m = 1 + (uint32_t)((ladder.profile.n - 2) * random_real());
        if (!(ladder.vv[m] > 0.0) || m + 1 >= ladder.profile.n) continue;
        move_on(&ladder, m);
        if (k % 3 == 0) ladder.profile.a = 1000.0 * (random_real() - 0.5);
        plan(&ladder, 1000000);
        const int joins = nck_profile_joins(&ladder.profile);
        if (joins && !CHECK(check, holds(&ladder) && meets_entry(&ladder))) {
            printf("    case %d\n", (int)k);
        }
        asked += k % 3 != 0;
        granted += k % 3 != 0 && joins;
    }
    if (!CHECK(check, granted > 9 * asked / 10)) printf("    %d of %d\n", granted, asked);
}

static void work_in_small_steps_gives_the_same_bits(check_t *check)
{
    static double vv[CELLS + 1];
    const uint32_t budgets[] = {1, 7, 32};
    for (uint64_t k = 0; k < CASES / 10; k++) {
        draw_ladder(&ladder, k);
        plan(&ladder, 1000000);
        const size_t size = (ladder.profile.n + 1) * sizeof vv[0];
        memcpy(vv, ladder.vv, size);
        draw_ladder(&ladder, k);
        plan(&ladder, budgets[k % 3]);
        CHECK(check, memcmp(vv, ladder.vv, size) == 0);
    }
}

static void work_is_bounded(check_t *check)
{
    for (uint64_t k = 0; k < CASES / 10; k++) {
        draw_ladder(&ladder, k);
        nck_profile_begin(&ladder.profile);
        uint32_t units = 0;
        while (nck_profile_step(&ladder.profile, 1) == NCK_OK && units < WORK) units++;
        CHECK(check, units <= 24 * (ladder.profile.n + 1));
    }
}

static void higher_caps_are_not_slower(check_t *check)
{
    double worst = 0.0;
    for (uint64_t k = 0; k < CASES; k++) {
        draw_ladder(&ladder, k);
        plan(&ladder, 1000000);
        const double low = time_of(&ladder);
        draw_ladder(&ladder, k);
        for (uint32_t i = 0; i < ladder.profile.n; i++) ladder.vv_cap[i] *= 1.3;
        plan(&ladder, 1000000);
        worst = fmax(worst, time_of(&ladder) / low - 1.0);
    }
    if (!CHECK(check, worst <= SLOWER_MOST)) printf("    slower by %g\n", worst);
}

// Between two rests a plan turns down at a speed far below that of its first hull's durations. What
// is worth the best comes near to ∛(32·s/J), which a motion takes under jerk alone.
static void between_rests_the_best_is_near_the_optimum(check_t *check)
{
    double time[2];
    for (uint32_t best = 0; best < 2; best++) {
        nck_profile_t *const p = &ladder.profile;
        bind(&ladder);
        p->n = CELLS;
        p->count = best * CELLS;
        p->q_cap = 1.0;
        for (uint32_t i = 0; i < CELLS; i++) {
            const double from_rest = (double)(i < CELLS / 2 ? i : CELLS - 1 - i);
            const double share = pow(from_rest + 1.0, 3.0) - pow(from_rest, 3.0);
            ladder.h[i] = 0.5 * share / pow(CELLS / 2, 3.0);
            ladder.vv_cap[i] = 1e4;
            ladder.a_max[i] = 1000.0;
            ladder.j_max[i] = 10000.0;
        }
        plan(&ladder, 1000000);
        CHECK(check, holds(&ladder));
        time[best] = time_of(&ladder);
    }
    const double least = cbrt(32.0 * 1.0 / 10000.0);
    const int good = time[1] < (NCK_HAS_BEST ? 1.01 : 1.2) * least && time[0] > 1.02 * least;
    if (!CHECK(check, good)) printf("    %g and %g of %g s\n", time[0], time[1], least);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, profile_from_rest_keeps_caps_and_rule_r);
    CHECK_RUN(&check, joins_tells_the_truth);
    CHECK_RUN(&check, work_in_small_steps_gives_the_same_bits);
    CHECK_RUN(&check, work_is_bounded);
    CHECK_RUN(&check, between_rests_the_best_is_near_the_optimum);
    CHECK_RUN(&check, higher_caps_are_not_slower);
    return check_end(&check);
}
