// SPDX-License-Identifier: MIT
// Inside room 4: whether the path is faster with a stop at a junction.
#include "nck/prep/4_lookahead/stop.h"

#include "nck/base/budget.h"                 // NCK_UNLIMITED
#include "nck/base/scurve_math.h"            // nck_scurve_over
#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_…
#include "nck/prep/4_lookahead/zone.h"       // nck_zone_s nck_zone_is_alone NCK_ZONES_CUT

// Time of a junction that is crossed at v, over half of the segs beside it: in its zone the path
// keeps to about that speed.
static double crossing_time(const double half[2], double v, const nck_scurve_t *ramp,
                            double zone_s) {
    double time = 0.0;
    for (int n = 0; n < 2; n++) {
        const double zone = nck_min(half[n], v * zone_s);
        time += zone / v + nck_scurve_over(ramp, v, half[n] - zone);
    }
    return time;
}

// Whether the path, under a jerk limit, is faster with a stop at a junction. A blunt one is crossed
// as fast as a ramp from rest gets over half a seg, v³ = j·l².
static int is_slow(const nck_junction_t *in, const nck_junction_t *out, double load,
                   const nck_terms_t *terms) {
    const double period = terms->machine->period_s;
    const double half[2] = {0.5 * in->length, 0.5 * out->length};
    const nck_scurve_t ramp = {nck_min(in->a_most, out->a_most),
                             nck_min(in->j_straight, out->j_straight),
                             nck_min(in->v_free, out->v_free)};
    const double most = NCK_CORNER_SHARE_DENSE * period / load;
    const double v = most - terms->v_filter;
    if (most >= ramp.v_max) return 0;
    if (!(v > 0.0)) return 1;
    if (v * v * v >= ramp.j * nck_max(half[0] * half[0], half[1] * half[1])) return 0;
    const double stop = nck_scurve_over(&ramp, 0.0, half[0]) + nck_scurve_over(&ramp, 0.0, half[1])
                        + 2.0 * terms->mix_s + period;
    return stop < crossing_time(half, v, &ramp, nck_zone_s(terms));
}

// All over segs that are too short to be cut at the zones of the programmed speed, a crossing
// leaves half of the acceleration. A stop costs a period at most.
int nck_stop_is_faster(const nck_junction_t *in, const nck_junction_t *out, double load, double v,
                       const nck_machine_t *machine) {
    const nck_junction_t *junction[2];
    junction[0] = in;
    junction[1] = out;
    const double period = machine->period_s;
    const double share = v * load / period;
    double stop = period;
    double crossing = 0.0;
    for (int n = 0; n < 2; n++) {
        const nck_scurve_t all = {junction[n]->a_most, NCK_UNLIMITED, junction[n]->v_max};
        const nck_scurve_t left = {(1.0 - share) * all.a, NCK_UNLIMITED, all.v_max};
        const double half = 0.5 * junction[n]->length;
        const double zone = junction[n]->v_max * period;
        stop += nck_scurve_over(&all, 0.0, half);
        if (half > NCK_ZONES_CUT * zone) return 0;
        crossing += nck_scurve_over(&left, v, half);
    }
    return stop < crossing;
}

int nck_stop_pays_jerk(const nck_junction_t *in, const nck_junction_t *out, double load,
                       const nck_terms_t *terms) {
    const double a = nck_min(in->a_most, out->a_most);
    const double a_there = nck_min(a, terms->j_max * nck_zone_s(terms));
    if (nck_zone_is_alone(in, out, load, terms) && nck_corner_sharp(load, a_there)) return 1;
    return is_slow(in, out, load, terms);
}
