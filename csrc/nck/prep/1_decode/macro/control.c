// SPDX-License-Identifier: MIT
// Words that control: O words, assignments, Fanuc's IF, GOTO, WHILE, DO and END.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_at nck_decode_only nck_value_holds …

#include <stddef.h> // NULL

enum { ALARMS = 3000, STOPS = 3006 }; // numbers of parameters

static const double label_most = NCK_LABEL_MOST;

static const char *end_of_line(const nck_decode_t *self) {
    return self->line.text + self->line.size;
}

static nck_status_t fail_at(nck_decode_t *self, const char *at, nck_status_t code) {
    return nck_decode_fail_at(self, code, at, 0, 0.0, 0.0);
}

// ---- assignments

// What the control itself does where its own parameters are set.
static nck_status_t set_own(nck_decode_t *self, const char *at, uint64_t number, double value) {
    const int fanuc = nck_is_fanuc(self);
    if (fanuc && number == ALARMS) {
        return nck_decode_fail_last(self, NCK_E_ALARM, nck_value_is(value) ? value : 0.0, 0.0);
    }
    if (nck_parameter_is_switch(self, (uint32_t)number)) {
        return nck_parameter_set_switch(self, (uint32_t)number, value);
    }
    if (!fanuc || number != STOPS) {
        // A work offset counts at once, so nothing but assignments may stand beside it.
        const nck_words_t *const words = &self->words;
        const int words_before = words->codes != 0 || (words->letters & ~NCK_LETTER('N')) != 0;
        nck_status_t status = NCK_E_WORD_SHARED;
        if (!words_before) status = nck_parameter_set_work(self, (uint32_t)number, value);
        if (status == NCK_OK) return NCK_OK;
        return nck_decode_fail_at(self, status, at, '#', (double)number,
                                  nck_parameter_limit(status));
    }
    self->words.steps |= NCK_STEP(NCK_STEP_STOP);
    self->words.codes |= NCK_STEP(NCK_STEP_STOP);
    self->words.code[NCK_STEP_STOP] = 0;
    return NCK_OK;
}

// What may follow the assignment of a work offset.
static nck_status_t check_behind(nck_decode_t *self, const char *at, uint64_t number) {
    const char *const next = nck_decode_skip(at);
    if (*next == '\n' || *next == '#' || *next == ';') return NCK_OK;
    return nck_decode_fail_at(self, NCK_E_WORD_SHARED, next, '#', (double)number, 0.0);
}

static nck_status_t read_target(nck_decode_t *self, const char **at, uint64_t *key_out) {
    double number = 0.0;
    const char *const name = nck_decode_skip(*at + 1);
    if (*name == '<') {
        const nck_status_t named = nck_decode_only(self, name, NCK_TONGUE_LINUXCNC);
        if (named != NCK_OK) return named;
        const char *const end = nck_decode_name_key(name, key_out);
        if (end == NULL) return fail_at(self, name, NCK_E_EXPRESSION);
        *at = end;
        return NCK_OK;
    }
    *at = name;
    const nck_status_t status = nck_decode_value(self, at, 0, &number);
    if (status != NCK_OK) return status;
    uint32_t index = 0;
    if (!nck_value_index(number, &index) || index == 0) {
        return nck_decode_fail_at(self, NCK_E_NUMBER_RANGE, name, '#',
                                  nck_value_is(number) ? number : 0.0, NCK_VARIABLE_LAST);
    }
    *key_out = index;
    return NCK_OK;
}

nck_status_t nck_decode_assign(nck_decode_t *self, const char **at) {
    const int fanuc = nck_is_fanuc(self);
    const char *const first = *at;
    uint64_t key = 0;
    double value = 0.0;
    if (!NCK_HAS_VARIABLES) return fail_at(self, first, NCK_E_UNSUPPORTED);
    self->text.words = 1;
    nck_status_t status = nck_decode_only(self, first, NCK_TONGUES_MACRO);
    if (status == NCK_OK) status = read_target(self, at, &key);
    if (status != NCK_OK) return status;
    *at = nck_decode_skip(*at);
    if (**at != '=') return fail_at(self, *at, NCK_E_EXPRESSION);
    ++*at;
    status = nck_decode_value(self, at, fanuc, &value);
    if (status != NCK_OK) return status;
    const int own = key <= NCK_VARIABLE_LAST && nck_parameter_is_own(self, (uint32_t)key);
    if (own && !nck_parameter_is_free(self, (uint32_t)key)) {
        status = set_own(self, first, key, value);
        const int alone = key != STOPS && !nck_parameter_is_switch(self, (uint32_t)key);
        return status == NCK_OK && alone ? check_behind(self, *at, key) : status;
    }
    return nck_variable_wait(self, key, value);
}

// ---- Fanuc's control words

static nck_status_t go_to(nck_decode_t *self, const char **at) {
    double number = 0.0;
    const char *const first = *at;
    const nck_status_t status = nck_decode_value(self, at, 0, &number);
    *at = end_of_line(self);
    if (status != NCK_OK) return status;
    if (!(number >= 1.0 && number <= label_most)) return fail_at(self, first, NCK_E_EXPRESSION);
    return nck_seek_number(self, (uint64_t)(number + 0.5));
}

// IF […] GOTO n, IF […] THEN …
static nck_status_t if_then(nck_decode_t *self, const char **at) {
    double value = 0.0;
    const nck_status_t status = nck_decode_value(self, at, 0, &value);
    if (status != NCK_OK) return status;
    const char *const next = nck_decode_skip(*at);
    const char *const then = nck_decode_spells(next, "THEN");
    const char *const jump = nck_decode_spells(next, "GOTO");
    if (then == NULL && jump == NULL) return fail_at(self, next, NCK_E_EXPRESSION);
    *at = then != NULL ? then : jump;
    if (nck_value_holds(value)) return then != NULL ? NCK_OK : go_to(self, at);
    *at = end_of_line(self);
    return NCK_OK;
}

// DO m: the loop begins, or goes on; if not, behind END m.
static nck_status_t do_loop(nck_decode_t *self, const char *at, int holds) {
    const nck_frame_t *const loop = nck_frame_loop(self);
    uint64_t key = 0;
    if (nck_decode_name_key(nck_decode_skip(at), &key) == NULL) {
        return fail_at(self, at, NCK_E_EXPRESSION);
    }
    const int again = loop != NULL && loop->key == key;
    if (!holds) {
        if (again) self->macro.depth--;
        nck_seek(self, NCK_SEEK_END, key);
        return NCK_OK;
    }
    return again ? NCK_OK : nck_frame_push(self, NCK_FRAME_WHILE, key, 0);
}

static nck_status_t while_loop(nck_decode_t *self, const char **at) {
    double value = 0.0;
    const nck_status_t status = nck_decode_value(self, at, 0, &value);
    const char *const next = nck_decode_skip(*at);
    const char *const end = nck_decode_spells(next, "DO");
    *at = end_of_line(self);
    if (status != NCK_OK) return status;
    if (end == NULL) return fail_at(self, next, NCK_E_EXPRESSION);
    return do_loop(self, end, nck_value_holds(value));
}

static nck_status_t end_loop(nck_decode_t *self, const char *at) {
    const nck_frame_t *const loop = nck_frame_loop(self);
    uint64_t key = 0;
    const char *const end = nck_decode_name_key(nck_decode_skip(at), &key);
    if (end == NULL || loop == NULL || loop->key != key) {
        return nck_decode_fail_last(self, NCK_E_FLOW, 0.0, 0.0);
    }
    return nck_jump(self, &loop->place);
}

// POPEN, PCLOS, DPRNT[…] and BPRNT[…] of Fanuc's move nothing.
static int puts_out(const nck_decode_t *self, const char *at) {
    const char letter = (char)(*at & ~0x20);
    const char *end = NULL;
    if ((letter != 'P' && letter != 'D' && letter != 'B') || !nck_is_letter(at[1])) return 0;
    return (self->tongue & NCK_TONGUES_FANUC) != 0
           && nck_decode_listed(at, "POPEN PCLOS DPRNT BPRNT ", &end) != 0;
}

nck_status_t nck_decode_control(nck_decode_t *self, const char **at) {
    enum { NONE, IF, GOTO, WHILE, DO };
    const char *end = NULL;
    if (puts_out(self, *at)) {
        *at = end_of_line(self);
        return NCK_OK;
    }
    const unsigned word = nck_decode_listed(*at, "IF GOTO WHILE DO END ", &end);
    if (word == NONE || nck_is_letter(*nck_decode_skip(end))) return NCK_EMPTY;
    if (!NCK_HAS_CALLS) return fail_at(self, *at, NCK_E_UNSUPPORTED);
    const nck_status_t speaks = nck_decode_only(self, *at, NCK_TONGUES_FANUC);
    if (speaks != NCK_OK) return speaks;
    self->text.words = 1;
    *at = nck_decode_skip(end);
    if (word == IF) return if_then(self, at);
    if (word == GOTO) return go_to(self, at);
    if (word == WHILE) return while_loop(self, at);
    const char *const behind = *at;
    *at = end_of_line(self);
    return word == DO ? do_loop(self, behind, 1) : end_loop(self, behind);
}
