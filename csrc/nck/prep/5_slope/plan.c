// SPDX-License-Identifier: MIT
// Inside room 5: pieces of path as every planner reads them.
#include "nck/prep/5_slope/plan.h"

#include "nck/base/real.h" // nck_min

nck_node_t *nck_plan_piece(const nck_pieces_t *pieces, uint32_t number) {
    if (number - pieces->head >= pieces->fill) return (nck_node_t *)0;
    return &pieces->at[number & (NCK_WINDOW - 1)];
}

uint32_t nck_plan_find(const nck_pieces_t *pieces, uint32_t number, const nck_cell_t *cell) {
    for (;;) {
        const nck_node_t *const piece = nck_plan_piece(pieces, number);
        const nck_node_t *const next = nck_plan_piece(pieces, number + 1);
        const int beyond = next && next->seg == cell->seg && cell->s >= next->s;
        if (!next || (piece->seg == cell->seg && !beyond)) return number;
        number++;
    }
}

double nck_plan_cap(const nck_node_t *piece, const nck_wish_t *wish, uint32_t over) {
    const double cap = over ? piece->vv_over : piece->vv_piece;
    if (!(piece->feed > 0.0)) return cap * wish->rapid * wish->rapid;
    const double v = piece->feed * wish->feed;
    return nck_min(cap, v * v);
}

int nck_plan_ends_block(const nck_link_t *link, const nck_pieces_t *pieces, uint32_t number) {
    const nck_node_t *const piece = nck_plan_piece(pieces, number);
    const nck_node_t *const next = nck_plan_piece(pieces, number + 1);
    return piece->last
           && nck_link_seg(link, piece->seg)->block != nck_link_seg(link, next->seg)->block;
}
