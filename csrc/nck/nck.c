// SPDX-License-Identifier: MIT
// The wires: pull from room k, push into room k + 1. Only this file and front.c name two rooms.
#include "nck/base/bits.h" // a compiler that would change them is stopped

#include "nck/nck_tools.h"

#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/real.h" // NCK_APART nck_rounded

enum {
    PPM = 1000000, FEED_MOST = 2, // overrides
    STEPS_PER_BLOCK = 2, // of the look-ahead
    PRICE_TICK = 60, PRICE_EASES = 1280 // hundreds of instructions: the clock brakes or sets off
};

// Rooms 3 to 5 at rest at the machine's start position, and where the link ends.
static void begin_rooms(nck_t *nck) {
    nck_smooth_init(&nck->smooth, &nck->terms);
    nck_lookahead_init(&nck->lookahead, &nck->terms);
    nck_slope_init(&nck->slope, &nck->terms, &nck->link);
}

nck_status_t nck_init(nck_t *nck, const nck_machine_t *machine, const nck_hooks_t *hooks) {
    if (!nck) return NCK_E_ARGUMENT;
    const nck_status_t status = nck_machine_check(machine);
    if (status != NCK_OK) return status;
    memset(nck, 0, offsetof(nck_t, link)); // the last and large part of it, which begins for itself
    nck->machine = *machine;
    nck->command.feed_ppm = PPM;
    nck->command.rapid_ppm = PPM;
    nck->command.speed_um_s = UINT32_MAX;
    if (hooks) nck->hooks = *hooks;
    nck_slope_terms(&nck->machine, &nck->terms);
    nck_decode_init(&nck->decode, &nck->machine);
    nck_toolcomp_init(&nck->toolcomp, &nck->machine);
    nck_link_init(&nck->link);
    nck_travel_init(&nck->travel);
    begin_rooms(nck);
    nck_interpolate_init(&nck->interpolate, &nck->terms, &nck->link);
    nck_transform_init(&nck->transform, &nck->machine);
    nck->wire.modes = nck->interpolate.modes = nck_decode_modes(&nck->decode);
    return NCK_OK;
}

// What was pushed before a flush is planned to its end before more is taken, so that the path
// depends on where the flush stands and not on time. NCK_FULL: not yet.
static nck_status_t finish_flush(nck_t *nck) {
    if (nck->wire.flush != NCK_FLUSH_AHEAD) return NCK_OK;
    if (!nck_lookahead_is_settled(&nck->lookahead)) return NCK_FULL;
    nck->wire.flush = NCK_FLUSH_NOT;
    return NCK_OK;
}

// seg ring ─▶ lookahead: a seg that is in its place.
static inline nck_status_t push_seg(nck_t *nck, nck_seg_t *seg) {
    nck_link_seg_placed(&nck->link, seg);
    if (nck_lookahead_push(&nck->lookahead, seg) != NCK_OK) return NCK_E_INTERNAL;
    if (nck->hooks.on_seg) nck->hooks.on_seg(nck->hooks.user, seg);
    return NCK_OK;
}

// The next item out of smooth, or a step towards it; there is room.
static nck_status_t pull_item(nck_t *nck) {
    nck_smooth_item_t item;
    const nck_status_t status = nck_smooth_pull(&nck->smooth, &item);
    if (status == NCK_OK) {
        // smooth ─▶ seg ring and lookahead, or output ring. All have room (see carry_item).
        if (item.is_output) return nck_link_push_output(&nck->link, &item.output);
        nck_seg_t *const seg = nck_link_seg_place(&nck->link);
        *seg = item.seg;
        return push_seg(nck, seg);
    }
    if (status == NCK_DONE) {
        // Smoothing has given all. After a flush blocks may follow: the path rests here and goes
        // on.
        const int flushes = nck->wire.flush == NCK_FLUSH_SMOOTH;
        if (flushes) nck_smooth_go_on(&nck->smooth);
        nck->wire.flush = flushes ? NCK_FLUSH_AHEAD : NCK_FLUSH_NOT;
        nck->wire.ended = !flushes;
        nck_lookahead_end(&nck->lookahead);
    }
    return status == NCK_FULL ? NCK_OK : status;
}

// 1 if no seg that the look-ahead still knows would be written over: its ring may have as many
// nodes as there are segs, and keeps those that the tick has passed.
static inline int keeps_known(const nck_t *nck) {
    const uint32_t head = nck->link.seg_head;
    return NCK_NODE_MAX < NCK_SEG_MAX
           || head - nck_lookahead_oldest(&nck->lookahead, head) < NCK_SEG_MAX;
}

// The same, if there is room and any is there. NCK_EMPTY: it needs a block.
static inline nck_status_t carry_item(nck_t *nck) {
    if (!nck_link_has_room(&nck->link) || !nck_lookahead_has_room(&nck->lookahead)) return NCK_FULL;
    if (!keeps_known(nck)) return NCK_FULL;
    return nck_smooth_is_hungry(&nck->smooth) ? NCK_EMPTY : pull_item(nck);
}

// A block that waits in smooth: the path marks its line.
static nck_status_t push_block(nck_t *nck, const nck_block_t *block) {
    const double before = nck->smooth.known;
    const nck_status_t status = nck_smooth_push(&nck->smooth, block, nck->wire.blocks);
    const double known = nck->smooth.known;
    if (!NCK_HAS_MARKS) return status;
    const nck_mark_t mark = {known, block->line, block->modes};
    if (known > before) nck_link_push_mark(&nck->link, &mark);
    return status;
}

// A block into smooth, which asks for it; on the exact path its seg is made in its place and goes
// on at once. There is room.
static nck_status_t smooth_block(nck_t *nck, const nck_block_t *block) {
    nck_seg_t *const seg = nck_link_seg_place(&nck->link);
    const nck_status_t status = nck_smooth_pass(&nck->smooth, block, nck->wire.blocks, seg);
    if (status == NCK_FULL) return push_block(nck, block);
    if (status == NCK_EMPTY) return NCK_OK;
    return status == NCK_OK ? push_seg(nck, seg) : status;
}

// One block into smooth. A program error ends the path where it stands:
// everything before it is executed.
static nck_status_t carry_block(nck_t *nck, const nck_block_t *block) {
    const nck_status_t status = smooth_block(nck, block);
    nck->wire.blocks++;
    if (block->kind == NCK_BLOCK_END) nck_smooth_end(&nck->smooth);
    if (status >= NCK_OK) return status;
    nck->wire.diagnostic.code = status;
    nck->wire.diagnostic.line = block->line;
    nck_smooth_end(&nck->smooth);
    return status;
}

// No block follows: what waits in toolcomp comes first.
static void end_blocks(nck_t *nck) {
    nck_toolcomp_end(&nck->toolcomp);
    nck->wire.last = (uint8_t)nck_toolcomp_is_on(&nck->toolcomp);
    if (!nck->wire.last) nck_smooth_end(&nck->smooth);
}

// Nothing is decoded. NCK_DONE: call again; else the status.
static nck_status_t end_decode(nck_t *nck, nck_status_t status) {
    if (status == NCK_EMPTY && nck_decode_reads(&nck->decode)) return NCK_DONE;
    if (status == NCK_EMPTY && nck->wire.flush == NCK_FLUSH_ASKED) {
        nck->wire.flush = NCK_FLUSH_SMOOTH;
        nck_smooth_end(&nck->smooth);
        return NCK_DONE;
    }
    const int refused = status < NCK_OK && nck->decode.session.before; // a line, and no more
    if (status != NCK_EMPTY && !refused) end_blocks(nck);
    return status;
}

// decode ─▶ toolcomp. NCK_OK: the block passes; NCK_DONE: it does not, or there is none.
static nck_status_t decode_block(nck_t *nck) {
    nck_status_t status = nck_decode_pull(&nck->decode, &nck->wire.block);
    nck->wire.modes = nck->decode.text.quick ? nck_decode_moves(&nck->decode, nck->wire.modes)
                                             : nck_decode_modes(&nck->decode);
    nck->wire.block.modes = nck->wire.modes;
    if (status != NCK_OK) return end_decode(nck, status);
    if (nck->wire.checks) return NCK_DONE;
    status = nck_toolcomp_push(&nck->toolcomp, &nck->wire.block);
    if (status < NCK_OK) end_blocks(nck);
    return status == NCK_EMPTY ? NCK_DONE : status;
}

// decode ─▶ toolcomp: wire.block, in the machine. NCK_DONE: no block, call again.
static nck_status_t next_block(nck_t *nck) {
    nck_status_t status = NCK_EMPTY;
    if (nck_toolcomp_is_on(&nck->toolcomp)) {
        status = nck_toolcomp_pull(&nck->toolcomp, &nck->wire.block);
        if (status < NCK_OK) end_blocks(nck);
    }
    if (status == NCK_EMPTY && nck->wire.last) {
        end_blocks(nck);
        return NCK_DONE;
    }
    if (status == NCK_EMPTY) status = decode_block(nck);
    if (status == NCK_OK) nck_toolcomp_place(&nck->toolcomp, &nck->wire.block);
    return status;
}

// … ─▶ smooth ─▶ lookahead, one item, or one block and the first item of it.
static nck_status_t pull_block(nck_t *nck) {
    if (nck->wire.ended) return NCK_DONE;
    if (finish_flush(nck) != NCK_OK) return NCK_FULL;
    const nck_status_t carried = carry_item(nck);
    if (carried != NCK_EMPTY) return carried == NCK_DONE ? NCK_OK : carried;
    const nck_status_t status = next_block(nck);
    if (status != NCK_OK) return status == NCK_DONE ? NCK_OK : status;
    const nck_status_t pushed = carry_block(nck, &nck->wire.block);
    if (pushed != NCK_OK || nck_smooth_is_hungry(&nck->smooth)) return pushed;
    const nck_status_t first = carry_item(nck);
    return first < NCK_OK ? first : NCK_OK;
}

static nck_wish_t wish_of(const nck_command_t *asked) {
    const uint32_t speed_um_s = asked->speed_um_s;
    const nck_wish_t wish = {(double)asked->feed_ppm / (double)PPM,
                             (double)asked->rapid_ppm / (double)PPM,
                             speed_um_s < UINT32_MAX ? (double)speed_um_s * 1e-3 : NCK_WISH_FREE,
                             asked->hold, asked->single_block, asked->resumes};
    return wish;
}

// 1 if the operator asks for what the slope has heard: the words are compared, for wishes are
// divisions. hold: whether a hold is asked for, or soft limits ask for one.
static int is_heard(const nck_t *nck, uint32_t hold) {
    const nck_command_t *const command = &nck->command;
    const nck_command_t *const heard = &nck->wire.heard;
    const uint32_t overrides =
        (nck_fence_load(&command->feed_ppm) ^ heard->feed_ppm)
        | (nck_fence_load(&command->rapid_ppm) ^ heard->rapid_ppm)
        | (nck_fence_load(&command->speed_um_s) ^ heard->speed_um_s);
    const uint32_t words = (nck_fence_load(&command->single_block) ^ heard->single_block)
                           | (nck_fence_load(&command->resumes) ^ heard->resumes)
                           | (hold ^ heard->hold);
    return (overrides | words) == 0;
}

static inline nck_pieces_t pieces_of(nck_t *nck) {
    const nck_pieces_t pieces = {nck->lookahead.window.at, nck->lookahead.window.head,
                                 nck->lookahead.window.fill, nck->lookahead.window.barrier,
                                 (uint32_t)nck_lookahead_is_complete(&nck->lookahead)};
    return pieces;
}

// The pieces before this number are done with. One planner may be done with more than the next.
static void drop_before(nck_t *nck, uint32_t number) {
    const int32_t count = (int32_t)(number - nck->lookahead.window.head);
    for (int32_t i = 0; nck->hooks.on_node && i < count; i++) {
        nck->hooks.on_node(nck->hooks.user, nck_lookahead_ahead(&nck->lookahead, (uint32_t)i));
    }
    if (count > 0) nck_lookahead_drop(&nck->lookahead, (uint32_t)count);
}

// 1 if the path would leave the soft limits, and brakes.
static uint32_t is_stopped(nck_t *nck) {
    if (!nck_travel_is_set(&nck->travel)) return 0;
    const nck_pieces_t pieces = pieces_of(nck);
    return (uint32_t)nck_travel_step(&nck->travel, &nck->terms, &nck->link, &pieces);
}

// As nck_lacks_pieces; most steps of prep end by it.
static inline int lacks_pieces(nck_t *nck) {
    const nck_pieces_t pieces = pieces_of(nck);
    return nck_slope_lacks(&nck->slope, &pieces);
}

// lookahead ─▶ slope ─▶ plans and final cells.
static nck_status_t step_slope(nck_t *nck) {
    const uint32_t stopped = is_stopped(nck);
    const uint32_t hold = nck_fence_load(&nck->command.hold) | stopped;
    if (lacks_pieces(nck) && is_heard(nck, hold)) return (nck_status_t)nck->slope.idle.status;
    const nck_pieces_t pieces = pieces_of(nck);
    nck_hear(nck, stopped);
    const nck_wish_t wish = wish_of(&nck->wire.heard);
    const nck_status_t status = nck_slope_step(&nck->slope, &pieces, &wish);
    nck_interpolate_keep(&nck->interpolate, nck->slope.stands & nck->slope.answer.pending);
    drop_before(nck, nck_slope_needs(&nck->slope));
    return status;
}

// An invariant is broken: the tick comes to rest on what is published, and that is the end.
static nck_status_t give_up(nck_t *nck, uint32_t line) {
    nck->wire.given_up = 1;
    nck->wire.diagnostic.code = NCK_E_INTERNAL;
    nck->wire.diagnostic.line = line;
    nck_abort(nck);
    return NCK_E_INTERNAL;
}

// No more segs are finished by what the slope has given: the tick is in the seg that it ends in, or
// has executed it, be it to the end of a seg that only the next cell leaves.
static int is_executed_so_far(const nck_t *nck) {
    const uint32_t finished = nck_link_finished(&nck->link);
    if (nck_lookahead_oldest(&nck->lookahead, finished + 1) == finished) return 1;
    return nck_link_is_spent(&nck->link) && !nck_fence_load(&nck->interpolate.has_cell);
}

// The rings are full of what waits for the tick, and nothing else will make room. So the path is
// planned to rest where it is known to.
static int is_stuck(const nck_t *nck, nck_status_t slope, nck_status_t ahead, nck_status_t input) {
    return slope == NCK_EMPTY && ahead == NCK_EMPTY && input == NCK_FULL && is_executed_so_far(nck);
}

// All rooms begin anew where the axes rest.
static void begin_anew(nck_t *nck) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double counts = nck_machine_counts(&nck->machine, x);
        const double place = nck->interpolate.pose.axis[x] * counts;
        nck->machine.start_nm[x] = nck_rounded(place);
    }
    nck_decode_stand(&nck->decode);
    nck_toolcomp_init(&nck->toolcomp, &nck->machine);
    nck_link_renew(&nck->link);
    begin_rooms(nck);
    nck->wire.modes = nck->interpolate.modes = nck_decode_modes(&nck->decode);
    nck_link_give_back(&nck->link);
}

// 0: nck_begin has asked for the link, and the tick has not yielded it yet.
static int is_begun(nck_t *nck) {
    const uint32_t owner = nck_link_owner(&nck->link);
    if (owner == NCK_LINK_PREP) begin_anew(nck);
    return owner != NCK_LINK_ASKED;
}

static inline nck_status_t step_ahead(nck_lookahead_t *lookahead) {
    if (nck_lookahead_is_full(lookahead)) return NCK_FULL;
    return nck_lookahead_is_idle(lookahead) ? NCK_EMPTY : nck_lookahead_step(lookahead);
}

// What a block has made known to the look-ahead is worked out: mostly a seg, now and then the one
// that has waited for it, too. 1 if nothing is left of it that finds room.
static int look_ahead(nck_t *nck) {
    for (int n = 0; n < STEPS_PER_BLOCK; n++) {
        if (step_ahead(&nck->lookahead) != NCK_OK) return 1;
    }
    return nck_lookahead_is_idle(&nck->lookahead);
}

int nck_lacks_pieces(nck_t *nck) { return lacks_pieces(nck); }

// A block has been taken. 1 if nothing is left to do before more text comes.
static int needs_text(nck_t *nck) {
    if (!nck_smooth_is_hungry(&nck->smooth) || nck->wire.flush != NCK_FLUSH_NOT) return 0;
    return look_ahead(nck) && nck_decode_needs_text(&nck->decode)
           && !nck_toolcomp_is_on(&nck->toolcomp) && lacks_pieces(nck);
}

// More input, where rooms 5 and 4 (status, ahead) have none to work on.
static nck_status_t take_input(nck_t *nck, nck_status_t status, nck_status_t ahead) {
    nck_status_t input = pull_block(nck);
    if (input == NCK_E_INTERNAL) return give_up(nck, nck->wire.block.line);
    if (input == NCK_OK && needs_text(nck)) input = NCK_EMPTY;
    if (input == NCK_EMPTY && nck_fence_load(&nck->interpolate.has_cell)) {
        (void)nck_slope_hurry(&nck->slope, 0);
    }
    if (input <= NCK_OK || input == NCK_EMPTY) return input;
    if (is_stuck(nck, status, ahead, input)) {
        nck_lookahead_end(&nck->lookahead);
        return NCK_OK;
    }
    return status == NCK_EMPTY && ahead == NCK_DONE ? input : NCK_FULL;
}

// Downstream first: cells, then caps, then blocks.
static nck_status_t step_rooms(nck_t *nck) {
    if (nck->wire.given_up) return NCK_DONE;
    if (!is_begun(nck)) return NCK_FULL;
    const nck_status_t status = step_slope(nck);
    if (status == NCK_OK) return NCK_OK;
    if (status == NCK_E_INTERNAL) return give_up(nck, nck_link_broken_line(&nck->link));
    if (nck_fence_load(&nck->command.abort)) {
        // Nothing more is planned; the end is the rest.
        const int waits = nck_interpolate_is_waiting(&nck->interpolate);
        const int stands = nck_interpolate_stands(&nck->interpolate);
        return nck_slope_is_held(&nck->slope) || waits || stands ? NCK_DONE : NCK_FULL;
    }
    const nck_status_t ahead = step_ahead(&nck->lookahead);
    return ahead == NCK_OK ? NCK_OK : take_input(nck, status, ahead);
}

// Who has nothing left to do need not be seen.
nck_status_t nck_prep(nck_t *nck) {
    const nck_status_t status = step_rooms(nck);
    nck_fence_store(&nck->wire.steps, status == NCK_DONE ? 0 : nck->wire.steps + 1);
    return status;
}

static NCK_APART void hand_over_outputs(nck_t *nck) {
    nck_output_t output;
    while (nck_link_take_output(&nck->link, &output) == NCK_OK) {
        if (nck->hooks.on_output) nck->hooks.on_output(nck->hooks.user, &output);
    }
}

// Held: at rest, or on the way to it along the stop tail.
static int is_held(const nck_t *nck, const nck_pose_t *pose) {
    const int waits = nck_interpolate_is_waiting(&nck->interpolate);
    if (nck_fence_load(&nck->command.abort) && waits) return 1;
    const int held = nck_fence_load(&nck->command.hold) || nck_is_at_travel(nck)
                     || nck_slope_waits(&nck->slope);
    return held && (pose->state == NCK_TICK_IDLE || pose->state == NCK_TICK_STARVED);
}

nck_tick_state_t nck_position(const nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out) {
    const nck_pose_t *const pose = &nck->interpolate.pose;
    *pose_out = *pose;
    if (is_held(nck, pose)) pose_out->state = NCK_TICK_HOLD;
    nck_transform_tick(&nck->transform, pose, axes_out);
    return (nck_tick_state_t)pose_out->state;
}

// 1 if somebody asks for rest: of the motion in work, or of the next one where the path rests.
static inline int asks_for_rest(nck_t *nck) {
    const nck_command_t *const command = &nck->command;
    const uint32_t feed = nck_fence_load(&command->feed_ppm);
    const uint32_t rapid = nck_fence_load(&command->rapid_ppm);
    if (nck_fence_load(&command->hold) | nck_fence_load(&nck->travel.stops)) return 1;
    if (nck_fence_load(&command->speed_um_s) == 0) return 1;
    if (feed > 0 && rapid > 0) return 0;
    return (nck_interpolate_is_rapid(&nck->interpolate) ? rapid : feed) == 0;
}

uint32_t nck_tick_price(nck_t *nck) {
    const uint32_t clock = nck_interpolate_clock(&nck->interpolate);
    const int eases = clock == NCK_CLOCK_BRAKES || clock == NCK_CLOCK_SETS_OFF;
    const int turns = asks_for_rest(nck) != (clock == NCK_CLOCK_STANDS);
    return eases || (turns && nck_slope_is_clocked(&nck->slope)) ? PRICE_EASES : PRICE_TICK;
}

// 1 where single block keeps the path, until the operator goes on: what stands behind the block
// waits, too.
static inline int stands_behind_block(nck_t *nck) {
    const uint32_t resumes = nck_fence_load(&nck->command.resumes);
    const int moves = nck->interpolate.has_cell || !nck_link_is_spent(&nck->link);
    const int stands = nck_slope_waits(&nck->slope) && !moves;
    if (!stands || !nck->wire.stands) nck->wire.resumed = resumes;
    nck->wire.stands = (uint8_t)stands;
    return stands && resumes == nck->wire.resumed;
}

nck_tick_state_t nck_tick(nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out) {
    const int asks = asks_for_rest(nck);
    nck_interpolate_watch(&nck->interpolate, asks, asks && nck_slope_brakes(&nck->slope),
                          nck_fence_load(&nck->wire.steps));
    (void)nck_interpolate_tick(&nck->interpolate);
    if (nck_fence_load(&nck->interpolate.sync.lost)) nck_abort(nck); // nothing can follow it
    const nck_tick_state_t state = nck_position(nck, pose_out, axes_out);
    const int waits = stands_behind_block(nck);
    if (nck_link_has_output(&nck->link) && !waits) hand_over_outputs(nck);
    return state;
}

void nck_resume(nck_t *nck) {
    if (nck_fence_load(&nck->command.abort)) return;
    nck_fence_store(&nck->command.hold, 0);
    nck_interpolate_hold_thread(&nck->interpolate, 0);
    nck_fence_store(&nck->command.resumes, nck_fence_load(&nck->command.resumes) + 1);
    nck_interpolate_resume(&nck->interpolate);
}

void nck_hold(nck_t *nck) {
    nck_fence_store(&nck->command.hold, 1);
    nck_interpolate_hold_thread(&nck->interpolate, 1);
}

void nck_abort(nck_t *nck) {
    nck_fence_store(&nck->command.abort, 1);
    nck_fence_store(&nck->command.hold, 1);
    nck_interpolate_stop_thread(&nck->interpolate);
}

void nck_stop_at(nck_t *nck, nck_halt_t *halt) {
    nck_abort(nck);
    nck_interpolate_stop(&nck->interpolate, halt);
}

void nck_set_single_block(nck_t *nck, uint32_t on) {
    nck_fence_store(&nck->command.single_block, on ? 1 : 0);
}

void nck_set_override(nck_t *nck, uint32_t feed_ppm, uint32_t rapid_ppm) {
    const uint32_t feed = feed_ppm < FEED_MOST * PPM ? feed_ppm : FEED_MOST * PPM;
    nck_fence_store(&nck->command.feed_ppm, feed);
    nck_fence_store(&nck->command.rapid_ppm, rapid_ppm < PPM ? rapid_ppm : PPM);
}

void nck_set_speed(nck_t *nck, uint32_t most_um_s) {
    nck_fence_store(&nck->command.speed_um_s, most_um_s);
}

int nck_is_moving(const nck_t *nck) {
    return nck->interpolate.has_cell || nck_link_waiting(&nck->link) > 0;
}

int nck_is_idle(const nck_t *nck) {
    const int waits = nck_interpolate_is_waiting(&nck->interpolate);
    if (nck_link_owner(&nck->link) == NCK_LINK_PREP) return 1;
    const int moves = nck_is_moving(nck);
    const int stands = nck_interpolate_stands(&nck->interpolate);
    if (nck_fence_load(&nck->command.abort)) return waits || stands || !moves;
    return !waits && !moves && nck_link_is_empty(&nck->link);
}

nck_status_t nck_take(nck_t *nck, nck_cell_t *cell_out) {
    const nck_status_t status = nck_interpolate_take(&nck->interpolate, cell_out);
    if (nck_link_has_output(&nck->link)) hand_over_outputs(nck);
    return status;
}
