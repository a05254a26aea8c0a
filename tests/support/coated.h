/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random contacts with layers, including soft thin ones: steady solutions, and
 * runs with dents compared with the same dents without layers. */
#ifndef OVR_TESTS_COATED_H
#define OVR_TESTS_COATED_H

void test_coated_steady(int contacts);
void test_coated_dents(int dents, int order);

#endif
