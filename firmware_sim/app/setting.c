// SPDX-License-Identifier: MIT
// Which numbers a machine has, and where they stand in nck_machine_t.
#include "app/setting.h"

#include <stddef.h> // offsetof
#include <string.h> // memcpy

typedef enum kind { REAL, INTEGER, WORD, HALF, BYTE } kind_t;

typedef struct setting {
    const char *name;
    kind_t kind;
    size_t offset;
    int64_t rows, columns;
    size_t row_size; // from one row to the next
} setting_t;

#define MACHINE ((nck_machine_t *)0)
#define ONE(member, kind) {#member, kind, offsetof(nck_machine_t, member), 1, 1, 0}
#define LIST(member, kind) \
    {#member, kind, offsetof(nck_machine_t, member), \
     (int64_t)(sizeof MACHINE->member / sizeof MACHINE->member[0]), 1, sizeof MACHINE->member[0]}
#define TABLE(member, kind) \
    {#member, kind, offsetof(nck_machine_t, member), \
     (int64_t)(sizeof MACHINE->member / sizeof MACHINE->member[0]), \
     (int64_t)(sizeof MACHINE->member[0] / sizeof MACHINE->member[0][0]), \
     sizeof MACHINE->member[0]}
#define RECORDS(list, member, kind) \
    {#list "." #member, kind, offsetof(nck_machine_t, list[0].member), \
     (int64_t)(sizeof MACHINE->list / sizeof MACHINE->list[0]), 1, sizeof MACHINE->list[0]}

static const setting_t settings[] = {
    ONE(period_s, REAL),
    RECORDS(axis, present, BYTE),
    RECORDS(axis, rotary, BYTE),
    RECORDS(axis, v_max, REAL),
    RECORDS(axis, rapid, REAL),
    RECORDS(axis, a_max, REAL),
    RECORDS(axis, j_max, REAL),
    RECORDS(axis, min_nm, INTEGER),
    RECORDS(axis, max_nm, INTEGER),
    ONE(path.feed_max, REAL),
    ONE(path.a_max, REAL),
    ONE(path.j_max, REAL),
    ONE(path.chord_error, REAL),
    ONE(path.tolerance, REAL),
    ONE(path.arc_radius, REAL),
    ONE(lookahead_blocks, WORD),
    ONE(slope, WORD),
    ONE(kinematics, WORD),
    ONE(dialect.base, WORD),
    ONE(dialect.diameter, BYTE),
    ONE(dialect.inch, BYTE),
    ONE(dialect.plane, BYTE),
    ONE(dialect.arc_absolute, BYTE),
    ONE(dialect.block_skip, BYTE),
    ONE(dialect.optional_stop, BYTE),
    ONE(dialect.system, BYTE),
    ONE(dialect.feed, BYTE),
    ONE(dialect.d_offset, BYTE),
    ONE(dialect.probe, BYTE),
    ONE(dialect.integers, BYTE),
    ONE(dialect.comp_start, BYTE),
    ONE(dialect.skip_switches, WORD),
    ONE(dialect.from_line, WORD),
    ONE(dialect.feed_default, REAL),
    ONE(dialect.scale_unit, REAL),
    ONE(dialect.thread_pull, REAL),
    ONE(spindle.rpm_max, REAL),
    ONE(spindle.a_max_rpm_s, REAL),
    ONE(approach.height_nm, INTEGER),
    ONE(approach.feed, REAL),
    ONE(approach.axis, WORD),
    LIST(start_nm, INTEGER),
    TABLE(home_nm, INTEGER),
    ONE(home_more, WORD),
    ONE(roams, BYTE),
    ONE(firmware, BYTE),
    ONE(spindle_waits, HALF),
    NCK_IF_VARIABLES(ONE(clock.date, WORD), ONE(clock.time, WORD), ONE(clock.on_ms, WORD),
                     ONE(clock.cut_s, WORD), )
    TABLE(work_nm, INTEGER),
    ONE(work_system, WORD),
    ONE(tool_count, WORD),
    RECORDS(tool, number, WORD),
    RECORDS(tool, orientation, WORD),
    {"tool.offset_nm", INTEGER, offsetof(nck_machine_t, tool[0].offset_nm),
     (int64_t)(sizeof MACHINE->tool / sizeof MACHINE->tool[0]), 3, sizeof MACHINE->tool[0]},
    RECORDS(tool, radius_mm, REAL),
    RECORDS(tool, wear_mm, REAL),
    ONE(own_m_count, WORD),
    RECORDS(own_m, code, HALF),
    RECORDS(own_m, waits, BYTE),
    RECORDS(own_m, stays, BYTE),
    ONE(own_g_count, WORD),
    RECORDS(own_g, tolerance, REAL),
    RECORDS(own_g, value, WORD),
    RECORDS(own_g, code, HALF),
    RECORDS(own_g, letter, BYTE),
    RECORDS(own_g, action, BYTE),
    ONE(work_more_count, WORD),
    {"work_more.zero_nm", INTEGER, offsetof(nck_machine_t, work_more[0].zero_nm),
     (int64_t)(sizeof MACHINE->work_more / sizeof MACHINE->work_more[0]), NCK_AXIS_MAX,
     sizeof MACHINE->work_more[0]},
    RECORDS(work_more, number, WORD),
    NCK_IF_VARIABLES(ONE(clock.date, WORD), ONE(clock.time, WORD),)
};

static const setting_t *find(const app_word_t *name) {
    for (size_t k = 0; k < sizeof settings / sizeof settings[0]; k++) {
        if (app_word_is(name, settings[k].name)) return &settings[k];
    }
    return NULL;
}

static size_t size_of(kind_t kind) {
    static const size_t sizes[] = {sizeof(double), sizeof(int64_t), sizeof(uint32_t),
                                   sizeof(uint16_t), 1};
    return sizes[kind];
}

static int store(void *place, kind_t kind, const app_word_t *word) {
    double real = 0.0;
    int64_t integer = 0;
    if (kind == REAL) {
        if (!app_real(word, &real)) return 0;
        memcpy(place, &real, sizeof real);
        return 1;
    }
    if (!app_integer(word, &integer)) return 0;
    const uint32_t word_of = (uint32_t)integer;
    const uint16_t half = (uint16_t)integer;
    const uint8_t byte = (uint8_t)integer;
    switch (kind) {
    case WORD: memcpy(place, &word_of, sizeof word_of); return integer == (int64_t)word_of;
    case HALF: memcpy(place, &half, sizeof half); return integer == (int64_t)half;
    case BYTE: memcpy(place, &byte, sizeof byte); return integer == (int64_t)byte;
    default: memcpy(place, &integer, sizeof integer); return 1;
    }
}

app_setting_status_t app_setting(nck_machine_t *machine, const app_word_t *name, int64_t row,
                                 int64_t column, const app_word_t *value) {
    const setting_t *const setting = find(name);
    if (!setting) return APP_SETTING_E_NAME;
    if (row < 0 || row >= setting->rows || column < 0 || column >= setting->columns) {
        return APP_SETTING_E_INDEX;
    }
    uint8_t *const place = (uint8_t *)machine + setting->offset + (size_t)row * setting->row_size
                           + (size_t)column * size_of(setting->kind);
    return store(place, setting->kind, value) ? APP_SETTING_OK : APP_SETTING_E_VALUE;
}
