// SPDX-License-Identifier: MIT
// Along the contour: roughing ends so, G73 and G70 do nothing else. Every move of these cycles is
// given here.
#include "nck/prep/1_decode/lathe/follow.h"
#include "nck/prep/1_decode/lathe/lathe.h"
#include "nck/prep/1_decode/lathe/level.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_block
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_give_exact nck_decode_give_within
#include "nck/base/arc_math.h" // nck_arc_inner nck_arc_outer
#include "nck/base/real.h" // nck_nm_of nck_real_of
#include "nck/base/trig.h" // nck_atan2

static const double tiny = 5e-7; // [mm]
static const double beyond = 2.05; // times the distance to keep: what leads to it is longer

static const uint8_t along_of[2] = {NCK_AXIS_X, NCK_AXIS_Z};

// Where the tool is: [0] along a, [1] along d.
void nck_follow_place(const nck_decode_t *self, double *out) {
    const nck_rough_t *const rough = &self->held.rough;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned axis = k == 0 ? rough->along : 1u - rough->along;
        const int64_t way_nm = self->place.position_nm[along_of[axis]]
                               - self->held.contour.start_nm[along_of[axis]];
        out[k] = (double)rough->sign[k] * nck_real_of(way_nm) / 1e6;
    }
}

// Along the contour a cut is what the program's own lines would be, within the tolerance in force.
static int is_contour(const nck_decode_t *self, nck_block_kind_t kind) {
    const uint8_t phase = self->held.rough.phase;
    const int follows = phase >= NCK_ROUGH_SIDE && phase <= NCK_ROUGH_LEAVE;
    return kind != NCK_BLOCK_RAPID && (follows || phase == NCK_ROUGH_COPY);
}

// A block to the machine position; a move to where the tool stands is none.
static nck_status_t give(nck_decode_t *self, nck_block_kind_t kind, const int64_t *to_nm,
                         nck_block_t *out) {
    int moves = kind == NCK_BLOCK_ARC;
    for (unsigned k = 0; k < 2; k++) {
        moves = moves || self->place.position_nm[along_of[k]] != to_nm[k];
        self->place.position_nm[along_of[k]] = to_nm[k];
    }
    if (!moves) return NCK_EMPTY;
    const double feed = self->held.rough.feed;
    if (is_contour(self, kind)) nck_decode_give_within(self, kind, feed, out);
    else nck_decode_give_exact(self, kind, feed, out);
    return NCK_OK;
}

nck_status_t nck_follow_go(nck_decode_t *self, nck_block_kind_t kind, double a, double d,
                           nck_block_t *out) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    const nck_rough_t *const rough = &self->held.rough;
    const unsigned along = rough->along;
    int64_t to_nm[2];
    to_nm[along] = self->held.contour.start_nm[along_of[along]] + rough->sign[0] * nck_nm_of(a);
    to_nm[1 - along] =
        self->held.contour.start_nm[along_of[1 - along]] + rough->sign[1] * nck_nm_of(d);
    return give(self, kind, to_nm, out);
}

static nck_block_kind_t approach_of(const nck_decode_t *self) {
    const int rapid = self->held.contour.rapid && self->held.rough.levels == 0;
    return rapid ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE;
}

// Places before the contour, in its own direction, and beside them, upright on it: from there
// radius compensation begins, so that the tool keeps its distance from the first place on.
//
//     beside ┐
//            ▼
//     before ├───▶ first
static void lead_in(const nck_decode_t *self, double *before, double *beside) {
    const double way = beyond * self->held.rough.spare;
    double first[2], heading[2];
    nck_level_place(self, 0, first);
    nck_level_heading(self, 1, 0, heading);
    for (unsigned k = 0; k < 2; k++) before[k] = first[k] - way * heading[k];
    beside[0] = before[0] - way * heading[1];
    beside[1] = before[1] + way * heading[0];
}

// ---- along the contour

// 2_toolcomp keeps the distance. left: 1 where the tool is left of the contour.
static nck_status_t give_side(const nck_decode_t *self, double spare, nck_block_t *out) {
    if (!(self->held.rough.spare > 0.0)) return NCK_EMPTY;
    nck_decode_block(self, NCK_BLOCK_COMP, out);
    out->output.value = nck_level_turn(self, 1.0) * spare;
    return NCK_OK;
}

static nck_status_t go_beside(nck_decode_t *self, nck_block_t *out) {
    double before[2], beside[2];
    lead_in(self, before, beside);
    self->held.rough.phase = NCK_ROUGH_SIDE;
    if (!(self->held.rough.spare > 0.0)) return NCK_EMPTY;
    return nck_follow_go(self, approach_of(self), beside[0], beside[1], out);
}

static nck_status_t begin_side(nck_decode_t *self, nck_block_t *out) {
    self->held.rough.phase = NCK_ROUGH_BEFORE;
    return give_side(self, self->held.rough.spare, out);
}

static nck_status_t go_before(nck_decode_t *self, nck_block_t *out) {
    double before[2], beside[2];
    lead_in(self, before, beside);
    self->held.rough.phase = NCK_ROUGH_ENTER;
    if (!(self->held.rough.spare > 0.0)) return NCK_EMPTY;
    return nck_follow_go(self, NCK_BLOCK_LINE, before[0], before[1], out);
}

static nck_status_t enter(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    const nck_block_kind_t kind = rough->spare > 0.0 ? NCK_BLOCK_LINE : approach_of(self);
    double first[2];
    nck_level_place(self, 0, first);
    rough->phase = NCK_ROUGH_FOLLOW;
    rough->element = 1;
    rough->part = 0;
    rough->top = first[1];
    return nck_follow_go(self, kind, first[0], first[1], out);
}

// An element as it was recorded, shifted.
static nck_status_t give_element(nck_decode_t *self, uint32_t k, nck_block_t *out) {
    const nck_rough_t *const rough = &self->held.rough;
    const nck_element_t *const element = &self->held.contour.element[k];
    const int rapid = k == 0 && self->held.contour.rapid;
    int64_t to_nm[2];
    for (unsigned axis = 0; axis < 2; axis++) {
        to_nm[axis] = element->to_nm[axis] + nck_nm_of(rough->shift_mm[axis]);
    }
    if (element->sweep_rad == 0.0) {
        return give(self, rapid ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE, to_nm, out);
    }
    const nck_status_t status = give(self, NCK_BLOCK_ARC, to_nm, out);
    for (unsigned axis = 0; axis < 2; axis++) {
        const double tool_mm = nck_real_of(self->place.tool_nm[along_of[axis]]) / 1e6;
        const double shift_mm = (double)nck_nm_of(rough->shift_mm[axis]) / 1e6;
        out->centre_mm[1 - axis] = element->centre_mm[axis] + shift_mm - tool_mm;
    }
    out->sweep_rad = element->sweep_rad;
    out->plane = 18;
    return status;
}

// A slant from the tool's place on.
static nck_status_t give_slant(nck_decode_t *self, const nck_slant_t *slant, nck_block_t *out) {
    const nck_rough_t *const rough = &self->held.rough;
    double at[2], centre[2];
    nck_follow_place(self, at);
    if (!(slant->r > 0.0)) {
        return nck_follow_go(self, NCK_BLOCK_LINE, slant->a[1], slant->d[1], out);
    }
    const double from[2] = {at[0] - slant->ca, at[1] - slant->cd};
    const double to[2] = {slant->a[1] - slant->ca, slant->d[1] - slant->cd};
    const double sweep = nck_atan2(nck_arc_outer(from, to), nck_arc_inner(from, to));
    const nck_status_t status = nck_follow_go(self, NCK_BLOCK_ARC, slant->a[1], slant->d[1], out);
    centre[rough->along] = (double)rough->sign[0] * slant->ca;
    centre[1 - rough->along] = (double)rough->sign[1] * slant->cd;
    for (unsigned axis = 0; axis < 2; axis++) {
        const int64_t zero_nm = self->held.contour.start_nm[along_of[axis]]
                                - self->place.tool_nm[along_of[axis]];
        out->centre_mm[1 - axis] = nck_real_of(zero_nm) / 1e6 + centre[axis];
    }
    out->sweep_rad = nck_level_turn(self, 1.0) * sweep;
    out->plane = 18;
    return status;
}

// Over the pockets: what lies below the way so far is passed at its height.
static nck_status_t bridge(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    nck_slant_t slant;
    double at[2];
    if (rough->element >= self->held.contour.count) {
        double last[2];
        nck_level_place(self, self->held.contour.count - 1, last);
        rough->phase = NCK_ROUGH_LEAVE;
        return nck_follow_go(self, NCK_BLOCK_LINE, last[0], rough->top, out);
    }
    if (!nck_level_slant(self, rough->element, rough->part, &slant)) {
        rough->element++;
        rough->part = 0;
        return NCK_EMPTY;
    }
    nck_follow_place(self, at);
    const double rises = slant.d[1] - rough->top;
    if (rises > tiny && slant.a[0] + 1e-5 < nck_level_at(&slant, rough->top)) {
        slant.a[0] = nck_level_at(&slant, rough->top);
    }
    if (rises > tiny && at[0] < slant.a[0] - 1e-5) {
        return nck_follow_go(self, NCK_BLOCK_LINE, slant.a[0], rough->top, out);
    }
    rough->part++;
    if (rises <= tiny) return NCK_EMPTY;
    rough->top = slant.d[1];
    return give_slant(self, &slant, out);
}

static nck_status_t follow(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    if (rough->levels > 0 && !rough->is_pocket) return bridge(self, out);
    if (rough->element >= self->held.contour.count) {
        rough->phase = NCK_ROUGH_LEAVE;
        return NCK_EMPTY;
    }
    return give_element(self, rough->element++, out);
}

static nck_status_t leave(nck_decode_t *self, nck_block_t *out) {
    self->held.rough.phase = NCK_ROUGH_OUT;
    return give_side(self, 0.0, out);
}

static nck_status_t go_out(nck_decode_t *self, nck_block_t *out) {
    double at[2], heading[2];
    nck_follow_place(self, at);
    nck_level_heading(self, self->held.contour.count - 1, 1, heading);
    self->held.rough.phase = NCK_ROUGH_OVER;
    // Beside the contour the tool is not where it is told to be.
    const nck_rough_t *const rough = &self->held.rough;
    const int bridged = heading[1] < 0.0 && rough->levels > 0 && !rough->is_pocket;
    if (!bridged) at[0] -= heading[1] * rough->spare;
    return nck_follow_go(self, NCK_BLOCK_RAPID, at[0], self->held.rough.highest, out);
}

// The contour may be higher than the start: over it first.
static nck_status_t go_over(nck_decode_t *self, nck_block_t *out) {
    self->held.rough.phase = NCK_ROUGH_HOME;
    if (!(self->held.rough.highest > 0.0)) return NCK_EMPTY;
    return nck_follow_go(self, NCK_BLOCK_RAPID, 0.0, self->held.rough.highest, out);
}

// To the start; G70 may go along the contour again.
static nck_status_t go_home(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    int64_t to_nm[2];
    for (unsigned k = 0; k < 2; k++) to_nm[k] = self->held.contour.start_nm[along_of[k]];
    rough->pass++;
    rough->spare += rough->spare_step;
    const int again = self->held.contour.count > 0 && rough->pass < rough->passes;
    rough->phase = again ? NCK_ROUGH_LEVEL : 0;
    return give(self, NCK_BLOCK_RAPID, to_nm, out);
}

// ---- G73: the contour again and again, from further away to where it is

static nck_status_t shift(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    const double left = (double)(rough->passes - 1 - rough->pass) / (double)(rough->passes - 1);
    int64_t to_nm[2];
    for (unsigned k = 0; k < 2; k++) {
        const double way_mm = left * nck_real_of(rough->pattern_nm[k]) / 1e6;
        rough->shift_mm[k] = rough->spare_mm[k] + way_mm;
        to_nm[k] = self->held.contour.start_nm[along_of[k]] + nck_nm_of(rough->shift_mm[k]);
    }
    rough->element = 0;
    rough->phase = NCK_ROUGH_COPY;
    return give(self, NCK_BLOCK_RAPID, to_nm, out);
}

static nck_status_t copy(nck_decode_t *self, nck_block_t *out) {
    nck_rough_t *const rough = &self->held.rough;
    if (rough->element < self->held.contour.count) return give_element(self, rough->element++, out);
    rough->pass++;
    rough->phase = rough->pass < rough->passes ? NCK_ROUGH_SHIFT : NCK_ROUGH_HOME;
    return NCK_EMPTY;
}

nck_status_t nck_follow_next(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    static const nck_step_function_t phases[NCK_ROUGH_PHASES - NCK_ROUGH_BESIDE] = {
        go_beside, begin_side, go_before, enter, follow, leave, go_out, go_over, go_home, shift,
        copy
    };
    return phases[self->held.rough.phase - NCK_ROUGH_BESIDE](self, out);
}

void nck_follow_begin(const nck_decode_t *self, double *place_out) {
    if (!NCK_HAS_CONTOUR) return;
    double before[2];
    lead_in(self, before, place_out);
}
