/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The flow law of [lubricant]; its points from a file. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "case/resolve.h"

enum { POINTS_MOST = 10000 };

/* What is read: stresses in Pa, rates in 1/s. */
typedef struct points {
    const char *file;
    double unit; /* of the stress, Pa; 0: its header was not read yet */
    bool rate_first;
    double *shear, *rate;
    size_t count;
} points;

/* "rate [1/s], stress [MPa]", in this order or the other. */
static bool read_header(points *p, const char *text)
{
    static const char *const parting = " \t,;()[]#=_:\r\n";
    const char *rate = strstr(text, "1/s");
    char word[32];
    for (const char *s = text; *s;) {
        s += strspn(s, parting);
        size_t length = strcspn(s, parting);
        snprintf(word, sizeof word, "%.*s", (int)length, s);
        double unit = length ? ovr_unit_value(word, OVR_PRESSURE) : NAN;
        if (rate && unit > 0) {
            p->unit = unit;
            p->rate_first = rate < s;
            return true;
        }
        s += length;
    }
    return false;
}

static bool read_pair(const char *text, double pair[2])
{
    static const char *const parting = " \t,;\r\n";
    for (int k = 0; k < 2; k++) {
        text += strspn(text, parting);
        if (!ovr_read_number(&text, &pair[k]))
            return false;
    }
    return text[strspn(text, parting)] == '\0';
}

static ovr_status take_line(points *p, const char *text, long line,
                            ovr_error *err)
{
    double pair[2];
    if (p->unit == 0 && read_header(p, text))
        return OVR_OK;
    if (p->unit == 0)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line,
                           "the first line must name the units of two columns, "
                           "such as 'rate [1/s], stress [MPa]'");
    if (text[strspn(text, " \t\r\n")] == '\0' || text[0] == '#')
        return OVR_OK;
    if (!read_pair(text, pair))
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line,
                           "must be two numbers, rate and stress");
    if (p->count == POINTS_MOST)
        return ovr_fail_at(err, OVR_BAD_INPUT, p->file, line,
                           "more than %d points", POINTS_MOST);
    p->rate[p->count] = pair[!p->rate_first];
    p->shear[p->count++] = pair[p->rate_first] * p->unit;
    return OVR_OK;
}

static ovr_status read_points(points *p, const ovr_slot *slot, ovr_error *err)
{
    FILE *in = fopen(p->file, "r");
    ovr_status status = OVR_OK;
    char text[256];
    if (!in)
        return ovr_fail_slot(err, slot, "cannot read '%s': %s", p->file,
                             strerror(errno));
    for (long line = 1; !status && fgets(text, sizeof text, in); line++)
        status = take_line(p, text, line, err);
    if (!status && ferror(in))
        status = ovr_fail_slot(err, slot, "cannot read '%s'", p->file);
    fclose(in);
    return status;
}

/* The stress that scales it: where the film has thinned to 0.7 of what it was
 * (the last one if it never does), that the law's table is fine there. */
static double knee(const points *p)
{
    size_t k = 0;
    while (k + 1 < p->count &&
           p->shear[k] / p->rate[k] > 0.7 * p->shear[0] / p->rate[0])
        k++;
    return p->count ? p->shear[k] : 1;
}

static ovr_status table(ovr_resolved *r, ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    points p = {.file = r->values.rheology_file};
    if (!p.file)
        return ovr_fail_slot(err, ovr_block_get(block, "rheology"),
                             "table needs 'rheology_file' in [lubricant]");
    p.shear = ovr_arena_take(&r->arena, POINTS_MOST, sizeof(double), err);
    p.rate = ovr_arena_take(&r->arena, POINTS_MOST, sizeof(double), err);
    if (!p.shear || !p.rate)
        return OVR_NO_MEMORY;
    if (read_points(&p, ovr_block_get(block, "rheology_file"), err))
        return OVR_BAD_INPUT;
    form->points = p.count;
    form->shear = p.shear;
    form->rate = p.rate;
    form->stress = knee(&p);
    return OVR_OK;
}

ovr_status ovr_resolve_flow(ovr_resolved *r, const ovr_allocator *allocator,
                            ovr_error *err)
{
    ovr_flow_form *form = &r->values.flow;
    const ovr_block *block = ovr_block_of(r, "lubricant");
    ovr_error why = {0};
    form->rheology = (ovr_rheology)r->values.rheology;
    if (form->rheology == OVR_CARREAU) {
        form->rheology = (ovr_rheology)r->values.carreau_form;
        form->stress = r->values.carreau_stress;
        form->number = r->values.carreau_number;
    }
    if (form->rheology == OVR_FLOW_TABLE && table(r, err))
        return err ? err->status : OVR_BAD_INPUT;
    if (form->rheology > OVR_EYRING) {
        form->law = r->flow_law = ovr_flow_law_create(form, allocator, &why);
        if (!form->law)
            return ovr_fail_in(err, r->c, block, NULL, &why);
    }
    if (ovr_lubricant_flow(&r->contact, form, &r->lubricant, &why))
        return ovr_fail_in(err, r->c, block, NULL, &why);
    return OVR_OK;
}
