// SPDX-License-Identifier: MIT
// Room 6: the end of a motion rides beside the next one. What comes out is held against the means
// over each of both, made here from times alone.
#include <math.h>   // fabs fmax
#include <string.h> // memset

#include "check.h"
#include "nck/base/cell_math.h"                 // nck_cell_part
#include "nck/tick/6_interpolate/interpolate.h" // nck_interpolate_tick
#include "terms_check.h"                        // terms_of

#define PERIOD 0.0078125 // 2⁻⁷ s: times are exact
#define HALF 5.0         // [mm] of a motion: it speeds up, then it slows down
enum { TAPS = NCK_FILTER_TAPS };

// A motion of 2·half periods along X, which then goes on another way.
typedef struct ride {
    int half;          // periods of either half of a motion
    double overlap;    // periods
    double way[2];     // of the second motion, along X and Y [mm]
    int parts;         // of the first one's end, and of either half of the second one
    int segs;          // of the first one: one, or one for each half
} ride_t;

static nck_machine_t machine;
static nck_link_t link_;
static nck_interpolate_t interpolate;

static void put_seg(check_t *check, uint32_t seq, const double start[2], const double end[2])
{
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = seq;
    seg.line = seq + 1;
    memcpy(seg.start, start, 2 * sizeof start[0]);
    memcpy(seg.end, end, 2 * sizeof end[0]);
    seg.length = hypot(end[0] - start[0], end[1] - start[1]);
    seg.s_begin = seq == 0 ? 0.0 : link_.seg[seq - 1].s_begin + link_.seg[seq - 1].length;
    CHECK_INT(check, nck_link_push_seg(&link_, &seg), NCK_OK);
}

// Half a motion.
static nck_cell_t half_of(const ride_t *ride, uint32_t seg, double s, int slows)
{
    const double t = PERIOD * ride->half;
    const double a = 2.0 * HALF / (t * t);
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.seg = seg;
    cell.stop = slows ? NCK_STOP_REST : 0;
    cell.last = (uint8_t)(slows || ride->segs == 2);
    cell.s = s;
    cell.length = HALF;
    cell.v = slows ? a * t : 0.0;
    cell.a = slows ? -a : a;
    cell.duration = t;
    return cell;
}

// The cell from t0 on, in parts.
static void put_parts(const nck_cell_t *cell, double t0, int parts, uint8_t rides)
{
    const double span = cell->duration - t0;
    for (int k = 0; k < parts; k++) {
        nck_cell_t part;
        nck_cell_part(cell, t0 + span * k / parts, t0 + span * (k + 1) / parts, &part);
        part.stop |= rides;
        nck_link_push_cell(&link_, &part);
    }
}

static void put_ride(check_t *check, const ride_t *ride)
{
    const double start[2] = {0.0, 0.0};
    const double middle[2] = {HALF, 0.0};
    const double corner[2] = {2.0 * HALF, 0.0};
    const double end[2] = {corner[0] + ride->way[0], ride->way[1]};
    const uint32_t last = (uint32_t)ride->segs - 1; // of the first motion
    const double apart = (ride->half - ride->overlap) * PERIOD;
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_JERK; // with a filter
    machine.period_s = PERIOD;
    nck_link_init(&link_);
    nck_interpolate_init(&interpolate, terms_of(&machine), &link_);
    put_seg(check, 0, start, last ? middle : corner);
    if (last) put_seg(check, 1, middle, corner);
    put_seg(check, last + 1, corner, end);
    const nck_cell_t cell[4] = {half_of(ride, 0, 0.0, 0), half_of(ride, last, last ? 0.0 : HALF, 1),
                                half_of(ride, last + 1, 0.0, 0), half_of(ride, last + 1, HALF, 1)};
    nck_cell_t before;
    nck_cell_part(&cell[1], 0.0, apart, &before);
    (void)nck_link_batch_begin(&link_);
    nck_link_push_cell(&link_, &cell[0]);
    if (apart > 0.0) nck_link_push_cell(&link_, &before);
    put_parts(&cell[1], apart, ride->parts, NCK_STOP_RIDES);
    put_parts(&cell[2], 0.0, ride->parts, 0);
    put_parts(&cell[3], 0.0, ride->parts, 0);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
}

// Where a motion is so many periods behind its begin.
static double way_at(const ride_t *ride, double periods)
{
    const double n = fmin(fmax(periods / ride->half, 0.0), 2.0);
    return n < 1.0 ? HALF * n * n : 2.0 * HALF - HALF * (2.0 - n) * (2.0 - n);
}

// Its mean at a tick.
static double mean_at(const ride_t *ride, double periods)
{
    double sum = 0.0;
    for (int n = 0; n < TAPS; n++) sum += way_at(ride, periods - n);
    return sum / (double)TAPS;
}

// The line of a place.
static uint32_t line_of(double s, uint32_t segs)
{
    if (s < HALF) return 1;
    return s < 2.0 * HALF ? segs : segs + 1;
}

// All of it, tick by tick.
static void run(check_t *check, const ride_t *ride)
{
    const double both = 2.0 * ride->half;
    const double apart = both - ride->overlap; // periods until the second motion begins
    const int settled = 2 * ride->half + TAPS - 1;
    const int landing = (int)ceil(apart + both) + TAPS - 1;
    const uint32_t segs = (uint32_t)ride->segs;
    uint32_t done = 0;
    double s = 0.0;
    put_ride(check, ride);
    for (int k = 1; k <= landing; k++) {
        const nck_pose_t *const pose = nck_interpolate_tick(&interpolate);
        const double in = mean_at(ride, k);
        const double out = mean_at(ride, k - apart);
        const int rides = k >= apart && k < settled;
        CHECK_INT(check, pose->state, NCK_TICK_MOVE);
        CHECK_NEAR(check, pose->axis[0], in + out * ride->way[0] / (2.0 * HALF), 1e-12);
        CHECK_NEAR(check, pose->axis[1], out * ride->way[1] / (2.0 * HALF), 1e-12);
        CHECK_NEAR(check, pose->s, in + out, 1e-11);
        CHECK_NEAR(check, pose->left, rides ? 2.0 * HALF - in : 0.0, 1e-11);
        CHECK(check, pose->s > s && (pose->left > 0.0) == rides && pose->v >= 0.0);
        CHECK_INT(check, pose->line, line_of(in + out, segs));
        if (!rides) done = k >= settled ? segs : in < HALF ? 0 : segs - 1;
        CHECK_INT(check, link_.seg_done, k == landing ? segs + 1 : done);
        CHECK(check, nck_interpolate_invariants(&interpolate));
        s = pose->s;
    }
    const nck_pose_t *const pose = nck_interpolate_tick(&interpolate);
    CHECK_INT(check, pose->state, NCK_TICK_IDLE);
    CHECK(check, pose->axis[0] == 2.0 * HALF + ride->way[0] && pose->axis[1] == ride->way[1]);
    CHECK(check, pose->left == 0.0 && pose->v == 0.0);
    CHECK_INT(check, nck_link_cell_room(&link_), NCK_CELL_MAX);
}

static void place_is_the_sum_of_both(check_t *check)
{
    const ride_t right_angle = {64, 16.0, {0.0, 10.0}, 1, 1};
    const ride_t way_back = {64, 40.0, {-10.0, 0.0}, 1, 1};
    const ride_t slant = {64, 63.0, {6.0, -8.0}, 1, 1};
    run(check, &right_angle);
    run(check, &way_back);
    run(check, &slant);
}

static void motions_may_meet_between_two_ticks(check_t *check)
{
    for (double part = 0.125; part < 1.0; part += 0.25) {
        const ride_t ride = {64, 16.0 + part, {0.0, 10.0}, 1, 1};
        const ride_t least = {64, 1.0 + part, {0.0, 10.0}, 1, 1};
        run(check, &ride);
        run(check, &least);
    }
}

static void what_rides_may_be_many_cells(check_t *check)
{
    const ride_t even = {64, 16.0, {0.0, 10.0}, 4, 1};
    const ride_t short_ones = {64, 2.0, {0.0, 10.0}, 4, 1};
    run(check, &even);
    run(check, &short_ones); // several in a period
}

// The filter is still in the seg before when the riding ones begin.
static void what_rides_may_begin_with_its_seg(check_t *check)
{
    const ride_t within = {64, 16.0, {0.0, 10.0}, 1, 2};
    const ride_t all = {64, 64.0, {0.0, 10.0}, 1, 2};
    run(check, &within);
    run(check, &all);
}

// Time begins to count anew, again and again, while one rides.
static void time_goes_on_for_both(check_t *check)
{
    const ride_t ride = {4096, 3500.5, {0.0, 10.0}, 4, 1};
    const ride_t many = {1024, 1000.0, {0.0, 10.0}, 4, 1};
    run(check, &ride);
    run(check, &many);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, place_is_the_sum_of_both);
    CHECK_RUN(&check, motions_may_meet_between_two_ticks);
    CHECK_RUN(&check, what_rides_may_be_many_cells);
    CHECK_RUN(&check, what_rides_may_begin_with_its_seg);
    CHECK_RUN(&check, time_goes_on_for_both);
    return check_end(&check);
}
