/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs files through a target of libFuzzer without libFuzzer. Each target is
 * linked with the name replay_NAME; the Makefile defines TARGETS as a list of
 * TARGET(NAME). */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TARGET(name) int replay_##name(const uint8_t *data, size_t size);
TARGETS
#undef TARGET

enum { MAX = 1 << 20 };

typedef int target(const uint8_t *data, size_t size);

static target *target_named(const char *name)
{
#define TARGET(target_name)                                                    \
    if (!strcmp(name, #target_name))                                           \
        return replay_##target_name;
    TARGETS
#undef TARGET
    return NULL;
}

int main(int argc, char **argv)
{
    target *take = argc > 1 ? target_named(argv[1]) : NULL;
    if (!take) {
        fprintf(stderr, "usage: replay TARGET FILE...\n");
        return 2;
    }
    for (int k = 2; k < argc; k++) {
        FILE *in = fopen(argv[k], "rb");
        uint8_t *data = malloc(MAX);
        uint8_t *exact;
        size_t size;
        if (!in || !data) {
            fprintf(stderr, "%s: cannot be read\n", argv[k]);
            return 1;
        }
        size = fread(data, 1, MAX, in);
        fclose(in);
        exact = realloc(data, size ? size : 1); /* a step too far shows */
        take(exact, size);
        free(exact);
    }
    printf("%s: %d inputs\n", argv[1], argc - 2);
    return 0;
}
