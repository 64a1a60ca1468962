// SPDX-License-Identifier: MIT
// Inside room 4: a junction's neighbours on both sides, nearest first.
#include "nck/prep/4_lookahead/walk.h"

#include "nck/base/budget.h"           // NCK_UNLIMITED
#include "nck/prep/4_lookahead/zone.h" // nck_zone_parts

static void cut_off(nck_walk_t *walk, nck_side_t *side) {
    side->state = NCK_SIDE_OVER;
    walk->cut = nck_min(walk->cut, side->x);
}

// A junction's load is known once the seg behind it is; nothing is shared across a rest.
static void walk_ahead(nck_lookahead_t *self, nck_walk_t *walk) {
    nck_side_t *const side = &walk->ahead;
    if (side->steps >= NCK_CORNER_SPAN) {
        cut_off(walk, side);
        return;
    }
    side->steps++;
    side->at++;
    if (side->at == self->joint.head) {
        side->state = self->ended ? NCK_SIDE_OVER : NCK_SIDE_UNKNOWN;
        return;
    }
    const nck_joint_t *const joint = nck_joint_at(self, side->at);
    const int newest = side->at + 1 == self->joint.head;
    side->x += joint->length;
    side->state = newest && !self->ended ? NCK_SIDE_UNKNOWN : NCK_SIDE_KNOWN;
    if (nck_zone_parts(joint, self->zone_s)) side->state = NCK_SIDE_OVER;
}

static void walk_behind(nck_lookahead_t *self, nck_walk_t *walk) {
    nck_side_t *const side = &walk->behind;
    if (side->steps >= NCK_CORNER_SPAN) {
        cut_off(walk, side);
        return;
    }
    if (side->at == 0 || nck_zone_parts(nck_joint_at(self, side->at - 1), self->zone_s)) {
        side->state = NCK_SIDE_OVER;
        return;
    }
    side->x += nck_joint_at(self, side->at)->length;
    side->steps++;
    side->at--;
}

void nck_walk_begin(nck_lookahead_t *self, nck_walk_t *walk, uint32_t count) {
    const nck_side_t here = {count, 0, 0.0, NCK_SIDE_KNOWN};
    walk->ahead = here;
    walk->behind = here;
    walk->cut = NCK_UNLIMITED;
    walk_ahead(self, walk);
    walk_behind(self, walk);
}

nck_status_t nck_walk_next(nck_lookahead_t *self, nck_walk_t *walk, double reach,
                           const nck_joint_t **joint_out, double *x_out) {
    const int forth = walk->behind.state == NCK_SIDE_OVER
                      || (walk->ahead.state != NCK_SIDE_OVER && walk->ahead.x <= walk->behind.x);
    const nck_side_t *const side = forth ? &walk->ahead : &walk->behind;
    if (side->state == NCK_SIDE_OVER || side->x >= reach) return NCK_DONE;
    if (side->state == NCK_SIDE_UNKNOWN) return NCK_EMPTY;
    *joint_out = nck_joint_at(self, side->at);
    *x_out = side->x;
    if (forth) {
        walk_ahead(self, walk);
    } else {
        walk_behind(self, walk);
    }
    return NCK_OK;
}
