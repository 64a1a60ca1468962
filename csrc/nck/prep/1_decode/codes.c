// SPDX-License-Identifier: MIT
// The codes of the language: which step executes a G or M code, and which letters it uses.
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // size_t

enum { UNSUPPORTED = NCK_STEP_COUNT }; // known to the language, not built

typedef struct code {
    uint16_t tenths; // G61.1 is 611
    uint16_t step;   // nck_step_t or UNSUPPORTED
    uint32_t takes;  // letters
} code_t;

#define AXES NCK_LETTERS_AXES
#define ARC (NCK_LETTERS_AXES | NCK_LETTERS_CENTRE | NCK_LETTER('R') | NCK_LETTER('P'))

// Ordered by how often programs use them: the search is from the front.
static const code_t g_codes[] = {
    {10, NCK_STEP_MOTION, AXES}, {0, NCK_STEP_MOTION, AXES},
    {20, NCK_STEP_MOTION, ARC}, {30, NCK_STEP_MOTION, ARC},
    {40, NCK_STEP_DWELL, NCK_LETTER('P')},
    {170, NCK_STEP_PLANE, 0}, {180, NCK_STEP_PLANE, 0}, {190, NCK_STEP_PLANE, 0},
    {200, NCK_STEP_UNITS, 0}, {210, NCK_STEP_UNITS, 0},
    {900, NCK_STEP_DISTANCE, 0}, {910, NCK_STEP_DISTANCE, 0},
    {901, NCK_STEP_CENTRE, 0}, {911, NCK_STEP_CENTRE, 0},
    {930, NCK_STEP_FEED_MODE, 0}, {940, NCK_STEP_FEED_MODE, 0}, {950, NCK_STEP_FEED_MODE, 0},
    {610, NCK_STEP_PATH, 0}, {611, NCK_STEP_PATH, 0},
    {640, NCK_STEP_PATH, NCK_LETTER('P') | NCK_LETTER('Q')},
    {800, NCK_STEP_MOTION, 0}, {530, NCK_STEP_MACHINE, 0}, {400, NCK_STEP_RADIUS_COMP, 0},
    {540, NCK_STEP_WORK, 0}, {550, NCK_STEP_WORK, 0}, {560, NCK_STEP_WORK, 0},
    {570, NCK_STEP_WORK, 0}, {580, NCK_STEP_WORK, 0}, {590, NCK_STEP_WORK, 0},
    {591, NCK_STEP_WORK, 0}, {592, NCK_STEP_WORK, 0}, {593, NCK_STEP_WORK, 0},
    {430, NCK_STEP_LENGTH, NCK_LETTER('H')}, {490, NCK_STEP_LENGTH, 0},
    {280, NCK_STEP_OFFSET, AXES}, {300, NCK_STEP_OFFSET, AXES},
    {920, NCK_STEP_OFFSET, AXES},
    {921, NCK_STEP_OFFSET, 0}, {922, NCK_STEP_OFFSET, 0}, {923, NCK_STEP_OFFSET, 0},
    {100, NCK_STEP_OFFSET, AXES | NCK_LETTER('L') | NCK_LETTER('P') | NCK_LETTER('R')},
    {70, NCK_STEP_DIAMETER, 0}, {80, NCK_STEP_DIAMETER, 0},
    {90, NCK_STEP_EXACT, 0}, {970, NCK_STEP_SPEED_MODE, 0},
    {50, UNSUPPORTED, 0}, {51, UNSUPPORTED, 0}, {52, UNSUPPORTED, 0}, {53, UNSUPPORTED, 0},
    {171, UNSUPPORTED, 0}, {181, UNSUPPORTED, 0}, {191, UNSUPPORTED, 0},
    {281, UNSUPPORTED, 0}, {301, UNSUPPORTED, 0}, {330, UNSUPPORTED, 0}, {331, UNSUPPORTED, 0},
    {382, UNSUPPORTED, 0}, {383, UNSUPPORTED, 0}, {384, UNSUPPORTED, 0}, {385, UNSUPPORTED, 0},
    {410, UNSUPPORTED, 0}, {411, UNSUPPORTED, 0}, {420, UNSUPPORTED, 0}, {421, UNSUPPORTED, 0},
    {431, UNSUPPORTED, 0}, {432, UNSUPPORTED, 0}, {520, UNSUPPORTED, 0},
    {700, UNSUPPORTED, 0}, {710, UNSUPPORTED, 0}, {711, UNSUPPORTED, 0}, {712, UNSUPPORTED, 0},
    {720, UNSUPPORTED, 0}, {721, UNSUPPORTED, 0}, {722, UNSUPPORTED, 0}, {730, UNSUPPORTED, 0},
    {740, UNSUPPORTED, 0}, {760, UNSUPPORTED, 0}, {810, UNSUPPORTED, 0}, {820, UNSUPPORTED, 0},
    {830, UNSUPPORTED, 0}, {840, UNSUPPORTED, 0}, {850, UNSUPPORTED, 0}, {860, UNSUPPORTED, 0},
    {870, UNSUPPORTED, 0}, {880, UNSUPPORTED, 0}, {890, UNSUPPORTED, 0},
    {960, UNSUPPORTED, 0}, {980, UNSUPPORTED, 0}, {990, UNSUPPORTED, 0}
};

static const code_t m_codes[] = {
    {0, NCK_STEP_STOP, 0}, {10, NCK_STEP_STOP, 0}, {20, NCK_STEP_STOP, 0},
    {300, NCK_STEP_STOP, 0}, {600, NCK_STEP_STOP, 0},
    {30, NCK_STEP_SPINDLE, 0}, {40, NCK_STEP_SPINDLE, 0}, {50, NCK_STEP_SPINDLE, 0},
    {60, NCK_STEP_CHANGE, 0},
    {70, NCK_STEP_MIST, 0}, {80, NCK_STEP_FLOOD, 0}, {90, NCK_STEP_FLOOD, 0},
    {480, NCK_STEP_OVERRIDE, 0}, {490, NCK_STEP_OVERRIDE, 0},
    {190, UNSUPPORTED, 0}, {500, UNSUPPORTED, 0}, {510, UNSUPPORTED, 0}, {520, UNSUPPORTED, 0},
    {530, UNSUPPORTED, 0}, {610, UNSUPPORTED, 0}, {620, UNSUPPORTED, 0}, {630, UNSUPPORTED, 0},
    {640, UNSUPPORTED, 0}, {650, UNSUPPORTED, 0}, {660, UNSUPPORTED, 0}, {670, UNSUPPORTED, 0},
    {680, UNSUPPORTED, 0}, {700, UNSUPPORTED, 0}, {710, UNSUPPORTED, 0}, {720, UNSUPPORTED, 0},
    {730, UNSUPPORTED, 0}, {980, UNSUPPORTED, 0}, {990, UNSUPPORTED, 0}
};

static const code_t *find(const code_t *codes, size_t count, int64_t tenths) {
    for (size_t k = 0; k < count; k++) {
        if (codes[k].tenths == tenths) return &codes[k];
    }
    return NULL;
}

nck_status_t nck_decode_code(int letter, int64_t tenths, unsigned *step_out, uint32_t *takes_out) {
    const code_t *const code = letter == 'G'
        ? find(g_codes, sizeof g_codes / sizeof g_codes[0], tenths)
        : find(m_codes, sizeof m_codes / sizeof m_codes[0], tenths);
    if (code == NULL) return letter == 'G' ? NCK_E_G_UNKNOWN : NCK_E_M_UNKNOWN;
    if (code->step == UNSUPPORTED) return NCK_E_UNSUPPORTED;
    *step_out = code->step;
    *takes_out = code->takes;
    return NCK_OK;
}

uint32_t nck_decode_motion_takes(int32_t motion) {
    return motion >= 20 ? ARC : AXES;
}
