// SPDX-License-Identifier: MIT
// One piece of path under the classical S-shape: acceleration is zero at both of its ends. How fast
// it may be entered and left, how fast it gets in between, and its cells of constant jerk. 
//
//     v     ______         rise: jerk up, acceleration constant, jerk down
//          /      \        cruise
//     ____/        \____   fall: the same downwards
//     v_in          v_out
#ifndef NCK_HOST_SSHAPE_PIECE_H
#define NCK_HOST_SSHAPE_PIECE_H

#include <stdint.h> // uint32_t

#include "nck/base/records.h" // nck_cell_t

enum { NCK_SSHAPE_CELLS = 7 }; // of a piece at most: three up, cruise, three down

// A part of a piece shorter than this share of it is rounding.
#define NCK_SSHAPE_EPSILON 1e-12

// What the ramps of a piece go by.
typedef struct nck_sshape_piece {
    double length; // [mm], positive
    double v_cap;  // [mm/s], positive
    double a;      // [mm/s²], positive
    double j;      // [mm/s³], positive
} nck_sshape_piece_t;

// How a piece is passed.
typedef struct nck_sshape_course {
    double peak;    // speed reached [mm/s]
    double v_out;   // at its end [mm/s]
    double cruise;  // length at the peak [mm]; 0: none
    double stretch; // of the ramps' times: 1 but for rounding
} nck_sshape_course_t;

// Cells under construction: where the next one begins.
typedef struct nck_sshape_pen {
    nck_cell_t *cells; // room for what is drawn
    uint32_t count;    // drawn so far
    uint32_t seg;      // of the cells
    double s;          // path coordinate [mm]
    double v;          // speed [mm/s]
} nck_sshape_pen_t;

// The largest speed at the start from which some speed in [0, v_out] is met at the end. Speeds up
// to it are good, too. Cost: bounded (two of Newton's methods). Context: any.
double nck_sshape_brakeable(const nck_sshape_piece_t *piece, double v_out);

// The largest speed at the end, v_most at most, that a piece entered at v reaches; v is brakeable
// for v_most. Cost: bounded (60 halvings). Context: any.
double nck_sshape_fastest_end(const nck_sshape_piece_t *piece, double v, double v_most);

// The least speed at the end, v_most at most, that braking from v > 0 on gets to; v is brakeable
// for v_most. Cost: bounded (60 halvings). Context: any.
double nck_sshape_slowest_end(const nck_sshape_piece_t *piece, double v, double v_most);

// The fastest way from v_in to v_out. Cost: bounded (60 halvings). Context: any.
void nck_sshape_plan(const nck_sshape_piece_t *piece, double v_in, double v_out,
                     nck_sshape_course_t *course_out);

// A cell of constant jerk from where the pen stands; none if the duration is not positive.
// Cost: constant. Context: any.
void nck_sshape_draw(nck_sshape_pen_t *pen, double duration, double a, double j);

// An S from the pen's speed to v: jerk j for `rise`, then none for `hold`, then −j for `rise`.
// Cost: constant. Context: any.
void nck_sshape_draw_s(nck_sshape_pen_t *pen, double v, double rise, double hold, double j);

// The ramp from the pen's speed to v within the piece's limits, its time stretched by a factor.
// Cost: constant. Context: any.
void nck_sshape_draw_ramp(nck_sshape_pen_t *pen, const nck_sshape_piece_t *piece, double v,
                          double stretch);

#endif
