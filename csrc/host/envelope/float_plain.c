// SPDX-License-Identifier: MIT
// The exact envelope in float, for any processor.
#define NCK_REAL float
#define ENVELOPE_VARIANT nck_host_envelope_float_plain

#include "host/envelope/simd_plain.h" // lanes_t

#include "host/envelope/whole.h" // ENVELOPE_VARIANT
