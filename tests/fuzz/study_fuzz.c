/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: studies. A file with any text is read or rejected with a message
 * of one line, and all cases of an accepted study can be created. Inputs with a
 * slash are skipped, because they could name any file of this machine. */
#include "fuzz/folder.h"

#include "overroll/overroll.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static const char contact[] = "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 4\n"
                              "[feature d]\nshape = dent\ndepth = 0.1\n"
                              "width = 1\nstart = -4\n[time]\nend = 1\n";

static void make_case(const ovr_study *study, size_t k)
{
    ovr_error err = {0};
    char name[160] = "";
    ovr_study_name(study, k, name, sizeof name);
    fuzz_fail_unless(*name);
    ovr_case *c = ovr_study_case(study, k, &err);
    fuzz_fail_unless(c || fuzz_is_line(&err));
    ovr_case_free(c);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    ovr_error err = {0};
    if (!size || memchr(data, '/', size))
        return 0;
    fuzz_put("case.ini", contact, sizeof contact - 1);
    fuzz_put("study.ini", data, size);
    ovr_study *study = ovr_study_read("study.ini", NULL, &err);
    if (study) {
        size_t cases = ovr_study_cases(study);
        for (size_t k = 0; k < cases && k < 3; k++)
            make_case(study, k);
        if (cases > 3)
            make_case(study, cases - 1);
    } else {
        fuzz_fail_unless(fuzz_is_line(&err));
    }
    ovr_study_free(study);
    return 0;
}
