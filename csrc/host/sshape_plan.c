// SPDX-License-Identifier: MIT
// The classical S-shape over the pieces of a whole program.
#include "host/sshape_plan.h"

#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_cbrt

enum { HOP_NODES = 3 }; // of a hop at most: head, middle, tail of a seg

// A hop keeps to the least jerk of its pieces: a zone that has less than this share of its middle's
// is a hop of its own.
#define HOP_JERK 0.6
// nck_ladder_cbrt is good to 1 %.
#define CBRT_ROOM 1.02

static int moves(const nck_node_t *node) { return node->length > 0.0; }

// Within the distance z of a place without acceleration the S-shape's is at most (6·z·j²)^(1/3):
// that is where it gets from rest, x = j·t³/6 and a = j·t. So v² changes by 2·a·z at most there.
static double gain_in(const nck_node_t *zone, double j) {
    const double a = CBRT_ROOM * nck_ladder_cbrt(6.0 * zone->length * j * j);
    return 2.0 * nck_min(a, zone->a) * zone->length;
}

// Whether a zone next to a junction may share a hop with the middle of its seg: its limit of
// acceleration must be out of reach there, and its cap be kept by one at the junction.
static int joins(const nck_node_t *zone, const nck_node_t *middle) {
    const double j = nck_min(zone->j, middle->j);
    const int slow = zone->a >= middle->a
                     || zone->a * zone->a * zone->a >= 6.0 * zone->length * j * j;
    const int open = zone->vv_piece >= middle->vv_piece;
    const int brisk = zone->j >= HOP_JERK * middle->j;
    return brisk && slow && (open || 0.5 * zone->vv_piece >= gain_in(zone, j));
}

// Nodes of the hop that begins with this one. The middle of a seg is longer than its zones; of two
// parts of a length the second is taken for it.
static uint32_t nodes_of_hop(const nck_node_t *first, size_t left) {
    if (first->last || left < 2) return 1;
    if (first[0].length > first[1].length) return joins(&first[1], &first[0]) ? 2 : 1;
    if (!joins(&first[0], &first[1])) return 1;
    if (first[1].last || left < HOP_NODES) return 2;
    const int goes_on = first[2].length <= first[1].length && joins(&first[2], &first[1]);
    return goes_on ? HOP_NODES : 2;
}

// The speed at the junction next to a zone that keeps its cap throughout.
static double v_beside(const nck_node_t *zone, double vv, double j) {
    if (zone->vv_piece >= vv) return nck_sqrt(vv);
    return nck_sqrt(nck_max(0.0, zone->vv_piece - gain_in(zone, j)));
}

// The hop of the nodes from `first` on, and its caps of speed at both ends.
static void add_hop(nck_host_sshape_t *self, const nck_node_t *first, uint32_t count) {
    const size_t k = self->hop_count;
    const nck_node_t *const end = first + (count - 1);
    const int begins_low = count > 1 && first[0].length <= first[1].length;
    const nck_node_t *const middle = begins_low ? &first[1] : first;
    nck_host_hop_t *const hop = &self->hops[k];
    double j = middle->j;
    for (uint32_t i = 0; i < count; i++) j = nck_min(j, first[i].j);
    memset(hop, 0, sizeof *hop);
    hop->seg = first->seg;
    hop->count = count;
    hop->s = first->s;
    hop->last = end->last;
    hop->limit = middle->limit_piece;
    self->length[k] = end->s + end->length - first->s;
    self->v_cap[k] = nck_sqrt(middle->vv_piece);
    self->a_max[k] = middle->a;
    self->j_max[k] = j;
    const double v_in = nck_min(nck_sqrt(first->vv_cap), v_beside(first, middle->vv_piece, j));
    self->v_node[k] = nck_min(self->v_node[k], v_in);
    self->v_node[k + 1] = end->stop ? 0.0 : v_beside(end, middle->vv_piece, j);
    self->hop_count++;
}

// Blocks that have hops are numbered one after the other.
static void number_block(const nck_host_sshape_t *self, size_t k) {
    const nck_seg_t *const segs = self->segs;
    const uint32_t here = segs[self->hops[k].seg - segs->seq].block;
    self->block[k] = 0;
    if (k == 0) return;
    const uint32_t before = segs[self->hops[k - 1].seg - segs->seq].block;
    self->block[k] = self->block[k - 1] + (here != before);
}

static nck_host_path_t path_of(const nck_host_sshape_t *self) {
    const nck_host_path_t path = {
        self->length, self->v_cap, self->a_max, self->j_max, self->v_node, self->hop_count,
        self->lookahead, NCK_HOST_RAMP_SSHAPE, 0.0, self->block};
    return path;
}

nck_status_t nck_host_sshape_plan(nck_host_sshape_t *self) {
    size_t i = 0;
    self->hop_count = 0;
    self->v_node[0] = 0.0;
    while (i < self->node_count) {
        const nck_node_t *const node = &self->nodes[i];
        if (!moves(node)) {
            self->v_node[self->hop_count] = 0.0;
            i++;
            continue;
        }
        const uint32_t count = nodes_of_hop(node, self->node_count - i);
        add_hop(self, node, count);
        number_block(self, self->hop_count - 1);
        i += count;
    }
    self->v_node[self->hop_count] = 0.0;
    if (self->hop_count == 0) return NCK_OK;
    const nck_host_path_t path = path_of(self);
    return nck_host_slope_speeds(&path, self->v, &self->bad);
}

// A dwell or a wait.
static void make_rest(nck_host_sshape_walk_t *walk, const nck_node_t *node) {
    nck_cell_t *const cell = walk->cells;
    memset(cell, 0, sizeof *cell);
    cell->seg = node->seg;
    cell->s = node->s;
    cell->duration = node->standstill.dwell_s;
    cell->limit = node->limit_piece;
    cell->last = 1;
    cell->stop = NCK_STOP_REST;
    walk->count = 1;
    walk->node++;
}

static void make_hop(nck_host_sshape_walk_t *walk) {
    const nck_host_sshape_t *const self = walk->plan;
    const nck_host_hop_t *const hop = &self->hops[walk->hop];
    const nck_host_path_t path = path_of(self);
    nck_host_slope_cells(&path, self->v, walk->hop, walk->hop + 1, walk->cells, &walk->count);
    for (size_t i = 0; i < walk->count; i++) {
        nck_cell_t *const cell = &walk->cells[i];
        cell->seg = hop->seg;
        cell->s += hop->s;
        if (cell->a == 0.0 && cell->j == 0.0) cell->limit = hop->limit;
    }
    walk->cells[walk->count - 1].last = hop->last;
    walk->node += hop->count;
    walk->hop++;
}

int nck_host_sshape_next(void *user, nck_cell_t *cell_out) {
    nck_host_sshape_walk_t *const walk = user;
    const nck_host_sshape_t *const self = walk->plan;
    if (walk->at == walk->count) {
        if (walk->node == self->node_count) return 0;
        walk->at = 0;
        if (moves(&self->nodes[walk->node])) make_hop(walk);
        else make_rest(walk, &self->nodes[walk->node]);
    }
    *cell_out = walk->cells[walk->at];
    walk->at++;
    return 1;
}
