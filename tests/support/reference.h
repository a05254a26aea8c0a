/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables 1 and 2 of Venner, ten Napel & Bosma, Advanced Multilevel Solution of
 * the EHL Line Contact Problem, ASME J. of Tribology 1990, as printed, with the
 * exact values of reference/truth.h. */
#ifndef TESTS_SUPPORT_REFERENCE_H
#define TESTS_SUPPORT_REFERENCE_H

#include "reference/truth.h"

enum { EXACT_FIRST = 6, EXACT_LAST = 14 };

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

/* The row of a level for a wedge of order 1 or 2; NULL above level 14. */
static inline const truth_row *exact_row(int order, int level)
{
    if (level < EXACT_FIRST || level > EXACT_LAST)
        return NULL;
    return (order == 1 ? truth_wedge_1 : truth_wedge_2) + level - EXACT_FIRST;
}

#endif
