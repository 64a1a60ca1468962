// SPDX-License-Identifier: MIT
// Rooms 1 and 2: the path of the tool's centre, block by block.
#include "told_check.h"

static told_t self;

static const told_row_t beside_rows[] = {
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nY0\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 arc X22 Y10 G17 about 20 10 by -90; 4 line Y0; ?5:0 comp-way 2/4; 5 line X0"},
    {"G42.1 D4 F100\nG1 X0 Y10\nX20\nY0\nG40 X0\n",
     "2 line X2 Y8 F100; 3 line X18; 4 line Y0; 5 line X0"},
    {"G41.1 D4 F100\nG1 X10\nX20 Y10\nX10 Y20\nX20\nG40\nY0\n",
     "2 line X9.171573 Y2 F100; 3 line X17.171573 Y10; 4 line X8.585786 Y18.585786;"
     " 5 arc X10 Y22 G17 about 10 20 by -135; 5 line X20; !7:0 comp-gouge G 2/4"},
    {"G42.1 D4 F100\nG1 X10\nX20 Y10\nX10 Y20\nX20\nG40\nY0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X10 Y-2 F100;"
     " 3 arc X11.414214 Y-1.414214 G17 about 10 0 by 45; 3 line X21.414214 Y8.585786;"
     " 4 arc Y11.414214 G17 about 20 10 by 90; 4 line X14.828427 Y18; 5 line X20;"
     " !7:0 comp-gouge G 2/4"},
    {"G41.1 D4 F100\nG1 X0 Y10\nG2 X10 Y20 I10\nG3 X20 Y30 J10\nG1 Y40\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X10 Y22 G17 about 10 10 by -90;"
     " 4 arc X18 Y30 G17 about 10 30 by 90; 5 line Y40; 6 line X0"},
    {"G42.1 D4 F100\nG1 X0 Y10\nG2 X10 Y20 I10\nG3 X20 Y30 J10\nG1 Y40\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X2 Y10 F100; 3 arc X10 Y18 G17 about 10 10 by -90;"
     " 4 arc X22 Y30 G17 about 10 30 by 90; 5 line Y40; ?6:0 comp-way 2/5; 6 line X0"},
    {"G41.1 D2 F100\nG1 Y5\nG2 X20 I10 Z-6\nX0 I-10 P2 Z-10\nG40 G1 X5\n",
     "?2:0 comp-way 0.0194193243/3; 2 line X-1 Y5 F100; 3 arc X21 Z-6 G17 about 10 5 by -180;"
     " 4 arc X2.221825 Y-2.778175 Z-7 G17 about 10 5 by -135;"
     " 4 arc X10 Y16 Z-8 G17 about 10 5 by -135;"
     " 4 arc X17.778175 Y-2.778175 Z-9 G17 about 10 5 by -135;"
     " 4 arc X-1 Y5 Z-10 G17 about 10 5 by -135; ?5:0 comp-way 1/4; 5 line X5"},
    {"G41.1 D2 F100\nG1 Y5\nG3 X0 I10\nG1 Y10\nG40 X5\n",
     "!2:0 comp-gouge G 0.213612567/3; 5 line X5 Y10 F100"},
    {"G18 G41.1 D4 F100\nG1 Z10\nX20\nZ20\nG2 X30 Z30 I10\nG40 G1 Z50\n",
     "2 line X2 Z8 F100; 3 line X20; 4 arc X22 Z10 G18 about 10 20 by -90;"
     " !4:0 comp-gouge 1.84802975/5; 6 line X30 Z50"},
    {"G19 G42.1 D4 F100\nG1 Y10\nZ20\nY20\nG3 Y30 Z30 K10\nG40 G1 Y50\n",
     "?2:0 comp-way 0.0388386486/3; 2 line Y10 Z-2 F100; 3 arc Y12 Z0 G19 about 10 0 by 90;"
     " 3 line Z18; 4 line Y20; 5 arc Y32 Z30 G19 about 20 30 by 90; 6 line Y50"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nZ-5\nM8\nG4 P1\nY0\nA1\nY-10\nS100\nG40\nZ5\nX0\nX1 Y1\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 line Z-5; 5 out M8; 6 dwell for 1; 7 arc X22 Y10 G17 about 20 10 by -90;"
     " 7 line Y0; 8 line A1; 9 line Y-10; 10 out S100; 12 line Z5; 13 line X0; 14 line X1 Y1"},
    {"G41.1 D4 G93\nG1 X0 Y10 F2\nX20 F3\nY0 F4\nG2 X30 Y-10 R10 F5\nG40 G1 X0 F1\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F2 inverse;"
     " 3 arc X0 Y12 G17 about 0 10 by -90 F19.0985932; 3 line X20 F3;"
     " 4 arc X22 Y10 G17 about 20 10 by -90 F12.7323954; 4 line Y1.83216 F4;"
     " 5 arc X32 Y-10 G17 about 20 -10 by -80.4059 F5; ?6:0 comp-way 2/5; 6 line X0 F1"},
    {"G41.1 D4 F100\nG0 X0 Y10\nX20\nY0\nG1 Y-10\nX10\nG0 X0\nG40 X0 Y20\n",
     "2 rapid X-2 Y10; 3 arc X0 Y12 G17 about 0 10 by -90 F6000; 3 rapid X20;"
     " 4 arc X22 Y10 G17 about 20 10 by -90; 4 rapid Y0; 5 line Y-10 F100;"
     " 6 arc X20 Y-12 G17 about 20 -10 by -90; 6 line X10; 7 rapid X0; 8 rapid Y20"},
    {"G41.1 D4 F100\nG1 X0 Y10\nG0 X20\nG1 Y0\nG0 X30\nG40 X0\n",
     "2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90 F6000; 3 rapid X20;"
     " 4 arc X22 Y10 G17 about 20 10 by -90 F100; 4 line Y2; 5 rapid X30; 6 rapid X0 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nX5\nY20\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 arc Y8 G17 about 20 10 by -180; 4 line X5;"
     " 5 arc X3 Y10 G17 about 5 10 by -90; 5 line Y20; 6 line X0"},
    {"G42.1 D4 F100\nG1 X0 Y10\nX20\nX5\nY20\nG40 X0\n",
     "2 line X2 Y8 F100; 3 line X20; 4 arc Y12 G17 about 20 10 by 180; 4 line X7; 5 line Y20;"
     " ?6:0 comp-way 2/5; 6 line X0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX10\nX20 Y10.0001\nX30 Y10\nX40 Y9.9999\nX50 Y9\nX60 Y10\n"
     "G40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X9.99999; 4 line X19.99998 Y12.0001; 5 line X30.00002 Y12;"
     " 6 line X40.00002 Y11.9999; 7 arc X40.198988 Y11.989976 G17 about 40 9.9999 by -5.7095;"
     " 7 line X49.99999 Y11.009974; 8 line X59.800993 Y11.990074; !9:0 comp-gouge G 2/3"},
    {"G42.1 D4 F100\nG1 X0 Y10\nX10\nX20 Y10.0001\nX30 Y10\nX40 Y9.9999\nX50 Y9\nX60 Y10\n"
     "G40 X0\n",
     "2 line X2 Y8 F100; 3 line X10; 4 line X20 Y8.0001; 5 line X29.99998 Y8;"
     " 6 line X39.900249 Y7.999901; 7 line X49.801012 Y7.009924;"
     " 8 arc X50.199007 Y7.009926 G17 about 50 9 by 11.4206; 8 line X60.199007 Y8.009926;"
     " !9:0 comp-gouge G 2/3"},
    {"G10 L2 P1 X100 Y50\nG43.1 X1 Y2 Z3\nG41.1 D4 F100\nG1 X0 Y10\nX20\nY0\nG40 X0\n",
     "4 line X99.953689 Y63.704474 F100; 5 arc X101 Y64 G17 about 101 62 by -31.5442; 5 line X121;"
     " 6 arc X123 Y62 G17 about 121 62 by -90; 6 line Y52; ?7:0 comp-way 2/6; 7 line X101"},
    {"G41.1 D4 F100\nG2 X10 Y10 I10\nX20 Y0 J-10\nG40 G1 X30\n",
     "2 arc X10 Y12 G17 about 10 1.83333 by -100.3889 F100; 3 arc X22 Y0 G17 about 10 0 by -90;"
     " 4 line X30"},
    {"G42.1 D4 F100\nG3 X10 Y10 J10\nX0 Y20 I-10\nG1 X-20\nG40 Y0\n",
     "2 arc X12 Y10 G17 about 1.83333 10 by 100.3889 F100; 3 arc X0 Y22 G17 about 0 10 by 90;"
     " 4 line X-20; ?5:0 comp-way 2/4; 5 line Y0"},
    {"G41.1 D4 F100 G61\nG1 X10\nG64 P.5 X20 F200\nY10 F300\nG61.1 X30\nS100 M3 G95 F.5\nX40\n"
     "G40 X50\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X10 Y2 F100 exact P0 Q0;"
     " 3 line X18 F200 smooth P0.5 Q0.5; 4 line Y10 F300;"
     " 5 arc X20 Y12 G17 about 20 10 by -90 stop P0 Q0; 5 line X30; 6 out S100 per-rev;"
     " 6 out M3 S100; 7 line X40 F0.5; ?8:0 comp-way 0.0388386486/7; 8 line X50 Y10"},
};

static void the_tool_goes_beside_the_contour(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_turns(&self);
    self.compensates = 1;
    TOLD(check, &self, beside_rows);
}

static const told_row_t inside_rows[] = {
    {"G41.1 D6 F100\nG1 X0 Y10\nX20\nY8\nX22\nY10\nX40\nG40 Y0\n",
     "?2:0 comp-way 0.126521144/3; 2 line X-3 Y10 F100; 3 arc X0 Y13 G17 about 0 10 by -90;"
     " 3 line X20; ?4:0 comp-left 1.93089328/6; 4 arc X21 Y12.828427 G17 about 20 10 by -19.4712;"
     " 7 arc X22 Y13 G17 about 22 10 by -19.4712; 7 line X40; ?8:0 comp-way 3/7; 8 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nY20\nX0\nY11\nG40 X-10\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; !3:0 comp-gouge 2/6; 7 line X-10 Y11"},
    {"G42.1 D4 F100\nG1 Y10\nX20\nY-10\nX-20\nY10\nX-5\nG40 Y30\n",
     "2 line X2 Y8 F100; 3 line X18; 4 line Y-8; 5 line X-18; 6 line Y8; 7 line X-5;"
     " ?8:0 comp-way 2/7; 8 line Y30"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nY-10\nX-20\nY10\nX5\nG40 Y30\n",
     "!2:0 comp-gouge G 2/7; 8 line X5 Y30 F100"},
    {"G41.1 D4 F100\nG1 Y10\nX10\nG3 X20 I5\nG1 X30\nG40 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X10; 4 arc X12 Y10 G17 about 10 10 by -90; 4 arc X18 G17 about 15 10 by 180;"
     " 5 arc X20 Y12 G17 about 20 10 by -90; 5 line X30; ?6:0 comp-way 2/5; 6 line Y0"},
    {"G41.1 D12 F100\nG1 Y10\nX10\nG3 X20 I5\nG1 X30\nG40 Y0\n",
     "!4:0 comp-radius 6/5; 5 line X30 Y10 F100; 6 line Y0"},
    {"G42.1 D8 F100\nG1 Y10\nX10\nG2 X20 I5\nG1 X30\nG40 Y0\n",
     "2 line X4 Y6 F100; 3 line X10; 4 arc X14 Y10 G17 about 10 10 by 90;"
     " 4 arc X16 G17 about 15 10 by -180; 5 arc X20 Y6 G17 about 20 10 by 90; 5 line X30;"
     " 6 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nY11\nX40\nY12\nX60\nG40 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " ?4:0 comp-left 0.645751311/4; 3 line X18.267949; 5 arc X20 Y13 G17 about 20 11 by -60;"
     " ?6:0 comp-left 0.645751311/6; 5 line X38.267949; 7 arc X40 Y14 G17 about 40 12 by -60;"
     " 7 line X60; ?8:0 comp-way 2/7; 8 line Y0"},
    {"G42.1 D4 F100\nG1 X0 Y10\nX20\nY11\nX40\nY12\nX60\nG40 Y0\n",
     "2 line X2 Y8 F100; 3 line X20; ?4:0 comp-left 0.645751311/4;"
     " 4 arc X21.732051 Y9 G17 about 20 10 by 60; 5 line X40; ?6:0 comp-left 0.645751311/6;"
     " 6 arc X41.732051 Y10 G17 about 40 11 by 60; 7 line X60; 8 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX20\nX22 Y14\nX24 Y10\nX40\nG40 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X18.763932; 4 line X20.211146 Y14.894427;"
     " 5 arc X23.788854 G17 about 22 14 by -126.8699; 5 line X25.236068 Y12; 6 line X40;"
     " ?7:0 comp-way 2/6; 7 line Y0"},
    {"G42.1 D4 F100\nG1 X0 Y10\nX20\nX22 Y14\nX24 Y10\nX40\nG40 Y0\n",
     "2 line X2 Y8 F100; 3 line X20; 4 arc X21.788854 Y9.105573 G17 about 20 10 by 63.4349;"
     " 4 line X22 Y9.527864; 5 line X22.211146 Y9.105573;"
     " 6 arc X24 Y8 G17 about 24 10 by 63.4349; 6 line X40; 7 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y10\nX10\nG2 X20 Y0 J-10\nG3 X30 Y10 J10\nG1 X40\nG40 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X10; 4 arc X21.795832 Y2.204168 G17 about 10 0 by -79.4158;"
     " 5 arc X28 Y10 G17 about 20 10 by 77.0278; 6 arc X30 Y12 G17 about 30 10 by -90; 6 line X40;"
     " ?7:0 comp-way 2/6; 7 line Y0"},
    {"G41.1 D6 F100\nG1 X0 Y10\nX20\nY0\nX10\nY-30\nX40\nY0\nX24\nY10\nX40\nG40 Y30\n",
     "?2:0 comp-way 0.126521144/3; 2 line X-3 Y10 F100; 3 arc X0 Y13 G17 about 0 10 by -90;"
     " 3 line X20; !4:0 comp-gouge 2/10; 12 line X40 Y30"},
    {"G41.1 D4 F100\nG1 X1\n",
     "!2:0 comp-entry 1/2"},
    {"G41.1 D4 F100\nG1 X2\nX10\nG40 X20\n",
     "!2:0 comp-entry 2/2; 3 line X10 F100; 4 line X20"},
    {"G41.1 D4 F100\nG1 X2.001\nX10\nG40 X20\n",
     "?2:0 comp-way 0.585433017/3; 2 line X2.001 Y2 F100; 3 line X10;"
     " ?4:0 comp-way 0.0388386486/3; 4 line X20 Y0"},
    {"G41.1 D4 F100\nG2 X1 R1\n",
     "!2:0 comp-entry 1/2"},
    {"G41.1 D4 F100\nG1 Y10\nG2 X20 R10\nG40\nG2 X30 R5\nG1 X40\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X22 G17 about 10 10 by -180;"
     " !5:0 comp-exit; 6 line X40"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG2 X20 Y10 I-10 P2\nG1 X30\nG40 Y30\n",
     "?2:0 comp-way 0.233031892/4; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 arc X22 Y10 G17 about 20 10 by -90;"
     " 4 arc X-1.989487 Y9.497802 G17 about 10 10 by -177.6015;"
     " 4 arc X21.957966 Y11.003515 G17 about 10 10 by -177.6015;"
     " 4 arc X-1.905493 Y8.496926 G17 about 10 10 by -177.6015;"
     " 4 arc X21.83216 Y12 G17 about 10 10 by -177.6015; 5 line X30; 6 line Y30"},
    {"G41.1 D4 F100\nG1 Y10\nX30\nY20\nX10\nY0\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X28; 4 line Y18; 5 line X12; 6 line Y0; ?7:0 comp-way 2/6; 7 line X0"},
    {"G41.1 D4 F100\nG1 Y10\nX30\nY13\nX0\nG40 X0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; !3:0 comp-gouge 1/5; 6 line"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nY20\nX19\nY30\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X18; ?5:0 comp-left 0.645751311/5; 4 line Y18.267949;"
     " 6 arc X17 Y20 G17 about 19 20 by -60; 6 line Y30; 7 arc X19 Y32 G17 about 19 30 by -90;"
     " 7 line X40; 8 line Y50"},
    {"G42.1 D4 F100\nG1 Y10\nX20\nY20\nX19\nY30\nX40\nG40 Y50\n",
     "2 line X2 Y8 F100; 3 line X20; 4 arc X22 Y10 G17 about 20 10 by 90; 4 line Y20;"
     " ?5:0 comp-left 0.645751311/5; 5 arc X21 Y21.732051 G17 about 20 20 by 60; 6 line Y28;"
     " 7 line X40; ?8:0 comp-way 2/7; 8 line Y50"},
    {"G41.1 D10 F100\nG1 Y20\nX20\nX20.5 Y20.2\nX21 Y21\nX21.2 Y23\nY50\nG40 X0\n",
     "?2:0 comp-way 0.149287499/3; 2 line X-5 Y20 F100; 3 arc X0 Y25 G17 about 0 20 by -90;"
     " ?4:0 comp-left 1.44437739/6; 3 line X16.2; 7 line Y50; 8 line X0"},
    {"G41.1 D10 F100\nG1 Y20\nX20\nX25 Y15\nX30 Y20\nX50\nG40 X0\n",
     "?2:0 comp-way 0.149287499/3; 2 line X-5 Y20 F100; 3 arc X0 Y25 G17 about 0 20 by -90;"
     " 3 line X20; 4 arc X23.535534 Y23.535534 G17 about 20 20 by -45; 4 line X25 Y22.071068;"
     " 5 line X26.464466 Y23.535534; 6 arc X30 Y25 G17 about 30 20 by -45; 6 line X50;"
     " !7:0 comp-gouge G 5/3"},
    {"G41.1 D4 F100\nG1 Y20\nG0 X20\nY40\nG1 X40\nG40 X0\n",
     "2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90 F6000; 3 rapid X18; 4 rapid Y40;"
     " 5 arc X20 Y42 G17 about 20 40 by -90 F100; 5 line X40; !6:0 comp-gouge G 1.00124766/5"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG41.1 D2\nG40\nG1 X30\n",
     "!4:1 comp-on G 41.1/0; ?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100;"
     " 3 arc X0 Y12 G17 about 0 10 by -90; 3 line X20; ?6:0 comp-way 0.0388386486/3;"
     " 6 line X30 Y10"},
};

static void inside_corners_are_cut_or_refused(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, inside_rows);
}

static const told_row_t way_in_4_rows[] = {
    {"T2 M6\nG0 X10 Y20 Z5\nS100 M3\nF100 G1 Z-1\nX40\nG41.1 D4 Y40\nX80\nY60\nG40\nY90\n",
     "4 rapid Z50 stop P0 Q0; 4 out T2 X10 Y20 Z5 smooth P0.01 Q0.01 S100; 4 out M5; 4 wait M6;"
     " 4 rapid Z50 stop P0 Q0 S0; 4 out S100 Z5 smooth P0.01 Q0.01 S100; 4 out M3;"
     " 4 line F100 stop P0 Q0; 4 line Z-1 smooth P0.01 Q0.01; 5 line X40;"
     " ?6:0 comp-way 0.00992561958/7; 6 line X38 Y40; 7 arc X40 Y42 G17 about 40 40 by -90;"
     " 7 line X78; 8 line Y60; ?10:0 comp-way 0.00442968429/8; 10 line X80 Y90"},
};

static void the_way_in_at_line_4(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 4;
    self.compensates = 1;
    TOLD(check, &self, way_in_4_rows);
}

static const told_row_t way_in_5_rows[] = {
    {"T2 M6\nG0 X10 Y20 Z5\nS100 M3\nF100 G1 Z-1\nX40\nG41.1 D4 Y40\nX80\nY60\nG40\nY90\n",
     "5 rapid Z50 stop P0 Q0; 5 out T2 X10 Y20 Z-1 smooth P0.01 Q0.01 S100; 5 out M5; 5 wait M6;"
     " 5 rapid Z50 stop P0 Q0 S0; 5 out S100 Z-1 smooth P0.01 Q0.01 S100; 5 out M3;"
     " 5 line F100 stop P0 Q0; 5 line X40 smooth P0.01 Q0.01; ?6:0 comp-way 0.00992561958/7;"
     " 6 line X38 Y40; 7 arc X40 Y42 G17 about 40 40 by -90; 7 line X78; 8 line Y60;"
     " ?10:0 comp-way 0.00442968429/8; 10 line X80 Y90"},
};

static void the_way_in_at_line_5(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 5;
    self.compensates = 1;
    TOLD(check, &self, way_in_5_rows);
}

static const told_row_t way_in_7_rows[] = {
    {"T2 M6\nG0 X10 Y20 Z5\nS100 M3\nF100 G1 Z-1\nX40\nG41.1 D4 Y40\nX80\nY60\nG40\nY90\n",
     "?6:0 comp-way 0.00992561958/7; 7 rapid Z50 stop P0 Q0;"
     " 7 out T2 X38 Y40 Z-1 smooth P0.01 Q0.01 S100; 7 out M5; 7 wait M6;"
     " 7 rapid Z50 stop P0 Q0 S0; 7 out S100 Z-1 smooth P0.01 Q0.01 S100; 7 out M3;"
     " 7 line F100 stop P0 Q0; 7 arc X40 Y42 G17 about 40 40 by -90 smooth P0.01 Q0.01;"
     " 7 line X78; 8 line Y60; ?10:0 comp-way 0.00442968429/8; 10 line X80 Y90"},
};

static void the_way_in_at_line_7(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 7;
    self.compensates = 1;
    TOLD(check, &self, way_in_7_rows);
}

static const told_row_t way_in_8_rows[] = {
    {"T2 M6\nG0 X10 Y20 Z5\nS100 M3\nF100 G1 Z-1\nX40\nG41.1 D4 Y40\nX80\nY60\nG40\nY90\n",
     "?6:0 comp-way 0.00992561958/7; 8 rapid Z50 stop P0 Q0;"
     " 8 out T2 X78 Y42 Z-1 smooth P0.01 Q0.01 S100; 8 out M5; 8 wait M6;"
     " 8 rapid Z50 stop P0 Q0 S0; 8 out S100 Z-1 smooth P0.01 Q0.01 S100; 8 out M3;"
     " 8 line F100 stop P0 Q0; 8 line Y60 smooth P0.01 Q0.01; ?10:0 comp-way 0.00442968429/8;"
     " 10 line X80 Y90"},
};

static void the_way_in_at_line_8(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 8;
    self.compensates = 1;
    TOLD(check, &self, way_in_8_rows);
}

static const told_row_t way_in_10_rows[] = {
    {"T2 M6\nG0 X10 Y20 Z5\nS100 M3\nF100 G1 Z-1\nX40\nG41.1 D4 Y40\nX80\nY60\nG40\nY90\n",
     "?6:0 comp-way 0.00992561958/7; 10 rapid Z50 stop P0 Q0;"
     " 10 out T2 X80 Y60 Z-1 smooth P0.01 Q0.01 S100; 10 out M5; 10 wait M6;"
     " 10 rapid X78 Z50 stop P0 Q0 S0; 10 out S100 X80 Z-1 smooth P0.01 Q0.01 S100; 10 out M3;"
     " 10 line X78 F100 stop P0 Q0; ?10:0 comp-way 0.00442968429/8;"
     " 10 line X80 Y90 smooth P0.01 Q0.01"},
};

static void the_way_in_at_line_10(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.machine.dialect.from_line = 10;
    self.compensates = 1;
    TOLD(check, &self, way_in_10_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, the_tool_goes_beside_the_contour);
    CHECK_RUN(&check, inside_corners_are_cut_or_refused);
    CHECK_RUN(&check, the_way_in_at_line_4);
    CHECK_RUN(&check, the_way_in_at_line_5);
    CHECK_RUN(&check, the_way_in_at_line_7);
    CHECK_RUN(&check, the_way_in_at_line_8);
    CHECK_RUN(&check, the_way_in_at_line_10);
    return check_end(&check);
}
