/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Everything: include this one. */
#ifndef OVERROLL_OVERROLL_H
#define OVERROLL_OVERROLL_H

#include "overroll/areal.h"
#include "overroll/case.h"
#include "overroll/conflicts.h"
#include "overroll/contact.h"
#include "overroll/elements.h"
#include "overroll/error.h"
#include "overroll/memory.h"
#include "overroll/pictures.h"
#include "overroll/profile.h"
#include "overroll/questions.h"
#include "overroll/results.h"
#include "overroll/run.h"
#include "overroll/simulation.h"
#include "overroll/stress.h"
#include "overroll/surface.h"
#include "overroll/text.h"
#include "overroll/version.h"

#endif
