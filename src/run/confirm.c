/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A level chosen before the run is confirmed after it, by the estimate of the
 * discretization error, of the films where friction counts too, as that is not
 * estimated.  A mesh that did worse is said, with the level that would do if
 * the error fell as D^2.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "run/internal.h"

static const char *const names[] = {"H_cen", "H_min", "what the features do",
                                    "both films"};

/* Infinite where it was not estimated. */
static double error_of(const ovr_run_errors *e, const char *key)
{
    for (size_t k = 0; k < e->count; k++)
        if (!strcmp(e->of[k].key, key))
            return e->of[k].error / fabs(e->of[k].value[0]);
    return INFINITY;
}

static double relative_error(const ovr_run *run)
{
    const ovr_run_errors *e = &run->error;
    ovr_accuracy of = run->setup->accuracy_of;
    double central = error_of(e, "H_cen");
    double minimum = error_of(e,
                              run->info.transient ? "H_min_overall" : "H_min");
    if (of != OVR_ACCURACY_ALL)
        return of == OVR_ACCURACY_H_CEN ? central : minimum;
    return isnan(central + minimum) ? NAN : fmax(central, minimum);
}

static void doubt(ovr_run *run, const char *why)
{
    const ovr_setup *s = run->setup;
    ovr_run_warn(
        run,
        "level %d was chosen for an error of %.2g of %s, which cannot be "
        "confirmed: %.800s",
        s->options->level, s->accuracy, names[s->accuracy_of], why);
}

ovr_status ovr_run_confirm(ovr_run *run, ovr_error *err)
{
    const ovr_setup *s = run->setup;
    int level = s->options->level;
    ovr_error why = {0};
    ovr_status status = ovr_run_estimate(run, &why);
    if (status == OVR_STOPPED)
        return ovr_fail(err, OVR_STOPPED, "%s", why.message);
    if (status) {
        doubt(run, why.message);
        return OVR_OK;
    }
    double error = relative_error(run);
    if (isnan(error))
        doubt(run, "coarser levels do not fall to it in a known order");
    if (isnan(error) || error <= s->accuracy)
        return OVR_OK;
    ovr_run_warn(run,
                 "level %d was chosen for an error of %.2g of %s; the estimate "
                 "after the run is %.2g: level %d would do",
                 level, s->accuracy, names[s->accuracy_of], error,
                 level + (int)ceil(log2(error / s->accuracy) / 2));
    return OVR_OK;
}
