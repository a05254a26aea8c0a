/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys that have a meaning only beside certain values of others. */
#include <string.h>

#include "case/case.h"

/* `other` of the same section, or of the plain section `of`, must be one of
 * the values, set apart by blanks; "*": given.  Without a section: of any that
 * has a history. */
static const struct condition {
    const char *section, *key, *of, *other, *values;
} conditions[] = {
    {NULL, "from", NULL, "history", "ramp step"},
    {NULL, "to", NULL, "history", "ramp step"},
    {NULL, "start", NULL, "history", "ramp step sine"},
    {NULL, "duration", NULL, "history", "ramp"},
    {NULL, "amplitude", NULL, "history", "sine"},
    {NULL, "time_unit", NULL, "history", "table"},
    {"lubricant", "p0", NULL, "viscosity_law", "roelands"},
    {"lubricant", "z", NULL, "viscosity_law", "roelands"},
    {"domain", "refine_level", NULL, "refine", "spike"},
    {"domain", "refine_change", NULL, "refine", "spike"},
    {"heat", "points", NULL, "model", "lobatto"},
    {"heat", "conductivity", NULL, "model", "lobatto"},
    {"heat", "heat_capacity", NULL, "model", "lobatto"},
    {"heat", "density", NULL, "model", "lobatto"},
    {"heat", "expansion", NULL, "model", "lobatto"},
    {"heat", "density_expansion", NULL, "model", "lobatto"},
    {"lubricant", "carreau_n", NULL, "rheology", "carreau"},
    {"lubricant", "carreau_a", NULL, "rheology", "carreau"},
    {"lubricant", "carreau_form", NULL, "rheology", "carreau"},
    {"time", "step", NULL, "end", "*"},
    {"time", "error", NULL, "end", "*"},
    {"time", "error", NULL, "step", "adaptive"},
    {"load", "history", "time", "end", "*"},
    {"speed", "mean", NULL, "history", "sine"},
    {"speed", "history", "time", "end", "*"},
    {"sliding", "history", "time", "end", "*"},
    {"radius", "history", "time", "end", "*"},
    {"radius", "curvature", NULL, "history", "ramp sine step table"},
    {"radius_1", "history", "time", "end", "*"},
    {"supply", "thickness_1", NULL, "model", "film"},
    {"supply", "thickness_2", NULL, "model", "film"},
    {"supply", "waiting", NULL, "model", "film"},
    {"supply", "history", NULL, "model", "film"},
    {"supply", "history", "time", "end", "*"},
    {"passes", "number", "cavitation", "model", "conserving"},
    {"passes", "split", NULL, "number", "*"},
    {"passes", "loss", NULL, "number", "*"},
    {"passes", "replenish", NULL, "number", "*"},
    {"passes", "again", NULL, "number", "*"},
    {"feature", "grow_from", NULL, "grow", "*"},
    {"feature", "copies", NULL, "repeat", "*"},
    {"feature", "scale", NULL, "shape", "profile"},
    {"feature", "invert", NULL, "shape", "profile"},
    {"feature", "stretch", NULL, "shape", "profile"},
    {"feature", "reverse", NULL, "shape", "profile"},
    {"feature", "max_missing", NULL, "shape", "profile"},
    {"feature", "level", NULL, "shape", "profile"},
    {"feature", "degree", NULL, "shape", "profile"},
    {"feature", "degree", NULL, "level", "polynomial"},
    {"feature", "offset", NULL, "shape", "profile"},
    {"feature", "extend", NULL, "shape", "profile roughness"},
    {"feature", "spectrum", NULL, "shape", "roughness"},
    {"feature", "seed", NULL, "shape", "roughness"},
    {"feature", "hurst", NULL, "shape", "roughness"},
    {"feature", "hurst", NULL, "spectrum", "self-affine"},
    {"output", "checkpoint", "time", "end", "*"},
    {"paper", "switch", NULL, "smoother", "hybrid"},
    {"paper", "relax_seidel", NULL, "smoother", "hybrid gauss-seidel"},
    {"paper", "relax_dipole", NULL, "smoother", "hybrid dipole"},
    {"paper", "cycles", "solver", "stop", "fixed"},
    {"fatigue", "alpha", NULL, "criterion", "circle dang-van"},
};

static bool is_one_of(const char *text, const char *values)
{
    size_t size = strlen(text);
    while (*values) {
        size_t length = strcspn(values, " ");
        if (length == size && !memcmp(values, text, size))
            return true;
        values += length + (values[length] != '\0');
    }
    return false;
}

static bool has_key(const ovr_block *block, const char *key)
{
    for (size_t k = 0; k < block->count; k++)
        if (!strcmp(block->slots[k].key, key))
            return true;
    return false;
}

static bool is_about(const struct condition *w, const ovr_block *block,
                     const char *key)
{
    if (*w->key != *key || strcmp(w->key, key) != 0)
        return false;
    return w->section ? !strcmp(w->section, block->section->name)
                      : has_key(block, w->other);
}

bool ovr_key_applies(const ovr_case *c, const ovr_block *block, const char *key)
{
    size_t n = sizeof conditions / sizeof *conditions;
    for (size_t k = 0; k < n; k++) {
        const struct condition *w = &conditions[k];
        const ovr_slot *slot;
        if (!is_about(w, block, key))
            continue;
        slot = ovr_block_get(
            w->of ? ovr_case_find_block(c, w->of, NULL) : block, w->other);
        if (*w->values == '*'
                ? !slot->given
                : !slot->text || !is_one_of(slot->text, w->values))
            return false;
    }
    return true;
}
