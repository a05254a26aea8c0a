/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tells what a run says of layers on its bodies, and what its file keeps of
 * them: the images that stood for them, and how well. */
#include "case/setup.h"
#include "results/results.h"
#include "run/internal.h"
#include "run/review.h"

static const ovr_coated *coated_of(const ovr_setup *setup)
{
    const ovr_coated *first = ovr_setup_layers(setup, 0);
    return first ? first : ovr_setup_layers(setup, 1);
}

static void foresee(const ovr_setup *setup, ovr_listener *say, void *data)
{
    const double small = 0.1;
    const ovr_coated *of = coated_of(setup);
    if (!of || !(of->strain > small))
        return;
    ovr_warn(say, data,
             "a layer is strained by some %.2g: what is calculated holds for "
             "small strains",
             of->strain);
}

/* A of a wave by A_top and the images: of each its weight. */
static ovr_status open_file(void *own, const ovr_run *run, ovr_error *err)
{
    const ovr_coated *of = coated_of(run->setup);
    const ovr_images *images = &of->images;
    const ovr_group_axis depth = {"image_depth", "depth of an image",
                                  OVR_KIND_LENGTH, (size_t)images->count,
                                  images->depth};
    const ovr_group_array weight = {.name = "image_weight",
                                    .long_name = "weight of an image",
                                    .kind = OVR_KIND_NUMBER,
                                    .rank = 1,
                                    .along = {0},
                                    .doubles = images->weight};
    const ovr_group_attribute about[] = {
        {"softness_top", NULL, images->top},
        {"image_error", NULL, images->error},
        {"modulus_over_substrates", NULL, of->stiffness},
        {"dry_half_width", NULL, of->width},
        {"dry_pressure", NULL, of->pressure}};
    size_t some = images->count > 0;
    const ovr_group group = {
        "coating", some,    some, sizeof about / sizeof *about,
        &depth,    &weight, about};
    (void)own;
    return ovr_writer_group(run->writer, &group, true, err);
}

const ovr_companion ovr_coating_companion = {.foresee = foresee,
                                             .open = open_file};
