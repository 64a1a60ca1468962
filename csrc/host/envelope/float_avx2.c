// SPDX-License-Identifier: MIT
// The exact envelope in float, for x86-64 with AVX2; compiled with -mavx2, used where the
// processor has it.
#define NCK_REAL float
#define ENVELOPE_VARIANT nck_host_envelope_float_avx2

#include "host/envelope/simd_float_avx2.h" // lanes_t

#include "host/envelope/whole.h" // ENVELOPE_VARIANT
