/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * X3P, ISO 25178-72: a ZIP with main.xml (a folder may precede the names) and
 * the points, in a binary file or inline; little-endian, x fastest, of each
 * point only the absolute axes.  coordinate = offset + stored x increment, in
 * metres.  Points may be missing: NaN, or a 0 in the mask of valid points.
 */
#include <expat.h>
#include <limits.h>
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/areal.h"
#include "surface/binary.h"
#include "surface/profile.h"
#include "surface/zip.h"

typedef struct x3p_axis {
    bool given;
    char kind; /* I: index times increment, A: stored coordinates */
    char type; /* I int16, L int32, F float, D double */
    double increment, offset;
} x3p_axis;

typedef struct x3p_file {
    char feature[8]; /* PRF, SUR, ... */
    x3p_axis axis[3];
    double size[3]; /* MatrixDimension; 0: not given */
    double list;    /* ListDimension; 0: not given */
    char data[256]; /* name of the binary file; "": data in main.xml */
    char valid[256];
    char *datum; /* data in main.xml: all <Datum> texts, NUL-terminated */
    size_t datum_size, datums;
} x3p_file;

/* ----------------------------------------------------------------- main.xml */

/*
 * Reads main.xml of X3P by expat: the texts of the elements below, identified
 * by the end of their path, with or without a namespace. A document type, and
 * therefore any entity, is rejected.
 */

enum { DEPTH = 16, NAME = 32, TEXT = 256 };

typedef struct reading {
    x3p_file *x3p;
    XML_Parser parser;
    char path[DEPTH][NAME];
    int depth;
    char text[TEXT];
    size_t used;
    bool too_long;
    size_t capacity; /* for data in main.xml */
    const char *wrong;
    long line;
} reading;

/* ------------------------------------------------------ texts of elements */

static void wrong(reading *r, const char *what)
{
    if (!r->wrong) {
        r->wrong = what;
        r->line = (long)XML_GetCurrentLineNumber(r->parser);
    }
    XML_StopParser(r->parser, XML_FALSE);
}

static bool path_ends(const reading *r, const char *parent, const char *name)
{
    return r->depth >= 2 && r->depth <= DEPTH &&
           strcmp(r->path[r->depth - 2], parent) == 0 &&
           strcmp(r->path[r->depth - 1], name) == 0;
}

static double number_of(reading *r, ovr_line text)
{
    double value = 0;
    if (!ovr_number(text, false, &value))
        wrong(r, "a number is needed");
    return value;
}

static void copy_text(reading *r, ovr_line text, char *into, size_t capacity)
{
    if (text.size + 1 > capacity) {
        wrong(r, "the text is too long");
        return;
    }
    memcpy(into, text.text, text.size);
    into[text.size] = 0;
}

static void end_axis(reading *r, x3p_axis *a, const char *name, ovr_line text)
{
    a->given = true;
    if (path_ends(r, name, "AxisType"))
        a->kind = text.size ? text.text[0] : 0;
    else if (path_ends(r, name, "DataType"))
        a->type = text.size ? text.text[0] : 0;
    else if (path_ends(r, name, "Increment") && text.size)
        a->increment = number_of(r, text);
    else if (path_ends(r, name, "Offset") && text.size)
        a->offset = number_of(r, text);
}

static void end_datum(reading *r, ovr_line text)
{
    x3p_file *x = r->x3p;
    if (text.size + 1 > r->capacity - x->datum_size) {
        wrong(r,
              /* non-ASCII letters take more bytes in UTF-8 */
              "a Datum must contain numbers only");
        return;
    }
    memcpy(x->datum + x->datum_size, text.text, text.size);
    x->datum_size += text.size;
    x->datum[x->datum_size++] = 0;
    x->datums++;
}

static ovr_line trimmed(const reading *r)
{
    ovr_line text = {r->text, r->used, 0};
    while (text.size && (text.text[0] == '\n' || text.text[0] == '\r' ||
                         text.text[0] == ' ' || text.text[0] == '\t'))
        text.text++, text.size--;
    while (text.size && strchr("\n\r \t", text.text[text.size - 1]))
        text.size--;
    return text;
}

static void end_leaf(reading *r, ovr_line text)
{
    static const char *const axes[] = {"CX", "CY", "CZ"};
    static const char *const sizes[] = {"SizeX", "SizeY", "SizeZ"};
    x3p_file *x = r->x3p;
    for (int k = 0; k < 3; k++) {
        if (r->depth >= 2 && strcmp(r->path[r->depth - 2], axes[k]) == 0)
            end_axis(r, &x->axis[k], axes[k], text);
        if (path_ends(r, "MatrixDimension", sizes[k]))
            x->size[k] = number_of(r, text);
    }
    if (path_ends(r, "Record1", "FeatureType"))
        copy_text(r, text, x->feature, sizeof x->feature);
    else if (path_ends(r, "Record3", "ListDimension"))
        x->list = number_of(r, text);
    else if (path_ends(r, "DataLink", "PointDataLink"))
        copy_text(r, text, x->data, sizeof x->data);
    else if (path_ends(r, "DataLink", "ValidPointsLink"))
        copy_text(r, text, x->valid, sizeof x->valid);
    else if (path_ends(r, "DataList", "Datum"))
        end_datum(r, text);
}

/* --------------------------------------------------------- expat's events */

static void XMLCALL on_start(void *data, const XML_Char *name,
                             const XML_Char **attributes)
{
    reading *r = data;
    const char *local = strrchr(name, ':');
    size_t size;
    (void)attributes;
    local = local ? local + 1 : name;
    size = strlen(local);
    r->used = 0;
    r->too_long = false;
    if (r->depth >= DEPTH) {
        wrong(r, "elements are nested too deeply");
        return;
    }
    if (size >= NAME)
        size = NAME - 1;
    memcpy(r->path[r->depth], local, size);
    r->path[r->depth++][size] = 0;
}

static void XMLCALL on_end(void *data, const XML_Char *name)
{
    reading *r = data;
    (void)name;
    if (!r->too_long)
        end_leaf(r, trimmed(r));
    r->used = 0;
    if (r->depth > 0)
        r->depth--;
}

/* Collects the text of an element; texts longer than any expected one are
 * ignored. */
static void XMLCALL on_text(void *data, const XML_Char *text, int size)
{
    reading *r = data;
    if (r->used + (size_t)size > TEXT) {
        r->too_long = true;
        return;
    }
    memcpy(r->text + r->used, text, (size_t)size);
    r->used += (size_t)size;
}

static void XMLCALL on_doctype(void *data, const XML_Char *name,
                               const XML_Char *system, const XML_Char *public,
                               int internal)
{
    (void)name, (void)system, (void)public, (void)internal;
    wrong(data, "X3P must not contain a document type");
}

static ovr_status run(reading *r, ovr_bytes xml, const char *file,
                      ovr_error *err)
{
    XML_SetUserData(r->parser, r);
    XML_SetElementHandler(r->parser, on_start, on_end);
    XML_SetCharacterDataHandler(r->parser, on_text);
    XML_SetStartDoctypeDeclHandler(r->parser, on_doctype);
    if (XML_Parse(r->parser, xml.data, (int)xml.size, XML_TRUE) ==
        XML_STATUS_OK)
        return OVR_OK;
    if (!r->wrong) {
        r->line = (long)XML_GetCurrentLineNumber(r->parser);
        r->wrong = XML_ErrorString(XML_GetErrorCode(r->parser));
    }
    return ovr_fail_at(err, OVR_BAD_INPUT, file, 0, "main.xml:%ld: %s", r->line,
                       r->wrong ? r->wrong : "not XML");
}

/* Parses main.xml; data contained in it are stored in the arena. */
static ovr_status x3p_parse(ovr_bytes xml, const char *file, ovr_arena *arena,
                            x3p_file *x3p, ovr_error *err)
{
    reading r = {.x3p = x3p, .capacity = xml.size + 1};
    ovr_status status;
    for (int k = 0; k < 3; k++)
        x3p->axis[k].increment = 1;
    x3p->datum = ovr_arena_take(arena, xml.size + 1, 1, err);
    if (!x3p->datum)
        return OVR_NO_MEMORY;
    r.parser = XML_ParserCreate(NULL);
    if (!r.parser)
        return ovr_fail(err, OVR_NO_MEMORY, "out of memory for reading XML");
    status = run(&r, xml, file, err);
    XML_ParserFree(r.parser);
    return status;
}

typedef struct package {
    ovr_zip zip;
    ovr_profile *profile;
    char folder[256]; /* path of main.xml's folder in the archive */
    ovr_arena arena;  /* memory of unpacked files */
    x3p_file x;
    size_t n, lines;     /* points per line, and lines */
    double *x_of, *y_of; /* stored coordinates; NULL: increments */
} package;

/* --------------------------------------------------------------- the ZIP */

/* Finds main.xml, at the top or in a folder. */
static const ovr_zip_entry *find_main(package *k)
{
    for (size_t i = 0; i < k->zip.entries; i++) {
        const char *name = k->zip.entry[i].name;
        const char *slash = strrchr(name, '/');
        const char *base = slash ? slash + 1 : name;
        size_t folder = (size_t)(base - name);
        if (strcmp(base, "main.xml") != 0 || folder >= sizeof k->folder)
            continue;
        memcpy(k->folder, name, folder);
        k->folder[folder] = 0;
        return &k->zip.entry[i];
    }
    return NULL;
}

/* Unpacks an entry. Sizes in a ZIP's directory may be wrong, so the size is
 * limited and must equal that of the content. */
static ovr_status unpack(package *k, const ovr_zip_entry *entry,
                         const char *name, ovr_bytes *out, ovr_error *err)
{
    const size_t maximum = strcmp(name, "main.xml") ? OVR_CONTENT_MAX
                                                    : OVR_CONTENT_MAX / 4;
    const char *file = k->profile->file, *wrong;
    char *data;
    if (entry->size > maximum)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "its '%s' is larger than the maximum of %zu bytes",
                           name, maximum);
    data = ovr_arena_take(&k->arena, (size_t)entry->size, 1, err);
    if (!data)
        return OVR_NO_MEMORY;
    wrong = ovr_zip_unpack(&k->zip, entry, data);
    if (wrong)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0, "its '%s' is %s", name,
                           wrong);
    *out = (ovr_bytes){data, (size_t)entry->size};
    return OVR_OK;
}

static ovr_status unpack_named(package *k, const char *link, ovr_bytes *out,
                               ovr_error *err)
{
    char name[sizeof k->folder + 256];
    const ovr_zip_entry *entry;
    size_t folder = strlen(k->folder), size = strlen(link);
    memcpy(name, k->folder, folder);
    memcpy(name + folder, link, size + 1);
    entry = ovr_zip_find(&k->zip, name);
    if (!entry)
        entry = ovr_zip_find(&k->zip, link);
    if (!entry)
        return ovr_fail_at(err, OVR_BAD_INPUT, k->profile->file, 0,
                           "'%s' is missing in main.xml",
                           ovr_quote((ovr_line){link, size, 0}).text);
    return unpack(k, entry, ovr_quote((ovr_line){link, size, 0}).text, out,
                  err);
}

/* ------------------------------------------ checks of the announced sizes */

static ovr_status check(package *k, ovr_error *err)
{
    const char *file = k->profile->file;
    const x3p_file *x = &k->x;
    const x3p_axis *cx = &x->axis[0], *cz = &x->axis[2];
    double points = x->list > 0 ? x->list : x->size[0], rows = 1;
    if (x->list <= 0 && x->size[1] > 1)
        rows = x->size[1];
    if (strcmp(x->feature, "PRF") != 0 && strcmp(x->feature, "SUR") != 0)
        return ovr_fail_at(
            err, OVR_BAD_INPUT, file, 0, "FeatureType '%s': must be PRF or SUR",
            ovr_quote((ovr_line){x->feature, strlen(x->feature), 0}).text);
    if (!cx->given || !cz->given || cz->kind != 'A' ||
        (cx->kind != 'I' && cx->kind != 'A'))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "main.xml needs the axes CX (I or A) and CZ (A)");
    if (cx->kind == 'I' && !(cx->increment > 0))
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "the increment of CX, %g m, must be positive",
                           cx->increment);
    if (!(points >= 2 && rows >= 1 && points * rows <= OVR_POINTS_MAX) ||
        points != floor(points) || rows != floor(rows) || x->size[2] > 1)
        return ovr_fail_at(err, OVR_BAD_INPUT, file, 0,
                           "%g x %g x %g points: must be one layer of 2 to "
                           "%d points",
                           points, rows, x->size[2], OVR_POINTS_MAX);
    k->n = (size_t)points;
    k->lines = (size_t)rows;
    return OVR_OK;
}

static bool binary_type(char letter, ovr_binary *type)
{
    switch (letter) {
    case 'I': *type = OVR_BINARY_I16; return true;
    case 'L': *type = OVR_BINARY_I32; return true;
    case 'F': *type = OVR_BINARY_F32; return true;
    case 'D': *type = OVR_BINARY_F64; return true;
    default: return false;
    }
}

static bool is_stored(const x3p_file *x, int axis)
{
    return x->axis[axis].given && x->axis[axis].kind == 'A';
}

static double coordinate(const x3p_axis *a, double stored)
{
    return a->offset + stored * a->increment;
}

/* -------------------------------------------------------------- the points */

/* Returns the spacing of the rows; without one, that of the points. */
static double row_distance(const x3p_file *x)
{
    const x3p_axis *cx = &x->axis[0], *cy = &x->axis[1];
    if (cy->given && cy->kind == 'I' && cy->increment > 0)
        return cy->increment;
    return cx->kind == 'I' ? cx->increment : 1;
}

/* Allocates memory for heights and stored coordinates. */
static ovr_status reserve(package *k, ovr_error *err)
{
    const x3p_axis *cx = &k->x.axis[0];
    size_t all = k->n * k->lines;
    if (cx->kind == 'A' &&
        !(k->x_of = ovr_arena_take(&k->arena, all, sizeof *k->x_of, err)))
        return OVR_NO_MEMORY;
    if (is_stored(&k->x, 1) && k->lines > 1 &&
        !(k->y_of = ovr_arena_take(&k->arena, all, sizeof *k->y_of, err)))
        return OVR_NO_MEMORY;
    return ovr_areal_reserve(k->profile, k->n, k->lines,
                             cx->kind == 'I' ? cx->increment : 1,
                             row_distance(&k->x), err);
}

static ovr_status read_binary(package *k, ovr_error *err)
{
    ovr_profile *p = k->profile;
    const x3p_file *x = &k->x;
    const size_t all = k->n * k->lines;
    ovr_binary type[3] = {OVR_BINARY_U8, OVR_BINARY_U8, OVR_BINARY_U8};
    size_t place[3] = {0}, stride = 0;
    ovr_bytes data;
    ovr_status status;
    for (int a = 0; a < 3; a++) {
        if (!is_stored(x, a))
            continue;
        if (!binary_type(x->axis[a].type, &type[a]))
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "the DataType of an axis must be I, L, F or D");
        place[a] = stride;
        stride += ovr_binary_size(type[a]);
    }
    status = unpack_named(k, x->data, &data, err);
    if (status)
        return status;
    if (!stride || data.size / stride < all)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "the points are truncated at offset %zu; %zu "
                           "points of %zu bytes are announced",
                           data.size, all, stride);
    status = reserve(k, err);
    for (size_t i = 0; i < all && !status; i++) {
        const char *at = data.data + i * stride;
        if (k->x_of)
            k->x_of[i] = ovr_binary_value(at + place[0], type[0]);
        if (k->y_of)
            k->y_of[i] = ovr_binary_value(at + place[1], type[1]);
        p->map.z[i] = ovr_binary_value(at + place[2], type[2]);
    }
    return status;
}

/* Reads "x;y;z" of the absolute axes; the point is missing if there is no
 * text. */
static ovr_status read_datum(const package *k, const char *text, size_t i,
                             ovr_error *err)
{
    const ovr_profile *p = k->profile;
    double *const to[3] = {k->x_of, k->y_of, p->map.z};
    ovr_line piece = {text, 0, 0};
    for (int a = 0; a < 3; a++) {
        double number = NAN;
        if (!is_stored(&k->x, a))
            continue;
        piece.text = text;
        piece.size = strcspn(text, ";,");
        text += piece.size + (text[piece.size] != 0);
        piece = ovr_trim(piece);
        if (!ovr_number(piece, false, &number) && !ovr_is_missing(piece))
            return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                               "Datum %zu: '%s' must be a number", i + 1,
                               ovr_quote(piece).text);
        if (to[a])
            to[a][i] = number;
    }
    return OVR_OK;
}

static ovr_status read_inline(package *k, ovr_error *err)
{
    const x3p_file *x = &k->x;
    const char *text = x->datum;
    ovr_status status = OVR_OK;
    if (x->datums < k->n * k->lines)
        return ovr_fail_at(err, OVR_BAD_INPUT, k->profile->file, 0,
                           "the DataList ends after %zu points, but %zu are "
                           "announced",
                           x->datums, k->n * k->lines);
    status = reserve(k, err);
    for (size_t i = 0; i < k->n * k->lines && !status; i++) {
        status = read_datum(k, text, i, err);
        text += strlen(text) + 1;
    }
    return status;
}

static ovr_status apply_mask(package *k, ovr_error *err)
{
    ovr_bytes mask;
    ovr_status status;
    if (!*k->x.valid)
        return OVR_OK;
    status = unpack_named(k, k->x.valid, &mask, err);
    if (status)
        return status;
    if (mask.size < (k->n * k->lines + 7) / 8)
        return ovr_fail_at(err, OVR_BAD_INPUT, k->profile->file, 0,
                           "the mask of valid points is truncated at offset "
                           "%zu",
                           mask.size);
    for (size_t i = 0; i < k->n * k->lines; i++)
        if (!((unsigned char)mask.data[i / 8] >> i % 8 & 1))
            k->profile->map.z[i] = NAN;
    return OVR_OK;
}

/* Uses a row, counted from 0, as the profile, with its stored x. */
static ovr_status place_row(package *k, size_t row, ovr_error *err)
{
    ovr_profile *p = k->profile;
    const x3p_axis *cx = &k->x.axis[0], *cz = &k->x.axis[2];
    const double *x = k->x_of + row * k->n, *z = p->map.z + row * k->n;
    ovr_status status = ovr_profile_reserve(p, k->n, err);
    if (status)
        return status;
    ovr_profile_drop_codes(p, p->map.z, k->n * k->lines);
    for (size_t i = 0; i < k->n; i++) {
        p->x[i] = coordinate(cx, x[i]);
        p->z[i] = coordinate(cz, z[i]);
    }
    if (k->lines > 1)
        ovr_profile_note(p, "row %zu of %zu", row + 1, k->lines);
    ovr_profile_note(p, "X3P is in metres: x as stored");
    if (k->lines > 1)
        p->view.columns = k->n; /* no grid, so no rows */
    return ovr_profile_finish(p, k->n, err);
}

/* Checks that the stored x of a grid are the same in every row and equally
 * spaced, within a tenth of the spacing. */
static ovr_status check_grid(const package *k, double *dx, ovr_error *err)
{
    double first = k->x_of[0], last = k->x_of[k->n - 1];
    *dx = (last - first) / (double)(k->n - 1);
    for (size_t i = 0; i < k->n * k->lines; i++) {
        double right = first + (double)(i % k->n) * *dx;
        if (!(fabs(k->x_of[i] - right) < 0.1 * fabs(*dx)))
            return ovr_fail_at(err, OVR_BAD_INPUT, k->profile->file, 0,
                               "x of point %zu is not on a regular grid; "
                               "select a %s",
                               i + 1, ovr_named(k->profile, "row").text);
    }
    return OVR_OK;
}

static ovr_status place_points(package *k, const ovr_profile_source *source,
                               ovr_error *err)
{
    ovr_profile *p = k->profile;
    const x3p_axis *cx = &k->x.axis[0], *cy = &k->x.axis[1];
    const x3p_axis *cz = &k->x.axis[2];
    size_t all = k->n * k->lines;
    double dx = p->map.dx, dy = p->map.dy;
    if (k->x_of && k->lines == 1)
        return place_row(k, 0, err);
    if (k->x_of && check_grid(k, &dx, err)) {
        /* A selected row is used directly. */
        if (source->row > 0 && (size_t)source->row <= k->lines && !p->map_only)
            return place_row(k, (size_t)source->row - 1, err);
        return OVR_BAD_INPUT;
    }
    if (k->y_of)
        dy = (k->y_of[all - 1] - k->y_of[0]) * cy->increment /
             (double)(k->lines - 1);
    if (k->x_of)
        dx *= cx->increment;
    if (!(fabs(dx) > 0) || !isfinite(dx) || !(fabs(dy) > 0) || !isfinite(dy))
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "the spacings of points, %g m and %g m, must not "
                           "be 0",
                           dx, dy);
    p->map.dx = fabs(dx);
    p->map.dy = fabs(dy);
    ovr_profile_drop_codes(p, p->map.z, all);
    for (size_t i = 0; i < all; i++)
        p->map.z[i] = coordinate(cz, p->map.z[i]);
    p->offset = cx->kind == 'I' ? cx->offset : 0;
    ovr_profile_note(p, "X3P is in metres: %s",
                     cx->kind == 'I' ? "equal distances" : "x as stored");
    return ovr_areal_finish(p, source, 1, err);
}

static ovr_status read_package(package *k, const ovr_profile_source *source,
                               ovr_error *err)
{
    ovr_profile *p = k->profile;
    const ovr_zip_entry *entry = find_main(k);
    ovr_bytes xml;
    ovr_status status;
    if (!entry)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "is a ZIP archive without main.xml, not X3P");
    status = unpack(k, entry, "main.xml", &xml, err);
    if (!status)
        status = x3p_parse(xml, p->file, &k->arena, &k->x, err);
    if (!status)
        status = check(k, err);
    if (!status)
        status = *k->x.data ? read_binary(k, err) : read_inline(k, err);
    if (!status)
        status = apply_mask(k, err);
    return status ? status : place_points(k, source, err);
}

ovr_status ovr_read_x3p(ovr_profile *profile, const ovr_profile_source *source,
                        ovr_bytes content, ovr_error *err)
{
    package k = {.profile = profile};
    ovr_status status;
    profile->view.format = "X3P";
    k.arena = ovr_arena_make(&profile->arena.allocator);
    status = ovr_zip_open(&k.zip, content, k.profile->file, &k.arena, err);
    if (!status)
        status = read_package(&k, source, err);
    ovr_arena_release(&k.arena);
    return status;
}
