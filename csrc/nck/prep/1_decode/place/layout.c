// SPDX-License-Identifier: MIT
// G15 G16, G50 G51, G50.1 G51.1, G68 G69 of Fanuc's mills.
//
//     words ─polar─▶ place of the program ─mirror─▶ ─scale─▶ ─turn─▶ + origin = machine position
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_fail_code …
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_axis_word …
#include "nck/base/arc_math.h" // nck_plane_axis
#include "nck/base/real.h" // nck_floor nck_fabs nck_sqrt nck_rounded nck_real_of
#include "nck/base/trig_math.h" // nck_sincos nck_atan2 NCK_PI

#include <string.h> // memcmp memcpy memset

static const double factor_most = 1000.0; // of scaling, and the least is its inverse
static const double degrees_most = 1e6;

void nck_plane_axes(const nck_decode_t *self, unsigned *u, unsigned *v) {
    *u = nck_plane_axis(self->modal.plane, 0);
    *v = nck_plane_axis(self->modal.plane, 1);
}

static nck_status_t fail(nck_decode_t *self, nck_status_t code, int letter, double value) {
    return nck_decode_fail_step(self, code, NCK_STEP_LAYOUT, letter, value, 0.0);
}

// ---- places

static void turn(const nck_decode_t *self, double sine, double *place) {
    const nck_layout_t *const layout = &self->layout;
    unsigned u = NCK_AXIS_X, v = NCK_AXIS_Y;
    if (!(layout->on & NCK_LAYOUT_SYSTEM)) nck_plane_axes(self, &u, &v);
    const double a = place[u] - nck_real_of(layout->turn_nm[0]);
    const double b = place[v] - nck_real_of(layout->turn_nm[1]);
    place[u] = nck_real_of(layout->turn_nm[0]) + (layout->cosine * a - sine * b);
    place[v] = nck_real_of(layout->turn_nm[1]) + (sine * a + layout->cosine * b);
}

// Mirrored and scaled, as far as that is in force.
static double stretch(const nck_layout_t *layout, unsigned axis, double place) {
    double at = place;
    if (layout->mirrors >> axis & 1u) at = 2.0 * nck_real_of(layout->mirror_nm[axis]) - at;
    if (!(layout->on & NCK_LAYOUT_SCALE)) return at;
    const double centre = nck_real_of(layout->centre_nm[axis]);
    return centre + layout->scale[axis] * (at - centre);
}

static double unstretch(const nck_layout_t *layout, unsigned axis, double place) {
    double at = place;
    if (layout->on & NCK_LAYOUT_SCALE) {
        const double centre = nck_real_of(layout->centre_nm[axis]);
        at = centre + (at - centre) / layout->scale[axis];
    }
    return layout->mirrors >> axis & 1u ? 2.0 * nck_real_of(layout->mirror_nm[axis]) - at : at;
}

// What the program calls the place where the axes stand.
void nck_layout_where(const nck_decode_t *self, int64_t *at_nm) {
    const nck_layout_t *const layout = &self->layout;
    const int64_t *const position_nm = self->place.position_nm;
    double place[3];
    if (layout->on && memcmp(position_nm, layout->stands_nm, sizeof layout->stands_nm) == 0) {
        memcpy(at_nm, layout->at_nm, sizeof layout->at_nm);
        return;
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        place[axis] = nck_real_of(position_nm[axis] - self->place.origin_nm[axis]);
    }
    if (layout->on & NCK_LAYOUT_TURN) turn(self, -layout->sine, place);
    for (unsigned axis = 0; axis < 3; axis++) {
        at_nm[axis] = nck_rounded(unstretch(layout, axis, place[axis]));
    }
}

// Radius and angle: G90 from the program's zero, G91 from where the axes stand and from the angle
// said last.
static nck_status_t read_polar(nck_decode_t *self, int64_t *at_nm) {
    nck_layout_t *const layout = &self->layout;
    const int steps = self->modal.incremental;
    int64_t radius_nm = 0;
    unsigned u, v;
    double sine, cosine;
    nck_plane_axes(self, &u, &v);
    if (self->words.axes >> u & 1u) {
        const nck_status_t status = nck_decode_axis_word(self, u, &radius_nm);
        if (status != NCK_OK) return status;
        layout->radius = nck_real_of(radius_nm);
        layout->pole_nm[0] = steps ? at_nm[u] : 0;
        layout->pole_nm[1] = steps ? at_nm[v] : 0;
    }
    if (self->words.axes >> v & 1u) {
        const int letter = nck_decode_letter(v);
        const double word = nck_decode_real_word(self, letter);
        layout->angle = steps ? layout->angle + word : word;
        if (!(nck_fabs(layout->angle) <= degrees_most)) {
            layout->angle = 0.0;
            return nck_decode_fail_range(self, letter,
                                         degrees_most * nck_decode_counts(self, letter));
        }
    }
    const double whole = 360.0 * nck_floor(layout->angle / 360.0);
    nck_sincos((layout->angle - whole) * NCK_PI / 180.0, &sine, &cosine);
    at_nm[u] = layout->pole_nm[0] + nck_rounded(layout->radius * cosine);
    at_nm[v] = layout->pole_nm[1] + nck_rounded(layout->radius * sine);
    return NCK_OK;
}

// The words of X Y Z.
static nck_status_t read_place(nck_decode_t *self, int64_t *at_nm) {
    unsigned u, v;
    uint32_t axes = self->words.axes & 7u;
    nck_plane_axes(self, &u, &v);
    const uint32_t plane = 1u << u | 1u << v;
    if ((self->layout.on & NCK_LAYOUT_POLAR) && (axes & plane)) {
        const nck_status_t status = read_polar(self, at_nm);
        if (status != NCK_OK) return status;
        axes &= ~plane;
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        int64_t value_nm = 0;
        if (!(axes >> axis & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value_nm);
        if (status != NCK_OK) return status;
        at_nm[axis] = self->modal.incremental ? at_nm[axis] + value_nm : value_nm;
    }
    return NCK_OK;
}

nck_status_t nck_layout_target(nck_decode_t *self, int64_t *target_nm) {
    if (!NCK_HAS_LAYOUTS) return NCK_E_UNSUPPORTED;
    nck_layout_t *const layout = &self->layout;
    int64_t at_nm[3];
    double place[3];
    nck_layout_where(self, at_nm);
    nck_status_t status = read_place(self, at_nm);
    for (unsigned axis = 0; axis < 3; axis++) {
        place[axis] = stretch(layout, axis, nck_real_of(at_nm[axis]));
    }
    if (layout->on & NCK_LAYOUT_TURN) turn(self, layout->sine, place);
    for (unsigned axis = 0; axis < 3 && status == NCK_OK; axis++) {
        target_nm[axis] = 0;
        const nck_scale_t *const factor = nck_decode_scale_of(self, axis);
        const double most = (double)factor->limit;
        const double far = place[axis] + nck_real_of(self->place.origin_nm[axis]);
        if (!(nck_fabs(far) <= most)) {
            status = nck_decode_fail(self, NCK_E_NUMBER_RANGE, 0, nck_decode_letter(axis),
                                     nck_decode_as_word(factor, far),
                                     nck_decode_as_word(factor, most));
        } else {
            target_nm[axis] = self->place.origin_nm[axis] + nck_rounded(place[axis]);
        }
    }
    if (status != NCK_OK) return status;
    memcpy(layout->at_nm, at_nm, sizeof at_nm);
    memcpy(layout->stands_nm, target_nm, sizeof layout->stands_nm);
    for (unsigned axis = 0; axis < 3; axis++) { // all that move are held against their travel
        const int moves = target_nm[axis] != self->place.position_nm[axis];
        self->words.axes |= (uint32_t)moves << axis;
    }
    return NCK_OK;
}

// ---- ways

double nck_layout_way(const nck_decode_t *self, double *way) {
    if (!NCK_HAS_LAYOUTS) return 1.0;
    const nck_layout_t *const layout = &self->layout;
    unsigned axes[2];
    nck_plane_axes(self, &axes[0], &axes[1]);
    double factor[2];
    if ((layout->on & NCK_LAYOUT_SYSTEM) && self->modal.plane != 17) return 0.0;
    for (unsigned k = 0; k < 2; k++) {
        factor[k] = layout->mirrors >> axes[k] & 1u ? -1.0 : 1.0;
        if (layout->on & NCK_LAYOUT_SCALE) factor[k] *= layout->scale[axes[k]];
        way[k] *= factor[k];
    }
    if (layout->on & NCK_LAYOUT_TURN) {
        const double a = way[0];
        way[0] = layout->cosine * a - layout->sine * way[1];
        way[1] = layout->sine * a + layout->cosine * way[1];
    }
    const double other = nck_fabs(factor[1]);
    if (nck_fabs(factor[0]) > other || nck_fabs(factor[0]) < other) return 0.0;
    return factor[0] * factor[1] < 0.0 ? -other : other;
}

nck_status_t nck_layout_spares(nck_decode_t *self, unsigned axis) {
    const nck_layout_t *const layout = &self->layout;
    const int scales = (layout->on & NCK_LAYOUT_SCALE)
                       && (layout->scale[axis] > 1.0 || layout->scale[axis] < 1.0);
    const int turns = (layout->on & NCK_LAYOUT_SYSTEM) && axis != NCK_AXIS_Z;
    const int lies = scales || turns || (layout->mirrors >> axis & 1u);
    if (!NCK_HAS_LAYOUTS || !lies) return NCK_OK;
    return nck_decode_fail(self, NCK_E_LAYOUT_ON, 0, nck_decode_letter(axis), 0.0, 0.0);
}

int nck_layout_says_radius(const nck_decode_t *self) {
    unsigned u, v;
    nck_plane_axes(self, &u, &v);
    return nck_has_word(self, nck_decode_letter(u));
}

// ---- codes

uint32_t nck_layout_bit(int64_t tenths) {
    static const uint16_t codes[] = {150, 160, 500, 510, 501, 511, 690, 680};
    for (unsigned k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        if (codes[k] == tenths) return 1u << k;
    }
    return 0;
}

int nck_layout_collides(uint32_t codes, uint32_t bit) {
    const uint32_t all = codes | bit;
    const uint32_t both = all & (all >> 1) & 0x55u;
    const uint32_t axes = all & NCK_LAYOUT_HAS_AXES;
    return (codes & bit) != 0 || both != 0 || (axes & (axes - 1u)) != 0;
}

nck_status_t nck_layout_refuses(nck_decode_t *self) {
    static const uint8_t steps[] = {NCK_STEP_WORK, NCK_STEP_OFFSET, NCK_STEP_MACHINE};
    const nck_words_t *const words = &self->words;
    const uint32_t codes = (words->codes & NCK_STEP(NCK_STEP_LAYOUT))
                               ? words->code[NCK_STEP_LAYOUT] : 0u;
    uint32_t on = self->layout.on;
    if (codes & NCK_LAYOUT_G69) on &= ~(uint32_t)NCK_LAYOUT_TURN;
    if (codes & NCK_LAYOUT_G50) on &= ~(uint32_t)NCK_LAYOUT_SCALE;
    if (codes & NCK_LAYOUT_G15) on &= ~(uint32_t)NCK_LAYOUT_POLAR;
    const int plane = (words->codes & NCK_STEP(NCK_STEP_PLANE))
                      && words->code[NCK_STEP_PLANE] != 10 * self->modal.plane;
    if (on == 0) return NCK_OK;
    for (unsigned k = 0; k < sizeof steps; k++) {
        if (!(words->codes & NCK_STEP(steps[k]))) continue;
        return nck_decode_fail_code(self, NCK_E_LAYOUT_ON, (nck_step_t)steps[k]);
    }
    if (!plane || !(on & (NCK_LAYOUT_TURN | NCK_LAYOUT_POLAR))) return NCK_OK;
    return nck_decode_fail_code(self, NCK_E_LAYOUT_ON, NCK_STEP_PLANE);
}

// What changes must come in this order: mirror, scale, turn; and go in the other one.
static nck_status_t check_order(nck_decode_t *self, uint32_t later, double code) {
    return (self->layout.on & later) != 0 ? fail(self, NCK_E_LAYOUT_ON, 'G', code) : NCK_OK;
}

// A place that the words name; an axis without one: where the program stands.
static nck_status_t read_centre(nck_decode_t *self, int64_t *centre_nm) {
    nck_layout_where(self, centre_nm);
    for (unsigned axis = 0; axis < 3; axis++) {
        if (!(self->words.axes >> axis & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &centre_nm[axis]);
        if (status != NCK_OK) return status;
    }
    return NCK_OK;
}

// P for all axes, or I J K; one that is not said is 1. Without a point their unit goes by the
// control.
static nck_status_t read_factors(nck_decode_t *self, double *factor) {
    const uint32_t each = self->words.letters & NCK_LETTERS_CENTRE;
    if (nck_has_word(self, 'P') && each) {
        return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'P', 0.0, 0.0);
    }
    if (!nck_has_word(self, 'P') && !each) return fail(self, NCK_E_WORD_MISSING, 'P', 51.0);
    for (unsigned k = 0; k < 3; k++) {
        const int letter = each ? (int)('I' + k) : 'P';
        if (!nck_has_word(self, letter)) continue;
        const nck_status_t status = nck_decode_plain_word(self, letter, &factor[k]);
        if (status != NCK_OK) return status;
        const double size_of = nck_fabs(factor[k]), word = nck_fabs(nck_word_real(self, letter));
        if (size_of >= 1.0 / factor_most && size_of <= factor_most) continue;
        const double most = size_of > 0.0 ? factor_most * word / size_of : factor_most;
        return nck_decode_fail_range(self, letter, most);
    }
    return NCK_OK;
}

// G51.
static nck_status_t begin_scale(nck_decode_t *self) {
    nck_layout_t *const layout = &self->layout;
    double factor[3] = {1.0, 1.0, 1.0};
    int64_t centre_nm[3];
    nck_status_t status = check_order(self, NCK_LAYOUT_SCALE | NCK_LAYOUT_TURN, 51.0);
    if (status == NCK_OK) status = read_factors(self, factor);
    if (status == NCK_OK) status = read_centre(self, centre_nm);
    if (status != NCK_OK) return status;
    for (unsigned axis = 0; axis < 3; axis++) {
        layout->centre_nm[axis] = nck_rounded(stretch(layout, axis, nck_real_of(centre_nm[axis])));
    }
    memcpy(layout->scale, factor, sizeof factor);
    layout->on |= NCK_LAYOUT_SCALE;
    return NCK_OK;
}

static void set_mirrors(nck_layout_t *layout, uint32_t axes, int on, const int64_t *centre_nm) {
    const uint32_t left = axes != 0 ? layout->mirrors & ~axes : 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        if (axes >> axis & 1u) layout->mirror_nm[axis] = centre_nm[axis];
    }
    layout->mirrors = on ? layout->mirrors | axes : left;
    layout->on &= ~(uint32_t)NCK_LAYOUT_MIRROR;
    if (layout->mirrors != 0) layout->on |= NCK_LAYOUT_MIRROR;
}

// G51.1: the axes named are mirrored at these places; G50.1: they, or all, are no more.
static nck_status_t mirror(nck_decode_t *self, int on) {
    nck_layout_t *const layout = &self->layout;
    const uint32_t axes = self->words.axes & 7u;
    const uint32_t others = NCK_LAYOUT_SCALE | NCK_LAYOUT_TURN;
    int64_t centre_nm[3];
    if (!on && !(layout->on & NCK_LAYOUT_MIRROR)) return NCK_OK;
    nck_status_t status = check_order(self, others, on ? 51.1 : 50.1);
    if (status == NCK_OK && on && axes == 0) status = fail(self, NCK_E_WORD_MISSING, 'X', 51.1);
    if (status == NCK_OK) status = read_centre(self, centre_nm);
    if (status == NCK_OK) set_mirrors(layout, axes, on, centre_nm);
    return status;
}

// G68: R about a place in the plane.
static nck_status_t rotate(nck_decode_t *self) {
    nck_layout_t *const layout = &self->layout;
    const double degrees = nck_decode_real_word(self, 'R');
    int64_t centre_nm[3];
    unsigned u, v;
    nck_status_t status = check_order(self, NCK_LAYOUT_TURN, 68.0);
    if (status != NCK_OK) return status;
    if (!nck_has_word(self, 'R')) return fail(self, NCK_E_WORD_MISSING, 'R', 68.0);
    if (self->modal.incremental) return fail(self, NCK_E_INCREMENTAL, 'G', 68.0);
    if (!(nck_fabs(degrees) <= degrees_most)) {
        return nck_decode_fail_range(self, 'R', degrees_most * nck_decode_counts(self, 'R'));
    }
    status = read_centre(self, centre_nm);
    if (status != NCK_OK) return status;
    nck_plane_axes(self, &u, &v);
    layout->turn_nm[0] = nck_rounded(stretch(layout, u, nck_real_of(centre_nm[u])));
    layout->turn_nm[1] = nck_rounded(stretch(layout, v, nck_real_of(centre_nm[v])));
    const double whole = 360.0 * nck_floor(degrees / 360.0);
    nck_sincos((degrees - whole) * NCK_PI / 180.0, &layout->sine, &layout->cosine);
    layout->on |= NCK_LAYOUT_TURN;
    return NCK_OK;
}

// What ends, in its order.
static nck_status_t end(nck_decode_t *self, uint32_t codes) {
    nck_layout_t *const layout = &self->layout;
    nck_status_t status = NCK_OK;
    if (codes & NCK_LAYOUT_G15) layout->on &= ~(uint32_t)NCK_LAYOUT_POLAR;
    if (codes & NCK_LAYOUT_G69) layout->on &= ~(uint32_t)NCK_LAYOUT_TURN;
    if ((codes & NCK_LAYOUT_G50) && (layout->on & NCK_LAYOUT_SCALE)) {
        status = check_order(self, NCK_LAYOUT_TURN, 50.0);
        if (status == NCK_OK) layout->on &= ~(uint32_t)NCK_LAYOUT_SCALE;
    }
    return status == NCK_OK && (codes & NCK_LAYOUT_G50_1) ? mirror(self, 0) : status;
}

void nck_layout_name(nck_decode_t *self) {
    nck_layout_t *const layout = &self->layout;
    layout->stands_nm[0] = self->place.position_nm[0] + 1; // its name is to be found anew
    nck_layout_where(self, layout->at_nm);
    memcpy(layout->stands_nm, self->place.position_nm, sizeof layout->stands_nm);
}

nck_status_t nck_decode_layout(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_LAYOUTS) return NCK_E_UNSUPPORTED;
    const uint32_t codes = self->words.code[NCK_STEP_LAYOUT];
    nck_status_t status = end(self, codes);
    (void)out;
    if (status == NCK_OK && (codes & NCK_LAYOUT_G51_1)) status = mirror(self, 1);
    if (status == NCK_OK && (codes & NCK_LAYOUT_G51)) status = begin_scale(self);
    if (status == NCK_OK && (codes & NCK_LAYOUT_G68)) status = rotate(self);
    nck_layout_name(self);
    // Polar coordinates begin where the axes stand.
    if (status == NCK_OK && (codes & NCK_LAYOUT_G16)) {
        nck_layout_t *const layout = &self->layout;
        int64_t at_nm[3];
        unsigned u, v;
        nck_layout_where(self, at_nm);
        nck_plane_axes(self, &u, &v);
        const double a = nck_real_of(at_nm[u]);
        const double b = nck_real_of(at_nm[v]);
        memset(layout->pole_nm, 0, sizeof layout->pole_nm);
        layout->radius = nck_sqrt(a * a + b * b);
        layout->angle = nck_atan2(b, a) * 180.0 / NCK_PI;
        layout->on |= NCK_LAYOUT_POLAR;
    }
    return status == NCK_OK ? NCK_EMPTY : status;
}
