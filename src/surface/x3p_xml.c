/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * main.xml of X3P through expat: the texts of the elements below, found by
 * the end of their path, in or out of a namespace.  A document type (and so
 * any entity) is refused.
 */
#include <expat.h>
#include <math.h>
#include <string.h>

#include "base/error.h"
#include "base/text.h"
#include "surface/x3p.h"

enum { DEPTH = 16, NAME = 32, TEXT = 256 };

typedef struct reading {
    ovr_x3p *x3p;
    XML_Parser parser;
    char path[DEPTH][NAME];
    int depth;
    char text[TEXT];
    size_t used;
    bool too_long;
    size_t capacity; /* for inline data */
    const char *wrong;
    long line;
} reading;

/* -------------------------------------------------------------- the texts */

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

static void end_axis(reading *r, ovr_x3p_axis *a, const char *name,
                     ovr_line text)
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
    ovr_x3p *x = r->x3p;
    if (text.size + 1 > r->capacity - x->datum_size) {
        wrong(r,
              "a Datum must contain numbers only"); /* letters grow as UTF-8 */
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
    ovr_x3p *x = r->x3p;
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

/* Texts longer than any of ours are skipped. */
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

ovr_status ovr_x3p_parse(ovr_bytes xml, const char *file, ovr_arena *arena,
                         ovr_x3p *x3p, ovr_error *err)
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
