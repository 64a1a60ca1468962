// SPDX-License-Identifier: MIT
// Canned cycles of drilling, boring and tapping: G73 G74 G81 … G86 G89; of Fanuc's lathes G83 …
// G85 along Z, G87 … G89 along X.
#include "nck/prep/1_decode/cycle/cycle.h"
#include "nck/prep/1_decode/cycle/bore.h"
#include "nck/prep/1_decode/cycle/height.h"
#include "nck/prep/1_decode/cycle/ring.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail …
#include "nck/prep/1_decode/number/number.h" // nck_decode_asks_unit nck_decode_fail_range …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_follows
#include "nck/prep/1_decode/modal/modal.h" // nck_decode_dwell_word
#include "nck/prep/1_decode/place/place.h" // nck_decode_target nck_layout_says_radius …
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_moved
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_cutting_feed nck_decode_cycle_fits …
#include "nck/prep/1_decode/lathe/lathe.h" // nck_decode_peck nck_decode_contour_cycle …
#include "nck/base/arc_math.h" // nck_plane_axis

#include <stddef.h> // NULL
#include <string.h> // memcmp memcpy

enum {
    COUNT_MOST = 1000000, CIRCLE_MOST = 1000,
    CLEARANCE_NM = 254000 // between pecks the drill backs off by LinuxCNC's 0.010 inch
};

// What a cycle does beside its cut to the bottom.
enum { PECKS = 1, CLEARS = 2, DWELLS = 4, STOPS = 8, FEEDS_OUT = 16, TAPS = 32, SHIFTS = 64 };

// Beside the letters of words that hold: P was said where the drill pecks. The P of a cycle before
// is none of a peck's.
#define PECK_RESTS ((uint32_t)1 << 31)

// The parts of a hole in their order.
enum {
    PHASE_TURN, PHASE_RISE, PHASE_OVER, PHASE_DOWN, PHASE_CUT, PHASE_BACK, PHASE_RETURN,
    PHASE_DWELL, PHASE_STOP, PHASE_FEED_OUT, PHASE_CLEAR, PHASE_START, PHASES
};

static int pecks(const nck_decode_t *self, int32_t code) {
    return self->lathe && (code == NCK_MOTION_PECK_Z || code == NCK_MOTION_PECK_X);
}

static int turns(int32_t code) { return code == NCK_MOTION_TURN || code == NCK_MOTION_FACE; }

static int drills(const nck_decode_t *self, int32_t code) {
    if (nck_bore_has(self, code)) return 1;
    return !nck_decode_follows(self, code) && !turns(code) && !pecks(self, code)
           && !nck_motion_cuts_threads(code) && !nck_motion_is_spline(code)
           && !nck_motion_probes(code);
}

// G83 G84 G85 along Z, G87 G88 G89 along X. Its pecks go back a little, as bit 2 of Fanuc's
// parameter 5101 has them where nobody has set it.
static uint8_t lathe_does(const nck_decode_t *self, int32_t code) {
    switch (code) {
    case NCK_MOTION_TAP_RIGHT:
    case NCK_MOTION_TAP_SIDE: return TAPS;
    case 850:
    case 890: return DWELLS | FEEDS_OUT;
    default: {
        const uint32_t said = self->words.letters | self->held.cycle.said;
        return (said & NCK_LETTER('Q')) ? DWELLS | PECKS : DWELLS;
    }
    }
}

static uint8_t does_of(int32_t code) {
    static const struct {
        uint16_t code;
        uint8_t does;
    } cycles[] = {
        {730, PECKS}, {NCK_MOTION_TAP_LEFT, TAPS}, {820, DWELLS}, {830, PECKS | CLEARS},
        {NCK_MOTION_TAP_RIGHT, TAPS}, {850, FEEDS_OUT}, {860, DWELLS | STOPS},
        {890, DWELLS | FEEDS_OUT},
        {NCK_MOTION_SCREW, DWELLS | STOPS | SHIFTS}, {NCK_MOTION_BORE_BACK, DWELLS | STOPS | SHIFTS}
    };
    for (unsigned k = 0; k < sizeof cycles / sizeof cycles[0]; k++) {
        if (cycles[k].code == code) return cycles[k].does;
    }
    return 0; // G81
}

// ---- words

// Words hold while the cycle does: in RS274NGC the same one, in Fanuc's language any. Of
// another drill they would mean another axis.
static void keep_or_forget(nck_decode_t *self, int32_t before) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    const unsigned drill = self->lathe ? nck_motion_drill_of_lathe(code)
                                       : nck_plane_axis(self->modal.plane, 2);
    const int cycled = nck_motion_is_cycle(before) && drills(self, before) && cycle->drill == drill;
    if (!cycled || (code != before && !nck_is_fanuc(self))) cycle->said = 0;
    if (!cycled) {
        cycle->initial_nm = self->place.position_nm[drill] - self->place.origin_nm[drill];
    }
    cycle->drill = drill;
    cycle->does = self->lathe ? lathe_does(self, code) : does_of(code);
}

// What Q says is the depth of a peck, or the cycle drills nothing.
static nck_status_t read_peck(nck_decode_t *self) {
    int64_t peck_nm = 0;
    nck_status_t status = NCK_OK;
    if (nck_decode_asks_unit(self, 'Q')) {
        status = nck_decode_fail_word(self, NCK_E_SCALE_UNIT, 'Q', nck_word_real(self, 'Q'), 0.0);
    } else {
        status = nck_decode_length_word(self, 'Q', &peck_nm);
        if (status == NCK_OK && peck_nm <= 0) status = nck_decode_fail_range(self, 'Q', 0.0);
    }
    if (status == NCK_OK) {
        self->held.cycle.peck_nm = peck_nm;
    } else {
        self->modal.motion = NCK_MOTION_REFUSED; // one mistake, one finding
    }
    return status;
}

// Q and P, where the cycle has them.
static nck_status_t read_rest(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const uint32_t said = self->words.letters & (NCK_LETTER('Q') | NCK_LETTER('P'));
    nck_status_t status = (said & NCK_LETTER('Q')) != 0 ? read_peck(self) : NCK_OK;
    if (status == NCK_OK && (said & NCK_LETTER('P'))) {
        status = nck_decode_dwell_word(self, 'P', &cycle->dwell_s);
        cycle->said &= ~PECK_RESTS;
        if (cycle->does & PECKS) cycle->said |= PECK_RESTS;
    }
    cycle->said |= said;
    return status;
}

// The spindle of a tap turns as the cycle wants it, or in Fanuc's language it is told to. What it
// has in a revolution is its lead.
static nck_status_t read_lead(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const uint8_t code = self->modal.motion == NCK_MOTION_TAP_LEFT ? 4 : 3;
    const int is_on = self->modal.spindle_on && self->modal.spindle_code == code;
    cycle->turns = is_on ? 0 : code;
    if (!is_on && !nck_is_fanuc(self)) return nck_cycle_missing(self, 'M');
    self->modal.spindle_on = 1;
    self->modal.spindle_code = code;
    nck_status_t status = nck_decode_thread_fits(self);
    if (status == NCK_OK) status = nck_decode_cutting_feed(self, 0, &cycle->feed);
    if (status != NCK_OK) return status;
    const int per_rev = self->modal.feed_mode == NCK_FEED_PER_REV;
    cycle->lead = per_rev ? cycle->feed : cycle->feed / self->modal.speed;
    return NCK_OK;
}

// What the cycle cannot do without. Fanuc's dwells are 0 until P is said.
static nck_status_t check_rest(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int timed = (cycle->said & NCK_LETTER('P')) != 0;
    if (!timed) cycle->dwell_s = 0.0;
    const int pecks_on = (cycle->does & PECKS) != 0;
    if (pecks_on && !(cycle->said & NCK_LETTER('Q'))) return nck_cycle_missing(self, 'Q');
    if (pecks_on && self->lathe) nck_decode_assume(self, NCK_NOTE_PECK);
    const int rests = (cycle->does & DWELLS) && !nck_is_fanuc(self);
    if (rests && !timed) return nck_cycle_missing(self, 'P');
    if (cycle->does & TAPS) return read_lead(self);
    const int stands = (cycle->does & STOPS) && !self->modal.spindle_on;
    return stands ? nck_cycle_missing(self, 'M') : NCK_OK;
}

// How many holes: L, in Fanuc's language K too; there 0 only keeps the words.
static nck_status_t read_count(nck_decode_t *self, int64_t *count_out) {
    const uint32_t both = NCK_LETTER('K') | NCK_LETTER('L');
    const char letter = self->words.letters & NCK_LETTER('K') ? 'K' : 'L';
    if ((self->words.letters & both) == both) {
        return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'K', 0.0, 0.0);
    }
    const nck_status_t status = nck_decode_whole(self, letter, COUNT_MOST, 1, count_out);
    if (status != NCK_OK || *count_out > 0 || nck_is_fanuc(self)) return status;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, 0.0, COUNT_MOST);
}

// The place that the words name, the drill left out.
static nck_status_t next_hole(nck_decode_t *self) {
    const uint32_t axes = self->words.axes;
    if (self->words.polars != 0) nck_polar_next(self);
    self->words.axes = axes & ~((uint32_t)1 << self->held.cycle.drill);
    const nck_status_t status = nck_decode_target(self, 0, self->held.cycle.hole_nm);
    self->words.axes = axes;
    return status;
}

// Holes on a circle: the angle is said in steps. Each of them is looked at before the first.
static nck_status_t check_circle(nck_decode_t *self, int64_t count, int64_t *last_nm) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const nck_layout_t layout = self->layout;
    const double at[2] = {self->words.polar_at[0], self->words.polar_at[1]};
    const unsigned drill = cycle->drill;
    int64_t first_nm[NCK_AXIS_MAX];
    nck_status_t status = NCK_OK;
    memcpy(first_nm, cycle->hole_nm, sizeof first_nm);
    const int is_radius = self->words.polars == 0 && nck_layout_says_radius(self);
    if (count > CIRCLE_MOST || is_radius) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'K', (double)count, CIRCLE_MOST);
    }
    for (int64_t k = 1; k < count && status == NCK_OK; k++) {
        status = next_hole(self);
        for (unsigned axis = 0; axis < 3 && status == NCK_OK; axis++) {
            if (axis != drill) status = nck_decode_travel(self, axis, cycle->hole_nm[axis]);
        }
    }
    memcpy(last_nm, cycle->hole_nm, sizeof first_nm);
    memcpy(cycle->hole_nm, first_nm, sizeof first_nm);
    memcpy(self->words.polar_at, at, sizeof at);
    self->layout = layout;
    return status;
}

// The first hole, and the way from one to the next. last_nm: where the axes stand in the end.
static nck_status_t place_holes(nck_decode_t *self, int64_t count, int64_t *last_nm) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const uint32_t axes = self->words.axes;
    self->words.axes = axes & ~((uint32_t)1 << cycle->drill);
    nck_status_t status = nck_decode_target(self, 0, cycle->hole_nm);
    // The steps from hole to hole are of an angle.
    const int polar = ((self->layout.on & NCK_LAYOUT_POLAR) | self->words.polars) != 0;
    cycle->circles = count > 1 && self->modal.incremental && polar;
    memcpy(last_nm, cycle->hole_nm, sizeof cycle->hole_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && status == NCK_OK; axis++) {
        const int64_t way_nm = cycle->hole_nm[axis] - self->place.position_nm[axis];
        cycle->step_nm[axis] = self->modal.incremental ? way_nm : 0;
        if (!(self->words.axes >> axis & 1u)) continue;
        status = nck_decode_steps(self, axis, cycle->step_nm[axis],
                                  cycle->circles ? 0 : count - 1, &last_nm[axis]);
        if (status == NCK_OK) status = nck_decode_travel(self, axis, cycle->hole_nm[axis]);
        if (status == NCK_OK) status = nck_decode_travel(self, axis, last_nm[axis]);
    }
    self->words.axes = axes;
    if (cycle->circles && status == NCK_OK) status = check_circle(self, count, last_nm);
    last_nm[cycle->drill] = cycle->level_nm[NCK_LEVEL_CLEAR];
    return status;
}

// The same of a ring about the place that the line names.
static nck_status_t place_ring(nck_decode_t *self, int64_t count, int64_t *last_nm) {
    const nck_cycle_t *const cycle = &self->held.cycle;
    if (cycle->circles != NCK_CIRCLES_RING) return place_holes(self, count, last_nm);
    nck_status_t status = next_hole(self);
    if (status == NCK_OK) status = nck_ring_place(self, count, last_nm);
    last_nm[cycle->drill] = cycle->level_nm[NCK_LEVEL_CLEAR];
    return status;
}

static nck_status_t read_cycle(nck_decode_t *self, int64_t *count_out) {
    if (!(self->place.axes >> self->held.cycle.drill & 1u)) {
        const int letter = nck_decode_letter(self->held.cycle.drill);
        return nck_decode_fail(self, NCK_E_AXIS_UNKNOWN, 0, letter, 0.0, 0.0);
    }
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = nck_layout_spares(self, self->held.cycle.drill);
    if (status == NCK_OK) status = nck_cycle_heights(self);
    if (status == NCK_OK) status = read_rest(self);
    if (status == NCK_OK) status = check_rest(self);
    if (status == NCK_OK && (self->held.cycle.does & SHIFTS)) status = nck_bore_shift(self);
    if (status != NCK_OK || self->held.cycle.circles == NCK_CIRCLES_RING) return status;
    return read_count(self, count_out);
}

// Whether the line says where a hole is. In RS274NGC a code without an axis is a mistake; Fanuc's R
// alone drills, and a code alone says what the next lines do.
static int says_hole(const nck_decode_t *self) {
    return self->words.axes != 0 || self->held.cycle.circles == NCK_CIRCLES_RING
           || (nck_is_fanuc(self) && (self->words.letters & NCK_LETTER('R')));
}

// Everything is known before the first block.
static nck_status_t begin(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int32_t before = self->modal.motion;
    int64_t last_nm[NCK_AXIS_MAX], count = 0;
    const nck_status_t ring = nck_ring_begin(self, &count);
    if (ring != NCK_OK) return ring;
    self->modal.motion = self->words.code[NCK_STEP_MOTION];
    keep_or_forget(self, before);
    if (!says_hole(self)) return nck_is_fanuc(self) ? NCK_OK : nck_cycle_missing(self, 'X');
    nck_decode_assume_places(self);
    nck_decode_assume(self, NCK_NOTE_PLANE);
    nck_status_t status = read_cycle(self, &count);
    if (status != NCK_OK || count == 0) return status;
    status = place_ring(self, count, last_nm);
    if (status == NCK_OK) status = nck_bore_fits(self, last_nm);
    if (status != NCK_OK) return status;
    status = nck_decode_cutting_feed(self, 0, &cycle->feed);
    if (status != NCK_OK) {
        memcpy(self->place.position_nm, last_nm, sizeof last_nm);
        return status;
    }
    nck_decode_moved(self);
    cycle->holes = (uint32_t)count;
    cycle->phase = PHASE_TURN;
    return NCK_OK;
}

// ---- holes

static nck_status_t go(nck_decode_t *self, nck_block_kind_t kind, nck_block_t *out) {
    const nck_cycle_t *const cycle = &self->held.cycle;
    // A lathe bores out so.
    const int twice = self->lathe && kind == NCK_BLOCK_LINE && cycle->phase > PHASE_FEED_OUT;
    nck_decode_give_exact(self, kind, twice ? 2.0 * cycle->feed : cycle->feed, out);
    return NCK_OK;
}

// The drill alone to a level. Nothing to do where it stands there.
static nck_status_t drill_to(nck_decode_t *self, nck_block_kind_t kind, int64_t level_nm,
                             nck_block_t *out) {
    int64_t *const at_nm = &self->place.position_nm[self->held.cycle.drill];
    if (*at_nm == level_nm && kind == NCK_BLOCK_RAPID) return NCK_EMPTY;
    *at_nm = level_nm;
    return go(self, kind, out);
}

// To the bottom and back with the spindle.
static nck_status_t tap(nck_decode_t *self, nck_block_t *out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    int64_t bottom_nm[NCK_AXIS_MAX];
    memcpy(bottom_nm, self->place.position_nm, sizeof bottom_nm);
    bottom_nm[cycle->drill] = cycle->level_nm[NCK_LEVEL_BOTTOM];
    cycle->phase = PHASE_CLEAR;
    return nck_decode_tap(self, bottom_nm, cycle->lead, cycle->dwell_s, out);
}

// To the bottom, or by Q.
static nck_status_t cut(nck_decode_t *self, nck_block_t *out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    int64_t *const level_nm = cycle->level_nm;
    const int64_t left_nm = level_nm[NCK_LEVEL_CUT] - level_nm[NCK_LEVEL_BOTTOM];
    const int goes_on = (cycle->does & PECKS) && left_nm > cycle->peck_nm;
    level_nm[NCK_LEVEL_CUT] -= goes_on ? cycle->peck_nm : left_nm;
    if (!goes_on) cycle->phase = PHASE_DWELL;
    return drill_to(self, NCK_BLOCK_LINE, level_nm[NCK_LEVEL_CUT], out);
}

// Above what is cut, never above R.
static int64_t back_nm(const nck_cycle_t *cycle) {
    const int64_t level_nm = cycle->level_nm[NCK_LEVEL_CUT] + CLEARANCE_NM;
    return level_nm < cycle->level_nm[NCK_LEVEL_R] ? level_nm : cycle->level_nm[NCK_LEVEL_R];
}

// M5 at the bottom, and what it was behind the way out.
static nck_status_t spindle(nck_decode_t *self, double code, nck_block_t *out) {
    if (!(self->held.cycle.does & STOPS)) return NCK_EMPTY;
    self->modal.spindle_on = code != 5.0;
    return nck_decode_give_m(self, code, out);
}

// The hole is done: the next one.
static void end_hole(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    cycle->holes--;
    cycle->level_nm[NCK_LEVEL_CUT] = cycle->level_nm[NCK_LEVEL_R];
    if (cycle->circles == NCK_CIRCLES_RING) {
        nck_ring_next(self);
        return;
    }
    if (cycle->circles) {
        if (cycle->holes > 0) (void)next_hole(self); // it was looked at
        return;
    }
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        cycle->hole_nm[axis] += cycle->step_nm[axis];
    }
}

static nck_status_t do_way(nck_decode_t *self, unsigned phase, nck_block_t *out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int64_t *const level_nm = cycle->level_nm;
    switch (phase) {
    case PHASE_TURN: {
        const uint8_t code = cycle->turns;
        cycle->turns = 0;
        return code != 0 ? nck_decode_give_m(self, code, out) : NCK_EMPTY;
    }
    case PHASE_RISE:
        if (self->place.position_nm[cycle->drill] >= level_nm[NCK_LEVEL_R]) return NCK_EMPTY;
        return drill_to(self, NCK_BLOCK_RAPID, level_nm[NCK_LEVEL_R], out);
    case PHASE_OVER:
        cycle->hole_nm[cycle->drill] = self->place.position_nm[cycle->drill];
        if (memcmp(self->place.position_nm, cycle->hole_nm, sizeof cycle->hole_nm) == 0) {
            return NCK_EMPTY;
        }
        memcpy(self->place.position_nm, cycle->hole_nm, sizeof cycle->hole_nm);
        return go(self, NCK_BLOCK_RAPID, out);
    case PHASE_DOWN: return drill_to(self, NCK_BLOCK_RAPID, level_nm[NCK_LEVEL_R], out);
    case PHASE_CUT: return cycle->does & TAPS ? tap(self, out) : cut(self, out);
    case PHASE_BACK:
        if (!(cycle->does & CLEARS)) return NCK_EMPTY;
        return drill_to(self, NCK_BLOCK_RAPID, level_nm[NCK_LEVEL_R], out);
    default: // PHASE_RETURN
        cycle->phase = PHASE_CUT;
        return drill_to(self, NCK_BLOCK_RAPID, back_nm(cycle), out);
    }
}

static nck_status_t do_bottom(nck_decode_t *self, unsigned phase, nck_block_t *out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    switch (phase) {
    case PHASE_DWELL: {
        const int peck_rests = (cycle->does & PECKS) && (cycle->said & PECK_RESTS);
        const int rests = (cycle->does & DWELLS) || peck_rests;
        if (!rests || !(cycle->dwell_s > 0.0)) return NCK_EMPTY;
        return nck_decode_give_dwell(self, cycle->dwell_s, out);
    }
    case PHASE_STOP: return spindle(self, 5.0, out);
    case PHASE_FEED_OUT: {
        // At feed up to R. RS274NGC's G89 goes on so, to where it retracts to.
        const int whole = (cycle->does & DWELLS) && !nck_is_fanuc(self); // no peck feeds out
        if (!(cycle->does & FEEDS_OUT)) return NCK_EMPTY;
        const unsigned level = whole ? NCK_LEVEL_CLEAR : NCK_LEVEL_R;
        return drill_to(self, NCK_BLOCK_LINE, cycle->level_nm[level], out);
    }
    case PHASE_CLEAR: return drill_to(self, NCK_BLOCK_RAPID, cycle->level_nm[NCK_LEVEL_CLEAR], out);
    default: // PHASE_START
        end_hole(self);
        cycle->phase = PHASE_OVER;
        return spindle(self, self->modal.spindle_code, out);
    }
}

static nck_status_t other_cycle(nck_decode_t *self, int32_t code, nck_block_t *out) {
    if (turns(code)) return nck_decode_turn(self, out);
    if (pecks(self, code)) return nck_decode_peck(self, out);
    if (nck_motion_is_spline(code)) return nck_decode_spline(self, out);
    if (nck_motion_probes(code)) return nck_decode_probe(self, out);
    return nck_motion_cuts_threads(code) ? nck_decode_screw(self, out)
                                         : nck_decode_contour_cycle(self, out);
}

nck_status_t nck_decode_cycle(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    nck_cycle_t *const cycle = &self->held.cycle;
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    if (!drills(self, code)) return other_cycle(self, code, out);
    nck_status_t status = cycle->holes == 0 ? begin(self) : NCK_OK;
    if (status == NCK_OK) status = NCK_EMPTY;
    while (status == NCK_EMPTY && cycle->holes > 0) { // a hole has a cut: PHASES times at most
        if (cycle->does & SHIFTS) {
            if (nck_bore_step(self, &status, out)) end_hole(self);
            continue;
        }
        const unsigned phase = cycle->phase++;
        status = phase < PHASE_DWELL ? do_way(self, phase, out) : do_bottom(self, phase, out);
    }
    if (status < NCK_OK) cycle->holes = 0;
    if (cycle->holes > 0) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
