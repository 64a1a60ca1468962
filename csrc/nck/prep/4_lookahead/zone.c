// SPDX-License-Identifier: MIT
// Inside room 4: how far around a junction its share of the acceleration is kept free.
#include "nck/prep/4_lookahead/zone.h"

#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_…

// A junction is alone if the segs around it are longer than so many of its zones: then what happens
// between junctions takes longer than what happens at them.
#define ZONES_APART 16.0

double nck_zone_s(const nck_terms_t *terms) { return terms->machine->period_s + terms->mix_s; }

int nck_zone_is_alone(const nck_junction_t *in, const nck_junction_t *out, double load,
                      const nck_terms_t *terms) {
    const double time = nck_zone_s(terms);
    const double v = nck_corner_speed_alone(NCK_CORNER_SHARE_DENSE, load, terms->machine->period_s);
    const double zone = (v + 0.5 * nck_max(in->a_most, out->a_most) * time) * time;
    return nck_min(in->length, out->length) > ZONES_APART * zone;
}
