// SPDX-License-Identifier: MIT
// One source line as words: letters with numbers, and the G and M codes sorted by the step that
// executes them.
#ifndef NCK_PREP_DECODE_STATE_WORDS_H
#define NCK_PREP_DECODE_STATE_WORDS_H

#include "nck/prep/1_decode/state/number.h" // nck_number_t

// What a block may have to do, in the order in which it is done (RS274NGC, table of execution, with
// the units moved to the front: an F word is read in the units of its own block). One G or M code
// at most in each.
typedef enum nck_step {
    NCK_STEP_UNITS = 0,   // G20 G21
    NCK_STEP_FEED_MODE,   // G93 G94 G95
    NCK_STEP_FEED,        // F
    NCK_STEP_SPEED_MODE,  // G96 G97
    NCK_STEP_SPEED,       // S
    NCK_STEP_TOOL,        // T
    NCK_STEP_PORT,        // M62 … M68
    NCK_STEP_CHANGE,      // M6: the spindle stops first
    NCK_STEP_SPINDLE,     // M3 M4 M5
    NCK_STEP_STATE,       // M70 M71 M72 M73
    NCK_STEP_MIST,        // M7
    NCK_STEP_FLOOD,       // M8 M9
    NCK_STEP_OVERRIDE,    // M48 M49
    NCK_STEP_OWN,         // an M code of the machine's
    NCK_STEP_DWELL,       // G4
    NCK_STEP_PLANE,       // G17 G18 G19
    NCK_STEP_DIAMETER,    // G7 G8
    NCK_STEP_RADIUS_COMP, // G40 G41 G41.1 G42 G42.1
    NCK_STEP_LENGTH,      // G43 G49
    NCK_STEP_WORK,        // G54 … G59.3
    NCK_STEP_PATH,        // G61 G61.1 G64
    NCK_STEP_DISTANCE,    // G90 G91
    NCK_STEP_CENTRE,      // G90.1 G91.1
    NCK_STEP_RETRACT,     // G98 G99
    NCK_STEP_LAYOUT,      // G15 G16 G50 G50.1 G51 G51.1 G68 G69
    NCK_STEP_OFFSET,      // G10 G28 G30 G92 G92.1 G92.2 G92.3: each takes the axis words for itself
    NCK_STEP_EXACT,       // G9
    NCK_STEP_MACHINE,     // G53
    NCK_STEP_MOTION,      // G0 G1 G2 G3 G80, canned cycles
    NCK_STEP_REST,        // what is left of the line: nck_rest_t
    NCK_STEP_CALL,        // M98 M99 G65 G66 G67
    NCK_STEP_STOP,        // M0 M1 M2 M30 M60
    NCK_STEP_COUNT
} nck_step_t;

// What NCK_STEP_REST does.
typedef enum nck_rest {
    NCK_REST_CYCLE = 0,  // the next block of a cycle
    NCK_REST_SECOND = 1, // the second move of a G28 or of an arc in two parts
    NCK_REST_PUSHED = 2, // what a pushed block does, unless it is an M code
    NCK_REST_CORNER = 3  // a corner, and the move behind it
} nck_rest_t;

// Letters that a word may begin with.
enum { NCK_LETTERS = 26 };

// Bytes of a line.
static inline int nck_is_letter(char c) { return (unsigned)((c | 0x20) - 'a') < NCK_LETTERS; }
static inline int nck_is_digit(char c) { return c >= '0' && c <= '9'; }

// The first character that is no blank. Cost: linear in them.
static inline const char *nck_skip_blanks(const char *at) {
    while (*at == ' ' || *at == '\t') at++;
    return at;
}

// Bits of letters and steps.
#define NCK_LETTER(c) ((uint32_t)1 << ((c) - 'A'))
#define NCK_STEP(k) ((uint32_t)1 << (k))

enum { NCK_POLAR_SLANT = 4 };     // the bit of ,A in nck_words_t's polars
enum { NCK_CODE_OWN_G = 0x8000 }; // of the codes of NCK_STEP_OWN those of letter G are higher

// Sets of letters.
enum {
    NCK_LETTERS_LINEAR = (1 << ('X' - 'A')) | (1 << ('Y' - 'A')) | (1 << ('Z' - 'A'))
                       | (1 << ('U' - 'A')) | (1 << ('V' - 'A')) | (1 << ('W' - 'A')),
    NCK_LETTERS_XYZ = 7 << ('X' - 'A'),
    NCK_LETTERS_AXES = NCK_LETTERS_LINEAR | 7, // A B C
    NCK_LETTERS_CENTRE = (1 << ('I' - 'A')) | (1 << ('J' - 'A')) | (1 << ('K' - 'A'))
};

// Steps whose codes may have the axis words.
#define NCK_STEPS_AXES                                                                            \
    (NCK_STEP(NCK_STEP_OFFSET) | NCK_STEP(NCK_STEP_LAYOUT) | NCK_STEP(NCK_STEP_LENGTH))

// The words of the line in work. What a bit does not announce is left over from an earlier line.
typedef struct nck_words {
    uint32_t letters;                     // bit k: the letter A + k stands in the line
    uint32_t axes;                        // bit k: a word of axis k that is to move or to set it
    uint32_t steps;                       // bit k: step k is still to be done
    uint32_t codes;                       // bit k: step k has a code
    uint32_t takes;                       // letters that the codes use
    uint16_t code[NCK_STEP_COUNT];        // G and M codes in tenths: G61.1 is 611
    uint16_t code_column[NCK_STEP_COUNT]; // 1-based byte column of the code
    uint16_t column[NCK_LETTERS];         // 1-based byte column of the word
    nck_number_t number[NCK_LETTERS];
    double polar_at[2];                   // where @ and ^ lead: [mm], [deg]
    double polar_step[2];                 // what they say
    uint16_t polar_column;                // of the first of them
    uint8_t polars;                       // bit 0: @, bit 1: ^, bit 2: ,A stands in the line
    uint8_t rest;                         // nck_rest_t
    uint8_t tail;                         // 1: the line ended in a ; comment
    uint8_t place;                        // of the last I, J or K behind G65 or G66, from 1
    uint8_t set, sets;                    // which of them its set has, and every set before it
} nck_words_t;

#endif
