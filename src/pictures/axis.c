/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures/axis.h"

#include <math.h>

#include "results/results.h"

typedef struct quantity {
    ovr_unit_kind kind;
    ovr_axis hertzian;
    struct {
        double size;
        const char *unit, *label, *plain;
    } unit[3]; /* the largest first */
} quantity;

#define LENGTH(size, unit, name, symbol)                                       \
    {                                                                          \
        size, unit, name ", {/:Italic " symbol "} (" unit ")",                 \
            name ", " symbol " (" unit ")"                                     \
    }
static const quantity quantities[] = {
    {OVR_KIND_LENGTH,
     {1, "position, {/:Italic x} ({/:Italic b})", "position, x (b)", ""},
     {LENGTH(1e-3, "mm", "position", "x"), LENGTH(1e-6, "µm", "position", "x"),
      LENGTH(1e-9, "nm", "position", "x")}},
    {OVR_KIND_HEIGHT,
     {1, "film thickness, {/:Italic h} ({/:Italic b}^2/{/:Italic R})",
      "film thickness, h (b²/R)", ""},
     {LENGTH(1e-6, "µm", "film thickness", "h"),
      LENGTH(1e-9, "nm", "film thickness", "h"),
      LENGTH(1e-9, "nm", "film thickness", "h")}},
    {OVR_KIND_PRESSURE,
     {1, "pressure, {/:Italic p} ({/:Italic p}_h)", "pressure, p (p_h)", ""},
     {LENGTH(1e9, "GPa", "pressure", "p"), LENGTH(1e6, "MPa", "pressure", "p"),
      LENGTH(1e3, "kPa", "pressure", "p")}},
    {OVR_KIND_TIME,
     {1, "time, {/:Italic t} ({/:Italic b}/{/:Italic u}_m)", "time, t (b/u_m)",
      ""},
     {LENGTH(1, "s", "time", "t"), LENGTH(1e-3, "ms", "time", "t"),
      LENGTH(1e-6, "µs", "time", "t")}},
};

static const quantity *find(ovr_unit_kind kind)
{
    for (size_t k = 0; k < sizeof quantities / sizeof *quantities; k++)
        if (quantities[k].kind == kind)
            return &quantities[k];
    return NULL;
}

bool ovr_axis_has(ovr_unit_kind kind)
{
    return find(kind) != NULL;
}

/* A prefix serves from a tenth of its unit on: 0.3 mm rather than 300 um. */
static ovr_axis with_unit(const quantity *q, double scale, double largest)
{
    int k = 0;
    while (k < 2 && !(largest * scale >= 0.1 * q->unit[k].size))
        k++;
    return (ovr_axis){scale / q->unit[k].size, q->unit[k].label,
                      q->unit[k].plain, q->unit[k].unit};
}

double ovr_axis_reach(const double *values, size_t n)
{
    double high = 0;
    for (size_t i = 0; i < n; i++)
        high = fmax(high, fabs(values[i])); /* passes over NAN */
    return high;
}

void ovr_axis_as_is(ovr_unit_kind kind, bool si, double largest, ovr_axis *axis)
{
    const quantity *q = find(kind);
    if (q)
        *axis = si ? with_unit(q, 1, largest) : q->hertzian;
    else
        *axis = (ovr_axis){1, "", "", ""};
}

ovr_status ovr_axis_make(ovr_unit_kind kind, ovr_result *result,
                         ovr_units units, double largest, ovr_axis *axis,
                         ovr_error *err)
{
    const ovr_result_info *info = ovr_result_get_info(result);
    double scale = ovr_result_scale(info, kind);
    const quantity *q = find(kind);
    if (!q)
        return ovr_fail(err, OVR_BAD_INPUT,
                        "a quantity of unknown kind cannot be drawn");
    *axis = q->hertzian;
    if (units == OVR_HERTZIAN || (units == OVR_AS_STORED && !info->physical))
        return OVR_OK;
    if (!(scale > 0 && isfinite(scale)))
        return ovr_fail(err, OVR_BAD_INPUT,
                        "no SI units: the contact has no physical scales; "
                        "use Hertzian units");
    *axis = with_unit(q, scale, largest);
    return OVR_OK;
}
