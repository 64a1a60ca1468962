// SPDX-License-Identifier: MIT
// The stable ids of statuses and notes.
#include "nck/base/status.h"

#include <stddef.h> // size_t
#include <string.h> // strlen

// Every code with its id. The ids stand one behind the other: no pointer to each is kept.
#define STATUSES(x)                       \
    x(NCK_OK, "ok")                       \
    x(NCK_EMPTY, "empty")                 \
    x(NCK_FULL, "full")                   \
    x(NCK_DONE, "done")                   \
    x(NCK_WAIT, "wait")                   \
    x(NCK_E_CHARACTER, "character")       \
    x(NCK_E_NUMBER, "number")             \
    x(NCK_E_NUMBER_RANGE, "number-range") \
    x(NCK_E_LINE_LENGTH, "line-length")   \
    x(NCK_E_COMMENT, "comment")           \
    x(NCK_E_WORD_UNKNOWN, "word-unknown") \
    x(NCK_E_WORD_TWICE, "word-twice")     \
    x(NCK_E_WORD_UNUSED, "word-unused")   \
    x(NCK_E_WORD_MISSING, "word-missing") \
    x(NCK_E_G_UNKNOWN, "g-unknown")       \
    x(NCK_E_M_UNKNOWN, "m-unknown")       \
    x(NCK_E_MODAL_GROUP, "modal-group")   \
    x(NCK_E_UNSUPPORTED, "unsupported")   \
    x(NCK_E_FEED_MISSING, "feed-missing") \
    x(NCK_E_ARC_RADIUS, "arc-radius")     \
    x(NCK_E_ARC_CENTRE, "arc-centre")     \
    x(NCK_E_ARC_CHORD, "arc-chord")       \
    x(NCK_E_AXIS_UNKNOWN, "axis-unknown") \
    x(NCK_E_TRAVEL, "travel")             \
    x(NCK_E_TOOL_UNKNOWN, "tool-unknown") \
    x(NCK_E_NO_MOTION, "no-motion")       \
    x(NCK_E_DIALECT, "dialect")           \
    x(NCK_E_BINARY, "binary")             \
    x(NCK_E_NO_PROGRAM, "no-program")     \
    x(NCK_E_WORD_SHARED, "word-shared")   \
    x(NCK_E_INCREMENTAL, "incremental")   \
    x(NCK_E_ARC_MODE, "arc-mode")         \
    x(NCK_E_EXPRESSION, "expression") \
    x(NCK_E_VALUE, "value")           \
    x(NCK_E_UNSET, "parameter-unset") \
    x(NCK_E_VARIABLES, "parameters-full")\
    x(NCK_E_DEPTH, "call-depth")      \
    x(NCK_E_LABEL, "label-missing")   \
    x(NCK_E_FLOW, "flow")             \
    x(NCK_E_NO_SEEK, "no-seek")       \
    x(NCK_E_ALARM, "alarm")           \
    x(NCK_E_ENDLESS, "endless")       \
    x(NCK_E_SPEED_LIMIT, "speed-limit") \
    x(NCK_E_CONTOUR, "contour")       \
    x(NCK_E_CONTOUR_FULL, "contour-full") \
    x(NCK_E_THREAD_SPEED, "thread-speed") \
    x(NCK_E_THREAD_RUN_IN, "thread-run-in") \
    x(NCK_E_COMP_ON, "comp-on")       \
    x(NCK_E_OTHER_BASE, "other-base") \
    x(NCK_E_COMP_PLANE, "comp-plane") \
    x(NCK_E_COMP_ENTRY, "comp-entry") \
    x(NCK_E_COMP_EXIT, "comp-exit")   \
    x(NCK_E_COMP_RADIUS, "comp-radius") \
    x(NCK_E_COMP_GOUGE, "comp-gouge") \
    x(NCK_E_LAYOUT_ON, "layout-on")   \
    x(NCK_E_SCALE_UNIT, "scale-unit") \
    x(NCK_E_SPLINE, "spline")         \
    x(NCK_E_CORNER, "corner")         \
    x(NCK_E_PROBE, "probe")           \
    x(NCK_E_APPROACH, "approach")     \
    x(NCK_E_ARGUMENT, "argument")         \
    x(NCK_E_MACHINE, "machine")           \
    x(NCK_E_STATE, "state")               \
    x(NCK_E_INTERNAL, "internal")

#define NOTES(x)                             \
    x(NCK_NOTE_UNITS, "assumed-units")       \
    x(NCK_NOTE_PLANE, "assumed-plane")       \
    x(NCK_NOTE_DISTANCE, "assumed-distance") \
    x(NCK_NOTE_ARC_CENTRE, "assumed-centre") \
    x(NCK_NOTE_NO_END, "no-end")             \
    x(NCK_NOTE_AFTER_END, "after-end")       \
    x(NCK_NOTE_FEED_UNITS, "feed-units")     \
    x(NCK_NOTE_TOLERANCE, "no-tolerance")    \
    x(NCK_NOTE_CALLED, "called-from")        \
    x(NCK_NOTE_COMP_LEFT, "comp-left")       \
    x(NCK_NOTE_COMP_WAY, "comp-way")         \
    x(NCK_NOTE_REPEATS, "repeats")           \
    x(NCK_NOTE_LIMITS, "limits-stay")        \
    x(NCK_NOTE_SYSTEM, "assumed-system")     \
    x(NCK_NOTE_FEED_MODE, "assumed-feed-mode") \
    x(NCK_NOTE_ABORT, "abort") \
    x(NCK_NOTE_MODE, "mode-stays") \
    x(NCK_NOTE_CLIPPED, "speed-clipped") \
    x(NCK_NOTE_FEED_KEPT, "feed-kept") \
    x(NCK_NOTE_CLAMPED, "travel-end") \
    x(NCK_NOTE_OWN_LEFT, "own-left") \
    x(NCK_NOTE_ENDS_OFF, "ends-off") \
    x(NCK_NOTE_CLOCK, "assumed-clock") \
    x(NCK_NOTE_TIMER, "timer-read") \
    x(NCK_NOTE_PECK, "assumed-peck") \
    x(NCK_NOTE_LENGTH, "assumed-length") \
    x(NCK_NOTE_INTEGERS, "assumed-integers")

#define CODE(code, id) code,
#define ID(code, id) id "\0"

static const int8_t status_codes[] = {STATUSES(CODE)};
static const char status_ids[] = STATUSES(ID);
static const int8_t note_codes[] = {NOTES(CODE)};
static const char note_ids[] = NOTES(ID);

static const char *id_of(const int8_t *codes, size_t count, const char *ids, int32_t code) {
    for (size_t k = 0; k < count; k++) {
        if (codes[k] == code) return ids;
        ids += strlen(ids) + 1;
    }
    return "unknown";
}

const char *nck_status_id(int32_t status) {
    return id_of(status_codes, sizeof status_codes, status_ids, status);
}

const char *nck_diagnostic_id(int32_t code) {
    if (code < 0) return nck_status_id(code);
    return id_of(note_codes, sizeof note_codes, note_ids, code);
}
