/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is wrong with an X3P file is said; strangers' files do no harm. */
#include "support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

#include "overroll/overroll.h"

static const char good_axes[] =
    "<CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>"
    "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ>";
static const char good_size[] = "<MatrixDimension><SizeX>3</SizeX><SizeY>1"
                                "</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
static const char link[] = "<DataLink><PointDataLink>bindata/data.bin"
                           "</PointDataLink></DataLink>";
static const double three[3] = {1e-6, 2e-6, 4e-6};

static void add(zip_t *zip, const char *name, const void *data, size_t size)
{
    zip_source_t *source = zip_source_buffer(zip, data, size, 0);
    zip_int64_t index;
    assert_non_null(source);
    index = zip_file_add(zip, name, source, 0);
    assert_true(index >= 0);
    zip_set_file_compression(zip, (zip_uint64_t)index, ZIP_CM_STORE, 0);
}

static void pack(const char *path, const char *xml, size_t points)
{
    zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, NULL);
    assert_non_null(zip);
    if (xml)
        add(zip, "main.xml", xml, strlen(xml));
    add(zip, "bindata/data.bin", three, points * sizeof *three);
    assert_int_equal(zip_close(zip), 0);
}

static ovr_profile *read_back(const char *path, ovr_error *err)
{
    ovr_profile_source source = ovr_profile_source_default();
    source.file = path;
    return ovr_profile_read(&source, NULL, err);
}

static void refuse_file(const char *path, const char *word)
{
    ovr_error err = {0};
    ovr_profile *p = read_back(path, &err);
    if (p)
        fail_msg("accepted without '%s'", word);
    CHECK_ERROR(&err, OVR_BAD_INPUT, word);
}

static void refuse(const char *path, const char *feature, const char *axes,
                   const char *record3, const char *word)
{
    char xml[4000];
    snprintf(xml, sizeof xml,
             "<?xml version=\"1.0\"?><p:ISO5436_2 xmlns:p=\"x\"><Record1>"
             "<FeatureType>%s</FeatureType><Axes>%s</Axes></Record1>"
             "<Record3>%s</Record3></p:ISO5436_2>",
             feature, axes, record3);
    pack(path, xml, 3);
    refuse_file(path, word);
}

static const char *joined(const char *a, const char *b)
{
    static char text[1000];
    snprintf(text, sizeof text, "%s%s", a, b);
    return text;
}

static void announcements_are_checked(void **state)
{
    const char *path = test_path(*state, "a.x3p");
    const char *both = joined(good_size, link);
    refuse(path, "PCL", good_axes, both, "FeatureType 'PCL'");
    refuse(path, "A long text", good_axes, both, "too long");
    refuse(path, "PRF", "", both, "needs the axes");
    refuse(path, "PRF",
           "<CX><AxisType>I</AxisType><Increment>-1</Increment></CX>"
           "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ>",
           both, "must be positive");
    refuse(path, "PRF",
           "<CX><AxisType>I</AxisType><Increment>one</Increment></CX>", both,
           "main.xml:1: a number");
    refuse(path, "PRF",
           "<CX><AxisType>I</AxisType></CX>"
           "<CZ><AxisType>A</AxisType><DataType>Q</DataType></CZ>",
           both, "I, L, F or D");
    refuse(path, "PRF", good_axes, link, "points");
    refuse(path, "PRF", good_axes, "<ListDimension>1e99</ListDimension>",
           "points");
    refuse(path, "PRF", good_axes, "<ListDimension>2.5</ListDimension>",
           "points");
    refuse(path, "PRF", good_axes,
           joined("<ListDimension>4</ListDimension>", link), "offset 24");
}

static void data_are_checked(void **state)
{
    const char *path = test_path(*state, "d.x3p");
    static const char away[] =
        "<DataLink><PointDataLink>../../etc/passwd</PointDataLink></DataLink>";
    refuse(path, "PRF", good_axes, joined(good_size, away), "not in it");
    refuse(path, "PRF", good_axes,
           joined(good_size, "<DataLink><PointDataLink>bindata/data.bin"
                             "</PointDataLink><ValidPointsLink>no"
                             "</ValidPointsLink></DataLink>"),
           "'no'");
    refuse(path, "PRF", good_axes,
           joined(good_size, "<DataList><Datum>1</Datum></DataList>"),
           "ends after 1");
    refuse(path, "PRF", good_axes,
           joined(good_size, "<DataList><Datum>1</Datum><Datum>high</Datum>"
                             "<Datum>2</Datum></DataList>"),
           "Datum 2: 'high'");
    refuse(path, "PRF", good_axes,
           joined(good_size, "<DataList><Datum/><Datum/><Datum/></DataList>"),
           "none of the 3");
}

static void xml_is_checked(void **state)
{
    const char *path = test_path(*state, "x.x3p");
    char deep[1000] = "";
    pack(path, NULL, 3);
    refuse_file(path, "main.xml");
    pack(path, "<a><b></a>", 3);
    refuse_file(path, "main.xml:1");
    pack(path, "<!DOCTYPE a [<!ENTITY e \"x\">]><a>&e;</a>", 3);
    refuse_file(path, "document type");
    for (int k = 0; k < 40; k++)
        strcat(deep, "<a>");
    pack(path, deep, 3);
    refuse_file(path, "nested");
}

/* A letter may be three bytes in UTF-8 and two in the file. */
static void inline_letters_do_not_overflow(void **state)
{
    const char *path = test_path(*state, "w.x3p");
    enum { DATA = 200, LETTERS = 80 };
    static unsigned char xml[200000];
    static const char *const parts[] = {"<a><DataList>", "<Datum>", "</Datum>",
                                        "</DataList></a>"};
    size_t used = 2;
    zip_t *zip = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, NULL);
    xml[0] = 0xFF, xml[1] = 0xFE;
    for (int k = -1; k <= DATA; k++) {
        for (int half = 0; half < 2; half++) {
            const char *text = k < 0      ? (half ? "" : parts[0])
                               : k < DATA ? parts[1 + half]
                                          : (half ? "" : parts[3]);
            for (; *text; text++, used += 2)
                xml[used] = (unsigned char)*text;
            for (int j = 0; !half && k >= 0 && k < DATA && j < LETTERS; j++)
                xml[used] = 0x01, xml[used + 1] = 0x4E, used += 2;
        }
    }
    add(zip, "main.xml", xml, used);
    assert_int_equal(zip_close(zip), 0);
    refuse_file(path, "main.xml");
}

/* A checksum that does not fit is damage, wherever it is. */
static void damaged_content_is_refused(void **state)
{
    const char *path = test_path(*state, "c.x3p");
    char xml[2000];
    size_t size, hit = 0;
    char *bytes;
    ovr_error err;
    ovr_profile *p;
    snprintf(xml, sizeof xml,
             "<a><Record1><FeatureType>PRF</FeatureType><Axes>%s</Axes>"
             "</Record1><Record3>%s%s</Record3></a>",
             good_axes, good_size, link);
    pack(path, xml, 3);
    p = read_back(path, &err);
    assert_non_null(p);
    CHECK_NEAR(ovr_profile_look(p)->z[2], 4e-6, 1e-20);
    ovr_profile_free(p);
    bytes = test_read(path, &size);
    for (size_t i = 0; i + sizeof three <= size; i++)
        if (!memcmp(bytes + i, three, sizeof three))
            hit = i;
    assert_true(hit > 0);
    bytes[hit + 3] ^= 1;
    test_write(path, bytes, size);
    refuse_file(path, "damaged");
    free(bytes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(announcements_are_checked),
        cmocka_unit_test(data_are_checked),
        cmocka_unit_test(xml_is_checked),
        cmocka_unit_test(inline_letters_do_not_overflow),
        cmocka_unit_test(damaged_content_is_refused),
    };
    return cmocka_run_group_tests(tests, test_make_folder, test_remove_folder);
}
