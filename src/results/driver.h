/* SPDX-License-Identifier: GPL-3.0-or-later */
/* HDF5 on a store: a file driver whose bytes are the store's. */
#ifndef OVR_RESULTS_DRIVER_H
#define OVR_RESULTS_DRIVER_H

#include <hdf5.h>

#include "results/store.h"

/* Creates or opens the store's file in HDF5; negative on failure.  The store
 * must outlive it. */
hid_t ovr_driver_create(ovr_store *store, hid_t creation);
hid_t ovr_driver_open(ovr_store *store);

/* Has to be called when the file is closed. */
void ovr_driver_release(ovr_store *store);

#endif
