/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command overroll check CASE: prints derived quantities, solves nothing.
 */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "cli/case_args.h"
#include "cli/json.h"
#include "cli/report.h"
#include "overroll/case.h"

/* ------------------------------------ contact points of a machine element */

/* Table of the contact points of a machine element. */

/* A column: heading and unit in the table, key in JSON, scale, and the
 * number. */
typedef struct column {
    const char *head, *key;
    double unit; /* SI value of the table's unit */
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
    {"t (ms)", "t_s", 1e-3, time_of},
    {"R (mm)", "R_m", 1e-3, radius_of},
    {"u1 (m/s)", "u1_m_per_s", 1, u1_of},
    {"u2 (m/s)", "u2_m_per_s", 1, u2_of},
    {"SRR", "slide_to_roll", 1, slip_of},
    {"w (kN/m)", "load_N_per_m", 1e3, load_of},
    {"p_h (GPa)", "hertz_pressure_Pa", 1e9, pressure_of},
    {"h_min (um)", "h_min_m", 1e-6, film_of},
    {"flash (K)", "flash_K", 1, flash_of},
};
enum { COLUMNS = sizeof columns / sizeof *columns };

/* Prints the contact points as lines with "#"; nothing without a machine
 * element. */
static void print_stations(const ovr_setup *setup)
{
    ovr_station station[OVR_STATIONS_MAX];
    size_t n = ovr_setup_stations(setup, station);
    bool still = false, beyond = false;
    if (!n)
        return;
    printf("# %-10s", "position");
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
        still = still || isnan(slip_of(&station[i]));
        beyond = beyond || isnan(station[i].minimum);
    }
    printf("#   SRR: slide-to-roll ratio%s, w: load per unit width\n",
           still ? " (-: no entrainment)" : "");
    printf("#   h_min by the film thickness formula (flooded, steady), flash "
           "temperature after Blok at mu = %g\n",
           OVR_STATION_FRICTION);
    if (beyond)
        puts("#   h_min -: outside the range of the formula, 2 <= M <= 1000, "
             "0.3 <= L <= 25, Roelands viscosity");
}

static void json_stations(json_writer *json, const ovr_setup *setup)
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

/* ----------------------------------------------------------------- memory */

/* Allocator that counts the bytes in use; each block is preceded by its size.
 */
enum { HEAD = sizeof(max_align_t) };

typedef struct used {
    double live, peak; /* bytes */
} used;

static void *count_allocation(void *context, size_t bytes)
{
    used *memory = context;
    unsigned char *piece = malloc(HEAD + bytes);
    if (!piece)
        return NULL;
    memcpy(piece, &bytes, sizeof bytes);
    memory->live += (double)bytes;
    if (memory->live > memory->peak)
        memory->peak = memory->live;
    return piece + HEAD;
}

static void count_release(void *context, void *memory)
{
    unsigned char *piece = (unsigned char *)memory - HEAD;
    size_t bytes;
    memcpy(&bytes, piece, sizeof bytes);
    ((used *)context)->live -= (double)bytes;
    free(piece);
}

/* ------------------------------------------------------------------ table */

/* Prints a line as a comment of a case; lines of the complete list only with
 * -v. */
static void print_comment(void *data, const ovr_summary_line *line)
{
    const cli_call *call = data;
    if (line->key || (line->detail && call->verbosity <= 0))
        return;
    if (!line->label)
        printf("# %s\n", line->text);
    else
        printf("#   %-*s %s\n", OVR_LABEL_WIDTH, line->label, line->text);
}

static void print_line(void *data, const char *name, const char *text)
{
    if (!*(bool *)data)
        puts("# Models");
    *(bool *)data = true;
    printf("#   %-*s %s\n", OVR_LABEL_WIDTH, name, text);
}

/* ------------------------------------------------------------------- JSON */

static void hear_json(void *data, ovr_message_kind kind, const char *text)
{
    if (kind == OVR_MESSAGE_WARNING)
        json_text(data, NULL, text);
}

static ovr_status report_json(const ovr_case *c, const ovr_setup *setup,
                              used memory, ovr_error *err)
{
    json_writer json = json_begin(stdout);
    ovr_status status = ovr_setup_report(setup, memory.live, memory.peak,
                                         cli_put_line, &json, err);
    json_stations(&json, setup);
    json_open_array(&json, "warnings");
    ovr_setup_review(setup, hear_json, &json);
    json_close_array(&json);
    cli_json_case(&json, c);
    json_end(&json);
    return status;
}

static ovr_status report(cli_call *call, const ovr_case *c,
                         const ovr_setup *setup, used memory, ovr_error *err)
{
    ovr_status status;
    bool begun = false;
    if (call->json)
        return report_json(c, setup, memory, err);
    status = ovr_setup_report(setup, memory.live, memory.peak, print_comment,
                              call, err);
    if (status)
        return status;
    print_stations(setup);
    ovr_setup_describe(setup, print_line, &begun);
    if (call->verbosity > 0)
        cli_put_case(c);
    return OVR_OK;
}

static int run(cli_call *call)
{
    int code;
    ovr_case *c = cli_open_case(call, &code);
    ovr_setup *setup;
    ovr_error err = {0};
    double depth;
    used memory = {0, 0};
    const ovr_allocator counted = {count_allocation, count_release, &memory};
    if (!c)
        return code;
    setup = ovr_case_resolve(c, &counted, &err);
    if (setup && !ovr_setup_prepare(setup, &counted, &err) &&
        !ovr_setup_stress_depth(setup, &depth, &err)) {
        ovr_setup_review(setup, cli_say, call);
        if (report(call, c, setup, memory, &err))
            code = cli_fail(&err);
    } else {
        code = cli_fail(&err);
    }
    ovr_setup_free(setup);
    ovr_case_free(c);
    return code;
}

static const cli_option options[] = {CLI_CASE_OPTIONS, {0}};

const cli_verb cli_check = {
    .name = "check",
    .arguments = "[CASE]",
    .summary =
        "print operating conditions, predictions and cost; solve nothing",
    .help =
        "Prints a summary of operating conditions, predicted film thickness, "
        "features, grid\nand cost. With -v the list is complete and every "
        "parameter follows with its value;\nthat output is itself a "
        "case.",
    .options = options,
    .minimum = 0,
    .maximum = 1,
    .run = run,
};
