// SPDX-License-Identifier: MIT
// Inside room 3: how far apart the knots may be by what a block itself is: by its speed, by its
// curvature, and by the step of that where another one begins.
#include "nck/prep/3_smooth/curve.h"

#include "nck/base/path.h"                 // nck_path_second_part
#include "nck/base/real.h"                 // nck_min
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define AIM_STEP 0.9 // of the tolerance, at a step of the curvature
// A step of the curvature is a key if the corner there allows alone so many of its spacings, and
// the blocks beside it have room for this share of it.
#define STEP_CORNER 4.0
#define STEP_ROOM 0.35
// Inside of an arc its spacing must fit by this share.
#define STEP_FITS 0.7

double nck_curve_widest(const nck_smooth_t *self, double v) {
    const nck_machine_t *const machine = self->terms->machine;
    double a = machine->path.a_max;
    double j = machine->path.j_max;
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (!axis->present) continue;
        a = nck_min(a, axis->a_max);
        j = nck_min(j, axis->j_max);
    }
    return nck_spline_spacing_max(v, a, j);
}

// The widest that the speed of a block can ask for: a wider bend only leaves the path further, and
// is a longer way.
static double widest_along(const nck_smooth_t *self, const nck_seg_t *seg) {
    if (seg->rapid || NCK_WINDOW < NCK_CURVE_WINDOW) return self->spacing_max;
    return nck_min(self->spacing_max, nck_curve_widest(self, seg->feed));
}

double nck_curve_inside(const nck_smooth_t *self, const nck_seg_t *seg, double tolerance) {
    const double kappa = nck_raw_curvature(seg, self->terms->axes);
    const double widest = widest_along(self, seg);
    if (!(kappa > 0.0)) return widest;
    return nck_min(widest, nck_spline_curve_spacing(NCK_CURVE_AIM * tolerance, kappa));
}

// How much the curvature steps from one seg to the next: |Δp″|.
static double step_of(const nck_seg_t *in, const nck_seg_t *out, int axes) {
    double before[NCK_AXIS_MAX];
    double behind[NCK_AXIS_MAX];
    if (in->kind == NCK_SEG_LINE && out->kind == NCK_SEG_LINE) return 0.0;
    nck_path_second_part(in, in->length, axes, before);
    nck_path_second_part(out, 0.0, axes, behind);
    return nck_spline_distance(before, behind, axes);
}

double nck_curve_along(const nck_smooth_t *self, const nck_raw_t *raw) {
    const double widest = widest_along(self, &raw->seg);
    if (raw->seg.kind == NCK_SEG_LINE) return widest;
    const double kappa = nck_raw_curvature(&raw->seg, self->terms->axes);
    const double omega = nck_fabs(raw->seg.shape.arc.sweep) / raw->seg.length;
    if (!(kappa * omega * omega > 0.0)) return widest; // it hardly bends
    return nck_min(widest, nck_spline_arc_spacing(NCK_CURVE_AIM * raw->tolerance, kappa, omega));
}

double nck_curve_step(nck_smooth_t *self, uint32_t count, double aim, double alone) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    const double step = step_of(&raw->seg, &next->seg, self->terms->axes);
    if (!(step > 0.0)) return 0.0;
    const double tolerance = aim / NCK_CURVE_AIM;
    const double most = nck_spline_step_spacing(AIM_STEP * tolerance, step);
    const double room = 0.5 * nck_min(raw->seg.length, next->seg.length);
    if (alone < STEP_CORNER * most || room < STEP_ROOM * most) return 0.0;
    const double inside = nck_min(nck_curve_along(self, raw), nck_curve_along(self, next));
    if (inside < STEP_FITS * most) return 0.0;
    const double share = AIM_STEP - NCK_CURVE_AIM * most / alone;
    return nck_min(nck_min(room, inside), nck_spline_step_spacing(share * tolerance, step));
}
