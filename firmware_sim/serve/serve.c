// SPDX-License-Identifier: MIT
// The session: what is received becomes lines, lines go to the kernel one by one, and each is
// answered once.
#include "serve/serve.h"

#include <string.h> // memcpy memset

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "serve/parts.h"

enum {
    QUIET_TICKS = 20, // at rest without a line for so long: nothing follows for now
    REPORTS = 0x3,    // $10: machine position, and what room there is
    WHOLE = 100       // [%]
};

static const char at_reset[] = "G92.1G49G54M5M9\n"; // what a reset undoes
enum { AT_END = 8 }; // from there on: the end of a program, sleep, alarms of limits, too

// ---- what the tick tells

const serve_seen_t *serve_seen(const serve_t *self) {
    return &self->seen[nck_fence_load(&self->tick.now)];
}

void serve_tick(serve_t *self, const nck_pose_t *pose) {
    const uint32_t next = 1 - self->tick.now;
    serve_seen_t *const seen = &self->seen[next];
    seen->pose = *pose;
    seen->moves = pose->v > 0.0 || pose->state == NCK_TICK_MOVE;
    seen->goes = !nck_is_idle(self->nck);
    nck_fence_store(&self->tick.now, next);
    nck_fence_store(&self->tick.ticks, self->tick.ticks + 1);
}

// M3, M4, M5; M7, M8, M9.
static void switch_code(serve_t *self, uint32_t code) {
    const uint32_t coolant = self->tick.coolant;
    if (code >= 3 && code <= 5) self->tick.turns = code == 5 ? 0 : code - 2;
    if (code >= 7 && code <= 9) {
        nck_fence_store(&self->tick.coolant, code == 9 ? 0 : coolant | (code - 6));
    }
}

void serve_output(void *user, const nck_output_t *output) {
    serve_t *const self = user;
    const uint32_t value = (uint32_t)output->value;
    if (output->kind == NCK_OUTPUT_SPINDLE_SPEED) self->tick.rpm = value;
    if (output->kind == NCK_OUTPUT_M) switch_code(self, value);
}

uint32_t serve_spindle(const serve_t *self) { return (uint32_t)self->spindle; }

uint32_t serve_coolant(const serve_t *self) {
    return nck_fence_load(&self->tick.coolant) ^ self->turned;
}

int serve_beside(serve_t *self, uint32_t event) {
    return self->beside ? self->beside(self, event) : 0;
}

// ---- signals

// What the kernel has to do, once a step.
static void look(serve_t *self) {
    nck_queue_t queue;
    nck_queue(self->nck, &queue);
    const serve_seen_t *const seen = serve_seen(self);
    const uint32_t left = queue.segs + queue.outputs + queue.smooth + queue.text;
    self->text_waits = (uint8_t)queue.text;
    self->moves = seen->moves;
    self->goes = seen->goes;
    self->tick_is = seen->pose.state;
    self->idle = !(left | seen->goes | seen->moves);
}

// Jogs are deaf to overrides.
void serve_override(serve_t *self) {
    const uint32_t feed = self->jogging ? WHOLE : (uint32_t)self->feed;
    const uint32_t rapid = self->jogging ? WHOLE : (uint32_t)self->rapid;
    nck_set_override(self->nck, feed * NCK_PERCENT, rapid * NCK_PERCENT);
}

void serve_brake(serve_t *self, serve_then_t then) {
    nck_abort(self->nck);
    self->phase = SERVE_BRAKES;
    self->then = (uint8_t)then;
}

static void drop_input(serve_t *self) {
    nck_fence_store(&self->in.tail, nck_fence_load(&self->in.head));
}

static void clear_line(serve_t *self) { memset(&self->line, 0, sizeof self->line); }

static void begin(serve_t *self) {
    self->held = self->door = self->checks = self->sleeps = self->waits = self->turned = 0;
    self->feed = self->rapid = self->spindle = WHOLE;
}

static void reset(serve_t *self) {
    if (self->phase == SERVE_HOMES) (void)serve_beside(self, SERVE_AT_BREAK);
    drop_input(self);
    nck_fence_store(&self->in.lost, 0);
    clear_line(self);
    begin(self);
    serve_brake(self, SERVE_THEN_BANNER);
}

// Returns 1 if jogs are executed, or one is on its way to the kernel.
static int cancel_jog(serve_t *self) {
    if (!self->jogging && (!self->line.jogs || self->phase == SERVE_READS)) return 0;
    if (self->phase != SERVE_BRAKES) {
        self->waits = self->phase != SERVE_READS;
        serve_brake(self, SERVE_THEN_NOTHING);
    }
    return 1;
}

void serve_hold(serve_t *self, int door) {
    if (self->phase == SERVE_HOMES) {
        (void)serve_beside(self, SERVE_AT_BREAK);
        self->waits = 1;
        serve_brake(self, SERVE_THEN_NOTHING);
    }
    if (self->checks || self->locked || self->sleeps) return;
    if (door) self->door = 1;
    if (!cancel_jog(self) && self->phase != SERVE_BRAKES) self->held = 1;
}

static void resume(serve_t *self) {
    const int waits = self->tick_is == NCK_TICK_WAIT;
    if (serve_beside(self, SERVE_AT_RESUME)) return;
    if ((self->held || waits) && self->phase != SERVE_BRAKES) nck_resume(self->nck);
    self->held = self->door = 0;
}

// 0x90 … 0x94 the feed, 0x95 … 0x97 rapids, 0x99 … 0x9d the spindle.
static void change_override(serve_t *self, uint32_t code) {
    enum { LEAST = 10, MOST = 200, RAPIDS = 5, NONE = 8, SPINDLE = 9 };
    static const int8_t steps[] = {0, 10, -10, 1, -1};
    int32_t *const percent = code < RAPIDS ? &self->feed : &self->spindle;
    if (code >= RAPIDS && code < NONE) {
        self->rapid = WHOLE >> (code - RAPIDS);
    } else if (code != NONE) {
        const int step = steps[code < RAPIDS ? code : code - SPINDLE];
        const int next = step == 0 ? WHOLE : *percent + step;
        *percent = next < LEAST ? LEAST : next > MOST ? MOST : next;
    }
    self->ov_in = 0;
    serve_override(self);
}

static void obey(serve_t *self, uint32_t signal) {
    switch (signal) {
    case SERVE_HOLD:
    case SERVE_DOOR: serve_hold(self, signal == SERVE_DOOR); break;
    case SERVE_CANCEL: (void)cancel_jog(self); break;
    case SERVE_RESET: reset(self); break;
    case SERVE_REPORT: serve_say_status(self); break;
    case SERVE_RESUME: resume(self); break;
    case SERVE_MODES: serve_say_modes(self, 1); break;
    case SERVE_MIST:
    case SERVE_FLOOD: self->turned ^= (uint8_t)(signal - SERVE_MODES); break; // bit 0, bit 1
    default: change_override(self, signal - SERVE_OVERRIDE); break;
    }
}

// Returns 1 if a signal was there.
static int hear(serve_t *self) {
    const uint32_t tail = self->in.signal_tail;
    if (tail == nck_fence_load(&self->in.signal_head)) return 0;
    const uint32_t signal = self->signal[tail & (SERVE_SIGNALS - 1)];
    nck_fence_store(&self->in.signal_tail, tail + 1);
    obey(self, signal);
    return 1;
}

// ---- lines

static void begin_line(serve_t *self) {
    clear_line(self);
    self->phase = SERVE_READS;
    self->silence = nck_fence_load(&self->tick.ticks);
}

// The line in work is over.
void serve_answer(serve_t *self) {
    const int32_t error = self->line.own ? 0 : self->line.error;
    const uint32_t text = error != 0 ? SERVE_SAY_ERROR : SERVE_SAY_OK + (uint32_t)self->then;
    if (self->then == SERVE_THEN_BANNER) serve_forget(self);
    if (!self->line.own || self->then == SERVE_THEN_BANNER) serve_say_form(self, text, &error);
    self->then = SERVE_THEN_OK;
    begin_line(self);
}

static void collect(serve_t *self, char byte) {
    const char upper = byte >= 'a' && byte <= 'z' ? (char)(byte - 'a' + 'A') : byte;
    if (self->line.comment != 0) {
        if (byte == (char)self->line.comment) self->line.comment = 0;
        return;
    }
    if (byte == '(') self->line.comment = ')';
    if (byte == ';') self->line.comment = '\n';
    if (byte <= ' ' || self->line.comment != 0 || byte == '/' || byte == '%') return;
    if (self->line.size >= SERVE_LINE_MAX) self->line.overflow = 1;
    else self->text[self->line.size++] = upper;
}

// Returns 1 at the end of a line.
static int collects_end(serve_t *self, char byte) {
    const int is_second = byte == '\n' && self->after_return;
    self->after_return = byte == '\r';
    if (is_second) return 0;
    if (byte == '\n' || byte == '\r') return 1;
    collect(self, byte);
    return 0;
}

static int read_line(serve_t *self) {
    while (self->in.tail != nck_fence_load(&self->in.head)) {
        const char byte = self->ring[self->in.tail & (SERVE_RING - 1)];
        nck_fence_store(&self->in.tail, self->in.tail + 1);
        if (collects_end(self, byte)) return 1;
    }
    return 0;
}

// Text of our own goes the way of a line.
static int give_own(serve_t *self) {
    const int resets = self->then == SERVE_THEN_BANNER;
    const uint32_t from = resets ? 0 : AT_END;
    const uint8_t own = resets || self->line.own;
    begin_line(self);
    self->line.size = (uint8_t)(sizeof at_reset - 1 - from);
    memcpy(self->text, at_reset + from, self->line.size);
    self->line.own = own;
    self->line.does = SERVE_LATE;
    self->phase = SERVE_GIVES;
    return 1;
}

static uint8_t begin_jog(serve_t *self) {
    const int may = self->jogging || self->idle;
    if (self->locked || self->held || self->checks || !may) return SERVE_E_BUSY;
    self->line.jogs = 1;
    return serve_look_jog(self);
}

static uint8_t begin_code(serve_t *self) {
    if (self->locked || self->jogging) return SERVE_E_LOCKED;
    serve_look(self);
    return self->line.probes && !self->beside ? SERVE_E_CODE : 0;
}

// A line is complete. Returns 1 if the kernel is to have it; else it is answered by its error, or
// by ok where that is 0.
static int end_line(serve_t *self) {
    char *const text = self->text;
    self->line.error = 0;
    text[self->line.size] = '\0';
    if (self->line.overflow || nck_fence_load(&self->in.lost)) self->line.error = SERVE_E_LENGTH;
    else if (*text == '\0') return 0;
    else if (self->sleeps) self->line.error = SERVE_E_LOCKED;
    else if (*text != '$') self->line.error = begin_code(self);
    else if (text[1] == 'J' && text[2] == '=') self->line.error = begin_jog(self);
    else {
        serve_command(self);
        return 0;
    }
    if (self->line.error != 0) return 0;
    text[self->line.size++] = '\n';
    return 1;
}

// Where the path rests and nobody has sent a line for a while, it ends for now.
static void be_patient(serve_t *self, nck_status_t status) {
    const uint32_t ticks = nck_fence_load(&self->tick.ticks) - self->silence;
    if (self->flushed || status != NCK_EMPTY || ticks < QUIET_TICKS) return;
    if (self->moves) return;
    nck_flush(self->nck);
    self->flushed = 1;
}

static int read(serve_t *self, nck_status_t status) {
    if (self->renews && !self->idle) return 0;
    self->renews = 0;
    if (self->jogging && self->idle) {
        self->jogging = 0;
        serve_override(self);
    }
    if (!read_line(self)) {
        nck_fence_store(&self->in.lost, 0); // the ring was empty
        be_patient(self, status);
        return 0;
    }
    self->phase = SERVE_GIVES;
    if (end_line(self)) return 1;
    if (self->phase == SERVE_GIVES) serve_answer(self);
    return 1;
}

static int ends_program(const serve_t *self) { return (self->line.does & SERVE_ENDS) != 0; }

// Returns 1 if the kernel has taken it.
static int give(serve_t *self) {
    size_t used = 0;
    if (self->line.probes && !serve_beside(self, SERVE_AT_PROBE)) return 0;
    if ((self->line.does & SERVE_SHIFTS) && !self->idle) {
        nck_flush(self->nck);
        return 0;
    }
    if (self->line.jogs && nck_leave_nothing(self->nck) != NCK_OK) return 0;
    nck_name_line(self->nck, self->line.name);
    (void)nck_push(self->nck, self->text, self->line.size, &used);
    if (used == 0) return 0;
    self->line.error = self->idle = self->flushed = 0;
    self->phase = SERVE_TAKES;
    return 1;
}

static int take(serve_t *self) {
    if (self->line.error == 0 && self->text_waits) return 0;
    if (self->line.error != 0 || !(self->line.does & (SERVE_LATE | SERVE_ENDS))) {
        if (self->line.jogs && self->line.error == 0) {
            self->jogging = 1;
            serve_override(self);
        }
        serve_answer(self);
        return 1;
    }
    if (!ends_program(self)) nck_flush(self->nck);
    self->phase = SERVE_SETTLES;
    return 1;
}

static int settle(serve_t *self, nck_status_t status) {
    if (!self->idle) return 0;
    if (self->line.probes) (void)serve_beside(self, SERVE_AT_PROBED);
    if (!ends_program(self)) {
        serve_answer(self);
        return 1;
    }
    if (status != NCK_DONE || nck_begin(self->nck) != NCK_OK) return 0;
    self->then = SERVE_THEN_ENDED;
    self->phase = SERVE_OWNS;
    return 1;
}

static int end_brake(serve_t *self) {
    const int resets = self->then == SERVE_THEN_BANNER;
    if ((resets ? nck_begin : nck_go_on)(self->nck) != NCK_OK) return 0;
    self->jogging = self->idle = 0;
    self->held = self->door; // a jog is over; a door stays
    self->flushed = self->renews = 1;
    serve_override(self);
    self->phase = resets ? SERVE_OWNS : SERVE_READS;
    if (!resets) self->then = SERVE_THEN_OK;
    if (self->waits) serve_answer(self);
    self->waits = 0;
    return 1;
}

// The path has ended though no line has said so. Returns 1 if it goes on.
static int revive(serve_t *self) {
    if (self->goes || nck_go_on(self->nck) != NCK_OK) return 0;
    if (self->phase == SERVE_TAKES) self->line.error = SERVE_E_CODE;
    return 1;
}

// The line in work has ended the program.
static int has_ended(const serve_t *self) {
    return ends_program(self) && self->phase >= SERVE_TAKES && !self->text_waits;
}

static int follow(serve_t *self, nck_status_t status) {
    if (self->phase == SERVE_BRAKES) return end_brake(self);
    if (status == NCK_DONE && !has_ended(self)) return revive(self);
    switch (self->phase) {
    case SERVE_READS: return read(self, status);
    case SERVE_GIVES: return give(self);
    case SERVE_TAKES: return take(self);
    case SERVE_SETTLES: return settle(self, status);
    default: return give_own(self);
    }
}

static void find(serve_t *self) {
    nck_diagnostic_t found;
    while (nck_diagnostic(self->nck, &found) == NCK_OK) {
        if (found.code == NCK_E_INTERNAL) self->locked = 1;
        if (found.code < NCK_OK) self->line.error = serve_error_of(found.code);
    }
}

// Whoever begins the path anew ends what the kernel was asked for, and the session goes on with it.
static void keep(serve_t *self) {
    if (self->held) nck_hold(self->nck);
    nck_check_only(self->nck, self->checks);
}

nck_status_t serve_step(serve_t *self) {
    const nck_status_t status = nck_prep(self->nck);
    find(self);
    look(self);
    const int heard = hear(self);
    const int went = serve_beside(self, SERVE_AT_STEP) ? 0 : follow(self, status);
    keep(self);
    return heard || went || status < NCK_OK ? NCK_OK : status;
}

void serve_join(serve_t *self) {
    if (self->idle && !self->held && self->phase != SERVE_BRAKES) reset(self);
}

void serve_part(serve_t *self) {
    drop_input(self);
    if (self->phase == SERVE_READS || (self->phase == SERVE_BRAKES && !self->waits)) {
        clear_line(self);
    } else {
        self->line.own = 1;
    }
    if (!self->idle && self->then != SERVE_THEN_BANNER) serve_hold(self, 0); // a reset goes on
}

nck_status_t serve_init(serve_t *self, nck_t *nck, nck_decode_t *room, const serve_port_t *port) {
    memset(self, 0, sizeof *self);
    self->nck = nck;
    self->port = *port;
    self->mask = REPORTS;
    begin(self);
    self->flushed = 1;
    nck_pose_t pose;
    nck_axes_t axes;
    (void)nck_position(nck, &pose, &axes);
    serve_tick(self, &pose);
    self->idle = 1;
    serve_say(self, SERVE_SAY_BANNER);
    return nck_begin_session(nck, room);
}
