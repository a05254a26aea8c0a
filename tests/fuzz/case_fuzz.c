/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: case files. Any text is either read as a case or rejected with a
 * message of one line. The text of a case with an added setting can be read
 * again. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "overroll/overroll.h"

static void check_message(const ovr_error *err)
{
    if (err->status == OVR_OK || !err->message[0] ||
        strpbrk(err->message, "\n\r"))
        abort();
}

static void check_again(ovr_case *c)
{
    ovr_error err = {0};
    const char *text;
    ovr_case *again;
    if (ovr_case_set(c, "solver.cycle", "W", "fuzz", &err))
        abort();
    text = ovr_case_text(c, &err);
    again = ovr_case_read_text(text, "again", NULL, NULL, &err);
    if (!again)
        abort();
    ovr_case_free(again);
}

/* An absolute path may be any file of this machine. */
static bool holds_path(const char *text)
{
    for (; *text; text++)
        if ((*text == '=' || *text == ':') &&
            text[1 + strspn(text + 1, " \t")] == '/')
            return true;
    return false;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    ovr_error err = {0};
    ovr_setup *setup = NULL;
    ovr_case *c;
    if (!text)
        return 0;
    memcpy(text, data, size);
    text[size] = '\0';
    c = ovr_case_read_text(text, "case", "/nowhere", NULL, &err);
    if (!c)
        check_message(&err);
    else if (!holds_path(text)) {
        setup = ovr_case_resolve(c, NULL, &err);
        if (!setup || ovr_setup_prepare(setup, NULL, &err))
            check_message(&err);
    }
    if (c) {
        check_again(c);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
    free(text);
    return 0;
}
