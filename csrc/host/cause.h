// SPDX-License-Identifier: MIT
// What the path loses time to, like ones together: fixed memory, however long the program.
#ifndef NCK_HOST_CAUSE_H
#define NCK_HOST_CAUSE_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX
#include "nck/base/records.h" // NCK_LIMIT_AXIS_V

#ifdef __cplusplus
extern "C" {
#endif

// How much is told apart, and kept.
enum {
    NCK_HOST_ANGLES = 12,       // classes of corner angles
    NCK_HOST_PLACES = 8,        // the worst ones of a cause
    NCK_HOST_LINE_GAP = 20,     // lines between two low points of one place at most
    // Every limit, every class of corners, and the two ends of the program.
    NCK_HOST_CAUSES = NCK_LIMIT_AXIS_V + NCK_AXIS_MAX + NCK_HOST_ANGLES + 1
};

// A sum that keeps what rounding would lose: sum + rest.
typedef struct nck_host_sum {
    double sum, rest;
} nck_host_sum_t;

// Add to a sum. Cost: constant. Context: any.
void nck_host_cause_sum(nck_host_sum_t *self, double value);

// Lines one behind the other that lose time to the same cause.
typedef struct nck_host_place {
    uint32_t line_first, line_last; // source lines
    uint32_t line_worst;        // with the low point that loses most
    uint32_t axis;              // that holds it there; NCK_AXIS_MAX: no single one
    uint32_t count;             // low points
    uint32_t reserved;
    double angle;               // of the corner there [rad]
    double worst_s;             // lost there
    double lost_s;              // lost at all of them
} nck_host_place_t;

// All low points of one cause.
typedef struct nck_host_cause {
    uint32_t limit;             // nck_limit_t
    uint32_t ends;              // 1: start and end of the program
    uint32_t count;             // low points
    uint32_t seg;               // of the last one: its seg counts once
    double angle_least, angle_most; // of the corners [rad]
    nck_host_sum_t lost_s;      // over the programmed feed
    double axis_s[NCK_AXIS_MAX + 1]; // of it by the axis that holds; the last: no single one
    nck_host_place_t open;      // place in work; count 0: none
    uint32_t place_count;
    uint32_t reserved;
    nck_host_place_t places[NCK_HOST_PLACES]; // the worst ones, worst first
} nck_host_cause_t;

// A point where the path is slow, and what for.
typedef struct nck_host_low {
    uint32_t limit;             // nck_limit_t
    uint32_t ends;              // 1: start or end of the program
    uint32_t seg;               // that it belongs to
    uint32_t line;
    uint32_t axis;              // NCK_AXIS_MAX: no single one
    uint32_t reserved;
    double angle;               // of a corner [rad]; 0: none
    double lost_s;              // by its ramps
} nck_host_low_t;

// Add a low point to the cause that it belongs to: of causes[NCK_HOST_CAUSES], 0 at first.
// What loses less than a microsecond adds its time and is not counted as a place.
// Cost: constant. Context: any.
void nck_host_cause_add(nck_host_cause_t *causes, const nck_host_low_t *low);

// Nothing more comes: places in work are done. Cost: constant. Context: any.
void nck_host_cause_end(nck_host_cause_t *causes);

#ifdef __cplusplus
}
#endif

#endif
