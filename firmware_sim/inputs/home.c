// SPDX-License-Identifier: MIT
// Homing: one axis after the other goes to its switch, fast, and again, slowly; where it was when
// the switch closed is the end of its travel.
#include "inputs/inputs.h"

#include <string.h> // memcpy memset

#include "nck/base/fence.h" // nck_fence_load

enum { NIBBLE = 4, LOCATES = 5 }; // LOCATES: times pull_off, the way of the slow approach

static int axis_at(const inputs_t *self, uint32_t at) {
    const uint32_t shift = at * NIBBLE;
    return shift < 32 ? (int)(self->set.order >> shift & 0xfu) - 1 : -1;
}

static int axis_of(const inputs_t *self) { return axis_at(self, self->home.at); }

static int64_t counts_of(const inputs_t *self, int axis, double way) {
    return (int64_t)(way * nck_machine_counts(nck_machine_of(self->nck), axis) + 0.5);
}

static int is_pair(const inputs_t *self) { return (int)self->set.pair == axis_of(self) + 1; }

// The switch of the axis, or one of a pair's.
static int is_closed(const inputs_t *self) {
    const uint32_t pins = nck_fence_load(&self->pins);
    const uint32_t second = is_pair(self) ? pins >> HAL_IN_SECOND : 0u;
    return ((pins >> (HAL_IN_HOME + axis_of(self)) | second) & 1u) != 0;
}

// Where a leg begins and ends, of the machine.
typedef struct way {
    int64_t from_nm, to_nm;
} way_t;

static way_t way_of(const inputs_t *self) {
    const int x = axis_of(self);
    const nck_axis_t *const axis = &nck_machine_of(self->nck)->axis[x];
    const int back = (self->set.reverse >> x & 1u) != 0;
    const int64_t off = counts_of(self, x, self->set.pull_off) * (back ? -1 : 1);
    const int64_t end = back ? axis->min_nm : axis->max_nm;
    way_t way = {end, end - off}; // off the switch
    switch (self->home.leg) {
    case INPUTS_SEEK:
    case INPUTS_AGAIN: way.from_nm = back ? axis->max_nm : axis->min_nm; way.to_nm = end; break;
    case INPUTS_LOCATE: way.from_nm = end - LOCATES * off; way.to_nm = end; break;
    case INPUTS_BACK:
    case INPUTS_LEAVE: way.from_nm = end + self->home.over_nm; break;
    default: break;
    }
    return way;
}

static int seeks(const inputs_t *self) {
    const uint32_t leg = self->home.leg;
    return leg == INPUTS_SEEK || leg == INPUTS_AGAIN || leg == INPUTS_LOCATE;
}

static void begin_leg(inputs_t *self, inputs_leg_t leg) {
    self->home.leg = (uint8_t)leg;
    self->home.phase = INPUTS_PLACES;
}

static void begin_axis(inputs_t *self) {
    if (axis_of(self) >= 0) begin_leg(self, is_closed(self) ? INPUTS_CLEAR : INPUTS_SEEK);
    else self->home.result = INPUTS_DONE;
}

static int fits(const inputs_t *self, int x) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    if (x >= NCK_AXIS_MAX || !machine->axis[x].present) return 0;
    const int64_t least = machine->axis[x].min_nm, most = machine->axis[x].max_nm;
    if (least == INT64_MIN || most == INT64_MAX || !(self->set.pull_off > 0.0)) return 0;
    return most - least >= LOCATES * counts_of(self, x, self->set.pull_off);
}

nck_status_t inputs_home(inputs_t *self) {
    uint32_t at = 0;
    for (; axis_at(self, at) >= 0; at++) {
        if (!fits(self, axis_at(self, at))) return NCK_E_ARGUMENT;
    }
    if (at == 0 || !(self->set.feed > 0.0) || !(self->set.seek > 0.0)) return NCK_E_ARGUMENT;
    memset(&self->home, 0, sizeof self->home);
    nck_fence_store(&self->watched, 0);
    self->home.result = INPUTS_GOES;
    begin_axis(self);
    return NCK_OK;
}

static void place(inputs_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    modal.position_nm[axis_of(self)] = way_of(self).from_nm;
    if (nck_set_position(self->nck, modal.position_nm) == NCK_OK) self->home.phase = INPUTS_GIVES;
}

static void give(inputs_t *self) {
    const int x = axis_of(self);
    nck_modal_t modal;
    nck_block_in_t block;
    nck_modal(self->nck, &modal);
    memset(&block, 0, sizeof block);
    block.kind = NCK_IN_LINE;
    block.sets = NCK_IN_SETS_FEED;
    block.feed_mode = NCK_FEED_PER_MINUTE;
    block.feed = self->home.leg == INPUTS_LOCATE ? self->set.feed : self->set.seek;
    block.axes = 1u << x;
    block.target[x] = (double)(way_of(self).to_nm - modal.origin_nm[x])
                      / nck_machine_counts(nck_machine_of(self->nck), x);
    if (nck_leave_nothing(self->nck) != NCK_OK) return;
    if (nck_push_block(self->nck, &block) != NCK_OK) return;
    if (seeks(self)) {
        nck_fence_store(&self->racked, 0);
        nck_fence_store(&self->squares, (uint32_t)is_pair(self));
        nck_fence_store(&self->watched, 1u << (HAL_IN_HOME + x));
    }
    nck_flush(self->nck);
    self->home.phase = INPUTS_MOVES;
}

// By how much the axis has gone on beyond the place of the switch.
static void measure(inputs_t *self) {
    const int x = axis_of(self);
    nck_pose_t pose;
    nck_axes_t axes;
    (void)nck_position(self->nck, &pose, &axes);
    const double over = pose.axis[x] - self->halt.at[x];
    self->home.over_nm = over < 0.0 ? -counts_of(self, x, -over) : counts_of(self, x, over);
}

static void end_move(inputs_t *self, int found) {
    const uint32_t leg = self->home.leg;
    self->home.phase = INPUTS_WAITS;
    if (!seeks(self)) return;
    if (found) begin_leg(self, leg == INPUTS_LOCATE ? INPUTS_LEAVE : INPUTS_BACK);
    else if (leg == INPUTS_SEEK) begin_leg(self, INPUTS_AGAIN);
    else self->home.result = INPUTS_MISSED;
}

static void move(inputs_t *self, int rests) {
    if (nck_fence_load(&self->tripped) == 0) {
        if (rests) end_move(self, 0);
        return;
    }
    if (nck_fence_load(&self->halt.periods) == 0) return;
    measure(self);
    if (inputs_go_on(self) != NCK_OK) return;
    if (nck_fence_load(&self->racked)) self->home.result = INPUTS_RACKED;
    else end_move(self, 1);
}

// The axis is off its switch, which must have opened.
static void wait(inputs_t *self) {
    if (nck_fence_load(&self->steady) < self->set.debounce) return;
    if (is_closed(self)) {
        if (self->home.leg == INPUTS_BACK) begin_leg(self, INPUTS_FURTHER);
        else self->home.result = INPUTS_STUCK;
    } else if (self->home.leg == INPUTS_LEAVE) {
        self->home.at++;
        begin_axis(self);
    } else {
        begin_leg(self, self->home.leg == INPUTS_CLEAR ? INPUTS_SEEK : INPUTS_LOCATE);
    }
}

void inputs_give_up(inputs_t *self) {
    self->home.result = INPUTS_NOT;
    nck_fence_store(&self->squares, 0);
    nck_fence_store(&self->held, 0);
    inputs_watch(self, 0, 0);
}

inputs_result_t inputs_step(inputs_t *self, int rests) {
    if (self->home.result == INPUTS_NOT) return INPUTS_NOT;
    if (self->home.result == INPUTS_GOES) {
        switch (self->home.phase) {
        case INPUTS_PLACES: place(self); break;
        case INPUTS_GIVES: give(self); break;
        case INPUTS_MOVES: move(self, rests); break;
        default: wait(self); break;
        }
    }
    const inputs_result_t result = (inputs_result_t)self->home.result;
    if (result != INPUTS_GOES) inputs_give_up(self);
    return result;
}
