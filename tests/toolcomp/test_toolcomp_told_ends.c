// SPDX-License-Identifier: MIT
// Rooms 1 and 2: the tool's centre at the ends of the travel, in narrow contours, beside a nose.
#include "told_check.h"

static told_t self;

static const told_row_t beside_bound_rows[] = {
    {"G42.1 D4 F100\nG1 X10 Y5\nX99\nY8\n",
     "2 line X10.472136 Y3 F100; 3 line X99; !4:0 travel X 101/100"},
    {"G42.1 D4 F100\nG1 X10 Y5\nX97\nG3 Y15 J5\nG1 X10\n",
     "!4:0 travel X 102/100; 2 line X10.472136 Y3 F100; 3 line X97;"
     " 5 arc X97.228381 Y6.986918 G17 about 97 5 by 173.4431; 5 line X10.228381 Y16.986918"},
    {"G41.1 D4 F100\nG1 X-5 Y5\nY190\nG2 X5 Y199 I9\nG1 X20\n",
     "!4:1 arc-radius 9.05538514/9; ?2:0 comp-way 0.0754991027/3;"
     " 2 line X-6.414214 Y3.585786 F100; 3 arc X-7 Y5 G17 about -5 5 by -45; 3 line Y190;"
     " 5 arc X-5.677439 Y191.881775 G17 about -5 190 by -70.2011; !5:0 travel Y 200.881775/200"},
    {"G41.1 D4 F100\nG1 X-5 Y5\nY190\nG2 X10 Y190 I7.5 P1\nG1 Y100\n",
     "?2:0 comp-way 0.0754991027/3; 2 line X-6.414214 Y3.585786 F100;"
     " 3 arc X-7 Y5 G17 about -5 5 by -45; 3 line Y190; 4 arc X12 G17 about 2.5 190 by -180;"
     " 5 line Y100"},
    {"G41.1 D4 F100\nG1 X20 Y-5\nX10\nG2 X0 Y5 J10\nG1 Y50\n",
     "!2:0 comp-gouge G 2/4"},
    {"G41.1 D4 F100\nG1 X20 Y-5\nX10\nG2 X-5 Y-5 I-7.5\nG1 Y50\n",
     "?2:0 comp-way 0.00934584553/3; 2 line X20.485071 Y-3.059715 F100;"
     " 3 arc X20 Y-7 G17 about 20 -5 by -165.9638; 3 line X11.787088;"
     " 4 arc X-7 Y-5 G17 about 2.5 -5 by -167.8468; 5 line Y50"},
    {"G42.1 D4 F100\nG1 X20 Y-5\nG3 X40 I10\nG1 Y20\n",
     "2 line X18.105528 Y-6.587935 F100; 3 arc X42 Y-5 G17 about 30 -5 by 172.3959; 4 line Y20"},
    {"G42.1 D4 F100\nG1 X20 Y-10\nG3 X40 I10\nG1 Y20\n",
     "2 line X18.067367 Y-11.269751 F100; !3:0 travel Y -22/-20"},
    {"G41.1 D4 F100\nG1 X-8.5 Y5\nY100\n",
     "?2:0 comp-way 0.0399042603/3; 2 line X-9.51404 Y3.276132 F100; !3:0 travel X -10.5/-10"},
    {"G41.1 D4 F100\nG1 X50 Y199\nX80\nY100\n",
     "2 line X48.06029 Y199.487364 F100; !3:0 travel Y 201/200"},
    {"G41.1 D4 F100\nG1 X50 Y-18.5\nX20\nY100\n",
     "!2:0 comp-gouge G 2/4"},
    {"G43.1 X5 Y5 Z5\nG41.1 D4 F100\nG1 X50 Y192\nX80\nY194\nX90\n",
     "3 line X53.073666 Y197.537809 F100; 4 arc X55 Y199 G17 about 55 197 by -74.4009;"
     " ?5:0 comp-left 0.828427125/5; 4 line X83; !6:0 travel Y 201/200"},
    {"G18 G41.1 D4 F100\nG1 Z5 X20\nZ47\nX30\nZ49\nX50\n",
     "?2:0 comp-way 0.00934584553/3; 2 line X20.485071 Z3.059715 F100;"
     " 3 arc X22 Z5 G18 about 5 20 by -75.9638; 3 line Z45; 4 line X30;"
     " ?5:0 comp-left 0.828427125/5; 5 arc X32 Z47 G18 about 47 30 by -90; 6 line X50"},
    {"G18 G41.1 D4 F100\nG1 Z5 X95\nZ20\nX99\nZ30\n",
     "2 line X95.105118 Z3.002764 F100; 3 arc X97 Z5 G18 about 5 95 by -86.9872; 3 line Z18;"
     " 4 line X99; !5:0 travel X 101/100"},
    {"G19 G42.1 D4 F100\nG1 Y20 Z-5\nY190\nZ10\nY199\nZ30\n",
     "?2:0 comp-way 0.00934584553/3; 2 line Y19.514929 Z-6.940285 F100;"
     " 3 arc Y20 Z-7 G19 about 20 -5 by 14.0362; 3 line Y190;"
     " 4 arc Y192 Z-5 G19 about 190 -5 by 90; 4 line Z8; 5 line Y199; !6:0 travel Y 201/200"},
    {"G41.1 D4 F100\nG1 X0 Y190\nG2 X10 Y190 I5\nG1 X30\n",
     "2 line X-2 Y190 F100; 3 arc X11.708204 Y192 G17 about 5 190 by -163.3985; 4 line X30"},
    {"G41.1 D4 F100\nG1 X0 Y190\nG2 X20 Y190 I10\nG1 X30\n",
     "2 line X-2 Y190 F100; !3:0 travel Y 202/200"},
    {"G42.1 D4 F100\nG1 X0 Y190\nG3 X-7 Y190 I-3.5\nG1 X-7 Y150\n",
     "2 line X2 Y190 F100; 3 arc X-9 G17 about -3.5 190 by 180; 4 line Y150"},
};

static void no_part_of_the_path_leaves_the_travel(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.compensates = 1;
    TOLD(check, &self, beside_bound_rows);
}

static const told_row_t inside2_rows[] = {
    {"G41.1 D4 F100\nG1 X20\nX20 Y20\nX0\nY0\nX20\nG40 X40\n",
     "!2:0 comp-gouge G 2/5; 7 line X40 F100"},
    {"G42.1 D4 F100\nG1 X20\nX20 Y20\nX0\nY0\nX20\nY10\nG40 X40\n",
     "!2:0 comp-gouge G 2/5; 8 line X40 Y10 F100"},
    {"G41.1 D4 F100\nG1 X20\nY20\nX40 Y10\nX20\nG40 Y-10\n",
     "2 line X18 Y2 F100; 3 line Y20; 4 arc X20.894427 Y21.788854 G17 about 20 20 by -116.5651;"
     " 4 line X40.894427 Y11.788854; 5 arc X40 Y8 G17 about 40 10 by -153.4349; 5 line X20;"
     " !6:0 comp-gouge G 2/3"},
    {"G42.1 D4 F100\nG1 Y5\nX20 Y15\nX0 Y25\nY5\nG40 X-10\n",
     "2 line X2 Y3.763932 F100; 3 line X20.894427 Y13.211146;"
     " 4 arc Y16.788854 G17 about 20 15 by 126.8699; 4 line X0.894427 Y26.788854;"
     " 5 arc X-2 Y25 G17 about 0 25 by 116.5651; 5 line Y5; 6 line X-10"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX10\nG2 X30 Y20 I10\nG1 X40\nG3 X60 Y20 I10\nG1 X70\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X8.16784; 4 arc X31.83216 G17 about 20 20 by -160.8119; 5 line X40;"
     " 6 arc X42 Y20 G17 about 40 20 by -90; 6 arc X58 G17 about 50 20 by 180;"
     " 7 arc X60 Y22 G17 about 60 20 by -90; 7 line X70; ?8:0 comp-way 2/7; 8 line Y0"},
    {"G41.1 D20 F100\nG1 X0 Y20\nX10\nG3 X30 Y20 I10\nG1 X40\nG40 Y0\n",
     "!4:0 comp-radius 10/10; 5 line X40 Y20 F100; 6 line Y0"},
    {"G41.1 D19.99 F100\nG1 X0 Y20\nX10\nG3 X30 Y20 I10\nG1 X40\nG40 Y0\n",
     "?2:0 comp-way 1.05430634/3; 2 line X-9.995 Y20 F100; 3 arc X0 Y29.995 G17 about 0 20 by -90;"
     " 3 line X10; 4 arc X19.995 Y20 G17 about 10 20 by -90; 4 arc X20.005 G17 about 20 20 by 180;"
     " 5 arc X30 Y29.995 G17 about 30 20 by -90; 5 line X40; ?6:0 comp-way 9.995/5; 6 line Y0"},
    {"G42.1 D6 F100\nG1 X0 Y20\nX10\nX10.5 Y19\nX11 Y20\nX12 Y18\nX13 Y20\nX30\nG40 Y0\n",
     "2 line X3 Y17 F100; ?4:0 comp-left 0.466111946/4; 3 line X8.263932;"
     " ?5:0 comp-left 1.06030393/6; 5 arc X9.662792 Y16.119187 G17 about 10.5 19 by 31.985;"
     " 7 arc X14.683282 Y16.658359 G17 about 12 18 by 114.6104; 7 line X14.854102 Y17;"
     " 8 line X30; 9 line Y0"},
    {"G42.1 D6 F100\nG1 X0 Y20\nX10\nG2 X12 Y20 I1\nG1 X20\nG3 X22 Y20 I1\nG1 X40\nG40 Y0\n",
     "!4:0 comp-radius 3/1; 5 line X20 Y20 F100; 6 arc X22 G17 about 21 20 by 180; 7 line X40;"
     " 8 line Y0"},
    {"G41.1 D6 F100\nG1 X0 Y20\nX10\nG2 X12 Y20 I1\nG1 X20\nG3 X22 Y20 I1\nG1 X40\nG40 Y0\n",
     "!6:0 comp-radius 3/1; 7 line X40 Y20 F100; 8 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX40\nY24\nX0\nY26\nX-20\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X38; !4:0 comp-gouge 2/5; 8 line X-20 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX40\nY24.1\nX-20\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X38; 4 line Y22.1; 5 line X-20; 6 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX40\nY30\nX20\nY22\nX10\nY40\nG40 Y50\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " !3:0 comp-gouge 2/6; 9 line X10 Y50"},
    {"G42.1 D4 F100\nG1 X0 Y20\nX40\nY30\nX20\nY10\nG40 X10\n",
     "2 line X2 Y18 F100; 3 line X40; 4 arc X42 Y20 G17 about 40 20 by 90; 4 line Y30;"
     " 5 arc X40 Y32 G17 about 40 30 by 90; 5 line X20; 6 arc X18 Y30 G17 about 20 30 by 90;"
     " 6 line Y10; 7 line X10"},
    {"G42.1 D4 F100\nG1 X0 Y20\nX40\nY40\nX20\nY0\nX50\nG40 X60\n",
     "2 line X2 Y18 F100; 3 line X40; 4 arc X42 Y20 G17 about 40 20 by 90; 4 line Y40;"
     " 5 arc X40 Y42 G17 about 40 40 by 90; 5 line X20; 6 arc X18 Y40 G17 about 20 40 by 90;"
     " 6 line Y0; 7 arc X20 Y-2 G17 about 20 0 by 90; 7 line X50; ?8:0 comp-way 0.0388386486/7;"
     " 8 line X60 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX40\nY40\nX20\nY0\nX50\nG40 X60\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X38; 4 line Y38; 5 line X22; 6 line Y2; 7 line X50; ?8:0 comp-way 0.0388386486/7;"
     " 8 line X60 Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX40\nG0 Y24\nG1 X0\nY22\nX-20\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X38; 4 rapid Y24; ?6:0 comp-left 0.828427125/6; 5 line X40 Y22; 5 line X2;"
     " 7 arc X0 Y20 G17 about 0 22 by -90; 7 line X-20; 8 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nG2 X0 Y20 I10\nG2 X20 Y20 I10\nG1 X40\nG40 Y0\n",
     "?2:0 comp-way 0.0595537175/3; 2 line X-2 Y20 F100;"
     " 3 arc X16 Y30.392305 G17 about 10 20 by -120; 3 arc Y9.607695 G17 about 10 20 by -120;"
     " 3 arc X-2 Y20 G17 about 10 20 by -120; 4 arc X21.83216 Y22 G17 about 10 20 by -170.4059;"
     " 5 line X40; ?6:0 comp-way 2/5; 6 line Y0"},
    {"G41.1 D4 F100\nG1 X0 Y20\nX20 Y20.0000005\nX40 Y20\nX40.00001\nX60\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X20; 4 line X40; 5 line X40.00001; 6 line X60; ?7:0 comp-way 2/6; 7 line Y0"},
    {"G42.1 D2 F100\nG1 X0 Y20\nX20 Y18\nX40 Y20\nX60 Y20.05\nX80 Y20\nG40 Y0\n",
     "2 line X1 Y18.895012 F100; 3 line X19.900496 Y17.004963;"
     " 4 arc X20.099504 G17 about 20 18 by 11.4212; 4 line X40.051122 Y19.000125;"
     " 5 line X60 Y19.049997; 6 line X79.9975 Y19.000003; 7 line X80 Y0"},
    {"G41.1 D4 F100\nG2 X10 Y10 I10 Z5\nX20 Y0 J-10 Z10\nG1 X20 Y-10 Z0\nG40 X30\n",
     "2 arc X10 Y12 Z5 G17 about 10 1.83333 by -100.3889 F100;"
     " 3 arc X22 Y0 Z10 G17 about 10 0 by -90; 4 line Y-10 Z0; 5 line X30"},
    {"G41.1 D4 F100 G93\nG1 X0 Y20 F1\nG2 X20 I10 P2 F2\nG1 X40 F3\nG40 Y0 F1\n",
     "?2:0 comp-way 0.0595537175/3; 2 line X-2 Y20 F1 inverse;"
     " 3 arc X21.981312 Y20.669445 G17 about 10 20 by -176.802 F2;"
     " 3 arc X-1.925307 Y18.663196 G17 about 10 20 by -176.802;"
     " 3 arc X21.83216 Y22 G17 about 10 20 by -176.802; 4 line X40 F3; ?5:0 comp-way 2/4;"
     " 5 line Y0 F1"},
};

static void narrow_contours_are_cut_left_out_or_refused(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, inside2_rows);
}

static const told_row_t between_rows[] = {
    {"G41.1 D4 F100\nG1 Y10\nX20\nM8\nG4 P1\nY20\nS5\nX40\nM9\nY0\nG40 X60\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X18; 4 out M8; 5 dwell for 1; 6 line Y20; 7 out S5;"
     " 8 arc X20 Y22 G17 about 20 20 by -90; 8 line X40; 9 out M9;"
     " 10 arc X42 Y20 G17 about 40 20 by -90; 10 line Y0; 11 line X60"},
    {"G41.1 D4 F100\nM8\nG1 Z-1\nY10\nZ-2\nX20\nZ-3\nY8\nZ-4\nX21\nZ-5\nY10\nZ-6\nX40\nG40\n"
     "Z5\nY0\n",
     "2 out M8; 3 line Z-1 F100; 4 line X-2 Y10; 5 line Z-2;"
     " 6 arc X0 Y12 G17 about 0 10 by -90; 6 line X20; 7 line Z-3;"
     " ?8:0 comp-left 1.96811879/12; 8 arc X20.5 Y11.936492 G17 about 20 10 by -14.4775;"
     " 9 line Z-4; 11 line Z-5; 13 line Z-6; 14 arc X21 Y12 G17 about 21 10 by -14.4775;"
     " 14 line X40; 16 line Z5; 17 line Y0"},
    {"G41.1 D4 F100\nG1 Y10\nG2 X20 R10\nG40\nG2 X30 R5\nG1 Z5\nX40\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X22 G17 about 10 10 by -180;"
     " !5:0 comp-exit; 6 line X30 Z5; 7 line X40"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG40\nG2 X30 R5\nZ5\nG1 X40\nG42.1 D2\nX50\nY30\nG40\nZ7\nX0\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90;"
     " 3 line X20; !5:0 comp-exit; !6:0 arc-centre; 7 line X40 Y10 Z5;"
     " ?9:0 comp-way 0.00496280979/10; 9 line X50 Y9; 10 arc X51 Y10 G17 about 50 10 by 90;"
     " 10 line Y30; 12 line Z7; 13 line X0"},
    {"G41.1 D4 F100\nG1 X10\nX30 Y0\nX20 Y17.320508\nX10 Y0\nG40 X0\n",
     "?2:0 comp-way 0.999999997/5; 2 line X10 Y2 F100; 3 line X26.535898; 4 line X20 Y13.320508;"
     " !5:0 comp-gouge 2/3; 6 line X0 Y0"},
    {"G42.1 D4 F100\nG1 X10\nX30 Y0\nX20 Y17.320508\nX10 Y0\nX20\nG40 X40\n",
     "?2:0 comp-way 0.0388386486/3; 2 line X10 Y-2 F100; 3 line X30;"
     " 4 arc X31.732051 Y1 G17 about 30 0 by 120; 4 line X21.732051 Y18.320508;"
     " 5 arc X18.267949 G17 about 20 17.32051 by 120; 5 line X8.267949 Y1;"
     " 6 arc X10 Y-2 G17 about 10 0 by 120; 6 line X20; !7:0 comp-gouge G 1.00496281/4"},
    {"G41.1 D4 F100\nG1 X15 Y0\nX30 Y0\nX20 Y17.320508\nX10 Y0\nX20\nG40 X20 Y5\n",
     "!2:0 comp-gouge G 2/5; 7 line X20 Y5 F100"},
    {"G41.1 D4 F100\nG1 Y20\nX40\nY25\nX38\nY40\nG40 X60\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X38; ?5:0 comp-left 0.828427125/5; 4 line Y23; 6 arc X36 Y25 G17 about 38 25 by -90;"
     " 6 line Y40; ?7:0 comp-way 2/6; 7 line X60"},
    {"G42.1 D4 F100\nG1 Y20\nX40\nX40 Y25\nX42\nY40\nG40 X60\n",
     "2 line X2 Y18 F100; 3 line X40; 4 arc X42 Y20 G17 about 40 20 by 90;"
     " ?5:0 comp-left 0.828427125/5; 4 line Y23; 6 arc X44 Y25 G17 about 42 25 by 90;"
     " 6 line Y40; 7 line X60"},
    {"G41.1 D4 F100\nG1 Y20\nX10\nX20 Y30\nX30 Y20\nX40\nX50 Y10\nX60 Y20\nX80\nG40 Y0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X9.171573; 4 line X18.585786 Y31.414214; 5 arc X21.414214 G17 about 20 30 by -90;"
     " 5 line X30.828427 Y22; 6 line X40; 7 arc X41.414214 Y21.414214 G17 about 40 20 by -45;"
     " 7 line X50 Y12.828427; 8 line X58.585786 Y21.414214; 9 arc X60 Y22 G17 about 60 20 by -45;"
     " 9 line X80; ?10:0 comp-way 2/9; 10 line Y0"},
    {"G42.1 D4 F100\nG1 Y20\nX10\nX20 Y30\nX30 Y20\nX40\nX50 Y10\nX60 Y20\nX80\nG40 Y0\n",
     "2 line X2 Y18 F100; 3 line X10; 4 arc X11.414214 Y18.585786 G17 about 10 20 by 45;"
     " 4 line X20 Y27.171573; 5 line X28.585786 Y18.585786;"
     " 6 arc X30 Y18 G17 about 30 20 by 45; 6 line X39.171573; 7 line X48.585786 Y8.585786;"
     " 8 arc X51.414214 G17 about 50 10 by 90; 8 line X60.828427 Y18; 9 line X80; 10 line Y0"},
    {"G41.1 D4 F100\nG1 Y20\nX10\nG2 X14 Y24 I4\nG3 X20 Y30 J6\nG1 Y40\nG3 X14 Y40 I-3\n"
     "G1 Y60\nG40 X0\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y20 F100; 3 arc X0 Y22 G17 about 0 20 by -90;"
     " 3 line X8.343146; 4 arc X14 Y26 G17 about 14 20 by -70.5288;"
     " 5 arc X18 Y30 G17 about 14 30 by 90; 6 line Y40; 7 arc X16 G17 about 17 40 by 180;"
     " 8 arc X12 G17 about 14 40 by -180; 8 line Y60; 9 line X0"},
    {"G42.1 D4 F100\nG1 Y20\nX10\nG3 X14 Y24 J4\nG2 X20 Y30 I6\nG1 X40\nG2 X40 Y20 J-5\n"
     "G1 X30\nG40 Y0\n",
     "2 line X2 Y18 F100; 3 line X10; 4 arc X16 Y24 G17 about 10 24 by 90;"
     " 5 arc X20 Y28 G17 about 20 24 by -90; 6 line X40; 7 arc Y22 G17 about 40 25 by -180;"
     " 8 line X30; ?9:0 comp-way 2/8; 9 line Y0"},
    {"G41.1 D4 F100\nG0 Y20\nG0 X20\nG1 Y10\nG0 X40\nY30\nG1 X60\nG40 G0 Y0\n",
     "2 rapid X-2 Y20; 3 arc X0 Y22 G17 about 0 20 by -90 F6000; 3 rapid X20;"
     " 4 arc X22 Y20 G17 about 20 20 by -90 F100; 4 line Y12; 5 rapid X38; 6 rapid Y30;"
     " 7 arc X40 Y32 G17 about 40 30 by -90; 7 line X60; 8 rapid Y0"},
    {"G41.1 D4 F100\nG1 Y10\nX20\nG41.1 D4\nG42.1 D4\nG40\nG1 Y0\nG42.1 D4\nX40\nY20\nG40\n"
     "G0 X0 Y0\n",
     "!4:1 comp-on G 41.1/0; !5:1 comp-on G 42.1/0; ?2:0 comp-way 0.0388386486/3;"
     " 2 line X-2 Y10 F100; 3 arc X0 Y12 G17 about 0 10 by -90; 3 line X20; ?7:0 comp-way 2/3;"
     " 7 line Y0; ?9:0 comp-way 0.00992561958/10; 9 line X40 Y-2;"
     " 10 arc X42 Y0 G17 about 40 0 by 90; 10 line Y20; 12 rapid X0 Y0"},
    {"G41.1 D4 F100\nG1 X20\nY20\nX22\nY0\nG40 X40\n",
     "2 line X18 Y2 F100; 3 line Y20; 4 arc X20 Y22 G17 about 20 20 by -90; 4 line X22;"
     " 5 arc X24 Y20 G17 about 22 20 by -90; 5 line Y0; 6 line X40"},
    {"G42.1 D4 F100\nG1 X20\nY20\nX22\nY0\nX40\nG40 X60\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X20 Y-2 F100; !3:0 comp-gouge 2/5; 7 line X60 Y0"},
};

static void what_stands_between_contours_is_executed_there(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.compensates = 1;
    TOLD(check, &self, between_rows);
}

static const told_row_t nose_rows[] = {
    {"G18 G42 D7 F100\nG1 X10 Z-5\nZ-20\nX20 Z-30\nG40 X40\n",
     "2 line X11.157771 Z-5.084458 F100; 3 arc X11.6 Z-5.8 G18 about -5.8 10.8 by 63.4349;"
     " 3 line Z-20.468629; 4 line X21.365685 Z-30.234315; 5 line X40 Z-30"},
    {"G18 G41.1 D2 L1 F100\nG1 X10 Z5\nZ20\nG3 X20 Z30 I10\nG1 X30\nG40 X40\n",
     "2 line X9.447214 Z5.105573 F100; 3 arc X10 Z6 G18 about 6 9 by -63.4349; 3 line Z21;"
     " 4 arc X19 Z30 G18 about 21 19 by 90; 5 line X29; 6 line X40"},
    {"G18 G42.1 D2 L6 F100\nG1 X10 Z-5\nX20\nZ-20\nG40 X40\n",
     "2 line X9.236068 Z-4 F100; 3 line X19; 4 arc X20 Z-5 G18 about -5 19 by 90; 4 line Z-20;"
     " 5 line X40"},
};

static void a_nose_goes_beside_the_contour(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_tools(&self);
    told_lathe(&self);
    self.compensates = 1;
    TOLD(check, &self, nose_rows);
}

// Entered at line 5, at X30 Y40 Z5 of the tip, which is 1, 2 and 3 mm beside the machine's place.
static const told_row_t offset_rows[] = {
    {"G43.1 X1 Y2 Z3\nG0 X10 Y20 Z5\nG1 F100 Z-1\nX30 Y40 Z5\nX50\nG49\nX60\n",
     "5 rapid Z8 stop P0 Q0; 5 rapid X31 Y42; 5 line F100; 5 line X51 smooth P0.01 Q0.01;"
     " 7 line X60"},
    {"G43.1 X1 Y2 Z3\nG0 X10 Y20 Z5\nG1 F100 Z-1\nX30 Y40 Z5\nX50\nG49\nX60\n",
     "5 rapid Z20 stop P0 Q0; 5 rapid X31 Y42; 5 line Z8 F100; 5 line X51 smooth P0.01 Q0.01;"
     " 7 line X60"},
    {"G43.1 X1 Y2 Z3\nG0 X10 Y20 Z5\nG1 F100 Z-1\nX30 Y40 Z5\nX50\nG49\nX60\n",
     "5 line X51 Y42 Z8 F100; 7 line X60"},
    {"G43.1 X1 Y2 Z3\nG0 X10 Y20 Z5\nG1 F100 Z-1\nX30 Y40 Z5\nX50\nG49\nX60\n",
     "5 rapid X31 Y42 Z8 stop P0 Q0; 5 rapid; 5 line F100; 5 line X51 smooth P0.01 Q0.01;"
     " 7 line X60"},
    {"G43.1 X1 Y2 Z3\nG0 X10 Y20 Z5\nG1 F100 Z-1\nX30 Y40 Z5\nX50\nG49\nX60\n",
     "5 rapid Z30 stop P0 Q0; 5 rapid X31 Y42; 5 line Z8 F100; 5 line X51 smooth P0.01 Q0.01;"
     " 7 line X60"},
};

static void enter_at(check_t *check, double x, double y, double z, const told_row_t *row) {
    const double start[3] = {x, y, z};
    for (int k = 0; k < 3; k++) self.machine.start_nm[k] = (int64_t)(start[k] * 1e6);
    told_check(check, &self, row, 1);
}

static void a_way_in_goes_to_where_the_tool_would_be(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    self.machine.dialect.from_line = 5;
    self.machine.approach.height_nm = 7 * NCK_COUNTS_PER_MM;
    self.compensates = 1;
    enter_at(check, 0.0, 0.0, 0.0, &offset_rows[0]);
    enter_at(check, 0.0, 0.0, 20.0, &offset_rows[1]);
    enter_at(check, 31.0, 42.0, 8.0, &offset_rows[2]);
    enter_at(check, 31.0, 42.0, 5.0, &offset_rows[3]);
    self.machine.approach.height_nm = 30 * NCK_COUNTS_PER_MM;
    enter_at(check, 0.0, 0.0, 0.0, &offset_rows[4]);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, no_part_of_the_path_leaves_the_travel);
    CHECK_RUN(&check, narrow_contours_are_cut_left_out_or_refused);
    CHECK_RUN(&check, what_stands_between_contours_is_executed_there);
    CHECK_RUN(&check, a_nose_goes_beside_the_contour);
    CHECK_RUN(&check, a_way_in_goes_to_where_the_tool_would_be);
    return check_end(&check);
}
