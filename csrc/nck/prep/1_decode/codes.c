// SPDX-License-Identifier: MIT
// The codes of the language: which step executes a G or M code, and which letters it uses.
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // size_t

typedef struct code {
    uint16_t tenths; // G61.1 is 611
    uint16_t step;   // nck_step_t
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
    {90, NCK_STEP_EXACT, 0}, {970, NCK_STEP_SPEED_MODE, 0}
};

static const code_t m_codes[] = {
    {0, NCK_STEP_STOP, 0}, {10, NCK_STEP_STOP, 0}, {20, NCK_STEP_STOP, 0},
    {300, NCK_STEP_STOP, 0}, {600, NCK_STEP_STOP, 0},
    {30, NCK_STEP_SPINDLE, 0}, {40, NCK_STEP_SPINDLE, 0}, {50, NCK_STEP_SPINDLE, 0},
    {60, NCK_STEP_CHANGE, 0},
    {70, NCK_STEP_MIST, 0}, {80, NCK_STEP_FLOOD, 0}, {90, NCK_STEP_FLOOD, 0},
    {480, NCK_STEP_OVERRIDE, 0}, {490, NCK_STEP_OVERRIDE, 0}
};

// Known to RS274NGC or to Fanuc's controls, not built.
static const uint16_t g_later[] = {
    50, 51, 52, 53, 62, 71, 72, 106, 109, 110, 120, 121, 130, 131, 150, 160, 171, 181, 191, 220,
    230, 250, 260, 270, 281, 290, 301, 310, 320, 330, 331, 340, 350, 360, 370, 380, 382, 383, 384,
    385, 390, 401, 410, 411, 412, 413, 414, 415, 416, 420, 421, 422, 424, 425, 426, 431, 432, 433,
    434, 435, 437, 440, 450, 460, 470, 480, 500, 501, 502, 503, 510, 511, 512, 520, 531, 532, 536,
    541, 542, 544, 600, 620, 630, 650, 660, 661, 670, 680, 681, 682, 683, 684, 690, 691, 700, 710,
    711, 712, 720, 721, 722, 730, 740, 750, 760, 770, 780, 790, 810, 811, 820, 830, 840, 842, 843,
    850, 860, 870, 880, 890, 960, 980, 990, 1070, 1120, 1130
};

static const uint16_t m_later[] = {
    100, 110, 130, 140, 190, 290, 400, 410, 420, 430, 440, 450, 500, 510, 520, 530, 560, 610, 620,
    630, 640, 650, 660, 670, 680, 700, 710, 720, 730, 960, 970, 980, 990, 1980
};

static const code_t *find(const code_t *codes, size_t count, int64_t tenths) {
    for (size_t k = 0; k < count; k++) {
        if (codes[k].tenths == tenths) return &codes[k];
    }
    return NULL;
}

static int is_later(const uint16_t *codes, size_t count, int64_t tenths) {
    for (size_t k = 0; k < count; k++) {
        if (codes[k] == tenths) return 1;
    }
    return 0;
}

nck_status_t nck_decode_code(int letter, int64_t tenths, unsigned *step_out, uint32_t *takes_out) {
    const int g = letter == 'G';
    const code_t *const code = g ? find(g_codes, sizeof g_codes / sizeof g_codes[0], tenths)
                                 : find(m_codes, sizeof m_codes / sizeof m_codes[0], tenths);
    if (code == NULL) {
        const int later = g ? is_later(g_later, sizeof g_later / sizeof g_later[0], tenths)
                            : is_later(m_later, sizeof m_later / sizeof m_later[0], tenths);
        if (later) return NCK_E_UNSUPPORTED;
        return g ? NCK_E_G_UNKNOWN : NCK_E_M_UNKNOWN;
    }
    *step_out = code->step;
    *takes_out = code->takes;
    return NCK_OK;
}

uint32_t nck_decode_motion_takes(int32_t motion) {
    return motion >= 20 ? ARC : AXES;
}
