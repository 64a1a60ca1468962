// SPDX-License-Identifier: MIT
// What is in force at the tool: in every period that of the line which the pose tells, as a kernel
// has it that decodes the program up to there and moves nothing.
//
//     test_executed [COUNT [FIRST]]   so many random sessions, from this number on

#include "front_check.h"

enum { LINES = 120, LINE_BYTES = 64 };

static front_t front;
static nck_t decoded;
static nck_decode_t before, before_decoded;
static nck_modal_t known[LINES + 1]; // behind each line; 0: before the first, or of a new begin
static uint32_t lines;               // pushed so far
static uint64_t seed, behind;        // behind: periods in which the interpreter was further on
static uint32_t count = 60, first;

static uint32_t pick(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((seed >> 33) % n);
}

// All but what the feed, the spindle's speed and places are.
static int same_modes(const nck_modal_t *a, const nck_modal_t *b)
{
    return a->motion == b->motion && a->plane == b->plane && a->inch == b->inch
           && a->diameter == b->diameter && a->incremental == b->incremental
           && a->feed_mode == b->feed_mode && a->path_mode == b->path_mode
           && a->spindle_on == b->spindle_on && a->spindle_code == b->spindle_code
           && a->coolant == b->coolant && a->work_system == b->work_system;
}

static int is_all_taken(void)
{
    nck_queue_t queue;
    nck_queue(&front.nck, &queue);
    return queue.text + queue.smooth + queue.segs + queue.outputs == 0;
}

static void tell(uint32_t at, const nck_modal_t *modal)
{
    printf("    line %u: G%d G%u %u %u %u %u %u %u %u %u %u\n", at, modal->motion, modal->plane,
           modal->inch, modal->diameter, modal->incremental, modal->feed_mode, modal->path_mode,
           modal->spindle_on, modal->spindle_code, modal->coolant, modal->work_system);
}

static void tick(check_t *check)
{
    nck_modal_t modal, read;
    front_tick(&front);
    nck_modal_executed(&front.nck, &modal);
    nck_modal(&front.nck, &read);
    const uint32_t at = is_all_taken() ? lines : front.pose.line;
    behind += !same_modes(&modal, &read);
    if (CHECK(check, at <= lines && same_modes(&modal, &known[at]))) return;
    tell(at, &modal);
    if (at <= lines) tell(at, &known[at]);
}

// A line to both: what it has left is known before the tool moves.
static void line(check_t *check, const char *text)
{
    char with_end[LINE_BYTES];
    size_t used = 0, n = strlen(text);
    memcpy(with_end, text, n);
    with_end[n++] = '\n';
    const uint32_t next = lines + 1;
    nck_name_line(&decoded, next);
    (void)nck_push(&decoded, with_end, n, &used);
    while (nck_prep(&decoded) <= NCK_OK) {}
    used = 0;
    nck_modal(&decoded, &known[next]);
    nck_name_line(&front.nck, next);
    for (int n_ticks = 0; used < n && n_ticks < FRONT_TICKS; n_ticks++) {
        if (nck_push(&front.nck, with_end, n, &used) != NCK_OK) used = 0;
        if (used == 0) tick(check);
        if (front.state == NCK_TICK_WAIT) nck_resume(&front.nck);
    }
    CHECK(check, used == n);
    lines = next;
    front_prep(&front);
}

static const char *const words[] = {
    "G91", "G90", "G20", "G21", "M8", "M7", "M9", "M3 S500", "M4 S700", "M5", "G55", "G54",
    "G59.3", "G61", "G64 P0.05", "G18", "G17", "G80", "F900", "F300", "G95 F3 M3 S600",
    "G94 F800", "G92 X1", "G92.1", "T99", "G1 X[", "G41 D99", "G93 G1 X1", "S100", "G61.1"
};

static void move(check_t *check)
{
    char text[LINE_BYTES];
    const int way = (int)pick(600) - 300, turn = (int)pick(80) - 40;
    switch (pick(8)) {
    case 0: snprintf(text, sizeof text, "G0 X%d Y%d", way / 100, turn / 10); break;
    case 1: snprintf(text, sizeof text, "G17 G3 X%d.5 Y%d R30", way / 100, turn / 8); break;
    case 2: snprintf(text, sizeof text, "G4 P0.0%u", pick(9)); break;
    case 3: snprintf(text, sizeof text, "%s G1 X%d", words[pick(18)], way / 60); break;
    case 4: snprintf(text, sizeof text, "G81 X%d Y%d Z-0.2 R0", way / 100, turn / 10); break;
    default: snprintf(text, sizeof text, "G1 X%d.%u Y0.%u", way / 100, pick(99), pick(99)); break;
    }
    line(check, text);
}

static void rest(check_t *check)
{
    nck_flush(&front.nck);
    for (int n = 0; n < FRONT_TICKS && !(nck_is_idle(&front.nck) && is_all_taken()); n++) {
        tick(check);
    }
}

// Braked anywhere, and what was not executed is dropped: from there on in the modes of the last
// line that was taken.
static void drop(check_t *check)
{
    nck_queue_t queue;
    int ticks = 0;
    do {
        tick(check);
        nck_queue(&front.nck, &queue);
    } while (queue.text != 0 && ++ticks < FRONT_TICKS);
    nck_abort(&front.nck);
    while (nck_go_on(&front.nck) != NCK_OK && ++ticks < FRONT_TICKS) tick(check);
    CHECK(check, ticks < FRONT_TICKS);
    known[0] = known[lines];
    for (int n = 0; n < 2; n++) front_tick(&front);
    nck_modal_t modal;
    nck_modal(&front.nck, &modal);
    memcpy(decoded.decode.place.position_nm, modal.position_nm, sizeof modal.position_nm);
}

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    front.machine.path.tolerance = pick(2) ? 0.05 : 0.0;
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    (void)nck_init(&decoded, &front.machine, NULL);
    (void)nck_begin_session(&decoded, &before_decoded);
    nck_check_only(&decoded, 1);
    nck_modal(&decoded, &known[0]);
    lines = 0;
}

static void check_session(check_t *check, uint32_t number)
{
    static const uint32_t slopes[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK, NCK_SLOPE_OPTIMAL};
    const int broken = check->broken;
    seed = number;
    begin(slopes[pick(NCK_HAS_OPTIMAL ? 3 : 2)]);
    while (lines < LINES && check->broken == broken) {
        const uint32_t kind = pick(40);
        if (kind < 12) line(check, words[pick(sizeof words / sizeof *words)]);
        else if (kind < 36) move(check);
        else if (kind == 36) rest(check);
        else if (kind == 37) drop(check);
        else if (kind == 38) nck_hold(&front.nck);
        else nck_resume(&front.nck);
        if (pick(4) == 0) tick(check);
        if (kind == 38) for (int n = 0; n < 50; n++) tick(check);
        nck_resume(&front.nck);
    }
    rest(check);
    if (check->broken != broken) printf("session %u\n", number);
}

static void at_the_tool_is_in_force_what_its_line_has_left(check_t *check)
{
    behind = 0;
    for (uint32_t k = 0; k < count; k++) check_session(check, first + k);
    CHECK(check, behind > count);
}

static void a_line_that_is_refused_leaves_nothing_at_the_tool(check_t *check)
{
    static const char *const texts[] = {"G95 F1", "G0 X1", "G0 X2", "M8 G1 X3", "G0 X4"};
    begin(NCK_SLOPE_LINEAR);
    for (uint32_t k = 0; k < sizeof texts / sizeof *texts; k++) line(check, texts[k]);
    rest(check);
    CHECK(check, known[5].coolant == 0);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, a_line_that_is_refused_leaves_nothing_at_the_tool);
    CHECK_RUN(&check, at_the_tool_is_in_force_what_its_line_has_left);
    return check_end(&check);
}
