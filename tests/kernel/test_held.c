// SPDX-License-Identifier: MIT
// Held and resumed again and again, as by a pendant: how long a program takes then.
//
//     test_held [COUNT [FIRST]]   so many random sessions, from this number on; tells the worst

#include "front_check.h"

enum { TEXT = 60000, LASTS = 3000, TICKS_MOST = 60 * LASTS };
// Chords, and the most of them [mm]; less than WAY_LEAST is no way to measure by.
#define CHORD 0.15
#define CHORDS_MOST 60.0
#define WAY_LEAST 3.0
enum { LINE, ZIGZAG, ARCS, CHORDS, FAMILIES };

// Along a line of what a perfect control needs, elsewhere of what the slope `jerk` takes. Of 1000
// sessions the longest took 1.97 and 1.49.
#define LINE_MOST 2.2
#define JERK_MOST 1.7

static front_t front;
static uint64_t seed;
static uint32_t count = 12, first;
static char text[TEXT];

static double draw(double low, double high) { return front_draw(&seed, low, high); }

// What a session is: the machine, and the operator, who holds it every so many periods.
typedef struct session {
    uint32_t family;
    double feed, a, j, v_max; // [mm/s] …
    double every, held;       // [periods]
    double way;               // as far as a perfect control goes in LASTS periods [mm]
    uint64_t seed;            // of what he does
} session_t;

typedef struct operator {
    const session_t *session;
    double next; // period of what he does next
    int holds;
} operator_t;

static operator_t operator_of(const session_t *session)
{
    seed = session->seed;
    const operator_t self = {session, draw(0.5, 2.0) * session->every, 0};
    return self;
}

// 1 if he does something in this period: then he holds, or no longer.
static int acts(operator_t *self, int period)
{
    const session_t *const session = self->session;
    if ((double)period < self->next) return 0;
    self->holds = !self->holds;
    self->next += draw(0.5, 2.0) * (self->holds ? session->held : session->every);
    return 1;
}

// A control that brakes at once and sets off at once, by all of a and j.
static double perfect_way(const session_t *session, double period)
{
    operator_t operator = operator_of(session);
    double v = 0.0, a = 0.0, way = 0.0;
    for (int k = 0; k < LASTS; k++) {
        (void)acts(&operator, k);
        const double wanted = operator.holds ? 0.0 : session->feed;
        const double reaches = v + a * fabs(a) / (2.0 * session->j);
        const double step = copysign(session->j * period, wanted - reaches);
        const double next = fmax(-session->a, fmin(session->a, a + step));
        const double v1 = v + 0.5 * (a + next) * period;
        const int there = fabs(v1 - wanted) < fabs(step) * period && fabs(next) <= 2.0 * fabs(step);
        way += 0.5 * (v + fmax(0.0, v1)) * period;
        v = there ? wanted : fmax(0.0, v1);
        a = there || !(v1 > 0.0) ? 0.0 : next;
    }
    return way;
}

static size_t put_move(size_t at, const session_t *session, int n, double step, double x)
{
    const int is_odd = n % 2;
    char *const to = text + at;
    const size_t room = TEXT - at;
    int bytes = 0;
    switch (session->family) {
    case ZIGZAG: {
        const double y = is_odd ? draw(0.1, 1.0) * step : 0.0;
        bytes = snprintf(to, room, "G1 X%.4f Y%.4f\n", x, y);
        break;
    }
    case ARCS: bytes = snprintf(to, room, "G%d X%.4f I%.4f\n", 2 + is_odd, x, 0.5 * step); break;
    case CHORDS: bytes = snprintf(to, room, "G1 X%.4f Y%.4f\n", x, 3.0 * sin(x)); break;
    default: bytes = snprintf(to, room, "G1 X%.4f\n", x); break;
    }
    return at + (size_t)bytes;
}

static void write_program(const session_t *session)
{
    const int is_fine = session->family == CHORDS;
    const double way = is_fine ? fmin(session->way, CHORDS_MOST) : session->way;
    const double about = is_fine ? CHORD : draw(1.0, 20.0);
    const int moves = session->family == LINE ? 1 : 1 + (int)(way / about);
    const double step = floor(way / moves * 1e4) * 1e-4 + 1e-4; // as it is written
    size_t at = (size_t)snprintf(text, TEXT, "G64 P0.01 F%.3f\n", session->feed * 60.0);
    for (int n = 1; n <= moves; n++) at = put_move(at, session, n, step, n * step);
}

static void begin(const session_t *session, uint32_t slope)
{
    front_machine(&front, slope);
    front_limit(&front, session->v_max, session->a, session->j);
    front.machine.path.feed_max = session->v_max;
    (void)front_start(&front);
}

// Periods that the program takes.
static int periods_of(const session_t *session, uint32_t slope)
{
    operator_t operator = operator_of(session);
    const char *rest = text;
    size_t left = strlen(text), used = 0;
    int k = 0;
    begin(session, slope);
    for (; k < TICKS_MOST && (left > 0 || !front_is_done(&front)); k++) {
        do {
            (void)nck_push(&front.nck, rest, left, &used);
            rest += used;
            left -= used;
            front_prep(&front);
        } while (left > 0 && used > 0);
        if (left == 0) nck_flush(&front.nck);
        if (acts(&operator, k)) (operator.holds ? nck_hold : nck_resume)(&front.nck);
        front_tick(&front);
    }
    return k;
}

static session_t session_of(uint32_t number)
{
    session_t session;
    seed = front_seed(number);
    session.family = number % FAMILIES;
    session.feed = draw(5.0, 150.0);
    session.a = draw(300.0, 5000.0);
    session.j = session.a * draw(8.0, 80.0);
    session.v_max = session.feed * draw(1.0, 4.0);
    session.every = draw(40.0, 2000.0);
    session.held = draw(10.0, 500.0);
    session.seed = seed;
    session.way = perfect_way(&session, 1e-3);
    return session;
}

static void check_session(check_t *check, uint32_t number, double *line_out, double *other_out)
{
    const session_t session = session_of(number);
    if (session.way < WAY_LEAST) return; // it hardly moves, whoever controls it
    write_program(&session);
    const int optimal = periods_of(&session, NCK_SLOPE_OPTIMAL);
    const int is_line = session.family == LINE;
    const int of = is_line ? LASTS : periods_of(&session, NCK_SLOPE_JERK);
    const double share = (double)optimal / of;
    double *const worst = is_line ? line_out : other_out;
    if (share > *worst) *worst = share;
    if (CHECK(check, share <= (is_line ? LINE_MOST : JERK_MOST))) return;
    printf("session %u: %d of %d periods\n", number, optimal, of);
}

static void who_is_held_again_and_again_goes_on(check_t *check)
{
    double line = 0.0, other = 0.0;
    for (uint32_t k = 0; k < count; k++) check_session(check, first + k, &line, &other);
    printf("%.2f of what a line needs, %.2f of what the slope jerk takes\n", line, other);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    if (NCK_HAS_OPTIMAL) CHECK_RUN(&check, who_is_held_again_and_again_goes_on);
    else check.tests++; // every slope brakes by plans: test_override.c
    return check_end(&check);
}
