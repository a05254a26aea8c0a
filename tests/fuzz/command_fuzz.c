/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target: command lines, one word per line. For any words the program ends
 * with one of its exit codes. Commands that solve are only checked, paths with
 * a slash are omitted, and all files are in an empty folder. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz/folder.h"

/* main of the program under another name (Makefile). */
int overroll_main(int argc, char **argv);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { WORDS = 40 };

static int cut(char *text, char **words)
{
    static char name[] = "overroll";
    int count = 1;
    words[0] = name;
    for (char *next = text; next && count < WORDS - 1; count++) {
        words[count] = next;
        next = strchr(next, '\n');
        if (next)
            *next++ = '\0';
    }
    words[count] = NULL;
    return count;
}

static void tame(char **words)
{
    static const char *const solves[] = {"steady", "run", "sweep", "resume"};
    static char check[] = "check";
    for (size_t k = 0; k < sizeof solves / sizeof *solves; k++)
        if (words[1] && !strcmp(words[1], solves[k]))
            words[1] = check;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *words[WORDS];
    char *text = malloc(size + 1);
    if (!text || size > 2000 || memchr(data, '/', size)) {
        free(text);
        return 0;
    }
    fuzz_enter();
    memcpy(text, data, size);
    text[size] = '\0';
    int count = cut(text, words), code;
    tame(words);
    code = overroll_main(count, words);
    if (code < 0 || code > 3)
        abort();
    free(text);
    return 0;
}
