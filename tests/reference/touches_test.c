/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steady contacts with asperity contact (support/touches.h). */
#include "../support/test.h"
#include "../support/touches.h"

TEST(asperity_contact_keeps_a_film)
{
    test_touches_survey(33000, test_draws(10, 100));
}
