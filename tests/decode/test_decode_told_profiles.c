// SPDX-License-Identifier: MIT
// Room 1: contours with walls, pockets and arcs, and words that they do not have.
#include "told_check.h"

static told_t self;

static const told_row_t profiles_rows[] = {
    {"o1 sub\nG0 X4\nG1 Z-6\nX9 Z-10\no1 endsub\nG0 X14 Z2 F100\nG70 Q1 X14 Z2 D2 E1 P2\n"
     "G70 Q1 X14 Z2 E.5\nG70 Q1 X14 Z2 D1\nG0 X14 Z2\n",
     "6 rapid X14 Z2; 7 rapid~ Z5.075; 7 rapid~ X7.075; 7 comp G18 -1.5 nose 0 0;"
     " 7 line X4 F100; 7 line Z2; 7 line Z-6; 7 line X9 Z-10; 7 comp G18 0 nose 0 0;"
     " 7 rapid~ X14 Z-8.828697; 7 rapid~ Z2; 7 rapid~ Z4.05; 7 rapid~ X6.05;"
     " 7 comp G18 -1 nose 0 0; 7 line X4; 7 line Z2; 7 line Z-6; 7 line X9 Z-10;"
     " 7 comp G18 0 nose 0 0; 7 rapid~ X14 Z-9.219131; 7 rapid~ Z2; 8 rapid~ Z3.025;"
     " 8 rapid~ X5.025; 8 comp G18 -0.5 nose 0 0; 8 line X4; 8 line Z2; 8 line Z-6;"
     " 8 line X9 Z-10; 8 comp G18 0 nose 0 0; 8 rapid~ X14 Z-9.609566; 8 rapid~ Z2;"
     " 9 rapid~ X4; 9 line Z-6; 9 line X9 Z-10; 9 rapid~ X14; 9 rapid~ Z2; 10 rapid"},
    {"o1 sub\nG0 X4\nG1 Z-6\nG3 X6 Z-11 R3\no1 endsub\nG0 X14 Z2 F100\nG70 Q1 X14 Z2 E.5\n",
     "6 rapid X14 Z2; 7 rapid~ Z3.025; 7 rapid~ X5.025; 7 comp G18 -0.5 nose 0 0;"
     " 7 line X4 F100; 7 line Z2; 7 line Z-6; 7 arc X6 Z-11 G18 about -8.9913 3.77174 by 127.6699;"
     " 7 comp G18 0 nose 0 0; 7 rapid~ X14 Z-11.334783; 7 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z-6\nG2 X6 Z-11 R3\no1 endsub\nG0 X14 Z2 F100\nG70 Q1 X14 Z2 E.5\n",
     "6 rapid X14 Z2; 7 rapid~ Z3.025; 7 rapid~ X5.025; 7 comp G18 -0.5 nose 0 0;"
     " 7 line X4 F100; 7 line Z2; 7 line Z-6; 7 arc X6 Z-11 G18 about -8.0087 6.22826 by -127.6699;"
     " 7 comp G18 0 nose 0 0; 7 rapid~ X14 Z-10.501449; 7 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z-6\nG2 X5.8 Z-6 R.9\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D.5\n",
     "6 rapid X14 Z2; !4:0 contour Z; ?7:0 called-from"}, // half circles come back
    {"o1 sub\nG0 X4\nG1 Z-6\nG3 X5.8 Z-6 R.9\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D.5\n",
     "6 rapid X14 Z2; !4:0 contour Z; ?7:0 called-from"},
    {"o1 sub\nG0 X4\nG1 Z-6\nX9 Z-10\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2 D0 I0 R1\n",
     "6 rapid X14 Z2; !7:18 number-range I"},
    {"F9 G71 Q1 X14 Z2 D0 I-1 R1\n",
     "!1:21 number-range I -1/0"},
    {"F9 G71 Q1 X14 Z2 D-1 I1 R1\n",
     "!1:18 number-range D -1/0"},
    {"F9 G71 Q1 X14 Z2 D0 I1 R-1\n",
     "!1:24 number-range R -1/0"},
    {"F9 G71 Q1 X14 Z2 D0 I1 R1 P2\n",
     "!1:0 label-missing 1/0; ?1:0 called-from"},
    {"F9 G71 Q1 X14 Z2 D0 I1 R1 E2\n",
     "!1:0 label-missing 1/0; ?1:0 called-from"},
    {"F9 G71 Q1 X14 Z2 D0 I1 R1 U2\n",
     "!1:27 axis-unknown U"},
    {"F9 G71 X14 Z2 D0 I1 R1\n",
     "!1:4 word-missing Q"},
    {"F9 G71 Q9 X14 Z2 D0 I1 R1\n",
     "!1:0 label-missing 9/0; ?1:0 called-from"},
    {"F9 G70 Q1.5 X14 Z2\n",
     "!1:8 number-range Q 1.5/99999999"},
    {"F9 G70 Q1 X14 Z2 P0\n",
     "!1:18 number-range P 0/1"},
    {"F9 G70 Q1 X14 Z2 P1.5\n",
     "!1:18 number-range P 1.5/1000"},
    {"F9 G70 Q1 X14 Z2 D-1\n",
     "!1:18 number-range D -1/0"},
    {"F9 G70 Q1 X14 Z2 E-1\n",
     "!1:18 number-range E -1/0"},
    {"F9 G71.3 Q1 X14 Z2\n",
     "!1:4 g-unknown G 71.3/0"},
    {"F9 G17 G71 Q1 X14 Z2\n",
     "!1:0 contour G 17/0"},
    {"F9 G20 G71 Q1 X1 Z1\n",
     "?1:0 feed-units; !1:8 word-missing I"},
    {"F9 G93 G71 Q1 X1 Z1\n",
     "!1:0 unsupported G 93/0"},
    {"F9 G41.1 D1\nG71 Q1 X1 Z1\n",
     "1 comp G18 0.5 nose 0 0; !2:0 comp-on G 71/0"},
    {"F9 G71 Q1 X1 Z1 M2\n",
     "!1:17 modal-group M 2/0"},
    {"o1 sub\nG0 X4\nG1 Z-6\nX9 Z-10\no1 endsub\nG0 X14 Z2 F100\nG71 Q1 X14 Z2\n",
     "6 rapid X14 Z2; 7 rapid~ X13; 7 line~ Z-10 F100; 7 rapid~ X13.5 Z-9.5; 7 rapid~ Z2;"
     " 7 rapid~ X12; 7 line~ Z-10; 7 rapid~ X12.5 Z-9.5; 7 rapid~ Z2; 7 rapid~ X11;"
     " 7 line~ Z-10; 7 rapid~ X11.5 Z-9.5; 7 rapid~ Z2; 7 rapid~ X10; 7 line~ Z-10;"
     " 7 rapid~ X10.5 Z-9.5; 7 rapid~ Z2; 7 rapid~ X9; 7 line~ Z-10; 7 rapid~ X9.5 Z-9.5;"
     " 7 rapid~ Z2; 7 rapid~ X8; 7 line~ Z-9.2; 7 rapid~ X8.5 Z-8.7; 7 rapid~ Z2; 7 rapid~ X7;"
     " 7 line~ Z-8.4; 7 rapid~ X7.5 Z-7.9; 7 rapid~ Z2; 7 rapid~ X6; 7 line~ Z-7.6;"
     " 7 rapid~ X6.5 Z-7.1; 7 rapid~ Z2; 7 rapid~ X5; 7 line~ Z-6.8; 7 rapid~ X5.5 Z-6.3;"
     " 7 rapid~ Z2; 7 rapid~ X4; 7 line~ Z-6; 7 rapid~ X4.5 Z-5.5; 7 rapid~ Z2; 7 line X4;"
     " 7 line Z-6; 7 line X9 Z-10; 7 rapid~ X14; 7 rapid~ Z2"},
    {"o1 sub\nG0 Z-4\nG1 X10\nG2 X8 Z-2 R2\nG1 X4\nG3 X2 Z0 R2\no1 endsub\nG0 X14 Z2\n"
     "G72 Q1 X14 Z2 D0 I2 R.5 F100\n",
     "8 rapid X14 Z2; 9 rapid~ Z0; 9 line~ X2 F100; 9 rapid~ X2.5 Z0.5; 9 rapid~ X14;"
     " 9 rapid~ Z-2; 9 line~ X4; 9 rapid~ X4.5 Z-1.5; 9 rapid~ X14; 9 rapid~ Z-4; 9 line~ X10;"
     " 9 rapid~ X10.5 Z-3.5; 9 rapid~ X14; 9 line Z-4; 9 line X10;"
     " 9 arc X8 Z-2 G18 about -4 8 by -90; 9 line X4; 9 arc X2 Z0 G18 about 0 4 by 90;"
     " 9 rapid~ Z2; 9 rapid~ X14"},
    {"o1 sub\nG0 X4\nG1 Z-2\nG2 X8 Z-6 R4\nX8 Z-12 R3.1\nG3 X12 Z-16 R4\no1 endsub\nG0 X16 Z2\n"
     "G71.2 Q1 X16 Z2 D0 I3 R.5 F100\n",
     "8 rapid X16 Z2; 9 rapid~ Z-6.462688; 9 line~ X7 F100; 9 line~ Z-11.537312;"
     " 9 rapid~ X7.5 Z-11.037312; 9 rapid~ X16; 9 rapid~ Z2; 9 rapid~ X7.5; 9 line X4;"
     " 9 line Z-2; 9 arc X8 Z-6 G18 about -2 8 by -90;"
     " 9 arc Z-12 G18 about -9 8.78102 by -150.8149; 9 arc X12 Z-16 G18 about -16 8 by 90;"
     " 9 rapid~ X16; 9 rapid~ Z2"},
    {"o1 sub\nG0 X10\nG1 Z-2\nX6 Z-4\nZ-6\nX10 Z-8\nX8 Z-9\nZ-10\nX12 Z-12\no1 endsub\n"
     "G0 X13 Z1\nG71 Q1 X13 Z1 D0 I2 R.5 F100\nG71.1 Q1 X13 Z1 D0 I2 R.5\n"
     "G71.2 Q1 X13 Z1 D0 I2 R.5\n",
     "11 rapid X13 Z1; 12 rapid~ X11; 12 line~ Z-11.5 F100; 12 rapid~ X11.5 Z-11;"
     " 12 rapid~ Z-2.5; 12 line~ X9; 12 line~ Z-7.5; 12 rapid~ X9.5 Z-7; 12 rapid~ X11.5;"
     " 12 rapid~ Z-8.5; 12 line~ X9; 12 line~ Z-10.5; 12 rapid~ X9.5 Z-10; 12 rapid~ X11.5;"
     " 12 rapid~ Z-3.5; 12 rapid~ X9.5; 12 line~ X7; 12 line~ Z-6.5; 12 rapid~ X7.5 Z-6;"
     " 12 rapid~ Z-4; 12 line~ X6; 12 line~ Z-6; 12 rapid~ X6.5 Z-5.5; 12 rapid~ X11.5;"
     " 12 rapid~ Z1; 12 line X10; 12 line Z-2; 12 line X6 Z-4; 12 line Z-6; 12 line X10 Z-8;"
     " 12 line X8 Z-9; 12 line Z-10; 12 line X12 Z-12; 12 rapid~ X13; 12 rapid~ Z1;"
     " 13 rapid~ X11; 13 line~ Z-11.5; 13 rapid~ X11.5 Z-11; 13 rapid~ Z1; 13 line X10;"
     " 13 line Z-11; 13 line X12 Z-12; 13 rapid~ X13; 13 rapid~ Z1; 14 rapid~ Z-2.5;"
     " 14 line~ X9; 14 line~ Z-7.5; 14 rapid~ X9.5 Z-7; 14 rapid~ X13; 14 rapid~ Z-8.5;"
     " 14 line~ X9; 14 line~ Z-10.5; 14 rapid~ X9.5 Z-10; 14 rapid~ X13; 14 rapid~ Z-3.5;"
     " 14 rapid~ X9.5; 14 line~ X7; 14 line~ Z-6.5; 14 rapid~ X7.5 Z-6; 14 rapid~ Z-4;"
     " 14 line~ X6; 14 line~ Z-6; 14 rapid~ X6.5 Z-5.5; 14 rapid~ X13; 14 rapid~ Z1;"
     " 14 rapid~ X12.5; 14 line X10; 14 line Z-2; 14 line X6 Z-4; 14 line Z-6; 14 line X10 Z-8;"
     " 14 line X8 Z-9; 14 line Z-10; 14 line X12 Z-12; 14 rapid~ X13; 14 rapid~ Z1"},
    {"o1 sub\nG0 X4\nG1 Z-6\nX12 Z-10\no1 endsub\nG43.1 X1 Z2\nG10 L2 P1 X1 Z1\nG0 X14 Z2\n"
     "G71 Q1 X14 Z2 D0 I4 R1 F100\nG7 G71 Q1 X28 Z2 D0 I4 R1\n",
     "8 rapid X15 Z3 tool X1 tool Z2; 9 rapid~ X11; 9 line~ Z-8 F100; 9 rapid~ X12 Z-7;"
     " 9 rapid~ Z3; 9 rapid~ X7; 9 line~ Z-6; 9 rapid~ X8 Z-5; 9 rapid~ Z3; 9 rapid~ X5;"
     " 9 line~ Z-5; 9 rapid~ X6 Z-4; 9 rapid~ Z3; 9 line X5; 9 line Z-5; 9 line X13 Z-9;"
     " 9 rapid~ X15; 9 rapid~ Z3; 10 rapid~ X11; 10 line~ Z-9; 10 rapid~ X12 Z-8; 10 rapid~ Z3;"
     " 10 rapid~ X7; 10 line~ Z-9; 10 rapid~ X8 Z-8; 10 rapid~ Z3; 10 rapid~ X3; 10 line~ Z-5;"
     " 10 rapid~ X4 Z-4; 10 rapid~ Z3; 10 line X3; 10 line Z-5; 10 line X7 Z-9; 10 rapid~ X15;"
     " 10 rapid~ Z3"},
    {"o1 sub\nG0 X4\nG1 X5 Z-2\nG3 X9 Z-6 I0 K-4\nG1 Z-8\no1 endsub\nG0 X14 Z2\n"
     "G71 Q1 X14 Z2 D1 I4 R1 F100\n",
     "7 rapid X14 Z2; 8 rapid~ X10; 8 line~ Z-8 F100; 8 rapid~ X11 Z-7; 8 rapid~ Z2;"
     " 8 rapid~ X6; 8 line~ Z-1.101021; 8 rapid~ X7 Z-0.101021; 8 rapid~ Z4.48599;"
     " 8 line X5.491594; 8 comp G18 -1 nose 0 0; 8 line X3.502802 Z3.988792; 8 line X4 Z2;"
     " 8 line X5 Z-2; 8 arc X9 Z-6 G18 about -6 5 by 90; 8 line Z-8; 8 comp G18 0 nose 0 0;"
     " 8 rapid~ X14; 8 rapid~ Z2"},
    {"o1 sub\nG1 X4 F3\nZ-6\nX12 Z-10\no1 endsub\nG0 X14 Z2\nG71 Q1 X14 Z2 D0 I4 R1 F100\n",
     "6 rapid X14 Z2; 7 line~ X10 F100; 7 line~ Z-9; 7 rapid~ X11 Z-8; 7 rapid~ Z2; 7 line~ X6;"
     " 7 line~ Z-7; 7 rapid~ X7 Z-6; 7 rapid~ Z2; 7 line~ X4; 7 line~ Z-6; 7 rapid~ X5 Z-5;"
     " 7 rapid~ Z2; 7 line X4; 7 line Z-6; 7 line X12 Z-10; 7 rapid~ X14; 7 rapid~ Z2"},
    {"o1 sub\nG0 X4 Z1\nG1 Z-6\nX12 Z-10\no1 endsub\nG0 X14 Z2\nG71 Q1 X14 Z2 D0 I4 R1 F100\n",
     "6 rapid X14 Z2; 7 rapid~ X10; 7 line~ Z-9 F100; 7 rapid~ X11 Z-8; 7 rapid~ Z2;"
     " 7 rapid~ X6; 7 line~ Z-7; 7 rapid~ X7 Z-6; 7 rapid~ Z2; 7 rapid~ X4; 7 line~ Z-6;"
     " 7 rapid~ X5 Z-5; 7 rapid~ Z1; 7 line X4; 7 line Z-6; 7 line X12 Z-10; 7 rapid~ X14;"
     " 7 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG91 G1 Z-8\nX5 Z-4\nG90\no1 endsub\nG0 X14 Z2\n"
     "G71 Q1 X14 Z2 D0 I4 R1 F100\nG0 X20\n",
     "7 rapid X14 Z2; 8 rapid~ X10; 8 line~ Z-10 F100; 8 rapid~ X11 Z-9; 8 rapid~ Z2;"
     " 8 rapid~ X6; 8 line~ Z-7.6; 8 rapid~ X7 Z-6.6; 8 rapid~ Z2; 8 rapid~ X4; 8 line~ Z-6;"
     " 8 rapid~ X5 Z-5; 8 rapid~ Z2; 8 line X4; 8 line Z-6; 8 line X9 Z-10; 8 rapid~ X14;"
     " 8 rapid~ Z2; 9 rapid X20"},
    {"o1 sub\nG0 X4\nG1 Z-6 C1\nX9 A2\nZ-12\nX14\no1 endsub\nG0 X14 Z2\nG70 Q1 X14 Z2 F9\n",
     "8 rapid X14 Z2; 9 rapid~ X4; 9 line Z-5 F9; 9 line X5 Z-6; 9 line X7;"
     " 9 arc X9 Z-8 G18 about -8 7 by 90; 9 line Z-12; 9 line X14; 9 rapid~ Z2"},
    {"o1 sub\nG0 X4\nG1 Z-6 C1\nG2 X9 Z-11 R5\no1 endsub\nG0 X14 Z2\nG70 Q1 X14 Z2 F9\n",
     "6 rapid X14 Z2; !4:0 contour C 1/0; ?7:0 called-from"},
};

static void contours_of_rs274ngc_are_cut_level_by_level(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_lathe(&self);
    TOLD(check, &self, profiles_rows);
}

static const told_row_t fprofiles_rows[] = {
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2 U.4 W.2\nN1 G0 X10.\nG1 Z-5.\n"
     "G2 X14. Z-7. R2.\nG1 Z-10.\nG3 X20. Z-13. R3.\nN2 G1 X24. Z-15.\nG70 P1 Q2\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ X13; 3 line~ Z-14.8 F0.2;"
     " 3 rapid~ X13.5 Z-14.3; 3 rapid~ Z2; 3 rapid~ X11; 3 line~ Z-13.6; 3 rapid~ X11.5 Z-13.1;"
     " 3 rapid~ Z2; 3 rapid~ X9; 3 line~ Z-10.4; 3 rapid~ X9.5 Z-9.9; 3 rapid~ Z2; 3 rapid~ X7;"
     " 3 line~ Z-6.789975; 3 rapid~ X7.5 Z-6.289975; 3 rapid~ Z2; 3 rapid~ X5.2; 3 line~ Z-4.8;"
     " 3 rapid~ X5.7 Z-4.3; 3 rapid~ Z2.2; 3 line X5.2; 3 line Z-4.8;"
     " 3 arc X7.2 Z-6.8 G18 about -4.8 7.2 by -90; 3 line Z-9.8;"
     " 3 arc X10.2 Z-12.8 G18 about -12.8 7.2 by 90; 3 line X12.2 Z-14.8; 3 rapid~ X15;"
     " 3 rapid~ Z2; 4 rapid X5; 5 line Z-5; 6 arc X7 Z-7 G18 about -5 7 by -90; 7 line Z-10;"
     " 8 arc X10 Z-13 G18 about -13 7 by 90; 9 line X12 Z-15; 10 rapid~ X15 Z2"},
    {"G0 X10. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2 U-.4 W.2\nN1 G0 X30.\nG1 Z-5.\n"
     "G3 X26. Z-7. R2.\nG1 Z-10.\nN2 X10. Z-15.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X5 Z2; 3 rapid~ X7; 3 line~ Z-13.425 F0.2;"
     " 3 rapid~ X6.5 Z-12.925; 3 rapid~ Z2; 3 rapid~ X9; 3 line~ Z-12.175;"
     " 3 rapid~ X8.5 Z-11.675; 3 rapid~ Z2; 3 rapid~ X11; 3 line~ Z-10.925;"
     " 3 rapid~ X10.5 Z-10.425; 3 rapid~ Z2; 3 rapid~ X13; 3 line~ Z-6.789975;"
     " 3 rapid~ X12.5 Z-6.289975; 3 rapid~ Z2; 3 rapid~ X14.8; 3 line~ Z-4.8;"
     " 3 rapid~ X14.3 Z-4.3; 3 rapid~ Z2.2; 3 line X14.8; 3 line Z-4.8;"
     " 3 arc X12.8 Z-6.8 G18 about -4.8 12.8 by 90; 3 line Z-9.8; 3 line X4.8 Z-14.8;"
     " 3 rapid~ Z2; 3 rapid~ X5"},
    {"G0 X30. Z2. S500 M3 F.2\nG72 W2. R.5\nG72 P1 Q2 U.4 W.2\nN1 G0 Z-13.\nG1 X20.\n"
     "G3 X14. Z-10. R3.\nG1 Z-6.\nG2 X10. Z-4. R2.\nN2 G1 Z2.\nG70 P1 Q2\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 rapid~ Z0; 3 line~ X5.2 F0.2;"
     " 3 rapid~ X5.7 Z0.5; 3 rapid~ X15; 3 rapid~ Z-2; 3 line~ X5.2; 3 rapid~ X5.7 Z-1.5;"
     " 3 rapid~ X15; 3 rapid~ Z-4; 3 line~ X6.07178; 3 rapid~ X6.57178 Z-3.5; 3 rapid~ X15;"
     " 3 rapid~ Z-6; 3 line~ X7.2; 3 rapid~ X7.7 Z-5.5; 3 rapid~ X15; 3 rapid~ Z-8;"
     " 3 line~ X7.2; 3 rapid~ X7.7 Z-7.5; 3 rapid~ X15; 3 rapid~ Z-10; 3 line~ X7.206674;"
     " 3 rapid~ X7.706674 Z-9.5; 3 rapid~ X15; 3 rapid~ Z-12; 3 line~ X8.160392;"
     " 3 rapid~ X8.660392 Z-11.5; 3 rapid~ X15; 3 rapid~ Z-12.8; 3 line~ X10.2;"
     " 3 rapid~ X10.7 Z-12.3; 3 rapid~ X15.2; 3 line Z-12.8; 3 line X10.2;"
     " 3 arc X7.2 Z-9.8 G18 about -9.8 10.2 by 90; 3 line Z-5.8;"
     " 3 arc X5.2 Z-3.8 G18 about -5.8 5.2 by -90; 3 line Z2.2; 3 rapid~ X15; 3 rapid~ Z2;"
     " 4 rapid Z-13; 5 line X10; 6 arc X7 Z-10 G18 about -10 10 by 90; 7 line Z-6;"
     " 8 arc X5 Z-4 G18 about -6 5 by -90; 9 line Z2; 10 rapid~ X15"},
    {"G0 X30. Z2. S500 M3 F.2\nG73 U2. W1. R1\nG73 P1 Q2 U.4 W.2\nN1 G0 X10.\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:13 number-range R 1/2;"
     " !3:1 word-missing R; 4 rapid X5; 5 line Z-5 F0.2"},
    {"G0 X30. Z2. S500 M3 F.2\nG73 U2. W1.\nG73 U2. W1. R0\nG73 U2. W1. R2.5\nG73 W1. R2\n"
     "G73 U-2. W-1. R2\nG73 P1 Q2 U-.4 W-.2\nN1 G0 X10.\nG1 Z-5.\nN2 G2 X16. Z-8. R3.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !3:13 number-range R 0/2;"
     " !4:13 number-range R 2.5/1000; 7 rapid~ X12.8 Z0.8; 7 rapid~ X2.8; 7 line Z-6.2 F0.2;"
     " 7 arc X5.8 Z-9.2 G18 about -6.2 5.8 by -90; 7 rapid~ X14.8 Z1.8; 7 rapid~ X4.8;"
     " 7 line Z-5.2; 7 arc X7.8 Z-8.2 G18 about -5.2 7.8 by -90; 7 rapid~ X15 Z2"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U-2. R.5\nG71 R.5\nG71 U2.\nG71 U2. R.5\n"
     "G71 P1 Q2 U.4 W.2 X5.\nG71 P1 Q2 U.4 W.2 K5.\nG71 P1 Q2 U-.4\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !2:5 number-range U -2/0;"
     " !6:19 word-unused X; !7:19 word-unused K; !8:0 contour P 1/100; 8 end M2"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2 U-.4\nN1 G0 X10.\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !3:0 contour U -0.4/0"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2 W-.4\nN1 G0 X10.\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !3:0 contour W -0.4/0"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2\nN1 G2 X10. Z-3. R50.\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !4:0 contour G 2/0"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2\nN1 G1 X10. F.5\nN2 G1 Z-5. F.4\n"
     "G70 P1 Q2\nG1 X50.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 3 line~ X13 F0.2; 3 line~ Z-5;"
     " 3 rapid~ X13.5 Z-4.5; 3 rapid~ Z2; 3 line~ X11; 3 line~ Z-5; 3 rapid~ X11.5 Z-4.5;"
     " 3 rapid~ Z2; 3 line~ X9; 3 line~ Z-5; 3 rapid~ X9.5 Z-4.5; 3 rapid~ Z2; 3 line~ X7;"
     " 3 line~ Z-5; 3 rapid~ X7.5 Z-4.5; 3 rapid~ Z2; 3 line~ X5; 3 line~ Z-5;"
     " 3 rapid~ X5.5 Z-4.5; 3 rapid~ Z2; 3 line X5; 3 line Z-5; 3 rapid~ X15; 3 rapid~ Z2;"
     " 4 line X5 F0.5; 5 line Z-5 F0.4; 6 rapid~ X15 Z2; 7 line X25"},
    {"G0 X30. Z2. S500 M3 F.2\nN1 G0 X10.\nN2 G1 Z-5.\n"
     "G70 P1 Q2 I1.\nG70 P1 Q2 D1\nG70 P1 Q2 R1.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 2 rapid X5; 3 line Z-5 F0.2;"
     " !4:11 word-unused I; !5:11 word-unused D; !6:11 word-unused R"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U.001 R.5\nG71 P1 Q2\nN1 G0 X30.\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !3:0 contour"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2\nN1 G0 X10.\nG54\nN2 G1 Z-5.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !5:1 contour G 54/0"},
    {"G0 X30. Z2. S500 M3 F.2\nG71 U2. R.5\nG71 P1 Q2\nN1 G0 X10.\nG1 Z-3. ,R1.\n"
     "N2 G1 X14. ,R1.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; !6:13 corner R 1/0"},
    {"G0 X30. Z2. S500 M3\nG98 F100.\nG71 U5. R.5\nG71 P1 Q2 F200.\nN1 G0 X10.\nN2 G1 Z-5.\n"
     "G1 X31.\n",
     "1 out S500 per-rev; 1 out M3 S500; 1 rapid X15 Z2; 4 rapid~ X10 per-min;"
     " 4 line~ Z-5 F200; 4 rapid~ X10.5 Z-4.5; 4 rapid~ Z2; 4 rapid~ X5; 4 line~ Z-5;"
     " 4 rapid~ X5.5 Z-4.5; 4 rapid~ Z2; 4 line X5; 4 line Z-5; 4 rapid~ X15; 4 rapid~ Z2;"
     " 7 line X15.5"},
};

static void contours_of_fanucs_are_cut_level_by_level(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, fprofiles_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, contours_of_rs274ngc_are_cut_level_by_level);
    CHECK_RUN(&check, contours_of_fanucs_are_cut_level_by_level);
    return check_end(&check);
}
