/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writes the artificial run of dent.h to a result file. */
#ifndef TESTS_SUPPORT_MADE_H
#define TESTS_SUPPORT_MADE_H

#include <stdbool.h>
#include <stddef.h>

enum { TEST_MADE_NODES = 225, TEST_MADE_SHOTS = 11 };

/* Writes eleven snapshots from T = 0 to 6. title = NULL: default title. */
void test_make_result(const char *path, const char *title, bool physical);

#endif
