// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Volume files (Documentation/Formats/nxv.md): writing, reading, and the index of a series.
#include "nexrad/Codec/NxvReader.h"
#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Codec/NxvWriter.h"
