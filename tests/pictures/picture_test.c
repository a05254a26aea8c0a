/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures: format and size of the files, data equal to the data of the result
 * file, and external text that remains text. */
#include "support/test.h"

#include <expat.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "overroll/pictures.h"
#include "support/made.h"

/* Contents of a title of unknown origin; each part would leave a file if
 * gnuplot or a shell executed it. */
static const char hostile[] =
    "a' ; system('touch stolen1') #`touch stolen2` @x %s %d \"$(touch "
    "stolen3)\" \\n\nset print 'stolen4'\n]]></text><script>alert(1)</script>"
    "{/=60 x}_{y}^2 & \xff\xc3 \x1b[31m";

static ovr_result *open_made(const char *path)
{
    ovr_error err;
    ovr_result *r = ovr_result_open(path, NULL, &err);
    if (!r)
        fail_msg("%s", err.message);
    return r;
}

static ovr_status draw(ovr_result *r, ovr_picture_options *o, ovr_error *err)
{
    *err = (ovr_error){0};
    return ovr_picture(&r, 1, o, NULL, err);
}

static void check_png(const char *path, unsigned width, unsigned height)
{
    size_t bytes;
    char *data = test_read(path, &bytes);
    const unsigned char *b = (const unsigned char *)data;
    assert_true(bytes > 1000);
    assert_memory_equal(data, "\x89PNG\r\n\x1a\n", 8);
    assert_int_equal(b[16] << 24 | b[17] << 16 | b[18] << 8 | b[19], width);
    assert_int_equal(b[20] << 24 | b[21] << 16 | b[22] << 8 | b[23], height);
    assert_memory_equal(data + bytes - 8, "IEND", 4);
    free(data);
}

/* Element names of a document, one after the other. */
static void XMLCALL note_element(void *data, const char *name,
                                 const char **attributes)
{
    (void)attributes;
    if (strcmp(name, "script") == 0)
        *(bool *)data = true;
}

static void check_svg(const char *path)
{
    size_t bytes;
    bool script = false;
    char *data = test_read(path, &bytes);
    XML_Parser parser = XML_ParserCreate(NULL);
    XML_SetUserData(parser, &script);
    XML_SetStartElementHandler(parser, note_element);
    if (XML_Parse(parser, data, (int)bytes, 1) != XML_STATUS_OK)
        fail_msg("%s: %s", path, XML_ErrorString(XML_GetErrorCode(parser)));
    assert_false(script);
    XML_ParserFree(parser);
    free(data);
}

TEST_IN_FOLDER(draws_every_kind)
{
    const char *path = test_path(*state, "made.h5");
    const char *picture = test_path(*state, "picture.png");
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *r;
    ovr_error err;
    test_make_result(path, NULL, true);
    r = open_made(path);
    o.path = picture;
    o.width = 640;
    o.height = 400;
    for (int kind = 0; kind < 8; kind++) {
        o.kind = (ovr_picture_kind)(kind % 4);
        o.units = kind < 4 ? OVR_AS_STORED : OVR_HERTZIAN;
        o.overlay = kind == 4;
        CHECK_OK(draw(r, &o, &err), &err);
        check_png(picture, 640, 400);
        unlink(picture);
    }
    ovr_result_close(r);
}

TEST_IN_FOLDER(draws_every_form)
{
    const char *path = test_path(*state, "made.h5");
    const char *svg = test_path(*state, "picture.svg");
    const char *pdf = test_path(*state, "picture.PDF");
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *r;
    ovr_error err;
    char *data;
    test_make_result(path, hostile, false);
    r = open_made(path);
    o.path = svg;
    CHECK_OK(draw(r, &o, &err), &err);
    check_svg(svg);
    o.path = pdf;
    CHECK_OK(draw(r, &o, &err), &err);
    data = test_read(pdf, NULL);
    assert_memory_equal(data, "%PDF", 4);
    free(data);
    o.path = test_path(*state, "picture.gif");
    CHECK_STATUS(draw(r, &o, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, ".png");
    ovr_result_close(r);
}

/* Runs in the folder, so that what a script may create lands there. */
TEST_IN_FOLDER(keeps_foreign_text_inert)
{
    static const char *const stolen[] = {"stolen1", "stolen2", "stolen3",
                                         "stolen4", "stolen5"};
    char *here = getcwd(NULL, 0);
    ovr_picture_options o = ovr_picture_options_default();
    const char *name = hostile;
    ovr_result *r;
    ovr_error err;
    assert_int_equal(chdir(*state), 0);
    test_make_result("made.h5", hostile, false);
    r = open_made("made.h5");
    o.names = &name;
    for (int kind = 0; kind < 4; kind++) {
        o.kind = (ovr_picture_kind)kind;
        o.force = true;
        o.script = "it's.gp";
        o.path = "|touch stolen5;'`touch stolen5`.svg";
        CHECK_OK(draw(r, &o, &err), &err);
        check_svg(o.path);
        unlink(o.path);
        assert_int_equal(system("gnuplot \"it's.gp\""), 0);
        check_svg(o.path);
    }
    for (int k = 0; k < 5; k++)
        assert_int_not_equal(access(stolen[k], F_OK), 0);
    o.path = "two\nlines.png";
    CHECK_STATUS(draw(r, &o, &err), OVR_BAD_INPUT, &err);
    ovr_result_close(r);
    assert_int_equal(chdir(here), 0);
    free(here);
}

/* Returns the rest of the line that begins with `start`. */
static const char *line_after(const char *text, const char *start)
{
    const char *at = strstr(text, start);
    assert_non_null(at);
    return strchr(at, '\n') + 1;
}

TEST_IN_FOLDER(writes_the_data_beside)
{
    const char *path = test_path(*state, "made.h5");
    const char *picture = test_path(*state, "p.png");
    const char *script = test_path(*state, "p.gp");
    ovr_picture_options o = ovr_picture_options_default();
    double x[TEST_MADE_NODES], P[TEST_MADE_NODES], T[] = {3};
    ovr_result *r;
    ovr_error err;
    char *data, *at;
    test_make_result(path, NULL, true);
    r = open_made(path);
    o.path = picture;
    o.script = script;
    o.units = OVR_HERTZIAN;
    o.times = T;
    o.time_count = 1;
    o.x_from = -4;
    CHECK_OK(draw(r, &o, &err), &err);
    CHECK_OK(ovr_result_x(r, OVR_HERTZIAN, x, &err), &err);
    CHECK_OK(ovr_result_snapshot(r, "pressure", 5, OVR_HERTZIAN, P, &err),
             &err);
    data = test_read(test_path(*state, "p.dat"), NULL);
    at = (char *)line_after(data, "# pressure");
    for (int i = 0; i < TEST_MADE_NODES; i++) {
        CHECK_NEAR(strtod(at, &at), x[i], 0);
        CHECK_NEAR(strtod(at, &at), P[i], 0);
    }
    free(data);
    ovr_result_close(r);
}

TEST_IN_FOLDER(refuses_clearly)
{
    const char *path = test_path(*state, "made.h5");
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *r;
    ovr_error err;
    test_make_result(path, NULL, false);
    r = open_made(path);
    o.path = test_path(*state, "exists.png");
    test_write_text(o.path, "precious");
    CHECK_STATUS(draw(r, &o, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "--force");
    o.path = test_path(*state, "no/folder.png");
    assert_int_not_equal(draw(r, &o, &err), OVR_OK);
    CHECK_ERROR(&err, err.status, "folder");
    o.path = test_path(*state, "si.png");
    o.units = OVR_SI;
    CHECK_STATUS(draw(r, &o, &err), OVR_BAD_INPUT, &err);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "scales");
    ovr_result_close(r);
}

/* Without gnuplot, which the test of every allocation would start each time. */
static ovr_status with_allocator(void *data, const ovr_allocator *allocator,
                                 ovr_error *err)
{
    ovr_picture_options o = ovr_picture_options_default();
    ovr_result *r = data;
    o.path = "x.png";
    for (int kind = 0; kind < 4; kind++) {
        ovr_error missing;
        ovr_status status;
        o.kind = (ovr_picture_kind)kind;
        status = ovr_picture(&r, 1, &o, allocator, &missing);
        if (status == OVR_NO_MEMORY) {
            *err = missing;
            return status;
        }
        CHECK_ERROR(&missing, OVR_BAD_INPUT, "apt install gnuplot-nox");
    }
    return OVR_OK;
}

TEST_IN_FOLDER(survives_failing_allocations)
{
    const char *path = test_path(*state, "made.h5");
    char *found = strdup(getenv("PATH"));
    ovr_result *r;
    test_make_result(path, NULL, false);
    r = open_made(path);
    setenv("PATH", "/nowhere", 1);
    test_every_allocation(with_allocator, r);
    setenv("PATH", found, 1);
    free(found);
    ovr_result_close(r);
}

/* The page is made without any other program. */
static ovr_status view_with(void *data, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_result *r = data;
    ovr_view_options o = {0};
    o.path = "view.html";
    o.force = true;
    return ovr_view(&r, 1, &o, allocator, err);
}

TEST_IN_FOLDER(page_survives_failing_allocations)
{
    char *here = getcwd(NULL, 0);
    ovr_result *r;
    assert_int_equal(chdir(*state), 0);
    test_make_result("made.h5", hostile, true);
    r = open_made("made.h5");
    test_every_allocation(view_with, r);
    assert_int_equal(access(".view.html.part", F_OK), -1);
    ovr_result_close(r);
    assert_int_equal(chdir(here), 0);
    free(here);
}

/* Frames without gnuplot end early, but not before most is allocated. */
static ovr_status frames_with(void *data, const ovr_allocator *allocator,
                              ovr_error *err)
{
    ovr_result *r = data;
    ovr_frames_options o = {0};
    ovr_picture_options look = ovr_picture_options_default();
    ovr_error missing;
    look.force = true;
    o.folder = "frames";
    o.look = &look;
    if (ovr_frames(&r, 1, &o, allocator, NULL, &missing) == OVR_NO_MEMORY) {
        *err = missing;
        return OVR_NO_MEMORY;
    }
    CHECK_ERROR(&missing, OVR_BAD_INPUT, "apt install gnuplot-nox");
    return OVR_OK;
}

TEST_IN_FOLDER(frames_survive_failing_allocations)
{
    char *here = getcwd(NULL, 0), *found = strdup(getenv("PATH"));
    ovr_result *r;
    assert_int_equal(chdir(*state), 0);
    test_make_result("made.h5", hostile, true);
    r = open_made("made.h5");
    setenv("PATH", "/nowhere", 1);
    test_every_allocation(frames_with, r);
    setenv("PATH", found, 1);
    ovr_result_close(r);
    assert_int_equal(chdir(here), 0);
    free(found);
    free(here);
}

static bool stop_at_five(void *data, size_t done, size_t count)
{
    *(size_t *)data = count;
    return done < 5;
}

/* Stopped, then resumed: each frame is drawn once. */
TEST_IN_FOLDER(frames_go_on)
{
    const char *path = test_path(*state, "made.h5");
    ovr_frames_options o = {0};
    ovr_picture_options look = ovr_picture_options_default();
    ovr_frames_made made;
    size_t count = 0;
    char *folder = strdup(test_path(*state, "frames"));
    ovr_result *r;
    ovr_error err;
    test_make_result(path, hostile, true);
    r = open_made(path);
    o.folder = folder; /* test_path's own would be reused */
    o.form = "svg";
    o.progress = stop_at_five;
    o.data = &count;
    assert_int_equal(ovr_frames(&r, 1, &o, NULL, &made, &err), OVR_STOPPED);
    assert_int_equal(count, TEST_MADE_SHOTS);
    assert_true(made.drawn >= 5);
    o.progress = NULL;
    CHECK_OK(ovr_frames(&r, 1, &o, NULL, &made, &err), &err);
    assert_true(made.kept >= 5); /* later ones may have been given up */
    assert_int_equal(made.kept + made.drawn, TEST_MADE_SHOTS);
    CHECK_OK(ovr_frames(&r, 1, &o, NULL, &made, &err), &err);
    assert_int_equal(made.kept, TEST_MADE_SHOTS);
    for (int k = 0; k < TEST_MADE_SHOTS; k++) {
        char name[40];
        snprintf(name, sizeof name, "frames/frame_%04d.svg", k);
        check_svg(test_path(*state, name));
    }
    look.H_to = 0.5;
    o.look = &look;
    assert_int_equal(ovr_frames(&r, 1, &o, NULL, &made, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "other settings");
    free(folder);
    ovr_result_close(r);
}

static int gnuplot_is_there(void **state)
{
    (void)state;
    return system("gnuplot --version >/dev/null 2>&1");
}

TEST_GROUP(gnuplot_is_there, NULL)
