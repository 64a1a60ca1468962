// SPDX-License-Identifier: MIT
// Inside room 6: how the tool follows the spindle's angle. As it is told, where the axes can; where
// they cannot, at the pace of before and towards it. What comes of that is lost if it is too far
// beside the angle, or if the spindle hardly turns.
#ifndef NCK_TICK_FOLLOW_H
#define NCK_TICK_FOLLOW_H

#include "nck/tick/6_interpolate/sync.h" // nck_sync_t

#define NCK_FOLLOW_FASTER 1.05 // than commanded: what a pass is planned for (base/thread.c)
#define NCK_FOLLOW_SLACK 2e-3  // [s] by which the tool may be beside the angle, in pass time
// Of the commanded speed: a spindle that is slower stops, or does not follow its command. Operators
// may set it to half, and what is uneven is so by a few per cent.
#define NCK_FOLLOW_SLOWEST 0.1

// What the spindle has turned since the tick before. Once a tick. Cost: constant. Context: tick.
void nck_follow_look(nck_sync_t *self, double rpm, double period);

// 1 if the pass begins with this tick: the angle has come, and the spindle turns. Else the next
// such angle is waited for. Cost: constant. Context: tick.
int nck_follow_begins(nck_sync_t *self, double rpm, double period);

// The angle is waited for anew: the next one like it. Cost: constant. Context: tick.
void nck_follow_aim(nck_sync_t *self);

// How the tool may go.
typedef struct nck_follow_room {
    double least;  // rate of a spindle that turns back as fast as it may
    double most;   // the furthest t: before it the tool brakes [s]
    double change; // of the rate, that X can follow beside the pass [1/s]
    double rpm;    // commanded [1/min]
    double period; // of the tick [s]
    nck_moment_t at, far; // of the pass: at t of the tick before, and as far on as it may be now
} nck_follow_room_t;

// t and rate of this tick. Returns by how much the spindle is ahead of the tool [s].
// Cost: constant. Context: tick.
double nck_follow(nck_sync_t *self, const nck_follow_room_t *room);

// 1 if the spindle hardly turns, for so long that it is none of the encoder's steps. way: 1 or −1,
// how it is to turn. Once a tick. Cost: constant. Context: tick.
int nck_follow_is_slow(nck_sync_t *self, double way, double period);

#endif
