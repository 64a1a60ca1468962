// SPDX-License-Identifier: MIT
// Room 5, slope: hops of pieces.
#include "nck/prep/5_slope/sshape_hop.h"

#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_cbrt

// A hop keeps to the least jerk of its pieces: a zone that has less than this share of its middle's
// is a hop of its own.
#define HOP_JERK 0.6
// nck_ladder_cbrt is good to 1 %.
#define CBRT_ROOM 1.02

// A piece under the wishes.
typedef struct zone {
    double length;
    double w; // cap, v²
    double a;
    double j;
} zone_t;

static zone_t zone_of(const nck_sshape_view_t *view, const nck_node_t *piece) {
    const zone_t zone = {piece->length, nck_plan_inside(piece, view->wish, view->over),
                         view->over ? piece->a_over : piece->a,
                         view->over ? piece->j_over : piece->j};
    return zone;
}

// Within the distance z of a place without acceleration the S-shape's is at most (6·z·j²)^(1/3):
// that is where it gets from rest, x = j·t³/6 and a = j·t. So v² changes by 2·a·z at most there.
static double gain_in(const zone_t *zone, double j) {
    const double a = CBRT_ROOM * nck_ladder_cbrt(6.0 * zone->length * j * j);
    return 2.0 * nck_min(a, zone->a) * zone->length;
}

// Whether a zone next to a junction may share a hop with the middle of its seg: its limit of
// acceleration must be out of reach there, and its cap be kept by one at the junction.
static int joins(const nck_sshape_view_t *view, const nck_node_t *piece, const nck_node_t *behind) {
    const zone_t zone = zone_of(view, piece);
    const zone_t middle = zone_of(view, behind);
    const double j = nck_min(zone.j, middle.j);
    const int slow = zone.a >= middle.a || zone.a * zone.a * zone.a >= 6.0 * zone.length * j * j;
    const int open = zone.w >= middle.w;
    const int brisk = zone.j >= HOP_JERK * middle.j;
    return brisk && slow && (open || 0.5 * zone.w >= gain_in(&zone, j));
}

// The speed at the junction next to a zone that keeps its cap throughout.
static double v_beside(const nck_sshape_view_t *view, const nck_node_t *piece, double w, double j) {
    const zone_t zone = zone_of(view, piece);
    return nck_sqrt(zone.w >= w ? w : nck_max(0.0, zone.w - gain_in(&zone, j)));
}

// The middle of a seg is longer than its zones; of two parts of a length the second is taken for
// it.
uint32_t nck_sshape_hop_pieces(const nck_sshape_view_t *view, uint32_t first) {
    const nck_node_t *const head = nck_plan_piece(view->pieces, first);
    if (!head) return 0;
    if (head->last) return 1;
    const nck_node_t *const second = nck_plan_piece(view->pieces, first + 1);
    if (!second) return 0;
    if (head->length > second->length) return joins(view, second, head) ? 2 : 1;
    if (!joins(view, head, second)) return 1;
    if (second->last) return 2;
    const nck_node_t *const third = nck_plan_piece(view->pieces, first + 2);
    if (!third) return 0;
    return third->length <= second->length && joins(view, third, second) ? NCK_SSHAPE_HOP : 2;
}

// The middle of a hop, the one that the others are joined to.
static const nck_node_t *middle_of(const nck_pieces_t *pieces, uint32_t first, uint32_t count) {
    const nck_node_t *const head = nck_plan_piece(pieces, first);
    if (count == 1) return head;
    const nck_node_t *const second = nck_plan_piece(pieces, first + 1);
    return head->length > second->length ? head : second;
}

void nck_sshape_hop_of(const nck_sshape_view_t *view, uint32_t first, uint32_t count,
                       nck_sshape_hop_t *hop_out) {
    const nck_node_t *const head = nck_plan_piece(view->pieces, first);
    const nck_node_t *const end = nck_plan_piece(view->pieces, first + count - 1);
    const nck_node_t *const middle = middle_of(view->pieces, first, count);
    const zone_t limits = zone_of(view, middle);
    double j = limits.j;
    for (uint32_t i = 0; i < count; i++) {
        j = nck_min(j, zone_of(view, nck_plan_piece(view->pieces, first + i)).j);
    }
    memset(hop_out, 0, sizeof *hop_out);
    hop_out->first = first;
    hop_out->count = count;
    hop_out->seg = head->seg;
    hop_out->s_end = end->s + end->length;
    hop_out->piece.v_cap = nck_sqrt(limits.w);
    hop_out->piece.a = limits.a;
    hop_out->piece.j = j;
    hop_out->v_in = v_beside(view, head, limits.w, j);
    hop_out->v_out = v_beside(view, end, limits.w, j);
    hop_out->last = end->last;
    hop_out->stops = end->stop || !(end->length > 0.0);
    hop_out->limit = limits.w < middle->vv_piece ? (uint8_t)NCK_LIMIT_FEED : middle->limit_piece;
    nck_sshape_hop_from(hop_out, head->s);
}

void nck_sshape_hop_from(nck_sshape_hop_t *hop, double s) {
    hop->s = s;
    hop->piece.length = hop->s_end - s;
}
