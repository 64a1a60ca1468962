// SPDX-License-Identifier: MIT
// Outputs and inputs of RS274NGC: M62 … M68. They are handed over in their place in the program.
#include "nck/prep/1_decode/modal/modal.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_step nck_decode_fail_word …
#include "nck/prep/1_decode/number/number.h" // nck_decode_whole
#include "nck/base/real.h" // nck_real_of

enum {
    PORT_MOST = 63, ANALOGUE_MOST = 15, WAIT_KINDS = 4, PER_KIND = 100, PER_ANALOGUE = 1000
};

static const double value_most = NCK_DECODE_VALUE_MAX;

static nck_status_t fail_missing(nck_decode_t *self, char letter) {
    return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_PORT, letter,
                                self->words.code[NCK_STEP_PORT] / 10.0, 0.0);
}

static nck_status_t read_port(nck_decode_t *self, char letter, uint32_t *port_out) {
    int64_t port = 0;
    if (!nck_has_word(self, letter)) return fail_missing(self, letter);
    const int64_t most = letter == 'P' ? PORT_MOST : ANALOGUE_MOST;
    const nck_status_t status = nck_decode_whole(self, letter, most, 0, &port);
    *port_out = (uint32_t)port;
    return status;
}

static nck_status_t read_real(nck_decode_t *self, char letter, double least, double *value_out) {
    *value_out = nck_has_word(self, letter) ? nck_word_real(self, letter) : 0.0;
    if (*value_out >= least && *value_out <= value_most) return NCK_OK;
    return nck_decode_fail_range(self, letter, value_most);
}

static nck_status_t give(nck_decode_t *self, nck_output_kind_t kind, uint32_t number, double value,
                         nck_block_t *out) {
    (void)nck_decode_give_output(self, NCK_BLOCK_OUTPUT, kind, value, out);
    out->output.number = number;
    return NCK_OK;
}

// A wait has an end, and is for a digital input.
static nck_status_t check_wait(nck_decode_t *self, char letter, int64_t kind, double most_s) {
    if (!(most_s > 0.0)) return fail_missing(self, 'Q');
    if (letter == 'P') return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'L', nck_real_of(kind), 0.0);
}

// M66: the program waits there for an input, L0: it does not.
static nck_status_t read_input(nck_decode_t *self, nck_block_t *out) {
    const char letter = nck_has_word(self, 'E') ? 'E' : 'P';
    uint32_t port = 0;
    int64_t kind = 0;
    double most_s = 0.0;
    if (nck_has_word(self, 'E') && nck_has_word(self, 'P')) {
        return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'E', 0.0, 0.0);
    }
    nck_status_t status = read_port(self, letter, &port);
    if (status == NCK_OK) status = nck_decode_whole(self, 'L', WAIT_KINDS, 0, &kind);
    if (status == NCK_OK) status = read_real(self, 'Q', 0.0, &most_s);
    if (status == NCK_OK && kind > 0) status = check_wait(self, letter, kind, most_s);
    if (status != NCK_OK) return status;
    port += (uint32_t)kind * PER_KIND + (letter == 'E' ? PER_ANALOGUE : 0);
    status = give(self, NCK_OUTPUT_INPUT, port, most_s, out);
    if (kind > 0) out->kind = NCK_BLOCK_WAIT;
    return status;
}

static nck_status_t set_output(nck_decode_t *self, nck_block_t *out) {
    const uint16_t code = self->words.code[NCK_STEP_PORT];
    uint32_t port = 0;
    double value = 0.0;
    const int analogue = code >= 670;
    nck_status_t status = read_port(self, analogue ? 'E' : 'P', &port);
    if (status == NCK_OK && analogue && !nck_has_word(self, 'Q')) status = fail_missing(self, 'Q');
    if (status == NCK_OK && analogue) status = read_real(self, 'Q', -value_most, &value);
    if (status != NCK_OK) return status;
    if (analogue) return give(self, NCK_OUTPUT_ANALOGUE, port, value, out);
    return give(self, NCK_OUTPUT_DIGITAL, port, code == 620 || code == 640 ? 1.0 : 0.0, out);
}

nck_status_t nck_decode_port(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_FOREIGN) return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_PORT);
    return self->words.code[NCK_STEP_PORT] == 660 ? read_input(self, out) : set_output(self, out);
}
