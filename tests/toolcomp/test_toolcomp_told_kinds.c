// SPDX-License-Identifier: MIT
// Rooms 1 and 2: contours of kinds that few programs have. Of 280 000 drawn ones these are left:
// each tells a change of the room that no other row does.
#include "told_check.h"

static told_t self;

static const told_row_t kinds_rows[] = {
    {"G43.1 X1 Y2 Z3\nM3 S600\nG33 Z-10 K1\n",
     "2 out S600 X-1 Y-2 Z-3 tool X1 tool Y2 tool Z3; 2 out M3 S600 axis1;"
     " 3 thread X0 Y0 Z-7 tool X0 tool Y0 tool Z0 of 7 lead 1 for 0.818"},
    {"M3 S600\nG43.1 X1 Z3\nG33 X5 Z-10 K1\nG33.1 Z-12 K1\n",
     "1 out S600; 1 out M3 S600; 3 thread X6 Z-7 of 9.21954446 lead 1 for 1.04 axis1;"
     " 4 tap by 0 0 -2 lead 1 for 0.5861"},
    {"G41.1 D1 F100\nG3 X0.8 Y0.8 J0.8\nG1 Y5\nG40 X4\n",
     "2 arc X0.3 Y0.8 G17 about -0.91667 0.8 by 41.1121 F100; 3 line Y5; ?4:0 comp-way 0.5/3;"
     " 4 line X4"},
    {"G41.1 D4 F100\nG1 X10\nX30\nG40 Y-10\nG41.1 D2\nG1 X20 Y-20\nX20 Y-8\nG40 X18 Y5\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X10 Y2 F100; 3 line X30; ?4:0 comp-way 2/3;"
     " 4 line Y-10; ?6:0 comp-way 0.00249066389/7; 6 line X20.707107 Y-20.707107;"
     " 7 arc X19 Y-20 G17 about 20 -20 by -135; 7 line Y-8; 8 line X18 Y5"},
    {"G42.1 D2 F100\nG1 X7 Y-3 Z2\nX0 Y0 Z-3\nX-1 Y1\n",
     "!2:0 comp-gouge G 0.405304774/3"},
    {"G42.1 D6 F100\nG1 X5 Y-9\nX4\nX3 Y-7\nZ-1\nZ1\nX-7 Y-4\nX4 Y-9\nZ3\nZ2\n",
     "!2:0 comp-gouge 0.819390832/4"},
    {"G41.1 D6 F100\nG1 X-5 Y1 Z1\nY0\nX-3 Y-1\nX-5 Y1\nG4 P1\nX-10 Y2\nZ3\nX-9 Y8\nX-12 Y9\n",
     "!2:0 comp-gouge 1.00013573/4"},
    {"G41.1 D10 F100\nG1 X30 Y80\nG4 P1\nY200 Z-2\nG3 X30 Y200 I15 J-5\n",
     "!5:8 travel Y 210.811388/200; 2 line X25 Y80.906673 F100; 3 dwell for 1; 4 line Y200 Z-2"},
    {"G42.1 D2 F100\nG1 X20 Y5\nX20\nG2 X40 Y-15 J-20\nG3 X40 Y-15 I80 J0\n"
     "G3 X40 Y-15 I-80 J10 Z-1\nG40 G1 X40 Y15.5\n",
     "2 line X20.12155 Y3.999611 F100; 3 line; 4 arc X39 Y-15 G17 about 20 -15 by -89.6335;"
     " 5 arc X160.5 Y-85.148058 G17 about 120 -15 by 120; !5:0 travel X 201/200;"
     " 7 line X40 Y15.5 Z-1"},
    {"G42.1 D2 F100\nG3 X-1 Y0 R-1.5\nG94 F50\nG1 Y0.5\nX-1\nG40 G1 X-1 Y3\n",
     "?2:0 comp-way 0.5/4; 2 arc X-1.57735 Y0.816497 G17 about -1 0 by 125.2644 F100;"
     " 2 arc X-1.333333 Y-0.942809 G17 about -1 0 by 125.2644;"
     " 4 arc X0 Y0 G17 about -1 0 by 109.4712 F50; 4 line Y0.5; 5 line;"
     " ?6:0 comp-way 0.0715233091/4; 6 line X-1 Y3"},
};

static const told_row_t kinds_a_rows[] = {
    {"G41.1 D0.4 F100\nG1 X0.84 Y-0.543\nG2 X0.84 Y-0.543 I-0.027 J-0.042\nG1 X0.894 Y-0.459\n"
     "G40\nG1 X0.141 Y-1.118\n",
     "?2:0 comp-way 0.00473316521/3; 2 line X0.948152 Y-0.374764 F100;"
     " !3:0 comp-gouge 0.0998599019/4; 6 line X0.141 Y-1.118"},
    {"G0 Y-0.5 Z4\nG19 G42.1 D10 F100\nG1 Y-0.501 Z4.0001\nA1\nZ4.2501\n"
     "G3 Y-0.251 Z4.2501 J0.125 K0 P2\nG3 Y-0.251 Z0.2501 R6\nG40 G1 Y-0.251 Z1.2501\nG42.1 D4\n"
     "G1 Y29.749\nZ60\nG40 Y90\n",
     "1 rapid Y-0.5 Z4; !4:1 axis-unknown A; ?3:0 comp-way 4.99899501/5;"
     " 3 line Y4.499 Z4.0001 F100; 5 line Z4.2501; !6:0 comp-gouge 0.25/7;"
     " 8 line Y-0.251 Z1.2501; ?10:0 comp-way 2/11; 10 line Y31.749; 11 line Z60; 12 line Y90"},
};

static const told_row_t kinds_b_rows[] = {
    {"G42.1 D6 F100\nG1 Y5 Z-1\nX0\nY85\nX5 Y105\n",
     "?2:0 comp-way 0.00299582917/4; 2 line X3 Y5 Z-1 F100; 3 line; 4 line Y84.630683;"
     " 5 line X7.910428 Y104.272393"},
    {"G42.1 D6 F100\nG1 X-1 Y-5\nZ1\nG3 X1 Y-7 I2 J0\nG1 X3 Y3\nX1 Y-7\nX-7 Y11\nX2 Y15\n"
     "X-7 Y11\nX11 Y3\nG40\nG1 X24 Y-12\n",
     "!2:0 comp-gouge G 0.646606378/5; 12 line X24 Y-12 Z1 F100"},
    {"G0 X-2 Y0\nG42.1 D10 F100\nG1 Y0.75\nG0 Y-1.25\nG1 X-2.25 Y-1\nY1\nG3 X-2.75 Y1 R-0.3\n"
     "G1 X-1.75 Y1.5\nX-1.7499 Y1.5001\n",
     "1 rapid X-2; 3 line X3 Y0.75 F100; !5:0 comp-gouge 1.26486241/7"},
    {"G18 G42.1 D10 L1 F100\nG1 Z-5 X-10\nG0 Z-15\nG40 G1 Z-12.5 X-14.5\n",
     "2 line X-10 F100; 3 rapid Z-10;"
     " 4 arc X-17.428215 Z-14.370786 G18 about -10 -15 by 119.0546; 4 line X-14.5 Z-12.5"},
    {"G42.1 D2 F100\nG1 X-10 Y2.5\nX0 Y12.5\nY15 Z1\nG40\nZ2\nG1 X-2.5 Y-4.5 Z1.001\n",
     "2 line X-9.292893 Y1.792893 F100; 3 line X0.707107 Y11.792893;"
     " 4 arc X1 Y12.5 G17 about 0 12.5 by 45; 4 line Y15 Z1; 6 line Z2;"
     " 7 arc X-0.991882 Y15.127164 G17 about 0 15 by 172.6943; 7 line X-2.5 Y-4.5 Z1.001"},
};

static const told_row_t kinds_bound_rows[] = {
    {"G42.1 D4 F100\nG1 X90 Y0\nG3 X90 Y20 J10\nG40 G1 X60\n",
     "2 line X90 Y-2 F100; !3:0 travel X 102/100; 4 line X60 Y20"},
    {"G41.1 D4 F100\nG1 Y5\nX98\nY0\nG40 X60\n",
     "?2:0 comp-way 0.143046618/3; 2 line X-2 Y5 F100; 3 arc X0 Y7 G17 about 0 5 by -90;"
     " 3 line X98; 4 arc X100 Y5 G17 about 98 5 by -90; 4 line Y0; ?5:0 comp-way 2/4; 5 line X60"},
};

static const told_row_t kinds_nose_rows[] = {
    {"T8 M6\nG43\nG43.1 X2 Y1 Z0\nG0 Y5 Z-10\nG19 G41.1 D6 F100\nG1 Y10.001 Z-5\n"
     "Y12.5007 X-0.001\nS5\nG2 Y12.5007 Z-5 J60 K-5\nG2 Y5.0007 Z-12.5 K-7.5\n"
     "G40 G0 Y5.0007 Z-12\n",
     "1 out T8; 1 out M5; 1 wait M6; 4 rapid Y6 Z-10; ?6:0 comp-way 0.238234022/7;"
     " 6 line Y8.879892 Z-2.878468 F100;"
     " 7 arc Y10.800178 Z-2.006729 G19 about 11.001 -5 by -41.156;"
     " 8 out S5 X-0.001 Y9.800178 tool X2 tool Y1;"
     " 9 arc X0.9995 Y136.360756 Z-16.622781 tool X0 tool Y0 G19 about 73.5007 -10 by -178.7493;"
     " 9 arc X1.999 Y10.511063 Z-4.750864 G19 about 73.5007 -10 by -178.7493;"
     " 10 arc Y13.5007 Z-2 G19 about 13.5007 -5 by -85.2364;"
     " 10 arc Y20.925321 Z-19.924621 G19 about 13.5007 -12.5 by -135;"
     " 10 arc Y3.0007 Z-12.5 G19 about 13.5007 -12.5 by -135; 11 rapid Y6.0007 Z-12"},
    {"G43.1 X1 Y1 Z3\nG41.1 D2 F100\nG1 X0.0001\nX10.0001\nG2 X20.0001 Y10 I10 J0 Z-2\n"
     "G2 X35.0001 Y25 J15\nG1 X75.0001 Y30\nG40 G1 X75.0001 Y30.5\n",
     "!5:1 arc-radius 11/10; ?3:0 comp-way 0.292857866/4; 3 line X1.0001 Y1 F100;"
     " 4 line X6.587829; !7:0 comp-gouge 0/7; 8 line X76.0001 Y31.5 Z1"},
};

static const told_row_t kinds_nose_b_rows[] = {
    {"T2 M6\nG18 G41.1 D10 L4 F100\nG1 Z-1 X-7\nG3 Z1 X-7 K1 I0\nG1 Z-8 X-5\n",
     "1 out T2; 1 out M5; 1 wait M6; !4:0 comp-radius 5/1; 5 line X-2.707107 Z10.949747 F100;"
     " 5 arc X-6.880935 Z4.915348 G18 about 6 -2 by -94.3987; 5 line X-5 Z-8"},
    {"T7 M6\nG18 G42.1 D6 L1 F100\nG1 Z2.6 X3.6\nZ4.6 X4.4\nZ7.9 X-4.9 Y-1\nZ7.1 X-12.2\nG40\n"
     "G1 Z-4.2 X-23.6\n",
     "1 out T7; 1 out M5; 1 wait M6; ?3:0 comp-way 0.696196287/4; ?4:0 comp-left 0.80445376/4;"
     " 3 line X-1.808162 Z5.555112 F100; 5 line X-8.255937 Y-1 Z7.843032;"
     " 6 line X-14.873189 Z7.117854; 8 line X-23.6 Z-4.2"},
};

// X, Y and Z may go 200 mm either way.
static void begin(void) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    for (int k = 0; k < 3; k++) {
        self.machine.axis[k].min_nm = -200 * (int64_t)NCK_COUNTS_PER_MM;
        self.machine.axis[k].max_nm = 200 * (int64_t)NCK_COUNTS_PER_MM;
    }
    self.compensates = 1;
}

static void contours_of_rare_kinds_are_cut_or_refused(check_t *check) {
    begin();
    TOLD(check, &self, kinds_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_A;
    TOLD(check, &self, kinds_a_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_B;
    TOLD(check, &self, kinds_b_rows);
}

static void what_bulges_stays_within_the_travel(check_t *check) {
    begin();
    told_bound(&self);
    TOLD(check, &self, kinds_bound_rows);
}

static void noses_begin_and_end_as_the_block_says(check_t *check) {
    begin();
    told_tools(&self);
    TOLD(check, &self, kinds_nose_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_B;
    TOLD(check, &self, kinds_nose_b_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, contours_of_rare_kinds_are_cut_or_refused);
    CHECK_RUN(&check, what_bulges_stays_within_the_travel);
    CHECK_RUN(&check, noses_begin_and_end_as_the_block_says);
    return check_end(&check);
}
