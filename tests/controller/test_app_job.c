// SPDX-License-Identifier: MIT
// The firmware's job: numbers read exactly, settings in their places, commands in order, and
// nothing taken that is not one.
#include <stdint.h> // INT64_MAX
#include <string.h> // strlen

#include "app/job.h"     // app_job_line
#include "app/number.h"  // app_real
#include "app/setting.h" // app_setting
#include "check.h"

static int integer(const char *text, int64_t *value_out)
{
    const app_word_t word = {text, (uint32_t)strlen(text)};
    return app_integer(&word, value_out);
}

static int real(const char *text, double *value_out)
{
    const app_word_t word = {text, (uint32_t)strlen(text)};
    return app_real(&word, value_out);
}

static app_job_status_t line(app_job_t *job, const char *text)
{
    return app_job_line(job, text, strlen(text));
}

static void integers_are_read_to_their_last_bit(check_t *check)
{
    int64_t value = 0;
    CHECK(check, integer("0", &value) && value == 0);
    CHECK(check, integer("-17", &value) && value == -17);
    CHECK(check, integer("9223372036854775807", &value) && value == INT64_MAX);
    CHECK(check, integer("-9223372036854775808", &value) && value == INT64_MIN);
    CHECK(check, !integer("9223372036854775808", &value));
    CHECK(check, !integer("-9223372036854775809", &value));
    CHECK(check, !integer("99999999999999999999", &value));
    CHECK(check, !integer("", &value) && !integer("-", &value) && !integer("1.5", &value));
}

static void reals_are_read_to_their_last_bit(check_t *check)
{
    double value = 0.0;
    CHECK(check, real("0x1.0624dd2f1a9fcp-10", &value) && value == 1e-3);
    CHECK(check, real("-0x1.921fb54442d18p+1", &value) && value == -3.141592653589793);
    CHECK(check, real("0x1.fffffffffffffp+1023", &value) && value == 1.7976931348623157e308);
    CHECK(check, real("0x1.0000000000000p-1022", &value) && value == 2.2250738585072014e-308);
    CHECK(check, real("0x0.0p+0", &value) && value == 0.0);
    CHECK(check, real("-250", &value) && value == -250.0);
}

static void what_is_no_real_or_not_exact_is_refused(check_t *check)
{
    static const char *const wrong[] = {
        "", "-", "0x", "0x1.8", "0x1.8p", "0xp+1", "0x1.8p+", "0x1..8p+1", "0x1.8p+1x", "1.5",
        "nan", "inf", "0x1.0000000000000p+1024", "0x1.0000000000000p-1023", "0x1.00000000000001p+0",
        "0x1.8p+99999999999", "0X1.8P+1"};
    double value = 7.0;
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; k++) {
        CHECK(check, !real(wrong[k], &value));
    }
    CHECK(check, value == 7.0);
}

static void settings_find_their_places(check_t *check)
{
    static app_job_t job;
    app_job_init(&job);
    CHECK_INT(check, line(&job, "set period_s 0 0 0x1.0624dd2f1a9fcp-10"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set axis.v_max 2 0 0x1.9p+6"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set axis.present 1 0 1"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set axis.min_nm 0 0 -5000000"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set home_nm 1 2 77"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set work_nm 8 1 78"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set start_nm 2 0 79"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set tool.offset_nm 3 2 80"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set dialect.plane 0 0 18"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "set slope 0 0 1"), APP_JOB_OK);
    CHECK(check, job.machine.period_s == 1e-3);
    CHECK(check, job.machine.axis[2].v_max == 100.0);
    CHECK_INT(check, job.machine.axis[1].present, 1);
    CHECK_INT(check, job.machine.axis[0].min_nm, -5000000);
    CHECK_INT(check, job.machine.home_nm[1][2], 77);
    CHECK_INT(check, job.machine.work_nm[8][1], 78);
    CHECK_INT(check, job.machine.start_nm[2], 79);
    CHECK_INT(check, job.machine.tool[3].offset_nm[2], 80);
    CHECK_INT(check, job.machine.dialect.plane, 18);
    CHECK_INT(check, job.machine.slope, 1);
}

static void settings_stay_inside_of_the_machine(check_t *check)
{
    static app_job_t job, before;
    app_job_init(&job);
    before = job;
    CHECK_INT(check, line(&job, "set axis.v_max -1 0 1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set axis.v_max 9 0 1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set axis.v_max 0 1 1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set tool.offset_nm 0 3 1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set work_nm 9 0 1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set dialect.plane 0 0 256"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set slope 0 0 -1"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set slope 0 0 4294967296"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set start_nm 0 0 0x1.8p+0"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "set speed 0 0 1"), APP_JOB_E_WORD);
    CHECK_INT(check, line(&job, "set period_s 0 1"), APP_JOB_E_COUNT);
    CHECK_INT(check, memcmp(&job, &before, sizeof job), 0);
}

static void commands_come_in_the_order_of_their_ticks(check_t *check)
{
    static app_job_t job;
    app_job_init(&job);
    CHECK_INT(check, line(&job, "at 10 hold"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "at 10 override 50 100"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "at 12 travel 0 -5 7\r"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "at 11 resume"), APP_JOB_E_ORDER);
    CHECK_INT(check, line(&job, "at -1 resume"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "at 12 override 50"), APP_JOB_E_COUNT);
    CHECK_INT(check, line(&job, "at 12 override 50 201"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "at 12 hold 1"), APP_JOB_E_COUNT);
    CHECK_INT(check, line(&job, "at 12 fly"), APP_JOB_E_WORD);
    CHECK_INT(check, line(&job, "at 12"), APP_JOB_E_COUNT);
    CHECK_INT(check, job.command_count, 3);
    CHECK_INT(check, job.command[1].kind, APP_OVERRIDE);
    CHECK_INT(check, job.command[1].argument[0], 50);
    CHECK_INT(check, job.command[2].tick, 12);
    CHECK_INT(check, job.command[2].argument[1], -5);
    CHECK_INT(check, job.command[2].argument[2], 7);
}

static void a_job_holds_so_many_commands_and_no_more(check_t *check)
{
    static app_job_t job;
    app_job_init(&job);
    for (int k = 0; k < APP_JOB_COMMANDS; k++) {
        CHECK_INT(check, line(&job, "at 5 hold"), APP_JOB_OK);
    }
    CHECK_INT(check, line(&job, "at 5 hold"), APP_JOB_E_COUNT);
    CHECK_INT(check, job.command_count, APP_JOB_COMMANDS);
}

static void conditions_are_counts(check_t *check)
{
    static app_job_t job;
    app_job_init(&job);
    CHECK_INT(check, job.wait_ticks, 1);
    CHECK_INT(check, line(&job, "# a comment, and an empty line"), APP_JOB_OK);
    CHECK_INT(check, line(&job, ""), APP_JOB_OK);
    CHECK_INT(check, line(&job, "  prep_steps   4 "), APP_JOB_OK);
    CHECK_INT(check, line(&job, "max_ticks 4294967295"), APP_JOB_OK);
    CHECK_INT(check, line(&job, "max_ticks 4294967296"), APP_JOB_E_NUMBER);
    CHECK_INT(check, line(&job, "prep_steps"), APP_JOB_E_COUNT);
    CHECK_INT(check, line(&job, "prep_steps 5 6"), APP_JOB_E_COUNT);
    CHECK_INT(check, line(&job, "prep_step 4"), APP_JOB_E_WORD);
    CHECK_INT(check, line(&job, "a b c d e f g"), APP_JOB_E_COUNT);
    char longer[APP_JOB_LINE_MAX + 1];
    memset(longer, '#', sizeof longer);
    CHECK_INT(check, app_job_line(&job, longer, sizeof longer), APP_JOB_E_LENGTH);
    CHECK_INT(check, job.prep_steps, 4);
    CHECK_INT(check, job.max_ticks, 4294967295);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, integers_are_read_to_their_last_bit);
    CHECK_RUN(&check, reals_are_read_to_their_last_bit);
    CHECK_RUN(&check, what_is_no_real_or_not_exact_is_refused);
    CHECK_RUN(&check, settings_find_their_places);
    CHECK_RUN(&check, settings_stay_inside_of_the_machine);
    CHECK_RUN(&check, commands_come_in_the_order_of_their_ticks);
    CHECK_RUN(&check, a_job_holds_so_many_commands_and_no_more);
    CHECK_RUN(&check, conditions_are_counts);
    return check_end(&check);
}
