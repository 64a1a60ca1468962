// SPDX-License-Identifier: MIT
// O words: subprograms, conditions and loops of RS274NGC.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_at nck_decode_only nck_value_holds …

#include <stddef.h> // NULL

enum { ARGUMENTS = 30 };

static const double repeat_most = 1e9;
static const double label_most = NCK_LABEL_MOST;

static nck_status_t fail_at(nck_decode_t *self, const char *at, nck_status_t code) {
    return nck_decode_fail_at(self, code, at, 'O', 0.0, 0.0);
}

// A condition or a count in brackets.
static nck_status_t read_bracket(nck_decode_t *self, const char **at, double *value_out) {
    *at = nck_decode_skip(*at);
    if (**at != '[') return fail_at(self, *at, NCK_E_EXPRESSION);
    return nck_decode_value(self, at, 0, value_out);
}

// The name: a number, a name in < >, or a value.
static nck_status_t read_name(nck_decode_t *self, const char **at, uint64_t *key_out) {
    double value = 0.0;
    const char *const end = nck_decode_name_key(*at, key_out);
    if (end != NULL) {
        *at = end;
        return NCK_OK;
    }
    const char *const first = *at;
    const nck_status_t status = nck_decode_value(self, at, 0, &value);
    if (status != NCK_OK) return status;
    if (!(value >= 0.0 && value <= label_most)) return fail_at(self, first, NCK_E_EXPRESSION);
    *key_out = (uint64_t)(value + 0.5);
    return NCK_OK;
}

// ---- subprograms

static nck_status_t call(nck_decode_t *self, const char **at, uint64_t key) {
    nck_status_t status = NCK_OK;
    uint64_t count = 0;
    for (*at = nck_decode_skip(*at); **at == '[' && count < ARGUMENTS; *at = nck_decode_skip(*at)) {
        double value = 0.0;
        status = nck_decode_value(self, at, 0, &value);
        if (status == NCK_OK) status = nck_variable_wait(self, ++count, value);
        if (status != NCK_OK) return status;
    }
    status = nck_call(self, NCK_FRAME_SUB, key, 1);
    return nck_variable_commit(self, status);
}

// endsub, return: with a value or without. Whatever name return has, it leaves the subprogram.
static nck_status_t give_back(nck_decode_t *self, const char **at, uint64_t key, int returns) {
    const nck_frame_t *const frame = nck_frame_call(self);
    double value = 0.0;
    *at = nck_decode_skip(*at);
    const int has = **at == '[';
    if (has) {
        const nck_status_t status = nck_decode_value(self, at, 0, &value);
        if (status != NCK_OK) return status;
    }
    const int fits = frame != NULL && frame->kind == NCK_FRAME_SUB;
    if (!fits || (!returns && frame->key != key)) {
        return nck_decode_fail_last(self, NCK_E_FLOW, 0.0, 0.0);
    }
    self->macro.returned = value;
    self->macro.has_returned = (uint32_t)has;
    return nck_call_return(self);
}

// ---- conditions

static nck_status_t condition(nck_decode_t *self, const char **at, uint64_t key) {
    double value = 0.0;
    const nck_status_t status = read_bracket(self, at, &value);
    if (status == NCK_OK && !nck_value_holds(value)) nck_seek(self, NCK_SEEK_ELSE, key);
    return status;
}

// ---- loops

static int is_loop(const nck_frame_t *loop, uint64_t key, nck_frame_kind_t kind) {
    return loop != NULL && loop->key == key && loop->kind == (uint32_t)kind;
}

// while: the head of a loop, or the end of a do.
static nck_status_t while_loop(nck_decode_t *self, const char **at, uint64_t key) {
    const nck_frame_t *const loop = nck_frame_loop(self);
    const int tail = is_loop(loop, key, NCK_FRAME_DO);
    const int again = is_loop(loop, key, NCK_FRAME_WHILE);
    double value = 0.0;
    const nck_status_t status = read_bracket(self, at, &value);
    if (status != NCK_OK) return status;
    if (nck_value_holds(value)) {
        if (tail) return nck_jump(self, &loop->place);
        return again ? NCK_OK : nck_frame_push(self, NCK_FRAME_WHILE, key, 0);
    }
    if (tail || again) self->macro.depth--;
    if (!tail) nck_seek(self, NCK_SEEK_LOOP_END, key);
    return NCK_OK;
}

static nck_status_t end_loop(nck_decode_t *self, uint64_t key, nck_frame_kind_t kind) {
    nck_frame_t *const loop = nck_frame_loop(self);
    if (!is_loop(loop, key, kind)) return nck_decode_fail_last(self, NCK_E_FLOW, 0.0, 0.0);
    if (kind == NCK_FRAME_REPEAT) {
        loop->count--;
        if (loop->count == 0) {
            self->macro.depth--;
            return NCK_OK;
        }
    }
    return nck_jump(self, &loop->place);
}

// break leaves the loop of that name, continue goes to its end; loops inside of it are left.
static nck_status_t leave(nck_decode_t *self, uint64_t key, int goes_on) {
    const nck_frame_t *loop = nck_frame_loop(self);
    while (loop != NULL && loop->key != key) {
        self->macro.depth--;
        loop = nck_frame_loop(self);
    }
    if (loop == NULL) return nck_decode_fail_last(self, NCK_E_FLOW, 0.0, 0.0);
    if (!goes_on) self->macro.depth--;
    nck_seek(self, goes_on ? NCK_SEEK_LOOP_TAIL : NCK_SEEK_LOOP_END, key);
    return NCK_OK;
}

// ---- all of them

static nck_status_t do_loop_word(nck_decode_t *self, const char **at, unsigned word, uint64_t key) {
    switch (word) {
    case NCK_O_WHILE: return while_loop(self, at, key);
    case NCK_O_ENDWHILE: return end_loop(self, key, NCK_FRAME_WHILE);
    case NCK_O_DO: return nck_frame_push(self, NCK_FRAME_DO, key, 0);
    case NCK_O_REPEAT: {
        double value = 0.0;
        const nck_status_t status = read_bracket(self, at, &value);
        if (status != NCK_OK) return status;
        if (!(value <= repeat_most)) return fail_at(self, *at, NCK_E_NUMBER_RANGE);
        if (value >= 0.5) {
            return nck_frame_push(self, NCK_FRAME_REPEAT, key, (uint32_t)(value + 0.5));
        }
        nck_seek(self, NCK_SEEK_LOOP_END, key);
        return NCK_OK;
    }
    case NCK_O_ENDREPEAT: return end_loop(self, key, NCK_FRAME_REPEAT);
    default: return leave(self, key, word == NCK_O_CONTINUE);
    }
}

static nck_status_t do_word(nck_decode_t *self, const char **at, unsigned word, uint64_t key) {
    switch (word) {
    case NCK_O_SUB:
        nck_seek(self, NCK_SEEK_ENDSUB, key);
        return NCK_OK;
    case NCK_O_CALL: return call(self, at, key);
    case NCK_O_ENDSUB:
    case NCK_O_RETURN: return give_back(self, at, key, word == NCK_O_RETURN);
    case NCK_O_IF: return condition(self, at, key);
    case NCK_O_ELSEIF: {
        // Met on the way, it ends the branch before it; looked for, its condition counts.
        const int decides = self->macro.seek.decides != 0;
        self->macro.seek.decides = 0;
        if (decides) return condition(self, at, key);
        nck_seek(self, NCK_SEEK_ENDIF, key);
        *at = self->line.text + self->line.size;
        return NCK_OK;
    }
    case NCK_O_ELSE:
        nck_seek(self, NCK_SEEK_ENDIF, key);
        return NCK_OK;
    case NCK_O_ENDIF: return NCK_OK;
    default: return do_loop_word(self, at, word, key);
    }
}

// Where there are no calls: the name of a program.
static nck_status_t name_only(nck_decode_t *self, const char **at, const char *first) {
    uint64_t key = 0;
    *at = nck_decode_name_key(*at, &key);
    if (*at != NULL) *at = nck_decode_skip(*at);
    const int lone = *at != NULL && (**at == '\n' || **at == ';' || **at == '(');
    return lone ? NCK_OK : fail_at(self, first, NCK_E_UNSUPPORTED);
}

nck_status_t nck_decode_o_word(nck_decode_t *self, const char **at) {
    const char *const first = *at;
    const char *behind = NULL;
    uint64_t key = 0;
    *at = nck_decode_skip(first + 1);
    if (!NCK_HAS_CALLS) return name_only(self, at, first);
    nck_status_t status = read_name(self, at, &key);
    if (status != NCK_OK) return status;
    const unsigned word = nck_decode_word(nck_decode_skip(*at), &behind);
    if (word == NCK_O_OTHER) return fail_at(self, first, NCK_E_UNSUPPORTED);
    *at = behind;
    if (word == NCK_O_NAME) return NCK_OK;
    status = nck_decode_only(self, first, NCK_TONGUE_LINUXCNC);
    if (status != NCK_OK) return status;
    self->text.words = 1;
    status = do_word(self, at, word, key);
    if (status != NCK_OK) return status;
    *at = nck_decode_skip(*at);
    return **at == '\n' || **at == ';' ? NCK_OK : fail_at(self, *at, NCK_E_EXPRESSION);
}
