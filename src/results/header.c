/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/header.h"

#include <hdf5_hl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "overroll/version.h"
#include "results/h5.h"

/* A dataset to be made: the unlimited dimension comes first. */
typedef struct dataset {
    const char *name, *long_name, *unit;
    double scale;
    hid_t type;
    hsize_t chunk, nodes; /* nodes 0: one-dimensional */
    int deflate;
} dataset;

const char *ovr_run_status_name(ovr_run_status status)
{
    static const char *const names[] = {"running", "complete", "stopped",
                                        "failed"};
    return names[status];
}

void ovr_date_now(char date[OVR_DATE_SIZE])
{
    struct timespec now = {0, 0};
    struct tm utc;
    size_t used = 0;
    clock_gettime(CLOCK_REALTIME, &now);
    if (gmtime_r(&now.tv_sec, &utc))
        used = strftime(date, OVR_DATE_SIZE, "%Y-%m-%dT%H:%M:%S", &utc);
    snprintf(date + used, OVR_DATE_SIZE - used, ".%06ldZ", now.tv_nsec / 1000);
}

hid_t ovr_header_creation(void)
{
    unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_link_creation_order(creation, order);
    H5Pset_attr_creation_order(creation, order);
    return creation;
}

static hid_t make_group(hid_t file, const char *name)
{
    unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    hid_t creation = H5Pcreate(H5P_GROUP_CREATE), group;
    H5Pset_link_creation_order(creation, order);
    H5Pset_attr_creation_order(creation, order);
    group = H5Gcreate2(file, name, H5P_DEFAULT, creation, H5P_DEFAULT);
    ovr_h5_drop(creation);
    return group;
}

/* A row that is not written yet reads as NaN, an integer one as -1. */
static void set_fill(hid_t creation, hid_t type)
{
    double nan = NAN;
    int none = -1;
    if (H5Tget_class(type) == H5T_FLOAT)
        H5Pset_fill_value(creation, H5T_NATIVE_DOUBLE, &nan);
    else
        H5Pset_fill_value(creation, H5T_NATIVE_INT, &none);
}

static hid_t dataset_creation(const dataset *d)
{
    hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    hsize_t chunk[2] = {d->chunk, d->nodes};
    H5Pset_attr_creation_order(creation,
                               H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    if (d->chunk)
        H5Pset_chunk(creation, d->nodes ? 2 : 1, chunk);
    if (d->chunk && d->deflate) {
        H5Pset_shuffle(creation);
        H5Pset_deflate(creation, (unsigned)d->deflate);
    }
    set_fill(creation, d->type);
    return creation;
}

static hid_t dataset_space(const dataset *d)
{
    hsize_t now[2] = {0, d->nodes}, most[2] = {H5S_UNLIMITED, d->nodes};
    if (!d->chunk) /* the positions: fixed */
        return H5Screate_simple(1, &d->nodes, NULL);
    return H5Screate_simple(d->nodes ? 2 : 1, now, most);
}

static bool describe(hid_t set, const dataset *d)
{
    return ovr_h5_set_chars(set, "long_name", d->long_name) &&
           ovr_h5_set_chars(set, "units", d->unit) &&
           ovr_h5_set_number(set, "scale", d->scale);
}

static hid_t make_dataset(hid_t where, const dataset *d)
{
    hid_t creation = dataset_creation(d), space = dataset_space(d);
    hid_t set = H5Dcreate2(where, d->name, d->type, space, H5P_DEFAULT,
                           creation, H5P_DEFAULT);
    ovr_h5_drop(space);
    ovr_h5_drop(creation);
    if (set >= 0 && !describe(set, d)) {
        ovr_h5_drop(set);
        set = -1;
    }
    return set;
}

static bool set_axis(hid_t set, const char *axis)
{
    return ovr_h5_set_chars(set, "axis", axis);
}

static hid_t make_positions(const ovr_file *f, const ovr_file_plan *plan)
{
    dataset d = {"x",
                 "position along the contact",
                 ovr_unit(plan->scales, 'X'),
                 ovr_scale(plan->scales, 'X'),
                 H5T_IEEE_F64LE,
                 0,
                 f->nodes,
                 0};
    hid_t x = make_dataset(f->file, &d);
    bool ok = x >= 0 && set_axis(x, "X") && H5DSset_scale(x, "x") >= 0 &&
              H5Dwrite(x, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                       plan->x) >= 0;
    if (!ok)
        ovr_h5_drop(x);
    return ok ? x : -1;
}

static bool make_time(ovr_file *f, const ovr_scales *scales)
{
    dataset d = {"time",
                 "time",
                 ovr_unit(scales, 'T'),
                 ovr_scale(scales, 'T'),
                 H5T_IEEE_F64LE,
                 OVR_ROW_CHUNK,
                 0,
                 0};
    f->time = make_dataset(f->file, &d);
    return f->time >= 0 && set_axis(f->time, "T") &&
           H5DSset_scale(f->time, "time") >= 0;
}

static hid_t field_type(const ovr_file *f, char kind)
{
    if (kind == 'b')
        return H5T_STD_I8LE;
    return f->element == sizeof(float) ? H5T_IEEE_F32LE : H5T_IEEE_F64LE;
}

static bool make_field(ovr_file *f, const ovr_scales *scales, hid_t x, size_t k)
{
    const ovr_field *which = f->which[k];
    dataset d = {which->name,
                 which->long_name,
                 ovr_unit(scales, which->kind),
                 ovr_scale(scales, which->kind),
                 field_type(f, which->kind),
                 1,
                 f->nodes,
                 f->deflate};
    f->field[k] = make_dataset(f->file, &d);
    return f->field[k] >= 0 && H5DSattach_scale(f->field[k], f->time, 0) >= 0 &&
           H5DSattach_scale(f->field[k], x, 1) >= 0;
}

static bool make_fields(ovr_file *f, const ovr_scales *scales, hid_t x)
{
    bool ok = true;
    for (size_t k = 0; ok && k < f->fields; k++)
        ok = make_field(f, scales, x, k);
    return ok;
}

static bool make_column(ovr_file *f, hid_t group, const ovr_scales *scales,
                        size_t c)
{
    const ovr_observable *o = &ovr_observables()[c];
    hid_t type = o->kind == 'i'   ? H5T_STD_I32LE
                 : o->kind == 'b' ? H5T_STD_I8LE
                                  : H5T_IEEE_F64LE;
    dataset d = {o->name,
                 o->long_name,
                 ovr_unit(scales, o->kind),
                 ovr_scale(scales, o->kind),
                 type,
                 OVR_ROW_CHUNK,
                 0,
                 0};
    f->column[c] = make_dataset(group, &d);
    return f->column[c] >= 0 && H5DSattach_scale(f->column[c], f->step, 0) >= 0;
}

static bool make_history(ovr_file *f, const ovr_scales *scales)
{
    dataset d = {"step",        "time step",   "1", 1,
                 H5T_STD_I32LE, OVR_ROW_CHUNK, 0,   0};
    hid_t group = make_group(f->file, "history");
    bool ok = group >= 0;
    f->step = ok ? make_dataset(group, &d) : -1;
    ok = f->step >= 0 && H5DSset_scale(f->step, "step") >= 0;
    for (size_t c = 0; ok && c < f->columns; c++)
        ok = make_column(f, group, scales, c);
    ovr_h5_drop(group);
    return ok;
}

static bool set_value(hid_t group, const ovr_case_value *value)
{
    char name[256];
    if (isnan(value->number))
        return ovr_h5_set_string(group, value->name, value->text);
    if (!ovr_h5_set_number(group, value->name, value->number))
        return false;
    if (!value->unit || !value->unit[0])
        return true;
    snprintf(name, sizeof name, "%s.unit", value->name);
    return ovr_h5_set_string(group, name, value->unit);
}

static bool make_case(const ovr_file *f, const ovr_write_options *o)
{
    hid_t group = make_group(f->file, "case");
    bool ok = group >= 0 && ovr_h5_set_string(group, "text",
                                              o->case_text ? o->case_text : "");
    for (size_t k = 0; ok && k < o->value_count; k++)
        ok = set_value(group, &o->values[k]);
    ovr_h5_drop(group);
    return ok;
}

static bool set_conventions(hid_t root, const ovr_file_plan *plan)
{
    const ovr_write_options *o = plan->options;
    const char *date = plan->created;
    char line[128];
    snprintf(line, sizeof line, "%s overroll %s", date, OVERROLL_VERSION);
    return ovr_h5_set_chars(root, "Conventions", "CF-1.8") &&
           ovr_h5_set_chars(root, "title",
                            o->title && o->title[0]
                                ? o->title
                                : "Transient rough EHL line contact") &&
           ovr_h5_set_chars(root, "history", line) &&
           ovr_h5_set_chars(root, "source", "overroll " OVERROLL_VERSION) &&
           ovr_h5_set_integer(root, "format_version", OVR_FORMAT_VERSION) &&
           ovr_h5_set_string(root, "status", "running") &&
           ovr_h5_set_string(root, "reason", "") &&
           ovr_h5_set_string(root, "date_created", date) &&
           ovr_h5_set_string(root, "date_modified", date) &&
           ovr_h5_set_number(root, "date_seconds", 0);
}

static bool set_scales(hid_t root, const ovr_scales *scales, double end)
{
    const ovr_contact *c = &scales->contact;
    const struct {
        const char *name;
        double value;
    } number[] = {
        {"M", c->M},
        {"L", c->L},
        {"alphabar", c->alphabar},
        {"lambda", c->lambda},
        {"u1_over_um", c->u1_ratio},
        {"u2_over_um", c->u2_ratio},
        {"scale_length", c->b},
        {"scale_pressure", c->ph},
        {"scale_height", c->height},
        {"scale_time", c->time},
        {"time_end", end * ovr_factor(scales, 'T')},
    };
    bool ok = ovr_h5_set_string(root, "scaling",
                                scales->physical ? "SI" : "dimensionless");
    for (size_t k = 0; ok && k < sizeof number / sizeof *number; k++)
        ok = ovr_h5_set_number(root, number[k].name, number[k].value);
    return ok;
}

bool ovr_header_write(ovr_file *f, const ovr_file_plan *plan)
{
    hid_t x = -1;
    bool ok = set_conventions(f->file, plan) &&
              set_scales(f->file, plan->scales, plan->options->end) &&
              make_time(f, plan->scales);
    if (ok)
        x = make_positions(f, plan);
    ok = x >= 0 && make_fields(f, plan->scales, x) &&
         make_history(f, plan->scales) && make_case(f, plan->options);
    ovr_h5_drop(x);
    return ok;
}

static bool open_fields(ovr_file *f, const ovr_scales *scales)
{
    hid_t x = H5Dopen2(f->file, "x", H5P_DEFAULT);
    bool ok = x >= 0;
    for (size_t k = 0; ok && k < f->fields; k++) {
        const char *name = f->which[k]->name;
        if (H5Lexists(f->file, name, H5P_DEFAULT) > 0)
            f->field[k] = H5Dopen2(f->file, name, H5P_DEFAULT);
        else
            make_field(f, scales, x, k);
        ok = f->field[k] >= 0;
    }
    ovr_h5_drop(x);
    return ok;
}

static bool open_columns(ovr_file *f)
{
    const ovr_observable *o = ovr_observables();
    hid_t group = H5Gopen2(f->file, "history", H5P_DEFAULT);
    bool ok = group >= 0;
    f->step = ok ? H5Dopen2(group, "step", H5P_DEFAULT) : -1;
    ok = f->step >= 0;
    for (size_t c = 0; ok && c < f->columns; c++) {
        f->column[c] = H5Dopen2(group, o[c].name, H5P_DEFAULT);
        ok = f->column[c] >= 0;
    }
    ovr_h5_drop(group);
    return ok;
}

bool ovr_header_new_case(ovr_file *f, const ovr_file_plan *plan)
{
    return H5Ldelete(f->file, "case", H5P_DEFAULT) >= 0 &&
           make_case(f, plan->options);
}

bool ovr_header_open(ovr_file *f, const ovr_file_plan *plan)
{
    f->time = H5Dopen2(f->file, "time", H5P_DEFAULT);
    return f->time >= 0 && open_fields(f, plan->scales) && open_columns(f);
}
