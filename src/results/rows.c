/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A state becomes the row of a snapshot: scaled, windowed, thinned. */
#include "results/writer.h"

/* At half nodes: the mean of the two that a node is between. */
static double value_at(const ovr_writer *w, const ovr_observable *which,
                       const double *values, size_t k)
{
    size_t i = w->first + k * w->options.stride, last = w->n - 1;
    if (which->axes != OVR_AT_HALVES)
        return values[i];
    return (values[i > 0 ? i - 1 : 0] + values[i < last ? i : last - 1]) / 2;
}

static void fill_flags(const ovr_writer *w, const ovr_observable *which,
                       const double *from, signed char *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = (signed char)value_at(w, which, from, k);
}

static void fill_single(const ovr_writer *w, const ovr_observable *which,
                        const double *from, double factor, float *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = (float)(factor * value_at(w, which, from, k));
}

static void fill_double(const ovr_writer *w, const ovr_observable *which,
                        const double *from, double factor, double *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = factor * value_at(w, which, from, k);
}

void ovr_writer_fill(const ovr_writer *w, const ovr_frame *frame,
                     unsigned char *rows)
{
    for (size_t k = 0; k < w->file.fields; k++) {
        const ovr_observable *which = w->file.which[k];
        const double *from = frame->field(frame->source, which, w->room);
        double factor = ovr_factor(&w->scales, which->kind);
        size_t element = ovr_file_element(&w->file, which);
        if (which->kind == OVR_KIND_FLAG)
            fill_flags(w, which, from, (signed char *)rows);
        else if (element == sizeof(float))
            fill_single(w, which, from, factor, (float *)(void *)rows);
        else
            fill_double(w, which, from, factor, (double *)(void *)rows);
        rows += w->nodes * element;
    }
}
