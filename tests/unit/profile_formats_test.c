/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random surfaces written in every format and encoding and read back within
 * rounding; messages about damaged files with the position of the error. */
#include "support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "overroll/overroll.h"
#include "support/gauges.h"
#include "surface/profile.h"

static gauge g;
static char bytes[GAUGE_BYTES];

/* ------------------------------------------------------------ comparison */

static void compare(const ovr_profile *p, size_t line, double step,
                    double shift, const char *what)
{
    const ovr_profile_view *v = ovr_profile_get_view(p);
    assert_int_equal(v->n, g.n);
    for (size_t i = 0; i < g.n; i++) {
        double z = g.z[line][i], size = fabs(g.x[0]) + (double)g.n * g.dx;
        if (fabs(v->x[i] - g.x[i]) > 1e-15 * size)
            fail_msg("%s: x[%zu] = %.17g, not %.17g", what, i, v->x[i], g.x[i]);
        if (isnan(z) ? !isnan(v->z[i])
                     : !(fabs(v->z[i] - shift - z) <=
                         4e-16 * (fabs(z) + fabs(shift)) + 0.5001 * step))
            fail_msg("%s: z[%zu] = %.17g, not %.17g", what, i, v->z[i], z);
    }
    assert_true(strlen(v->notes) > 0);
}

static ovr_profile *parse(const char *data, size_t size, int line)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err;
    ovr_profile *p;
    source.file = "it";
    source.row = line;
    p = ovr_profile_parse(&source, data, size, NULL, &err);
    if (!p)
        fail_msg("%s", err.message);
    return p;
}

static void check_bytes(size_t size, size_t line, double step, double shift,
                        const char *what)
{
    ovr_profile *p = parse(bytes, size, g.lines > 1 ? (int)line + 1 : 0);
    compare(p, line, step, shift, what);
    ovr_profile_free(p);
}

/* ------------------------------------------------------------ round trips */

static void check_text(const gauge_text *how)
{
    char what[80];
    snprintf(what, sizeof what, "text '%c' encoding %d index %d",
             how->separator, (int)how->encoding, how->index);
    check_bytes(gauge_as_text(&g, how, bytes), 0, 0, 0, what);
}

TEST(text_comes_back)
{
    static const char separators[] = {' ', '\t', ',', ';'};
    static const char *const newlines[] = {"\n", "\r\n", "\r\r\n", "\r"};
    uint64_t seed = 11;
    for (unsigned k = 0; k < 4 * 4 * GAUGE_ENCODINGS * 2; k++) {
        gauge_text how = {
            .separator = separators[k % 4],
            .newline = newlines[k / 4 % 4],
            .encoding = (gauge_encoding)(k / 16 % GAUGE_ENCODINGS),
            .index = k / 16 / GAUGE_ENCODINGS};
        how.trailing = how.separator != ' ' && test_random(&seed, 0, 2) < 1;
        how.count = test_random(&seed, 0, 2) < 1;
        how.backwards = test_random(&seed, 0, 2) < 1;
        gauge_make(&g, &seed, test_random(&seed, 0, 2) < 1, 1, true);
        check_text(&how);
    }
}

TEST(gzipped_text_comes_back)
{
    const char *path = test_path(*state, "anything.dat");
    gauge_text how = {
        .separator = ';', .newline = "\r\n", .encoding = GAUGE_UTF16_LITTLE};
    ovr_profile_source source = ovr_profile_source_default();
    uint64_t seed = 12;
    ovr_error err;
    gauge_make(&g, &seed, false, 1, true);
    source.file = path;
    for (int packed = 0; packed < 2; packed++) {
        size_t size = gauge_as_text(&g, &how, bytes);
        gzFile out = gzopen(path, packed ? "wb" : "wbT");
        ovr_profile *p;
        assert_int_equal(gzwrite(out, bytes, (unsigned)size), (int)size);
        assert_int_equal(gzclose(out), Z_OK);
        p = ovr_profile_read(&source, NULL, &err);
        assert_non_null(p);
        compare(p, 0, 0, 0, "gz");
        ovr_profile_free(p);
    }
}

TEST(saved_text_comes_back_exactly)
{
    const char *path = test_path(*state, "saved.csv");
    ovr_profile_source source = ovr_profile_source_default();
    uint64_t seed = 13;
    ovr_error err;
    source.file = path;
    for (int k = 0; k < 8; k++) {
        ovr_profile *p, *q;
        const ovr_profile_view *a, *b;
        gauge_make(&g, &seed, k % 2, 1, true);
        p = ovr_profile_create(g.n, g.x, g.z[0], k / 4, NULL, &err);
        assert_non_null(p);
        CHECK_OK(ovr_profile_save(p, path, &err), &err);
        q = ovr_profile_read(&source, NULL, &err);
        assert_non_null(q);
        a = ovr_profile_get_view(p), b = ovr_profile_get_view(q);
        assert_int_equal(a->n, b->n);
        assert_true(a->scaled_x == b->scaled_x && a->scaled_z == b->scaled_z);
        for (size_t i = 0; i < a->n; i++) {
            assert_true(a->x[i] == b->x[i]);
            assert_true(a->z[i] == b->z[i] ||
                        (isnan(a->z[i]) && isnan(b->z[i])));
        }
        ovr_profile_free(p), ovr_profile_free(q);
    }
}

TEST(sdf_comes_back)
{
    static const double half[] = {128, 32768, 2147483648.0, 0, 0, 0, 0, 0};
    uint64_t seed = 14;
    for (int k = 0; k < 80; k++) {
        size_t lines = (size_t)test_random(&seed, 1, 4.99), line;
        int type = k % 8;
        bool is_unsigned = half[type] > 0;
        double step;
        gauge_make(&g, &seed, true, lines, !is_unsigned);
        line = (size_t)test_random(&seed, 0, (double)lines);
        check_bytes(gauge_as_sdf_text(&g, bytes), line, 0, 0, "SDF text");
        gauge_as_sdf_binary(&g, type, bytes, &step);
        check_bytes(gauge_as_sdf_binary(&g, type, bytes, &step), line,
                    type == 3   ? 1e-12
                    : type == 7 ? 0
                                : step,
                    half[type] * step, "SDF binary");
    }
}

TEST(smd_comes_back)
{
    uint64_t seed = 15;
    for (int k = 0; k < 20; k++) {
        gauge_make(&g, &seed, true, 1, true);
        check_bytes(gauge_as_smd(&g, bytes), 0, 0, 0, "SMD");
    }
}

TEST(x3p_comes_back)
{
    const char *path = test_path(*state, "it.x3p");
    uint64_t seed = 16;
    ovr_error err;
    for (unsigned k = 0; k < 256; k++) {
        gauge_x3p how = {.type = "ILFD"[k % 4],
                         .stored_x = k / 4 % 2,
                         .inline_data = k / 8 % 2,
                         .mask = k / 16 % 2,
                         .list = k / 32 % 2,
                         .prefix = k / 64 % 2,
                         .deflate = k / 128 % 2,
                         .folder = k % 3 ? "" : "some folder/"};
        bool whole = how.type == 'I' || how.type == 'L';
        size_t lines = how.list ? 1 : (size_t)test_random(&seed, 1, 3.99);
        ovr_profile_source source = ovr_profile_source_default();
        ovr_profile *p;
        double step;
        gauge_make(&g, &seed, !how.stored_x, lines,
                   !whole || how.mask || how.inline_data);
        if (whole && how.mask && how.inline_data)
            how.mask = false;
        gauge_to_x3p(&g, &how, path, &step);
        source.file = path;
        source.row = (int)lines;
        p = ovr_profile_read(&source, NULL, &err);
        if (!p)
            fail_msg("%u: %s", k, err.message);
        compare(p, lines - 1,
                whole             ? step
                : how.type == 'F' ? 1e-12
                                  : 0,
                0, "X3P");
        ovr_profile_free(p);
    }
}

/* --------------------------------------------------------------- mistakes */

static void refuse(const char *text, size_t size, const char *word)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err = {0};
    ovr_profile *p;
    source.file = "f.txt";
    p = ovr_profile_parse(&source, text, size, NULL, &err);
    if (p)
        fail_msg("accepted: '%s'", text);
    CHECK_ERROR(&err, OVR_BAD_INPUT, word);
}

static void refuse_text(const char *text, const char *word)
{
    refuse(text, strlen(text), word);
}

TEST(mistakes_in_text_are_reported)
{
    refuse_text("", "empty");
    refuse_text("hello\n", "no line of numbers");
    refuse_text("x,z um\n1,2\n2,3\n", "unit_x");
    refuse_text("x um,z\n1,2\n2,3\n", "unit_z");
    refuse_text("x um,z um\n1,2\n", "two points");
    refuse_text("x um,z um\n1,2\n2,a\n", "f.txt:3: 'a'");
    refuse_text("x um,z um\n1,2\n,3\n", "f.txt:3");
    refuse_text("x um,z um\n1,2\n2\n", "f.txt:3");
    refuse_text("x um,z um\n1,2\n3,3\n2,4\n9,9", "f.txt:4: x is not monotonic");
    refuse_text("x um,z um\n1,NaN\n3,BAD\n", "none of the 2");
    refuse_text("z um\n1\n2\n3\n", "spacing");
    refuse_text("1,2,3\n2,3,4\n", "column_z");
    refuse_text("a,x um,b\n1,2,3\n2,3,4\n", "column");
    refuse("x um,z um\n1,2\n\0\n", 16, "f.txt:3");
    refuse("x\0um\n1,2\n", 10, "NUL");
}

TEST(mistakes_in_sdf_are_reported)
{
    double step;
    uint64_t seed = 3;
    size_t size;
    refuse_text("aISO-1.0\nNumPoints = 3\n", "*");
    refuse_text("aISO-1.0\nNumPoints = 3\n*\n1 2 3\n*\n", "Xscale");
    refuse_text("aISO-1.0\nNumPoints = x\n*\n", "f.txt:2");
    refuse_text("aISO-1.0\nNumPoints = 3\nXscale=1e-6\nZscale=1e-6\n*\n1 2\n*",
                "end after 2");
    refuse_text("aISO-1.0\nNumPoints=3\nXscale=1e-6\nZscale=1e-6\n*\n1 2 q\n*",
                "f.txt:6: 'q'");
    gauge_make(&g, &seed, true, 2, false);
    size = gauge_as_sdf_binary(&g, 5, bytes, &step);
    refuse(bytes, 50, "offset 50");
    refuse(bytes, size - 1, "truncated");
    bytes[79] = 9;
    refuse(bytes, size, "DataType = 9");
}

TEST(mistakes_in_smd_are_reported)
{
    refuse_text("r\nPRF 0 n\nCX I 3 mm 1 D 0.1\nCZ A 3 um 1 D\n\x03\n\x03\n"
                "1\n2\n\x03\n9\n\x03\n",
                "end after 2");
    refuse_text("r\nPRF 0 n\nCX I 3 mm 1 D 0.1\nCZ A 3 um 1 D\n\x03\n\x03",
                "third record");
    refuse_text("r\nPRF 0 n\nCX I 3 ft 1 D 0.1\nCZ A 3 um 1 D\n\x03\n", "'ft'");
    refuse_text("r\nPRF 0 n\nCX A 3 mm 1 D 0.1\nCZ A 3 um 1 D\n\x03\n",
                "incremental");
    refuse_text("r\nPRF 0 n\nCX I 3 mm 1 D 0.1\nCZ A 3 um 1 D\n\x03\nt\n\x03\n"
                "1\nz\n\x03\n",
                "f.txt:9: 'z'");
}

/* Sizes of which nothing is there: refused before memory is asked for. */
TEST(huge_announcements_are_refused)
{
    static const char *const sdf[] = {
        "4294967297", "18446744073709551618", "1e300", "inf", "nan", "-3"};
    double step;
    uint64_t seed = 4;
    size_t size;
    for (size_t k = 0; k < sizeof sdf / sizeof *sdf; k++) {
        char text[300];
        snprintf(text, sizeof text,
                 "aISO-1.0\nNumPoints=%s\nXscale=1e-6\nZscale=1\n*\n1 2 3\n",
                 sdf[k]);
        refuse_text(text, "NumPoints");
        snprintf(text, sizeof text,
                 "aISO-1.0\nNumPoints=3\nNumProfiles=%s\nXscale=1e-6\n"
                 "Zscale=1\n*\n1 2 3\n",
                 sdf[k]);
        refuse_text(text, "NumProfiles");
        snprintf(text, sizeof text,
                 "r\nPRF 0 n\nCX I %s mm 1 D 0.1\nCZ A 3 um 1 D\n\x03\nt\n"
                 "\x03\n1\n2\n\x03\n",
                 sdf[k]);
        refuse_text(text, "");
        snprintf(text, sizeof text,
                 "r\nSUR 0 n\nCX I 2 mm 1 D 0.1\nCY I %s mm 1 D 0.1\n"
                 "CZ A 3 um 1 D\n\x03\nt\n\x03\n1\n2\n\x03\n",
                 sdf[k]);
        refuse_text(text, "");
    }
    gauge_make(&g, &seed, true, 2, false);
    size = gauge_as_sdf_binary(&g, 7, bytes, &step);
    memset(bytes + 42, 0xff, 4); /* 65535 x 65535 values of 8 bytes */
    refuse(bytes, size, "65535 x 65535 values");
}

/* Members of a gzip file follow each other: a million zeros, 300 times. */
TEST(bombs_are_refused)
{
    enum { PIECE = 1 << 20, PIECES = 300 };
    const char *path = test_path(*state, "bomb.gz");
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err = {0};
    test_faults count;
    gzFile out = gzopen(path, "wb");
    char *zeros = calloc(1, PIECE), *member;
    size_t size;
    FILE *all;
    assert_int_equal(gzwrite(out, zeros, PIECE), PIECE);
    assert_int_equal(gzclose(out), Z_OK);
    member = test_read(path, &size);
    all = fopen(path, "wb");
    for (int k = 0; k < PIECES; k++)
        assert_int_equal(fwrite(member, 1, size, all), size);
    assert_int_equal(fclose(all), 0);
    test_faults_init(&count);
    source.file = path;
    assert_null(ovr_profile_read(&source, &count.hook, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "larger than 256 MiB");
    assert_true(count.bytes < 1.5 * (1 << 28));
    assert_int_equal(count.live, 0);
    free(member);
    free(zeros);
}

/* Cut anywhere, a file is refused or read, never more. */
TEST(cut_files_do_no_harm)
{
    const char *path = test_path(*state, "cut.x3p");
    gauge_x3p how = {.type = 'D', .deflate = true, .mask = true, .folder = ""};
    uint64_t seed = 5;
    double step;
    size_t size;
    char *all;
    gauge_make(&g, &seed, true, 2, true);
    gauge_to_x3p(&g, &how, path, &step);
    all = test_read(path, &size);
    for (size_t cut = 0; cut < size; cut += 7) {
        ovr_profile_source source = ovr_profile_source_default();
        ovr_error err;
        char *part = malloc(cut + 1); /* so that a reader's step shows */
        ovr_profile *p;
        memcpy(part, all, cut);
        p = ovr_profile_parse(&source, part, cut, NULL, &err);
        if (!p)
            assert_null(strchr(err.message, '\n'));
        ovr_profile_free(p);
        free(part);
    }
    free(all);
}

TEST(missing_files_are_named)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_error err;
    source.file = test_path(*state, "absent.csv");
    assert_null(ovr_profile_read(&source, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "absent.csv");
    source.file = *state;
    assert_null(ovr_profile_read(&source, NULL, &err));
    CHECK_ERROR(&err, OVR_BAD_INPUT, "cannot be read");
    source.file = NULL;
    assert_null(ovr_profile_read(&source, NULL, &err));
}

/* ------------------------------------------------------------ allocations */

static ovr_status read_once(void *data, const ovr_allocator *hook,
                            ovr_error *err)
{
    ovr_profile_source source = ovr_profile_source_default();
    ovr_profile *p;
    source.file = data;
    p = ovr_profile_read(&source, hook, err);
    if (!p)
        return err->status;
    ovr_profile_free(p);
    return OVR_OK;
}

TEST(every_allocation_may_fail)
{
    const char *path = test_path(*state, "faults");
    gauge_text text = {
        .separator = ',', .newline = "\n", .encoding = GAUGE_UTF16_BIG};
    gauge_x3p x3p = {.type = 'L', .inline_data = true, .folder = ""};
    uint64_t seed = 17;
    double step;
    gauge_make(&g, &seed, true, 1, false);
    test_write(path, bytes, gauge_as_text(&g, &text, bytes));
    assert_true(test_every_allocation(read_once, (void *)(uintptr_t)path) > 1);
    test_write(path, bytes, gauge_as_sdf_text(&g, bytes));
    assert_true(test_every_allocation(read_once, (void *)(uintptr_t)path) > 1);
    test_write(path, bytes, gauge_as_smd(&g, bytes));
    assert_true(test_every_allocation(read_once, (void *)(uintptr_t)path) > 1);
    gauge_to_x3p(&g, &x3p, path, &step);
    assert_true(test_every_allocation(read_once, (void *)(uintptr_t)path) > 2);
}

TEST_GROUP(test_make_folder, test_remove_folder)
