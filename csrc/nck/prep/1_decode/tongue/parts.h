// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_TONGUE_PARTS_H
#define NCK_PREP_DECODE_TONGUE_PARTS_H

#include "nck/prep/1_decode/tongue/tongue.h"

// ---- mode.c

// 1 if the machine's file explains a G code in tenths. Cost: linear in its entries.
int nck_decode_has_own_g(const nck_decode_t *self, int64_t tenths);

// ---- printer.c

// 1 if an M code in tenths is one of Marlin's, whatever language is read; if the language in force
// has it; if it has a G code of printers, and the letters that this takes. Cost: linear in the
// codes.
int nck_printer_names(int64_t tenths);
int nck_printer_has(const nck_decode_t *self, int64_t tenths);
int nck_printer_has_g(const nck_decode_t *self, int64_t tenths, uint32_t *takes_out);

#endif
