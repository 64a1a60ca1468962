// SPDX-License-Identifier: MIT
// A block that comes without text: geometry from a planner, or a word for the machine.
#ifndef NCK_PREP_DECODE_STATE_BLOCK_IN_H
#define NCK_PREP_DECODE_STATE_BLOCK_IN_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX

// What a pushed block does, after it has set what it sets.
typedef enum nck_in_kind {
    NCK_IN_SET = 0,   // nothing more
    NCK_IN_RAPID = 1, // straight to the target, as fast as the axes allow
    NCK_IN_LINE = 2,  // straight to the target
    NCK_IN_ARC = 3,   // about the centre to the target; a helix if a third axis has one
    NCK_IN_DWELL = 4, // rests for `value` seconds, 0 … NCK_DECODE_DWELL_MAX_S
    NCK_IN_M = 5,     // M code `value`, as in text: M0 waits, M8 is handed over, M2 ends
    NCK_IN_S = 6,     // spindle speed `value` [rpm]
    NCK_IN_T = 7      // tool number `value`
} nck_in_kind_t;

// Bits of nck_block_in_t.sets.
enum {
    NCK_IN_SETS_FEED = 1, // feed_mode and feed
    NCK_IN_SETS_PATH = 2  // path_mode and tolerance
};

// Coordinates are the program's: they count from its zero (work system, G92 and tool length in
// force), are absolute, radii and not diameters, in mm and degrees. What a block sets stays in
// force for blocks and text behind it. All bits 0 is a block that does nothing.
typedef struct nck_block_in {
    uint32_t id;         // the caller's: comes back as `line` in pose, outputs and diagnostics
    uint8_t kind;        // nck_in_kind_t
    uint8_t sets;        // NCK_IN_SETS_…
    uint8_t feed_mode;   // nck_feed_mode_t; inverse time holds for one block
    uint8_t path_mode;   // nck_path_mode_t
    uint32_t axes;       // bit k: target[k] counts; the other axes stay
    int32_t turns;       // arc: how often the target is passed, + anticlockwise, − clockwise
    uint8_t plane;       // arc: 17, 18, 19
    uint8_t reserved[7]; // 0
    double target[NCK_AXIS_MAX]; // [mm, deg]
    double centre[2];    // arc: along the plane's axes (G17 XY, G18 ZX, G19 YZ) [mm]
    double feed;         // > 0, by feed_mode: [mm/min; deg/min if rotary axes move alone],
                         // [1/min] or [mm/rev]
    double tolerance;    // of NCK_PATH_CONTINUOUS, ≥ 0 [mm]
    double value;        // see nck_in_kind_t
} nck_block_in_t;

#endif
