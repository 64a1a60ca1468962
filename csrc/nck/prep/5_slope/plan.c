// SPDX-License-Identifier: MIT
// Inside room 5: pieces of path as every planner reads them.
#include "nck/prep/5_slope/plan.h"

#include "nck/base/real.h" // nck_min

enum { SEGS_LEAST = 2 }; // that a look-ahead of several blocks sees

uint32_t nck_plan_find(const nck_pieces_t *pieces, uint32_t number, const nck_cell_t *cell) {
    const uint32_t last = pieces->head + pieces->fill - 1;
    // Every seg has a piece at least.
    const uint32_t segs = cell->seg - nck_plan_there(pieces, number)->seg;
    if ((int32_t)segs > 0 && (int32_t)(last - number - segs) >= 0) number += segs;
    nck_node_t *piece = nck_plan_there(pieces, number);
    for (; (int32_t)(last - number) > 0; number++) {
        nck_node_t *const next = nck_plan_behind(pieces, piece);
        const int is_it = piece->seg == cell->seg;
        if (is_it && (next->seg != cell->seg || !(cell->s >= next->s))) break;
        piece = next;
    }
    return number;
}

int nck_plan_is_other(const nck_wish_t *a, const nck_wish_t *b) {
    const uint32_t words = (a->hold ^ b->hold) | (a->single_block ^ b->single_block);
    return words != 0 || a->feed != b->feed || a->rapid != b->rapid || a->tool != b->tool;
}

int nck_plan_is_good(const nck_wish_t *wish) {
    return wish->feed >= 0.0 && wish->feed <= NCK_OVERRIDE_TOP && wish->rapid >= 0.0
           && wish->rapid <= 1.0 && wish->tool >= 0.0;
}

int nck_plan_is_plain(const nck_wish_t *wish, uint32_t over) {
    return wish->feed == 1.0 && wish->rapid == 1.0 && wish->tool == NCK_WISH_FREE && !over;
}

double nck_plan_at(const nck_pieces_t *pieces, uint32_t number, const nck_wish_t *wish,
                   uint32_t over) {
    const nck_node_t *const piece = nck_plan_piece(pieces, number);
    const double junction = over ? piece->vv_node : piece->vv_cap;
    const nck_node_t *const before = nck_plan_piece(pieces, number - 1);
    const double cap = nck_min(junction, nck_plan_cap(piece, wish, over));
    return before ? nck_min(cap, nck_plan_cap(before, wish, over)) : cap;
}

int nck_plan_ends_block(const nck_link_t *link, const nck_pieces_t *pieces, uint32_t number) {
    const nck_node_t *const piece = nck_plan_piece(pieces, number);
    const nck_node_t *const next = nck_plan_piece(pieces, number + 1);
    return piece->last
           && nck_link_seg(link, piece->seg)->block != nck_link_seg(link, next->seg)->block;
}

int nck_plan_is_beyond(const nck_link_t *link, const nck_node_t *first, const nck_node_t *piece,
                       uint32_t blocks) {
    const uint32_t segs = piece->seg - first->seg;
    if (segs < blocks && segs < SEGS_LEAST) return 0;
    return nck_link_seg(link, piece->seg)->block - nck_link_seg(link, first->seg)->block >= blocks;
}
