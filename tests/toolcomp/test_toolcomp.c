// SPDX-License-Identifier: MIT
// Radius compensation through the front door: what waits in its ring is executed, to the last.
#include "front_check.h"

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

static void a_gouge_ends_the_path_before_it(check_t *check) {
    nck_diagnostic_t found;
    begin();
    run("G41.1 D6\nG1 X0 Y10 F900\nX20\nY8\nX22\nY10\nX40\nG40\nM2\n");
    CHECK_INT(check, front.error, NCK_OK);
    CHECK_INT(check, nck_diagnostic(&front.nck, &found), NCK_OK);
    CHECK_INT(check, found.code, NCK_NOTE_COMP_LEFT);
    begin();
    run("G41.1 D6\nG1 X0 Y10 F900\nX20\nY0\nX10\nY-30\nX40\nY0\nX24\nY10\nX40\nG40\nM2\n");
    CHECK_INT(check, front.error, NCK_E_COMP_GOUGE);
    CHECK(check, front_x(&front) > 19.0 && front_x(&front) < 23.1);
    CHECK_INT(check, nck_diagnostic(&front.nck, &found), NCK_OK);
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

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, the_end_of_a_program_executes_what_waits);
    CHECK_RUN(&check, a_mistake_behind_it_executes_what_waits);
    CHECK_RUN(&check, a_gouge_ends_the_path_before_it);
    CHECK_RUN(&check, another_program_begins_without_it);
    CHECK_RUN(&check, the_ring_gives_as_it_is_fed);
    return check_end(&check);
}
