// SPDX-License-Identifier: MIT
// Threading cycles: Fanuc's G92 (system B: G78, C: G21) and G76 in one line and in two, RS274NGC's
// G76. Each pass:
//
//     start ◀──── 4 ──── ┐            1 rapid along Z to where the pass begins
//     1 │                │ 3          2 rapid in X, then the pass with the spindle
//       └───── 2 ─────── ┘ or ╱       3 rapid out, or pulled out while the pass ends
#include "nck/prep/1_decode/lathe/lathe.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_step …
#include "nck/prep/1_decode/number/number.h" // nck_decode_increments nck_decode_length_word …
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_moved
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_give_exact nck_decode_lead …
#include "nck/base/real.h" // nck_fabs nck_min nck_max nck_nm_of nck_real_of
#include "nck/base/trig_math.h" // NCK_PI
#include "nck/base/trig.h" // nck_sincos

enum { PHASE_ALONG = 1, PHASE_IN, PHASE_CUT, PHASE_OUT, PHASE_BACK, PASSES_MOST = 1000 };

#define NM 1e6
#define HUNDRED 100

static nck_status_t fail_missing(nck_decode_t *self, char letter) {
    return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_MOTION, letter,
                                nck_decode_thread_name(self), 0.0);
}

// A word that must be there and more than 0.
static nck_status_t read_positive(nck_decode_t *self, char letter, double scale, double *out) {
    if (!nck_has_word(self, letter)) return fail_missing(self, letter);
    *out = nck_word_real(self, letter) * scale;
    if (*out > 0.0 && *out <= (double)NCK_LINEAR_MAX_MM) return NCK_OK;
    return nck_decode_fail_range(self, letter, 0.0);
}

// A length of Fanuc's.
static nck_status_t read_length(nck_decode_t *self, char letter, double *out) {
    int64_t size_nm = 0;
    const nck_status_t status = nck_decode_length_word(self, letter, &size_nm);
    *out = nck_real_of(size_nm) / NM;
    return status;
}

// A whole number of least increments: with a point it would mean something else.
static nck_status_t read_increments(nck_decode_t *self, char letter, double *out) {
    int64_t size_nm = 0;
    if (!nck_decode_increments(self, letter, &size_nm) || size_nm < 0) {
        return nck_decode_fail_range(self, letter, NCK_DECODE_VALUE_MAX);
    }
    *out = nck_real_of(size_nm) / NM;
    return NCK_OK;
}

// ---- Fanuc's first line of G76

// P in three pairs of digits: passes at full depth, tenths of a lead to pull out over, the angle.
static nck_status_t read_pairs(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    int64_t word = 0;
    if (!nck_has_word(self, 'P')) return NCK_OK;
    if (!nck_number_whole(&self->words.number['P' - 'A'], 0, &word) || word < 0 || word > 999999) {
        return nck_decode_fail_range(self, 'P', 999999.0);
    }
    const int64_t angle = word % HUNDRED;
    const int known = angle == 0 || angle == 29 || angle == 30 || angle == 55 || angle == 60
                      || angle == 80;
    if (!known || word / (HUNDRED * HUNDRED) == 0) {
        return nck_decode_fail_range(self, 'P', 999999.0);
    }
    screw->angle = (uint8_t)angle;
    screw->pull = (uint8_t)(word / HUNDRED % HUNDRED);
    screw->springs = (uint32_t)(word / (HUNDRED * HUNDRED));
    screw->set = 1;
    return NCK_OK;
}

static nck_status_t set_screw(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    nck_status_t status = read_pairs(self);
    if (status == NCK_OK && nck_has_word(self, 'Q')) {
        status = read_increments(self, 'Q', &screw->least);
    }
    if (status == NCK_OK && nck_has_word(self, 'R')) {
        status = read_length(self, 'R', &screw->allowance);
    }
    if (status == NCK_OK && screw->allowance < 0.0) status = nck_decode_fail_range(self, 'R', 0.0);
    return status == NCK_OK ? NCK_EMPTY : status;
}

// ---- what a cycle is to do

// The tangent of an angle below 90°.
static double tangent(double degrees) {
    double sine, cosine;
    nck_sincos(degrees * NCK_PI / 180.0, &sine, &cosine);
    return sine / cosine;
}

// X and Z of the end, machine positions; they hold for G92.
static nck_status_t read_end(nck_decode_t *self) {
    static const uint8_t axes[2] = {NCK_AXIS_X, NCK_AXIS_Z};
    static const char letters[2] = {'X', 'Z'};
    nck_screw_t *const screw = &self->held.screw;
    nck_turn_t *const turn = &self->held.turn;
    const int holds = self->words.code[NCK_STEP_MOTION] == NCK_MOTION_THREAD;
    int64_t target_nm[NCK_AXIS_MAX];
    const nck_status_t status = nck_decode_target(self, 0, target_nm);
    if (status != NCK_OK) return status;
    for (unsigned k = 0; k < 2; k++) {
        const int said = (int)(self->words.axes >> axes[k] & 1u);
        const int needs = self->lathe || k == 1;
        const int64_t origin_nm = self->place.origin_nm[axes[k]];
        screw->start_nm[k] = self->place.position_nm[axes[k]];
        if (said && holds) {
            turn->end_nm[k] = target_nm[axes[k]] - origin_nm;
            turn->said |= (uint8_t)(1u << k);
        }
        const int held = holds && (turn->said >> k & 1u);
        if (needs && !said && !held) return fail_missing(self, letters[k]);
        screw->end_nm[k] = held ? turn->end_nm[k] + origin_nm : target_nm[axes[k]];
    }
    return NCK_OK;
}

// Which way X goes in, by the sign of what lies there.
static void go_in(nck_screw_t *screw, double way) { screw->in = way < 0.0 ? -1.0 : 1.0; }

// G92: one pass at X, with a taper R (older: I).
static nck_status_t read_single(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    const char letter = nck_has_word(self, 'I') ? 'I' : 'R';
    if (nck_has_word(self, 'I') && nck_has_word(self, 'R')) {
        return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'I', 0.0, 0.0);
    }
    if (nck_has_word(self, letter)) {
        const nck_status_t status = nck_decode_length_word(self, letter, &self->held.turn.taper_nm);
        if (status != NCK_OK) return status;
    }
    screw->taper = nck_real_of(self->held.turn.taper_nm) / NM;
    screw->full = 0.0;
    screw->first = 0.0;
    screw->rough = 0.0;
    screw->left = 0;
    screw->slope = 0.0;
    screw->exit = screw->lead * self->machine->dialect.thread_pull;
    return nck_decode_start_angle(self, &screw->turn);
}

// The second of two G76 lines: R taper, P depth, Q first cut, F lead.
static nck_status_t read_second_line(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    if (!screw->set) return fail_missing(self, 'P');
    if (!nck_has_word(self, 'P')) return fail_missing(self, 'P');
    if (!nck_has_word(self, 'Q')) return fail_missing(self, 'Q');
    nck_status_t status = read_increments(self, 'P', &screw->full);
    if (status == NCK_OK) status = read_increments(self, 'Q', &screw->first);
    screw->taper = 0.0;
    if (status == NCK_OK && nck_has_word(self, 'R')) status = read_length(self, 'R', &screw->taper);
    if (status != NCK_OK) return status;
    screw->rough = screw->full - screw->allowance;
    screw->left = screw->springs;
    screw->step_least = screw->least;
    screw->slope = tangent(0.5 * (double)screw->angle);
    screw->exit = screw->lead * (double)screw->pull / 10.0;
    return NCK_OK;
}

// G76 in one line: K depth, D first cut, A angle, I taper, F lead. D without a point is a length on
// some controls and increments on others.
static nck_status_t read_one_line(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    nck_status_t status = read_length(self, 'K', &screw->full);
    if (status == NCK_OK && screw->full <= 0.0) status = nck_decode_fail_range(self, 'K', 0.0);
    if (status == NCK_OK) status = read_positive(self, 'D', nck_unit_mm(self), &screw->first);
    screw->taper = 0.0;
    if (status == NCK_OK && nck_has_word(self, 'I')) status = read_length(self, 'I', &screw->taper);
    if (status != NCK_OK) return status;
    if (self->words.number['D' - 'A'].decimals <= 0) return nck_decode_fail_range(self, 'D', 0.0);
    const double angle = nck_has_word(self, 'A') ? nck_word_real(self, 'A') : 0.0;
    if (angle < 0.0 || angle > 120.0) return nck_decode_fail_range(self, 'A', 120.0);
    screw->rough = screw->full;
    screw->left = 0;
    screw->step_least = 0.0;
    screw->slope = tangent(0.5 * angle);
    screw->exit = screw->lead * self->machine->dialect.thread_pull;
    return NCK_OK;
}

static nck_status_t read_fanuc(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    const int single = self->words.code[NCK_STEP_MOTION] == NCK_MOTION_THREAD;
    double lead = 0.0;
    nck_status_t status = read_end(self);
    if (status == NCK_OK) status = nck_decode_lead(self, 'F', &lead);
    if (status != NCK_OK) return status;
    screw->power = 0.5;
    screw->entry = 0.0;
    screw->turn = 0.0f;
    screw->goes_back = 1;
    if (single) status = read_single(self);
    else if (nck_has_word(self, 'K')) status = read_one_line(self);
    else status = read_second_line(self);
    if (status != NCK_OK) return status;
    go_in(screw, nck_real_of(screw->end_nm[0] - screw->start_nm[0]));
    screw->end_nm[0] -= nck_nm_of(screw->in * screw->full); // to the crest: said is the root
    return NCK_OK;
}

// E, the way along Z over which the tool goes in (L1, L3) and out (L2, L3).
static nck_status_t read_tapers(nck_decode_t *self) {
    int64_t ends = 0;
    double length = 0.0;
    nck_status_t status = nck_decode_whole(self, 'L', 3, 0, &ends);
    if (status != NCK_OK || ends == 0) return status;
    status = read_positive(self, 'E', nck_unit_mm(self), &length);
    self->held.screw.entry = ends & 1 ? length : 0.0;
    self->held.screw.exit = ends & 2 ? length : 0.0;
    return status;
}

// R, the degression of depths, and Q, the angle at which they go in.
static nck_status_t read_infeed(nck_decode_t *self) {
    const double degression = nck_has_word(self, 'R') ? nck_word_real(self, 'R') : 1.0;
    const double angle = nck_has_word(self, 'Q') ? nck_word_real(self, 'Q') : 0.0;
    if (!nck_has_word(self, 'I')) return fail_missing(self, 'I');
    if (!(degression >= 1.0)) return nck_decode_fail_range(self, 'R', 1.0);
    if (angle < 0.0 || angle > 80.0) return nck_decode_fail_range(self, 'Q', 80.0);
    self->held.screw.slope = tangent(angle);
    self->held.screw.power = 1.0 / degression;
    return NCK_OK;
}

// RS274NGC: P lead, Z end, I from the drive line to the crest, J first cut, K depth, H springs.
// Under G7 I, J and K are diameters.
static nck_status_t read_rs274(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    const double size = self->modal.diameter ? 0.5 * nck_unit_mm(self) : nck_unit_mm(self);
    int64_t springs = 0;
    nck_status_t status = read_infeed(self);
    if (status == NCK_OK) status = read_end(self);
    if (status == NCK_OK) status = nck_decode_lead(self, 'P', &screw->lead);
    if (status == NCK_OK) status = read_positive(self, 'J', size, &screw->first);
    if (status == NCK_OK) status = read_positive(self, 'K', size, &screw->full);
    if (status == NCK_OK) status = nck_decode_whole(self, 'H', PASSES_MOST, 0, &springs);
    screw->entry = 0.0;
    screw->exit = 0.0;
    if (status == NCK_OK) status = read_tapers(self);
    const double drive = nck_word_real(self, 'I') * size;
    const double most = (double)NCK_LINEAR_MAX_MM;
    if (status == NCK_OK && !(nck_fabs(drive) <= most)) {
        status = nck_decode_fail_range(self, 'I', most);
    }
    if (status != NCK_OK) return status;
    go_in(screw, drive);
    screw->end_nm[0] = screw->start_nm[0] + nck_nm_of(drive);
    screw->taper = 0.0;
    screw->rough = screw->full;
    screw->left = (uint32_t)springs;
    screw->step_least = 0.0;
    screw->turn = 0.0f;
    screw->goes_back = 0;
    return NCK_OK;
}

// The depth of the next pass; the step to it may be held up. Behind the rough ones: full.
static double next_depth(const nck_screw_t *screw) {
    if (screw->depth >= screw->rough) return screw->full;
    const double n = (double)(screw->pass + 1);
    const double wanted = screw->first * nck_power(n, screw->power);
    return nck_min(screw->rough, nck_max(wanted, screw->depth + screw->step_least));
}

// What the code is for the lines behind it. NCK_OK: a cycle begins; NCK_EMPTY: the line only says
// what holds for one.
static nck_status_t begin_mode(nck_decode_t *self) {
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    const int holds = code == NCK_MOTION_THREAD;
    if (holds && self->modal.motion != code) {
        self->held.turn.said = 0;
        self->held.turn.taper_nm = 0;
    }
    if (holds) self->modal.motion = code;
    else if (!self->lathe) self->modal.motion = NCK_MOTION_NONE;
    if (self->words.axes != 0) return NCK_OK;
    if (holds) return fail_missing(self, 'X');
    return self->lathe ? set_screw(self) : fail_missing(self, 'Z');
}

static nck_status_t read_cycle(nck_decode_t *self) {
    const char first = !self->lathe ? 'J' : nck_has_word(self, 'K') ? 'D' : 'Q';
    nck_status_t status = self->lathe ? read_fanuc(self) : read_rs274(self);
    if (status == NCK_OK) status = nck_decode_thread_fits(self);
    if (status != NCK_OK) return status;
    // Depths are told, and passes are not without number.
    const nck_screw_t *const screw = &self->held.screw;
    const double most = screw->first * nck_power((double)PASSES_MOST, screw->power);
    const int steps = screw->step_least * (double)PASSES_MOST >= screw->full;
    if (screw->full == 0.0) return NCK_OK;
    if (!(screw->first > 0.0) || !(most >= screw->full || steps)) {
        return nck_decode_fail_range(self, first, screw->full);
    }
    if (screw->rough < 0.0) return nck_decode_fail_range(self, 'R', screw->full);
    return NCK_OK;
}

static nck_status_t begin(nck_decode_t *self) {
    nck_screw_t *const screw = &self->held.screw;
    const int holds = self->words.code[NCK_STEP_MOTION] == NCK_MOTION_THREAD;
    nck_status_t status = begin_mode(self);
    if (status != NCK_OK) return status;
    nck_decode_assume(self, NCK_NOTE_UNITS);
    if (holds && self->machine->dialect.system == NCK_SYSTEM_OPEN) {
        nck_decode_assume(self, NCK_NOTE_SYSTEM);
    }
    status = read_cycle(self);
    if (status != NCK_OK) return status;
    nck_decode_moved(self);
    screw->pass = 0;
    screw->depth = 0.0;
    screw->depth = next_depth(screw);
    screw->pass = 1;
    screw->phase = PHASE_ALONG;
    return NCK_EMPTY;
}

// ---- a pass

// Which way Z goes.
static double forward(const nck_screw_t *screw) {
    return screw->end_nm[1] < screw->start_nm[1] ? -1.0 : 1.0;
}

static nck_status_t rapid_to(nck_decode_t *self, unsigned axis, int64_t place_nm,
                             nck_block_t *out) {
    if (self->place.position_nm[axis] == place_nm) return NCK_EMPTY;
    const nck_status_t status = nck_decode_travel(self, axis, place_nm);
    self->place.position_nm[axis] = place_nm;
    if (status != NCK_OK) return status;
    nck_decode_give_exact(self, NCK_BLOCK_RAPID, 0.0, out);
    return NCK_OK;
}

// X of the pass where it begins and ends, at its depth.
static int64_t cut_x(const nck_screw_t *screw, int at_begin) {
    const double beside = screw->in * screw->depth + (at_begin ? screw->taper : 0.0);
    return screw->end_nm[0] + nck_nm_of(beside);
}

// The pass. A taper at its begin: it goes in from the crest; at its end: out to where X began.
static nck_status_t cut(nck_decode_t *self, nck_block_t *out) {
    const nck_screw_t *const screw = &self->held.screw;
    const double back = screw->slope * (screw->full - screw->depth);
    const int64_t x_nm = cut_x(screw, 0);
    nck_thread_t thread = {0};
    int64_t end_nm[NCK_AXIS_MAX];
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        end_nm[axis] = self->place.position_nm[axis];
    }
    end_nm[NCK_AXIS_Z] = screw->end_nm[1] - nck_nm_of(forward(screw) * back);
    end_nm[NCK_AXIS_X] = screw->exit > 0.0 ? screw->start_nm[0] : x_nm;
    thread.lead = screw->lead;
    thread.turn = screw->turn;
    thread.entry = (float)screw->entry;
    thread.exit = (float)screw->exit;
    thread.enter = nck_real_of(cut_x(screw, 1) - self->place.position_nm[NCK_AXIS_X]) / NM;
    thread.leave = nck_real_of(end_nm[NCK_AXIS_X] - x_nm) / NM;
    const double along = nck_real_of(end_nm[NCK_AXIS_Z] - self->place.position_nm[NCK_AXIS_Z]) / NM;
    const double across = nck_real_of(x_nm - cut_x(screw, 1)) / NM;
    thread.length = nck_max(nck_fabs(along), nck_fabs(across));
    return nck_decode_pass(self, end_nm, &thread, out);
}

// Another pass, or the end.
static void next_pass(nck_screw_t *screw) {
    const int rough = screw->depth < screw->rough;
    screw->phase = PHASE_ALONG;
    if (!rough && screw->left == 0 && screw->depth >= screw->full) {
        screw->phase = screw->goes_back ? PHASE_BACK : 0;
        return;
    }
    if (!rough && screw->left > 0) screw->left--;
    screw->depth = next_depth(screw);
    screw->pass++;
}

static nck_status_t do_phase(nck_decode_t *self, nck_block_t *out) {
    nck_screw_t *const screw = &self->held.screw;
    const double ahead = forward(screw) * screw->slope * screw->depth;
    switch (screw->phase) {
    case PHASE_ALONG:
        screw->phase = PHASE_IN;
        return rapid_to(self, NCK_AXIS_Z, screw->start_nm[1] + nck_nm_of(ahead), out);
    case PHASE_IN:
        screw->phase = PHASE_CUT;
        return rapid_to(self, NCK_AXIS_X,
                        screw->entry > 0.0 ? screw->end_nm[0] + nck_nm_of(screw->taper)
                                           : cut_x(screw, 1),
                        out);
    case PHASE_CUT: screw->phase = PHASE_OUT; return cut(self, out);
    case PHASE_OUT:
        next_pass(screw);
        return rapid_to(self, NCK_AXIS_X, screw->start_nm[0], out);
    default:
        screw->phase = 0;
        return rapid_to(self, NCK_AXIS_Z, screw->start_nm[1], out);
    }
}

nck_status_t nck_decode_screw(nck_decode_t *self, nck_block_t *out) {
    nck_screw_t *const screw = &self->held.screw;
    if (self->words.code[NCK_STEP_MOTION] == NCK_MOTION_PASS) {
        return nck_decode_single_pass(self, out);
    }
    if (self->words.code[NCK_STEP_MOTION] == NCK_MOTION_TAP) {
        return nck_decode_single_tap(self, out);
    }
    nck_status_t status = screw->phase == 0 ? begin(self) : NCK_EMPTY;
    while (status == NCK_EMPTY && screw->phase != 0) status = do_phase(self, out);
    if (status < NCK_OK) {
        screw->phase = 0;
        self->modal.motion = NCK_MOTION_REFUSED; // one mistake, one finding
    }
    if (screw->phase != 0) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
