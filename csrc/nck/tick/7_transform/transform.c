// SPDX-License-Identifier: MIT
// Room 7, transform: kinematics whose joints are axes.
#include "nck/tick/7_transform/transform.h"

#include <assert.h> // assert
#include <string.h> // memset

#include "nck/base/real.h" // nck_floor

// Identity: the machine's axes in the order X Y Z A B C U V W. Lathe: X (radius), Z.
void nck_transform_init(nck_transform_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    for (uint8_t x = 0; x < NCK_AXIS_MAX; x++) {
        const int on_lathe = x == NCK_AXIS_X || x == NCK_AXIS_Z;
        const int used = machine->kinematics == NCK_KINEMATICS_LATHE_XZ ? on_lathe : 1;
        if (!used || !machine->axis[x].present) continue;
        self->axis[self->joints] = x;
        self->counts[self->joints] = nck_machine_counts(machine, x);
        self->joints++;
    }
}

// Nearest integer, halves to even.
static int64_t round_even(double x) {
    const double below = nck_floor(x);
    const double rest = x - below;
    const int64_t n = (int64_t)below;
    if (rest < 0.5) return n;
    if (rest > 0.5) return n + 1;
    return n + (n & 1);
}

void nck_transform_tick(const nck_transform_t *self, const nck_pose_t *pose, nck_axes_t *axes_out) {
    assert(self->joints <= NCK_AXIS_MAX);
    memset(axes_out, 0, sizeof *axes_out);
    for (uint32_t k = 0; k < self->joints; k++) {
        axes_out->joint_nm[k] = round_even(pose->axis[self->axis[k]] * self->counts[k]);
    }
}
