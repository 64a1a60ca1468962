// SPDX-License-Identifier: MIT
// Circles, helices and spirals about any axis of space, as points along them.
#ifndef ARC_H
#define ARC_H

#include <stdint.h> // int32_t

// From a start point about an axis through the centre; radius and height change evenly.
typedef struct arc {
    double centre[3]; // of the plane through the start [mm]
    double u[3];      // unit: from there to the start
    double v[3];      // unit: a quarter turn on
    double n[3];      // unit: the axis
    double radius[2]; // at start and end [mm]
    double height;    // along the axis, from start to end [mm]
    double angle;     // + anticlockwise about n [rad]
} arc_t;

// turn ≥ 0: anticlockwise, with so many whole turns more; turn < 0: clockwise, −1 − turn more.
// Where both ends are in one direction from the axis, it goes round once.
// Returns 1; 0 if normal or radius have no length. Cost: constant. Context: any.
int arc_make(const double *start, const double *end, const double *centre, const double *normal,
             int32_t turn, arc_t *arc_out);

// The point at a share, 0 … 1, of the way. Cost: constant. Context: any.
void arc_point(const arc_t *arc, double share, double *point_out);

// The share of the way where it is next to a point; of several turns the one that is nearest to the
// share `guess`. Cost: constant. Context: any.
double arc_share(const arc_t *arc, const double *point, double guess);

// From its end to its start. Cost: constant. Context: any.
void arc_reverse(arc_t *arc);

// Length of the way; exact where the radius stays. Cost: constant. Context: any.
double arc_length(const arc_t *arc);

// So many even chords stay within the error of the arc, from 1 [mm]. Cost: constant. Context: any.
uint32_t arc_chords(const arc_t *arc, double error);

// How far it gets along X, Y or Z, axis 0 … 2, to the side of 1 or −1 [mm]. Where radius or height
// change it may be off by an eighth of what they change by in a turn. Cost: constant. Context: any.
double arc_reach(const arc_t *arc, int axis, double side);

#endif
