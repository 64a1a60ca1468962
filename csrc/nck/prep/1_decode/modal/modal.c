// SPDX-License-Identifier: MIT
// Settings that stay in force, and what is not motion: outputs, dwell, stops.
#include "nck/prep/1_decode/modal/modal.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_missing …
#include "nck/prep/1_decode/number/number.h" // nck_decode_counts nck_decode_real_word …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_mode nck_decode_own_m …
#include "nck/base/budget.h" // NCK_TOLERANCE_MIN
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL

enum { CHANGE_WAITS = 1, SET_TOOL = 610 }; // code of M6 whose M5 has been given; M61

static const double value_max = NCK_DECODE_VALUE_MAX;
static const double dwell_max_s = NCK_DECODE_DWELL_MAX_S;
static const double linear_max_mm = NCK_LINEAR_MAX_MM;

static nck_status_t give_m(const nck_decode_t *self, nck_step_t step, nck_block_t *out) {
    return nck_decode_give_m(self, self->words.code[step] / 10, out);
}

nck_status_t nck_decode_units(nck_decode_t *self, nck_block_t *out) {
    const nck_words_t *const words = &self->words;
    const uint8_t inch = words->code[NCK_STEP_UNITS] == 200;
    const int mode_said = (words->codes & NCK_STEP(NCK_STEP_FEED_MODE)) != 0;
    const int inverse = mode_said ? words->code[NCK_STEP_FEED_MODE] == 930
                                  : self->modal.feed_mode == NCK_FEED_INVERSE;
    (void)out;
    if (inch != self->modal.inch && nck_has_word(self, 'F') && !inverse) {
        nck_decode_assume(self, NCK_NOTE_FEED_UNITS);
    }
    self->modal.inch_before = self->modal.inch;
    self->modal.inch = inch;
    self->finding.given |= 1u << NCK_NOTE_UNITS;
    nck_decode_scale(self);
    return NCK_EMPTY;
}

// A feed is meant for its mode: after a change the program has to say a new one.
nck_status_t nck_decode_feed_mode(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_FEED_MODE];
    const nck_feed_mode_t mode = code == 930   ? NCK_FEED_INVERSE
                                 : code == 940 ? NCK_FEED_PER_MINUTE
                                               : NCK_FEED_PER_REV;
    (void)out;
    if (self->modal.feed_mode != mode) {
        self->modal.feed = 0.0;
        self->modal.feed_word = 0.0;
    }
    self->modal.feed_mode = (uint8_t)mode;
    self->finding.given |= 1u << NCK_NOTE_FEED_MODE;
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_FEED;
    return NCK_EMPTY;
}

void nck_decode_set_feed(nck_decode_t *self, double feed, double word) {
    self->modal.feed = feed;
    self->modal.feed_word = word;
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_FEED;
}

// mm in the unit of F. RS274NGC sets the feed before the units; others read it in its line's.
static double feed_unit_mm(const nck_decode_t *self) {
    const int changes = (self->words.codes & NCK_STEP(NCK_STEP_UNITS)) != 0;
    if (self->modal.feed_mode == NCK_FEED_INVERSE) return 1.0;
    if (!changes || self->tongue != NCK_TONGUE_LINUXCNC) return nck_unit_mm(self);
    return self->modal.inch_before ? 25.4 : 1.0;
}

nck_status_t nck_decode_feed(nck_decode_t *self, nck_block_t *out) {
    const double value = nck_word_real(self, 'F');
    const double unit = feed_unit_mm(self);
    const double feed = value * unit;
    (void)out;
    if (self->lathe && self->machine->dialect.feed == NCK_FEED_START_OPEN) {
        nck_decode_assume(self, NCK_NOTE_FEED_MODE);
    }
    if (value <= 0.0 && self->tongue == NCK_TONGUE_MARLIN) {
        nck_decode_note_word(self, NCK_NOTE_FEED_KEPT, 'F', value);
        return NCK_EMPTY;
    }
    if (value < 0.0 || feed > value_max) {
        return nck_decode_fail_range(self, 'F', value_max / unit);
    }
    // Per minute no feed is slower than the slowest axis may be: a millimetre would take days.
    nck_range_t speed;
    nck_machine_range(NCK_QUANTITY_SPEED, &speed);
    const double least = self->modal.feed_mode == NCK_FEED_PER_MINUTE ? 60.0 * speed.low : 0.0;
    if (feed > 0.0 && feed < least) {
        return nck_decode_fail_range(self, 'F', least / unit);
    }
    nck_decode_set_feed(self, feed, value);
    return NCK_EMPTY;
}

// A tool is changed at rest (NISTIR 6556, M6): the spindle's stop goes before the wait, whether or
// not the program has started it.
nck_status_t nck_decode_change(nck_decode_t *self, nck_block_t *out) {
    // M61: the tool in the spindle is this one; nothing moves.
    if (self->words.code[NCK_STEP_CHANGE] == SET_TOOL) {
        int64_t number = 0;
        if (!nck_has_word(self, 'Q')) return nck_decode_fail_missing(self, NCK_STEP_CHANGE, 'Q');
        const nck_status_t status = nck_decode_whole(self, 'Q', NCK_DECODE_VALUE_MAX, 0, &number);
        if (status != NCK_OK) return status;
        const uint32_t tool = (uint32_t)number;
        const int unknown = self->machine->tool_count > 0
                            && nck_decode_find_tool(self, tool) == NULL;
        if (tool > 0 && unknown) {
            return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, 'Q', nck_real_of(number), 0.0);
        }
        self->modal.tool_in = tool;
        return NCK_EMPTY;
    }
    if (self->words.code[NCK_STEP_CHANGE] == CHANGE_WAITS) {
        return nck_decode_give_output(self, NCK_BLOCK_WAIT, NCK_OUTPUT_M, 6.0, out);
    }
    self->modal.tool_in = self->modal.tool_next;
    self->modal.spindle_on = 0;
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_SPEED;
    self->words.code[NCK_STEP_CHANGE] = CHANGE_WAITS;
    self->words.steps |= NCK_STEP(NCK_STEP_CHANGE);
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_M, 5.0, out);
}

nck_status_t nck_decode_spindle(nck_decode_t *self, nck_block_t *out) {
    self->modal.spindle_on = self->words.code[NCK_STEP_SPINDLE] != 50;
    self->modal.spindle_code = (uint8_t)(self->words.code[NCK_STEP_SPINDLE] / 10);
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_SPEED;
    return give_m(self, NCK_STEP_SPINDLE, out);
}

nck_status_t nck_decode_mist(nck_decode_t *self, nck_block_t *out) {
    self->modal.coolant |= 1;
    return give_m(self, NCK_STEP_MIST, out);
}

nck_status_t nck_decode_flood(nck_decode_t *self, nck_block_t *out) {
    const int off = self->words.code[NCK_STEP_FLOOD] == 90;
    self->modal.coolant = off ? 0 : (uint8_t)(self->modal.coolant | 2u);
    return give_m(self, NCK_STEP_FLOOD, out);
}

// M48 and M49; M50 to M53 with P 0 or 1, and without it 1, are handed over like a port.
nck_status_t nck_decode_override(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_OVERRIDE];
    int64_t on = 1;
    if (!NCK_HAS_FOREIGN || code < 500) return give_m(self, NCK_STEP_OVERRIDE, out);
    const nck_status_t status = nck_decode_whole(self, 'P', 1, 1, &on);
    if (status != NCK_OK) return status;
    (void)nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_SETTING, nck_real_of(on), out);
    out->output.number = code / 10;
    return NCK_OK;
}

// What the machine does at its own M codes is its own: the code is handed over.
nck_status_t nck_decode_own(nck_decode_t *self, nck_block_t *out) {
    if (self->words.code[NCK_STEP_OWN] >= NCK_CODE_OWN_G) {
        nck_decode_own_mode(self);
        return NCK_EMPTY;
    }
    const int code = self->words.code[NCK_STEP_OWN] / 10;
    const nck_own_m_t *const own = nck_decode_own_m(self, code);
    const int waits = own != NULL && own->waits;
    if (own == NULL && nck_printer_speaks(self)) return nck_decode_printer(self, out);
    return nck_decode_give_output(self, waits ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT, NCK_OUTPUT_M,
                                  code, out);
}

// The word that times a dwell, 0 if there is none: P; in Fanuc's language also X or U, in Marlin's
// S, which Klipper does not hear.
static char dwell_letter(const nck_decode_t *self) {
    const uint32_t base = self->machine->dialect.base;
    const int hears = self->machine->firmware != NCK_FIRMWARE_KLIPPER;
    if (base == NCK_DIALECT_MARLIN && hears && nck_has_word(self, 'S')) return 'S';
    if (nck_has_word(self, 'P')) return 'P';
    if (base == NCK_DIALECT_FANUC && nck_has_word(self, 'X')) return 'X';
    if (base == NCK_DIALECT_FANUC && nck_has_word(self, 'U')) return 'U';
    return 0;
}

// P is in seconds, in Fanuc's and Marlin's languages in milliseconds, but with a point in Haas' in
// seconds, and Fanuc has none; the other words are in seconds.
nck_status_t nck_decode_dwell_word(nck_decode_t *self, char letter, double *dwell_out) {
    const uint32_t base = self->machine->dialect.base;
    const int whole = base == NCK_DIALECT_FANUC && !nck_decode_says_point(self, letter);
    const int millisecond = whole || base == NCK_DIALECT_MARLIN;
    const int counts = letter == 'P';
    const double word = counts ? nck_word_real(self, letter) : nck_decode_real_word(self, letter);
    const double dwell_s = counts && millisecond ? word / 1000.0 : word;
    if (!(word >= 0.0 && dwell_s <= dwell_max_s)) {
        const double unit = counts ? (millisecond ? 1000.0 : 1.0) : nck_decode_counts(self, letter);
        return nck_decode_fail_range(self, letter, dwell_max_s * unit);
    }
    *dwell_out = dwell_s;
    return NCK_OK;
}

nck_status_t nck_decode_dwell(nck_decode_t *self, nck_block_t *out) {
    const char letter = dwell_letter(self);
    double dwell_s = 0.0;
    const int waits = self->tongue == NCK_TONGUE_MARLIN; // until all that is before it is done
    if (letter == 0 && waits) return nck_decode_give_dwell(self, 0.0, out);
    if (letter == 0) return nck_decode_fail_missing(self, NCK_STEP_DWELL, 'P');
    const nck_status_t status = nck_decode_dwell_word(self, letter, &dwell_s);
    return status == NCK_OK ? nck_decode_give_dwell(self, dwell_s, out) : status;
}

nck_status_t nck_decode_plane(nck_decode_t *self, nck_block_t *out) {
    (void)out;
    self->modal.plane = (uint8_t)(self->words.code[NCK_STEP_PLANE] / 10);
    self->finding.given |= 1u << NCK_NOTE_PLANE;
    return NCK_EMPTY;
}

nck_status_t nck_decode_diameter(nck_decode_t *self, nck_block_t *out) {
    (void)out;
    self->modal.diameter = self->words.code[NCK_STEP_DIAMETER] == 70;
    nck_decode_scale(self);
    return NCK_EMPTY;
}

// G64 without P means the machine's tolerance. That the path stays exact is noted: within one that
// is too small, and under a slope that knows none where P or this build asks for one.
static double read_tolerance(nck_decode_t *self) {
    const int says = nck_has_word(self, 'P');
    const double tolerance =
        says ? nck_word_real(self, 'P') * nck_unit_mm(self) : nck_decode_plain_mm(self);
    const int is_exact = !NCK_HAS_OPTIMAL || (says && self->machine->slope != NCK_SLOPE_OPTIMAL);
    if (tolerance >= NCK_TOLERANCE_MIN) {
        if (is_exact) nck_decode_note_code(self, NCK_NOTE_TOLERANCE, NCK_STEP_PATH, 64.0);
    } else if (tolerance >= 0.0) {
        if (says) nck_decode_note_word(self, NCK_NOTE_TOLERANCE, 'P', tolerance);
        else nck_decode_assume(self, NCK_NOTE_TOLERANCE);
    }
    return tolerance;
}

static nck_status_t set_exact(nck_decode_t *self, int stop) {
    self->modal.path_mode = stop ? NCK_PATH_STOP : NCK_PATH_EXACT;
    self->modal.tolerance_mm = 0.0;
    self->modal.merge_mm = 0.0;
    return NCK_EMPTY;
}

// G64 without Q: Q is the tolerance in force.
nck_status_t nck_decode_path(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_PATH];
    const int fanuc = nck_is_fanuc(self);
    (void)out;
    if (fanuc && code != 610 && code != 640) return nck_decode_mode(self);
    // Fanuc's G61 is exact stop, RS274NGC's is exact path.
    if (code != 640) return set_exact(self, code == 611 || fanuc);
    const double tolerance = read_tolerance(self);
    const double merge = nck_has_word(self, 'Q') ? nck_word_real(self, 'Q') * nck_unit_mm(self)
                                                 : tolerance;
    const int p_good = tolerance >= 0.0 && tolerance <= linear_max_mm;
    if (!p_good || merge < 0.0 || merge > linear_max_mm) {
        const char letter = p_good ? 'Q' : 'P';
        return nck_decode_fail_range(self, letter, linear_max_mm / nck_unit_mm(self));
    }
    self->modal.path_mode = NCK_PATH_CONTINUOUS;
    self->modal.tolerance_mm = tolerance;
    self->modal.merge_mm = merge;
    return NCK_EMPTY;
}

nck_status_t nck_decode_distance(nck_decode_t *self, nck_block_t *out) {
    (void)out;
    self->modal.incremental = self->words.code[NCK_STEP_DISTANCE] == 910;
    self->finding.given |= 1u << NCK_NOTE_DISTANCE;
    return NCK_EMPTY;
}

nck_status_t nck_decode_centre(nck_decode_t *self, nck_block_t *out) {
    (void)out;
    self->modal.centre_absolute = self->words.code[NCK_STEP_CENTRE] == 901;
    self->finding.given |= 1u << NCK_NOTE_ARC_CENTRE;
    return NCK_EMPTY;
}

nck_status_t nck_decode_retract(nck_decode_t *self, nck_block_t *out) {
    (void)out;
    self->held.cycle.to_r = self->words.code[NCK_STEP_RETRACT] == 990;
    return NCK_EMPTY;
}

nck_status_t nck_decode_stop(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_STOP];
    nck_block_kind_t kind = NCK_BLOCK_WAIT;
    double wait_s = 0.0;
    if (nck_printer_pauses(self, &wait_s)) return nck_decode_give_dwell(self, wait_s, out);
    const int optional = code == 10 && self->tongue != NCK_TONGUE_MARLIN; // whose M1 is its M0
    if (optional && !self->machine->dialect.optional_stop) kind = NCK_BLOCK_OUTPUT;
    if (code == 20 || code == 300) {
        if (nck_spline_waits(self)) return nck_spline_missing(self);
        kind = NCK_BLOCK_END;
        self->text.over = 1;
        self->text.watch = 1;
    }
    return nck_decode_give_output(self, kind, NCK_OUTPUT_M, code / 10, out);
}
