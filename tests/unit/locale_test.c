/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program with a locale that has decimal commas gets the same files from the
 * library. */
#include "support/test.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"
#include "support/made.h"
#include "surface/profile.h"

static const char *const names[] = {"profile.csv", "page.html", "picture.gp",
                                    "picture.dat"};
enum { FILES = sizeof names / sizeof *names };

static void save_profile(const char *path)
{
    static const double x[] = {0, 0.5e-6, 1e-6}, z[] = {1e-7, -2.5e-7, 0};
    ovr_error err = {0};
    ovr_profile *p = ovr_profile_create(3, x, z, false, NULL, &err);
    assert_non_null(p);
    CHECK_OK(ovr_profile_save(p, path, &err), &err);
    ovr_profile_free(p);
}

static void save_pictures(const char *made, const char *page,
                          const char *picture, const char *script)
{
    ovr_error err = {0};
    ovr_result *r = ovr_result_open(made, NULL, &err);
    ovr_view_options view = {0};
    ovr_picture_options look = ovr_picture_options_default();
    assert_non_null(r);
    view.path = page;
    view.force = true;
    CHECK_OK(ovr_view(&r, 1, &view, NULL, &err), &err);
    look.path = picture;
    look.script = script;
    look.force = true;
    if (ovr_picture(&r, 1, &look, NULL, &err))
        fail_msg("%s", err.message);
    ovr_result_close(r);
}

static void write_all(const char *folder, char *content[])
{
    save_profile(test_path(folder, names[0]));
    save_pictures(test_path(folder, "made.h5"), test_path(folder, names[1]),
                  test_path(folder, "picture.png"),
                  test_path(folder, names[2]));
    for (int k = 0; k < FILES; k++)
        content[k] = test_read(test_path(folder, names[k]), NULL);
}

TEST_IN_FOLDER(files_have_points)
{
    char *plain[FILES], *comma[FILES], half[8];
    if (system("command -v gnuplot >/dev/null")) /* NOLINT(cert-env33-c) */
        skip();
    test_make_result(test_path(*state, "made.h5"), "1.5", true);
    write_all(*state, plain);
    if (!test_decimal_comma())
        skip();
    write_all(*state, comma);
    snprintf(half, sizeof half, "%.1f", 0.5);
    assert_string_equal(half, "0,5"); /* the program keeps its own */
    setlocale(LC_ALL, "C");
    for (int k = 0; k < FILES; k++) {
        if (strcmp(plain[k], comma[k]) != 0)
            fail_msg("%s is another in another locale", names[k]);
        assert_true(strlen(plain[k]) > 20);
        free(plain[k]);
        free(comma[k]);
    }
}
