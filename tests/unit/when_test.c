/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keys without effect: rejected with a message, noted if their section is
 * switched off or if a result file contains them. */
#include "support/test.h"

#include <stdio.h>
#include <string.h>

#include "case/case.h"
#include "overroll/overroll.h"
#include "surface/feature.h"

#define MOES "[contact]\nM = 20\nL = 10\n[domain]\nlevel = 5\n"
#define INDENT                                                                 \
    "[time]\nend = 1\n[feature d]\nshape = indent\ndepth = 0.1\nwidth = 1\n"
#define GEAR                                                                   \
    "[gear]\nteeth_1 = 25\nteeth_2 = 57\nmodule = 2.5 mm\nface = 20 mm\n"      \
    "speed = 3000 rpm\ntorque = 80 N.m\n[contact]\nmodulus = 226 GPa\n"        \
    "[lubricant]\nviscosity = 40 mPa.s\nalpha = 17 1/GPa\n[gear]\n"

/* ------------------------------------------------- the table as it stands */

static const ovr_parameter *row_of(const ovr_section *section, const char *text,
                                   size_t length)
{
    char name[100], *key = name;
    snprintf(name, sizeof name, "%.*s", (int)length, text);
    if (strchr(name, '.')) {
        key = strchr(name, '.');
        *key++ = '\0';
        section = ovr_section_find(name);
    }
    return section ? ovr_parameter_find(section, key) : NULL;
}

static bool has_word(const ovr_parameter *row, const char *word, size_t length)
{
    for (const ovr_word *w = row->words; w && w->name; w++)
        if (strlen(w->name) == length && !memcmp(w->name, word, length))
            return true;
    return false;
}

/* One alternative of a condition: its key is one, its words are the key's. */
static void check_alternative(const ovr_section *section, const char *text,
                              size_t length)
{
    const char *end = text + length;
    size_t skip = strncmp(text, "no ", 3) ? 0 : 3, key;
    const ovr_parameter *row;
    text += skip;
    key = strcspn(text, " ;");
    if (*text == '[') { /* a section that is there */
        char name[40];
        snprintf(name, sizeof name, "%.*s", (int)key - 2, text + 1);
        assert_non_null(ovr_section_find(name));
        return;
    }
    row = row_of(section, text, key);
    if (!row)
        fail_msg("no key '%.*s'", (int)key, text);
    text += key;
    if (text >= end)
        return;
    if (!strncmp(text, " == ", 4) || !strncmp(text, " != ", 4))
        return;
    assert_true(!strncmp(text, " = ", 3) || !strncmp(text, " > ", 3));
    for (bool words = text[1] == '='; words && text < end;) {
        text += 3;
        key = strcspn(text, " ;");
        if (!has_word(row, text, key))
            fail_msg("'%s' has no word '%.*s'", row->key, (int)key, text);
        text += key;
    }
}

TEST(conditions_are_about_keys)
{
    const ovr_section *section;
    const ovr_parameter *row;
    int conditions = 0;
    for (size_t k = 0; (row = ovr_parameter_row(k, &section)); k++) {
        const char *s = row->when ? row->when : "";
        if (!strcmp(s, OVR_BY_SHAPE)) {
            int shapes = 0;
            for (int shape = 0; ovr_shape_name(shape); shape++)
                shapes += ovr_shape_has(shape, row->key);
            assert_true(shapes > 0);
            continue;
        }
        while (*s) {
            static const char *const between[] = {"; ", " => ", " or "};
            const char *end = s + strlen(s), *next = end;
            for (size_t i = 0; i < sizeof between / sizeof *between; i++) {
                const char *at = strstr(s, between[i]);
                if (at && at < end)
                    end = at, next = at + strlen(between[i]);
            }
            check_alternative(section, s, (size_t)(end - s));
            s = next;
            conditions++;
        }
    }
    assert_true(conditions > 100);
    for (size_t k = 0; (section = ovr_section_row(k)); k++)
        assert_true(!section->on || ovr_parameter_find(section, section->on));
}

/* --------------------------------------------------------------- refusals */

static ovr_status attempt(ovr_case *c, ovr_error *err)
{
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, err) : NULL;
    ovr_status status = setup ? OVR_OK : err->status;
    ovr_setup_free(setup);
    ovr_case_free(c);
    return status;
}

static const struct {
    const char *text, *message;
} idle[] = {
    {MOES INDENT "Rq = 0.1\n",
     "t.ini:12: Rq: has no effect with shape = indent; it needs shape = "
     "roughness"},
    {MOES INDENT "hurst = 0.7\n", "t.ini:12: hurst: has no effect with shape"},
    {MOES INDENT "file = a.csv\n", "it needs shape = profile"},
    {MOES INDENT "lambda_c = 1\n", "lambda_c: has no effect"},
    {MOES INDENT "origin = 1\n",
     "without shape = wave or texture or extend = periodic or mirror"},
    {MOES INDENT "copies = 2\n", "copies: has no effect without repeat"},
    {MOES INDENT "shoulder_at = 1\n",
     "t.ini:12: shoulder_at: has no effect without shoulder"},
    {"[contact]\nM = 20\nL = 10\nradius = 10 mm\n",
     "t.ini:4: radius: has no effect without modulus or G or load or [body]"},
    {"[contact]\nM = 20\nL = 10\nmodulus = 226 GPa\n[body 1]\n"
     "poisson = 0.3\n",
     "t.ini:6: poisson: has no effect beside [contact] modulus without "
     "[stress]"},
    {MOES "[lubricant]\nalpha = 17 1/GPa\noil = mineral\n",
     "t.ini:8: oil: has no effect beside alpha without iso_vg or "
     "viscosity_40"},
    {MOES "[load]\nto = 2\n",
     "t.ini:7: to: has no effect with history = constant; it needs history = "
     "ramp or step"},
    {MOES "[time]\nend = 2\n[speed]\nhistory = ramp\nto = 2\nmean = 0\n",
     "mean: has no effect with history = ramp; it needs history = sine"},
    {MOES "[lubricant]\nviscosity_law = barus\nz = 0.6\n",
     "z: has no effect with viscosity_law = barus; it needs viscosity_law = "
     "roelands"},
    {MOES "[lubricant]\nlimiting_shear = 0\ncarreau_n = 0.6\n",
     "carreau_n: has no effect with rheology = newtonian"},
    {MOES "[lubricant]\ntait_K0 = 1 GPa\n",
     "without density_law = tait or viscosity_law = doolittle"},
    {MOES "accuracy = 1e-3\n",
     "accuracy: has no effect with level = 5; it needs level = auto"},
    {MOES "refine = spike\nrefine_level = 9\nrefine_change = 1e-4\n",
     "refine_change: has no effect beside refine_level"},
    {MOES "[paper]\ncycles = 3\n",
     "cycles: has no effect with [solver] stop = negligible; it needs [solver] "
     "stop = fixed"},
    {MOES INDENT "[stress]\nfields = sigma_x\n",
     "fields: has no effect with every = 0; it needs every above 0"},
    {MOES "[time]\nend = 2\n[load]\nhistory = ramp\nduration = 1\n",
     "t.ini:9: history: has no effect without from or to"},
    {MOES "[time]\nend = 2\n[radius]\nhistory = sine\nperiod = 1\n",
     "history: has no effect without amplitude"},
    {MOES "[time]\nend = 2\n[speed]\nhistory = sine\nperiod = 1\n",
     "history: has no effect without amplitude or mean"},
    {MOES "[boundary]\nlaw = layer\nlayer = 0.01\nof = unresolved\n",
     "t.ini:9: of: has no effect without [feature]"},
    {MOES "[cavitation]\nmodel = conserving\n[passes]\nnumber = 2\n"
          "spacing = 5\n",
     "t.ini:10: spacing: has no effect without recovery"},
    {GEAR "slice = 0.2\n",
     "slice: has no effect with helix_angle = 0 deg; it needs helix_angle "
     "other than 0"},
    {GEAR "helix_angle = 20 deg\nblend = 0.1\n",
     "blend: has no effect with helix_angle = 20 deg; it needs helix_angle = "
     "0"},
    {GEAR "sharing = stiffness\nrelief_length_1 = 1 mm\n",
     "relief_length_1: has no effect with relief_1 = 0 um; it needs relief_1 "
     "above 0"},
};

TEST(refused_with_a_sentence)
{
    for (size_t k = 0; k < sizeof idle / sizeof *idle; k++) {
        ovr_error err = {0};
        ovr_case *c = ovr_case_read_text(idle[k].text, "t.ini", NULL, NULL,
                                         &err);
        if (!attempt(c, &err))
            fail_msg("not refused: %s", idle[k].text);
        CHECK_ERROR(&err, OVR_BAD_INPUT, idle[k].message);
    }
}

/* The same stand in the files of an earlier version; what is set later is
 * looked at as ever. */
TEST(taken_from_result_files)
{
    ovr_error err = {0};
    ovr_case *c;
    for (size_t k = 0; k < sizeof idle / sizeof *idle; k++) {
        c = ovr_case_read_stored(idle[k].text, "t.ini", NULL, NULL, &err);
        CHECK_OK(attempt(c, &err), &err);
    }
    c = ovr_case_read_stored(MOES "[load]\nto = 2\n", "t.ini", NULL, NULL,
                             &err);
    assert_int_equal(ovr_case_set(c, "speed.to", "2", "--set", &err), OVR_OK);
    assert_int_equal(attempt(c, &err), OVR_BAD_INPUT);
    CHECK_ERROR(&err, OVR_BAD_INPUT, "--set: to: has no effect");
}

/* ------------------------------------------------------------------ notes */

typedef struct heard {
    int notes, warnings;
    char first[OVR_MESSAGE_SIZE], warning[OVR_MESSAGE_SIZE];
} heard;

static void hear(void *data, ovr_message_kind kind, const char *text)
{
    heard *h = data;
    if (kind == OVR_MESSAGE_WARNING && !h->warnings++)
        snprintf(h->warning, sizeof h->warning, "%s", text);
    if (kind == OVR_MESSAGE_NOTE && !h->notes++)
        snprintf(h->first, sizeof h->first, "%s", text);
}

static heard review(const char *text)
{
    heard h = {0};
    ovr_error err = {0};
    ovr_case *c = ovr_case_read_text(text, "t.ini", NULL, NULL, &err);
    ovr_setup *setup = c ? ovr_case_resolve(c, NULL, &err) : NULL;
    ovr_status status = setup ? ovr_setup_prepare(setup, NULL, &err)
                              : err.status;
    CHECK_OK(status, &err);
    ovr_setup_review(setup, hear, &h);
    ovr_setup_free(setup);
    ovr_case_free(c);
    return h;
}

TEST(noted_where_switched_off)
{
    static const struct {
        const char *text, *note;
        int notes;
    } off[] = {
        {MOES "[heat]\nmodel = none\npoints = 7\n",
         "t.ini:8: points has no effect with model = none; it needs model = "
         "lobatto",
         1},
        {"[contact]\nM = 20\nL = 10\nmodulus = 226 GPa\n[body 1]\n"
         "material = steel\n",
         "t.ini:6: material has no effect beside [contact] modulus without "
         "[stress] or [heat] model = lobatto",
         1},
        {MOES "[lubricant]\nS0 = 1\n",
         "t.ini:7: S0 has no effect with [heat] model = none", 1},
        {MOES "[supply]\nthickness_1 = 0.1\nthickness_2 = 0.1\n",
         "thickness_1 has no effect with model = flooded", 2},
        {MOES "[passes]\nnumber = 1\nsplit = 0.4\n",
         "split has no effect without number above 1", 1},
        {MOES "[time]\nstep = 0.1\n", "step has no effect without [time] end",
         1},
        {MOES "[output]\nevery = 2\n", "every has no effect without [time] end",
         1},
        {MOES "[heat]\nmodel = none\n", "", 0},
    };
    for (size_t k = 0; k < sizeof off / sizeof *off; k++) {
        heard h = review(off[k].text);
        assert_int_equal(h.notes, off[k].notes);
        if (!strstr(h.first, off[k].note))
            fail_msg("'%s' lacks '%s'", h.first, off[k].note);
    }
}

/* Nor for what varies. */
TEST(histories_in_steady_contacts_are_noted)
{
    heard h = review(MOES "[load]\nhistory = ramp\nto = 2\n");
    assert_int_equal(h.warnings, 1);
    assert_non_null(strstr(h.warning, "uses the value at T = 0; set time.end"));
    h = review(MOES "[time]\nend = 1\n[load]\nhistory = ramp\nto = 2\n");
    assert_int_equal(h.warnings, 0);
}

/* A steady solution has no space for what passes. */
TEST(omitted_features_are_reported)
{
    heard h = review("[contact]\nM = 20\nL = 10\n[domain]\nlevel = 8\n"
                     "[time]\nscheme = upstream2\n[feature d]\nshape = "
                     "dent\ndepth = 0.1\nwidth = 1\n");
    assert_int_equal(h.warnings, 1);
    assert_non_null(strstr(h.warning, "'d' moves and is left out of a steady "
                                      "solution; set time.end"));
    h = review(MOES "[feature d]\nshape = ridge\nheight = 0.1\nwidth = 9\n"
                    "start = 0\n[contact]\nslide_to_roll = 2\n"
                    "[feature e]\nshape = ridge\nheight = 0.1\nwidth = 9\n"
                    "start = 0\nsurface = 2\n");
    assert_null(strstr(h.warning, "'e'")); /* it stands still */
    h = review(MOES "[feature d]\nshape = dent\ndepth = 0.03\nwidth = 9\n"
                    "start = 0\n");
    assert_non_null(strstr(h.warning, "'d' moves and is held where it is at T "
                                      "= 0 in a steady solution; set"));
    /* Longitudinal features are the same at all times. */
    h = review("[contact]\nM = 20\nL = 10\n[strip]\n[feature g]\n"
               "shape = groove\ndepth = 0.01\nwidth = 0.6\nangle = 90 deg\n"
               "[feature w]\nshape = wave\namplitude = 0.01\n"
               "wavelength = 1\nangle = 90 deg\n");
    assert_int_equal(h.warnings, 0);
    h = review("[contact]\nM = 20\nL = 10\n[strip]\n[feature g]\n"
               "shape = groove\ndepth = 0.01\nwidth = 0.6\nangle = 90 deg\n"
               "length_across = 1\n");
    assert_non_null(strstr(h.warning, "'g' moves"));
}
