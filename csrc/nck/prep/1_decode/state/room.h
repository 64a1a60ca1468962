// SPDX-License-Identifier: MIT
// The room's state, all of it: each wing reads and writes what it knows of it.
#ifndef NCK_PREP_DECODE_STATE_ROOM_H
#define NCK_PREP_DECODE_STATE_ROOM_H

#include "nck/base/in_force.h" // NCK_FORCE_…
#include "nck/base/machine.h"  // nck_machine_t
#include "nck/base/records.h"  // nck_block_t
#include "nck/base/status.h"   // nck_status_t nck_diagnostic_t
#include "nck/prep/1_decode/state/block_in.h" // nck_block_in_t
#include "nck/prep/1_decode/state/contour.h" // nck_contour_t nck_rough_t
#include "nck/prep/1_decode/state/corner.h" // nck_corner_t
#include "nck/prep/1_decode/state/cycle.h" // nck_cycle_t
#include "nck/prep/1_decode/state/layout.h" // nck_layout_t
#include "nck/prep/1_decode/state/macro.h" // nck_macro_t
#include "nck/prep/1_decode/state/modes.h" // nck_modes_t nck_states_t
#include "nck/prep/1_decode/state/screw.h" // nck_screw_t
#include "nck/prep/1_decode/state/session.h" // nck_session_t
#include "nck/prep/1_decode/state/spline.h" // nck_spline_t
#include "nck/prep/1_decode/state/turn.h" // nck_turn_t
#include "nck/prep/1_decode/state/words.h" // nck_words_t

// Sets of tongues: Fanuc's; those with parameters and expressions.
enum {
    NCK_TONGUES_FANUC = NCK_TONGUE_FANUC | NCK_TONGUE_TURNING,
    NCK_TONGUES_MACRO = NCK_TONGUE_LINUXCNC | NCK_TONGUES_FANUC
};

// Bounds of words, and of what is kept.
enum {
    NCK_DECODE_VALUE_MAX = 1000000000,    // largest F [mm/min, 1/min, mm/rev] and S [rpm]
    NCK_DECODE_DWELL_MAX_S = 1000000,     // longest G4
    NCK_DECODE_TURNS_MAX = 100000,        // largest P of an arc
    NCK_DECODE_FINDINGS = 12 + NCK_CALL_DEPTH // one error, every kind of note, every call in force
};

// The value of the diagnostic NCK_E_DIALECT: whose language the text is.
typedef enum nck_dialect_hint {
    NCK_HINT_HEIDENHAIN = 1, // Klartext: BEGIN PGM
    NCK_HINT_SINUMERIK = 2,  // %_N_…, DEF REAL …, CYCLE81(…
    NCK_HINT_OKUMA = 3,      // $NAME.MIN%
    NCK_HINT_SHOPBOT = 4     // 'SHOPBOT …, MS,50,20
} nck_dialect_hint_t;

// How far the line in hand is.
typedef enum nck_decode_line_state {
    NCK_LINE_OPEN = 0,    // text is being collected
    NCK_LINE_WAITING = 1, // complete, not looked at
    NCK_LINE_RUNNING = 2, // read, its steps are being done
    NCK_LINE_PUSHED = 3   // a pushed block waits in place of a line
} nck_decode_line_state_t;

// What ends a program but a code.
typedef enum nck_closed {
    NCK_CLOSED_NOT = 0,
    NCK_CLOSED_BY_PERCENT = 1, // what follows is not read, which a note tells
    NCK_CLOSED_BY_ABORT = 2    // (abort, …), which a note tells
} nck_closed_t;

// What modal.motion is where it is no G code.
typedef enum nck_no_motion {
    NCK_MOTION_NONE = -1,   // at start, after G80
    NCK_MOTION_REFUSED = -2 // a refused line would have set it: what counts on that moves nothing
} nck_no_motion_t;

// Whether G41 or G42 is in force.
typedef enum nck_comp_state {
    NCK_COMPENSATES_NOT = 0,
    NCK_COMPENSATES_NOTHING = 1, // a tool without radius
    NCK_COMPENSATES = 2
} nck_comp_state_t;

// How far a program is that begins at a line in the middle.
typedef enum nck_entry {
    NCK_ENTRY_NOT = 0,    // it has begun, or begins with its first line
    NCK_ENTRY_BEGINS = 1, // nothing of it is read
    NCK_ENTRY_SEEKS = 2,  // the line is looked for
    NCK_ENTRY_REACHED = 3 // the line is there
} nck_entry_t;

// What a program has put out and what stays so: digital outputs, analogue ones, a printer's
// settings, in this order.
enum { NCK_KEPT_DIGITAL = 64, NCK_KEPT_ANALOGUE = 16, NCK_KEPT_SETTINGS = 6, NCK_KEPT = 86 };

// What it is.
typedef struct nck_kept {
    double value[NCK_KEPT_ANALOGUE + NCK_KEPT_SETTINGS]; // of all but digital ones
    uint32_t told[3];              // bit k: it has been put out
    uint32_t on[2];                // bit k: the digital output is on
    uint32_t waits;                // bit k: the program has waited for the setting
    uint8_t own[NCK_OWN_M_MAX];    // rows of the machine's own M codes that stay, the latest last
    uint8_t owns;                  // of them
    uint16_t percent;              // of a printer's speed, M220; 0: nobody has said it
    uint16_t percent_back;         // what M220 B has kept; 0: nothing
} nck_kept_t;

// Bits of modal.excused.
enum { NCK_EXCUSED_FEED = 1, NCK_EXCUSED_SPEED = 2 };

// What cycles hold from line to line; a union where they are left out.
typedef NCK_CYCLE_STATE nck_cycles {
    nck_cycle_t cycle;     // drilling
    nck_turn_t turn;       // turning
    nck_peck_t peck;       // G74, G75 of lathes
    nck_screw_t screw;     // threads
    nck_contour_t contour; // that G70 … G73 read
    nck_corner_t corner;   // ,R and ,C
    nck_rough_t rough;     // and what they do with it
    nck_spline_t spline;   // its points are in the contour
} nck_cycles_t;

// The room's state: filled by nck_decode_init, written by the room alone.
typedef struct nck_decode {
    const nck_machine_t *machine;

    struct {
        char text[NCK_LINE_MAX + 1]; // the line, ended by a line feed once it is complete
        uint32_t size;               // bytes in it
        uint32_t number;             // of the line collected last, from 1
        uint32_t tag;                // what blocks and findings call the line in work: its number,
                                     // or the id of a pushed block
        uint8_t state;               // nck_decode_line_state_t
        uint8_t overflow;            // 1: the line had more bytes than text holds
        uint8_t after_cr;            // 1: a line feed that comes next belongs to the line before
        uint8_t binary;              // 1: the line had a NUL byte behind those in text
    } line;
    nck_words_t words; // of the line in work
    uint16_t lathe;    // 1: it speaks Fanuc's language: G codes go by its system
    uint16_t tongue;   // nck_tongue_t: whose rows of the tables count

    nck_modes_t modal;   // what stays in force until a word changes it
    nck_states_t states; // and is kept by M70, M73

    struct {
        int64_t position_nm[NCK_AXIS_MAX]; // machine position, tool offset included
        int64_t origin_nm[NCK_AXIS_MAX];   // where the program's zero is: outer + work + g92 + tool
        int64_t outer_nm[NCK_AXIS_MAX];    // Fanuc's external zero offset, of all work systems
        int64_t work_nm[NCK_WORK_SYSTEMS + 1][NCK_AXIS_MAX]; // the last: G54.1 P's, if in force
        double turn_deg[NCK_TURNED_ROWS]; // G10 L2 R, 0 … 360
        int64_t g92_nm[NCK_AXIS_MAX];
        int64_t g92_kept_nm[NCK_AXIS_MAX]; // what G92.3 brings back
        int64_t home_nm[2][NCK_AXIS_MAX];  // G28, G30; set by G28.1, G30.1
        int64_t tool_nm[3];                // G43
        uint32_t work_system;              // 0: G54; NCK_WORK_SYSTEMS: the one of G54.1 P
        uint32_t work_more;                // its P, if it is in force
        uint32_t axes;                     // bit k: the machine has axis k
        uint8_t is_local;                  // 1: G52 has set g92_nm
        uint32_t rotary;                   // bit k: axis k turns
        nck_scale_t scale[3];              // of linear words, of X (diameter), of rotary words
    } place;

    struct {
        int64_t at_nm[NCK_AXIS_MAX]; // where the last move before it ends, machine position
        NCK_KEPT_MEMBER(nck_kept_t, kept) // what has been put out before it
        uint32_t tool_in;  // before the program
        uint8_t waits;     // nck_entry_t
        uint8_t phase;     // of what is given there, entry.c
        uint8_t is_called; // 1: the line is of a subprogram, which is still to be called
        uint8_t is_passed; // 1: a loop has passed the line; a later pass may come to it
    } entry;

    nck_session_t session; // errors refuse their lines

    nck_layout_t layout; // how the program's coordinates lie
    nck_macro_t macro; // parameters, calls, jumps
    nck_cycles_t held; // cycles

    nck_block_in_t pushed; // the block in place of a line
    nck_block_t second;    // the block of NCK_REST_SECOND

    struct {
        nck_diagnostic_t error;                       // of the line in work
        nck_diagnostic_t queue[NCK_DECODE_FINDINGS];  // waiting to be taken, oldest first
        uint32_t count;                               // of them
        uint32_t lost;                                // findings that met a full queue
        uint32_t notes;                               // bit k: note k was given
        uint32_t modes;                               // codes that NCK_NOTE_MODE told, mode.c
        uint32_t given;                               // bit k: the program says what note k assumes
    } finding;

    struct {
        uint8_t percent;  // 1: the text begins with a % line
        uint8_t begun;    // 1: a line that is not blank was met
        uint8_t closed;   // nck_closed_t: the program ends before the line in work
        uint8_t words;    // 1: a line with words (or an error) was met
        uint8_t complete; // 1: nck_decode_end was called
        uint8_t over;     // 1: nothing more is decoded
        uint8_t watch;    // not 0: look whether text follows the program's end, source.c
        uint8_t quick;    // 1: the line before was a quick one: what these ask for is as it was
    } text;
} nck_decode_t;

// A step does one thing of a block. It returns NCK_OK if it filled a block, NCK_EMPTY if it had
// none to give, or the error that nck_decode_fail has noted. Context: prep.
typedef nck_status_t (*nck_step_function_t)(nck_decode_t *self, nck_block_t *out);

// The modes in force (nck_decode_modes) behind a quick line, where the word before is known: it
// changes the motion alone, which is below 0 where there is none. Cost: constant. Context: prep.
static inline uint32_t nck_decode_moves(const nck_decode_t *self, uint32_t modes) {
    const uint32_t of_moves = NCK_FORCE_MOTION_MASK | 1u << NCK_FORCE_INCREMENTAL;
    return (modes & ~of_moves) | ((uint32_t)self->modal.motion & NCK_FORCE_MOTION_MASK)
           | (uint32_t)self->modal.incremental << NCK_FORCE_INCREMENTAL;
}

#endif
