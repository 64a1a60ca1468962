// SPDX-License-Identifier: MIT
// Where a corner of two lines or arcs is cut off.
//
//            corner                  places are in mm from the corner, u and v along the plane's
//       -- a --+                     axes; a touch is where the piece that replaces the corner
//      touch[0] \| touch[1]          leaves the first edge, and where it meets the second one
//               b
#ifndef NCK_PREP_DECODE_MOTION_FILLET_H
#define NCK_PREP_DECODE_MOTION_FILLET_H

// A line or an arc that ends in the corner (edge 0) or begins there (edge 1).
typedef struct nck_edge {
    double way[2];    // the way along it at the corner, of length 1
    double centre[2]; // of an arc
    double radius;    // of an arc; 0: a line
    double turn;      // of an arc: +1 anticlockwise, −1 clockwise
    double length;    // of a line [mm]; of an arc its angle [rad]
} nck_edge_t;

// What comes in the corner's place.
typedef struct nck_cut {
    double touch[2][2]; // of edge 0 and 1
    double centre[2];   // of the fillet
    double turn;        // of the fillet: +1 anticlockwise, −1 clockwise
} nck_cut_t;

// The arc of a radius that goes on from edge 0 and into edge 1 without a bend, and the straight cut
// whose ends are `size` away from the corner. radius, size > 0. Returns 1, or 0: it does not fit
// between them, or they make no corner. Cost: constant. Context: any.
int nck_fillet(const nck_edge_t *edges, double radius, nck_cut_t *out);
int nck_chamfer(const nck_edge_t *edges, double size, nck_cut_t *out);

#endif
