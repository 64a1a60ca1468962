// SPDX-License-Identifier: MIT
// Parameters: where their values are kept, and which of them belong to the call in force.
#include "nck/prep/1_decode/state/state.h"

#include <stddef.h> // NULL offsetof
#include <string.h> // memset

enum {
    LOCALS = 30, FANUC_LOCALS = 33, // #1 … are a call's own
    LAST = NCK_VARIABLE_ROWS - 1
};

#define NAMED ((uint64_t)1 << 63)  // the key is of a name
#define SHARED ((uint64_t)1 << 62) // of one that begins with _
#define KEPT ((uint64_t)1 << 61)   // an argument of a call, kept for the next one
#define KEPT_ALL ((uint64_t)3 << 60)
#define TOOL ((uint64_t)1 << 59)   // of a tool
#define WORK ((uint64_t)1 << 40)   // beside it: of a work system; above the number of any tool

int nck_value_is(double value) { return value < 0.5 * NCK_NO_VALUE; }

int nck_value_holds(double value) { return nck_value_is(value) && (value > 0.0 || value < 0.0); }

int nck_value_index(double value, uint32_t *index_out) {
    if (!NCK_HAS_VARIABLES || !(value > -0.5 && value < (double)NCK_VARIABLE_LAST + 0.5)) return 0;
    const int32_t whole = (int32_t)(value + 0.5);
    const double rest = value - whole;
    *index_out = (uint32_t)whole;
    return rest <= NCK_VALUE_NEAR && rest >= -NCK_VALUE_NEAR;
}

// FNV-1a over the letters in lower case, without blanks.
uint64_t nck_variable_name(const char *at, const char *end) {
    if (!NCK_HAS_VARIABLES) return 0;
    uint64_t key = 14695981039346656037ULL;
    const int shared = *at == '_';
    for (; at < end; at++) {
        const char c = *at >= 'A' && *at <= 'Z' ? (char)(*at - 'A' + 'a') : *at;
        if (c == ' ' || c == '\t') continue;
        key = (key ^ (uint64_t)(unsigned char)c) * 1099511628211ULL;
    }
    return (key >> 4) | NAMED | (shared ? SHARED : 0);
}

static int is_local(const nck_decode_t *self, uint64_t key) {
    const int fanuc = nck_is_fanuc(self);
    if (key & (NAMED | KEPT_ALL)) return !(key & SHARED);
    return key <= (fanuc ? FANUC_LOCALS : LOCALS);
}

// The row of a parameter; NCK_VARIABLE_ROWS: it was never set.
static uint32_t row_of(const nck_decode_t *self, uint64_t key) {
    const nck_macro_t *const macro = &self->macro;
    if (is_local(self, key)) {
        for (uint32_t k = macro->base; k < macro->locals; k++) {
            if (macro->variable[LAST - k].key == key) return LAST - k;
        }
        return NCK_VARIABLE_ROWS;
    }
    for (uint32_t k = 0; k < macro->globals; k++) {
        if (macro->variable[k].key == key) return k;
    }
    return NCK_VARIABLE_ROWS;
}

const double *nck_variable_find(const nck_decode_t *self, uint64_t key) {
    if (!NCK_HAS_VARIABLES) return NULL;
    const uint32_t row = row_of(self, key);
    return row < NCK_VARIABLE_ROWS ? &self->macro.variable[row].value : NULL;
}

static int has_room(const nck_macro_t *macro) {
    return macro->globals + macro->waiting + macro->locals + 1 <= NCK_VARIABLES;
}

static nck_status_t fail_full(nck_decode_t *self) {
    return nck_decode_fail(self, NCK_E_VARIABLES, 0, '#', NCK_VARIABLES, NCK_VARIABLES);
}

nck_status_t nck_variable_add(nck_decode_t *self, uint64_t key, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    if (!has_room(macro)) return fail_full(self);
    macro->variable[LAST - macro->locals] = (nck_variable_t){key, value};
    macro->locals++;
    return NCK_OK;
}

uint64_t nck_variable_work(uint32_t number, unsigned axis) {
    return TOOL | WORK | (uint64_t)number << 4 | axis;
}

uint64_t nck_variable_tool(uint32_t number, unsigned field) {
    return TOOL | (uint64_t)number << 3 | field;
}

nck_status_t nck_variable_set(nck_decode_t *self, uint64_t key, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    const uint32_t row = row_of(self, key);
    if (row < NCK_VARIABLE_ROWS) {
        macro->variable[row].value = value;
        return NCK_OK;
    }
    if (is_local(self, key)) return nck_variable_add(self, key, value);
    if (!has_room(macro)) return fail_full(self);
    macro->variable[macro->globals++] = (nck_variable_t){key, value};
    return NCK_OK;
}

nck_status_t nck_variable_wait(nck_decode_t *self, uint64_t key, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    if (!has_room(macro)) return fail_full(self);
    macro->variable[macro->globals + macro->waiting] = (nck_variable_t){key, value};
    macro->waiting++;
    return NCK_OK;
}

// A value that becomes a new global parameter takes the row of one that has been set before it.
nck_status_t nck_variable_commit(nck_decode_t *self, nck_status_t line) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    nck_status_t status = line;
    const uint32_t first = macro->globals, count = macro->waiting;
    for (uint32_t k = 0; k < count && status == NCK_OK; k++) {
        const nck_variable_t row = macro->variable[first + k];
        macro->waiting = first + count - macro->globals - (macro->globals == first + k);
        status = nck_variable_set(self, row.key, row.value);
    }
    macro->waiting = 0;
    return status;
}

void nck_variable_restart(nck_decode_t *self) {
    nck_macro_t *const macro = &self->macro;
    uint32_t kept = 0;
    for (uint32_t k = 0; NCK_HAS_VARIABLES && k < macro->globals; k++) {
        const nck_variable_t row = macro->variable[k];
        if ((row.key & (NAMED | TOOL)) != TOOL) continue;
        macro->variable[kept] = row;
        kept++;
    }
    if (kept == 0) {
        memset(macro, 0, sizeof *macro);
        return;
    }
    char *const begin = (char *)macro;
    char *const behind = (char *)&macro->variable[kept];
    memset(begin, 0, offsetof(nck_macro_t, variable));
    memset(behind, 0, sizeof *macro - (size_t)(behind - begin));
    macro->globals = kept;
}

int nck_variable_invariants(const nck_decode_t *self) {
    const nck_macro_t *const macro = &self->macro;
    return macro->globals + macro->waiting + macro->locals <= NCK_VARIABLE_ROWS
           && macro->base <= macro->locals && macro->waiting == 0
           && macro->depth <= NCK_FRAME_ROWS;
}

uint64_t nck_variable_kept(uint64_t number, int modal) {
    return number | (modal ? KEPT : KEPT >> 1);
}

void nck_variable_drop_kept(nck_decode_t *self, int modal) {
    if (!NCK_HAS_VARIABLES) return;
    nck_macro_t *const macro = &self->macro;
    uint32_t to = macro->base;
    for (uint32_t k = macro->base; k < macro->locals; k++) {
        const nck_variable_t row = macro->variable[LAST - k];
        if (!(row.key & NAMED) && (row.key & nck_variable_kept(0, modal))) continue;
        macro->variable[LAST - to] = row;
        to++;
    }
    macro->locals = to;
}

nck_status_t nck_variable_copy_kept(nck_decode_t *self, uint32_t from, int modal) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const nck_macro_t *const macro = &self->macro;
    const uint64_t flag = nck_variable_kept(0, modal);
    const uint32_t end = macro->base;
    for (uint32_t k = from; k < end; k++) {
        const nck_variable_t row = macro->variable[LAST - k];
        if ((row.key & NAMED) || !(row.key & flag)) continue;
        const nck_status_t status = nck_variable_add(self, row.key & ~flag, row.value);
        if (status != NCK_OK) return status;
    }
    return NCK_OK;
}
