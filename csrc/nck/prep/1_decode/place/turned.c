// SPDX-License-Identifier: MIT
// Work systems of RS274NGC that are turned about their zero, in the plane of X and Y: G10 L2 R.
// One that is in force is a layout that turns, and shifts of G92 and G52 lie in it:
//
//     place of the program + G92 ─turn─▶ + work system + tool = machine position
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_code
#include "nck/base/real.h" // nck_floor
#include "nck/base/trig_math.h" // nck_sincos NCK_PI

double nck_turned_by(const nck_decode_t *self, uint32_t system) {
    return NCK_HAS_LAYOUTS && system < NCK_TURNED_ROWS ? self->place.turn_deg[system] : 0.0;
}

void nck_turned_set(nck_decode_t *self, uint32_t system, double degrees) {
    if (!NCK_HAS_LAYOUTS || system >= NCK_TURNED_ROWS) return;
    self->place.turn_deg[system] = degrees - 360.0 * nck_floor(degrees / 360.0);
}

void nck_decode_origin(nck_decode_t *self) {
    const int64_t *const work = self->place.work_nm[self->place.work_system];
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int64_t tool = axis < 3 ? self->place.tool_nm[axis] : 0;
        self->place.origin_nm[axis] =
            self->place.outer_nm[axis] + work[axis] + self->place.g92_nm[axis] + tool;
    }
    // What holds for the work system in force.
    nck_layout_t *const layout = &self->layout;
    if (!NCK_HAS_LAYOUTS || self->tongue != NCK_TONGUE_LINUXCNC) return;
    const double degrees = nck_turned_by(self, self->place.work_system);
    layout->on = 0;
    if (!(degrees > 0.0)) return;
    nck_sincos(degrees * NCK_PI / 180.0, &layout->sine, &layout->cosine);
    layout->turn_nm[0] = -self->place.g92_nm[NCK_AXIS_X];
    layout->turn_nm[1] = -self->place.g92_nm[NCK_AXIS_Y];
    layout->on = NCK_LAYOUT_TURN | NCK_LAYOUT_SYSTEM;
    nck_layout_name(self);
}

int64_t nck_turned_place(const nck_decode_t *self, unsigned axis) {
    int64_t at_nm[3];
    const int is_turned = NCK_HAS_LAYOUTS && (self->layout.on & NCK_LAYOUT_SYSTEM) != 0;
    if (axis >= 3 || !is_turned) {
        return self->place.position_nm[axis] - self->place.origin_nm[axis];
    }
    nck_layout_where(self, at_nm);
    return at_nm[axis];
}

nck_status_t nck_turned_refuses(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const int offset = (words->codes & NCK_STEP(NCK_STEP_OFFSET)) != 0;
    const unsigned code = words->code[NCK_STEP_OFFSET];
    const int returns = offset && (code == 280 || code == 300) && words->axes != 0;
    const int flat = self->modal.plane == 17;
    const int compensates = (words->codes & NCK_STEP(NCK_STEP_RADIUS_COMP)) != 0
                            && words->code[NCK_STEP_RADIUS_COMP] != 400;
    if (returns) return nck_decode_fail_code(self, NCK_E_LAYOUT_ON, NCK_STEP_OFFSET);
    if (!compensates || flat) return NCK_OK;
    return nck_decode_fail_code(self, NCK_E_LAYOUT_ON, NCK_STEP_RADIUS_COMP);
}
