// SPDX-License-Identifier: MIT
// What the session says of itself.
#include <stddef.h> // NULL

#include "nck/base/fence.h" // nck_fence_load
#include "serve/parts.h"

#define UM_PER_NM 1e-3

enum {
    WCO_MOVING = 30, WCO_RESTING = 10, OV_MOVING = 20, OV_RESTING = 10, // reports until the next
    SYSTEMS = 6,                                                       // G54 … G59
    BLOCKS_MOST = 255                                                  // that are told to be free
};

// A number whose last so many digits stand behind its point.
static void say_number(serve_t *self, int32_t value, uint32_t places) {
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

// To the nearest whole number that fits.
static int32_t nearest(double value) {
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

void serve_say_form(serve_t *self, const char *form, const int32_t *values) {
    for (; *form != '\0'; form++) {
        const int ends = *form == '\n';
        if (*form == '@' || *form == '%') say_number(self, *values++, *form == '%' ? 3 : 0);
        else self->port.write(self->port.user, ends ? "\r\n" : form, ends ? 2 : 1);
    }
}

void serve_say(serve_t *self, const char *text) { serve_say_form(self, text, NULL); }

void serve_say_setting(serve_t *self, int32_t number, int32_t value) {
    const int32_t values[] = {number, value};
    serve_say_form(self, "$@=@\n", values);
}

void serve_say_measure(serve_t *self, int32_t number, double value) {
    const int32_t values[] = {number, nearest(value * 1e3)};
    serve_say_form(self, "$@=%\n", values);
}

void serve_say_axes(serve_t *self, const char *before, const double *at, const int64_t *zero_nm) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    const char *comma = before;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!machine->axis[axis].present) continue;
        const double counts = nck_machine_counts(machine, axis);
        const double zero = zero_nm ? (double)zero_nm[axis] / counts : 0.0;
        const int inches = self->inches && !machine->axis[axis].rotary;
        const double place = at ? at[axis] - zero : zero;
        serve_say(self, comma);
        say_number(self, nearest(place * (inches ? 1e4 / 25.4 : 1e3)), inches ? 4 : 3);
        comma = ",";
    }
}

static double feed_of(const serve_seen_t *seen, double speed) {
    return speed * 60.0 / seen->pose.feed_scale;
}

typedef enum state {
    SLEEP, HOME, ALARM, DOOR_RESTS, DOOR_MOVES, HOLD_RESTS, HOLD_MOVES, CHECK, JOG, IDLE, RUN
} state_t;

static state_t state_of(const serve_t *self) {
    const serve_seen_t *const seen = serve_seen(self);
    if (self->sleeps) return SLEEP;
    if (self->phase == SERVE_HOMES) return HOME;
    if (self->locked) return ALARM;
    if (self->door) return (state_t)(DOOR_RESTS + seen->moves);
    if (self->held || self->phase == SERVE_BRAKES) return (state_t)(HOLD_RESTS + seen->moves);
    if (seen->pose.state == NCK_TICK_WAIT) return HOLD_RESTS;
    if (self->checks) return CHECK;
    if (self->jogging) return JOG;
    return self->idle ? IDLE : RUN;
}

const char *serve_state(const serve_t *self) {
    static const char names[][7] = {"Sleep", "Home", "Alarm", "Door:0", "Door:2", "Hold:0",
                                    "Hold:1", "Check", "Jog", "Idle", "Run"};
    return names[state_of(self)];
}

// Another sum: the offsets have changed.
static uint32_t sum_of(const nck_modal_t *modal) {
    const unsigned char *const bytes = (const unsigned char *)modal->origin_nm;
    uint32_t sum = 1;
    for (uint32_t k = 0; k < sizeof modal->origin_nm; k++) sum = sum * 31 + bytes[k];
    return sum;
}

// What room there is, where the tool is, how fast it goes.
static void say_numbers(serve_t *self, const serve_seen_t *seen, const char *state) {
    enum { ROOM, BYTES, LINE, SPEED, RPM, NUMBERS };
    nck_queue_t queue;
    nck_queue(self->nck, &queue);
    const uint32_t blocks = NCK_SEG_MAX - queue.segs;
    const double speed = feed_of(seen, seen->pose.v);
    const int32_t values[NUMBERS] = {
        [ROOM] = (int32_t)(blocks < BLOCKS_MOST ? blocks : BLOCKS_MOST),
        [BYTES] = (int32_t)(SERVE_RING - 1 + self->in.tail - nck_fence_load(&self->in.head)),
        [LINE] = (int32_t)seen->pose.line,
        [SPEED] = nearest(self->inches ? speed / 25.4 : speed),
        [RPM] = (int32_t)((self->tick.turns != 0 ? self->tick.rpm : 0) * self->spindle / 100)};
    if (self->mask & 2) serve_say_form(self, "|Bf:@,@", values);
    if (values[LINE] != 0 && *state != 'I') serve_say_form(self, "|Ln:@", &values[LINE]);
    serve_say_form(self, "|FS:@,@", &values[SPEED]);
}

static void say_overrides(serve_t *self) {
    const uint32_t coolant = serve_coolant(self);
    const int32_t values[] = {self->feed, self->rapid, self->spindle};
    serve_say_form(self, "|Ov:@,@,@", values);
    serve_say_letters(self, "|A:", "SCFM",
                      self->tick.turns | (coolant & 2) << 1 | (coolant & 1) << 3);
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
    if (self->mask & 1) serve_say_axes(self, "|MPos:", seen.pose.axis, NULL);
    else serve_say_axes(self, "|WPos:", seen.pose.axis, modal.origin_nm);
    say_numbers(self, &seen, state);
    (void)serve_beside(self, SERVE_AT_STATUS);
    say_seldom(self, &modal, seen.moves);
    serve_say(self, ">\n");
}

static void say_modes(serve_t *self, const nck_modal_t *modal) {
    static const uint8_t feeds[] = {94, 93, 95}; // nck_feed_mode_t
    enum { LAST = SYSTEMS - 1, MOTION = 0, MORE = 2, FIRST = 3, NUMBERS = 11 };
    const int32_t system = modal->work_system, more = system > LAST ? system - LAST : 0;
    const double unit = modal->inch && modal->feed_mode != NCK_FEED_INVERSE ? 25.4 : 1.0;
    const int32_t values[NUMBERS] = {
        [MOTION] = modal->motion < 0 ? 80 : modal->motion, 54 + system - more, [MORE] = more,
        [FIRST] = modal->plane, 21 - modal->inch, 90 + modal->incremental,
        feeds[modal->feed_mode], modal->spindle_on ? modal->spindle_code : 5,
        (int32_t)modal->tool_next, nearest(modal->feed / unit),
        nearest(modal->spindle_rpm)};
    uint32_t on = modal->coolant != 0 ? modal->coolant : 4;
    serve_say_form(self, "[GC:G@ G@", values);
    if (more > 0) serve_say_form(self, ".@", &values[MORE]);
    serve_say_form(self, " G@ G@ G@ G@ M@", &values[FIRST]);
    for (int32_t code = 7; on != 0; code++, on >>= 1) {
        if (on & 1) serve_say_form(self, " M@", &code);
    }
    serve_say_form(self, " T@ F@ S@]\n", &values[FIRST + 5]);
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
    if (!self->idle) {
        const serve_seen_t *const seen = serve_seen(self);
        if (seen->pose.feed > 0.0) modal.feed = feed_of(seen, seen->pose.feed);
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
        const int32_t name = names[k];
        if (k == SYSTEMS) place_nm = modal.home_nm[0];
        if (k == SYSTEMS + 2) place_nm = modal.g92_nm;
        serve_say_form(self, "[G@", &name);
        serve_say_axes(self, ":", NULL, place_nm);
        serve_say(self, "]\n");
        place_nm += NCK_AXIS_MAX;
    }
    const int32_t length = nearest((double)modal.tool_nm[2] * UM_PER_NM);
    serve_say_form(self, "[TLO:%]\n", &length);
    if (serve_beside(self, SERVE_AT_OFFSETS)) return 0;
    serve_say_axes(self, "[PRB:", NULL, NULL);
    serve_say(self, ":0]\n");
    return 0;
}
