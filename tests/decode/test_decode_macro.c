// SPDX-License-Identifier: MIT
// Room 1: parameters, calls, jumps and loops, in text that is read and in text that is pushed.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

// A text that gives its bytes from any place, seven at a time at most.
typedef struct shelf {
    const char *text;
    size_t size;
} shelf_t;

static size_t read_shelf(void *user, size_t offset, char *out, size_t n) {
    const shelf_t *const shelf = user;
    const size_t left = shelf->size - offset;
    const size_t most = n < 7 ? n : 7;
    const size_t count = left < most ? left : most;
    memcpy(out, shelf->text + offset, count);
    return count;
}

// Decode a text that the room reads itself: in place, or through the hook.
static void case_read(const char *text, int hooked) {
    shelf_t shelf = {text, strlen(text)};
    const nck_source_t in_place = {text, strlen(text), NULL, NULL};
    const nck_source_t hook = {NULL, 0, read_shelf, &shelf};
    nck_block_t block;
    nck_status_t status = NCK_EMPTY;
    self.blocks = self.findings = self.errors = self.returned = 0;
    memset(&self.first, 0, sizeof self.first);
    nck_decode_init(&self.decode, &self.machine);
    (void)nck_decode_source(&self.decode, hooked ? &hook : &in_place);
    while (status != NCK_DONE) {
        status = nck_decode_pull(&self.decode, &block);
        case_take(&self, status, &block);
    }
}

static void check_read(check_t *check, const char *text, nck_status_t code, unsigned line,
                       unsigned column) {
    for (int hooked = 0; hooked <= 1; hooked++) {
        case_read(text, hooked);
        const int good = self.first.code == (int32_t)code && self.errors == (code < 0)
                         && self.returned == self.errors
                         && (code == NCK_OK || self.first.line == line)
                         && (code == NCK_OK || self.first.column == column);
        if (check_that(check, good, text, __FILE__, __LINE__)) continue;
        printf("    %d errors, first %s at %u:%u, want %s at %u:%u\n", self.errors,
               nck_status_id(self.first.code), (unsigned)self.first.line,
               (unsigned)self.first.column, nck_status_id(code), line, column);
    }
}

// The X of every block but the last one, in mm.
static void check_x(check_t *check, const char *text, const double *wanted, int count) {
    check_read(check, text, NCK_OK, 0, 0);
    CHECK_INT(check, self.blocks, count + 1);
    for (int k = 0; k < count && k < self.blocks; k++) {
        CHECK_NEAR(check, (double)self.block[k].target_nm[0] / 1e6, wanted[k], 1e-9);
    }
}

static void values_are_what_they_say(check_t *check) {
    static const double wanted[] = {3.0, 14.0, 8.0, 4.0, 2.0, -2.0, 45.0, 1.0, 512.0, 0.3, 2.0,
                                    -3.0, 0.125, 1.0, 0.0};
    case_begin(&self);
    check_x(check, "G0 X[1+2]\nX[2+3*4]\nX[[1+3]*2]\nX-[-4]\nX[8/2/2]\nX[-7 MOD 3-4]\n"
                   "XATAN[3]/[3]\nX[1 LT 2 AND 3 GE 3]\nX[2**3**3]\nX[0.1+0.2]\nXROUND[1.5]\n"
                   "XFIX[-2.5]\nX[2**-3]\nXEXP[LN[1]]\nX[1 EQ 2]\nM2\n", wanted, 15);
}

static void assignments_count_from_the_end_of_their_line(check_t *check) {
    static const double wanted[] = {5.0, 5.0, 7.0, 9.0, 0.0, 1.0};
    case_begin(&self);
    check_x(check, "#1=5 #<a b>=7\nG0 X#1 #1=9\nX5 #2=#1\n#1=1\nX#<AB>\nX#2\nX#30\n"
                   "XEXISTS[#<ab>]\nM2\n", wanted, 6);
    check_read(check, "G0 X#<never>\nM2\n", NCK_E_UNSET, 1, 6);
    check_read(check, "#0=1\nM2\n", NCK_E_NUMBER_RANGE, 1, 2);
    check_read(check, "#5420=1\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
    check_read(check, "#1 5\nM2\n", NCK_E_EXPRESSION, 1, 5);
}

static void expressions_that_have_no_value_are_errors(check_t *check) {
    case_begin(&self);
    check_read(check, "G0 X[1/0]\nM2\n", NCK_E_VALUE, 1, 9);
    check_read(check, "G0 XSQRT[-1]\nM2\n", NCK_E_VALUE, 1, 13);
    check_read(check, "G0 X[-8**0.5]\nM2\n", NCK_E_VALUE, 1, 13);
    check_read(check, "G0 X[1+]\nM2\n", NCK_E_EXPRESSION, 1, 8);
    check_read(check, "G0 X[1\nM2\n", NCK_E_EXPRESSION, 1, 7);
    check_read(check, "G0 X[1]]\nM2\n", NCK_E_CHARACTER, 1, 8);
    check_read(check, "G0 XATAN[1]\nM2\n", NCK_E_EXPRESSION, 1, 12);
    check_read(check, "G0 X[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]\nM2\n",
               NCK_E_EXPRESSION, 1, 29);
}

static void subprograms_have_parameters_of_their_own(check_t *check) {
    static const double wanted[] = {11.0, 21.0, 3.0, 1.0};
    case_begin(&self);
    check_x(check, "#1=1\no<s> sub\nG0 X[#1+1]\no<s> return [#1/10+#2]\nX99\no<s> endsub\n"
                   "o<s> call [10] [0]\no<s> call [20] [1]\nX#<_value>\nX#1\nM2\n", wanted, 4);
    check_read(check, "o1 sub\no1 call\no1 endsub\no1 call\nM2\n", NCK_E_DEPTH, 2, 0);
    CHECK_INT(check, self.findings, 1 + NCK_CALL_DEPTH);
    CHECK_INT(check, self.finding[1].code, NCK_NOTE_CALLED);
    CHECK_INT(check, self.finding[NCK_CALL_DEPTH].line, 4);
    check_read(check, "G0 X1\no1 call\nM2\n", NCK_E_LABEL, 2, 0);
    check_read(check, "o1 endsub\nM2\n", NCK_E_FLOW, 1, 0);
    check_read(check, "o1 sub\nM2\n", NCK_E_FLOW, 1, 0);
}

static void loops_and_conditions_jump(check_t *check) {
    static const double wanted[] = {0.0, 1.0, 5.0, 5.0, 2.0, 8.0};
    case_begin(&self);
    check_x(check, "o1 while [#1 lt 2]\r\nG0 X#1\r\n#1=[#1+1]\r\no1 endwhile\r\no2 repeat [2]\r\n"
                   "X5\r\no2 endrepeat\r\no3 if [#1 eq 1]\r\nX1\r\no3 elseif [#1 eq 2]\r\nX2\r\n"
                   "o3 else\r\nX3\r\no3 endif\r\no4 do\r\no4 break\r\nX7\r\no4 while [1]\r\nX8\r\n"
                   "M2\r\n", wanted, 6);
    CHECK_INT(check, self.block[1].line, 2);
    CHECK_INT(check, self.block[5].line, 19);
    check_read(check, "o1 endwhile\nM2\n", NCK_E_FLOW, 1, 0);
    check_read(check, "G0 X1\no1 if [0]\nM2\n", NCK_E_FLOW, 2, 0);
    check_read(check, "o1 while [1]\no1 endwhile\nM2\n", NCK_E_ENDLESS, 1, 0);
}

static void fanuc_jumps_calls_and_stops(check_t *check) {
    static const double loop[] = {1.0, 2.0, 3.0, 7.0}, calls[] = {5.0, 6.0, 5.0, 6.0, 9.0, 8.0};
    static const double modal[] = {1.0, 3.0, 2.0, 3.0, 4.0};
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    check_x(check, "#1=1\nN10 X#1\n#1=#1+1\nIF[#1LE3]GOTO10\nWHILE[#1LT6]DO1\n#1=#1+1\nEND1\n"
                   "IF [#1 EQ 6] THEN #2=7\nX#2 Y#5\nM30\n", loop, 4);
    check_x(check, "M98 P20005\nM98 P9\nX8\nM30\nO0005\nX5\nX6\nM99\nO9\nX9\nM99\n", calls, 6);
    check_x(check, "G66 P7 A3.\nX1\nX2\nG67\nX4\nM30\nO7\nX#1\nM99\n", modal, 5);
    check_read(check, "G65 P7 X2. M3\nM30\nO7\nIF [#24 NE 2] GOTO 9\nIF [#13 NE 3] GOTO 9\n"
                      "IF [#1 NE #0] GOTO 9\nM99\nN9 #3000=5 (BAD)\n", NCK_OK, 0, 0);
    check_read(check, "G0 X1\n#3000=5 (TOOL)\nM30\n", NCK_E_ALARM, 2, 0);
    CHECK_NEAR(check, self.first.value, 5.0, 0.0);
    check_read(check, "GOTO 77\nM30\n", NCK_E_LABEL, 1, 0);
    check_read(check, "X1\nM99\n", NCK_OK, 0, 0);
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_REPEATS), 1);
    check_read(check, "N1 G91 X1\nX-1\nM99 P1\n", NCK_E_ENDLESS, 3, 0);
    check_read(check, "WHILE [1 EQ 1] DO 1\nG91 X1\nX-1\nEND 1\n", NCK_E_ENDLESS, 4, 0);
}

static void fanuc_says_i_j_k_in_sets(check_t *check) {
    static const double wanted[] = {1.0, 2.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 0.0};
    static const double short_sets[] = {4.0, 7.0, 10.0, 5.0, 0.0};
    static const double modal[] = {1.0, 7.0, 2.0, 7.0};
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    check_x(check, "G65 P7 A1. B2. I4. J5. K6. I7. J8. K9. I[4+6]\nM30\nO7\nX#1\nX#2\nX#4\n"
                   "X#5\nX#6\nX#7\nX#8\nX#9\nX#10\nX[#11+0]\nM99\n", wanted, 10);
    check_x(check, "G65 P7 I4. I7. I10.\nG65 P8 I#0 J5. I#0\nM30\n"
                   "O7\nX#4\nX#7\nX#10\nM99\nO8\nX#5\nX[#7+#4]\nM99\n", short_sets, 5);
    check_x(check, "G66 P7 I4. I7.\nX1\nX2\nG67\nM30\nO7\nX#7\nM99\n", modal, 4);
    check_read(check, "G65 P7 J5. I4.\nM30\nO7\nM99\n", NCK_E_UNSUPPORTED, 1, 12);
    check_read(check, "G65 P7 I4. I7. J5.\nM30\nO7\nM99\n", NCK_E_UNSUPPORTED, 1, 16);
    check_read(check, "G65 P7 I4. J5. I7. D3.\nM30\nO7\nM99\n", NCK_E_WORD_TWICE, 1, 20);
    check_read(check, "G65 P7 I1.I1.I1.I1.I1.I1.I1.I1.I1.I1.\nM30\nO7\nM99\n", NCK_OK, 0, 0);
    check_read(check, "G65 P7 I1.I1.I1.I1.I1.I1.I1.I1.I1.I1.I1.\nM30\nO7\nM99\n",
               NCK_E_WORD_TWICE, 1, 38);
    check_read(check, "G2 X1. I1. I1. F9\nM30\n", NCK_E_WORD_TWICE, 1, 12);
}

static void fanuc_counts_in_bits_and_digits(check_t *check) {
    static const double wanted[] = {8.0, 9.0, 0.5, 21.0, 15.0, 2.0, 7.0, 5.0, 1.0, 0.0};
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    check_x(check, "X POW[2,3]\nX[POW[1+2,4/2]]\nXPOW[4,-POW[4,-0.5]]\nXBCD[15]\nXBIN[21]\n"
                   "X[6 AND 3]\nX[6 OR 3]\nX[6 XOR 3]\nX[[2 GT 1] AND [1 LT 2]]\n"
                   "X[[2 GT 1] XOR [0.1*30 GE 2]]\nM30\n", wanted, 10);
    check_read(check, "X[1.5 AND 1]\nM30\n", NCK_E_VALUE, 1, 12);
    check_read(check, "X[-1 OR 1]\nM30\n", NCK_E_VALUE, 1, 10);
    check_read(check, "XBIN[10]\nM30\n", NCK_E_VALUE, 1, 9);
    check_read(check, "XBCD[100000000]\nM30\n", NCK_E_VALUE, 1, 16);
    check_read(check, "XPOW[2]\nM30\n", NCK_E_EXPRESSION, 1, 8);
    check_read(check, "XBIN[2,3]\nM30\n", NCK_E_EXPRESSION, 1, 7);
    check_read(check, "XPOW[-8,0.5]\nM30\n", NCK_E_VALUE, 1, 13);
    check_read(check, "XADP[#1]\nM30\n", NCK_E_UNSUPPORTED, 1, 2);
    check_read(check, "XPRM[12]\nM30\n", NCK_E_UNSUPPORTED, 1, 2);
    check_read(check, "XMAX[1,2]\nM30\n", NCK_E_EXPRESSION, 1, 2);
    self.machine.dialect.base = NCK_DIALECT_LINUXCNC;
    check_read(check, "G0 XPOW[2,3]\nM30\n", NCK_E_OTHER_BASE, 1, 5);
    check_read(check, "G0 X[[1.5 AND 1] + [0 OR 0]]\nM30\n", NCK_OK, 0, 0);
}

static void fanuc_sets_its_work_offsets(check_t *check) {
    static const double wanted[] = {6.0, 31.4, 7.0, 7.0}, zeros[] = {6.0, 7.0, 20.0};
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    check_x(check, "G21 G90 G54\n#5221=5. #5223=1\nX1.\nG20\nN5 #5221=1 (inch)\nG21 X6.\n"
                   "IF [#5221 GT 25] THEN #5241=6.\nG55 X1\n#100=#5241\n"
                   "#5241=#100 #101=2\nX1.\nM30\n", wanted, 4);
    CHECK_INT(check, self.block[0].target_nm[2], 0);
    check_read(check, "#5220=1\nM30\n", NCK_E_UNSUPPORTED, 1, 1);
    CHECK_INT(check, self.first.letter, '#');
    check_x(check, "G21 G90 G54\n#5201=5.\nX1.\nG55 X2.\n#5201=#5201-#5221\nG10 L2 P0 X9.\n"
                   "G91 G10 L2 P0 X1.\nG90 X#5201\nM30\n", zeros, 3);
    check_read(check, "#5341=1\nM30\n", NCK_E_UNSUPPORTED, 1, 1);
    check_read(check, "#5235=1\nM30\n", NCK_E_UNSUPPORTED, 1, 1);
    check_read(check, "#2001=1\nM30\n", NCK_E_UNSUPPORTED, 1, 1);
    check_read(check, "G0 X#2001\nM30\n", NCK_E_UNSUPPORTED, 1, 10);
    check_read(check, "X1 #5221=1\nM30\n", NCK_E_WORD_SHARED, 1, 4);
    check_read(check, "#5221=1 X1\nM30\n", NCK_E_WORD_SHARED, 1, 9);
    check_read(check, "#5221=1000001\nM30\n", NCK_E_VALUE, 1, 1);
    check_read(check, "#5221=#0\nM30\n", NCK_E_VALUE, 1, 1);
    self.machine.tool_count = 1;
    self.machine.tool[0] = (nck_tool_t){.number = 1, .radius_mm = 1.0};
    if (NCK_HAS_COMP) check_read(check, "G41 D1\n#5221=1\nM30\n", NCK_E_COMP_ON, 2, 1);
    if (NCK_HAS_LAYOUTS) check_read(check, "G51.1 X0\n#5221=1\nM30\n", NCK_E_LAYOUT_ON, 2, 1);
    self.machine.dialect.base = NCK_DIALECT_LINUXCNC;
    check_read(check, "#5221=1\nM30\n", NCK_E_UNSUPPORTED, 1, 1);
}

static void pushed_text_jumps_forward_only(check_t *check) {
    case_begin(&self);
    case_decode(&self, "#1=2\no1 if [#1 eq 1]\nG0 X1\no1 else\nG0 X[#1+3]\no1 endif\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[0].target_nm[0], 5000000);
    check_error(check, &self, "o1 repeat [2]\nG0 X1\no1 endrepeat\nM2\n", NCK_E_NO_SEEK, 3, 0);
    check_error(check, &self, "o1 sub\no1 endsub\no1 call\nM2\n", NCK_E_NO_SEEK, 3, 0);
    check_error(check, &self, "GOTO 5\nN5 M2\n", NCK_E_OTHER_BASE, 1, 1);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    check_error(check, &self, "GOTO 5\nX1\nN5 M2\n", NCK_OK, 0, 0);
    check_error(check, &self, "GOTO 5\nX1\nM2\n", NCK_E_NO_SEEK, 1, 0);
}

static void a_source_takes_the_place_of_pushing(check_t *check) {
    const nck_source_t none = {NULL, 0, NULL, NULL}, good = {"M2\n", 3, NULL, NULL};
    size_t used;
    case_begin(&self);
    nck_decode_init(&self.decode, &self.machine);
    CHECK_INT(check, nck_decode_source(&self.decode, &none), NCK_E_ARGUMENT);
    CHECK_INT(check, nck_decode_source(&self.decode, &good), NCK_OK);
    CHECK_INT(check, nck_decode_source(&self.decode, &good), NCK_E_STATE);
    CHECK_INT(check, nck_decode_push(&self.decode, "M2", 2, &used), NCK_E_STATE);
    CHECK(check, nck_decode_reads(&self.decode));
    CHECK(check, !nck_decode_is_empty(&self.decode));
    case_read("G0 X1\nM2\n\nX5\n", 0);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 1);
    case_read("G0 X1\nM2\n%\n \n", 1);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_AFTER_END), 0);
}

static void too_many_parameters_are_an_error(check_t *check) {
    case_begin(&self);
    check_read(check, "#31=1\no1 while [1]\n#[#31+31]=#31\n#31=[#31+1]\no1 endwhile\nM2\n",
               NCK_E_VARIABLES, 4, 0);
}

// Where the capacities leave jumps out, text is pushed.
static void what_is_left_out_is_refused(check_t *check) {
    const nck_source_t source = {"M2\n", 3, NULL, NULL};
    case_begin(&self);
    nck_decode_init(&self.decode, &self.machine);
    CHECK_INT(check, nck_decode_source(&self.decode, &source),
              NCK_HAS_CALLS ? NCK_OK : NCK_E_STATE);
}

// M99 in the main program ends its pass.
static void m99_in_the_main_program_is_its_end(check_t *check) {
    check_error(check, &self, "M99\n", NCK_HAS_CALLS ? NCK_OK : NCK_E_UNSUPPORTED,
                NCK_HAS_CALLS ? 0 : 1, NCK_HAS_CALLS ? 0 : 1);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, what_is_left_out_is_refused);
    CHECK_RUN(&check, m99_in_the_main_program_is_its_end);
    if (!NCK_HAS_CALLS) return check_end(&check);
    CHECK_RUN(&check, values_are_what_they_say);
    CHECK_RUN(&check, assignments_count_from_the_end_of_their_line);
    CHECK_RUN(&check, expressions_that_have_no_value_are_errors);
    CHECK_RUN(&check, subprograms_have_parameters_of_their_own);
    CHECK_RUN(&check, loops_and_conditions_jump);
    CHECK_RUN(&check, fanuc_jumps_calls_and_stops);
    CHECK_RUN(&check, fanuc_says_i_j_k_in_sets);
    CHECK_RUN(&check, fanuc_counts_in_bits_and_digits);
    CHECK_RUN(&check, fanuc_sets_its_work_offsets);
    CHECK_RUN(&check, pushed_text_jumps_forward_only);
    CHECK_RUN(&check, a_source_takes_the_place_of_pushing);
    CHECK_RUN(&check, too_many_parameters_are_an_error);
    return check_end(&check);
}
