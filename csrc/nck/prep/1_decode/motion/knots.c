// SPDX-License-Identifier: MIT
// Fanuc's G6.2: a rational B-spline whose knots are said.
//
//     G6.2 P K X Y Z R   P: the order (4); the first control point: where the tool stands
//     K X Y Z R          its knot, the point, its weight (1)
//     K                  as many as the order: behind the last one the curve is cut
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume_places nck_decode_fail_step …
#include "nck/prep/1_decode/number/number.h" // nck_decode_letter nck_decode_plain_word …
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/base/real.h" // nck_fabs nck_real_of

#include <string.h> // memcmp memset

enum { FANUC_ORDER = 4, ORDER_LEAST = 2 };

static nck_status_t fail(nck_decode_t *self, nck_status_t code, int letter, double value,
                         double limit) {
    const int at = letter >= 'A' && nck_has_word(self, letter);
    if (at) return nck_decode_fail_word(self, code, letter, value, limit);
    return nck_decode_fail_step(self, code, NCK_STEP_MOTION, letter, value, limit);
}

static double *knot(nck_decode_t *self, uint32_t i) {
    return &self->held.contour.element[i].centre_mm[NCK_SPLINE_KNOT];
}

// A knot or a weight.
static nck_status_t read_plain(nck_decode_t *self, char letter, double *value_out) {
    const nck_status_t status = nck_decode_plain_word(self, letter, value_out);
    if (status != NCK_OK || nck_fabs(*value_out) <= (double)NCK_LINEAR_MAX_MM) return status;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, *value_out, NCK_LINEAR_MAX_MM);
}

// The line of G6.2 itself.
static nck_status_t start(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    int64_t order = FANUC_ORDER;
    memset(spline, 0, sizeof *spline);
    nck_spline_begins(self);
    if (self->modal.incremental) return fail(self, NCK_E_SPLINE, 'G', 91.0, 0.0);
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = nck_decode_whole(self, 'P', FANUC_ORDER, order, &order);
    if (status != NCK_OK) return status;
    if (order < ORDER_LEAST) return fail(self, NCK_E_NUMBER_RANGE, 'P', (double)order, FANUC_ORDER);
    spline->order = (uint32_t)order;
    spline->axes = self->words.axes;
    if (spline->axes == 0) return fail(self, NCK_E_WORD_MISSING, 'X', 6.2, 0.0);
    for (unsigned axis = 3; axis < NCK_AXIS_MAX; axis++) {
        if (!(spline->axes >> axis & 1u)) continue;
        return fail(self, NCK_E_SPLINE, nck_decode_letter(axis), 0.0, 0.0);
    }
    return NCK_OK;
}

// Every point names the axes of the first one.
static nck_status_t check_axes(nck_decode_t *self) {
    const uint32_t other = self->held.spline.axes ^ self->words.axes;
    if (other == 0) return NCK_OK;
    unsigned axis = 0;
    while (!(other >> axis & 1u)) axis++;
    const int missing = (self->held.spline.axes & other) != 0;
    return fail(self, missing ? NCK_E_WORD_MISSING : NCK_E_SPLINE, nck_decode_letter(axis), 6.2,
                0.0);
}

static nck_status_t add_point(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    nck_element_t *const point = &self->held.contour.element[spline->points];
    int64_t place_nm[NCK_AXIS_MAX];
    double weight = 1.0;
    nck_status_t status = check_axes(self);
    nck_decode_assume_places(self);
    if (status == NCK_OK) status = nck_decode_target(self, 0, place_nm);
    if (status == NCK_OK && (self->words.letters & NCK_LETTER('R'))) {
        status = read_plain(self, 'R', &weight);
    }
    if (status != NCK_OK) return status;
    if (!(weight > 0.0)) return fail(self, NCK_E_NUMBER_RANGE, 'R', weight, NCK_LINEAR_MAX_MM);
    const int64_t *const here_nm = self->place.position_nm;
    if (spline->points == 0 && memcmp(place_nm, here_nm, sizeof self->place.position_nm) != 0) {
        return fail(self, NCK_E_SPLINE, 'P', 6.2, 0.0);
    }
    point->to_nm[0] = place_nm[0];
    point->to_nm[1] = place_nm[1];
    point->centre_mm[NCK_SPLINE_Z] = nck_real_of(place_nm[2]);
    point->sweep_rad = weight;
    spline->points++;
    return NCK_OK;
}

static nck_status_t add_knot(nck_decode_t *self) {
    nck_spline_t *const spline = &self->held.spline;
    double value = 0.0;
    if (!(self->words.letters & NCK_LETTER('K'))) {
        return fail(self, NCK_E_WORD_MISSING, 'K', 6.2, 0.0);
    }
    const nck_status_t status = read_plain(self, 'K', &value);
    if (status != NCK_OK) return status;
    if (spline->knots > 0 && value < *knot(self, spline->knots - 1)) {
        return fail(self, NCK_E_SPLINE, 'K', value, 0.0);
    }
    *knot(self, spline->knots) = value;
    spline->knots++;
    return NCK_OK;
}

// As many equal knots as the order at both ends: there the curve begins and ends; between them
// fewer: nowhere else is it broken.
static int are_knots_good(nck_decode_t *self) {
    const uint32_t k = self->held.spline.order, n = self->held.spline.points;
    if (n < k || *knot(self, k - 1) > *knot(self, 0)) return 0;
    for (uint32_t i = 1; i < n; i++) {
        if (!(*knot(self, i) < *knot(self, i + k - 1))) return 0;
    }
    return !(*knot(self, n + k - 1) > *knot(self, n));
}

// May a knot come here, or (adds) a point with one?
static nck_status_t check_room(nck_decode_t *self, int adds) {
    const nck_spline_t *const spline = &self->held.spline;
    const int over = spline->order == 0 || (adds && spline->points < spline->knots);
    if (over) return fail(self, NCK_E_SPLINE, 'K', 0.0, 0.0);
    if (spline->knots + 1 <= NCK_CONTOUR) return NCK_OK;
    return fail(self, NCK_E_CONTOUR_FULL, 0, NCK_CONTOUR, NCK_CONTOUR);
}

nck_status_t nck_decode_knots(nck_decode_t *self) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    const nck_spline_t *const spline = &self->held.spline;
    const int first = (self->words.codes & NCK_STEP(NCK_STEP_MOTION)) != 0;
    nck_status_t status = first ? start(self) : NCK_OK;
    const int adds = self->words.axes != 0;
    if (status == NCK_OK) status = check_room(self, adds);
    if (status == NCK_OK && adds) status = add_point(self);
    if (status == NCK_OK) status = add_knot(self);
    if (status != NCK_OK || spline->knots < spline->points + spline->order) return status;
    return are_knots_good(self) ? NCK_DONE : fail(self, NCK_E_SPLINE, 'K', 0.0, 0.0);
}
