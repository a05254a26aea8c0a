/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "support/test.h"

#include <stdlib.h>
#include <string.h>

TEST(fills_status_and_message)
{
    ovr_error err = {OVR_OK, "old", .about = "key"};
    assert_int_equal(ovr_fail(&err, OVR_IO, "%s: %d", "disk", 7), OVR_IO);
    assert_int_equal(err.status, OVR_IO);
    assert_string_equal(err.message, "disk: 7");
    assert_null(err.about);
}

TEST(messages_name_their_object)
{
    ovr_error err = {0}, placed = {0};
    assert_int_equal(ovr_fail_about(&err, "depth", "depth = %d", -1),
                     OVR_BAD_INPUT);
    assert_string_equal(err.about, "depth");
    assert_int_equal(ovr_fail_from(&placed, &err, "dent.ini", 12),
                     OVR_BAD_INPUT);
    assert_string_equal(placed.message, "dent.ini:12: depth = -1");
    assert_string_equal(placed.about, "depth");
    ovr_fail_from(&err, &err, "--depth", 0); /* in place */
    assert_string_equal(err.message, "--depth: depth = -1");
    assert_int_equal(ovr_fail_from(NULL, &err, NULL, 0), OVR_BAD_INPUT);
    assert_int_equal(ovr_fail_about(NULL, "depth", "x"), OVR_BAD_INPUT);
}

/* What a program needs to go to the place, and to mend it. */
TEST(messages_contain_place_and_suggestion)
{
    ovr_error err, placed = {0};
    ovr_fail_at(&err, OVR_BAD_INPUT, "dent.ini", 12, "no 'Q'");
    assert_int_equal(ovr_fail_meant(&err, OVR_BAD_INPUT, "M"), OVR_BAD_INPUT);
    assert_int_equal(err.file, strlen("dent.ini"));
    assert_int_equal(err.line, 12);
    ovr_fail_from(&placed, &err, NULL, 0);
    assert_memory_equal(&placed, &err, sizeof err);
    ovr_fail_from(&placed, &err, "study.ini", 3); /* the outermost place */
    assert_string_equal(placed.message, "study.ini:3: dent.ini:12: no 'Q'");
    assert_int_equal(placed.file, strlen("study.ini"));
    assert_int_equal(placed.line, 3);
    assert_string_equal(placed.meant, "M");
    ovr_fail_at(&err, OVR_BAD_INPUT, "--set", 0, "x");
    assert_int_equal(err.file, strlen("--set"));
    assert_int_equal(err.line, 0);
    assert_null(err.meant);
    ovr_fail(&err, OVR_IO, "x");
    assert_int_equal(err.file, 0);
    assert_int_equal(ovr_fail_meant(NULL, OVR_IO, "M"), OVR_IO);
}

TEST(accepts_no_error_object)
{
    assert_int_equal(ovr_fail(NULL, OVR_BAD_INPUT, "%d", 1), OVR_BAD_INPUT);
    assert_int_equal(ovr_fail_at(NULL, OVR_STOPPED, "a.ini", 3, "x"),
                     OVR_STOPPED);
}

TEST(names_file_and_line)
{
    ovr_error err;
    assert_int_equal(
        ovr_fail_at(&err, OVR_BAD_INPUT, "dent.ini", 12, "key '%s'", "M"),
        OVR_BAD_INPUT);
    assert_string_equal(err.message, "dent.ini:12: key 'M'");
    ovr_fail_at(&err, OVR_BAD_INPUT, "dent.ini", 0, "empty");
    assert_string_equal(err.message, "dent.ini: empty");
    ovr_fail_at(&err, OVR_BAD_INPUT, "dent.ini", -1, "empty");
    assert_string_equal(err.message, "dent.ini: empty");
}

/* Too long a message is cut, whole or in the file name, never overrun: the
 * guard behind it stays. */
TEST(cuts_long_messages)
{
    struct {
        ovr_error err;
        char guard[8];
    } box;
    char text[3 * OVR_MESSAGE_SIZE];
    memset(text, 'x', sizeof text);
    text[sizeof text - 1] = '\0';
    memset(box.guard, 'g', sizeof box.guard);
    ovr_fail(&box.err, OVR_IO, "%s", text);
    assert_int_equal(strlen(box.err.message), OVR_MESSAGE_SIZE - 1);
    ovr_fail_at(&box.err, OVR_IO, text, 5, "lost");
    assert_int_equal(strlen(box.err.message), OVR_MESSAGE_SIZE - 1);
    ovr_fail_at(&box.err, OVR_IO, "short", 5, "%s", text);
    assert_int_equal(strlen(box.err.message), OVR_MESSAGE_SIZE - 1);
    assert_memory_equal(box.guard, "gggggggg", sizeof box.guard);
}

/* What a file says may hold anything: lines, escape sequences. */
TEST(is_one_line_without_controls)
{
    ovr_error err;
    ovr_fail(&err, OVR_IO, "unknown key '%s'", "a\nb\033[2Jc\177\xc2\x9b");
    assert_string_equal(err.message,
                        "unknown key 'a b\\x1b[2Jc\\x7f\\xc2\\x9b'");
    ovr_fail_at(&err, OVR_IO, "f\tile\n", 3, "no\r\xc3\xbc");
    assert_string_equal(err.message, "f\\x09ile\\x0a:3: no \xc3\xbc");
    assert_int_equal(err.file, strlen("f\\x09ile\\x0a"));
    char text[2 * OVR_MESSAGE_SIZE];
    memset(text, '\033', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    ovr_fail(&err, OVR_IO, "%s", text);
    assert_true(strlen(err.message) > OVR_MESSAGE_SIZE - 5);
    assert_null(strchr(err.message, '\033'));
}

TEST(every_status_has_its_name)
{
    for (int a = OVR_OK; a <= OVR_STOPPED; a++) {
        const char *name = ovr_status_name((ovr_status)a);
        assert_string_not_equal(name, "unknown status");
        for (int b = OVR_OK; b < a; b++)
            assert_string_not_equal(name, ovr_status_name((ovr_status)b));
    }
    assert_string_equal(ovr_status_name((ovr_status)99), "unknown status");
}
