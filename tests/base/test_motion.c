// SPDX-License-Identifier: MIT
// The fastest motion over a clock, in the numbers of the build.
#include "fastest_check.h"

int main(void) { return fastest_check(); }
