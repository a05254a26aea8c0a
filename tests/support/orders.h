/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with order = auto: which of them are solved at fourth order.
 */
#ifndef TESTS_SUPPORT_ORDERS_H
#define TESTS_SUPPORT_ORDERS_H

#include <stdint.h>

/* `contacts` from a seed on, printed: M 5 to 1000 (logarithmic), L 0 to 15,
 * levels 7, 8 and 9 in turn, order = auto. If the mesh size is below 0.29
 * H^(2/3), the length of the inlet, no contact may fail or fall back to second
 * order. A coarser mesh may be refused with a message. */
void test_order_survey(uint64_t seed, int contacts);

/* Of Eyring films: M to 100, tau0 0.03 to 1 of ph b/R, SRR 0 to 1. */
void test_order_survey_eyring(uint64_t seed, int contacts);

#endif
