/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Read before each file by clang-tidy alone.  It sees one file at a time, so
 * that ovr_fail() might return OVR_OK for all it knows, and what a failing
 * function left unset be used.  Here the failing calls have the value of the
 * status they are given.
 */
#include "base/error.h"

#define ovr_fail(err, status, ...)                                             \
    ((void)(ovr_fail)(err, status, __VA_ARGS__), (status))
#define ovr_fail_meant(err, status, meant)                                     \
    ((void)(ovr_fail_meant)(err, status, meant), (status))
#define ovr_fail_at(err, status, ...)                                          \
    ((void)(ovr_fail_at)(err, status, __VA_ARGS__), (status))
