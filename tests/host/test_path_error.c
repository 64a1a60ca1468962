// SPDX-License-Identifier: MIT
// How far a run and its program are apart, both ways, where the answer is known: on lines, arcs and
// helices; blocks in pieces of any size; rings that are just long enough, and too short.
#include <string.h> // memset

#include "check.h"
#include "host/path_error.h"   // nck_host_path_error_…
#include "host/path_miss.h"    // nck_host_path_miss_…
#include "host/seg_distance.h" // nck_host_seg_distance

enum { BLOCKS = 400, ROWS = 512, MM = 1000000 };

static nck_machine_t machine;
static nck_block_t blocks[BLOCKS];
static nck_pose_t poses[BLOCKS];
static nck_seg_t segs[BLOCKS];
static nck_host_move_t moves[ROWS];
static nck_host_mark_t marks[ROWS];
static nck_seg_t kept[ROWS];

// Up and down by 1 mm a block, and 1 mm along X; at the 100th block the run is off by `off` along
// Z, and the path lower.
static void write_wave(size_t count, double off)
{
    nck_machine_default(&machine);
    memset(machine.start_nm, 0, sizeof machine.start_nm);
    memset(blocks, 0, sizeof blocks);
    memset(poses, 0, sizeof poses);
    memset(segs, 0, sizeof segs);
    for (size_t k = 0; k < count; k++) {
        blocks[k].line = (uint32_t)k + 1;
        blocks[k].kind = NCK_BLOCK_LINE;
        blocks[k].plane = 17;
        blocks[k].path_mode = NCK_PATH_CONTINUOUS;
        blocks[k].tolerance_mm = 0.5;
        blocks[k].target_nm[0] = (int64_t)(k + 1) * MM;
        blocks[k].target_nm[1] = (int64_t)((k + 1) % 2) * MM;
        const double root = sqrt(2.0);
        const double y = (double)(k % 2);
        nck_seg_t *const seg = &segs[k];
        seg->length = root;
        seg->s_begin = root * (double)k;
        seg->start[0] = (double)k;
        seg->end[0] = (double)k + 1.0;
        seg->start[1] = y;
        seg->end[1] = 1.0 - y;
        poses[k].line = (uint32_t)k + 1;
        poses[k].s = root * ((double)k + 0.5);
        poses[k].axis[0] = (double)k + 0.5;
        poses[k].axis[1] = 0.5;
    }
    if (count <= 100) return;
    poses[100].axis[2] = off;
    segs[100].end[1] -= off;
    segs[101].start[1] -= off;
}

// Give a course so many blocks more.
static size_t give(nck_host_course_t *course, size_t given, size_t count, size_t piece)
{
    const size_t some = count - given < piece ? count - given : piece;
    nck_host_course_give(course, blocks + given, some);
    return given + some;
}

static double run_error(size_t count, size_t piece, size_t ring)
{
    nck_host_path_error_t error = {.moves = moves, .move_max = ring};
    size_t given = 0;
    nck_host_path_error_init(&error, &machine);
    for (size_t done = 0, used = 0; done < count; done += used) {
        if (nck_host_path_error_add(&error, poses + done, count - done, &used) == NCK_EMPTY) {
            given = give(&error.course, given, count, piece);
        }
    }
    return error.largest;
}

static nck_host_path_miss_t miss_of(size_t count, size_t piece, size_t mark_max, size_t seg_max)
{
    nck_host_path_miss_t miss = {
        .marks = marks, .mark_max = mark_max, .segs = kept, .seg_max = seg_max};
    size_t given = 0;
    nck_host_path_miss_init(&miss, &machine, 0.5);
    for (size_t done = 0, used = 0; done < count; done += used) {
        if (nck_host_path_miss_add(&miss, segs + done, count - done, &used) == NCK_EMPTY) {
            given = give(&miss.course, given, count, piece);
        }
    }
    while (nck_host_path_miss_end(&miss) == NCK_EMPTY) {
        given = give(&miss.course, given, count, piece);
    }
    return miss;
}

static void a_setpoint_beside_a_line_is_as_far_as_it_is_off(check_t *check)
{
    write_wave(300, 0.125);
    for (size_t piece = 1; piece <= 300; piece += 23) {
        CHECK_NEAR(check, run_error(300, piece, ROWS), 0.125, 1e-12);
    }
}

static void a_ring_of_a_few_moves_is_enough_where_the_run_is_near(check_t *check)
{
    write_wave(300, 0.125);
    for (size_t ring = 2; ring < 40; ring++) {
        CHECK_NEAR(check, run_error(300, 7, ring), 0.125, 1e-12);
    }
}

static void a_run_on_another_line_than_its_own_counts_from_there(check_t *check)
{
    write_wave(300, 0.0);
    poses[50].axis[0] = 53.25; // three and a half moves further on, and on the path
    poses[50].axis[1] = 0.75;
    CHECK_NEAR(check, run_error(300, 7, ROWS), 0.0, 1e-12);
}

static void setpoints_that_the_spindle_leads_do_not_count(check_t *check)
{
    write_wave(300, 0.125);
    poses[100].kind = NCK_SEG_THREAD;
    CHECK_NEAR(check, run_error(300, 7, ROWS), 0.0, 1e-12);
    poses[100].kind = NCK_SEG_LINE;
    poses[100].line = 0;
    CHECK_NEAR(check, run_error(300, 7, ROWS), 0.0, 1e-12);
}

// The tip at (101, 1) is 0.9 high.
static void a_tip_that_is_cut_off_is_missed_by_its_distance(check_t *check)
{
    write_wave(300, 0.1);
    for (size_t piece = 1; piece <= 300; piece += 23) {
        const nck_host_path_miss_t miss = miss_of(300, piece, ROWS, ROWS);
        CHECK_NEAR(check, miss.largest, 0.1, 1e-12);
        CHECK_NEAR(check, miss.missed, 0.2, 1e-12);
    }
}

static void rings_of_a_few_rows_find_it_too(check_t *check)
{
    write_wave(300, 0.1);
    const double found = miss_of(300, 300, ROWS, ROWS).largest;
    for (size_t rows = 8; rows < 40; rows += 3) {
        CHECK_NEAR(check, miss_of(300, 7, rows - 7, rows).largest, found, 1e-15);
    }
}

static void a_path_that_ends_early_is_measured_as_far_as_it_goes(check_t *check)
{
    write_wave(300, 0.1);
    nck_host_path_miss_t miss = {.marks = marks, .mark_max = ROWS, .segs = kept, .seg_max = ROWS};
    nck_host_path_miss_init(&miss, &machine, 0.5);
    CHECK_INT(check, nck_host_path_miss_end(&miss), NCK_OK);
    (void)give(&miss.course, 0, 300, 300);
    size_t used = 0;
    CHECK_INT(check, nck_host_path_miss_add(&miss, segs, 50, &used), NCK_OK);
    CHECK_INT(check, used, 50);
    CHECK_INT(check, nck_host_path_miss_end(&miss), NCK_OK);
    CHECK_NEAR(check, miss.largest, 0.0, 1e-12);
}

// A full turn about (0, 5) from (0, 0), and `rise` along Z.
static nck_host_move_t helix(double rise)
{
    nck_host_course_t course;
    nck_host_move_t move;
    write_wave(1, 0.0);
    blocks[0].kind = NCK_BLOCK_ARC;
    blocks[0].target_nm[0] = blocks[0].target_nm[1] = 0;
    blocks[0].target_nm[2] = (int64_t)(rise * (double)MM);
    blocks[0].centre_mm[1] = 5.0;
    blocks[0].sweep_rad = 2.0 * 3.14159265358979323846;
    nck_host_course_init(&course, &machine);
    nck_host_course_give(&course, blocks, 1);
    (void)nck_host_course_next(&course, &move);
    return move;
}

static void a_point_beside_a_helix_is_as_far_as_it_is_off(check_t *check)
{
    const double rises[] = {0.0, 0.001, -0.001, 3.0};
    for (size_t i = 0; i < sizeof rises / sizeof *rises; i++) {
        const nck_host_move_t move = helix(rises[i]);
        for (int k = 1; k < 16; k++) {
            double point[NCK_AXIS_MAX];
            nck_host_course_point(&move, (double)k / 16.0, point);
            CHECK_NEAR(check, nck_host_course_distance(&move, point), 0.0, 1e-12);
            point[0] *= 1.02;
            point[1] = 5.0 + (point[1] - 5.0) * 1.02;
            CHECK_NEAR(check, nck_host_course_distance(&move, point), 0.1, 1e-3);
        }
    }
}

// Of a quarter circle as an arc, as a cubic, and a line through both ends.
static void a_seg_is_as_far_as_its_curve(check_t *check)
{
    const double k = 4.0 / 3.0 * (sqrt(2.0) - 1.0);
    nck_seg_t seg;
    double point[NCK_AXIS_MAX] = {2.0, 2.0};
    memset(&seg, 0, sizeof seg);
    seg.start[0] = seg.end[1] = 1.0;
    seg.kind = NCK_SEG_LINE;
    CHECK_NEAR(check, nck_host_seg_distance(&seg, point, 9.0), 1.5 * sqrt(2.0), 1e-12);
    seg.kind = NCK_SEG_SPLINE;
    seg.shape.inner[0][0] = seg.shape.inner[1][1] = 1.0;
    seg.shape.inner[0][1] = seg.shape.inner[1][0] = k;
    CHECK_NEAR(check, nck_host_seg_distance(&seg, point, 9.0), 2.0 * sqrt(2.0) - 1.0, 1e-3);
    memset(&seg.shape, 0, sizeof seg.shape);
    seg.kind = NCK_SEG_ARC;
    seg.shape.arc.axis_v = 1;
    seg.shape.arc.sweep = 0.5 * 3.14159265358979323846;
    CHECK_NEAR(check, nck_host_seg_distance(&seg, point, 9.0), 2.0 * sqrt(2.0) - 1.0, 1e-5);
    CHECK(check, nck_host_seg_distance(&seg, point, 0.1) >= 0.1);
    point[0] = point[1] = 0.0;
    CHECK_NEAR(check, nck_host_seg_distance(&seg, point, 9.0), 1.0, 1e-5);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_setpoint_beside_a_line_is_as_far_as_it_is_off);
    CHECK_RUN(&check, a_ring_of_a_few_moves_is_enough_where_the_run_is_near);
    CHECK_RUN(&check, a_run_on_another_line_than_its_own_counts_from_there);
    CHECK_RUN(&check, setpoints_that_the_spindle_leads_do_not_count);
    CHECK_RUN(&check, a_tip_that_is_cut_off_is_missed_by_its_distance);
    CHECK_RUN(&check, rings_of_a_few_rows_find_it_too);
    CHECK_RUN(&check, a_path_that_ends_early_is_measured_as_far_as_it_goes);
    CHECK_RUN(&check, a_point_beside_a_helix_is_as_far_as_it_is_off);
    CHECK_RUN(&check, a_seg_is_as_far_as_its_curve);
    return check_end(&check);
}
