// SPDX-License-Identifier: MIT
// Radius compensation in the text: which tool, on which side, and what cannot be done meanwhile.
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_block nck_decode_fail_code …
#include "nck/prep/1_decode/number/number.h" // nck_decode_fail_range nck_decode_whole nck_word_real
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL

// From the centre of the nose to the tool's point, in radii: orientations 0 … 9 along X and Z, as
// LinuxCNC's tool table numbers them, and as Fanuc's manuals do with their imaginary noses.
static const int8_t nose_x[2][10] = {{0, -1, -1, 1, 1, 0, -1, 0, 1, 0},
                                     {0, 1, 1, -1, -1, 0, 1, 0, -1, 0}};
static const int8_t nose_z[10] = {0, 1, -1, -1, 1, 1, 0, -1, 0, 0}; // of both

nck_status_t nck_decode_comp_refuses(nck_decode_t *self) {
    static const uint8_t after[] = {NCK_STEP_LAYOUT, NCK_STEP_LENGTH, NCK_STEP_WORK,
                                    NCK_STEP_OFFSET, NCK_STEP_MACHINE};
    const nck_words_t *const words = &self->words;
    const uint32_t codes = words->codes;
    const int plane = (codes & NCK_STEP(NCK_STEP_PLANE)) != 0
                      && words->code[NCK_STEP_PLANE] != 10 * self->modal.plane;
    if (plane) return nck_decode_fail_code(self, NCK_E_COMP_ON, NCK_STEP_PLANE);
    if (codes & NCK_STEP(NCK_STEP_CHANGE)) {
        return nck_decode_fail_code(self, NCK_E_COMP_ON, NCK_STEP_CHANGE);
    }
    const int ends = (codes & NCK_STEP(NCK_STEP_RADIUS_COMP)) != 0
                     && words->code[NCK_STEP_RADIUS_COMP] == 400;
    for (unsigned k = 0; !ends && k < sizeof after; k++) {
        const nck_step_t step = (nck_step_t)after[k];
        if (codes & NCK_STEP(step)) return nck_decode_fail_code(self, NCK_E_COMP_ON, step);
    }
    return NCK_OK;
}

// G41, G42: the tool in the spindle, or the one that D names, on Fanuc's mills until another one
// does; D0 and no tool have no radius.
static nck_status_t read_tool(nck_decode_t *self, double *radius_out, int64_t *nose_out) {
    const int32_t offset = self->modal.offset_in;
    int64_t number = offset >= 0 ? offset : (int64_t)self->modal.tool_in;
    // Fanuc's H in place of D, where G43 does not have it.
    const int fanuc = nck_is_fanuc(self);
    const int is_length = (self->words.codes & NCK_STEP(NCK_STEP_LENGTH)) != 0;
    const uint32_t said = self->words.letters & (NCK_LETTER('D') | NCK_LETTER('H'));
    const char letter = fanuc && !is_length && said == NCK_LETTER('H') ? 'H' : 'D';
    nck_tool_t tool = {0};
    const nck_status_t status = nck_decode_whole(self, letter, NCK_DECODE_VALUE_MAX, number,
                                                 &number);
    if (status != NCK_OK) return status;
    const int has_none = number != 0 && !nck_table_find(self, (uint32_t)number, &tool);
    if (has_none && self->machine->tool_count == 0) {
        nck_decode_note_word(self, NCK_NOTE_LENGTH, letter, nck_real_of(number));
    } else if (has_none) {
        return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, letter, nck_real_of(number), 0.0);
    }
    if (fanuc && nck_has_word(self, letter)) self->modal.offset_in = (int32_t)number;
    *radius_out = tool.radius_mm + tool.wear_mm;
    *nose_out = tool.orientation;
    return NCK_OK;
}

// G41.1, G42.1: D is the diameter, L the orientation.
static nck_status_t read_diameter(nck_decode_t *self, double *radius_out, int64_t *nose_out) {
    const double most = 2.0 * (double)NCK_LINEAR_MAX_MM;
    const double diameter = nck_word_real(self, 'D') * (self->modal.inch ? 25.4 : 1.0);
    if (!nck_has_word(self, 'D')) return nck_decode_fail_missing(self, NCK_STEP_RADIUS_COMP, 'D');
    if (!(diameter >= -most && diameter <= most)) return nck_decode_fail_range(self, 'D', most);
    *radius_out = 0.5 * diameter;
    return nck_decode_whole(self, 'L', 9, *nose_out, nose_out);
}

// The block that 2_toolcomp begins or ends at. radius: as NCK_BLOCK_COMP has it.
static nck_status_t give(nck_decode_t *self, double radius, int64_t nose, nck_block_t *out) {
    const double size = radius < 0.0 ? -radius : radius;
    const int fanuc = nck_is_fanuc(self);
    nck_decode_block(self, NCK_BLOCK_COMP, out);
    out->output.value = radius;
    out->output.number = self->machine->dialect.comp_start; // how it begins and ends
    if (out->output.number == NCK_COMP_START_OPEN) {
        out->output.number = fanuc ? NCK_COMP_START_A : NCK_COMP_START_RS274;
    }
    out->centre_mm[0] = size * nose_z[nose];
    out->centre_mm[1] = size * nose_x[fanuc][nose];
    return NCK_OK;
}

// G41, G42. left: the side, ±1.
static nck_status_t begin(nck_decode_t *self, double left, nck_block_t *out) {
    const uint8_t before = self->modal.comp;
    const int by_tool = self->words.code[NCK_STEP_RADIUS_COMP] % 10 == 0;
    double radius = 0.0;
    int64_t nose = 0;
    const nck_status_t status = by_tool ? read_tool(self, &radius, &nose)
                                        : read_diameter(self, &radius, &nose);
    if (status != NCK_OK) return status;
    if (nose % 9 != 0 && self->modal.plane != 18) {
        return nck_decode_fail_step(self, NCK_E_COMP_PLANE, NCK_STEP_RADIUS_COMP, 'G',
                                    nck_real_of(nose), 0.0);
    }
    self->modal.comp = radius != 0.0 ? NCK_COMPENSATES : NCK_COMPENSATES_NOTHING;
    if (radius == 0.0 && before != NCK_COMPENSATES) return NCK_EMPTY;
    (void)give(self, left * radius, nose, out);
    if (before == NCK_COMPENSATES) out->feed = self->modal.feed;
    return NCK_OK;
}

nck_status_t nck_decode_comp(nck_decode_t *self, nck_block_t *out) {
    const unsigned code = self->words.code[NCK_STEP_RADIUS_COMP];
    const uint8_t before = self->modal.comp;
    double unit[2] = {1.0, 1.0};
    const int left = (code < 420) != (nck_layout_way(self, unit) < 0.0);
    if (code == 400) {
        self->modal.comp = NCK_COMPENSATES_NOT;
        return before == NCK_COMPENSATES ? give(self, 0.0, 0, out) : NCK_EMPTY;
    }
    if (!NCK_HAS_COMP) return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_RADIUS_COMP);
    // Fanuc changes the side without G40 between; the way across has the feed in force, and G93's
    // is that of one move.
    const int fanuc = NCK_HAS_FOREIGN && nck_is_fanuc(self);
    const int refuses = self->modal.comp && (!fanuc || self->modal.feed_mode == NCK_FEED_INVERSE);
    if (refuses) return nck_decode_fail_code(self, NCK_E_COMP_ON, NCK_STEP_RADIUS_COMP);
    return begin(self, left ? 1.0 : -1.0, out);
}
