// SPDX-License-Identifier: MIT
// The wires, second half: what goes in at the front door, how the kernel begins anew, and what it
// tells. nck.c moves the records from room to room.
#include "nck/nck_tools.h"

#include <string.h> // memcpy memset

#include "nck/base/in_force.h"        // nck_force_t
#include "nck/base/link_invariants.h" // nck_link_invariants
#include "nck/base/real.h"            // nck_larger nck_rounded nck_real_of

enum { PRICE_LEAST = 40 }; // of any room's step, in hundreds of instructions

// ---- memory

size_t nck_size(void) { return sizeof(nck_t); }

nck_t *nck_place(void *memory, size_t size) {
    const int is_aligned = (uintptr_t)memory % sizeof(double) == 0;
    return is_aligned && size >= sizeof(nck_t) ? (nck_t *)memory : NULL;
}

// ---- in

static int flushes(const nck_t *nck) { return nck->wire.flush != NCK_FLUSH_NOT; }

nck_status_t nck_push(nck_t *nck, const char *text, size_t n, size_t *used_out) {
    *used_out = 0;
    return flushes(nck) ? NCK_FULL : nck_decode_push(&nck->decode, text, n, used_out);
}

nck_status_t nck_read(nck_t *nck, const nck_source_t *source) {
    return nck_decode_source(&nck->decode, source);
}

size_t nck_read_offset(const nck_t *nck) { return nck_decode_used(&nck->decode); }

nck_status_t nck_push_block(nck_t *nck, const nck_block_in_t *block) {
    return flushes(nck) ? NCK_FULL : nck_decode_push_block(&nck->decode, block);
}

void nck_flush(nck_t *nck) {
    nck_decode_flush(&nck->decode);
    if (!flushes(nck) && !nck->wire.ended) nck->wire.flush = NCK_FLUSH_ASKED;
}

void nck_enter(nck_t *nck, const nck_decode_t *decode, const nck_toolcomp_t *toolcomp,
               uint32_t blocks, const char *text) {
    nck->decode = *decode;
    nck->toolcomp = *toolcomp;
    nck->decode.machine = &nck->machine;
    nck->decode.macro.source.text = text;
    nck->toolcomp.machine = &nck->machine;
    nck->wire.blocks = blocks;
}

void nck_leave_at(nck_t *nck, uint32_t blocks) {
    if (nck->wire.blocks >= blocks) nck->decode.text.over = 1;
}

nck_status_t nck_push_piece(nck_t *nck, const nck_node_t *piece) {
    return nck_lookahead_take(&nck->lookahead, piece);
}

nck_status_t nck_end_pieces(nck_t *nck, uint32_t blocks) {
    if (nck->lookahead.ended) return NCK_E_STATE;
    nck_lookahead_end(&nck->lookahead);
    nck->wire.ended = 1;
    nck->wire.blocks = blocks;
    return NCK_OK;
}

void nck_hurry(nck_t *nck, uint32_t periods) {
    if (!nck_slope_hurry(&nck->slope, periods)) return;
    nck_smooth_hurry(&nck->smooth);
}

double nck_known_s(const nck_t *nck, double *v_out) {
    const double known = nck_slope_known_s(&nck->slope);
    const uint32_t fill = nck_lookahead_fill(&nck->lookahead);
    *v_out = 0.0;
    if (!(known > 0.0) || fill == 0) return 0.0;
    const nck_node_t *const last = nck_lookahead_ahead(&nck->lookahead, fill - 1);
    *v_out = nck_link_seg(&nck->link, last->seg)->length / nck->terms.knot_s;
    return known;
}

void nck_end(nck_t *nck) { nck_decode_end(&nck->decode); }

nck_status_t nck_diagnostic(nck_t *nck, nck_diagnostic_t *diagnostic_out) {
    if (nck->wire.diagnostic.code == NCK_OK) {
        const nck_status_t status = nck_toolcomp_diagnostic(&nck->toolcomp, diagnostic_out);
        if (status == NCK_OK) return NCK_OK;
        return nck_decode_diagnostic(&nck->decode, diagnostic_out);
    }
    *diagnostic_out = nck->wire.diagnostic;
    nck->wire.diagnostic.code = NCK_OK;
    return NCK_OK;
}

// ---- limits

// Nothing is under way that was made for the limits of now, but what is planned already.
static int is_planned(const nck_t *nck) {
    return !flushes(nck) && nck_decode_is_empty(&nck->decode) && nck_smooth_is_empty(&nck->smooth)
           && nck_lookahead_is_settled(&nck->lookahead);
}

static void take_limits(nck_machine_t *machine, const nck_machine_t *from) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        nck_axis_t *const axis = &machine->axis[x];
        axis->v_max = from->axis[x].v_max;
        axis->rapid = from->axis[x].rapid;
        axis->a_max = from->axis[x].a_max;
        axis->j_max = from->axis[x].j_max;
    }
    machine->path.feed_max = from->path.feed_max;
    machine->path.a_max = from->path.a_max;
    machine->path.j_max = from->path.j_max;
    machine->path.chord_error = from->path.chord_error;
    machine->path.tolerance = from->path.tolerance;
}

nck_status_t nck_set_limits(nck_t *nck, const nck_machine_t *machine) {
    const nck_status_t status = nck_machine_check(machine);
    if (status != NCK_OK) return status;
    if (!is_planned(nck)) {
        nck_flush(nck);
        return NCK_FULL;
    }
    // An answer to the operator goes by the limits of now, so nothing is left of those before.
    if (nck_link_finished(&nck->link) != nck->link.seg_head) return NCK_FULL;
    take_limits(&nck->machine, machine);
    nck_slope_terms(&nck->machine, &nck->terms);
    nck_lookahead_adapt(&nck->lookahead);
    return NCK_OK;
}

nck_status_t nck_set_travel(nck_t *nck, uint32_t axis, int64_t least_nm, int64_t most_nm) {
    if (axis >= NCK_AXIS_MAX || least_nm > most_nm) return NCK_E_ARGUMENT;
    const double counts = nck_machine_counts(&nck->machine, (int)axis);
    nck_travel_set(&nck->travel, (int)axis, nck_real_of(least_nm) / counts,
                   nck_real_of(most_nm) / counts);
    return NCK_OK;
}

// ---- begin anew

// The program has ended, and every seg and output of it is done.
static int is_executed(const nck_t *nck) {
    nck_queue_t queue;
    nck_queue(nck, &queue);
    return nck->wire.ended && queue.segs == 0 && queue.outputs == 0;
}

static nck_status_t begin_at_rest(nck_t *nck) {
    const int aborted = nck_fence_load(&nck->command.abort) != 0;
    const int over = aborted || is_executed(nck);
    const int rests = nck_interpolate_is_at_rest(&nck->interpolate)
                      || nck_interpolate_stands(&nck->interpolate);
    if (nck->wire.given_up || !over || !rests) return NCK_E_STATE;
    nck_link_ask(&nck->link); // nck_prep begins the other rooms when the tick has yielded it
    nck_travel_begin(&nck->travel);
    memset(&nck->wire, 0, sizeof nck->wire);
    nck_fence_store(&nck->command.hold, 0);
    nck_interpolate_hold_thread(&nck->interpolate, 0);
    nck_fence_store(&nck->command.abort, 0);
    return NCK_OK;
}

nck_status_t nck_begin(nck_t *nck) {
    const nck_status_t status = begin_at_rest(nck);
    if (status == NCK_OK) nck_decode_begin(&nck->decode);
    return status;
}

// ---- a session

nck_status_t nck_begin_session(nck_t *nck, nck_decode_t *before) {
    return nck_decode_lend(&nck->decode, before);
}

nck_status_t nck_go_on(nck_t *nck) {
    if (!nck->decode.session.before) return NCK_E_STATE;
    const nck_status_t status = begin_at_rest(nck);
    if (status == NCK_OK) nck_decode_drop(&nck->decode);
    return status;
}

nck_status_t nck_leave_nothing(nck_t *nck) {
    return flushes(nck) ? NCK_FULL : nck_decode_leave_nothing(&nck->decode);
}

void nck_check_only(nck_t *nck, uint32_t on) { nck->wire.checks = on != 0; }

nck_status_t nck_set_switches(nck_t *nck, uint32_t skips, uint32_t stops) {
    if (skips >> 10 != 0 || stops > 1) return NCK_E_ARGUMENT;
    nck->machine.dialect.block_skip = skips & 1u;
    nck->machine.dialect.skip_switches = skips & ~1u;
    nck->machine.dialect.optional_stop = (uint8_t)stops;
    return NCK_OK;
}

void nck_name_line(nck_t *nck, uint32_t name) { nck_decode_name_line(&nck->decode, name); }

// Nothing is under way in any room.
static int is_all_taken(const nck_t *nck) {
    nck_queue_t queue;
    nck_queue(nck, &queue);
    return nck_decode_is_empty(&nck->decode) && !nck_toolcomp_is_on(&nck->toolcomp)
           && queue.smooth == 0 && queue.segs == 0 && queue.outputs == 0;
}

// Nothing is under way in any room, and the link is both sides'.
static int is_all_done(const nck_t *nck) {
    return is_all_taken(nck) && !flushes(nck) && !nck->wire.given_up
           && nck_link_owner(&nck->link) == NCK_LINK_BOTH
           && nck_interpolate_is_at_rest(&nck->interpolate);
}

// 1 if an axis that the machine has can stand there.
static int is_place(const nck_machine_t *machine, int x, int64_t at_nm) {
    const double counts = nck_machine_counts(machine, x);
    const double most = machine->axis[x].rotary ? NCK_ROTARY_MAX_DEG : NCK_LINEAR_MAX_MM;
    return nck_real_of(at_nm) >= -most * counts && nck_real_of(at_nm) <= most * counts;
}

nck_status_t nck_set_position(nck_t *nck, const int64_t *position_nm) {
    nck_machine_t *const machine = &nck->machine;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (!is_place(machine, x, position_nm[x])) return NCK_E_ARGUMENT;
    }
    if (!is_all_done(nck)) return NCK_E_STATE;
    memcpy(machine->start_nm, position_nm, sizeof machine->start_nm);
    nck->interpolate.told |= 1u;
    nck_link_ask(&nck->link);
    return NCK_OK;
}

static int are_places(const nck_machine_t *machine, const int64_t *at_nm, uint32_t rows,
                      int columns) {
    for (uint32_t row = 0; row < rows; row++) {
        for (int x = 0; x < columns; x++) {
            if (!is_place(machine, x, at_nm[row * NCK_AXIS_MAX + (uint32_t)x])) return 0;
        }
    }
    return 1;
}

nck_status_t nck_modal_set(nck_t *nck, const nck_modal_t *modal) {
    const nck_machine_t *const machine = &nck->machine;
    const nck_offsets_t offsets = {modal->systems_nm[0], modal->home_nm[0], modal->g92_nm,
                                   modal->tool_nm, modal->work_system, modal->tool_next,
                                   modal->tool_in};
    const int good = are_places(machine, offsets.systems_nm, NCK_WORK_SYSTEMS, NCK_AXIS_MAX)
                     && are_places(machine, offsets.home_nm, 2, NCK_AXIS_MAX)
                     && are_places(machine, offsets.g92_nm, 1, NCK_AXIS_MAX)
                     && are_places(machine, offsets.tool_nm, 1, 3);
    if (!good) return NCK_E_ARGUMENT;
    if (!is_all_done(nck)) return NCK_E_STATE;
    const nck_status_t status = nck_decode_set_offsets(&nck->decode, &offsets);
    nck->wire.modes = nck_decode_modes(&nck->decode);
    return status;
}

nck_status_t nck_tool_of(const nck_t *nck, uint32_t number, nck_tool_t *tool_out) {
    return nck_decode_tool_of(&nck->decode, number, tool_out) ? NCK_OK : NCK_E_TOOL_UNKNOWN;
}

nck_status_t nck_tool_set(nck_t *nck, const nck_tool_t *tool) {
    nck_machine_t *const machine = &nck->machine;
    uint32_t row = 0;
    while (row < machine->tool_count && machine->tool[row].number != tool->number) row++;
    const int fits = row < NCK_TOOL_MAX && tool->number != 0;
    if (!fits || !nck_machine_takes_tool(machine, tool)) return NCK_E_ARGUMENT;
    if (!is_all_done(nck)) return NCK_E_STATE;
    machine->tool[row] = *tool;
    if (row == machine->tool_count) machine->tool_count++;
    nck_decode_forget_tool(&nck->decode, tool->number);
    return NCK_OK;
}

nck_status_t nck_heed_travel(nck_t *nck, uint32_t on) {
    if (!is_all_done(nck)) return NCK_E_STATE;
    nck->machine.roams = on == 0;
    return NCK_OK;
}

uint32_t nck_places(const nck_t *nck) { return nck->interpolate.told >> 1; }

// ---- what has stopped

nck_status_t nck_stopped_at(const nck_t *nck, const nck_halt_t *halt, nck_axes_t *joints_out) {
    nck_pose_t pose;
    if (nck_fence_load(&halt->periods) == 0) return NCK_EMPTY;
    memset(&pose, 0, sizeof pose);
    memcpy(pose.axis, halt->at, sizeof pose.axis);
    nck_transform_tick(&nck->transform, &pose, joints_out);
    return NCK_OK;
}

nck_status_t nck_probed(nck_t *nck, const nck_halt_t *halt) {
    int64_t at_nm[NCK_AXIS_MAX];
    if (!nck->decode.session.before || !nck_decode_is_empty(&nck->decode)) return NCK_E_STATE;
    for (int x = 0; halt && x < NCK_AXIS_MAX; x++) {
        at_nm[x] = nck_rounded(halt->at[x] * nck_machine_counts(&nck->machine, x));
    }
    return nck_decode_probed(&nck->decode, halt ? at_nm : NULL);
}

nck_status_t nck_answered(nck_t *nck, double value) {
    if (!nck->decode.session.before || !nck_decode_is_empty(&nck->decode)) return NCK_E_STATE;
    return nck_decode_answered(&nck->decode, value);
}

void nck_set_clock(nck_t *nck, const nck_wall_clock_t *clock) {
    nck_wall_clock_t *const own = NCK_CLOCK_AT(&nck->machine);
    (void)nck;
    if (NCK_HAS_VARIABLES) *own = *clock;
}

void nck_await(nck_t *nck, uint32_t on) { nck_interpolate_await(&nck->interpolate, on); }

// ---- what it tells

void nck_set_spindle(nck_t *nck, double turns) {
    nck_interpolate_measure(&nck->interpolate, turns);
}

int nck_is_thread_lost(const nck_t *nck) {
    return (int)nck_fence_load(&nck->interpolate.sync.lost);
}

uint32_t nck_joint_count(const nck_t *nck) { return nck->transform.joints; }

uint32_t nck_joint_axis(const nck_t *nck, uint32_t joint) { return nck->transform.axis[joint]; }

void nck_queue(const nck_t *nck, nck_queue_t *queue_out) {
    const nck_link_t *const link = &nck->link;
    queue_out->blocks = nck->wire.blocks;
    queue_out->smooth = nck_smooth_is_empty(&nck->smooth) ? 0 : 1;
    queue_out->segs = link->seg_head - nck_link_finished(link);
    queue_out->outputs = link->output_head - nck_fence_load(&link->output_taken);
    queue_out->cells = nck_link_waiting(link);
    queue_out->text = nck_decode_is_empty(&nck->decode) ? 0 : 1;
    const int rests = queue_out->segs == 0 && queue_out->smooth == 0;
    const uint32_t oldest = link->seg_head - queue_out->segs;
    queue_out->executed = rests ? nck->wire.blocks : nck_link_seg(link, oldest)->block;
}

uint32_t nck_queue_cells(const nck_t *nck) { return nck_link_waiting(&nck->link); }

// So many bits of a word of modes.
static uint32_t force(uint32_t modes, nck_force_t from, uint32_t bits) {
    return modes >> from & ((1u << bits) - 1u);
}

static void tell_modes(uint32_t modes, nck_modal_t *modal_out) {
    const uint32_t motion = force(modes, NCK_FORCE_MOTION, 10);
    modal_out->motion = motion >= NCK_FORCE_NO_MOTION ? -1 : (int32_t)motion / 10;
    modal_out->plane = (uint8_t)(17 + force(modes, NCK_FORCE_PLANE, 2));
    modal_out->inch = (uint8_t)force(modes, NCK_FORCE_INCH, 1);
    modal_out->diameter = (uint8_t)force(modes, NCK_FORCE_DIAMETER, 1);
    modal_out->incremental = (uint8_t)force(modes, NCK_FORCE_INCREMENTAL, 1);
    modal_out->feed_mode = (uint8_t)force(modes, NCK_FORCE_FEED_MODE, 2);
    modal_out->path_mode = (uint8_t)force(modes, NCK_FORCE_PATH_MODE, 2);
    modal_out->spindle_on = (uint8_t)force(modes, NCK_FORCE_SPINDLE_ON, 1);
    modal_out->spindle_code = (uint8_t)force(modes, NCK_FORCE_SPINDLE_CODE, 3);
    modal_out->coolant = (uint8_t)force(modes, NCK_FORCE_COOLANT, 2);
    modal_out->work_system = (uint8_t)force(modes, NCK_FORCE_SYSTEM, 4);
}

void nck_modal(const nck_t *nck, nck_modal_t *modal_out) {
    const nck_decode_t *const decode = &nck->decode;
    const uint32_t system = decode->place.work_system;
    memset(modal_out, 0, sizeof *modal_out);
    tell_modes(nck_decode_modes(decode), modal_out);
    modal_out->tolerance_mm = decode->modal.tolerance_mm;
    modal_out->feed = decode->modal.feed;
    modal_out->spindle_rpm = decode->modal.speed > 0.0 ? decode->modal.speed : 0.0;
    modal_out->surface = decode->modal.surface_on ? decode->modal.surface : 0.0;
    modal_out->tool_next = decode->modal.tool_next;
    modal_out->tool_in = decode->modal.tool_in;
    memcpy(modal_out->position_nm, decode->place.position_nm, sizeof modal_out->position_nm);
    memcpy(modal_out->origin_nm, decode->place.origin_nm, sizeof modal_out->origin_nm);
    memcpy(modal_out->work_nm, decode->place.work_nm[system], sizeof modal_out->work_nm);
    memcpy(modal_out->g92_nm, decode->place.g92_nm, sizeof modal_out->g92_nm);
    memcpy(modal_out->systems_nm, decode->place.work_nm, sizeof modal_out->systems_nm);
    memcpy(modal_out->home_nm, decode->place.home_nm, sizeof modal_out->home_nm);
    memcpy(modal_out->tool_nm, decode->place.tool_nm, sizeof modal_out->tool_nm);
}

void nck_modal_executed(const nck_t *nck, nck_modal_t *modal_out) {
    nck_modal(nck, modal_out);
    if (!is_all_taken(nck)) tell_modes(nck_fence_load(&nck->interpolate.modes), modal_out);
}

int nck_is_at_travel(const nck_t *nck) { return (int)nck_fence_load(&nck->travel.stops); }

const nck_machine_t *nck_machine_of(const nck_t *nck) { return &nck->machine; }

const nck_node_t *nck_piece(const nck_t *nck, uint32_t i) {
    return nck_lookahead_ahead(&nck->lookahead, i);
}

uint32_t nck_price(nck_t *nck) {
    const uint32_t plan = nck_slope_price(&nck->slope);
    const uint32_t smooth = nck_smooth_price(&nck->smooth);
    const uint32_t path = smooth > 0 ? smooth : (uint32_t)PRICE_LEAST;
    return nck_slope_plans_clocked(&nck->slope) && plan > 0 ? plan : nck_larger(plan, path);
}

int nck_is_answering(const nck_t *nck) { return nck_slope_is_answering(&nck->slope); }

void nck_asked(const nck_t *nck, nck_command_t *command_out) {
    const nck_command_t *const command = &nck->command;
    command_out->feed_ppm = nck_fence_load(&command->feed_ppm);
    command_out->rapid_ppm = nck_fence_load(&command->rapid_ppm);
    command_out->speed_um_s = nck_fence_load(&command->speed_um_s);
    command_out->hold = nck_fence_load(&command->hold);
    command_out->single_block = nck_fence_load(&command->single_block);
    command_out->resumes = nck_fence_load(&command->resumes);
    command_out->abort = nck_fence_load(&command->abort);
}

// An override of none asks for a rest, which a clock that stands has brought.
static uint32_t moving(uint32_t asked, uint32_t before) { return asked > 0 ? asked : before; }

// 1 if all motion is to rest. Rapids alone are slowed down for, too.
static int brakes_at_once(const nck_command_t *asked) {
    return asked->hold || asked->feed_ppm == 0 || asked->speed_um_s == 0;
}

// Along a clocked path the tick rests by its own clock, and counts on the plan in force: nothing
// else is heard then, and an answer in work is not wanted any more. While the clock stands any plan
// may come that moves.
static void hear_clock(const nck_command_t *planned, uint32_t clock, nck_command_t *heard) {
    const nck_command_t asked = *heard;
    *heard = *planned;
    heard->resumes = asked.resumes;
    if (clock != NCK_CLOCK_STANDS) return;
    heard->hold &= asked.hold;
    heard->single_block = asked.single_block;
    heard->feed_ppm = moving(asked.feed_ppm, planned->feed_ppm);
    heard->rapid_ppm = moving(asked.rapid_ppm, planned->rapid_ppm);
    heard->speed_um_s = moving(asked.speed_um_s, planned->speed_um_s);
}

void nck_hear(nck_t *nck, uint32_t stopped) {
    nck_command_t *const heard = &nck->wire.heard;
    nck_command_t *const planned = NCK_OPTIMAL_OR(nck, wire.planned, wire.heard);
    if (NCK_HAS_OPTIMAL && !nck_slope_is_answering(&nck->slope)) *planned = *heard;
    nck_asked(nck, heard);
    heard->hold |= stopped;
    nck->slope.stands = 0;
    if (!NCK_HAS_OPTIMAL || !nck_slope_is_clocked(&nck->slope)) return;
    const uint32_t clock = nck_interpolate_clock(&nck->interpolate);
    const int rests = nck_interpolate_is_at_rest(&nck->interpolate);
    if (clock == NCK_CLOCK_RUNS && (rests || !brakes_at_once(heard))) return;
    nck->slope.stands = (uint32_t)(clock == NCK_CLOCK_STANDS);
    hear_clock(planned, clock, heard);
}

uint32_t nck_invariants(const nck_t *nck) {
    const int holds[] = {nck_link_invariants(&nck->link),
                         nck_decode_invariants(&nck->decode),
                         nck_toolcomp_invariants(&nck->toolcomp),
                         nck_smooth_invariants(&nck->smooth),
                         nck_lookahead_invariants(&nck->lookahead),
                         nck_slope_invariants(&nck->slope),
                         nck_interpolate_invariants(&nck->interpolate)};
    uint32_t broken = 0;
    for (uint32_t k = 0; k < sizeof holds / sizeof *holds; k++) broken |= holds[k] ? 0u : 1u << k;
    return broken;
}

nck_link_t *nck_link_of(nck_t *nck) { return &nck->link; }
