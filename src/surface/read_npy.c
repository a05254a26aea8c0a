/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * NumPy .npy, versions 1 to 3: an array of heights, of one dimension (a line)
 * or of two (rows, columns).
 *
 * "\x93NUMPY", major and minor version u8, size of the header u16 (version 1)
 * or u32, little-endian; the header is a dictionary of Python,
 *     {'descr': '<f8', 'fortran_order': False, 'shape': (300, 400), }
 * Spacing and unit of the heights are not in the file.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/error.h"
#include "base/quantity.h"
#include "surface/areal.h"
#include "surface/binary.h"

typedef struct npy {
    ovr_binary type; /* integer type or floating point */
    size_t bytes;    /* bytes of a value */
    bool big;        /* most significant byte first (big endian) */
    bool columns;    /* stored by columns */
    size_t shape[2]; /* rows, columns */
    size_t start;    /* offset of the values */
} npy;

static ovr_status fail(const ovr_profile *p, ovr_error *err, const char *what)
{
    return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0, "NumPy header: %s",
                       what);
}

/* Returns the text after 'NAME': in the header, NUL-terminated; NULL if
 * absent. */
static const char *value_of(const char *header, const char *name)
{
    const char *at = strstr(header, name);
    at = at ? strchr(at, ':') : NULL;
    return at ? at + 1 + strspn(at + 1, " ") : NULL;
}

static bool read_type(const char *text, npy *h)
{
    static const struct {
        const char *name;
        ovr_binary type;
    } types[] = {{"f8", OVR_BINARY_F64}, {"f4", OVR_BINARY_F32},
                 {"i4", OVR_BINARY_I32}, {"i2", OVR_BINARY_I16},
                 {"i1", OVR_BINARY_I8},  {"u4", OVR_BINARY_U32},
                 {"u2", OVR_BINARY_U16}, {"u1", OVR_BINARY_U8}};
    if (!text || (*text != '\'' && *text != '"') || !strchr("<>|=", text[1]) ||
        !text[1])
        return false;
    h->big = text[1] == '>';
    for (size_t k = 0; k < sizeof types / sizeof *types; k++)
        if (!strncmp(text + 2, types[k].name, 2) && text[4] == *text) {
            h->type = types[k].type;
            h->bytes = ovr_binary_size(h->type);
            return true;
        }
    return false;
}

static bool read_shape(const char *text, npy *h)
{
    size_t count = 0;
    if (!text || *text != '(')
        return false;
    for (text++; *text && *text != ')' && count < 2; count++) {
        char *end;
        text += strspn(text, " ");
        if (*text < '0' || *text > '9')
            return false;
        h->shape[count] = strtoul(text, &end, 10);
        text = end + strspn(end, " ");
        text += *text == ',';
        text += strspn(text, " ");
    }
    if (count == 1) { /* a single line */
        h->shape[1] = h->shape[0];
        h->shape[0] = 1;
    }
    return *text == ')' && count > 0;
}

static ovr_status read_header(const ovr_profile *p, ovr_bytes c, npy *h,
                              ovr_error *err)
{
    char header[1024];
    const char *order;
    size_t from, size;
    if (c.size < 12)
        return fail(p, err, "cut off");
    from = c.data[6] == 1 ? 10 : 12;
    size = (size_t)ovr_binary_value(
        c.data + 8, c.data[6] == 1 ? OVR_BINARY_U16 : OVR_BINARY_U32);
    if (c.data[6] < 1 || c.data[6] > 3)
        return fail(p, err, "only versions 1 to 3 are supported");
    if (size > c.size - from)
        return fail(p, err, "cut off");
    h->start = from + size;
    size = size < sizeof header ? size : sizeof header - 1;
    memcpy(header, c.data + from, size);
    header[size] = 0;
    order = value_of(header, "fortran_order");
    if (!read_type(value_of(header, "descr"), h))
        return fail(p, err,
                    "descr must be a number type, one of f4, f8, i1, i2, i4, "
                    "u1, u2, u4");
    if (!order || !read_shape(value_of(header, "shape"), h))
        return fail(p, err, "shape must have one or two dimensions");
    h->columns = !strncmp(order, "True", 4);
    if (h->shape[1] > OVR_POINTS_MAX || h->shape[0] > OVR_POINTS_MAX ||
        (double)h->shape[0] * (double)h->shape[1] * (double)h->bytes >
            (double)(c.size - h->start))
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, 0,
                           "offset %zu: truncated; the header announces %zu "
                           "x %zu values of %zu bytes",
                           c.size, h->shape[0], h->shape[1], h->bytes);
    return OVR_OK;
}

static double value_at(const npy *h, const char *at)
{
    char turned[8];
    if (!h->big)
        return ovr_binary_value(at, h->type);
    for (size_t k = 0; k < h->bytes; k++)
        turned[k] = at[h->bytes - 1 - k];
    return ovr_binary_value(turned, h->type);
}

ovr_status ovr_read_npy(ovr_profile *p, const ovr_profile_source *source,
                        ovr_bytes c, ovr_error *err)
{
    npy h = {.bytes = 0};
    double dx, dy, scale = 1;
    ovr_status status = read_header(p, c, &h, err);
    p->view.format = "NumPy";
    if (!status)
        status = ovr_areal_need_spacing(p, source, &dx, &dy, &scale, err);
    if (!status)
        status = ovr_areal_reserve(p, h.shape[1], h.shape[0], dx, dy, err);
    if (status)
        return status;
    for (size_t j = 0; j < h.shape[0]; j++)
        for (size_t i = 0; i < h.shape[1]; i++) {
            size_t k = h.columns ? i * h.shape[0] + j : j * h.shape[1] + i;
            p->map.z[j * h.shape[1] + i] = value_at(&h, c.data + h.start +
                                                            k * h.bytes);
        }
    return ovr_areal_finish(p, source, scale, err);
}
