// SPDX-License-Identifier: MIT
// Inside room 5: what corners and bends leave to the linear slope's brake.
#include "nck/prep/5_slope/linear_left.h"

#include "nck/base/real.h" // nck_min nck_sqrt

enum { NEIGHBOURS = 8 }; // on a side; where a period passes more of them, nothing is known

// The smallest cap of the pieces within a distance of a piece on one side, and of itself; 0 if it
// is not known so far.
static double least_cap(const nck_pieces_t *pieces, uint32_t number, double distance, int step,
                        uint32_t over) {
    const nck_node_t *piece = nck_plan_there(pieces, number);
    double least = nck_plan_limits_at(piece, over);
    double left = distance;
    for (int n = 0; n < NEIGHBOURS; n++) {
        if (step > 0 && piece->stop) return least;
        number += (uint32_t)step;
        piece = nck_plan_piece(pieces, number);
        if (!piece) return 0.0;
        if (!(piece->length > 0.0) || (step < 0 && piece->stop)) return least;
        least = nck_min(least, nck_plan_limits_at(piece, over));
        left -= piece->length;
        if (!(left > 0.0)) return least;
    }
    return 0.0;
}

// With v_c, the smallest cap within a period of path, and a_c, what is left there, every corner
// within that period is passed at v_r = v + a_0 T at most, where a_0 is what is left at standstill.
// What it asks for,  Σ d_i·(v_r − x_i/T)  over all with x_i < v_r T,  is convex in v_r and 0 at
// standstill; so is what an arc's or a spline's bends ask for. So
//   a ≥ a_0 + (a_c − a_0)·r,   r = v_r/v_c < 1.
double nck_linear_left(const nck_pieces_t *pieces, uint32_t number, double vv, uint32_t over,
                       double period) {
    const nck_node_t *const piece = nck_plan_there(pieces, number);
    const double a = over ? piece->a_over : piece->a;
    const double a_rest = (double)piece->standstill.left.a;
    if (!(a_rest > a)) return a;
    const double v = nck_sqrt(vv) + a_rest * period;
    const double ahead = least_cap(pieces, number, v * period, 1, over);
    const double cap = nck_min(ahead, least_cap(pieces, number, v * period, -1, over));
    if (!(v * v < cap)) return a;
    return a_rest + (a - a_rest) * v / nck_sqrt(cap);
}
