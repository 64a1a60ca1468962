// SPDX-License-Identifier: MIT
// What the session says of itself.
#include <math.h> // copysign fabs floor
#include <stddef.h> // NULL
#include <string.h> // strlen

#include "nck/base/fence.h" // nck_fence_load
#include "serve/parts.h"

#define UM_PER_NM 1e-3

enum {
    AGAIN_MOVING = 30, AGAIN_RESTING = 10, // reports until the next
    SYSTEMS = 6,                           // G54 … G59
    THOUSANDTHS = 1000,
    BLOCKS_MOST = 255                      // that are told to be free
};

// In the order of serve_text_t; each ends with a zero.
static const char texts[] =
    "ok\n\0" "\nGrbl 1.1f ['$' for help]\n\0" "[MSG:Pgm End]\nok\n\0" "error:@\n\0"
    "ALARM:@\n\0" "[MSG:'$H'|'$X' to unlock]\n\0" "[MSG:Caution: Unlocked]\n\0"
    "[MSG:Enabled]\n\0" "[MSG:Disabled]\nok\n\0" "[MSG:Restoring defaults]\n\0"
    "[HLP:$$ $# $G $I $N $x=val $J=line $SLP $C $X $H ~ ! ? ctrl-x]\n\0"
    "[VER:1.1f.nck:]\n[OPT:VNM,@,@]\n\0" "$N0=\n$N1=\n\0" "[MSG:Sleeping]\n\0" "$@=@\n\0"
    "$@=%\n\0" "Sleep\0" "Home\0" "Alarm\0" "Door:0\0" "Door:2\0" "Hold:0\0" "Hold:1\0"
    "Check\0" "Jog\0" "Idle\0" "Run\0" "<\0" "|WPos:\0" "|MPos:\0" "|Bf:@,@\0" "|Ln:@\0"
    "|FS:@,@\0" "|WCO:\0" "|Ov:@,@,@\0" "|A:\0" "SCMF\0" ">\n\0" "|Pn:\0" "PXYZABCUVWDE\0" ",\0"
    "[GC:G@ G@\0" ".@\0" " G@ G@ G@ G@ M@\0" " M7\0" " M8\0" " M9\0" " T@ F@ S@]\n\0" "[G@\0"
    ":\0" "]\n\0" "[TLO:%]\n\0" "[PRB:\0" ":0]\n\0" ":1]\n";

static const char *text_of(uint32_t text) {
    const char *at = texts;
    for (uint32_t left = text; left > 0; left--) at += strlen(at) + 1;
    return at;
}

static void put(const serve_t *self, char byte) { self->port.write(self->port.user, &byte, 1); }

// A number counted in parts of one.
static void say_number(const serve_t *self, int32_t value, uint32_t one) {
    const uint32_t parts = value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
    if (value < 0) put(self, '-');
    for (uint32_t unit = 1000000000; unit > 0; unit /= 10) {
        if (unit == one / 10) put(self, '.');
        if (unit <= one || unit <= parts) put(self, (char)('0' + parts / unit % 10));
    }
}

// To the nearest whole number that fits.
static int32_t nearest(double value) {
    const double most = 2e9;
    return (int32_t)floor((fabs(value) < most ? value : copysign(most, value)) + 0.5);
}

void serve_say_form(serve_t *self, uint32_t text, const int32_t *values) {
    for (const char *at = text_of(text); *at != '\0'; at++) {
        if (*at == '@' || *at == '%') {
            say_number(self, *values++, *at == '%' ? THOUSANDTHS : 1);
            continue;
        }
        if (*at == '\n') put(self, '\r');
        put(self, *at);
    }
}

void serve_say(serve_t *self, uint32_t text) { serve_say_form(self, text, NULL); }

void serve_say_letters(serve_t *self, uint32_t before, uint32_t bits) {
    const char *letter = text_of(before + 1);
    if (bits != 0) serve_say(self, before);
    for (uint32_t left = bits; left != 0; left >>= 1) {
        if (left & 1u) put(self, *letter);
        letter++;
    }
}

void serve_say_setting(serve_t *self, int32_t number, int32_t value) {
    const int32_t values[] = {number, value};
    serve_say_form(self, SERVE_SAY_SETTING, values);
}

void serve_say_measure(serve_t *self, int32_t number, double value) {
    const int32_t values[] = {number, nearest(value * 1e3)};
    serve_say_form(self, SERVE_SAY_MEASURE, values);
}

void serve_say_axes(serve_t *self, uint32_t before, const double *at, const int64_t *zero_nm) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    uint32_t text = before;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!machine->axis[axis].present) continue;
        const int inches = self->inches && !machine->axis[axis].rotary;
        double place = zero_nm ? serve_measure(machine, axis, zero_nm[axis]) : 0.0;
        if (at) place = at[axis] - place;
        serve_say(self, text);
        say_number(self, nearest(place * (inches ? 1e4 / 25.4 : 1e3)), inches ? 10000 : 1000);
        text = SERVE_SAY_COMMA;
    }
}

static double feed_of(const serve_seen_t *seen, double speed) {
    return speed * 60.0 / seen->pose.feed_scale;
}

// In mm, or in inches.
static int32_t whole_of(double length, int inches) {
    return nearest(inches ? length / 25.4 : length);
}

typedef enum state {
    SLEEP, HOME, ALARM, DOOR_RESTS, DOOR_MOVES, HOLD_RESTS, HOLD_MOVES, CHECK, JOG, IDLE, RUN
} state_t;

// What stands further down counts more.
static state_t state_of(const serve_t *self) {
    uint32_t state = self->idle ? IDLE : RUN;
    if (self->jogging) state = JOG;
    if (self->checks) state = CHECK;
    if (self->tick_is == NCK_TICK_WAIT) state = HOLD_RESTS;
    if (self->held || self->phase == SERVE_BRAKES) state = HOLD_RESTS + self->moves;
    if (self->door) state = DOOR_RESTS + self->moves;
    if (self->locked) state = ALARM;
    if (self->phase == SERVE_HOMES) state = HOME;
    return self->sleeps ? SLEEP : (state_t)state;
}

const char *serve_state(const serve_t *self) {
    return text_of(SERVE_SAY_STATES + (uint32_t)state_of(self));
}

// Another sum: the offsets have changed.
static uint32_t sum_of(const nck_modal_t *modal) {
    const unsigned char *const bytes = (const unsigned char *)modal->origin_nm;
    uint32_t sum = 1;
    for (uint32_t k = 0; k < sizeof modal->origin_nm; k++) sum = sum * 31 + bytes[k];
    return sum;
}

// What room there is, where the tool is, how fast it goes.
static void say_numbers(serve_t *self, const serve_seen_t *seen, int named) {
    enum { ROOM, BYTES, LINE, SPEED, RPM, NUMBERS };
    nck_queue_t queue;
    nck_queue(self->nck, &queue);
    const uint32_t blocks = NCK_SEG_MAX - queue.segs;
    const double speed = feed_of(seen, seen->pose.v);
    const uint32_t rpm = self->tick.turns != 0 ? self->tick.rpm : 0;
    const int32_t values[NUMBERS] = {
        [ROOM] = (int32_t)(blocks < BLOCKS_MOST ? blocks : BLOCKS_MOST),
        [BYTES] = (int32_t)(SERVE_RING - 1 + self->in.tail - nck_fence_load(&self->in.head)),
        [LINE] = (int32_t)seen->pose.line,
        [SPEED] = whole_of(speed, self->inches),
        [RPM] = (int32_t)(rpm * serve_spindle(self) / 100)};
    if (self->mask & 2) serve_say_form(self, SERVE_SAY_ROOM, values);
    if (values[LINE] != 0 && named) serve_say_form(self, SERVE_SAY_LINE, &values[LINE]);
    serve_say_form(self, SERVE_SAY_SPEED, &values[SPEED]);
}

static void say_overrides(serve_t *self) {
    serve_say_form(self, SERVE_SAY_OVERRIDES, &self->feed);
    serve_say_letters(self, SERVE_SAY_ACCESSORIES, self->tick.turns | serve_coolant(self) << 2);
}

// What changes seldom is said seldom: the work offset, else the overrides.
static void say_seldom(serve_t *self, const nck_modal_t *modal) {
    const uint8_t again = self->moves ? AGAIN_MOVING : AGAIN_RESTING;
    const uint32_t sum = sum_of(modal);
    if (sum != self->told) self->wco_in = 0;
    self->told = sum;
    if (self->wco_in == 0) {
        self->wco_in = again;
        serve_say_axes(self, SERVE_SAY_ZERO, NULL, modal->origin_nm);
    } else if (self->ov_in == 0) {
        self->ov_in = again;
        say_overrides(self);
    } else {
        self->ov_in--;
    }
    self->wco_in--;
}

void serve_say_status(serve_t *self) {
    const serve_seen_t seen = *serve_seen(self); // ticks go on while the answer is written
    const state_t state = state_of(self);
    const uint32_t machine = self->mask & 1u; // places of the machine
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    serve_say(self, SERVE_SAY_BEGIN);
    serve_say(self, SERVE_SAY_STATES + (uint32_t)state);
    serve_say_axes(self, SERVE_SAY_PLACE + machine, seen.pose.axis,
                   machine ? NULL : modal.origin_nm);
    say_numbers(self, &seen, state != IDLE);
    (void)serve_beside(self, SERVE_AT_STATUS);
    say_seldom(self, &modal);
    serve_say(self, SERVE_SAY_END);
}

// M7 and M8, M9 if neither is on.
static void say_coolant(serve_t *self, uint32_t coolant) {
    uint32_t on = coolant != 0 ? coolant : 4;
    for (uint32_t text = SERVE_SAY_MIST; on != 0; text++, on >>= 1) {
        if (on & 1) serve_say(self, text);
    }
}

// At the tool F is the tool's in a feed move, in mm/min; S always is.
void serve_say_modes(serve_t *self, int at_tool) {
    static const uint8_t feeds[] = {94, 93, 95}; // nck_feed_mode_t
    enum { LAST = SYSTEMS - 1, MOTION = 0, MORE = 2, FIRST = 3, NUMBERS = 11 };
    nck_modal_t modal;
    if (at_tool) nck_modal_executed(self->nck, &modal);
    else nck_modal(self->nck, &modal);
    if (at_tool && !self->idle) {
        const serve_seen_t *const seen = serve_seen(self);
        if (seen->pose.feed > 0.0) modal.feed = feed_of(seen, seen->pose.feed);
        modal.spindle_rpm = self->tick.rpm;
    }
    const int32_t system = modal.work_system, more = system > LAST ? system - LAST : 0;
    const int inches = modal.inch && modal.feed_mode != NCK_FEED_INVERSE;
    const int32_t values[NUMBERS] = {
        [MOTION] = modal.motion < 0 ? 80 : modal.motion, 54 + system - more, [MORE] = more,
        [FIRST] = modal.plane, 21 - modal.inch, 90 + modal.incremental,
        feeds[modal.feed_mode], modal.spindle_on ? modal.spindle_code : 5,
        (int32_t)modal.tool_next, whole_of(modal.feed, inches), nearest(modal.spindle_rpm)};
    serve_say_form(self, SERVE_SAY_MODES, values);
    if (more > 0) serve_say_form(self, SERVE_SAY_TENTH, &values[MORE]);
    serve_say_form(self, SERVE_SAY_MORE_MODES, &values[FIRST]);
    say_coolant(self, modal.coolant);
    serve_say_form(self, SERVE_SAY_LAST_MODES, &values[FIRST + 5]);
}

static void say_place(serve_t *self, int32_t code, const int64_t *place_nm) {
    serve_say_form(self, SERVE_SAY_SYSTEM, &code);
    serve_say_axes(self, SERVE_SAY_COLON, NULL, place_nm);
    serve_say(self, SERVE_SAY_CLOSE);
}

void serve_say_offsets(serve_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    for (int32_t k = 0; k < SYSTEMS; k++) say_place(self, 54 + k, modal.systems_nm[k]);
    say_place(self, 28, modal.home_nm[0]);
    say_place(self, 30, modal.home_nm[1]);
    say_place(self, 92, modal.g92_nm);
    const int32_t length = nearest((double)modal.tool_nm[2] * UM_PER_NM);
    serve_say_form(self, SERVE_SAY_LENGTH, &length);
    if (serve_beside(self, SERVE_AT_OFFSETS)) return;
    serve_say_axes(self, SERVE_SAY_PROBE, NULL, NULL);
    serve_say(self, SERVE_SAY_MISSED);
}
