/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Optimal string alignment distance (insert, delete, replace, swap of
 * neighbours), three rows of its table at a time; if no name is similar, a name
 * that contains the given word is suggested.
 */
#include "overroll/text.h"

#include <stdbool.h>
#include <string.h>

enum { LONGEST = 48 };

static char lower(char c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

static size_t minimum(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t distance(const char *a, const char *b)
{
    size_t rows[3][LONGEST + 1], la = strlen(a), lb = strlen(b);
    if (la > LONGEST || lb > LONGEST)
        return la + lb;
    for (size_t j = 0; j <= lb; j++)
        rows[0][j] = j;
    for (size_t i = 1; i <= la; i++) {
        size_t *now = rows[i % 3], *last = rows[(i + 2) % 3];
        const size_t *before = rows[(i + 1) % 3];
        now[0] = i;
        for (size_t j = 1; j <= lb; j++) {
            bool same = lower(a[i - 1]) == lower(b[j - 1]);
            now[j] = minimum(last[j - 1] + !same,
                             minimum(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                now[j] = minimum(now[j], before[j - 2] + 1);
        }
    }
    return rows[la % 3][lb];
}

/* True if `word` is one of the words of `name` between underscores. */
static bool has_word(const char *name, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = name; (at = strstr(at, word)); at++)
        if ((at == name || at[-1] == '_') && (!at[length] || at[length] == '_'))
            return true;
    return false;
}

/* Returns the first name that contains `wrong` as a word. */
static const char *with_word(const char *wrong, const char *const *names,
                             size_t n)
{
    for (size_t i = 0; *wrong && i < n; i++)
        if (has_word(names[i], wrong))
            return names[i];
    return NULL;
}

const char *ovr_suggest(const char *wrong, const char *const *names, size_t n)
{
    if (!wrong || !names)
        return NULL;
    size_t allowed = (strlen(wrong) + 2) / 3, best = allowed + 1;
    const char *nearest = NULL;
    for (size_t i = 0; i < n; i++) {
        size_t d = distance(wrong, names[i]);
        if (d < best && d < strlen(names[i])) {
            best = d;
            nearest = names[i];
        }
    }
    return nearest ? nearest : with_word(wrong, names, n);
}
