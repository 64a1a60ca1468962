// SPDX-License-Identifier: MIT
// The arguments of G65 and G66: which parameter a word sets.
//
//     A B C D E F H I J K M Q …                        by their letters
//     A B C, then I J K I J K … (ten times at most)    #4 #5 #6, #7 #8 #9 …
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_at nck_decode_fail_word …
#include "nck/prep/1_decode/number/number.h" // nck_number_real

#include <stddef.h> // NULL

enum { SET = 3, SETS = 10, ALL = 7 };

// By letter; 0: none.
static const uint8_t parameter_of[NCK_LETTERS] = {
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26
};

static int is_modal(const nck_decode_t *self) {
    return self->words.code[NCK_STEP_CALL] == 660;
}

static nck_status_t fail(nck_decode_t *self, nck_status_t code, const char *at) {
    return nck_decode_fail_at(self, code, at, *at & ~0x20, 0.0, 0.0);
}

// Controls count sets, or each letter: what would not be the same by both is refused.
nck_status_t nck_argument_place(nck_decode_t *self, const char *at, unsigned *place_out) {
    nck_words_t *const words = &self->words;
    const unsigned letter = (unsigned)((*at & ~0x20) - 'I');
    const unsigned before = words->place;
    unsigned place = (before > 0 ? (before - 1) / SET * SET : 0) + letter + 1;
    if (!NCK_HAS_CALLS) return fail(self, NCK_E_UNSUPPORTED, at);
    if (before == 0) {
        words->sets = ALL;
        words->set = 0;
    }
    if (place <= before) {
        words->sets &= words->set;
        words->set = 0;
        place += SET;
    }
    if (place > SET * SETS) return fail(self, NCK_E_WORD_TWICE, at);
    if (place > SET && !(words->sets >> letter & 1u)) return fail(self, NCK_E_UNSUPPORTED, at);
    if (place > SET && before <= SET) nck_variable_drop_kept(self, is_modal(self));
    words->set |= (uint8_t)(1u << letter);
    words->place = (uint8_t)place;
    *place_out = place;
    return NCK_OK;
}

nck_status_t nck_argument_keep(nck_decode_t *self, const char *at, unsigned place,
                               const nck_number_t *number) {
    nck_words_t *const words = &self->words;
    const unsigned letter = (unsigned)((*at & ~0x20) - 'A');
    if (place > SET) {
        const uint64_t key = nck_variable_kept(parameter_of['I' - 'A'] + place - 1, is_modal(self));
        return nck_variable_add(self, key, nck_number_real(number));
    }
    words->number[letter] = *number;
    words->letters |= (uint32_t)1 << letter;
    words->column[letter] = (uint16_t)(at - self->line.text + 1);
    return NCK_OK;
}

nck_status_t nck_argument_all(nck_decode_t *self) {
    const int modal = is_modal(self);
    const int in_sets = self->words.place > SET;
    nck_status_t status = NCK_OK;
    if (!in_sets) nck_variable_drop_kept(self, modal);
    for (unsigned k = 0; k < NCK_LETTERS && status == NCK_OK; k++) {
        if (parameter_of[k] == 0 || !(self->words.letters >> k & 1u)) continue;
        const uint64_t key = nck_variable_kept(parameter_of[k], modal);
        if (in_sets && nck_variable_find(self, key) != NULL) {
            return nck_decode_fail_word(self, NCK_E_WORD_TWICE, (int)k + 'A', 0.0, 0.0);
        }
        status = nck_variable_add(self, key, nck_number_real(&self->words.number[k]));
    }
    return status;
}
