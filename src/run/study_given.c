/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sections of a study share what may be given: paths, each key once, and no
 * word that they do not know. */
#include <stdio.h>
#include <string.h>

#include "base/error.h"
#include "overroll/text.h"
#include "run/study.h"

const char *ovr_study_path(ovr_study *s, const char *path, ovr_error *err)
{
    char whole[4096];
    if (path[0] == '/' || !strcmp(s->folder, "."))
        return ovr_arena_text(&s->arena, path, err);
    snprintf(whole, sizeof whole, "%s/%s", s->folder, path);
    return ovr_arena_text(&s->arena, whole, err);
}

ovr_status ovr_study_unknown(const ovr_study *s, const ovr_study_words *words,
                             const char *given, long line, ovr_error *err)
{
    const char *what = *words->in ? "key" : "section";
    const char *meant = ovr_suggest(given, words->word, words->count);
    char there[200] = "";
    size_t used = 0;
    for (size_t k = 0; k < words->count && used < sizeof there; k++)
        used += (size_t)snprintf(there + used, sizeof there - used, "%s%s",
                                 k ? ", " : "", words->word[k]);
    ovr_fail_at(err, OVR_BAD_INPUT, s->path, line,
                meant ? "unknown %s '%.60s'%s; did you mean '%s'?"
                      : "unknown %s '%.60s'%s; there are %s%s",
                what, given, words->in, meant ? meant : there, words->more);
    return meant ? ovr_fail_meant(err, OVR_BAD_INPUT, meant) : OVR_BAD_INPUT;
}

ovr_study_key *ovr_study_new_key(ovr_study *s, const char *where, long line,
                                 ovr_error *err)
{
    ovr_study_key *k = &s->key[s->keys];
    const char *wrong = s->keys == OVR_STUDY_MAX_KEYS
                            ? "'%.60s' is one key too many: at most 64"
                            : NULL;
    for (size_t i = 0; !wrong && i < s->keys; i++)
        if (!strcmp(s->key[i].where, where))
            wrong = "'%.60s' is given twice";
    if (wrong) {
        ovr_fail_at(err, OVR_BAD_INPUT, s->path, line, wrong, where);
        return NULL;
    }
    *k = (ovr_study_key){.where = ovr_arena_text(&s->arena, where, err),
                         .line = line};
    s->keys += k->where != NULL;
    return k->where ? k : NULL;
}
