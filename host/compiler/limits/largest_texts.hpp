#pragma once

#include "host/compiler/limits/measured_moments.hpp"
#include "host/compiler/limits/outline_meter.hpp"

#include <span>
#include <string>
#include <vector>

namespace kfast {

/// A text for each input of a scene; empty where the input is none.
using LargestTexts = std::vector<std::string>;

void put_texts(const LargestTexts& texts, OutlineMeter& meter);

/// Texts with which the outlines of a scene are largest: each is as many of one character as the input may
/// have. Looked for at some of `moments`, of which there is at least one; several of them if different
/// characters are the largest at different moments. `meter` is one of the scene; its texts are others
/// afterwards.
std::vector<LargestTexts> largest_texts(const SceneView& scene, std::span<const MeasuredMoment> moments,
                                        OutlineMeter& meter);

}
