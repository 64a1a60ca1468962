// SPDX-License-Identifier: MIT
// What the program switches: spindle and coolant.
#ifndef APP_OUTPUT_H
#define APP_OUTPUT_H

#include "nck/nck.h" // nck_output_t

// Switch what an output says; user is the app_t. Cost: constant. Context: tick.
void app_output(void *user, const nck_output_t *output);

// The spindle's speed at this tick [rpm]: under G96 it follows the position, while taps is 1 it
// brakes and turns back (< 0). user is the app_t. Cost: constant. Context: tick.
void app_output_follow(void *user, double rpm, int taps);

#endif
