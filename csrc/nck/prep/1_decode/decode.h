// SPDX-License-Identifier: MIT
// Room 1, decode: NC text → blocks. Words, modal groups, offsets, arcs, travel check.
//
//     push text → one line waits → pull gives its blocks one by one → push the next line
//
// A block is one move or one thing to do, in machine coordinates, with everything that was modal
// written into it. Errors leave the room by pull and by nck_decode_diagnostic; the line they stand
// in yields nothing more and decoding can go on with the next one. Notes (assumed defaults) leave
// by nck_decode_diagnostic alone.
//
// What comes without text enters by nck_decode_push_block and takes the place of a line.
#ifndef NCK_PREP_DECODE_H
#define NCK_PREP_DECODE_H

#include <stddef.h> // size_t

#include "nck/base/machine.h"        // nck_machine_t
#include "nck/base/records.h"        // nck_block_t
#include "nck/base/status.h"         // nck_status_t nck_diagnostic_t
#include "nck/prep/1_decode/block_in.h" // nck_block_in_t
#include "nck/prep/1_decode/contour.h" // nck_contour_t nck_rough_t
#include "nck/prep/1_decode/corner.h" // nck_corner_t
#include "nck/prep/1_decode/cycle.h" // nck_cycle_t
#include "nck/prep/1_decode/lathe.h" // nck_turn_t
#include "nck/prep/1_decode/layout.h" // nck_layout_t
#include "nck/prep/1_decode/macro.h" // nck_macro_t nck_source_t
#include "nck/prep/1_decode/screw.h" // nck_screw_t
#include "nck/prep/1_decode/session.h" // nck_session_t
#include "nck/prep/1_decode/spline.h" // nck_spline_t
#include "nck/prep/1_decode/state.h" // nck_modes_t nck_states_t
#include "nck/prep/1_decode/words.h" // nck_words_t

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
    NCK_HINT_SINUMERIK = 2,  // %_N_…, DEF REAL …, PROC …
    NCK_HINT_OKUMA = 3       // $NAME.MIN%
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
        uint32_t given;                               // bit k: the program says what note k assumes
    } finding;

    struct {
        uint8_t percent;  // 1: the text begins with a % line
        uint8_t begun;    // 1: a line that is not blank was met
        uint8_t closed;   // nck_closed_t: the program ends before the line in work
        uint8_t words;    // 1: a line with words (or an error) was met
        uint8_t complete; // 1: nck_decode_end was called
        uint8_t over;     // 1: nothing more is decoded
        uint8_t watch;    // 1: look whether text follows the program's end
        uint8_t quick;    // 1: the line before was a quick one: what these ask for is as it was
    } text;
} nck_decode_t;

// Begin a program. machine: checked by nck_machine_check, must outlive self.
// Cost: constant. Context: prep.
void nck_decode_init(nck_decode_t *self, const nck_machine_t *machine);

// Hand over program text in pieces of any size: at most the rest of one line is taken, *used_out
// bytes (0 … n). Returns NCK_OK (push the rest; nothing is left over only if *used_out is n),
// NCK_FULL if a complete line waits to be pulled and nothing was taken, NCK_E_STATE after
// nck_decode_end. After the program's end text is taken and dropped. Cost: linear in the bytes
// taken, at most NCK_LINE_MAX + 2 before the end. Context: prep.
nck_status_t nck_decode_push(nck_decode_t *self, const char *text, size_t n, size_t *used_out);

// Have the room read its text itself, instead of pushing it: calls, loops and jumps backward need
// that. Call it before anything is pushed; what the source points to must outlive the program.
// Returns NCK_OK; NCK_E_ARGUMENT if it has neither text nor read; NCK_E_STATE if the program has
// begun. Cost: constant. Context: prep, and so is that of source->read.
nck_status_t nck_decode_source(nck_decode_t *self, const nck_source_t *source);

// 1 if NCK_EMPTY of pull means that there is more to pull: a source is there and the program has
// not ended, or a line is tried. Cost: constant. Context: prep.
int nck_decode_reads(const nck_decode_t *self);

// How far the source is read: where the next line begins. Cost: constant. Context: prep.
size_t nck_decode_used(const nck_decode_t *self);

// Take a block in place of a line: its units are mm, degrees and seconds whatever the modes say,
// its coordinates are absolute, and what it sets is modal for what follows. What is wrong with it
// in the program's terms (travel, feed, arc) is told by nck_decode_pull, as for a line.
// Returns NCK_OK; NCK_FULL if a line or block waits to be pulled; NCK_E_STATE in the middle of a
// line, while a corner (,R) waits for its second move, after the program's end and after
// nck_decode_end; NCK_E_ARGUMENT if a member is outside of its range (see nck_block_in_t). Cost:
// constant. Context: prep.
nck_status_t nck_decode_push_block(nck_decode_t *self, const nck_block_in_t *block);

// Say that text stops here: a line without line feed is complete. Cost: constant. Context: prep.
void nck_decode_flush(nck_decode_t *self);

// 1 if neither a line, nor a part of one, nor a block waits. Cost: constant. Context: prep.
int nck_decode_is_empty(const nck_decode_t *self);

// 1 if nck_decode_pull would find no line to work on: text must be pushed first. Cost: constant.
// Context: prep.
static inline int nck_decode_needs_text(const nck_decode_t *self) {
    if (self->line.state != NCK_LINE_OPEN) return 0;
    const int ends = self->text.complete || self->text.over || self->entry.waits != 0;
    return !ends && !self->macro.reads;
}

// Begin another program: modes are the machine's again, the
// offsets (work systems, G92, tool length) and the tools of T and M6 stay. Cost: constant.
// Context: prep.
void nck_decode_begin(nck_decode_t *self);

// The axes stand at the machine's start position. Cost: constant. Context: prep.
void nck_decode_stand(nck_decode_t *self);

// From now on an error refuses its line: nck_decode_pull tells it and goes on behind the line, and
// all is as it was before. A line is done twice, once to try it. before: memory for a copy of the
// room, which outlives it. Returns NCK_OK, or NCK_E_STATE if the text has begun, or the room reads
// it itself. Cost: constant. Context: prep.
nck_status_t nck_decode_lend(nck_decode_t *self, struct nck_decode *before);

// The next line leaves nothing in force but the place that it moves to. Returns NCK_OK;
// NCK_E_STATE outside of a session, or while a line or a part of one waits. Cost: constant.
// Context: prep.
nck_status_t nck_decode_leave_nothing(nck_decode_t *self);

// A probe has ended: where it touched, of the machine; NULL: it has met nothing, and stands where
// it was sent. #5061 … #5070. Returns NCK_OK or NCK_E_VARIABLES. Cost: linear in the parameters.
// Context: prep.
nck_status_t nck_decode_probed(nck_decode_t *self, const int64_t *at_nm);

// What blocks and findings call the next line, in place of its number; the one behind it is one
// more. Cost: constant. Context: prep.
void nck_decode_name_line(nck_decode_t *self, uint32_t name);

// In a session: a line that has not given its last block was never there, nor what waits for lines
// to come. An end is over. Modes and offsets stay. Cost: a copy of the room. Context: prep.
void nck_decode_drop(nck_decode_t *self);

// Say that the text is complete: a last line without line feed counts, and the program ends there
// if it has not. Cost: constant. Context: prep.
void nck_decode_end(nck_decode_t *self);

// Take the next block. The last block is of kind NCK_BLOCK_END; where the text or a closing % ends
// the program its output says M2.
// Returns NCK_OK (block_out is filled), NCK_EMPTY (push text first; with a source: pull again),
// NCK_DONE (the program has ended), or the error of the line in work: NCK_E_CHARACTER …
// NCK_E_COMP_PLANE. After an error the next pull goes on with the next line, as if the move had
// been made; after NCK_E_BINARY, NCK_E_DIALECT, NCK_E_NO_PROGRAM, errors of jumps, and any error
// behind a call, loop or jump it says NCK_DONE. Cost: linear in the line. Context: prep.
nck_status_t nck_decode_pull(nck_decode_t *self, nck_block_t *block_out);

// Take the oldest finding: an error that pull has returned, or a note. Returns NCK_OK or NCK_EMPTY.
// Findings that nobody takes are kept up to NCK_DECODE_FINDINGS, later ones are dropped and
// counted. Cost: constant. Context: prep.
nck_status_t nck_decode_diagnostic(nck_decode_t *self, nck_diagnostic_t *diagnostic_out);

// What must hold between two calls: sizes within their arrays, origin = work + G92 + tool,
// positions within range. Returns 1 if it holds. For tests. Cost: constant. Context: prep.
int nck_decode_invariants(const nck_decode_t *self);

#endif
