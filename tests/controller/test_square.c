// SPDX-License-Identifier: MIT
// An axis with two motors is squared in homing: wherever the motors and their switches are, both
// stand as far from their switches, to what the axis goes in the periods that a switch bounces.
//
//     test_square [COUNT [FIRST]]   so many gantries, from this number on
#include <math.h>   // fabs
#include <string.h> // memset

#include "check.h"
#include "inputs/inputs.h"
#include "nck/nck_session.h"
#include "nck/nck_tools.h"

enum { PREP = 64, TICKS_MOST = 400000, X = 0 };

// A machine whose X two motors drive.
typedef struct gantry {
    nck_t nck;
    nck_decode_t room;
    inputs_t inputs;
    nck_pose_t pose;
    nck_axes_t axes;
    int64_t told_nm;     // of X, before the tick
    uint32_t places;
    double motor[2];     // where they are [mm]
    double at[2];        // their switches close there and beyond
    int wired[2];
    uint32_t since[2], was[2], bounce;
} gantry_t;

static gantry_t gantry;
static uint64_t seed;
static uint32_t count = 12, first = 1;

static double draw(double low, double high)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 40) / 16777216.0;
}

static uint32_t read_one(uint32_t m)
{
    const uint32_t now = gantry.wired[m] && gantry.motor[m] >= gantry.at[m];
    gantry.since[m] = now != gantry.was[m] ? 0 : gantry.since[m] + 1;
    gantry.was[m] = now;
    return gantry.since[m] < gantry.bounce ? (uint32_t)(draw(0.0, 2.0)) : now;
}

static void tick(void)
{
    const uint32_t pins = read_one(0) << HAL_IN_HOME | read_one(1) << HAL_IN_SECOND;
    (void)inputs_tick(&gantry.inputs, pins);
    (void)nck_tick(&gantry.nck, &gantry.pose, &gantry.axes);
    const int told = nck_places(&gantry.nck) != gantry.places;
    const double way = told ? 0.0 : (double)(gantry.axes.joint_nm[X] - gantry.told_nm) * 1e-6;
    for (uint32_t m = 0; m < 2; m++) {
        if (!(gantry.inputs.held >> m & 1u)) gantry.motor[m] += way;
    }
    gantry.told_nm = gantry.axes.joint_nm[X];
    gantry.places = nck_places(&gantry.nck);
}

static int rests(void)
{
    nck_queue_t queue;
    nck_queue(&gantry.nck, &queue);
    return nck_is_idle(&gantry.nck) && queue.segs + queue.smooth + queue.text == 0;
}

static inputs_result_t home(void)
{
    inputs_result_t result = INPUTS_GOES;
    if (inputs_home(&gantry.inputs) != NCK_OK) return INPUTS_NOT;
    for (int n = 0; n < TICKS_MOST && result == INPUTS_GOES; n++) {
        for (int k = 0; k < PREP && nck_prep(&gantry.nck) == NCK_OK; k++) continue;
        result = inputs_step(&gantry.inputs, rests());
        tick();
    }
    return result;
}

static void build(void)
{
    nck_machine_t machine;
    memset(&gantry, 0, sizeof gantry);
    nck_machine_default(&machine);
    machine.slope = draw(0.0, 1.0) < 0.5 ? NCK_SLOPE_LINEAR : NCK_SLOPE_JERK;
    machine.axis[X].min_nm = -150000000;
    machine.axis[X].max_nm = 150000000;
    (void)nck_init(&gantry.nck, &machine, NULL);
    (void)nck_begin_session(&gantry.nck, &gantry.room);
    inputs_init(&gantry.inputs, &gantry.nck);
    gantry.inputs.set.order = X + 1;
    gantry.inputs.set.pair = X + 1;
    gantry.inputs.set.skew = 6.0;
    gantry.inputs.set.seek = draw(500.0, 3000.0);
    gantry.inputs.set.feed = draw(20.0, 100.0);
    gantry.inputs.set.pull_off = draw(1.0, 4.0);
    gantry.wired[0] = gantry.wired[1] = 1;
    gantry.bounce = (uint32_t)draw(0.0, 5.0);
    for (int m = 0; m < 2; m++) {
        gantry.motor[m] = draw(-2.0, 2.0);
        gantry.at[m] = draw(8.0, 10.0);
        gantry.since[m] = TICKS_MOST;
    }
}

static void both_motors_stand_as_far_from_their_switches(check_t *check)
{
    for (uint32_t k = 0; k < count; k++) {
        seed = first + k;
        build();
        const double step = gantry.inputs.set.feed / 60e3 * (gantry.bounce + 1.0) + 2e-6;
        const inputs_result_t result = home();
        CHECK_INT(check, result, INPUTS_DONE);
        for (int m = 0; m < 2; m++) {
            const double off = gantry.at[m] - gantry.motor[m] - gantry.inputs.set.pull_off;
            if (!CHECK(check, fabs(off) <= step)) printf("gantry %u: %g mm\n", first + k, off);
        }
        CHECK(check, gantry.inputs.held == 0 && nck_invariants(&gantry.nck) == 0);
    }
}

static void a_switch_that_is_not_there_ends_it(check_t *check)
{
    for (int m = 0; m < 2; m++) {
        seed = 77;
        build();
        gantry.wired[m] = 0;
        CHECK_INT(check, home(), INPUTS_RACKED);
        CHECK(check, fabs(gantry.motor[0] - gantry.motor[1]) < 12.0);
        CHECK_INT(check, gantry.inputs.held, 0);
    }
    seed = 77;
    build();
    gantry.wired[0] = gantry.wired[1] = 0;
    CHECK_INT(check, home(), INPUTS_MISSED);
}

static void one_that_is_at_its_switch_goes_off_it_first(check_t *check)
{
    seed = 5;
    build();
    gantry.motor[1] = gantry.at[1] + 0.5;
    gantry.motor[0] = gantry.at[0] - 2.0;
    CHECK_INT(check, home(), INPUTS_DONE);
    const double skew = gantry.at[0] - gantry.motor[0] - gantry.at[1] + gantry.motor[1];
    CHECK(check, fabs(skew) <= gantry.inputs.set.feed / 60e3 * (gantry.bounce + 1.0) + 2e-6);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, both_motors_stand_as_far_from_their_switches);
    CHECK_RUN(&check, a_switch_that_is_not_there_ends_it);
    CHECK_RUN(&check, one_that_is_at_its_switch_goes_off_it_first);
    return check_end(&check);
}
