// SPDX-License-Identifier: MIT
// Inside room 4: how far around a junction its share of the acceleration is kept free.
#include "nck/prep/4_lookahead/zone.h"

#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_…

// A junction is alone if the segs around it are longer than so many of its zones: then what happens
// between junctions takes longer than what happens at them.
#define ZONES_APART 16.0
double nck_zone_s(const nck_terms_t *terms) { return terms->machine->period_s + terms->mix_s; }

int nck_zone_is_alone(const nck_joint_t *in, const nck_joint_t *out, double load,
                      const nck_terms_t *terms) {
    const double time = nck_zone_s(terms);
    const double v =
        nck_corner_speed_alone(NCK_CORNER_SHARE_DENSE, load, terms->machine->period_s);
    const double zone = (v + 0.5 * nck_max(in->a_most, out->a_most) * time) * time;
    return nck_min(in->length, out->length) > ZONES_APART * zone;
}

// The share where the span is shorter than the zone. Under a jerk limit the seg is slowed until it
// is not (near.h); else the worst is assumed.
static double beyond_span(const nck_lookahead_t *self, double share) {
    return self->terms->limits_jerk ? share : NCK_CORNER_SHARE_MAX;
}

// A walk away from a seg at both paces. No seg takes longer with an override than without: so the
// zone is left at NCK_PACE_OVER last.
typedef struct reach {
    double time[NCK_PACES];
    double *share; // by pace
} reach_t;

static void meet(const nck_lookahead_t *self, reach_t *reach, const nck_joint_t *joint) {
    const nck_pace_t *const pace = joint->pace;
    double *const share = reach->share;
    if (reach->time[NCK_PACE_FEED] < self->zone_s) {
        share[NCK_PACE_FEED] = nck_max(share[NCK_PACE_FEED], pace[NCK_PACE_FEED].share);
    }
    share[NCK_PACE_OVER] = nck_max(share[NCK_PACE_OVER], pace[NCK_PACE_OVER].share);
}

// Returns 1 if the zone ends within the joint.
static int pass(const nck_lookahead_t *self, reach_t *reach, const nck_joint_t *joint) {
    for (int k = 0; k < NCK_PACES; k++) reach->time[k] += joint->pace[k].time;
    return reach->time[NCK_PACE_OVER] >= self->zone_s;
}

// No more neighbours are looked at.
static void cut_off(const nck_lookahead_t *self, reach_t *reach) {
    for (int k = 0; k < NCK_PACES; k++) {
        if (reach->time[k] < self->zone_s) reach->share[k] = beyond_span(self, reach->share[k]);
    }
}

void nck_zone_shares_before(nck_lookahead_t *self, uint32_t count, double share_out[NCK_PACES]) {
    reach_t reach = {{0.0, 0.0}, share_out};
    share_out[NCK_PACE_FEED] = 0.0;
    share_out[NCK_PACE_OVER] = 0.0;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == 0) return;
        count--;
        const nck_joint_t *const joint = nck_joint_at(self, count);
        if (nck_zone_parts(joint, self->zone_s)) return;
        meet(self, &reach, joint);
        if (pass(self, &reach, joint)) return;
    }
    cut_off(self, &reach);
}

nck_status_t nck_zone_shares_after(nck_lookahead_t *self, uint32_t count,
                                   double share_out[NCK_PACES]) {
    reach_t reach = {{0.0, 0.0}, share_out};
    const nck_joint_t *joint = nck_joint_at(self, count);
    share_out[NCK_PACE_FEED] = 0.0;
    share_out[NCK_PACE_OVER] = 0.0;
    for (uint32_t n = 0; n < NCK_CORNER_SPAN; n++) {
        if (count == self->joint.decided) return NCK_EMPTY;
        meet(self, &reach, joint);
        if (nck_zone_parts(joint, self->zone_s)) return NCK_OK;
        count++;
        if (count == self->joint.head) return self->ended ? NCK_OK : NCK_EMPTY;
        joint = nck_joint_at(self, count);
        if (pass(self, &reach, joint)) return NCK_OK;
    }
    cut_off(self, &reach);
    return NCK_OK;
}
