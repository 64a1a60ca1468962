// SPDX-License-Identifier: MIT
// What the machine is awaited for: nothing moves before the spindle has its speed, whatever the
// operator does, and M66's answer can be asked for.
//
//     test_await [COUNT [FIRST]]   so many random sessions, from this number on

#include "front_check.h"

enum { LINES = 40, LINE_BYTES = 64, ASKS = NCK_HAS_FOREIGN && NCK_HAS_VARIABLES };

static front_t front;
static nck_decode_t before;
static uint64_t seed;
static uint32_t count = 40, first;

static struct {
    double speed, way;           // commanded; 1, −1 or 0: M3, M4, M5
    double rpm, step;            // as it turns; what it gains in a tick
    uint32_t awaits, reads;      // the spindle; so many ticks more M66's input
} spindle;

static uint32_t pick(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((seed >> 33) % n);
}

static void on_output(void *user, const nck_output_t *output)
{
    const int turns = output->kind == NCK_OUTPUT_M && output->value >= 3.0 && output->value <= 5.0;
    (void)user;
    if (output->kind == NCK_OUTPUT_SPINDLE_SPEED) spindle.speed = output->value;
    if (turns) spindle.way = output->value == 5.0 ? 0.0 : output->value == 3.0 ? 1.0 : -1.0;
    spindle.awaits = turns || output->kind == NCK_OUTPUT_SPINDLE_SPEED;
    spindle.reads = output->kind == NCK_OUTPUT_INPUT && output->number >= 100 ? 1 + pick(90) : 0;
    nck_await(&front.nck, spindle.awaits || spindle.reads);
}

static double wanted(void) { return spindle.speed * spindle.way; }

static void turn(void)
{
    const double way = wanted() - spindle.rpm;
    spindle.rpm = fabs(way) <= spindle.step ? wanted() : spindle.rpm + copysign(spindle.step, way);
    if (spindle.awaits && spindle.rpm == wanted()) {
        spindle.awaits = 0;
        nck_await(&front.nck, 0);
    }
    if (spindle.reads > 0 && --spindle.reads == 0) nck_await(&front.nck, 0);
}

// The tool never moves by the program while the spindle is to turn and has not its speed.
static void tick(check_t *check)
{
    const uint64_t moving = front.moving;
    if (pick(40) == 0) nck_hold(&front.nck);
    if (pick(10) == 0) nck_resume(&front.nck);
    turn();
    const int slow = wanted() != 0.0 && spindle.rpm != wanted();
    const int reads = spindle.reads > 0;
    front_tick(&front);
    CHECK(check, front.moving == moving || !(slow || reads));
    CHECK(check, front.state != NCK_TICK_WAIT || front.outputs == 0);
}

static void rest(check_t *check)
{
    int ticks = 0;
    nck_flush(&front.nck);
    for (; !front_is_done(&front) && ticks < FRONT_TICKS; ticks++) tick(check);
    CHECK(check, ticks < FRONT_TICKS);
}

static void line(check_t *check, const char *text)
{
    size_t used = 0;
    for (int n = 0; used == 0 && n < FRONT_TICKS; n++) {
        (void)nck_push(&front.nck, text, strlen(text), &used);
        if (used == 0) tick(check);
    }
    CHECK(check, used == strlen(text));
    while (pick(3) > 0) tick(check);
}

static void begin(void)
{
    static const uint32_t slopes[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK, NCK_SLOPE_OPTIMAL};
    const nck_hooks_t hooks = {NULL, on_output, NULL, NULL};
    front_machine(&front, slopes[pick(NCK_HAS_OPTIMAL ? 3 : 2)]);
    front.machine.path.tolerance = pick(2) ? 0.05 : 0.0;
    front.machine.spindle_waits = 1;
    (void)front_start(&front);
    (void)nck_init(&front.nck, &front.machine, &hooks);
    (void)nck_begin_session(&front.nck, &before);
    memset(&spindle, 0, sizeof spindle);
    spindle.step = 1.0 + pick(200);
}

static double ask(check_t *check)
{
    const double answer = (double)pick(3) - 1.0;
    const int waits = (int)pick(2);
    rest(check);
    line(check, waits ? "M66 P1 L3 Q5\n" : "M66 P1\n");
    rest(check);
    CHECK_INT(check, nck_answered(&front.nck, answer), NCK_OK);
    return answer;
}

static void check_session(check_t *check, uint32_t number)
{
    static const char *const words[] = {"M3 S900\n", "M4\n", "M5\n", "S1500\n", "M3\n", "M8\n",
                                        "S300 M4\n", "G4 P0.02\n"};
    const int broken = check->broken;
    char text[LINE_BYTES];
    double x = 0.0;
    seed = number;
    begin();
    for (int n = 0; n < LINES && check->broken == broken; n++) {
        const uint32_t kind = pick(10);
        x = (double)pick(200) * 0.1;
        if (kind < 3) line(check, words[pick(sizeof words / sizeof *words)]);
        snprintf(text, sizeof text, "G%u X%.1f Y%.1f\n", pick(2), x, (double)pick(30) * 0.1);
        if (kind == 3 && ASKS) {
            const double answer = ask(check);
            snprintf(text, sizeof text, "G1 X[%.1f+#5399]\n", x);
            x += answer;
        }
        line(check, text);
    }
    rest(check);
    CHECK_NEAR(check, front_x(&front), x, 1e-6);
    if (check->broken != broken) printf("session %u\n", number);
}

static void nothing_moves_before_the_spindle_has_its_speed(check_t *check)
{
    for (uint32_t k = 0; k < count; k++) check_session(check, first + k);
}

static void an_answer_is_a_session_s(check_t *check)
{
    front_machine(&front, NCK_SLOPE_LINEAR);
    (void)front_start(&front);
    CHECK_INT(check, nck_answered(&front.nck, 1.0), NCK_E_STATE);
}

static void a_clock_is_told_to_the_lines_that_come(check_t *check)
{
    const nck_wall_clock_t clock = {20301231, 60504, 7, 0};
    front_machine(&front, NCK_SLOPE_LINEAR);
    front.machine.dialect.base = NCK_DIALECT_FANUC;
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    nck_set_clock(&front.nck, &clock);
    line(check, "G1 X[#3012-60500+#3001] F900.\n");
    rest(check);
    if (ASKS) CHECK_NEAR(check, front_x(&front), 11.0, 1e-6);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, nothing_moves_before_the_spindle_has_its_speed);
    CHECK_RUN(&check, a_clock_is_told_to_the_lines_that_come);
    CHECK_RUN(&check, an_answer_is_a_session_s);
    return check_end(&check);
}
