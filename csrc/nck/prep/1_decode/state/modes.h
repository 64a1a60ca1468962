// SPDX-License-Identifier: MIT
// What is in force, and kept by M70 or M73 for each call.
#ifndef NCK_PREP_DECODE_STATE_MODES_H
#define NCK_PREP_DECODE_STATE_MODES_H

#include <stdint.h> // int32_t uint8_t

#include "nck/base/limits.h" // NCK_STATE_ROWS

// Of modal.plain_mm: the machine's tolerance, which may change on the way.
#define NCK_PLAIN_OPEN (-1.0)

// What stays in force until a word changes it.
typedef struct nck_modes {
    int32_t motion;         // G0 … G3 or a canned cycle in tenths; nck_no_motion_t
    uint8_t plane;          // 17, 18, 19
    uint8_t inch;           // 1: G20
    uint8_t inch_before;    // of a line with G20 or G21: what was in force before it
    uint8_t diameter;       // 1: G7
    uint8_t incremental;    // 1: G91
    uint8_t centre_absolute;// 1: G90.1
    uint8_t feed_mode;      // nck_feed_mode_t
    uint8_t path_mode;      // nck_path_mode_t
    uint8_t spindle_on;     // 1: M3 or M4
    uint8_t spindle_code;   // 3 or 4: the last of them
    uint8_t surface_on;     // 1: G96
    uint8_t comp;           // nck_comp_state_t
    uint8_t extrudes_steps; // 1: M83
    uint8_t coolant;        // bit 0: M7, bit 1: M8
    uint8_t group;          // G0 … G3 in tenths, the last of them: Fanuc's G80 goes back to it
    uint8_t roams;          // 1: M211 S0: axes are not held within their travel
    uint8_t excused;        // NCK_EXCUSED_…: what is missing was told, or is an error's
    double tolerance_mm;    // G64 P
    double merge_mm;        // G64 Q
    double plain_mm;        // what G64 without P means, as a mode has chosen; tongue.h
    double feed;            // F in mm/min, mm/rev or 1/min; 0: none yet
    double feed_word;       // F as written: what a move of rotary axes alone goes by
    double speed;           // S [rpm], −1: none yet
    double surface;         // S under G96 [mm/min]; 0: none yet
    double speed_most;      // of the spindle under G96 by the program [rpm]; 0: none said
    uint32_t tool_next;     // T
    uint32_t tool_in;       // T at the last M6
    int32_t offset_in;      // of T0202 or D the offset whose radius G41 and G42 take; −1: none said
} nck_modes_t;

// What M70 or M73 keeps.
typedef struct nck_state {
    nck_modes_t modal;
    int64_t tool_nm[3];  // G43
    uint32_t work_system;
    uint32_t level;      // of calls in force, plus one; 0: nothing is kept
    uint8_t to_r;        // 1: G99
    uint8_t returns;     // 1: M73: restored when the call is over
} nck_state_t;

// All of it.
typedef struct nck_states {
    nck_state_t kept[NCK_STATE_ROWS];
    uint32_t pending;    // outputs that a restored state still owes, keep.c
} nck_states_t;

#endif
