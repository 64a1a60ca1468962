// SPDX-License-Identifier: MIT
// The simulation: one loop in place of a low-priority task and a timer interrupt.
#include "sim.h"

#include <math.h>   // sin
#include <string.h> // memcpy memset

#include "nck/base/trig_math.h" // NCK_PI

enum {
    PERCENT = 100,
    REST_TICKS = 16, // at rest with nothing to prepare and nothing to wait for: it stays there
    STEPS_MOST = 1 << 22 // of prep, none of which moves the run on: it never will
};

static void keep_output(void *user, const nck_output_t *output) {
    sim_t *const sim = user;
    const int follows = output->kind == NCK_OUTPUT_SURFACE_SPEED;
    if (output->kind == NCK_OUTPUT_SPINDLE_SPEED) sim->spindle_rpm = output->value;
    const int speaks = follows || output->kind == NCK_OUTPUT_SPINDLE_SPEED;
    if (speaks) sim->spindle_follows = (uint32_t)follows;
    sim->outputs++;
}

static nck_status_t prep_kernel(void *user) { return nck_prep(user); }

nck_status_t sim_init(sim_t *sim, nck_t *nck, const nck_machine_t *machine, const char *text,
                      size_t n, uint32_t prep_steps) {
    const nck_hooks_t hooks = {sim, keep_output, NULL, NULL};
    if (prep_steps == 0) return NCK_E_ARGUMENT;
    memset(sim, 0, sizeof *sim);
    sim->nck = nck;
    sim->prep = prep_kernel;
    sim->prep_user = nck;
    sim->text = text;
    sim->text_size = n;
    sim->prep_steps = prep_steps;
    sim->feed_percent = sim->rapid_percent = PERCENT;
    return nck_init(nck, machine, &hooks);
}

void sim_prepare_by(sim_t *sim, nck_status_t (*prep)(void *user), void *user) {
    sim->prep = prep;
    sim->prep_user = user;
}

void sim_operate(sim_t *sim, const sim_command_t *commands, size_t count) {
    sim->commands = commands;
    sim->command_count = count;
}

static void override(sim_t *sim, const sim_command_t *command) {
    nck_set_override(sim->nck, command->value[0] * NCK_PERCENT, command->value[1] * NCK_PERCENT);
    sim->feed_percent = (uint16_t)command->value[0];
    sim->rapid_percent = (uint16_t)command->value[1];
}

static void obey(sim_t *sim, const sim_command_t *command) {
    switch (command->kind) {
    case SIM_HOLD: nck_hold(sim->nck); break;
    case SIM_RESUME:
        nck_resume(sim->nck);
        sim->resumed = 1;
        break;
    case SIM_OVERRIDE: override(sim, command); break;
    case SIM_SINGLE_BLOCK: nck_set_single_block(sim->nck, command->value[0]); break;
    default: nck_abort(sim->nck); break;
    }
    sim->rest_ticks = 0;
}

// What the operator does behind the last tick.
static void operate(sim_t *sim) {
    while (sim->command_next < sim->command_count
           && sim->commands[sim->command_next].tick <= sim->ticks) {
        obey(sim, &sim->commands[sim->command_next]);
        sim->command_next++;
    }
}

void sim_feed_blocks(sim_t *sim) { sim->is_blocks = 1; }

static void feed_block(sim_t *sim) {
    nck_block_in_t block;
    memcpy(&block, sim->text + sim->text_used, sizeof block);
    if (nck_push_block(sim->nck, &block) == NCK_FULL) return;
    sim->text_used += sizeof block;
}

// The kernel reads the text itself, if its capacities let it jump.
static void begin(sim_t *sim) {
    const nck_source_t source = {sim->text, sim->text_size, NULL, NULL};
    sim->begun = 1;
    sim->reads = !sim->is_blocks && nck_read(sim->nck, &source) == NCK_OK;
}

static void feed(sim_t *sim) {
    if (sim->text_used == sim->text_size) {
        nck_end(sim->nck);
        return;
    }
    if (sim->is_blocks) {
        feed_block(sim);
        return;
    }
    size_t used = 0;
    (void)nck_push(sim->nck, sim->text + sim->text_used, sim->text_size - sim->text_used, &used);
    sim->text_used += used;
}

// Changes as long as the run gets on: text read, segs and outputs made, cells taken.
static uint64_t progress(const sim_t *sim) {
    const nck_link_t *const link = nck_link_of(sim->nck);
    return sim->text_used + link->seg_head + link->output_head + link->taken + link->tail_taken;
}

static void count_step(sim_t *sim) {
    const uint64_t now = progress(sim);
    sim->steps = now == sim->progress ? sim->steps + 1 : 0;
    sim->progress = now;
    if (sim->steps >= STEPS_MOST) sim->end = SIM_END_STALLED;
}

// One step of the prep task. Returns 1 if another one has something to do.
static int prep(sim_t *sim) {
    if (sim->prep_status == NCK_DONE || sim->end != SIM_END_NOT) return 0;
    if (!sim->begun) begin(sim);
    sim->prep_status = sim->prep(sim->prep_user);
    if (sim->prep_status < NCK_OK) sim->error = sim->prep_status;
    if (sim->reads) sim->text_used = nck_read_offset(sim->nck);
    if (sim->prep_status == NCK_EMPTY) feed(sim);
    if (sim->prep_status == NCK_FULL || sim->prep_status == NCK_DONE) return 0;
    count_step(sim);
    return 1;
}

static nck_command_t asked_of(const nck_t *nck) {
    nck_command_t command;
    nck_asked(nck, &command);
    return command;
}

// What keeps the path at rest while neither prep nor the tick has anything to do.
static sim_end_t cause_of_rest(const sim_t *sim) {
    const nck_command_t command = asked_of(sim->nck);
    if (command.abort) return SIM_END_STALLED; // prep has to say that it is done
    if (command.hold) return SIM_END_HOLD;
    if (command.feed_ppm == 0 || command.rapid_ppm == 0) return SIM_END_OVERRIDE;
    nck_pose_t pose;
    nck_axes_t axes;
    const int held = nck_position(sim->nck, &pose, &axes) == NCK_TICK_HOLD;
    return held && !sim->resumed ? SIM_END_SINGLE_BLOCK : SIM_END_STALLED;
}

// Prep has nothing to do before the tick or the operator does something.
static int is_prepared(const sim_t *sim) {
    return sim->prep_status == NCK_FULL || sim->prep_status == NCK_DONE;
}

// How the run has ended behind a tick and the prep that follows it.
static uint32_t find_end(const sim_t *sim) {
    if (sim->end != SIM_END_NOT) return sim->end;
    if (sim->prep_status == NCK_DONE && nck_is_idle(sim->nck)) {
        return asked_of(sim->nck).abort ? SIM_END_ABORTED : SIM_END_DONE;
    }
    if (sim->rest_ticks < REST_TICKS || !is_prepared(sim)) return SIM_END_NOT;
    const sim_end_t cause = cause_of_rest(sim);
    const int waits = cause != SIM_END_STALLED && sim->command_next < sim->command_count;
    return waits ? SIM_END_NOT : cause;
}

// M0, M1 and M6 end here, a hold in force does not.
static void end_wait(nck_t *nck) {
    const uint32_t hold = asked_of(nck).hold;
    nck_resume(nck);
    if (hold) nck_hold(nck);
}

static int moves(const sim_t *sim) {
    return nck_is_moving(sim->nck);
}

// The spindle turns on for a period, at the speed that the last tick has commanded.
static void turn_spindle(sim_t *sim) {
    sim_spindle_t *const spindle = &sim->spindle;
    nck_pose_t pose;
    nck_axes_t axes;
    if (!spindle->on) return;
    const double period = nck_machine_of(sim->nck)->period_s;
    const double share = spindle->late_s > period ? period / spindle->late_s : 1.0;
    (void)nck_position(sim->nck, &pose, &axes);
    spindle->rpm += share * (pose.spindle_rpm - spindle->rpm);
    const double angle = 2.0 * NCK_PI * spindle->turns / spindle->ripple_turns;
    const double uneven = spindle->ripple > 0.0 ? spindle->ripple * sin(angle) : 0.0;
    spindle->turns += spindle->rpm / 60.0 * (1.0 + uneven) * period;
    nck_set_spindle(sim->nck, spindle->turns);
}

// Nothing but outputs is left: to hand them over takes a tick, and no time.
static int only_gives(const sim_t *sim) {
    return sim->prep_status == NCK_DONE && !moves(sim);
}

// Whether the tick rests at a pose, and prep has no more for it: held, or full.
static int rests(const sim_t *sim, const nck_pose_t *pose) {
    const int held = pose->state == NCK_TICK_HOLD && !(pose->v > 0.0) // before a thread, too
                     && is_prepared(sim) && !asked_of(sim->nck).abort;
    const int waits = sim->prep_status == NCK_FULL && pose->state != NCK_TICK_WAIT;
    return held || (waits && !moves(sim));
}

// Returns 1 if the row is one of the run.
static int tick(sim_t *sim, sim_row_t *row) {
    const int gives = only_gives(sim);
    memset(row, 0, sizeof *row);
    if (moves(sim)) sim->resumed = 0;
    turn_spindle(sim);
    row->spindle_turns = sim->spindle.turns;
    const nck_tick_state_t state = nck_tick(sim->nck, &row->pose, &row->axes);
    if (state == NCK_TICK_WAIT) end_wait(sim->nck);
    if (gives && state == NCK_TICK_IDLE) return 0;
    sim->starved_ticks += state == NCK_TICK_STARVED;
    sim->ticks++;
    row->t_s = (double)sim->ticks * nck_machine_of(sim->nck)->period_s;
    if (sim->spindle_follows) sim->spindle_rpm = row->pose.spindle_rpm;
    row->spindle_rpm = sim->spindle_rpm;
    row->queue_cells = nck_queue_cells(sim->nck);
    row->feed_percent = sim->feed_percent;
    row->rapid_percent = sim->rapid_percent;
    sim->rest_ticks = rests(sim, &row->pose) ? sim->rest_ticks + 1 : 0;
    return 1;
}

nck_status_t sim_run(sim_t *sim, sim_row_t *rows, size_t row_max, size_t *row_count_out) {
    *row_count_out = 0;
    if (sim->ticks == 0) operate(sim);
    while (!sim->prefilled) sim->prefilled = !prep(sim);
    sim->end = find_end(sim);
    while (*row_count_out < row_max && sim->end == SIM_END_NOT) {
        *row_count_out += (size_t)tick(sim, &rows[*row_count_out]);
        operate(sim);
        for (uint32_t n = 0; n < sim->prep_steps && prep(sim); n++) continue;
        sim->end = find_end(sim);
    }
    if (sim->end == SIM_END_NOT) return NCK_OK;
    if (sim->end == SIM_END_STALLED) return NCK_E_INTERNAL;
    return sim->error < NCK_OK ? (nck_status_t)sim->error : NCK_DONE;
}
