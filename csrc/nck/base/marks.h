// SPDX-License-Identifier: MIT
// Which source line the path is of, place by place: a smooth seg may be of many. Prep marks where
// the way of each line ends; a seg knows its first mark and how many are on it.
#ifndef NCK_BASE_MARKS_H
#define NCK_BASE_MARKS_H

#include "nck/base/limits.h"  // NCK_MARK_MAX
#include "nck/base/records.h" // nck_seg_t

#ifdef __cplusplus
extern "C" {
#endif

// The way of a source line ends here.
typedef struct nck_mark {
    double s;          // program's path up to there [path mm]
    uint32_t line;     // source line
    uint32_t modes;    // in force there (in_force.h)
} nck_mark_t;

// A ring of them. Prep writes all of it; the tick reads the marks of segs that it has.
typedef struct nck_marks {
    uint32_t head; // marks so far
    uint32_t tail; // those before it are behind the path that has been told
    nck_mark_t at[NCK_MARK_MAX];
} nck_marks_t;

// The next mark. oldest: the first mark that a seg may still ask for.
// Where the ring is full it is left out, and its way counts to a line beside it. Cost: constant.
// Context: prep.
void nck_marks_push(nck_marks_t *self, uint32_t oldest, const nck_mark_t *mark);

// Tell a seg its first line, the modes in force there, and its marks; segs come in order. Cost:
// linear in the marks that it passes. Context: prep, before the tick sees the seg.
void nck_marks_tell(nck_marks_t *self, nck_seg_t *seg);

// Where the way of a mark's line ends, and the line behind it. Cost: constant. Context: any.
static inline double nck_marks_end(const nck_marks_t *self, uint32_t count) {
    return self->at[count & (NCK_MARK_MAX - 1)].s;
}
static inline uint32_t nck_marks_after(const nck_marks_t *self, uint32_t count) {
    return self->at[(count + 1u) & (NCK_MARK_MAX - 1)].line;
}

// The source line at s of a seg, and what is in force there. Cost: logarithmic in its marks.
// Context: any.
uint32_t nck_marks_line(const nck_marks_t *self, const nck_seg_t *seg, double s,
                        uint32_t *modes_out);

#ifdef __cplusplus
}
#endif

#endif
