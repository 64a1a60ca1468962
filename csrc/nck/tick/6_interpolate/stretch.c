// SPDX-License-Identifier: MIT
// Inside room 6: the plan that is known of a clocked path, stretch by stretch.
#include "nck/tick/6_interpolate/stretch.h"

#include <string.h> // memset

#include "nck/base/cell_math.h" // nck_cell_way
#include "nck/base/path.h"      // nck_path_part nck_path_ways nck_path_way_at

static void know_seg(nck_stretch_seg_t *on, const nck_seg_t *seg, int axes) {
    if (on->seg == seg) return;
    on->seg = seg;
    on->per = 1 / (nck_num)seg->length;
    for (int x = 0; x < axes; x++) nck_path_ways(seg, x, on->ways[x]);
}

// Of a path that goes by time every seg is an interval of it.
void nck_stretch_look(nck_stretch_walk_t *walk, nck_stretch_point_t *out) {
    const nck_cell_t *const cell = walk->cell;
    know_seg(&walk->on, nck_link_seg(walk->link, cell->seg), walk->terms->axes);
    const nck_num t = walk->t;
    const nck_num per = walk->on.per;
    const nck_num jerk = (nck_num)cell->j;
    const nck_num a = (nck_num)cell->a + jerk * t;
    const nck_num v = (nck_num)cell->v + (a - NCK_NUM_OF(0.5) * jerk * t) * t;
    const nck_num way = (v - (NCK_NUM_OF(0.5) * a - jerk / 6 * t) * t) * t;
    const nck_num f = nck_num_min(((nck_num)cell->s + nck_num_max(0, way)) * per, 1);
    const nck_num rate = nck_num_max(0, v) * per;
    for (int x = 0; x < walk->terms->axes; x++) {
        const nck_num *const ways = walk->on.ways[x];
        const nck_num dd0 = ways[1] - ways[0];
        const nck_num bend = dd0 + (ways[2] - ways[1] - dd0) * f;
        const nck_num tangent = 3 * nck_path_way_at(ways, f);
        out->first[x] = tangent * rate;
        out->second[x] = 6 * bend * rate * rate + tangent * (a * per);
    }
}

void nck_stretch_place(nck_stretch_walk_t *walk, double t, double far, double *axis_out) {
    double left = t + far;
    for (uint32_t n = 0; n < NCK_TAIL_MAX && left > walk->cell->duration; n++) {
        const nck_cell_t *const next = nck_link_ahead(walk->link, walk->word, walk->next);
        if ((walk->cell->stop & NCK_STOP_REST) || !next) break;
        left -= walk->cell->duration;
        walk->cell = next;
        walk->next++;
    }
    const nck_cell_t *const cell = walk->cell;
    const double at = nck_max(0.0, nck_min(left, cell->duration));
    const double s = cell->s + nck_max(0.0, nck_min(nck_cell_way(cell, at), cell->length));
    walk->t = (nck_num)at;
    nck_path_part(nck_link_seg(walk->link, cell->seg), s, walk->terms->axes, axis_out);
}

// On by so much of the plan's time, or to its rest. Returns how far [s].
static nck_num walk_on(nck_stretch_walk_t *walk, nck_num far) {
    nck_num gone = 0;
    for (uint32_t n = 0; n < NCK_TAIL_MAX; n++) {
        const nck_num duration = (nck_num)walk->cell->duration;
        const nck_num left = duration - walk->t;
        if (gone + left >= far) {
            walk->t += far - gone;
            return far;
        }
        gone += left;
        walk->t = duration;
        const nck_cell_t *const next = nck_link_ahead(walk->link, walk->word, walk->next);
        walk->ends = (walk->cell->stop & NCK_STOP_REST) || !next;
        if (walk->ends) return gone;
        walk->cell = next;
        walk->next++;
        walk->t = 0;
    }
    return gone;
}

static void ways_of(const nck_stretch_t *on, int x, nck_stretch_ways_t *out) {
    const nck_num turn = on->to.second[x] - on->from.second[x];
    out->first[0] = on->from.first[x];
    out->first[1] = on->to.first[x];
    out->second[0] = on->from.second[x];
    out->second[1] = on->to.second[x];
    out->third[0] = on->far > 0 ? turn / on->far : 0;
    out->third[1] = out->third[0];
    out->rise = on->to.first[x] - on->from.first[x];
}

static void along_of(const nck_stretch_t *on, int axes, nck_stretch_ways_t *out) {
    memset(out, 0, sizeof *out);
    for (int n = 0; n < 2; n++) {
        const nck_stretch_point_t *const at = n == 0 ? &on->from : &on->to;
        nck_num square = 0;
        for (int x = 0; x < axes; x++) square += at->first[x] * at->first[x];
        out->first[n] = NCK_NUM_SQRT(square);
        const nck_num per = square > 0 ? 1 / out->first[n] : 0; // 0: it rests there
        for (int x = 0; x < axes; x++) {
            nck_stretch_ways_t own;
            const nck_num share = per * at->first[x];
            ways_of(on, x, &own);
            out->second[n] += share * own.second[n];
            out->third[n] += share * own.third[n];
            if (n == 1) out->rise += share * own.rise;
        }
    }
}

// What stands is asked nothing.
static int moves(const nck_stretch_ways_t *ways) {
    return ways->first[0] != 0 || ways->first[1] != 0 || ways->second[0] != 0
           || ways->second[1] != 0;
}

void nck_stretch_limits(const nck_terms_t *terms, nck_stretch_limit_t *limit_out) {
    const nck_machine_t *const machine = terms->machine;
    for (int x = 0; x < terms->axes; x++) {
        limit_out[x].a_max = (nck_num)machine->axis[x].a_max;
        limit_out[x].j_max = (nck_num)machine->axis[x].j_max;
    }
    limit_out[NCK_AXIS_MAX].a_max = (nck_num)machine->path.a_max;
    limit_out[NCK_AXIS_MAX].j_max = (nck_num)machine->path.j_max;
}

static void set_ways(nck_stretch_t *on, const nck_stretch_walk_t *walk) {
    const nck_terms_t *const terms = walk->terms;
    on->count = 0;
    for (int x = 0; x < terms->axes; x++) {
        nck_stretch_ways_t *const ways = &on->of[on->count];
        if (!terms->machine->axis[x].present) continue;
        ways_of(on, x, ways);
        ways->limit = walk->limit[x];
        on->count += moves(ways);
    }
    if (!terms->limits_path) return;
    nck_stretch_ways_t *const ways = &on->of[on->count++];
    along_of(on, terms->axes, ways);
    ways->limit = walk->limit[NCK_AXIS_MAX];
}

// The next stretch.
void nck_stretch_take(nck_stretch_walk_t *walk, nck_num far, nck_stretch_t *stretch) {
    stretch->from = stretch->to;
    stretch->far = walk_on(walk, far);
    nck_stretch_look(walk, &stretch->to);
    set_ways(stretch, walk);
}
