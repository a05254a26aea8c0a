/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Messages about defective X3P files; files of unknown origin are harmless. */
#include "support/test.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "overroll/overroll.h"
#include "surface/zip.h"

static const char good_axes[] =
    "<CX><AxisType>I</AxisType><Increment>1e-6</Increment></CX>"
    "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ>";
static const char good_size[] = "<MatrixDimension><SizeX>3</SizeX><SizeY>1"
                                "</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
static const char data_link[] = "<DataLink><PointDataLink>bindata/data.bin"
                                "</PointDataLink></DataLink>";
static const double three[3] = {1e-6, 2e-6, 4e-6};

static void pack_files(const char *path, const ovr_zip_file *file, size_t files,
                       bool stored)
{
    ovr_arena arena = ovr_arena_make(NULL);
    FILE *to = fopen(path, "wb");
    assert_non_null(to);
    assert_true(ovr_zip_write(to, file, files, stored, &arena));
    assert_int_equal(fclose(to), 0);
    ovr_arena_release(&arena);
}

static void pack(const char *path, const char *xml, size_t points)
{
    const ovr_zip_file files[] = {
        {"bindata/data.bin", three, points * sizeof *three},
        {"main.xml", xml, xml ? strlen(xml) : 0}};
    pack_files(path, files, xml ? 2 : 1, true);
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

TEST(announcements_are_checked)
{
    const char *path = test_path(*state, "a.x3p");
    const char *both = joined(good_size, data_link);
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
    refuse(path, "PRF", good_axes, data_link, "points");
    refuse(path, "PRF", good_axes, "<ListDimension>1e99</ListDimension>",
           "points");
    refuse(path, "PRF", good_axes, "<ListDimension>2.5</ListDimension>",
           "points");
    refuse(path, "PRF", good_axes,
           joined("<ListDimension>4</ListDimension>", data_link), "offset 24");
}

TEST(data_are_checked)
{
    const char *path = test_path(*state, "d.x3p");
    static const char away[] =
        "<DataLink><PointDataLink>../../etc/passwd</PointDataLink></DataLink>";
    refuse(path, "PRF", good_axes, joined(good_size, away),
           "is missing in main.xml");
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

TEST(xml_is_checked)
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

/* A document type is refused before an entity of it is looked at, whether it
 * grows (each of ten entities is ten of the last) or leads to another file. */
TEST(entities_are_refused)
{
    const char *path = test_path(*state, "e.x3p");
    char xml[2000] = "<!DOCTYPE a [<!ENTITY e0 \"ha\">";
    size_t used = strlen(xml);
    for (int k = 1; k <= 10; k++) {
        used += (size_t)snprintf(xml + used, sizeof xml - used,
                                 "<!ENTITY e%d \"", k);
        for (int j = 0; j < 10; j++)
            used += (size_t)snprintf(xml + used, sizeof xml - used, "&e%d;",
                                     k - 1);
        used += (size_t)snprintf(xml + used, sizeof xml - used, "\">");
    }
    snprintf(xml + used, sizeof xml - used, "]><a>&e10;</a>");
    pack(path, xml, 3);
    refuse_file(path, "document type");
    pack(path, "<!DOCTYPE a [<!ENTITY e SYSTEM \"/etc/passwd\">]><a>&e;</a>",
         3);
    refuse_file(path, "document type");
    pack(path, "<!DOCTYPE a SYSTEM \"/etc/passwd\"><a/>", 3);
    refuse_file(path, "document type");
    pack(path, "<a>&e;</a>", 3);
    refuse_file(path, "entity");
}

static size_t files_in(const char *folder)
{
    DIR *d = opendir(folder);
    size_t count = 0;
    assert_non_null(d);
    while (readdir(d))
        count++;
    closedir(d);
    return count;
}

/* Members are read in memory: a name that leads out of the folder is a name
 * like any other, and no file appears by it. */
TEST(member_names_are_no_paths)
{
    char *outside = strdup(test_path(*state, "outside.bin"));
    const char *path = test_path(*state, "m.x3p");
    const char *const names[] = {"../outside.bin", outside,
                                 "a/../../outside.bin"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char xml[2000];
        ovr_error err = {0};
        ovr_profile *p;
        size_t before;
        snprintf(xml, sizeof xml,
                 "<a><Record1><FeatureType>PRF</FeatureType><Axes>%s</Axes>"
                 "</Record1><Record3>%s<DataLink><PointDataLink>%s"
                 "</PointDataLink></DataLink></Record3></a>",
                 good_axes, good_size, names[k]);
        const ovr_zip_file files[] = {{"main.xml", xml, strlen(xml)},
                                      {names[k], three, sizeof three}};
        pack_files(path, files, 2, true);
        before = files_in(*state);
        p = read_back(path, &err);
        assert_non_null(p);
        CHECK_NEAR(ovr_profile_get_view(p)->z[1], 2e-6, 1e-20);
        ovr_profile_free(p);
        assert_int_equal(files_in(*state), before);
        assert_int_not_equal(access(outside, F_OK), 0);
    }
    free(outside);
}

/* Deflate makes 64 kB of 64 MB of spaces. */
TEST(bombs_are_refused)
{
    enum { MAX = 1 << 26 };
    const char *path = test_path(*state, "b.x3p");
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err = {0};
    test_faults count;
    char *spaces = malloc(MAX + 1);
    memset(spaces, ' ', MAX + 1);
    pack_files(path, &(ovr_zip_file){"main.xml", spaces, MAX + 1}, 1, false);
    test_faults_init(&count);
    source.file = path;
    assert_null(ovr_profile_read(&source, &count.hook, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "larger than the maximum of 67108864");
    assert_true(count.bytes < MAX / 8);
    assert_int_equal(count.live, 0);
    free(spaces);
}

/* A letter may be three bytes in UTF-8 and two in the file. */
TEST(inline_letters_do_not_overflow)
{
    const char *path = test_path(*state, "w.x3p");
    enum { DATA = 200, LETTERS = 80 };
    static unsigned char xml[200000];
    static const char *const parts[] = {"<a><DataList>", "<Datum>", "</Datum>",
                                        "</DataList></a>"};
    size_t used = 2;
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
    pack_files(path, &(ovr_zip_file){"main.xml", xml, used}, 1, true);
    refuse_file(path, "main.xml");
}

/* A wrong checksum of any part is reported as damage. */
TEST(damaged_content_is_refused)
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
             good_axes, good_size, data_link);
    pack(path, xml, 3);
    p = read_back(path, &err);
    assert_non_null(p);
    CHECK_NEAR(ovr_profile_get_view(p)->z[2], 4e-6, 1e-20);
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

TEST_GROUP(test_make_folder, test_remove_folder)
