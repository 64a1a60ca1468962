// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#include "nck/prep/4_lookahead/near.h"

#include "nck/base/budget.h" // NCK_UNLIMITED

// Of a walk away from a seg.
typedef struct walked {
    double time;   // at the speeds that are allowed [s]
    double least;  // at least [s]
    double gained; // v² at most [(path mm/s)²]
} walked_t;

// The walk comes to a junction that is passed at v at most.
static void meet(nck_near_t *near, const walked_t *walked, double v) {
    near->vv = nck_min(near->vv, v * v + walked->gained);
}

// The walk passes a seg.
static void pass(nck_near_t *near, walked_t *walked, const nck_junction_t *junction, double a,
                 int pace) {
    const nck_pace_t *const at = &junction->pace[pace];
    near->a = nck_min(near->a, a);
    near->j = nck_min(near->j, at->j);
    walked->time += at->time;
    walked->least += at->least;
    walked->gained += 2.0 * a * junction->length;
}

void nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double left,
                     nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0, NCK_UNLIMITED};
    walked_t walked = {0.0, 0.0, 0.0};
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        const nck_junction_t *const junction =
            count > 0 ? nck_junction_at(self, count - 1) : (nck_junction_t *)0;
        const int rests = nck_near_rests(junction);
        meet(near_out, &walked, rests ? 0.0 : junction->pace[pace].v_corner);
        if (rests) return;
        count--;
        const double a = nck_junction_accel(junction, left, pace, self->terms);
        pass(near_out, &walked, junction, a, pace);
        if (walked.least >= self->terms->mix_s) return;
    }
    near_out->slow = walked.time / self->terms->mix_s;
}

nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double left,
                            nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0, NCK_UNLIMITED};
    walked_t walked = {0.0, 0.0, 0.0};
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        const nck_junction_t *junction = nck_junction_at(self, count);
        const int stops = junction->end & NCK_JUNCTION_STOP;
        count++;
        const int ends = stops || (count == self->junction.head && self->ended);
        if (!ends && count >= self->junction.settled) return NCK_EMPTY;
        const nck_junction_t *const next = nck_junction_at(self, count);
        const int rests = ends || next->kind >= NCK_SEG_DWELL;
        meet(near_out, &walked, rests ? 0.0 : junction->pace[pace].v_corner);
        if (rests) return NCK_OK;
        junction = next;
        const double a = nck_junction_accel(junction, left, pace, self->terms);
        pass(near_out, &walked, junction, a, pace);
        if (walked.least >= self->terms->mix_s) return NCK_OK;
    }
    near_out->slow = walked.time / self->terms->mix_s;
    return NCK_OK;
}
