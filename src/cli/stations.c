/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/stations.h"

#include <math.h>

/* A column: its name and unit in the table, its key in JSON, its scale there,
 * and the number. */
typedef struct column {
    const char *head, *key;
    double unit; /* SI over that of the table */
    double (*value)(const ovr_station *s);
} column;

static double time_of(const ovr_station *s)
{
    return isnan(s->T) ? NAN : s->moment.t;
}
static double radius_of(const ovr_station *s)
{
    return s->moment.R;
}
static double u1_of(const ovr_station *s)
{
    return s->moment.u1;
}
static double u2_of(const ovr_station *s)
{
    return s->moment.u2;
}
static double slip_of(const ovr_station *s)
{
    double mean = (s->moment.u1 + s->moment.u2) / 2;
    return mean != 0 ? (s->moment.u1 - s->moment.u2) / mean : NAN;
}
static double load_of(const ovr_station *s)
{
    return s->moment.load;
}
static double pressure_of(const ovr_station *s)
{
    return s->pressure;
}
static double film_of(const ovr_station *s)
{
    return s->minimum;
}
static double flash_of(const ovr_station *s)
{
    return s->flash;
}

static const column columns[] = {
    {"t ms", "t_s", 1e-3, time_of},
    {"R mm", "R_m", 1e-3, radius_of},
    {"u1 m/s", "u1_m_per_s", 1, u1_of},
    {"u2 m/s", "u2_m_per_s", 1, u2_of},
    {"slide/roll", "slide_to_roll", 1, slip_of},
    {"load kN/m", "load_N_per_m", 1e3, load_of},
    {"ph GPa", "hertz_pressure_Pa", 1e9, pressure_of},
    {"h_min um", "h_min_m", 1e-6, film_of},
    {"flash K", "flash_K", 1, flash_of},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

void cli_put_stations(const ovr_setup *setup)
{
    ovr_station station[OVR_STATIONS_MAX];
    size_t n = ovr_setup_stations(setup, station);
    if (!n)
        return;
    printf("# %-10s", "station");
    for (int k = 0; k < COLUMNS; k++)
        printf(" %10s", columns[k].head);
    putchar('\n');
    for (size_t i = 0; i < n; i++) {
        printf("# %-10s", station[i].name);
        for (int k = 0; k < COLUMNS; k++) {
            double value = columns[k].value(&station[i]) / columns[k].unit;
            if (isnan(value))
                printf(" %10s", "-");
            else
                printf(" %10.4g", value);
        }
        putchar('\n');
    }
    printf("#   h_min by the film thickness formula, flooded and steady; "
           "flash temperature after Blok at mu = %g\n",
           OVR_STATION_FRICTION);
}

void cli_json_stations(json_writer *json, const ovr_setup *setup)
{
    ovr_station station[OVR_STATIONS_MAX];
    size_t n = ovr_setup_stations(setup, station);
    if (!n)
        return;
    json_open_array(json, "stations");
    for (size_t i = 0; i < n; i++) {
        json_open(json, NULL);
        json_text(json, "name", station[i].name);
        json_number(json, "T", station[i].T);
        for (int k = 0; k < COLUMNS; k++)
            json_number(json, columns[k].key, columns[k].value(&station[i]));
        json_number(json, "h_cen_m", station[i].central);
        json_close(json);
    }
    json_close_array(json);
}
