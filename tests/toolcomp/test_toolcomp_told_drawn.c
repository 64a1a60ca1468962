// SPDX-License-Identifier: MIT
// Rooms 1 and 2: contours drawn at random. Of 12 000 these are left: each tells a change of the
// room that no row before it does.
#include "told_check.h"

static told_t self;

static const told_row_t drawn_rows[] = {
    {"G42.1 D6 F100\nG1 X10 Y-20\nG3 X30 Y-10 I10 J5\nG1 X20 Y-30\nY-30.5\nZ1\n",
     "?2:0 comp-way 0.0266408828/3; 2 line X7.316718 Y-21.341641 F100;"
     " !3:0 comp-gouge 1.68011897/5"},
    {"G42.1 D2 F100\nG1 X-10 Y-20\nX-20 Y-25\nG2 X-20 Y-25 I0 J-2 Z3\nG1 Y-20\nX-10\n"
     "G2 X-15 Y-20 R-10\nG1 Y-25\nG0 Y-30\nG2 X-15 Y-30 I-5 J0 P2\nG40 G1 X-10 Y-30\n",
     "2 line X-10.745356 Y-19.254644 F100; 3 line X-20.447214 Y-24.105573;"
     " !4:0 comp-gouge 0.835174625/7; 11 line X-10 Y-30 Z3"},
    {"G0 X10 Y0 Z5\nG42.1 D2 F100\nG1 X20 Y10\nS5\nG3 X20 Y20 I0 J5\nG1 X30 Y40\n"
     "G2 X20 Y20 I-5 J-10\nG1 X60 Y40\n",
     "1 rapid X10 Z5; 3 line X20.429614 Y9.0154 F100; 4 out S5;"
     " 5 arc X21.520151 Y20.804235 G17 about 20 15 by 161.2176; 6 line X30.425196 Y38.614324;"
     " !7:0 comp-gouge 0/8"},
    {"G0 X40 Y40\nG41.1 D10 F100\nG1 X60 Y20\nX70\nG2 X65 Y40 I-2.5 J10\nG2 X85 Y50 R-16.771\n"
     "G1 X65 Y70\nG2 X65 Y90 I0 J10\nG2 X85 Y95 R-41.231 Z-3\nG1 Z-3.001\nX65 Y40\n"
     "G40 X60 Y40\nG42.1 D4\nG1 X70\nY60\nG40 X90\n",
     "1 rapid X40 Y40; !3:0 comp-gouge G 5/5; 12 line X60 Z-3.001 F100;"
     " ?14:0 comp-way 0.0388386486/15; 14 line X70 Y38; 15 arc X72 Y40 G17 about 70 40 by 90;"
     " 15 line Y60; 16 line X90"},
    {"G42.1 D10 F100\nG1 Y10\nX1\nX0\nY0\nG3 X0 Y0 I-10 J0\nG1 X-10 Y-20\n"
     "G3 X0 Y-10 R-14.142\nG1 X10\nY-5\n",
     "?3:0 comp-left 0.0990195136/3; 2 line X5 Y7 F100; 4 arc X1 Y15 G17 about 1 10 by 126.8699;"
     " 4 line X0; 5 arc X-5 Y10 G17 about 0 10 by 90; 5 line Y0; !6:0 comp-gouge 0.126280266/8"},
    {"G0 Z-10 X10\nG18 G41.1 D6 F100\nG1 Z-5\nZ5 X7.5\nG0 Z5.5\nZ-5 X10\nG40 Z35 X10\n",
     "1 rapid X10 Z-10; ?3:0 comp-way 0.427521223/4; 3 line X13 Z-5 F100;"
     " 4 arc X12.910428 Z-4.272393 G18 about -5 10 by -14.0362; 4 line X10.5 Z5.369317;"
     " 5 rapid Z5.5; 6 rapid X4.581581 Z4.805138; 6 rapid X7.081581 Z-5.694862; 7 rapid X10 Z35"},
    {"G0 X10 Y40\nG42.1 D2 F100\nG3 X10 Y38.5 R1.125 Z3\nG1 X0\nY43.5\nG40 X0 Y43.5\n",
     "1 rapid X10 Y40; 3 arc X9.186062 Y39.5 Z3 G17 about 10.23292 38.70833 by 42.6802 F100;"
     " 4 line X1; 5 line Y43.5; 6 line"},
    {"G41.1 D4 F100\nG1 X15\nG2 X15 Y2 I0 J1\nG1 X-25\nX5\nY-18\nZ2\nG40 X45 Y-18\nG41.1 D4\n"
     "G1 X70\nY60\nG40 X90\n",
     "!2:0 comp-gouge G 2/4; 8 line X45 Y-18 Z2 F100; 10 line X68 Y-16; 11 line Y60;"
     " ?12:0 comp-way 2/11; 12 line X90"},
    {"G42.1 D4 F100\nG1 X-10 Y15\nG2 X-10 Y25 I0 J5\nG1 Y15\nG4 P1\nX0 Y20\nG40 X0 Y40\n",
     "?2:0 comp-way 0.335899411/4; 2 line X-8.335899 Y16.1094 F100; !3:0 comp-gouge 2/4;"
     " 7 line X0 Y40"},
    {"G41.1 D6 F100\nG1 Y-20\nG2 X2.5 Y-17.5 I1.25 J1.25 Z-1\nG3 X5 Y-12.5 R4.193\n"
     "G2 X5 Y-7.5 I0 J2.5\nG1 X0 Y-20\nY-15\nX10 Y-25\nG2 X9 Y-25 I-0.5 J0 P2\nG1 Y-30\n"
     "X-1 Y-25\n",
     "?2:0 comp-way 0.0331909414/3; 2 line X3 Y-20 F100;"
     " 3 arc X-2.12132 Y-22.12132 G17 about 0 -20 by -135; !3:0 comp-gouge 0.493986486/5"},
    {"G18 G41.1 D2 F100\nG3 Z0 X0 K-1.5 I0\nG1 Y2\n",
     "!2:0 comp-entry 1.5/1; 3 line Y2 F100"},
    {"G41.1 D6 F100\nG1 Y20\nX-1\nZ2\nY17\nG40 Z7\nX4 Y-3\n",
     "!2:0 comp-gouge 1/5; 6 line Z7 F100; 7 line X4 Y-3"},
    {"G42.1 D2 F100\nG1 X-10 Y10\nG3 X-11 Y11 I-0.5 J0.5 P2\nG1 X-9 Y9 Z-3\nX-13 Y8\n"
     "G3 X-13 Y9 I0 J0.5\nG1 X-12 Y5\nX-14 Y1\nS5\nG40 X-14 Y-19\n",
     "2 line X-8.814575 Y10.228788 F100;"
     " 3 arc X-12.092713 Y11.114394 G17 about -10.5 10.5 by 168.0472;"
     " 3 arc X-9.069065 Y9.569065 G17 about -10.5 10.5 by 168.0471;"
     " 3 arc X-11.707107 Y11.707107 G17 about -10.5 10.5 by 168.0471;"
     " 4 arc Y10.292893 G17 about -11 11 by 90; 4 line X-10.955992 Y9.541778 Z-3;"
     " 5 line X-13.242536 Y8.970143; !6:0 comp-gouge 0.755633473/7; 10 line X-14 Y-19"},
    {"G0 Y0 Z0\nG19 G41.1 D2 F100\nG1 Y-20 Z20\nY-19\nZ21\nY-29\nG0 Z22\nG1 Z17\n"
     "G40 G0 Y-29 Z17\n",
     "1 rapid; 3 line Y-20.707107 Z19.292893 F100; !6:0 comp-gouge 1/4; 9 rapid"},
    {"G42.1 D2 F100\nG1 X-10 Y-20\nS5\nM8\nY-21 Z1\nX-15 Y-1\nY-6\nX5 Y14\nG4 P1\n"
     "G40 G0 X-15 Y19\n",
     "?5:0 comp-left 2.53484014/5; 2 line X-9.85216 Y-17.468253 F100; 3 out S5; 4 out M8;"
     " 6 line X-14.029857 Y-0.757464 Z1; 7 arc X-16 Y-1 G17 about -15 -1 by 165.9637; 7 line Y-6;"
     " 8 arc X-14.292893 Y-6.707107 G17 about -15 -6 by 135; 8 line X5.707107 Y13.292893;"
     " 9 dwell for 1; 10 rapid X-15 Y19"},
    {"G42.1 D4 F100\nG1 X10 Y15\nY14.5 Z3\nX20\nG0 X40\nZ0\nG1 X41\nX31 Y-5.5\n"
     "G3 X41 Y-5.5 I5 J0\nG0 X21 Y-0.5\nG2 X26 Y-20.5 R41.231\nG40 G1 X6 Y-40.5\n",
     "?3:0 comp-left 0.606380515/3; 2 line X10.737034 Y12.5 F100; 4 line X20 Z3;"
     " ?7:0 comp-left 1.80422607/7; 5 rapid X37.763932; 6 rapid Z0; 8 line X29.211146 Y-4.605573;"
     " 9 arc X29 Y-5.5 G17 about 31 -5.5 by 26.5651; 9 arc X43 G17 about 36 -5.5 by 180;"
     " 10 arc X41.485071 Y-3.559715 G17 about 41 -5.5 by 75.9638 F6000;"
     " 10 rapid X21.485071 Y1.440285;"
     " 11 arc X19.242595 Y-1.45474 G17 about 21 -0.5 by 132.55 F100;"
     " 11 arc X24.000059 Y-20.484596 G17 about -15.22978 -20.18244 by -28.9551; 12 line X6 Y-40.5"},
    {"G19 G41.1 D4 F100\nG1 Y-10 Z15\nY-20\nY-10\nY30 Z35\nY-10 Z15\n",
     "2 line Y-11.070368 Z13 F100; 3 line Y-20; 4 arc Z17 G19 about -20 15 by -180;"
     " 4 line Y-10.472136; 5 line Y29.105573 Z36.788854;"
     " 6 arc Y30.894427 Z33.211146 G19 about 30 35 by -180; 6 line Y-9.105573 Z13.211146"},
    {"G0 X-10 Y0 Z5\nG42.1 D4 F100\nG1 X0\nG4 P1\nY-8\nY0\nG2 X2 Y4 I1 J2 P2\n"
     "G3 X6 Y8 R-2.885\nG2 X8 Y0 R-6.185\nG1 X12\nX10\nG40 X15 Y5\nX0 Y33\n",
     "1 rapid X-10 Z5; 3 line X-2 Y-2 F100; 4 dwell for 1; 5 line Y-8;"
     " 6 arc X2 G17 about 0 -8 by 180; 6 line Y0;"
     " 7 arc X0.894427 Y1.788854 G17 about 0 0 by 63.4349; !7:0 comp-gouge 0.160803812/8;"
     " 12 line X15 Y5; 13 line X0 Y33"},
    {"G0 Z40 X10\nG18 G42.1 D2 F100\nG1 Z20\nM8\nX8\nZ19\nM8\nG3 Z19 X9 K0 I0.5\nG1 Z20\n"
     "G0 Z18 X8.5\nG2 Z20 X6.5 K1 I-1\nG40 G1 Y5\nZ20 X26.5\n",
     "1 rapid X10 Z40; ?3:0 comp-way 0.00124766112/5; 3 line X11 Z20 F100; 4 out M8;"
     " 5 arc X10 Z19 G18 about 20 10 by 90; ?6:0 comp-left 0.414213562/6; 5 line X9; 7 out M8;"
     " 8 arc X7 G18 about 19 8 by 180; 8 arc X10 G18 about 19 8.5 by 180;"
     " 9 arc X8 G18 about 19 9 by 180; 9 line Z20; 10 rapid X9.970143 Z19.757464;"
     " 10 rapid X9.470143 Z17.757464; 11 line X7.792893 Z18.707107;"
     " 11 arc X7.207107 Z19.292893 G18 about 19 7.5 by -180; 12 line Y5; !13:0 comp-gouge G 1/11"},
    {"G0 Y20 Z40\nG19 G42.1 D6 F100\nG1 Y10 Z50\nY11\nG3 Y11 Z49.5 J0 K-0.25\n"
     "G3 Y-19 Z49.5 J-15 K0\nG1 X1\n",
     "1 rapid Y20 Z40; ?4:0 comp-left 0.16227766/4; 3 line Y13.989282 Z50.253358 F100;"
     " !5:0 comp-gouge 2.5970782/6"},
    {"G41.1 D4 F100\nG1 X-10 Y15\nY-15\nX-9 Y-19\nX-8\nG2 X-8 Y-19 I10 J0\nG1 X-10 Y-15\n"
     "X-12 Y-11\nG0 Y19\n",
     "2 line X-8 Y8.394449 F100; 3 line Y-14.753789; !5:0 comp-gouge 1.9440983/7"},
    {"G0 X10 Y10 Z5\nG41.1 D6 F100\nS5\nG3 X20 Y15 R22.361 Z2\nG4 P1\nG1 X30\nX20\n"
     "G3 X0 Y15 R-12\nG1 Y10\nX3\n",
     "1 rapid X10 Y10 Z5; !4:0 comp-entry 22.361/3; 5 dwell X20 Y15 Z2 for 1; 6 line X30 F100;"
     " 7 line X20; 8 arc X0 G17 about 10 21.63325 by 247.1146; 9 line Y10; 10 line X3"},
    {"G0 Z-10 X-10\nG18 G41.1 D6 F100\nG1 Z-30\nG2 Z-30 X-11 R0.75\nG1 X-10\nZ-50 X30\n"
     "Z-30 X-10\nG2 Z-40 X-50 R-41.231\nG1 X-80\nZ-30 X-10\nZ-40\nX-30\nG40 Z-35 X-30\n",
     "1 rapid X-10 Z-10; ?4:0 comp-left 0.16227766/4; 3 line X-13 Z-27.763932 F100;"
     " 5 arc X-11 Z-33 G18 about -30 -11 by -138.1897; 5 line X-10.708204;"
     " 6 line X28.658359 Z-52.683282; 7 arc X31.341641 Z-47.316718 G18 about -50 30 by -180;"
     " 7 line X-5.055323 Z-29.118237;"
     " 8 arc X-44.578051 Z43.474284 G18 about -0.35905 -38.66024 by -138.2459;"
     " 8 arc X-63.435668 Z-37 G18 about -0.35905 -38.66024 by -138.2459;"
     " !9:0 comp-gouge 0.030151519/10; 13 line X-30 Z-35"},
    {"G18 G42.1 D10 F100\nG1 Z-10\nZ0 X-5\nX-10.5\nG4 P1\nM8\nG3 Z0 X-20.5 R7.5\nG1 Y1\n"
     "Z-10 X0\n",
     "!2:0 comp-gouge G 0.527864045/3"},
    {"G19 G41.1 D10 F100\nG2 Y0 Z-10 R5.1\nG1 Y-10 Z30\nG2 Y-15 Z30 R2.55\n"
     "G2 Y25 Z50 J20 K10 P2\nG1 Z60\nY-15 Z70\nX-1\n",
     "!2:0 comp-gouge G 2.57464375/3"},
    {"G0 X20 Y10\nG41.1 D2 F100\nG1 X0\nG2 X0 Y12.5 R-5 Z3\nG1 Z0\nX-1 Z-1\nY11.5\nX-6 Y14\n"
     "X-8.5\n",
     "1 rapid X20 Y10; 3 line X0.72092 Y9 F100;"
     " 4 arc X-10.828222 Y11.644864 Z1.5 G17 about -4.84123 11.25 by -161.7491;"
     " 4 arc X0.968246 Y12.75 Z3 G17 about -4.84123 11.25 by -161.7491; 5 line Z0;"
     " ?6:0 comp-left 0.414213562/7; 6 arc X0 Y11.5 G17 about 0 12.5 by -104.4775;"
     " !8:0 comp-gouge 0.197224362/4"},
    {"G0 X0 Y-10\nG41.1 D2 F100\nG1 Y10\nS5\nX-0.5\nX-1 Y9.5\nG0 X-2 Y11.5\n",
     "1 rapid Y-10; !3:0 comp-gouge 0.646446609/6"},
    {"G0 X0 Y0\nG42.1 D2 F100\nG0 Y-2.5\nG4 P1\nG1 Y-1\nG3 X10 Y-1 I5 J0\nG1 Y9\nZ-0.001\n"
     "G4 P1\nG40 X50 Y29\n",
     "1 rapid; 3 rapid X-1 Y-2.5; 4 dwell for 1; 5 arc X1 G17 about 0 -2.5 by 180 F100;"
     " !5:0 comp-gouge 0.272001873/6; 10 line X50 Y29 Z-0.001"},
    {"G41.1 D4 F100\nG1 X20 Y15\nG0 X18\nG1 X8 Z-3\nZ-2.999\nY12.5\nX18 Y22.5\nY2.5\n"
     "G40 X13 Y2.5\n",
     "2 line X18.8 Y16.6 F100; 3 rapid X20 Y13; 3 rapid X18; 4 line X10 Z-3; 5 line Z-2.999;"
     " !6:0 comp-gouge 0.585786438/7; 9 line X13 Y2.5"},
    {"G0 X10 Y40\nG42.1 D4 F100\nG1 X-10 Y20\nG3 X-10 Y20 I0 J-2.5\nG3 X-15 Y25 R3.606\n"
     "G1 X-12.5 Y15\nX-7.5\n",
     "1 rapid X10 Y40; 3 line X-10.924396 Y21.904031 F100; !4:0 comp-gouge 1.67799506/6"},
    {"G42.1 D2 F100\nG1 Y15\nX-40 Y55\nG0 X-39\nS5\nG1 X0 Y15\nG3 X20 Y35 I10 J10 P2\n"
     "G1 X30 Y75\nX70 Y65 Z3\nY66.5 Z6\nG40 X50 Y66.5\nX50 Y33\n",
     "?2:0 comp-way 0.00221484214/3; 2 line X1 Y15 F100;"
     " 3 arc X0.707107 Y15.707107 G17 about 0 15 by 45; 3 line X-39.292893 Y55.707107;"
     " 4 rapid X-40 Y54; 4 rapid X-39.421648; 5 out S5; !6:0 comp-gouge 7.48156708e-05/7;"
     " 11 line X50 Y66.5 Z6; 12 line Y33"},
};

static const told_row_t drawn_a_rows[] = {
    {"G42.1 D4 F100\nG1 X-20 Y20\nX-15 Y30 Z3\nG3 X-15 Y25 R5\nG3 X-15 Y20 R3\nG1 X-20 Y30\n"
     "Y60 Z2\nG40 X20 Y40\n",
     "2 line X-18.211146 Y19.105573 F100; !3:0 comp-gouge 2/4; 8 line X20 Y40 Z2"},
    {"G0 X40 Y40\nG41.1 D10 F100\nG1 X50 Y60\nG2 X30 Y60 R20 Z3\nG1 X10\nY55\nX15\nX10\n"
     "G40 G0 X30 Y55\n",
     "1 rapid X40 Y40; 3 line X52.5 Y55.669873 F100;"
     " 4 arc X28.739675 Y55 Z3 G17 about 40 77.32051 by -56.7702; !5:0 comp-gouge 5/7;"
     " 9 rapid X30"},
    {"G0 X-10 Y-10\nG41.1 D10 F100\nG1 Y0\nY5\nY35 Z1\nG40 X10 Y40\n",
     "1 rapid X-10 Y-10; ?3:0 comp-way 0.527864045/4; 3 line X-15 Y0 F100; 4 line Y5;"
     " 5 line Y35 Z1; ?6:0 comp-way 4.01941932/5; 6 line X10 Y40"},
    {"G42.1 D10 F100\nG1 X-10\nG3 X-20 Y10 R-14.142\nG1 X-25 Y0\nG2 X-25 Y0 I20 J0\n"
     "G3 X-20 Y5 I2.5 J2.5 P2\nG1 Y10\nX-30 Y20\nG40 X10 Y40\n",
     "!2:0 comp-gouge G 4.08931667/3; 9 line X10 Y40 F100"},
    {"G42.1 D2 F100\nG1 X15\nG0 Y2.5\nZ-1\nG2 X15 Y2.5 I-1.5 J0\nG1 X14\nY3\nX13\nG0 X12\n"
     "G1 Y4\nY9\n",
     "2 line X16 F100; 3 rapid Y2.5; 4 rapid Z-1; 5 arc X14 G17 about 15 2.5 by 180;"
     " !7:0 comp-gouge 0.999674514/5"},
    {"G0 X40 Y10 Z5\nG42.1 D4 F100\nG1 Y30\nX60\nG0 Y35\nG1 X65 Y15\nM8\nX75\nZ2\nX40 Y30\n"
     "G40 Z7\nX40 Y37\n",
     "1 rapid X40 Y10 Z5; 3 line Y28 F100; 4 line X60; 5 arc X62 Y30 G17 about 60 30 by 90 F6000;"
     " 5 rapid Y35; 6 line X58.059715 Y34.514929 F100; 6 line X63.059715 Y14.514929; 7 out M8;"
     " 8 arc X65 Y13 G17 about 65 15 by 75.9638; 8 line X75; 9 line Z2;"
     " 10 arc X75.787839 Y16.83829 G17 about 75 15 by 156.8014; !10:0 comp-gouge 2/4; 11 line Z7;"
     " 12 line X40 Y37"},
};

static const told_row_t drawn_b_rows[] = {
    {"G42.1 D4 F100\nG1 X20 Y20\nG0 Y10\nG3 X22 Y10 R2\nG3 X22 Y10 I-10 J0 P2\nG1 Z-1\n"
     "G3 X23 Y10 I0.5 J0\nG3 X23 Y12.5 R1.875\nG1 Y-7.5\nX43\n",
     "2 line X18 Y20 F100; 3 rapid Y10; 4 arc X19 Y8.267949 G17 about 20 10 by 60;"
     " 4 arc X23 G17 about 21 11.73205 by 60; 5 arc X24 Y10 G17 about 22 10 by 60;"
     " 5 arc X2.291796 Y17.053423 G17 about 12 10 by 144;"
     " 5 arc X15.708204 Y-1.412678 G17 about 12 10 by 144;"
     " 5 arc Y21.412678 G17 about 12 10 by 144; 5 arc X2.291796 Y2.946577 G17 about 12 10 by 144;"
     " 5 arc X24 Y10 G17 about 12 10 by 144; 6 line Z-1; 7 arc X20 G17 about 22 10 by 180;"
     " 7 arc X24.840608 Y9.121619 G17 about 22.5 10 by 159.4299;"
     " 8 arc X24.490712 Y13.833333 G17 about 21.60246 11.25 by 75.1265;"
     " 9 arc X21 Y12.5 G17 about 23 12.5 by 138.1897; 9 line Y-7.5;"
     " 10 arc X23 Y-9.5 G17 about 23 -7.5 by 90; 10 line X43"},
    {"G0 X10 Y0\nG41.1 D6 F100\nG1 X0 Y-20\nM8\nX-5 Y-40 Z-1\nZ-2\nY-30\nG3 X-5 Y-50 I0 J-10\n",
     "1 rapid X10; 3 line X2.910428 Y-20.727607 F100; 4 out M8;"
     " 5 line X-2.089572 Y-40.727607 Z-1; 6 line Z-2;"
     " 7 arc X-8 Y-40 G17 about -5 -40 by -165.9638; 7 line Y-33.675445;"
     " 8 arc X-5 Y-47 G17 about -5 -40 by 154.6231"},
    {"G0 Y0 Z40\nG19 G41.1 D4 F100\nG1 Y20 Z50\nY20.5\nG3 Y20.5 Z50 J-5 K0\nM8\n"
     "G40 G1 Y20.5 Z55\n",
     "1 rapid Z40; !3:0 comp-gouge G 2/5; 7 line Y20.5 Z55 F100"},
    {"G0 X20 Y0\nG41.1 D2 F100\nG1 X30 Y20\nX20 Y60\nX10\nZ2\nY58.5\nX11.5\nX31.5 Y98.5 Z3\n"
     "G40 G0 X36.5 Y98.5\nX50 Y0\n",
     "1 rapid X20; 3 line X29.029857 Y19.757464 F100; 4 line X19.219224 Y59; !5:0 comp-gouge 1/9;"
     " 10 rapid X30.605573 Y98.947214 F6000;"
     " 10 arc X31.5 Y99.5 G17 about 31.5 98.5 by -63.4349 F6000; 10 rapid X36.5 Y98.5 Z3;"
     " 11 rapid X50 Y0"},
    {"G0 X10 Y10\nG41.1 D4 F100\nG1 Y8\nM8\nX12\nX16 Z1\nG2 X16 Y8 I-4 J0\nG40 G1 X16 Y28\n"
     "X50 Y33\n",
     "1 rapid X10 Y10; !3:0 comp-gouge G 0.828427125/7; 8 line X18 Y8 F100;"
     " 8 arc X14 G17 about 16 8 by -180; 8 line X16 Y28 Z1; 9 line X50 Y33"},
    {"G42.1 D6 F100\nG3 X0.5 Y0 R-0.3 Z-1\nG1 X20.5 Y-10\nY-10.5\nG40 G0 X15.5 Y-5.5\n"
     "X50 Y33\n",
     "!2:0 comp-entry G 0.3/3; 3 line X20.5 Y-10 Z-1 F100; 4 line Y-10.5; 5 rapid X15.5 Y-5.5;"
     " 6 rapid X50 Y33"},
    {"G41.1 D10 F100 G93\nG1 X-10 F2\nG2 X-10 Y-0.5 R0.255 Z-1 F3\nG1 Z-1.001 F2\n"
     "G2 X0 Y-5.5 R8.385 F2\nG0 X-2.5 Y-15.5 F3\nG1 Y-21 F3\nG2 X2.5 Y-21 R5 F3\n"
     "G2 X0 Y-18.5 R1.803 F2\nG40 G0 X5 Y-13.5 F2\n",
     "?2:0 comp-way 0.223073362/3; 2 line X-9.014718 Y4.901961 F2 inverse;"
     " !3:0 comp-gouge 4.52207564/5; 10 rapid X-4.161974 Y-15.729084 F6000 per-min;"
     " 10 arc X-3.535534 Y-14.964466 G17 about 0 -18.5 by -11.3455 F6000;"
     " 10 rapid X5 Y-13.5 Z-1.001 inverse"},
    {"G42.1 D2 F100\nG1 X-20 Y-20\nG2 X-20 Y-18 R1.02\nG1 X-20.5\nG3 X-20.5 Y-17 R-0.75\n"
     "G1 X-22\nG40 G0 X-42 Y3\n",
     "!2:0 comp-gouge G 0.558397368/5; 7 rapid X-42 Y3"},
    {"G0 Y0 Z10\nG19 G41.1 D10 F100\nG1 Y10 Z25\nY5\nX1\nZ20\nG2 Y5 Z50 J0 K15\n"
     "G40 G1 Y-15 Z50\n",
     "1 rapid Z10; !3:0 comp-gouge 0/4; 8 line Y5 Z55 F100; 8 arc Z45 G19 about 5 50 by -180;"
     " 8 line X1 Y-15 Z50"},
    {"G41.1 D2 F100\nG1 X10 Y-20\nG3 X10 Y-10 R6 Z-1\nG3 X10 Y-20 R5.1\n",
     "2 line X9.447229 Y-19.166667 F100;"
     " 3 arc X9.791744 Y-11.083619 Z-1 G17 about 6.68338 -15 by 108.0042;"
     " !4:0 comp-gouge 0.291933551/3"},
    {"G0 Y10 Z0\nG19 G42.1 D6 F100\nG1 Y25\nY37 Z12\nY43\nY31 Z9\nZ12\nZ0\nG4 P1\nY28\n"
     "G3 Y31.5 Z0 J1.75 K0\nG40 G1 X3\nY36.5 Z7\n",
     "1 rapid Y10; ?3:0 comp-way 0.0582579729/4; 3 line Y25 Z-3 F100;"
     " 4 arc Y27.12132 Z-2.12132 G19 about 25 0 by 45; 4 line Y38.242641 Z9;"
     " !5:0 comp-gouge 0.0895724996/6; 12 line X3; 13 line Y36.5 Z7"},
    {"G0 X0 Y40\nG42.1 D4 F100\nG1 X10 Y50\nG2 X10 Y48 I0 J-1\nG3 X8 Y52 R2.281\nG1 Y56\n",
     "1 rapid Y40; !4:0 comp-radius 2/1; !5:0 comp-exit; 6 line X8 Y56 F100"},
    {"G0 X10 Y-10\nG41.1 D6 F100 G93\nG1 X-10 Y0 F3\nX-50 Y-10 F3\nZ1 F1\nG2 X-53 Y-10 R6 F3\n",
     "1 rapid X10 Y-10; 3 line X-9.272393 Y-2.910428 F3 inverse; 4 line X-49.262318 Y-12.907909;"
     " 5 line Z1 F1; 6 arc X-53.75 Y-12.904738 G17 about -51.5 -4.19052 by -28.874 F3"},
    {"G42.1 D10 F100\nG1 Y15\nG3 X0 Y45 I0 J15\nG1 X-2.5 Y42.5\nG40 Z3\nX17.5 Y22.5\n",
     "2 line Y10 F100; 3 arc Y50 G17 about 0 30 by 180;"
     " 4 arc X-3.535534 Y48.535534 G17 about 0 45 by 45; 4 line X-6.035534 Y46.035534; 5 line Z3;"
     " 6 arc Y38.964466 G17 about -2.5 42.5 by 90; 6 line X17.5 Y22.5"},
};

static const told_row_t bound_rows[] = {
    {"G42.1 D6 F100\nG1 Y10\nX-0.5\nG2 X-20.5 Y0 I-10 J-5\nG3 X-0.5 Y40 R22.808\nG1 X-3.5\n"
     "G2 X-3.5 Y40 I6 J0\nG40 G1 X-3.5 Y45\n",
     "!4:4 travel X -20.5/-10; ?2:0 comp-way 0.0217362923/3; ?3:0 comp-left 0.521016125/3;"
     " 2 line X3 Y9.615872 F100; !5:0 comp-gouge 0/6; 8 line X-3.5 Y45"},
    {"G0 X40 Y40 Z5\nG41.1 D10 F100\nG3 X40 Y50 R-10\nG1 X45\nG3 X45 Y50 I0 J5.5\n",
     "1 rapid X40 Y40 Z5; !3:0 comp-gouge 2.99553544/5"},
    {"G18 G41.1 D10 F100\nG2 Z-20 X0 R40\nG1 Z-25\nZ-20\nG2 Z-20 X5 K0 I2.5\nG1 Z-25 X0\n"
     "G40 G0 Z-20 X5\n",
     "2 arc X-5 Z-20.597059 G18 about -15.3125 18.15461 by -53.0023 F100; 3 line Z-25;"
     " 4 arc X5 G18 about -25 0 by -180; 4 line Z-20; !5:0 comp-gouge 5/6; 7 rapid"},
    {"G41.1 D2 F100\nG1 X-10\nX0 Y20\nG0 Y19\nG3 X0 Y19 I-4 J0 Z3\nG40 G0 X0 Y39\n",
     "?2:0 comp-way 0.00496280979/3; 2 line X-10 Y-1 F100; !3:0 travel X -11.000001/-10;"
     " 6 rapid X0 Y39 Z3"},
    {"G0 X20 Y0\nG42.1 D4 F100\nG1 X10 Y-20\nX40\nX36\nG40 X56 Y-15\nX50 Y0\n",
     "1 rapid X20; ?3:0 comp-way 0.00795231778/4; 3 line X8.211146 Y-19.105573 F100;"
     " !4:0 travel Y -22/-20; 6 line X56 Y-15; 7 line X50 Y0"},
    {"G0 X40 Y-10\nG41.1 D4 F100\nG1 X60 Y5\nX61\nX60 Y7\nX61\nY9\nY5\nX62\nX61 Z1\n",
     "1 rapid X40 Y-10; !3:0 comp-gouge G 0.735088936/5"},
    {"G42.1 D6 F100 G93\nG1 X-10 Y10 F3\nY-10 F2\nX0 F3\nG40 G0 X20 Y-10 F1\n",
     "?2:0 comp-way 0.0653040717/3; 2 line X-7.87868 Y12.12132 F3 inverse; !3:0 travel X -13/-10;"
     " 5 rapid X20 Y-10"},
    {"G41.1 D2 F100\nG1 X20 Y-20\nG3 X20 Y0 R20\nG1 X60 Y-10\nY30\nG40 Z3\nX60 Y10\nX0 Y33\n",
     "2 line X19.752212 Y-18.337999 F100; 3 arc X19.133975 Y-0.5 G17 about 2.67949 -10 by 56.03;"
     " 4 arc X20.242536 Y0.970143 G17 about 20 0 by -134.0363; 4 line X59 Y-8.719224; 5 line Y30;"
     " 6 line Z3; 7 line X60 Y10; 8 line X0 Y33"},
    {"G42.1 D4 F100\nG1 Y-20\nX20 Y0\nX40\nX30 Y40\nX40\nG0 X70\nM8\nG2 X30 Y40 R20.4\n"
     "G40 G1 X35 Y20\n",
     "?2:0 comp-way 0.00992561958/3; 2 line X-2 Y-20 F100; !3:0 travel Y -22.000001/-20;"
     " 10 line X35 Y20"},
    {"G0 X0 Y10\nG41.1 D2 F100\nG1 X-10 Y-10\nS5\nX-9 Y-12 Z-1\nZ1\nX-10 Y-10\nX-11 Y-9.5\n"
     "X-10 Y-11.5\nG0 Y-12.5\nG40 X-5 Y-7.5\nG41.1 D2\nG1 X70\nY60\nG40 X90\n",
     "1 rapid Y10; !8:1 travel X -11/-10; 3 line X-8.881966 Y-10 F100; 4 out S5;"
     " 5 line X-8.105573 Y-11.552786 Z-1; 6 line Z1;"
     " 7 arc X-9.894427 Y-12.447214 G17 about -9 -12 by -180; !10:0 comp-gouge 0.97204915/7;"
     " 11 rapid X-5 Y-7.5; 13 line X69 Y-6.5; 14 line Y60; ?15:0 comp-way 1/14; 15 line X90"},
};

// X, Y and Z may go 200 mm either way.
static void widen(void) {
    for (int k = 0; k < 3; k++) {
        self.machine.axis[k].min_nm = -200 * (int64_t)NCK_COUNTS_PER_MM;
        self.machine.axis[k].max_nm = 200 * (int64_t)NCK_COUNTS_PER_MM;
    }
}

static void contours_at_random_are_cut_or_refused(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    widen();
    self.compensates = 1;
    TOLD(check, &self, drawn_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_A;
    TOLD(check, &self, drawn_a_rows);
    self.machine.dialect.comp_start = NCK_COMP_START_B;
    TOLD(check, &self, drawn_b_rows);
}

static void contours_at_random_stay_within_the_travel(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_bound(&self);
    self.compensates = 1;
    TOLD(check, &self, bound_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, contours_at_random_are_cut_or_refused);
    CHECK_RUN(&check, contours_at_random_stay_within_the_travel);
    return check_end(&check);
}
