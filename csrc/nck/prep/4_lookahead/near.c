// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#include "nck/prep/4_lookahead/near.h"

#include "nck/base/budget.h" // NCK_UNLIMITED

static void include(nck_near_t *near, const nck_junction_t *junction, double a, int pace) {
    near->a = nck_min(near->a, a);
    near->j = nck_min(near->j, junction->pace[pace].j);
}

void nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                     nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (count == 0) return;
        count--;
        const nck_junction_t *const junction = nck_junction_at(self, count);
        if ((junction->end & NCK_JUNCTION_STOP) || junction->kind >= NCK_SEG_DWELL) return;
        include(near_out, junction, nck_junction_accel(junction, beta, pace, self->terms), pace);
        time += junction->pace[pace].time;
        least += junction->pace[pace].least;
        if (least >= self->terms->mix_s) return;
    }
    near_out->slow = time / self->terms->mix_s;
}

nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                            nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (nck_junction_at(self, count)->end & NCK_JUNCTION_STOP) return NCK_OK;
        count++;
        if (count == self->junction.head && self->ended) return NCK_OK;
        if (count >= self->junction.settled) return NCK_EMPTY;
        const nck_junction_t *const junction = nck_junction_at(self, count);
        if (junction->kind >= NCK_SEG_DWELL) return NCK_OK;
        include(near_out, junction, nck_junction_accel(junction, beta, pace, self->terms), pace);
        time += junction->pace[pace].time;
        least += junction->pace[pace].least;
        if (least >= self->terms->mix_s) return NCK_OK;
    }
    near_out->slow = time / self->terms->mix_s;
    return NCK_OK;
}
