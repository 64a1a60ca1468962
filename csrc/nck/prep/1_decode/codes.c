// SPDX-License-Identifier: MIT
// The codes of the language: which step executes a G or M code, and which letters it uses.
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // NULL size_t

enum { RIGID = 290 }; // M29

// The sets of letters that codes use.
enum {
    NONE, AXES, ARC, DWELL, PATH, LENGTH, REFERENCE, SET, CALL, MACRO, DRILL, DRILL_P, DRILL_Q,
    RADIUS, DIAMETER, TAP, TURN_PLANE, SCALE, MIRROR, INPUT, ANALOGUE, BEZIER, PARABOLA, NURBS,
    KNOTS, TURN, FACE, PECK, PASS, PASS_Q, THREAD, SCREW, SCREW_FANUC, LINES, SUB, SETS
};

static const uint32_t letters_of[SETS] = {
    [NONE] = 0,
    [AXES] = NCK_LETTERS_AXES,
    [ARC] = NCK_LETTERS_AXES | NCK_LETTERS_CENTRE | NCK_LETTER('R') | NCK_LETTER('P'),
    [DWELL] = NCK_LETTER('P'),
    [PATH] = NCK_LETTER('P') | NCK_LETTER('Q'),
    [LENGTH] = NCK_LETTER('H'),
    [REFERENCE] = NCK_LETTERS_AXES | NCK_LETTER('P'),
    [SET] = NCK_LETTERS_AXES | NCK_LETTER('L') | NCK_LETTER('P') | NCK_LETTER('R')
            | NCK_LETTER('Q'),
    [CALL] = NCK_LETTER('L') | NCK_LETTER('P'),
    [MACRO] = (1 << NCK_LETTERS) - 1,
    [DRILL] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L'),
    [DRILL_P] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('P'),
    [DRILL_Q] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('Q'),
    [RADIUS] = NCK_LETTER('D'),
    [DIAMETER] = NCK_LETTER('D') | NCK_LETTER('L'),
    [TURN_PLANE] = NCK_LETTERS_XYZ | NCK_LETTER('R'),
    [SCALE] = NCK_LETTERS_XYZ | NCK_LETTERS_CENTRE | NCK_LETTER('P'),
    [MIRROR] = NCK_LETTERS_XYZ,
    [TAP] = NCK_LETTERS_XYZ | NCK_LETTER('K'),
    [INPUT] = NCK_LETTER('P') | NCK_LETTER('E') | NCK_LETTER('L') | NCK_LETTER('Q'),
    [ANALOGUE] = NCK_LETTER('E') | NCK_LETTER('Q'),
    [BEZIER] = NCK_LETTERS_AXES | NCK_LETTER('I') | NCK_LETTER('J') | NCK_LETTER('P')
               | NCK_LETTER('Q'),
    [PARABOLA] = NCK_LETTERS_AXES | NCK_LETTER('I') | NCK_LETTER('J'),
    [NURBS] = NCK_LETTERS_AXES | NCK_LETTER('P') | NCK_LETTER('L'),
    [KNOTS] = NCK_LETTERS_AXES | NCK_LETTER('K') | NCK_LETTER('P') | NCK_LETTER('R'),
    [TURN] = NCK_LETTERS_LINEAR | NCK_LETTER('R') | NCK_LETTER('I'),
    [FACE] = NCK_LETTERS_LINEAR | NCK_LETTER('R') | NCK_LETTER('K'),
    [PECK] = NCK_LETTERS_LINEAR | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('R')
             | NCK_LETTER('I') | NCK_LETTER('K'),
    [PASS] = NCK_LETTERS_AXES | NCK_LETTER('K'),
    [PASS_Q] = NCK_LETTERS_LINEAR | NCK_LETTER('Q'),
    [THREAD] = NCK_LETTERS_LINEAR | NCK_LETTER('R') | NCK_LETTER('I') | NCK_LETTER('Q'),
    [SCREW] = NCK_LETTERS_CENTRE | NCK_LETTER('Z') | NCK_LETTER('E') | NCK_LETTER('H')
              | NCK_LETTER('L') | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('R'),
    [SCREW_FANUC] = NCK_LETTERS_LINEAR | NCK_LETTER('A') | NCK_LETTER('D') | NCK_LETTER('I')
                    | NCK_LETTER('K') | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('R'),
    [LINES] = NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('U') | NCK_LETTER('W')
              | NCK_LETTER('R') | NCK_LETTER('D') | NCK_LETTER('I') | NCK_LETTER('K'),
    [SUB] = NCK_LETTER('Q') | NCK_LETTER('X') | NCK_LETTER('Z') | NCK_LETTER('D') | NCK_LETTER('E')
            | NCK_LETTER('I') | NCK_LETTER('P') | NCK_LETTER('R')
};

typedef struct code {
    uint16_t tenths; // G61.1 is 611
    uint8_t step;    // nck_step_t
    uint8_t takes;   // place in letters_of
} code_t;

// Ordered by how often programs use them: the search is from the front.
static const code_t g_codes[] = {
    {10, NCK_STEP_MOTION, AXES}, {0, NCK_STEP_MOTION, AXES},
    {20, NCK_STEP_MOTION, ARC}, {30, NCK_STEP_MOTION, ARC},
    {40, NCK_STEP_DWELL, DWELL},
    {170, NCK_STEP_PLANE, NONE}, {180, NCK_STEP_PLANE, NONE}, {190, NCK_STEP_PLANE, NONE},
    {200, NCK_STEP_UNITS, NONE}, {210, NCK_STEP_UNITS, NONE},
    {900, NCK_STEP_DISTANCE, NONE}, {910, NCK_STEP_DISTANCE, NONE},
    {901, NCK_STEP_CENTRE, NONE}, {911, NCK_STEP_CENTRE, NONE},
    {930, NCK_STEP_FEED_MODE, NONE}, {940, NCK_STEP_FEED_MODE, NONE},
    {950, NCK_STEP_FEED_MODE, NONE},
    {610, NCK_STEP_PATH, NONE}, {611, NCK_STEP_PATH, NONE},
    {640, NCK_STEP_PATH, PATH},
    {800, NCK_STEP_MOTION, NONE}, {530, NCK_STEP_MACHINE, NONE}, {400, NCK_STEP_RADIUS_COMP, NONE},
    {410, NCK_STEP_RADIUS_COMP, RADIUS}, {420, NCK_STEP_RADIUS_COMP, RADIUS},
    {411, NCK_STEP_RADIUS_COMP, DIAMETER}, {421, NCK_STEP_RADIUS_COMP, DIAMETER},
    {540, NCK_STEP_WORK, NONE}, {550, NCK_STEP_WORK, NONE}, {560, NCK_STEP_WORK, NONE},
    {570, NCK_STEP_WORK, NONE}, {580, NCK_STEP_WORK, NONE}, {590, NCK_STEP_WORK, NONE},
    {591, NCK_STEP_WORK, NONE}, {592, NCK_STEP_WORK, NONE}, {593, NCK_STEP_WORK, NONE},
    {430, NCK_STEP_LENGTH, LENGTH}, {490, NCK_STEP_LENGTH, NONE},
    {280, NCK_STEP_OFFSET, AXES}, {300, NCK_STEP_OFFSET, REFERENCE},
    {920, NCK_STEP_OFFSET, AXES}, {520, NCK_STEP_OFFSET, AXES},
    {921, NCK_STEP_OFFSET, NONE}, {922, NCK_STEP_OFFSET, NONE}, {923, NCK_STEP_OFFSET, NONE},
    {100, NCK_STEP_OFFSET, SET},
    {70, NCK_STEP_DIAMETER, NONE}, {80, NCK_STEP_DIAMETER, NONE},
    {90, NCK_STEP_EXACT, NONE},
    {970, NCK_STEP_SPEED_MODE, NONE}, {960, NCK_STEP_SPEED_MODE, RADIUS},
    {650, NCK_STEP_CALL, MACRO}, {660, NCK_STEP_CALL, MACRO}, {670, NCK_STEP_CALL, NONE}
};

// Behind the others: nobody's plain lines pay for them.
static const code_t cycle_codes[] = {
    {810, NCK_STEP_MOTION, DRILL}, {830, NCK_STEP_MOTION, DRILL_Q},
    {980, NCK_STEP_RETRACT, NONE}, {990, NCK_STEP_RETRACT, NONE},
    {730, NCK_STEP_MOTION, DRILL_Q}, {820, NCK_STEP_MOTION, DRILL_P},
    {850, NCK_STEP_MOTION, DRILL}, {860, NCK_STEP_MOTION, DRILL_P},
    {890, NCK_STEP_MOTION, DRILL_P}, {NCK_MOTION_TAP_RIGHT, NCK_STEP_MOTION, DRILL_P},
    {NCK_MOTION_TAP_LEFT, NCK_STEP_MOTION, DRILL_P}
};

static const code_t spline_codes[] = {
    {NCK_MOTION_CUBIC, NCK_STEP_MOTION, BEZIER}, {NCK_MOTION_QUADRATIC, NCK_STEP_MOTION, PARABOLA},
    {NCK_MOTION_NURBS, NCK_STEP_MOTION, NURBS}, {NCK_MOTION_NURBS_END, NCK_STEP_MOTION, NONE}
};

static const code_t rs274_codes[] = {
    {281, NCK_STEP_OFFSET, NONE}, {301, NCK_STEP_OFFSET, NONE}, {431, NCK_STEP_LENGTH, MIRROR},
    {432, NCK_STEP_LENGTH, LENGTH}
};

static const code_t port_codes[] = {
    {620, NCK_STEP_PORT, DWELL}, {630, NCK_STEP_PORT, DWELL}, {640, NCK_STEP_PORT, DWELL},
    {650, NCK_STEP_PORT, DWELL}, {660, NCK_STEP_PORT, INPUT}, {670, NCK_STEP_PORT, ANALOGUE},
    {680, NCK_STEP_PORT, ANALOGUE}, {700, NCK_STEP_STATE, NONE}, {710, NCK_STEP_STATE, NONE},
    {720, NCK_STEP_STATE, NONE}, {730, NCK_STEP_STATE, NONE}
};

static const code_t layout_codes[] = {
    {150, NCK_STEP_LAYOUT, NONE}, {160, NCK_STEP_LAYOUT, NONE}, {500, NCK_STEP_LAYOUT, NONE},
    {510, NCK_STEP_LAYOUT, SCALE}, {501, NCK_STEP_LAYOUT, MIRROR}, {511, NCK_STEP_LAYOUT, MIRROR},
    {690, NCK_STEP_LAYOUT, NONE}, {680, NCK_STEP_LAYOUT, TURN_PLANE}
};

static const code_t thread_codes[] = {
    {NCK_MOTION_PASS, NCK_STEP_MOTION, PASS}, {NCK_MOTION_SCREW, NCK_STEP_MOTION, SCREW},
    {NCK_MOTION_TAP, NCK_STEP_MOTION, TAP}
};

static const code_t turning_codes[] = {
    {NCK_MOTION_TURN, NCK_STEP_MOTION, TURN}, {NCK_MOTION_FACE, NCK_STEP_MOTION, FACE},
    {NCK_MOTION_PASS, NCK_STEP_MOTION, PASS_Q}, {NCK_MOTION_THREAD, NCK_STEP_MOTION, THREAD},
    {NCK_MOTION_SCREW, NCK_STEP_MOTION, SCREW_FANUC},
    {NCK_MOTION_PECK_Z, NCK_STEP_MOTION, PECK}, {NCK_MOTION_PECK_X, NCK_STEP_MOTION, PECK}
};

static const code_t line_codes[] = {
    {NCK_MOTION_FINISH, NCK_STEP_MOTION, LINES}, {NCK_MOTION_ROUGH, NCK_STEP_MOTION, LINES},
    {NCK_MOTION_FACE_ROUGH, NCK_STEP_MOTION, LINES}, {NCK_MOTION_PATTERN, NCK_STEP_MOTION, LINES}
};

static const code_t sub_codes[] = {
    {NCK_MOTION_FINISH, NCK_STEP_MOTION, SUB}, {NCK_MOTION_ROUGH, NCK_STEP_MOTION, SUB},
    {711, NCK_STEP_MOTION, SUB}, {712, NCK_STEP_MOTION, SUB},
    {NCK_MOTION_FACE_ROUGH, NCK_STEP_MOTION, SUB}, {721, NCK_STEP_MOTION, SUB},
    {722, NCK_STEP_MOTION, SUB}
};

static const code_t m_codes[] = {
    {0, NCK_STEP_STOP, NONE}, {10, NCK_STEP_STOP, NONE}, {20, NCK_STEP_STOP, NONE},
    {300, NCK_STEP_STOP, NONE}, {600, NCK_STEP_STOP, NONE},
    {30, NCK_STEP_SPINDLE, NONE}, {40, NCK_STEP_SPINDLE, NONE}, {50, NCK_STEP_SPINDLE, NONE},
    {60, NCK_STEP_CHANGE, NONE},
    {70, NCK_STEP_MIST, NONE}, {80, NCK_STEP_FLOOD, NONE}, {90, NCK_STEP_FLOOD, NONE},
    {480, NCK_STEP_OVERRIDE, NONE}, {490, NCK_STEP_OVERRIDE, NONE},
    {980, NCK_STEP_CALL, CALL}, {990, NCK_STEP_CALL, CALL}
};

// Known to RS274NGC or to Fanuc's controls, not built. A number tells how far its code lies behind
// the one before: of G codes in tenths, of M codes, which have none, in whole ones.
static const uint8_t g_later[] = {
    50, 1, 1, 1, 9, 9, 1, 34, 3, 1, 10, // G5 G5.1 G5.2 G5.3 G6.2 G7.1 G7.2 G10.6 G10.9 G11 G12
    1, 9, 1, 19, 10, 11, 10, 10, 29, 10, // G12.1 G13 G13.1 G15 G16 G17.1 G18.1 G19.1 G22 G23
    20, 10, 10, 11, 9, 11, 9, 10, 10, 1, 9, // G25 G26 G27 G28.1 G29 G30.1 G31 G32 G33 G33.1 G34
    10, 10, 10, 10, 2, 1, 1, 1, 5, 11, // G35 G36 G37 G38 G38.2 G38.3 G38.4 G38.5 G39 G40.1
    11, 1, 1, 1, 1, 6, 2, // G41.2 G41.3 G41.4 G41.5 G41.6 G42.2 G42.4
    1, 1, 5, 1, 1, 1, 1, 2, 3, 10, // G42.5 G42.6 G43.1 G43.2 G43.3 G43.4 G43.5 G43.7 G44 G45
    10, 10, 10, 20, 1, 1, 1, 7, 1, 1, 8, // G46 G47 G48 G50 G50.1 G50.2 G50.3 G51 G51.1 G51.2 G52
    11, 1, 4, 5, 1, 2, 56, 20, 10, 20, // G53.1 G53.2 G53.6 G54.1 G54.2 G54.4 G60 G62 G63 G65
    10, 1, 9, 10, 1, 1, 1, 1, 6, 1, 9, // G66 G66.1 G67 G68 G68.1 G68.2 G68.3 G68.4 G69 G69.1 G70
    10, 1, 1, 8, 1, 1, 8, 10, 10, 10, 10, // G71 G71.1 G71.2 G72 G72.1 G72.2 G73 G74 G75 G76 G77
    10, 10, 20, 1, 9, 10, 10, 2, 1, 7, 10, // G78 G79 G81 G81.1 G82 G83 G84 G84.2 G84.3 G85 G86
    10, 10, 10, 90, 10, 80, 50, 10 // G87 G88 G89 G98 G99 G107 G112 G113
};

static const uint8_t m_later[] = {
    10, 1, 2, 1, 5, 10, 11, 1, 1, 1, 1, 1, // M10 M11 M13 M14 M19 M29 M40 M41 M42 M43 M44 M45
    5, 1, 1, 1, 3, 5, 1, 1, 1, 1, 1, 1, 1, // M50 M51 M52 M53 M56 M61 M62 M63 M64 M65 M66 M67 M68
    2, 1, 1, 1, 23, 1, 1, 1, 99 // M70 M71 M72 M73 M96 M97 M98 M99 M198
};

static const code_t *find(const code_t *codes, size_t count, int64_t tenths) {
    for (size_t k = 0; k < count; k++) {
        if (codes[k].tenths == tenths) return &codes[k];
    }
    return NULL;
}

// unit: of the steps from code to code [tenths].
static int is_later(const uint8_t *steps, size_t count, int unit, int64_t tenths) {
    int64_t code = 0;
    for (size_t k = 0; k < count && code < tenths; k++) code += steps[k] * unit;
    return code == tenths;
}

const nck_own_m_t *nck_decode_own_m(const nck_decode_t *self, int64_t code) {
    const nck_machine_t *const machine = self->machine;
    for (uint32_t k = 0; k < machine->own_m_count; k++) {
        if (machine->own_m[k].code == code) return &machine->own_m[k];
    }
    return NULL;
}

// G70 … G73, by whatever name.
static int is_profile(int64_t tenths) {
    return tenths >= NCK_MOTION_FINISH && tenths <= NCK_MOTION_PATTERN;
}

int nck_decode_follows(const nck_decode_t *self, int32_t motion) {
    const uint32_t base = self->machine->dialect.base;
    const int g70 = base == NCK_DIALECT_LINUXCNC
                    && self->machine->kinematics == NCK_KINEMATICS_LATHE_XZ
                    && motion < NCK_MOTION_PATTERN;
    return is_profile(motion) && (self->lathe || g70);
}

// Of mills: Fanuc's have no threads.
static const code_t *find_drilling(const nck_decode_t *self, int64_t tenths) {
    const code_t *const code =
        find(cycle_codes, sizeof cycle_codes / sizeof cycle_codes[0], tenths);
    if (code != NULL || self->machine->dialect.base != NCK_DIALECT_LINUXCNC) return code;
    return find(thread_codes, sizeof thread_codes / sizeof thread_codes[0], tenths);
}

// A canned cycle, G98 or G99: Fanuc's lathes have others than mills.
static const code_t *find_cycle(const nck_decode_t *self, int64_t tenths) {
    if (!NCK_HAS_CYCLES) return NULL;
    if (is_profile(tenths) && !NCK_HAS_CONTOUR) return NULL;
    if (nck_decode_follows(self, (int32_t)tenths)) {
        if (!self->lathe) return find(sub_codes, sizeof sub_codes / sizeof sub_codes[0], tenths);
        return find(line_codes, sizeof line_codes / sizeof line_codes[0], tenths);
    }
    if (self->lathe) {
        return find(turning_codes, sizeof turning_codes / sizeof turning_codes[0], tenths);
    }
    return find_drilling(self, tenths);
}

// Fanuc's G5 and G5.1 mean other things, and G6.2 is its mills' own.
static const code_t *find_spline(const nck_decode_t *self, int64_t tenths) {
    static const code_t knots = {NCK_MOTION_KNOTS, NCK_STEP_MOTION, KNOTS};
    const int mills = self->machine->dialect.base == NCK_DIALECT_FANUC && !self->lathe;
    if (!NCK_HAS_CONTOUR) return NULL;
    if (tenths == NCK_MOTION_KNOTS) return mills ? &knots : NULL;
    if (self->machine->dialect.base == NCK_DIALECT_FANUC) return NULL;
    return find(spline_codes, sizeof spline_codes / sizeof spline_codes[0], tenths);
}

// Straight probes, where the machine says what they meet.
static const code_t *find_probe(const nck_decode_t *self) {
    static const code_t probe = {NCK_MOTION_PROBE, NCK_STEP_MOTION, AXES};
    const uint32_t base = self->machine->dialect.base;
    const int speaks = base == NCK_DIALECT_LINUXCNC || base == NCK_DIALECT_GRBL;
    const int built = NCK_HAS_CYCLES && self->machine->dialect.probe != NCK_PROBE_REFUSED;
    return speaks && built ? &probe : NULL;
}

// What other languages mean otherwise, or leave to the machine.
static const code_t *find_rs274(const nck_decode_t *self, int g, int64_t tenths) {
    if (self->machine->dialect.base != NCK_DIALECT_LINUXCNC) return NULL;
    return g ? find(rs274_codes, sizeof rs274_codes / sizeof rs274_codes[0], tenths)
             : find(port_codes, sizeof port_codes / sizeof port_codes[0], tenths);
}

// The codes that not all programs can say.
static const code_t *find_other(const nck_decode_t *self, int64_t tenths) {
    const int mills = self->machine->dialect.base == NCK_DIALECT_FANUC && !self->lathe;
    const int lays_out = NCK_HAS_LAYOUTS && mills && nck_layout_bit(tenths) != 0;
    if (nck_motion_is_spline((int32_t)tenths)) return find_spline(self, tenths);
    if (nck_motion_probes((int32_t)tenths)) return find_probe(self);
    const code_t *const code = find_rs274(self, 1, tenths);
    if (code != NULL) return code;
    if (!lays_out) return find_cycle(self, tenths);
    return find(layout_codes, sizeof layout_codes / sizeof layout_codes[0], tenths);
}

// Fanuc's mills count holes by K too, and other axes may move from hole to hole.
static uint32_t letters_of_cycle(const nck_decode_t *self, const code_t *code) {
    const uint32_t letters = letters_of[code->takes];
    const int fanuc = self->machine->dialect.base == NCK_DIALECT_FANUC;
    const int drills = code->takes >= DRILL && code->takes <= DRILL_Q;
    return fanuc && drills ? letters | NCK_LETTERS_AXES | NCK_LETTER('K') : letters;
}

// An M code that is handed over: of the machine's own, or M29, whose taps are rigid anyhow.
static int is_own(const nck_decode_t *self, int64_t tenths) {
    const int taps = NCK_HAS_CYCLES && self->machine->dialect.base == NCK_DIALECT_FANUC;
    if (taps && tenths == RIGID) return 1;
    if (tenths % 10 == 0 && nck_printer_has(self, tenths / 10)) return 1;
    return tenths % 10 == 0 && nck_decode_own_m(self, tenths / 10) != NULL;
}

// What is not in the first tables: a cycle, or the machine may have it.
static nck_status_t other_code(const nck_decode_t *self, int g, int64_t tenths,
                               unsigned *step_out, uint32_t *takes_out) {
    const code_t *const code = g ? find_other(self, tenths) : find_rs274(self, 0, tenths);
    *takes_out = 0;
    if (code != NULL) {
        *step_out = code->step;
        *takes_out = letters_of_cycle(self, code);
        return NCK_OK;
    }
    if (!g && is_own(self, tenths)) {
        *step_out = NCK_STEP_OWN;
        return NCK_OK;
    }
    const int later = g ? is_later(g_later, sizeof g_later, 1, tenths)
                        : is_later(m_later, sizeof m_later, 10, tenths);
    if (later) return NCK_E_UNSUPPORTED;
    return g ? NCK_E_G_UNKNOWN : NCK_E_M_UNKNOWN;
}

nck_status_t nck_decode_code(const nck_decode_t *self, int letter, int64_t tenths,
                             unsigned *step_out, uint32_t *takes_out) {
    const int g = letter == 'G';
    const code_t *const code = g ? find(g_codes, sizeof g_codes / sizeof g_codes[0], tenths)
                                 : find(m_codes, sizeof m_codes / sizeof m_codes[0], tenths);
    if (code == NULL) return other_code(self, g, tenths, step_out, takes_out);
    *step_out = code->step;
    *takes_out = letters_of[code->takes];
    return NCK_OK;
}

int nck_words_are_arguments(const nck_words_t *words) {
    return (words->codes & NCK_STEP(NCK_STEP_CALL)) != 0
           && (words->code[NCK_STEP_CALL] == 650 || words->code[NCK_STEP_CALL] == 660);
}

int nck_words_set_axes(const nck_words_t *words) {
    const int offset = (words->codes & NCK_STEP(NCK_STEP_OFFSET)) != 0
                       && words->code[NCK_STEP_OFFSET] <= 920;
    const int length = (words->codes & NCK_STEP(NCK_STEP_LENGTH)) != 0
                       && words->code[NCK_STEP_LENGTH] == 431;
    const int layout = (words->codes & NCK_STEP(NCK_STEP_LAYOUT)) != 0
                       && (words->code[NCK_STEP_LAYOUT] & NCK_LAYOUT_HAS_AXES) != 0;
    return offset || length || layout;
}

uint32_t nck_decode_motion_takes(const nck_decode_t *self, int32_t motion) {
    if (motion < 20) return letters_of[AXES];
    if (motion <= 30) return letters_of[ARC];
    const code_t *const cycle = find_other(self, motion);
    return cycle != NULL ? letters_of_cycle(self, cycle) : 0;
}
