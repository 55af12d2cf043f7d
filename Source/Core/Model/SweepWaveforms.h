// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

namespace nexrad
{

/// Sets the waveform of each sweep, and the unambiguous ranges that the rays lack.
///
/// The waveform is that of message 5 where its cut of that number fits the sweep: the angles differ
/// by less than half a degree, and a surveillance cut has neither velocity nor spectrum width. Else
/// it follows from the rays: surveillance without these two moments; with them, at a terminal radar
/// and above 7° Doppler without ambiguity resolution; at others contiguous Doppler below 1.7° or
/// next after a surveillance cut at the same tilt; else batch. (No pattern of a WSR-88D has batch
/// cuts below 1.7° or above 7°.)
///
/// A range outside 50 to 1000 km is none. In its place comes c·λ/(8·Nyquist velocity) with λ = 11.1
/// cm, the longest wavelength of a WSR-88D: no gate that was seen lies beyond. It stays 0 (unknown)
/// at terminal radars, whose Nyquist velocity is made of several pulse rates, and without either.
void ResolveWaveforms(RadarVolume& volume);

/// The waveform as a text for people ("contiguous surveillance"); "" for Unknown.
const char* ToString(Waveform waveform);

} // namespace nexrad
