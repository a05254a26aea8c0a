/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a contact, by key for programs and by name for people. */
#include <math.h>

#include "run/lines.h"

typedef struct scale {
    const char *key, *label; /* NULL: not for people */
    double value, unit;      /* of the line for people */
    const char *symbol;
    bool before; /* told before a case is solved, not of what came out */
} scale;

static void put_scale(const ovr_told *to, const scale *s, bool before)
{
    if (before && s->label && isfinite(s->value))
        ovr_tell(to, s->label, "%.6g %s", s->value / s->unit, s->symbol);
    if (before || !s->before)
        ovr_put_number(to, s->key, s->value);
}

void ovr_put_contact(const ovr_told *to, const ovr_contact *c, bool before)
{
    const scale rows[] = {
        {"M", "M", c->M, 1, "", false},
        {"L", "L", c->L, 1, "", false},
        {"lambda", "lambda", c->lambda, 1, "", false},
        {"alphabar", "alphabar", c->alphabar, 1, "", false},
        {"u1_ratio", "u1/um", c->u1_ratio, 1, "", true},
        {"u2_ratio", "u2/um", c->u2_ratio, 1, "", true},
        {"hertz_pressure_Pa", "Hertzian pressure ph", c->ph, 1e9, "GPa", false},
        {"half_width_m", "half width b", c->b, 1e-6, "um", false},
        {"film_scale_m", "film scale b^2/R", c->height, 1e-6, "um", false},
        {"time_scale_s", "time scale b/um", c->time, 1e-6, "us", false},
        {"load_N_per_m", "load", c->load, 1e3, "kN/m", false},
        {"mean_speed_m_per_s", "mean speed um", c->um, 1, "m/s", false},
        {"load_N", "force over the width", c->load * c->width, 1, "N", true},
        {"radius_m", "reduced radius R", c->radius, 1e-3, "mm", true},
        {"modulus_Pa", "reduced modulus E'", c->modulus, 1e9, "GPa", true},
        {"viscosity_Pa_s", "viscosity eta0", c->viscosity, 1e-3, "mPa.s", true},
        {"alpha_per_Pa", NULL, c->alpha, 1, "", true}};
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        put_scale(to, &rows[k], before);
}
