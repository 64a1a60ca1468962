// SPDX-License-Identifier: MIT
// The codes of the language: which step executes a G or M code, and which letters it uses.
#include "nck/prep/1_decode/tongue/parts.h"

#include <stddef.h> // NULL size_t

enum {
    RIGID = 290, // M29
    PLAIN = 30,  // G3
    // Haas: G110 … G129 are G154 P1 … P20. G112 and G113 mean something else to Fanuc.
    FURTHER = 1100, FURTHER_LAST = 1290, POLAR = 1120, POLAR_END = 1130
};

// The sets of letters that codes use.
enum {
    NONE, AXES, ARC, CURVE, DWELL, PATH, LENGTH, REFERENCE, SET, CALL, MACRO, DRILL, DRILL_P,
    DRILL_Q, HOLE, HOLE_P, RADIUS, DIAMETER, TAP, TURN_PLANE, SCALE, MIRROR, DYNAMIC, INPUT,
    ANALOGUE, BEZIER, PARABOLA, NURBS, KNOTS, TURN, FACE, PECK, PASS, PASS_Q, THREAD, SCREW,
    SCREW_FANUC, LINES, SUB, COUNT, LEVEL, ROUGHNESS, EITHER,
    HOLE_PQ, BORE, ASKED, RING, HOMING, SETS
};

static const uint32_t letters_of[SETS] = {
    [NONE] = 0,
    [AXES] = NCK_LETTERS_AXES,
    [ARC] = NCK_LETTERS_AXES | NCK_LETTERS_CENTRE | NCK_LETTER('R') | NCK_LETTER('P'),
    [CURVE] = NCK_LETTERS_AXES | NCK_LETTERS_CENTRE | NCK_LETTER('R'),
    [DWELL] = NCK_LETTER('P'),
    [PATH] = NCK_LETTER('P') | NCK_LETTER('Q'),
    [LENGTH] = NCK_LETTER('H'),
    [REFERENCE] = NCK_LETTERS_AXES | NCK_LETTER('P'),
    // Marlin: how homing is done, which changes no place.
    [HOMING] = NCK_LETTERS_AXES | NCK_LETTER('L') | NCK_LETTER('R'),
    [SET] = NCK_LETTERS_AXES | NCK_LETTER('L') | NCK_LETTER('P') | NCK_LETTER('R')
            | NCK_LETTER('Q'),
    [CALL] = NCK_LETTER('L') | NCK_LETTER('P'),
    [MACRO] = (1 << NCK_LETTERS) - 1,
    [DRILL] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L'),
    [DRILL_P] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('P'),
    [DRILL_Q] = NCK_LETTERS_XYZ | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('Q'),
    // Fanuc's mills count holes by K too, and other axes may move from hole to hole.
    [HOLE] = NCK_LETTERS_AXES | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('K'),
    [HOLE_P] = NCK_LETTERS_AXES | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('K')
               | NCK_LETTER('P'),
    [RADIUS] = NCK_LETTER('D'),
    [DIAMETER] = NCK_LETTER('D') | NCK_LETTER('L'),
    [TURN_PLANE] = NCK_LETTERS_XYZ | NCK_LETTER('R'),
    [SCALE] = NCK_LETTERS_XYZ | NCK_LETTERS_CENTRE | NCK_LETTER('P'),
    [MIRROR] = NCK_LETTERS_XYZ,
    [DYNAMIC] = NCK_LETTER('Z'),
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
    [PASS] = NCK_LETTERS_LINEAR | NCK_LETTER('K'),
    [PASS_Q] = NCK_LETTERS_LINEAR | NCK_LETTER('Q'),
    [THREAD] = NCK_LETTERS_LINEAR | NCK_LETTER('R') | NCK_LETTER('I') | NCK_LETTER('Q'),
    [SCREW] = NCK_LETTERS_CENTRE | NCK_LETTER('Z') | NCK_LETTER('E') | NCK_LETTER('H')
              | NCK_LETTER('L') | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('R'),
    [SCREW_FANUC] = NCK_LETTERS_LINEAR | NCK_LETTER('A') | NCK_LETTER('D') | NCK_LETTER('I')
                    | NCK_LETTER('K') | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('R'),
    [LINES] = NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('U') | NCK_LETTER('W')
              | NCK_LETTER('R') | NCK_LETTER('D') | NCK_LETTER('I') | NCK_LETTER('K'),
    [SUB] = NCK_LETTER('Q') | NCK_LETTER('X') | NCK_LETTER('Z') | NCK_LETTER('D') | NCK_LETTER('E')
            | NCK_LETTER('I') | NCK_LETTER('P') | NCK_LETTER('R'),
    [COUNT] = NCK_LETTER('P'),
    [ASKED] = NCK_LETTER('Q'),
    [RING] = NCK_LETTERS_XYZ | NCK_LETTERS_CENTRE | NCK_LETTER('L'),
    [EITHER] = NCK_LETTER('D') | NCK_LETTER('H'),
    [HOLE_PQ] = NCK_LETTERS_AXES | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('K')
                | NCK_LETTER('P') | NCK_LETTER('Q'),
    [BORE] = NCK_LETTERS_AXES | NCK_LETTER('R') | NCK_LETTER('L') | NCK_LETTER('K')
             | NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('I') | NCK_LETTER('J'),
    [LEVEL] = NCK_LETTER('Q') | NCK_LETTER('P') | NCK_LETTER('R'),
    [ROUGHNESS] = NCK_LETTER('P') | NCK_LETTER('E')
};

// Whose a row is: bits of nck_tongue_t behind those of the code.
enum {
    CODE = 0x7ff, WHO = 11,
    L = NCK_TONGUE_LINUXCNC << WHO,
    F = NCK_TONGUE_FANUC << WHO,
    T = NCK_TONGUE_TURNING << WHO,
    G = NCK_TONGUE_GRBL << WHO,
    P = NCK_TONGUE_MARLIN << WHO,
    ALL = L | F | T | G | P
};

typedef struct code {
    uint16_t name; // in tenths, G61.1 is 611, and whose it is
    uint8_t step;  // nck_step_t
    uint8_t takes; // place in letters_of
} code_t;

// One row for each code and what it means to those whose it is; what no row gives to a language is
// refused there. Sources: the G code lists of LinuxCNC 2.9, of Fanuc's 0i and 30i (M, and T in
// G-code system B), of grbl 1.1 and of Marlin 2.1.
// G9 is ours in the language of LinuxCNC, which has G61.1 alone for it.
// Ordered by how often programs use them: the search is from the front.
static const code_t g_codes[] = {
    {ALL | 10, NCK_STEP_MOTION, AXES}, {ALL, NCK_STEP_MOTION, AXES}, // G1, G0
    {L | P | 20, NCK_STEP_MOTION, ARC}, {L | P | 30, NCK_STEP_MOTION, ARC},
    {F | T | G | 20, NCK_STEP_MOTION, CURVE}, {F | T | G | 30, NCK_STEP_MOTION, CURVE},
    {ALL | 900, NCK_STEP_DISTANCE, NONE}, {ALL | 910, NCK_STEP_DISTANCE, NONE},
    {ALL | 40, NCK_STEP_DWELL, DWELL}, {ALL | 170, NCK_STEP_PLANE, NONE},
    {ALL | 180, NCK_STEP_PLANE, NONE}, {ALL | 190, NCK_STEP_PLANE, NONE},
    {ALL | 200, NCK_STEP_UNITS, NONE}, {ALL | 210, NCK_STEP_UNITS, NONE},
    {L | 901, NCK_STEP_CENTRE, NONE}, {L | G | 911, NCK_STEP_CENTRE, NONE},
    {L | F | T | G | 940, NCK_STEP_FEED_MODE, NONE},
    {L | F | T | G | 930, NCK_STEP_FEED_MODE, NONE},
    {L | F | T | 950, NCK_STEP_FEED_MODE, NONE}, {L | F | T | G | 610, NCK_STEP_PATH, NONE},
    {L | 611, NCK_STEP_PATH, NONE}, {L | 640, NCK_STEP_PATH, PATH},
    {F | T | 640, NCK_STEP_PATH, NONE}, {F | T | 50, NCK_STEP_PATH, COUNT},
    {F | T | 51, NCK_STEP_PATH, LEVEL}, {F | T | 80, NCK_STEP_PATH, COUNT},
    {F | T | 611, NCK_STEP_PATH, NONE}, {F | T | 620, NCK_STEP_PATH, NONE},
    {F | T | 630, NCK_STEP_PATH, NONE}, {F | T | 1870, NCK_STEP_PATH, ROUGHNESS},
    {F | T | 1030, NCK_STEP_PATH, COUNT},
    {F | T | 109, NCK_STEP_PATH, NONE},
    {L | T | G | 800, NCK_STEP_MOTION, NONE}, {F | 800, NCK_STEP_MOTION, AXES},
    {ALL | 530, NCK_STEP_MACHINE, NONE}, {L | F | T | G | 400, NCK_STEP_RADIUS_COMP, NONE},
    {L | 410, NCK_STEP_RADIUS_COMP, RADIUS}, {L | 420, NCK_STEP_RADIUS_COMP, RADIUS},
    {F | T | 410, NCK_STEP_RADIUS_COMP, EITHER}, {F | T | 420, NCK_STEP_RADIUS_COMP, EITHER},
    {L | 411, NCK_STEP_RADIUS_COMP, DIAMETER},
    {L | 421, NCK_STEP_RADIUS_COMP, DIAMETER}, {L | G | P | 540, NCK_STEP_WORK, NONE},
    {F | T | 540, NCK_STEP_WORK, COUNT}, {F | T | 541, NCK_STEP_WORK, COUNT},
    {F | T | 1540, NCK_STEP_WORK, COUNT}, {F | T | FURTHER, NCK_STEP_WORK, NONE},
    {ALL | 550, NCK_STEP_WORK, NONE}, {ALL | 560, NCK_STEP_WORK, NONE},
    {ALL | 570, NCK_STEP_WORK, NONE}, {ALL | 580, NCK_STEP_WORK, NONE},
    {ALL | 590, NCK_STEP_WORK, NONE}, {L | P | 591, NCK_STEP_WORK, NONE},
    {L | P | 592, NCK_STEP_WORK, NONE}, {L | P | 593, NCK_STEP_WORK, NONE},
    {L | F | 430, NCK_STEP_LENGTH, LENGTH}, {L | F | G | 490, NCK_STEP_LENGTH, NONE},
    {L | 431, NCK_STEP_LENGTH, MIRROR}, {G | 431, NCK_STEP_LENGTH, DYNAMIC},
    {L | 432, NCK_STEP_LENGTH, LENGTH}, {L | F | T | G | 280, NCK_STEP_OFFSET, AXES},
    {P | 280, NCK_STEP_OFFSET, HOMING},
    {L | G | 300, NCK_STEP_OFFSET, AXES}, {F | T | 300, NCK_STEP_OFFSET, REFERENCE},
    {ALL | 920, NCK_STEP_OFFSET, AXES}, {L | F | T | 520, NCK_STEP_OFFSET, AXES},
    {L | G | 921, NCK_STEP_OFFSET, NONE}, {L | 922, NCK_STEP_OFFSET, NONE},
    {L | 923, NCK_STEP_OFFSET, NONE}, {L | F | T | G | 100, NCK_STEP_OFFSET, SET},
    {L | G | 281, NCK_STEP_OFFSET, NONE}, {L | G | 301, NCK_STEP_OFFSET, NONE},
    {L | 70, NCK_STEP_DIAMETER, NONE}, {L | 80, NCK_STEP_DIAMETER, NONE},
    {L | F | T | 90, NCK_STEP_EXACT, NONE}, {L | F | T | 970, NCK_STEP_SPEED_MODE, NONE},
    {L | 960, NCK_STEP_SPEED_MODE, RADIUS}, {F | T | 960, NCK_STEP_SPEED_MODE, NONE},
    {F | T | 650, NCK_STEP_CALL, MACRO}, {F | T | 660, NCK_STEP_CALL, MACRO},
    {F | T | 670, NCK_STEP_CALL, NONE},
    // What they end is not built, so they have nothing to do.
    {F | T | 131, NCK_STEP_COUNT, NONE}, {F | T | 230, NCK_STEP_COUNT, NONE},
    {F | T | 250, NCK_STEP_COUNT, NONE}, {F | T | 401, NCK_STEP_COUNT, NONE},
    {F | T | 502, NCK_STEP_COUNT, NONE}
};

// Behind the others: nobody's plain lines pay for them.
static const code_t cycle_codes[] = {
    {L | 810, NCK_STEP_MOTION, DRILL}, {F | 810, NCK_STEP_MOTION, HOLE},
    {L | 830, NCK_STEP_MOTION, DRILL_Q}, {F | T | 830, NCK_STEP_MOTION, HOLE_PQ},
    {L | 730, NCK_STEP_MOTION, DRILL_Q}, {F | 730, NCK_STEP_MOTION, HOLE_PQ},
    {L | 820, NCK_STEP_MOTION, DRILL_P}, {F | 820, NCK_STEP_MOTION, HOLE_P},
    {L | 850, NCK_STEP_MOTION, DRILL}, {F | 850, NCK_STEP_MOTION, HOLE},
    {L | 860, NCK_STEP_MOTION, DRILL_P}, {F | 860, NCK_STEP_MOTION, HOLE_P},
    {L | 890, NCK_STEP_MOTION, DRILL_P}, {F | T | 890, NCK_STEP_MOTION, HOLE_P},
    {F | 700, NCK_STEP_MOTION, RING}, {F | 710, NCK_STEP_MOTION, RING},
    {F | NCK_MOTION_SCREW, NCK_STEP_MOTION, BORE},
    {F | NCK_MOTION_BORE_BACK, NCK_STEP_MOTION, BORE},
    {L | NCK_MOTION_TAP_RIGHT, NCK_STEP_MOTION, DRILL_P},
    {F | T | NCK_MOTION_TAP_RIGHT, NCK_STEP_MOTION, HOLE_P},
    {L | NCK_MOTION_TAP_LEFT, NCK_STEP_MOTION, DRILL_P},
    {F | NCK_MOTION_TAP_LEFT, NCK_STEP_MOTION, HOLE_P}, {L | F | T | 980, NCK_STEP_RETRACT, NONE},
    {L | F | T | 990, NCK_STEP_RETRACT, NONE}, {L | G | 382, NCK_STEP_MOTION, AXES},
    {L | G | 383, NCK_STEP_MOTION, AXES}, {L | G | 384, NCK_STEP_MOTION, AXES},
    {L | G | 385, NCK_STEP_MOTION, AXES}, {F | T | NCK_MOTION_SKIP, NCK_STEP_MOTION, AXES},
    {L | NCK_MOTION_PASS, NCK_STEP_MOTION, PASS},
    {L | NCK_MOTION_SCREW, NCK_STEP_MOTION, SCREW}, {L | NCK_MOTION_TAP, NCK_STEP_MOTION, TAP},
    {T | NCK_MOTION_TURN, NCK_STEP_MOTION, TURN}, {T | NCK_MOTION_FACE, NCK_STEP_MOTION, FACE},
    {T | NCK_MOTION_PASS, NCK_STEP_MOTION, PASS_Q},
    {T | NCK_MOTION_THREAD, NCK_STEP_MOTION, THREAD},
    {T | NCK_MOTION_SCREW, NCK_STEP_MOTION, SCREW_FANUC},
    {T | NCK_MOTION_PECK_Z, NCK_STEP_MOTION, PECK}, {T | NCK_MOTION_PECK_X, NCK_STEP_MOTION, PECK},
    {T | 850, NCK_STEP_MOTION, HOLE_P}, {T | NCK_MOTION_BORE_BACK, NCK_STEP_MOTION, HOLE_PQ},
    {T | NCK_MOTION_TAP_SIDE, NCK_STEP_MOTION, HOLE_P}
};

static const code_t contour_codes[] = {
    {T | NCK_MOTION_FINISH, NCK_STEP_MOTION, LINES}, {T | NCK_MOTION_ROUGH, NCK_STEP_MOTION, LINES},
    {T | NCK_MOTION_FACE_ROUGH, NCK_STEP_MOTION, LINES},
    {T | NCK_MOTION_PATTERN, NCK_STEP_MOTION, LINES}, {L | NCK_MOTION_FINISH, NCK_STEP_MOTION, SUB},
    {L | NCK_MOTION_ROUGH, NCK_STEP_MOTION, SUB}, {L | 711, NCK_STEP_MOTION, SUB},
    {L | 712, NCK_STEP_MOTION, SUB}, {L | NCK_MOTION_FACE_ROUGH, NCK_STEP_MOTION, SUB},
    {L | 721, NCK_STEP_MOTION, SUB}, {L | 722, NCK_STEP_MOTION, SUB},
    {L | P | NCK_MOTION_CUBIC, NCK_STEP_MOTION, BEZIER},
    {L | NCK_MOTION_QUADRATIC, NCK_STEP_MOTION, PARABOLA},
    {L | NCK_MOTION_NURBS, NCK_STEP_MOTION, NURBS},
    {L | NCK_MOTION_NURBS_END, NCK_STEP_MOTION, NONE},
    {F | NCK_MOTION_KNOTS, NCK_STEP_MOTION, KNOTS}
};

static const code_t layout_codes[] = {
    {F | 150, NCK_STEP_LAYOUT, NONE}, {F | 160, NCK_STEP_LAYOUT, NONE},
    {F | 500, NCK_STEP_LAYOUT, NONE}, {F | 510, NCK_STEP_LAYOUT, SCALE},
    {F | 501, NCK_STEP_LAYOUT, MIRROR}, {F | 511, NCK_STEP_LAYOUT, MIRROR},
    {F | 690, NCK_STEP_LAYOUT, NONE}, {F | 680, NCK_STEP_LAYOUT, TURN_PLANE}
};

static const code_t m_codes[] = {
    {ALL, NCK_STEP_STOP, NONE}, {ALL | 10, NCK_STEP_STOP, NONE},
    {L | F | T | G | 20, NCK_STEP_STOP, NONE}, {L | F | T | G | 300, NCK_STEP_STOP, NONE},
    {L | 600, NCK_STEP_STOP, NONE}, {ALL | 30, NCK_STEP_SPINDLE, NONE},
    {ALL | 40, NCK_STEP_SPINDLE, NONE}, {ALL | 50, NCK_STEP_SPINDLE, NONE},
    {L | F | T | 60, NCK_STEP_CHANGE, NONE}, {L | 610, NCK_STEP_CHANGE, ASKED},
    {ALL | 70, NCK_STEP_MIST, NONE},
    {ALL | 80, NCK_STEP_FLOOD, NONE}, {ALL | 90, NCK_STEP_FLOOD, NONE},
    {L | F | T | 480, NCK_STEP_OVERRIDE, NONE}, {L | F | T | 490, NCK_STEP_OVERRIDE, NONE},
    {F | T | 970, NCK_STEP_CALL, CALL}, {L | F | T | 980, NCK_STEP_CALL, CALL},
    {L | F | T | 990, NCK_STEP_CALL, CALL},
    {L | G | 620, NCK_STEP_PORT, DWELL}, {L | G | 630, NCK_STEP_PORT, DWELL},
    {L | G | 640, NCK_STEP_PORT, DWELL}, {L | G | 650, NCK_STEP_PORT, DWELL},
    {L | G | 660, NCK_STEP_PORT, INPUT}, {L | G | 670, NCK_STEP_PORT, ANALOGUE},
    {L | G | 680, NCK_STEP_PORT, ANALOGUE}, {L | 700, NCK_STEP_STATE, NONE},
    {L | 500, NCK_STEP_OVERRIDE, COUNT}, {L | 510, NCK_STEP_OVERRIDE, COUNT},
    {L | 520, NCK_STEP_OVERRIDE, COUNT}, {L | 530, NCK_STEP_OVERRIDE, COUNT},
    {L | 710, NCK_STEP_STATE, NONE}, {L | 720, NCK_STEP_STATE, NONE},
    {L | 730, NCK_STEP_STATE, NONE}
};

// Of a language, and not built, or not in a build without cycles: a code and whose it is.
static const uint16_t g_later[] = {
    F | 54, P | 60, L | T | 62, L | 63, F | T | 70, F | T | 71, T | 72, P | 100, F | T | 106,
    F | T | P | 110, F | T | P | 120, F | T | 121,
    F | T | 130, T | 150, T | 160, L | 171, L | 181, L | 191, F | T | 220,
    F | T | P | 260, F | T | P | 270, F | T | P | 290, P | 300, F | T | 301,
    P | 310, P | 320, F | P | 330, F | T | P | 340, F | T | P | 350, F | T | 360,
    F | T | 370, F | T | 380, P | 382, P | 383, P | 384, P | 385, F | T | 390,
    F | T | 411, F | T | 412, F | T | 413, F | T | 414, F | T | 415, F | T | 416, P | 420,
    F | T | 421, F | T | 422, F | T | 424, F | T | P | 425, F | T | 426, T | 430, F | T | 431,
    F | T | 433, F | T | 434, F | T | 435, F | T | 437, F | T | 440, F | 450, F | 460, F | 470,
    F | 480, T | 490, T | 500, T | 501, F | T | 503, T | 510, T | 511, F | T | 512,
    F | T | 531, F | 532, F | T | 536, F | 542, F | 544, F | T | P | 600, P | 610,
    F | T | 661, T | 680, F | T | 681, F | 682, F | 683, F | 684, T | 690,
    F | T | 691, L | 700, L | 710, L | 711, L | 712, L | F | 720, L | F | 721, L | F | 722,
    F | 750, P | 760, F | 770, F | 780, F | 790, T | 810, F | T | 811, T | 820, T | 830, T | 840,
    F | T | 842, F | T | 843, T | 850, T | 860, L | T | 870, L | F | T | 880, T | 890, F | 911,
    F | T | P | 921, T | 980, T | 990, F | T | 1070, F | T | 1120, F | T | 1130, F | 1500
};

static const uint16_t m_later[] = {
    ALL | 100, ALL | 110, ALL | 130, ALL | 140, ALL | 190, F | T | 290, P | 300, ALL | 400,
    ALL | 410, ALL | 420, ALL | 430, ALL | 440, ALL | 450, P | 480, P | 490, G | 560,
    F | T | 960, F | T | 1980
};

#define ALL_OF(rows) rows, sizeof rows / sizeof rows[0]

// The row of a code of one of the languages `who`; NULL: none.
static const code_t *find(const code_t *codes, size_t count, int64_t tenths, uint32_t who) {
    for (size_t k = 0; k < count; k++) {
        const uint32_t name = codes[k].name;
        if ((name & CODE) == tenths && (name & who << WHO)) return &codes[k];
    }
    return NULL;
}

// A code of the row of G110.
static int is_further(int64_t tenths) {
    return tenths >= FURTHER && tenths <= FURTHER_LAST && tenths % 10 == 0 && tenths != POLAR
           && tenths != POLAR_END;
}

static const code_t *find_g(int64_t named, uint32_t who) {
    const int64_t tenths = is_further(named) ? FURTHER : named;
    const code_t *code = find(ALL_OF(g_codes), tenths, who);
    if (code == NULL && NCK_HAS_CYCLES) code = find(ALL_OF(cycle_codes), tenths, who);
    if (code == NULL && NCK_HAS_CONTOUR) code = find(ALL_OF(contour_codes), tenths, who);
    if (code == NULL && NCK_HAS_LAYOUTS) code = find(ALL_OF(layout_codes), tenths, who);
    return code;
}

static int is_later(const uint16_t *codes, size_t count, int64_t tenths, uint32_t who) {
    for (size_t k = 0; k < count; k++) {
        if ((codes[k] & CODE) == tenths && (codes[k] & who << WHO)) return 1;
    }
    return 0;
}

static int is_named(int g, int64_t tenths, uint32_t who) {
    if (!NCK_HAS_FOREIGN) return 0;
    return g ? is_later(ALL_OF(g_later), tenths, who) : is_later(ALL_OF(m_later), tenths, who);
}

const nck_own_m_t *nck_decode_own_m(const nck_decode_t *self, int64_t code) {
    const nck_machine_t *const machine = self->machine;
    for (uint32_t k = 0; k < machine->own_m_count; k++) {
        if (machine->own_m[k].code == code) return &machine->own_m[k];
    }
    return NULL;
}

// RS274NGC's contours are a lathe's.
static int is_lathe(const nck_decode_t *self) {
    return self->machine->kinematics == NCK_KINEMATICS_LATHE_XZ;
}

int nck_decode_follows(const nck_decode_t *self, int32_t motion) {
    const int g70 = self->tongue == NCK_TONGUE_LINUXCNC && is_lathe(self)
                    && motion < NCK_MOTION_PATTERN;
    return motion >= NCK_MOTION_FINISH && motion <= NCK_MOTION_PATTERN && (self->lathe || g70);
}

static int is_thread(const code_t *code) {
    switch (code->name & CODE) {
    case NCK_MOTION_PASS:
    case NCK_MOTION_TAP:
    case NCK_MOTION_TAP_RIGHT:
    case NCK_MOTION_TAP_LEFT:
    case NCK_MOTION_TAP_SIDE:
    case NCK_MOTION_THREAD: return 1;
    case NCK_MOTION_SCREW: return code->takes != BORE;
    default: return 0;
    }
}

// What a machine must be for a code: a lathe, or one that says what probes meet.
static int is_able(const nck_decode_t *self, const code_t *code) {
    if (!NCK_HAS_THREADS && is_thread(code)) return 0;
    if (code->takes == SUB) return is_lathe(self);
    if (!nck_motion_probes(code->name & CODE)) return 1;
    return self->machine->dialect.probe != NCK_PROBE_REFUSED;
}

// An M code that is handed over: of the machine's own, or M29, whose taps are rigid anyhow.
static int is_own(const nck_decode_t *self, int64_t tenths) {
    const unsigned fanuc = NCK_TONGUE_FANUC | NCK_TONGUE_TURNING;
    const int taps = NCK_HAS_CYCLES && (self->tongue & fanuc) != 0;
    if (taps && tenths == RIGID) return 1;
    if (nck_printer_has(self, tenths)) return 1;
    return tenths % 10 == 0 && nck_decode_own_m(self, tenths / 10) != NULL;
}

uint32_t nck_decode_who(int letter, int64_t tenths) {
    const int g = letter == 'G';
    const int printer = !g && nck_printer_names(tenths);
    uint32_t all = printer ? NCK_TONGUE_MARLIN : 0;
    for (uint32_t who = NCK_TONGUE_LINUXCNC; who <= NCK_TONGUE_MARLIN; who <<= 1) {
        const code_t *const code = g ? find_g(tenths, who) : find(ALL_OF(m_codes), tenths, who);
        if (code != NULL || is_named(g, tenths, who)) all |= who;
    }
    return all;
}

// A build without some of the tables cannot say whose a G code is: its language may have it.
enum { HAS_ALL = NCK_HAS_CYCLES && NCK_HAS_CONTOUR && NCK_HAS_LAYOUTS };

// What is in no table of the language: the machine may have it.
static nck_status_t other_code(const nck_decode_t *self, int g, int64_t tenths,
                               unsigned *step_out, uint32_t *takes_out) {
    if (!g && is_own(self, tenths)) {
        *step_out = NCK_STEP_OWN;
        return NCK_OK;
    }
    const int own_g = g && nck_decode_has_own_g(self, tenths);
    if (own_g || (g && nck_printer_has_g(self, tenths, takes_out))) {
        *step_out = NCK_STEP_OWN;
        if (own_g) *takes_out = letters_of[MACRO];
        return NCK_OK;
    }
    if (is_named(g, tenths, self->tongue)) return NCK_E_UNSUPPORTED;
    if (nck_decode_who(g ? 'G' : 'M', tenths) != 0) {
        return g && !HAS_ALL ? NCK_E_UNSUPPORTED : NCK_E_OTHER_BASE;
    }
    return g ? NCK_E_G_UNKNOWN : NCK_E_M_UNKNOWN;
}

// A G code of LinuxCNC's that grblHAL has not.
static int is_lacking(const nck_decode_t *self, int64_t tenths) {
    static const uint16_t lacks[] = {52, 53, 90, 331, 410, 411, 420, 421, 520, 611, 640,
                                     NCK_MOTION_TAP_LEFT, NCK_MOTION_TAP_RIGHT, 901};
    if (!NCK_HAS_FOREIGN || self->tongue != NCK_TONGUES_GRBLHAL) return 0;
    for (size_t k = 0; k < sizeof lacks / sizeof lacks[0]; k++) {
        if (lacks[k] == tenths) return 1;
    }
    return 0;
}

// G0 to G3 are everybody's, and nothing more is asked of them.
static nck_status_t check_able(const nck_decode_t *self, const code_t *code, int64_t tenths) {
    if (tenths <= PLAIN) return NCK_OK;
    if (is_lacking(self, tenths)) return NCK_E_OTHER_BASE;
    return is_able(self, code) ? NCK_OK : NCK_E_UNSUPPORTED;
}

nck_status_t nck_decode_code(const nck_decode_t *self, int letter, int64_t tenths,
                             unsigned *step_out, uint32_t *takes_out) {
    const int g = letter == 'G';
    const code_t *const code = g ? find_g(tenths, self->tongue)
                                 : find(ALL_OF(m_codes), tenths, self->tongue);
    *takes_out = 0;
    if (code == NULL) return other_code(self, g, tenths, step_out, takes_out);
    *step_out = code->step;
    *takes_out = letters_of[code->takes];
    return g ? check_able(self, code, tenths) : NCK_OK;
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
    const code_t *const code = find_g(motion, self->tongue);
    return code != NULL ? letters_of[code->takes] : 0;
}
