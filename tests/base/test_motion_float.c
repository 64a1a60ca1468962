// SPDX-License-Identifier: MIT
// The fastest motion over a clock in floats: its files once more, for numbers that the build of the
// kernel has not.
#define NCK_NUM float
#include "nck/base/motion.c"
#include "nck/base/motion_caps.c"
#include "nck/base/motion_check.c"
#include "nck/base/motion_place.c"
#include "nck/base/motion_rows.c"

#include "fastest_check.h"

int main(void) { return fastest_check(); }
