/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [lubricant]: the oil, and its tables from their files. */
#include <math.h>

#include "base/entries.h"
#include "base/error.h"
#include "base/text.h"
#include "case/resolve.h"
#include "case/two_columns.h"
#include "contact/oil.h"

/* A file of measured values over the pressure, of the key that names it. */
static ovr_status read_table(ovr_resolved *r, const char *key, const char *file,
                             ovr_table_of what, ovr_error *err)
{
    bool density = what == OVR_TABLE_OF_DENSITY;
    ovr_two_columns c = {
        .name = {"pressure", density ? "density" : "viscosity"},
        .header = {OVR_PRESSURE,
                   density ? OVR_MASS_DENSITY : OVR_DYNAMIC_VISCOSITY},
        .example = density ? "pressure [MPa], density [kg/m3]"
                           : "pressure [MPa], viscosity [mPa.s]"};
    ovr_error why = {0};
    ovr_status status;
    if (!file)
        return OVR_OK;
    status = ovr_two_columns_read(
        &c, file, ovr_block_get(ovr_block_of(r, "lubricant"), key), &r->arena,
        err);
    if (status)
        return status;
    const ovr_law_points points = {what, c.count, c.x, c.y};
    r->tables[what] = ovr_law_table_create(&points, &r->arena.allocator, &why);
    return r->tables[what] ? OVR_OK : ovr_fail_from(err, &why, file, 0);
}

/* -------------------------------------------------------------------- oil */

static ovr_status grade(ovr_resolved *r, ovr_error *err)
{
    ovr_oil *oil = &r->values.oil;
    const ovr_slot *slot = ovr_block_get(ovr_block_of(r, "lubricant"),
                                         "iso_vg");
    if (isnan(r->values.iso_vg))
        return OVR_OK;
    if (!isnan(oil->nu_40))
        return ovr_fail_slot(err, slot,
                             "viscosity_40 is given too: leave one "
                             "out");
    oil->nu_40 = r->values.iso_vg * 1e-6;
    return OVR_OK;
}

ovr_status ovr_resolve_oil(ovr_resolved *r, ovr_error *err)
{
    ovr_settings *v = &r->values;
    ovr_oil *oil = &v->oil;
    ovr_error why = {0};
    ovr_status status = grade(r, err);
    const ovr_slot *supplied = ovr_slot_of(r, "heat", "temperature");
    if (supplied->given && !isnan(oil->temperature))
        return ovr_fail_slot(err, supplied,
                             "is given in [lubricant] too: leave one out");
    if (supplied->given)
        oil->temperature = supplied->number;
    oil->viscosity_law = (ovr_viscosity_law)v->viscosity_law;
    oil->density_law = (ovr_density_law)v->density_law;
    oil->viscosity = v->contact.viscosity;
    oil->alpha = v->contact.alpha;
    oil->mineral = v->oil_kind == 1;
    if (!status && oil->viscosity_law == OVR_VISCOSITY_TABLE)
        status = read_table(r, "viscosity_file", v->viscosity_file,
                            OVR_TABLE_OF_VISCOSITY, err);
    if (!status && oil->density_law == OVR_DENSITY_TABLE)
        status = read_table(r, "density_file", v->density_file,
                            OVR_TABLE_OF_DENSITY, err);
    if (status)
        return status;
    oil->viscosity_table = r->tables[OVR_TABLE_OF_VISCOSITY];
    oil->density_table = r->tables[OVR_TABLE_OF_DENSITY];
    bool given = !isnan(oil->alpha);
    if (ovr_oil_complete(oil, &why))
        return ovr_fail_in(err, r->c, ovr_block_of(r, "lubricant"),
                           ovr_block_of(r, "contact"), &why);
    r->alpha_estimated = oil->mineral && !given;
    v->contact.viscosity = oil->viscosity;
    v->contact.alpha = oil->alpha;
    return OVR_OK;
}
