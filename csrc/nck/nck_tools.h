// SPDX-License-Identifier: MIT
// libnck, what hosts and tests open beside nck.h: cells without a tick, path in pieces, a text
// entered in its middle, what is asked for, the link, invariants. A firmware needs none of it.
#ifndef NCK_TOOLS_H
#define NCK_TOOLS_H

#ifdef __cplusplus
extern "C" {
#endif

#include "nck/nck_memory.h" // nck_t

// Take the next final cell in place of the tick: for planning without executing (machining time,
// pictures). Outputs are handed over as in the tick. Returns NCK_OK or NCK_EMPTY. Cost: constant.
// Context: tick.
nck_status_t nck_take(nck_t *nck, nck_cell_t *cell_out);

// Nothing more is there to push for now, and more may come: a plan that begins at rest, or takes
// over within so many periods, takes what is known of the path. By itself nck_prep does so two
// periods ahead, which is soon enough where it is called as long as it says NCK_OK; a caller with a
// budget names the periods that a plan takes to be made, 1 at least. Speeds that hang on pieces not
// known yet are settled without them. Behind NCK_EMPTY.
// Cost: linear in periods. Context: prep.
void nck_hurry(nck_t *nck, uint32_t periods);

// How long the path lasts, by its clock and to where it is known, that a plan from rest waits for
// more of [s]; 0: none does, or the path has no clock. v: how fast it goes there [mm/s]. A caller
// with a budget hurries if that lasts longer than a brake and what comes next is in the making.
// Cost: constant. Context: prep.
double nck_known_s(const nck_t *nck, double *v_out);

// Read a text from its middle on, right after nck_init with the machine standing there: rooms 1 and
// 2 as they were elsewhere behind so many blocks of the same text, which is at `text` here.
// Cost: constant. Context: prep, before the tick runs.
void nck_enter(nck_t *nck, const nck_decode_t *decode, const nck_toolcomp_t *toolcomp,
               uint32_t blocks, const char *text);

// The program ends once so many blocks have been taken, the ones before nck_enter counted: call it
// behind every prep step. Cost: constant. Context: prep.
void nck_leave_at(nck_t *nck, uint32_t blocks);

// Hand over a piece of path in the place of text, with its caps as room 4 of another kernel for the
// same machine has found them: rooms 1 to 4 of this one stay empty. Its seg is in the link by then,
// the outputs before that too. Behind each piece, or the few that became known together, nck_prep
// goes on until it says NCK_EMPTY, unless nck_lacks_pieces.
// Returns NCK_OK; NCK_FULL if nothing more fits before the tick has taken cells; NCK_E_STATE once
// the path has ended, be it because rings full of outputs had it rest where it was known to.
// Cost: constant. Context: prep.
nck_status_t nck_push_piece(nck_t *nck, const nck_node_t *piece);

// 1 if nck_prep would do nothing, since the path needs more pieces than are known. While the
// operator asks for nothing else, more may be handed over at once. Cost: constant. Context: prep.
int nck_lacks_pieces(nck_t *nck);

// The path that was handed over in pieces ends here; blocks: that it was made of.
// Returns NCK_OK, or NCK_E_STATE as nck_push_piece. Cost: constant. Context: prep.
nck_status_t nck_end_pieces(nck_t *nck, uint32_t blocks);

// The i-th of the pieces of path that are placed and that on_node has not told yet; its caps are
// final, its envelope may not be. NULL: not known yet. Cost: constant. Context: prep.
const nck_node_t *nck_piece(const nck_t *nck, uint32_t i);

// What the next nck_prep takes at most, or little more, in hundreds of instructions of a PC, up to
// three axes: for who has so many in a period. Cost: constant. Context: prep.
uint32_t nck_price(nck_t *nck);

// The same of the next nck_tick. Cost: constant. Context: any.
uint32_t nck_tick_price(nck_t *nck);

// 1 while a plan is made that answers the operator: who asks for something else now, and again and
// again, has it begin anew each time. Cost: constant. Context: prep.
int nck_is_answering(const nck_t *nck);

// Have the slope hear in its next step what the operator asks for, and 1 that soft limits stop the
// path; but for what has to wait for the tick's clock. Cost: constant. Context: prep.
void nck_hear(nck_t *nck, uint32_t stopped);

// Every invariant of the kernel, for tests: 0 if all hold, else a bit (1 << k) for each room k that
// one of them is broken in; bit 0 is the link's. Cost: linear in the capacities. Context: prep,
// while the tick is not within a call.
uint32_t nck_invariants(const nck_t *nck);

// The link, for a planner that fills it in nck_prep's place. Cost: constant. Context: any.
nck_link_t *nck_link_of(nck_t *nck);

#ifdef __cplusplus
}
#endif

#endif
