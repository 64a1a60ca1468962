// SPDX-License-Identifier: MIT
// Room 1: text in any pieces and with any line ends, to the program's end and not beyond it.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;
static decode_case_t other;

static const char program[] = "%\r\nG21 G90 F100\r\nG0 X1\rG1 Y2\nG3 X2 Y1 I1\n\n(remark)\r"
                              "S5 M3\r\nG1 X3\r\n%";

static void pieces_of_any_size_give_the_same(check_t *check) {
    case_begin(&self);
    case_begin(&other);
    case_decode(&self, program);
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 7);
    CHECK_INT(check, self.block[6].kind, NCK_BLOCK_END);
    CHECK_INT(check, self.block[6].line, 10);
    for (size_t piece = 1; piece < sizeof program; piece++) {
        case_decode_bytes(&other, program, sizeof program - 1, piece);
        CHECK_INT(check, other.blocks, self.blocks);
        CHECK(check, memcmp(other.block, self.block, sizeof self.block) == 0);
        CHECK_INT(check, other.findings, self.findings);
        CHECK(check, memcmp(other.finding, self.finding, sizeof self.finding) == 0);
    }
}

static void a_full_line_waits_until_it_is_pulled(check_t *check) {
    nck_block_t block;
    size_t used = 99;
    case_begin(&self);
    nck_decode_init(&self.decode, &self.machine);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_EMPTY);
    CHECK_INT(check, nck_decode_push(&self.decode, "G0 X1\nX2\n", 9, &used), NCK_OK);
    CHECK_INT(check, used, 6);
    CHECK_INT(check, nck_decode_push(&self.decode, "X2\n", 3, &used), NCK_FULL);
    CHECK_INT(check, used, 0);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_OK);
    CHECK_INT(check, nck_decode_push(&self.decode, "X2", 2, &used), NCK_OK);
    CHECK_INT(check, nck_decode_push(&self.decode, "", 0, &used), NCK_OK);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_EMPTY);
    nck_decode_end(&self.decode);
    CHECK_INT(check, nck_decode_push(&self.decode, "X3", 2, &used), NCK_E_STATE);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_OK);
    CHECK_INT(check, block.target_nm[0], 2000000);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_OK);
    CHECK_INT(check, block.kind, NCK_BLOCK_END);
    CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_DONE);
    CHECK(check, nck_decode_invariants(&self.decode));
}

static void the_first_percent_opens_and_the_next_one_closes(check_t *check) {
    case_begin(&self);
    case_decode(&self, "\n%\nG0 X1\n % \nX2\n");
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_NO_END), 0);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 1);
    case_decode(&self, "% name of the part\nG0 X1\n%\nX2\n% remark\nX3\nM2\n%\n");
    CHECK_INT(check, self.blocks, 4); // no lone % at the beginning: the others are remarks
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 0);
    case_decode(&self, "%\nO1\nG0 X1\nM30\n%\n");
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 0);
}

static void text_after_the_end_is_noted_once(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1\nM2\n\r\n%\n\n  Post time 3 min\nG1 X5 nonsense\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 1);
    CHECK_INT(check, self.finding[self.findings - 1].line, 6);
}

static void a_missing_end_is_noted_and_the_last_line_counts(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1\nX2");
    CHECK_INT(check, self.blocks, 3);
    CHECK_INT(check, self.block[2].kind, NCK_BLOCK_END);
    CHECK_NEAR(check, self.block[2].output.value, 2.0, 0.0);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_NO_END), 1);
}

static void assumed_defaults_are_noted_once_each(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F1 G0 X1\nX2\nG2 X3 I.5\nG2 X4 I.5\nM2\n");
    CHECK_INT(check, self.findings, 4);
    CHECK_INT(check, self.finding[0].code, NCK_NOTE_UNITS);
    CHECK_INT(check, self.finding[1].code, NCK_NOTE_DISTANCE);
    CHECK_INT(check, self.finding[2].code, NCK_NOTE_PLANE);
    CHECK_INT(check, self.finding[2].line, 3);
    CHECK_INT(check, self.finding[3].code, NCK_NOTE_ARC_CENTRE);
    case_decode(&self, "G21 G90 G17 G91.1 F1 G0 X1\nG2 X3 I1\nM2\n");
    CHECK_INT(check, self.findings, 0);
}

// A build that does not smooth notes every G64.
static void a_g64_that_gives_no_tolerance_is_noted(check_t *check) {
    const int64_t noted = !NCK_HAS_OPTIMAL;
    case_begin(&self);
    case_decode(&self, "G64\nM2\n");
    CHECK_INT(check, self.findings, noted); // it means the machine's
    self.machine.path.tolerance = 0.0;
    case_decode(&self, "G64 P0.1\nG61\nM2\n");
    CHECK_INT(check, self.findings, noted);
    case_decode(&self, "M3\nG64\nG64 Q0.1\nM2\n");
    CHECK_INT(check, self.findings, 1);
    CHECK_INT(check, self.finding[0].code, NCK_NOTE_TOLERANCE);
    CHECK_INT(check, self.finding[0].line, 2);
    CHECK_INT(check, self.finding[0].letter, 0);
}

static void a_p_too_small_to_smooth_within_is_noted_once(check_t *check) {
    static const char *const small[] = {"G64 P0\n", "G64 P0.00009999\n", "G20 G64 P0.0000039\n"};
    case_begin(&self);
    case_decode(&self, "G64 P0.0001\nG20\nG64 P0.000004\nM2\n"); // 0.1 µm and more
    CHECK_INT(check, self.findings, !NCK_HAS_OPTIMAL);
    for (unsigned k = 0; k < sizeof small / sizeof small[0]; k++) {
        char text[64];
        (void)snprintf(text, sizeof text, "%s%sM2\n", small[k], small[k]);
        case_decode(&self, text);
        CHECK_INT(check, self.findings, 1);
        CHECK_INT(check, self.finding[0].code, NCK_NOTE_TOLERANCE);
        CHECK_INT(check, self.finding[0].line, 1);
        if (!NCK_HAS_OPTIMAL) continue;
        CHECK_INT(check, self.finding[0].letter, 'P');
        CHECK(check, self.finding[0].column > 0 && self.finding[0].value < 1e-4);
    }
}

// Under a slope that smooths nothing P is noted, once; what the machine has for G64 is not.
static void a_p_that_the_slope_does_not_heed_is_noted_once(check_t *check) {
    static const uint32_t exact[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    case_begin(&self);
    for (unsigned k = 0; k < sizeof exact / sizeof exact[0]; k++) {
        self.machine.slope = exact[k];
        case_decode(&self, "G61\nM8 G64 P0.01\nG61\nG64 P0.02\nM2\n");
        CHECK_INT(check, self.findings, 1);
        CHECK_INT(check, self.finding[0].code, NCK_NOTE_TOLERANCE);
        CHECK_INT(check, self.finding[0].line, 2);
        CHECK_INT(check, self.finding[0].column, 4);
        CHECK_INT(check, self.finding[0].letter, 'G');
        CHECK_NEAR(check, self.finding[0].value, 64.0, 0.0);
        case_decode(&self, "G64\nG64 Q0.1\nG61\nM2\n");
        CHECK_INT(check, self.findings, !NCK_HAS_OPTIMAL);
        case_decode(&self, "G64 P0\nG64 P0.01\nM2\n");
        CHECK_INT(check, self.findings, 1);
        CHECK_INT(check, self.finding[0].letter, 'P');
    }
}

static void a_feed_beside_a_change_of_units_is_noted(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G90 G20 F10\nG1 X1\nG21 F9\nM2\n");
    CHECK_INT(check, self.findings, 1);
    CHECK_INT(check, self.finding[0].code, NCK_NOTE_FEED_UNITS);
    CHECK_INT(check, self.finding[0].line, 1);
    CHECK_NEAR(check, self.block[0].feed, 10.0, 0.0);
    // What others read alike: units that stay, F on its own line, F in 1/min.
    case_decode(&self, "G21 F10\nG20\nF10\nG93 G21 F2\nG20 F2\nM2\n");
    CHECK_INT(check, self.findings, 0);
}

static void a_text_without_a_block_is_no_program(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "", NCK_E_NO_PROGRAM, 0, 0);
    check_error(check, &self, "\n\n", NCK_E_NO_PROGRAM, 2, 0);
    check_error(check, &self, "%\nO7\n(nothing)\n; here\n%\n", NCK_E_NO_PROGRAM, 5, 0);
    check_error(check, &self, "N10\n", NCK_E_NO_PROGRAM, 1, 0);
    check_error(check, &self, "?\n", NCK_E_CHARACTER, 1, 1);
    check_error(check, &self, "M2\n", NCK_OK, 0, 0);
}

static void a_nul_byte_ends_it_at_once(check_t *check) {
    static const char text[] = "G0 X1\n(\0)\nG0 X2\n\0\0\n";
    static const char inside[] = {'\x7f', 'E', 'L', 'F', '\0', '\1'};
    case_begin(&self);
    case_decode_bytes(&self, text, sizeof text - 1, 1000);
    CHECK_INT(check, self.errors, 1);
    CHECK_INT(check, self.first.code, NCK_E_BINARY);
    CHECK_INT(check, self.first.line, 2);
    CHECK_INT(check, self.blocks, 1);
    case_decode_bytes(&self, inside, sizeof inside, 1);
    CHECK_INT(check, self.errors, 1);
    CHECK_INT(check, self.first.code, NCK_E_BINARY);
}

// A line of n bytes: a G0 in front, the rest filled up.
static void long_line(char *text, size_t n, const char *begin, char fill) {
    memset(text, fill, n);
    memcpy(text, begin, strlen(begin));
    text[n] = '\n';
    memcpy(text + n + 1, "G0 X5\nM2\n", 9);
}

static void a_line_may_be_as_long_as_the_buffer_and_no_longer(check_t *check) {
    static char text[100 * NCK_LINE_MAX];
    case_begin(&self);
    long_line(text, NCK_LINE_MAX, "G0 X1", ' ');
    case_decode_bytes(&self, text, NCK_LINE_MAX + 10, 1000000);
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 3);
    for (size_t n = NCK_LINE_MAX + 1; n < sizeof text - 10; n = n * 3) {
        long_line(text, n, "G0 X1", ' ');
        case_decode_bytes(&self, text, n + 10, 1000000);
        CHECK_INT(check, self.errors, 1);
        CHECK_INT(check, self.first.code, NCK_E_LINE_LENGTH);
        CHECK_NEAR(check, self.first.value, NCK_LINE_MAX, 0.0);
        CHECK_INT(check, self.blocks, 2);
        long_line(text, n, "G0 X1 ;", 'x'); // a remark may be as long as it likes
        case_decode_bytes(&self, text, n + 10, 7);
        CHECK_INT(check, self.errors, 0);
        CHECK_INT(check, self.blocks, 3);
    }
}

static void a_byte_order_mark_and_foreign_letters_in_remarks_do_no_harm(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "\xef\xbb\xbfG0 X1 (\xc3\xa4)\n; fr\xe4sen\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G0 X1\n\xef\xbb\xbfG0 X1\nM2\n", NCK_E_CHARACTER, 2, 1);
    check_error(check, &self, "G0 X1 \xc3\xa4\nM2\n", NCK_E_CHARACTER, 1, 7);
    CHECK_NEAR(check, self.first.value, 0xc3, 0.0);
}

static void a_foreign_language_gets_one_sentence(check_t *check) {
    static const struct {
        const char *text;
        int hint;
    } rows[] = {{"0 BEGIN PGM 1 MM\n1 BLK FORM 0.1 Z X+0\n2 L X+0 FMAX\n", NCK_HINT_HEIDENHAIN},
                {"; remark\nBEGIN PGM X MM\nL X+0\n", NCK_HINT_HEIDENHAIN},
                {"%_N_PART_MPF\nG0 X1\n", NCK_HINT_SINUMERIK},
                {"N10 G17 G90\nN20 T=\"MILL10\"\n", NCK_HINT_SINUMERIK},
                {"N60 CYCLE81(10,0,2,-15)\n", NCK_HINT_SINUMERIK},
                {"N70 MCALL\n", NCK_HINT_SINUMERIK},
                {"MSG(\"FACE\")\n", NCK_HINT_SINUMERIK},
                {";$PATH=/_N_WKS\nN10 DEF REAL A=1\nG0 X=A\n", NCK_HINT_SINUMERIK},
                {"'SHOPBOT ROUTER FILE IN MM\nSA\n", NCK_HINT_SHOPBOT},
                {"MS,50,20\nJZ,20\n", NCK_HINT_SHOPBOT},
                {"m3 ,1,2,-3\n", NCK_HINT_SHOPBOT},
                {"&tool = 1\n", NCK_HINT_SHOPBOT},
                {"$PART.MIN%\nG15 H1\nCALL O1\n", NCK_HINT_OKUMA}};
    case_begin(&self);
    for (unsigned k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        case_decode(&self, rows[k].text);
        CHECK_INT(check, self.errors, 1);
        CHECK_INT(check, self.blocks, 0);
        CHECK_INT(check, self.first.code, NCK_E_DIALECT);
        CHECK_NEAR(check, self.first.value, rows[k].hint, 0.0);
    }
    check_error(check, &self, "(BEGIN PGM)\n; DEF REAL X\nG0 X1\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G0 X1\n$H\nM2\n", NCK_E_CHARACTER, 2, 1);
    check_error(check, &self, "X1,2\nM2\n", NCK_E_CHARACTER, 1, 3);
}

static void findings_that_nobody_takes_are_counted(check_t *check) {
    nck_block_t block;
    size_t used;
    case_begin(&self);
    nck_decode_init(&self.decode, &self.machine);
    for (int k = 0; k < NCK_DECODE_FINDINGS + 3; k++) {
        CHECK_INT(check, nck_decode_push(&self.decode, "?\n", 2, &used), NCK_OK);
        CHECK_INT(check, nck_decode_pull(&self.decode, &block), NCK_E_CHARACTER);
    }
    CHECK_INT(check, self.decode.finding.count, NCK_DECODE_FINDINGS);
    CHECK_INT(check, self.decode.finding.lost, 3);
    CHECK(check, nck_decode_invariants(&self.decode));
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, pieces_of_any_size_give_the_same);
    CHECK_RUN(&check, a_full_line_waits_until_it_is_pulled);
    CHECK_RUN(&check, the_first_percent_opens_and_the_next_one_closes);
    CHECK_RUN(&check, text_after_the_end_is_noted_once);
    CHECK_RUN(&check, a_missing_end_is_noted_and_the_last_line_counts);
    CHECK_RUN(&check, assumed_defaults_are_noted_once_each);
    CHECK_RUN(&check, a_g64_that_gives_no_tolerance_is_noted);
    CHECK_RUN(&check, a_p_too_small_to_smooth_within_is_noted_once);
    CHECK_RUN(&check, a_p_that_the_slope_does_not_heed_is_noted_once);
    CHECK_RUN(&check, a_feed_beside_a_change_of_units_is_noted);
    CHECK_RUN(&check, a_text_without_a_block_is_no_program);
    CHECK_RUN(&check, a_nul_byte_ends_it_at_once);
    CHECK_RUN(&check, a_line_may_be_as_long_as_the_buffer_and_no_longer);
    CHECK_RUN(&check, a_byte_order_mark_and_foreign_letters_in_remarks_do_no_harm);
    CHECK_RUN(&check, a_foreign_language_gets_one_sentence);
    CHECK_RUN(&check, findings_that_nobody_takes_are_counted);
    return check_end(&check);
}
