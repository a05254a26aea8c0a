/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "support/gauges.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/test.h"
#include "surface/zip.h"

void gauge_make(gauge *g, uint64_t *seed, bool uniform, size_t lines, bool gaps)
{
    double x = test_random(seed, -1e-4, 1e-4), walk = 0;
    bool some = gaps && test_random(seed, 0, 3) < 1;
    g->n = (size_t)test_random(seed, 20, GAUGE_POINTS);
    g->lines = lines;
    g->uniform = uniform;
    g->dx = pow(10, test_random(seed, -8, -5));
    if (uniform)
        x = 0;
    for (size_t i = 0; i < g->n; i++) {
        g->x[i] = uniform ? (double)i * g->dx : x;
        x += g->dx * test_random(seed, 0.3, 1.7);
        for (size_t k = 0; k < lines; k++) {
            walk += test_random(seed, -1e-7, 1e-7);
            g->z[k][i] = walk;
            if (some && i && i + 1 < g->n && test_random(seed, 0, 8) < 1)
                g->z[k][i] = NAN;
        }
    }
}

/* ------------------------------------------------------------------ text */

typedef struct buffer {
    char *out;
    size_t used;
} buffer;

static void put(buffer *b, const char *format, ...) OVR_PRINTF(2, 3);
static void put(buffer *b, const char *format, ...)
{
    va_list args;
    int wrote;
    va_start(args, format);
    wrote = vsnprintf(b->out + b->used, GAUGE_BYTES - b->used, format, args);
    va_end(args);
    assert_true(wrote >= 0 && b->used + (size_t)wrote < GAUGE_BYTES);
    b->used += (size_t)wrote;
}

static void put_number(buffer *b, double value, bool comma)
{
    size_t from = b->used;
    if (isnan(value)) {
        put(b, "NaN");
        return;
    }
    put(b, "%.17g", value);
    for (; comma && from < b->used; from++)
        if (b->out[from] == '.')
            b->out[from] = ',';
}

/* Encodes UTF-8 whose only characters beyond ASCII are micro signs. */
static size_t encode(char *text, size_t size, gauge_encoding encoding)
{
    static char copy[GAUGE_BYTES];
    size_t used = 0;
    memcpy(copy, text, size);
    if (encoding == GAUGE_UTF8)
        return size;
    if (encoding == GAUGE_UTF8_MARK)
        memcpy(text, "\xEF\xBB\xBF", used = 3);
    if (encoding == GAUGE_UTF16_LITTLE)
        memcpy(text, "\xFF\xFE", used = 2);
    if (encoding == GAUGE_UTF16_BIG)
        memcpy(text, "\xFE\xFF", used = 2);
    for (size_t i = 0; i < size; i++) {
        char c = copy[i];
        if (c == '\xC2' && encoding != GAUGE_UTF8_MARK)
            continue; /* the next byte is the Latin-1 code */
        assert_true(used + 2 < GAUGE_BYTES);
        if (encoding == GAUGE_UTF16_BIG)
            text[used++] = 0;
        text[used++] = c;
        if (encoding == GAUGE_UTF16_LITTLE)
            text[used++] = 0;
    }
    return used;
}

size_t gauge_as_text(const gauge *g, const gauge_text *how, char *out)
{
    buffer b = {out, 0};
    bool comma = how->separator == ';';
    char s[3] = {how->separator == ' ' ? ',' : how->separator, 0, 0};
    put(&b, "Profile 7 of the \xC2\xB5-series%s", how->newline);
    put(&b, "%sx in mm%sz (\xC2\xB5m)%s", how->index ? "index," : "",
        how->index ? "," : s, how->newline);
    s[0] = how->separator;
    if (how->count)
        put(&b, "%zu%s", g->n, how->newline);
    for (size_t k = 0; k < g->n; k++) {
        size_t i = how->backwards ? g->n - 1 - k : k;
        if (how->index)
            put(&b, "%zu%s", i, s);
        put_number(&b, g->x[i] * 1e3, comma);
        put(&b, "%s", s);
        put_number(&b, g->z[0][i] * 1e6, comma);
        put(&b, "%s%s", how->trailing ? s : "", how->newline);
    }
    return encode(out, b.used, how->encoding);
}

/* ------------------------------------------------------------------- SDF */

size_t gauge_as_sdf_text(const gauge *g, char *out)
{
    buffer b = {out, 0};
    put(&b,
        "aISO-1.0\r\nManufacID = test\r\nCreateDate = 010120261200\r\n"
        "ModDate = 010120261200\r\nNumPoints = %zu\r\nNumProfiles = %zu\r\n"
        "Xscale = %.17g\r\nYscale = 1e-6\r\nZscale = 1e-6\r\n"
        "Zresolution = -1\r\nCompression = 0\r\nDataType = 7\r\n"
        "CheckType = 0\r\n*\r\n",
        g->n, g->lines, g->dx);
    for (size_t k = 0; k < g->lines; k++)
        for (size_t i = 0; i < g->n; i++) {
            if (isnan(g->z[k][i]))
                put(&b, "BAD");
            else
                put(&b, "%.17g", g->z[k][i] / 1e-6);
            put(&b, i % 5 == 4 ? "\r\n" : " ");
        }
    put(&b, "\r\n*\r\n");
    return b.used;
}

static void put_bits(buffer *b, uint64_t bits, size_t bytes)
{
    assert_true(b->used + bytes <= GAUGE_BYTES);
    for (size_t k = 0; k < bytes; k++)
        b->out[b->used++] = (char)(bits >> 8 * k & 0xFF);
}

static void put_f64(buffer *b, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_bits(b, bits, 8);
}

static void put_f32(buffer *b, double value)
{
    float narrow = (float)value;
    uint32_t bits;
    memcpy(&bits, &narrow, sizeof bits);
    put_bits(b, bits, 4);
}

static double largest(const gauge *g)
{
    double maximum = 0;
    for (size_t k = 0; k < g->lines; k++)
        for (size_t i = 0; i < g->n; i++)
            if (fabs(g->z[k][i]) > maximum)
                maximum = fabs(g->z[k][i]);
    return maximum;
}

/* Heights are about zero. They are shifted by half of the range of unsigned
 * types; levelling removes the shift. */
static void put_typed(buffer *b, double value, int type, double step)
{
    static const size_t bytes[] = {1, 2, 4, 4, 1, 2, 4, 8};
    static const double half[] = {128, 32768, 2147483648.0, 0, 0, 0, 0, 0};
    size_t size = bytes[type];
    if (type == 3)
        put_f32(b, value / step);
    else if (type == 7)
        put_f64(b, value / step);
    else if (isnan(value))
        put_bits(b, 1ull << (8 * size - 1), size);
    else
        put_bits(b, (uint64_t)(int64_t)round(value / step + half[type]), size);
}

size_t gauge_as_sdf_binary(const gauge *g, int type, char *out, double *step)
{
    static const double range[] = {120, 32000, 2e9, 1, 120, 32000, 2e9, 1};
    buffer b = {out, 0};
    *step = type == 3 || type == 7 ? 1e-6 : largest(g) / range[type];
    put(&b, "bISO-1.0%-10s%-12s%-12s", "test", "010120261200", "010120261200");
    put_bits(&b, g->n, 2);
    put_bits(&b, g->lines, 2);
    put_f64(&b, g->dx);
    put_f64(&b, 1e-6);
    put_f64(&b, *step);
    put_f64(&b, -1);
    put_bits(&b, 0, 1);
    put_bits(&b, (uint64_t)type, 1);
    put_bits(&b, 0, 1);
    assert_int_equal(b.used, 81);
    for (size_t k = 0; k < g->lines; k++)
        for (size_t i = 0; i < g->n; i++)
            put_typed(&b, g->z[k][i], type, *step);
    return b.used;
}

/* ------------------------------------------------------------------- SMD */

size_t gauge_as_smd(const gauge *g, char *out)
{
    buffer b = {out, 0};
    put(&b,
        "ISO 5436 - 2000 \"test\"\r\nPRF 0 made-up\r\n"
        "CX I %zu mm 1.0e0 D %.17g\r\nCZ A %zu um 1.0e0 D\r\n\x03\r\n",
        g->n, g->dx * 1e3, g->n);
    put(&b, "DATE 010126\r\nCOMMENT /* any text */\r\n\x03\r\n");
    for (size_t i = 0; i < g->n; i++) {
        if (isnan(g->z[0][i]))
            put(&b, "BAD");
        else
            put(&b, "%.17g", g->z[0][i] * 1e6);
        put(&b, "\r\n");
        if (i == 3)
            out[b.used++] = 0; /* white space */
    }
    put(&b, "\x03\r\n12345\r\n\x03\r\n");
    return b.used;
}

/* ------------------------------------------------------------------- X3P */

static void put_z(buffer *b, double value, const gauge_x3p *how, double step)
{
    double code = isnan(value) ? (how->mask ? 0 : NAN) : value;
    /* Whole numbers have no NaN; a mask marks missing heights. */
    int64_t whole = isnan(code) ? 0 : (int64_t)round(code / step);
    switch (how->type) {
    case 'I': put_bits(b, (uint64_t)whole, 2); break;
    case 'L': put_bits(b, (uint64_t)whole, 4); break;
    case 'F': put_f32(b, code); break;
    default: put_f64(b, code); break;
    }
}

static void put_axes(buffer *b, const gauge *g, const gauge_x3p *how,
                     double step, const char *p)
{
    put(b, "<%sAxes>", p);
    if (how->stored_x)
        put(b,
            "<%sCX><%sAxisType>A</%sAxisType><%sDataType>D</%sDataType>"
            "</%sCX>",
            p, p, p, p, p, p);
    else
        put(b,
            "<%sCX><%sAxisType>I</%sAxisType><%sIncrement> %.17g "
            "</%sIncrement><%sOffset>0</%sOffset></%sCX>",
            p, p, p, p, g->dx, p, p, p, p);
    put(b,
        "<%sCY><%sAxisType>I</%sAxisType><%sIncrement>1e-6</%sIncrement>"
        "</%sCY>",
        p, p, p, p, p, p);
    put(b,
        "<%sCZ><%sAxisType>A</%sAxisType><%sDataType>%c</%sDataType>"
        "<%sIncrement>%.17g</%sIncrement><%sOffset>0</%sOffset></%sCZ>",
        p, p, p, p, how->type, p, p, step, p, p, p, p);
    put(b, "</%sAxes>", p);
}

static void put_data_list(buffer *b, const gauge *g, const gauge_x3p *how,
                          double step, const char *p)
{
    put(b, "<%sDataList>\n", p);
    for (size_t k = 0; k < g->lines; k++)
        for (size_t i = 0; i < g->n; i++) {
            put(b, "<%sDatum>", p);
            if (how->stored_x)
                put(b, "%.17g;", g->x[i]);
            if (isnan(g->z[k][i]))
                put(b, "NaN");
            else
                put(b, "%.17g",
                    how->type == 'I' || how->type == 'L'
                        ? round(g->z[k][i] / step)
                        : g->z[k][i] / step);
            put(b, "</%sDatum>\n", p);
        }
    put(b, "</%sDataList>", p);
}

static size_t main_xml(const gauge *g, const gauge_x3p *how, double step,
                       char *out)
{
    buffer b = {out, 0};
    const char *p = how->prefix ? "p:" : "";
    put(&b, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<p:ISO5436_2 "
            "xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n");
    put(&b,
        "<%sRecord1><%sRevision>ISO5436 - 2000</%sRevision>"
        "<%sFeatureType>%s</%sFeatureType>",
        p, p, p, p, g->lines > 1 ? "SUR" : "PRF", p);
    put_axes(&b, g, how, step, p);
    put(&b, "</%sRecord1>\n<%sRecord3>", p, p);
    if (how->list)
        put(&b, "<%sListDimension>%zu</%sListDimension>", p, g->n, p);
    else
        put(&b,
            "<%sMatrixDimension><%sSizeX>%zu</%sSizeX><%sSizeY>%zu"
            "</%sSizeY><%sSizeZ>1</%sSizeZ></%sMatrixDimension>",
            p, p, g->n, p, p, g->lines, p, p, p, p);
    if (how->inline_data)
        put_data_list(&b, g, how, step, p);
    else
        put(&b,
            "<%sDataLink><%sPointDataLink>bindata/data.bin"
            "</%sPointDataLink>%s%s%s</%sDataLink>",
            p, p, p,
            how->mask && how->prefix ? "<p:ValidPointsLink>"
            : how->mask              ? "<ValidPointsLink>"
                                     : "",
            how->mask ? "bindata/valid.bin" : "",
            how->mask && how->prefix ? "</p:ValidPointsLink>"
            : how->mask              ? "</ValidPointsLink>"
                                     : "",
            p);
    put(&b, "</%sRecord3></p:ISO5436_2>\n", p);
    return b.used;
}

typedef struct parts {
    ovr_arena arena;
    ovr_zip_file file[3];
    size_t count;
} parts;

static void add(parts *to, const gauge_x3p *how, const char *name,
                const char *data, size_t size)
{
    char path[300];
    char *kept = ovr_arena_take(&to->arena, size + 1, 1, NULL);
    assert_non_null(kept);
    memcpy(kept, data, size);
    snprintf(path, sizeof path, "%s%s", how->folder, name);
    to->file[to->count++] = (ovr_zip_file){
        ovr_arena_text(&to->arena, path, NULL), kept, size};
}

static void write_parts(parts *from, bool stored, const char *path)
{
    FILE *to = fopen(path, "wb");
    assert_non_null(to);
    assert_true(
        ovr_zip_write(to, from->file, from->count, stored, &from->arena));
    assert_int_equal(fclose(to), 0);
    ovr_arena_release(&from->arena);
}

void gauge_to_x3p(const gauge *g, const gauge_x3p *how, const char *path,
                  double *step)
{
    static char out[GAUGE_BYTES];
    parts zip = {.arena = ovr_arena_make(NULL)};
    buffer data = {out, 0};
    char mask[GAUGE_POINTS * GAUGE_LINES / 8 + 1] = {0};
    size_t total = g->n * g->lines;
    *step = how->type == 'I'   ? largest(g) / 32000
            : how->type == 'L' ? largest(g) / 2e9
                               : 1;
    for (size_t j = 0; j < total; j++) {
        double z = g->z[j / g->n][j % g->n];
        if (how->stored_x)
            put_f64(&data, g->x[j % g->n]);
        put_z(&data, z, how, *step);
        if (!isnan(z))
            mask[j / 8] = (char)((unsigned char)mask[j / 8] | 1u << j % 8);
    }
    if (!how->inline_data)
        add(&zip, how, "bindata/data.bin", out, data.used);
    if (how->mask && !how->inline_data)
        add(&zip, how, "bindata/valid.bin", mask, (total + 7) / 8);
    add(&zip, how, "main.xml", out, main_xml(g, how, *step, out));
    write_parts(&zip, !how->deflate, path);
}
