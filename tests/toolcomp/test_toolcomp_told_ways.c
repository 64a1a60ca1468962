// SPDX-License-Identifier: MIT
// Rooms 1 and 2: what the path comes near to: the backs of contours, what lies on other heights,
// what is on the way in and out.
#include "told_check.h"

static told_t self;

// The path of line 3 is at Y22, and faces the back of a contour further on: the paths beside them
// do not cross. A corner at Y23.5, and an arc whose middle is there, are 0.5 mm too near.
static const told_row_t back_rows[] = {
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY23.5\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/6; 8 line X40 Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY24\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X58; 4 line Y58; 5 line X22; 6 line Y26; 7 line X40; 8 line Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY33.5\nG3 X40 I10\nG40 G1 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/7; 8 line X40 Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY34\nG3 X40 I10\nG40 G1 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X58; 4 line Y58; 5 line X22; 6 line Y34; 7 arc X38 G17 about 30 34 by 180;"
     " ?8:0 comp-way 0.0154442466/7; 8 line X40 Y50"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX30\nY23\nX20\nY60\nX60\nY20\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X30; ?5:0 comp-left 0.397915762/5;"
     " 5 arc X28.677124 Y25 G17 about 30 23.5 by 41.4096; 6 line X22; 7 line Y58; 8 line X58;"
     " 9 line Y22; !10:0 comp-gouge 1/5; 11 line X0 Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23\nX30\nY23.5\nX20\nY60\nX60\nY20\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25 F100; ?5:0 comp-left 0.397915762/5; 4 line X31.322876;"
     " 6 arc X30 Y25.5 G17 about 30 23.5 by 41.4096; 6 line X22; 7 line Y58; 8 line X58;"
     " 9 line Y22; !10:0 comp-gouge 1/4; 11 line X0 Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX30\nX20 Y22.5\nY60\nX60\nY20\nX0\nY50\nX-20\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X30;"
     " 5 arc X29.800993 Y25.490074 G17 about 30 23.5 by 5.7106; 5 line X22 Y24.709975; 6 line Y58;"
     " 7 line X58; 8 line Y22; !9:0 comp-gouge 1.5/5; 12 line X-20 Y10"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nX25 Y23.5\nX35 Y23\nX45 Y30\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 1/7; 9 line X45 Y50"},
    {"G0 X18 Y-20\nG41.1 D4 F100\nG1 X20 Y0\nG3 X-20 Y0 I-20\nG1 X-10\nG2 X10 Y0 I10\n"
     "G40 G1 Y-20\n",
     "1 rapid X18 Y-20; 3 line X17.999738 Y0.097131 F100;"
     " 4 arc X-17.888544 Y2 G17 about 0 0 by 173.3115; 5 line X-11.83216;"
     " 6 arc X12 Y0 G17 about 0 0 by -170.4059; ?7:0 comp-way 0.00992561958/6; 7 line X10 Y-20"},
    {"G0 X-10 Y-10\nG41.1 D6 F100\nG1 X0 Y0\nX10\nY-10\nX5\nY-30\nX19\nY-10\nX14\nY0\n"
     "X30\nG40 Y20\n",
     "1 rapid X-10 Y-10; ?3:0 comp-way 0.0653040717/4; 3 line X-2.12132 Y2.12132 F100;"
     " 4 arc X0 Y3 G17 about 0 0 by -45; 4 line X10; !5:0 comp-gouge 2/11; 13 line X30 Y20"},
    {"G0 X-10 Y-10\nG41.1 D3.9 F100\nG1 X0 Y0\nX10\nY-10\nX5\nY-30\nX19\nY-10\nX14\nY0\n"
     "X30\nG40 Y20\n",
     "1 rapid X-10 Y-10; ?3:0 comp-way 0.0182769783/4; 3 line X-1.378858 Y1.378858 F100;"
     " 4 arc X0 Y1.95 G17 about 0 0 by -45; 4 line X10; 5 arc X11.95 Y0 G17 about 10 0 by -90;"
     " 5 line Y-10; 6 arc X10 Y-11.95 G17 about 10 -10 by -90; 6 line X6.95; 7 line Y-28.05;"
     " 8 line X17.05; 9 line Y-11.95; 10 line X14; 11 arc X12.05 Y-10 G17 about 14 -10 by -90;"
     " 11 line Y0; 12 arc X14 Y1.95 G17 about 14 0 by -90; 12 line X30; 13 line Y20"},
};

static void a_path_keeps_off_the_back_of_a_contour(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, back_rows);
}

// The same contours, part of them lower or higher: in G17 the tool passes above what is lower by
// more than 1 µm. Three end in the corner where they begin; two come to line 5 or 6 from where
// they leave line 3, lower down or not; in the last both go down.
static const told_row_t level_rows[] = {
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nZ-1\nY23.5\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X58; 4 line Y58; 5 line X22; 6 line Z-1; 7 line Y25.5; 8 line X40; 9 line Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nZ1\nY23.5\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/7; 9 line X40 Y50 Z1"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nZ-0.001\nY23.5\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/7; 9 line X40 Y50 Z-0.001"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nZ-0.0011\nY23.5\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X58; 4 line Y58; 5 line X22; 6 line Z-0.0011; 7 line Y25.5; 8 line X40; 9 line Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY23.5 Z-1\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X58; 4 line Y58; 5 line X22; 6 line Y25.5 Z-1; 7 line X40; 8 line Y50"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60\nY60\nX20\nY23.5 Z1\nX40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/6; 8 line X40 Y50 Z1"},
    {"G18 G41.1 D4 F100\nG1 Z0 X20\nZ60\nX60\nZ20\nY-1\nX23.5\nZ40\nG40 X50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Z-2 F100; 3 arc X22 Z0 G18 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/7; 9 line X50 Y-1 Z40"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX20\nY60\nX60\nY20\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X22; 5 line Y58; 6 line X58; 7 line Y22;"
     " !8:0 comp-gouge 0.5/4; 9 line X0 Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX20\nY60\nX60\nZ1\nY20\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X22; 5 line Y58; 6 line X58; 7 line Z1;"
     " 8 line Y22; 9 line X0; ?10:0 comp-way 2/9; 10 line Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX20\nY60\nX60\nZ-1\nY20\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X22; 5 line Y58; 6 line X58; 7 line Z-1;"
     " 8 line Y22; !9:0 comp-gouge 0.5/4; 10 line X0 Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX20\nY60\nX60\nY20 Z1\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X22; 5 line Y58; 6 line X58; 7 line Y22 Z1;"
     " 8 line X0; ?9:0 comp-way 2/8; 9 line Y10"},
    {"G0 X40 Y40\nG42.1 D4 F100\nG1 Y23.5\nX20\nY60\nX60\nZ-1\nY20 Z1\nX0\nG40 Y10\n",
     "1 rapid X40 Y40; 3 line X38 Y25.5 F100; 4 line X22; 5 line Y58; 6 line X58; 7 line Z-1;"
     " 8 line Y22 Z1; 9 line X0; ?10:0 comp-way 2/9; 10 line Y10"},
    {"G0 X0 Y0\nG41.1 D6 F100\nG1 X20 Y-20\nY20\nX-20\nY-20\nX20\nG40 X0 Y0\n",
     "1 rapid; 3 line X17 Y-12.757359 F100; 4 line Y17; 5 line X-17; 6 line Y-17;"
     " !7:0 comp-gouge 3/4; 8 line X0 Y0"},
    {"G0 X0 Y0\nG41.1 D6 F100\nG1 X20 Y-20\nY20\nX-20\nY-20\nZ1\nX20\nG40 X0 Y0\n",
     "1 rapid; 3 line X17 Y-12.757359 F100; 4 line Y17; 5 line X-17; 6 line Y-17; 7 line Z1;"
     " 8 line X20; 9 line X0 Y0"},
    {"G0 X0 Y0\nG41.1 D6 F100\nG1 X20 Y-20\nY20\nX-20\nY-20\nZ-1\nX20\nG40 X0 Y0\n",
     "1 rapid; 3 line X17 Y-12.757359 F100; 4 line Y17; 5 line X-17; 6 line Y-17; 7 line Z-1;"
     " !8:0 comp-gouge 3/4; 9 line X0 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20 Z-3\nX39.5\nX40 Y20.5 Z0\nY60\nX20\nZ-2\nY26\nX36.5\nY40\nG40 X30\n",
     "2 line X-2 Y20 Z-3 F100; 3 arc X0 Y22 G17 about 0 20 by -90; ?4:0 comp-left 0.5/4;"
     " 3 line X38; !5:0 comp-gouge 0.5/9; 11 line X30 Y40 Z-2"},
    {"G41.1 D4 F100\nG1 X0 Y20 Z-3\nX39.5\nZ0\nX40 Y20.5\nY60\nX20\nZ-2\nY26\n"
     "X36.5\nY40\nG40 X30\n",
     "2 line X-2 Y20 Z-3 F100; 3 arc X0 Y22 G17 about 0 20 by -90; ?5:0 comp-left 0.5/5;"
     " 3 line X38; 4 line Z0; 6 line Y58; 7 line X22; 8 line Z-2; 9 line Y28; 10 line X34.5;"
     " 11 line Y40; 12 line X30"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX60 Z-3\nY60\nX50 Z-2\nY23.5 Z-2.4\nG40 X58 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 0.5/6; 7 line X58 Y50 Z-2.4"},
    {"G41.1 D4 F100\nG1 X0 Y20 Z-3\nX39.3\nX39.6 Y20.2 Z-1.5\nX40 Y20.5 Z0\nY60\nX20\nZ-2\nY26\n"
     "X36.5\nY40\nG40 X30\n",
     "2 line X-2 Y20 Z-3 F100; 3 arc X0 Y22 G17 about 0 20 by -90; ?4:0 comp-left 0.5/5;"
     " 3 line X38; !6:0 comp-gouge 0.5/10; 12 line X30 Y40 Z-2"},
};

static void a_path_passes_above_what_lies_lower(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, level_rows);
}

// Ways in and out: above walls and through them, past a lap and beyond a rapid.
static const told_row_t ways_rows[] = {
    {"G41.1 D4 F100\nG3 X20 Y20 J20\nG1 Y40\nX12\nY8\nG40 X0 Y30\n",
     "!2:0 comp-gouge G 0.412480787/5; 6 line Y30 F100"},
    {"G41.1 D4 F100\nG3 X20 Y20 J20\nG1 Y40\nX12\nY12\nG40 X0 Y30\n",
     "2 arc X18 Y20 G17 about -2.11111 20 by 83.9744 F100; 3 line Y38; 4 line X14; 5 line Y12;"
     " !6:0 comp-gouge G 2/5"},
    {"G0 X10 Y10\nG41.1 D4 F100\nG1 X20\nY20\nX0\nY0\nX20\nY10\nX19\nY19\nX1\n"
     "Y1\nX19\nY10\nG40 X10 Y10\n",
     "1 rapid X10 Y10; 3 line X18 Y12 F100; 4 line Y18; 5 line X2; 6 line Y2; 7 line X18;"
     " ?9:0 comp-left 0.645751311/9; 8 line Y8.267949; 10 arc X17 Y10 G17 about 19 10 by -60;"
     " 10 line Y17; 11 line X3; 12 line Y3; 13 line X17; 14 line Y10; 15 line X10"},
    {"G0 X10 Y10\nG41.1 D4 F100\nG1 X19\nY19\nX1\nY1\nX19\nY10\nX20\nY20\nX0\n"
     "Y0\nX20\nY10\nG40 X10 Y10\n",
     "1 rapid X10 Y10; 3 line X17 Y12 F100; 4 line Y17; 5 line X3; 6 line Y3; 7 line X17;"
     " 8 line Y10; ?9:0 comp-left 0.645751311/9; 9 arc X18 Y11.732051 G17 about 19 10 by -60;"
     " 10 line Y18; 11 line X2; 12 line Y2; 13 line X18; 14 line Y10; 15 line X10"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG0 Y30\nG1 X40\nG40 X10 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X18; 4 rapid Y30; 5 arc X20 Y32 G17 about 20 30 by -90; 5 line X40;"
     " ?6:0 comp-way 2/5; 6 line X10 Y0"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG1 Y30\nG1 X40\nG40 X10 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X18; 4 line Y30; 5 arc X20 Y32 G17 about 20 30 by -90; 5 line X40;"
     " !6:0 comp-gouge G 2/4"},
    {"G41.1 D4 F100\nG1 Y20\nX20\nG0 Y40\nG1 X-1\nY0\nG40 X-20\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X18; 4 rapid Y38; 5 line X1; 6 line Y0; ?7:0 comp-way 2/6; 7 line X-20"},
    {"G41.1 D4 F100\nG1 Y20\nX20\nG1 Y40\nG1 X-1\nY0\nG40 X-20\n",
     "!2:0 comp-gouge G 2/6; 7 line X-20 F100"},
    {"G41.1 D4 F100\nG1 X20\nZ-5\nX0 Y-1 Z5\nG40 Y-20\n",
     "!2:0 comp-gouge G 1.00124766/4; 5 line Y-20 Z5 F100"},
    {"G41.1 D4 F100\nG1 X20\nZ5\nX0 Y-1 Z-5\nG40 Y-20\n",
     "!2:0 comp-gouge G 0.507543718/4; 5 line Y-20 Z-5 F100"},
    {"G0 Z5\nG41.1 D4 F100\nG1 X20 Z-5\nZ0\nX0 Y-1\nG40 Y-20\n",
     "1 rapid Z5; !3:0 comp-gouge G 0.501971367/5; 6 line Y-20 Z0 F100"},
    {"G0 Z5\nG41.1 D4 F100\nG1 X20\nZ0\nX0 Y-1\nG40 Y-20\n",
     "1 rapid Z5; 3 line X20 Y2 F100; 4 line Z0;"
     " 5 arc X20.099875 Y-1.997505 G17 about 20 0 by -177.1376; 5 line X0.099875 Y-2.997505;"
     " 6 line X0 Y-20"},
    {"G41.1 D4 F100\nG0 X20\nG1 X0 Y-1\nG40 Y-20\n",
     "2 rapid X20 Y2; 3 arc X20.099875 Y-1.997505 G17 about 20 0 by -177.1376 F100;"
     " 3 line X0.099875 Y-2.997505; 4 line X0 Y-20"},
    {"G41.1 D4 F100\nG1 X20\nG40 X0\n",
     "2 line X20 Y2 F100; 3 line X0 Y0"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40 Z3\nX0 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 line Z3; 5 line X0 Y0"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40 Z-3\nX0 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 line Z-3; !5:0 comp-gouge G 2/3"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40 X18 Y-9.5 Z3\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; ?4:0 comp-way 0.00716666667/3; 4 line X18 Y-9.5 Z3"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40 G0 X0 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; 4 rapid X0 Y0"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40 X40\nG41.1 D4\nX60\nY-20\nG40 X10 Y0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; ?4:0 comp-way 0.00992561958/3; 4 line X40 Y10; ?6:0 comp-way 0.00992561958/7;"
     " 6 line X60 Y12; 7 arc X62 Y10 G17 about 60 10 by -90; 7 line Y-20; ?8:0 comp-way 2/7;"
     " 8 line X10 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX20\nX20 Y24\nX-20\nG40 X-30 Y0\nX5 Y21\nX0 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X18; !4:0 comp-gouge 2/5; 6 line X-30 Y0; 7 line X5 Y21; 8 line X0 Y0"},
};

// By types A and B.
static const told_row_t a_rows[] = {
    {"G41.1 D6 F100\nG1 X20\nY-20\nG40 X0\n",
     "?2:0 comp-way 3/3; 2 line X23 F100; 3 line Y-20; ?4:0 comp-way 3/3; 4 line X0"},
    {"G41.1 D6 F100\nG1 X20\nX10 Y-20\nG40 X20\n",
     "?2:0 comp-way 3/3; 2 line X22.683282 Y-1.341641 F100; 3 line X12.683282 Y-21.341641;"
     " 4 line X20 Y-20"},
    {"G41.1 D6 F100\nG1 X20\nX30 Y-20\nG40 Y-40\n",
     "?2:0 comp-way 1.81913014/3; 2 line X22.683282 Y1.341641 F100; 3 line X32.683282 Y-18.658359;"
     " ?4:0 comp-way 0.505045534/3; 4 line X30 Y-40"},
    {"G41.1 D6 F100\nG1 X20\nY20\nG40 X30\n",
     "2 line X17 F100; 3 line Y20; ?4:0 comp-way 3/3; 4 line X30"},
    {"G41.1 D6 F100\nG1 X20\nY-20\nX0\nY-10\nG40 X40 Y0\n",
     "?2:0 comp-way 3/3; 2 line X23 F100; 3 line Y-20; 4 arc X20 Y-23 G17 about 20 -20 by -90;"
     " 4 line X0; 5 arc X-3 Y-20 G17 about 0 -20 by -90; 5 line Y-10; !6:0 comp-gouge G 3/3"},
    {"G41.1 D6 F100\nG1 X20\nY-20\nX40\nG40 Z4\nX30 Y-50\n",
     "?2:0 comp-way 3/3; 2 line X23 F100; 3 line Y-17; 4 line X40; 5 line Z4; 6 line X30 Y-50"},
    {"G41.1 D6 F100\nG1 X20\nY-20\nX40\nG40 X0 Y-18\n",
     "?2:0 comp-way 3/3; 2 line X23 F100; 3 line Y-17; 4 line X40; !5:0 comp-gouge G 3/3"},
    {"G0 X0 Y30\nG41.1 D6 F100\nG1 Y20\nX20\nY0\nX10\nY18.5\nG40 X-9 Y30\n",
     "1 rapid Y30; 3 line Y23 F100; 4 line X20; 5 arc X23 Y20 G17 about 20 20 by -90; 5 line Y0;"
     " 6 arc X20 Y-3 G17 about 20 0 by -90; 6 line X10; !7:0 comp-gouge 1.5/4; 8 line X-9 Y30"},
};

static const told_row_t b_rows[] = {
    {"G41.1 D4 F100\nG1 X20\nY-20\nG40 X0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100; 3 arc X22 Y0 G17 about 20 0 by -90;"
     " 3 line Y-20; ?4:0 comp-way 0.00992561958/3; 4 arc X20 Y-22 G17 about 20 -20 by -90;"
     " 4 line X0 Y-20"},
    {"G41.1 D4 F100\nG1 X20\nX10 Y-20\nG40 X20\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100;"
     " 3 arc X21.788854 Y-0.894427 G17 about 20 0 by -116.5651; 3 line X11.788854 Y-20.894427;"
     " 4 line X20 Y-20"},
    {"G41.1 D4 F100\nG1 X20\nX30 Y-20\nG40 Y-40\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100;"
     " 3 arc X21.788854 Y0.894427 G17 about 20 0 by -63.4349; 3 line X31.788854 Y-19.105573;"
     " ?4:0 comp-way 0.00992561958/3; 4 arc X32 Y-20 G17 about 30 -20 by -26.5651;"
     " 4 line X30 Y-40"},
    {"G41.1 D4 F100\nG1 X20\nY20\nG40 X30\n",
     "2 line X18 F100; 3 line Y20; ?4:0 comp-way 0.0388386486/3;"
     " 4 arc X20 Y22 G17 about 20 20 by -90; 4 line X30 Y20"},
    {"G41.1 D4 F100\nG1 X20\nY-20\nX0\nY-10\nG40 X40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100; 3 arc X22 Y0 G17 about 20 0 by -90;"
     " 3 line Y-20; 4 arc X20 Y-22 G17 about 20 -20 by -90; 4 line X0;"
     " 5 arc X-2 Y-20 G17 about 0 -20 by -90; 5 line Y-10; !6:0 comp-gouge G 2/3"},
    {"G41.1 D4 F100\nG1 X20\nY-20\nX40\nG40 Z4\nX30 Y-50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100; 3 arc X22 Y0 G17 about 20 0 by -90;"
     " 3 line Y-18; 4 line X40; 5 line Z4;"
     " 6 arc X41.897367 Y-20.632456 G17 about 40 -20 by -108.435; 6 line X30 Y-50"},
    {"G41.1 D4 F100\nG1 X20\nY-20\nX40\nG40 X0 Y-18\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y2 F100; 3 arc X22 Y0 G17 about 20 0 by -90;"
     " 3 line Y-18; 4 line X40; !5:0 comp-gouge G 2/3"},
    {"G0 X0 Y30\nG41.1 D4 F100\nG1 Y20\nX20\nY0\nX10\nY18.5\nG40 X-9 Y30\n",
     "1 rapid Y30; 3 line Y22 F100; 4 line X20; 5 arc X22 Y20 G17 about 20 20 by -90; 5 line Y0;"
     " 6 arc X20 Y-2 G17 about 20 0 by -90; 6 line X10; !7:0 comp-gouge 0.5/4; 8 line X-9 Y30"},
};

static void ways_are_held_against_the_contour(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, ways_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_A;
    TOLD(check, &self, a_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_B;
    TOLD(check, &self, b_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_path_keeps_off_the_back_of_a_contour);
    CHECK_RUN(&check, a_path_passes_above_what_lies_lower);
    CHECK_RUN(&check, ways_are_held_against_the_contour);
    return check_end(&check);
}
