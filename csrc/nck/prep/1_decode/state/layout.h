// SPDX-License-Identifier: MIT
// How a program's coordinates lie in the work system: mirrored, scaled, turned, polar.
#ifndef NCK_PREP_DECODE_STATE_LAYOUT_H
#define NCK_PREP_DECODE_STATE_LAYOUT_H

#include <stdint.h> // int64_t

#include "nck/base/limits.h" // NCK_LAYOUT_STATE

// What may be in force, bit by bit.
enum {
    NCK_LAYOUT_MIRROR = 1, NCK_LAYOUT_SCALE = 2, NCK_LAYOUT_TURN = 4, NCK_LAYOUT_POLAR = 8,
    NCK_LAYOUT_SYSTEM = 16 // the turn is that of the work system, in X and Y, whatever the plane
};

// Codes of NCK_STEP_LAYOUT, bit by bit: a line may have one of each pair.
enum {
    NCK_LAYOUT_G15 = 1, NCK_LAYOUT_G16 = 2, NCK_LAYOUT_G50 = 4, NCK_LAYOUT_G51 = 8,
    NCK_LAYOUT_G50_1 = 16, NCK_LAYOUT_G51_1 = 32, NCK_LAYOUT_G69 = 64, NCK_LAYOUT_G68 = 128,
    NCK_LAYOUT_HAS_AXES = NCK_LAYOUT_G51 | NCK_LAYOUT_G50_1 | NCK_LAYOUT_G51_1 | NCK_LAYOUT_G68
};

// Places are those of the program, from its zero [nm].
typedef NCK_LAYOUT_STATE nck_layout {
    uint32_t on;          // NCK_LAYOUT_…; 0: a coordinate is a place in the work system
    uint32_t mirrors;     // bit k: axis k is mirrored
    int64_t mirror_nm[3]; // where
    int64_t centre_nm[3]; // of scaling, mirrored
    double scale[3];      // 1: none; < 0 mirrors
    int64_t turn_nm[2];   // centre of the rotation in its plane, mirrored and scaled
    double cosine, sine;  // of its angle
    int64_t at_nm[3];     // what the program calls the place stands_nm
    int64_t stands_nm[3]; // machine position
    int64_t pole_nm[2];   // of polar coordinates, in the plane
    double radius, angle; // of them as last said [nm, deg]
} nck_layout_t;

#endif
