// SPDX-License-Identifier: MIT
// G2 and G3: from the words to circles that pass through both ends.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_block nck_decode_fail …
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_counts …
#include "nck/prep/1_decode/place/place.h" // nck_layout_way nck_plane_axes
#include "nck/base/arc_math.h" // nck_arc_sweep …
#include "nck/base/real.h" // nck_mm_of nck_nm_of nck_rounded …

#include <string.h> // memcpy memset

// An arc on its way to a block. Points in the plane are in mm, relative to the start.
typedef struct course {
    unsigned u, v;          // axes of the plane
    double turn;            // +1 anticlockwise (G3), −1 clockwise (G2)
    double more;            // whole turns beyond the first, as an angle [rad] ≥ 0
    double d[2];            // end
    double c[2];            // centre
} course_t;

// One of I J K, of a set that is not empty.
static int first_of(uint32_t letters) {
    if (letters & NCK_LETTER('I')) return 'I';
    return (letters & NCK_LETTER('J')) ? 'J' : 'K';
}

static nck_status_t choose_plane(nck_decode_t *self, course_t *course) {
    memset(course, 0, sizeof *course);
    nck_plane_axes(self, &course->u, &course->v);
    const unsigned axes[2] = {course->u, course->v};
    for (unsigned k = 0; k < 2; k++) {
        if (!(self->place.axes & ((uint32_t)1 << axes[k]))) {
            return nck_decode_fail_step(self, NCK_E_AXIS_UNKNOWN, NCK_STEP_MOTION,
                                        nck_decode_letter(axes[k]), 0.0, 0.0);
        }
    }
    return NCK_OK;
}

// P: how often the arc passes its end, from 1.
static nck_status_t read_turns(nck_decode_t *self, course_t *course) {
    const nck_number_t *const word = &self->words.number['P' - 'A'];
    int64_t turns = 1;
    const int own = nck_has_word(self, 'P') && !(self->words.codes & (NCK_STEP(NCK_STEP_DWELL)
                                                             | NCK_STEP(NCK_STEP_PATH)));
    if (own && (!nck_number_whole(word, 0, &turns) || turns < 1 || turns > NCK_DECODE_TURNS_MAX)) {
        return nck_decode_fail_range(self, 'P', NCK_DECODE_TURNS_MAX);
    }
    course->more = nck_real_of(turns - 1) * 2.0 * NCK_PI;
    return NCK_OK;
}

static nck_status_t read_length(nck_decode_t *self, char letter, int64_t *value_out) {
    *value_out = 0;
    return nck_has_word(self, letter) ? nck_decode_length_word(self, letter, value_out) : NCK_OK;
}

// The block of an arc from from_nm to to_nm; centre: from the start [mm]; sweep: more turns
// included. Where it turns back must be in the travel, too; its ends are checked elsewhere.
static nck_status_t fill_block(nck_decode_t *self, const course_t *course, const int64_t *from_nm,
                               const int64_t *to_nm, double sweep, nck_block_t *out) {
    const unsigned axes[2] = {course->u, course->v};
    double centre_nm[2];
    nck_decode_block(self, NCK_BLOCK_ARC, out);
    memcpy(out->target_nm, to_nm, sizeof out->target_nm);
    for (unsigned axis = 0; axis < 3; axis++) out->target_nm[axis] -= self->place.tool_nm[axis];
    for (unsigned k = 0; k < 2; k++) {
        const int64_t tool_nm = self->place.tool_nm[axes[k]];
        centre_nm[k] = nck_real_of(from_nm[axes[k]]) + course->c[k] * 1e6;
        out->centre_mm[k] = nck_mm_of(from_nm[axes[k]] - tool_nm) + course->c[k];
    }
    out->sweep_rad = sweep;
    const double from[2] = {-course->c[0], -course->c[1]};
    const double to[2] = {course->d[0] - course->c[0], course->d[1] - course->c[1]};
    const unsigned bulges = nck_arc_bulges(from, to, sweep);
    const double radius_nm = nck_arc_norm(from[0], from[1]) * 1e6;
    nck_status_t status = NCK_OK;
    for (unsigned k = 0; k < 4 && status == NCK_OK; k++) {
        if (!(bulges >> k & 1u)) continue;
        const double far_nm = centre_nm[k % 2] + (k < 2 ? radius_nm : -radius_nm);
        status = nck_decode_travel(self, axes[k % 2], nck_rounded(far_nm));
    }
    return status;
}

// The arc over a chord that is not empty, its centre at a height above it.
static nck_status_t fill_arc(nck_decode_t *self, course_t *course, const int64_t *from_nm,
                             const int64_t *to_nm, double height, nck_block_t *out) {
    const double length = nck_arc_norm(course->d[0], course->d[1]);
    const double sweep = nck_arc_sweep(length, height, course->turn) + course->turn * course->more;
    nck_arc_centre(course->d[0], course->d[1], height, course->c);
    return fill_block(self, course, from_nm, to_nm, sweep, out);
}

static nck_status_t arc_by_radius(nck_decode_t *self, course_t *course, const int64_t *target_nm,
                                  nck_block_t *out) {
    const double length = nck_arc_norm(course->d[0], course->d[1]);
    const uint32_t centre = self->words.letters & NCK_LETTERS_CENTRE;
    int64_t radius_nm;

    if (centre) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, first_of(centre), 0.0, 0.0);
    }
    const nck_status_t status = read_length(self, 'R', &radius_nm);
    if (status != NCK_OK) return status;
    double unit[2] = {1.0, 0.0};
    const double scale = self->layout.on != 0 ? nck_fabs(nck_layout_way(self, unit)) : 1.0;
    const double radius = scale * nck_mm_of(radius_nm);
    if (radius_nm == 0 || !(length > 0.0)) {
        return nck_decode_fail_word(self, NCK_E_ARC_CENTRE, 'R', radius, 0.0);
    }
    if (nck_fabs(radius) < 0.5 * length - self->machine->path.arc_radius) {
        const double least = nck_decode_as_word(&self->place.scale[0], 0.5e6 * length / scale);
        return nck_decode_fail_word(self, NCK_E_ARC_CHORD, 'R', nck_word_real(self, 'R'),
                                    least * nck_decode_counts(self, 'R'));
    }
    const double height = nck_arc_radius_height(length, radius, course->turn);
    return fill_arc(self, course, self->place.position_nm, target_nm, height, out);
}

// I J K: from the start (G91.1) or from the program's zero (G90.1) to the centre.
static nck_status_t read_centre(nck_decode_t *self, course_t *course) {
    const unsigned axes[2] = {course->u, course->v};
    const char letters[2] = {(char)('I' + course->u), (char)('I' + course->v)}; // X I, Y J, Z K
    const uint32_t both = NCK_LETTER(letters[0]) | NCK_LETTER(letters[1]);
    const uint32_t said = self->words.letters & NCK_LETTERS_CENTRE;
    const uint32_t strange = said & ~both;
    const char letter = (char)first_of(strange);
    const int is_none = nck_is_fanuc(self) && !(nck_fabs(nck_word_real(self, letter)) > 0.0);

    if (strange != 0 && !is_none) { // Fanuc's K0. says nothing
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
    }
    if (said == 0) return nck_motion_fail(self, NCK_E_ARC_CENTRE, 0, 0.0, 0.0);
    nck_decode_assume(self, NCK_NOTE_ARC_CENTRE);
    for (unsigned k = 0; k < 2; k++) {
        int64_t centre_nm;
        if (self->modal.centre_absolute && !nck_has_word(self, letters[k])) {
            return nck_decode_fail(self, NCK_E_WORD_MISSING, 0, letters[k], 0.0, 0.0);
        }
        const nck_status_t status = read_length(self, letters[k], &centre_nm);
        if (status != NCK_OK) return status;
        if (self->modal.centre_absolute) {
            centre_nm += self->place.origin_nm[axes[k]] - self->place.position_nm[axes[k]];
        }
        course->c[k] = nck_mm_of(centre_nm);
    }
    if (self->layout.on != 0) (void)nck_layout_way(self, course->c);
    return NCK_OK;
}

// LinuxCNC's rule: the radii may differ by the tolerance, or by a thousandth up to a hundred times
// that.
static int radii_agree(const nck_decode_t *self, double start, double end) {
    const double tolerance = self->machine->path.arc_radius;
    const double miss = nck_fabs(start - end);
    return miss <= tolerance || (miss <= 100.0 * tolerance && miss <= 0.001 * nck_max(start, end));
}

static nck_status_t check_radii(nck_decode_t *self, const course_t *course) {
    const double start = nck_arc_norm(course->c[0], course->c[1]);
    const double end = nck_arc_norm(course->d[0] - course->c[0], course->d[1] - course->c[1]);

    if (!(start > 0.0)) return nck_motion_fail(self, NCK_E_ARC_CENTRE, 0, 0.0, 0.0);
    if (radii_agree(self, start, end)) return NCK_OK;
    // An arc that misses its circle: would it be on one if I J K counted the other way?
    const unsigned axes[2] = {course->u, course->v};
    const int absolute = self->modal.centre_absolute;
    const double sign = absolute ? -1.0 : 1.0;
    const nck_status_t status = nck_motion_fail(self, NCK_E_ARC_RADIUS, 0, end, start);
    double c[2];
    for (unsigned k = 0; k < 2; k++) {
        if (!nck_has_word(self, (char)('I' + axes[k])) || self->layout.on != 0) return status;
        const int64_t zero_nm = self->place.origin_nm[axes[k]] - self->place.position_nm[axes[k]];
        c[k] = course->c[k] + sign * nck_mm_of(zero_nm);
    }
    const double other = nck_arc_norm(c[0], c[1]);
    const double rest = nck_arc_norm(course->d[0] - c[0], course->d[1] - c[1]);
    if (!(other > 0.0) || !radii_agree(self, other, rest)) return status;
    self->finding.error.code = NCK_E_ARC_MODE;
    self->finding.error.letter = absolute ? 'I' : 'A';
    return NCK_E_ARC_MODE;
}

static int is_empty(const course_t *course) {
    return !(nck_arc_norm(course->d[0], course->d[1]) > 0.0);
}

// A long arc whose ends are close together and not quite equally far from the centre: the circle
// through both ends would stand far beside the programmed one. Two circles through the middle of
// the arc stay close to it.
static nck_status_t arc_in_two(nck_decode_t *self, course_t *course, const int64_t *target_nm,
                               double angle, nck_block_t *out) {
    const int64_t *const from_nm = self->place.position_nm;
    const double rest[2] = {course->d[0] - course->c[0], course->d[1] - course->c[1]};
    const double radius = 0.5 * (nck_arc_norm(course->c[0], course->c[1])
                                 + nck_arc_norm(rest[0], rest[1]));
    const double share = 0.5 * nck_fabs(angle) / (nck_fabs(angle) + course->more);
    int64_t middle_nm[NCK_AXIS_MAX];
    course_t first = *course, second = *course;

    nck_arc_point(course->c[0], course->c[1], radius, 0.5 * angle, first.d);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        double ahead_nm = nck_real_of(target_nm[axis] - from_nm[axis]) * share;
        if (axis == course->u) ahead_nm = first.d[0] * 1e6;
        if (axis == course->v) ahead_nm = first.d[1] * 1e6;
        middle_nm[axis] = from_nm[axis] + nck_rounded(ahead_nm);
    }
    first.more = 0.0;
    first.d[0] = nck_mm_of(middle_nm[course->u] - from_nm[course->u]);
    first.d[1] = nck_mm_of(middle_nm[course->v] - from_nm[course->v]);
    for (unsigned k = 0; k < 2; k++) {
        second.d[k] = course->d[k] - first.d[k];
        second.c[k] = course->c[k] - first.d[k];
    }
    if (is_empty(&first) || is_empty(&second)) { // of a few nanometres
        const double all = nck_arc_height(course->d[0], course->d[1], course->c[0], course->c[1]);
        return fill_arc(self, course, from_nm, target_nm, all, out);
    }
    double height = nck_arc_height(first.d[0], first.d[1], first.c[0], first.c[1]);
    nck_status_t status = fill_arc(self, &first, from_nm, middle_nm, height, out);
    if (status != NCK_OK) return status;
    height = nck_arc_height(second.d[0], second.d[1], second.c[0], second.c[1]);
    nck_decode_leave(self, NCK_REST_SECOND);
    return fill_arc(self, &second, middle_nm, target_nm, height, &self->second);
}

static nck_status_t arc_about(nck_decode_t *self, course_t *course, const int64_t *target_nm,
                              nck_block_t *out) {
    const int64_t *const from_nm = self->place.position_nm;
    const nck_status_t status = check_radii(self, course);
    if (status != NCK_OK) return status;
    if (target_nm[course->u] == from_nm[course->u] && target_nm[course->v] == from_nm[course->v]) {
        const double sweep = course->turn * (2.0 * NCK_PI + course->more);
        return fill_block(self, course, from_nm, target_nm, sweep, out);
    }
    const double *const d = course->d, *const c = course->c;
    const double angle = nck_arc_angle(d[0], d[1], c[0], c[1], course->turn);
    const double aside = nck_arc_aside(d[0], d[1], c[0], c[1]);
    if (nck_fabs(angle) > NCK_PI && nck_fabs(aside) > self->machine->path.chord_error) {
        return arc_in_two(self, course, target_nm, angle, out);
    }
    const double height = nck_arc_height(d[0], d[1], c[0], c[1]);
    return fill_arc(self, course, from_nm, target_nm, height, out);
}

// A pushed block says centre and turns as numbers.
static void take_centre(const nck_decode_t *self, const nck_block_in_t *pushed, course_t *course) {
    const unsigned axes[2] = {course->u, course->v};
    const double turns = nck_fabs((double)pushed->turns);
    for (unsigned k = 0; k < 2; k++) {
        const int64_t origin_nm = self->place.origin_nm[axes[k]];
        const int64_t centre_nm = nck_nm_of(pushed->centre[k]);
        course->c[k] = nck_mm_of(origin_nm + centre_nm - self->place.position_nm[axes[k]]);
    }
    course->more = (turns - 1.0) * 2.0 * NCK_PI;
}

// A mirrored plane has its arcs turn the other way; one that is stretched has none. Centres then
// count from the start.
static nck_status_t turn_over(nck_decode_t *self, course_t *course) {
    double unit[2] = {1.0, 1.0};
    const double scale = nck_layout_way(self, unit);
    const int even = nck_fabs(scale) > 0.0;
    const int absolute = self->modal.centre_absolute && !nck_has_word(self, 'R');
    if (!even || absolute) {
        return nck_motion_fail(self, NCK_E_LAYOUT_ON, 0, absolute ? 1.0 : 0.0, 0.0);
    }
    if (scale < 0.0) course->turn = -course->turn;
    return NCK_OK;
}

nck_status_t nck_decode_arc(nck_decode_t *self, const nck_block_in_t *pushed,
                            const int64_t *target_nm, nck_block_t *out) {
    course_t course;
    nck_status_t status = choose_plane(self, &course);
    if (status == NCK_OK && !pushed) status = read_turns(self, &course);
    if (status != NCK_OK) return status;
    course.turn = self->words.code[NCK_STEP_MOTION] == 30 ? 1.0 : -1.0;
    if (self->layout.on != 0 && !pushed) {
        status = turn_over(self, &course);
        if (status != NCK_OK) return status;
    }
    course.d[0] = nck_mm_of(target_nm[course.u] - self->place.position_nm[course.u]);
    course.d[1] = nck_mm_of(target_nm[course.v] - self->place.position_nm[course.v]);
    if (!pushed && nck_has_word(self, 'R')) return arc_by_radius(self, &course, target_nm, out);
    if (pushed) take_centre(self, pushed, &course);
    else status = read_centre(self, &course);
    return status == NCK_OK ? arc_about(self, &course, target_nm, out) : status;
}
