// SPDX-License-Identifier: MIT
// Fuzz target of room 1: any bytes, pushed in pieces of any size, give the same blocks and
// findings, and all of them are finite and within their ranges.
#include "nck/prep/1_decode/decode.h" // nck_decode_t

#include <math.h>   // isfinite
#include <stdint.h> // uint8_t
#include <stdlib.h> // abort
#include <string.h> // memcmp

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// Pulls of a text that jumps; of one that has a million holes drilled.
enum { STEPS_MOST = 3000, PULLS_MOST = 100000 };

// One decoder and the text that it still has to read.
typedef struct reader {
    nck_decode_t decode;
    const char *text;
    size_t size;
    size_t piece; // bytes in a push
    int ended;
    uint32_t error_line;
} reader_t;

static void require(int condition) {
    if (!condition) abort();
}

// Push until a block or an error comes out. Returns what pull said last.
static nck_status_t next(reader_t *reader, nck_block_t *block) {
    nck_status_t status = nck_decode_pull(&reader->decode, block);
    while (status == NCK_EMPTY) {
        size_t used = 0;
        require(nck_decode_invariants(&reader->decode));
        require(!reader->ended);
        if (reader->size == 0) {
            nck_decode_end(&reader->decode);
            reader->ended = 1;
        } else {
            const size_t n = reader->size < reader->piece ? reader->size : reader->piece;
            require(nck_decode_push(&reader->decode, reader->text, n, &used) == NCK_OK);
            require(used >= 1 && used <= n);
        }
        reader->text += used;
        reader->size -= used;
        status = nck_decode_pull(&reader->decode, block);
    }
    require(nck_decode_invariants(&reader->decode));
    return status;
}

// Behind the end both take what is left, and both see whether it is text.
static void drop_rest(reader_t *reader) {
    while (reader->size > 0 && !reader->ended) {
        size_t used = 0;
        const size_t n = reader->size < reader->piece ? reader->size : reader->piece;
        require(nck_decode_push(&reader->decode, reader->text, n, &used) == NCK_OK);
        require(used == n);
        reader->text += used;
        reader->size -= used;
    }
}

// A block has the number of its line; at a corner the line before it is only given now.
static int has_its_line(const nck_decode_t *decode, const nck_block_t *block) {
    const nck_corner_t *const corner = &decode->held.corner;
    const int at_corner = corner->phase != NCK_CORNER_NOT && block->line == corner->line;
    return at_corner || block->line == decode->line.tag;
}

static void check_block(const nck_decode_t *decode, const nck_block_t *block) {
    const double numbers[] = {block->centre_mm[0], block->centre_mm[1], block->sweep_rad,
                              block->feed, block->spindle_rpm, block->tolerance_mm,
                              block->merge_mm, block->dwell_s, block->output.value};
    for (size_t k = 0; k < sizeof numbers / sizeof numbers[0]; k++) require(isfinite(numbers[k]));
    require(block->kind <= NCK_BLOCK_TAP && has_its_line(decode, block));
    for (int k = 0; k < 3; k++) require(isfinite(block->tap.way[k]));
    require(isfinite(block->tap.lead) && isfinite(block->tap.duration));
    require(block->feed >= 0.0 && block->dwell_s >= 0.0);
    if (block->kind == NCK_BLOCK_LINE || block->kind == NCK_BLOCK_ARC) require(block->feed > 0.0);
    if (block->kind == NCK_BLOCK_ARC) require(fabs(block->sweep_rad) > 0.0);
}

static void check_finding(reader_t *reader, const nck_diagnostic_t *finding) {
    require(isfinite(finding->value) && isfinite(finding->limit));
    require(finding->column <= NCK_LINE_MAX + 1);
    // A cycle's own mistake is told behind those of its contour, and a corner's own once the move
    // behind it is missed: refused lines may stand between.
    const int follows = reader->decode.machine->kinematics == NCK_KINEMATICS_LATHE_XZ
                        || finding->code == NCK_E_CORNER;
    require(finding->code > 0 || follows || reader->error_line < finding->line
            || finding->line == 0);
    if (finding->code < 0) reader->error_line = finding->line;
}

static void init(reader_t *reader, const nck_machine_t *machine, const char *text, size_t size) {
    memset(reader, 0, sizeof *reader);
    nck_decode_init(&reader->decode, machine);
    reader->text = text;
    reader->size = size;
}

// The same text, read by the room itself: whatever it jumps to, it ends, or gives blocks for ever.
static void read_in_place(const nck_machine_t *machine, const char *text, size_t size) {
    static reader_t reader;
    const nck_source_t source = {text, size, NULL, NULL};
    nck_block_t block;
    nck_diagnostic_t finding;
    init(&reader, machine, NULL, 0);
    require(nck_decode_source(&reader.decode, &source) == NCK_OK);
    for (int k = 0; k < STEPS_MOST; k++) {
        const nck_status_t status = nck_decode_pull(&reader.decode, &block);
        require(nck_decode_invariants(&reader.decode));
        while (nck_decode_diagnostic(&reader.decode, &finding) == NCK_OK) {
            require(isfinite(finding.value) && isfinite(finding.limit));
            require(finding.column <= NCK_LINE_MAX + 1);
        }
        if (status == NCK_DONE) return;
    }
}

// The first byte chooses the machine and the second the size of the pieces.
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static nck_machine_t machine;
    static reader_t whole, pieces;
    nck_block_t block, same;
    nck_diagnostic_t finding, again;
    nck_status_t status = NCK_OK;

    if (size < 2) return 0;
    nck_machine_default(&machine);
    machine.dialect.base = data[0] & 3u;
    machine.axis[NCK_AXIS_Y].present = (data[0] & 4u) == 0;
    machine.dialect.feed_default = (data[0] & 16u) ? 1000.0 : 0.0;
    machine.axis[NCK_AXIS_X].max_nm = (data[0] & 32u) ? 100000000 : INT64_MAX;
    if (NCK_AXIS_MAX > NCK_AXIS_Z + 1) {
        machine.axis[NCK_AXIS_Z + 1].present = (data[0] & 8u) != 0;
        machine.axis[NCK_AXIS_MAX - 3] = machine.axis[NCK_AXIS_X];
        machine.axis[NCK_AXIS_MAX - 3].present = (data[0] & 64u) != 0;
    }
    machine.dialect.integers = (data[0] & 8u) ? NCK_INTEGERS_INCREMENTS : NCK_INTEGERS_OPEN;
    machine.dialect.d_offset = (data[0] & 16u) ? NCK_D_DIAMETER : NCK_D_OPEN;
    machine.dialect.probe = (data[0] & 16u) ? NCK_PROBE_TOUCHES : NCK_PROBE_MISSES;
    machine.dialect.scale_unit = (data[0] & 16u) ? 0.001 : 0.0;
    if (data[0] & 128u) machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    machine.tool_count = 2;
    machine.tool[0].number = 1;
    machine.tool[0].offset_nm[2] = 123456789;
    machine.tool[1].number = 7;
    require(nck_machine_check(&machine) == NCK_OK);
    init(&whole, &machine, (const char *)data + 2, size - 2);
    init(&pieces, &machine, (const char *)data + 2, size - 2);
    whole.piece = size;
    pieces.piece = 1 + data[1] % 64u;
    for (int k = 0; status != NCK_DONE; k++) {
        if (k == PULLS_MOST) return 0;
        memset(&block, 0, sizeof block);
        memset(&same, 0, sizeof same);
        status = next(&whole, &block);
        require(status == next(&pieces, &same));
        if (status == NCK_OK) check_block(&whole.decode, &block);
        if (status == NCK_OK) require(memcmp(&block, &same, sizeof block) == 0);
        if (status == NCK_DONE) drop_rest(&whole);
        if (status == NCK_DONE) drop_rest(&pieces);
        while (nck_decode_diagnostic(&whole.decode, &finding) == NCK_OK) {
            require(nck_decode_diagnostic(&pieces.decode, &again) == NCK_OK);
            require(memcmp(&finding, &again, sizeof finding) == 0);
            check_finding(&whole, &finding);
        }
    }
    require(nck_decode_pull(&whole.decode, &block) == NCK_DONE);
    if (NCK_HAS_CALLS) read_in_place(&machine, (const char *)data + 2, size - 2);
    return 0;
}
