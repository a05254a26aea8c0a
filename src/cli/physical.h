/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers as engineers write them, beside the Hertzian ones. */
#ifndef OVR_CLI_PHYSICAL_H
#define OVR_CLI_PHYSICAL_H

#include "overroll/contact.h"

/* Films in um, pressures in GPa, times in ms, lengths as they are; "" when
 * nothing is known in SI. */
enum { CLI_PHYSICAL_SIZE = 40 };
void cli_physical(double value, ovr_unit_kind kind, const ovr_contact *contact,
                  char text[CLI_PHYSICAL_SIZE]);

/* On stdout: `X = 0.4 (12.3 um)`, the name given with its sign or word. */
void cli_put_place(const char *name, double value, ovr_unit_kind kind,
                   const ovr_contact *contact);

#endif
