// SPDX-License-Identifier: MIT
// Random scripts at the front door: text and blocks pushed, flushed, held, overridden, aborted and
// begun anew at random ticks. Limits hold at every tick, every block is executed once and in order,
// and the position is never lost.
//
//     test_script [COUNT [FIRST]]   so many scripts, from this number on; one alone is told in full

#include "motion_check.h"

enum { COUNT = 1000, EVENTS = 24, MOVES = 512, PATIENCE = 40, TICKS = 60000, LOOK = 16,
       WHOLE = 1000000 }; // an override of 100 %

// A move that has been pushed, as the segs are to name it.
typedef struct move {
    uint32_t line;
    int exact; // 1: it has segs of its own
} move_t;

typedef struct script {
    uint64_t seed;
    move_t move[MOVES];
    uint32_t moves, reached;  // pushed; the move of the newest seg
    uint32_t line, id;        // lines of text and blocks pushed since the program began
    uint32_t sent, received;  // S words likewise
    double target[2];         // of the last move pushed [mm]
    double seg_end[2];        // of the newest seg [mm]
    int exact;                // 1: no tolerance in force
    int slow;                 // 1: prep gets a few steps a tick
    int broken;               // 1: out of order
    const char *why;
} script_t;

static motion_t motion;
static script_t script;
static uint32_t programs;

static double draw(void) { return motion_random(&script.seed); }

static int pick(int n) { return (int)(draw() * (double)n); }

static void fail(const char *why)
{
    if (!script.broken) script.why = why;
    script.broken = 1;
}

static void on_seg(void *user, const nck_seg_t *seg)
{
    uint32_t k = script.reached;
    motion_keep_seg(user, seg);
    if (hypot(seg->start[0] - script.seg_end[0], seg->start[1] - script.seg_end[1]) > 1e-9) {
        fail("a seg does not begin where the last one ends");
    }
    script.seg_end[0] = seg->end[0];
    script.seg_end[1] = seg->end[1];
    if (seg->kind >= NCK_SEG_DWELL) return;
    while (k < script.moves && script.move[k].line != seg->line) {
        if (k > script.reached && script.move[k].exact) fail("a move is left out");
        k++;
    }
    if (k == script.moves) fail("a seg of no move that is to come");
    else script.reached = k;
}

static void on_output(void *user, const nck_output_t *output)
{
    (void)user;
    if (output->kind != NCK_OUTPUT_SPINDLE_SPEED) return;
    script.received++;
    if (output->value != (double)script.received) fail("an output out of order");
}

static void begin_program(void)
{
    programs++;
    script.moves = script.reached = script.line = script.id = 0;
    script.sent = script.received = 0;
    script.exact = 0;
    motion.segs = 0;
    memset(motion.s, 0, sizeof motion.s);
    for (int x = 0; x < 2; x++) {
        script.target[x] = (double)motion.axes.joint_nm[x] * 1e-6;
        script.seg_end[x] = script.target[x];
    }
}

// ---- time

static void tick(void)
{
    const uint32_t steps = script.slow ? (uint32_t)pick(12) : MOTION_STEPS;
    nck_status_t status = NCK_OK;
    for (uint32_t n = 0; n < steps && status == NCK_OK; n++) status = nck_prep(&motion.nck);
    const int looks = motion.ticks % LOOK == 0;
    if (looks && nck_invariants(&motion.nck)) fail("a room's invariant is broken");
    if (status < NCK_OK) fail("a program error");
    motion.status = status;
    const nck_tick_state_t state = nck_tick(&motion.nck, &motion.pose, &motion.axes);
    nck_command_t asked;
    nck_asked(&motion.nck, &asked);
    if (state == NCK_TICK_WAIT && !asked.hold) nck_resume(&motion.nck);
    motion.ticks++;
    motion_judge(&motion);
}

static void free_path(void)
{
    nck_set_override(&motion.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    nck_set_single_block(&motion.nck, 0);
    for (uint32_t x = 0; x < 2; x++) (void)nck_set_travel(&motion.nck, x, INT64_MIN, INT64_MAX);
    nck_resume(&motion.nck);
}

// Until all that is pushed is executed, or what is aborted rests.
static void run_out(int until_done)
{
    for (uint32_t n = 0; n < TICKS; n++) {
        const nck_status_t wanted = until_done ? NCK_DONE : NCK_EMPTY;
        nck_queue_t queue;
        if (n % 512 == 511) nck_resume(&motion.nck);
        tick();
        nck_queue(&motion.nck, &queue);
        const int all = queue.segs == 0 && queue.outputs == 0 && queue.smooth == 0;
        if (motion.status == wanted && nck_is_idle(&motion.nck) && all) return;
    }
    fail("the path does not come to its end");
}

static void check_position(void)
{
    for (int x = 0; x < 2; x++) {
        if (fabs((double)motion.axes.joint_nm[x] * 1e-6 - script.target[x]) > 1.1e-6) {
            fail("the path ends elsewhere");
        }
    }
    if (script.received != script.sent) fail("outputs are lost");
    for (uint32_t k = script.reached + 1; k < script.moves; k++) {
        if (script.move[k].exact) fail("moves are lost");
    }
}

// Something was FULL: give it time; what keeps the path at rest is let go.
static int wait_for_room(int tries)
{
    if (tries == PATIENCE) free_path();
    for (int n = 0; n <= tries; n++) tick();
    return tries < 10 * PATIENCE;
}

// ---- what is pushed

static void note_move(uint32_t line, double x, double y)
{
    const int moves = hypot(x - script.target[0], y - script.target[1]) > 1e-9;
    script.target[0] = x;
    script.target[1] = y;
    if (!moves || script.moves == MOVES) return;
    script.move[script.moves].line = line;
    script.move[script.moves].exact = script.exact;
    script.moves++;
}

static void push(const char *words)
{
    size_t used = 0, n = strlen(words);
    for (int tries = 0; n > 0; tries++) {
        const nck_status_t status = nck_push(&motion.nck, words, n, &used);
        if (status < NCK_OK) fail("text is refused");
        words += used;
        n -= used;
        if (n > 0 && used == 0 && !wait_for_room(tries)) fail("no room for text");
        if (script.broken) return;
    }
}

static void push_block(const nck_block_in_t *block)
{
    for (int tries = 0; !script.broken; tries++) {
        const nck_status_t status = nck_push_block(&motion.nck, block);
        if (status == NCK_OK) return;
        if (status != NCK_FULL) fail("a block is refused");
        else if (!wait_for_room(tries)) fail("no room for a block");
    }
}

// Whole micrometres, so that text says them exactly.
static double coordinate(double scale) { return floor(1000.0 * scale * (draw() - 0.5)) / 1000.0; }

static double scale_of_move(void)
{
    static const double scales[] = {0.004, 0.05, 0.5, 4.0, 20.0};
    return scales[pick(5)];
}

static void push_text(void)
{
    char words[120];
    const double scale = scale_of_move();
    const double d[2] = {coordinate(scale), coordinate(scale)};
    const double x = floor(1000.0 * (script.target[0] + d[0]) + 0.5) / 1000.0;
    const double y = floor(1000.0 * (script.target[1] + d[1]) + 0.5) / 1000.0;
    const uint32_t line = script.line + 1;
    switch (pick(8)) {
    case 0: snprintf(words, sizeof words, "G91 G1 X%.3f Y%.3f\n", d[0], d[1]); break;
    case 1: snprintf(words, sizeof words, "G90 G0 X%.3f Y%.3f\n", x, y); break;
    case 2: snprintf(words, sizeof words, "S%u\n", (unsigned)++script.sent); break;
    case 3: snprintf(words, sizeof words, "G4 P0.%03d\n", pick(30)); break;
    case 4:
        script.exact = pick(2);
        snprintf(words, sizeof words, "%s\n", !script.exact ? "G64 P0.01 Q0"
                                              : pick(2) ? "G61" : "G61.1");
        break;
    default: snprintf(words, sizeof words, "G90 G1 X%.3f Y%.3f F%d\n", x, y, 300 + pick(6000));
    }
    script.line++;
    const int relative = words[0] == 'G' && words[1] == '9' && words[2] == '1';
    if (relative) note_move(line, script.target[0] + d[0], script.target[1] + d[1]);
    else if (words[0] == 'G' && words[1] == '9') note_move(line, x, y);
    push(words);
}

static void push_geometry(void)
{
    nck_block_in_t block;
    const double scale = scale_of_move();
    memset(&block, 0, sizeof block);
    block.id = 100000 + ++script.id;
    block.axes = 3;
    block.target[0] = floor(1e6 * (script.target[0] + scale * (draw() - 0.5)) + 0.5) / 1e6;
    block.target[1] = floor(1e6 * (script.target[1] + scale * (draw() - 0.5)) + 0.5) / 1e6;
    block.kind = NCK_IN_LINE;
    if (pick(2)) {
        block.sets = NCK_IN_SETS_FEED;
        block.feed = 100.0 + 6000.0 * draw();
    }
    switch (pick(8)) {
    case 0: block.kind = NCK_IN_RAPID; break;
    case 1:
        block.kind = NCK_IN_S;
        block.value = (double)++script.sent;
        break;
    case 2:
        block.kind = NCK_IN_DWELL;
        block.value = 0.02 * draw();
        break;
    case 3:
        block.sets |= NCK_IN_SETS_PATH;
        block.path_mode = (uint8_t)pick(3);
        block.tolerance = 0.01;
        script.exact = block.path_mode != NCK_PATH_CONTINUOUS;
        break;
    case 4:
        block.kind = NCK_IN_ARC; // half a circle, at least
        block.plane = 17;
        block.turns = pick(2) ? 1 : -1;
        for (int x = 0; x < 2; x++) block.centre[x] = 0.5 * (script.target[x] + block.target[x]);
        break;
    default: break;
    }
    const int moves = block.kind >= NCK_IN_RAPID && block.kind <= NCK_IN_ARC;
    if (moves) note_move(block.id, block.target[0], block.target[1]);
    push_block(&block);
}

// ---- what else happens

static void begin_anew(void)
{
    const nck_axes_t before = motion.axes;
    if (nck_begin(&motion.nck) != NCK_OK) fail("it does not begin anew");
    free_path();
    begin_program();
    tick();
    if (memcmp(&before, &motion.axes, sizeof before) != 0) fail("begin moves an axis");
    for (int n = 0; n < 3; n++) {
        memcpy(motion.axis[n], motion.pose.axis, sizeof motion.axis[n]); // now at whole counts
    }
    push("G21 G90 F3000\n");
    script.line = 1;
}

static void end_and_begin(void)
{
    nck_end(&motion.nck);
    free_path();
    run_out(1);
    if (!script.broken) check_position();
    begin_anew();
}

static void abort_and_begin(void)
{
    nck_abort(&motion.nck);
    for (uint32_t n = 0; n < TICKS; n++) {
        const nck_axes_t before = motion.axes;
        tick();
        const int still = memcmp(&before, &motion.axes, sizeof before) == 0;
        if (motion.status == NCK_DONE && nck_is_idle(&motion.nck) && still) break;
    }
    begin_anew();
}

static void flush_out(void)
{
    nck_flush(&motion.nck);
    if (pick(2)) return;
    free_path();
    run_out(0);
    if (!script.broken) check_position();
}

// Somewhere around where the program is.
static void set_travel(void)
{
    const int x = pick(2);
    const double at = script.target[x];
    const int64_t least = (int64_t)((at - 20.0 * draw()) * 1e6);
    const int64_t most = (int64_t)((at + 20.0 * draw()) * 1e6);
    (void)nck_set_travel(&motion.nck, (uint32_t)x, least, most);
}

static void ask(void)
{
    switch (pick(7)) {
    case 0: nck_hold(&motion.nck); break;
    case 1: nck_resume(&motion.nck); break;
    case 2: nck_set_override(&motion.nck, (uint32_t)pick(201) * NCK_PERCENT, WHOLE); break;
    case 3: nck_set_override(&motion.nck, WHOLE, (uint32_t)pick(101) * NCK_PERCENT); break;
    case 4: nck_set_single_block(&motion.nck, (uint32_t)pick(2)); break;
    case 5: set_travel(); break;
    default: free_path(); break;
    }
}

static void happen(void)
{
    const int what = pick(20);
    if (what < 7) push_text();
    else if (what < 13) push_geometry();
    else if (what < 15) flush_out();
    else if (what < 17) ask();
    else if (what == 17) abort_and_begin();
    else if (what == 18) end_and_begin();
    else for (int n = pick(200); n > 0; n--) tick();
}

// A script by its number. Returns 1 if all promises held.
static int run_script(check_t *check, uint32_t number)
{
    static const uint32_t slopes[] = {NCK_SLOPE_JERK, NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    const nck_hooks_t hooks = {&motion, on_output, NULL, on_seg};
    memset(&script, 0, sizeof script);
    script.seed = 88172645463325252u + 0x9e3779b97f4a7c15u * (uint64_t)(number + 1);
    for (int n = 0; n < 4; n++) (void)draw();
    motion_begin(&motion, 1);
    motion.machine.slope = slopes[number % 3];
    if (motion.machine.slope == NCK_SLOPE_LINEAR) motion.machine.path.j_max = 1e12;
    (void)motion_start(&motion);
    (void)nck_init(&motion.nck, &motion.machine, &hooks);
    (void)nck_position(&motion.nck, &motion.pose, &motion.axes);
    begin_program();
    script.slow = number % 5 == 4;
    push("G21 G90 F3000\n");
    script.line = 1;
    for (int n = 0; n < EVENTS && !script.broken; n++) happen();
    if (!script.broken) end_and_begin();
    const int good = motion_holds(check, &motion, "limits") && !script.broken;
    const char *const why = script.broken ? script.why : "limits";
    if (!good) printf("    script %u: %s\n", (unsigned)number, why);
    CHECK(check, !script.broken);
    return good;
}

static uint32_t first, count = COUNT;

static void scripts_keep_every_promise(check_t *check)
{
    uint32_t bad = 0;
    for (uint32_t n = first; n < first + count && bad < 5; n++) bad += !run_script(check, n);
    printf("    %u programs in %u scripts\n", (unsigned)programs, (unsigned)count);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, scripts_keep_every_promise);
    return check_end(&check);
}
