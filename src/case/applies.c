/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys that have a meaning only beside certain values of others. */
#include <string.h>

#include "case/case.h"

/* `other` of the same section, or of the plain section `of`, must be one of
 * the values, set apart by blanks; "*": given. */
static const struct condition {
    const char *section, *key, *of, *other, *values;
} conditions[] = {
    {"lubricant", "p0", NULL, "viscosity_law", "roelands"},
    {"lubricant", "z", NULL, "viscosity_law", "roelands"},
    {"heat", "points", NULL, "model", "lobatto"},
    {"heat", "conductivity", NULL, "model", "lobatto"},
    {"heat", "heat_capacity", NULL, "model", "lobatto"},
    {"heat", "density", NULL, "model", "lobatto"},
    {"heat", "expansion", NULL, "model", "lobatto"},
    {"lubricant", "carreau_n", NULL, "rheology", "carreau"},
    {"lubricant", "carreau_a", NULL, "rheology", "carreau"},
    {"lubricant", "carreau_form", NULL, "rheology", "carreau"},
    {"time", "step", NULL, "end", "*"},
    {"time", "error", NULL, "end", "*"},
    {"time", "error", NULL, "step", "adaptive"},
    {"load", "history", "time", "end", "*"},
    {"load", "from", NULL, "history", "ramp step"},
    {"load", "to", NULL, "history", "ramp step"},
    {"load", "start", NULL, "history", "ramp step sine"},
    {"load", "duration", NULL, "history", "ramp"},
    {"load", "amplitude", NULL, "history", "sine"},
    {"load", "time_unit", NULL, "history", "table"},
    {"speed", "history", "time", "end", "*"},
    {"speed", "from", NULL, "history", "ramp step"},
    {"speed", "to", NULL, "history", "ramp step"},
    {"speed", "start", NULL, "history", "ramp step sine"},
    {"speed", "duration", NULL, "history", "ramp"},
    {"speed", "amplitude", NULL, "history", "sine"},
    {"speed", "time_unit", NULL, "history", "table"},
    {"sliding", "history", "time", "end", "*"},
    {"sliding", "from", NULL, "history", "ramp step"},
    {"sliding", "to", NULL, "history", "ramp step"},
    {"sliding", "start", NULL, "history", "ramp step sine"},
    {"sliding", "duration", NULL, "history", "ramp"},
    {"sliding", "amplitude", NULL, "history", "sine"},
    {"sliding", "time_unit", NULL, "history", "table"},
    {"supply", "thickness_1", NULL, "model", "film"},
    {"supply", "thickness_2", NULL, "model", "film"},
    {"supply", "waiting", NULL, "model", "film"},
    {"supply", "history", NULL, "model", "film"},
    {"supply", "history", "time", "end", "*"},
    {"supply", "from", NULL, "history", "ramp step"},
    {"supply", "to", NULL, "history", "ramp step"},
    {"supply", "start", NULL, "history", "ramp step sine"},
    {"supply", "duration", NULL, "history", "ramp"},
    {"supply", "amplitude", NULL, "history", "sine"},
    {"supply", "time_unit", NULL, "history", "table"},
    {"passes", "number", "cavitation", "model", "conserving"},
    {"passes", "split", NULL, "number", "*"},
    {"passes", "loss", NULL, "number", "*"},
    {"passes", "replenish", NULL, "number", "*"},
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

bool ovr_key_applies(const ovr_case *c, const ovr_block *block, const char *key)
{
    size_t n = sizeof conditions / sizeof *conditions;
    for (size_t k = 0; k < n; k++) {
        const struct condition *w = &conditions[k];
        const ovr_block *in = w->of ? ovr_case_find_block(c, w->of, NULL)
                                    : block;
        const ovr_slot *slot;
        if (strcmp(w->section, block->section->name) != 0 ||
            strcmp(w->key, key) != 0)
            continue;
        slot = ovr_block_get(in, w->other);
        if (*w->values == '*'
                ? !slot->given
                : !slot->text || !is_one_of(slot->text, w->values))
            return false;
    }
    return true;
}
