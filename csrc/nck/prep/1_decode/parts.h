// SPDX-License-Identifier: MIT
// The room's inner doors: what its files call of each other. Nobody outside includes this.
//
// A step does one thing of a block. It returns NCK_OK if it filled a block, NCK_EMPTY if it had
// none to give, or the error that nck_decode_fail has noted. Context of all: prep.
#ifndef NCK_PREP_DECODE_PARTS_H
#define NCK_PREP_DECODE_PARTS_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t
#include "nck/prep/1_decode/values.h" // nck_variable_ … nck_parameter_ …

// Bits of letters and steps.
#define NCK_LETTER(c) ((uint32_t)1 << ((c) - 'A'))
#define NCK_STEP(k) ((uint32_t)1 << (k))

enum { NCK_LABEL_MOST = 99999999, NCK_VARIABLE_LAST = 99999 }; // of O and N; of #

// Sets of tongues: Fanuc's; those with parameters and expressions.
enum {
    NCK_TONGUES_FANUC = NCK_TONGUE_FANUC | NCK_TONGUE_TURNING,
    NCK_TONGUES_MACRO = NCK_TONGUE_LINUXCNC | NCK_TONGUES_FANUC
};

enum { NCK_CODE_OWN_G = 0x8000 }; // of the codes of NCK_STEP_OWN those of letter G are higher

enum { NCK_LIST_WORK = 2, NCK_LIST_WORK_HERE = 20 }; // lists of G10

// Sets of letters.
enum {
    NCK_LETTERS_LINEAR = (1 << ('X' - 'A')) | (1 << ('Y' - 'A')) | (1 << ('Z' - 'A'))
                       | (1 << ('U' - 'A')) | (1 << ('V' - 'A')) | (1 << ('W' - 'A')),
    NCK_LETTERS_XYZ = 7 << ('X' - 'A'),
    NCK_LETTERS_AXES = NCK_LETTERS_LINEAR | 7, // A B C
    NCK_LETTERS_CENTRE = (1 << ('I' - 'A')) | (1 << ('J' - 'A')) | (1 << ('K' - 'A'))
};

// codes.c: 1 if the words are arguments of G65 or G66. Cost: constant.
int nck_words_are_arguments(const nck_words_t *words);

// rest.c: at a /: is what stands behind it skipped? *at: one past it, its number. Cost: constant.
int nck_decode_skips(const nck_decode_t *self, const char **at);

// rest.c: something is left of the line. Cost: constant.
void nck_decode_leave(nck_decode_t *self, nck_rest_t rest);

// A step.
typedef nck_status_t (*nck_step_function_t)(nck_decode_t *self, nck_block_t *out);

// finding.c: note the line's error, the last one counts. column: 1-based, 0 for the whole line;
// letter: upper case or 0. Returns code. Cost: constant.
nck_status_t nck_decode_fail(nck_decode_t *self, nck_status_t code, unsigned column, int letter,
                             double value, double limit);

// finding.c: the same at a place of the line's text; for a word of the line: its column and letter.
nck_status_t nck_decode_fail_at(nck_decode_t *self, nck_status_t code, const char *at, int letter,
                                double value, double limit);
nck_status_t nck_decode_fail_word(nck_decode_t *self, nck_status_t code, int letter, double value,
                                  double limit);
// The same at the code of a step, if the line has one; for that code itself.
nck_status_t nck_decode_fail_step(nck_decode_t *self, nck_status_t code, nck_step_t step,
                                  int letter, double value, double limit);
nck_status_t nck_decode_fail_code(nck_decode_t *self, nck_status_t code, nck_step_t step);

// finding.c: is the text at a place in the language that is read? whose: bits of nck_tongue_t.
// NCK_E_OTHER_BASE. Cost: constant.
nck_status_t nck_decode_only(nck_decode_t *self, const char *at, uint32_t whose);

// finding.c: queue a finding. Cost: constant.
void nck_decode_find(nck_decode_t *self, const nck_diagnostic_t *finding);

// finding.c: give a note if the program leaves it to the machine. Cost: constant.
void nck_decode_assume(nck_decode_t *self, nck_note_t note);

// finding.c: give a note, once in a program, about what a word asks for. Cost: constant.
void nck_decode_note_word(nck_decode_t *self, nck_note_t note, char letter, double value);
// The same about a G code.
void nck_decode_note_code(nck_decode_t *self, nck_note_t note, nck_step_t step, double code);

// axis.c: the letter of axis 0 … 8: X Y Z A B C U V W. Cost: constant.
int nck_decode_letter(unsigned axis);

// axis.c: the word of an axis, [nm] or [ndeg]; NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_axis_word(nck_decode_t *self, unsigned axis, int64_t *value_out);

// target.c: the machine position that the axis words name; axes without a word stay. absolute: 1:
// words count from the machine's zero (G53). NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_target(nck_decode_t *self, int absolute, int64_t *target_nm);

// axis.c: a place or a way of a linear axis as a word: nine decimals name every nanometre, in
// inches too. Cost: constant.
void nck_decode_write(const nck_decode_t *self, unsigned axis, int64_t value_nm,
                      nck_number_t *out);

// axis.c: a length [nm] that stands in the line, whatever its letter. NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_length_word(nck_decode_t *self, char letter, int64_t *value_out);

// axis.c: a value of so many counts as a word of that scale says it. Cost: constant.
double nck_decode_as_word(const nck_scale_t *scale, double value_nm);

// axis.c: a place of an axis is beyond what it may be, its word counting so many times in it. Told
// is the word, and the largest that is within; without a word the place. NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_beyond(nck_decode_t *self, unsigned axis, double at_nm, double times);

// axis.c: count steps on from a machine position of an axis. NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_steps(nck_decode_t *self, unsigned axis, int64_t step_nm, int64_t count,
                              int64_t *at_nm);

// axis.c: is a machine position within the travel of its axis? NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_decode_travel(nck_decode_t *self, unsigned axis, int64_t position_nm);

// quick.c: the block of a line that only moves X Y Z straight, in a program that has begun. Returns
// 1, or 0 with nothing done: the line says more, or is wrong. Cost: linear in the line.
int nck_decode_quick(nck_decode_t *self, nck_block_t *out);

// words.c: the line from `at` on as words. Cost: linear in the line.
nck_status_t nck_decode_words(nck_decode_t *self, const char *at);

// remark.c: LinuxCNC's remarks from `first` on: one in another one is NCK_E_COMMENT, letter (;
// where the last one says (abort, …) the program ends before the line. Cost: linear in the line.
nck_status_t nck_decode_remarks(nck_decode_t *self, const char *first);

// words.c: the line is refused. If it says a feed, a speed or the first motion, that one is missing
// behind it is no mistake of its own. Cost: linear in the line.
void nck_decode_excuse(nck_decode_t *self);

// What a parameter without a value is: no number of a program is as large.
#define NCK_NO_VALUE 1e301

#define NCK_VALUE_NEAR 1e-4 // RS274NGC: what differs by less is equal

// variables.c: 1 if it is a value; 1 if it is one and not 0, so that a condition holds; 1 if it is
// nearly the number of a parameter. Cost: constant.
int nck_value_is(double value);
int nck_value_holds(double value);
int nck_value_index(double value, uint32_t *index_out);

// sign.c: one past blanks and remarks; one past the word (upper case) if the text spells it, in
// either case, else NULL; the first of a list that it spells, from 1, and one past it, 0: none;
// one past a name's >, NULL: none. at: its <. Each word of a list ends with a
// blank. Cost: linear in the text.
const char *nck_decode_skip(const char *at);
const char *nck_decode_spells(const char *at, const char *word);
unsigned nck_decode_listed(const char *at, const char *words, const char **behind);
const char *nck_decode_name_end(const char *at);

// sign.c: one past a number or a name in < >, and its key; NULL: neither.
const char *nck_decode_name_key(const char *at, uint64_t *key_out);

// control.c: # … =: waits for the end of the line. Cost: linear in the line.
nck_status_t nck_decode_assign(nck_decode_t *self, const char **at);

// control.c: IF, GOTO, WHILE, DO, END. NCK_EMPTY: it is none of them. Cost: linear in the line.
nck_status_t nck_decode_control(nck_decode_t *self, const char **at);

// oword.c: an O word. Cost: linear in the line.
nck_status_t nck_decode_o_word(nck_decode_t *self, const char **at);

// integer.c: a whole number of a word within 0 … most; without the word `otherwise`.
// NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_whole(nck_decode_t *self, char letter, int64_t most, int64_t otherwise,
                              int64_t *out);

// argument.c: of an I, J or K of G65 or G66: which one in the row of them it is, from 1, and its
// number. All arguments of the line in work are kept for the call. NCK_E_WORD_TWICE,
// NCK_E_UNSUPPORTED: in an order that leaves open which; NCK_E_VARIABLES. Cost: linear in these.
nck_status_t nck_argument_place(nck_decode_t *self, const char *at, unsigned *place_out);
nck_status_t nck_argument_keep(nck_decode_t *self, const char *at, unsigned place,
                               const nck_number_t *number);
nck_status_t nck_argument_all(nck_decode_t *self);

// call.c: M98, M99, G65, G66, G67; a move is done while G66 is in force.
nck_status_t nck_decode_call(nck_decode_t *self, nck_block_t *out);
void nck_decode_moved(nck_decode_t *self);

// expression.c: a value that begins with #, [, a sign, a function or a digit; bare: operators may
// stand outside of brackets. May be NCK_NO_VALUE. Cost: linear in the text.
nck_status_t nck_decode_value(nck_decode_t *self, const char **at, int bare, double *value_out);

// expression.c: a value as a number of the program.
void nck_decode_number(double value, nck_number_t *out);

// jump.c: the line in work while something is looked for: NCK_OK: it is to be read, NCK_EMPTY: it
// is passed over. The end of the text while something is looked for. The calls in force, behind an
// error.
nck_status_t nck_seek_pass(nck_decode_t *self);
nck_status_t nck_seek_wrap(nck_decode_t *self);
void nck_decode_tell_calls(nck_decode_t *self);

// source.c: the next line of the source, or the end of the text; what follows the program's end.
void nck_decode_fetch(nck_decode_t *self);
void nck_decode_watch(nck_decode_t *self);

// codes.c: what a code is to the language in force. Returns NCK_OK; NCK_E_UNSUPPORTED: it has the
// code, and it is not built; NCK_E_OTHER_BASE: others have it; NCK_E_G_UNKNOWN, NCK_E_M_UNKNOWN.
// letter: G or M; tenths: the code; *takes_out: letters that it uses. Cost: linear in the codes.
nck_status_t nck_decode_code(const nck_decode_t *self, int letter, int64_t tenths,
                             unsigned *step_out, uint32_t *takes_out);

// codes.c: who has a code: bits of nck_tongue_t. Cost: linear in the codes.
uint32_t nck_decode_who(int letter, int64_t tenths);

// codes.c: the machine's entry for an M code; NULL: it has none. Cost: linear in the entries.
const nck_own_m_t *nck_decode_own_m(const nck_decode_t *self, int64_t code);

// mode.c: 1 if the machine's file explains a G code in tenths; what G5 G5.1 G8 G61.1 G62 G63 G187
// of Fanuc's language do: NCK_E_WORD_MISSING, NCK_E_WORD_UNUSED, NCK_E_NUMBER_RANGE; what a code
// does that only the machine's file has. Cost: linear in its entries.
int nck_decode_has_own_g(const nck_decode_t *self, int64_t tenths);
nck_status_t nck_decode_mode(nck_decode_t *self);
void nck_decode_own_mode(nck_decode_t *self);

// codes.c: whether a motion in tenths works on a contour: Fanuc's G70 to G73 on a lathe, RS274NGC's
// G70 … G72.2. Cost: constant.
int nck_decode_follows(const nck_decode_t *self, int32_t motion);

// codes.c: the letters that a motion, or another G code in tenths, uses. Cost: constant.
uint32_t nck_decode_motion_takes(const nck_decode_t *self, int32_t motion);

// resolve.c: do words and codes of the line fit, and who gets the axis words? Cost: constant.
nck_status_t nck_decode_resolve(nck_decode_t *self);

// foreign.c: whose language the line is, 0 if it does not say. Cost: linear in the line.
int nck_decode_foreign(const char *line);

// modal.c: settings and outputs.
nck_status_t nck_decode_units(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed_mode(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_change(nck_decode_t *self, nck_block_t *out);
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
nck_status_t nck_decode_retract(nck_decode_t *self, nck_block_t *out);

// tool.c: T; a tool number. On Fanuc's lathes T0202: NCK_E_TOOL_UNKNOWN, NCK_E_COMP_ON.
// Cost: linear in the tools.
nck_status_t nck_decode_tool(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_set_tool(nck_decode_t *self, double value, nck_block_t *out);

// spindle.c: G96, G97; S; the S of Fanuc's G92 (system A: G50).
nck_status_t nck_decode_speed_mode(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_speed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_speed_limit(nck_decode_t *self);

// spindle.c: a speed [rpm], which ends G96. Cost: constant.
nck_status_t nck_decode_set_speed(nck_decode_t *self, double value, nck_block_t *out);

// output.c: the most under G96 [rpm], 0: none; 1 if the spindle turns. Cost: constant.
double nck_decode_speed_most(const nck_decode_t *self);
int nck_decode_turns(const nck_decode_t *self);

// output.c: a block that hands something over.
nck_status_t nck_decode_give_output(const nck_decode_t *self, nck_block_kind_t block,
                                    nck_output_kind_t kind, double value, nck_block_t *out);

// modal.c: a feed [mm/min, mm/rev or 1/min], and as written; the word of a dwell. output.c: a
// dwell, an M code as an output. Cost: constant.
void nck_decode_set_feed(nck_decode_t *self, double feed, double word);
nck_status_t nck_decode_dwell_word(nck_decode_t *self, char letter, double *dwell_out);
nck_status_t nck_decode_give_m(const nck_decode_t *self, double code, nck_block_t *out);
nck_status_t nck_decode_give_dwell(const nck_decode_t *self, double dwell_s, nck_block_t *out);

// output.c: fill a block with all that is modal; the target is the present position.
// Cost: constant.
void nck_decode_block(const nck_decode_t *self, nck_block_kind_t kind, nck_block_t *out);

// axis.c: the scales of axis words, after a change of units or of diameter mode. Cost: constant.
void nck_decode_scale(nck_decode_t *self);

// output.c: a tool of the table, NULL if it has none of that number. Cost: linear in the tools.
const nck_tool_t *nck_decode_find_tool(const nck_decode_t *self, uint32_t number);

// table.c: a tool with what G10 has changed; returns 0 if the table has none of that number. G10
// with another list than L2 and L20: NCK_E_UNSUPPORTED, NCK_E_TOOL_UNKNOWN, NCK_E_NUMBER_RANGE,
// NCK_E_WORD_UNUSED, NCK_E_WORD_MISSING, NCK_E_VARIABLES. Cost: linear in tools and parameters.
int nck_table_find(const nck_decode_t *self, uint32_t number, nck_tool_t *tool_out);
nck_status_t nck_table_set(nck_decode_t *self, int64_t list);

// table.c: does the language have this list of G10? NCK_E_UNSUPPORTED. Cost: constant.
nck_status_t nck_table_lists(nck_decode_t *self, int64_t list);

// port.c: M62 … M68. Cost: constant.
nck_status_t nck_decode_port(nck_decode_t *self, nck_block_t *out);

// state.c: M70 … M73; a call of that level is over; an output of a restored state, NCK_EMPTY: it
// owes none. NCK_E_DEPTH, NCK_E_FLOW, NCK_E_COMP_ON. Cost: constant.
nck_status_t nck_decode_state(nck_decode_t *self, nck_block_t *out);
void nck_state_return(nck_decode_t *self, uint32_t level);
nck_status_t nck_state_give(nck_decode_t *self, nck_step_t step, nck_block_t *out);

// jump.c: how many calls are in force. Cost: linear in the frames.
uint32_t nck_call_level(const nck_decode_t *self);

// layout.c: G15 G16 G50 G51 G50.1 G51.1 G68 G69, and where the words of X Y Z then lead.
// NCK_E_LAYOUT_ON, NCK_E_SCALE_UNIT, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_layout(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_layout_target(nck_decode_t *self, int64_t *target_nm);

// layout.c: a way in the plane as it lies in the work system; returns by how much it is longer, < 0
// if the plane is mirrored, 0 if its axes have not the same scale. Cost: constant.
double nck_layout_way(const nck_decode_t *self, double *way);

// layout.c: 1 if the words name the radius of polar coordinates. Cost: constant.
int nck_layout_says_radius(const nck_decode_t *self);

// layout.c: is an axis neither mirrored nor scaled? NCK_E_LAYOUT_ON. Cost: constant.
nck_status_t nck_layout_spares(nck_decode_t *self, unsigned axis);

// polar.c: @ or ^ of RS274NGC; both become words of X and Y; those of the next hole. NCK_E_VALUE,
// NCK_E_WORD_SHARED, NCK_E_INCREMENTAL, NCK_E_UNSUPPORTED, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_polar_read(nck_decode_t *self, const char **at);
nck_status_t nck_polar_resolve(nck_decode_t *self);
void nck_polar_next(nck_decode_t *self);

// layout.c: the bit of a code, 0: it is none of them; 1 if it cannot stand beside others; what
// cannot be done while one is in force: NCK_E_LAYOUT_ON. Cost: constant.
uint32_t nck_layout_bit(int64_t tenths);
int nck_layout_collides(uint32_t codes, uint32_t bit);
nck_status_t nck_layout_refuses(nck_decode_t *self);

// Steps whose codes may have the axis words.
#define NCK_STEPS_AXES                                                                            \
    (NCK_STEP(NCK_STEP_OFFSET) | NCK_STEP(NCK_STEP_LAYOUT) | NCK_STEP(NCK_STEP_LENGTH))

// codes.c: 1 if a code that is no motion has the axis words. Cost: constant.
int nck_words_set_axes(const nck_words_t *words);

// comp.c: G40, G41, G42; what cannot be done while G41 or G42 is in force.
nck_status_t nck_decode_comp(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_comp_refuses(nck_decode_t *self);

// place.c: offsets.
nck_status_t nck_decode_length(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_work(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_offset(nck_decode_t *self);

// turned.c: the origin from its parts, after a change of one. Cost: constant.
void nck_decode_origin(nck_decode_t *self);

// motion.c: moves.
nck_status_t nck_decode_motion(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_reference(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_second(nck_decode_t *self, nck_block_t *out);

// motion.c: the feed of a cut. NCK_E_FEED_MISSING: none was ever said, G93 without F here, G95 at a
// standstill; NCK_EMPTY: the same, and known. Cost: constant.
nck_status_t nck_decode_cutting_feed(nck_decode_t *self, int rotary_alone, double *feed_out);

// motion.c: whether a straight move of a kind has the F in force; straight on to a machine place,
// as G0 or G1, taken as reached. NCK_E_TRAVEL, and as above. Cost of both: constant.
int nck_decode_has_feed(const nck_decode_t *self, uint8_t kind);
nck_status_t nck_decode_straight(nck_decode_t *self, nck_block_kind_t kind,
                                 const int64_t *target_nm, nck_block_t *out);

// probe.c: G38.2 … G38.5. NCK_E_PROBE, and as above. Cost: linear in the parameters.
nck_status_t nck_decode_probe(nck_decode_t *self, nck_block_t *out);

// motion.c: a cycle is not for inverse time, nor for radius compensation. NCK_E_UNSUPPORTED,
// NCK_E_COMP_ON. Cost: constant.
nck_status_t nck_decode_cycle_fits(nck_decode_t *self);

// motion.c: a block of a cycle to the present position; within: as any other move is, exact: its
// corners are not rounded; G61.1, G9 and a tolerance stop at them. feed: of NCK_BLOCK_LINE.
// Cost: constant.
void nck_decode_give_within(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                            nck_block_t *out);
void nck_decode_give_exact(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                           nck_block_t *out);

// motion.c: the motion of the line in work to a machine position; pushed: of this block, NULL: of
// words. Cost: constant.
nck_status_t nck_decode_go(nck_decode_t *self, const nck_block_in_t *pushed,
                           const int64_t *target_nm, nck_block_t *out);

// cycle.c: the holes of a canned cycle; turn.c, peck.c: the moves of one for turning, of G74, G75.
nck_status_t nck_decode_cycle(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_turn(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_peck(nck_decode_t *self, nck_block_t *out);

// profile.c: G70 … G73.
nck_status_t nck_decode_profile(nck_decode_t *self, nck_block_t *out);

// contour.c: the lines that follow are a contour's, for the cycle of that code. Cost: constant.
void nck_contour_begin(nck_decode_t *self, nck_contour_mode_t mode, uint32_t code);

// contour.c: of such a line: its words before they are resolved, the line behind that, a block that
// it gave, and its end: with the last line the cycle begins. status: the line's own, handed back.
// NCK_E_CONTOUR, NCK_E_CONTOUR_FULL. Cost: constant.
nck_status_t nck_contour_words(nck_decode_t *self);
nck_status_t nck_contour_check(nck_decode_t *self);
nck_status_t nck_contour_take(nck_decode_t *self, const nck_block_t *block);
nck_status_t nck_contour_behind(nck_decode_t *self, nck_status_t status);

// contour.c: the text ends in the middle of it. NCK_E_LABEL. Cost: constant.
nck_status_t nck_contour_missing(nck_decode_t *self);

// corner.c: 1 if the language has ,R and ,C; the word of one; of letters that nobody uses those
// that are a corner's on lathes. Cost: constant.
int nck_corner_speaks(const nck_decode_t *self);
void nck_corner_keep(nck_decode_t *self, char letter, unsigned column,
                     const nck_number_t *number, int is_old);
uint32_t nck_corner_letters(nck_decode_t *self, uint32_t letters);

// corner.c: the line behind a corner, resolved; what a line's steps gave while a corner is in work:
// NCK_EMPTY: the block is held; the corner, and the move behind it; the text ends before it. All:
// NCK_E_CORNER. Cost: constant.
nck_status_t nck_corner_words(nck_decode_t *self);
nck_status_t nck_corner_take(nck_decode_t *self, nck_status_t status, nck_block_t *out);
nck_status_t nck_corner_next(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_corner_missing(nck_decode_t *self);

// thread.c: G33, in system A G32. Whether a thread can be cut here: NCK_E_THREAD_SPEED, and as
// nck_decode_cycle_fits. The lead [mm] of a word; F may hold from the thread before. Fanuc's Q: the
// angle at the begin [revolutions]. A pass from where the tool stands; its duration is filled in:
// NCK_E_THREAD_SPEED, NCK_E_THREAD_RUN_IN, NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_decode_single_pass(nck_decode_t *self, nck_block_t *out);
double nck_decode_thread_name(const nck_decode_t *self); // the code in work, as its system says it
nck_status_t nck_decode_thread_fits(nck_decode_t *self);
nck_status_t nck_decode_lead(nck_decode_t *self, char letter, double *lead_out);
nck_status_t nck_decode_start_angle(nck_decode_t *self, float *turn_out);
nck_status_t nck_decode_pass(nck_decode_t *self, const int64_t *end_nm, nck_thread_t *thread,
                             nck_block_t *out);

// spline.c: G5, G5.1, G5.2, G5.3, G6.2. Cost: constant, of G6.2 linear in its points.
nck_status_t nck_decode_spline(nck_decode_t *self, nck_block_t *out);

// rest.c: the line begins a spline whose end is another line; 1 if one is not ended; what a step
// that moves does meanwhile; a line of it was refused, and its others are no mistakes; the program
// ends: NCK_E_SPLINE. Cost: constant.
void nck_spline_begins(nck_decode_t *self);
int nck_spline_waits(const nck_decode_t *self);
nck_status_t nck_spline_refuses(nck_decode_t *self, nck_step_t step);
void nck_spline_break(nck_decode_t *self);
nck_status_t nck_spline_missing(nck_decode_t *self);

// knots.c: a line of G6.2: a knot, and a point or not. NCK_OK; NCK_DONE: it was the last one;
// NCK_E_SPLINE, NCK_E_CONTOUR_FULL, NCK_E_SCALE_UNIT, and as nck_decode_cycle_fits. Cost: linear in
// the points.
nck_status_t nck_decode_knots(nck_decode_t *self);

// tap.c: G33.1; a tapped hole from where the tool stands, with all in force that it needs.
// NCK_E_THREAD_SPEED, NCK_E_THREAD_RUN_IN. Cost: constant.
nck_status_t nck_decode_single_tap(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_tap(nck_decode_t *self, const int64_t *bottom_nm, double lead,
                            double dwell_s, nck_block_t *out);

// screw.c: the passes of a threading cycle. Cost: constant.
nck_status_t nck_decode_screw(nck_decode_t *self, nck_block_t *out);

// entry.c: where the axes stand before a program that begins in the middle; 1 if it begins here,
// with the line in work or the one that waits; a jump of that kind has met a line; a block before
// it: NCK_OK: it is of the path, NCK_EMPTY: it is not handed over; the next block of what is in
// force there, NCK_EMPTY behind the last one. NCK_E_LABEL: the program never comes to it;
// NCK_E_APPROACH.
// Cost: constant.
void nck_entry_begin(nck_decode_t *self);
int nck_entry_is_here(nck_decode_t *self);
void nck_entry_leave_out(nck_decode_t *self, nck_seek_kind_t kind);
nck_status_t nck_entry_pass(nck_decode_t *self, const nck_block_t *block);
nck_status_t nck_entry_next(nck_decode_t *self, nck_block_t *out);

// lathe.c: 1 on a lathe that speaks Fanuc's language; what its G-code system means by a code, in
// system B's names; 1 if that is system A. Cost: constant.
int nck_lathe_speaks_fanuc(const nck_decode_t *self);
int64_t nck_lathe_code(const nck_decode_t *self, int64_t tenths);
int nck_lathe_is_a(const nck_decode_t *self);

// lathe.c: U V W that no axis has become places of X Y Z. NCK_EMPTY: they are no steps here;
// NCK_E_AXIS_UNKNOWN, NCK_E_WORD_TWICE, NCK_E_INCREMENTAL, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_lathe_steps(nck_decode_t *self, uint32_t strangers);

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
