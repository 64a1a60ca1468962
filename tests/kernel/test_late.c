// SPDX-License-Identifier: MIT
// Along a clocked path prep is late, starved and hurried: every axis keeps its limits, and the tool
// arrives; so it does where an operator holds it besides, and turns its override.
//
//     test_late [COUNT [FIRST]]   so many random sessions, from this number on; tells the worst

#include "front_check.h"
#include "nck/base/cell_math.h" // nck_cell_speed

enum { LINES = 600, LINE_BYTES = 64, AXES = 2, PLACES = 4 };
#define MOST_S 60.0 // a session takes less
#define ACTS_S 10.0 // an operator acts so long
// Of a limit: what cells are off their plan by; of a jerk where another plan comes.
#define MOST 1.005
#define JERK_MOST 1.01
#define BACK_MOST (-1e-6) // of a cell's speed, that rounding leaves

static front_t front;
static uint64_t seed;
static uint32_t count = 20, first = 240; // 248, 255: a plan crept for hours, 17 times a jerk

static double draw(double low, double high) { return front_draw(&seed, low, high); }

static uint32_t pick(uint32_t n)
{
    (void)draw(1.0, 2.0);
    return (uint32_t)((seed >> 33) % n);
}

static struct {
    char line[LINES][LINE_BYTES];
    double at_s[LINES]; // when it may be pushed
    int lines, next;    // so many; pushed
    double v, a, j;     // of each axis
    uint32_t steps, hurries; // of prep in a period at most; one in so many periods hurries besides
    double periods;          // that it tells
    double place[PLACES][AXES];
    double most[3];          // of v, a and j that an axis has taken
    double least;            // of a cell's speed, of the most in it; below 0: it goes back
} session;

// Who holds and turns the override every so many periods, and holds for so many.
static struct {
    int acts, holds;
    uint64_t seed;
    double every, held, turns;   // [periods]
    double next_hold, next_turn; // period of what he does next
} operator;

static void write_burst(double *t, double *place, double *turned)
{
    const double size = draw(0.1, 2.0), feed = draw(600.0, 6000.0), turn = draw(0.02, 0.4);
    const int chords = 3 + (int)pick(80);
    *t += draw(0.05, 1.0);
    for (int n = 0; n < chords && session.lines < LINES; n++) {
        *turned += pick(20) ? turn : draw(0.5, 3.0);
        place[0] += size * cos(*turned);
        place[1] += size * sin(*turned);
        session.at_s[session.lines] = *t;
        snprintf(session.line[session.lines++], LINE_BYTES, "G1 X%.5f Y%.5f F%.1f\n", place[0],
                 place[1], feed);
    }
}

static void begin(uint32_t number)
{
    double t = 0.0, place[AXES] = {0.0, 0.0}, turned = 0.0;
    memset(&session, 0, sizeof session);
    seed = front_seed(number);
    front_machine(&front, NCK_SLOPE_OPTIMAL);
    front.machine.period_s = pick(2) ? 1e-3 : 0.25e-3;
    session.v = draw(50.0, 300.0);
    session.a = draw(300.0, 5000.0);
    session.j = draw(5000.0, 100000.0);
    front_limit(&front, session.v, session.a, session.j);
    front.machine.path.feed_max = 2.0 * session.v;
    session.steps = (uint32_t)draw(4.0, 60.0);
    session.hurries = (uint32_t)draw(5.0, 100.0);
    session.periods = draw(1.0, 200.0);
    snprintf(session.line[session.lines++], LINE_BYTES, "G64 P%.4f\n", draw(0.01, 0.5));
    for (int n = 0; n < 5; n++) write_burst(&t, place, &turned);
    (void)front_start(&front);
}

// Between half and twice of what he waits as a rule.
static double wait(double as_a_rule) { return as_a_rule * front_draw(&operator.seed, 0.5, 2.0); }

static void begin_operator(uint32_t number, int acts)
{
    memset(&operator, 0, sizeof operator);
    operator.acts = acts;
    operator.seed = front_seed(~number);
    operator.every = front_draw(&operator.seed, 20.0, 2000.0);
    operator.held = front_draw(&operator.seed, 3.0, 500.0);
    operator.turns = front_draw(&operator.seed, 20.0, 4000.0);
    operator.next_hold = wait(operator.every);
    operator.next_turn = wait(operator.turns);
}

static void operate(uint64_t k)
{
    const double period = (double)k;
    if (!operator.acts) return;
    if (period * front.machine.period_s > ACTS_S) {
        operator.acts = 0;
        nck_set_override(&front.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
        nck_resume(&front.nck);
        return;
    }
    if (period >= operator.next_hold) {
        operator.holds = !operator.holds;
        operator.next_hold += wait(operator.holds ? operator.held : operator.every);
        if (operator.holds) nck_hold(&front.nck);
        else nck_resume(&front.nck);
    }
    if (period >= operator.next_turn) {
        const double percent = front_draw(&operator.seed, 5.0, 200.0);
        operator.next_turn += wait(operator.turns);
        nck_set_override(&front.nck, (uint32_t)(percent * NCK_PERCENT), 100 * NCK_PERCENT);
    }
}

// What prep lacks: a line, if one is there by now. Returns 1 if it has been given something.
static int give(double now_s)
{
    size_t used = 0;
    if (session.next < session.lines && session.at_s[session.next] <= now_s) {
        const char *const line = session.line[session.next];
        (void)nck_push(&front.nck, line, strlen(line), &used); // all of it, or none
        session.next += used > 0;
        return used > 0;
    }
    if (session.next == session.lines) nck_flush(&front.nck);
    nck_hurry(&front.nck, (uint32_t)session.periods);
    return 0;
}

static void prep(double now_s)
{
    uint32_t given = 0;
    for (uint32_t n = 0; n < session.steps; n++) {
        front.status = nck_prep(&front.nck);
        if (front.status == NCK_FULL) break;
        if (front.status == NCK_EMPTY && !give(now_s) && given++) break;
    }
    if (pick(session.hurries) == 0) nck_hurry(&front.nck, (uint32_t)session.periods);
}

// A cell's speed is a parabola of time: the least of it.
static void measure_cell(const nck_cell_t *cell)
{
    const double middle = cell->j > 0.0 ? -cell->a / cell->j : 0.0;
    const double end = nck_cell_speed(cell, cell->duration);
    const double at = fmin(fmax(middle, 0.0), cell->duration);
    const double least = fmin(nck_cell_speed(cell, at), end);
    session.least = fmin(session.least, least / (1e-6 + fmax(cell->v, end)));
}

static void measure(void)
{
    const double period = front.machine.period_s;
    double (*const p)[AXES] = session.place;
    memmove(p[1], p[0], sizeof session.place - sizeof *p);
    memcpy(p[0], front.pose.axis, sizeof *p);
    if (front.nck.interpolate.has_cell) measure_cell(&front.nck.interpolate.cell);
    for (int x = 0; x < AXES; x++) {
        const double v = (p[0][x] - p[1][x]) / period;
        const double a = (p[0][x] - 2.0 * p[1][x] + p[2][x]) / (period * period);
        const double j = (p[0][x] - p[3][x] - 3.0 * (p[1][x] - p[2][x])) / pow(period, 3.0);
        session.most[0] = fmax(session.most[0], fabs(v) / session.v);
        session.most[1] = fmax(session.most[1], fabs(a) / session.a);
        session.most[2] = fmax(session.most[2], fabs(j) / session.j);
    }
}

static void check_session(check_t *check, uint32_t number, int acts, double *worst)
{
    int done = 0;
    begin(number);
    begin_operator(number, acts);
    for (uint64_t k = 0; !done && (double)k * front.machine.period_s < MOST_S; k++) {
        operate(k);
        prep((double)k * front.machine.period_s);
        front.state = nck_tick(&front.nck, &front.pose, &front.axes);
        measure();
        done = session.next == session.lines && front_is_done(&front);
    }
    const double *const most = session.most;
    for (int n = 0; n < 3; n++) worst[n] = fmax(worst[n], most[n]);
    const int keeps = most[0] <= MOST && most[1] <= MOST && most[2] <= JERK_MOST;
    if (CHECK(check, keeps && done && session.least >= BACK_MOST)) return;
    printf("session %u: %.4f of v, %.4f of a, %.4f of j, back by %.2g, done %d\n", number, most[0],
           most[1], most[2], session.least, done);
}

static void check_sessions(check_t *check, int acts, const uint32_t *range)
{
    double worst[3] = {0.0, 0.0, 0.0};
    for (uint32_t k = 0; k < range[0]; k++) check_session(check, range[1] + k, acts, worst);
    printf("%.4f of v, %.4f of a, %.4f of j at most\n", worst[0], worst[1], worst[2]);
}

static void limits_hold_however_late_prep_is(check_t *check)
{
    const uint32_t drawn[2] = {count, first};
    check_sessions(check, 0, drawn);
}

static void limits_hold_whoever_operates_besides(check_t *check)
{
    // Took 277, 3.1 and 17 times a jerk.
    static const uint32_t known[][2] = {{1, 416}, {1, 793}, {1, 2021}};
    const uint32_t drawn[2] = {count, first};
    check_sessions(check, 1, drawn);
    for (int n = 0; n < 3 && NCK_HAS_OPTIMAL; n++) check_sessions(check, 1, known[n]);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    if (!NCK_HAS_OPTIMAL) count = 0; // the build has no clocked path
    CHECK_RUN(&check, limits_hold_however_late_prep_is);
    CHECK_RUN(&check, limits_hold_whoever_operates_besides);
    return check_end(&check);
}
