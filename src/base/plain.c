/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/plain.h"

locale_t ovr_plain_begin(void)
{
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    return plain ? uselocale(plain) : (locale_t)0;
}

void ovr_plain_end(locale_t before)
{
    if (before)
        freelocale(uselocale(before));
}
