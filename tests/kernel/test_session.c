// SPDX-License-Identifier: MIT
// A session: an error refuses its line and no more, a jog leaves nothing in force, and the axes may
// be told to stand elsewhere.
//
//     test_session [COUNT [FIRST]]   so many random sessions, from this number on

#include "front_check.h"

enum { LINES = 40, LINE_BYTES = 64 };

static front_t front;
static front_t plain;
static nck_decode_t before;
static nck_decode_t before_plain;
static uint64_t seed, moving;
static uint32_t count = 60, first;

static uint32_t pick(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((seed >> 33) % n);
}

static void begin(front_t *self, nck_decode_t *room, uint32_t slope)
{
    front_machine(self, slope);
    self->machine.tool_count = 1;
    self->machine.tool[0].number = 3;
    self->machine.tool[0].offset_nm[2] = 5000000;
    (void)front_start(self);
    if (room) (void)nck_begin_session(&self->nck, room);
}

static const char *const good[] = {
    "G1 X3 F900", "Y4", "X1 Y2", "G0 X-5", "G3 X0 I2.5", "G2 X3 Y3 R4 F700", "G91", "G90", "G20",
    "G21", "S700 M3", "M5", "G4 P0.01", "G10 L2 P1 X2 Y1", "G92 X1", "G92.1", "T3", "G43 H3", "G49",
    "G18", "G17", "G55", "G54", "M8", "M9", "G64 P0.02", "G61", "#1=2", "G1 X#1",
    "G95 F0.5 S500 M3", "G94 F800", "G1 X2 S800 M4 Y#1", "G28.1", "N10 G1 X1.5 Y-1"
};

static const char *const bad[] = {
    "S1000 M3 G1 X9999999", "G91 G20 G1 X1 Q3", "G10 L2 P1 X5 G1 X", "T99 M6", "G43 H77", "G4 P-1",
    "G92 X1 G1 Q2", "G18 G2 X1", "G55 G3 X1 R0.0001 Y99", "#1=9 G1 X1e", "M3 M4", "G93 G1 X1", "(",
    "G90 G91 X1", "G1 X1 X2", "M98 P5", "S300 M4 F5000 G1 X#<none>", "G21 G0 X-9999999", "!", "E1",
    "G95 F1 M8 S50 G1 Y99999999", "G64 P0.5 G1 X99999999", "o1 endwhile", "G5.2 X1 Y1 P1 L9",
    "G81 X1 Y1", "G1 X[1/0] #1=7", "M8 G83 X1 Z-1 R1", "G53 G91 G1 X1", "M66 P0 L9", "G41 D99"
};

static void line(front_t *self, const char *text)
{
    char with_end[LINE_BYTES];
    const size_t n = strlen(text);
    memcpy(with_end, text, n);
    with_end[n] = '\n';
    with_end[n + 1] = '\0';
    front_push(self, with_end);
}

static uint32_t findings(front_t *self)
{
    nck_diagnostic_t found;
    uint32_t errors = 0;
    while (nck_diagnostic(&self->nck, &found) == NCK_OK) errors += found.code < NCK_OK;
    return errors;
}

// All that is in force but where the axes are to be.
static int same_modes(const front_t *a, const front_t *b)
{
    nck_modal_t one, other;
    nck_modal(&a->nck, &one);
    nck_modal(&b->nck, &other);
    memset(one.position_nm, 0, sizeof one.position_nm);
    memset(other.position_nm, 0, sizeof other.position_nm);
    return memcmp(&one, &other, sizeof one) == 0;
}

static int is_same(check_t *check)
{
    int same = front.hash == plain.hash && front.moving == plain.moving;
    for (uint32_t k = 0; k < front.outputs && k < FRONT_OUTPUTS; k++) {
        same = same && front.output[k].kind == plain.output[k].kind
               && front.output[k].value == plain.output[k].value;
    }
    CHECK_INT(check, front.outputs, plain.outputs);
    CHECK(check, same_modes(&front, &plain));
    CHECK_INT(check, nck_invariants(&front.nck), 0);
    return same;
}

// A session with wrong lines in it gives the setpoints, outputs and modes of the same one without
// them. Some good lines are wrong where they stand: these are wrong in both.
static void check_session(check_t *check, uint32_t number)
{
    uint32_t wrong = 0;
    seed = number;
    const uint32_t slope = pick(2) ? NCK_SLOPE_JERK : NCK_SLOPE_LINEAR;
    begin(&front, &before, slope);
    begin(&plain, &before_plain, slope);
    for (int n = 0; n < LINES; n++) {
        while (pick(3) == 0) {
            line(&front, bad[pick(sizeof bad / sizeof *bad)]);
            wrong++;
        }
        const char *const text = good[pick(sizeof good / sizeof *good)];
        line(&front, text);
        line(&plain, text);
        if (pick(8) == 0) {
            nck_flush(&front.nck);
            nck_flush(&plain.nck);
        }
    }
    nck_flush(&front.nck);
    nck_flush(&plain.nck);
    front_rest(&front);
    front_rest(&plain);
    CHECK(check, wrong > 0 && front.error < NCK_OK);
    moving += plain.moving;
    if (!CHECK(check, is_same(check))) printf("session %u\n", number);
}

static void a_wrong_line_leaves_nothing(check_t *check)
{
    moving = 0; // a few do not move in builds without parameters
    for (uint32_t k = 0; k < count; k++) check_session(check, first + k);
    CHECK(check, moving > count);
}

static void every_wrong_line_is_told_once(check_t *check)
{
    for (uint32_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        begin(&front, &before, NCK_SLOPE_JERK);
        begin(&plain, &before_plain, NCK_SLOPE_JERK);
        line(&front, bad[k]);
        front_prep(&front);
        if (!CHECK(check, findings(&front) == 1)) printf("    %s\n", bad[k]);
        CHECK(check, same_modes(&front, &plain));
        line(&front, "G1 X2");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front), 2.0, 1e-9);
    }
}

static void it_is_a_mode_from_the_beginning(check_t *check)
{
    const nck_source_t source = {"G1 X1\n", 6, NULL, NULL};
    begin(&front, NULL, NCK_SLOPE_JERK);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_E_STATE);
    CHECK_INT(check, nck_leave_nothing(&front.nck), NCK_E_STATE);
    line(&front, "G1 X1");
    CHECK_INT(check, nck_begin_session(&front.nck, &before), NCK_E_STATE);
    begin(&front, &before, NCK_SLOPE_JERK);
    CHECK_INT(check, nck_read(&front.nck, &source), NCK_E_STATE);
}

static void a_jog_leaves_no_mode(check_t *check)
{
    static const char *const jog[] = {"G91 G20 G1 X0.1 F30", "G90 G1 X7 F99", "G53 G1 Y2 F400",
                                      "S99 M3 G18 G1 X1 F5000", "X3 Y1", "G1 X99999999 F1"};
    for (uint32_t k = 0; k < sizeof jog / sizeof *jog; k++) {
        begin(&front, &before, NCK_SLOPE_JERK);
        begin(&plain, &before_plain, NCK_SLOPE_JERK);
        line(&front, "G91 G1 X1 F600");
        line(&front, "X1");
        line(&plain, "G91 G1 X1 F600");
        line(&plain, "X1");
        front_prep(&front);
        front_prep(&plain);
        CHECK_INT(check, nck_leave_nothing(&front.nck), NCK_OK);
        line(&front, jog[k]);
        front_prep(&front);
        CHECK(check, same_modes(&front, &plain));
        line(&front, "X1");
        nck_flush(&front.nck);
        front_rest(&front);
        nck_modal_t modal;
        nck_modal(&front.nck, &modal);
        CHECK_INT(check, modal.position_nm[0], front.axes.joint_nm[0]);
    }
}

// What is checked alone is in force for the next line, and nothing moves.
static void a_check_moves_nothing(check_t *check)
{
    nck_modal_t modal;
    begin(&front, &before, NCK_SLOPE_JERK);
    nck_check_only(&front.nck, 1);
    line(&front, "G91 G1 X5 F600 M8");
    line(&front, "G1 Q3");
    line(&front, "X5 S100 M3");
    nck_flush(&front.nck);
    front_rest(&front);
    nck_modal(&front.nck, &modal);
    CHECK_INT(check, findings(&front), 1);
    CHECK(check, modal.incremental && front.moving == 0 && front.outputs == 0);
    CHECK_INT(check, modal.position_nm[0], 10000000);
    nck_abort(&front.nck);
    front_rest(&front);
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    line(&front, "G91 G1 X2 F600");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 2.0, 1e-9);
}

static void until_beyond(double x)
{
    for (int n = 0; n < FRONT_TICKS && front_x(&front) < x; n++) front_tick(&front);
}

// What an abort dropped is gone, modes are there.
static void it_goes_on_in_the_same_modes(check_t *check)
{
    nck_modal_t modal;
    begin(&front, &before, NCK_SLOPE_JERK);
    line(&front, "G91 G1 X50 F6000");
    line(&front, "X50");
    nck_flush(&front.nck);
    until_beyond(20.0);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_E_STATE);
    nck_abort(&front.nck);
    front_rest(&front);
    const double rest = front_x(&front);
    CHECK(check, rest < 50.0);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
    line(&front, "X2");
    nck_flush(&front.nck);
    front_rest(&front);
    nck_modal(&front.nck, &modal);
    CHECK(check, modal.incremental && modal.feed == 6000.0);
    CHECK_NEAR(check, front_x(&front), rest + 2.0, 1.1e-6);
}

// A dwell that was dropped is not waited for: no more ticks than any rest takes.
static void an_abort_ends_a_dwell(check_t *check)
{
    static const uint32_t slopes[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    for (int k = 0; k < 2; k++) {
        begin(&front, &before, slopes[k]);
        line(&front, "G91 G1 X1 F600");
        line(&front, "G4 P1000");
        line(&front, "X5");
        nck_flush(&front.nck);
        for (int n = 0; n < 3000 && front.state != NCK_TICK_DWELL; n++) front_tick(&front);
        for (int n = 0; n < 100; n++) front_tick(&front);
        CHECK_INT(check, front.state, NCK_TICK_DWELL);
        nck_abort(&front.nck);
        for (int n = 0; n < 20; n++) front_tick(&front);
        CHECK_INT(check, front.state, NCK_TICK_HOLD);
        CHECK_INT(check, nck_is_idle(&front.nck), 1);
        CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
        line(&front, "X2");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front), 3.0, 1e-9);
        CHECK_INT(check, nck_invariants(&front.nck), 0);
    }
}

static void the_axes_can_be_told_to_stand_elsewhere(check_t *check)
{
    int64_t place_nm[NCK_AXIS_MAX] = {-7000000, 0, 3000000};
    begin(&front, &before, NCK_SLOPE_JERK);
    line(&front, "G91 G1 X5 F600");
    CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_E_STATE);
    nck_flush(&front.nck);
    until_beyond(1.0);
    CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_E_STATE);
    front_rest(&front);
    place_nm[1] = INT64_MAX;
    CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_E_ARGUMENT);
    place_nm[1] = 0;
    CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_OK);
    front.hash = 0;
    CHECK_INT(check, nck_places(&front.nck), 1);
    front_tick(&front);
    CHECK_INT(check, nck_places(&front.nck), 2);
    CHECK_INT(check, front.axes.joint_nm[0], -7000000);
    CHECK_INT(check, front.axes.joint_nm[2], 3000000);
    line(&front, "X2");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.axes.joint_nm[0], -5000000);
    CHECK_INT(check, nck_invariants(&front.nck), 0);
}

// Executed follows what is taken, and reaches it at rest; a named line is called so.
static void what_is_executed_is_counted(check_t *check)
{
    nck_queue_t queue;
    uint64_t last = 0;
    int between = 0;
    begin(&front, &before, NCK_SLOPE_JERK);
    nck_name_line(&front.nck, 7000);
    front_push(&front, "G1 X5 F600\nY5\nX0\nY0\n");
    nck_flush(&front.nck);
    for (int n = 0; n < 6000; n++) {
        front_tick(&front);
        nck_queue(&front.nck, &queue);
        CHECK(check, queue.executed >= last && queue.executed <= queue.blocks);
        between += queue.executed > 0 && queue.executed < queue.blocks;
        last = queue.executed;
    }
    CHECK(check, between > 100 && queue.executed == queue.blocks && queue.text == 0);
    CHECK_INT(check, front.line[0], 7000);
    CHECK_INT(check, front.line[front.lines - 1], 7003);
}

// A switch is for what is read from then on: lines with /, /2 and M1.
static void switches_hold_for_lines_to_come(check_t *check)
{
    begin(&front, &before, NCK_SLOPE_JERK);
    line(&front, "G91 G1 X1 F6000");
    line(&front, "/X2");
    CHECK_INT(check, nck_set_switches(&front.nck, 1u << 2, 0), NCK_OK);
    line(&front, "/X4");
    line(&front, "/2X8");
    CHECK_INT(check, nck_set_switches(&front.nck, 1u, 0), NCK_OK);
    line(&front, "/X16");
    CHECK_INT(check, nck_set_switches(&front.nck, 1u << 10, 0), NCK_E_ARGUMENT);
    CHECK_INT(check, nck_set_switches(&front.nck, 0, 2), NCK_E_ARGUMENT);
    line(&front, "/X32");
    line(&front, "M1");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 7.0, 1e-9);
    CHECK_INT(check, nck_set_switches(&front.nck, 0, 1), NCK_OK);
    line(&front, "/M1");
    line(&front, "X1");
    nck_flush(&front.nck);
    for (int n = 0; n < 3000; n++) front_tick(&front);
    CHECK_NEAR(check, front_x(&front), 7.0, 1e-9);
    nck_resume(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 8.0, 1e-9);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, a_wrong_line_leaves_nothing);
    CHECK_RUN(&check, every_wrong_line_is_told_once);
    CHECK_RUN(&check, it_is_a_mode_from_the_beginning);
    CHECK_RUN(&check, a_jog_leaves_no_mode);
    CHECK_RUN(&check, a_check_moves_nothing);
    CHECK_RUN(&check, it_goes_on_in_the_same_modes);
    CHECK_RUN(&check, an_abort_ends_a_dwell);
    CHECK_RUN(&check, the_axes_can_be_told_to_stand_elsewhere);
    CHECK_RUN(&check, what_is_executed_is_counted);
    CHECK_RUN(&check, switches_hold_for_lines_to_come);
    return check_end(&check);
}
