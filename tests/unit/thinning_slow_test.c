/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A tenth of the random runs of verify/rheology_test, one level coarser. */
#include "support/test.h"
#include "support/thinning.h"

TEST(random_runs_go_through)
{
    test_thinning_survey(20261122, 20, 6);
}
