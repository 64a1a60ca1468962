// SPDX-License-Identifier: MIT
// Room 1: lines of Fanuc's mills, and all that they are told to do.
#include "told_check.h"

static told_t self;

static const told_row_t fanuc_rows[] = {
    {"G0 X100 Y1.\nG20 X1. F10\nG4 P1500\nG4 X2.5\nG4 U.5\nG4 X2\nG90 G0 G28 Z1.\nX2.\n"
     "G61 X3.\nG64 X4.\n",
     "?1:0 assumed-integers; 1 rapid X100 Y1; ?2:0 feed-units; 2 rapid X25.4; 3 dwell for 1.5;"
     " 4 dwell for 2.5; 5 dwell for 0.5; 6 dwell for 2; 7 rapid Z25.4; 7 rapid Z0;"
     " 8 rapid X50.8; 9 rapid X76.2 stop P0 Q0; 10 rapid X101.6 smooth P0.01 Q0.01"},
    {"G81 X10. Y5. Z-5. R2. F100.\nX20.\nG82 X30. P500\nG91 X10. K3\nG98 X10. Z-6. R-1. K2\n"
     "G90 G83 X0. Z-9. R1. Q4.\nR2.\nG80\nX9.\n",
     "1 rapid~ Z2; 1 rapid~ X10 Y5; 1 line~ Z-5 F100; 1 rapid~ Z2; 2 rapid~ X20; 2 line~ Z-5;"
     " 2 rapid~ Z2; 3 rapid~ X30; 3 line~ Z-5; 3 dwell for 0.5; 3 rapid~ Z2; 4 rapid~ X40;"
     " 4 line~ Z-5; 4 dwell for 0.5; 4 rapid~ Z2; 4 rapid~ X50; 4 line~ Z-5; 4 dwell for 0.5;"
     " 4 rapid~ Z2; 4 rapid~ X60; 4 line~ Z-5; 4 dwell for 0.5; 4 rapid~ Z2; 5 rapid~ X70;"
     " 5 rapid~ Z-1; 5 line~ Z-7; 5 dwell for 0.5; 5 rapid~ Z0; 5 rapid~ X80; 5 rapid~ Z-1;"
     " 5 line~ Z-7; 5 dwell for 0.5; 5 rapid~ Z0; 6 rapid~ Z1; 6 rapid~ X0; 6 line~ Z-3;"
     " 6 rapid~ Z1; 6 rapid~ Z-2.746; 6 line~ Z-7; 6 rapid~ Z1; 6 rapid~ Z-6.746; 6 line~ Z-9;"
     " 6 rapid~ Z1; 7 rapid~ Z2; 7 line~ Z-2; 7 rapid~ Z2; 7 rapid~ Z-1.746; 7 line~ Z-6;"
     " 7 rapid~ Z2; 7 rapid~ Z-5.746; 7 line~ Z-9; 7 rapid~ Z2; 9 rapid X9"},
    {"G0 Z10. F100.\nG98 G81 X1. Z-5. R2. K0\nX2.\nG99 X3. L2\nX4. K2 L2\nG73 X5. Q3.\n"
     "G86 X6.\nG89 X7. P1000\nG80 G0 Z20.\n",
     "1 rapid Z10; 3 rapid~ X2; 3 rapid~ Z2; 3 line~ Z-5 F100; 3 rapid~ Z10; 4 rapid~ X3;"
     " 4 rapid~ Z2; 4 line~ Z-5; 4 rapid~ Z2; 4 line~ Z-5; 4 rapid~ Z2; !5:5 word-shared K;"
     " 6 rapid~ X5; 6 line~ Z-1; 6 rapid~ Z-0.746; 6 line~ Z-4; 6 rapid~ Z-3.746; 6 line~ Z-5;"
     " 6 rapid~ Z2; !7:1 word-missing M; !8:1 word-missing R; 9 rapid Z20"},
    {"G91 G0 Z10. F60.\nG98 G81 X1. Z-5. R-2.\nX1. Z-6.\nR-3. X1.\nG99 X1.\nG90 X0.\n",
     "1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z8; 2 line~ Z3 F60; 2 rapid~ Z10; 3 rapid~ X2;"
     " 3 rapid~ Z8; 3 line~ Z2; 3 rapid~ Z10; 4 rapid~ X3; 4 rapid~ Z7; 4 line~ Z2;"
     " 4 rapid~ Z10; 5 rapid~ X4; 5 rapid~ Z7; 5 line~ Z2; 5 rapid~ Z7; 6 rapid~ X0;"
     " 6 line~ Z2; 6 rapid~ Z7"},
    {"S100 M3 F150. G0 Z10.\nG84 X1. Z-5. R2.\nG74 X2. P500\nG98 X3.\nM29 S50\nG84 X4. R1.\n"
     "G95 F1.5 X5.\nG80\n",
     "1 out S100; 1 out M3 S100; 1 rapid Z10; 2 rapid~ X1; 2 rapid~ Z2;"
     " 2 tap by 0 0 -7 lead 1.5 for 5.968; 2 rapid~ Z10; 3 out M4; 3 rapid~ X2; 3 rapid~ Z2;"
     " 3 tap by 0 0 -7 lead 1.5 dwell 0.5 for 6.468; 3 rapid~ Z10; 4 rapid~ X3; 4 rapid~ Z2;"
     " 4 tap by 0 0 -7 lead 1.5 dwell 0.5 for 6.468; 4 rapid~ Z10; 5 out S50 S50; 5 out M29;"
     " 6 out M3; 6 rapid~ X4; 6 rapid~ Z1; 6 tap by 0 0 -6 lead 3 dwell 0.5 for 5.968;"
     " 6 rapid~ Z10; 7 rapid~ X5 per-rev; 7 rapid~ Z1;"
     " 7 tap by 0 0 -6 lead 1.5 dwell 0.5 for 10.75; 7 rapid~ Z10"},
    {"G10 L2 P1 X10. Y20.\nG0 X1. Y1.\nG10 L2 P0 X5.\nX1.\nG91 G10 L2 P1 X1.\nG90 X1.\n"
     "G10 L2 P0 X1.\nG54 X0.\nG10 L2 P7 X1.\nG10 L20 P1 X0.\nG10 L2 P6 X100.\nG59 X1.\n",
     "2 rapid X11 Y21; 4 rapid X16; 6 rapid X17; 8 rapid X12; !9:8 number-range P 7/6;"
     " 12 rapid X102"},
    {"G52 X1. Y2.\nG0 X1. Y1.\nG52 X0. Y0.\nX1.\nG92 X5.\nX6.\nG52 X3.\nG92.1\n",
     "2 rapid X2 Y3; 4 rapid X1; !5:1 unsupported G 92/0; 6 rapid X6; !8:1 unsupported G 92.1/0"},
    {"G43\nG43 H1\nG49 G0 X1.\nG30 X1.\nG30 P2\nG30 P3\nG30 P1\nG30 P5\nG53 X1.\nG28 X5. Y6.\n"
     "G28\n",
     "!1:1 word-missing H 43/0; ?2:5 assumed-length H 1/0; 3 rapid X1; 4 rapid; 4 rapid X0;"
     " 5 rapid; 5 rapid; !6:5 unsupported P 3/0; !7:5 number-range P 1/4;"
     " !8:5 number-range P 5/4; 9 rapid X1; 10 rapid X5 Y6; 10 rapid X0 Y0; 11 rapid; 11 rapid"},
    {"#1=5.\nG0 X#1 Y#0\nX#2\n#3=#0\n#1=#0\nX#1 Y1.\nX[#1+2] Y[3*#0]\n#1=-2.7\n"
     "X[FIX[#1]] Y[FUP[#1]] Z[ROUND[#1]]\nX[FIX[2.7]] Y[FUP[2.1]] Z[RND[2.5]]\n"
     "X[6 AND 3] Y[6 OR 3] Z[6 XOR 3]\nX[BIN[21]] Y[BCD[15]] Z[SQR[9]]\n"
     "X[POW[2,3]] Y[ATAN[1,1]] Z[ATAN[1]/[1]]\nX[1 EQ 1.00001] Y[#99 EQ #0] Z[#99 EQ 0]\n"
     "X[1.5 AND 1] \nX[2**3]\nX#<a>\nX[EXISTS[#1]]\nX[ADP[1]]\nX[PRM[1]]\nX[MAX[1,2]]\n"
     "X[POW[2]]\nX[ATAN[1]]\nX[SIN[1,2]]\nX[-1 AND 1]\nX[4294967295 AND 4]\n"
     "X[4294967296 AND 4]\nX[BCD[99999999]]\nX[BCD[100000000]]\nX[BIN[10]]\n",
     "2 rapid X5; 6 rapid Y1; 7 rapid X2 Y0; 9 rapid X-2 Y-3 Z-3; 10 rapid X2 Y3 Z3;"
     " 11 rapid Y7 Z5; 12 rapid X15 Y21 Z3; 13 rapid X8 Y45 Z45; !14:23 unsupported # 99/0;"
     " !15:12 value 1.5/0; !16:4 other-base 0/1; !17:3 other-base 0/1; !18:3 other-base 0/1;"
     " !19:3 unsupported; !20:3 unsupported; !21:3 expression; !22:9 expression;"
     " !23:10 expression; !24:8 expression; !25:11 value -1/0; 26 rapid X4;"
     " !27:19 value 4.2949673e+09/0; !28:1 number-range X 2.57698038e+09/1000000;"
     " !29:17 value 100000000/0; !30:10 value 10/0"},
    {"IF [1 EQ 2] GOTO 10\nG0 X1.\nN10 X2.\nIF [1 LT 2] GOTO 20\nX3.\nN20 X4.\n"
     "IF [2 GT 1] THEN #1=7.\nX#1\nIF [2 LT 1] THEN #1=8.\nX#1\nGOTO 30\nX5.\nN30 X6.\n#2=0\n"
     "WHILE [#2 LT 2] DO1\n#2=#2+1\n#3=0\nWHILE [#3 LT 2] DO 2\n#3=[#3+1]\nX[#2*10+#3]\nEND2\n"
     "END 1\nGOTO 99\nX7.\n",
     "2 rapid X1; 3 rapid X2; 6 rapid X4; 8 rapid X7; 10 rapid; 13 rapid X6; 20 rapid X11;"
     " 20 rapid X12; 20 rapid X21; 20 rapid X22; !23:0 label-missing 99/0"},
    {"GOTO 5\nN5 G0 X1.\n#1=5\nN6 #1=[#1-1]\nX#1\nIF [#1 GT 3] GOTO 6\nIF [#1 EQ 3] GOTO[5+2]\n"
     "X50.\nN7 X60.\n",
     "2 rapid X1; 5 rapid X4; 5 rapid X3; 9 rapid X60"},
    {"END1\n",
     "!1:0 flow"},
    {"WHILE [1] DO1\nG0 X1.\n",
     "2 rapid X1"},
    {"G0 X5.\nIF 1 GOTO 5\n",
     "1 rapid X5; !2:0 label-missing 5/0"},
    {"G0 X5.\nIF [1] X1\n",
     "1 rapid X5; !2:8 expression"},
    {"G0 X5.\nIF [1]\n",
     "1 rapid X5; !2:7 expression"},
    {"G0 X5.\nGOTO\n",
     "1 rapid X5; !2:5 expression"},
    {"G0 X5.\nGOTO 1.5\n",
     "1 rapid X5; !2:0 label-missing 2/0"},
    {"G0 X5.\nGOTO -1\n",
     "1 rapid X5; !2:6 expression"},
    {"G0 X5.\nWHILE [1]\n",
     "1 rapid X5; !2:10 expression"},
    {"G0 X5.\nWHILE [1] DO\n",
     "1 rapid X5; !2:13 expression"},
    {"G0 X5.\nDO\n",
     "1 rapid X5; !2:3 expression"},
    {"G0 X5.\nEND\n",
     "1 rapid X5; !2:0 flow"},
    {"G0 X5.\nTHEN #1=2\n",
     "1 rapid X5; !2:2 expression"},
    {"M98 P7\nM98 P7 L2\nM98 P20007\nG65 P7 X1. Y2. A3. I4. J5. K6. I7.\n"
     "G65 P8 A1. B2. C3. D4. E5. F6. H7. I8. J9. K10. M11. Q12. R13. S14. T15. U16. V17."
     " W18. X19. Y20. Z21.\nM99\nM30\nO7\nG0 X#1 Y#24 Z#25\nX#4 Y#5 Z#6\nX#7\nM99\nO8\n"
     "G0 X#1 Y#2 Z#3\nX#7 Y#8 Z#9\nX#11 Y#4 Z#5\nX#6 Y#13 Z#17\nX#18 Y#19 Z#20\n"
     "X#21 Y#22 Z#23\nX#24 Y#25 Z#26\nM99\n",
     "9 rapid X3 Y1 Z2; 10 rapid X4 Y5 Z6; 11 rapid X7; 14 rapid X1 Y2 Z3; 15 rapid X4 Y5 Z6;"
     " 16 rapid X7 Y8 Z9; 17 rapid X10 Y11 Z12; 18 rapid X13 Y14 Z15; 19 rapid X16 Y17 Z18;"
     " 20 rapid X19 Y20 Z21; ?6:0 repeats; 6 end M30"},
    {"G66 P7 A5.\nG0 X1.\nY1.\nG1 X2. F100\nG67\nX3.\nM30\nO7\nZ#1\nZ0\nM99\n",
     "2 rapid X1; 9 rapid Z5; 10 rapid Z0; 3 rapid Y1; 9 rapid Z5; 10 rapid Z0; 4 line X2 F100;"
     " 9 line Z5; 10 line Z0; 6 line X3; 7 end M30"},
    {"G0\nG65 P7 A1. A2.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:12 word-twice A; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P7 G1\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:1 modal-group G 65/0; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P7 N5\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "3 end M30"},
    {"G0\nG65 P7 O5\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "3 end M30"},
    {"G0\nG65 P7 L2 A1.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "5 rapid X1; 5 rapid; 3 end M30"},
    {"G0\nG65 A1.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:1 word-missing P; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P9\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:0 label-missing 9/0; ?2:0 called-from"},
    {"G0\nG65 P7 A1. B2. G0\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:1 modal-group G 65/0; ?4:0 after-end; 3 end M30"},
    {"G0\nG0 G65 P7\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:4 modal-group G 65/0; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P7 I1. I2. J3. K4.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:16 unsupported J; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P7 K1. J2. I3.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:12 unsupported J; ?4:0 after-end; 3 end M30"},
    {"G0\nG65 P7 D1. I2. I3.\nM30\nO7\nG0 X#1 Y#4 Z#7\nM99\n",
     "!2:8 word-twice D; ?4:0 after-end; 3 end M30"},
    {"M98 P7\nG0 X9.\nM30\nO7\nX1.\nM99 P20\nX2.\nN20 X3.\n",
     "5 rapid X1; !6:0 label-missing 20/0"},
    {"O7\nG0 X1.\nM99 P5\nX2.\nN5 X3.\n",
     "2 rapid X1; 5 rapid X3"},
    {"#3000=5 (alarm)\nG0 X1.\n",
     "!1:0 alarm 5/0"},
    {"#3006=1 (stop)\nG0 X1.\n",
     "1 wait M0; 2 rapid X1"},
    {"G0 X1. Y2. Z3.\nX#5001 Y[#5002+1.] Z#5003\nX[#5041] Y#5042 Z[#5021+1.]\n"
     "X#4001 Y#4002 Z#4003\nX#4005 Y#4006 Z#4014\nX#4109 Y#4113 Z#4119\nX#4120 Y#4111 Z#4107\n"
     "#5221=7.\nX1.\nX#5221\n#5201=1.\nX1.\nX#5241\n#5222=#5221 Y0\n#2001=1\nX#2001\n#1000=1\n"
     "X#1000\nX#3000\nX#3010\n",
     "1 rapid X1 Y2 Z3; 2 rapid Y3; 3 rapid Z2; 4 rapid X0 Y17 Z90; 5 rapid X94 Y21 Z54;"
     " !6:15 unsupported # 4113/0; !7:15 unsupported # 4111/0; 9 rapid X8; 10 rapid X14;"
     " 12 rapid X9; 13 rapid X8; !14:13 word-shared # 5222/0; !15:1 unsupported # 2001/0;"
     " !16:7 unsupported # 2001/0; !17:1 unsupported # 1000/0; !18:7 unsupported # 1000/0;"
     " !19:7 unsupported # 3000/0; !20:7 unsupported # 3010/0"},
    {"G16 G0 X10. Y30.\nY90.\nG91 Y30.\nX5.\nG15 X0 Y0\nG90 X1. Y1.\n",
     "1 rapid X8.660254 Y5; 2 rapid X0 Y10; 3 rapid X-5 Y8.660254; 4 rapid X-7.5 Y12.990381;"
     " 5 rapid; 6 rapid X1 Y1"},
    {"G68 X0 Y0 R90.\nG0 X10. Y0\nX0 Y10.\nG69\nX0 Y0\nG68 X5. Y5. R45.\nX10. Y5.\nG69\n",
     "2 rapid Y10; 3 rapid X-10 Y0; 5 rapid X0; 7 rapid X8.535534 Y8.535534"},
    {"G51 X0 Y0 Z0 P2.\nG0 X10. Y5. Z1.\nF100. G2 X20. R5.\nG50\nX10.\nG51 I2. J-1. K1.\n"
     "X5. Y5.\nG50\nG51 P2\nG51.1 X0\nX5. Y1.\nG2 X15. I5.\nG50.1\nX5.\n",
     "2 rapid X20 Y10 Z2; 3 arc X40 G17 about 30 10 by -180 F100; !5:0 arc-centre;"
     " !7:0 layout-on; !9:5 scale-unit P 2/0; !11:0 arc-centre;"
     " 12 arc X-15 Y1 G17 about -10 1 by 180; !14:0 arc-centre"},
    {"G51.1 Y10.\nG0 X1. Y1.\nG41 D1\nG54\nG28\nG92 X0\nG52 X0\nG53 X0\nG10 L2 P1 X0\nG18\n"
     "G50.1 Y0\nG68 X0 Y0 R30.\nG18\nG50.1\nG69 \nG51 P.5\nG81 X1. Z-5. R1. F100.\nG50\n",
     "2 rapid X1 Y19; ?3:5 assumed-length D 1/0; !4:1 layout-on G 54/0; !5:1 layout-on G 28/0;"
     " !6:1 layout-on G 92/0; !7:1 layout-on G 52/0; !8:1 layout-on G 53/0; !9:1 layout-on G"
     " 10/0; !10:1 comp-on G 18/0; !11:1 comp-on G 1.6/0; !12:1 comp-on G 12.8/0; !13:1 comp-on"
     " G 18/0; !14:1 comp-on G 1.6/0; !15:1 comp-on G 6.4/0; !16:1 comp-on G 0.8/0; !17:0"
     " comp-on G 81/0; !18:1 comp-on G 0.4/0"},
    {"G17 G41 D1 G1 X1. F100.\nG40 X0\n",
     "?1:9 assumed-length D 1/0; 1 line X1 F100; 2 line X0"},
    {"G0 X.5 Y1,5\nG1 X10. ,R2. F100.\nY10.\nX20. ,C1.\nY0\nX30. ,R20.\nY1.\nX40. ,C1.\nX50.\n"
     "X60. ,R1.\nG0 X70.\nG1 X80. ,R1. ,C1.\nX90. ,R-1.\nX95. ,R0\nY5.\nX100. ,B5.\n",
     "!1:10 character 44/0; 2 line X8 F100; 2 arc X10 Y2 G17 about 8 2 by 90; 3 line Y10;"
     " 4 line X19; 4 line X20 Y9; 5 line Y0; !6:7 corner R 20/0; !8:7 corner C 1/0;"
     " !10:7 corner R 1/0; !12:15 word-twice C; !13:7 corner R -1/0; !14:7 corner R;"
     " 15 rapid X95 Y5; !16:7 character 44/0"},
    {"G0 X1\nG21 X1000\nG20 X1\nX1.\nG4 X1\nY5 R1\nG2 X5 R5 F1\n",
     "?1:0 assumed-integers; 1 rapid X1; 2 rapid X1000; 3 rapid X25.4; 4 rapid; 5 dwell for 1;"
     " !6:4 word-unused R; 7 arc X127 G17 about 76.2 -116.39742 by -47.1564 F25.4"},
};

static void fanucs_words_do_what_they_say(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, fanuc_rows);
}

static const told_row_t fanuc_inc_rows[] = {
    {"G0 X1 Y1.\nX1000 A5\nG2 X0 I-500 F100\nG4 X500\nG4 P500\nG20 X10000\nG81 Z-1000 R500 Q3\n"
     "F60 G81 Z-1000 R500\nG83 Z-2000 R500 Q1000\n",
     "1 rapid X0.001 Y1; !2:7 axis-unknown A; 3 arc X-0.9985 G17 about -0.49875 1 by -180 F100;"
     " 3 arc X0 G17 about -0.49925 1 by -180; 4 dwell for 0.5; 5 dwell for 0.5;"
     " !6:0 arc-centre; !7:17 word-unused Q; 8 rapid~ X25.4 Z1.27; 8 line~ Z-2.54 F1524;"
     " 8 rapid~ Z1.27; 9 line~ Z-1.27; 9 rapid~ Z1.27; 9 rapid~ Z-1.016; 9 line~ Z-3.81;"
     " 9 rapid~ Z1.27; 9 rapid~ Z-3.556; 9 line~ Z-5.08; 9 rapid~ Z1.27"},
};

static void words_without_a_point_are_increments(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    self.machine.dialect.integers = NCK_INTEGERS_INCREMENTS;
    TOLD(check, &self, fanuc_inc_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, fanucs_words_do_what_they_say);
    CHECK_RUN(&check, words_without_a_point_are_increments);
    return check_end(&check);
}
