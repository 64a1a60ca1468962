// SPDX-License-Identifier: MIT
// Fanuc's G-code systems of lathes: what their codes mean, and U V W, which count steps in A.
#include "nck/prep/1_decode/tongue/tongue.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_word
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_letter …

#include <stddef.h> // size_t

enum {
    AXIS_U = 6,
    FIRST_DRILL = 830, LAST_DRILL = 890 // G83 … G89
};

int nck_lathe_speaks_fanuc(const nck_decode_t *self) {
    if (!NCK_HAS_LATHE) return 0;
    return self->machine->kinematics == NCK_KINEMATICS_LATHE_XZ && nck_is_fanuc(self);
}

static uint32_t system_of(const nck_decode_t *self) {
    const uint32_t system = self->machine->dialect.system;
    return system == NCK_SYSTEM_OPEN ? NCK_SYSTEM_A : system;
}

int64_t nck_lathe_code(const nck_decode_t *self, int64_t tenths) {
    if (!NCK_HAS_LATHE) return tenths;
    // Of the codes that are not alike in all systems: what they are in B, and a pass of a thread as
    // RS274NGC has it. G34, which is unsupported, stands for what a system has not.
    static const struct {
        uint16_t system, from, to;
    } codes[] = {
        {NCK_SYSTEM_A, 900, NCK_MOTION_TURN}, {NCK_SYSTEM_A, 920, NCK_MOTION_THREAD},
        {NCK_SYSTEM_A, 940, NCK_MOTION_FACE}, {NCK_SYSTEM_A, 980, 940},
        {NCK_SYSTEM_A, 990, 950}, {NCK_SYSTEM_A, 500, 920}, {NCK_SYSTEM_A, 910, 340},
        {NCK_SYSTEM_A, 950, 340}, {NCK_SYSTEM_A, 770, 340}, {NCK_SYSTEM_A, 790, 340},
        {NCK_SYSTEM_A, 780, 340}, {NCK_SYSTEM_A, 330, 340}, {NCK_SYSTEM_A, 320, NCK_MOTION_PASS},
        {NCK_SYSTEM_C, 200, NCK_MOTION_TURN}, {NCK_SYSTEM_C, 210, NCK_MOTION_THREAD},
        {NCK_SYSTEM_C, 240, NCK_MOTION_FACE}, {NCK_SYSTEM_C, 700, 200}, {NCK_SYSTEM_C, 710, 210},
        {NCK_SYSTEM_C, 720, NCK_MOTION_FINISH}, {NCK_SYSTEM_C, 730, NCK_MOTION_ROUGH},
        {NCK_SYSTEM_C, 740, NCK_MOTION_FACE_ROUGH}, {NCK_SYSTEM_C, 750, NCK_MOTION_PATTERN},
        {NCK_SYSTEM_C, 760, NCK_MOTION_PECK_Z}, {NCK_SYSTEM_C, 770, NCK_MOTION_PECK_X},
        {NCK_SYSTEM_C, 790, 340},
        {NCK_SYSTEM_C, 780, NCK_MOTION_SCREW}
    };
    for (size_t k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        if (codes[k].system == system_of(self) && codes[k].from == tenths) return codes[k].to;
    }
    return tenths;
}

int nck_lathe_is_a(const nck_decode_t *self) {
    if (!NCK_HAS_LATHE) return 0;
    return self->lathe && system_of(self) == NCK_SYSTEM_A;
}

// What else stands in the line may move the zero that the steps are told from.
static int moves_zero(const nck_words_t *words) {
    const uint32_t codes = NCK_STEP(NCK_STEP_UNITS) | NCK_STEP(NCK_STEP_DIAMETER)
                           | NCK_STEP(NCK_STEP_LENGTH) | NCK_STEP(NCK_STEP_WORK)
                           | NCK_STEP(NCK_STEP_MACHINE);
    const int sets = (words->codes & NCK_STEP(NCK_STEP_OFFSET))
                     && (words->code[NCK_STEP_OFFSET] == 100
                         || words->code[NCK_STEP_OFFSET] == 520);
    return sets || (words->codes & codes) != 0;
}

// Whether an axis drills: its steps would count from R.
static int is_depth(const nck_decode_t *self, unsigned axis) {
    const int says = (self->words.codes & NCK_STEP(NCK_STEP_MOTION)) != 0;
    const int32_t motion = says ? self->words.code[NCK_STEP_MOTION] : self->modal.motion;
    return self->lathe && motion >= FIRST_DRILL && motion <= LAST_DRILL
           && axis == nck_motion_drill_of_lathe(motion);
}

// U, V or W becomes X, Y or Z.
static nck_status_t take_step(nck_decode_t *self, unsigned axis, int letter) {
    nck_words_t *const words = &self->words;
    const int place = nck_decode_letter(axis);
    int64_t at_nm = 0;
    if (!(self->place.axes >> axis & 1u)) {
        return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, letter, 0.0, 0.0);
    }
    if (words->letters & NCK_LETTER(place)) {
        return nck_decode_fail_word(self, NCK_E_WORD_TWICE, letter, 0.0, 0.0);
    }
    if (moves_zero(words) || is_depth(self, axis)) {
        return nck_decode_fail_word(self, NCK_E_INCREMENTAL, letter, 0.0, 0.0);
    }
    words->number[place - 'A'] = words->number[letter - 'A'];
    words->column[place - 'A'] = words->column[letter - 'A'];
    words->letters = (words->letters & ~NCK_LETTER(letter)) | NCK_LETTER(place);
    words->axes = (words->axes & ~((uint32_t)1 << (axis + AXIS_U))) | (uint32_t)1 << axis;
    const int says = (words->codes & NCK_STEP(NCK_STEP_DISTANCE)) != 0;
    const int steps = says ? words->code[NCK_STEP_DISTANCE] == 910 : self->modal.incremental;
    if (steps) return NCK_OK; // under G91 all words are
    nck_status_t status = nck_decode_axis_word(self, axis, &at_nm);
    if (status != NCK_OK) return status;
    at_nm += self->place.position_nm[axis] - self->place.origin_nm[axis];
    status = nck_decode_steps(self, axis, 0, 0, &at_nm);
    if (status == NCK_OK) nck_decode_write(self, axis, at_nm, &words->number[place - 'A']);
    return status;
}

// G28 or G30 of a mill without these axes, as in G28 U0 V0 W0.
static int goes_home(const nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const uint32_t code = words->code[NCK_STEP_OFFSET];
    return self->tongue == NCK_TONGUE_FANUC && (words->codes & NCK_STEP(NCK_STEP_OFFSET))
           && (code == 280 || code == 300);
}

nck_status_t nck_lathe_steps(nck_decode_t *self, uint32_t strangers) {
    if (!NCK_HAS_LATHE) return NCK_EMPTY;
    nck_status_t status = NCK_OK;
    const int steps = nck_lathe_is_a(self) || self->held.contour.called != 0;
    if (!steps && !goes_home(self)) return NCK_EMPTY;
    for (int letter = 'A'; letter <= 'Z'; letter++) {
        if (letter >= 'U' && letter <= 'W') continue;
        if (!(strangers & NCK_LETTER(letter))) continue;
        return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, letter, 0.0, 0.0);
    }
    for (unsigned axis = 0; axis < 3 && status == NCK_OK; axis++) {
        const int letter = nck_decode_letter(axis + AXIS_U);
        if (strangers & NCK_LETTER(letter)) status = take_step(self, axis, letter);
    }
    return status;
}
