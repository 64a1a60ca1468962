// SPDX-License-Identifier: MIT
// The arithmetic that the kernel's bits need: doubles of IEEE 754, every operation rounded once and
// by itself, in the order of the source. A compiler that is told otherwise is stopped here. What no
// compiler tells, nck_selftest finds when it runs.
#ifndef NCK_BASE_BITS_H
#define NCK_BASE_BITS_H

#include <float.h> // FLT_EVAL_METHOD DBL_MANT_DIG

#if FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024
#error "libnck needs a double of 64 bits as in IEEE 754"
#endif

// 0: each type in its own; 1: float in double, and the kernel has no float. x87 says 2: it rounds
// twice.
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 1
#error "doubles are not computed as doubles here: on x86 compile with -msse2 -mfpmath=sse"
#endif

#ifdef __FAST_MATH__
#error "-ffast-math changes setpoints: compile libnck without it"
#endif
#ifdef __FINITE_MATH_ONLY__
#if __FINITE_MATH_ONLY__
#error "-ffinite-math-only changes setpoints: compile libnck without it"
#endif
#endif

// a·b + c is two roundings. gcc does not read the pragma of the standard, and takes the option
// -ffp-contract=off in this way, too; clang heeds it but for -ffp-contract=fast.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off")
#else
#pragma STDC FP_CONTRACT OFF
#endif

#endif
