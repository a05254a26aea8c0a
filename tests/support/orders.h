/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Number of random contacts with order = auto that are solved at fourth order.
 */
#ifndef TESTS_SUPPORT_ORDERS_H
#define TESTS_SUPPORT_ORDERS_H

#include <stdint.h>

/* Solves and prints `contacts` random contacts from a seed on: M 5 to 1000
 * (logarithmic), L 0 to 15, levels 7, 8 and 9 in turn, order = auto. If the
 * mesh size is below 0.29 H^(2/3), no contact may fail or be solved at second
 * order. Coarser grids may be rejected with a message. */
void test_order_survey(uint64_t seed, int contacts);

/* Solves Eyring films with M up to 100, tau0 of 0.03 to 1 ph b/R, SRR 0 to 1.
 */
void test_order_survey_eyring(uint64_t seed, int contacts);

#endif
