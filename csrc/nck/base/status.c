// SPDX-License-Identifier: MIT
// The stable ids of statuses and notes.
#include "nck/base/status.h"

#include <stddef.h> // size_t

typedef struct name {
    int32_t code;
    const char *id;
} name_t;

static const name_t statuses[] = {
    {NCK_OK, "ok"},
    {NCK_EMPTY, "empty"},
    {NCK_FULL, "full"},
    {NCK_DONE, "done"},
    {NCK_WAIT, "wait"},
    {NCK_E_CHARACTER, "character"},
    {NCK_E_NUMBER, "number"},
    {NCK_E_NUMBER_RANGE, "number-range"},
    {NCK_E_LINE_LENGTH, "line-length"},
    {NCK_E_COMMENT, "comment"},
    {NCK_E_WORD_UNKNOWN, "word-unknown"},
    {NCK_E_WORD_TWICE, "word-twice"},
    {NCK_E_WORD_UNUSED, "word-unused"},
    {NCK_E_WORD_MISSING, "word-missing"},
    {NCK_E_G_UNKNOWN, "g-unknown"},
    {NCK_E_M_UNKNOWN, "m-unknown"},
    {NCK_E_MODAL_GROUP, "modal-group"},
    {NCK_E_UNSUPPORTED, "unsupported"},
    {NCK_E_FEED_MISSING, "feed-missing"},
    {NCK_E_ARC_RADIUS, "arc-radius"},
    {NCK_E_ARC_CENTRE, "arc-centre"},
    {NCK_E_ARC_CHORD, "arc-chord"},
    {NCK_E_AXIS_UNKNOWN, "axis-unknown"},
    {NCK_E_TRAVEL, "travel"},
    {NCK_E_TOOL_UNKNOWN, "tool-unknown"},
    {NCK_E_NO_MOTION, "no-motion"},
    {NCK_E_DIALECT, "dialect"},
    {NCK_E_BINARY, "binary"},
    {NCK_E_NO_PROGRAM, "no-program"},
    {NCK_E_WORD_SHARED, "word-shared"},
    {NCK_E_INCREMENTAL, "incremental"},
    {NCK_E_ARGUMENT, "argument"},
    {NCK_E_MACHINE, "machine"},
    {NCK_E_STATE, "state"},
    {NCK_E_INTERNAL, "internal"}
};

static const name_t notes[] = {
    {NCK_NOTE_UNITS, "assumed-units"},
    {NCK_NOTE_PLANE, "assumed-plane"},
    {NCK_NOTE_DISTANCE, "assumed-distance"},
    {NCK_NOTE_ARC_CENTRE, "assumed-centre"},
    {NCK_NOTE_NO_END, "no-end"},
    {NCK_NOTE_AFTER_END, "after-end"},
    {NCK_NOTE_FEED_UNITS, "feed-units"},
    {NCK_NOTE_TOLERANCE, "no-tolerance"}
};

static const char *id_of(const name_t *names, size_t count, int32_t code) {
    for (size_t k = 0; k < count; k++) {
        if (names[k].code == code) return names[k].id;
    }
    return "unknown";
}

const char *nck_status_id(int32_t status) {
    return id_of(statuses, sizeof statuses / sizeof statuses[0], status);
}

const char *nck_note_id(int32_t note) {
    return id_of(notes, sizeof notes / sizeof notes[0], note);
}
