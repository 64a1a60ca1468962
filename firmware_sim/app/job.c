// SPDX-License-Identifier: MIT
// A job: statements of a line each.
#include "app/job.h"

#include <string.h> // memset

#include "app/number.h"  // app_word_t
#include "app/setting.h" // app_setting

enum { WORDS = 6 }; // of a statement at most

typedef struct words {
    app_word_t word[WORDS];
    uint32_t count;
} words_t;

// Commands in the order of app_command_kind_t: how many numbers they take, and their ranges.
static const struct {
    const char *name;
    uint32_t arguments;
    int64_t least, most;
} commands[APP_COMMAND_KINDS] = {
    {"hold", 0, 0, 0},
    {"resume", 0, 0, 0},
    {"override", 2, 0, 200},
    {"single_block", 1, 0, 1},
    {"abort", 0, 0, 0},
    {"estop", 0, 0, 0},
    {"travel", 3, INT64_MIN, INT64_MAX},
    {"feeder_pause", 1, 1, UINT32_MAX},
    {"tick_work", 2, 1, UINT32_MAX},
    {"stack_work", 1, 0, UINT32_MAX},
    {"task_work", 2, 0, UINT32_MAX},
    {"masked_work", 2, 0, UINT32_MAX},
    {"trap", 1, 0, UINT32_MAX},
};

static const struct {
    const char *name;
    size_t offset;
} conditions[] = {
    {"prep_steps", offsetof(app_job_t, prep_steps)},
    {"prep_units", offsetof(app_job_t, prep_units)},
    {"tick_units", offsetof(app_job_t, tick_units)},
    {"feeder_units", offsetof(app_job_t, feeder_units)},
    {"wait_ticks", offsetof(app_job_t, wait_ticks)},
    {"starve_ticks", offsetof(app_job_t, starve_ticks)},
    {"max_ticks", offsetof(app_job_t, max_ticks)},
    {"trace", offsetof(app_job_t, trace)},
};

// Split a line at its spaces. Returns 0 if there are more than WORDS words.
static int split(const char *line, size_t n, words_t *words) {
    words->count = 0;
    for (size_t k = 0; k < n; k++) {
        const int space = line[k] == ' ' || line[k] == '\r';
        const int begins = !space && (k == 0 || line[k - 1] == ' ');
        if (space) continue;
        if (begins) {
            if (words->count == WORDS) return 0;
            words->word[words->count].at = line + k;
            words->word[words->count].length = 0;
            words->count++;
        }
        words->word[words->count - 1].length++;
    }
    return 1;
}

static app_job_status_t take_setting(app_job_t *job, const words_t *words) {
    int64_t row = 0, column = 0;
    if (words->count != 5) return APP_JOB_E_COUNT;
    if (!app_integer(&words->word[2], &row) || !app_integer(&words->word[3], &column)) {
        return APP_JOB_E_NUMBER;
    }
    switch (app_setting(&job->machine, &words->word[1], row, column, &words->word[4])) {
    case APP_SETTING_OK: return APP_JOB_OK;
    case APP_SETTING_E_NAME: return APP_JOB_E_WORD;
    default: return APP_JOB_E_NUMBER;
    }
}

// A whole number of 32 bits.
static int counting_number(const app_word_t *word, uint32_t *value_out) {
    int64_t value = 0;
    if (!app_integer(word, &value) || value < 0 || value > (int64_t)UINT32_MAX) return 0;
    *value_out = (uint32_t)value;
    return 1;
}

static app_job_status_t take_condition(app_job_t *job, const words_t *words) {
    for (size_t k = 0; k < sizeof conditions / sizeof conditions[0]; k++) {
        if (!app_word_is(&words->word[0], conditions[k].name)) continue;
        uint32_t value = 0;
        if (words->count != 2) return APP_JOB_E_COUNT;
        if (!counting_number(&words->word[1], &value)) return APP_JOB_E_NUMBER;
        memcpy((uint8_t *)job + conditions[k].offset, &value, sizeof value);
        return APP_JOB_OK;
    }
    return APP_JOB_E_WORD;
}

static app_job_status_t take_arguments(const words_t *words, app_command_t *command) {
    if (words->count != 3 + commands[command->kind].arguments) return APP_JOB_E_COUNT;
    for (uint32_t k = 0; k < commands[command->kind].arguments; k++) {
        int64_t *const value = &command->argument[k];
        if (!app_integer(&words->word[3 + k], value)) return APP_JOB_E_NUMBER;
        if (*value < commands[command->kind].least || *value > commands[command->kind].most) {
            return APP_JOB_E_NUMBER;
        }
    }
    return APP_JOB_OK;
}

static app_job_status_t take_command(app_job_t *job, const words_t *words) {
    if (words->count < 3 || job->command_count == APP_JOB_COMMANDS) return APP_JOB_E_COUNT;
    app_command_t *const command = &job->command[job->command_count];
    memset(command, 0, sizeof *command);
    if (!counting_number(&words->word[1], &command->tick)) return APP_JOB_E_NUMBER;
    if (job->command_count > 0 && command->tick < command[-1].tick) return APP_JOB_E_ORDER;
    while (command->kind < APP_COMMAND_KINDS
           && !app_word_is(&words->word[2], commands[command->kind].name)) {
        command->kind++;
    }
    if (command->kind == APP_COMMAND_KINDS) return APP_JOB_E_WORD;
    const app_job_status_t status = take_arguments(words, command);
    if (status == APP_JOB_OK) job->command_count++;
    return status;
}

void app_job_init(app_job_t *job) {
    memset(job, 0, sizeof *job);
    job->wait_ticks = 1;
}

app_job_status_t app_job_line(app_job_t *job, const char *line, size_t n) {
    words_t words;
    if (n > APP_JOB_LINE_MAX) return APP_JOB_E_LENGTH;
    if (n > 0 && line[0] == '#') return APP_JOB_OK;
    if (!split(line, n, &words)) return APP_JOB_E_COUNT;
    if (words.count == 0) return APP_JOB_OK;
    if (app_word_is(&words.word[0], "set")) return take_setting(job, &words);
    if (app_word_is(&words.word[0], "at")) return take_command(job, &words);
    return take_condition(job, &words);
}
