// SPDX-License-Identifier: MIT
// Room 1: what stands beside each other in a line, threads and taps and their refusals.
#include "told_check.h"

static told_t self;

static const told_row_t rest_rows[] = {
    {"#1=3\nG0 X#1+2\nX#1 +2\nX[#1]+2\nX#1 Y#1 -2\nXABS[-1]+1\nX#1*2\nX1 +2\nX#1\n",
     "!2:7 number 43/0; !3:5 number 43/0; !4:6 number 43/0; !5:9 number 45/0; !6:9 number 43/0;"
     " !7:4 character 42/0; !8:4 number 43/0"},
    {"S100 M5\nF60 G0 Z5\nG84 X1 Z-1 R1\nM3 G84 X1 Z-1 R1\nM5\nG85 X1 Z-1 R1\nM4\n"
     "G86 X2 Z-1 R1 P0\nG74 X3 Z-1 R1\nM5 X4\n",
     "1 out S100; 1 out M5; 2 rapid Z5; !3:1 word-missing M; 4 out M3 S100; 4 rapid~ X1;"
     " 4 rapid~ Z1; 4 tap by 0 0 -2 lead 0.6 for 4.343; 5 out M5 S0; 6 line~ Z-1 F60;"
     " 6 line~ Z1; 7 out M4 S100; 8 rapid~ X2; 8 line~ Z-1; 8 out M5 S0; 8 rapid~ Z1;"
     " 8 out M4 S100; 9 rapid~ X3; 9 tap by 0 0 -2 lead 0.6 for 4.343; 10 out M5 S0;"
     " !10:0 word-missing M"},
    {"G54 X5 Y6\nG0 X5 Y6\nG92 X1 Y1\nG96 S100 D200 M3\nX2\nG52 X3\nX2\nG97 S50\n",
     "!1:5 no-motion X; 2 rapid X5 Y6; 4 out surface 100000; 4 out M3 S200 V100000 axis4;"
     " 5 rapid X6; 7 rapid X5 axis3; 8 out S50 S50 V0"},
    {"G33 Z-5\nG33 K1 Z1000001\nG33 X1 K1000001 S9 M3\nG33 K-1 Z1\nG33 X1 Y2 Z3 K1\n"
     "G33.1 Z-1000001 K1\nG33.1 Z-1 K0\nG33.1 Z-1 K-1\nG33.1 Z-1\nS9 M3 G33.1 X1 Y1 Z-1 K1\n"
     "G33.1 Z-2 K1 G91\nG33 Z1 K.5\nG20 G33 Z1 K.1\nG33.1 Z-1 K.1\nG33 Z1 K50000\n"
     "G33 Z.00001 K1\nG96 S1 D9 G33.1 Z9 K1\nG97 G93 F1 G33 Z9 K1\nG94 G41.1 D1\nG33 Z1 K1\n"
     "G33.1 Z1 K1\nG40\nZ5\n",
     "!1:1 word-missing K 33/0; !2:1 thread-speed S; 3 out S9; 3 out M3 S9;"
     " !3:8 number-range K 1000001/1000000; !4:5 number-range K -1/1000000;"
     " 5 thread X1 Y2 Z3 of 3.74165739 lead 1 for 28.29; !6:7 number-range Z -1000001/1000000;"
     " !7:11 number-range K 0/1000000; !8:11 number-range K -1/1000000;"
     " !9:1 word-missing K 33.1/0; 10 out M3; 10 tap by 0 -1 -4 lead 1 for 58.32;"
     " 11 tap by 0 0 -2 lead 1 for 30.02; 12 thread Z4 of 1 lead 0.5 for 16.67;"
     " 13 thread Z29.4 of 25.4 lead 2.54 for 70.01; 14 tap by 0 0 -25.4 lead 2.54 for 136.7;"
     " !15:8 number-range K 50000/39370.0787; !16:1 thread-run-in Z 0.160030001/0.000254;"
     " 17 out surface 304.8 Z29.400254 V304.8; !17:11 thread-speed G 96/0;"
     " 18 out S9 inverse V0; !18:0 unsupported G 93/0; 19 comp G17 12.7 nose 0 0 per-min;"
     " !20:0 comp-on G 33/0; !21:0 comp-on G 33.1/0; 22 comp G17 0 nose 0 0"},
    {"N10G0X1\nN 20 X2\nN30 N40 X3\nn50.5x4\nN-1 X5\nN X6\n N60 X7 N70\n/N80 X8\n/ N90 / X9\n"
     "N100 /X10\nN110%\nN120 (abort, no)\nX11\n",
     "1 rapid X1; 2 rapid X2; !3:5 word-twice N; 4 rapid X4; 5 rapid X5; !6:1 number N;"
     " !7:9 word-twice N; 8 rapid X8; !9:7 character 47/0; !10:6 character 47/0;"
     " !11:5 character 37/0; ?12:6 abort (; 12 end M2"},
};

static void lines_are_read_to_their_end(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, rest_rows);
}

static const told_row_t frest_rows[] = {
    {"N10G0X1.\nX1\nX+1\nX-1 Y+2.\nX#1\nX[1]\nX0\nX1.0\nX.5\nX5.\nX1 Y2 Z3.\nX 1 . 5\n"
     "X1000000\nX1000001\nG1 X1 F5\nX2 F6.\nN5 X3. (F9)\nX4.;F9\nX5. F\nX6. Q1\nX7. Y\nX8. G0\n"
     "X9.G1\nX10.M8\nX11. A1\nX12. U1\n/X13.\n%\nX14.\nN15\n:15 X15.\nX16. X17.\nX18. F1 F2\n"
     "X1e1\nX19.Y20.Z21.F22.\nx20.y21.\nX21. ( Y5.\nX22. ) Y5.\nX23.\tY24.\nF100. X25.\n"
     "S100 X26.\nT1 X27.\nG91 X1.\nY1. Z-1.\nG53 X1.\nG90 G53 X1.\n",
     "1 rapid X1; ?2:0 assumed-integers; 2 rapid; 3 rapid; 4 rapid X-1 Y2; 6 rapid X1;"
     " 7 rapid X0; 8 rapid X1; 9 rapid X0.5; 10 rapid X5; 11 rapid X1 Z3; 12 rapid X1.5;"
     " 13 rapid X1000000; !14:1 number-range X 1000001/1000000; 15 line X1 F5; 16 line X2 F6;"
     " 17 line X3; 18 line X4; !19:5 number F; !20:5 word-unused Q; !21:5 number Y;"
     " 22 rapid X8; 23 line X9; 24 out M8; 24 line X10; !25:6 axis-unknown A;"
     " !26:6 axis-unknown U; 27 line X13; 29 line X14; !31:1 unsupported O; !32:6 word-twice X;"
     " !33:9 word-twice F; !34:3 word-unknown E; 35 line X19 Y20 Z21 F22; 36 line X20 Y21;"
     " !37:6 comment; !38:6 character 41/0; 39 line X23 Y24; 40 line X25 F100; 41 out S100;"
     " 41 line X26; 42 out T1; 42 line X27; 43 line X28; 44 line Y25 Z20;"
     " !45:1 incremental G 53/0; 46 line X1"},
};

static void lines_of_fanucs_are_read_to_their_end(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, frest_rows);
}

static const told_row_t frest_lathe_rows[] = {
    {"M3 S9 G0 X9. Z9.\nG33 Z1. F1.\nG32 Z0. F1.\nG32 Z0 E1.\nG32 X1. Z-1. F2. Q1000\n"
     "G32 X1. Z-1. F2. Q360001\nG32 X1. Z-1. F2. Q-1\nG32 F2.\nG32 Z-2. F0\n"
     "G92 X1. Z1. F1. R5.\nG76 P1\nG74 R0\nG75 R0\nG75 X5. P0\nG28\nT1\n",
     "1 out S9 per-rev; 1 out M3 S9; 1 rapid X4.5 Z9; !2:1 unsupported G 33/0;"
     " 3 thread Z0 of 9 lead 1 for 63.34; !4:8 word-unknown E;"
     " 5 thread X0.5 Z-1 of 4 lead 2 at 0.00277778 for 16.68;"
     " !6:18 number-range Q 360001/360000; !7:18 number-range Q -1/360000;"
     " !9:10 number-range F 0/1000000; 10 rapid~ X5.5; 10 thread X0.5 Z1 of 5 lead 1 for 36.68;"
     " 10 rapid~ Z-1; !11:5 number-range P 1/999999; !14:9 number-range P; 15 rapid;"
     " 15 rapid X0 Z0; 16 out T1"},
};

static void threads_of_fanucs_are_refused_or_cut(check_t *check) {
    told_turning(&self);
    TOLD(check, &self, frest_lathe_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, lines_are_read_to_their_end);
    CHECK_RUN(&check, lines_of_fanucs_are_read_to_their_end);
    CHECK_RUN(&check, threads_of_fanucs_are_refused_or_cut);
    return check_end(&check);
}
