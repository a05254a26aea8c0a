/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Types, dimensions and values of datasets and attributes. */
#ifndef OVR_HDF5READ_ELEMENTS_H
#define OVR_HDF5READ_ELEMENTS_H

#include "results/hdf5read/heap.h"

/* A message of an object's header by its kind. */
bool ovr_object_message(ovr_source *source, uint64_t object, unsigned target,
                        ovr_piece *body);

/* All links or all attributes of an object, wherever they are. */
enum { OVR_ITEM_LINK = 0x06, OVR_ITEM_ATTRIBUTE = 0x0c };
bool ovr_object_items(ovr_source *source, uint64_t object, unsigned target,
                      ovr_items *items);

/* A name of this program's: letters, digits and _. */
bool ovr_plain_name(const unsigned char *name, size_t length);

/* Makes an element from such messages: the type; rank, shape and width (missing
 * dimensions are 1); false for what the writer never makes. */
bool ovr_element_read(ovr_piece type, ovr_datatype *element);
bool ovr_shape_read(ovr_piece space, ovr_dataset *set);

/* Numbers of the file as numbers here. */
void ovr_element_values(const ovr_datatype *element, const unsigned char *from,
                        size_t count, double *values);

#endif
