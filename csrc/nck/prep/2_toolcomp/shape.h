// SPDX-License-Identifier: MIT
// Inside room 2: lines and arcs in a plane, and how they meet. Lengths in mm.
#ifndef NCK_PREP_SHAPE_H
#define NCK_PREP_SHAPE_H

// A line or an arc. Filled by nck_shape_line and nck_shape_arc.
typedef struct nck_shape {
    double p[2];   // where it begins
    double q[2];   // where it ends
    double c[2];   // arc: its centre
    double radius; // arc; of a line 0
    double sweep;  // arc: signed angle, + from the plane's first axis to its second; of a line 0
    double length;
} nck_shape_t;

// A place that two shapes have in common: how far along either it is.
typedef struct nck_meeting {
    double on_a;
    double on_b;
} nck_meeting_t;

// Where two shapes are nearest to each other.
typedef struct nck_approach {
    double gap;  // between them there
    double on_a; // how far along either it is
    double on_b;
} nck_approach_t;

// The line from p to q. Cost: constant.
void nck_shape_line(const double *p, const double *q, nck_shape_t *out);

// The arc about c from p, over a signed angle, to q. Cost: constant.
void nck_shape_arc(const double *p, const double *q, const double *c, double sweep,
                   nck_shape_t *out);

// 1: an arc turns from the plane's first axis to its second, −1: the other way. Cost: constant.
double nck_shape_turn(const nck_shape_t *self);

// The point, and the direction of length 1, so far along. Cost: constant.
void nck_shape_point(const nck_shape_t *self, double along, double *out);
void nck_shape_tangent(const nck_shape_t *self, double along, double *out);

// How far a point is from the nearest one of the shape. Cost: constant.
double nck_shape_distance(const nck_shape_t *self, const double *point);

// How far along is a point of the shape? Cost: constant.
double nck_shape_along(const nck_shape_t *self, const double *point);

// The part of a shape between two places. Cost: constant.
void nck_shape_part(const nck_shape_t *self, double from, double to, nck_shape_t *out);

// The shape parallel to it, at a distance to its left (negative: right). Returns 0 if there is
// none: an arc that is not larger than that. Cost: constant.
int nck_shape_parallel(const nck_shape_t *self, double left, nck_shape_t *out);

// Where two shapes cross: 0 … 2 places. Of an arc of more than a turn: a's last turn, b's first.
// Parallel and touching shapes do not cross. Cost: constant.
unsigned nck_shape_cross(const nck_shape_t *a, const nck_shape_t *b, nck_meeting_t *out);

// 1 if the shapes, by circles about them, are further apart than a distance for certain. Cost:
// constant.
int nck_shape_are_far(const nck_shape_t *a, const nck_shape_t *b, double distance);

// Where two shapes are nearest to each other. Cost: constant.
void nck_shape_approach(const nck_shape_t *a, const nck_shape_t *b, nck_approach_t *out);

#endif
