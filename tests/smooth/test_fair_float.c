// SPDX-License-Identifier: MIT
// Room 3: the smoothest curve within a tolerance, solved in single floats.
#define NCK_NUM float
#include "nck/prep/3_smooth/fair.c"

#include "fair_check.h" // fair_tests

int main(void)
{
    return fair_tests();
}
