/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A state becomes the row of a snapshot: scaled, windowed, thinned. */
#include "results/writer.h"

/* Mass flow at a node: the mean of its two half nodes. */
static double flow_at(const ovr_frame *frame, size_t i)
{
    const double *flow = frame->flow;
    size_t last = frame->state->n - 1;
    double left = flow[i > 0 ? i - 1 : 0],
           right = flow[i < last ? i : last - 1];
    return (left + right) / 2;
}

static const double *array_of(const ovr_frame *frame, unsigned bit)
{
    switch (bit) {
    case OVR_FIELD_PRESSURE: return frame->state->P;
    case OVR_FIELD_FILM: return frame->state->H;
    case OVR_FIELD_ROUGHNESS: return frame->state->S;
    case OVR_FIELD_DENSITY: return frame->rho;
    case OVR_FIELD_VISCOSITY: return frame->eta;
    default: return NULL;
    }
}

static double value_at(const ovr_frame *frame, const double *array, size_t i)
{
    return array ? array[i] : flow_at(frame, i);
}

static void fill_flags(const ovr_writer *w, const double *P, signed char *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = (signed char)(P[w->first + k * w->options.stride] <= 0);
}

static void fill_single(const ovr_writer *w, const ovr_frame *frame,
                        const double *from, double factor, float *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = (float)(factor * value_at(frame, from,
                                          w->first + k * w->options.stride));
}

static void fill_double(const ovr_writer *w, const ovr_frame *frame,
                        const double *from, double factor, double *to)
{
    for (size_t k = 0; k < w->nodes; k++)
        to[k] = factor *
                value_at(frame, from, w->first + k * w->options.stride);
}

void ovr_writer_fill(const ovr_writer *w, const ovr_frame *frame,
                     unsigned char *rows)
{
    for (size_t k = 0; k < w->file.fields; k++) {
        const ovr_field *which = w->file.which[k];
        const double *from = array_of(frame, which->bit);
        double factor = ovr_factor(&w->scales, which->kind);
        if (which->kind == 'b')
            fill_flags(w, frame->state->P, (signed char *)rows);
        else if (w->options.single)
            fill_single(w, frame, from, factor, (float *)(void *)rows);
        else
            fill_double(w, frame, from, factor, (double *)(void *)rows);
        rows += w->nodes * (which->kind == 'b' ? 1 : w->file.element);
    }
}
