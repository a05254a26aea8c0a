/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>

#include "overroll/overroll.h"

int main(void)
{
    puts(OVERROLL_VERSION);
    return 0;
}
