// SPDX-License-Identifier: MIT
// Splines in the plane of X and Y: rational B-splines with knots 0 … 0 1 2 … m … m, cut into
// chords that keep to the chord tolerance. G5 and G5.1 are those of one span; those of G6.2 have
// knots of their own, and Z.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume_places nck_decode_block …
#include "nck/prep/1_decode/number/number.h" // nck_decode_length_word nck_decode_letter …
#include "nck/prep/1_decode/place/place.h" // nck_decode_target nck_layout_way
#include "nck/base/real.h" // nck_floor nck_min nck_max nck_sqrt nck_rounded nck_real_of

#include <string.h> // memcpy memset

enum { DEFAULT_ORDER = 3, HALVINGS = 24, SAMPLES = 4 };

// A point times its weight [mm], and the weight.
typedef struct weighted {
    double x, y, z, w;
} weighted_t;

// ---- the curve

// Knot i of n + 1 points.
static double knot(const nck_decode_t *self, uint32_t i) {
    const nck_spline_t *const spline = &self->held.spline;
    const uint32_t k = spline->order;
    const uint32_t n = spline->points - 1;
    if (spline->knots != 0) return self->held.contour.element[i].centre_mm[NCK_SPLINE_KNOT];
    return i < k ? 0.0 : i <= n ? (double)(i - k + 1) : (double)(n - k + 2);
}

static double parameter_end(const nck_decode_t *self) {
    return knot(self, self->held.spline.points);
}

// The span of a parameter: from knot j, which is less than the one behind it.
static uint32_t span_of(const nck_decode_t *self, double u) {
    const nck_spline_t *const spline = &self->held.spline;
    const double last = (double)(spline->points - spline->order);
    uint32_t j = spline->order - 1;
    if (spline->knots == 0) return (uint32_t)nck_min(nck_floor(u), last) + j;
    while (j + 1 < spline->points && knot(self, j + 1) <= u) j++;
    return j;
}

// De Boor's algorithm on weighted points: from their places in the machine to one.
static void point_at(const nck_decode_t *self, double u, double *at) {
    const nck_spline_t *const spline = &self->held.spline;
    const nck_element_t *const element = self->held.contour.element;
    const uint32_t k = spline->order;
    const uint32_t j = span_of(self, u);
    weighted_t d[NCK_SPLINE_ORDER_MOST];
    memset(d, 0, sizeof d);
    for (uint32_t r = 0; r < k; r++) {
        const nck_element_t *const point = &element[j - k + 1 + r];
        const double w = point->sweep_rad;
        d[r] = (weighted_t){w * nck_real_of(point->to_nm[0]), w * nck_real_of(point->to_nm[1]),
                            w * point->centre_mm[NCK_SPLINE_Z], w};
    }
    for (uint32_t l = 1; l < k; l++) {
        for (uint32_t r = k - 1; r >= l; r--) {
            const uint32_t i = j - k + 1 + r;
            const double low = knot(self, i);
            const double a = (u - low) / (knot(self, i + k - l) - low);
            d[r].x = (1.0 - a) * d[r - 1].x + a * d[r].x;
            d[r].y = (1.0 - a) * d[r - 1].y + a * d[r].y;
            d[r].z = (1.0 - a) * d[r - 1].z + a * d[r].z;
            d[r].w = (1.0 - a) * d[r - 1].w + a * d[r].w;
        }
    }
    at[0] = d[k - 1].x / d[k - 1].w;
    at[1] = d[k - 1].y / d[k - 1].w;
    at[2] = d[k - 1].z / d[k - 1].w;
}

// How far a point is from a chord [nm].
static double beside(const double *a, const double *b, const double *point) {
    const double dx = b[0] - a[0], dy = b[1] - a[1], dz = b[2] - a[2];
    const double x = point[0] - a[0], y = point[1] - a[1], z = point[2] - a[2];
    const double dd = dx * dx + dy * dy + dz * dz;
    const double way = x * dx + y * dy + z * dz;
    const double share = dd > 0.0 ? nck_max(0.0, nck_min(1.0, way / dd)) : 0.0;
    const double px = x - share * dx, py = y - share * dy, pz = z - share * dz;
    return nck_sqrt(px * px + py * py + pz * pz);
}

// Is the curve from u to v no further from its chord than the tolerance?
static int is_flat(const nck_decode_t *self, double u, double v) {
    const double tolerance_nm = self->machine->path.chord_error * 1e6;
    double a[3], b[3], point[3];
    point_at(self, u, a);
    point_at(self, v, b);
    for (int k = 1; k < SAMPLES; k++) {
        point_at(self, u + (v - u) * (double)k / (double)SAMPLES, point);
        if (beside(a, b, point) > tolerance_nm) return 0;
    }
    return 1;
}

// The end of the next chord: it does not pass a knot.
static double step_on(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    const double at = spline->at;
    const double next = knot(self, span_of(self, at) + 1);
    const double span = next - at;
    double step = nck_min(spline->step, span);
    for (int k = 0; k < HALVINGS && !is_flat(self, at, at + step); k++) step *= 0.5;
    spline->step = 2.0 * step;
    return step < span && at + step > at ? at + step : next;
}

static void place_of_last(const nck_decode_t *self, int64_t *place_nm) {
    const nck_element_t *const last = &self->held.contour.element[self->held.spline.points - 1];
    memcpy(place_nm, last->to_nm, sizeof last->to_nm);
    if (self->held.spline.knots != 0) place_nm[2] = (int64_t)last->centre_mm[NCK_SPLINE_Z];
}

static nck_status_t chord(nck_decode_t *self, nck_block_t *out) {
    nck_spline_t *const spline = &self->held.spline;
    int64_t last_nm[3];
    double at[3];
    place_of_last(self, last_nm);
    spline->at = step_on(self);
    spline->works = spline->at < parameter_end(self);
    point_at(self, spline->at, at);
    const unsigned axes = spline->knots != 0 ? 3 : 2; // only knots of G6.2 lead Z
    nck_status_t status = NCK_OK;
    for (unsigned axis = 0; axis < axes && status == NCK_OK; axis++) {
        const int64_t place_nm = spline->works ? nck_rounded(at[axis]) : last_nm[axis];
        self->place.position_nm[axis] = place_nm;
        status = nck_decode_travel(self, axis, place_nm);
    }
    if (status != NCK_OK) {
        spline->works = 0;
        place_of_last(self, self->place.position_nm);
    }
    if (!spline->works) spline->points = 0;
    if (status != NCK_OK) return status;
    nck_decode_block(self, NCK_BLOCK_LINE, out);
    out->feed = spline->feed;
    return NCK_OK;
}

// ---- words

static void add_point(nck_decode_t *self, const int64_t *place_nm, double weight) {
    nck_spline_t *const spline = &self->held.spline;
    nck_element_t *const point = &self->held.contour.element[spline->points];
    point->to_nm[0] = place_nm[0];
    point->to_nm[1] = place_nm[1];
    point->centre_mm[NCK_SPLINE_Z] = 0.0;
    point->sweep_rad = weight;
    spline->points++;
}

// A point beside another by two words. Missing ones are 0.
static nck_status_t add_beside(nck_decode_t *self, const int64_t *from_nm, char x, char y) {
    int64_t place_nm[2] = {0, 0};
    nck_status_t status = NCK_OK;
    if (nck_has_word(self, x)) status = nck_decode_length_word(self, x, &place_nm[0]);
    if (status == NCK_OK && nck_has_word(self, y)) {
        status = nck_decode_length_word(self, y, &place_nm[1]);
    }
    double way[2] = {nck_real_of(place_nm[0]), nck_real_of(place_nm[1])};
    if (self->layout.on != 0) (void)nck_layout_way(self, way);
    for (unsigned k = 0; k < 2; k++) place_nm[k] = from_nm[k] + nck_rounded(way[k]);
    add_point(self, place_nm, 1.0);
    return status;
}

// In X and Y, and nothing else moves.
static nck_status_t read_target(nck_decode_t *self, int64_t *target_nm) {
    const uint32_t others = self->words.axes & ~3u;
    if (self->modal.plane != 17) {
        return nck_motion_fail(self, NCK_E_SPLINE, 'G', self->modal.plane, 17.0);
    }
    if (others != 0) {
        unsigned axis = 2;
        while (!(others >> axis & 1u)) axis++;
        return nck_motion_fail(self, NCK_E_SPLINE, nck_decode_letter(axis), 0.0, 0.0);
    }
    nck_decode_assume_places(self);
    return nck_decode_target(self, 0, target_nm);
}

static nck_status_t need(nck_decode_t *self, char a, char b) {
    const char missing = !nck_has_word(self, a) ? a : b;
    if (nck_has_word(self, a) && nck_has_word(self, b)) return NCK_OK;
    return nck_motion_fail(self, NCK_E_WORD_MISSING, missing,
                           self->words.code[NCK_STEP_MOTION] / 10.0, 0.0);
}

// All points are said: the first chord can be made.
static nck_status_t begin(nck_decode_t *self, uint32_t order) {
    nck_spline_t *const spline = &self->held.spline;
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = nck_decode_cutting_feed(self, 0, &spline->feed);
    if (status != NCK_OK) {
        place_of_last(self, self->place.position_nm);
        spline->points = 0;
        return status;
    }
    spline->order = order;
    spline->at = knot(self, order - 1);
    spline->step = parameter_end(self) - spline->at;
    spline->works = 1;
    return NCK_OK;
}

// G5: I J from the start, P Q from the end; without I and J it goes on as the G5 before.
static nck_status_t cubic(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    const int goes_on = !nck_has_word(self, 'I') && !nck_has_word(self, 'J');
    const int64_t *const from_nm = self->place.position_nm;
    int64_t target_nm[NCK_AXIS_MAX];
    spline->points = 0;
    nck_status_t status = need(self, 'P', 'Q');
    if (status == NCK_OK) status = read_target(self, target_nm);
    if (status != NCK_OK) return status;
    add_point(self, from_nm, 1.0);
    if (goes_on && spline->follows) {
        const int64_t place_nm[2] = {from_nm[0] + spline->tangent_nm[0],
                                     from_nm[1] + spline->tangent_nm[1]};
        add_point(self, place_nm, 1.0);
    } else {
        status = add_beside(self, from_nm, 'I', 'J');
    }
    if (status == NCK_OK) status = add_beside(self, target_nm, 'P', 'Q');
    if (status != NCK_OK) return status;
    const nck_element_t *const control = &self->held.contour.element[spline->points - 1];
    spline->tangent_nm[0] = target_nm[0] - control->to_nm[0];
    spline->tangent_nm[1] = target_nm[1] - control->to_nm[1];
    add_point(self, target_nm, 1.0);
    return begin(self, 4);
}

static nck_status_t read_order(nck_decode_t *self, int first) {
    int64_t order = first ? DEFAULT_ORDER : (int64_t)self->held.spline.order;
    const nck_status_t status = nck_decode_whole(self, 'L', NCK_SPLINE_ORDER_MOST, order, &order);
    self->held.spline.order = (uint32_t)order;
    if (status != NCK_OK || order >= 2) return status;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'L', (double)order,
                                NCK_SPLINE_ORDER_MOST);
}

static nck_status_t check_weight(nck_decode_t *self, double weight) {
    const nck_status_t status = need(self, 'P', 'P');
    if (status != NCK_OK || (weight > 0.0 && weight <= (double)NCK_LINEAR_MAX_MM)) return status;
    return nck_decode_fail_range(self, 'P', NCK_LINEAR_MAX_MM);
}

// G5.2, and the lines behind it: a control point of the weight P. The first one is where the tool
// stands; P alone is its weight. L: the order.
static nck_status_t control_point(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    const double weight = nck_word_real(self, 'P');
    const int first = spline->points == 0;
    int64_t target_nm[NCK_AXIS_MAX];
    const int moves = (self->words.axes & 3u) != 0;
    nck_status_t status = read_order(self, first);
    if (status == NCK_OK) status = check_weight(self, weight);
    if (status == NCK_OK && moves) status = need(self, 'X', 'Y');
    if (status == NCK_OK) status = read_target(self, target_nm);
    if (status != NCK_OK) return status;
    if (spline->points + 2 > NCK_CONTOUR) {
        return nck_motion_fail(self, NCK_E_CONTOUR_FULL, 0, NCK_CONTOUR, NCK_CONTOUR);
    }
    if (first) {
        nck_spline_begins(self);
        add_point(self, self->place.position_nm, moves ? 1.0 : weight);
    }
    if (moves) add_point(self, target_nm, weight);
    return NCK_OK;
}

static nck_status_t end(nck_decode_t *self) {
    const nck_spline_t *const spline = &self->held.spline;
    if (spline->points == 0) return nck_motion_fail(self, NCK_E_SPLINE, 'G', 5.3, 0.0);
    if (spline->points < spline->order) {
        return nck_motion_fail(self, NCK_E_SPLINE, 'L', spline->points, spline->order);
    }
    return begin(self, spline->order);
}

static nck_status_t knots(nck_decode_t *self) {
    const nck_status_t status = nck_decode_knots(self);
    return status == NCK_DONE ? begin(self, self->held.spline.order) : status;
}

static nck_status_t read_spline(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    const int refused = self->modal.motion == NCK_MOTION_REFUSED;
    self->modal.motion = code == NCK_MOTION_NURBS_END ? NCK_MOTION_NONE : code;
    if (code == NCK_MOTION_KNOTS) return knots(self);
    spline->knots = 0;
    if (code == NCK_MOTION_NURBS) return control_point(self);
    if (code == NCK_MOTION_NURBS_END) return refused && spline->points == 0 ? NCK_OK : end(self);
    if (self->words.axes == 0) {
        return nck_motion_fail(self, NCK_E_WORD_MISSING, 'X', code / 10.0, 0.0);
    }
    if (code == NCK_MOTION_CUBIC) return cubic(self);
    // G5.1: I J from the start.
    int64_t target_nm[NCK_AXIS_MAX];
    self->held.spline.points = 0;
    nck_status_t status = need(self, 'I', 'J');
    if (status == NCK_OK) status = read_target(self, target_nm);
    if (status != NCK_OK) return status;
    add_point(self, self->place.position_nm, 1.0);
    status = add_beside(self, self->place.position_nm, 'I', 'J');
    if (status != NCK_OK) return status;
    add_point(self, target_nm, 1.0);
    return begin(self, 3);
}

nck_status_t nck_decode_spline(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    nck_spline_t *const spline = &self->held.spline;
    const int cubic_now = self->words.code[NCK_STEP_MOTION] == NCK_MOTION_CUBIC;
    nck_status_t status = spline->works ? NCK_OK : read_spline(self);
    spline->follows = 0u;
    if (cubic_now && status == NCK_OK) spline->follows = 1u;
    if (status == NCK_OK) status = spline->works ? chord(self, out) : NCK_EMPTY;
    if (status < NCK_OK) {
        memset(spline, 0, sizeof *spline);
        if (self->modal.motion != NCK_MOTION_NONE) self->modal.motion = NCK_MOTION_REFUSED;
    }
    if (spline->works) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
