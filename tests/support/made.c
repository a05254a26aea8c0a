/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/made.h"

#include "results/results.h"
#include "support/dent.h"
#include "support/test.h"

void test_make_result(const char *path, const char *title, bool physical)
{
    ovr_contact contact = physical ? test_contact_physical()
                                   : test_contact_bare();
    ovr_write_options o = ovr_write_options_default();
    ovr_error err = {0};
    test_dent d;
    ovr_writer *w;
    test_dent_init(&d, TEST_MADE_NODES, 0.15);
    o.path = path;
    o.force = true;
    o.every_steps = 4;
    o.end = 6;
    o.title = title;
    o.case_text = "[contact]\nM = 20 # </script><b>`id`\n";
    w = ovr_writer_create(&o, &contact, d.n, d.X, NULL, &err);
    if (!w)
        fail_msg("%s", err.message);
    for (long k = 0; k <= 40; k++) {
        test_dent_move(&d, k);
        CHECK_OK(ovr_writer_record(w, &d.frame, &err), &err);
    }
    CHECK_OK(ovr_writer_close(w, OVR_RUN_COMPLETE, NULL, &err), &err);
    test_dent_free(&d);
}
