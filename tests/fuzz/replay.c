/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Feeds files to a target of libFuzzer, without libFuzzer. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { MAX = 1 << 20 };

int main(int argc, char **argv)
{
    for (int k = 1; k < argc; k++) {
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
        LLVMFuzzerTestOneInput(exact, size);
        free(exact);
    }
    printf("%d inputs\n", argc - 1);
    return 0;
}
