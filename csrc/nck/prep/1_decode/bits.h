// SPDX-License-Identifier: MIT
// Values of programs as bits, and as decimal digits of four bits each (BCD): what Fanuc's AND, OR,
// XOR, BIN and BCD are about.
#ifndef NCK_PREP_DECODE_BITS_H
#define NCK_PREP_DECODE_BITS_H

#include <stdint.h> // uint32_t

// The bits of a whole number 0 … 2^32 − 1. Returns 0 if it is none. Cost: constant. Context: any.
int nck_bits(double value, uint32_t *bits_out);

// 0 … 99999999 as BCD (15 → 21), and back; −1: it cannot be. Cost: constant. Context: any.
double nck_to_bcd(double value);
double nck_from_bcd(double value);

#endif
