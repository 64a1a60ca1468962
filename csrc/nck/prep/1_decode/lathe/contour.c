// SPDX-License-Identifier: MIT
// The lines of a contour: they are decoded as ever, what they move is kept, and nothing else of
// them counts. G70 P Q has them done instead.
#include "nck/prep/1_decode/lathe/parts.h"
#include "nck/prep/1_decode/lathe/level.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_fail_code …
#include "nck/prep/1_decode/number/number.h" // nck_decode_fail_range nck_decode_length_word …
#include "nck/prep/1_decode/modal/modal.h" // nck_decode_set_feed
#include "nck/prep/1_decode/macro/macro.h" // nck_call_return
#include "nck/prep/1_decode/motion/motion.h" // nck_corner_missing
#include "nck/base/arc_math.h" // nck_arc_inner nck_arc_norm nck_arc_outer
#include "nck/base/real.h" // nck_fabs nck_nm_of nck_real_of nck_mm_of
#include "nck/base/trig.h" // nck_atan2 nck_sincos

#include <stddef.h> // NULL
#include <string.h> // memcpy

static const double back_most = 1e-3; // [mm] the wrong way: what rounding makes

// ---- begin and end

static nck_status_t fail_cycle(nck_decode_t *self, nck_status_t code, int letter, double value) {
    self->line.tag = self->held.contour.line;
    return nck_decode_fail(self, code, 0, letter, value, NCK_CONTOUR);
}

void nck_contour_begin(nck_decode_t *self, nck_contour_mode_t mode, uint32_t code) {
    if (!NCK_HAS_CONTOUR) return;
    nck_contour_t *const contour = &self->held.contour;
    contour->mode = (uint32_t)mode | (contour->mode & NCK_CONTOUR_CORNER);
    contour->code = code;
    contour->line = self->line.tag;
    contour->count = 0;
    contour->begun = 0;
    contour->broken = 0;
    contour->rapid = 0;
    contour->falls = 0;
    contour->one_way = 0;
    contour->corner_nm = 0;
    contour->next_corner_nm = 0;
    contour->called = 0;
    contour->kept.feed = self->modal.feed;
    contour->kept.feed_word = self->modal.feed_word;
    contour->kept.motion = self->modal.motion;
    contour->kept.incremental = self->modal.incremental;
    contour->kept.centre_absolute = self->modal.centre_absolute;
    contour->kept.feed_mode = self->modal.feed_mode;
    contour->kept.excused = self->modal.excused;
    memcpy(contour->from_nm, self->place.position_nm, sizeof contour->from_nm);
    if (mode == NCK_CONTOUR_RUNS) return;
    memcpy(self->place.position_nm, contour->start_nm, sizeof contour->start_nm);
    self->modal.feed_mode = NCK_FEED_PER_MINUTE; // so that no line of the contour misses a feed
    nck_decode_set_feed(self, 1.0, 1.0);
}

static void bring_back(nck_decode_t *self) {
    nck_contour_t *const contour = &self->held.contour;
    if ((contour->mode & NCK_CONTOUR_READS) != 0) {
        self->modal.feed = contour->kept.feed;
        self->modal.feed_word = contour->kept.feed_word;
        self->modal.motion = contour->kept.motion;
        self->modal.incremental = contour->kept.incremental;
        self->modal.centre_absolute = contour->kept.centre_absolute;
        self->modal.feed_mode = contour->kept.feed_mode;
        self->modal.excused = contour->kept.excused;
        memcpy(self->place.position_nm, contour->from_nm, sizeof contour->from_nm);
    } else {
        self->modal.motion = NCK_MOTION_NONE; // the cycle's line's or the contour's: nobody says
    }
    contour->mode = NCK_CONTOUR_NOT;
}

// ---- a line

// A and C are a corner's in RS274NGC's contours.
nck_status_t nck_contour_words(nck_decode_t *self) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    if (self->machine->dialect.base != NCK_DIALECT_LINUXCNC) return NCK_OK;
    nck_words_t *const words = &self->words;
    const uint32_t both = NCK_LETTER('A') | NCK_LETTER('C');
    const uint32_t said = words->letters & both;
    const char letter = said & NCK_LETTER('A') ? 'A' : 'C';
    int64_t *const size_nm = &self->held.contour.next_corner_nm;
    *size_nm = 0;
    if (said == 0 || self->held.contour.called == 0) return NCK_OK;
    if (said == both) return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'C', 0.0, 0.0);
    const nck_status_t status = nck_decode_length_word(self, letter, size_nm);
    if (status != NCK_OK) return status;
    if (*size_nm <= 0) return nck_decode_fail_range(self, letter, 0.0);
    if (letter == 'C') *size_nm = -*size_nm;
    words->letters &= ~said;
    return NCK_OK;
}

// The first line of P … Q is the one that follows the cycle.
static nck_status_t check_first(nck_decode_t *self) {
    nck_contour_t *const contour = &self->held.contour;
    const nck_words_t *const words = &self->words;
    const int by_lines = contour->called == 0;
    int64_t number = -1;
    if (contour->begun) return NCK_OK;
    contour->begun = 1;
    if (by_lines && (contour->mode & NCK_CONTOUR_READS) != 0) {
        const int said = (words->letters & NCK_LETTER('N')) != 0
                         && nck_number_whole(&words->number['N' - 'A'], 0, &number);
        if (!said || (uint64_t)number != contour->first) {
            contour->broken = 1;
            bring_back(self);
            return fail_cycle(self, NCK_E_CONTOUR, 'P', (double)contour->first);
        }
        contour->one_way = (words->axes & 5u) != 5u; // X and Z: type II
    }
    return NCK_OK;
}

nck_status_t nck_contour_check(nck_decode_t *self) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    const uint32_t moves = NCK_STEP(NCK_STEP_MOTION) | NCK_STEP(NCK_STEP_DISTANCE)
                           | NCK_STEP(NCK_STEP_CENTRE);
    const uint32_t passed = NCK_STEP(NCK_STEP_FEED_MODE) | NCK_STEP(NCK_STEP_SPINDLE)
                            | NCK_STEP(NCK_STEP_MIST) | NCK_STEP(NCK_STEP_FLOOD)
                            | NCK_STEP(NCK_STEP_OVERRIDE) | NCK_STEP(NCK_STEP_OWN)
                            | NCK_STEP(NCK_STEP_DWELL) | NCK_STEP(NCK_STEP_RADIUS_COMP)
                            | NCK_STEP(NCK_STEP_PATH) | NCK_STEP(NCK_STEP_EXACT)
                            | NCK_STEP(NCK_STEP_SPEED_MODE);
    nck_words_t *const words = &self->words;
    const nck_status_t status = check_first(self);
    if (status != NCK_OK) return status;
    uint32_t strange = words->codes & ~(moves | passed);
    if (words->code[NCK_STEP_MOTION] > 30) strange |= words->codes & NCK_STEP(NCK_STEP_MOTION);
    for (unsigned step = 0; step < NCK_STEP_COUNT; step++) {
        if (!(strange & NCK_STEP(step))) continue;
        return nck_decode_fail_code(self, NCK_E_CONTOUR, (nck_step_t)step);
    }
    if (self->held.contour.mode & NCK_CONTOUR_READS) words->steps &= moves;
    return NCK_OK;
}

// ---- what it moves

static int8_t sign_of(double way) { return way > 0.0 ? 1 : -1; }

// Which way a and d count, as soon as the contour tells: towards the cut, and away from it.
static void turn_frame(nck_decode_t *self, const nck_element_t *element) {
    static const uint8_t axes[2] = {NCK_AXIS_X, NCK_AXIS_Z};
    const nck_contour_t *const contour = &self->held.contour;
    nck_rough_t *const rough = &self->held.rough;
    const unsigned along = rough->along, deep = 1u - along;
    const int64_t *const start_nm = contour->start_nm;
    const int64_t depth_nm = element->to_nm[deep] - start_nm[axes[deep]];
    const int64_t way_nm = element->to_nm[along] - contour->element[0].to_nm[along];
    if (rough->sign[1] == 0 && depth_nm != 0) rough->sign[1] = sign_of(nck_real_of(-depth_nm));
    if (rough->sign[0] == 0 && way_nm != 0) rough->sign[0] = sign_of(nck_real_of(way_nm));
}

// A contour that is roughed goes one way along the cuts; Fanuc's type I against the depth, too.
static nck_status_t judge(nck_decode_t *self, uint32_t last) {
    nck_contour_t *const contour = &self->held.contour;
    const nck_rough_t *const rough = &self->held.rough;
    nck_slant_t slant;
    turn_frame(self, &contour->element[last]);
    if (contour->code == NCK_MOTION_PATTERN || contour->code == NCK_MOTION_FINISH) return NCK_OK;
    if (last == 0 || rough->sign[0] == 0 || rough->sign[1] == 0) return NCK_OK;
    for (unsigned part = 0; nck_level_slant(self, last, part, &slant); part++) {
        const int back = slant.a[0] - slant.a[1] > back_most;
        const int falls = slant.d[0] - slant.d[1] > back_most;
        contour->falls |= (uint32_t)falls;
        if (back || (contour->one_way && falls)) {
            // It turns back along the cuts, or against their depth.
            const int z = (self->held.rough.along == 1) == back;
            return nck_decode_fail(self, NCK_E_CONTOUR, 0, z ? 'Z' : 'X', 0.0, 0.0);
        }
    }
    return NCK_OK;
}

// The corner between the last two elements, lines, is cut off: the one before ends earlier, and a
// third stands between them. A chamfer has the ends of the fillet of its size.
static nck_status_t round_corner(nck_decode_t *self) {
    nck_contour_t *const contour = &self->held.contour;
    nck_element_t *const last = &contour->element[contour->count - 1];
    nck_element_t *const before = last - 1;
    const double size = nck_real_of(contour->corner_nm) / 1e6, radius = nck_fabs(size);
    const int letter = size > 0.0 ? 'A' : 'C';
    double u[2], v[2];
    for (unsigned k = 0; k < 2; k++) { // Z first: as G18 turns
        u[k] = nck_real_of(before->to_nm[1 - k] - before[-1].to_nm[1 - k]) / 1e6;
        v[k] = nck_real_of(last->to_nm[1 - k] - before->to_nm[1 - k]) / 1e6;
    }
    const double before_mm = nck_arc_norm(u[0], u[1]), last_mm = nck_arc_norm(v[0], v[1]);
    const double turn = nck_atan2(nck_arc_outer(u, v), nck_arc_inner(u, v));
    double sine, cosine;
    nck_sincos(0.5 * nck_fabs(turn), &sine, &cosine);
    const double ahead = radius * sine; // of the corner, times cosine
    if (before->sweep_rad != 0.0 || last->sweep_rad != 0.0 || ahead > before_mm * cosine
        || ahead > last_mm * cosine || contour->count + 1 > NCK_CONTOUR) {
        return nck_decode_fail(self, NCK_E_CONTOUR, 0, letter, radius, 0.0);
    }
    last[1] = *last;
    for (unsigned k = 0; k < 2; k++) {
        const int64_t corner_nm = before->to_nm[k];
        const double back = ahead / cosine * u[1 - k] / before_mm;
        const double on = ahead / cosine * v[1 - k] / last_mm;
        before->to_nm[k] = corner_nm - nck_nm_of(back);
        last->to_nm[k] = corner_nm + nck_nm_of(on);
        const double left = k == 0 ? u[0] : -u[1]; // of the way, along this axis
        last->centre_mm[k] = nck_real_of(before->to_nm[k]) / 1e6
                             + (turn > 0.0 ? radius : -radius) * left / before_mm;
    }
    last->sweep_rad = size > 0.0 ? turn : 0.0;
    contour->count++;
    return NCK_OK;
}

// The element is there: its corner to the one before, and whether both can be cut.
static nck_status_t close_element(nck_decode_t *self) {
    nck_contour_t *const contour = &self->held.contour;
    const uint32_t first = contour->count - 1;
    nck_status_t status = NCK_OK;
    if (contour->corner_nm != 0) status = round_corner(self);
    contour->corner_nm = contour->next_corner_nm;
    contour->next_corner_nm = 0;
    if (contour->corner_nm != 0 && first == 0) {
        return nck_decode_fail(self, NCK_E_CONTOUR, 0, 'A', 0.0, 0.0);
    }
    for (uint32_t k = first; k < contour->count && status == NCK_OK; k++) status = judge(self, k);
    return status;
}

nck_status_t nck_contour_take(nck_decode_t *self, const nck_block_t *block) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    nck_contour_t *const contour = &self->held.contour;
    nck_element_t *const element = &contour->element[contour->count % NCK_CONTOUR_ROWS];
    const int arc = block->kind == NCK_BLOCK_ARC;
    if (contour->count + 1 > NCK_CONTOUR) {
        contour->broken = 1;
        return fail_cycle(self, NCK_E_CONTOUR_FULL, 0, NCK_CONTOUR);
    }
    if (contour->count == 0 && arc) {
        return nck_decode_fail(self, NCK_E_CONTOUR, 0, 'G', block->sweep_rad > 0.0 ? 3.0 : 2.0,
                               0.0);
    }
    if (contour->count == 0) contour->rapid = block->kind == NCK_BLOCK_RAPID;
    element->to_nm[0] = block->target_nm[NCK_AXIS_X] + self->place.tool_nm[NCK_AXIS_X];
    element->to_nm[1] = block->target_nm[NCK_AXIS_Z] + self->place.tool_nm[NCK_AXIS_Z];
    element->sweep_rad = arc ? block->sweep_rad : 0.0;
    element->centre_mm[0] = block->centre_mm[1] + nck_mm_of(self->place.tool_nm[NCK_AXIS_X]);
    element->centre_mm[1] = block->centre_mm[0] + nck_mm_of(self->place.tool_nm[NCK_AXIS_Z]);
    contour->count++;
    return close_element(self);
}

// ---- behind a line

static int is_over(const nck_decode_t *self) {
    const nck_contour_t *const contour = &self->held.contour;
    const nck_words_t *const words = &self->words;
    int64_t number = -1;
    if (self->macro.seek.kind != NCK_SEEK_NOT || self->line.tag == contour->line) return 0;
    if (contour->called != 0) return self->macro.depth < contour->called;
    return (words->letters & NCK_LETTER('N')) != 0
           && nck_number_whole(&words->number['N' - 'A'], 0, &number)
           && (uint64_t)number == contour->last;
}

nck_status_t nck_contour_behind(nck_decode_t *self, nck_status_t status) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    nck_contour_t *const contour = &self->held.contour;
    nck_status_t back = status;
    if (status < 0) contour->broken = 1;
    if ((status >= 0 && self->words.steps != 0) || !is_over(self)) return status;
    if (status >= 0 && (contour->mode & NCK_CONTOUR_CORNER)) {
        contour->broken = 1;
        back = nck_corner_missing(self);
    }
    const int runs = (contour->mode & NCK_CONTOUR_RUNS) != 0;
    bring_back(self);
    if (runs && back >= 0) back = nck_call_return(self);
    if (back < 0 || contour->broken) return back;
    self->line.tag = contour->line;
    self->words.code[NCK_STEP_MOTION] = (uint16_t)contour->code;
    self->words.steps = 0;
    nck_decode_leave(self, NCK_REST_CYCLE);
    self->held.rough.phase = NCK_ROUGH_BEGIN;
    return status;
}

nck_status_t nck_contour_missing(nck_decode_t *self) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    const double last = (double)self->held.contour.last;
    self->text.over = 1;
    return fail_cycle(self, NCK_E_LABEL, 0, last);
}
