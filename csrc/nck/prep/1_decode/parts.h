// SPDX-License-Identifier: MIT
// The room's inner doors: what its files call of each other. Nobody outside of 1_decode includes
// this.
//
// A step does one thing of a block. It returns NCK_OK if it filled a block, NCK_EMPTY if it had
// none to give, or the error that nck_decode_fail has noted. Context of all: prep.
#ifndef NCK_PREP_DECODE_PARTS_H
#define NCK_PREP_DECODE_PARTS_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// Bits of letters and steps.
#define NCK_LETTER(c) ((uint32_t)1 << ((c) - 'A'))
#define NCK_STEP(k) ((uint32_t)1 << (k))

// Sets of letters.
enum {
    NCK_LETTERS_LINEAR = (1 << ('X' - 'A')) | (1 << ('Y' - 'A')) | (1 << ('Z' - 'A'))
                       | (1 << ('U' - 'A')) | (1 << ('V' - 'A')) | (1 << ('W' - 'A')),
    NCK_LETTERS_AXES = NCK_LETTERS_LINEAR | 7, // A B C
    NCK_LETTERS_CENTRE = (1 << ('I' - 'A')) | (1 << ('J' - 'A')) | (1 << ('K' - 'A'))
};

// A step.
typedef nck_status_t (*nck_step_function_t)(nck_decode_t *self, nck_block_t *out);

// finding.c: note the line's error, the last one counts. column: 1-based, 0 for the whole line;
// letter: upper case or 0. Returns code. Cost: constant.
nck_status_t nck_decode_fail(nck_decode_t *self, nck_status_t code, unsigned column, int letter,
                             double value, double limit);

// finding.c: the same for a word of the line: its column and letter.
nck_status_t nck_decode_fail_word(nck_decode_t *self, nck_status_t code, int letter, double value,
                                  double limit);

// finding.c: queue a finding. Cost: constant.
void nck_decode_find(nck_decode_t *self, const nck_diagnostic_t *finding);

// finding.c: give a note if the program leaves it to the machine. Cost: constant.
void nck_decode_assume(nck_decode_t *self, nck_note_t note);

// axis.c: the letter of axis 0 … 8: X Y Z A B C U V W. Cost: constant.
int nck_decode_letter(unsigned axis);

// axis.c: the word of an axis, [nm] or [ndeg]; NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_axis_word(nck_decode_t *self, unsigned axis, int64_t *value_out);

// axis.c: the machine position that the axis words name; axes without a word stay. absolute: 1:
// words count from the machine's zero (G53). NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_target(nck_decode_t *self, int absolute, int64_t *target_nm);

// axis.c: is a machine position within the travel of its axis? NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_decode_travel(nck_decode_t *self, unsigned axis, int64_t position_nm);

// words.c: the line from `at` on as words. Cost: linear in the line.
nck_status_t nck_decode_words(nck_decode_t *self, const char *at);

// words.c: the line is refused. If it says a feed, a speed or the first motion, that one is missing
// behind it is no mistake of its own. Cost: linear in the line.
void nck_decode_excuse(nck_decode_t *self);

// codes.c: what a code is. Returns NCK_OK, NCK_E_UNSUPPORTED, or NCK_E_G_UNKNOWN / NCK_E_M_UNKNOWN.
// letter: G or M; tenths: the code; *takes_out: letters that it uses. Cost: linear in the codes.
nck_status_t nck_decode_code(const nck_decode_t *self, int letter, int64_t tenths,
                             unsigned *step_out, uint32_t *takes_out);

// codes.c: the machine's entry for an M code; NULL: it has none. Cost: linear in the entries.
const nck_own_m_t *nck_decode_own_m(const nck_decode_t *self, int64_t code);

// codes.c: the letters that a modal motion uses. Cost: constant.
uint32_t nck_decode_motion_takes(int32_t motion);

// resolve.c: do words and codes of the line fit, and who gets the axis words? Cost: constant.
nck_status_t nck_decode_resolve(nck_decode_t *self);

// foreign.c: whose language the line is, 0 if it does not say. Cost: linear in the line.
int nck_decode_foreign(const char *line);

// modal.c: settings and outputs.
nck_status_t nck_decode_units(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed_mode(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_speed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_tool(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_change(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_change_wait(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_spindle(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_mist(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_flood(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_override(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_own(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_dwell(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_plane(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_diameter(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_path(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_distance(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_centre(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_stop(nck_decode_t *self, nck_block_t *out);

// modal.c: a feed [mm/min, mm/rev or 1/min], and as written; a spindle speed [rpm], a tool number,
// a dwell. Cost: constant, set_tool linear in the tools.
void nck_decode_set_feed(nck_decode_t *self, double feed, double word);
nck_status_t nck_decode_set_speed(nck_decode_t *self, double value, nck_block_t *out);
nck_status_t nck_decode_set_tool(nck_decode_t *self, double value, nck_block_t *out);
nck_status_t nck_decode_give_dwell(const nck_decode_t *self, double dwell_s, nck_block_t *out);

// modal.c: fill a block with all that is modal; the target is the present position. Cost: constant.
void nck_decode_block(const nck_decode_t *self, nck_block_kind_t kind, nck_block_t *out);

// modal.c: the scales of axis words, after a change of units or of diameter mode. Cost: constant.
void nck_decode_scale(nck_decode_t *self);

// modal.c: a tool of the table, NULL if it has none of that number. Cost: linear in the tools.
const nck_tool_t *nck_decode_find_tool(const nck_decode_t *self, uint32_t number);

// place.c: offsets.
nck_status_t nck_decode_length(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_work(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_offset(nck_decode_t *self, nck_block_t *out);

// place.c: the origin from its parts, after a change of one. Cost: constant.
void nck_decode_origin(nck_decode_t *self);

// motion.c: moves.
nck_status_t nck_decode_motion(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_reference(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_second(nck_decode_t *self, nck_block_t *out);

// motion.c: the motion of the line in work to a machine position; pushed: of this block, NULL: of
// words. Cost: constant.
nck_status_t nck_decode_go(nck_decode_t *self, const nck_block_in_t *pushed,
                           const int64_t *target_nm, nck_block_t *out);

// arc.c: the arc to a machine position; a second part of it goes to self->second. pushed: the block
// that says centre and turns, NULL: words do. Cost: constant.
nck_status_t nck_decode_arc(nck_decode_t *self, const nck_block_in_t *pushed,
                            const int64_t *target_nm, nck_block_t *out);

// block_in.c: 1 if every member is within its range. Cost: constant.
int nck_decode_block_good(const nck_block_in_t *block);

// block_in.c: the pushed block becomes the line in work: its settings count, its steps are set.
// Cost: constant.
nck_status_t nck_decode_pushed(nck_decode_t *self);

// block_in.c: what the pushed block does.
nck_status_t nck_decode_give_pushed(nck_decode_t *self, nck_block_t *out);

#endif
