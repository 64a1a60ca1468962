// SPDX-License-Identifier: MIT
// Room 1: corners that are rounded or cut off, and what a text leaves unsaid.
#include "told_check.h"

static told_t self;

static const told_row_t corner2_rows[] = {
    {"G1 X10. ,R2. F100.\nG2 X20. Y10. R10.\nG1 X30.\n",
     "1 line X8.16784 F100; 1 arc X10.139867 Y1.666667 G17 about 8.16784 2 by 80.406;"
     " 2 arc X20 Y10 G17 about 20 0 by -80.4059; 3 line X30"},
    {"G1 X10. ,C2. F100.\nG2 X20. Y10. R10.\nG1 X30.\n",
     "1 line X8 F100; 1 line X10.2 Y1.989975; 2 arc X20 Y10 G17 about 20 0 by -78.5217;"
     " 3 line X30"},
    {"G2 X10. Y10. R10. ,R2. F100.\nG1 Y0\n",
     "1 arc X7.5 Y9.682458 G17 about 10 0 by -75.5225 F100;"
     " 1 arc X10 Y7.745967 G17 about 8 7.74597 by -104.4775; 2 line Y0"},
    {"G2 X10. Y10. R10. ,C2. F100.\nG1 Y0\n",
     "1 arc X8.010025 Y9.8 G17 about 10 0 by -78.5217 F100; 1 line X10 Y8; 2 line Y0"},
    {"G2 X10. Y10. R10. ,R1. F100.\nG2 X20. Y20. R10.\n",
     "1 arc X9.12892 Y9.961989 G17 about 10 0 by -85.0027 F100;"
     " 1 arc X10.038011 Y10.87108 G17 about 9.04181 10.95819 by 80.0055;"
     " 2 arc X20 Y20 G17 about 20 10 by -85.0027"},
    {"G2 X10. Y10. R10. ,C1. F100.\nG2 X20. Y20. R10.\n",
     "1 arc X9.001251 Y9.95 G17 about 10 0 by -84.268 F100; 1 line X10.05 Y10.998749;"
     " 2 arc X20 Y20 G17 about 20 10 by -84.268"},
    {"G3 X10. Y10. I0 J10. ,R1. F100.\nG3 X20. Y0 J-10.\n",
     "1 arc X9.930004 Y8.818893 G17 about 0 10 by 83.2169 F100;"
     " 1 arc X8.818893 Y9.930004 G17 about 8.937 8.937 by 103.5662;"
     " 2 arc X20 Y0 G17 about 10 0 by 263.2169"},
    {"G1 X10. ,R30. F100.\nG2 X20. Y10. R10.\n",
     "!1:10 corner R 30/0"},
    {"G18 G1 X10. ,R2. F100.\nZ10.\nX0 ,C3.\nZ0\nG19 G1 Y10. ,R2. F100.\nZ10.\nY0\n",
     "1 line X8 F100; 1 arc X10 Z2 G18 about 2 8 by -90; 2 line Z10; 3 line X3; 3 line X0 Z7;"
     " 4 line Z0; 5 line Y8; 5 arc Y10 Z2 G19 about 8 2 by 90; 6 line Z10; 7 line Y0"},
    {"G43.1 X1 Y2 Z3\n",
     "!1:1 unsupported G 43.1/0"},
    {"G91 G1 X10. ,R2. F100.\nY10. F50. M8\nX10. ,C1.\nG90 S100 M3 Y0\n",
     "1 line X8 F100; 1 arc X10 Y2 G17 about 8 2 by 90; 2 out M8; 2 line Y10 F50; 3 line X19;"
     " 3 line X20 Y9; 4 out S100; 4 out M3 S100; 4 line Y0"},
    {"G20 G1 X1. ,R.2 F10.\nY1.\n",
     "?1:0 feed-units; 1 line X20.32 F254; 1 arc X25.4 Y5.08 G17 about 20.32 5.08 by 90;"
     " 2 line Y25.4"},
    {"G1 X10. ,R2. F100.\nX20. Y10. ,R2.\nX30. Y0\nX40.\n",
     "1 line X9.171573 F100; 1 arc X10.585786 Y0.585786 G17 about 9.17157 2 by 45;"
     " 2 line X18.585786 Y8.585786; 2 arc X21.414214 G17 about 20 7.17157 by -90;"
     " 3 line X30 Y0; 4 line X40"},
    {"G1 X10. ,R2. F100.\nX0\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nX20.\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nZ5.\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nM0\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nG4 P1\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nG17\nY10.\n",
     "!1:10 corner R 2/0; 3 line X10 Y10 F100"},
    {"G1 X10. ,R2. F100.\nG54\nY10.\n",
     "!1:10 corner R 2/0; 3 line X10 Y10 F100"},
    {"G1 X10. ,R2. F100.\nG0 Y10.\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R2. F100.\nS100\nY10.\n",
     "!1:10 corner R 2/0; 3 line X10 Y10 F100"},
    {"G1 X10. ,R2. F100.\n(remark)\n",
     "!1:10 corner R 2/0; 1 end M2 X10"},
    {"F200.\nY10.\n",
     "2 rapid Y10"},
    {"G1 X10. ,R2. F100.\n",
     "!1:10 corner R 2/0; 1 end M2 X10"},
    {"G1 X10. ,R2. F100.\nG81 Z-1. R1.\n",
     "!1:10 corner R 2/0"},
    {"G1 X10. ,R10. F100.\nY10.\n",
     "1 line F100; 1 arc X10 Y10 G17 about 0 10 by 90; 2 line"},
    {"G1 X10. ,R10.001 F100.\nY10.\n",
     "!1:10 corner R 10.001/0"},
    {"G1 X10. ,C10. F100.\nY10.\n",
     "1 line F100; 1 line X10 Y10; 2 line"},
    {"G1 X10. ,C10.001 F100.\nY10.\n",
     "!1:10 corner C 10.001/0"},
    {"G1 X10. ,R.0005 F100.\nY10.\nG1 X10. ,R1000001.\n,R2.\nX20. ,R\nX20. ,\nX20. ,X2.\n"
     "X20. ,R[1+1]\nY0\n",
     "!1:10 number-range R 0.0005/1000000; 2 line X10 Y10 F100;"
     " !3:10 number-range R 1000001/1000000; !4:2 corner R 2/0; !5:7 number R;"
     " !6:6 character 44/0; !7:6 character 44/0; 8 line X18;"
     " 8 arc X20 Y8 G17 about 18 8 by -90; 9 line Y0"},
    {"G93 G1 X10. ,R2. F1.\nY10. F1.\n",
     "!1:14 corner R 2/0; 2 line X10 Y10 F1 inverse"},
    {"G61 G1 X10. ,R2. F100.\nG9 Y10. ,R2.\nX0\n",
     "1 line X8 F100 stop P0 Q0; 1 arc X10 Y2 G17 about 8 2 by 90; 2 line Y8;"
     " 2 arc X8 Y10 G17 about 8 8 by 90; 3 line X0"},
    {"G68 X0 Y0 R90.\nG1 X10. ,R2. F100.\nY10.\nG69\n",
     "2 line Y8 F100; 2 arc X-2 Y10 G17 about -2 8 by 90; 3 line X-10"},
    {"G51 X0 Y0 Z0 P2.\nG1 X10. ,R2. F100.\nY10.\n",
     "!2:10 layout-on R 2/0; 3 line X20 Y20 F100"},
    {"G1 X10. Z5. ,R2. F100.\nY10.\n",
     "!1:14 corner R 2/0"},
    {"G2 I5. ,R2. F100.\nG1 X10.\n",
     "!1:9 corner R 2/0"},
    {"G1 X10. ,C2. F100.\nG2 I5.\n",
     "!1:10 corner C 2/0"},
    {"G1 X10. ,R1. F100.\nG2 X10.018 Y-.4475 I5.\nG1 X0\n",
     "1 line X9.083911 F100; 1 arc X10.069927 Y0.83335 G17 about 9.08391 1 by 80.4069;"
     " 2 arc X19.996013 Y0.223929 G17 about 15.00051 0.00001 by -167.8404;"
     " 2 arc X10.018 Y-0.4475 G17 about 14.99949 -0.00003 by -177.4336; 3 line X0"},
    {"G1 X10. ,R2.\nF100.\nY10.\n",
     "!1:0 feed-missing F; 3 line X10 Y10 F100"},
    {"G1 X10. ,R2. F100.\nY10. ,C3.\nX0 M30\n",
     "1 line X8 F100; 1 arc X10 Y2 G17 about 8 2 by 90; 2 line Y7; 2 line X7 Y10; 3 line X0;"
     " ?4:0 after-end; 3 end M30"},
    {"G1 X10. ,R2. F100.\nY10. M0\nX0\n",
     "1 line X8 F100; 1 arc X10 Y2 G17 about 8 2 by 90; 2 line Y10; 2 wait M0; 3 line X0"},
};

static void a_corner_is_rounded_or_cut_off(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, corner2_rows);
}

static const told_row_t notes_rows[] = {
    {"G0 X1\nY2\nG2 X2 I1 F9\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid X1; 2 rapid Y2; ?3:0 assumed-plane;"
     " ?3:0 assumed-centre; !3:1 arc-radius 0/1"},
    {"G20 G0 X1\nG90 Y2\nG2 X2 I1 F9\n",
     "?1:0 assumed-distance; 1 rapid X25.4; 2 rapid Y50.8; ?3:0 assumed-plane;"
     " ?3:0 assumed-centre; !3:1 arc-radius 0/25.4"},
    {"G21 G90 G0 X1\nG17 G2 X2 I.5 F9\nG91.1 G2 X3 I.5\n",
     "1 rapid X1; ?2:0 assumed-centre; 2 arc X2 G17 about 1.5 0 by -180 F9;"
     " 3 arc X3 G17 about 2.5 0 by -180"},
    {"G91 G0 X1\nX1\nG3 X1 R1 F9\nG18\nG3 X1 R1\n",
     "?1:0 assumed-units; 1 rapid X1; 2 rapid X2; ?3:0 assumed-plane;"
     " 3 arc X3 G17 about 2.5 0.86603 by 60 F9; 5 arc X4 G18 about -0.86603 3.5 by 60"},
    {"G81 X1 Z-1 R1 F9\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; ?1:0 assumed-plane; 1 rapid~ Z1; 1 rapid~ X1;"
     " 1 line~ Z-1 F9; 1 rapid~ Z1"},
    {"G17 G81 X1 Z-1 R1 F9\nG20\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid~ Z1; 1 rapid~ X1; 1 line~ Z-1 F9;"
     " 1 rapid~ Z1"},
    {"G28 X1\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid X1; 1 rapid X0"},
    {"G30 Y1\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid Y1; 1 rapid Y0"},
    {"G4 P1\nF100\nS10\nM3\n",
     "1 dwell for 1; 3 out S10; 4 out M3 S10"},
    {"G21 G0 X1\nG90 G2 X3 I1 F9\nG91.1 G2 X5 I1\nX6\n",
     "?1:0 assumed-distance; 1 rapid X1; ?2:0 assumed-plane; ?2:0 assumed-centre;"
     " 2 arc X3 G17 about 2 0 by -180 F9; 3 arc X5 G17 about 4 0 by -180; !4:0 arc-centre"},
    {"G0 G53 X1\nG10 L2 P1 X1\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid X1"},
    {"G92 X1\n",
     ""},
    {"G43.1 Z1\nG38.2 X1\n",
     "!2:1 unsupported G 38.2/0"},
    {"G64\nG64 P0\nG64 P0\nG64 P.00009\n",
     "?2:5 no-tolerance P"},
    {"F10 G20\nF20 G20\nG21 F5\nG93 G20 F2 G1 X1\nG94 G21 G1 F1 X0\n",
     "?1:0 feed-units; ?4:0 assumed-distance; 4 line X25.4 F2 inverse; 5 line X0 F25.4 per-min"},
};

static void what_a_text_leaves_unsaid_is_noted(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.notes = 1;
    TOLD(check, &self, notes_rows);
}

static const told_row_t fnotes_rows[] = {
    {"G0 X1. Y2.\nX5\nY6\nG2 X6. R1. F100\nG4 X1\nG4 P1\nG81 Z-1 R1.\nG83 Z-1. R1. Q1\nA5\n"
     "G10 L2 P1 X5\n",
     "?1:0 assumed-units; ?1:0 assumed-distance; 1 rapid X1 Y2; ?2:0 assumed-integers;"
     " 2 rapid X5; 3 rapid Y6; ?4:0 assumed-plane; 4 arc X6 G17 about 5.5 5.13397 by -60 F100;"
     " 5 dwell for 1; 6 dwell for 0.001; 7 rapid~ Z1; 7 line~ Z-1; 7 rapid~ Z1;"
     " !8:14 scale-unit Q 1/0; !9:1 axis-unknown A"},
};

static void what_a_mill_of_fanucs_assumes_is_noted(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.notes = 1;
    TOLD(check, &self, fnotes_rows);
}

static const told_row_t lnotes_rows[] = {
    {"G0 X1. Z1.\nM3 S60\nG1 X2. F.1\nG90 X1. Z-1.\nG94 X1. Z-1.\nG0 X5\nM5\nG92 X1. Z-1. F1.\n",
     "?1:0 assumed-units; 1 rapid X0.5 Z1 per-rev; 2 out S60; 2 out M3 S60;"
     " ?3:0 assumed-feed-mode; 3 line X1 F0.1; ?4:0 assumed-system; 4 rapid~ X0.5; 4 line~ Z-1;"
     " 4 line~ X1; 4 rapid~ Z1; 5 rapid~ Z-1; 5 line~ X0.5; 5 line~ Z1; 5 rapid~ X1;"
     " ?6:0 assumed-integers; 6 rapid X2.5; 7 out M5 S0; !8:1 thread-speed S"},
    {"G98 G1 X1. F100.\nG99 G1 X1. F.1\n",
     "?1:0 assumed-units; 1 line X0.5 F100; !2:0 feed-missing S"},
    {"S9 M3 G92 X1. Z-1. F1.\nG90 X1. F1.\n",
     "?1:0 assumed-feed-mode; 1 out S9 per-rev; 1 out M3 S9; ?1:0 assumed-units;"
     " ?1:0 assumed-system; 1 rapid~ X0.5; 1 thread Z-1 of 1 lead 1 for 10.01; 1 rapid~ X0;"
     " 1 rapid~ Z0; !2:1 word-missing Z 90/0"},
};

static void what_a_lathe_of_fanucs_assumes_is_noted(check_t *check) {
    told_turning(&self);
    self.machine.dialect.system = NCK_SYSTEM_OPEN;
    self.machine.dialect.feed = NCK_FEED_START_OPEN;
    self.machine.dialect.integers = NCK_INTEGERS_OPEN;
    self.notes = 1;
    TOLD(check, &self, lnotes_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_corner_is_rounded_or_cut_off);
    CHECK_RUN(&check, what_a_text_leaves_unsaid_is_noted);
    CHECK_RUN(&check, what_a_mill_of_fanucs_assumes_is_noted);
    CHECK_RUN(&check, what_a_lathe_of_fanucs_assumes_is_noted);
    return check_end(&check);
}
