/* SPDX-License-Identifier: GPL-3.0-or-later */
#define _POSIX_C_SOURCE 200809L
#include <locale.h>
#include <stdlib.h>

#include "support/test.h"

bool test_decimal_comma(void)
{
    const char *ours = getenv("TEST_LOCALES");
    if (ours)
        setenv("LOCPATH", ours, 1);
    return setlocale(LC_ALL, "de_DE.UTF-8") != NULL &&
           *localeconv()->decimal_point == ',';
}
