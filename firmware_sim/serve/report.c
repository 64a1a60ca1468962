// SPDX-License-Identifier: MIT
// What the session says of itself.
#include <string.h> // strlen

#include "nck/base/fence.h" // nck_fence_load
#include "serve/parts.h"

#define UM_PER_NM 1e-3

enum {
    WCO_MOVING = 30, WCO_RESTING = 10, OV_MOVING = 20, OV_RESTING = 10, // reports until the next
    SYSTEMS = 6,                                                       // G54 … G59
    BLOCKS_MOST = 255                                                  // that are told to be free
};

void serve_say(serve_t *self, const char *text) {
    self->port.write(self->port.user, text, (uint32_t)strlen(text));
}

void serve_say_number(serve_t *self, int32_t value, uint32_t places) {
    enum { DIGITS = 16 };
    char text[DIGITS];
    uint32_t at = DIGITS;
    const int negative = value < 0;
    uint32_t parts = negative ? 0u - (uint32_t)value : (uint32_t)value;
    text[--at] = '\0';
    for (uint32_t k = 0; k <= places || parts > 0; k++) {
        if (k == places && places > 0) text[--at] = '.';
        text[--at] = (char)('0' + parts % 10);
        parts /= 10;
    }
    if (negative) text[--at] = '-';
    serve_say(self, text + at);
}

int32_t serve_round(double value) {
    enum { MOST = 2000000000 };
    const double most = MOST;
    const double kept = value < most ? value : most;
    return (int32_t)(kept < 0.0 ? kept - 0.5 : kept + 0.5);
}

void serve_say_letters(serve_t *self, const char *before, const char *letters, uint32_t bits) {
    if (bits != 0) serve_say(self, before);
    for (uint32_t left = bits; left != 0; left >>= 1) {
        if (left & 1u) self->port.write(self->port.user, letters, 1);
        letters++;
    }
}

void serve_say_two(serve_t *self, const char *form, int32_t first, int32_t second) {
    int32_t next = first;
    for (; *form != '\0'; form++) {
        if (*form != '#') {
            self->port.write(self->port.user, form, 1);
            continue;
        }
        serve_say_number(self, next, 0);
        next = second;
    }
}

void serve_say_axes(serve_t *self, const char *before, const double *at, const int64_t *zero_nm) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    const char *comma = before;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!machine->axis[axis].present) continue;
        const double zero = (double)zero_nm[axis] / nck_machine_counts(machine, axis);
        const int inches = self->inches && !machine->axis[axis].rotary;
        const double place = at ? at[axis] - zero : zero;
        serve_say(self, comma);
        serve_say_number(self, serve_round(place * (inches ? 1e4 / 25.4 : 1e3)), inches ? 4 : 3);
        comma = ",";
    }
}

static const int64_t nowhere_nm[NCK_AXIS_MAX];

const char *serve_state(const serve_t *self) {
    const serve_seen_t *const seen = serve_seen(self);
    if (self->sleeps) return "Sleep";
    if (self->phase == SERVE_HOMES) return "Home";
    if (self->locked) return "Alarm";
    if (self->door) return seen->moves ? "Door:2" : "Door:0";
    if (self->held || self->phase == SERVE_BRAKES) return seen->moves ? "Hold:1" : "Hold:0";
    if (seen->state == NCK_TICK_WAIT) return "Hold:0";
    if (self->checks) return "Check";
    if (self->jogging) return "Jog";
    return serve_is_idle(self) ? "Idle" : "Run";
}

// Another sum: the offsets have changed.
static uint32_t sum_of(const nck_modal_t *modal) {
    const unsigned char *const bytes = (const unsigned char *)modal->origin_nm;
    uint32_t sum = 1;
    for (uint32_t k = 0; k < sizeof modal->origin_nm; k++) sum = sum * 31 + bytes[k];
    return sum;
}

static void say_room(serve_t *self) {
    nck_queue_t queue;
    nck_queue(self->nck, &queue);
    const uint32_t blocks = NCK_SEG_MAX - queue.segs;
    const uint32_t used = nck_fence_load(&self->in.head) - self->in.tail;
    const uint32_t told = blocks < BLOCKS_MOST ? blocks : BLOCKS_MOST;
    serve_say_two(self, "|Bf:#,#", (int32_t)told, (int32_t)(SERVE_RING - 1 - used));
}

static void say_speeds(serve_t *self, const serve_seen_t *seen) {
    const uint32_t rpm = self->tick.turns != 0 ? self->tick.rpm : 0;
    const int32_t speed = serve_round(self->inches ? seen->speed / 25.4 : seen->speed);
    serve_say_two(self, "|FS:#,#", speed, (int32_t)(rpm * self->spindle / 100));
}

static void say_overrides(serve_t *self) {
    const uint32_t coolant = serve_coolant(self);
    const uint32_t turns = self->tick.turns;
    serve_say_two(self, "|Ov:#,#", self->feed, self->rapid);
    serve_say_two(self, ",#", self->spindle, 0);
    serve_say_letters(self, "|A:", "SCFM", turns | (coolant & 2) << 1 | (coolant & 1) << 3);
}

// What changes seldom is said seldom: the work offset, else the overrides.
static void say_seldom(serve_t *self, const nck_modal_t *modal, int moves) {
    const uint32_t sum = sum_of(modal);
    if (sum != self->told) self->wco_in = 0;
    self->told = sum;
    if (self->wco_in == 0) {
        self->wco_in = moves ? WCO_MOVING : WCO_RESTING;
        serve_say_axes(self, "|WCO:", NULL, modal->origin_nm);
    } else if (self->ov_in == 0) {
        self->ov_in = moves ? OV_MOVING : OV_RESTING;
        say_overrides(self);
    }
    self->wco_in--;
    if (self->ov_in > 0) self->ov_in--;
}

void serve_forget(serve_t *self) { self->wco_in = self->ov_in = 0; }

void serve_say_status(serve_t *self) {
    const serve_seen_t seen = *serve_seen(self); // ticks go on while the answer is written
    const char *const state = serve_state(self);
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    serve_say(self, "<");
    serve_say(self, state);
    if (self->mask & 1) serve_say_axes(self, "|MPos:", seen.at, nowhere_nm);
    else serve_say_axes(self, "|WPos:", seen.at, modal.origin_nm);
    if (self->mask & 2) say_room(self);
    if (seen.line != 0 && *state != 'I') serve_say_two(self, "|Ln:#", (int32_t)seen.line, 0);
    say_speeds(self, &seen);
    (void)serve_beside(self, SERVE_AT_STATUS, 0.0);
    say_seldom(self, &modal, seen.moves);
    serve_say(self, ">\r\n");
}

static void say_modes(serve_t *self, const nck_modal_t *modal) {
    static const uint8_t feeds[] = {94, 93, 95}; // nck_feed_mode_t
    enum { LAST = SYSTEMS - 1, CODES = 6 };
    const int32_t system = modal->work_system, more = system > LAST ? system - LAST : 0;
    const uint8_t codes[CODES] = {(uint8_t)(modal->motion < 0 ? 80 : modal->motion),
                                  (uint8_t)(54 + system - more), modal->plane,
                                  (uint8_t)(21 - modal->inch), (uint8_t)(90 + modal->incremental),
                                  feeds[modal->feed_mode]};
    const double unit = modal->inch && modal->feed_mode != NCK_FEED_INVERSE ? 25.4 : 1.0;
    serve_say(self, "[GC");
    for (uint32_t k = 0; k < CODES; k++) {
        serve_say_two(self, k == 0 ? ":G#" : " G#", codes[k], 0);
        if (k == 1 && more > 0) serve_say_two(self, ".#", more, 0);
    }
    serve_say_two(self, " M#", modal->spindle_on ? modal->spindle_code : 5, 0);
    if (modal->coolant & 1) serve_say(self, " M7");
    if (modal->coolant & 2) serve_say(self, " M8");
    if (modal->coolant == 0) serve_say(self, " M9");
    serve_say_two(self, " T# F#", (int32_t)modal->tool_next, serve_round(modal->feed / unit));
    serve_say_two(self, " S#]\r\n", serve_round(modal->spindle_rpm), 0);
}

uint8_t serve_say_modes(serve_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    say_modes(self, &modal);
    return 0;
}

// In a feed move F is the tool's, in mm/min; S always is.
void serve_say_executed(serve_t *self) {
    nck_modal_t modal;
    nck_modal_executed(self->nck, &modal);
    if (!serve_is_idle(self)) {
        const double feed = serve_seen(self)->feed;
        if (feed > 0.0) modal.feed = feed;
        modal.spindle_rpm = self->tick.rpm;
    }
    say_modes(self, &modal);
}

uint8_t serve_say_offsets(serve_t *self) {
    static const uint8_t names[] = {54, 55, 56, 57, 58, 59, 28, 30, 92};
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    const int64_t *place_nm = modal.systems_nm[0];
    for (uint32_t k = 0; k < sizeof names; k++) {
        if (k == SYSTEMS) place_nm = modal.home_nm[0];
        if (k == SYSTEMS + 2) place_nm = modal.g92_nm;
        serve_say_two(self, "[G#", names[k], 0);
        serve_say_axes(self, ":", NULL, place_nm);
        serve_say(self, "]\r\n");
        place_nm += NCK_AXIS_MAX;
    }
    serve_say(self, "[TLO:");
    serve_say_number(self, serve_round((double)modal.tool_nm[2] * UM_PER_NM), 3);
    serve_say(self, "]\r\n");
    if (serve_beside(self, SERVE_AT_OFFSETS, 0.0)) return 0;
    serve_say_axes(self, "[PRB:", NULL, nowhere_nm);
    serve_say(self, ":0]\r\n");
    return 0;
}
