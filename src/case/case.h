/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Inside a case: blocks (the sections present) of slots (one a parameter),
 * each of which remembers its text and where it came from, so that an error
 * found late still names file, line and key.
 */
#ifndef OVR_CASE_CASE_H
#define OVR_CASE_CASE_H

#include "base/arena.h"
#include "case/parameters.h"
#include "overroll/case.h"

enum { OVR_NAME_MAX = 48, OVR_LINE_MAX = 190, OVR_CASE_MAX = 1 << 20 };

typedef struct ovr_slot {
    const char *key;
    bool given;
    bool stored;      /* by the text in a result file */
    const char *text; /* as given or the default; NULL: neither */
    const char *file; /* or origin */
    long line;        /* 0: not from a file */
    long replaces;    /* line of the file that a later setting replaced */
    double number;    /* SI or without a unit; for a word its value */
    const char *unit; /* as written; NULL: bare or a word */
    bool word;
    ovr_list list;
    unsigned bits;
} ovr_slot;

typedef struct ovr_block {
    const ovr_section *section;
    size_t first;     /* number of its first row among those of all sections */
    const char *name; /* of a feature; else NULL */
    long line;        /* of its header; 0: none */
    size_t count;     /* of slots, one a row of the section */
    ovr_slot *slots;
    struct ovr_block *next;
} ovr_block;

struct ovr_case {
    ovr_arena arena;
    const char *name;      /* in messages; NULL: no file */
    const char *directory; /* NULL: the working directory */
    const char *source;    /* text read, or NULL */
    ovr_block *blocks;     /* in the order of the sections, then features */
    const char *standing;  /* of a steady solve of an element: a station's name,
                              an angle or a time, "" the nominal; NULL: it runs
                              its way */
};

/* Understands `text`; the error is about the key, which begins it. */
ovr_status ovr_slot_read(const ovr_parameter *row, const char *text,
                         ovr_arena *arena, ovr_slot *slot, ovr_error *err);

/* Fails unless the number, as written in `text`, is in the row's range;
 * `number` is SI where `unit`, else bare. */
ovr_status ovr_range_check(const ovr_parameter *row, double number,
                           const char *text, ovr_error *err);

/* True if `where` names an entry: "contact.M", "feature.dent.depth" or
 * "feature dent.depth". */
bool ovr_entry_is(const ovr_case_entry *entry, const char *where,
                  size_t length);

/* The block of a section; feature blocks by name, made when absent. */
ovr_block *ovr_case_block(ovr_case *c, const ovr_section *section,
                          const char *name, ovr_error *err);
const ovr_block *ovr_case_find_block(const ovr_case *c, const char *section,
                                     const char *name);

/* A block of a feature, not of a body. */
bool ovr_block_is_feature(const ovr_block *block);

/* The slot of a key, NULL with a message that suggests when there is none. */
ovr_slot *ovr_block_slot(const ovr_block *block, const char *key,
                         const ovr_parameter **row, ovr_error *err);

/* Reports an unknown key of a section, with a suggestion. */
void ovr_no_key(const ovr_section *section, const char *key, ovr_error *err);

/* True if a section is in the case, even if it is empty; NULL: no. */
bool ovr_block_is_there(const ovr_block *block);

/* Given and default value of a key that exists. */
const ovr_slot *ovr_block_get(const ovr_block *block, const char *key);

/* True if conditions hold that are written as those of a row are. */
bool ovr_conditions_hold(const ovr_case *c, const ovr_block *block,
                         const char *when);

/* True if a key has an effect beside the values of the others. */
bool ovr_key_applies(const ovr_case *c, const ovr_block *block,
                     const ovr_parameter *row);

/* The words about a key that is given and has no effect. */
typedef struct ovr_idle {
    bool said; /* in a note; else it is refused */
    char text[400];
} ovr_idle;
bool ovr_key_idle(const ovr_case *c, const ovr_block *block,
                  const ovr_slot *slot, ovr_idle *idle);

/* Refuses the first key that is given and has no effect. */
ovr_status ovr_case_check_ineffective(const ovr_case *c, ovr_error *err);

/* The case whose text a result file holds: a key without effect, of which an
 * earlier version said nothing, is no reason to refuse it. */
ovr_case *ovr_case_read_stored(const char *text, const char *name,
                               const char *directory,
                               const ovr_allocator *allocator, ovr_error *err);

/* Makes what is given so far count as stored. */
void ovr_case_mark_stored(ovr_case *c);

/* "[feature NAME]" taken apart: section and name (NULL for plain ones). */
const ovr_section *ovr_section_parse(const char *header, const char **name,
                                     ovr_error *err);

/* OVR_BAD_INPUT about the slot's key: "file:line: key: " (or "origin: key: ")
 * and the message. */
ovr_status ovr_fail_slot(ovr_error *err, const ovr_slot *slot,
                         const char *format, ...) OVR_PRINTF(3, 4);

#endif
