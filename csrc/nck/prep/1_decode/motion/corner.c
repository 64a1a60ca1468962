// SPDX-License-Identifier: MIT
// ,R and ,C: a move is held until the next one is known; then it ends earlier, the corner's piece
// follows, and the next move begins later. A line of which ,A alone is said ends where it meets the
// next one. The next line's motion is decoded before its outputs, so
// that these stand between the corner and the move of their own line.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/motion/fillet.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_block nck_decode_fail nck_decode_leave
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_counts_of …
#include "nck/prep/1_decode/place/place.h" // nck_layout_way
#include "nck/base/arc_math.h" // nck_arc_norm nck_plane_axis
#include "nck/base/real.h" // nck_fabs nck_mm_of nck_nm_of nck_sincos

#include <string.h> // memcpy

enum { MOST = 1000000 }; // [mm]

static const double size_most = MOST;
static const double size_least = 0.001; // [mm]

// Steps that hand something over, and those that may stand beside the second move.
#define LATER                                                                                     \
    (NCK_STEP(NCK_STEP_SPEED) | NCK_STEP(NCK_STEP_SPINDLE) | NCK_STEP(NCK_STEP_MIST)               \
     | NCK_STEP(NCK_STEP_FLOOD) | NCK_STEP(NCK_STEP_OVERRIDE) | NCK_STEP(NCK_STEP_OWN))
#define PASSES                                                                                    \
    (LATER | NCK_STEP(NCK_STEP_FEED_MODE) | NCK_STEP(NCK_STEP_FEED)                               \
     | NCK_STEP(NCK_STEP_DISTANCE) | NCK_STEP(NCK_STEP_CENTRE) | NCK_STEP(NCK_STEP_EXACT)         \
     | NCK_STEP(NCK_STEP_MOTION) | NCK_STEP(NCK_STEP_CALL) | NCK_STEP(NCK_STEP_STOP))

static int is_move(const nck_block_t *block) {
    return block->kind == NCK_BLOCK_LINE || block->kind == NCK_BLOCK_ARC;
}

// G1 G2 G3 move, and no cycle does.
static int is_plain(const nck_decode_t *self, const nck_block_t *block) {
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    return code >= 10 && code <= 30 && is_move(block);
}

// ---- words

void nck_corner_keep(nck_decode_t *self, char letter, unsigned column,
                     const nck_number_t *number, int is_old) {
    nck_corner_word_t *const word = &self->held.corner.word;
    word->number = *number;
    word->column = (uint16_t)column;
    word->letter = letter;
    word->is_old = (uint8_t)is_old;
    word->is_open = 0;
    self->held.contour.mode |= NCK_CONTOUR_CORNER;
    self->text.words = 1; // the line is no empty one
    if (self->held.corner.phase != NCK_CORNER_NOT) return;
    memcpy(self->held.corner.from_nm, self->place.position_nm, sizeof self->place.position_nm);
}

void nck_corner_open(nck_decode_t *self, unsigned column, double angle) {
    const nck_number_t none = {0};
    nck_corner_t *const corner = &self->held.corner;
    if (corner->word.letter == 0) nck_corner_keep(self, 'A', column, &none, 0);
    corner->word.is_open = 1;
    corner->slant[0] = angle;
}

int nck_corner_is_open(const nck_decode_t *self) {
    const nck_corner_t *const corner = &self->held.corner;
    return NCK_HAS_CYCLES && corner->phase == NCK_CORNER_WAITS && corner->is_open != 0;
}

int nck_corner_excuses(nck_decode_t *self) {
    const int excuses = self->held.corner.is_missed;
    self->held.corner.is_missed = 0;
    return excuses;
}

void nck_corner_close(nck_decode_t *self, double angle) {
    self->held.corner.slant[1] = angle;
    self->held.corner.is_open = 2;
}

int nck_corner_speaks(const nck_decode_t *self) {
    return NCK_HAS_CYCLES && nck_is_fanuc(self);
}

uint32_t nck_corner_letters(nck_decode_t *self, uint32_t letters) {
    const nck_words_t *const words = &self->words;
    const uint32_t old = NCK_LETTERS_CENTRE | NCK_LETTER('R') | NCK_LETTER('C');
    const uint32_t said = letters & old & ~NCK_LETTER('J');
    const int cuts = (words->steps & NCK_STEP(NCK_STEP_MOTION))
                     && words->code[NCK_STEP_MOTION] == 10;
    if (!NCK_HAS_CYCLES || !self->lathe || !cuts) return 0;
    if (said == 0 || (said & (said - 1)) != 0 || self->held.corner.word.letter != 0) return 0;
    char letter = 'C';
    while (!(said & NCK_LETTER(letter))) letter++;
    const unsigned k = (unsigned)(letter - 'A');
    nck_corner_keep(self, letter, words->column[k], &words->number[k], 1);
    return said;
}

// ---- the moves

static nck_status_t fail(nck_decode_t *self, double value) {
    const nck_corner_t *const corner = &self->held.corner;
    self->line.tag = corner->line;
    return nck_decode_fail(self, NCK_E_CORNER, corner->column, corner->letter, value, 0.0);
}

static void choose_plane(const nck_block_t *block, unsigned *axes) {
    for (unsigned k = 0; k < 2; k++) axes[k] = nck_plane_axis(block->plane, k);
}

// Where a block ends as a machine position.
static void end_of(const nck_block_t *block, int64_t *out_nm) {
    memcpy(out_nm, block->target_nm, sizeof block->target_nm);
    for (unsigned axis = 0; axis < 3; axis++) out_nm[axis] += block->tool_nm[axis];
}

// Do both places differ in the plane alone?
static int is_flat(const unsigned *axes, const int64_t *from_nm, const int64_t *to_nm) {
    int flat = 1;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int in = axis == axes[0] || axis == axes[1];
        flat = flat && (in || from_nm[axis] == to_nm[axis]);
    }
    return flat;
}

// A block as an edge at the corner. Returns 0 if it makes none: too short, turns more than once, or
// leaves the plane.
static int make_edge(const nck_block_t *block, const int64_t *from_nm, const int64_t *corner_nm,
                     nck_edge_t *out) {
    unsigned axes[2];
    int64_t to_nm[NCK_AXIS_MAX];
    double way[2];
    choose_plane(block, axes);
    end_of(block, to_nm);
    if (!is_flat(axes, from_nm, to_nm)) return 0;
    for (unsigned k = 0; k < 2; k++) {
        const int64_t tool_nm = block->tool_nm[axes[k]];
        way[k] = nck_mm_of(to_nm[axes[k]] - from_nm[axes[k]]);
        out->centre[k] = block->centre_mm[k] - nck_mm_of(corner_nm[axes[k]] - tool_nm);
    }
    if (block->kind == NCK_BLOCK_ARC) {
        const double sense = block->sweep_rad > 0.0 ? 1.0 : -1.0;
        way[0] = sense * out->centre[1];
        way[1] = -sense * out->centre[0];
        out->turn = sense;
        out->length = nck_fabs(block->sweep_rad);
        out->radius = nck_arc_norm(way[0], way[1]);
    } else {
        out->turn = 0.0;
        out->radius = 0.0;
        out->length = nck_arc_norm(way[0], way[1]);
    }
    const double size = nck_arc_norm(way[0], way[1]);
    if (!(size > 0.0)) return 0;
    out->way[0] = way[0] / size;
    out->way[1] = way[1] / size;
    return block->kind != NCK_BLOCK_ARC || out->length < 2.0 * NCK_PI;
}

// ,R5 wants no sign; the words of lathes say by theirs which way the next move goes: both moves
// then go along an axis each. I: the second one along X, K: along Z.
static int is_sign_good(const nck_corner_t *corner, const nck_edge_t *edges) {
    if (!corner->is_old) return corner->size > 0.0;
    const double *const way = edges[1].way;
    const int along = nck_fabs(way[0]) <= nck_fabs(way[1]); // G18: 0 Z, 1 X
    const int lines = !(edges[0].radius > 0.0) && !(edges[1].radius > 0.0);
    const int square = !(nck_fabs(way[1 - along]) > 0.0) && !(nck_fabs(edges[0].way[along]) > 0.0);
    const int axis = (corner->letter != 'I' || along) && (corner->letter != 'K' || !along);
    return lines && square && axis && corner->size * way[along] > 0.0;
}

// An arc from one place to another: its own circle passes through both.
static void bend(nck_block_t *block, const int64_t *from_nm) {
    unsigned axes[2];
    double d[2], c[2];
    choose_plane(block, axes);
    for (unsigned k = 0; k < 2; k++) {
        const double start = nck_mm_of(from_nm[axes[k]] - block->tool_nm[axes[k]]);
        d[k] = nck_mm_of(block->target_nm[axes[k]]) - start;
        c[k] = block->centre_mm[k] - start;
    }
    if (!(nck_arc_norm(d[0], d[1]) > 0.0)) {
        block->kind = NCK_BLOCK_LINE; // nothing of it is left
        return;
    }
    const double turn = block->sweep_rad > 0.0 ? 1.0 : -1.0;
    const double height = nck_arc_height(d[0], d[1], c[0], c[1]);
    block->sweep_rad = nck_arc_sweep(nck_arc_norm(d[0], d[1]), height, turn);
    nck_arc_centre(d[0], d[1], height, c);
    for (unsigned k = 0; k < 2; k++) {
        block->centre_mm[k] = c[k] + nck_mm_of(from_nm[axes[k]] - block->tool_nm[axes[k]]);
    }
}

// The corner's own piece becomes `held`, whose centre is the fillet's.
static void make_piece(nck_corner_t *corner, const nck_cut_t *cut, const int64_t *corner_nm,
                       const int64_t *from_nm, const int64_t *to_nm) {
    nck_block_t *const piece = &corner->held;
    unsigned axes[2];
    const int rounds = corner->letter == 'R';
    choose_plane(piece, axes);
    piece->kind = (uint8_t)(rounds ? NCK_BLOCK_ARC : NCK_BLOCK_LINE);
    piece->sweep_rad = rounds ? cut->turn : 0.0;
    for (unsigned k = 0; k < 2; k++) {
        const double apex_mm = nck_mm_of(corner_nm[axes[k]] - piece->tool_nm[axes[k]]);
        piece->centre_mm[k] = rounds ? apex_mm + cut->centre[k] : 0.0;
        piece->target_nm[axes[k]] = to_nm[axes[k]] - piece->tool_nm[axes[k]];
    }
    if (rounds) bend(piece, from_nm);
}

// An open move ends where both lines meet; 0: they do not, or lie within a degree of each other,
// or meet too far off.
static int meet(nck_corner_t *corner) {
    static const double least = 0.01745; // sine of the angle between them
    static const double most = NCK_LINEAR_MAX_MM;
    nck_block_t *const held = &corner->held;
    int64_t end_nm[NCK_AXIS_MAX];
    double a[2], b[2], way[2];
    unsigned axes[2];
    choose_plane(held, axes);
    end_of(&corner->next, end_nm);
    nck_sincos(corner->slant[0], &a[1], &a[0]);
    nck_sincos(corner->slant[1], &b[1], &b[0]);
    for (unsigned k = 0; k < 2; k++) way[k] = nck_mm_of(end_nm[axes[k]] - corner->from_nm[axes[k]]);
    const double cross = a[0] * b[1] - a[1] * b[0];
    if (!(nck_fabs(cross) >= least)) return 0;
    const double along = (way[0] * b[1] - way[1] * b[0]) / cross;
    if (!(nck_fabs(along) <= most)) return 0;
    for (unsigned k = 0; k < 2; k++) {
        held->target_nm[axes[k]] += nck_nm_of(along * a[k]);
    }
    return corner->next.kind == NCK_BLOCK_LINE && corner->next.plane == held->plane;
}

// Where both moves meet, and how they do.
static nck_status_t find_edges(nck_decode_t *self, int64_t *corner_nm, nck_edge_t *edges) {
    nck_corner_t *const corner = &self->held.corner;
    const int misses = corner->is_open == 1 || (corner->is_open && !meet(corner));
    if (misses) return fail(self, corner->size);
    end_of(&corner->held, corner_nm);
    for (unsigned axis = 0; axis < 3 && corner->is_open; axis++) {
        const nck_status_t status = nck_decode_travel(self, axis, corner_nm[axis]);
        if (status != NCK_OK) return status;
    }
    const int before = make_edge(&corner->held, corner->from_nm, corner_nm, &edges[0]);
    const int behind = make_edge(&corner->next, corner_nm, corner_nm, &edges[1]);
    return before && behind ? NCK_OK : fail(self, corner->size);
}

static int cut_off(const nck_corner_t *corner, const nck_edge_t *edges, nck_cut_t *cut_out) {
    const double size = nck_fabs(corner->size);
    if (!is_sign_good(corner, edges)) return 0;
    return corner->letter == 'R' ? nck_fillet(edges, size, cut_out)
                                 : nck_chamfer(edges, size, cut_out);
}

// Both moves are known: the first one goes out, shorter.
static nck_status_t join(nck_decode_t *self, nck_block_t *out) {
    nck_corner_t *const corner = &self->held.corner;
    nck_block_t *const held = &corner->held;
    int64_t corner_nm[NCK_AXIS_MAX], place_nm[2][NCK_AXIS_MAX];
    nck_edge_t edges[2];
    nck_cut_t cut;
    unsigned axes[2];
    const nck_status_t status = find_edges(self, corner_nm, edges);
    if (status != NCK_OK) return status;
    // The first move goes out; there is nothing between both.
    if (corner->letter == 'A') {
        *out = corner->held;
        memcpy(corner->end_nm, self->place.position_nm, sizeof corner->end_nm);
        memcpy(corner->from_nm, corner_nm, sizeof corner->from_nm);
        memcpy(self->place.position_nm, corner_nm, sizeof corner->from_nm);
        corner->phase = NCK_CORNER_ENDS;
        self->words.steps |= corner->later & LATER;
        return NCK_OK;
    }
    if (!cut_off(corner, edges, &cut)) return fail(self, corner->size);
    choose_plane(held, axes);
    for (unsigned k = 0; k < 2; k++) {
        memcpy(place_nm[k], corner_nm, sizeof corner_nm);
        for (unsigned axis = 0; axis < 2; axis++) {
            place_nm[k][axes[axis]] += nck_nm_of(cut.touch[k][axis]);
        }
    }
    for (unsigned k = 0; k < 2; k++) {
        held->target_nm[axes[k]] = place_nm[0][axes[k]] - held->tool_nm[axes[k]];
    }
    if (held->kind == NCK_BLOCK_ARC) bend(held, corner->from_nm);
    *out = *held;
    make_piece(corner, &cut, corner_nm, place_nm[0], place_nm[1]);
    memcpy(corner->end_nm, self->place.position_nm, sizeof corner->end_nm);
    memcpy(corner->from_nm, place_nm[1], sizeof corner->from_nm);
    memcpy(self->place.position_nm, place_nm[1], sizeof corner->from_nm);
    if (corner->next.kind == NCK_BLOCK_ARC) bend(&corner->next, corner->from_nm);
    corner->phase = NCK_CORNER_JOINS;
    return NCK_OK;
}

// ---- the lines

static void forget(nck_decode_t *self, int is_error) {
    if (is_error && self->held.corner.is_open) self->held.corner.is_missed = 1;
    self->held.corner.is_open = 0;
    self->held.corner.phase = NCK_CORNER_NOT;
    self->held.corner.word.letter = 0;
    self->held.contour.mode &= ~(uint32_t)NCK_CONTOUR_CORNER;
}

// The corner in work is that of the line's word.
static void name_word(nck_decode_t *self) {
    nck_corner_t *const corner = &self->held.corner;
    corner->line = self->line.tag;
    corner->column = corner->word.column;
    corner->letter = corner->word.letter;
    corner->is_old = corner->word.is_old;
    corner->is_open = corner->word.is_open;
    corner->size = nck_number_real(&corner->word.number);
}

nck_status_t nck_corner_words(nck_decode_t *self) {
    nck_corner_t *const corner = &self->held.corner;
    nck_words_t *const words = &self->words;
    if (!NCK_HAS_CYCLES || corner->phase != NCK_CORNER_WAITS) return NCK_OK;
    const int strange = (words->steps & ~PASSES) != 0;
    const int moves = (words->steps & NCK_STEP(NCK_STEP_MOTION)) != 0
                      && words->code[NCK_STEP_MOTION] >= 10 && words->code[NCK_STEP_MOTION] <= 30;
    const int gives = (words->steps & (LATER | NCK_STEP(NCK_STEP_STOP))) != 0;
    if (strange || (gives && !moves)) return fail(self, corner->size);
    corner->later = words->steps & LATER;
    words->steps &= ~LATER;
    return NCK_OK;
}

// The size that the word says.
static nck_status_t measure(nck_decode_t *self) {
    nck_corner_t *const corner = &self->held.corner;
    int64_t size_nm = 0;
    const int whole = nck_decode_fixed(self, &corner->word.number, &self->place.scale[0], &size_nm);
    if (!whole || !nck_within(nck_fabs(nck_mm_of(size_nm)), size_least, size_most)) {
        return nck_decode_fail(self, NCK_E_NUMBER_RANGE, corner->column, corner->letter,
                               corner->size,
                               nck_decode_as_word(&self->place.scale[0], size_most * 1e6)
                                   * nck_decode_counts_of(self, &corner->word.number));
    }
    corner->size = nck_mm_of(size_nm);
    return NCK_OK;
}

// A block of a line that has a word.
static nck_status_t take_own(nck_decode_t *self, nck_block_t *out) {
    nck_corner_t *const corner = &self->held.corner;
    const int goes_on = (self->words.steps & NCK_STEP(NCK_STEP_REST)) != 0;
    if (!is_move(out) && out->kind != NCK_BLOCK_RAPID) return NCK_OK;
    // A move of a line with a word: the last one of its line is held.
    if (!goes_on || self->words.code[NCK_STEP_MOTION] > 30) {
        double unit[2] = {1.0, 0.0};
        name_word(self);
        const int plain = is_plain(self, out) && self->macro.modal == 0
                          && out->feed_mode != NCK_FEED_INVERSE;
        if (!plain) return fail(self, corner->size);
        const double scale = self->layout.on != 0 ? nck_fabs(nck_layout_way(self, unit)) : 1.0;
        if (nck_fabs(scale - 1.0) > 1e-9) {
            return nck_decode_fail(self, NCK_E_LAYOUT_ON, corner->column, corner->letter,
                                   corner->size, 0.0);
        }
        const nck_status_t status = corner->letter == 'A' ? NCK_OK : measure(self);
        if (status != NCK_OK) return status;
        corner->held = *out;
        corner->word.letter = 0;
        corner->phase = NCK_CORNER_WAITS;
        return NCK_EMPTY;
    }
    end_of(out, corner->from_nm); // the first part of an arc
    return NCK_OK;
}

static nck_status_t take_block(nck_decode_t *self, nck_block_t *out) {
    nck_corner_t *const corner = &self->held.corner;
    // The move behind a corner is decoded: the words of its line tell what comes then.
    if (corner->phase == NCK_CORNER_WAITS) {
        const int second = (self->words.steps & NCK_STEP(NCK_STEP_REST)) != 0;
        corner->next = *out;
        const nck_status_t status = is_plain(self, out) ? join(self, out)
                                                        : fail(self, corner->size);
        if (status != NCK_OK) return status;
        corner->later |= second ? NCK_STEP(NCK_STEP_REST) : 0u;
        nck_decode_leave(self, NCK_REST_CORNER);
        return NCK_OK;
    }
    const int own = corner->phase == NCK_CORNER_NOT && corner->word.letter != 0;
    return own ? take_own(self, out) : NCK_OK;
}

nck_status_t nck_corner_take(nck_decode_t *self, nck_status_t status, nck_block_t *out) {
    nck_corner_t *const corner = &self->held.corner;
    nck_status_t now = status;
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    if (now == NCK_OK) now = take_block(self, out);
    const int says = corner->word.letter != 0;
    if (now == NCK_EMPTY && says && self->words.steps == 0) {
        // Nothing of a line with a word has moved.
        name_word(self);
        now = fail(self, self->held.corner.size);
    }
    // A cycle in place of the move behind a corner is not done: its first block is refused.
    if (status == NCK_OK && now < NCK_OK) {
        self->held.cycle.holes = 0;
        self->held.turn.left = 0;
        self->held.peck.phase = 0;
        self->held.screw.phase = 0;
        self->held.rough.phase = 0;
    }
    if (now < NCK_OK || (corner->phase == NCK_CORNER_NOT && !says)) forget(self, now < NCK_OK);
    return now;
}

nck_status_t nck_corner_next(nck_decode_t *self, nck_block_t *out) {
    nck_corner_t *const corner = &self->held.corner;
    nck_words_t *const words = &self->words;
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    if (corner->phase == NCK_CORNER_JOINS) {
        *out = corner->held;
        corner->phase = NCK_CORNER_ENDS;
        words->steps |= corner->later & LATER;
        nck_decode_leave(self, NCK_REST_CORNER);
        return NCK_OK;
    }
    memcpy(self->place.position_nm, corner->end_nm, sizeof corner->end_nm);
    nck_decode_block(self, (nck_block_kind_t)corner->next.kind, out);
    memcpy(out->target_nm, corner->next.target_nm, sizeof out->target_nm);
    memcpy(out->centre_mm, corner->next.centre_mm, sizeof out->centre_mm);
    out->sweep_rad = corner->next.sweep_rad;
    out->feed = corner->next.feed;
    out->path_mode = corner->next.path_mode;
    corner->phase = NCK_CORNER_NOT;
    if (corner->later & NCK_STEP(NCK_STEP_REST)) nck_decode_leave(self, NCK_REST_SECOND);
    return NCK_OK;
}

nck_status_t nck_corner_missing(nck_decode_t *self) {
    self->text.over = 1;
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    forget(self, 1);
    return fail(self, self->held.corner.size);
}
