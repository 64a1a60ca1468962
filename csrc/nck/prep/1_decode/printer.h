// SPDX-License-Identifier: MIT
// The room's inner doors to the words of printers. Context of all: prep.
#ifndef NCK_PREP_DECODE_PRINTER_H
#define NCK_PREP_DECODE_PRINTER_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// 1 if an M code in tenths is one of Marlin's; if a G code is that moves something and does not say
// what; if the line is one's; one past the text of a step's code; who takes its words; what it
// hands over. NCK_E_MODAL_GROUP. Cost: linear in the codes, and in the text.
int nck_printer_has(const nck_decode_t *self, int64_t tenths);
int nck_printer_has_g(const nck_decode_t *self, int64_t tenths, uint32_t *takes_out);
int nck_printer_names(int64_t tenths);
int nck_printer_speaks(const nck_decode_t *self);
const char *nck_printer_text(const nck_decode_t *self, const char *at, unsigned step);

// One past an M code, and its number: a blank ends it, since text may follow (M117 5 %).
// NULL: it is none of a printer's. Cost: constant.
const char *nck_printer_code(const char *at, nck_number_t *out);

// The line's checksum behind a *; NCK_E_NUMBER; NCK_E_NUMBER_RANGE: it is another one.
// 1 if a letter stands without a number here: the axes of G28, and its W. Cost: linear in the line.
nck_status_t nck_printer_checksum(nck_decode_t *self, const char **at);
int nck_printer_flag(const nck_decode_t *self, char letter);
nck_status_t nck_printer_resolve(nck_decode_t *self);
nck_status_t nck_decode_printer(nck_decode_t *self, nck_block_t *out);

// E becomes U. NCK_E_AXIS_UNKNOWN, NCK_E_WORD_TWICE, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_printer_extrude(nck_decode_t *self);

#endif
