// SPDX-License-Identifier: MIT
// The modes that are in force, packed into one word, which goes with a block, its seg and its mark
// to the tool.
#ifndef NCK_BASE_IN_FORCE_H
#define NCK_BASE_IN_FORCE_H

// Where each stands in the word, lowest bit first; nck_modal_t says what it means. 0 is no such
// word: NCK_FORCE_KNOWN is set in each.
typedef enum nck_force {
    NCK_FORCE_MOTION = 0,       // ten bits, in tenths; from 1000 on: none
    NCK_FORCE_PLANE = 10,       // two: less 17
    NCK_FORCE_FEED_MODE = 12,   // two
    NCK_FORCE_PATH_MODE = 14,   // two
    NCK_FORCE_SPINDLE_CODE = 16, // three
    NCK_FORCE_COOLANT = 19,     // two
    NCK_FORCE_SYSTEM = 21,      // four
    NCK_FORCE_INCH = 25,
    NCK_FORCE_DIAMETER = 26,
    NCK_FORCE_INCREMENTAL = 27,
    NCK_FORCE_SPINDLE_ON = 28,
    NCK_FORCE_KNOWN = 31
} nck_force_t;

// The motion's bits, and from which number on it is none.
enum { NCK_FORCE_MOTION_MASK = 0x3ff, NCK_FORCE_NO_MOTION = 1000 };

#endif
