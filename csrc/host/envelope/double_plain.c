// SPDX-License-Identifier: MIT
// The exact envelope in double, for any processor.
#define NCK_REAL double
#define ENVELOPE_VARIANT nck_host_envelope_double_plain

#include "host/envelope/simd_plain.h" // lanes_t

#include "host/envelope/whole.h" // ENVELOPE_VARIANT
