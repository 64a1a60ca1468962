// SPDX-License-Identifier: MIT
// The room's door: text in pieces → lines → blocks one by one.
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_block nck_decode_fail …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_foreign
#include "nck/prep/1_decode/modal/modal.h" // nck_decode_centre nck_decode_change …
#include "nck/prep/1_decode/place/place.h" // nck_decode_comp nck_decode_layout …
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_call nck_decode_state …
#include "nck/prep/1_decode/motion/motion.h" // nck_corner_missing nck_corner_next …
#include "nck/prep/1_decode/lathe/lathe.h" // nck_contour_behind nck_contour_check …
#include "nck/prep/1_decode/cycle/cycle.h" // nck_decode_cycle
#include "nck/prep/1_decode/line/line.h" // nck_decode_block_good nck_decode_excuse …

#include <string.h> // memchr memcmp memcpy memset

enum { FOREIGN_LINES = 100 }; // a foreign language shows itself at the beginning

static nck_status_t fail_last(nck_decode_t *self, nck_status_t code, double value) {
    self->text.over = 1;
    return nck_decode_fail(self, code, 0, 0, value, 0.0);
}

// A line that begins with %: the first of a text opens the program, the next one ends it. Without
// the first one, and with something behind the %, it is a remark.
static nck_status_t percent_line(nck_decode_t *self, const char *at) {
    const int hint = nck_decode_foreign(at);
    if (hint != 0) return fail_last(self, NCK_E_DIALECT, hint);
    do at++; while (*at == ' ' || *at == '\t');
    if (*at != '\n') return NCK_OK;
    if (!self->text.begun) self->text.percent = 1;
    else if (self->text.percent) self->text.closed = NCK_CLOSED_BY_PERCENT;
    return NCK_OK;
}

// A line that cannot be read: too long, of another language, or simply wrong.
static nck_status_t unreadable(nck_decode_t *self, nck_status_t status) {
    const int early = self->line.number <= FOREIGN_LINES;
    const int hint = early ? nck_decode_foreign(self->line.text) : 0;
    if (hint != 0) return fail_last(self, NCK_E_DIALECT, hint);
    if (!self->line.overflow) return status;
    return nck_decode_fail(self, NCK_E_LINE_LENGTH, 0, 0, NCK_LINE_MAX, NCK_LINE_MAX);
}

// Where the line begins, behind a byte order mark and blanks.
static const char *begin_of_line(const nck_decode_t *self) {
    const char *at = self->line.text;
    if (self->line.number == 1 && memcmp(at, "\xef\xbb\xbf", 3) == 0) at += 3;
    while (*at == ' ' || *at == '\t') at++;
    return at;
}

// The lines are a contour's, or a corner is in work.
static int is_watched(const nck_decode_t *self) {
    return self->held.contour.mode != NCK_CONTOUR_NOT;
}

static int has_contour(const nck_decode_t *self) {
    return (self->held.contour.mode & NCK_CONTOUR_LINES) != 0;
}

static nck_status_t read_watched(nck_decode_t *self) {
    const int has = has_contour(self);
    nck_status_t status = has ? nck_contour_words(self) : NCK_OK;
    if (status == NCK_OK) status = nck_decode_resolve(self);
    if (status == NCK_OK && has) status = nck_contour_check(self);
    return status == NCK_OK ? nck_corner_words(self) : status;
}

// What the line says from its first word on.
static nck_status_t read_words(nck_decode_t *self, const char *at) {
    nck_status_t status = NCK_OK;
    if (self->tongue == NCK_TONGUE_LINUXCNC) status = nck_decode_remarks(self, at);
    if (self->text.closed != NCK_CLOSED_NOT) return NCK_OK;
    if (status == NCK_OK) status = nck_decode_words(self, at);
    if (status != NCK_OK || (self->line.overflow && !self->words.tail)) {
        self->text.words = 1;
        return unreadable(self, status);
    }
    const int says = self->words.codes != 0 || self->words.polars != 0;
    if (!says && !(self->words.letters & ~NCK_LETTER('N'))) return NCK_OK;
    self->text.words = 1;
    return is_watched(self) ? read_watched(self) : nck_decode_resolve(self);
}

static nck_status_t read_line(nck_decode_t *self) {
    const int is_binary = self->line.binary || memchr(self->line.text, '\0', self->line.size);
    if (is_binary) return fail_last(self, NCK_E_BINARY, 0.0);
    const char *const at = begin_of_line(self);
    if (*at == '\n') return NCK_OK;
    if (*at == '%') {
        const nck_status_t status = percent_line(self, at);
        self->text.begun = 1;
        return status;
    }
    self->text.begun = 1;
    const char *behind = at;
    const int skips = *at == '/' && nck_decode_skips(self, &behind);
    return skips ? NCK_OK : read_words(self, behind);
}

static void release_line(nck_decode_t *self) {
    self->line.state = NCK_LINE_OPEN;
    self->line.size = 0;
    self->line.overflow = 0;
    self->line.binary = 0;
    self->words.steps = 0;
}

// Settings that give no block and have no function of their own: G9, G53.
static nck_status_t nothing(nck_decode_t *self, nck_block_t *out) {
    (void)self;
    (void)out;
    return NCK_EMPTY;
}

static nck_status_t rest(nck_decode_t *self, nck_block_t *out) {
    switch (self->words.rest) {
    case NCK_REST_SECOND: return nck_decode_second(self, out);
    case NCK_REST_PUSHED: return nck_decode_give_pushed(self, out);
    case NCK_REST_CORNER: return nck_corner_next(self, out);
    default: return nck_decode_cycle(self, out);
    }
}

// G28 and G30 move; the others of their group do not.
static nck_status_t offset(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_OFFSET];
    if (code == 280 || code == 300) return nck_decode_reference(self, out);
    return nck_decode_offset(self);
}

// Where the program ends, what follows is looked at.
static nck_status_t stop(nck_decode_t *self, nck_block_t *out) {
    const nck_status_t status = nck_decode_stop(self, out);
    if (status == NCK_OK && out->kind == NCK_BLOCK_END) nck_decode_watch(self);
    return status;
}

// Do the steps of the line until one gives a block.
static nck_status_t run_steps(nck_decode_t *self, nck_block_t *out) {
    static const nck_step_function_t steps[NCK_STEP_COUNT] = {
        nck_decode_units, nck_decode_feed_mode, nck_decode_feed, nck_decode_speed_mode,
        nck_decode_speed, nck_decode_tool, nck_decode_port, nck_decode_change, nck_decode_spindle,
        nck_decode_state, nck_decode_mist, nck_decode_flood, nck_decode_override, nck_decode_own,
        nck_decode_dwell, nck_decode_plane, nck_decode_diameter, nck_decode_comp, nck_decode_length,
        nck_decode_work, nck_decode_path, nck_decode_distance, nck_decode_centre,
        nck_decode_retract, nck_decode_layout, offset, nothing, nothing,
        nck_decode_motion, rest, nck_decode_call, stop
    };
    nck_status_t status = NCK_EMPTY;
    unsigned step = 0;
    while (status == NCK_EMPTY && self->words.steps != 0) {
        while (!(self->words.steps >> step & 0xffu)) step += 8;
        while (!(self->words.steps >> step & 1u)) step++;
        self->words.steps &= ~NCK_STEP(step);
        status = steps[step](self, out);
    }
    return status;
}

static nck_status_t fail_line(nck_decode_t *self, nck_status_t status) {
    nck_decode_find(self, &self->finding.error);
    nck_decode_tell_calls(self);
    if (self->macro.jumped) self->text.over = 1; // the same mistake would come again and again
    nck_decode_excuse(self);
    nck_spline_break(self);
    release_line(self);
    return status;
}

// Lines are to come: of a contour, a corner or a spline.
static int waits_for_lines(const nck_decode_t *self) {
    return is_watched(self) || nck_spline_waits(self);
}

// The text is used up, or what closes it has been read: % or (abort, …).
static nck_status_t end_program(nck_decode_t *self, int closes, nck_block_t *out) {
    if (waits_for_lines(self)) {
        nck_status_t status = NCK_OK;
        if (!is_watched(self)) status = nck_spline_missing(self);
        else if (has_contour(self)) status = nck_contour_missing(self);
        else status = nck_corner_missing(self);
        return fail_line(self, status);
    }
    if (!self->text.words) return fail_line(self, fail_last(self, NCK_E_NO_PROGRAM, 0.0));
    if (!closes) nck_decode_assume(self, NCK_NOTE_NO_END);
    nck_decode_block(self, NCK_BLOCK_END, out);
    out->output.kind = NCK_OUTPUT_M;
    out->output.value = 2.0;
    self->text.over = 1;
    if (!closes) return NCK_OK;
    self->text.watch = self->text.closed == NCK_CLOSED_BY_PERCENT;
    if (self->text.watch) nck_decode_watch(self);
    return NCK_OK;
}

// The line that waits, or the block in its place, is taken into work.
static nck_status_t begin_line(nck_decode_t *self) {
    const uint8_t state = self->line.state;
    if (state == NCK_LINE_RUNNING) return NCK_OK;
    self->line.state = NCK_LINE_RUNNING;
    self->text.quick = 0;
    self->words.steps = 0;
    if (state == NCK_LINE_WAITING) {
        self->line.tag = self->line.number;
        return read_line(self);
    }
    self->text.begun = 1;
    self->text.words = 1;
    return nck_decode_pushed(self);
}

// No line waits: the next one of the source, or the end. NCK_OK: a line waits.
static nck_status_t next_line(nck_decode_t *self, nck_block_t *out) {
    nck_macro_t *const macro = &self->macro;
    if (macro->reads && !self->text.complete) {
        nck_decode_fetch(self);
        macro->idle += macro->seek.kind == NCK_SEEK_NOT;
        if (self->line.state != NCK_LINE_OPEN) return NCK_OK;
    }
    if (macro->seek.kind == NCK_SEEK_NOT) return end_program(self, 0, out);
    const nck_status_t status = nck_seek_wrap(self);
    return status == NCK_OK ? NCK_EMPTY : fail_line(self, status);
}

// What a line has given, or that it gave nothing.
static nck_status_t end_steps(nck_decode_t *self, nck_status_t status, nck_block_t *out) {
    if (status < 0) return fail_line(self, status);
    if (self->words.steps == 0) release_line(self);
    if (status == NCK_OK) {
        self->macro.idle = 0;
        return NCK_OK;
    }
    if (self->macro.idle > NCK_DECODE_IDLE_MOST) {
        const double most = NCK_DECODE_IDLE_MOST;
        self->text.over = 1;
        return fail_line(self, nck_decode_fail(self, NCK_E_ENDLESS, 0, 0, most, most));
    }
    return self->text.complete && !self->text.over ? next_line(self, out) : status;
}

// What a line gives while a corner is in work. Behind a move that is held its other steps follow.
static nck_status_t pass_corner(nck_decode_t *self, nck_status_t status, nck_block_t *out) {
    nck_status_t now = status;
    if (!(self->held.contour.mode & NCK_CONTOUR_CORNER)) return now;
    now = nck_corner_take(self, now, out);
    if (now != NCK_EMPTY || self->words.steps == 0) return now;
    now = run_steps(self, out);
    return nck_corner_take(self, now, out);
}

// What a contour's line gives is recorded, unless it is to be done. Behind the last line the cycle
// begins.
static nck_status_t pull_contour(nck_decode_t *self, nck_status_t status, nck_block_t *out) {
    while (status == NCK_OK && (self->held.contour.mode & NCK_CONTOUR_READS)) {
        status = nck_contour_take(self, out);
        if (status == NCK_OK) status = pass_corner(self, run_steps(self, out), out);
    }
    status = nck_contour_behind(self, status);
    const int goes_on = status == NCK_EMPTY && self->words.steps != 0;
    return goes_on ? run_steps(self, out) : status;
}

static nck_status_t fail_entry(nck_decode_t *self, nck_status_t status) {
    self->text.over = 1;
    return fail_line(self, status);
}

// The line in work, or the one that waits.
static nck_status_t do_line(nck_decode_t *self, nck_block_t *out) {
    nck_status_t status = begin_line(self);
    if (status == NCK_OK && self->text.closed) {
        release_line(self);
        return end_program(self, 1, out);
    }
    if (status == NCK_OK) status = run_steps(self, out);
    if (is_watched(self)) {
        const nck_status_t now = pass_corner(self, status, out);
        status = has_contour(self) ? pull_contour(self, now, out) : now;
    }
    return end_steps(self, status, out);
}

// Give a line that only moves straight, in a mode that does: seen at once, so that arcs pay
// nothing. 0: the line that waits is none, or no line waits.
static inline int give_quick(nck_decode_t *self, nck_block_t *out) {
    enum { LINE = 10 }; // in tenths; no motion is between G0 and G1, and none at all is below 0
    const int straight = (uint32_t)self->modal.motion <= LINE;
    if (!straight || self->line.state != NCK_LINE_WAITING || self->text.over) return 0;
    if (!nck_decode_quick(self, out)) return 0;
    release_line(self);
    self->macro.idle = 0;
    return 1;
}

// The line in work, or the one that waits and is not left out; before it what the program begins
// with.
static nck_status_t pull_line(nck_decode_t *self, nck_block_t *block_out) {
    const int seeks = NCK_HAS_CALLS && self->macro.seek.kind != NCK_SEEK_NOT;
    if (seeks && self->line.state == NCK_LINE_WAITING) {
        // A line on the way of a jump is not read. NCK_OK: the jump ends at it, and it is to be
        // done.
        const nck_seek_kind_t kind = (nck_seek_kind_t)self->macro.seek.kind;
        self->line.tag = self->line.number;
        const nck_status_t ends = nck_seek_pass(self);
        nck_entry_leave_out(self, kind);
        if (ends != NCK_OK) return end_steps(self, ends, block_out);
    }
    if (self->entry.waits != NCK_ENTRY_NOT && nck_entry_is_here(self)) {
        const nck_status_t entry = nck_entry_next(self, block_out);
        if (entry != NCK_EMPTY) return entry < 0 ? fail_entry(self, entry) : entry;
    }
    return do_line(self, block_out);
}

// The block of a line that give_quick has refused, or that the room reads itself.
static nck_status_t pull_block(nck_decode_t *self, nck_block_t *block_out) {
    if (self->text.over) return NCK_DONE;
    if (self->line.state == NCK_LINE_OPEN) {
        if (!self->text.complete && !self->macro.reads) return NCK_EMPTY;
        const nck_status_t next = next_line(self, block_out);
        if (self->line.state == NCK_LINE_OPEN) return next;
        if (give_quick(self, block_out)) return NCK_OK;
    }
    return pull_line(self, block_out);
}

static nck_status_t pull_any(nck_decode_t *self, nck_block_t *out) {
    if (self->entry.waits == 0) return pull_block(self, out);
    // The same of a program that begins in the middle: what comes before is passed.
    nck_status_t status = NCK_EMPTY;
    do {
        nck_entry_begin(self);
        status = pull_block(self, out);
        const int before = self->entry.waits != 0 && self->entry.phase == 0;
        if (status == NCK_OK && before) {
            status = nck_entry_pass(self, out);
            if (status < 0) status = fail_entry(self, status);
        }
    } while (status == NCK_EMPTY && self->line.state == NCK_LINE_RUNNING);
    return status;
}

// NCK_EMPTY: pull again.
static nck_status_t try_line(nck_decode_t *self, nck_block_t *out) {
    const nck_status_t status = pull_any(self, out);
    if (status < NCK_OK) {
        // The line that waits leaves nothing: as if it had never been, but that its error is told.
        const nck_diagnostic_t error = self->finding.error;
        nck_session_go_back(self);
        nck_decode_find(self, &error);
        release_line(self);
        self->session.passes = 0;
        return status;
    }
    if (self->line.state != NCK_LINE_OPEN) return NCK_EMPTY;
    nck_session_go_back(self);
    self->session.phase = NCK_SESSION_DOES;
    return NCK_EMPTY;
}

// In a session, of a line that is no quick one: tried, then done.
static nck_status_t pull_session(nck_decode_t *self, nck_block_t *out) {
    const int waits = self->line.state == NCK_LINE_WAITING || self->line.state == NCK_LINE_PUSHED;
    if (waits && self->session.phase == NCK_SESSION_NOT) {
        *self->session.before = *self;
        self->session.phase = NCK_SESSION_TRIES;
    }
    if (self->session.phase == NCK_SESSION_TRIES) return try_line(self, out);
    const nck_status_t status = pull_any(self, out);
    // The line is done. What leaves nothing in force has moved the axes, and that is all.
    if (self->line.state == NCK_LINE_OPEN) {
        if (self->session.passes && self->session.phase == NCK_SESSION_DOES) {
            int64_t position_nm[NCK_AXIS_MAX];
            memcpy(position_nm, self->place.position_nm, sizeof position_nm);
            nck_session_go_back(self);
            memcpy(self->place.position_nm, position_nm, sizeof position_nm);
            release_line(self);
            self->session.passes = 0;
        }
        self->session.phase = NCK_SESSION_NOT;
    }
    return status;
}

nck_status_t nck_decode_pull(nck_decode_t *self, nck_block_t *block_out) {
    if (nck_decode_needs_text(self)) return NCK_EMPTY;
    if (give_quick(self, block_out)) return NCK_OK;
    if (self->session.before) return pull_session(self, block_out);
    return pull_any(self, block_out);
}

nck_status_t nck_decode_diagnostic(nck_decode_t *self, nck_diagnostic_t *diagnostic_out) {
    if (self->finding.count == 0) return NCK_EMPTY;
    self->finding.count--;
    *diagnostic_out = self->finding.queue[self->finding.count];
    for (uint32_t k = self->finding.count; k > 0; k--) { // each takes the place before it
        const nck_diagnostic_t behind = *diagnostic_out;
        *diagnostic_out = self->finding.queue[k - 1];
        self->finding.queue[k - 1] = behind;
    }
    return NCK_OK;
}

nck_status_t nck_decode_push_block(nck_decode_t *self, const nck_block_in_t *block) {
    if (!nck_decode_block_good(block)) return NCK_E_ARGUMENT;
    if (self->text.complete || self->text.over || self->macro.reads) return NCK_E_STATE;
    if (waits_for_lines(self)) return NCK_E_STATE;
    if (self->line.state != NCK_LINE_OPEN) return NCK_FULL;
    if (!nck_decode_is_empty(self)) return NCK_E_STATE; // in the middle of a line
    self->pushed = *block;
    self->line.tag = block->id;
    self->line.state = NCK_LINE_PUSHED;
    return NCK_OK;
}

static int axis_good(const nck_decode_t *self, unsigned axis) {
    const int64_t zero = self->place.outer_nm[axis]
                         + self->place.work_nm[self->place.work_system][axis];
    const int64_t tool = axis < 3 ? self->place.tool_nm[axis] : 0;
    const int64_t limit = (self->place.rotary >> axis & 1u) ? self->place.scale[2].limit
                                                            : self->place.scale[0].limit;
    const int64_t at = self->place.position_nm[axis];
    return self->place.origin_nm[axis] == zero + self->place.g92_nm[axis] + tool
           && at >= -limit && at <= limit;
}

static int cycle_works(const nck_decode_t *self) {
    if (!NCK_HAS_CYCLES) return 0;
    return self->held.cycle.holes != 0 || self->held.turn.left != 0 || self->held.peck.phase != 0
           || self->held.screw.phase != 0 || self->held.rough.phase != 0
           || self->held.spline.works;
}

int nck_decode_invariants(const nck_decode_t *self) {
    int good = self->line.size <= NCK_LINE_MAX && self->line.state <= NCK_LINE_PUSHED
               && self->finding.count <= NCK_DECODE_FINDINGS
               && self->place.work_system <= NCK_WORK_SYSTEMS
               && (self->line.state == NCK_LINE_RUNNING || self->words.steps == 0)
               && (!cycle_works(self) || (self->words.steps & NCK_STEP(NCK_STEP_REST)))
               && nck_variable_invariants(self);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) good = good && axis_good(self, axis);
    return good;
}
