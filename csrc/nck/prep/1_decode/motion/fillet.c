// SPDX-License-Identifier: MIT
// Fillets and chamfers of lines and arcs.
//
// The centre of a fillet of radius r is r away from both edges, on the side to which the corner
// turns: on the parallel of a line, on a circle of radius R - r or R + r about an arc's centre. Of
// two such places the one nearer to the corner counts.
#include "nck/prep/1_decode/motion/fillet.h"
#include "nck/prep/1_decode/motion/motion.h"
#include "nck/base/arc_math.h" // nck_arc_inner nck_arc_norm nck_arc_outer
#include "nck/base/real.h" // nck_fabs nck_sqrt
#include "nck/base/trig.h" // nck_atan2

static const double bend_least = 1e-6;  // sine of an angle that is a corner
static const double near = 2e-6;        // [mm] two roundings to whole nanometres

// The side of a corner: +1 left, −1 right, 0: it is none.
static double side_of(const nck_edge_t *edges) {
    const double bend = nck_arc_outer(edges[0].way, edges[1].way);
    if (nck_fabs(bend) < bend_least) return 0.0;
    return bend > 0.0 ? 1.0 : -1.0;
}

// Is the place on the edge? last: it is the edge behind the corner.
static int is_on(const nck_edge_t *edge, const double *place, int last) {
    const double sense = last ? 1.0 : -1.0;
    if (!(edge->radius > 0.0)) {
        const double ahead = sense * nck_arc_inner(place, edge->way);
        return ahead > -near && ahead < edge->length + near;
    }
    const double from[2] = {-edge->centre[0], -edge->centre[1]};
    const double to[2] = {place[0] - edge->centre[0], place[1] - edge->centre[1]};
    const double turn = sense * edge->turn;
    const double angle = nck_atan2(turn * nck_arc_outer(from, to), nck_arc_inner(from, to));
    const double ahead = angle < 0.0 ? angle + 2.0 * NCK_PI : angle;
    return ahead * edge->radius < edge->length * edge->radius + near;
}

static int both_on(const nck_edge_t *edges, const nck_cut_t *cut) {
    return is_on(&edges[0], cut->touch[0], 0) && is_on(&edges[1], cut->touch[1], 1);
}

static void keep(double u, double v, double *out) {
    out[0] = u;
    out[1] = v;
}

// Two parallels: the place p with p·n = r for the normals n of both.
static int meet_lines(const nck_edge_t *edges, double offset, double *out) {
    const double *const a = edges[0].way, *const b = edges[1].way;
    const double per = offset / nck_arc_outer(a, b); // n is a way turned by +90°
    keep(per * (b[0] - a[0]), per * (b[1] - a[1]), out);
    return 1;
}

// The parallel of a line and a circle of radius rho.
static int meet_line(const nck_edge_t *line, double offset, const double *centre, double rho,
                     double *out) {
    const double foot[2] = {-line->way[1] * offset, line->way[0] * offset};
    const double from[2] = {foot[0] - centre[0], foot[1] - centre[1]};
    const double along = nck_arc_inner(from, line->way);
    const double rest = along * along - nck_arc_inner(from, from) + rho * rho;
    if (!(rest >= 0.0)) return 0;
    const double root = nck_sqrt(rest);
    const double s = along > 0.0 ? root - along : -root - along; // of the smaller magnitude
    keep(foot[0] + s * line->way[0], foot[1] + s * line->way[1], out);
    return 1;
}

// Two circles of radii rho.
static int meet_circles(const double *a, const double *b, const double *rho, double *out) {
    const double way[2] = {b[0] - a[0], b[1] - a[1]};
    const double apart = nck_arc_norm(way[0], way[1]);
    if (!(apart > near)) return 0;
    const double ahead = 0.5 * (apart + (rho[0] - rho[1]) * (rho[0] + rho[1]) / apart);
    const double rest = (rho[0] - ahead) * (rho[0] + ahead);
    if (!(rest >= 0.0)) return 0;
    const double u = way[0] / apart, v = way[1] / apart;
    const double foot[2] = {a[0] + ahead * u, a[1] + ahead * v};
    const double aside = foot[1] * u - foot[0] * v > 0.0 ? -nck_sqrt(rest) : nck_sqrt(rest);
    keep(foot[0] - aside * v, foot[1] + aside * u, out);
    return 1;
}

// The place that is r away from both.
static int find_centre(const nck_edge_t *edges, double r, double side, double *out) {
    double rho[2];
    for (unsigned k = 0; k < 2; k++) {
        rho[k] = edges[k].radius - side * edges[k].turn * r;
        if (edges[k].radius > 0.0 && !(rho[k] > near)) return 0;
    }
    const int bends[2] = {edges[0].radius > 0.0, edges[1].radius > 0.0};
    if (bends[0] && bends[1]) return meet_circles(edges[0].centre, edges[1].centre, rho, out);
    if (bends[0]) return meet_line(&edges[1], side * r, edges[0].centre, rho[0], out);
    if (bends[1]) return meet_line(&edges[0], side * r, edges[1].centre, rho[1], out);
    return meet_lines(edges, side * r, out);
}

// Where the circle about c touches the edge.
static void touch(const nck_edge_t *edge, const double *c, double *out) {
    if (!(edge->radius > 0.0)) {
        const double ahead = nck_arc_inner(c, edge->way);
        keep(ahead * edge->way[0], ahead * edge->way[1], out);
        return;
    }
    const double way[2] = {c[0] - edge->centre[0], c[1] - edge->centre[1]};
    const double scale = edge->radius / nck_arc_norm(way[0], way[1]);
    keep(edge->centre[0] + scale * way[0], edge->centre[1] + scale * way[1], out);
}

int nck_fillet(const nck_edge_t *edges, double radius, nck_cut_t *out) {
    double *const c = out->centre;
    out->turn = side_of(edges);
    if (!(nck_fabs(out->turn) > 0.0)) return 0;
    const int found = find_centre(edges, radius, out->turn, c);
    if (!found) return 0;
    for (unsigned k = 0; k < 2; k++) touch(&edges[k], c, out->touch[k]);
    const double from[2] = {out->touch[0][0] - c[0], out->touch[0][1] - c[1]};
    const double to[2] = {out->touch[1][0] - c[0], out->touch[1][1] - c[1]};
    return out->turn * nck_arc_outer(from, to) > 0.0 && both_on(edges, out);
}

// The place on the edge that is `size` away from the corner. sense: −1: before it. Returns 0 if
// there is none.
static int step(const nck_edge_t *edge, double size, double sense, double *out) {
    if (!(edge->radius > 0.0)) {
        keep(sense * size * edge->way[0], sense * size * edge->way[1], out);
        return 1;
    }
    const double half = 0.5 * size / edge->radius; // sine of half of the angle
    if (!(half < 1.0)) return 0;
    const double sine = sense * edge->turn * 2.0 * half * nck_sqrt(1.0 - half * half);
    const double cosine = 1.0 - 2.0 * half * half;
    const double *const c = edge->centre;
    keep(c[0] - c[0] * cosine + c[1] * sine, c[1] - c[1] * cosine - c[0] * sine, out);
    return 1;
}

int nck_chamfer(const nck_edge_t *edges, double size, nck_cut_t *out) {
    out->turn = side_of(edges);
    keep(0.0, 0.0, out->centre);
    if (!(nck_fabs(out->turn) > 0.0)) return 0;
    const int before = step(&edges[0], size, -1.0, out->touch[0]);
    const int behind = step(&edges[1], size, 1.0, out->touch[1]);
    return before && behind && both_on(edges, out);
}
