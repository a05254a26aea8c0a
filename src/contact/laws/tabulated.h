/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A tabulated law (ovr_law_table), for a number type `num` (base/scalar.h):
 * cubics between the points of a uniform mesh h, with value and slope at each,
 *
 *     y = (1 - f) y_k + f y_{k+1} + f (1 - f) ((1 - f) d_k - f d_{k+1})
 *     d_k = h m_k - (y_{k+1} - y_k),  d_{k+1} = h m_{k+1} - (y_{k+1} - y_k)
 *
 * and linear beyond both ends, with the slope at the end.
 */
#ifndef OVR_CONTACT_LAWS_TABULATED_H
#define OVR_CONTACT_LAWS_TABULATED_H

#include "contact/laws/law_table.h"
#ifndef VEC /* or vector.h and power.h came before */
#include "base/scalar.h"
#endif

typedef struct tabulated {
    const double *value, *slope; /* y and h m at the points */
    double cells, per_P;         /* last point; ph/h */
    double scale;                /* factor of y */
} tabulated;

/* `scale` times the table, for P in units of `ph` Pa. */
static inline void tabulated_make(const ovr_law_table *table, double ph,
                                  double scale, tabulated *law)
{
    static const double none[2] = {0};
    *law = (tabulated){.value = none, .slope = none, .scale = scale};
    if (!table)
        return;
    law->value = table->value;
    law->slope = table->slope;
    law->cells = (double)table->cells;
    law->per_P = ph / table->mesh;
}

static inline num tabulated_at(const tabulated *law, num P, num *slope)
{
    num s = law->per_P * P;
    num inside = smaller(larger(s, all(0)), all(law->cells));
    cell k = whole_part(inside);
    num f = inside - from_whole(k), g = 1 - f;
    num y = gather(law->value, k), m = gather(law->slope, k);
    num y1 = gather(law->value + 1, k), m1 = gather(law->slope + 1, k);
    num rise = y1 - y, d = m - rise, d1 = m1 - rise;
    num along = fused(g, d, fused(-f, d1, all(0)));
    num steep = rise + (g - f) * along - f * g * (d + d1);
    *slope = law->scale * law->per_P * steep;
    return law->scale * (y + f * rise + f * g * along + (s - inside) * steep);
}

#endif
