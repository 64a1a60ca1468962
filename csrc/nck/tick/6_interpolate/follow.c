// SPDX-License-Identifier: MIT
// Inside room 6: how the tool follows the spindle's angle.
#include "nck/tick/6_interpolate/follow.h"

#include "nck/base/real.h" // nck_fabs nck_floor nck_max nck_min nck_sqrt

#define SECONDS 60.0
#define ROUNDING 1e-9 // of a rate: what differences of angles lose
#define BRAKES (8.0 / 9.0) // of what the axes have: the last period of make_up takes 9/8
#define SPEED_LEAST 1e-9 // [mm/s] a tool that is slower takes any change of pace

void nck_follow_look(nck_sync_t *self, double rpm, double period) {
    self->spin = (self->turns - self->seen) * SECONDS / (rpm * period);
    self->seen = self->turns;
}

void nck_follow_aim(nck_sync_t *self) {
    const double ahead = self->begin - self->turns;
    if (ahead <= 0.0 || ahead > 1.0) self->begin = self->turns + (ahead - nck_floor(ahead));
}

// An angle that comes out of turn is none: it has jumped there, or the spindle still starts.
int nck_follow_begins(nck_sync_t *self, double rpm, double period) {
    const double turned = (self->turns - self->begin) * SECONDS / rpm;
    if (!self->measured) return turned >= 0.0;
    const double most = NCK_FOLLOW_FASTER * period + NCK_FOLLOW_SLACK;
    const int comes = turned >= 0.0 && turned <= most && self->spin >= NCK_FOLLOW_SLOWEST;
    if (comes) self->rate = nck_min(self->spin, NCK_FOLLOW_FASTER);
    else nck_follow_aim(self);
    return comes;
}

// The rate that makes up for being beside by so much, and can be taken back in time. With steps of
// x = c·T a tick, c the change that is used:
//   r·T + r²/(2c) + r·T/2 ≥ e      r = √(x²/4 + 2·c·e) − x/2, no more than e/T
static double make_up(double beside, double change, double period) {
    const double e = nck_fabs(beside);
    const double half = 0.5 * change * period;
    const double root = nck_sqrt(half * half + 2.0 * change * e);
    const double rate = nck_min(e / period, 2.0 * change * e / (root + half));
    return beside < 0.0 ? -rate : rate;
}

// The rates that the axes can go on with: from one period, at the rate r, to the next, at q,
//   a = s′·(q − r)/T + s″·(q² + r²)/2      stays within what they have
static void find_range(const nck_sync_t *self, const nck_follow_room_t *room, double *range) {
    const double a = self->pass.ramp.a * NCK_FOLLOW_FASTER * NCK_FOLLOW_FASTER;
    const double v = nck_max(room->at.v, SPEED_LEAST);
    const double rr = self->rate * self->rate;
    const double rr_most = 0.5 * (rr + NCK_FOLLOW_FASTER * NCK_FOLLOW_FASTER);
    const double high = nck_max(self->was, nck_max(room->at.a, room->far.a));
    const double low = nck_min(self->was, nck_min(room->at.a, room->far.a));
    const double up = a - (high > 0.0 ? high * rr_most : high * rr);
    const double down = a + (low > 0.0 ? 0.5 * low * rr : low * rr_most);
    const double more = nck_min(room->change, nck_max(0.0, up) / v) * room->period;
    const double less = nck_min(room->change, nck_max(0.0, down) / v) * room->period;
    const double brakes = make_up(room->most - self->t, BRAKES * a / v, room->period);
    range[0] = nck_max(room->least, self->rate - less);
    range[1] = nck_min(NCK_FOLLOW_FASTER, self->rate + more);
    range[1] = nck_max(range[0], nck_min(range[1], brakes));
}

// The angle says what the axes cannot do. A spindle does not stand at once: if it seems to, the
// tool goes on until it is lost, or the angle comes again.
static double go_on(const nck_sync_t *self, const nck_follow_room_t *room, const double *range,
                    double left) {
    const double period = room->period;
    const int turns = self->spin >= range[0] && self->spin <= range[1];
    const double spin = turns ? self->spin : self->rate;
    const double most = self->pass.ramp.a / nck_max(room->at.v, SPEED_LEAST);
    const double change = 0.5 * nck_min(most, room->change);
    if (!turns && self->spin * self->rate <= 0.0) return self->rate;
    return spin + make_up(left - spin * period, change, period);
}

double nck_follow(nck_sync_t *self, const nck_follow_room_t *room) {
    const double wanted = (self->turns - self->begin) * SECONDS / room->rpm;
    const double left = wanted - self->t;
    double range[2] = {room->least, NCK_FOLLOW_FASTER};
    double rate = left / room->period;
    if (self->measured && self->t == 0.0) { // it begins between two ticks
        self->t = nck_max(0.0, nck_min(wanted, NCK_FOLLOW_FASTER * room->period));
        return wanted - self->t;
    }
    if (self->measured) find_range(self, room, range);
    self->was = room->at.a;
    if (rate >= range[0] - ROUNDING && rate <= range[1] + ROUNDING) {
        self->rate = rate;
        self->t = wanted;
        return 0.0;
    }
    if (self->measured) {
        // of a stop: the spindle is taken to do as it is commanded
        rate = self->state == NCK_SYNC_STOPS ? self->rpm / room->rpm
                                             : go_on(self, room, range, left);
    }
    self->rate = nck_max(range[0], nck_min(range[1], rate));
    self->t += self->rate * room->period;
    return wanted - self->t;
}

int nck_follow_is_slow(nck_sync_t *self, double way, double period) {
    const double lacks = (NCK_FOLLOW_SLOWEST - way * self->spin) * period;
    self->slow = self->measured ? nck_max(0.0, self->slow + lacks) : 0.0;
    return self->slow > NCK_FOLLOW_SLACK;
}
