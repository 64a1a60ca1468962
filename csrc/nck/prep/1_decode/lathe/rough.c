// SPDX-License-Identifier: MIT
// Roughing level by level, then along the contour; G73 and G70 along the contour alone.
//
//     rise ─ across ─ down ─ plunge ─ cut ─ back     one stretch of a level
#include "nck/prep/1_decode/lathe/rough.h"
#include "nck/prep/1_decode/lathe/lathe.h"
#include "nck/prep/1_decode/lathe/follow.h"
#include "nck/prep/1_decode/lathe/level.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_leave
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_travel
#include "nck/base/real.h" // nck_min nck_nm_of …

#include <stddef.h> // NULL

enum { LEVELS_MOST = 100000 };

static const double tiny = 5e-7; // [mm]

static const uint8_t axes[2] = {NCK_AXIS_X, NCK_AXIS_Z};

static nck_status_t fail(nck_decode_t *self, nck_status_t code, int letter, double value) {
    return nck_decode_fail(self, code, 0, letter, value, 0.0);
}

// A level's height; of level 0 the start's.
static double height_of(const nck_rough_t *rough, uint32_t level) {
    return nck_max(-(double)level * rough->depth, rough->bottom);
}

// ---- before the first move

// How low and how high the tool goes, and whether the axes may go where it leads.
static nck_status_t survey(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    nck_slant_t slant;
    rough->bottom = 0.0;
    rough->highest = 0.0;
    for (uint32_t k = 0; k < self->held.contour.count; k++) {
        for (unsigned axis = 0; axis < 2; axis++) {
            const int64_t at_nm = self->held.contour.element[k].to_nm[axis]
                                  + nck_nm_of(rough->shift_mm[axis]);
            const nck_status_t status = nck_decode_travel(self, axes[axis], at_nm);
            if (status != NCK_OK) return status;
        }
        for (unsigned part = 0; k > 0 && nck_level_slant(self, k, part, &slant); part++) {
            rough->bottom = nck_min(rough->bottom, nck_min(slant.d[0], slant.d[1]));
            rough->highest = nck_max(rough->highest, nck_max(slant.d[0], slant.d[1]));
        }
    }
    rough->bottom += rough->spare;
    rough->highest += rough->highest > 0.0 ? rough->spare : 0.0;
    return NCK_OK;
}

// Allowances lead away from the work. One along the cuts would lead into the far side of a pocket.
static nck_status_t check_shift(nck_decode_t *self) {
    const nck_rough_t *const rough = &self->held.rough;
    for (unsigned axis = 0; axis < 2; axis++) {
        const int along = axis == rough->along;
        const double sign = (double)rough->sign[along ? 0 : 1];
        const double away = (along ? -sign : sign) * rough->shift_mm[axis];
        const int bites = along && self->held.contour.falls && away > 0.0;
        if (away < 0.0 || bites) {
            const nck_scale_t *const scale = &self->place.scale[axis == 0 ? 1 : 0];
            return fail(self, NCK_E_CONTOUR, axis == 0 ? 'U' : 'W',
                        nck_decode_as_word(scale, rough->shift_mm[axis] * 1e6));
        }
    }
    return NCK_OK;
}

static nck_status_t set_levels(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    double last[2], clear = 0.0;
    nck_level_place(self, self->held.contour.count - 1, last);
    const double count = -rough->bottom / rough->depth;
    if (count > (double)LEVELS_MOST) {
        // The depth is too small: its letter is U or W of a line before, D, or RS274NGC's I.
        const nck_scale_t *const scale = &self->place.scale[0];
        const int before = nck_real_of(rough->depth_nm) / 1e6 == rough->depth;
        const int deep = self->held.contour.code == NCK_MOTION_ROUGH ? 'U' : 'W';
        const int fanuc = before ? deep : 'D';
        const double least = -rough->bottom / (double)LEVELS_MOST;
        return nck_decode_fail(self, NCK_E_NUMBER_RANGE, 0,
                               self->tongue == NCK_TONGUE_LINUXCNC ? 'I' : fanuc,
                               nck_decode_as_word(scale, rough->depth * 1e6),
                               nck_decode_as_word(scale, least * 1e6));
    }
    rough->levels = (uint32_t)nck_floor(count);
    rough->levels += (double)rough->levels * rough->depth < -rough->bottom - tiny;
    rough->end = 0.0;
    rough->reach = last[0];
    double end = 0.0, behind = 0.0;
    const int outside = nck_level_clear(self, 0.0, &clear, &end) && clear <= tiny;
    // What lies behind a wall that is higher than the start is not reached.
    clear = end;
    if (!outside || nck_level_clear(self, 0.0, &clear, &behind)) {
        return fail(self, NCK_E_CONTOUR, 0, 0.0);
    }
    rough->reach = end;
    return NCK_EMPTY;
}

// The first and the last copy of G73; the others lie between them.
static nck_status_t survey_patterns(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    nck_status_t status = survey(self);
    for (unsigned k = 0; k < 2; k++) {
        rough->spare_mm[k] = rough->shift_mm[k];
        rough->shift_mm[k] += nck_real_of(rough->pattern_nm[k]) / 1e6;
    }
    return status == NCK_OK ? survey(self) : status;
}

static nck_status_t survey_cycle(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    const int pattern = self->held.contour.code == NCK_MOTION_PATTERN;
    rough->pass = 0;
    rough->follows = 0;
    rough->levels = 0;
    rough->level = 1;
    if (self->lathe && self->held.contour.code == NCK_MOTION_FINISH) { // it has been done
        rough->phase = NCK_ROUGH_HOME;
        return NCK_EMPTY;
    }
    rough->phase = pattern ? NCK_ROUGH_SHIFT : NCK_ROUGH_START;
    if (self->held.contour.count < 2) return fail(self, NCK_E_CONTOUR, 0, 0.0);
    if (pattern) {
        rough->sign[0] = 1;
        rough->sign[1] = 1;
        return survey_patterns(self);
    }
    if (rough->sign[0] == 0 || rough->sign[1] == 0) return fail(self, NCK_E_CONTOUR, 0, 0.0);
    nck_status_t status = survey(self);
    if (self->held.contour.code == NCK_MOTION_FINISH) return status;
    if (status == NCK_OK) status = check_shift(self);
    return status == NCK_OK ? set_levels(self) : status;
}

static nck_status_t begin_moves(nck_decode_t *self, nck_block_t *out) {
    const nck_status_t status = survey_cycle(self);
    (void)out;
    return status < 0 ? status : NCK_EMPTY;
}

// ---- levels

static nck_status_t start(nck_decode_t *self, nck_block_t *out) {
    self->held.rough.phase = NCK_ROUGH_LEVEL;
    return nck_follow_go(self, NCK_BLOCK_RAPID, 0.0, 0.0, out);
}

// The next stretch of the level, or of the next one; then along the contour.
static nck_status_t choose(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    double begin = rough->end, end = 0.0;
    (void)out; // moves nothing
    if (rough->level > rough->levels) {
        double beside[2];
        nck_follow_begin(self, beside);
        rough->begin = beside[0];
        rough->follows = 1;
        rough->phase = NCK_ROUGH_RISE;
        return NCK_EMPTY;
    }
    const int clear = nck_level_clear(self, height_of(rough, rough->level), &begin, &end);
    const int is_first = begin < tiny;
    if (!clear) {
        rough->level++;
        rough->end = 0.0;
        return NCK_EMPTY;
    }
    rough->begin = begin;
    rough->end = end;
    if (is_first ? rough->is_first : rough->is_pocket) rough->phase = NCK_ROUGH_RISE;
    return NCK_EMPTY;
}

// Whether a level above the stretch is open to the side: another cycle has cut it.
static int is_opened(const nck_decode_t *self, uint32_t level) {
    double begin = 0.0, end = 0.0;
    return nck_level_clear(self, height_of(&self->held.rough, level), &begin, &end) && begin < tiny
           && end > self->held.rough.begin;
}

// As high as the way to the next stretch needs: above a level that passes there and is cut. Where
// another cycle has cut before, nobody knows what stands.
static nck_status_t rise(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    double at[2];
    uint32_t passes = 0, stops = rough->level;
    nck_follow_place(self, at);
    while (stops - passes > 1) {
        const uint32_t middle = passes + (stops - passes) / 2;
        if (nck_level_passes(self, height_of(rough, middle), at[0], rough->begin)) passes = middle;
        else stops = middle;
    }
    if (!rough->is_first && is_opened(self, passes)) passes = 0;
    const double over = nck_min(height_of(rough, passes) + rough->retract, 0.0);
    rough->phase = NCK_ROUGH_ACROSS;
    return nck_follow_go(self, NCK_BLOCK_RAPID, at[0], nck_max(at[1], over), out);
}

static nck_status_t across(nck_decode_t *self, nck_block_t *out) {
    double at[2];
    nck_follow_place(self, at);
    self->held.rough.phase = NCK_ROUGH_DOWN;
    return nck_follow_go(self, NCK_BLOCK_RAPID, self->held.rough.begin, at[1], out);
}

// How high what roughing left may stand at the contour's first place; G70 goes there as the contour
// does.
static double near_contour(const nck_decode_t *self) {
    const nck_rough_t *const rough = &self->held.rough;
    double first[2];
    nck_level_place(self, 0, first);
    return rough->levels > 0 ? first[1] + rough->spare + rough->depth + rough->retract : 0.0;
}

// At rapid as far as nothing stands.
static nck_status_t down(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    double at[2];
    nck_follow_place(self, at);
    double to = height_of(rough, rough->level - 1) + rough->retract;
    if (rough->follows) to = near_contour(self);
    else if (!rough->is_first && is_opened(self, rough->level - 1)) to = 0.0;
    else if (rough->begin < tiny && self->held.contour.rapid) to = height_of(rough, rough->level);
    rough->phase = rough->follows ? NCK_ROUGH_BESIDE : NCK_ROUGH_PLUNGE;
    return nck_follow_go(self, NCK_BLOCK_RAPID, rough->begin, nck_min(at[1], to), out);
}

static nck_status_t plunge(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    rough->phase = NCK_ROUGH_CUT;
    return nck_follow_go(self, NCK_BLOCK_LINE, rough->begin, height_of(rough, rough->level), out);
}

static nck_status_t cut(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    rough->phase = NCK_ROUGH_BACK;
    return nck_follow_go(self, NCK_BLOCK_LINE, rough->end, height_of(rough, rough->level), out);
}

// Off the cut, away from the wall before it.
static nck_status_t back(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    const double a = nck_max(rough->end - rough->retract, rough->begin);
    const double d = nck_min(height_of(rough, rough->level) + rough->retract, 0.0);
    rough->phase = NCK_ROUGH_LEVEL;
    return nck_follow_go(self, NCK_BLOCK_RAPID, a, d, out);
}

nck_status_t nck_rough_next(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    static const nck_step_function_t phases[NCK_ROUGH_BESIDE] = {
        NULL, begin_moves, start, choose, rise, across, down, plunge, cut, back
    };
    nck_rough_t *const rough = &self->held.rough;
    nck_status_t status = NCK_EMPTY;
    while (status == NCK_EMPTY && rough->phase != 0) {
        status = rough->phase < NCK_ROUGH_BESIDE ? phases[rough->phase](self, out)
                                                 : nck_follow_next(self, out);
    }
    if (status < 0) rough->phase = 0;
    if (rough->phase != 0) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
