// SPDX-License-Identifier: MIT
// Inside room 5: which planner is in force.
#include "nck/prep/5_slope/planner.h"

// The machine's slope, one of those that the build has (nck_machine_check): the others are not
// called.
static uint32_t slope_of(const nck_machine_t *machine) {
    return NCK_HAS_JERK ? machine->slope : (uint32_t)NCK_SLOPE_LINEAR;
}

// Its planner on the exact path.
static uint32_t planner_of(const nck_machine_t *machine) {
    const uint32_t slope = slope_of(machine);
    return NCK_HAS_OPTIMAL && slope == NCK_SLOPE_OPTIMAL ? NCK_SLOPE_JERK : slope;
}

uint32_t nck_planner_kind(const nck_slope_t *self) {
    return NCK_HAS_OPTIMAL ? self->kind_in_force : planner_of(self->machine);
}

// The optimal planner's state, which few builds have.
static nck_optimal_t *optimal_of(nck_slope_t *self) {
    (void)self; // of no use without one
    return NCK_OPTIMAL_AT(self, optimal);
}

static void begin_jerk(nck_slope_t *self) {
    nck_jerk_init(&self->planner.jerk, self->machine, self->link, &self->now, &self->next);
}

void nck_planner_init(nck_slope_t *self) {
    const nck_machine_t *const machine = self->machine;
    nck_link_t *const link = self->link;
    self->kind_in_force = planner_of(machine);
    if (slope_of(machine) == NCK_SLOPE_OPTIMAL) {
        nck_optimal_init(optimal_of(self), self->terms, link, &self->now, &self->next,
                         NCK_OPTIMAL_AT(self, planner.motion));
    }
    if (self->kind_in_force == NCK_SLOPE_JERK) {
        begin_jerk(self);
    } else {
        nck_linear_init(&self->planner.linear, machine, link, &self->next);
    }
}

void nck_planner_choose(nck_slope_t *self, const nck_node_t *piece) {
    if (!NCK_HAS_OPTIMAL || slope_of(self->machine) != NCK_SLOPE_OPTIMAL || !piece) return;
    const int is_clocked = nck_link_seg(self->link, piece->seg)->kind == NCK_SEG_SPLINE;
    const uint32_t kind = is_clocked ? (uint32_t)NCK_SLOPE_OPTIMAL : (uint32_t)NCK_SLOPE_JERK;
    if (kind == self->kind_in_force) return;
    self->kind_in_force = kind;
    if (!is_clocked) begin_jerk(self); // the other one has worked in its place
}

void nck_planner_begin(nck_slope_t *self, const nck_job_t *job) {
    switch (nck_planner_kind(self)) {
    case NCK_SLOPE_OPTIMAL: nck_optimal_begin(optimal_of(self), job); break;
    case NCK_SLOPE_JERK: nck_jerk_begin(&self->planner.jerk, job); break;
    default: nck_linear_begin(&self->planner.linear, job); break;
    }
}

nck_status_t nck_planner_step(nck_slope_t *self, const nck_pieces_t *pieces) {
    switch (nck_planner_kind(self)) {
    case NCK_SLOPE_OPTIMAL: return nck_optimal_step(optimal_of(self), pieces);
    case NCK_SLOPE_JERK: return nck_jerk_step(&self->planner.jerk, pieces);
    default: return nck_linear_step(&self->planner.linear, pieces);
    }
}

void nck_planner_hurry(nck_slope_t *self) {
    switch (nck_planner_kind(self)) {
    case NCK_SLOPE_OPTIMAL: nck_optimal_hurry(optimal_of(self)); break;
    case NCK_SLOPE_JERK: nck_jerk_hurry(&self->planner.jerk); break;
    default: nck_linear_hurry(&self->planner.linear); break;
    }
}

uint32_t nck_planner_price(const nck_slope_t *self) {
    if (nck_planner_kind(self) != NCK_SLOPE_OPTIMAL) return NCK_PROFILE > 1024 ? 120 : 40;
    return nck_optimal_price(NCK_OPTIMAL_AT(self, optimal));
}

uint32_t nck_planner_laid(const nck_slope_t *self) {
    if (nck_planner_kind(self) != NCK_SLOPE_OPTIMAL) return 0;
    return nck_optimal_laid(NCK_OPTIMAL_AT(self, optimal));
}

uint32_t nck_planner_seam(nck_slope_t *self, uint32_t cell) {
    if (nck_planner_kind(self) != NCK_SLOPE_OPTIMAL) return cell;
    return nck_optimal_seam(optimal_of(self), cell);
}
