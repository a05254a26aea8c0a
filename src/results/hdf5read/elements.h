/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types, dimensions and values of datasets and attributes. */
#ifndef OVR_HDF5READ_ELEMENTS_H
#define OVR_HDF5READ_ELEMENTS_H

#include "results/hdf5read/heap.h"

/* Finds a message of an object's header by its type. */
bool ovr_object_message(ovr_source *source, uint64_t object, unsigned target,
                        ovr_piece *body);

/* Reads all links or all attributes of an object, whether they are in its
 * header or in a heap. */
enum { OVR_ITEM_LINK = 0x06, OVR_ITEM_ATTRIBUTE = 0x0c };
bool ovr_object_items(ovr_source *source, uint64_t object, unsigned target,
                      ovr_items *items);

/* True if the name consists of letters, digits and _, as all names written by
 * this program. */
bool ovr_plain_name(const unsigned char *name, size_t length);

/* Parse the messages of the data type and of the dataspace: rank, shape and
 * width (missing dimensions are 1). They return false for types and shapes that
 * the writer does not use. */
bool ovr_element_read(ovr_piece type, ovr_datatype *element);
bool ovr_shape_read(ovr_piece space, ovr_dataset *set);

/* Converts elements of the file to doubles. */
void ovr_element_values(const ovr_datatype *element, const unsigned char *from,
                        size_t count, double *values);

#endif
