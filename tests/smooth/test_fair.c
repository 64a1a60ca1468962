// SPDX-License-Identifier: MIT
// Room 3: the smoothest curve within a tolerance.
#include "fair_check.h" // fair_tests

int main(void)
{
    return fair_tests();
}
