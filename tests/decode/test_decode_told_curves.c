// SPDX-License-Identifier: MIT
// Room 1: splines as chords of half a millimetre, probes, places that are mapped.
#include "told_check.h"

static told_t self;

static const told_row_t spline_rows[] = {
    {"G17 F100 G5 X10 Y0 I0 J5 P0 Q5\n",
     "1 line X1.5625 Y2.8125 F100; 1 line X5 Y3.75; 1 line X8.4375 Y2.8125; 1 line X10 Y0"},
    {"F100 G5 X2 Y0 I1 J1 P-1 Q1\nX4 Y0 P-1 Q-1\nG5 X6 Y0 P0 Q0\n",
     "1 line X1 Y0.75 F100; 1 line X2 Y0; 2 line X3 Y-0.75; 2 line X4 Y0; 3 line X6"},
    {"F100 G5.1 X4 Y0 I2 J3\nX8 I2 J-3\nG91 G5.1 X2 Y2 I1 J0\n",
     "1 line X2 Y1.5 F100; 1 line X4 Y0; 2 line X6 Y-1.5; 2 line X8 Y0; 3 line X10 Y2"},
    {"F100 G5.2 X1 Y1 P1 L3\nX2 Y0 P1\nX3 Y1 P2\nG5.3\n",
     "4 line X1.5 Y0.5 F100; 4 line X3 Y1"},
    {"F100 G5.2 P2\nX1 Y2 P1\nX4 Y0 P.5\nG5.3\nG0 X5\n",
     "4 line X0.888889 Y0.888889 F100; 4 line X4 Y0; 5 rapid X5"},
    {"F100 G1 X1\nG5 X2 P1\nG5 X2 Q1\nG5 P1 Q1\nG5 X2 Z1 P1 Q1\nG5.1 X2 I1\nG5.1 X2 J1\n"
     "G5.1 I1 J1\nG5.1 X2 A1 I1 J1\nG18 G5 X2 P1 Q1\nG17 G93 G5 X2 P1 Q1 I1 J1 F1\nG5.2 X1 P1\n"
     "G5.2 X1 Y1\nG5.2 X1 Y1 P0\nG5.2 X1 Y1 P-1\nG5.2 X1 Y1 P1 L1\nG5.2 X1 Y1 P1 L9\nG5.3\n",
     "1 line X1 F100; !2:1 word-missing Q 5/0; !3:1 word-missing P 5/0;"
     " !4:1 word-missing X 5/0; !5:1 spline Z; !6:1 word-missing J 5.1/0;"
     " !7:1 word-missing I 5.1/0; !8:1 word-missing X 5.1/0; !9:9 axis-unknown A;"
     " !10:5 spline G 18/17; !11:0 unsupported G 93/0; !12:1 word-missing Y 5.2/0;"
     " !13:1 word-missing P 5.2/0; !14:12 number-range P 0/1000000;"
     " !15:12 number-range P -1/1000000; !16:15 number-range L 1/8; !17:15 number-range L 9/8"},
    {"F100 G5.2 X1 Y1 P1\nG5.3\n",
     "!2:1 spline L 2/3"},
    {"F100 G5.2 X1 Y1 P1\nX2 Y2 P1\nG0 X5\nG5.3\n",
     "!3:1 spline G 5.2/0"},
    {"F100 G5.2 X1 Y1 P1\nX2 Y2 P1\n",
     "!1:6 spline M 5.2/0"},
    {"F100 G5.2 X1 Y1 P1 L2\nX2 Y0 P1\nX3 Y5 P1\nG5.3\n",
     "4 line X1 Y1 F100; 4 line X2 Y0; 4 line X3 Y5"},
    {"G5 X10 Y0 I0 J5 P0 Q5\nF100 G5 X10 Y0 I0 J5 P0 Q5\nG5.1 X20 Y0 I5 J5 Z3\n"
     "G43.1 Z1 G5.1 X20 Y0 I5 J5\nG20 G5.1 X1 Y0 I0 J0\n",
     "!1:0 feed-missing F; 2 line X10 Y3.75 F100; 2 line Y0; !3:1 spline Z;"
     " !4:1 modal-group G 43.1/0; 5 line X25.4"},
};

static void a_spline_is_cut_into_chords(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.path.chord_error = 0.5;
    TOLD(check, &self, spline_rows);
}

static const told_row_t knots_rows[] = {
    {"G6.2 P3 K0. X0. Y0. Z0. R1. F100.\nK0. X2. Y2. Z0. R1.\nK0. X4. Y0. Z2. R1.\nK1.\nK1.\n"
     "K1.\nG0 X9.\n",
     "6 line X2 Y1 Z0.5 F100; 6 line X4 Y0 Z2; 7 rapid X9"},
    {"G6.2 P2 K0. X0. Y0. R1. F100.\nK0. X2. Y2.\nK1. X4. Y0.\nK2.\nK2.\nX3.\n",
     "5 line X2 Y2 F100; 5 line X4 Y0; !6:0 spline K"},
    {"G6.2 P4 K0. X0. Y0. R1. F100.\nK0. X2. Y2. R2.\nK0. X4. Y2. R.5\nK0. X6. Y0.\n"
     "K1. X8. Y1.\nK2.\nK2.\nK2.\nK2.\n",
     "9 line X2.085106 Y1.787234 F100; 9 line X3.5 Y1.5; 9 line X5.724138 Y0.551724;"
     " 9 line X8 Y1"},
    {"G6.2 P1 K0. X0. Y0. R1. F100.\n",
     "!1:6 number-range P 1/4"},
    {"G6.2 P9 K0. X0. Y0. R1. F100.\n",
     "!1:6 number-range P 9/4"},
    {"G6.2 P3 K1. X0. Y0. R1. F100.\nK0. X1. Y1.\n",
     "!2:1 spline K"},
    {"G6.2 P3 K0. X1. Y0. R1. F100.\nK0. X1. Y1.\nK0. X2. Y0.\nK1.\nK1.\nK1.\n",
     "!1:6 spline P 6.2/0"},
    {"G6.2 P3 K0. X0. Y0. R1. F100.\nK0. X1. Y1. R0.\n",
     "!2:13 number-range R 0/1000000"},
    {"G6.2 P3 K0. X0. Y0. R1. F100.\nG0 X1.\n",
     "!2:1 spline G 6.2/0"},
    {"G6.2 P3 K0. X0. Y0. R1. F100.\nK0. X1. Z1.\n",
     "!2:0 word-missing Y 6.2/0"},
    {"G91 G6.2 P3 K0. X0. Y0. R1. F100.\n",
     "!1:5 spline G 91/0"},
    {"G6.2 P3 K0 X0. Y0. R1. F100.\n",
     "!1:1 spline M 6.2/0"},
    {"G6.2 K0. X0. Y0. F100.\n",
     "!1:1 spline M 6.2/0"},
};

static void fanucs_spline_has_knots(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.path.chord_error = 0.5;
    TOLD(check, &self, knots_rows);
}

static const told_row_t probe_rows[] = {
    {"F100 G38.2 X10\nG38.3 Y5\nG38.4 X5\nG38.5 Z1\nX1\nG0 X[#5061] Y[#5062+1] Z[#5070]\n"
     "G38.2 X1\nG38.3 X1 Y6\nG38.2\nG93 F1 G38.3 X9\nG95 S1 M3 F1 G38.3 X9\n"
     "G91 G94 F50 G38.2 Z-1\nG38.3 Z0\nG38.6 Z1\n",
     "1 line X10 F100 stop; 2 line Y5; 3 line X5; 4 line Z1; 5 line X1; 6 rapid Y6 smooth;"
     " !7:1 probe X 38.2/0; 8 line stop; !9:1 word-missing X 38.2/0; !10:0 unsupported G 93/0;"
     " 11 out S1 smooth per-rev; 11 out M3 S1; !11:14 probe G 95/0;"
     " 12 line Z0 F50 stop per-min; 13 line; !14:1 g-unknown G 38.6/0"},
};

static void a_probe_touches(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.dialect.probe = NCK_PROBE_TOUCHES;
    TOLD(check, &self, probe_rows);
}

static const told_row_t probe_miss_rows[] = {
    {"F100 G38.2 X10\nG38.3 Y5\nG38.4 X5\nG38.5 Z1\nX1\nG0 X[#5061] Y[#5062+1] Z[#5070]\n"
     "G38.2 X1\nG38.3 X1 Y6\nG38.2\nG93 F1 G38.3 X9\nG95 S1 M3 F1 G38.3 X9\n"
     "G91 G94 F50 G38.2 Z-1\nG38.3 Z0\nG38.6 Z1\n",
     "!1:6 probe G 38.2/0; 2 line X10 Y5 F100 stop; !3:1 probe G 38.4/0; 4 line X5 Z1;"
     " 5 line X1; 6 rapid Y6 Z0 smooth; !7:1 probe X 38.2/0; 8 line stop;"
     " !9:1 word-missing X 38.2/0; !10:0 unsupported G 93/0; 11 out S1 smooth per-rev;"
     " 11 out M3 S1; !11:14 probe G 95/0; !12:13 probe G 38.2/0; 13 line Z-1 F50 stop per-min;"
     " !14:1 g-unknown G 38.6/0"},
};

static void a_probe_misses(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.dialect.probe = NCK_PROBE_MISSES;
    TOLD(check, &self, probe_miss_rows);
}

static const told_row_t layouts_rows[] = {
    {"G17 G16\nG0 X10. Y45.\nX20.\nY0\nG91 X5.\nY90.\nG90 G81 X10. Y90. Z-5. R1. F100.\n"
     "G91 Y30. K3\nG80 G15\nG0 X0 Y0\n",
     "2 rapid X7.071068 Y7.071068; 3 rapid X14.142136 Y14.142136; 4 rapid X20 Y0; 5 rapid X25;"
     " 6 rapid X20 Y5; 7 rapid~ Z1; 7 rapid~ X0 Y10; 7 line~ Z-5 F100; 7 rapid~ Z1;"
     " 8 rapid~ X-5 Y8.660254; 8 line~ Z-5; 8 rapid~ Z1; 8 rapid~ X-8.660254 Y5; 8 line~ Z-5;"
     " 8 rapid~ Z1; 8 rapid~ X-10 Y0; 8 line~ Z-5; 8 rapid~ Z1; 10 rapid"},
    {"G18 G16 G0 Z10. X90.\nG15\nG19 G16 G0 Y10. Z90.\nG15 G17\n",
     "1 rapid X10; 3 rapid Z10"},
    {"G68 X10. Y10. R90.\nG0 X20. Y10. Z5.\nF100. G2 X20. Y20. I0 J5.\nG91 X5.\nG90 G69\n",
     "2 rapid X10 Y20 Z5; 3 arc X0 G17 about 5 20 by -180 F100; !4:0 arc-centre"},
    {"G68 R30.\nG0 X10. Y0\nG69\nG91 G68 X1. Y1. R90.\nG90 G68 R90\nG68 X5. R90.\nG69\n"
     "G68 X1. Y1.\n",
     "2 rapid X8.660254 Y5; !4:5 incremental G 68/0; ?5:0 assumed-integers;"
     " !6:1 layout-on G 68/0; !8:1 word-missing R 68/0"},
    {"G18 G68 X0 Z0 R90.\nG0 X5. Z0\nG69\nG19 G68 Y0 Z0 R90.\nG0 Y5. Z0\n",
     "2 rapid Z-5; 5 rapid Z5"},
    {"G51 X10. Y0 Z0 P.5\nG0 X20. Y10. Z4.\nG91 X2.\nG90 G2 X24. Y10. R5. F100.\nX30. I3.\n"
     "G81 X0 Y0 Z-5. R1.\nG50\nG0 X0\n",
     "2 rapid X15 Y5 Z2; 3 rapid X16; 4 arc X17 G17 about 16.5 2.55051 by -23.0739 F100;"
     " 5 arc X20 G17 about 18.5 5 by -180; !6:0 layout-on Z; 8 rapid X0"},
    {"G51 I2. J2. K1.\nG0 X1. Y1. Z1.\nG3 X3. I1. F100.\nG3 X3. Y3. R5.\nG51 I2. J3. K1.\n"
     "G3 X3. I1.\nG51 X1. Y1. Z1. I1. J1. K2.\nG81 X1. Y1. Z-1. R1.\nG50\n",
     "2 rapid X2 Y2 Z1; 3 arc X6 G17 about 4 2 by 180 F100;"
     " 4 arc Y6 G17 about -3.79796 4 by 23.0739; !5:1 layout-on G 51/0;"
     " 6 arc G17 about 8 6 by 360; !7:1 layout-on G 51/0; 8 rapid~ X2 Y2; 8 line~ Z-1;"
     " 8 rapid~ Z1"},
    {"G51.1 X5. Y5.\nG0 X1. Y1.\nG2 X3. I1. F100.\nG50.1 X0\nX1. Y1.\nG51.1 Z1.\nZ2.\nG50.1\n"
     "Z2.\n",
     "2 rapid X9 Y9; 3 arc X7 G17 about 8 9 by -180 F100; !5:0 arc-centre; !7:0 arc-centre;"
     " !9:0 arc-centre"},
    {"G51.1 X0\nG68 X0 Y0 R90.\nG0 X10. Y0\nG50.1\nG69\nG50.1\nG0 X1.\n",
     "3 rapid Y-10; !4:1 layout-on G 50.1/0; 7 rapid X1"},
    {"G51 P2.\nG51.1 X1.\nG68 X0 Y0 R45.\nG16\nG0 X10. Y0\nG51 P3.\nG15\nG69\nG50.1\nG50\nX1.\n",
     "!2:1 layout-on G 51.1/0; 5 rapid X14.142136 Y14.142136; !6:1 layout-on G 51/0;"
     " 11 rapid X1"},
    {"G51\nG51 X1.\nG51 P0.\nG51 I0. J1. K1.\nG51 P2\nG51 P1.5 I2.\nG51 I2\nG51 P-1.\n"
     "G0 X1. Y2. Z3.\nG50\nG51.1\nG50.1 A1.\nG16 G0 X-5. Y0\nG15\n",
     "!1:1 word-missing P 51/0; !2:1 word-missing P 51/0; !3:5 number-range P 0/1000;"
     " !4:5 number-range I 0/1000; !5:5 scale-unit P 2/0; !6:5 word-shared P;"
     " !7:5 scale-unit I 2/0; 9 rapid X-1 Y-2 Z-3; !11:1 word-missing X 51.1/0;"
     " !12:7 axis-unknown A; 13 rapid X-5 Y0"},
    {"G16 G68 X0 Y0 R90.\nG51 P2. G50\nG15 G16\nG0 G68 X1. Y1. R0\n",
     "!2:9 modal-group G 50/0; !3:5 modal-group G 16/0; !4:4 layout-on G 68/0"},
    {"G16 G0 X5. Y30.\nG2 X10. Y0 R5. F100.\nG3 X10. Y90. I1.\nG0 X10.\nG91 X1.\nG15\n",
     "1 rapid X4.330127 Y2.5; 2 arc X10 Y0 G17 about 5.58178 -2.3408 by -76.5822 F100;"
     " !3:1 arc-radius 14.8660687/1; 4 rapid X0 Y10; 5 rapid Y11"},
};

static void layouts_map_places(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, layouts_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_spline_is_cut_into_chords);
    CHECK_RUN(&check, fanucs_spline_has_knots);
    CHECK_RUN(&check, a_probe_touches);
    CHECK_RUN(&check, a_probe_misses);
    CHECK_RUN(&check, layouts_map_places);
    return check_end(&check);
}
