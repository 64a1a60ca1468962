// SPDX-License-Identifier: MIT
// Inside room 3: the clock's guess from the program's shape, and what is kept of a plan.
#include "nck/base/real.h"                 // nck_max nck_min nck_num nck_sqrt
#include "nck/base/root_math.h"            // nck_root_cube
#include "nck/base/tuning.h"               // NCK_START
#include "nck/prep/3_smooth/timing.h"
#include "nck/prep/3_smooth/timing_math.h" // nck_timing_reach_speed …
#include "nck/prep/3_smooth/tuning.h" // NCK_TIMING_REACH …

#define RUNG 1.4422495703074083 // ∛3: what a rung is longer than the last one; the third from it
                                // is 3 times as long
#define USE ((nck_num)NCK_START) // of what rungs allow: a curve is not as good everywhere
#define FAR ((nck_num)1e9) // [path mm] is beyond any path

// How far a place looks about, in time at the feed [s].
static double reach_of(const nck_timing_t *self) { return NCK_TIMING_REACH * self->terms->tau; }

void nck_timing_begin(nck_timing_t *self, const nck_timing_terms_t *terms) {
    self->terms = terms;
    self->closed = 0;
    self->looked = 0;
    self->hurries = 0;
    self->brakes = 0;
    self->ends = 0;
    self->begins = 1;
    self->even = 0;
    self->phase = NCK_TIMING_ADD;
    self->at = 0;
    self->knots = 0;
    self->guess.head = 0;
    self->guess.tail = 0;
    self->guess.v = 0;
    for (int k = 0; k <= 2 * NCK_TIMING_RUNGS; k++) self->guess.near[k] = 0;
    self->s[0] = 0.0;
}

// What the rungs find at a place: v² ≤ 1/second, v³ ≤ 1/third, and the steepest axis.
typedef struct bends {
    nck_num second; // [s²/mm²]
    nck_num third;  // [s³/mm³]
} bends_t;

// The path so far before and behind a place, from there.
typedef struct rung {
    nck_num h;
    nck_num front[NCK_AXIS_MAX];
    nck_num back[NCK_AXIS_MAX];
} rung_t;

// A place while it is looked at.
typedef struct sight {
    double known;      // the path is known to here [path mm]
    nck_num room;      // so far before it and behind it at least, or it goes on straight [mm]
    nck_num tolerance; // P [mm]
    nck_track_view_t middle;
    nck_num odd[4][NCK_AXIS_MAX]; // p(s + h) − p(s − h) of the last four rungs
} sight_t;

// Add what the rung n, of the length h, shows:
//   v²(|δ²p| − 4P) ≤ A h²      δ²p = p(s + h) − 2 p(s) + p(s − h)
//   v³(|δ³p| − 8P) ≤ J (2h′)³  δ³p = p(s + h) − 3 p(s + h′) + 3 p(s − h′) − p(s − h),  h′ = h/3
// for each point may be P off.
static void add_rung(const nck_timing_terms_t *terms, sight_t *sight, int n, const rung_t *rung,
                     bends_t *bends) {
    const nck_num h = rung->h;
    const nck_num l = 2 * h / 3;
    nck_num *const odd = sight->odd[n % 4];
    const nck_num *const inner = sight->odd[(n + 1) % 4];
    for (int x = 0; x < terms->axes; x++) {
        const nck_num even = NCK_NUM_ABS(rung->front[x] + rung->back[x]);
        const nck_num second = (even - 4 * sight->tolerance) / (terms->a[x] * h * h);
        odd[x] = rung->front[x] - rung->back[x];
        bends->second = nck_num_max(bends->second, second);
        if (n < 3) continue;
        const nck_num turn = NCK_NUM_ABS(odd[x] - 3 * inner[x]);
        const nck_num third = (turn - 8 * sight->tolerance) / (terms->j[x] * l * l * l);
        bends->third = nck_num_max(bends->third, third);
    }
}

// The speed that the axes' own speeds allow, by the path's direction over the first rung.
static nck_num axis_speed(const nck_timing_terms_t *terms, const nck_num *odd, nck_num h) {
    nck_num slowness = (nck_num)1e-9;
    for (int x = 0; x < terms->axes; x++) {
        slowness = nck_num_max(slowness, NCK_NUM_ABS(odd[x]) / (2 * h * terms->v[x]));
    }
    return 1 / slowness;
}

static void find_offset(nck_timing_t *self, const nck_track_t *track, sight_t *sight, int k,
                        double s, nck_num *offset_out) {
    self->guess.near[k] = nck_track_find(track, self->guess.near[k], s);
    nck_track_offset(track, &sight->middle, self->guess.near[k], s, offset_out);
}

// How fast the place may be passed, as its surroundings up to `reach` show.
static nck_num look_around(nck_timing_t *self, const nck_track_t *track, sight_t *sight,
                          nck_num reach) {
    const nck_timing_terms_t *const terms = self->terms;
    rung_t rung;
    bends_t bends = {0, 0};
    nck_num v = (nck_num)1e9;
    nck_num h = 2 * sight->tolerance;
    for (int n = 0; n < NCK_TIMING_RUNGS && (n < 1 || h <= reach) && h <= sight->room; n++) {
        find_offset(self, track, sight, 2 * n, sight->middle.s + (double)h, rung.front);
        find_offset(self, track, sight, 2 * n + 1, sight->middle.s - (double)h, rung.back);
        rung.h = h;
        add_rung(terms, sight, n, &rung, &bends);
        if (h <= 2 * sight->tolerance) v = axis_speed(terms, sight->odd[0], h);
        h *= (nck_num)RUNG;
    }
    if (v * v * bends.second > USE * USE) v = USE / NCK_NUM_SQRT(bends.second);
    if (v * v * v * bends.third > USE * USE * USE) {
        v = USE * (nck_num)nck_root_cube(1.0 / (double)bends.third);
    }
    const nck_num tau = (nck_num)terms->tau;
    const nck_num least = NCK_NUM_OF(0.5) * terms->smooth_least * tau * tau;
    return nck_num_max(v, least);
}

// Where the next place is: half a knot on at the speed that is reached. Towards the run's end half
// of the way that is left, so that there is one within the shortest run.
static double next_place(nck_timing_t *self, double end) {
    const nck_timing_terms_t *const terms = self->terms;
    const double half = 0.5 * terms->tau;
    const double least = NCK_TIMING_LEAVE * (double)terms->smooth_least * half * half * half / 6.0;
    if (self->guess.head == 0) return 0.0;
    const nck_place_t *const last = nck_timing_place(self, self->guess.head - 1);
    const nck_num rate = nck_timing_rate(terms, self->guess.v, last->wide);
    const double s = last->s;
    const double step = nck_max(least, half * (double)rate);
    if (!self->closed) return s + step;
    return s > 0.0 && end - s <= least ? end : s + nck_min(step, 0.5 * (end - s));
}

// How fast a place may be passed by all that is known.
static nck_num speed_of(nck_timing_t *self, const nck_track_t *track, sight_t *sight,
                       const nck_track_element_t *element) {
    const double s = sight->middle.s;
    const nck_num reach = (nck_num)reach_of(self) * (nck_num)element->feed;
    const nck_num around = look_around(self, track, sight, reach);
    const nck_num feed = (nck_num)nck_track_feed(track, sight->middle.count, s);
    const nck_num v = nck_timing_near_rest(self->terms, s, nck_num_min(around, feed));
    return self->closed ? nck_timing_near_rest(self->terms, sight->known - s, v) : v;
}

// The guess goes on to a place.
static void add_place(nck_timing_t *self, double s, nck_num v, nck_num wide) {
    if (self->guess.head > 0) {
        const double h = s - nck_timing_place(self, self->guess.head - 1)->s;
        const nck_num most = nck_timing_reach_speed(self->terms, NCK_TIMING_ASK, self->guess.v, h);
        self->guess.v = nck_num_min(v, most);
    }
    nck_place_t *const place = nck_timing_place(self, self->guess.head++);
    place->s = s;
    place->v = v;
    place->wide = wide;
}

// How fast the clock may be at s, by how far the ends of its element are; near: an element to begin
// with, and the one found [path mm/s].
static nck_num wide_at(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                       double s) {
    const nck_timing_terms_t *const terms = self->terms;
    if (self->even) return 0;
    *near = nck_track_find(track, *near, s);
    const nck_track_element_t *const element = nck_track_at(track, *near);
    const nck_num feed = (nck_num)nck_track_feed(track, *near, s);
    const nck_num v = nck_num_min(feed, terms->v_most);
    if (element->plane || !(terms->longest > 1) || !(v > 0)) return 0;
    const nck_num way = (nck_num)(s - element->s);
    const nck_num length = (nck_num)element->length;
    const nck_num tau = (nck_num)terms->tau;
    const nck_num swings = NCK_NUM_SQRT(NCK_TIMING_SWINGS * terms->j_least / v);
    const nck_num grows = nck_num_min(NCK_TIMING_GROWS / tau, swings);
    const nck_num most = NCK_TIMING_TURNS * (nck_num)nck_track_even(track, *near, s) / tau;
    return nck_num_min(most, nck_num_max(grows * way * (1 - way / length), 0));
}

// How far the path is known to both sides of s, or goes on straight.
static nck_num room_at(const nck_timing_t *self, const nck_track_t *track, double s) {
    const double first = nck_track_at(track, track->tail)->s;
    const nck_num ahead = self->closed ? FAR : (nck_num)(nck_track_known(track) - s);
    return first > 0.0 ? nck_num_min(ahead, (nck_num)(s - first)) : ahead;
}

nck_status_t nck_timing_look(nck_timing_t *self, const nck_track_t *track) {
    self->brakes = 0;
    if (self->looked || self->guess.head - self->guess.tail == NCK_TIMING_PLACES) return NCK_DONE;
    sight_t sight = {.known = nck_track_known(track)};
    if (!(sight.known > 0.0)) return self->closed ? NCK_DONE : NCK_EMPTY;
    const double s = next_place(self, sight.known);
    uint32_t *const near = &self->guess.near[2 * NCK_TIMING_RUNGS];
    *near = nck_track_find(track, *near, s);
    const nck_track_element_t *const element = nck_track_at(track, *near);
    if (!self->closed && s + reach_of(self) * element->feed > sight.known) {
        if (!nck_track_is_full(track) && !self->hurries) return NCK_EMPTY;
        self->brakes = self->guess.head - self->guess.tail < NCK_FAIR_WINDOW;
        if (s > sight.known) return NCK_DONE;
    }
    sight.room = room_at(self, track, s);
    sight.tolerance = (nck_num)element->tolerance;
    nck_track_view(track, *near, s, &sight.middle);
    const nck_num wide = wide_at(self, track, near, s);
    add_place(self, s, speed_of(self, track, &sight, element), wide);
    self->looked = self->closed && s >= sight.known;
    return NCK_OK;
}

int nck_timing_hurry(nck_timing_t *self) {
    self->hurries = self->guess.head - self->guess.tail >= NCK_FAIR_WINDOW;
    return self->hurries;
}

double nck_timing_reach(const nck_timing_t *self, const nck_track_t *track) {
    const uint32_t near = nck_track_find(track, track->tail, self->s[0]);
    return reach_of(self) * nck_track_at(track, near)->feed;
}

void nck_timing_drop(nck_timing_t *self, double s) {
    while (self->guess.tail + 1 < self->guess.head
           && nck_timing_place(self, self->guess.tail)->s < s) {
        self->guess.tail++;
    }
}

// ds/du at a quarter.
static nck_num speed_at(const nck_timing_t *self, int k, int last) {
    const nck_num quarter = (nck_num)(0.25 * self->terms->tau);
    if (k == 0) return self->begins ? 0 : (nck_num)(self->s[1] - self->s[0]) / quarter;
    if (self->ends && k == last) return 0;
    return (nck_num)(self->s[k + 1] - self->s[k - 1]) / (2 * quarter);
}

static nck_num clamp(nck_num x, nck_num least, nck_num most) {
    return nck_num_min(nck_num_max(x, least), most);
}

// The plan's du/dt at a quarter.
static nck_num pace_at(const nck_num *b, int k) {
    const int knot = k / 4;
    const nck_num w = (nck_num)0.25 * (nck_num)(k % 4);
    const nck_num at = w > 0 ? b[knot] + w * (b[knot + 1] - b[knot]) : b[knot];
    return NCK_NUM_SQRT(nck_num_max(at, 0));
}

// How much of a plan comes into the clock at a quarter: smoothly over `blend` knots.
static nck_num share_at(int k, int from, int blend) {
    const nck_num way = (nck_num)0.25 * (nck_num)k - (nck_num)from;
    const nck_num g = blend > 0 ? clamp(way / (nck_num)blend, 0, 1) : 1;
    return g * g * (3 - 2 * g);
}

int nck_timing_is_wide(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                       int knot) {
    const nck_num now = speed_at(self, 4 * knot, 4 * self->knots);
    return now > 0 && wide_at(self, track, near, self->s[4 * knot]) > now;
}

double nck_timing_pace(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                       int knot) {
    const double s = self->s[4 * knot];
    const double rate = (double)speed_at(self, 4 * knot, 4 * self->knots);
    if (!nck_timing_is_wide(self, track, near, knot)) return 1.0;
    const nck_track_element_t *const element = nck_track_at(track, *near);
    const double way = nck_min(s - element->s, element->s + element->length - s);
    const double feed = nck_track_feed(track, *near, s);
    const double vv = nck_min(feed * feed, 2.0 * (double)self->terms->a_least * way);
    return nck_min(1.0, vv / (rate * rate));
}

// By what a clock of the speed `now` differs from one that is `wanted`.
static nck_num factor_of(nck_num now, nck_num wanted) { return now > 0 ? wanted / now : 1; }

nck_num nck_timing_factor(const nck_timing_t *self, const nck_track_t *track, uint32_t *near,
                          int knot, nck_num b) {
    const nck_num now = speed_at(self, 4 * knot, 4 * self->knots);
    const nck_num wide = wide_at(self, track, near, self->s[4 * knot]);
    const nck_num v = now * NCK_NUM_SQRT(nck_num_max(b, 0));
    return factor_of(now, nck_timing_rate(self->terms, v, wide));
}

// What is kept at a quarter, whose s and `wide` are known: the clock's speed there by the plan, and
// the path's.
static void keep_place(const nck_timing_t *self, nck_num pace, nck_num share, int k,
                       nck_place_t *out) {
    const nck_num now = speed_at(self, k, 4 * self->knots);
    const nck_num v = now * pace;
    const nck_num rate = nck_timing_rate(self->terms, v, out->wide);
    const nck_num factor = nck_num_min(factor_of(now, rate), NCK_TIMING_FASTEST);
    const nck_num blended = now * (1 + (factor - 1) * share);
    const nck_num scale = rate > 0 ? blended / rate : 1;
    out->v = scale * v;
    out->wide *= scale;
}

void nck_timing_begin_keep(nck_timing_t *self, nck_timing_list_t *list, const nck_track_t *track,
                           const int span[3]) {
    self->keep.from = span[0];
    self->keep.to = span[1];
    self->keep.blend = span[2];
    self->keep.near = track->tail;
    self->at = 4 * span[0];
    list->count = 0;
}

// A quarter of the clock is kept, if it goes on there.
static void keep_quarter(nck_timing_t *self, nck_timing_list_t *list, const nck_track_t *track,
                         const nck_num *b, int k) {
    if (list->count > 0 && !(self->s[k] > list->at[list->count - 1].s + 1e-9)) return;
    const nck_num share = share_at(k, self->keep.from, self->keep.blend);
    // At a seam no row stands at the first node: its b is of no use.
    const nck_num pace = pace_at(b, self->begins || k > 4 ? k : 4);
    nck_place_t *const place = &list->at[list->count++];
    place->s = self->s[k];
    place->wide = wide_at(self, track, &self->keep.near, place->s);
    keep_place(self, pace, share, k, place);
}

nck_status_t nck_timing_keep(nck_timing_t *self, nck_timing_list_t *list,
                             const nck_track_t *track, const nck_num *b) {
    const int all = self->keep.to > self->keep.from ? 4 * self->keep.to + 1 : self->at;
    for (int n = 0; n < NCK_TIMING_SLICE && self->at < all; n++) {
        keep_quarter(self, list, track, b, self->at++);
    }
    if (self->at < all) return NCK_OK;
    list->kept = list->count;
    if (self->keep.from > 0) self->begins = 0;
    self->phase = NCK_TIMING_ADD;
    self->at = 0;
    return NCK_DONE;
}

void nck_timing_rest(nck_timing_t *self, nck_timing_list_t *list, double s) {
    list->at[0].s = s;
    list->at[0].v = 0;
    list->at[0].wide = 0;
    list->count = 1;
    list->kept = 1;
    self->begins = 1;
    self->phase = NCK_TIMING_ADD;
    self->at = 0;
}
