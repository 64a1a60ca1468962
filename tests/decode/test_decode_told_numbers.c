// SPDX-License-Identifier: MIT
// Room 1: numbers to the last digit, and parameters from call to call.
#include "told_check.h"

static told_t self;

static const told_row_t numbers_rows[] = {
    {"G0 X1.0000005 Y1.0000015 Z-1.0000005\nX0.0000005 Y0.0000006 Z-0.0000015\n"
     "X1.00000050000000000000000000001 Y2.0000005000000000000000000000\n"
     "Z0.00000000000000000000000000009\nX000000000000000000000000012.5 Y1234.56789\n"
     "X100000000000000000 Y1\nX99999.999999 Y999999.9999994 Z1000000\nX1000000.0000004\n"
     "X1000000.0000006\nX-1000000.0000006\nX12345678901234567890\n"
     "X.000000000000000000000000001\nX 1 2 . 5 Y - 3 . 2 5\nX1. 5\nX1.2.3\nX1..2\nX.\nX..1\n"
     "X-.5 Y+.5\nX--1\nX1-\nX \nX123456.7890123456789\nY0.1234565 Z0.1234575\n"
     "X1.00000049999999999999 Y1.00000050000000000001\nX5.00000000000000000000000\n",
     "1 rapid X1 Y1.000002 Z-1; 2 rapid X0 Y0.000001 Z-0.000002; 3 rapid X1.000001 Y2;"
     " 4 rapid Z0; 5 rapid X12.5 Y1234.56789; !6:1 number-range X 1e+17/1000000;"
     " 7 rapid X99999.999999 Y999999.999999 Z1000000; 8 rapid X1000000;"
     " !9:1 number-range X 1000000/1000000; !10:1 number-range X -1000000/1000000;"
     " !11:1 number-range X 1.23456789e+19/1000000; 12 rapid X0; 13 rapid X12.5 Y-3.25;"
     " 14 rapid X1.5; !15:5 number 46/0; !16:4 number 46/0; !17:1 number X; !18:1 number X;"
     " 19 rapid X-0.5 Y0.5; !20:1 number X; !21:3 number 45/0; !22:1 number X;"
     " 23 rapid X123456.789012; 24 rapid Y0.123456 Z0.123458; 25 rapid X1 Y1.000001;"
     " 26 rapid X5"},
    {"G20 G0 X1.00000001 Y.0000001 Z.00000005\nX.00000001 Y39370.0787401 Z-39370.0787402\n"
     "Y39370.0787402\nX0.00000002 Y0.0000000196850393700787401574803149606\n"
     "X0.00000001968503937007874015748031496063 Y.00000005905511811023622047244094488189\n"
     "X1.23456789012345678901234567890\nX-3.00000000000000000000000000000000000000000001\n",
     "1 rapid X25.4 Y0.000003 Z0.000001; !2:27 number-range Z -39370.0787/39370.0787;"
     " !3:1 number-range Y 39370.0787/39370.0787; 4 rapid X0.000001 Y0; 5 rapid Y0.000002;"
     " 6 rapid X31.358024; 7 rapid X-76.2"},
    {"F100.5 S1000.25 M3\nF0.00000000000000000000000000000000000001\nF99999999999\n"
     "F12345678901234567890123456789\nS1e5\n"
     "S12345678901234567890123456789012345678901234567890\nT1.0\nT2.50\nT1000000000\n"
     "T1000000001\nT99999999999999999999\nN99999999999999999999999 G0 X1\nG01.0 X2 F10\n"
     "G1.00 X3\nG001 X4\nM03\nM3.0\nM03.1\nG38.20\nG5.10\nG92.10 X1\nG 0 0 X5\nm 0 5\n"
     "g1.0001 X1\nG100000000000000000\nM1000000000000000000000\n",
     "1 out S1000.25; 1 out M3 S1000.25; !2:1 number-range F 1e-38/6e-05;"
     " !3:1 number-range F 1e+11/1e+09; !4:1 number-range F 1.23456789e+28/1e+09;"
     " !5:3 word-unknown E; !6:1 number-range S 1.23456789e+49/1e+09; 7 out T1;"
     " !8:1 number-range T 2.5/1e+09; 9 out T1e+09; !10:1 number-range T 1e+09/1e+09;"
     " !11:1 number-range T 1e+20/1e+09; 12 rapid X1; 13 line X2 F10; 14 line X3; 15 line X4;"
     " 16 out M3; 17 out M3; !18:1 m-unknown M 3.1/0; !19:1 unsupported G 38.2/0;"
     " !20:1 word-missing X 5.1/0; 22 rapid X5; 23 out M5 S0; !24:1 g-unknown G 1.0001/0;"
     " !25:1 g-unknown G 1e+17/0; !26:1 m-unknown M 1e+21/0"},
};

static void a_number_counts_to_its_last_digit(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, numbers_rows);
}

static const told_row_t kept_rows[] = {
    {"#<_global>=5 #<local>=3\no1 sub\nG0 X#<_global> Y[EXISTS[#<local>]]\n#<_global>=6\n"
     "#<local>=9\n#30=1 #31=2\no1 endsub\no1 call\nX#<_global> Y#<local> Z[#30+#31]\n",
     "3 rapid X5; 9 rapid X6 Y3 Z2"},
    {"o1 sub\no2 call [#1+1]\nY#1\no1 endsub\no2 sub\nG0 X#1\no2 return\nX99\no2 endsub\n"
     "o1 call [3]\no1 call [4]\n",
     "6 rapid X4; 3 rapid Y3; 6 rapid X5; 3 rapid Y4"},
    {"o1 sub\nG0 X1 Q9\no1 endsub\no1 call\nX2\n",
     "!2:7 word-unused Q; ?4:0 called-from"},
    {"o1 sub\no2 repeat [2]\no3 while [1]\no1 return [7]\no3 endwhile\no2 endrepeat\n"
     "o1 endsub\no1 call\no4 repeat [2]\nG91 G0 X#<_value>\no4 endrepeat\n",
     "10 rapid X7; 10 rapid X14"},
    {"#1=3\no1 do\n#1=[#1-1]\no2 if [#1 EQ 1]\no1 continue\no2 endif\nG0 X#1\n"
     "o1 while [#1 GT 0]\nY9\n",
     "7 rapid X2; 7 rapid X0; 9 rapid Y9"},
    {"#1=0\no1 repeat [5]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no2 if [#1 EQ 4]\n"
     "o1 break\no2 endif\nG0 X#1\no1 endrepeat\nY#1\n",
     "10 rapid X1; 10 rapid X3; 12 rapid Y4"},
    {"#1=0\no1 while [#1 LT 2]\n#1=[#1+1]\n#2=0\no2 while [#2 LT 2]\n#2=[#2+1]\n"
     "o3 if [#2 EQ 2]\no1 continue\no3 endif\nG0 X#1 Y#2\no2 endwhile\no1 endwhile\nZ1\n",
     "10 rapid X1 Y1; 10 rapid X2; 13 rapid Z1"},
    {"o1 if [1]\no2 if [0]\nG0 X1\no2 elseif [0]\nX2\no2 else\nG0 X3\no2 endif\no1 elseif [1]\n"
     "X4\no1 else\nX5\no1 endif\nY1\n",
     "7 rapid X3; 14 rapid Y1"},
    {"o1 repeat [1e10]\no1 repeat [2000000000]\no1 endrepeat\n",
     "!1:13 expression; !2:23 number-range O; !3:0 flow"},
    {"o1.5 sub\no[1+1] sub\nG0 X1\no2 endsub\no2 call\no-1 sub\no100000000000 call\no<a b\n"
     "o<ab> sub x\no<ab> endsub 5\n",
     "!1:1 unsupported O; !5:0 label-missing 2/0; ?5:0 called-from"},
    {"o1 call [1\no1 call [1] 2\n",
     "!1:11 expression; !2:13 expression O; ?2:0 called-from"},
    {"o1 if [1] X2\n",
     "!1:11 expression O"},
    {"o1 endif [1]\n",
     "!1:10 expression O"},
    {"#1=1 #2=2 #3=3\nG0 X#1 Y#2 Z#3\n#1 = 5 (remark)\n#2=[#1+#3] #3=[#1] ; tail\nX#1 Y#2 Z#3\n"
     "G0 #1=7 X#1 #1=8 Y#1\nX#1\n# 4 = 2 X# 4\n#[1+3]=3 X#4\nX##4\n#<x y>=1 #<XY>=[#<xy>+1]\n"
     "X#<xy>\n#5602=1\nX#5602\n#5601=1\n#5000=4 X#5000\n#4999.99999=2 X#5000\n#4999.9=2\n"
     "X[#<_coord_system>/10] Y[#<_plane>] Z[#<_task>]\nG59.1 X[#<_coord_system>]\n"
     "G91.1 G90.1 X[#<_ijk_absolute_mode>]\nX[#<_lathe_diameter_mode>]\n"
     "X[#<_motion_mode>] F5 G1\nX[#<_motion_mode>]\nG80\n#9=#<_motion_mode>\nG0 X#9\n"
     "X#5420 Y#5421 Z#5422\nX#5423\nX#5428\nX#5429\nX#5061 Y#5070\nX#5400 T3 M6\nX#5400\n"
     "X#5220\nX#5221 Y#5241 Z#5381\nG10 L2 P9 X1 Y2 Z3\nX#5381 Y#5382 Z#5383\nX#5390\nX#5401\n"
     "X#5001\n",
     "2 rapid X1 Y2 Z3; 5 rapid X5 Y8 Z5; 6 rapid Y5; 7 rapid X8; 8 rapid X0; 9 rapid X2;"
     " 10 rapid X5; !11:18 parameter-unset; !12:3 parameter-unset;"
     " !13:1 number-range # 5602/5601; !14:7 number-range # 5602/5601;"
     " !15:1 unsupported # 5601/0; 16 rapid X0; 17 rapid X4; !18:2 number-range # 4999.9/99999;"
     " 19 rapid X54 Y170 Z0; 20 rapid X540; !21:7 modal-group G 90.1/0; 22 rapid X0;"
     " 23 line F5; 24 line X10; 27 rapid X800; 28 rapid; 29 rapid X0; 30 rapid;"
     " !31:7 unsupported # 5429/0; 32 rapid Y0; 33 out T3; 33 out M5; 33 wait M6; 33 rapid;"
     " 34 rapid X3; 35 rapid X7; 36 rapid X0; 38 rapid X1 Y2 Z3; 39 rapid X0;"
     " !40:7 unsupported # 5401/0; !41:7 other-base # 5001/6"},
};

static void parameters_are_kept_as_long_as_they_say(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, kept_rows);
}

static const told_row_t fkept_rows[] = {
    {"G65 P1 A1. B2.\nM30\nO1\nG0 X#1 Y#2\nG65 P2 A[#1+5.]\nX#1\nM99\nO2\nX#1 Y[#2+1.]\n#1=9.\n"
     "M99\n",
     "4 rapid X1 Y2; 9 rapid X6 Y1; 6 rapid X1; 2 end M30"},
    {"G66 P1 A5.\nG0 X1.\nX2. Y2.\nG65 P2\nG67\nX3.\nG67\nM30\nO1\nZ#1\nM99\nO2\nX7.\nM99\n",
     "2 rapid X1; 10 rapid Z5; 3 rapid X2 Y2; 10 rapid; 13 rapid X7; 6 rapid X3; 8 end M30"},
    {"G66 P1 A5.\nG66 P2 A6.\nG0 X1.\nG67\nM30\nO1\nZ#1\nM99\nO2\nZ-#1\nM99\n",
     "3 rapid X1; 10 rapid Z-6; 5 end M30"},
    {"G66 P1 A2.\nG81 X1. Z-1. R1. F9.\nG80\nG67\nM30\nO1\nG0 Y#1\nM99\n",
     "2 rapid~ Z1; 2 rapid~ X1; 2 line~ Z-1 F9; 2 rapid~ Z1; 7 rapid Y2; 5 end M30"},
    {"M98 P31\nM98 P0031\nM98 P20001\nM98 P9999\nM30\nO1\nG91 G0 X1.\nM99\nO31\nG91 G0 Y1.\n"
     "M99\n",
     "10 rapid Y1; 10 rapid Y2; 7 rapid X1; 7 rapid X2; !4:0 label-missing 9999/0;"
     " ?4:0 called-from"},
    {"M98 P1 L3\nM98 P100001\nM30\nO1\nG91 G0 X1.\nM99\n",
     "5 rapid X1; 5 rapid X2; 5 rapid X3; 5 rapid X4; 5 rapid X5; 5 rapid X6; 5 rapid X7;"
     " 5 rapid X8; 5 rapid X9; 5 rapid X10; 5 rapid X11; 5 rapid X12; 5 rapid X13; 3 end M30"},
    {"M98 P1\nG0 X2.\nN5 X3.\nM30\nO1\nG0 X1.\nM99 P5\n",
     "6 rapid X1; 3 rapid X3; 4 end M30"},
    {"G65 P1 A1. I1. J2. K3. I4. J5. K6. I7.\nM30\nO1\nG0 X#4 Y#5 Z#6\nX#7 Y#8 Z#9\nX#10 Y#11\n"
     "M99\n",
     "4 rapid X1 Y2 Z3; 5 rapid X4 Y5 Z6; 6 rapid X7; 2 end M30"},
    {"G65 P1 I1. J1. K1. I2. J2. K2. I3. J3. K3. I4. J4. K4. I5. J5. K5. I6. J6. K6. I7. J7."
     " K7. I8. J8. K8. I9. J9. K9. I10. J10. K10.\nM30\nO1\nG0 X#4 Y#32 Z#33\nX#31 Y#30 Z#1\n"
     "M99\n",
     "4 rapid X1 Y10 Z10; 5 rapid X10 Y9; 2 end M30"},
    {"G65 P1 I1. J1. K1. I2. J2. K2. I3. J3. K3. I4. J4. K4. I5. J5. K5. I6. J6. K6. I7. J7."
     " K7. I8. J8. K8. I9. J9. K9. I10. J10. K10. I11.\nM30\nO1\nM99\n",
     "!1:131 word-twice I; ?3:0 after-end; 2 end M30"},
    {"G65 P1 A[1+1] B-2. C#0 D\nM30\nO1\nM99\n",
     "!1:24 number D; ?3:0 after-end; 2 end M30"},
    {"G65 P1 A[1+1] B-2. C#0 X#5\nM30\nO1\nG0 X#1 Y#2 Z[#3+#24+1.]\nM99\n",
     "4 rapid X2 Y-2 Z1; 2 end M30"},
    {"#100=5. #33=2. #34=1.\nG0 X#100 Y#33\n#500=3.\nX#500\n#99=1\nX#34\nX#999\nX#1000\n"
     "#3000=99\nX1.\n",
     "!1:16 unsupported # 34/0; 4 rapid X3; !5:1 unsupported # 99/0; !6:5 unsupported # 34/0;"
     " !8:7 unsupported # 1000/0; !9:0 alarm 99/0"},
    {"#5221=1. #5222=2. #5223=3.\nG0 X0 Y0 Z0\n#5241=10.\nG55 X0\n#5203=-1.\nZ0\n"
     "X#5221 Y#5201 Z#5203\nX#5241\n#5321=4.\nG59 X0\nX#5341\n#5224=1\n#5221=2000000.\n"
     "X#5401 Y#5500 Z#5501\nX#5021 Y#5022 Z#5023\nX#5041 Y#5003\nX#5004\nX#5024\nG20\n"
     "#5221=1.\nX0\nX#5221 Y#5021\nX[#4006-20.] Y[#4003-90.] Z[#4005-94.]\nG91 X[#4003-90.]\n"
     "G90 G81 X1. Z-1. R1. F9.\nX#4001\nG80 G0 X#4001\nS500 X[#4119/100.] F20. Y#4109\nT3\n"
     "X#4120\nX#5400\nX#4113\n",
     "2 rapid X1 Y2 Z3; 4 rapid X10; 6 rapid Z-1; 7 rapid X11 Y0 Z-2; 8 rapid X20; 10 rapid X4;"
     " !11:7 unsupported # 5341/0; !12:1 unsupported # 5224/0; !13:1 value # 5221/0;"
     " !14:21 unsupported # 5501/0; 15 rapid X8 Z-3; 16 rapid Y-2; !17:7 unsupported # 5004/0;"
     " !18:7 unsupported # 5024/0; 21 rapid X4; 22 rapid X29.4 Y4; 23 rapid X4 Y0 Z-1;"
     " 24 rapid; 25 rapid~ Z24.4; 25 rapid~ X29.4; 25 line~ Z-26.4 F228.6; 25 rapid~ Z24.4;"
     " !26:7 unsupported # 4001/0; !27:14 unsupported # 4001/0; 28 out S500;"
     " 28 rapid~ X4 Y228.6; 28 line~ Z-26.4 F508; 28 rapid~ Z24.4; 29 out T3; 30 rapid~ X80.2;"
     " 30 line~ Z-26.4; 30 rapid~ Z24.4; !31:7 unsupported # 5400/0; !32:7 unsupported # 4113/0"},
    {"IF [#1 EQ #0] THEN #1=3.\nG0 X#1\nIF [#1 NE #0] GOTO 5\nX9.\nN5 Y1.\nIF [#9] GOTO 6\n"
     "X2.\nN6 Y2.\nWHILE [#9] DO1\nX99.\nEND1\nWHILE [#1 GT 1.] DO1\nWHILE [#1 GT 2.] DO2\n"
     "#1=#1-1.\nX#1\nEND2\n#1=#1-1.\nEND1\nY#1\nDO2\nGOTO 7\nEND2\nN7 X7.\nIF[1]GOTO8\nX8.\n"
     "N8 X9.\n",
     "2 rapid X3; 5 rapid Y1; 7 rapid X2; 8 rapid Y2; 15 rapid; 19 rapid Y1; 23 rapid X7;"
     " 26 rapid X9"},
    {"WHILE [1] DO1\nEND2\n",
     "!2:0 flow"},
    {"WHILE [0] DO1\nG0 X1.\nEND1\nG0 X2.\n",
     "4 rapid X2"},
    {"IF [1 GT 0] THEN G0 X1.\nG0 X2.\nIF [0] THEN X5.\nX#1=5\n",
     "1 rapid X1; 2 rapid X2; !4:4 character 61/0"},
    {"G0 X#1 #1=2.\n#1=3. X#1\n#1=4. #2=#1\nX#1 Y#2\n#1=#1*2.\nX#1\n#1=-#1\nX#1\n"
     "#1=[2.+3.]*2.\nX#1\n#1=2.+3.*2.\nX#1\n#1=SIN[30.]+1.\nX#1\n#[1]=4.\nX#1\n##1=7.\nX#4\n"
     "X-#4\nX-[#4+1.]\nY[-#4]\n",
     "2 rapid X2; 4 rapid X4 Y3; 6 rapid X8; 8 rapid X-8; 10 rapid X10; 12 rapid X8;"
     " 14 rapid X1.5; 16 rapid X4; 18 rapid X7; 19 rapid X-7; 20 rapid X-8; 21 rapid Y-7"},
};

static void fanucs_macros_keep_theirs(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, fkept_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_number_counts_to_its_last_digit);
    CHECK_RUN(&check, parameters_are_kept_as_long_as_they_say);
    CHECK_RUN(&check, fanucs_macros_keep_theirs);
    return check_end(&check);
}
