// SPDX-License-Identifier: MIT
// What a program does, told in short words, so that a person can hold them against its lines. Used
// by the tests of rooms 1 and 2.
//
//     G20 G0 X1 Y2           1 rapid X25.4 Y50.8; 2 line X0 F254
//     G1 F10 X0
//
// A block has its line and its kind, and then only what is other than in the block before; before
// the first one the axes stand at 0, G94 is in force, and what the machine's own table has.
// Findings stand where they came: !line:column id letter value/limit of an error, ? of a note. The
// M2 that ends every text is not told, nor, unless asked for, are the notes on what a text leaves
// unsaid. ~ marks a move of a cycle that keeps to the path, whatever G64 says.
#ifndef TOLD_CHECK_H
#define TOLD_CHECK_H

#include <stdarg.h> // va_list
#include <stdio.h>  // vsnprintf
#include <string.h> // memset strlen

#include "check.h"
#include "nck/base/trig_math.h" // NCK_PI
#include "nck/prep/1_decode/decode.h" // nck_decode_t
#include "nck/prep/2_toolcomp/toolcomp.h" // nck_toolcomp_t

// A build that leaves something out refuses what these tables say; other tests hold what it says
// then.
#define TOLD_WHOLE                                                   \
    (NCK_HAS_CALLS && NCK_HAS_CONTOUR && NCK_HAS_LAYOUTS && NCK_HAS_COMP && NCK_AXIS_MAX == 9)

enum { TOLD_MAX = 8192, TOLD_TURNS = 4000 };

typedef struct told {
    nck_machine_t machine;
    nck_decode_t decode;
    nck_toolcomp_t toolcomp;
    int compensates; // 1: the blocks of room 2, 0: of room 1
    int reads;       // 1: the room reads the text itself, and so may jump back in it
    int hooked;      // 1: in pieces
    int bare;        // 1: no M2 stands behind the text, and what ends it is told
    int notes;       // 1: what a text leaves unsaid is told, too; 2: only that it has no end
    nck_block_t before;
    nck_block_t path; // told last of G61 and G64
    double feed;      // told last
    char program[TOLD_MAX];
    char text[TOLD_MAX];
    size_t size;
} told_t;

// A program and what it is told to do.
typedef struct told_row {
    const char *program;
    const char *told;
} told_row_t;

// A machine of the default, which speaks a language; its room reads the text itself where that is
// built.
static inline void told_begin(told_t *self, nck_dialect_t base) {
    memset(self, 0, sizeof *self);
    nck_machine_default(&self->machine);
    self->machine.dialect.base = base;
    self->reads = NCK_HAS_VARIABLES;
}

// It has three rotary axes more.
static inline void told_turns(told_t *self) {
    for (int k = NCK_AXIS_A; k <= NCK_AXIS_C && k < NCK_AXIS_MAX; k++) {
        self->machine.axis[k] = self->machine.axis[NCK_AXIS_X];
        self->machine.axis[k].rotary = 1;
    }
}

// It has an extruder, which a printer's E moves.
static inline void told_extruder(told_t *self) {
    const int u = NCK_AXIS_U;
    if (u < NCK_AXIS_MAX) self->machine.axis[u] = self->machine.axis[NCK_AXIS_X];
}

// It is a lathe.
static inline void told_lathe(told_t *self) {
    self->machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    self->machine.axis[NCK_AXIS_Y].present = 0;
    self->machine.dialect.plane = 18;
}

// It is a lathe of Fanuc's system A: X is a diameter, F is per revolution.
static inline void told_turning(told_t *self) {
    told_begin(self, NCK_DIALECT_FANUC);
    told_lathe(self);
    self->machine.dialect.system = NCK_SYSTEM_A;
    self->machine.dialect.diameter = 1;
    self->machine.dialect.feed = NCK_FEED_START_REV;
    self->machine.dialect.integers = NCK_INTEGERS_UNITS;
    self->machine.dialect.thread_pull = 0.0;
}

static inline void told_add(told_t *self, const char *format, ...) {
    va_list words;
    va_start(words, format);
    const size_t room = TOLD_MAX - self->size;
    const int size = vsnprintf(self->text + self->size, room, format, words);
    va_end(words);
    if (size > 0 && (size_t)size < room) self->size += (size_t)size;
}

// It has tools: their offsets, radii, wear of the radii, noses.
static inline void told_tools(told_t *self) {
    nck_tool_t *const tool = self->machine.tool;
    self->machine.tool_count = 4;
    tool[0] = (nck_tool_t){1, 0, {0, 0, 10000000}, 3.0, 0.5};
    tool[1] = (nck_tool_t){2, 0, {1000000, 2000000, 20000000}, 0.0, 0.0};
    tool[2] = (nck_tool_t){7, 3, {0, 0, 0}, 0.8, 0.0};
    tool[3] = (nck_tool_t){8, 0, {0, 0, 0}, 2.0, -0.25};
}

// Its axes have an end: X at -10 and 100, Y at -20 and 200, Z at -30 and 50.
static inline void told_bound(told_t *self) {
    static const int64_t ends_mm[3][2] = {{-10, 100}, {-20, 200}, {-30, 50}};
    for (int k = 0; k < 3; k++) {
        self->machine.axis[k].min_nm = ends_mm[k][0] * NCK_COUNTS_PER_MM;
        self->machine.axis[k].max_nm = ends_mm[k][1] * NCK_COUNTS_PER_MM;
    }
}

// A number of at most so many decimals: further ones go by how places were rounded.
static inline void told_rounded(told_t *self, double value, int decimals) {
    char text[40];
    int size = snprintf(text, sizeof text, "%.*f", decimals, value);
    while (size > 1 && text[size - 1] == '0') text[--size] = '\0';
    if (text[size - 1] == '.') text[--size] = '\0';
    told_add(self, " %s", strcmp(text, "-0") == 0 ? "0" : text);
}

// What is kept as a float: its last digits are nobody's.
static inline void told_float(told_t *self, const char *name, float now) {
    if (now < 0.0f || now > 0.0f) told_add(self, " %s %.6g", name, (double)now);
}

// A number that changed. Returns 1 if it did.
static inline int told_number(told_t *self, const char *name, double before, double now) {
    if (before <= now && before >= now) return 0;
    told_add(self, " %s%.9g", name, now + 0.0);
    return 1;
}

// A place to the last count, in whole units and their decimals.
static inline void told_place(told_t *self, char letter, int64_t count, int digits) {
    char decimals[24];
    uint64_t unit = 1;
    for (int k = 0; k < digits; k++) unit *= 10;
    const uint64_t size = count < 0 ? (uint64_t)-count : (uint64_t)count;
    snprintf(decimals, sizeof decimals, "%0*llu", digits, (unsigned long long)(size % unit));
    while (digits > 0 && decimals[digits - 1] == '0') decimals[--digits] = '\0';
    told_add(self, " %c%s%llu%s%s", letter, count < 0 ? "-" : "", (unsigned long long)(size / unit),
             digits > 0 ? "." : "", decimals);
}

static inline void told_places(told_t *self, const nck_block_t *now) {
    for (int k = 0; k < NCK_AXIS_MAX; k++) {
        if (now->target_nm[k] == self->before.target_nm[k]) continue;
        told_place(self, "XYZABCUVW"[k], now->target_nm[k], self->machine.axis[k].rotary ? 9 : 6);
    }
    for (int k = 0; k < 3; k++) {
        if (now->tool_nm[k] == self->before.tool_nm[k]) continue;
        told_add(self, " tool");
        told_place(self, "XYZ"[k], now->tool_nm[k], 6);
    }
}

// A cycle's moves keep to the path and are marked by ~; what G64 says counts behind them.
static inline void told_path(told_t *self, const nck_block_t *now) {
    static const char *const paths[] = {"exact", "stop", "smooth"};
    nck_block_t *const before = &self->path;
    if (now->path_mode == NCK_PATH_TURNS) {
        (void)told_number(self, "P", 0.0, now->tolerance_mm);
        (void)told_number(self, "Q", 0.0, now->merge_mm);
        return;
    }
    if (now->path_mode != before->path_mode) told_add(self, " %s", paths[now->path_mode]);
    (void)told_number(self, "P", before->tolerance_mm, now->tolerance_mm);
    (void)told_number(self, "Q", before->merge_mm, now->merge_mm);
    *before = *now;
}

static inline void told_modes(told_t *self, const nck_block_t *now) {
    static const char *const feeds[] = {"per-min", "inverse", "per-rev"};
    const nck_block_t *const before = &self->before;
    told_path(self, now);
    if (now->feed_mode != before->feed_mode) told_add(self, " %s", feeds[now->feed_mode]);
    (void)told_number(self, "S", before->spindle_rpm, now->spindle_rpm);
    (void)told_number(self, "V", before->surface, now->surface);
    (void)told_number(self, "axis", before->spindle_x_mm, now->spindle_x_mm);
}

static inline void told_shape(told_t *self, const nck_block_t *now) {
    const nck_thread_t *const thread = &now->thread;
    const nck_tap_t *const tap = &now->tap;
    if (now->kind == NCK_BLOCK_ARC) {
        told_add(self, " G%d about", now->plane);
        told_rounded(self, now->centre_mm[0], 5);
        told_rounded(self, now->centre_mm[1], 5);
        told_add(self, " by");
        told_rounded(self, now->sweep_rad * 180.0 / NCK_PI, 4);
    }
    if (now->kind == NCK_BLOCK_DWELL) told_add(self, " for %.9g", now->dwell_s);
    if (now->kind == NCK_BLOCK_THREAD) {
        told_add(self, " of %.9g lead %.9g", thread->length, thread->lead);
        (void)told_number(self, "in ", 0.0, thread->enter);
        told_float(self, "over", thread->entry);
        (void)told_number(self, "out ", 0.0, thread->leave);
        told_float(self, "over", thread->exit);
        told_float(self, "at", thread->turn);
        told_add(self, " for %.4g", (double)thread->duration);
    }
    if (now->kind == NCK_BLOCK_TAP) {
        told_add(self, " by %.9g %.9g %.9g lead %.9g", tap->way[0], tap->way[1], tap->way[2],
                 tap->lead);
        told_float(self, "dwell", tap->dwell);
        told_add(self, " for %.4g", (double)tap->duration);
    }
}

static inline void told_output(told_t *self, const nck_block_t *now) {
    static const char *const kinds[] = {"S", "M", "T", "surface ", "M", "digital ", "analogue ",
                                        "input "};
    const nck_output_t *const output = &now->output;
    const int has_number = output->kind >= NCK_OUTPUT_SETTING;
    if (now->kind == NCK_BLOCK_COMP) {
        told_add(self, " G%d %.9g nose %.9g %.9g", now->plane, output->value + 0.0,
                 now->centre_mm[0] + 0.0, now->centre_mm[1] + 0.0);
    } else if (now->kind == NCK_BLOCK_ENTRY) {
        told_add(self, " %u", (unsigned)output->number);
    } else if (now->kind >= NCK_BLOCK_WAIT && now->kind <= NCK_BLOCK_END) {
        told_add(self, " %s", kinds[output->kind]);
        if (has_number) told_add(self, "%u=", (unsigned)output->number);
        told_add(self, "%.9g", output->value);
    }
}

// The end behind the text.
static inline int told_is_last(const told_t *self, const nck_block_t *now) {
    uint32_t lines = 0;
    for (const char *at = self->program; *at; at++) lines += *at == '\n';
    return now->kind == NCK_BLOCK_END && now->line == lines && now->output.value == 2.0;
}

static inline void told_block(told_t *self, const nck_block_t *now) {
    static const char *const kinds[] = {"rapid", "line", "arc", "dwell", "wait", "out", "end",
                                        "comp", "thread", "tap", "entry"};
    if (!self->bare && told_is_last(self, now)) return;
    const int cuts = now->kind == NCK_BLOCK_LINE || now->kind == NCK_BLOCK_ARC
                     || (now->kind == NCK_BLOCK_ENTRY && now->output.number == NCK_WAY_IN);
    told_add(self, "%s%u %s%s", self->size > 0 ? "; " : "", (unsigned)now->line, kinds[now->kind],
             now->path_mode == NCK_PATH_TURNS ? "~" : "");
    told_output(self, now);
    told_places(self, now);
    told_shape(self, now);
    if (cuts && told_number(self, "F", self->feed, now->feed)) self->feed = now->feed;
    if (!cuts) (void)told_number(self, "F", 0.0, now->feed);
    told_modes(self, now);
    self->before = *now;
}

static inline void told_finding(told_t *self, const nck_diagnostic_t *finding) {
    const int unsaid = finding->code >= NCK_NOTE_UNITS && finding->code <= NCK_NOTE_ARC_CENTRE;
    if (unsaid && self->notes != 1) return;
    if (finding->code == NCK_NOTE_NO_END && self->notes == 0) return;
    const char *const id = nck_diagnostic_id(finding->code);
    told_add(self, "%s%c%u:%u %s", self->size > 0 ? "; " : "", finding->code < 0 ? '!' : '?',
             (unsigned)finding->line, (unsigned)finding->column, id);
    if (finding->letter != 0) told_add(self, " %c", (char)finding->letter);
    if (finding->value != 0.0 || finding->limit != 0.0) {
        told_add(self, " %.9g/%.9g", finding->value, finding->limit);
    }
}

static inline void told_findings(told_t *self) {
    nck_diagnostic_t finding;
    while (nck_decode_diagnostic(&self->decode, &finding) == NCK_OK) told_finding(self, &finding);
    while (nck_toolcomp_diagnostic(&self->toolcomp, &finding) == NCK_OK) {
        told_finding(self, &finding);
    }
}

static inline nck_status_t told_pull(told_t *self, nck_block_t *block) {
    if (!self->compensates) return nck_decode_pull(&self->decode, block);
    nck_status_t status = nck_toolcomp_pull(&self->toolcomp, block);
    if (status != NCK_EMPTY) return status;
    status = nck_decode_pull(&self->decode, block);
    if (status == NCK_OK) return nck_toolcomp_push(&self->toolcomp, block);
    if (status == NCK_DONE && nck_toolcomp_is_on(&self->toolcomp)) {
        nck_toolcomp_end(&self->toolcomp);
        return NCK_EMPTY;
    }
    return status;
}

// The state before a program.
static inline void told_reset(told_t *self) {
    memset(&self->before, 0, sizeof self->before);
    self->path.path_mode = NCK_PATH_CONTINUOUS;
    self->path.tolerance_mm = self->path.merge_mm = self->machine.path.tolerance;
    self->feed = self->machine.dialect.feed_default;
    self->size = 0;
    self->text[0] = '\0';
    nck_decode_init(&self->decode, &self->machine);
    nck_toolcomp_init(&self->toolcomp, &self->machine);
}

// A text that gives its bytes from any place, seven at a time at most.
static inline size_t told_read(void *user, size_t offset, char *out, size_t n) {
    const told_t *const self = user;
    const size_t left = strlen(self->program) - offset;
    const size_t most = n < 7 ? n : 7;
    const size_t count = left < most ? left : most;
    memcpy(out, self->program + offset, count);
    return count;
}

// Tell what a text and an M2 behind it do. Printers have no M2.
static inline void told_run(told_t *self, const char *text) {
    nck_block_t block;
    nck_status_t status = NCK_EMPTY;
    const int ends = self->bare || self->machine.dialect.base == NCK_DIALECT_MARLIN;
    const char *const tail = ends ? "" : "M2\n";
    const int size = snprintf(self->program, sizeof self->program, "%s%s", text, tail);
    size_t used = 0, n = size > 0 ? (size_t)size : 0;
    const nck_source_t in_place = {self->program, n, NULL, NULL};
    const nck_source_t pieces = {NULL, 0, told_read, self};
    const char *at = self->program;
    told_reset(self);
    if (self->reads) {
        (void)nck_decode_source(&self->decode, self->hooked ? &pieces : &in_place);
        n = 0;
    }
    for (int turn = 0; status != NCK_DONE && turn < TOLD_TURNS; turn++) {
        if (status == NCK_EMPTY && n > 0) {
            (void)nck_decode_push(&self->decode, at, n, &used);
            at += used;
            n -= used;
        } else if (status == NCK_EMPTY && !self->reads) {
            nck_decode_end(&self->decode);
        }
        status = told_pull(self, &block);
        told_findings(self);
        if (status == NCK_OK && self->compensates) nck_toolcomp_place(&self->toolcomp, &block);
        if (status == NCK_OK) told_block(self, &block);
    }
    if (status != NCK_DONE) told_add(self, "; never ends");
}

// The next part of what is told, and how long it is. A build that does not smooth tells so at the
// first tolerance, and no longer where one is too small: that is no part there.
static inline const char *told_part(const char *at, size_t *size_out) {
    for (;;) {
        at += strspn(at, "; ");
        *size_out = strcspn(at, ";");
        const char *const note = NCK_HAS_OPTIMAL ? NULL : strstr(at, " no-tolerance");
        if (note == NULL || note > at + *size_out) return at;
        at += *size_out;
    }
}

static inline int told_same(const char *got, const char *want) {
    size_t size, wanted;
    do {
        got = told_part(got, &size);
        want = told_part(want, &wanted);
        if (size != wanted || memcmp(got, want, size) != 0) return 0;
        got += size;
        want += size;
    } while (size > 0);
    return 1;
}

// Hold every program of a table against what it is told to do, read in place and in pieces.
static inline void told_check(check_t *check, told_t *self, const told_row_t *rows, size_t count) {
    for (size_t k = 0; k < 2 * count; k++) {
        const told_row_t *const row = &rows[k / 2];
        self->hooked = (int)(k % 2);
        told_run(self, row->program);
        const int same = told_same(self->text, row->told);
        if (check_that(check, same, row->program, __FILE__, __LINE__)) continue;
        printf("    got  %s\n    want %s\n", self->text, row->told);
    }
}

#define TOLD(check, self, rows) told_check((check), (self), (rows), sizeof(rows) / sizeof *(rows))

#endif
