// SPDX-License-Identifier: MIT
// Radius compensation through the front door: what waits in its ring is executed, to the last.
#include "front_check.h"
#include "nck/base/trig_math.h" // NCK_PI

static front_t front;
static nck_toolcomp_t room;

static void begin(void) {
    front_machine(&front, NCK_SLOPE_JERK);
    (void)front_start(&front);
}

static void run(const char *text) {
    front_push(&front, text);
    nck_end(&front.nck);
    front_rest(&front);
}

// Without G40 the tool stays where compensation has left it.
static void the_end_of_a_program_executes_what_waits(check_t *check) {
    begin();
    run("G41.1 D4\nG1 X0 Y10 F900\nX20\nM8\nY0\nM2\n");
    CHECK_INT(check, front.status, NCK_DONE);
    CHECK_INT(check, front.error, NCK_OK);
    CHECK_NEAR(check, front_x(&front), 22.0, 1e-9);
    CHECK_INT(check, front.outputs, 2);
}

static void a_mistake_behind_it_executes_what_waits(check_t *check) {
    begin();
    run("G41.1 D4\nG1 X0 Y10 F900\nX20\nY0\nG1 X1 X2\nM2\n");
    CHECK_INT(check, front.error, NCK_E_WORD_TWICE);
    CHECK_NEAR(check, front_x(&front), 22.0, 1e-9);
}

// The first finding is of the way to the contour: straight on, by less than a quarter of a
// millimetre.
static nck_diagnostic_t found_behind_the_way(check_t *check, double deep) {
    nck_diagnostic_t found = {0};
    CHECK_INT(check, nck_diagnostic(&front.nck, &found), NCK_OK);
    CHECK_INT(check, found.code, NCK_NOTE_COMP_WAY);
    CHECK_NEAR(check, found.value, deep, 1e-9);
    CHECK_INT(check, nck_diagnostic(&front.nck, &found), NCK_OK);
    return found;
}

static void a_gouge_ends_the_path_before_it(check_t *check) {
    const double deep = 3.0 * (1.0 - 10.0 / nck_sqrt(109.0));
    nck_diagnostic_t found;
    begin();
    run("G41.1 D6\nG1 X0 Y10 F900\nX20\nY8\nX22\nY10\nX40\nG40\nM2\n");
    CHECK_INT(check, front.error, NCK_OK);
    found = found_behind_the_way(check, deep);
    CHECK_INT(check, found.code, NCK_NOTE_COMP_LEFT);
    begin();
    run("G41.1 D6\nG1 X0 Y10 F900\nX20\nY0\nX10\nY-30\nX40\nY0\nX24\nY10\nX40\nG40\nM2\n");
    CHECK_INT(check, front.error, NCK_E_COMP_GOUGE);
    CHECK(check, front_x(&front) > 19.0 && front_x(&front) < 23.1);
    found = found_behind_the_way(check, deep);
    CHECK_NEAR(check, found.value, 2.0, 1e-9);
}

static void another_program_begins_without_it(check_t *check) {
    begin();
    run("G41.1 D4\nG1 X0 Y10 F900\nX20\nM2\n");
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    run("G0 X5 Y5\nG2 X7 R1 F900\nM2\n");
    CHECK_INT(check, front.error, NCK_OK);
    CHECK_NEAR(check, front_x(&front), 7.0, 1e-9);
}

// Behind a change of tool the way in was lost: the wait told where it led to, and it did not move.
// The second time the tool is in already.
static void a_program_that_begins_in_the_middle_cuts_where_the_whole_one_does(check_t *check) {
    static const char text[] = "T2 M6\nG0 X10 Y20 Z5\nG1 Z-1\nX40\nG41.1 D4 Y40\nX80\nG40\nM2\n";
    for (uint32_t line = 1; line <= 8; line++) {
        front_machine(&front, NCK_SLOPE_JERK);
        front.machine.axis[NCK_AXIS_Z].max_nm = 30000000;
        front.machine.dialect.from_line = line;
        (void)front_start(&front);
        for (int again = 0; again < 2; again++) {
            run(text);
            CHECK_INT(check, front.state == NCK_TICK_WAIT, again == 0 || line == 1);
            nck_resume(&front.nck);
            front_rest(&front);
            CHECK_INT(check, front.error, NCK_OK);
            CHECK_NEAR(check, front_x(&front), 80.0, 1e-9);
            CHECK_NEAR(check, front.pose.axis[NCK_AXIS_Y], 42.0, 1e-9);
            CHECK_NEAR(check, front.pose.axis[NCK_AXIS_Z], -1.0, 1e-9);
            CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
        }
    }
}

static void a_way_in_without_a_height_is_refused(check_t *check) {
    front_machine(&front, NCK_SLOPE_JERK);
    front.machine.dialect.from_line = 2;
    (void)front_start(&front);
    run("G1 X10\nX20\nM2\n");
    CHECK_INT(check, front.error, NCK_E_APPROACH);
    CHECK_NEAR(check, front_x(&front), 0.0, 1e-9);
}

static nck_block_t line_to(double x, double y, uint32_t line) {
    nck_block_t block;
    memset(&block, 0, sizeof block);
    block.kind = NCK_BLOCK_LINE;
    block.line = line;
    block.plane = 17;
    block.target_nm[0] = (int64_t)(x * 1e6);
    block.target_nm[1] = (int64_t)(y * 1e6);
    block.feed = 100.0;
    return block;
}

// Pull whatever is given: how many, and whether lines come in order.
static int pull_all(check_t *check, uint32_t *line) {
    nck_block_t block;
    int given = 0;
    while (nck_toolcomp_pull(&room, &block) == NCK_OK) {
        CHECK(check, block.line >= *line);
        *line = block.line;
        given++;
        CHECK(check, nck_toolcomp_invariants(&room));
    }
    return given;
}

// A right angle away from the tool at either end of a contour from (0, 0) to (0, −9): how many
// moves come of it, and where the first one ends.
static void begins_and_ends(check_t *check, nck_comp_start_t start, int moves, double x, double y) {
    static nck_machine_t machine;
    const double ends[3][2] = {{0.0, 0.0}, {0.0, -9.0}, {-9.0, -9.0}};
    nck_block_t block = line_to(-9.0, 0.0, 0);
    nck_block_t first = block;
    int given = 0;
    nck_machine_default(&machine);
    nck_toolcomp_init(&room, &machine);
    block.kind = NCK_BLOCK_COMP;
    block.output.value = 1.0;
    block.output.number = start;
    CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
    for (uint32_t k = 0; k < 3; k++) {
        if (k == 2) { // G40
            block.output.value = 0.0;
            block.kind = NCK_BLOCK_COMP;
            CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
            while (nck_toolcomp_pull(&room, &block) == NCK_OK) {
                if (given++ == 0) first = block;
            }
            CHECK(check, !nck_toolcomp_is_on(&room));
        }
        block = line_to(ends[k][0], ends[k][1], k + 1);
        given += nck_toolcomp_push(&room, &block) == NCK_OK;
        CHECK(check, nck_toolcomp_invariants(&room));
    }
    while (nck_toolcomp_pull(&room, &block) == NCK_OK) given++;
    CHECK(check, nck_toolcomp_invariants(&room) && !nck_toolcomp_is_on(&room));
    CHECK_INT(check, given, moves);
    CHECK_NEAR(check, (double)first.target_nm[0] * 1e-6, x, 1e-9);
    CHECK_NEAR(check, (double)first.target_nm[1] * 1e-6, y, 1e-9);
    CHECK_NEAR(check, (double)block.target_nm[0] * 1e-6, -9.0, 1e-9);
    CHECK_NEAR(check, (double)block.target_nm[1] * 1e-6, -9.0, 1e-9);
}

// Two arcs about the corners, one, none.
static void it_begins_and_ends_as_the_block_says(check_t *check) {
    begins_and_ends(check, NCK_COMP_START_OPEN, 4, 0.0, 1.0);
    begins_and_ends(check, NCK_COMP_START_RS274, 4, 0.0, 1.0);
    begins_and_ends(check, NCK_COMP_START_A, 3, 1.0, 0.0);
    begins_and_ends(check, NCK_COMP_START_B, 5, 0.0, 1.0);
}

// Many more blocks than fit: none is lost, and none comes before what follows it is known.
static void the_ring_gives_as_it_is_fed(check_t *check) {
    static nck_machine_t machine;
    uint32_t line = 0;
    int given = 0, held = 0;
    nck_machine_default(&machine);
    nck_toolcomp_init(&room, &machine);
    nck_block_t block = line_to(0.0, 0.0, 0);
    block.kind = NCK_BLOCK_COMP;
    block.output.value = 1.0;
    CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
    for (uint32_t k = 1; k <= 4 * NCK_COMP_ROWS; k++) {
        block = line_to(5.0 * k, k % 4 < 2 ? 0.0 : 3.0, k);
        if (k % 5 == 0) block.kind = NCK_BLOCK_OUTPUT;
        CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
        given += pull_all(check, &line);
        held += line == 0;
    }
    CHECK(check, held >= NCK_COMP_ROWS / 2 && held < NCK_COMP_ROWS);
    nck_toolcomp_end(&room);
    given += pull_all(check, &line);
    CHECK(check, given >= 4 * NCK_COMP_ROWS);
    CHECK_INT(check, line, 4 * NCK_COMP_ROWS);
    CHECK(check, !nck_toolcomp_is_on(&room));
}

// A contour of 10 mm along X, the tool left of it; the ring is filled until that is given, and the
// next one comes. Returns what comes of pushing it.
static nck_status_t go_on_behind(check_t *check, nck_block_kind_t first, nck_block_t next) {
    static nck_machine_t machine;
    uint32_t line = 0;
    nck_machine_default(&machine);
    nck_toolcomp_init(&room, &machine);
    nck_block_t block = line_to(-9.0, 0.0, 0);
    block.kind = NCK_BLOCK_COMP;
    block.output.value = 1.0;
    CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
    for (uint32_t k = 1; k <= NCK_COMP_ROWS + 4; k++) {
        block = line_to(10.0, 0.0, k);
        if (k == 1) block = line_to(0.0, 0.0, 1);
        if (k == 2) block.kind = (uint8_t)first;
        if (k > 2) block.kind = NCK_BLOCK_OUTPUT;
        CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
        (void)pull_all(check, &line);
    }
    return nck_toolcomp_push(&room, &next);
}

// What is given cannot be cut short: straight on the tool dips in by 1 − cos of the angle.
static void an_inside_corner_behind_what_is_given_is_refused(check_t *check) {
    static const double ends[][3] = {{10.0, 5.0, 1.0}, {20.0, 0.6, 1.7955e-3}, {20.0, 0.3, 0.0},
                                     {20.0, 0.0, 0.0}, {10.0, -5.0, 0.0}, {0.0, 0.0, 0.0}};
    nck_diagnostic_t found;
    nck_block_t block;
    for (int k = 0; k < 6; k++) {
        const double dip = ends[k][2];
        const nck_block_t next = line_to(ends[k][0], ends[k][1], 9999);
        const nck_status_t status = go_on_behind(check, NCK_BLOCK_LINE, next);
        CHECK_INT(check, status, dip > 0.0 ? NCK_E_COMP_GOUGE : NCK_EMPTY);
        if (status == NCK_EMPTY) continue;
        do CHECK_INT(check, nck_toolcomp_diagnostic(&room, &found), NCK_OK);
        while (found.code == NCK_NOTE_COMP_WAY);
        CHECK_INT(check, found.code, NCK_E_COMP_GOUGE);
        CHECK_NEAR(check, found.value, dip, 1e-5);
        CHECK_NEAR(check, found.limit, 9999.0, 0.0);
        CHECK_INT(check, found.line, 2);
        CHECK(check, !nck_toolcomp_is_on(&room));
        CHECK_INT(check, nck_toolcomp_pull(&room, &block), NCK_EMPTY);
    }
    nck_block_t next = line_to(10.0, 5.0, 9999);
    next.kind = NCK_BLOCK_RAPID; // cuts nothing
    CHECK_INT(check, go_on_behind(check, NCK_BLOCK_LINE, next), NCK_EMPTY);
    next.kind = NCK_BLOCK_LINE;
    CHECK_INT(check, go_on_behind(check, NCK_BLOCK_RAPID, next), NCK_EMPTY);
    next = line_to(10.0, -6.0, 9999); // half a turn to the right, from straight on
    next.kind = NCK_BLOCK_ARC;
    next.centre_mm[0] = 10.0;
    next.centre_mm[1] = -3.0;
    next.sweep_rad = -NCK_PI;
    CHECK_INT(check, go_on_behind(check, NCK_BLOCK_LINE, next), NCK_EMPTY);
    next = line_to(10.0, 6.0, 9999); // … to the left
    next.kind = NCK_BLOCK_ARC;
    next.centre_mm[0] = 10.0;
    next.centre_mm[1] = 3.0;
    next.sweep_rad = NCK_PI;
    CHECK_INT(check, go_on_behind(check, NCK_BLOCK_LINE, next), NCK_EMPTY);
    nck_toolcomp_end(&room);
    CHECK_INT(check, nck_toolcomp_pull(&room, &block), NCK_OK);
    while (block.kind != NCK_BLOCK_ARC) {
        if (nck_toolcomp_pull(&room, &block) != NCK_OK) break;
    }
    CHECK_NEAR(check, (double)block.target_nm[1] * 1e-6, 5.0, 1e-9);
    CHECK_NEAR(check, block.sweep_rad, NCK_PI, 1e-9);
}

// The move behind G40 leads through a contour: as long as the ring has that, it is refused.
static void a_way_out_is_held_against_what_the_ring_has(check_t *check) {
    static nck_machine_t machine;
    nck_machine_default(&machine);
    for (uint32_t others = 0; others <= NCK_COMP_ROWS; others++) {
        uint32_t line = 0;
        nck_toolcomp_init(&room, &machine);
        nck_block_t block = line_to(0.0, 0.0, 0);
        block.kind = NCK_BLOCK_COMP;
        block.output.value = 1.0;
        CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
        for (uint32_t k = 1; k <= others + 2; k++) {
            block = line_to(k == 1 ? 10.0 : 20.0, 0.0, k);
            if (k > 2) block.kind = NCK_BLOCK_OUTPUT;
            CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
            (void)pull_all(check, &line);
        }
        block.kind = NCK_BLOCK_COMP;
        block.output.value = 0.0;
        CHECK_INT(check, nck_toolcomp_push(&room, &block), NCK_EMPTY);
        (void)pull_all(check, &line);
        block = line_to(5.0, -2.0, 9999);
        const nck_status_t want = others + 2 <= NCK_COMP_ROWS ? NCK_E_COMP_GOUGE : NCK_OK;
        CHECK_INT(check, nck_toolcomp_push(&room, &block), want);
    }
}

static void its_invariants_tell_what_is_broken(check_t *check) {
    static nck_machine_t machine;
    static const struct {
        uint8_t phase, open;
        uint32_t waiting;
        double radius;
        int holds;
    } rows[] = {
        {NCK_COMP_OFF, 0, 0, 0.0, 1},           {NCK_COMP_OFF, 1, 0, 1.0, 0},
        {NCK_COMP_OFF, 0, 1, 1.0, 0},           {NCK_COMP_ON, 1, NCK_COMP_ROWS, 0.1, 1},
        {NCK_COMP_ON, 1, 1, 0.0, 0},            {NCK_COMP_ON, 0, NCK_COMP_ROWS + 1, 1.0, 0},
        {NCK_COMP_LEAVES, 1, 1, 1.0, 1},        {NCK_COMP_LEAVES + 1, 1, 1, 1.0, 0},
    };
    nck_machine_default(&machine);
    for (unsigned k = 0; k < sizeof rows / sizeof *rows; k++) {
        nck_toolcomp_init(&room, &machine);
        room.phase = rows[k].phase;
        room.walk.open = rows[k].open;
        room.ring.head = rows[k].waiting;
        room.radius = rows[k].radius;
        CHECK_INT(check, nck_toolcomp_invariants(&room), rows[k].holds);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, the_end_of_a_program_executes_what_waits);
    CHECK_RUN(&check, a_mistake_behind_it_executes_what_waits);
    CHECK_RUN(&check, a_gouge_ends_the_path_before_it);
    CHECK_RUN(&check, another_program_begins_without_it);
    CHECK_RUN(&check, a_program_that_begins_in_the_middle_cuts_where_the_whole_one_does);
    CHECK_RUN(&check, a_way_in_without_a_height_is_refused);
    CHECK_RUN(&check, it_begins_and_ends_as_the_block_says);
    CHECK_RUN(&check, the_ring_gives_as_it_is_fed);
    CHECK_RUN(&check, an_inside_corner_behind_what_is_given_is_refused);
    CHECK_RUN(&check, a_way_out_is_held_against_what_the_ring_has);
    CHECK_RUN(&check, its_invariants_tell_what_is_broken);
    return check_end(&check);
}
