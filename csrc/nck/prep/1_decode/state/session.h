// SPDX-License-Identifier: MIT
// A session: text that somebody types or sends, where an error refuses its line and no more.
//
// A line is tried first, with all its blocks dropped, and the room put back as it was. If that has
// found an error the line is over. Else it is done. What it was put back from is a copy of the
// room, in memory that the caller lends.
#ifndef NCK_PREP_DECODE_STATE_SESSION_H
#define NCK_PREP_DECODE_STATE_SESSION_H

#include <stdint.h> // int64_t uint8_t

// The room, room.h.
struct nck_decode;

// How far the line in work is.
typedef enum nck_session_phase {
    NCK_SESSION_NOT = 0,   // no line is, or the room is in no session
    NCK_SESSION_TRIES = 1, // its blocks are dropped
    NCK_SESSION_DOES = 2   // it has no error
} nck_session_phase_t;

// What a session adds to the room's state.
typedef struct nck_session {
    struct nck_decode *before; // the room before the line in work; NULL: no session
    uint8_t phase;             // nck_session_phase_t
    uint8_t passes;            // 1: the next line leaves nothing in force
} nck_session_t;

// Offsets that come from outside of the text [nm, ndeg].
typedef struct nck_offsets {
    const int64_t *systems_nm; // G54 … G59.3, NCK_AXIS_MAX each
    const int64_t *home_nm;    // G28, G30
    const int64_t *g92_nm;
    const int64_t *tool_nm;    // G43: X Y Z
    uint32_t system;           // in force, 0: G54
    uint32_t tool_next, tool_in;
} nck_offsets_t;

#endif
