// SPDX-License-Identifier: MIT
// Remarks that LinuxCNC does not pass over: one in another one, and the last one of a line if it
// says (abort, …), or something to the operator: that is a program, too.
#include "nck/prep/1_decode/line/line.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_at nck_decode_find
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_spells

#include <stddef.h> // NULL
#include <string.h> // memchr

// An O word stands first in its line, or behind N and its number: its remark is passed over.
static int is_o_word(const char *at) {
    if ((*at & ~0x20) == 'N') do at++; while (*at == ' ' || (*at >= '0' && *at <= '9'));
    return (*at & ~0x20) == 'O';
}

// What a remark begins with, NULL: not with this.
static const char *behind(const char *remark, const char *word) {
    do remark++; while (*remark == ' ' || *remark == '\t');
    return nck_decode_spells(remark, word);
}

// The last remark of a line, NULL: it has none. NCK_E_COMMENT.
static nck_status_t find_last(nck_decode_t *self, const char *first, const char **last_out) {
    const char *open = NULL;
    *last_out = NULL;
    for (const char *at = first; *at != '\n' && (open != NULL || *at != ';'); at++) {
        if (*at == '(' && open != NULL) {
            return nck_decode_fail_at(self, NCK_E_COMMENT, at, '(', 0.0, 0.0);
        }
        if (*at == '(') open = at;
        if (*at != ')' || open == NULL) continue;
        *last_out = open;
        open = NULL;
    }
    return NCK_OK;
}

nck_status_t nck_decode_remarks(nck_decode_t *self, const char *first) {
    const char *last;
    const size_t size = (size_t)(self->line.text + self->line.size - first);
    if (memchr(first, '(', size) == NULL) return NCK_OK; // nobody's plain lines pay for it
    const nck_status_t status = find_last(self, first, &last);
    if (status != NCK_OK) return status;
    if (last == NULL || is_o_word(first)) return NCK_OK;
    if (behind(last, "MSG,") || behind(last, "PRINT,") || behind(last, "DEBUG,")) {
        self->text.words = 1;
    }
    if (!behind(last, "ABORT,")) return NCK_OK;
    const unsigned column = (unsigned)(last - self->line.text) + 1;
    const nck_diagnostic_t told = {NCK_NOTE_ABORT, self->line.tag, column, '(', 0.0, 0.0};
    nck_decode_find(self, &told);
    self->text.words = 1;
    self->text.closed = NCK_CLOSED_BY_ABORT;
    return NCK_OK;
}
