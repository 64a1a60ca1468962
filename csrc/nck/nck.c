// SPDX-License-Identifier: MIT
// The wires: pull from room k, push into room k + 1. The only file that names two rooms.
#include "nck/nck.h"

#include <string.h> // memset

enum {
    PERCENT = 100, FEED_MOST = 200,    // overrides
    TAIL_STEP = 32,                    // cells of the stop tail in one bounded step
    BATCH_ROOM = NCK_CELL_MAX / 2,     // free places that make a batch worth its tail
    WIRE_FILL = 0, WIRE_BATCH = 1, WIRE_TAIL = 2, WIRE_PUBLISH = 3
};

nck_status_t nck_init(nck_t *nck, const nck_machine_t *machine, const nck_hooks_t *hooks) {
    const nck_status_t status = nck_machine_check(machine);
    if (status != NCK_OK) return status;
    memset(nck, 0, sizeof *nck);
    nck->machine = *machine;
    nck->command.feed_percent = PERCENT;
    nck->command.rapid_percent = PERCENT;
    if (hooks) nck->hooks = *hooks;
    nck_decode_init(&nck->decode, &nck->machine);
    nck_toolcomp_init(&nck->toolcomp, &nck->machine);
    nck_smooth_init(&nck->smooth, &nck->machine);
    nck_lookahead_init(&nck->lookahead, &nck->machine);
    nck_slope_init(&nck->slope, &nck->machine);
    nck_jerk_init(&nck->jerk, &nck->machine, &nck->link);
    nck_sshape_init(&nck->sshape, &nck->machine, &nck->link);
    nck_link_init(&nck->link);
    nck_interpolate_init(&nck->interpolate, &nck->machine, &nck->link);
    nck_transform_init(&nck->transform, &nck->machine);
    return NCK_OK;
}

nck_status_t nck_push(nck_t *nck, const char *text, size_t n, size_t *used_out) {
    return nck_decode_push(&nck->decode, text, n, used_out);
}

void nck_end(nck_t *nck) { nck_decode_end(&nck->decode); }

nck_status_t nck_diagnostic(nck_t *nck, nck_diagnostic_t *diagnostic_out) {
    if (nck->wire.diagnostic.code == NCK_OK) {
        return nck_decode_diagnostic(&nck->decode, diagnostic_out);
    }
    *diagnostic_out = nck->wire.diagnostic;
    nck->wire.diagnostic.code = NCK_OK;
    return NCK_OK;
}

static void end_path(nck_t *nck) {
    nck->wire.ended = 1;
    nck_lookahead_end(&nck->lookahead);
}

// smooth ─▶ seg ring and lookahead, or output ring. All have room (see carry_item).
static nck_status_t push_item(nck_t *nck, const nck_smooth_item_t *item) {
    if (item->is_output) return nck_link_push_output(&nck->link, &item->output);
    if (nck_link_push_seg(&nck->link, &item->seg) != NCK_OK) return NCK_E_INTERNAL;
    if (nck_lookahead_push(&nck->lookahead, &item->seg) != NCK_OK) return NCK_E_INTERNAL;
    if (nck->hooks.on_seg) nck->hooks.on_seg(nck->hooks.user, &item->seg);
    return NCK_OK;
}

// One item out of smooth. NCK_EMPTY: it needs a block.
static nck_status_t carry_item(nck_t *nck) {
    nck_smooth_item_t item;
    if (!nck_link_has_room(&nck->link) || !nck_lookahead_has_room(&nck->lookahead)) return NCK_FULL;
    const nck_status_t status = nck_smooth_pull(&nck->smooth, &item);
    if (status == NCK_OK) return push_item(nck, &item);
    if (status == NCK_DONE) end_path(nck);
    return status;
}

// One block into smooth, which asks for it. A program error ends the path where it stands:
// everything before it is executed.
static nck_status_t carry_block(nck_t *nck, const nck_block_t *block) {
    const nck_status_t status = nck_smooth_push(&nck->smooth, block, nck->wire.blocks);
    nck->wire.blocks++;
    if (block->kind == NCK_BLOCK_END) nck_smooth_end(&nck->smooth);
    if (status >= NCK_OK) return status;
    nck->wire.diagnostic.code = status;
    nck->wire.diagnostic.line = block->line;
    nck_smooth_end(&nck->smooth);
    return status;
}

// decode ─▶ toolcomp ─▶ smooth ─▶ lookahead, one item or one block.
static nck_status_t pull_block(nck_t *nck) {
    if (nck->wire.ended) return NCK_DONE;
    const nck_status_t carried = carry_item(nck);
    if (carried != NCK_EMPTY) return carried == NCK_DONE ? NCK_OK : carried;
    nck_block_t *const block = &nck->wire.block;
    const nck_status_t status = nck_decode_pull(&nck->decode, block);
    if (status == NCK_DONE || status < NCK_OK) nck_smooth_end(&nck->smooth);
    if (status == NCK_DONE) return NCK_OK;
    if (status != NCK_OK) return status;
    nck_toolcomp_push(&nck->toolcomp, block);
    return carry_block(nck, block);
}

// The tick has entered the stop tail: go on from where that tail comes to rest. The tail has one
// cell for each piece from the window's head on.
static void go_on_from_tail(nck_t *nck) {
    uint32_t count = 0;
    const nck_cell_t *const end = nck_link_tail_end(&nck->link, &count);
    nck_lookahead_restart(&nck->lookahead, count - 1, end->s + end->length);
    nck->wire.recovered = 1;
}

static nck_status_t begin_batch(nck_t *nck) {
    const nck_node_t *node = NULL;
    double vv_end = 0.0;
    if (nck_link_batch_begin(&nck->link) && !nck->wire.recovered) {
        go_on_from_tail(nck);
        return NCK_OK;
    }
    if (nck_link_cell_room(&nck->link) < BATCH_ROOM) return NCK_FULL;
    if (nck_lookahead_piece(&nck->lookahead, 0, &node, &vv_end) != NCK_OK) return NCK_EMPTY;
    nck->wire.pieces = 0;
    nck->wire.phase = WIRE_BATCH;
    return NCK_OK;
}

// lookahead ─▶ slope ─▶ cells behind the ring's end, one piece.
static void fill_batch(nck_t *nck) {
    const nck_node_t *node = NULL;
    nck_cell_t cells[NCK_SLOPE_CELLS];
    double vv_end = 0.0;
    if (nck_link_cell_room(&nck->link) < NCK_SLOPE_CELLS
        || nck_lookahead_piece(&nck->lookahead, nck->wire.pieces, &node, &vv_end) != NCK_OK) {
        nck_slope_brake_begin(&nck->slope, nck->wire.vv_end);
        nck_link_tail_begin(&nck->link);
        nck->wire.tail = nck->wire.pieces;
        nck->wire.phase = WIRE_TAIL;
        return;
    }
    const int count = nck_slope_push(&nck->slope, node, vv_end, cells);
    for (int k = 0; k < count; k++) nck_link_push_cell(&nck->link, &cells[k]);
    nck->wire.vv_end = vv_end;
    nck->wire.pieces++;
}

// lookahead ─▶ slope ─▶ stop tail, a bounded number of cells.
static void fill_tail(nck_t *nck) {
    for (int n = 0; n < TAIL_STEP; n++) {
        nck_cell_t cell;
        const nck_node_t *const node = nck_lookahead_ahead(&nck->lookahead, nck->wire.tail);
        nck->wire.tail++;
        const nck_node_t *const next = nck_lookahead_ahead(&nck->lookahead, nck->wire.tail);
        const double vv_cap_end = next ? next->vv_cap : 0.0;
        const nck_status_t status =
            node ? nck_slope_brake(&nck->slope, node, vv_cap_end, &cell) : NCK_EMPTY;
        if (status != NCK_EMPTY) nck_link_tail_push(&nck->link, &cell);
        if (status != NCK_OK) {
            nck->wire.phase = WIRE_PUBLISH;
            return;
        }
    }
}

static nck_status_t publish(nck_t *nck) {
    const nck_status_t status = nck_link_publish(&nck->link);
    if (status == NCK_FULL || status == NCK_E_INTERNAL) return status;
    nck->wire.phase = WIRE_FILL;
    if (status != NCK_OK) return NCK_OK;
    nck->wire.recovered = 0;
    for (uint32_t i = 0; nck->hooks.on_node && i < nck->wire.pieces; i++) {
        nck->hooks.on_node(nck->hooks.user, nck_lookahead_ahead(&nck->lookahead, i));
    }
    nck_lookahead_drop(&nck->lookahead, nck->wire.pieces);
    return NCK_OK;
}

static nck_status_t step_linear(nck_t *nck) {
    switch (nck->wire.phase) {
    case WIRE_BATCH: fill_batch(nck); return NCK_OK;
    case WIRE_TAIL: fill_tail(nck); return NCK_OK;
    case WIRE_PUBLISH: return publish(nck);
    default: return nck_fence_load(&nck->command.hold) ? NCK_FULL : begin_batch(nck);
    }
}

static nck_wish_t wish_of(const nck_command_t *command) {
    const nck_wish_t wish = {(double)nck_fence_load(&command->feed_percent) / 100.0,
                             (double)nck_fence_load(&command->rapid_percent) / 100.0,
                             nck_fence_load(&command->hold),
                             nck_fence_load(&command->single_block),
                             nck_fence_load(&command->resumes)};
    return wish;
}

static nck_pieces_t pieces_of(const nck_t *nck) {
    const nck_pieces_t pieces = {nck->lookahead.window.at, nck->lookahead.window.head,
                                 nck_lookahead_fill(&nck->lookahead)};
    return pieces;
}

// The pieces before this number are done with.
static void drop_before(nck_t *nck, uint32_t number) {
    const uint32_t count = number - nck->lookahead.window.head;
    for (uint32_t i = 0; nck->hooks.on_node && i < count; i++) {
        nck->hooks.on_node(nck->hooks.user, nck_lookahead_ahead(&nck->lookahead, i));
    }
    if (count > 0) nck_lookahead_drop(&nck->lookahead, count);
}

// lookahead ─▶ jerk-limited slope ─▶ plans and final cells.
static nck_status_t step_jerk(nck_t *nck) {
    const nck_pieces_t pieces = pieces_of(nck);
    const nck_wish_t wish = wish_of(&nck->command);
    const nck_status_t status = nck_jerk_step(&nck->jerk, &pieces, &wish);
    drop_before(nck, nck_jerk_needs(&nck->jerk));
    return status;
}

// lookahead ─▶ classical S-shape ─▶ parts of pieces, each with its brake.
static nck_status_t step_sshape(nck_t *nck) {
    const nck_pieces_t pieces = pieces_of(nck);
    const uint32_t hold = nck_fence_load(&nck->command.hold);
    const nck_status_t status = nck_sshape_step(&nck->sshape, &pieces, hold);
    drop_before(nck, nck_sshape_needs(&nck->sshape));
    return status;
}

static nck_status_t step_slope(nck_t *nck) {
    switch (nck->machine.slope) {
    case NCK_SLOPE_JERK: return step_jerk(nck);
    case NCK_SLOPE_SSHAPE: return step_sshape(nck);
    default: return step_linear(nck);
    }
}

// At a WAIT that nobody has ended. After an abort nobody can.
static int is_waiting(const nck_t *nck) {
    return nck->interpolate.waits && !nck_fence_load(&nck->interpolate.resume);
}

// An invariant is broken: the tick comes to rest on what is published, and that is the end.
static nck_status_t give_up(nck_t *nck, uint32_t line) {
    nck->wire.given_up = 1;
    nck->wire.diagnostic.code = NCK_E_INTERNAL;
    nck->wire.diagnostic.line = line;
    nck_abort(nck);
    return NCK_E_INTERNAL;
}

// The rings are full of what waits for the tick, and the tick has executed all that the slope has:
// nothing else will make room. So the path is planned to rest where it is known to.
static int is_stuck(const nck_t *nck, nck_status_t slope, nck_status_t ahead, nck_status_t input) {
    const uint32_t finished = nck_link_finished(&nck->link);
    return slope == NCK_EMPTY && ahead == NCK_EMPTY && input == NCK_FULL
           && nck_lookahead_oldest(&nck->lookahead, finished + 1) == finished;
}

// Downstream first: cells, then the envelope, then blocks.
nck_status_t nck_prep(nck_t *nck) {
    const int jerk = nck->machine.slope == NCK_SLOPE_JERK;
    if (nck->wire.given_up) return NCK_DONE;
    const nck_status_t status = step_slope(nck);
    if (status == NCK_OK) return NCK_OK;
    if (status == NCK_E_INTERNAL) return give_up(nck, nck_link_broken_line(&nck->link));
    if (nck_fence_load(&nck->command.abort)) {
        const int rests = nck_jerk_is_held(&nck->jerk) || is_waiting(nck);
        return jerk && !rests ? NCK_FULL : NCK_DONE;
    }
    const nck_status_t ahead = nck_lookahead_step(&nck->lookahead);
    if (ahead == NCK_OK) return NCK_OK;
    const nck_status_t input = pull_block(nck);
    if (input == NCK_E_INTERNAL) return give_up(nck, nck->wire.block.line);
    if (input <= NCK_OK || input == NCK_EMPTY) return input;
    if (is_stuck(nck, status, ahead, input)) {
        nck_lookahead_end(&nck->lookahead);
        return NCK_OK;
    }
    return status == NCK_EMPTY && ahead == NCK_DONE ? input : NCK_FULL;
}

static void hand_over_outputs(nck_t *nck) {
    nck_output_t output;
    while (nck_link_take_output(&nck->link, &output) == NCK_OK) {
        if (nck->hooks.on_output) nck->hooks.on_output(nck->hooks.user, &output);
    }
}

// Held: at rest, or on the way to it along the stop tail.
static int is_held(const nck_t *nck, const nck_pose_t *pose) {
    if (nck_fence_load(&nck->command.abort) && is_waiting(nck)) return 1;
    return nck_fence_load(&nck->command.hold)
           && (pose->state == NCK_TICK_IDLE || pose->state == NCK_TICK_STARVED);
}

nck_tick_state_t nck_tick(nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out) {
    const nck_pose_t *const pose = nck_interpolate_tick(&nck->interpolate);
    *pose_out = *pose;
    if (is_held(nck, pose)) pose_out->state = NCK_TICK_HOLD;
    nck_transform_tick(&nck->transform, pose, axes_out);
    hand_over_outputs(nck);
    return (nck_tick_state_t)pose_out->state;
}

void nck_resume(nck_t *nck) {
    if (nck_fence_load(&nck->command.abort)) return;
    nck_fence_store(&nck->command.hold, 0);
    nck_fence_store(&nck->command.resumes, nck_fence_load(&nck->command.resumes) + 1);
    nck_interpolate_resume(&nck->interpolate);
}

void nck_hold(nck_t *nck) { nck_fence_store(&nck->command.hold, 1); }

void nck_abort(nck_t *nck) {
    nck_fence_store(&nck->command.abort, 1);
    nck_fence_store(&nck->command.hold, 1);
}

static nck_status_t set_command(const nck_t *nck, uint32_t *word, uint32_t value, uint32_t most) {
    if (nck->machine.slope != NCK_SLOPE_JERK) return NCK_E_STATE;
    nck_fence_store(word, value < most ? value : most);
    return NCK_OK;
}

nck_status_t nck_set_single_block(nck_t *nck, uint32_t on) {
    return set_command(nck, &nck->command.single_block, on, 1);
}

nck_status_t nck_set_override(nck_t *nck, uint32_t feed_percent, uint32_t rapid_percent) {
    (void)set_command(nck, &nck->command.rapid_percent, rapid_percent, PERCENT);
    return set_command(nck, &nck->command.feed_percent, feed_percent, FEED_MOST);
}

int nck_is_idle(const nck_t *nck) {
    const int waits = is_waiting(nck);
    const int moves = nck->interpolate.has_cell || nck_link_waiting(&nck->link) > 0;
    if (nck_fence_load(&nck->command.abort)) return waits || !moves;
    return !waits && !moves && nck_link_is_empty(&nck->link);
}

nck_status_t nck_take(nck_t *nck, nck_cell_t *cell_out) {
    const nck_status_t status = nck_interpolate_take(&nck->interpolate, cell_out);
    hand_over_outputs(nck);
    return status;
}
