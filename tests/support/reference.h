/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What the solutions are held against.
 *
 * exact_*: the exact solution of the discrete equations and, for the smooth
 * contacts, grid-converged values, by an independent Newton solver with dense
 * matrices and no multigrid (reference.json of the project's shared truth).
 * printed_*: Tables 1 and 2 of Venner, ten Napel & Bosma, Advanced Multilevel
 * Solution of the EHL Line Contact Problem, ASME J. of Tribology 1990.
 */
#ifndef TESTS_SUPPORT_REFERENCE_H
#define TESTS_SUPPORT_REFERENCE_H

typedef struct exact_table2 {
    double H_m, P_s, H_cen, H0;
} exact_table2;

enum { EXACT_FIRST = 6, EXACT_LAST = 14 };

/* M = 20, L = 10 on [-4, 1.5]; order of the wedge, then level. */
static const exact_table2 exact_table2_of[2][EXACT_LAST - EXACT_FIRST + 1] = {
    {
        {0.0749790421, 0.684396749, 0.0864699107, -0.5026444940},
        {0.0743185275, 0.720342837, 0.0853885840, -0.5036407649},
        {0.0739691113, 0.755890032, 0.0848064453, -0.5041840466},
        {0.0737776065, 0.800177944, 0.0845050155, -0.5044675508},
        {0.0736767550, 0.828927855, 0.0843517109, -0.5046124195},
        {0.0736256218, 0.853498668, 0.0842744105, -0.5046856887},
        {0.0735995277, 0.868724473, 0.0842355978, -0.5047225609},
        {0.0735863501, 0.877860929, 0.0842161507, -0.5047410637},
        {0.0735797175, 0.883232766, 0.0842064169, -0.5047503335},
    },
    {
        {0.0731816529, 0.656777266, 0.0838598945, -0.5051193803},
        {0.0734584284, 0.717890629, 0.0841121786, -0.5048557941},
        {0.0735319574, 0.756037685, 0.0841754872, -0.5047859509},
        {0.0735604667, 0.816235613, 0.0841913621, -0.5047669307},
        {0.0735689914, 0.845555032, 0.0841953435, -0.5047616387},
        {0.0735719214, 0.865382451, 0.0841963421, -0.5047601680},
        {0.0735727167, 0.879816158, 0.0841965925, -0.5047597618},
        {0.0735729638, 0.885972793, 0.0841966553, -0.5047596540},
        {0.0735730290, 0.888022025, 0.0841966710, -0.5047596262},
    },
};

/* Table 2, levels 6..14. */
static const double printed_H_m[] = {0.0750, 0.0744, 0.0741, 0.0739, 0.0738,
                                     0.0737, 0.0737, 0.0737, 0.0737};
static const double printed_P_s[] = {0.677, 0.710, 0.758, 0.787, 0.825,
                                     0.850, 0.867, 0.875, 0.879};

/* Table 1, levels 5..14, seconds on an HP 9000/800. */
static const double printed_2V[] = {12,  24,  48,   98,   197,
                                    398, 800, 1610, 3780, 7680};
static const double printed_2W[] = {25,   58,   138,  318,   704,
                                    1665, 3510, 7440, 18240, 38700};

/* Second-order wedge, [-4, 1.5]. */
typedef struct exact_steady {
    double M, L, H_min, H_cen;
} exact_steady;

static const exact_steady exact_steady_of[] = {
    {5, 2.5, 0.18557672, 0.23338661},   {10, 2.5, 0.08266978, 0.10258260},
    {20, 2.5, 0.03696054, 0.04511406},  {50, 2.5, 0.01278928, 0.01520219},
    {100, 2.5, 0.00573738, 0.00667239}, {200, 2.5, 0.00257565, 0.00293136},
    {5, 10, 0.34083378, 0.40248640},    {10, 10, 0.15907887, 0.18512227},
    {20, 10, 0.07357310, 0.08419668},   {50, 10, 0.02633728, 0.02951638},
    {100, 10, 0.01206332, 0.01333993},  {200, 10, 0.00551426, 0.00603232},
};

static inline const exact_table2 *exact_row(int order, int level)
{
    return level >= EXACT_FIRST && level <= EXACT_LAST
               ? &exact_table2_of[order - 1][level - EXACT_FIRST]
               : (const exact_table2 *)0;
}

#endif
