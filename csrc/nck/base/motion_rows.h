// SPDX-License-Identifier: MIT
// Inside of motion.c: the rows of a chunk of nodes, lane by lane.
#ifndef NCK_BASE_MOTION_ROWS_H
#define NCK_BASE_MOTION_ROWS_H

#include "nck/base/motion.h" // nck_motion_t

#ifdef __cplusplus
extern "C" {
#endif

// The motion about a place, or a step of it: what every row is made of. Linear in b.
typedef struct nck_motion_shape {
    nck_motion_lanes_t bend[2]; // α on either side of the place
    nck_motion_lanes_t slope;   // β
    nck_motion_lanes_t level;   // γ
} nck_motion_shape_t;

// A chunk's nodes, or the middles of the cells behind them.
typedef struct nck_motion_place {
    int kind;                          // 0: node, 1: middle
    nck_motion_shape_t b;              // of the motion
    nck_motion_lanes_t root;    // √γ
    nck_motion_lanes_t tangent; // 1/(2γ): by how much more √γ a row gets where γ falls
    nck_num on[NCK_MOTION_BATCH];      // 1: the row is there, 0: it is not
} nck_motion_place_t;

// The path of one axis at a place.
typedef struct nck_motion_path {
    nck_motion_lanes_t p1;       // p′/(2τA)
    nck_motion_lanes_t p2;       // p″/A
    nck_motion_lanes_t turn[2];  // δ = τp‴/A on either side
} nck_motion_path_t;

// What the rows of a place add to the Newton system, over bends, slope and level.
typedef struct nck_motion_system {
    nck_motion_lanes_t bend_bend[2], bend_slope[2];
    nck_motion_lanes_t bend_level[2];
    nck_motion_lanes_t slope_slope, slope_level;
    nck_motion_lanes_t level_level;
    nck_motion_shape_t force; // gradient
} nck_motion_system_t;

// Make the place of a chunk. kind as in nck_motion_place_t.
void nck_motion_place(const nck_motion_t *self, int chunk, int kind, nck_motion_place_t *place_out);

// The shape of a line about a chunk's places.
void nck_motion_shape(const nck_num *line, int kind, nck_motion_shape_t *shape_out);

// The path of an axis, or NCK_MOTION_ALONG, at the place of a chunk.
void nck_motion_path(const nck_motion_t *self, int chunk, int axis, int kind,
                     nck_motion_path_t *path_out);

// Add what the rows of a place tell to the lines of the Newton system.
void nck_motion_scatter(nck_motion_t *self, int chunk, int kind, const nck_motion_system_t *system);

// First multipliers of a chunk's rows.
void nck_motion_seed(nck_motion_t *self, int chunk);

// Add a chunk's rows to the Newton system.
void nck_motion_assemble(nck_motion_t *self, int chunk);

// Find the most that is taken of a limit in a chunk, between its places, too.
void nck_motion_check(nck_motion_t *self, int chunk);

// Give a chunk's rows their next multipliers, and find how far the step may go.
void nck_motion_direct(nck_motion_t *self, int chunk);

// Whether a node's cap may be broken at a price.
int nck_motion_is_soft(const nck_motion_t *self, int k);

// What the start has to pay for being beyond caps.
nck_num nck_motion_price_of_start(const nck_motion_t *self);

// The same of the caps of nodes first … first + NCK_MOTION_LANES − 1.
void nck_motion_seed_caps(nck_motion_t *self, int first);
void nck_motion_assemble_caps(nck_motion_t *self, int first);
void nck_motion_direct_caps(nck_motion_t *self, int first);

#ifdef __cplusplus
}
#endif

#endif
