/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A state becomes the row of a snapshot: scaled, windowed, thinned. */
#include "results/results.h"
#include "results/writer.h"

/* The value at half nodes is the mean of the two that a node is between. */
static double value_at(const ovr_writer *w, const ovr_observable *which,
                       const double *values, size_t k)
{
    size_t i = w->first + k * w->options.stride, last = w->n - 1;
    if (which->axes != OVR_AT_HALVES)
        return values[i];
    return (values[i > 0 ? i - 1 : 0] + values[i < last ? i : last - 1]) / 2;
}

void ovr_writer_fill(const ovr_writer *w, const ovr_frame *frame,
                     unsigned char *rows)
{
    for (size_t f = 0; f < w->file.fields; f++) {
        const ovr_observable *which = w->file.which[f];
        const double *from = frame->field(frame->source, which, w->workspace);
        double factor = ovr_factor(&w->scales, which->kind);
        size_t element = ovr_file_element(&w->file, which);
        for (size_t k = 0; k < w->nodes; k++, rows += element) {
            double value = factor * value_at(w, which, from, k);
            if (element == sizeof(double))
                *(double *)(void *)rows = value;
            else if (element == sizeof(float))
                *(float *)(void *)rows = (float)value;
            else
                *(signed char *)rows = (signed char)value;
        }
    }
}
