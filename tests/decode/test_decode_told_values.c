// SPDX-License-Identifier: MIT
// Room 1: what expressions, parameters and O words come to.
#include "told_check.h"

static told_t self;

static const told_row_t expr_rows[] = {
    {"G0 X[1+2*3] Y[[1+2]*3] Z[-2**2]\nX[2**3**2] Y[7/2-1] Z[10-2-3]\n"
     "X[2*3**2] Y[16/4/2] Z[-[3]]\nX[7 MOD 3] Y[-7 MOD 3] Z[7 MOD -3]\n"
     "X[1 LT 2] Y[2 LE 2] Z[3 GT 4]\nX[2 GE 2] Y[2 EQ 2] Z[2 NE 2]\n"
     "X[1 AND 0] Y[1 OR 0] Z[1 XOR 1]\nX[2 AND 3] Y[0 OR 5] Z[0 XOR 7]\n"
     "X[1+1 EQ 2] Y[2 LT 1 OR 1] Z[1 OR 1 AND 0]\n"
     "X[1 EQ 1.00001] Y[1 EQ 1.001] Z[1 NE 1.00001]\nX[1 LT 1] Y[2 LE 1] Z[4 GT 3]\n"
     "X[1 GE 2] Y[1 GT 1] Z[2 LE 3]\n",
     "1 rapid X7 Y9 Z4; 2 rapid X64 Y2.5 Z5; 3 rapid X18 Y2 Z-3; 4 rapid X1 Z1; 5 rapid Y1 Z0;"
     " 6 rapid; 7 rapid X0; 8 rapid X1 Z1; 9 rapid Z0; 10 rapid Y0; 11 rapid X0 Z1; 12 rapid"},
    {"G0 XABS[-3] YSQRT[16] ZSIN[30]\nXCOS[60] YTAN[45] ZASIN[1]\n"
     "XACOS[0] YATAN[1]/[1] ZATAN[-1]/[-1]\nXATAN[0]/[-1] YATAN[1]/[0] ZEXP[0]\n"
     "XLN[1] YFIX[2.7] ZFIX[-2.7]\nXFUP[2.1] YFUP[-2.1] ZROUND[2.5]\n"
     "XROUND[-2.5] YROUND[2.4] ZACOS[-1]\nXSIN[-30] YCOS[420] ZASIN[-.5]\n"
     "X-SIN[30] Y-[2] Z+[3]\nXABS[SIN[-30]*4] YSQRT[ABS[-9]] ZEXP[LN[5]]\n"
     "XSIN[750] YCOS[-60] ZTAN[-45]\nXEXP[1] YLN[10] ZSQRT[2]\n",
     "1 rapid X3 Y4 Z0.5; 2 rapid X0.5 Y1 Z90; 3 rapid X90 Y45 Z-135; 4 rapid X180 Y90 Z1;"
     " 5 rapid X0 Y2 Z-3; 6 rapid X3 Y-2 Z3; 7 rapid X-3 Y2 Z180; 8 rapid X-0.5 Y0.5 Z-30;"
     " 9 rapid Y-2 Z3; 10 rapid X2 Y3 Z5; 11 rapid X0.5 Y0.5 Z-1;"
     " 12 rapid X2.718282 Y2.302585 Z1.414214"},
    {"#1=5 #2=[#1*2]\nG0 X#1 Y#2 Z-#1\n#1=7 X#1\nX#1\n##1=3\nX#7\n#[2+3]=1.5 Y#5\n"
     "Y#[2+3] Z##1\n#30=4 X[#30/#5]\n#<a>=3 #<_b c>=4\nX#<a> Y#<_bc> Z[#<A>*#<_b C>]\n"
     "X[EXISTS[#<a>]] Y[EXISTS[#<none>]] Z[EXISTS[#99]]\n#99=0\nZ[EXISTS[#99]]\nX#98 Y[#98+2]\n",
     "2 rapid X5 Z-5; 3 rapid; 4 rapid X7; 6 rapid X3; 7 rapid; 8 rapid Y1.5 Z3; 9 rapid X0;"
     " 11 rapid X3 Y4 Z12; 12 rapid X1 Y0 Z0; 14 rapid Z1; 15 rapid X0 Y2"},
    {"G0\nX[1/0]\nX[1 MOD 0]\nXSQRT[-1]\nXLN[0]\nXASIN[1.1]\nXACOS[-1.1]\nXTAN[90]\n"
     "X[[-2]**.5]\nX[0**-1]\nX[1e5]\nX[1+]\nX[+]\nX[1 2]\nX[1\nX1]\nX[\nX[]\nX[1 FOO 2]\n"
     "X FOO[1]\nX SIN 3\nX SIN[\nX ATAN[1]\nX ATAN[1]/2\nX#\nX#0\nX#-1\nX#5603\nX#1.5\n#0=1\n"
     "#1\n#1 5\n#=5\n#1=\n#<a\n#<a=5\nX#<q>\nX[EXISTS[5]]\nX[EXISTS #5]\nX[1 = 2]\nX[5 && 2]\n"
     "X BIN[5]\nX[POW[2,3]]\nX[EXP[1000]]\nX[1+[2*[3-[4/[5+[6]]]]]]\nX[-2**.5]\n"
     "X[-8**3] Y[2**-1]\n",
     "!2:6 value; !3:10 value; !4:10 value -1/0; !5:7 value; !6:11 value 1.1/0;"
     " !7:12 value -1.1/0; !8:1 number-range X 1e+15/1000000; !9:11 value -2/0; !10:8 value;"
     " !11:4 expression; !12:5 expression; !13:4 expression; 14 rapid X12; !15:4 expression;"
     " !16:3 character 93/0; !17:3 expression; !18:3 expression; !19:5 expression;"
     " !20:3 expression; !21:3 expression; !22:7 expression; !23:10 expression;"
     " !24:11 expression; !25:3 expression; 26 rapid X0; !27:5 number-range # -1/99999;"
     " !28:7 number-range # 5603/5601; !29:6 number-range # 1.5/99999;"
     " !30:2 number-range # 0/99999; !31:3 expression; !32:5 expression; !33:2 expression;"
     " !34:4 expression; !35:2 expression; !36:2 expression; !37:3 parameter-unset;"
     " !38:3 expression; !39:13 expression; !40:5 expression; !41:5 expression;"
     " !42:3 other-base 0/6; !43:3 other-base 0/6; 45 rapid X6.272727; !46:9 value -2/0;"
     " 47 rapid X-512 Y0.5"},
    {"#1=2\n#5399=1\n#5220=1\n#5221=1\nG0 X#5220 Y#5221\nG55 X#5220\nG10 L2 P2 X3 Z4\n"
     "X#5241 Y#5243\n#2000=1\nX#2000\nG54 X1 Y2 Z3\nX#5420 Y[#5421+1] Z#5422\nX#5420\n"
     "X[#<_x>+1] Y#<_y> Z#<_z>\nG20\nX#5420\nX[#<_metric>] Y[#<_imperial>] Z#<_absolute>\n"
     "G21 G91 X[#<_incremental>] Y[#<_metric>]\nG90 X#<_feed> Y#<_rpm>\nF50 S200 M3\n"
     "X#<_feed> Y#<_rpm> Z#<_spindle_on>\nX#<_spindle_cw> Y#<_mist> Z#<_flood>\nM7\n"
     "M8 X#<_mist> Y#<_flood>\nX#<_mist> Y#<_flood>\nT5 M6\n"
     "X#<_selected_tool> Y#<_current_tool>\nX#<_motion_mode> Y#<_plane> Z#<_ccomp>\n"
     "X#<_coord_system> Y#<_tool_offset> Z#<_retract_r_plane>\nX#<_line> Y#<_call_level>\n"
     "X#5400 Y#5403 Z#5161\nG28.1\nX#5161 Y#5162 Z#5163\nG92 X0\nX#5211 Y#5210\nX#5210 Y#5211\n",
     "!2:1 unsupported # 5399/0; !3:1 unsupported # 5220/0; !4:1 unsupported # 5221/0;"
     " 5 rapid X1; 6 rapid; 8 rapid X6 Y4; 10 rapid X4; 11 rapid X1 Y2 Z3; 12 rapid Y3;"
     " 13 rapid; 14 rapid X2; 16 rapid; 17 rapid X0 Y25.4 Z25.4; 18 rapid; 19 rapid Y0;"
     " 20 out S200; 20 out M3 S200; 21 rapid X50 Y200 Z1; !22:3 parameter-unset; 23 out M7;"
     " !24:6 parameter-unset; !25:3 parameter-unset; 26 out T5; 26 out M5 S0; 26 wait M6;"
     " 27 rapid X5 Y5; !28:31 parameter-unset; !29:21 parameter-unset; !30:3 parameter-unset;"
     " !31:15 unsupported # 5403/0; !33:8 unsupported # 5161/0; !35:8 unsupported # 5211/0;"
     " !36:8 unsupported # 5210/0"},
    {"G0 X[1 GT 0] Y[1 LT 0]\nX[3-5] Y[2*-3] Z[--2]\nX[1--1] Y[+3] Z[2+-+1]\n"
     "X[ 1 + 2 ] Y [ 3 ] Z# 5\nXaBs[-2] Y[1 eq 1] z[4 mOd 3]\nX[1.5*2.] Y[.5+.5] Z[00.5]\n"
     "X[2 EQ 2 EQ 1] Y[5 GT 3 GT 0]\nX[1 AND 1 OR 0] Y[0 AND 1 OR 1] Z[1 XOR 1 XOR 1]\n"
     "X[2*3+4*5] Y[2+3*4-5] Z[100/10*2]\nX[2 MOD 2*3] Y[7 MOD 4 MOD 2]\n"
     "X[ATAN[1]/[1]+1] Y[2*ATAN[2]/[2]]\nG#1 X1\nG[0+1] F[10*2] X#1\nM[2+1] S[100]\nN#1 X1\n",
     "1 rapid X1; 2 rapid X-2 Y-6 Z2; 3 rapid X2 Y3 Z1; 4 rapid X3 Z0; 5 rapid X2 Y1 Z1;"
     " 6 rapid X3 Z0.5; 7 rapid X1; 8 rapid Z1; 9 rapid X26 Y9 Z20; 10 rapid X0 Y1;"
     " 11 rapid X46 Y90; 12 rapid X1; 13 line X0 F20; 14 out S100; 14 out M3 S100; 15 line X1"},
    {"#1=1\n#2=#1 #1=#2\n#1=2 #2=#1 G0 X#1 Y#2\nX#1 Y#2\n#1=[#1+1] #2=[#1+1] X#1\nX#1 Y#2\n"
     "#1=1 #1=2\nX#1\n",
     "3 rapid Y1; 4 rapid X2 Y0; 5 rapid; 6 rapid X3 Y3; 8 rapid X2"},
};

static void an_expression_has_the_value_that_it_says(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, expr_rows);
}

static const told_row_t oword_rows[] = {
    {"o1 sub\nG0 X#1 Y#2\no1 endsub\no1 call [5] [6]\no1 call [7]\no1 call\nX99 Y99\n",
     "2 rapid X5 Y6; 2 rapid X7 Y0; 2 rapid X0; 7 rapid X99 Y99"},
    {"o<two> sub\n#3=[#1+#2]\no<two> return [#3*2]\no<two> endsub [9]\no<two> call [1] [2]\n"
     "G0 X#<_value> Y#<_value_returned>\no<three> sub\no<three> endsub [4]\no<three> call\n"
     "X#<_value> Y#<_value_returned>\no<four> sub\no<four> endsub\no<four> call\n"
     "X#<_value> Y#<_value_returned>\n",
     "6 rapid X6 Y1; 10 rapid X4; 14 rapid X0 Y0"},
    {"#1=0\no1 while [#1 LT 3]\n#1=[#1+1]\nG0 X#1\no1 endwhile\no2 do\n#1=[#1-1]\nX#1\n"
     "o2 while [#1 GT 0]\no3 repeat [2]\nX[#1+10]\n#1=[#1+1]\no3 endrepeat\n",
     "4 rapid X1; 4 rapid X2; 4 rapid X3; 8 rapid X2; 8 rapid X1; 8 rapid X0; 11 rapid X10;"
     " 11 rapid X11"},
    {"#1=2\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\no1 elseif [#1 EQ 2]\nG0 X22\n"
     "o1 else\nG0 X3\no1 endif\no2 if [0]\nG0 X5\no2 else\nG0 X6\no2 endif\no3 if [1]\nX7\n"
     "o3 else\nX8\no3 endif\no4 if [0]\nX9\no4 endif\nX10\n",
     "5 rapid X2; 14 rapid X6; 17 rapid X7; 24 rapid X10"},
    {"#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 GT 3]\n"
     "o1 break\no3 endif\nG0 X#1\no1 endwhile\nX9\n",
     "10 rapid X1; 10 rapid X3; 12 rapid X9"},
    {"o1 repeat [3]\no2 repeat [2]\nG91 G0 X1\no2 endrepeat\nY1\no1 endrepeat\nG90 X0\n",
     "3 rapid X1; 3 rapid X2; 5 rapid Y1; 3 rapid X3; 3 rapid X4; 5 rapid Y2; 3 rapid X5;"
     " 3 rapid X6; 5 rapid Y3; 7 rapid X0"},
    {"o1 sub\n#1=[#1-1]\nG0 X#1\no2 if [#1 GT 0]\no1 call [#1]\no2 endif\nY#1\no1 endsub\n"
     "o1 call [3]\n",
     "3 rapid X2; 3 rapid X1; 3 rapid X0; 7 rapid; 7 rapid Y1; 7 rapid Y2"},
    {"o1 repeat [0]\nX1\no1 endrepeat\no2 repeat [-1]\nX1\no2 endrepeat\no3 while [0]\nX1\n"
     "o3 endwhile\no4 repeat [1.5]\nG0 X1\no4 endrepeat\n",
     "11 rapid X1; 11 rapid"},
    {"o1 call\n",
     "!1:0 label-missing 1/0; ?1:0 called-from"},
    {"o1 sub\nG0 X1\n",
     "!1:0 flow 1/0"},
    {"o1 endsub\n",
     "!1:0 flow"},
    {"o1 endif\n",
     ""},
    {"o1 endwhile\n",
     "!1:0 flow"},
    {"o1 endrepeat\n",
     "!1:0 flow"},
    {"o1 else\n",
     "!1:0 flow 1/0"},
    {"o1 if [1]\nG0 X1\n",
     "2 rapid X1"},
    {"o1 while [1]\n",
     ""},
    {"o1 repeat [2]\nX1\n",
     "!2:1 no-motion X"},
    {"o1 break\n",
     "!1:0 flow"},
    {"o1 return\n",
     "!1:0 flow"},
    {"o1 sub\no1 sub\no1 endsub\n",
     ""},
    {"o1 if\nG0 X1\n",
     "!1:6 expression O; 2 rapid X1"},
    {"o1 while [1/0]\no1 endwhile\n",
     "!1:14 value; !2:0 flow"},
    {"o1 nonsense\n",
     "!1:1 unsupported O"},
    {"o1 sub\no1 endsub\n"
     "o1 call [1] [2] [3] [4] [5] [6] [7] [8] [9] [10] [11] [12] [13] [14] [15] [16] [17]"
     " [18] [19] [20] [21] [22] [23] [24] [25] [26] [27] [28] [29] [30]\nG0 X1\n"
     "o1 call [1] [2] [3] [4] [5] [6] [7] [8] [9] [10] [11] [12] [13] [14] [15] [16] [17]"
     " [18] [19] [20] [21] [22] [23] [24] [25] [26] [27] [28] [29] [30] [31]\n",
     "4 rapid X1; !5:150 expression O; ?5:0 called-from"},
    {"o1 sub\no1 call\no1 endsub\no1 call\n",
     "!2:0 call-depth 16/16; ?2:0 called-from; ?2:0 called-from; ?2:0 called-from;"
     " ?2:0 called-from; ?2:0 called-from; ?2:0 called-from; ?2:0 called-from;"
     " ?2:0 called-from; ?2:0 called-from; ?2:0 called-from; ?2:0 called-from;"
     " ?2:0 called-from; ?2:0 called-from; ?2:0 called-from; ?2:0 called-from; ?4:0 called-from"},
    {"O5 (name)\nG0 X1\nO<x y> sub\nX2\no <XY> endsub\nN5 o<xy> call\n/o<xy> call (remark)\n"
     "o<xy> call ; tail\nX3\n",
     "2 rapid X1; 4 rapid X2; 4 rapid; 4 rapid; 9 rapid X3"},
    {"M98 P7\nM2\nO7\nG0 X1\nM99\n",
     "4 rapid X1; 2 end M2"},
    {"#1=4\nG0 X9\nM98 P7\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; 7 rapid X5; 4 rapid Y5; 5 end M2"},
    {"#1=4\nG0 X9\nM98 P7 L2\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; 7 rapid X5; 7 rapid; 4 rapid Y5; 5 end M2"},
    {"#1=4\nG0 X9\nG65 P7 X1\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; !3:1 other-base G 65/6; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"#1=4\nG0 X9\nM97 P7\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; !3:1 other-base M 97/6; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"#1=4\nG0 X9\nM98\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; !3:1 word-missing P; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"#1=4\nG0 X9\nM98 P1.5\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; !3:5 number-range P 1.5/99999999; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"#1=4\nG0 X9\nM98 P7 L0\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"#1=4\nG0 X9\nM98 P7 L1.5\nY5\nM2\no7\nX[#1+1]\nM99\n",
     "2 rapid X9; !3:8 number-range L 1.5/1000000; 4 rapid Y5; ?6:0 after-end; 5 end M2"},
    {"G0 X1\nM99\nX2\n",
     "1 rapid X1; ?2:0 repeats; ?3:0 after-end; 2 end M30"},
    {"#1=5\nM70\nG20 G91 F10 G55\nM72\nG0 X#1\nM70\nG91\nM71\nM72\nX1\n",
     "?3:0 feed-units; 5 rapid X5; !9:1 flow M 72/0; 10 rapid X6"},
    {"o1 sub\nM73\nG91 G20\nS100 M3 M8\no1 endsub\no1 call\nG0 X1\nX1\n",
     "4 out S100; 4 out M3 S100; 4 out M8; 5 out M5 S0; 5 out M9; 7 rapid X1; 8 rapid"},
    {"M72\n",
     "!1:1 flow M 72/0"},
    {"S100 M3 M7\nM70\nS200 M4 M8 M9\nM72\n",
     "1 out S100; 1 out M3 S100; 1 out M7; !3:12 modal-group M 9/0"},
    {"S100 M3 M8\nM70\nM5 M9 S0\nM72\n",
     "1 out S100; 1 out M3 S100; 1 out M8; 3 out S0 S0; 3 out M5; 3 out M9; 4 out S100 S100;"
     " 4 out M3; 4 out M8"},
    {"S50 M4 M7 M8\nM70\nM5 M9 M7\nM72\n",
     "1 out S50; 1 out M4 S50; 1 out M7; 1 out M8; !3:4 modal-group M 9/0"},
    {"(abort, x)\nX1\n",
     "?1:1 abort (; 1 end M2"},
    {"(print, x)\n(debug, #1)\n(msg, hi)\n(log, x)\nG0 X1\n(nested (a) b)\n",
     "5 rapid X1; !6:9 comment ("},
};

static void o_words_lead_the_program(check_t *check) {
    told_begin(&self, NCK_DIALECT_LINUXCNC);
    TOLD(check, &self, oword_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, an_expression_has_the_value_that_it_says);
    CHECK_RUN(&check, o_words_lead_the_program);
    return check_end(&check);
}
