// SPDX-License-Identifier: MIT
// Room 1: corners between lines and arcs of every sense, calls, contours that are refused.
#include "told_check.h"

static told_t self;

static const told_row_t fillets_rows[] = {
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG1 Y10.\n",
     "1 rapid; 2 line X8 F9; 2 arc X10 Y2 G17 about 8 2 by 90; 3 line Y10"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG1 Y-10.\n",
     "1 rapid; 2 line X8 F9; 2 arc X10 Y-2 G17 about 8 -2 by -90; 3 line Y-10"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid; 2 line X8.16784 F9; 2 arc X10.139867 Y1.666667 G17 about 8.16784 2 by 80.406;"
     " 3 arc X20 Y10 G17 about 20 0 by -80.4059"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid; 2 line X7.745967 F9; 2 arc X9.682458 Y2.5 G17 about 7.74597 2 by 104.4775;"
     " 3 arc X0 Y10 G17 about 0 0 by 75.5225"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid; 2 line X7.745967 F9; 2 arc X9.682458 Y-2.5 G17 about 7.74597 -2 by -104.4775;"
     " 3 arc X0 Y-10 G17 about 0 0 by -75.5225"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid; 2 line X8.16784 F9; 2 arc X10.139867 Y-1.666667 G17 about 8.16784 -2 by -80.406;"
     " 3 arc X20 Y-10 G17 about 20 0 by 80.4059"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG1 X17. Y7.\n",
     "1 rapid; 2 line X9.171573 F9; 2 arc X10.585786 Y0.585786 G17 about 9.17157 2 by 45;"
     " 3 line X17 Y7"},
    {"G0 X0 Y0\nG1 X10. ,R2. F9.\nG1 X5. Y5.\n",
     "1 rapid; 2 line X5.171573 F9; 2 arc X6.585786 Y3.414214 G17 about 5.17157 2 by 135;"
     " 3 line X5 Y5"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG1 Y10.\n",
     "1 rapid Y-10; 2 arc X8.333333 Y-0.139867 G17 about 10 -10 by -80.4059 F9;"
     " 2 arc X10 Y1.83216 G17 about 8 1.83216 by 80.406; 3 line Y10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG1 Y-10.\n",
     "1 rapid Y-10; 2 arc X7.5 Y-0.317542 G17 about 10 -10 by -75.5225 F9;"
     " 2 arc X10 Y-2.254033 G17 about 8 -2.25403 by -104.4775; 3 line Y-10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y-10; 2 arc X8.453621 Y-0.120288 G17 about 10 -10 by -81.1042 F9;"
     " 2 arc X10.120288 Y1.546379 G17 about 8.14435 1.85565 by 72.2084;"
     " 3 arc X20 Y10 G17 about 20 0 by -81.1042"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y-10; 2 arc X8.163193 Y-0.17014 G17 about 10 -10 by -79.4158 F9;"
     " 2 arc X9.744789 Y2.244789 G17 about 7.79583 1.79583 by 92.388;"
     " 3 arc X0 Y10 G17 about 0 0 by 77.0278"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X7.057189 Y-0.442811 G17 about 10 -10 by -72.8856 F9;"
     " 2 arc X9.557189 Y-2.942811 G17 about 7.64575 -2.35425 by -124.2289;"
     " 3 arc X0 Y-10 G17 about 0 0 by -72.8856"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X7.755211 Y-0.255211 G17 about 10 -10 by -77.0278 F9;"
     " 2 arc X10.17014 Y-1.836807 G17 about 8.20417 -2.20417 by -92.388;"
     " 3 arc X20 Y-10 G17 about 20 0 by 79.4158"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG1 X17. Y7.\n",
     "1 rapid Y-10; 2 arc X9.283977 Y-0.025667 G17 about 10 -10 by -85.894 F9;"
     " 2 arc X10.554986 Y0.554986 G17 about 9.14077 1.9692 by 40.894; 3 line X17 Y7"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R2. F9.\nG1 X5. Y5.\n",
     "1 rapid Y-10; 2 arc X6.579495 Y-0.603184 G17 about 10 -10 by -69.9981 F9;"
     " 2 arc X7.309608 Y2.690392 G17 about 5.89539 1.27618 by 114.9981; 3 line X5 Y5"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG1 Y10.\n",
     "1 rapid Y10; 2 arc X7.5 Y0.317542 G17 about 10 10 by 75.5225 F9;"
     " 2 arc X10 Y2.254033 G17 about 8 2.25403 by 104.4775; 3 line Y10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG1 Y-10.\n",
     "1 rapid Y10; 2 arc X8.333333 Y0.139867 G17 about 10 10 by 80.4059 F9;"
     " 2 arc X10 Y-1.83216 G17 about 8 -1.83216 by -80.406; 3 line Y-10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y10; 2 arc X7.755211 Y0.255211 G17 about 10 10 by 77.0278 F9;"
     " 2 arc X10.17014 Y1.836807 G17 about 8.20417 2.20417 by 92.388;"
     " 3 arc X20 Y10 G17 about 20 0 by -79.4158"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y10; 2 arc X7.057189 Y0.442811 G17 about 10 10 by 72.8856 F9;"
     " 2 arc X9.557189 Y2.942811 G17 about 7.64575 2.35425 by 124.2289;"
     " 3 arc X0 Y10 G17 about 0 0 by 72.8856"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y10; 2 arc X8.163193 Y0.17014 G17 about 10 10 by 79.4158 F9;"
     " 2 arc X9.744789 Y-2.244789 G17 about 7.79583 -1.79583 by -92.388;"
     " 3 arc X0 Y-10 G17 about 0 0 by -77.0278"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y10; 2 arc X8.453621 Y0.120288 G17 about 10 10 by 81.1042 F9;"
     " 2 arc X10.120288 Y-1.546379 G17 about 8.14435 -1.85565 by -72.2084;"
     " 3 arc X20 Y-10 G17 about 20 0 by 81.1042"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG1 X17. Y7.\n",
     "1 rapid Y10; 2 arc X9.013267 Y0.048801 G17 about 10 10 by 84.3372 F9;"
     " 2 arc X10.624827 Y0.624827 G17 about 9.21061 2.03904 by 50.6628; 3 line X17 Y7"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R2. F9.\nG1 X5. Y5.\n",
     "1 rapid Y10; !2:18 corner R 2/0"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG1 Y10.\n",
     "1 rapid; 2 line X8 F9; 2 line X10 Y2; 3 line Y10"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG1 Y-10.\n",
     "1 rapid; 2 line X8 F9; 2 line X10 Y-2; 3 line Y-10"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid; 2 line X8 F9; 2 line X10.2 Y1.989975; 3 arc X20 Y10 G17 about 20 0 by -78.5217"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid; 2 line X8 F9; 2 line X9.8 Y1.989975; 3 arc X0 Y10 G17 about 0 0 by 78.5217"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid; 2 line X8 F9; 2 line X9.8 Y-1.989975; 3 arc X0 Y-10 G17 about 0 0 by -78.5217"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid; 2 line X8 F9; 2 line X10.2 Y-1.989975; 3 arc X20 Y-10 G17 about 20 0 by 78.5217"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG1 X17. Y7.\n",
     "1 rapid; 2 line X8 F9; 2 line X11.414214 Y1.414214; 3 line X17 Y7"},
    {"G0 X0 Y0\nG1 X10. ,C2. F9.\nG1 X5. Y5.\n",
     "1 rapid; 2 line X8 F9; 2 line X8.585786 Y1.414214; 3 line X5 Y5"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG1 Y10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9; 2 line X10 Y2;"
     " 3 line Y10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG1 Y-10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9; 2 line X10 Y-2;"
     " 3 line Y-10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X10.2 Y1.989975; 3 arc X20 Y10 G17 about 20 0 by -78.5217"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X9.8 Y1.989975; 3 arc X0 Y10 G17 about 0 0 by 78.5217"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X9.8 Y-1.989975; 3 arc X0 Y-10 G17 about 0 0 by -78.5217"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X10.2 Y-1.989975; 3 arc X20 Y-10 G17 about 20 0 by 78.5217"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG1 X17. Y7.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X11.414214 Y1.414214; 3 line X17 Y7"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,C2. F9.\nG1 X5. Y5.\n",
     "1 rapid Y-10; 2 arc X8.010025 Y-0.2 G17 about 10 -10 by -78.5217 F9;"
     " 2 line X8.585786 Y1.414214; 3 line X5 Y5"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG1 Y10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X10 Y2;"
     " 3 line Y10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG1 Y-10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X10 Y-2;"
     " 3 line Y-10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X10.2 Y1.989975;"
     " 3 arc X20 Y10 G17 about 20 0 by -78.5217"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X9.8 Y1.989975;"
     " 3 arc X0 Y10 G17 about 0 0 by 78.5217"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X9.8 Y-1.989975;"
     " 3 arc X0 Y-10 G17 about 0 0 by -78.5217"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9; 2 line X10.2 Y-1.989975;"
     " 3 arc X20 Y-10 G17 about 20 0 by 78.5217"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG1 X17. Y7.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9;"
     " 2 line X11.414214 Y1.414214; 3 line X17 Y7"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,C2. F9.\nG1 X5. Y5.\n",
     "1 rapid Y10; 2 arc X8.010025 Y0.2 G17 about 10 10 by 78.5217 F9;"
     " 2 line X8.585786 Y1.414214; 3 line X5 Y5"},
    {"G0 X0 Y0\nG1 X10. ,R.5 F9.\nG2 X20. Y10. R10.\n",
     "1 rapid; 2 line X9.511912 F9; 2 arc X10.011344 Y0.47619 G17 about 9.51191 0.5 by 87.2705;"
     " 3 arc X20 Y10 G17 about 20 0 by -87.2706"},
    {"G0 X0 Y0\nG1 X10. ,R.5 F9.\nG3 X0 Y10. R10.\n",
     "1 rapid; 2 line X9.486833 F9; 2 arc X9.98614 Y0.526316 G17 about 9.48683 0.5 by 93.017;"
     " 3 arc X0 Y10 G17 about 0 0 by 86.983"},
    {"G0 X0 Y0\nG1 X10. ,R.5 F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid; 2 line X9.486833 F9;"
     " 2 arc X9.98614 Y-0.526316 G17 about 9.48683 -0.5 by -93.017;"
     " 3 arc X0 Y-10 G17 about 0 0 by -86.983"},
    {"G0 X0 Y0\nG1 X10. ,R.5 F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid; 2 line X9.511912 F9;"
     " 2 arc X10.011344 Y-0.47619 G17 about 9.51191 -0.5 by -87.2705;"
     " 3 arc X20 Y-10 G17 about 20 0 by 87.2706"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG1 Y10.\n",
     "1 rapid Y-10; 2 arc X9.52381 Y-0.011344 G17 about 10 -10 by -87.2706 F9;"
     " 2 arc X10 Y0.488088 G17 about 9.5 0.48809 by 87.2705; 3 line Y10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG1 Y-10.\n",
     "1 rapid Y-10; 2 arc X9.473684 Y-0.01386 G17 about 10 -10 by -86.983 F9;"
     " 2 arc X10 Y-0.513167 G17 about 9.5 -0.51317 by -93.017; 3 line Y-10"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y-10; 2 arc X9.534643 Y-0.010834 G17 about 10 -10 by -87.3327 F9;"
     " 2 arc X10.010834 Y0.465357 G17 about 9.51138 0.48862 by 84.6655;"
     " 3 arc X20 Y10 G17 about 20 0 by -87.3327"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y-10; 2 arc X9.51189 Y-0.01192 G17 about 10 -10 by -87.2022 F9;"
     " 2 arc X9.986826 Y0.513141 G17 about 9.48748 0.48748 by 90.1435;"
     " 3 arc X0 Y10 G17 about 0 0 by 87.0586"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X9.459042 Y-0.014643 G17 about 10 -10 by -86.899 F9;"
     " 2 arc X9.985357 Y-0.540958 G17 about 9.48609 -0.51391 by -96.2019;"
     " 3 arc X0 Y-10 G17 about 0 0 by -86.899"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y-10; 2 arc X9.486859 Y-0.013174 G17 about 10 -10 by -87.0586 F9;"
     " 2 arc X10.01192 Y-0.48811 G17 about 9.51252 -0.51252 by -90.1435;"
     " 3 arc X20 Y-10 G17 about 20 0 by 87.2022"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG1 X17. Y7.\n",
     "1 rapid Y-10; 2 arc X9.800771 Y-0.001985 G17 about 10 -10 by -88.8584 F9;"
     " 2 arc X10.144363 Y0.144363 G17 about 9.79081 0.49792 by 43.8585; 3 line X17 Y7"},
    {"G0 X0 Y-10.\nG2 X10. Y0 R10. ,R.5 F9.\nG1 X5. Y5.\n",
     "1 rapid Y-10; 2 arc X8.909961 Y-0.059587 G17 about 10 -10 by -83.7421 F9;"
     " 2 arc X9.209013 Y0.790987 G17 about 8.85546 0.43743 by 128.7421; 3 line X5 Y5"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG1 Y10.\n",
     "1 rapid Y10; 2 arc X9.473684 Y0.01386 G17 about 10 10 by 86.983 F9;"
     " 2 arc X10 Y0.513167 G17 about 9.5 0.51317 by 93.017; 3 line Y10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG1 Y-10.\n",
     "1 rapid Y10; 2 arc X9.52381 Y0.011344 G17 about 10 10 by 87.2706 F9;"
     " 2 arc X10 Y-0.488088 G17 about 9.5 -0.48809 by -87.2705; 3 line Y-10"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG2 X20. Y10. R10.\n",
     "1 rapid Y10; 2 arc X9.486859 Y0.013174 G17 about 10 10 by 87.0586 F9;"
     " 2 arc X10.01192 Y0.48811 G17 about 9.51252 0.51252 by 90.1435;"
     " 3 arc X20 Y10 G17 about 20 0 by -87.2022"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG3 X0 Y10. R10.\n",
     "1 rapid Y10; 2 arc X9.459042 Y0.014643 G17 about 10 10 by 86.899 F9;"
     " 2 arc X9.985357 Y0.540958 G17 about 9.48609 0.51391 by 96.2019;"
     " 3 arc X0 Y10 G17 about 0 0 by 86.899"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG2 X0 Y-10. R10.\n",
     "1 rapid Y10; 2 arc X9.51189 Y0.01192 G17 about 10 10 by 87.2022 F9;"
     " 2 arc X9.986826 Y-0.513141 G17 about 9.48748 -0.48748 by -90.1435;"
     " 3 arc X0 Y-10 G17 about 0 0 by -87.0586"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG3 X20. Y-10. R10.\n",
     "1 rapid Y10; 2 arc X9.534643 Y0.010834 G17 about 10 10 by 87.3327 F9;"
     " 2 arc X10.010834 Y-0.465357 G17 about 9.51138 -0.48862 by -84.6655;"
     " 3 arc X20 Y-10 G17 about 20 0 by 87.3327"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG1 X17. Y7.\n",
     "1 rapid Y10; 2 arc X9.784319 Y0.002326 G17 about 10 10 by 88.7641 F9;"
     " 2 arc X10.148656 Y0.148656 G17 about 9.7951 0.50221 by 46.2358; 3 line X17 Y7"},
    {"G0 X0 Y10.\nG3 X10. Y0 R10. ,R.5 F9.\nG1 X5. Y5.\n",
     "1 rapid Y10; 2 arc X8.635884 Y0.093478 G17 about 10 10 by 82.1597 F9;"
     " 2 arc X9.057643 Y0.942357 G17 about 8.70409 0.5888 by 142.8402; 3 line X5 Y5"},
};

static void a_corner_fits_between_lines_and_arcs(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, fillets_rows);
}

static const told_row_t call2_rows[] = {
    {"M98 P19998\nM98 P39998 L2\nM30\nO9998\nG91 G0 X1.\nM99\n",
     "5 rapid X1; 5 rapid X2; 5 rapid X3; 5 rapid X4; 5 rapid X5; 5 rapid X6; 5 rapid X7;"
     " 3 end M30"},
    {"G0 X100. ,R1. F9.\nG1 X1. ,R1.\nG0 Y5.\n",
     "!1:11 corner R 1/0; !2:9 corner R 1/0"},
    {"F9. G1 X10. ,R1.\nS5 Y10. M3 M8 M7\n",
     "1 line X9 F9; 1 arc X10 Y1 G17 about 9 1 by 90; 2 out S5; 2 out M3 S5; 2 out M7;"
     " 2 out M8; 2 line Y10"},
    {"G1 X10. F9.\nG3 X10. Y10. R5. ,R1.\nG1 X0 S9 M4 F8.\n",
     "1 line X10 F9; !2:19 corner R 1/0"},
    {"G17 G41 D1\nG10 L10 P1 R5.\nG49 H1\nG43 H0\nG43.1 Z1.\nG40 D1\nG42 G41\n",
     "?1:9 assumed-length D 1/0; !2:1 comp-on G 10/0; !3:5 word-unused H; !4:1 comp-on G 43/0;"
     " !5:1 unsupported G 43.1/0; !6:5 word-unused D; !7:5 modal-group G 41/0"},
};

static void calls_and_corners_have_their_words(check_t *check) {
    told_begin(&self, NCK_DIALECT_FANUC);
    TOLD(check, &self, call2_rows);
}

int main(void) {
    check_t check = {0};
    if (!TOLD_WHOLE) return 0;
    CHECK_RUN(&check, a_corner_fits_between_lines_and_arcs);
    CHECK_RUN(&check, calls_and_corners_have_their_words);
    return check_end(&check);
}
