// SPDX-License-Identifier: MIT
// What the owner of a machine writes into its INI for this planner: jerk, profile, budget.
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

#include "nck/nck.h" // NCK_PROFILE

enum {
    SETTINGS_AXES = 9,    // X Y Z A B C U V W
    SETTINGS_SHORT = NCK_PROFILE > 1024, // 1: built for servo periods of less than 1 ms
    // of a millisecond's cycles, where the INI says nothing [1000 instructions]
    SETTINGS_BUDGET = SETTINGS_SHORT ? 480 : 240,
    SETTINGS_WHY = 256    // longest message
};

// As the owner wants it, in mm, degrees and seconds.
typedef struct settings {
    double mm_per_unit;      // of X Y Z U V W: 25.4 on a machine that counts in inches
    double deg_per_unit;     // of A B C
    uint32_t axes;           // bit k: the machine has axis k
    uint32_t slope;          // nck_slope_kind_t
    uint32_t budget;         // of a cycle [1000 instructions]; 0: SETTINGS_BUDGET a ms
    double tolerance;        // of a G64 without P [mm]
    uint32_t jerk_given;     // 1: by the command that loads the module: no move changes it
    double jerk[SETTINGS_AXES]; // [mm/s³, deg/s³]; 0: none
    double v_max[SETTINGS_AXES]; // [mm/s, deg/s] until the host tells its own
    double a_max[SETTINGS_AXES]; // [mm/s², deg/s²]
} settings_t;

// What the command that loads the module says; it comes before the INI.
typedef struct settings_given {
    int jerk;            // of every axis [units/s³]; 0: as the INI says
    int budget;          // the same; 0: as the INI says
    const char *planner; // "jerk", "optimal" or "linear"; NULL: as the INI says
} settings_given_t;

// Read the INI of a path; NULL: there is none, then `given` has to say the jerk.
// Returns 1; 0 if something is missing or wrong, why tells what and what to do, SETTINGS_WHY bytes.
// Cost: reads the file once for every word. Context: while the module loads.
int settings_read(settings_t *settings, const char *path, const settings_given_t *given, char *why);

// What serves a planner that takes no move. Cost: constant. Context: while the module loads.
void settings_rest(settings_t *settings);

// What its owner calls the planner in force. Cost: constant. Context: any.
const char *settings_planner(const settings_t *settings);

// Millimetres or degrees in one unit of the axis. Cost: constant. Context: any.
double settings_scale(const settings_t *settings, int axis);

#endif
