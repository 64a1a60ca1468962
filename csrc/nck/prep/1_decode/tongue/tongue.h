// SPDX-License-Identifier: MIT
// Which codes and words a language has, and what the machine's file adds to it.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_TONGUE_TONGUE_H
#define NCK_PREP_DECODE_TONGUE_TONGUE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- codes.c

// 1 if the words are arguments of G65 or G66. Cost: constant.
int nck_words_are_arguments(const nck_words_t *words);

// What a code is to the language in force. Returns NCK_OK; NCK_E_UNSUPPORTED: it has the code, and
// it is not built; NCK_E_OTHER_BASE: others have it; NCK_E_G_UNKNOWN, NCK_E_M_UNKNOWN. letter: G or
// M; tenths: the code; *takes_out: letters that it uses. Cost: linear in the codes.
nck_status_t nck_decode_code(const nck_decode_t *self, int letter, int64_t tenths,
                             unsigned *step_out, uint32_t *takes_out);

// Who has a code: bits of nck_tongue_t. Cost: linear in the codes.
uint32_t nck_decode_who(int letter, int64_t tenths);

// The machine's entry for an M code; NULL: it has none. Cost: linear in the entries.
const nck_own_m_t *nck_decode_own_m(const nck_decode_t *self, int64_t code);

// Whether a motion in tenths works on a contour: Fanuc's G70 to G73 on a lathe, RS274NGC's G70 …
// G72.2. Cost: constant.
int nck_decode_follows(const nck_decode_t *self, int32_t motion);

// The letters that a motion, or another G code in tenths, uses. Cost: constant.
uint32_t nck_decode_motion_takes(const nck_decode_t *self, int32_t motion);

// 1 if a code that is no motion has the axis words. Cost: constant.
int nck_words_set_axes(const nck_words_t *words);

// ---- mode.c

// What G5 G5.1 G8 G61.1 G62 G63 G187 of Fanuc's language do: NCK_E_WORD_MISSING, NCK_E_WORD_UNUSED,
// NCK_E_NUMBER_RANGE; what a code does that only the machine's file has. Cost: linear in its
// entries.
nck_status_t nck_decode_mode(nck_decode_t *self);
void nck_decode_own_mode(nck_decode_t *self);

// The tolerance of a path that no G64 P says one of [mm]. Cost: constant. Context: prep.
static inline double nck_decode_plain_mm(const nck_decode_t *self) {
    const double chosen = self->modal.plain_mm;
    return chosen < 0.0 ? self->machine->path.tolerance : chosen;
}

// ---- printer.c

// 1 if the line is a printer's; one past the text of a step's code. Cost: linear in the text.
int nck_printer_speaks(const nck_decode_t *self);
const char *nck_printer_text(const nck_decode_t *self, const char *at, unsigned step);

// 1 if M0 or M1 goes on by itself, and after how long [s]: S, or P in milliseconds, stands before
// its text. Cost: linear in the text.
int nck_printer_pauses(const nck_decode_t *self, double *wait_out);

// One past an M code, and its number: a blank ends it, since text may follow (M117 5 %). NULL: it
// is none of a printer's. Cost: constant.
const char *nck_printer_code(const char *at, nck_number_t *out);

// What a letter is that stands without a number: an axis of G28, or B or R of M220; another one of
// G28, which changes no place.
typedef enum nck_flag { NCK_FLAG_NONE = 0, NCK_FLAG_WORD = 1, NCK_FLAG_IDLE = 2 } nck_flag_t;

// The line's checksum behind a *; NCK_E_NUMBER; NCK_E_NUMBER_RANGE: it is another one; what a
// letter without a number is. Cost: linear in the line.
nck_status_t nck_printer_checksum(nck_decode_t *self, const char **at);
nck_flag_t nck_printer_flag(const nck_decode_t *self, char letter);
nck_status_t nck_printer_resolve(nck_decode_t *self);
nck_status_t nck_decode_printer(nck_decode_t *self, nck_block_t *out);

// E becomes U. NCK_E_AXIS_UNKNOWN, NCK_E_WORD_TWICE, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_printer_extrude(nck_decode_t *self);

// ---- turning.c

// 1 on a lathe that speaks Fanuc's language; what its G-code system means by a code, in system B's
// names; 1 if that is system A. Cost: constant.
int nck_lathe_speaks_fanuc(const nck_decode_t *self);
int64_t nck_lathe_code(const nck_decode_t *self, int64_t tenths);
int nck_lathe_is_a(const nck_decode_t *self);

// U V W that no axis has become places of X Y Z. NCK_EMPTY: they are no steps here;
// NCK_E_AXIS_UNKNOWN, NCK_E_WORD_TWICE, NCK_E_INCREMENTAL, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_lathe_steps(nck_decode_t *self, uint32_t strangers);

// ---- foreign.c

// Whose language the line is, 0 if it does not say. Cost: linear in the line.
int nck_decode_foreign(const char *line);

#endif
