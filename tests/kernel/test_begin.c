// SPDX-License-Identifier: MIT
// After the end, an abort or an error the kernel goes on from where the axes rest.
#include "front_check.h"

static front_t front;
static front_t fresh;

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    (void)front_start(&front);
}

static void run(front_t *self, const char *text)
{
    front_push(self, text);
    nck_end(&self->nck);
    front_rest(self);
}

static void until_beyond(double x)
{
    for (int n = 0; n < FRONT_TICKS && front_x(&front) < x; n++) front_tick(&front);
}

static const char *const program =
    "G64 P0.01\nG1 X3 F900\nY4 X6\nG3 X0 I-3\nG4 P0.05\nG0 X-5\nM2\n";

// What rooms have left in their memory counts for nothing.
static void spoil_rooms(void)
{
    memset(&front.nck.smooth, 0xA5, sizeof front.nck.smooth);
    memset(&front.nck.lookahead, 0xA5, sizeof front.nck.lookahead);
    memset(&front.nck.slope, 0xA5, sizeof front.nck.slope);
}

// The same setpoints as of a new kernel whose axes stand there.
static void it_goes_on_as_a_new_kernel_there(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        run(&front, "G1 X12.3456 Y-7 Z1\nM30\n");
        CHECK_INT(check, front.status, NCK_DONE);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        front_tick(&front);
        spoil_rooms();
        front.hash = 0;
        front.moving = 0;
        run(&front, program);
        front_machine(&fresh, slope);
        fresh.machine.start_nm[NCK_AXIS_X] = 12345600;
        fresh.machine.start_nm[NCK_AXIS_Y] = -7000000;
        fresh.machine.start_nm[NCK_AXIS_Z] = 1000000;
        (void)front_start(&fresh);
        run(&fresh, program);
        CHECK(check, front.hash == fresh.hash && front.moving == fresh.moving);
        CHECK(check, fresh.moving > 0);
        CHECK_NEAR(check, front_x(&front), -5.0, 1e-9);
    }
}

// Offsets stay, modes are the machine's again.
static void offsets_stay_and_modes_do_not(check_t *check)
{
    nck_modal_t modal;
    front_machine(&front, NCK_SLOPE_JERK);
    front.machine.tool_count = 1;
    front.machine.tool[0].number = 3;
    front.machine.tool[0].offset_nm[2] = 50000000;
    (void)front_start(&front);
    run(&front, "G10 L2 P2 X100\nG55 G43 H3 T3 M6\nG1 Z0\nG92 Y-10\n"
                "G91 G20 G18 G95 G61.1 S100\nM2\n");
    nck_resume(&front.nck);
    front_rest(&front);
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    nck_modal(&front.nck, &modal);
    CHECK_INT(check, modal.work_system, 1);
    CHECK_INT(check, modal.work_nm[NCK_AXIS_X], 100000000);
    CHECK_INT(check, modal.g92_nm[NCK_AXIS_Y], 10000000);
    CHECK_INT(check, modal.tool_nm[2], 50000000);
    CHECK_INT(check, modal.position_nm[2], 50000000);
    CHECK_INT(check, modal.tool_in, 3);
    CHECK_INT(check, modal.plane, 17);
    CHECK(check, !modal.incremental && !modal.inch && modal.feed_mode == NCK_FEED_PER_MINUTE);
    CHECK(check, modal.path_mode == NCK_PATH_CONTINUOUS && modal.spindle_rpm == 0.0);
    run(&front, "G1 X1 Y1 Z2\nM2\n");
    CHECK_NEAR(check, front_x(&front), 101.0, 1e-9);
    CHECK_NEAR(check, front_y(&front), 11.0, 1e-9);
    CHECK_NEAR(check, (double)front.axes.joint_nm[2] * 1e-6, 52.0, 1e-9);
}

// Behind nck_begin the tick has nothing to do until prep has begun anew, whatever an abort dropped.
static void it_is_idle_until_prep_begins_anew(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    front_push(&front, "G1 F3000 X60\nX90\nM8\nX10\n");
    nck_flush(&front.nck);
    until_beyond(20.0);
    CHECK(check, !nck_is_idle(&front.nck));
    nck_abort(&front.nck);
    front_rest(&front);
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    for (int n = 0; n < 3; n++) {
        CHECK_INT(check, nck_tick(&front.nck, &front.pose, &front.axes), NCK_TICK_IDLE);
        CHECK(check, nck_is_idle(&front.nck));
    }
    front_push(&front, "G1 X5\n");
    nck_flush(&front.nck);
    front_prep(&front);
    CHECK(check, !nck_is_idle(&front.nck));
}

// While the tick moves, and before the end is executed, it is refused and nothing is changed.
static void it_is_refused_before_the_end(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
        front_push(&front, "G1 X5\n");
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
        nck_end(&front.nck);
        front_prep(&front);
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
        until_beyond(2.0);
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
        nck_abort(&front.nck);
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
        front_rest(&front);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        CHECK_INT(check, nck_begin(&front.nck), NCK_E_STATE);
    }
}

// An abort drops the rest of the program, outputs too, and the axes go on from where they rest.
static void after_an_abort_it_goes_on_from_the_rest(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        front_push(&front, "G92 X10\nG1 F3000 X60 Y1\nX90\n");
        front_push(&front, "M8\nX10 Y0\n");
        nck_flush(&front.nck);
        until_beyond(20.0);
        nck_abort(&front.nck);
        front_rest(&front);
        const double x = front_x(&front);
        CHECK(check, x > 20.0 && x < 79.9);
        CHECK_INT(check, front.state, NCK_TICK_HOLD);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        front_tick(&front);
        CHECK_INT(check, front.state, NCK_TICK_IDLE);
        CHECK_NEAR(check, front_x(&front), x, 0.0);
        front.step_most = 0.0;
        run(&front, "G91 G1 X-1.5\nM7\n");
        CHECK_NEAR(check, front_x(&front), x - 1.5, 1e-9);
        CHECK_INT(check, front.outputs, 2);
        CHECK_NEAR(check, front.output[0].value, 7.0, 0.0);
        CHECK(check, front.step_most <= 0.2 && front.error == NCK_OK);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        run(&front, "G1 X12\n"); // G92 is in force still
        CHECK_NEAR(check, front_x(&front), 2.0, 1e-9);
    }
}

// Again and again, with the rings full of what was dropped.
static void it_can_be_done_for_ever(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        for (int n = 0; n < 40; n++) {
            const double x = front_x(&front);
            for (int k = 0; k < 40; k++) {
                front_push(&front, "G91 G1 X1\n");
                front_push(&front, "S1\nS2\nX-1 Y0.1\n");
            }
            for (int k = 0; k < 7 * n; k++) front_tick(&front);
            nck_abort(&front.nck);
            front_rest(&front);
            CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
            CHECK(check, fabs(front_x(&front) - x) <= 1.0);
        }
        run(&front, "G1 X5 Y5\nM2\n");
        CHECK(check, fabs(front_x(&front) - 5.0) < 1e-9 && fabs(front_y(&front) - 5.0) < 1e-9);
        CHECK_INT(check, front.status, NCK_DONE);
    }
}

// A WAIT that was aborted waits no longer, an error is over, a hold is.
static void what_kept_it_is_over(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        front_push(&front, "G1 X1\nM0\nG1 X2\n");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_INT(check, front.state, NCK_TICK_WAIT);
        nck_abort(&front.nck);
        front_rest(&front);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        front_push(&front, "G1 X3\nG1 X\n");
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front), 3.0, 1e-9);
        CHECK_INT(check, front.error, NCK_E_NUMBER);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        nck_hold(&front.nck);
        nck_abort(&front.nck);
        front_rest(&front);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        run(&front, "G1 X4\n");
        CHECK_NEAR(check, front_x(&front), 4.0, 1e-9);
    }
}

// Planned without ticks it begins anew just so.
static void it_begins_anew_without_ticks(check_t *check)
{
    nck_cell_t cell;
    double length[2] = {0.0, 0.0};
    begin(NCK_SLOPE_JERK);
    for (int n = 0; n < 2; n++) {
        size_t used = 0;
        nck_status_t status = NCK_OK;
        CHECK_INT(check, nck_push(&front.nck, "G1 X5\n", 6, &used), NCK_OK);
        nck_end(&front.nck);
        for (int k = 0; k < 100000 && status != NCK_DONE; k++) {
            status = nck_prep(&front.nck);
            while (nck_take(&front.nck, &cell) == NCK_OK) length[n] += cell.length;
        }
        front.nck.interpolate.pose.axis[0] = 0.0; // takes move nothing
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    }
    CHECK_NEAR(check, length[0], 5.0, 1e-9);
    CHECK_NEAR(check, length[1], 5.0, 1e-9);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, it_goes_on_as_a_new_kernel_there);
    CHECK_RUN(&check, offsets_stay_and_modes_do_not);
    CHECK_RUN(&check, it_is_idle_until_prep_begins_anew);
    CHECK_RUN(&check, it_is_refused_before_the_end);
    CHECK_RUN(&check, after_an_abort_it_goes_on_from_the_rest);
    CHECK_RUN(&check, it_can_be_done_for_ever);
    CHECK_RUN(&check, what_kept_it_is_over);
    CHECK_RUN(&check, it_begins_anew_without_ticks);
    return check_end(&check);
}
