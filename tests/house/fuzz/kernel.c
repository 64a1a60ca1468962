// SPDX-License-Identifier: MIT
// Fuzz target of the whole kernel: bytes fill a machine, then a program, an operator and a prep
// task of any pace. Either the machine is refused, or every prep step is bounded, every number
// finite, nothing jumps, and the run comes to its end where the program ends.
//
//     machine: slope, edits │ one byte for an operation, more for what it needs │ …
#include "nck/nck_tools.h" // nck_t

#include <math.h>   // isfinite fabs pow
#include <stdint.h> // uint8_t
#include <stdio.h>  // snprintf
#include <stdlib.h> // abort
#include <string.h> // memset

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum {
    TEXT_MAX = 32768,
    LINE_SIZE = 160,
    PREP_MOST = 20000,  // steps in a row without a tick or a byte: more than the rings can hold
    STILL_MOST = 200,   // ticks in a row in which nothing happens though something is left to do
    TICKS_MOST = 2000,  // of an input: a program may last for years
    EDITS_MOST = 8
};

// What is checked by abort has a name in the trace.
static void require(int condition) {
    if (!condition) abort();
}

// The rest of the bytes; behind their end they are 0.
typedef struct source {
    const uint8_t *at;
    size_t left;
} source_t;

typedef struct run {
    nck_machine_t machine;
    nck_t nck;
    source_t source;
    char text[TEXT_MAX];
    size_t size;   // of the text so far
    size_t used;   // of it, pushed
    size_t piece;  // bytes in a push
    size_t line;   // where the last line begins
    uint32_t hurry;// periods that a caller with a budget names; 0: it has none
    int complete;  // 1: no more text will come
    int aborted;
    int failed;    // 1: a program error has ended the path
    int sane;      // 1: the machine is one that may be built
    uint32_t word; // of the link, when its cells were last looked at
    uint32_t ticks;
    uint32_t still;
    nck_status_t status;
    nck_pose_t pose;
    nck_pose_t before;
} run_t;

static uint8_t byte_of(source_t *source) {
    if (source->left == 0) return 0;
    source->left--;
    return *source->at++;
}

// ---- the machine

// 10^low … 10^high.
static double decades(source_t *source, double low, double high) {
    return pow(10.0, low + (high - low) * (double)byte_of(source) / 255.0);
}

// Numbers that ought to be refused, or to be survived.
static double odd_number(source_t *source) {
    static const double odd[] = {0.0, -0.0, -1.0, 2.2e-308, 5e-324, 1e-100, 1e-30, 1e-12, 1e-9,
                                 1e-6, 1e-5, 1e-3, 0.1, 1.0, 1e3, 1e6, 1e9, 1e12,
                                 1.1e12, 1e18, 1e100, 1.7e308,
                                 (double)NAN, (double)INFINITY, -(double)INFINITY};
    const uint8_t n = byte_of(source);
    if (n < sizeof odd / sizeof odd[0]) return odd[n];
    return decades(source, -13.0, 13.0) * (1.0 + (double)n / 256.0);
}

static void edit(nck_machine_t *machine, source_t *source) {
    nck_axis_t *const axis = &machine->axis[byte_of(source) % 3];
    double *const numbers[] = {
        &machine->period_s, &machine->path.feed_max, &machine->path.a_max, &machine->path.j_max,
        &machine->path.chord_error, &machine->path.tolerance, &machine->path.arc_radius,
        &axis->v_max, &axis->rapid, &axis->a_max, &axis->j_max, &machine->dialect.feed_default,
        &machine->spindle.rpm_max};
    const uint8_t n = byte_of(source);
    if (n < 200) {
        *numbers[n % (sizeof numbers / sizeof numbers[0])] = odd_number(source);
        return;
    }
    uint8_t *const bytes = (uint8_t *)machine;
    const size_t at = (size_t)byte_of(source) << 8 | byte_of(source);
    for (int k = 0; k < 1 + n % 8; k++) bytes[(at + (size_t)k) % sizeof *machine] = byte_of(source);
}

static void scale_axis(nck_axis_t *axis, source_t *source) {
    axis->v_max = decades(source, 0.0, 3.0);
    axis->rapid = axis->v_max;
    axis->a_max = decades(source, 1.0, 4.5);
    axis->j_max = decades(source, 1.0, 6.0);
}

static void make_machine(run_t *self) {
    static const double periods[] = {1e-3, 1e-4, 2.5e-4, 4e-3, 1e-2, 1e-5, 0.1, 2e-3};
    nck_machine_t *const machine = &self->machine;
    source_t *const source = &self->source;
    nck_machine_default(machine);
    const uint8_t kind = byte_of(source);
    const uint8_t edits = byte_of(source);
    machine->slope = kind % 2u; // linear or jerk
    machine->period_s = periods[kind / 2 % 8];
    machine->dialect.feed_default = 1000.0;
    for (int x = 0; x < 3 && (edits & 64); x++) scale_axis(&machine->axis[x], source);
    if (edits & 32) {
        machine->path.feed_max = decades(source, 0.0, 3.0);
        machine->path.a_max = decades(source, 1.0, 4.5);
        machine->path.j_max = decades(source, 1.0, 6.0);
    }
    if (edits & 16) machine->lookahead_blocks = byte_of(source) % 40u;
    self->sane = !(edits & 128);
    for (int k = 0; k < edits % EDITS_MOST && !self->sane; k++) edit(machine, source);
}

// ---- the program

static void add_line(run_t *self, const char *line, size_t n) {
    if (self->complete || self->size + n + 1 > TEXT_MAX) return;
    self->line = self->size;
    memcpy(self->text + self->size, line, n);
    self->size += n;
    self->text[self->size] = '\n';
    self->size++;
}

// A length of whole nanometres from 1 nm to 1 m, either sign.
static double length_of(source_t *source, uint8_t scale) {
    static const double unit[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 8.0};
    return (double)(int8_t)byte_of(source) * unit[scale % 8];
}

static void add_move(run_t *self) {
    char line[LINE_SIZE];
    source_t *const source = &self->source;
    const uint8_t kind = byte_of(source);
    const double x = length_of(source, kind);
    const double y = length_of(source, kind);
    const double z = (kind & 8) ? length_of(source, kind >> 5) : 0.0;
    const int code = kind >> 4 & 1;
    int n;
    if (kind & 32) {
        n = snprintf(line, sizeof line, "G91 G%d X%.6f Y%.6f Z%.6f I%.6f J%.6f", 2 + code,
                     code ? x - y : x + y, code ? y + x : y - x, z, x, y);
    } else {
        n = snprintf(line, sizeof line, "G91 G%d X%.6f Y%.6f Z%.6f", (kind >> 4 & 3) != 3, x, y, z);
    }
    add_line(self, line, (size_t)n);
}

static void add_word(run_t *self) {
    static const char *const words[] = {
        "G61", "G61.1", "G64", "G64 P0.01", "G64 P1", "G64 P0.0005 Q0.1", "G93 F60", "G94 F3000",
        "G95 S600 M3 F0.1", "G9 G1 X0.001", "M0", "M1", "M8", "S500", "G4 P0.01", "G4 P0", "G20",
        "G21", "G18", "G17", "G19", "G90", "G92 X0", "M2", "G28", "G10 L2 P1 X1", "G43 H1", "T1 M6",
        "G40 G80", "G64 P100 Q100", "G0 X0", "%"};
    const char *const word = words[byte_of(&self->source) % (sizeof words / sizeof words[0])];
    add_line(self, word, strlen(word));
}

static void add_number(run_t *self) {
    static const char *const words[] = {"F%.6f", "G64 P%.6f", "G93 F%.6f", "G64 P0.1 Q%.6f",
                                        "G4 P%.6f", "S%.3f", "G1 X%.6f", "G2 I%.6f"};
    char line[LINE_SIZE];
    const char *const format = words[byte_of(&self->source) % 8];
    const int n = snprintf(line, sizeof line, format, decades(&self->source, -4.0, 4.5));
    add_line(self, line, (size_t)n);
}

static void add_again(run_t *self) {
    char line[LINE_SIZE];
    const size_t n = self->size - self->line;
    const uint8_t times = byte_of(&self->source);
    if (n == 0 || n > sizeof line) return;
    memcpy(line, self->text + self->line, n - 1);
    for (int k = 0; k < times % 64; k++) add_line(self, line, n - 1);
}

// Short lines round a circle: how long, how many, how sharp.
static void add_ring(run_t *self) {
    char line[LINE_SIZE];
    source_t *const source = &self->source;
    const uint8_t scale = byte_of(source);
    const double step = fabs(length_of(source, scale));
    const double turn = 3.2 * (double)byte_of(source) / 255.0;
    const int count = byte_of(source);
    for (int k = 0; k < count; k++) {
        const double angle = turn * (double)k;
        const int n = snprintf(line, sizeof line, "G91 G1 X%.6f Y%.6f", step * cos(angle),
                               step * sin(angle));
        add_line(self, line, (size_t)n);
    }
}

static void add_bytes(run_t *self) {
    char line[LINE_SIZE];
    const size_t n = byte_of(&self->source) % 32u;
    for (size_t k = 0; k < n; k++) line[k] = (char)byte_of(&self->source);
    add_line(self, line, n);
}

// ---- what must hold

static int all_finite(const double *numbers, int count) {
    for (int k = 0; k < count; k++) {
        if (!isfinite(numbers[k])) return 0;
    }
    return 1;
}

static void check_cell(const nck_cell_t *cell) {
    const double numbers[] = {cell->s, cell->length, cell->v, cell->a, cell->j, cell->duration};
    require(all_finite(numbers, 6));
    require(cell->s >= 0.0 && cell->length >= 0.0 && cell->v >= 0.0 && cell->duration >= 0.0);
    require(cell->length == 0.0 || cell->duration > 0.0);
}

static void check_node(void *user, const nck_node_t *node) {
    const double numbers[] = {node->s, node->length, node->a, node->a_over, node->j, node->j_over,
                              node->vv_piece, node->vv_over, node->vv_cap, node->vv_node, node->vv};
    (void)user;
    require(all_finite(numbers, 11));
    require(node->length >= 0.0 && node->a > 0.0 && node->j > 0.0 && node->vv >= 0.0);
}

static void check_seg(void *user, const nck_seg_t *seg) {
    const double numbers[] = {seg->length, seg->s_begin, seg->feed, seg->feed_scale};
    (void)user;
    require(all_finite(numbers, 4));
    for (int k = 0; k < 2; k++) require(all_finite(seg->shape.inner[k], NCK_AXIS_MAX)); // or an arc
    require(all_finite(seg->start, NCK_AXIS_MAX) && all_finite(seg->end, NCK_AXIS_MAX));
    require(seg->kind >= NCK_SEG_DWELL || seg->length > 0.0);
}

// Whatever the tick may take: the final cells and the tail behind them.
static void check_published(run_t *self) {
    const nck_link_t *const link = &self->nck.link;
    const uint32_t waiting = nck_link_waiting(link);
    if (link->word == self->word) return;
    self->word = link->word;
    for (uint32_t i = 0; i < waiting; i++) {
        check_cell(&link->cell[(link->taken + i) & (NCK_CELL_MAX - 1)]);
    }
    int entered = 0;
    const uint32_t end = nck_link_end(link, &entered);
    for (uint32_t i = 0; nck_link_tail_cell(link, end + i) != NULL; i++) {
        check_cell(nck_link_tail_cell(link, end + i));
    }
}

static void check_findings(run_t *self) {
    nck_diagnostic_t finding;
    while (nck_diagnostic(&self->nck, &finding) == NCK_OK) {
        require(isfinite(finding.value) && isfinite(finding.limit));
        require(finding.code != NCK_E_INTERNAL);
    }
}

// No axis jumps: twice its limit of speed is beyond doubt.
static void check_pose(run_t *self) {
    const nck_pose_t *const pose = &self->pose;
    require(all_finite(pose->axis, NCK_AXIS_MAX) && isfinite(pose->s) && isfinite(pose->v));
    require(isfinite(pose->feed));
    require(pose->v >= 0.0 && pose->state <= NCK_TICK_HOLD);
    const double rounding = 1e-9 + 1e-14 * pose->s;
    require(pose->s >= self->before.s - rounding);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double step = fabs(pose->axis[x] - self->before.axis[x]);
        const double most = 2.0 * self->machine.axis[x].v_max * self->machine.period_s;
        require(!self->machine.axis[x].present || step <= most + 2e-6);
    }
    self->before = *pose;
}

// ---- the run

// One step, and more text where it asks for it. Returns 1 if another one has something to do.
static int prep(run_t *self) {
    size_t used = 0;
    nck_t *const nck = &self->nck;
    self->status = nck_prep(nck);
    if (self->status < NCK_OK) self->failed = 1;
    require(self->status != NCK_E_INTERNAL);
    check_published(self);
    require(nck_decode_invariants(&nck->decode) && nck_smooth_invariants(&nck->smooth));
    require(nck_lookahead_invariants(&nck->lookahead));
    check_findings(self);
    if (self->status != NCK_EMPTY) return self->status <= NCK_OK;
    const size_t left = self->size - self->used;
    if (left == 0) {
        if (self->complete) nck_end(nck);
        else if (self->hurry > 0) nck_hurry(nck, self->hurry);
        return self->complete;
    }
    require(nck_push(nck, self->text + self->used, left < self->piece ? left : self->piece, &used)
            != NCK_E_STATE);
    self->used += used;
    return 1;
}

// Until there is nothing to do without a tick. A push takes one byte at least, so that text lasts.
static void prep_all(run_t *self) {
    const size_t used = self->used;
    for (size_t n = 0; prep(self); n++) require(n < PREP_MOST + (self->used - used));
}

static void tick(run_t *self) {
    nck_axes_t axes;
    const nck_tick_state_t state = nck_tick(&self->nck, &self->pose, &axes);
    require(state == (nck_tick_state_t)self->pose.state);
    check_pose(self);
    self->ticks++;
}

static void command(run_t *self) {
    nck_t *const nck = &self->nck;
    const uint8_t what = byte_of(&self->source);
    switch (what % 8) {
    case 0: nck_hold(nck); break;
    case 1: nck_resume(nck); break;
    case 2: nck_set_single_block(nck, what >> 3 & 1u); break;
    case 3: nck_set_override(nck, byte_of(&self->source) * NCK_PERCENT, what * NCK_PERCENT); break;
    case 4: nck_set_override(nck, (10u + what) * NCK_PERCENT, 100 * NCK_PERCENT); break;
    case 5: nck_set_override(nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT); break;
    case 6:
        self->complete |= what > 200;
        (void)nck_set_travel(nck, what >> 3 & 1u, -1000000 * (int64_t)byte_of(&self->source),
                             1000000 * (int64_t)byte_of(&self->source));
        break;
    default:
        if (what <= 220) {
            self->hurry = what >> 3;
            break;
        }
        self->aborted = 1;
        nck_abort(nck);
        break;
    }
}

static void operate(run_t *self) {
    const uint8_t what = byte_of(&self->source);
    switch (what & 15) {
    case 0: case 1: case 2: case 3: case 4: add_move(self); break;
    case 5: add_word(self); break;
    case 6: add_number(self); break;
    case 7: add_again(self); break;
    case 8: add_bytes(self); break;
    case 9: command(self); break;
    case 10: if (what & 16) self->piece = 1 + (what >> 5) * 8u; else add_ring(self); break;
    case 11: for (int n = 0; n <= what >> 4 && prep(self); n++) continue; break;
    case 12: prep_all(self); break;
    case 13: tick(self); break;
    case 14: for (int n = 0; n <= what >> 2; n++) tick(self); break;
    default:
        for (int n = 0; n <= what; n++) {
            prep_all(self);
            tick(self);
        }
        break;
    }
}

// The operator lets it go on, to the end.
static void release(run_t *self) {
    nck_t *const nck = &self->nck;
    nck_set_single_block(nck, 0);
    nck_set_override(nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    for (uint32_t x = 0; x < 2; x++) (void)nck_set_travel(nck, x, INT64_MIN, INT64_MAX);
    nck_resume(nck);
}

// Whether the tick has nothing in hand, and has not moved.
static int stands(const run_t *self, const nck_pose_t *before) {
    const nck_interpolate_t *const at = &self->nck.interpolate;
    const int moved = self->pose.seg != before->seg || self->pose.s > before->s;
    return !moved && !at->has_cell && at->filter.settle == 0;
}

static int is_over(const run_t *self) {
    return self->status == NCK_DONE && nck_is_idle(&self->nck);
}

static void check_end(const run_t *self) {
    if (self->failed || self->aborted) return;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        require(fabs(self->pose.axis[x] - self->nck.smooth.position[x]) < 1e-6);
    }
}

static void finish(run_t *self) {
    self->complete = 1;
    release(self);
    while (self->ticks < TICKS_MOST) {
        const nck_pose_t before = self->pose;
        prep_all(self);
        tick(self);
        if (is_over(self)) {
            check_end(self);
            return;
        }
        const int rests = self->pose.state == NCK_TICK_WAIT || self->pose.state == NCK_TICK_HOLD;
        if (rests) nck_resume(&self->nck);
        self->still = stands(self, &before) ? self->still + 1 : 0;
        require(self->still < STILL_MOST);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static run_t self;
    static const char begin[] = "G21 G17 G91.1 G90 G1 F3000";
    const nck_hooks_t hooks = {NULL, NULL, check_node, check_seg};

    memset(&self, 0, sizeof self);
    self.source.at = data;
    self.source.left = size;
    self.piece = 64;
    make_machine(&self);
    if (nck_init(&self.nck, &self.machine, &hooks) != NCK_OK) {
        require(nck_machine_check(&self.machine) == NCK_E_MACHINE);
        return 0;
    }
    memcpy(self.before.axis, self.nck.interpolate.pose.axis, sizeof self.before.axis);
    add_line(&self, begin, sizeof begin - 1);
    while (self.source.left > 0 && self.ticks < TICKS_MOST) operate(&self);
    finish(&self);
    return 0;
}
