// SPDX-License-Identifier: MIT
// Limits of the axes as the host has them now, and how much of them it leaves to a move.
#ifndef BOUNDS_H
#define BOUNDS_H

#include "moves.h" // MOVES_AXES move_t

// Shares are of the axes' limits, 0 … 1: less than 1 where the host asks a move for less than they
// have.
typedef struct bounds {
    double v[MOVES_AXES]; // [mm/s, deg/s]; 0: no such axis
    double a[MOVES_AXES]; // [mm/s², deg/s²]
    double j[MOVES_AXES]; // [mm/s³, deg/s³]; 0: none
    double a_path;        // of the tool along the path [mm/s²]; 0: as the axes can
    double a_share;       // of a, in all that follows
    double v_share;       // of v, in rapids
} bounds_t;

// What the host asks of one move at most, whatever the overrides; 0: what the axes can.
typedef struct bounds_most {
    double v; // [mm/s; deg/s if rotary axes move alone]
    double a; // [mm/s², deg/s²]
    double j; // [mm/s³, deg/s³]; 0: it says nothing of jerk
} bounds_most_t;

// Length of a straight move, as its feed is told along it [mm, deg]. Cost: constant. Context: any.
double bounds_length(const move_t *move);

// What limits of the axes leave to the tool on a move, as LinuxCNC's interpreter reckons: along a
// line's direction, on an arc the least of X Y Z. Cost: constant. Context: any.
double bounds_along(const double *limit, const move_t *move);

// The shares that a move is to have; they come in as the last move's. A change costs a rest, so
// what follows may have less than it is asked for, half of it at least. Cost: constant. Context:
// any.
void bounds_share(bounds_t *bounds, const bounds_most_t *most, const move_t *move);

// The jerk of the axes, as far as a move tells of it: what it may have is what they leave to its
// direction. More than was known: each of its axes has its part at least. Less: the share holds for
// all of its axes, until a move along one of them tells more. Cost: constant. Context: any.
void bounds_jerk(bounds_t *bounds, const bounds_most_t *most, const move_t *move);

// The speed that a feed move is not to exceed at any override [mm/s, deg/s]; 0: the axes' limits
// see to it. Cost: constant. Context: any.
double bounds_cap(const bounds_t *bounds, const bounds_most_t *most, const move_t *move);

// 1 if both are the same. Cost: constant. Context: any.
int bounds_same(const bounds_t *one, const bounds_t *other);

#endif
