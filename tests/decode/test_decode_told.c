// SPDX-License-Identifier: MIT
// Room 1: lines and all that they are told to do: modes, offsets, places, and every mistake.
#include "told_check.h"

static told_t self;

static const told_row_t plain_rows[] = {
    {"G20 G0 X1 Y-2.5 Z.001\nG1 F10 X0 Y0\nG21 X1 F20\n",
     "1 rapid X25.4 Y-63.5 Z0.0254; 2 line X0 Y0 F254; ?3:0 feed-units; 3 line X1 F508"},
    {"G91 G0 X1 Y1\nX1 Z-2\nG90 X1\n",
     "1 rapid X1 Y1; 2 rapid X2 Z-2; 3 rapid X1"},
    {"G1 X1 F100\nF200\nX2\nX3 F300\nG0 X4\nG1 X5\n",
     "1 line X1 F100; 3 line X2 F200; 4 line X3 F300; 5 rapid X4; 6 line X5"},
    {"G1 F100\nX1\nG93 F2 X2\nX3 F4\nG94 X4 F50\nG95 S100 M3 F.5 X5\n",
     "2 line X1 F100; 3 line X2 F2 inverse; 4 line X3 F4; 5 line X4 F50 per-min;"
     " 6 out S100 per-rev; 6 out M3 S100; 6 line X5 F0.5"},
    {"G93 G20 G1 X1 F3\nG94 X2 F3\n",
     "1 line X25.4 F3 inverse; 2 line X50.8 F76.2 per-min"},
    {"G95 F.5 M4 S200 G1 X1\nM5 X2\n",
     "1 out S200 per-rev; 1 out M4 S200; 1 line X1 F0.5; 2 out M5 S0; !2:0 feed-missing S"},
    {"G0 X1 F1e6\n",
     "!1:9 word-unknown E"},
    {"G1 X1 F1000000\nX2 F1000001\nX3\n",
     "1 line X1 F1000000; 2 line X2 F1000001; 3 line X3"},
    {"G1 F.00006 X1\nF.00005 X2\n",
     "1 line X1 F6e-05; !2:1 number-range F 5e-05/6e-05"},
    {"G20 G1 F39370 X1\nF39371 X2\n",
     "?1:0 feed-units; 1 line X25.4 F39370; 2 line X50.8 F1000023.4"},
    {"G95 G1 M3 S10 F.00001 X1\n",
     "1 out S10 per-rev; 1 out M3 S10; 1 line X1 F1e-05"},
    {"G4 P0\nG4 P1000000\nG4 P1000000.5\n",
     "1 dwell for 0; 2 dwell for 1000000; !3:4 number-range P 1000000.5/1000000"},
    {"G4 X1\n",
     "!1:4 no-motion X"},
    {"S100\nS100 M3\nS0\nS100.5\nM4\nM5\n",
     "1 out S100; 2 out M3 S100; 3 out S0 S0; 4 out S100.5 S100.5; 5 out M4; 6 out M5 S0"},
    {"M3 M8 M7\nM9\nM48\nM49\nM0\nM1\nM60\n",
     "1 out M3; 1 out M7; 1 out M8; 2 out M9; 3 out M48; 4 out M49; 5 wait M0; 6 out M1;"
     " 7 wait M60"},
    {"T5\nT5 M6\nT0\nT3 M6 G0 X1\n",
     "1 out T5; 2 out T5; 2 out M5; 2 wait M6; 3 out T0; 4 out T3; 4 out M5; 4 wait M6;"
     " 4 rapid X1"},
    {"G96 S100 M3\nG96 S100 D2000 M3\nG97 S500\n",
     "!1:1 speed-limit D 96/0; 2 out surface 100000; 2 out M3 S2000 V100000; 3 out S500 S500 V0"},
    {"G61 G0 X1\nG61.1 X2\nG64 X3\nG64 P.5 X4\nG64 P.5 Q.25 X5\nG20 G64 P.1 Q.2 X6\nG64 Q1 X7\n"
     "G61 X8\nG64 P0 X9\n",
     "1 rapid X1 exact P0 Q0; 2 rapid X2 stop; 3 rapid X3 smooth P0.01 Q0.01;"
     " 4 rapid X4 P0.5 Q0.5; 5 rapid X5 Q0.25; 6 rapid X152.4 P2.54 Q5.08;"
     " 7 rapid X177.8 P0.01 Q25.4; 8 rapid X203.2 exact P0 Q0; ?9:5 no-tolerance P;"
     " 9 rapid X228.6 smooth"},
    {"G64 P-1\nG64 P1 Q-1\nG64 P1000001\nG64 P1 Q1000001\nG64 P1000000 Q1000000 G0 X1\n",
     "!1:5 number-range P -1/1000000; !2:8 number-range Q -1/1000000;"
     " !3:5 number-range P 1000001/1000000; !4:8 number-range Q 1000001/1000000;"
     " 5 rapid X1 P1000000 Q1000000"},
    {"G9 G1 X1 F10\n",
     "1 line X1 F10 stop"},
    {"G61 G0 X1\nG9 X2\nX3\n",
     "1 rapid X1 exact P0 Q0; 2 rapid X2 stop; 3 rapid X3 exact"},
    {"G52 X1 Y2\nG0 X1 Y1 Z1\nG52 X0\nX1 Y1\nG92.1\nX1 Y1\n",
     "2 rapid X2 Y3 Z1; 4 rapid X1; 6 rapid Y1"},
    {"G54 G0 X1\nG10 L2 P1 X10 Y20 Z30\nX1 Y1\nG10 L2 P2 X100\nG55 X1\nG59.3 X2\nG10 L2 P0 Z7\n"
     "G54 Z1\nG59.3 Z1\nG10 L2 P9 X5\nX1\n",
     "1 rapid X1; 3 rapid X11 Y21; 5 rapid X101; 6 rapid X2; 8 rapid Z31; 9 rapid Z8;"
     " 11 rapid X6"},
    {"G0 X5 Y5\nG10 L20 P1 X1\nX2\nG10 L20 P2 X1 Y1\nG55 X0 Y0\nG10 L20 P0 X9\nX9\n",
     "1 rapid X5 Y5; 3 rapid X6; 5 rapid X5 Y4; 7 rapid"},
    {"G0 X5\nG92 X1 Z3\nX2 Z0\nG92.2\nX2 Z1\nG92.3\nX2 Z1\nG92 X0\nX1\nG92.1\nX1\nG92.3\nX3\n",
     "1 rapid X5; 3 rapid X6 Z-3; 5 rapid X2 Z1; 7 rapid X6 Z-2; 9 rapid X7; 11 rapid X1;"
     " 13 rapid X3"},
    {"G0 X1 Y2 Z3\nG28\nG28 X5\nX1 Y1\nG28.1\nX9\nG28 Z4\nG30 Z1\nG30.1\nX0 Z0\nG30\n",
     "1 rapid X1 Y2 Z3; 2 rapid; 2 rapid X0 Y0 Z0; 3 rapid X5; 3 rapid X0; 4 rapid X1 Y1;"
     " 6 rapid X9; 7 rapid Z4; 7 rapid Z0; 8 rapid Z1; 8 rapid Z0; 10 rapid X0; 11 rapid;"
     " 11 rapid X9"},
    {"G53 G0 X1\nG10 L2 P1 X10\nG53 X1\nX1\nG53 G1 X2 F10\nG53 X2\n",
     "1 rapid X1; 3 rapid; 4 rapid X11; 5 line X2 F10; 6 line"},
    {"G20 G10 L2 P1 X1\nG0 X1\nG21 G52 X1\nX1\nG20 G92 Y1\nY2\nG91 G28 Z1\n",
     "2 rapid X50.8; 4 rapid X27.4; 6 rapid Y25.4; 7 rapid Z25.4; 7 rapid Z0"},
    {"G28 P1\nG30 P2 X1\nG30 P3\nG30 P1\nG30 P5\nG30 P1.5\n",
     "!1:5 word-unused P; !2:5 word-unused P; !3:5 word-unused P; !4:5 word-unused P;"
     " !5:5 word-unused P; !6:5 word-unused P"},
    {"G10 L2 P10 X1\nG10 L2 P-1 X1\nG10 L20 P1.5 X1\nG10 L2 P1 R0 X1\nG10 L20 P1 R5 X1\n"
     "G10 L2 P1 Q5 X1\nG10 P1 X1\nG10 L2 X1\nG10 L99 P1 X1\nG10 L2.5 P1 X1\n"
     "G10 L2 P1 X1000001\nG92\nG52\n",
     "!1:8 number-range P 10/9; !2:8 number-range P -1/9; !3:9 number-range P 1.5/9;"
     " !5:12 unsupported R 5/0; !6:11 word-unused Q; !7:1 word-missing L; !8:1 word-missing P;"
     " !9:5 unsupported L 99/0; !10:5 unsupported L 2.5/0;"
     " !11:11 number-range X 1000001/1000000; !12:1 word-missing X; !13:1 word-missing X"},
    {"G10 L2 P1 R90 X1\nG0 X2 Y1\nG92 X0 Y0\nX1\nG53 X9\nG28 X1\nG10 L20 P1 X1\n"
     "G10 L2 P1 R1000001\nG55 X1\nG54 G18 G2 X5 Z1 R9 F1\nG0 X#5230\n",
     "2 rapid Y2; 4 rapid Y3; 5 rapid X9; !6:1 layout-on G 28/0; !7:1 layout-on G 10/0;"
     " !8:11 number-range R 1000001/1000000; 9 rapid X3; !10:9 layout-on; 11 rapid Y92 Z1"},
    {"G43.1 Z5\nG0 Z1\nG43.1 X1 Y2\nZ0\nG49\nX0\nG20 G43.1 Z1\nZ0\nG91 G43.1 Z2\nG90 Z0\n",
     "2 rapid Z1 tool Z5; 4 rapid X-1 Y-2 Z0 tool X1 tool Y2;"
     " 6 rapid X0 Y0 Z5 tool X0 tool Y0 tool Z0; 8 rapid Z0 tool Z25.4; 10 rapid tool Z50.8"},
    {"G43 H1\nG43\nG43.2 H1\nG43.2\nG43.1 Z1000001\nG49 H1\n",
     "?1:5 assumed-length H 1/0; !4:1 word-missing H 43.2/0;"
     " !5:7 number-range Z 1000001/1000000; !6:5 word-unused H"},
    {"X1\nG0 X1\nG80\nX2\nG80 G1 F5 X3\nX4\n",
     "!1:1 no-motion X; 2 rapid X1; !4:1 no-motion X; 5 line X3 F5; 6 line X4"},
    {"N10 G0 X1\n/X2\n/2 X3\nN20 (remark) X4 (more)\nX5 ; tail X6\n%\nX7\n",
     "1 rapid X1; 2 rapid X2; 3 rapid X3; 4 rapid X4; 5 rapid X5; 7 rapid X7"},
    {"%\nG0 X1\n%\nX2\n",
     "2 rapid X1; ?4:0 after-end; 3 end M2"},
    {"G0 X1 X2\nG0 X1 G1\nG0 G53 G91 X1\nG17 G18\nM3 M5\nM7 M9\nM8 M9\nM0 M30\nG54 G55\n"
     "G20 G21\nG90 G91\nG94 G95\nG61 G64\nG43 G49\nG40 G41\nG98 G99\nG4 P1 G28\nM48 M49\n"
     "T1 T2\nS1 S2\nF1 F2\nG90.1 G91.1\nG10 L2 P1 G92 X1\nG28 G30\nG7 G8\nM70 M71\n",
     "!1:7 word-twice X; !2:7 modal-group G 1/0; !3:4 incremental G 53/0;"
     " !4:5 modal-group G 18/0; !5:4 modal-group M 5/0; !6:4 modal-group M 9/0;"
     " !7:4 modal-group M 9/0; !8:4 modal-group M 30/0; !9:5 modal-group G 55/0;"
     " !10:5 modal-group G 21/0; !11:5 modal-group G 91/0; !12:5 modal-group G 95/0;"
     " !13:5 modal-group G 64/0; !14:5 modal-group G 49/0; !15:5 modal-group G 41/0;"
     " !16:5 modal-group G 99/0; 17 dwell for 1; 17 rapid; 17 rapid; !18:5 modal-group M 49/0;"
     " !19:4 word-twice T; !20:4 word-twice S; !21:4 word-twice F; !22:7 modal-group G 91.1/0;"
     " !23:11 modal-group G 92/0; !24:5 modal-group G 30/0; !25:4 modal-group G 8/0;"
     " !26:5 modal-group M 71/0"},
    {"G0 A1\nG0 X1 B2\nU5\nX1\n",
     "!1:4 axis-unknown A; !2:7 axis-unknown B; !3:1 axis-unknown U"},
    {"G98765\nG1.23\nG-1\nM1000\nM-1\nM3.1\nG0.5\nG\nM\nX\nG0 X-\nG0 X+-1\nG0 X.\nG0 X1.\n"
     "G0 X+.5\nG0 X-.25\nG0 X 2 5\nG0 X0005.5000\nG0 X1e3\nG0 X1,5\n",
     "!1:1 g-unknown G 98765/0; !2:1 g-unknown G 1.23/0; !3:1 g-unknown G -1/0;"
     " !4:1 m-unknown M 1000/0; !5:1 m-unknown M -1/0; !6:1 m-unknown M 3.1/0;"
     " !7:1 g-unknown G 0.5/0; !8:1 number G; !9:1 number M; !10:1 number X; !11:4 number X;"
     " !12:4 number X; !13:4 number X; 14 rapid X1; 15 rapid X0.5; 16 rapid X-0.25;"
     " 17 rapid X25; 18 rapid X5.5; !19:6 word-unknown E; !20:6 character 44/0"},
    {"G0 X1 !\nG0 X1 [2]\nG0 X1 @\nG0 X1 ^\nG0 X1 -2\nG0 X1 .5\nG0 X1 )\n(open\nG0 X1 \"a\"\n"
     "G0 X1 $\n",
     "!1:7 character 33/0; !2:7 unsupported 91/0; !3:8 expression; !4:8 expression;"
     " !5:7 number 45/0; 6 rapid X1.5; !7:7 character 41/0; !8:1 comment; !9:7 character 34/0;"
     " !10:7 character 36/0"},
};

static void plain_words_do_what_they_say(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, plain_rows);
}

static const told_row_t arcs_rows[] = {
    {"F100\nG2 X10 Y0 R5\nG3 X0 Y0 R-5\nG2 X10 R-10\nG3 X0 R10\nG2 X3 Y4 R2.4991\nG2 X6 Y8 R0\n"
     "G2 R5\nG2 X13 Y4 R5 I1\nG2 X13 Y4 R5 J1\nG2 X13 Y4 R5 K1\n",
     "2 arc X10 G17 about 5 0 by -180 F100; 3 arc X0 G17 about 5 0 by 180;"
     " 4 arc X10 G17 about 5 8.66025 by -300; 5 arc X0 G17 about 5 -8.66025 by 60;"
     " 6 arc X3 Y4 G17 about 1.5 2 by -180; !7:10 arc-centre R; !8:4 arc-centre R 5/0;"
     " !9:14 word-unused I; !10:14 word-unused J; !11:14 word-unused K"},
    {"F100 G18\nG2 X10 Z0 R5\nG3 X0 Z0 I-5 K0\nG2 Z10 X0 K5\nG2 X0 Z0 J5\nG2 X0 Z0 K-5 J1\n"
     "G2 X0 Z0 K-5 I0 Y7\n",
     "2 arc X10 G18 about 0 5 by -180 F100; 3 arc X0 G18 about 0 5 by 180;"
     " 4 arc Z10 G18 about 5 0 by -180; !5:10 word-unused J; !6:14 word-unused J;"
     " 7 arc Y7 Z0 G18 about -5 0 by -360"},
    {"F100 G19\nG2 Y10 Z0 J5\nG3 Z10 K5\nG3 Z0 J0 K-5 X2\nG2 Y0 R5\nG2 Y10 I5\n",
     "2 arc Y10 G19 about 5 0 by -180 F100; 3 arc Z10 G19 about 10 5 by 180;"
     " 4 arc X2 Z0 G19 about 10 5 by 180; 5 arc Y0 G19 about 5 0 by -180; !6:8 word-unused I"},
    {"F100\nG2 I5\nG3 J-2 P3\nG2 X10 I5 P2 Z-6\nG2 X0 I-5 P0\nG2 X0 I-5 P1.5\nG2 X0 I-5 P1001\n"
     "G3 X0 I-5 P1000\n",
     "2 arc G17 about 5 0 by -360 F100; 3 arc G17 about 0 -2 by 1080;"
     " 4 arc X10 Z-6 G17 about 5 0 by -540; !5:11 number-range P 0/100000;"
     " !6:11 number-range P 1.5/100000; 7 arc X0 G17 about -5 0 by -360360;"
     " 8 arc G17 about -5 0 by 360000"},
    {"F100\nG2 X1\nG2 X10 Y0 I0 J0\nG2 X10 Y0 I6\nG2 X20 Y0 I5.0005\nG2 X30 I5.004\n"
     "G2 X40 I5.1\nG2 I0\n",
     "!2:1 arc-centre; !3:1 arc-centre; 4 arc X10 G17 about 16 0 by -360 F100;"
     " 5 arc X20 G17 about 15 0 by -180; !6:1 arc-radius 4.996/5.004; !7:1 arc-radius 4.9/5.1;"
     " !8:1 arc-centre"},
    {"F100 G90.1\nG2 X10 I5 J0\nG2 X0 I5\nG2 X0 J0\nG3 X0 Y0 I5 J0\nG1 X3 Y4\nG2 X3 Y-4 I0 J0\n"
     "G2 X13 Y-4 I5 J0\n",
     "2 arc X10 G17 about 5 0 by -180 F100; !3:0 word-missing J; !4:0 word-missing I;"
     " 5 arc X0 G17 about 5 0 by 360; 6 line X3 Y4; 7 arc Y-4 G17 about 0 0 by -106.2602;"
     " !8:1 arc-mode I 8.94427191/4.47213595"},
    {"F100 G1 X3 Y4\nG2 X3 Y-4 I-3 J-4\nG2 X-3 Y-4 I0 J0\nG91.1 G2 X-3 Y4 I0 J4\n"
     "G90.1 G2 X3 Y4 I3 J-8\n",
     "1 line X3 Y4 F100; 2 arc Y-4 G17 about 0 0 by -106.2602; !3:1 arc-centre;"
     " 4 arc X-3 Y4 G17 about -3 0 by -180; !5:7 arc-mode I 12/13.4164079"},
    {"G10 L2 P1 X10 Y20\nF100 G90.1 G1 X0 Y0\nG3 X10 Y0 I5 J0\nG52 X1\nG2 X0 Y0 I4.5 J0\n",
     "2 line X10 Y20 F100; 3 arc X20 G17 about 15 20 by 180;"
     " 5 arc X11 G17 about 15.5 20 by -180"},
    {"F60 G20 G91\nG2 X1 I.5\nG3 X1 Y1 J1\nG90 X0 Y0 R2\n",
     "?1:0 feed-units; 2 arc X25.4 G17 about 12.7 0 by -180 F60;"
     " 3 arc X50.8 Y25.4 G17 about 25.4 25.4 by 90;"
     " 4 arc X0 Y0 G17 about 44.23714 -24.97429 by 67.9757"},
    {"G43.1 X1 Y2 Z3\nF100 G1 X0 Y0 Z0\nG2 X10 I5\nG18 G3 X0 I-5\n",
     "2 line tool X1 tool Y2 tool Z3 F100; 3 arc X10 G17 about 5 0 by -180;"
     " 4 arc X0 G18 about 0 5 by 180"},
    {"F100 G2 X1000000 R500000\nG3 X0 R500000.5\nG2 X0 R-1\n",
     "1 arc X1000000 G17 about 500000 0 by -180 F100;"
     " 2 arc X0 G17 about 500000 -707.10696 by 179.8379; !3:7 arc-centre R -1/0"},
    {"F100 G17 G1 X5 Y0\nG3 X5 Y.0005 I-5 J0\nG3 X4.9995 Y0 I-5 J0\n",
     "1 line X5 F100; 2 arc Y0.0005 G17 about 0 0.00025 by 0.0057;"
     " 3 arc X-4.99975 Y0.00075 G17 about 0.00012 0.0005 by 179.9971;"
     " 3 arc X4.9995 Y0 G17 about -0.00012 0.0005 by 179.9971"},
    {"F100 G61.1\nG3 X0 Y0.003 I-5 P2 Z9\nG3 X0 Y0.001 I-5\n",
     "2 arc Y0.003 Z9 G17 about -5 0.0015 by 360.0344 F100 stop P0 Q0;"
     " 3 arc Y0.001 G17 about -5 0.002 by 359.9771"},
    {"G2 X5 R5\nF100\nG2 X1 R5\nG93 G3 X2 R5\nG3 X3 R5 F2\n",
     "!1:0 feed-missing F; 3 arc X1 G17 about 3 4.58258 by -47.1564 F100; !4:0 feed-missing F;"
     " 5 arc X3 G17 about 2.5 4.97494 by 11.4783 F2 inverse"},
};

static void arcs_go_about_their_centre(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, arcs_rows);
}

static const told_row_t six_rows[] = {
    {"G0 A90 B-45.5 C.001\nG1 A0 F360\nX1 A10\nF100 A20 B30\nG20 A30 F10\nX1 A40\nF10 X2\nC5\n",
     "1 rapid A90 B-45.5 C0.001; 2 line A0 F360; 3 line X1 A10; 4 line A20 B30 F100;"
     " ?5:0 feed-units; 5 line A30 F10; 6 line X25.4 A40; 7 line X50.8 F254;"
     " 8 line C5 F10"},
    {"G91 G0 A10 X1\nA10\nG92 A0\nG90 A10\nG53 A0\nG10 L2 P1 A5\nA0\nG28 A3\nG28\n",
     "1 rapid X1 A10; 2 rapid A20; 4 rapid A30; 5 rapid A0; 7 rapid A25; 8 rapid A28;"
     " 8 rapid A0; 9 rapid; 9 rapid X0"},
    {"F100 G1 A1000001\nA1000000\nA-1000000\nX1 G2 Y1 R5 A2\nG93 F2 A0\nG93 F2 A0 X0\n",
     "!1:9 number-range A 1000001/1000000; 2 line A1000000 F100; 3 line A-1000000;"
     " 4 arc X1 Y1 A2 G17 about 4 -3 by -16.2602; !5:0 arc-centre; !6:0 arc-centre"},
    {"G20 F60 G2 X1 R1 A5\nG3 I.5 B7 P2\n",
     "?1:0 feed-units; 1 arc X25.4 A5 G17 about 12.7 -21.99705 by -60 F60;"
     " 2 arc B7 G17 about 38.1 0 by 720"},
};

static void rotary_axes_count_degrees(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    told_turns(&self);
    TOLD(check, &self, six_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, plain_words_do_what_they_say);
    CHECK_RUN(&check, arcs_go_about_their_centre);
    CHECK_RUN(&check, rotary_axes_count_degrees);
    return check_end(&check);
}
