// SPDX-License-Identifier: MIT
// Offsets and tools are read and written as a whole, at rest, and the travel is heeded or not.
#include "front_check.h"

static front_t front;
static front_t other;
static nck_decode_t before;
static nck_decode_t before_other;

static void begin(front_t *self, nck_decode_t *room)
{
    front_machine(self, NCK_SLOPE_JERK);
    self->machine.tool_count = 2;
    self->machine.tool[0].number = 3;
    self->machine.tool[0].offset_nm[2] = 5000000;
    self->machine.tool[1].number = 4;
    (void)front_start(self);
    (void)nck_begin_session(&self->nck, room);
}

static void run(front_t *self, const char *text)
{
    front_push(self, text);
    nck_flush(&self->nck);
    front_rest(self);
}

static const char all[] = "G10 L2 P1 X1 Y2 Z3\nG10 L2 P9 X-4\nG1 X7 F900\nG28.1\nG30.1\nG92 Y-2\n"
                          "T4\nM6 T3\nG43 H3\nG59.3\n";

// What one machine has told is in force in another: the same words lead to the same place.
static void what_was_told_can_be_given_back(check_t *check)
{
    nck_modal_t told, again;
    begin(&front, &before);
    begin(&other, &before_other);
    run(&front, all);
    for (int n = 0; n < 4 && front.state == NCK_TICK_WAIT; n++) {
        nck_resume(&front.nck);
        front_rest(&front);
    }
    front_rest(&front);
    nck_modal(&front.nck, &told);
    CHECK_INT(check, told.work_system, 8);
    CHECK_INT(check, told.tool_nm[2], 5000000);
    CHECK_INT(check, nck_modal_set(&other.nck, &told), NCK_OK);
    nck_modal(&other.nck, &again);
    CHECK(check, memcmp(told.origin_nm, again.origin_nm, sizeof told.origin_nm) == 0);
    CHECK(check, memcmp(told.systems_nm, again.systems_nm, sizeof told.systems_nm) == 0);
    CHECK(check, memcmp(told.home_nm, again.home_nm, sizeof told.home_nm) == 0);
    CHECK_INT(check, again.tool_in, told.tool_in);
    CHECK_INT(check, again.tool_next, told.tool_next);
    run(&front, "G90 G1 X1 Y1 Z1 F900\nG92.3\nG54 X2\n");
    run(&other, "G90 G1 X1 Y1 Z1 F900\nG92.3\nG54 X2\n");
    for (uint32_t k = 0; k < 3; k++) {
        CHECK_INT(check, other.axes.joint_nm[k], front.axes.joint_nm[k]);
    }
    CHECK_INT(check, nck_invariants(&other.nck), 0);
}

// Straight lines behind it go by the new zero, too.
static void the_next_plain_line_knows_it(check_t *check)
{
    nck_modal_t modal;
    begin(&front, &before);
    run(&front, "G90 G1 X1 F900\nX2\nX3\n");
    nck_modal(&front.nck, &modal);
    modal.systems_nm[0][0] = 10000000;
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_OK);
    run(&front, "X4\n");
    CHECK_INT(check, front.axes.joint_nm[0], 14000000);
}

static void it_is_refused_in_motion_and_out_of_range(check_t *check)
{
    nck_modal_t modal, now;
    nck_tool_t tool = {0};
    begin(&front, &before);
    nck_modal(&front.nck, &modal);
    tool.number = 4;
    front_push(&front, "G1 X20 F900\n");
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_E_STATE);
    for (int n = 0; n < 100; n++) front_tick(&front);
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_E_STATE);
    CHECK_INT(check, nck_tool_set(&front.nck, &tool), NCK_E_STATE);
    CHECK_INT(check, nck_heed_travel(&front.nck, 0), NCK_E_STATE);
    nck_flush(&front.nck);
    front_rest(&front);
    modal.systems_nm[3][1] = INT64_MAX;
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_E_ARGUMENT);
    modal.systems_nm[3][1] = 0;
    modal.work_system = NCK_WORK_SYSTEMS;
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_E_ARGUMENT);
    modal.work_system = 0;
    modal.tool_in = 99;
    CHECK_INT(check, nck_modal_set(&front.nck, &modal), NCK_E_TOOL_UNKNOWN);
    nck_modal(&front.nck, &now);
    CHECK_INT(check, now.tool_in, 0);
    tool.orientation = 10;
    CHECK_INT(check, nck_tool_set(&front.nck, &tool), NCK_E_ARGUMENT);
}

static void a_tool_is_put_into_the_table(check_t *check)
{
    nck_tool_t tool = {0};
    begin(&front, &before);
    if (NCK_HAS_VARIABLES) run(&front, "G10 L1 P3 Z6 R2\n");
    CHECK_INT(check, nck_tool_of(&front.nck, 3, &tool), NCK_OK);
    CHECK_INT(check, tool.offset_nm[2], NCK_HAS_VARIABLES ? 6000000 : 5000000);
    tool.offset_nm[2] = 8000000;
    CHECK_INT(check, nck_tool_set(&front.nck, &tool), NCK_OK);
    tool.number = 77;
    tool.offset_nm[2] = 9000000;
    CHECK_INT(check, nck_tool_of(&front.nck, 77, &tool), NCK_E_TOOL_UNKNOWN);
    CHECK_INT(check, nck_tool_set(&front.nck, &tool), NCK_OK);
    run(&front, "G43 H3 G0 Z0\n");
    CHECK_INT(check, front.axes.joint_nm[2], 8000000);
    run(&front, "G43 H77 Z0\n");
    CHECK_INT(check, front.axes.joint_nm[2], 9000000);
    for (uint32_t k = 100; k < 100 + NCK_TOOL_MAX; k++) {
        tool.number = k;
        const int fits = k - 100 + 3 < NCK_TOOL_MAX;
        CHECK_INT(check, nck_tool_set(&front.nck, &tool), fits ? NCK_OK : NCK_E_ARGUMENT);
    }
    tool.number = 0;
    CHECK_INT(check, nck_tool_set(&front.nck, &tool), NCK_E_ARGUMENT);
}

static void the_travel_is_heeded_or_not(check_t *check)
{
    front_machine(&front, NCK_SLOPE_JERK);
    front.machine.axis[0].max_nm = 10000000;
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    run(&front, "G1 X11 F900\n");
    CHECK_INT(check, front.axes.joint_nm[0], 0);
    CHECK_INT(check, nck_heed_travel(&front.nck, 0), NCK_OK);
    run(&front, "G1 X11 F900\nG2 X12 Y0 R2\n");
    CHECK_INT(check, front.axes.joint_nm[0], 12000000);
    CHECK_INT(check, nck_heed_travel(&front.nck, 1), NCK_OK);
    run(&front, "G1 X13 F900\n");
    CHECK_INT(check, front.axes.joint_nm[0], 12000000);
    run(&front, "G1 X3 F900\n");
    CHECK_INT(check, front.axes.joint_nm[0], 3000000);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, what_was_told_can_be_given_back);
    CHECK_RUN(&check, the_next_plain_line_knows_it);
    CHECK_RUN(&check, it_is_refused_in_motion_and_out_of_range);
    CHECK_RUN(&check, a_tool_is_put_into_the_table);
    CHECK_RUN(&check, the_travel_is_heeded_or_not);
    return check_end(&check);
}
