/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Prints the statistics of a study as text and JSON. */
#include "cli/sample.h"

#include <math.h>
#include <string.h>

enum { FEW = 200 }; /* samples, up to which shares have one digit */

/* -------------------------------------------------------------------- JSON */

static void json_quantiles(json_writer *json, const ovr_sample_row *r)
{
    json_open_array(json, "quantiles");
    for (int k = 0; k < OVR_SAMPLE_QUANTILES; k++) {
        json_open(json, NULL);
        json_number(json, "p", r->p[k]);
        json_number(json, "value", r->quantile[k]);
        json_number(json, "low", r->low[k]);
        json_number(json, "high", r->high[k]);
        json_close(json);
    }
    json_close_array(json);
}

static void json_limits(json_writer *json, const ovr_sample_row *r)
{
    json_open_array(json, "limits");
    for (size_t k = 0; k < r->limits; k++) {
        json_open(json, NULL);
        json_text(json, "relation", r->sense[k] > 0 ? "at least" : "at most");
        json_number(json, "limit", r->limit[k]);
        json_number(json, "P", r->P[k]);
        json_number(json, "P_low", r->P_low[k]);
        json_number(json, "P_high", r->P_high[k]);
        json_close(json);
    }
    json_close_array(json);
}

static void json_inputs(json_writer *json, const ovr_sample *sample, size_t row)
{
    const ovr_sample_input *in;
    json_open_array(json, "inputs");
    for (size_t k = 0; (in = ovr_sample_input_at(sample, row, k)); k++) {
        json_open(json, NULL);
        json_text(json, "key", in->key);
        json_number(json, "share", in->share);
        json_number(json, "share_low", in->share_low);
        json_number(json, "share_high", in->share_high);
        json_number(json, "rho", in->rho);
        json_number(json, "rho_low", in->rho_low);
        json_number(json, "rho_high", in->rho_high);
        json_number(json, "lowest", in->lowest);
        json_number(json, "highest", in->highest);
        json_close(json);
    }
    json_close_array(json);
}

void cli_json_sample(json_writer *json, const ovr_sample *sample)
{
    const ovr_sample_row *r;
    json_open_array(json, "statistics");
    for (size_t k = 0; (r = ovr_sample_at(sample, k)); k++) {
        json_open(json, NULL);
        json_text(json, "group", r->group);
        json_text(json, "quantity", r->quantity);
        json_integer(json, "draws", (long long)r->draws);
        json_integer(json, "finished", (long long)r->finished);
        json_integer(json, "failed", (long long)r->failed);
        json_integer(json, "marked", (long long)r->marked);
        json_integer(json, "known", (long long)r->known);
        json_integer(json, "order_least", r->order[0]);
        json_integer(json, "order_most", r->order[1]);
        json_number(json, "mean", r->mean);
        json_number(json, "mean_error", r->error);
        json_number(json, "sd", r->sd);
        json_quantiles(json, r);
        json_limits(json, r);
        json_inputs(json, sample, k);
        json_close(json);
    }
    json_close_array(json);
}

/* ------------------------------------------------------------------- tables */

static void put_range(const char *name, const int range[2])
{
    if (range[0] == range[1] && range[0])
        printf(", %s %d", name, range[0]);
    else if (range[1])
        printf(", %ss %d to %d", name, range[0], range[1]);
}

/* Prints the number of samples and how they ended. */
static void put_counts(const ovr_sample_row *r)
{
    printf("%s%s%zu samples: %zu finished, %zu failed, %zu with steps accepted "
           "above tolerance",
           r->group, *r->group ? ": " : "", r->draws, r->finished, r->failed,
           r->marked);
    put_range("order", r->order);
    put_range("level", r->level);
    putchar('\n');
    if ((double)r->failed > 0.01 * (double)r->draws)
        printf("%.2g %% of the samples failed and are excluded; the statistics "
               "may be biased\n",
               100 * (double)r->failed / (double)r->draws);
    if (r->order[0] != r->order[1])
        puts("the samples contain solutions of different order; set "
             "domain.order = 2 in [set]");
}

/* Prints "LOW to HIGH", or the one that is known. */
static void put_interval(double low, double high)
{
    if (isnan(low) && isfinite(high))
        printf(" below %.4g\n", high);
    else if (isnan(high) && isfinite(low))
        printf(" above %.4g\n", low);
    else if (isfinite(low))
        printf(" %.4g to %.4g\n", low, high);
    else
        putchar('\n');
}

static void put_value(const char *label, double value)
{
    printf("%-*s %-12.5g", OVR_LABEL_WIDTH, label, value);
}

static void put_moments(const ovr_sample_row *r)
{
    double half = r->factor * r->error;
    char label[64];
    printf("\n%s%s%s (%s)\n", r->name, *r->unit ? ", " : "", r->unit,
           r->quantity);
    printf("%-*s %-12s 95 %% confidence interval\n", OVR_LABEL_WIDTH,
           "statistic", "value");
    put_value("mean", r->mean);
    put_interval(r->mean - half, r->mean + half);
    printf("%-*s %.5g\n", OVR_LABEL_WIDTH, "standard deviation", r->sd);
    for (int k = 0; k < OVR_SAMPLE_QUANTILES; k++) {
        snprintf(label, sizeof label, "%.0f %% quantile", 100 * r->p[k]);
        put_value(label, r->quantile[k]);
        put_interval(r->low[k], r->high[k]);
    }
}

static void put_limits(const ovr_sample_row *r)
{
    char label[64];
    for (size_t k = 0; k < r->limits; k++) {
        snprintf(label, sizeof label, "probability of %s %.6g",
                 r->sense[k] > 0 ? "at least" : "at most", r->limit[k]);
        put_value(label, r->P[k]);
        put_interval(r->P_low[k] <= 0 ? NAN : r->P_low[k], r->P_high[k]);
    }
}

static void put_inputs(const ovr_sample *sample, size_t row, size_t known)
{
    const ovr_sample_input *in;
    int d = known < FEW ? 1 : 2;
    if (ovr_sample_input_at(sample, row, 0))
        printf("%-*s %-23s rank correlation rho\n", OVR_LABEL_WIDTH,
               "effect of the input", "share of the variance");
    for (size_t k = 0; (in = ovr_sample_input_at(sample, row, k)); k++) {
        char share[64] = "";
        if (!in->related)
            snprintf(share, sizeof share, "%.*f (%.*f to %.*f)", d, in->share,
                     d, in->share_low, d, in->share_high);
        printf("%-*s %-23s %+.*f (%+.*f to %+.*f)\n", OVR_LABEL_WIDTH, in->key,
               share, d, in->rho, d, in->rho_low, d, in->rho_high);
    }
}

void cli_put_sample(const ovr_sample *sample)
{
    const ovr_sample_row *r;
    const char *group = NULL;
    for (size_t k = 0; (r = ovr_sample_at(sample, k)); k++) {
        if (!group || strcmp(group, r->group) != 0)
            put_counts(r);
        group = r->group;
        if (!r->known)
            continue;
        put_moments(r);
        put_limits(r);
        put_inputs(sample, k, r->known);
    }
}
