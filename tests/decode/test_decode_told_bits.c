// SPDX-License-Identifier: MIT
// Room 1: powers and angles, numbers as bits, places that are mapped.
#include "told_check.h"

static told_t self;

static const told_row_t powers_rows[] = {
    {"G0 X[[-1]**2001] Y[[-1]**2000] Z[1.0001**2000]\nX[1.0001**-2000] Y[0**2000] Z[2**.5]\n"
     "X[[-1]**1025] Y[[-1]**1024] Z[1**1e3]\nX[.5**3] Y[2**-3] Z[[-2]**3]\n"
     "X[2**10] Y[2**0] Z[0**0]\nX[10**2.5] Y[4**.5] Z[8**[1/3]]\nXEXP[-1] YEXP[10] ZEXP[.5]\n"
     "XLN[.5] YLN[1000000] ZLN[1.41]\nXLN[1.5] YLN[3] ZLN[.7]\n"
     "X[EXP[-800]] Y[EXP[13.8]] Z[EXP[-13]*1000000]\n"
     "X[EXP[0.34657]] Y[EXP[-.34658]] Z[LN[1.4142135]]\n"
     "X[1000000 MOD 7] Y[-7.5 MOD 2] Z[7.5 MOD -2]\nX[5 MOD 5] Y[4 MOD 5] Z[[1e0] MOD 1]\n"
     "X[10 MOD 3] Y[0 MOD 3] Z[.3 MOD .1]\nX[12345678 MOD 1000] Y[1 MOD 1000000] Z[9 MOD 4.5]\n"
     "XATAN[1]/[2] YATAN[-1]/[2] ZATAN[1]/[-2]\nXATAN[-1]/[-2] YATAN[0]/[1] ZATAN[-1]/[0]\n"
     "XASIN[.5] YACOS[.5] ZASIN[-1]\nXACOS[1] YACOS[-.5] ZASIN[0]\nXSIN[0] YSIN[90] ZSIN[180]\n"
     "XCOS[0] YCOS[90] ZCOS[180]\nXSIN[-390] YCOS[-420] ZTAN[225]\nXTAN[60] YSIN[45] ZCOS[45]\n"
     "XSQRT[0] YSQRT[2] ZSQRT[1000000]\nXABS[0] YROUND[-2.4] ZROUND[-2.6]\n"
     "XROUND[.5] YROUND[-.5] ZROUND[1.49999]\nXFIX[-2] YFUP[-2] ZFIX[2]\n"
     "XFUP[2] YFIX[-.1] ZFUP[.1]\nX[1 EQ 1.00009] Y[1 EQ 1.00011] Z[1 NE 1.00011]\n"
     "X[2 AND -1] Y[0 XOR 0] Z[.0001 OR 0]\n"
     "X[1 OR 0 AND 0] Y[3 GT 2 AND 2 GT 1] Z[1 EQ 1 OR 1 EQ 2]\n"
     "X[1 + 2 MOD 2] Y[2 * 3 MOD 4] Z[9 / 3 * 2]\nX[2 ** 2 * 3] Y[3 * 2 ** 2] Z[- 2 ** 2]\n"
     "X[[1+[2*[3+[4-[5-[6]]]]]]] Y[[[[[[1]]]]]] Z[1+[1+[1+[1+[1+[1+[1]]]]]]]\n"
     "X[1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1+1]\n"
     "X[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]\n"
     "X[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]\nX------------------------1\n"
     "X[------------------------1]\nX[-------------------------1]\nX[1]\n"
     "X[10**299/10**298] Y[10**299*10]\nX[10**300]\nY[-[10**299]*10]\n",
     "1 rapid X-1 Y1 Z1.221391; 2 rapid X0.818739 Y0 Z1.414214; !3:35 expression;"
     " 4 rapid X0.125 Y0.125 Z-8; 5 rapid X1024 Y1 Z1; 6 rapid X316.227766 Y2 Z2;"
     " 7 rapid X0.367879 Y22026.465795 Z1.648721; 8 rapid X-0.693147 Y13.815511 Z0.34359;"
     " 9 rapid X0.405465 Y1.098612 Z-0.356675; 10 rapid X0 Y984609.111229 Z2.260329;"
     " 11 rapid X1.414208 Y0.707102 Z0.346574; 12 rapid X1 Y0.5 Z1.5; !13:27 expression;"
     " 14 rapid Y0 Z0.1; 15 rapid X678 Y1 Z0; 16 rapid X26.565051 Y-26.565051 Z153.434949;"
     " 17 rapid X-153.434949 Y0 Z-90; 18 rapid X30 Y60; 19 rapid X0 Y120 Z0; 20 rapid Y1;"
     " 21 rapid X1 Y0 Z-1; 22 rapid X-0.5 Y0.5 Z1; 23 rapid X1.732051 Y0.707107 Z0.707107;"
     " 24 rapid X0 Y1.414214 Z1000; 25 rapid Y-2 Z-3; 26 rapid X1 Y-1 Z1; 27 rapid X-2 Y-2 Z2;"
     " 28 rapid X2 Y-1 Z1; 29 rapid X1 Y0; 30 rapid; 31 rapid X0 Y1; 32 rapid X1 Y2 Z6;"
     " 33 rapid X12 Y12 Z4; 34 rapid X17 Y1 Z7; 35 rapid X30; 36 rapid X1; !37:26 expression;"
     " !38:1 number X; !39:26 expression; !40:26 expression; 41 rapid; !42:32 value;"
     " !43:10 value; !44:16 value"},
};

static void powers_and_angles_are_what_they_are(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, powers_rows);
}

static const told_row_t fbits_rows[] = {
    {"G0 X[BIN[21]] Y[BIN[0]] Z[BCD[0]]\nX[BCD[99999]] Y[BIN[629145]] Z[BCD[10]]\n"
     "X[BIN[153]] Y[BCD[12345]] Z[BIN[16]]\nX[BIN[10]]\nX[BIN[160]]\nX[BIN[-1]]\nX[BIN[1.5]]\n"
     "X[BIN[1.0000001]]\nX[BIN[4294967296]]\nX[BCD[100000000]]\nX[[BCD[99999999]]/1000000.]\n"
     "X[[BIN[2576980377]]/1000.]\nX[5 AND 12] Y[5 OR 10] Z[5 XOR 12]\n"
     "X[4294967295 AND 255] Y[4294967295 XOR 4294967295] Z[0 OR 1]\nX[1.1 AND 1]\nX[1 OR -1]\n"
     "X[1 AND #0] Y[#0 OR 3]\nX[POW[2,10]] Y[POW[4,.5]] Z[POW[2,-1]]\nX[POW[-8,1/3]]\n"
     "X[POW[0,-1]]\nX[POW[1,2,3]]\nX[ATAN[1,1]] Y[ATAN[-1,-1]] Z[ATAN[1,0]]\nX[ATAN[1]/[-1]]\n"
     "X[FIX[-2.7]] Y[FUP[-2.1]] Z[FIX[2.7]]\nX[RND[2.5]] Y[ROUND[-2.5]] Z[SQR[4]]\n"
     "X[FUP[2.1]] Y[FIX[-.5]] Z[FUP[-.5]]\nX[SQRT[9]] Y[LN[1]] Z[EXP[0]]\n"
     "X[#0 EQ #0] Y[#0 EQ 0] Z[#0 NE 0]\nX[#0 LT 1] Y[#0 GE 0] Z[#0+1]\n"
     "X[1 EQ 1.0000001] Y[1 NE 1.0000001] Z[2 EQ 2]\nX[ADP[1]]\nX[PRM[1]]\nX[1,2]\n"
     "X[SIN[30,2]]\nX[SIN 30]\nX SIN[30]\nX-SIN[30]\nX[2+3,4]\n",
     "1 rapid X15; 2 rapid X629145 Y99999 Z16; 3 rapid X99 Y74565 Z10; !4:10 value 10/0;"
     " !5:11 value 160/0; !6:10 value -1/0; !7:11 value 1.5/0; 8 rapid X1;"
     " !9:18 value 4.2949673e+09/0; !10:17 value 100000000/0; 11 rapid X2576.980377;"
     " 12 rapid X99999.999; 13 rapid X4 Y15 Z9; 14 rapid X255 Y0 Z1; !15:12 value 1.1/0;"
     " !16:10 value 1/0; 17 rapid X0 Y3; 18 rapid X1024 Y2 Z0.5; !19:14 value -8/0;"
     " !20:12 value; !21:10 expression; 22 rapid X45 Y-135 Z90; 23 rapid X135;"
     " 24 rapid X-2 Y-3 Z2; 25 rapid X3; 26 rapid Y0 Z-1; 27 rapid Z1; 28 rapid X1;"
     " 29 rapid Y1; 30 rapid X0; !31:3 unsupported; !32:3 unsupported; !33:4 expression;"
     " !34:9 expression; !35:3 expression; 36 rapid X0.5; 37 rapid X-0.5; !38:6 expression"},
};

static void numbers_of_fanucs_are_bits(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, fbits_rows);
}

static const told_row_t layouts2_rows[] = {
    {"G10 L2 P1 X100. Y50. Z10.\nG0 X10. Y0 Z0\nG68 X0 Y0 R90.\nX10. Y5.\nZ3.\nG91 X5.\n"
     "G90 G69\nG51 X0 Y0 Z0 I2. J.5 K3.\nX10. Y10. Z10.\nG91 X1. Y1. Z1.\nG90 G50\n"
     "G51.1 X5. Z2.\nX1. Y1. Z1.\nG50.1 X0\nX1.\nG50.1\nX1. Z1.\nG16 X10. Y90.\nG91 X2.\nY10.\n"
     "G90 G15\n",
     "2 rapid X110 Y50 Z10; 4 rapid X95 Y60; 5 rapid Z13; 6 rapid Y65; 9 rapid X120 Y55 Z40;"
     " 10 rapid X122 Y55.5 Z43; 13 rapid X109 Y51 Z13; 15 rapid X101; 17 rapid Z11;"
     " 18 rapid X100 Y60; 19 rapid Y62; 20 rapid X99.652704 Y61.969616"},
    {"G16 G0 X10. Y370.\nX10. Y-90.\nX-10. Y1000001.\nY-30.\nG91 Y1000001.\nG15\nX1000000.\n"
     "G68 X0 Y0 R1000001.\nG68 X0 Y0 R-450.\nG0 X1. Y0\nG69\n",
     "1 rapid X9.848078 Y1.736482; 2 rapid X0 Y-10; !3:7 number-range Y 1000001/1000000;"
     " 4 rapid X-8.660254 Y5; 5 rapid X3.255682 Y9.455186;"
     " !7:1 number-range X 1000000/999996.744; !8:1 incremental G 68/0;"
     " !9:1 incremental G 68/0; 10 rapid X4.255682"},
    {"G51 X0 Y0 P1000.\nG51 X0 Y0 P1001.\nG0 X2.\nX1000.\nX1000.001\nG50\nG51 X0 Y0 P.001\n"
     "X1.\nG50\nG51 X0 Y0 P.0009\nG51 P-2. X1. Y1.\nG0 X2. Y3.\nG2 X4. R1. F9.\nG3 X6. I1.\n"
     "G50\nG51 I1. J1. K2.\nG17 G2 X8. I1.\nG18 G2 X9. I.5 K0\n",
     "!2:1 layout-on G 51/0; 3 rapid X2000; 4 rapid X1000000;"
     " !5:0 number-range X 1000001/1000000; 8 rapid X0.001; !10:11 number-range P 0.0009/1000;"
     " 12 rapid X-1 Y-3; 13 arc X-5 G17 about -3 -3 by -180 F9;"
     " 14 arc X-9 G17 about -7 -3 by 180; !17:5 arc-radius 16/1; !18:5 layout-on"},
    {"G17 G0 X3. Y4.\nG16\nY0\nX10.\nG15\nG18 G0 Z0 X5.\nG16\nZ10.\nG15\nG19 G0 Y0 Z2.\nG16\n"
     "Y1.\nG15\n",
     "1 rapid X3 Y4; 3 rapid X5 Y0; 4 rapid X10; 6 rapid X5; 8 rapid X10; 10 rapid Z2;"
     " 12 rapid Z1"},
    {"G17 G0 X10. Y0\nG68 R90.\nX20.\nG69\nG51 P2.\nX20. Y0\nG50\nG51.1 X15.\nX10.\nG50.1\n",
     "1 rapid X10; 3 rapid Y10; 6 rapid X30 Y-10; 9 rapid X20"},
    {"G68 X0 Y0 R45. G0 X10. Y0\nG68 X0 Y0 R90. G69\nG69 G0 X1. Y0\nG51 X0 Y0 P2. G69 X1.\n"
     "G50 G51 X0 P2.\nG16 G51.1 X1. X2.\nG51.1 X1. G68 X0 Y0 R9.\nG28 G69\nG54 G50\nG18 G15\n"
     "G50 G69 G15 G54 X1. Y1.\n",
     "!1:19 word-twice X; !2:16 modal-group G 69/0; 3 rapid X1; !4:19 word-twice X;"
     " !5:5 modal-group G 51/0; !6:15 word-twice X; !7:11 modal-group G 68/0; 8 rapid;"
     " 8 rapid X0; 11 rapid X1 Y1"},
    {"G68 X0 Y0 R90.\nG28\nG92 X1.\nG54\nG53 X1.\nG18\nG10 L2 P1 X1.\nG52 X1.\nG30\nG69 G54\n"
     "G51 X0 Y0 P2.\nG18\nG54\nG17\nG50 G54\nG16\nG19\nG52 X1.\nG15\n",
     "!2:1 layout-on G 28/0; !3:1 layout-on G 92/0; !4:1 layout-on G 54/0;"
     " !5:1 layout-on G 53/0; !6:1 layout-on G 18/0; !7:1 layout-on G 10/0;"
     " !8:1 layout-on G 52/0; !9:1 layout-on G 30/0; !13:1 layout-on G 54/0;"
     " !17:1 layout-on G 19/0; !18:1 layout-on G 52/0"},
    {"G51 Z0 P2.\nG81 X1. Y1. Z-1. R1. F9.\nG51.1 X3.\nG50\nG51.1 Z1.\nG81 X1. Y1. Z-1. R1.\n"
     "G50.1\nG51.1 X3.\nG81 X1. Y1. Z-1. R1.\nG91 X1. K2\nG90 G80 G50.1\n"
     "G16 G81 X10. Y0 Z-1. R1.\nG91 Y30. K1001\nY10. X5. K2\nY10. K2\nG90 G80 G15\n",
     "!2:0 layout-on Z; !3:1 layout-on G 51.1/0; !6:0 layout-on Z; 9 rapid~ Z1; 9 rapid~ X5 Y1;"
     " 9 line~ Z-1 F9; 9 rapid~ Z1; 10 rapid~ X4; 10 line~ Z-1; 10 rapid~ Z1; 10 rapid~ X3;"
     " 10 line~ Z-1; 10 rapid~ Z1; 12 rapid~ X10 Y0; 12 line~ Z-1; 12 rapid~ Z1;"
     " !13:10 number-range K 1001/1000; !14:10 number-range K 2/1000;"
     " 15 rapid~ X13.213938 Y3.830222; 15 line~ Z-1; 15 rapid~ Z1; 15 rapid~ X12.5 Y4.330127;"
     " 15 line~ Z-1; 15 rapid~ Z1"},
    {"G51 X0 Y0 I2. J2.\nG41 D1\nG50\nG68 X0 Y0 R90. G1 X1. F9.\nG33 Z1. F1.\nG90.1\n"
     "G3 X0 Y1. I0 J0\nG69\n",
     "?2:5 assumed-length D 1/0; !3:1 comp-on G 0.4/0; !4:19 word-twice X; !5:1 unsupported G"
     " 33/0; !6:1 other-base G 90.1/1; !8:1 comp-on G 6.4/0"},
};

static void a_place_is_mapped_from_where_it_stands(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, layouts2_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, powers_and_angles_are_what_they_are);
    CHECK_RUN(&check, numbers_of_fanucs_are_bits);
    CHECK_RUN(&check, a_place_is_mapped_from_where_it_stands);
    return check_end(&check);
}
