// SPDX-License-Identifier: MIT
// Room 1: numbers are read exactly and rounded half to even, whatever their length.
#include <stdint.h> // INT64_MIN
#include <stdio.h>  // snprintf

#include "check.h"
#include "nck/prep/1_decode/number/number.h" // nck_number_read

static const nck_scale_t mm = {10, 5, 1000000000000};
static const nck_scale_t inch = {254, 5, 1000000000000};
static const nck_scale_t inch_diameter = {127, 5, 1000000000000};
static const nck_scale_t degree = {1, 6, 10000000000000};
static const nck_scale_t fine = {1, 9, 10000000000000000};

// The number in counts, INT64_MIN if it cannot be read or is out of range. text: without line feed.
static int64_t fixed(const char *text, const nck_scale_t *scale) {
    char line[300];
    nck_number_t number;
    int64_t value;
    (void)snprintf(line, sizeof line, "%s\n", text);
    if (nck_number_read(line, line, &number) == NULL) return INT64_MIN;
    return nck_number_fixed(line, &number, scale, &value) ? value : INT64_MIN;
}

static double real(const char *text) {
    char line[300];
    nck_number_t number;
    (void)snprintf(line, sizeof line, "%s\n", text);
    return nck_number_read(line, line, &number) == NULL ? 1e300 : nck_number_real(&number);
}

static void millimetres_become_nanometres(check_t *check) {
    CHECK_INT(check, fixed("1.234", &mm), 1234000);
    CHECK_INT(check, fixed(".5", &mm), 500000);
    CHECK_INT(check, fixed("5.", &mm), 5000000);
    CHECK_INT(check, fixed("-0", &mm), 0);
    CHECK_INT(check, fixed("+7", &mm), 7000000);
    CHECK_INT(check, fixed("-12.3456789", &mm), -12345679);
    CHECK_INT(check, fixed("000000000000000000000000012", &mm), 12000000);
    CHECK_INT(check, fixed("1000000", &mm), 1000000000000);
    CHECK_INT(check, fixed("3.141592653589793238462643383279", &mm), 3141593);
}

static void ties_go_to_the_even_neighbour(check_t *check) {
    CHECK_INT(check, fixed("0.0000005", &mm), 0);
    CHECK_INT(check, fixed("0.0000015", &mm), 2);
    CHECK_INT(check, fixed("-0.0000025", &mm), -2);
    CHECK_INT(check, fixed("0.00000050000000000000000000000000000000", &mm), 0);
    CHECK_INT(check, fixed("0.00000050000000000000000000000000000001", &mm), 1);
    CHECK_INT(check, fixed("0.00000149999999999999999999999999999999", &mm), 1);
    // 0.0000025 inch are 63.5 nm, 0.0000075 inch are 190.5 nm
    CHECK_INT(check, fixed("0.0000025", &inch), 64);
    CHECK_INT(check, fixed("0.0000075", &inch), 190);
    CHECK_INT(check, fixed("0.0000075000000000000000000000000000001", &inch), 191);
    CHECK_INT(check, fixed("0.00000249999999999999999999999999999", &inch), 63);
}

static void inches_are_exact(check_t *check) {
    CHECK_INT(check, fixed("1", &inch), 25400000);
    CHECK_INT(check, fixed("0.0001", &inch), 2540);
    CHECK_INT(check, fixed("-39370.0787401574803149606299212598", &inch), -1000000000000);
    CHECK_INT(check, fixed("1", &inch_diameter), 12700000);
    // 0.00000003 inch are 0.762 nm, half of it 0.381 nm
    CHECK_INT(check, fixed("0.00000003", &inch), 1);
    CHECK_INT(check, fixed("0.00000003", &inch_diameter), 0);
}

static void degrees_are_exact_in_both_resolutions(check_t *check) {
    CHECK_INT(check, fixed("360.0000005", &degree), 360000000);
    CHECK_INT(check, fixed("-0.0000015", &degree), -2);
    CHECK_INT(check, fixed("0.1234567895", &fine), 123456790);
    CHECK_INT(check, fixed("10000000", &fine), 10000000000000000);
}

static void what_is_out_of_range_is_told(check_t *check) {
    CHECK_INT(check, fixed("1000000.0000001", &mm), 1000000000000); // rounds into the range
    CHECK_INT(check, fixed("1000000.000001", &mm), INT64_MIN);
    CHECK_INT(check, fixed("-1000001", &mm), INT64_MIN);
    CHECK_INT(check, fixed("99999999999999999999999999999999", &mm), INT64_MIN);
    CHECK_INT(check, fixed("123456789012345678", &inch), INT64_MIN);
    CHECK_INT(check, fixed("99999999.99999999999999999999", &degree), INT64_MIN);
}

static void what_is_no_number_is_told(check_t *check) {
    static const char *const texts[] = {"", ".", "-", "+.", "--1", "+-1", "x", " ", "-.", "-x1"};
    for (unsigned k = 0; k < sizeof texts / sizeof texts[0]; k++) {
        CHECK_INT(check, fixed(texts[k], &mm), INT64_MIN);
    }
}

static void blanks_inside_a_number_do_not_count(check_t *check) {
    CHECK_INT(check, fixed(" 1 2", &mm), 12000000);
    CHECK_INT(check, fixed("\t- 1\t. 5 ", &mm), -1500000);
    CHECK_INT(check, fixed("0 . 0 0 0 0 0 1 5 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1", &mm), 2);
}

// The long way, digit by digit, and the short way, by one mantissa, must agree.
static void length_does_not_change_the_value(check_t *check) {
    static const nck_scale_t *const scales[] = {&mm, &inch, &inch_diameter, &degree, &fine};
    uint64_t seed = 12345;
    int different = 0;
    for (int k = 0; k < 20000; k++) {
        char text[80], longer[120];
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        const unsigned decimals = (unsigned)(seed >> 60) % 14;
        const unsigned long whole = (unsigned long)(seed >> 33) % 39000;
        const unsigned long part = (unsigned long)(seed >> 20) % 100000000;
        (void)snprintf(text, sizeof text, "%s%lu.%0*lu", k & 1 ? "-" : "", whole,
                       (int)decimals + 1, part);
        (void)snprintf(longer, sizeof longer, "%s000000000000000000000", text);
        const nck_scale_t *const scale = scales[k % 5];
        different += fixed(text, scale) != fixed(longer, scale) || fixed(text, scale) == INT64_MIN;
    }
    CHECK_INT(check, different, 0);
}

static void reals_are_the_nearest(check_t *check) {
    CHECK(check, real("0.1") == 0.1);
    CHECK(check, real("-123456.789") == -123456.789);
    CHECK(check, real("1e5") == 1.0); // no exponents: the rest is another word
    CHECK(check, real("999999999999999") == 999999999999999.0);
    CHECK(check, real("0.0000000000000000000123") == 0.0000000000000000000123);
    CHECK_NEAR(check, real("0.000000000000000000000000000123") / 1.23e-28, 1.0, 4e-16);
    CHECK_NEAR(check, real("2.718281828459045235360287471352"), 2.718281828459045, 1e-15);
    CHECK_NEAR(check, real("123456789012345678901234567890") / 1.2345678901234568e29, 1.0, 4e-16);
}

static void whole_numbers_are_recognised(check_t *check) {
    static const struct {
        const char *text;
        int places, good;
        int64_t value;
    } rows[] = {{"61.1\n", 1, 1, 611}, {"61.10\n", 1, 1, 611}, {"61.11\n", 1, 0, 0},
                {"3.0\n", 0, 1, 3},    {"3.5\n", 0, 0, 0},     {"-2\n", 0, 1, -2},
                {"00007\n", 1, 1, 70}, {"99999999999999999999\n", 0, 0, 0}};
    for (unsigned k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        nck_number_t number;
        int64_t value = 0;
        CHECK(check, nck_number_read(rows[k].text, rows[k].text, &number) != NULL);
        CHECK_INT(check, nck_number_whole(&number, rows[k].places, &value), rows[k].good);
        CHECK_INT(check, value, rows[k].value);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, millimetres_become_nanometres);
    CHECK_RUN(&check, ties_go_to_the_even_neighbour);
    CHECK_RUN(&check, inches_are_exact);
    CHECK_RUN(&check, degrees_are_exact_in_both_resolutions);
    CHECK_RUN(&check, what_is_out_of_range_is_told);
    CHECK_RUN(&check, what_is_no_number_is_told);
    CHECK_RUN(&check, blanks_inside_a_number_do_not_count);
    CHECK_RUN(&check, length_does_not_change_the_value);
    CHECK_RUN(&check, reals_are_the_nearest);
    CHECK_RUN(&check, whole_numbers_are_recognised);
    return check_end(&check);
}
