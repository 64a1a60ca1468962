// SPDX-License-Identifier: MIT
// Planning by velocity grades, whole programs at once (Cao et al. 2014, sections 4 to 7):
//
//   segs ─▶ stretches ─▶ units ─▶ speed in each ─▶ grade of each end ─▶ bubble ─▶ cells
//              from rest to rest, one table of grades each
//
// Every stage is a function of arrays, which the caller owns; every stage can run elsewhere
// (OpenCL) and be held against its twin here. Theory, choices and costs: docs/grades.md.
#ifndef NCK_HOST_GRADE_H
#define NCK_HOST_GRADE_H

#include <stddef.h> // size_t

#include "host/host.h" // all records
#include "host/unit.h" // nck_unit_t nck_grade_rule_t

#ifdef __cplusplus
extern "C" {
#endif

// Numbers of planning by grades.
enum {
    NCK_HOST_GRADE_STEPS = 4, // n of eq. 10, unless the caller says otherwise
    // A slower seg joins a table if its own speed is this grade at least; below, rounding down to a
    // grade would cost more than a tenth of its speed.
    NCK_HOST_GRADE_LEAST = 4
};

// A run of segs from rest to rest that share a table of grades, and its units. Points are the ends
// of its units, one more than there are units; those of stretch k begin at point unit_begin + k.
typedef struct nck_host_stretch {
    size_t seg_begin, seg_end;   // segs seg_begin … seg_end − 1
    size_t unit_begin, unit_end; // units; filled by nck_host_grade_divide
    nck_grade_rule_t rule;
} nck_host_stretch_t;

// A whole program: what is given, and arrays that the stages fill, all the caller's.
typedef struct nck_host_grades {
    const nck_machine_t *machine;
    uint32_t steps;               // n of eq. 10, at least 1
    const nck_seg_t *segs;        // of the whole program, from nck_host_plan
    size_t seg_count;             // less than 2³²
    double *v_command;            // seg_count: commanded speed of every seg [path mm/s]
    uint8_t *limit;               // seg_count: nck_limit_t that set it
    nck_host_stretch_t *stretches;
    size_t stretch_max, stretch_count;
    nck_unit_t *units;
    size_t unit_max, unit_count;
    double *v;                    // unit_max: speed inside (12) [path mm/s]
    uint32_t *n_step;             // unit_max
    uint8_t *unit_limit;          // unit_max: what bound it last, nck_limit_t
    double *a;                    // unit_max: acceleration (15), 0 between two rests [path mm/s²]
    double *v_transfer;           // unit_max + stretch_max: cap of every point [path mm/s]
    double *angle;                // unit_max + stretch_max: linking vector angle [rad]
    int32_t *preplanned;          // unit_max + stretch_max: grade before the bubble
    int32_t *grade;               // unit_max + stretch_max: grade after it
    size_t bad;                   // first offender when a stage says NCK_E_ARGUMENT
} nck_host_grades_t;

// Fill in a rule: L (10) and N (11) from a command velocity [mm/s], n and the acceleration a
// [mm/s²]; the rest from the machine. v_min: speed of grade 0 [mm/s], below v_command.
// Returns NCK_OK or NCK_E_ARGUMENT (a number is NaN, infinite, negative or zero, v_min apart, or N
// is 2³¹ or more). Cost: constant. Context: any.
nck_status_t nck_host_grade_rule(const nck_machine_t *machine, double v_command, double v_min,
                                 double a, uint32_t steps, nck_grade_rule_t *rule_out);

// v_command and limit of every seg: all caps that need no steps (F, the machine's feed, axis
// speeds). Returns NCK_OK, or NCK_E_ARGUMENT with the first seg a number of which is NaN or
// infinite, or that moves and has no length or (but for rapids) no feed. Cost: linear. Context:
// any.
nck_status_t nck_host_grade_command(nck_host_grades_t *self);

// Cut the program into stretches: at every rest, and where a commanded speed would fall below the
// grade NCK_HOST_GRADE_LEAST of a common table. Their a is the smallest limit of the path and of
// the axes that the program moves.
// Returns NCK_OK; NCK_FULL if stretch_max is too small (stretch_count tells how many there are);
// NCK_E_ARGUMENT with the first seg whose commanded speed is NaN, infinite or not positive. Cost:
// linear. Context: any.
nck_status_t nck_host_grade_stretches(nck_host_grades_t *self);

// Divide every stretch into units: segs are merged until L is reached, and the whole is cut into
// floor(length/L) equal parts; what is left at the end of a stretch joins the units before it. So
// no unit is shorter than L but the only one of a short stretch.
// Returns NCK_OK; NCK_FULL if unit_max is too small (unit_count tells how many there are; nothing
// is to be used then); NCK_E_ARGUMENT with the first seg whose length is NaN, infinite, zero or
// negative, or seg_count if there are 2³¹ units or more. Cost: linear in segs and units. Context:
// any.
nck_status_t nck_host_grade_divide(nck_host_grades_t *self);

// The linking vector angle between the end of one seg and the start of the next one, 0 … π [rad].
// Lines in space by eq. 1; what lies in one plane by the plane formulas (2) to (5); everything
// else, helices and rotary axes, by the tangents over all axes. Both move. Cost: constant.
// Context: any.
double nck_host_link_angle(const nck_seg_t *in, const nck_seg_t *out);

// Speeds inside the units of stretch k: fills its part of v, n_step and unit_limit.
// Cost: linear in the units and their steps. Context: any.
void nck_host_unit_speeds(nck_host_grades_t *self, size_t k);

// Caps and grades at the ends of the units of stretch k, from their speeds v: transfer (14), both
// neighbours' v, rest at both ends of the stretch. Fills its part of v_transfer, angle and
// preplanned. Cost: linear in the units. Context: any.
void nck_host_transfers(nck_host_grades_t *self, size_t k);

// The bubble by sweeps, as many as it takes: grades p of n points (not negative) to g_out; both
// and other (work space) n. *sweeps_out counts the last, which changed nothing.
// Returns NCK_OK, or NCK_E_ARGUMENT and in *bad_out the first point whose grade is negative or 2³¹
// − 1. Cost: n times the largest grade at most. Context: any.
nck_status_t nck_host_bubble_sweeps(const int32_t *p, size_t n, int32_t *g_out, int32_t *other,
                                    size_t *sweeps_out, size_t *bad_out);

// The bubble by a scan each way: the same grades. g_out may be p. Returns as above. Cost: linear.
// Context: any.
nck_status_t nck_host_bubble_scan(const int32_t *p, size_t n, int32_t *g_out, size_t *bad_out);

// A DEMONSTRATION of a defect, for no other use: one computation step of the bubble as printed,
// where every pair of points reads the grades g and may write either of its ends, so that two
// pairs write one point. next_out: n. order (n − 1 numbers; pair k is points k and k + 1) is the
// order in which the writes happen to arrive; the last one stays.
// Returns 1 if next_out differs from g. Cost: linear. Context: any.
int nck_host_bubble_printed(const int32_t *g, size_t n, const uint32_t *order, int32_t *next_out);

// All of it: speeds, transfers, bubble and accelerations of every stretch. Returns NCK_OK.
// Cost: linear in units and their steps. Context: any.
nck_status_t nck_host_grade_plan(nck_host_grades_t *self);

// Every invariant of a finished plan, for tests: 1 if all hold. Cost: linear. Context: any.
int nck_host_grade_invariants(const nck_host_grades_t *self);

// Where the making of cells stands; all zero at the begin but the plan.
typedef struct nck_host_grade_cursor {
    const nck_host_grades_t *grades; // a finished plan
    size_t stretch, unit; // next unit
    size_t seg;           // under way
    double s;             // in it [path mm]
    double ends[3][2];    // v² at both ends of the unit's phases
    double lengths[3];    // of the phases [path mm]
    uint32_t phase, phases;
    double done;          // of the phase [path mm]
} nck_host_grade_cursor_t;

// The next cell of a plan (user: a nck_host_grade_cursor_t), for a nck_host_feed_t; 0: there is
// none. Constant acceleration (15) in each unit; a unit between two rests speeds up and brakes
// within itself. Cost: constant. Context: prep.
int nck_host_grade_next(void *user, nck_cell_t *cell_out);

#ifdef __cplusplus
}
#endif

#endif
