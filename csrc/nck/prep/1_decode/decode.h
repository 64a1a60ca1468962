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

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

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

// What M66 has found: #5399. Returns NCK_OK or NCK_E_VARIABLES. Cost: linear in the parameters.
nck_status_t nck_decode_answered(nck_decode_t *self, double value);

// Offsets, and the tools of T and M6. Returns NCK_OK; NCK_E_ARGUMENT where there is no such work
// system, NCK_E_TOOL_UNKNOWN where there is no such tool. Cost: constant. Context: prep, between
// two lines.
nck_status_t nck_decode_set_offsets(nck_decode_t *self, const nck_offsets_t *offsets);

// A tool with what G10 has changed in it; returns 0: there is none of that number. Cost of both:
// linear in tools and parameters. Context: prep.
int nck_decode_tool_of(const nck_decode_t *self, uint32_t number, nck_tool_t *tool_out);

// What G10 has changed in a tool counts no more: the machine's table has another. Context: prep.
void nck_decode_forget_tool(nck_decode_t *self, uint32_t number);

// What blocks and findings call the next line, in place of its number; the one behind it is one
// more. Cost: constant. Context: prep.
void nck_decode_name_line(nck_decode_t *self, uint32_t name);

// In a session: a line that has not given its last block was never there, nor what waits for lines
// to come. An end is over. Modes and offsets stay. Cost: a copy of the room. Context: prep.
void nck_decode_drop(nck_decode_t *self);

// The modes that are in force behind the last block given, as one word (in_force.h). Cost:
// constant. Context: prep.
uint32_t nck_decode_modes(const nck_decode_t *self);

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
