// SPDX-License-Identifier: MIT
// base/marks.h: which source line the path is of, place by place.
#include <string.h> // memset

#include "check.h"
#include "nck/base/link.h"  // nck_link_push_mark nck_link_push_seg
#include "nck/base/marks.h" // nck_marks_line

#define ROUNDING 1e-12 // of sums of lengths [path mm]

static nck_link_t link_;
static nck_seg_t seg_;

// The next seg goes on to `end`. Returns it, as it is in the link.
static const nck_seg_t *seg_to(check_t *check, double end)
{
    seg_.s_begin += seg_.length;
    seg_.length = end - seg_.s_begin;
    seg_.line = 999;
    CHECK_INT(check, nck_link_push_seg(&link_, &seg_), NCK_OK);
    return nck_link_seg(&link_, seg_.seq++);
}

static void begin(void)
{
    memset(&link_, 0, sizeof link_);
    memset(&seg_, 0, sizeof seg_);
    nck_link_init(&link_);
}

// The way of a line ends at s; the modes in force there are its number's.
static void mark(uint32_t line, double s)
{
    const nck_mark_t next = {s, line, line + 1000};
    nck_link_push_mark(&link_, &next);
}

// The modes come from where the line does, and those of a seg without marks are its own.
static uint32_t line_at(const nck_seg_t *seg, double s)
{
    uint32_t modes = 0;
    const uint32_t line = nck_marks_line(&link_.marks, seg, s, &modes);
    if (line != 999 && modes != line + 1000) return 0;
    return line;
}

static void a_seg_of_several_lines_knows_all_of_them(check_t *check)
{
    begin();
    for (uint32_t n = 0; n < 6; n++) mark(10 + 2 * n, 1.0 + (double)n);
    const nck_seg_t *const first = seg_to(check, 3.5);
    const nck_seg_t *const second = seg_to(check, 6.0);
    const double places[] = {0.0, 0.5, 1.0, 1.5, 2.5, 3.25, 3.5};
    const uint32_t lines[] = {10, 10, 10, 12, 14, 16, 16};
    if (!NCK_HAS_MARKS) return;
    for (int k = 0; k < 7; k++) CHECK_INT(check, line_at(first, places[k]), lines[k]);
    CHECK_INT(check, first->line, 10);
    CHECK_INT(check, second->line, 16);
    CHECK_INT(check, line_at(second, 0.5), 16);
    CHECK_INT(check, line_at(second, 0.75), 18);
    CHECK_INT(check, line_at(second, 2.5), 20);
}

static void a_rounded_end_is_the_end(check_t *check)
{
    begin();
    mark(1, 1.0);
    mark(2, 2.0);
    const nck_seg_t *const first = seg_to(check, 1.0 + ROUNDING);
    const nck_seg_t *const second = seg_to(check, 2.0 - ROUNDING);
    if (!NCK_HAS_MARKS) return;
    CHECK_INT(check, line_at(first, first->length), 1);
    CHECK_INT(check, second->line, 2);
    CHECK_INT(check, line_at(second, second->length), 2);
}

static void a_seg_without_a_mark_keeps_its_line(check_t *check)
{
    begin();
    CHECK_INT(check, line_at(seg_to(check, 1.0), 0.5), 999);
    mark(7, 2.0);
    CHECK_INT(check, line_at(seg_to(check, 1.0), 0.0), 999); // at rest
    CHECK_INT(check, line_at(seg_to(check, 2.0), 0.5), NCK_HAS_MARKS ? 7 : 999);
}

// Marks go round with the segs: those that a seg of the ring asks for are never written over, and
// what has no room is left out.
static void marks_of_the_ring_stay(check_t *check)
{
    begin();
    if (!NCK_HAS_MARKS) return;
    for (int n = 0; n < 2 * NCK_MARK_MAX; n++) {
        mark((uint32_t)n, (double)n + 1.0);
        if (n == 0) (void)seg_to(check, 1.0);
    }
    CHECK_INT(check, link_.marks.head, NCK_MARK_MAX);
    CHECK_INT(check, line_at(nck_link_seg(&link_, 0), 0.5), 0);
    const nck_seg_t *const long_one = seg_to(check, 2.0 * NCK_MARK_MAX);
    CHECK_INT(check, line_at(long_one, 0.5), 1);
    CHECK_INT(check, line_at(long_one, NCK_MARK_MAX - 1.5), NCK_MARK_MAX - 1);
    CHECK_INT(check, line_at(long_one, 2.0 * NCK_MARK_MAX - 1.0), NCK_MARK_MAX - 1);
    for (uint32_t n = 2; n < NCK_SEG_MAX; n++) (void)seg_to(check, seg_.s_begin + 2.0);
    mark(5, seg_.s_begin + 2.0);
    CHECK_INT(check, link_.marks.head, NCK_MARK_MAX); // the first seg is in the ring's last place
    nck_link_seg_finish(&link_, NCK_SEG_MAX);
    for (int n = 0; n < 2; n++) (void)seg_to(check, seg_.s_begin + seg_.length + 1.0);
    mark(5, seg_.s_begin + 3.0);
    CHECK_INT(check, link_.marks.head, NCK_MARK_MAX + 1);
    CHECK_INT(check, line_at(seg_to(check, seg_.s_begin + 3.0), 0.5), 5);
}

static void a_link_anew_has_no_marks(check_t *check)
{
    begin();
    mark(7, 2.0);
    nck_link_renew(&link_);
    CHECK_INT(check, line_at(seg_to(check, 2.0), 0.5), 999);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_seg_of_several_lines_knows_all_of_them);
    CHECK_RUN(&check, a_rounded_end_is_the_end);
    CHECK_RUN(&check, a_seg_without_a_mark_keeps_its_line);
    CHECK_RUN(&check, marks_of_the_ring_stay);
    CHECK_RUN(&check, a_link_anew_has_no_marks);
    return check_end(&check);
}
