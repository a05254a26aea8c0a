/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reviews the ends of the domain. */
#include <math.h>
#include <stdio.h>

#include "case/domain.h"
#include "case/resolve.h"
#include "contact/starvation.h"
#include "physics/supply/supply.h"
#include "run/review.h"

/* "some 0.54 %": the loss is a fit to those up to a fifth. */
typedef struct share {
    char text[40];
} share;

static share share_of(double loss)
{
    share s = {"more than a fifth"};
    if (loss < 0.2)
        snprintf(s.text, sizeof s.text, "some %.2g %%", 100 * loss);
    return s;
}

/* Rounds to four digits, farther out and not nearer. */
static double rounded_out(double X)
{
    double digit = pow(10, floor(log10(fabs(X))) - 3);
    return copysign(ceil(fabs(X) / digit * (1 - 1e-12)) * digit, X);
}

static bool is_usual(const ovr_review *r, const char *key)
{
    const ovr_slot *slot = ovr_slot_of((const ovr_resolved *)r->setup, "domain",
                                       key);
    return slot->word && slot->number == 0;
}

static void warn_of_kept_inlet(const ovr_review *r,
                               const ovr_domain_needs *needs)
{
    ovr_review_say(
        r, OVR_SAY_WARNING,
        "a feature starts left of X = %.4g: the inlet stays there, which costs "
        "%s of the central film; start it left of %.4g to have the inlet there",
        r->setup->options->inlet, share_of(needs->loss).text,
        ((const ovr_resolved *)r->setup)->inlet_kept);
}

/* The usual inlet lies farther out, or does not because of a feature. */
static void say_usual_inlet(const ovr_review *r, const ovr_domain_needs *needs)
{
    double inlet = r->setup->options->inlet;
    const ovr_contact *contact = r->setup->contact;
    double loss = ovr_inlet_loss(contact->M, contact->L, OVR_USUAL_INLET);
    if (inlet < OVR_USUAL_INLET && needs->varies)
        ovr_review_say(
            r, OVR_SAY_NOTE,
            "the inlet is at X = %.4g: that far for all films and contacts "
            "that load, speed and radius make",
            inlet);
    else if (inlet < OVR_USUAL_INLET)
        ovr_review_say(
            r, OVR_SAY_NOTE,
            "the inlet is at X = %.4g: at -4 it would cost %s of the central "
            "film",
            inlet, share_of(loss).text);
}

/* Ends that were given, where films are cut by them.  An inlet that oil does
 * not fill is judged by the meniscus, when there is one (ovr_review_inlet). */
static void warn_of_near_inlet(const ovr_review *r,
                               const ovr_domain_needs *needs)
{
    if (!ovr_setup_supply(r->setup)->film &&
        needs->loss > 1.01 * OVR_USUAL_LOSS)
        ovr_review_say(
            r, OVR_SAY_WARNING,
            "the inlet is numerically starved: X = %.4g is so near that it "
            "costs %s of the film; inlet = %.4g would do",
            r->setup->options->inlet, share_of(needs->loss).text,
            rounded_out(needs->inlet));
}

static void warn_of_near_outlet(const ovr_review *r,
                                const ovr_domain_needs *needs)
{
    const ovr_options *o = r->setup->options;
    if (!is_usual(r, "outlet") && o->outlet < needs->film_end)
        ovr_review_say(
            r, OVR_SAY_WARNING,
            "the outlet X = %.4g is too near: films end as far out as X = "
            "%.4g, and what is cut off carries load; outlet = %.4g would do",
            o->outlet, needs->film_end, rounded_out(needs->outlet));
}

void ovr_review_domain(const ovr_review *r)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (((const ovr_resolved *)r->setup)->inlet_kept < 0 &&
        needs.loss > OVR_USUAL_LOSS)
        warn_of_kept_inlet(r, &needs);
    else if (is_usual(r, "inlet"))
        say_usual_inlet(r, &needs);
    else
        warn_of_near_inlet(r, &needs);
    warn_of_near_outlet(r, &needs);
}

void ovr_review_inlet(const ovr_review *r, const ovr_state *state, double H_cen)
{
    ovr_domain_needs needs = ovr_setup_needs(r->setup);
    if (needs.loss <= 1.01 * OVR_USUAL_LOSS)
        return;
    ovr_review_say(
        r, OVR_SAY_WARNING,
        "the inlet is numerically starved: the film at X = %.3g is only %.1f "
        "central films, which costs %s of the film; inlet = %.4g would do",
        state->X[0], state->H[0] / H_cen, share_of(needs.loss).text,
        rounded_out(needs.inlet));
}
