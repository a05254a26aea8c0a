/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "results/header.h"

#include <errno.h>
#include <hdf5_hl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "overroll/version.h"
#include "results/h5.h"
#include "results/results.h"

typedef ovr_new_dataset dataset;

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

/* Attributes and links are stored in the header of the group, not in a heap.
 * HDF5 1.10 cannot close a file that was opened again if such a heap has grown
 * and was changed.  The size of the header is set in advance, as a number of
 * links, because HDF5 copies the header to append an attribute. */
static void set_group(hid_t creation, size_t bytes)
{
    enum { NAME = 43, LINK = 64, MOST = 60000 }; /* a message: 64 KiB */
    unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
    size_t links = (bytes < MOST ? bytes : MOST) / LINK;
    H5Pset_link_creation_order(creation, order);
    H5Pset_attr_creation_order(creation, order);
    H5Pset_link_phase_change(creation, 512, 256);
    H5Pset_attr_phase_change(creation, 512, 256);
    H5Pset_est_link_info(creation, (unsigned)links + 4, NAME);
}

/* About 40 attributes of the root, and the extremes in one or two units. */
hid_t ovr_header_creation(void)
{
    hid_t creation = H5Pcreate(H5P_FILE_CREATE);
    enum { ATTRIBUTE = OVR_ATTRIBUTE };
    size_t bytes = 40 * (ATTRIBUTE + 24);
    ovr_extreme e;
    for (size_t k = 0; ovr_extreme_at(k, &e); k++) {
        bytes += ATTRIBUTE + strlen(e.key);
        if (*e.key_si)
            bytes += ATTRIBUTE + strlen(e.key_si);
    }
    set_group(creation, bytes);
    return creation;
}

hid_t ovr_header_group(hid_t where, const char *name, size_t bytes)
{
    hid_t creation = H5Pcreate(H5P_GROUP_CREATE), group;
    set_group(creation, bytes);
    group = H5Gcreate2(where, name, H5P_DEFAULT, creation, H5P_DEFAULT);
    ovr_h5_drop(creation);
    return group;
}

/* Sets the fill value: rows that are not written yet are NaN, or -1 for
 * integers. */
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
    hsize_t chunk[OVR_MAX_RANK];
    memcpy(chunk, d->shape, sizeof chunk);
    chunk[0] = d->rows;
    H5Pset_attr_creation_order(creation,
                               H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    if (d->rows)
        H5Pset_chunk(creation, d->rank, chunk);
    if (d->rows && d->deflate) {
        H5Pset_shuffle(creation);
        H5Pset_deflate(creation, (unsigned)d->deflate);
    }
    set_fill(creation, d->type);
    return creation;
}

/* Returns access properties with a cache of three chunks, which suffices for
 * writing in order. The default uses 4 KiB for each dataset. */
static hid_t dataset_access(void)
{
    hid_t access = H5Pcreate(H5P_DATASET_ACCESS);
    H5Pset_chunk_cache(access, 3, H5D_CHUNK_CACHE_NBYTES_DEFAULT,
                       H5D_CHUNK_CACHE_W0_DEFAULT);
    return access;
}

static hid_t dataset_space(const dataset *d)
{
    hsize_t maximum[OVR_MAX_RANK];
    memcpy(maximum, d->shape, sizeof maximum);
    if (d->rows)
        maximum[0] = H5S_UNLIMITED;
    return H5Screate_simple(d->rank, d->shape, maximum);
}

/* Adds the width to quantities per unit width, if it is known. */
static bool write_width(hid_t set, const dataset *d, const ovr_contact *contact)
{
    bool wide = d->kind == OVR_KIND_FORCE || d->kind == OVR_KIND_POWER;
    return !wide || isnan(contact->width) ||
           ovr_h5_set_number(set, "width", contact->width);
}

static bool describe(hid_t set, const dataset *d, const ovr_scales *scales)
{
    return write_width(set, d, &scales->contact) &&
           ovr_h5_set_chars(set, "long_name", d->long_name) &&
           (!d->comment || ovr_h5_set_chars(set, "comment", d->comment)) &&
           ovr_h5_set_chars(set, "units", ovr_unit(scales, d->kind)) &&
           ovr_h5_set_number(set, "scale",
                             ovr_kind_scale(d->kind, &scales->contact)) &&
           ovr_h5_set_chars(set, "kind", ovr_kind_about(d->kind)->name);
}

static bool place(hid_t set, const dataset *d)
{
    bool ok = true;
    if (d->along[0] == 0)
        return H5DSset_scale(set, d->name) >= 0;
    if (d->attached_later)
        return true;
    for (unsigned k = 0; ok && k < (unsigned)d->rank; k++)
        ok = H5DSattach_scale(set, d->along[k], k) >= 0;
    return ok;
}

hid_t ovr_header_dataset(hid_t where, const dataset *d,
                         const ovr_scales *scales)
{
    hid_t creation = d->creation > 0 ? d->creation : dataset_creation(d);
    hid_t access = d->access > 0 ? d->access : dataset_access();
    hid_t space = dataset_space(d);
    hid_t set = H5Dcreate2(where, d->name, d->type, space, H5P_DEFAULT,
                           creation, access);
    ovr_h5_drop(space);
    if (d->access <= 0)
        ovr_h5_drop(access);
    if (d->creation <= 0)
        ovr_h5_drop(creation);
    if (set >= 0 && !(describe(set, d, scales) && place(set, d))) {
        ovr_h5_drop(set);
        set = -1;
    }
    return set;
}

static bool set_axis(hid_t set, const char *axis)
{
    return set >= 0 && ovr_h5_set_chars(set, "axis", axis);
}

/* Writes an attribute with several values; true on success. */
static bool set_list(hid_t set, const char *name, hid_t type, hsize_t count,
                     const void *values)
{
    hid_t space = H5Screate_simple(1, &count, NULL);
    hid_t list = H5Acreate2(set, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    bool ok = list >= 0 && H5Awrite(list, type, values) >= 0;
    ovr_h5_drop(list);
    ovr_h5_drop(space);
    return ok;
}

/* An element of REFERENCE_LIST: this dataset's first dimension. */
typedef struct attachment {
    hobj_ref_t set;
    int dimension;
} attachment;

static hid_t attachment_type(void)
{
    hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(attachment));
    H5Tinsert(type, "dataset", HOFFSET(attachment, set), H5T_STD_REF_OBJ);
    H5Tinsert(type, "dimension", HOFFSET(attachment, dimension),
              H5T_NATIVE_INT);
    return type;
}

/* Attaches all columns to their scale `step`. H5DSattach_scale would attach
 * them one by one, and each call copies the scale's whole list. */
static bool attach_columns(ovr_file *f)
{
    ovr_arena arena = ovr_arena_make(&f->store.changed.arena->allocator);
    attachment *list = ovr_arena_take(&arena, f->columns, sizeof *list, NULL);
    hid_t type = attachment_type(), along = H5Tvlen_create(H5T_STD_REF_OBJ);
    hobj_ref_t axis;
    hvl_t one = {1, &axis};
    bool ok = ovr_store_note(&f->store, list ? 0 : ENOMEM) &&
              H5Rcreate(&axis, f->step, ".", H5R_OBJECT, -1) >= 0;
    for (size_t k = 0; ok && k < f->columns; k++)
        ok = H5Rcreate(&list[k].set, f->column[k], ".", H5R_OBJECT, -1) >= 0 &&
             set_list(f->column[k], "DIMENSION_LIST", along, 1, &one);
    ok = ok && set_list(f->step, "REFERENCE_LIST", type, f->columns, list);
    ovr_h5_drop(along);
    ovr_h5_drop(type);
    ovr_arena_release(&arena);
    return ok;
}

/* Creates an axis; `axis` may be NULL. */
static hid_t make_axis(const ovr_file *f, const ovr_file_plan *plan, dataset d,
                       const char *axis, const double *values)
{
    d.kind = OVR_KIND_LENGTH;
    d.type = H5T_IEEE_F64LE;
    d.rank = 1;
    hid_t set = ovr_header_dataset(f->file, &d, plan->scales);
    bool ok = (!axis || set_axis(set, axis)) &&
              H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                       values) >= 0;
    if (!ok)
        ovr_h5_drop(set);
    return ok ? set : -1;
}

static hid_t make_positions(const ovr_file *f, const ovr_file_plan *plan)
{
    dataset d = {.name = "x",
                 .long_name = "position along the contact",
                 .shape = {f->nodes}};
    return make_axis(f, plan, d, "X", plan->x);
}

/* Creates the positions of the lines; -1 for a line contact. ParaView
 * interprets two axes named X and Y as longitude and latitude, so only x has
 * this attribute. */
static hid_t make_lines(const ovr_file *f, const ovr_file_plan *plan)
{
    dataset d = {.name = "y",
                 .long_name = "position across rolling",
                 .shape = {f->lines}};
    return f->lines > 1 ? make_axis(f, plan, d, NULL, plan->y) : -1;
}

/* Writes integration weights of the stored nodes along x if the nodes are not
 * equally spaced. */
static bool make_weights(const ovr_file *f, const ovr_file_plan *plan, hid_t x)
{
    dataset d = {.name = "weight",
                 .long_name = "weight of a node in integrals over x",
                 .kind = OVR_KIND_LENGTH,
                 .type = H5T_IEEE_F64LE,
                 .rank = 1,
                 .shape = {f->nodes},
                 .along = {x}};
    hid_t set = ovr_header_dataset(f->file, &d, plan->scales);
    bool ok = set >= 0 && H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL,
                                   H5P_DEFAULT, plan->weights) >= 0;
    ovr_h5_drop(set);
    return ok;
}

static bool make_time(ovr_file *f, const ovr_scales *scales)
{
    dataset d = {.name = "time",
                 .long_name = "time",
                 .kind = OVR_KIND_TIME,
                 .type = H5T_IEEE_F64LE,
                 .rows = OVR_ROW_CHUNK,
                 .rank = 1};
    f->time = ovr_header_dataset(f->file, &d, scales);
    return set_axis(f->time, "T");
}

size_t ovr_file_element(const ovr_file *f, const ovr_observable *which)
{
    return which->kind == OVR_KIND_FLAG ? 1 : f->element;
}

/* Creates a field; `y` is negative for a line contact. */
static bool make_field(ovr_file *f, const ovr_scales *scales, hid_t x, hid_t y,
                       size_t k)
{
    const ovr_observable *which = f->which[k];
    size_t element = ovr_file_element(f, which);
    dataset d = {.name = which->name,
                 .long_name = which->long_name,
                 .comment = which->comment,
                 .kind = which->kind,
                 .type = element == 1               ? H5T_STD_I8LE
                         : element == sizeof(float) ? H5T_IEEE_F32LE
                                                    : H5T_IEEE_F64LE,
                 .rows = 1,
                 .rank = 2,
                 .shape = {0, f->nodes},
                 .along = {f->time, x},
                 .deflate = f->deflate};
    if (y >= 0) {
        d.rank = 3;
        d.shape[1] = f->lines;
        d.shape[2] = f->nodes;
        d.along[1] = y;
        d.along[2] = x;
    }
    f->field[k] = ovr_header_dataset(f->file, &d, scales);
    return f->field[k] >= 0;
}

static dataset column_plan(const ovr_file *f, size_t c)
{
    const ovr_observable *o = f->row[c];
    return (dataset){.name = o->name,
                     .long_name = o->long_name,
                     .comment = o->comment,
                     .kind = o->kind,
                     .type = o->kind == OVR_KIND_COUNT  ? H5T_STD_I32LE
                             : o->kind == OVR_KIND_FLAG ? H5T_STD_I8LE
                                                        : H5T_IEEE_F64LE,
                     .rows = OVR_ROW_CHUNK,
                     .rank = 1,
                     .along = {f->step}};
}

/* Creates all columns, which share creation properties by type. */
static bool make_columns(ovr_file *f, hid_t group, const ovr_scales *scales)
{
    hid_t access = dataset_access(), whole = -1, number = -1;
    bool ok = true;
    for (size_t c = 0; ok && c < f->columns; c++) {
        dataset d = column_plan(f, c);
        hid_t *creation = d.type == H5T_IEEE_F64LE ? &number : &whole;
        if (*creation < 0)
            *creation = dataset_creation(&d);
        d.creation = *creation;
        d.access = access;
        d.attached_later = true;
        f->column[c] = ovr_header_dataset(group, &d, scales);
        ok = f->column[c] >= 0;
    }
    ovr_h5_drop(number);
    ovr_h5_drop(whole);
    ovr_h5_drop(access);
    return ok;
}

static bool make_history(ovr_file *f, const ovr_scales *scales)
{
    enum { LINK = 60 }; /* in bytes */
    dataset d = {.name = "step",
                 .long_name = "time step",
                 .kind = OVR_KIND_COUNT,
                 .type = H5T_STD_I32LE,
                 .rows = OVR_ROW_CHUNK,
                 .rank = 1};
    hid_t group = ovr_header_group(f->file, "history", (f->columns + 1) * LINK);
    bool ok = group >= 0;
    f->step = ok ? ovr_header_dataset(group, &d, scales) : -1;
    ok = f->step >= 0 && make_columns(f, group, scales) && attach_columns(f);
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

/* Returns the bytes of the case's attributes; a number with a unit has two. */
static size_t case_bytes(const ovr_write_options *o)
{
    size_t bytes = OVR_ATTRIBUTE;
    for (size_t k = 0; k < o->value_count; k++) {
        const ovr_case_value *value = &o->values[k];
        size_t count = value->unit && value->unit[0] ? 2 : 1;
        bytes += count * (OVR_ATTRIBUTE + 5 + strlen(value->name));
    }
    return bytes;
}

static bool make_case(const ovr_file *f, const ovr_write_options *o)
{
    hid_t group = ovr_header_group(f->file, "case", case_bytes(o));
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
                            o->title && o->title[0] ? o->title
                            : o->lines > 1
                                ? "Transient rough EHL line contact, a strip"
                                : "Transient rough EHL line contact") &&
           ovr_h5_set_chars(root, "history", line) &&
           ovr_h5_set_chars(root, "source", "overroll " OVERROLL_VERSION) &&
           ovr_h5_set_integer(root, "format_version",
                              o->lines > 1 ? OVR_FORMAT_STRIP
                                           : OVR_FORMAT_VERSION) &&
           ovr_h5_set_string(root, "status", "running") &&
           ovr_h5_set_string(root, "reason", "") &&
           ovr_h5_set_string(root, "warnings", "") &&
           ovr_h5_set_string(root, "date_created", date) &&
           ovr_h5_set_string(root, "date_modified", date) &&
           ovr_h5_set_number(root, "date_seconds", 0);
}

bool ovr_header_extremes(hid_t root, const ovr_scales *scales,
                         const ovr_statistics *total)
{
    bool (*put)(hid_t, const char *, double) = total ? ovr_h5_put_number
                                                     : ovr_h5_set_number;
    ovr_extreme e;
    bool ok = true;
    for (size_t k = 0; ok && ovr_extreme_at(k, &e); k++) {
        double value = total ? ovr_extreme_value(&e, total) : NAN;
        double si = value * ovr_kind_scale(e.kind, &scales->contact);
        if (e.of->needs && isnan(value))
            continue;
        ok = put(root, e.key, value) &&
             (!scales->physical || !*e.key_si || put(root, e.key_si, si));
    }
    return ok;
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
        {"time_end", end * ovr_factor(scales, OVR_KIND_TIME)},
    };
    bool ok = ovr_h5_set_string(root, "scaling",
                                scales->physical ? "SI" : "dimensionless");
    for (size_t k = 0; ok && k < sizeof number / sizeof *number; k++)
        ok = ovr_h5_set_number(root, number[k].name, number[k].value);
    return ok;
}

/* Writes the width of a strip and the line shown by default. */
static bool set_strip(hid_t root, const ovr_write_options *o)
{
    return o->lines <= 1 ||
           (ovr_h5_set_number(root, "strip_width_over_b", o->width) &&
            ovr_h5_set_number(root, "shown_line", (double)o->shown) &&
            ovr_h5_set_number(root, "shown_over_b", o->Y[o->shown]));
}

bool ovr_header_write(ovr_file *f, const ovr_file_plan *plan)
{
    hid_t x = -1, y = -1;
    bool ok = set_conventions(f->file, plan) &&
              set_scales(f->file, plan->scales, plan->options->end) &&
              set_strip(f->file, plan->options) &&
              ovr_header_extremes(f->file, plan->scales, NULL) &&
              make_time(f, plan->scales);
    if (ok)
        x = make_positions(f, plan);
    ok = x >= 0 && (!plan->weights || make_weights(f, plan, x));
    if (ok)
        y = make_lines(f, plan);
    ok = ok && (f->lines <= 1 || y >= 0);
    for (size_t k = 0; ok && k < f->fields; k++)
        ok = make_field(f, plan->scales, x, y, k);
    ok = ok && make_history(f, plan->scales) && make_case(f, plan->options);
    ovr_h5_drop(y);
    ovr_h5_drop(x);
    return ok;
}

static bool open_fields(ovr_file *f, const ovr_scales *scales)
{
    hid_t x = H5Dopen2(f->file, "x", H5P_DEFAULT), y = -1;
    bool ok = x >= 0;
    if (f->lines > 1)
        y = H5Dopen2(f->file, "y", H5P_DEFAULT);
    for (size_t k = 0; ok && k < f->fields; k++) {
        const char *name = f->which[k]->name;
        if (H5Lexists(f->file, name, H5P_DEFAULT) > 0)
            f->field[k] = H5Dopen2(f->file, name, H5P_DEFAULT);
        else
            make_field(f, scales, x, y, k);
        ok = f->field[k] >= 0;
    }
    ovr_h5_drop(y);
    ovr_h5_drop(x);
    return ok;
}

static bool open_columns(ovr_file *f, const ovr_scales *scales)
{
    hid_t group = H5Gopen2(f->file, "history", H5P_DEFAULT);
    bool ok = group >= 0;
    f->step = ok ? H5Dopen2(group, "step", H5P_DEFAULT) : -1;
    ok = f->step >= 0;
    for (size_t c = 0; ok && c < f->columns; c++) {
        dataset d = column_plan(f, c);
        f->column[c] = H5Lexists(group, d.name, H5P_DEFAULT) > 0
                           ? H5Dopen2(group, d.name, H5P_DEFAULT)
                           : ovr_header_dataset(group, &d, scales);
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
    return f->time >= 0 && open_fields(f, plan->scales) &&
           open_columns(f, plan->scales);
}
