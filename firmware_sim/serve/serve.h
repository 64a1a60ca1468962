// SPDX-License-Identifier: MIT
// The protocol of grbl 1.1 around one nck_t: bytes in, bytes out. It has no operating system and no
// streams, so that it runs on a microcontroller as it does on a PC. docs/serve.md says where it is
// not grbl.
//
//     nck_init(&nck, &machine, &hooks);      // on_output: serve_output, or what calls it
//     serve_init(&serve, &nck, &room, &port);
//     UART interrupt:     serve_receive(&serve, byte)
//     low-priority task:  serve_step, as long as it says NCK_OK, then until the next tick or byte
//     1 ms interrupt:     nck_tick(&nck, &pose, &axes); serve_tick(&serve, &pose)
#ifndef SERVE_H
#define SERVE_H

#include "nck/nck_session.h" // nck_t

// Sizes: the ring holds one byte less.
enum {
    SERVE_RING = 128,      // bytes that were received; a power of two
    SERVE_SIGNALS = 16,    // real-time bytes that wait; a power of two
    SERVE_LINE_MAX = 80,   // bytes of a line, blanks and comments left out
    SERVE_NOT_HOMED = 11   // serve_t.locked, above grbl's alarms
};

// Where the answers go. write: all bytes, before it comes back. Context: that of serve_step.
typedef struct serve_port {
    void *user;
    void (*write)(void *user, const char *bytes, uint32_t n);
} serve_port_t;

// What the line in work, or the session, is at.
typedef enum serve_phase {
    SERVE_READS = 0,  // a line is collected
    SERVE_GIVES = 1,  // one is to be pushed
    SERVE_TAKES = 2,  // and taken by the kernel to its end
    SERVE_SETTLES = 3,// all before it, and it, is to be executed
    SERVE_BRAKES = 4, // the path comes to rest, what is left of it is dropped
    SERVE_HOMES = 5,  // $H is in work
    SERVE_OWNS = 6    // behind a reset, an end, sleep, a stop by a switch: text of our own comes
} serve_phase_t;

// What a line does, bit by bit.
typedef enum serve_does {
    SERVE_LATE = 1,    // ok when it is executed
    SERVE_ENDS = 2,    // M2 or M30
    SERVE_SHIFTS = 4,  // it moves the work's zero, which waits for all before it
    SERVE_HAS_AXES = 8, // its axes are for something else than a probe
    SERVE_JOGS = 16    // a jog may have it
} serve_does_t;

// What comes when the line in work, or the brake, is over.
typedef enum serve_then {
    SERVE_THEN_OK = 0,      // ok
    SERVE_THEN_BANNER = 1,  // a reset is over
    SERVE_THEN_ENDED = 2,   // M2, M30: the modes of the beginning are there; ok
    SERVE_THEN_NOTHING = 3  // a jog is cancelled
} serve_then_t;

// What a tick leaves for reports.
typedef struct serve_seen {
    nck_pose_t pose;
    uint8_t moves;           // 1: the path does
    uint8_t goes;            // 1: it is not nck_is_idle
} serve_seen_t;

// When whoever knows the machine's switches is asked. What is not said returns 0.
typedef enum serve_event {
    SERVE_AT_STEP = 0,    // in every step; 1: the step is done
    SERVE_AT_PROBE = 1,   // a line that probes is to go: 1 now, 0 later, or it is over
    SERVE_AT_PROBED = 2,  // it is over
    SERVE_AT_HOME = 3,    // $H: its error
    SERVE_AT_BREAK = 4,   // $H is broken off
    SERVE_AT_RESUME = 5,  // 1: not now, the door is open
    SERVE_AT_STATUS = 6,  // a report wants its fields
    SERVE_AT_OFFSETS = 7, // $# wants where the probe touched; 1: it was said
    SERVE_AT_LIST = 8,    // $$ wants settings; 1: they were said
    SERVE_AT_SET = 9      // and above: $(event − 9)=set; 1: it is one
} serve_event_t;

// All of it: one static instance. What is asked for often stands first, which makes code smaller.
typedef struct serve {
    struct {                     // the line in work
        uint8_t error;           // to be answered, 0: none
        uint8_t comment;         // the byte that ends the comment in work; 0: none is
        uint8_t overflow;        // 1: longer than SERVE_LINE_MAX
        uint8_t jogs;            // 1: it is one
        uint8_t does;            // of serve_does_t
        uint8_t own;             // 1: nobody has sent it, or who has is gone
        uint8_t probes;          // G38.n: n; M66: 66; 0: it does not
        uint8_t size;            // of text
        uint32_t name;           // its N word
    } line;

    uint8_t phase;               // serve_phase_t
    uint8_t then;                // serve_then_t
    uint8_t jogging;             // 1: what is executed are jogs
    uint8_t locked;              // 1: an alarm
    uint8_t held;                // 1: by !, until ~
    uint8_t door;                // 1: by 0x84, until ~
    uint8_t checks;              // 1: $C
    uint8_t sleeps;              // 1: $SLP
    uint8_t waits;               // 1: a line is to be answered behind the brake
    uint8_t turned;              // coolant that the operator turned over, as in serve_coolant
    uint8_t wco_in, ov_in;       // reports until these are told again
    uint8_t flushed;             // 1: that nothing follows for now was said
    uint8_t renews;              // 1: no line is read until the tick has begun anew, too
    uint8_t idle;                // 1: nothing is under way, and all stands
    uint8_t text_waits;          // 1: the line in work is not taken to its end
    uint8_t mask;                // $10
    uint8_t inches;              // $13
    uint8_t moves, goes;         // of the last tick that was seen
    uint8_t tick_is;             // its nck_tick_state_t
    uint8_t after_return;        // 1: a line feed that comes next is of the line before
    uint8_t probe;               // the last G38.n that went

    nck_t *nck;
    int32_t feed, rapid, spindle; // overrides [%]
    uint32_t silence;            // tick of the last line
    uint32_t told;               // a sum over the offsets that were told

    struct {                     // received: heads by serve_receive, tails by serve_step
        uint32_t head, tail;
        uint32_t signal_head, signal_tail;
        uint32_t lost;           // 1: a byte found no room
        uint32_t rest;           // bytes of a UTF-8 letter still to be dropped; 4: C2 was the last
    } in;

    struct {                     // written by the tick
        uint32_t now;            // which of seen counts
        uint32_t ticks;
        uint32_t rpm;            // S
        uint32_t turns;          // M3: 1, M4: 2, M5: 0
        uint32_t coolant;        // bit 0: M7, bit 1: M8
    } tick;

    serve_port_t port;
    int (*beside)(struct serve *self, uint32_t event); // NULL: no switches
    double set;                    // of the $n=set in work
    struct inputs *inputs;         // serve_switches
    char text[SERVE_LINE_MAX + 8]; // of the line, behind a jog's prefix, ended by a line feed
    uint8_t signal[SERVE_SIGNALS]; // real-time bytes
    char ring[SERVE_RING];         // all others
    serve_seen_t seen[2];          // written by the tick
} serve_t;

// Begin, with the banner. nck: behind nck_init; nothing was pushed. room: memory that is nck's from
// now on (nck_begin_session). Returns NCK_OK, or what nck_begin_session does. Cost: constant.
// Context: prep, before the tick runs.
nck_status_t serve_init(serve_t *self, nck_t *nck, nck_decode_t *room, const serve_port_t *port);

// The machine has switches, which somebody gives to inputs_tick (inputs/inputs.h). Where it is to
// be homed it is locked until it is. Links beside.c, which is left out otherwise. Cost: constant.
// Context: prep, before the tick runs.
struct inputs;
void serve_switches(serve_t *self, struct inputs *inputs);

// A byte has come: serve_hear, and serve_put where it says 0. Cost: constant. Context: any, but
// one.
void serve_receive(serve_t *self, uint8_t byte);

// Take a byte if it is a real-time one, whatever it stands in, or of a letter that counts for
// nothing. Returns 0: it is one of a line. Cost: constant. Context: as serve_receive.
int serve_hear(serve_t *self, uint8_t byte);

// A byte of a line. What finds no room is lost, and the lines that wait then are refused. Cost:
// constant. Context: as serve_receive.
void serve_put(serve_t *self, uint8_t byte);

// 1 if one more byte finds room. Cost: constant. Context: any.
int serve_has_room(const serve_t *self);

// Somebody is connected: at rest that is a reset, with its banner; a session that was left in
// motion is as it was, and held. Cost: constant. Context: prep.
void serve_join(serve_t *self);

// The connection is gone: the path comes to rest and is held, what was received and is no line in
// work is dropped, and nothing is answered. Cost: constant. Context: prep.
void serve_part(serve_t *self);

// Do one bounded piece of work, nck_prep among it. Returns NCK_OK: call again; what is positive:
// when a byte has come or a tick has passed. Cost: as nck_prep's. Context: prep.
nck_status_t serve_step(serve_t *self);

// Behind each nck_tick: what it has given. Cost: constant. Context: tick.
void serve_tick(serve_t *self, const nck_pose_t *pose);

// What the program switches is told; user is the serve_t. Cost: constant. Context: tick.
void serve_output(void *user, const nck_output_t *output);

// The state as a report tells it. Cost: constant. Context: prep.
const char *serve_state(const serve_t *self);

// Of the programmed speed the spindle has so much [%]. Cost: constant. Context: any.
uint32_t serve_spindle(const serve_t *self);

// What coolant is on: bit 0: mist, bit 1: flood; by the program, turned over by the operator. Cost:
// constant. Context: any.
uint32_t serve_coolant(const serve_t *self);

#endif
