/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "overroll/text.h"

int ovr_utf8_sequence(const unsigned char *s)
{
    if (!s)
        return 0;
    int n = s[0] < 0x80 ? 1 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : 4;
    if (n > 1 && (s[0] < 0xc2 || s[0] > 0xf4))
        return 0;
    for (int i = 1; i < n; i++)
        if ((s[i] & 0xc0) != 0x80)
            return 0;
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f) ||
        (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f))
        return 0; /* overlong, surrogates, beyond U+10FFFF */
    return n;
}
