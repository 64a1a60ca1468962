// SPDX-License-Identifier: MIT
// Room 1: contours that lathes rough and finish.
#include "told_check.h"

static told_t self;

static const told_row_t pockets_rows[] = {
    {"o1 sub\nG0 X10\nG1 Z-10 F1\nX14 Z-12\nX8 Z-16\nX16 Z-20\no1 endsub\nG0 X20 Z2\n"
     "G71.2 Q1 X20 Z2 D0 I2 R1 F100\n",
     "8 rapid X20 Z2; 9 rapid~ Z-13.333333; 9 line~ X12 F100; 9 line~ Z-18; 9 rapid~ X13 Z-17;"
     " 9 rapid~ Z-14.666667; 9 line~ X10; 9 line~ Z-17; 9 rapid~ X11 Z-16; 9 rapid~ X20;"
     " 9 rapid~ Z2; 9 rapid~ X13; 9 line X10; 9 line Z-10; 9 line X14 Z-12; 9 line X8 Z-16;"
     " 9 line X16 Z-20; 9 rapid~ X20; 9 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z-4\nG3 X8 Z-8 R4\nG1 Z-12\nG2 X12 Z-16 R4\no1 endsub\nG0 X14 Z2\n"
     "G71 Q1 X14 Z2 D0 I3 R1 F100\nG70 Q1 X14 Z2 E1 P2\n",
     "8 rapid X14 Z2; 9 rapid~ X11; 9 line~ Z-15.872983 F100; 9 rapid~ X12 Z-14.872983;"
     " 9 rapid~ Z2; 9 rapid~ X8; 9 line~ Z-12; 9 rapid~ X9 Z-11; 9 rapid~ Z2; 9 rapid~ X5;"
     " 9 line~ Z-4.127017; 9 rapid~ X6 Z-3.127017; 9 rapid~ Z2; 9 rapid~ X4; 9 line~ Z-4;"
     " 9 rapid~ X5 Z-3; 9 rapid~ Z2; 9 line X4; 9 line Z-4; 9 arc X8 Z-8 G18 about -8 4 by 90;"
     " 9 line Z-12; 9 arc X12 Z-16 G18 about -12 12 by -90; 9 rapid~ X14; 9 rapid~ Z2;"
     " 10 rapid~ Z3.025; 10 rapid~ X5.025; 10 comp G18 -0.5 nose 0 0; 10 line X4; 10 line Z2;"
     " 10 line Z-4; 10 arc X8 Z-8 G18 about -8 4 by 90; 10 line Z-12;"
     " 10 arc X12 Z-16 G18 about -12 12 by -90; 10 comp G18 0 nose 0 0; 10 rapid~ X14 Z-15.5;"
     " 10 rapid~ Z2; 10 rapid~ Z4.05; 10 rapid~ X6.05; 10 comp G18 -1 nose 0 0; 10 line X4;"
     " 10 line Z2; 10 line Z-4; 10 arc X8 Z-8 G18 about -8 4 by 90; 10 line Z-12;"
     " 10 arc X12 Z-16 G18 about -12 12 by -90; 10 comp G18 0 nose 0 0; 10 rapid~ X14 Z-15;"
     " 10 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z-6 A1\nX8 C2\nZ-12\nX14\no1 endsub\nG0 X14 Z2\n"
     "G71 Q1 X14 Z2 D0 I4 R1 F100\nG72 Q1 X14 Z2 D0 I4 R1\n",
     "8 rapid X14 Z2; 9 rapid~ X10; 9 line~ Z-12 F100; 9 rapid~ X11 Z-11; 9 rapid~ Z2;"
     " 9 rapid~ X6; 9 line~ Z-6; 9 rapid~ X7 Z-5; 9 rapid~ Z2; 9 rapid~ X4; 9 line~ Z-5;"
     " 9 rapid~ X5 Z-4; 9 rapid~ Z2; 9 line X4; 9 line Z-5; 9 arc X5 Z-6 G18 about -5 5 by -90;"
     " 9 line X6; 9 line X8 Z-8; 9 line Z-12; 9 line X14; 9 rapid~ Z2; !10:0 contour"},
    {"o1 sub\nG0 Z-6\nG1 X4\nZ0 X0\no1 endsub\nG0 X14 Z2\nG72.1 Q1 X14 Z2 D1 I4 R1 F100\n",
     "6 rapid X14 Z2; 7 rapid~ Z-2; 7 line~ X2.535184 F100; 7 rapid~ X3.535184 Z-1;"
     " 7 rapid~ X14; 7 rapid~ Z-5; 7 line~ X4.535184; 7 rapid~ X5.535184 Z-4; 7 rapid~ X16.05;"
     " 7 line Z-3.95; 7 comp G18 1 nose 0 0; 7 line Z-6; 7 line X14; 7 line X4; 7 line X0 Z0;"
     " 7 comp G18 0 nose 0 0; 7 rapid~ X0.83205 Z2; 7 rapid~ X14"},
    {"o1 sub\nG0 X4\nG1 Z-6\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D0 I0 R1\n"
     "G71 Q1 X14 Z2 D0 I-1 R1\nG71 Q1 X14 Z2 D-1 I1 R1\nG71 Q1 X14 Z2 D0 I1 R-1\n"
     "G71 Q1 X14 Z2 D0 R1\nG71 Q1 Z2 D0 I1 R1\nG71 X14 Z2 D0 I1 R1\nG71 Q9 X14 Z2 D0 I1 R1\n",
     "5 rapid X14 Z2; !6:18 number-range I"},
    {"o1 sub\nG3 X4 Z-4 R4\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D0 I1 R1\n",
     "4 rapid X14 Z2; !2:11 arc-chord R 4/5.83095189; ?5:0 called-from"},
    {"o1 sub\nG0 X4\nG1 Z-6\nZ-4\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D0 I1 R1\n",
     "6 rapid X14 Z2; !4:0 contour Z; ?7:0 called-from"},
    {"o1 sub\nG0 X4\nG1 Z-6\nM8\nG81 Z-9 R1\nZ-12\no1 endsub\nG0 X14 Z2 F100\n"
     "G71 Q1 X14 Z2 D0 I1 R1\nX9\n",
     "8 rapid X14 Z2; !5:1 contour G 81/0; ?9:0 called-from"},
    {"o1 sub\nG0 X4 A1\nG1 Z-6 A0\nX9 A1 C1\nX9 A9\no1 endsub\nG0 X14 Z2 F100\n"
     "G71 Q1 X14 Z2 D0 I1 R1\n",
     "7 rapid X14 Z2; !2:0 contour A; ?8:0 called-from"},
    {"o1 sub\nG0 X4\nG1 Z-6\nX9\no1 endsub\nG0 X14 Z2\nG70 Q1 X14 Z2\nG70 X14 Z2 F9\n"
     "G70 Q1 X14 Z2 F9\nG7 G70 Q1 X28 Z2 F9\nG91 G70 Q1 X0 Z0 F9\n",
     "6 rapid X14 Z2; !7:0 feed-missing F"},
    {"o1 sub\nG0 X-4\nG1 Z-6\nX-9\no1 endsub\nG0 X-14 Z2\nG71 Q1 X-14 Z2 D0 I3 R1 F9\n",
     "6 rapid X-14 Z2; 7 rapid~ X-11; 7 line~ Z-6 F9; 7 rapid~ X-12 Z-5; 7 rapid~ Z2;"
     " 7 rapid~ X-8; 7 line~ Z-6; 7 rapid~ X-9 Z-5; 7 rapid~ Z2; 7 rapid~ X-5; 7 line~ Z-6;"
     " 7 rapid~ X-6 Z-5; 7 rapid~ Z2; 7 rapid~ X-4; 7 line~ Z-6; 7 rapid~ X-5 Z-5; 7 rapid~ Z2;"
     " 7 line X-4; 7 line Z-6; 7 line X-9; 7 rapid~ X-14; 7 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z6\nX9\no1 endsub\nG0 X14 Z-2\nG71 Q1 X14 Z-2 D0.5 I3 R1 F9\n",
     "6 rapid X14 Z-2; 7 rapid~ X11; 7 line~ Z6 F9; 7 rapid~ X12 Z5; 7 rapid~ Z-2; 7 rapid~ X8;"
     " 7 line~ Z5.5; 7 rapid~ X9 Z4.5; 7 rapid~ Z-2; 7 rapid~ X5; 7 line~ Z5.5;"
     " 7 rapid~ X6 Z4.5; 7 rapid~ Z-2; 7 rapid~ X4.5; 7 line~ Z5.5; 7 rapid~ X5.5 Z4.5;"
     " 7 rapid~ Z-3.025; 7 line X5.025; 7 comp G18 0.5 nose 0 0; 7 line X4; 7 line Z-2;"
     " 7 line Z6; 7 line X9; 7 comp G18 0 nose 0 0; 7 rapid~ X14 Z5.5; 7 rapid~ Z-2"},
};

static void a_contour_of_rs274ngc_is_cut(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_lathe(&self);
    TOLD(check, &self, pockets_rows);
}

static const told_row_t fpockets_rows[] = {
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 U1. W.5 F.2\nN1 G0 X10. Z1.\nG1 Z-10.\n"
     "X30. Z-14.\nX20. Z-20.\nN2 X40. Z-24.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !3:0 contour W 0.5/0"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 U1. W.5 F.2\nN1 G0 X10.\nG1 Z-10.\n"
     "X30. Z-14.\nX20. Z-20.\nN2 X40. Z-24.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !7:0 contour X"},
    {"G0 X10. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 U-1. W.5 F.2\nN1 G0 X30.\nG1 Z-10.\n"
     "G2 X20. Z-15. R5.\nN2 G1 X10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X5 Z2; 3 rapid~ X9; 3 line~ Z-14.5 F0.2;"
     " 3 rapid~ X8 Z-13.5; 3 rapid~ Z2; 3 rapid~ X13; 3 line~ Z-9.730304;"
     " 3 rapid~ X12 Z-8.730304; 3 rapid~ Z2; 3 rapid~ X14.5; 3 line~ Z-9.5;"
     " 3 rapid~ X13.5 Z-8.5; 3 rapid~ Z2.5; 3 line X14.5; 3 line Z-9.5;"
     " 3 arc X9.5 Z-14.5 G18 about -14.5 14.5 by -90; 3 line X4.5; 3 rapid~ Z2; 3 rapid~ X5"},
    {"G0 X40. Z-22. S500 M3\nG71 U4. R1.\nG71 P1 Q2 U1. W-.5 F.2\nN1 G0 X10.\nG1 Z-10.\n"
     "N2 X40. Z0.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z-22; 3 rapid~ X16; 3 line~ Z-3.5 F0.2;"
     " 3 rapid~ X17 Z-4.5; 3 rapid~ Z-22; 3 rapid~ X12; 3 line~ Z-6.166667;"
     " 3 rapid~ X13 Z-7.166667; 3 rapid~ Z-22; 3 rapid~ X8; 3 line~ Z-8.833333;"
     " 3 rapid~ X9 Z-9.833333; 3 rapid~ Z-22; 3 rapid~ X5.5; 3 line~ Z-10.5;"
     " 3 rapid~ X6.5 Z-11.5; 3 rapid~ Z-22.5; 3 line X5.5; 3 line Z-10.5; 3 line X20.5 Z-0.5;"
     " 3 rapid~ Z-22; 3 rapid~ X20"},
    {"G0 X40. Z2. S500 M3\nG73 U3. W2. R2\nG73 P1 Q2 U1. W.5 F.2\nN1 G0 X10.\nG1 Z-10.\n"
     "N2 X40.\nG70 P1 Q2 F.1\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; 3 rapid~ X23.5 Z4.5; 3 rapid~ X8.5;"
     " 3 line Z-7.5 F0.2; 3 line X23.5; 3 rapid~ X20.5 Z2.5; 3 rapid~ X5.5; 3 line Z-9.5;"
     " 3 line X20.5; 3 rapid~ X20 Z2; 4 rapid X5; 5 line Z-10 F0.1; 6 line X20; 7 rapid~ Z2"},
    {"G0 X40. Z2. S500 M3\nG73 P1 Q2 F.2\nN1 G0 X10.\nN2 G1 Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !2:1 word-missing R; 3 rapid X5;"
     " 4 line Z-10 F0.2"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P5 Q6 F.2\nN1 G0 X10.\nN2 G1 Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !3:0 contour P 5/100; 5 line Z-10 F0.2"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 F.2\nN1 G0 X10.\nT2\nN2 G1 Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; 3 rapid~ X16; 3 line~ Z-10 F0.2;"
     " 3 rapid~ X17 Z-9; 3 rapid~ Z2; 3 rapid~ X12; 3 line~ Z-10; 3 rapid~ X13 Z-9;"
     " 3 rapid~ Z2; 3 rapid~ X8; 3 line~ Z-10; 3 rapid~ X9 Z-9; 3 rapid~ Z2; 3 rapid~ X5;"
     " 3 line~ Z-10; 3 rapid~ X6 Z-9; 3 rapid~ Z2; 3 line X5; 3 line Z-10; 3 rapid~ X20;"
     " 3 rapid~ Z2"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 F.2\nN1 G0 X10.\nG1 Z-10. F.3 M8\nZ-5.\n"
     "N2 G1 X12.\nX50.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !6:0 contour Z; 8 rapid X25"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 F.2\nG71 Q2 F.2\nG71 P1 Q2 D3. F.2\n"
     "G71 P1.5 Q2 F.2\nG70 P1\nG70 Q2\nG70 P9 Q10\nN1 G0 X10.\nN2 G1 X12.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !3:1 word-missing Q;"
     " !4:1 word-missing P; !5:0 contour P 1/100; !7:1 word-missing Q; !8:1 word-missing P;"
     " !9:0 label-missing 9/0; ?9:0 called-from"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R1.\nG71 P1 Q2 U1. F.2\nN1 G0 X10.\nG1 Z-8. ,R2.\n"
     "X20. ,C1.\nZ-14.\nN2 X40.\nG70 P1 Q2\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; 3 rapid~ X16; 3 line~ Z-14 F0.2;"
     " 3 rapid~ X17 Z-13; 3 rapid~ Z2; 3 rapid~ X12; 3 line~ Z-14; 3 rapid~ X13 Z-13;"
     " 3 rapid~ Z2; 3 rapid~ X8; 3 line~ Z-8; 3 rapid~ X9 Z-7; 3 rapid~ Z2; 3 rapid~ X5.5;"
     " 3 line~ Z-6; 3 rapid~ X6.5 Z-5; 3 rapid~ Z2; 3 line X5.5; 3 line Z-6;"
     " 3 arc X7.5 Z-8 G18 about -6 7.5 by -90; 3 line X9.5; 3 line X10.5 Z-9; 3 line Z-14;"
     " 3 line X20.5; 3 rapid~ Z2; 3 rapid~ X20; 4 rapid X5; 5 line Z-6;"
     " 5 arc X7 Z-8 G18 about -6 7 by -90; 6 line X9; 6 line X10 Z-9; 7 line Z-14; 8 line X20;"
     " 9 rapid~ Z2"},
    {"G0 X40. Z2. S500 M3\nG72 W3. R.5\nG72 P1 Q2 U.2 W.2 F.2\nN1 G0 Z-9.\nG1 X20.\n"
     "G3 X10. Z-4. R5.\nN2 G1 Z2.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; 3 rapid~ Z-1; 3 line~ X5.1 F0.2;"
     " 3 rapid~ X5.6 Z-0.5; 3 rapid~ X20; 3 rapid~ Z-4; 3 line~ X5.104002;"
     " 3 rapid~ X5.604002 Z-3.5; 3 rapid~ X20; 3 rapid~ Z-7; 3 line~ X6.258125;"
     " 3 rapid~ X6.758125 Z-6.5; 3 rapid~ X20; 3 rapid~ Z-8.8; 3 line~ X10.1;"
     " 3 rapid~ X10.6 Z-8.3; 3 rapid~ X20.1; 3 line Z-8.8; 3 line X10.1;"
     " 3 arc X5.1 Z-3.8 G18 about -3.8 10.1 by 90; 3 line Z2.2; 3 rapid~ X20; 3 rapid~ Z2"},
    {"G0 X40. Z2. S500 M3\nG71 U4. R0\nG71 P1 Q2 F.2\nN1 G0 X10.\nM98 P3\nN2 G1 Z-10.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X20 Z2; !5:1 contour M 98/0"},
};

static void a_contour_of_fanucs_is_cut(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, fpockets_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_contour_of_rs274ngc_is_cut);
    CHECK_RUN(&check, a_contour_of_fanucs_is_cut);
    return check_end(&check);
}
