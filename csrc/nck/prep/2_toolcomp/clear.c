// SPDX-License-Identifier: MIT
// Does the path cross itself, or come too near to a contour? It may where the contour crosses or
// touches itself: laps, what leads in and out. Elsewhere two parts of the contour face each other,
// nearer than the tool is wide, or one is too near to the back of the other.
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/arc_math.h" // NCK_PI
#include "nck/base/real.h"     // nck_min nck_max

enum { PLACES = 8 }; // of a piece are looked at
#define NEAR 4.0  // radii of contour about a place: what is met there explains what the path meets
#define BESIDE 0.25 // radii beside a crossing: so far from it the tool is in the other contour

// How deep the tool is in a contour at worst.
typedef struct depth {
    double most;    // [mm]
    uint32_t other; // count of the contour
} depth_t;

// Contours about a place, counts from … until.
typedef struct window {
    uint32_t from;
    uint32_t until;
} window_t;

static double place_of(nck_toolcomp_t *self, const nck_comp_piece_t *piece, double along) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    if (piece->part == NCK_COMP_ABOUT) return entry->s;
    return entry->s + entry->contour.length * (along / piece->shape.length);
}

static window_t window_about(nck_toolcomp_t *self, uint32_t of, double s) {
    const double near = NEAR * self->radius;
    window_t window = {of, of};
    while (window.from != self->ring.tail) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, window.from - 1);
        if (entry->s + entry->contour.length < s - near) break;
        window.from--;
    }
    while (window.until != self->ring.head && nck_comp_at(self, window.until)->s < s + near) {
        window.until++;
    }
    return window;
}

static int is_at(const nck_shape_t *shape, const double *point) {
    return nck_shape_distance(shape, point) < NCK_COMP_CLOSE;
}

// Do two contours meet, but for the corner between neighbours?
static int do_meet(nck_toolcomp_t *self, uint32_t first, uint32_t second) {
    const nck_shape_t *const a = &nck_comp_at(self, first)->contour;
    const nck_shape_t *const b = &nck_comp_at(self, second)->contour;
    nck_meeting_t at[2];
    if (nck_shape_are_far(a, b, NCK_COMP_CLOSE)) return 0;
    if (is_at(a, b->q) || is_at(b, a->p)) return 1;
    if (nck_comp_next(self, first) == second) return 0;
    return nck_shape_cross(a, b, at) > 0 || is_at(a, b->p) || is_at(b, a->q);
}

// Does the contour meet itself about two places?
static int meets(nck_toolcomp_t *self, const window_t *a, const window_t *b) {
    for (uint32_t m = a->from; m != a->until; m++) {
        if (!nck_comp_at(self, m)->moves) continue;
        for (uint32_t n = nck_comp_next(self, m); n - self->ring.tail < b->until - self->ring.tail;
             n = nck_comp_next(self, n)) {
            if (n - self->ring.tail < b->from - self->ring.tail) continue;
            if (do_meet(self, m, n)) return 1;
        }
    }
    return 0;
}

// The tool at a place of a piece: is it deep in a contour?
static void sound(nck_toolcomp_t *self, const nck_shape_t *shape, double along, uint32_t contour,
                  depth_t *depth) {
    double point[2];
    const nck_shape_t *const other = &nck_comp_at(self, contour)->contour;
    nck_shape_point(shape, nck_min(nck_max(along, 0.0), shape->length), point);
    const double deep = self->radius - nck_shape_distance(other, point);
    if (deep > depth->most) *depth = (depth_t){deep, contour};
}

static int is_inside(const nck_shape_t *shape, double along) {
    return along > NCK_COMP_CLOSE && along < shape->length - NCK_COMP_CLOSE;
}

// Does the path, at a place where two of its pieces cross, go into either contour?
static int goes_in(nck_toolcomp_t *self, const nck_shape_t *shapes, const uint32_t *contours,
                   const nck_meeting_t *at) {
    static const double side[2] = {-BESIDE, BESIDE};
    depth_t depth = {0.0, 0};
    for (unsigned k = 0; k < 2; k++) {
        const double step = side[k] * self->radius;
        sound(self, &shapes[0], at->on_a + step, contours[1], &depth);
        sound(self, &shapes[1], at->on_b + step, contours[0], &depth);
    }
    return depth.most > NCK_COMP_CLOSE;
}

// A fault between the piece in work and another one, whatever their heights: of two paths that
// cross the lower one is in the contour of the higher one. Returns 1 if it is one.
static int is_fault(nck_toolcomp_t *self, const nck_shape_t *shape, const nck_comp_piece_t *other) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const uint32_t contours[2] = {piece->of, other->of};
    nck_shape_t shapes[2];
    nck_meeting_t at[2];
    shapes[0] = *shape;
    nck_comp_on_path(self, other, &shapes[1]);
    const unsigned count = nck_shape_cross(&shapes[0], &shapes[1], at);
    for (unsigned k = 0; k < count; k++) {
        const int inside = is_inside(&shapes[0], at[k].on_a) && is_inside(&shapes[1], at[k].on_b);
        if (!inside || !goes_in(self, shapes, contours, &at[k])) continue;
        const double from = nck_comp_at(self, other->of)->path[other->part].from;
        const window_t a = window_about(self, piece->of,
                                        place_of(self, piece, self->walk.along + at[k].on_a));
        const window_t b = window_about(self, other->of, place_of(self, other, from + at[k].on_b));
        if (!meets(self, &a, &b)) return 1;
    }
    return 0;
}

static nck_status_t fail(nck_toolcomp_t *self, const nck_shape_t *shape, uint32_t other) {
    const uint32_t of = self->walk.piece.of;
    depth_t depth = {0.0, other};
    for (uint32_t m = nck_comp_next(self, of); m != self->ring.head; m = nck_comp_next(self, m)) {
        if (nck_comp_at(self, m)->rapid) break;
        if (m == nck_comp_next(self, of) && m != other) continue;
        for (int k = 0; k <= PLACES; k++) {
            sound(self, shape, shape->length * (double)k / (double)PLACES, m, &depth);
        }
    }
    return nck_comp_fail(self, NCK_E_COMP_GOUGE, nck_comp_at(self, of)->block.line, depth.most,
                         (double)nck_comp_at(self, depth.other)->block.line);
}

// Does a contour that comes back to itself begin anew between two places, or next to them?
static int begins_anew(nck_toolcomp_t *self, const window_t *a, const window_t *b) {
    const int ahead = a->from - self->ring.tail < b->from - self->ring.tail;
    const uint32_t until = ahead ? b->until : a->until;
    for (uint32_t m = ahead ? a->from : b->from; m != until; m++) {
        if (nck_comp_at(self, m)->anew) return 1;
    }
    return 0;
}

// A stretch of the path and a contour that it is not beside: how deep is the tool in it [mm]?
// anew: 1: it is too near, but they are of two laps.
static double depth_in(nck_toolcomp_t *self, const nck_comp_piece_t *piece,
                       const nck_comp_stretch_t *path, uint32_t contour, int *anew) {
    const nck_comp_entry_t *const of = nck_comp_at(self, piece->of);
    const nck_comp_entry_t *const other = nck_comp_at(self, contour);
    nck_comp_stretch_t wall;
    nck_approach_t at;
    if (nck_shape_are_far(&path->shape, &other->contour, self->radius)) return 0.0;
    nck_comp_wall(self, contour, &wall);
    const double depth = nck_comp_depth(self, path, &wall, &at);
    if (!(depth > 0.0)) return 0.0;
    const double along = of->path[piece->part].from + at.on_a;
    const window_t a = window_about(self, piece->of, place_of(self, piece, along));
    const window_t b = window_about(self, contour, other->s + at.on_b);
    *anew = begins_anew(self, &a, &b);
    return *anew ? 0.0 : depth;
}

// Note how deep the tool is beside an entry, unless one before it, or that one deeper, is noted.
static void note_deep(nck_toolcomp_t *self, uint32_t count, double depth) {
    const uint32_t ahead = self->deep.of - self->ring.tail;
    const uint32_t own = count - self->ring.tail;
    const int waits = ahead < self->ring.head - self->ring.tail;
    if (waits && (ahead < own || (ahead == own && self->deep.most >= depth))) return;
    self->deep.most = depth;
    self->deep.of = count;
    self->deep.line = nck_comp_at(self, self->walk.piece.of)->block.line;
}

// What the path has beside a contour further on may be too near to that of the piece in work, which
// is gone from the ring by then.
static void hold_back(nck_toolcomp_t *self, uint32_t count, int *anew) {
    for (int part = 0; part < NCK_COMP_PARTS && !*anew; part++) {
        nck_comp_piece_t piece;
        nck_comp_stretch_t path;
        if (!nck_comp_at(self, count)->on[part]) continue;
        nck_comp_piece(self, count, (nck_comp_part_t)part, &piece);
        nck_comp_stretch(self, &piece, &path);
        const double depth = depth_in(self, &piece, &path, self->walk.piece.of, anew);
        if (depth > 0.0) note_deep(self, count, depth);
    }
}

int nck_comp_is_anew(nck_toolcomp_t *self, uint32_t count) {
    const nck_shape_t *const contour = &nck_comp_at(self, count)->contour;
    const double turn = 2.0 * NCK_PI * contour->radius;
    if (turn > 0.0 && contour->length > turn - NCK_COMP_CLOSE) return 1;
    for (uint32_t m = self->ring.tail; m != count; m++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (entry->moves && !entry->enters && do_meet(self, m, count)) return 1;
    }
    return 0;
}

int nck_comp_is_met(nck_toolcomp_t *self, uint32_t count) {
    for (uint32_t m = nck_comp_next(self, count); m != self->ring.head;
         m = nck_comp_next(self, m)) {
        if (do_meet(self, count, m)) return 1;
    }
    return 0;
}

// Is the piece in work held against the contours? A way to the contour and a rapid are not, nor is
// what a rapid swings about.
static int is_held(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    const int swings = entry->clear && piece->part == NCK_COMP_ABOUT;
    return !entry->rapid && !entry->enters && !swings;
}

// Are two contours so far apart that what runs beside one, at R from it, keeps off from the other
// one, and from what runs beside that?
static int are_apart(nck_toolcomp_t *self, uint32_t first, uint32_t second) {
    return nck_shape_are_far(&nck_comp_at(self, first)->contour,
                             &nck_comp_at(self, second)->contour, 2.0 * self->radius);
}

// Is the piece in work at fault with what the path has of an entry?
static int crosses(nck_toolcomp_t *self, const nck_shape_t *shape, uint32_t count) {
    for (int part = 0; part < NCK_COMP_PARTS; part++) {
        nck_comp_piece_t other;
        if (!nck_comp_at(self, count)->on[part]) continue;
        nck_comp_piece(self, count, (nck_comp_part_t)part, &other);
        if (is_fault(self, shape, &other)) return 1;
    }
    return 0;
}

// What runs beside a contour is nowhere nearer than R to the corner before it, so it does not cross
// the arc about that.
nck_status_t nck_comp_hold(nck_toolcomp_t *self) {
    const uint32_t of = self->walk.piece.of;
    nck_shape_t shape;
    if (!is_held(self)) return NCK_OK;
    nck_comp_on_path(self, &self->walk.piece, &shape);
    for (uint32_t m = nck_comp_next(self, of); m != self->ring.head; m = nck_comp_next(self, m)) {
        if (nck_comp_at(self, m)->rapid) return NCK_OK;
        if (!are_apart(self, of, m) && crosses(self, &shape, m)) return fail(self, &shape, m);
    }
    return NCK_OK;
}

nck_status_t nck_comp_keep_off(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    double depth = self->deep.of == piece->of ? self->deep.most : 0.0;
    uint32_t line = self->deep.line;
    nck_comp_stretch_t path;
    int anew = 0;
    if (!is_held(self)) return NCK_OK;
    nck_comp_stretch(self, piece, &path);
    for (uint32_t m = nck_comp_next(self, piece->of); m != self->ring.head && !anew;
         m = nck_comp_next(self, m)) {
        const nck_comp_entry_t *const other = nck_comp_at(self, m);
        if (other->rapid || other->leaves) break;
        if (are_apart(self, piece->of, m)) continue;
        const double deep = depth_in(self, piece, &path, m, &anew);
        if (deep > depth) {
            depth = deep;
            line = other->block.line;
        }
        hold_back(self, m, &anew);
    }
    if (!(depth > 0.0)) return NCK_OK;
    return nck_comp_fail(self, NCK_E_COMP_GOUGE, entry->block.line, depth, (double)line);
}
