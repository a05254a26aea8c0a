/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Internal structure of a case: blocks (one per section present) of slots (one
 * per parameter). A slot stores its text and origin, so that errors detected
 * later also name file, line and key.
 */
#ifndef OVR_CASE_CASE_H
#define OVR_CASE_CASE_H

#include "base/arena.h"
#include "case/parameters.h"
#include "overroll/case.h"
#include "surface/two_columns.h"

enum { OVR_NAME_MAX = 48, OVR_LINE_MAX = 190, OVR_CASE_MAX = 1 << 20 };

typedef struct ovr_slot {
    const char *key;
    bool given;
    bool stored;      /* read from the text in a result file */
    const char *text; /* value as given, or the default; NULL: neither */
    const char *file; /* file or other origin */
    long line;        /* line number; 0: not from a file */
    long replaces;    /* line of the file whose setting this one replaces */
    double number;    /* in SI or without a unit; the value of a word */
    const char *unit; /* unit as written; NULL for none and for words */
    bool word;
    ovr_list list;
    unsigned bits;
} ovr_slot;

typedef struct ovr_block {
    const ovr_section *section;
    size_t first;     /* index of its first row among the rows of all
                       * sections */
    const char *name; /* name of a feature; otherwise NULL */
    long line;        /* line of its header; 0: none */
    size_t count;     /* number of slots, one per row of the section */
    ovr_slot *slots;
    struct ovr_block *next;
} ovr_block;

struct ovr_case {
    ovr_arena arena;
    const char *name;      /* for messages; NULL: no file */
    const char *directory; /* NULL: the working directory */
    const char *source;    /* text read, or NULL */
    ovr_block *blocks;     /* in the order of the sections, followed by
                            * features */
    const char *standing;  /* position of a steady solution of a machine
                            * element: name of a contact point, an angle or a
                            * time; "": reference position; NULL: solved along
                            * its path */
};

/* Parses `text`. The error message begins with the key. */
ovr_status ovr_slot_read(const ovr_parameter *row, const char *text,
                         ovr_arena *arena, ovr_slot *slot, ovr_error *err);

/* Fails unless the number is in the row's range. `text`: the number as written.
 * `number` is in SI if `unit` is given, otherwise without unit. */
ovr_status ovr_range_check(const ovr_parameter *row, double number,
                           const char *text, ovr_error *err);

/* True if `where` names an entry: "contact.M", "feature.dent.depth" or
 * "feature dent.depth". */
bool ovr_entry_is(const ovr_case_entry *entry, const char *where,
                  size_t length);

/* Returns the block of a section; of features by name, created if absent. */
ovr_block *ovr_case_block(ovr_case *c, const ovr_section *section,
                          const char *name, ovr_error *err);
const ovr_block *ovr_case_find_block(const ovr_case *c, const char *section,
                                     const char *name);

/* True for the block of a feature, false for that of a body. */
bool ovr_block_is_feature(const ovr_block *block);

/* Returns the slot of a key. If there is none, returns NULL with a message that
 * suggests a key. */
ovr_slot *ovr_block_slot(const ovr_block *block, const char *key,
                         const ovr_parameter **row, ovr_error *err);

/* Reports an unknown key of a section, with a suggestion. */
void ovr_no_key(const ovr_section *section, const char *key, ovr_error *err);

/* True if a section is in the case, even if it is empty; false for NULL. */
bool ovr_block_is_there(const ovr_block *block);

/* Returns the slot of an existing key, given or default. */
const ovr_slot *ovr_block_get(const ovr_block *block, const char *key);

/* True if a key has an effect with the present values of the other keys. */
bool ovr_key_applies(const ovr_case *c, const ovr_block *block,
                     const ovr_parameter *row);

/* Explanation why a given key has no effect. */
typedef struct ovr_idle {
    bool said; /* printed as a note; otherwise the key is rejected */
    char text[400];
} ovr_idle;
bool ovr_key_idle(const ovr_case *c, const ovr_block *block,
                  const ovr_slot *slot, ovr_idle *idle);

/* Rejects the first given key that has no effect. */
ovr_status ovr_case_check_ineffective(const ovr_case *c, ovr_error *err);

/* Reads the case text stored in a result file. Keys without effect, which
 * earlier versions accepted, are not rejected. */
ovr_case *ovr_case_read_stored(const char *text, const char *name,
                               const char *directory,
                               const ovr_allocator *allocator, ovr_error *err);

/* Marks all present settings as stored. */
void ovr_case_mark_stored(ovr_case *c);

/* Splits "[feature NAME]" into section and name (NULL for sections without a
 * name). */
const ovr_section *ovr_section_parse(const char *header, const char **name,
                                     ovr_error *err);

/* Fails with OVR_BAD_INPUT about the slot's key: "file:line: key: " (or
 * "origin: key: ") and the message. */
ovr_status ovr_fail_slot(ovr_error *err, const ovr_slot *slot,
                         const char *format, ...) OVR_PRINTF(3, 4);

/* Reads the file of two columns that the slot's key names. */
ovr_status ovr_slot_columns(const ovr_slot *slot, const char *file,
                            ovr_two_columns *columns, ovr_arena *arena,
                            ovr_error *err);

#endif
